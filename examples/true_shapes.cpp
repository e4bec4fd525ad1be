// Two stars 6 mm apart: the leaves of their trees call that a collision; the true shapes,
// the finest level of detail, say that it is none, and when it will be one.
#include <cstdio>
#include <vector>

#include <lodlab/core/exact/time_of_impact.hpp>
#include <lodlab/core/frame/frame.hpp>
#include <lodlab/lod2d/builder/build_tree.hpp>
#include <lodlab/lod2d/shape/generators.hpp>
#include <lodlab/lod2d/shape/outline.hpp>

int main() {
    const lod2d::Shape star = lod2d::generate("star:4");
    std::vector<lod::Body<2>> bodies(2);
    for (lod::Body<2>& body : bodies) {
        lod::set_mass(body, star.area, lod::Inertia<2>::Constant(star.second_moment));
        body.tree = std::make_shared<lod::SphereTree<2>>(lod2d::build_tree(star, {.depth = 2}));
        body.exact = std::make_shared<lod2d::ExactOutline>(star);
    }
    bodies[0].velocity = {0.1, 0};
    bodies[1].position = {0.6, 0.3};

    bool apart = false;
    for (const lod::Finest level : {lod::Finest::leaves, lod::Finest::exact}) {
        lod::FrameSettings settings;
        settings.contact_model = lod::ContactModel::centre_line;
        settings.finest.level = level;
        lod::FrameStorage<2> storage;
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::detect<2>(bodies, settings, budget, storage);
        apart = !record.pairs.empty() && record.pairs.front().verdict == lod::Verdict::apart;
        std::printf("%s: %s\n", level == lod::Finest::leaves ? "leaves" : "true shapes",
                    apart ? "apart" : "touching");
    }
    std::printf("the gap is %.6f m\n", lod::separation<2>(bodies[0], bodies[1]).distance);

    const lod::TimeOfImpact<2> impact = lod::time_of_impact<2>(bodies[0], bodies[1]);
    std::printf("they touch in %.6f s, %zu contact(s), after %d advances\n", impact.time,
                impact.contacts.size(), impact.rounds);
    return apart && impact.outcome == lod::ImpactOutcome::touching ? 0 : 1;
}
