#pragma once

#include <iomanip>
#include <numbers>
#include <sstream>
#include <string>

#include "lodlab/core/exact/ball_union.hpp"
#include "lodlab/core/exact/time_of_impact.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/lod2d/shape/outline.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/lod3d/solid/surface.hpp"
#include "tests/core/bodies.hpp"

// Bodies with exact shapes, planar ones for the plane and, 1 m thick, for space.

namespace lodtest {

/// "box:WIDTH,HEIGHT", to the last bit.
inline std::string box_spec(double width, double height) {
    std::ostringstream spec;
    spec << std::setprecision(17) << "box:" << width << ',' << height;
    return spec.str();
}

template <int Dim>
struct Boxes;
template <>
struct Boxes<2> {
    static std::shared_ptr<const lod::ExactShape<2>> make(double width, double height) {
        return std::make_shared<lod2d::ExactOutline>(lod2d::generate(box_spec(width, height)));
    }
};
template <>
struct Boxes<3> {
    static std::shared_ptr<const lod::ExactShape<3>> make(double width, double height) {
        return std::make_shared<lod3d::ExactSurface>(
            lod3d::generate(box_spec(width, height) + ",1"));
    }
};

/// The planar body with a box for its shape: x, v and w are its motion, `angle` its orientation.
template <int Dim>
lod::Body<Dim> with_box(lod::Body<Dim> body, double width, double height, double angle = 0) {
    body.exact = Boxes<Dim>::make(width, height);
    body.orientation =
        lod::Space<Dim>::turned(lod::Space<Dim>::unturned(), planar_spin<Dim>(angle));
    return body;
}

template <int Dim>
lod::Body<Dim> static_box(double width, double height, Planar x, double angle = 0) {
    auto body = with_box<Dim>(immovable<Dim>(), width, height, angle);
    body.position = planar<Dim>(x.x(), x.y());
    return body;
}

/// A uniform ball with its own exact shape.
template <int Dim>
lod::Body<Dim> exact_ball(double mass, double radius, Planar x, Planar v = {0, 0}) {
    auto body = disc<Dim>(mass, radius, x, v);
    body.exact = std::make_shared<lod::BallUnion<Dim>>(
        std::vector<lod::Sphere<Dim>>{{lod::Vector<Dim>::Zero(), radius}});
    return body;
}

/// The contacts of a moment of touch, as the response takes them.
template <int Dim>
std::vector<lod::Impact<Dim>> impacts_of(const lod::TimeOfImpact<Dim>& touch) {
    std::vector<lod::Impact<Dim>> impacts;
    for (const auto& contact : touch.contacts) impacts.push_back({0, 1, 0, contact});
    return impacts;
}

/// Lets two bodies collide: to the time of impact, and what the response makes of it.
template <int Dim>
std::vector<lod::Body<Dim>> collide(const lod::Body<Dim>& a, const lod::Body<Dim>& b,
                                    lod::Response response = lod::Response::net,
                                    const lod::ImpactSettings& settings = {.horizon = 10}) {
    const auto touch = lod::time_of_impact(a, b, settings);
    REQUIRE(touch.outcome == lod::ImpactOutcome::touching);
    CHECK(touch.distance <= settings.tolerance);
    CHECK(touch.distance > 0);
    std::vector<lod::Body<Dim>> bodies{touch.a, touch.b};
    resolve<Dim>(response, impacts_of(touch), bodies);
    return bodies;
}

}  // namespace lodtest
