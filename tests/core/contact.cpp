#include "core/contact.hpp"

#include "tests/catch.hpp"

using namespace lod;

TEMPLATE_TEST_CASE_SIG("the contact point divides the centre line by the radii", "[contact]",
                       ((int Dim), Dim), 2, 3) {
    const Vector<Dim> along = Vector<Dim>::Unit(0);
    const Sphere<Dim> coarse{Vector<Dim>::Zero(), 3.0};
    const Sphere<Dim> fine{3.5 * along, 1.0};

    const auto contact = model_contact(coarse, fine);
    REQUIRE(contact);
    CHECK(contact->point.isApprox(3.5 * (3.0 / 4.0) * along));
    CHECK(contact->depth == Approx(0.5));
}
