#include "lod2d/box2d_reference.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "core/error.hpp"

namespace lod2d {
namespace {

constexpr std::size_t most_corners = b2_maxPolygonVertices;
/// Box2D welds corners nearer than half its slop.
constexpr float weld = 0.5f * b2_linearSlop;
/// A piece must keep some area in single precision; Box2D asserts more than 1.2e-7.
constexpr float least_area = 1e-5f;
constexpr double most_dropped = 1e-3;  ///< share of a shape's area

b2Vec2 to_box2d(const Point& p, double scale) {
    return {static_cast<float>(scale * p.x()), static_cast<float>(scale * p.y())};
}
Point from_box2d(const b2Vec2& p, double scale) {
    return {p.x / scale, p.y / scale};
}

/// A convex piece as Box2D will take it: corners welded.
struct Piece {
    std::array<b2Vec2, most_corners> corners;
    int count = 0;

    void add(const b2Vec2& corner) {
        for (int i = 0; i < count; ++i)
            if (b2DistanceSquared(corner, at(i)) <= 1.01f * weld * weld) return;
        corners[static_cast<std::size_t>(count++)] = corner;
    }
    [[nodiscard]] const b2Vec2& at(int i) const { return corners[static_cast<std::size_t>(i)]; }
    [[nodiscard]] float area() const {
        float twice = 0;
        for (int i = 1; i + 1 < count; ++i) twice += b2Cross(at(i) - at(0), at(i + 1) - at(0));
        return 0.5f * twice;
    }
};

/// Gives a body the shape's convex pieces; see run_to_impact for what is refused.
void add_fixtures(b2Body& body, const Shape& shape, double scale) {
    const ConvexParts parts = with_at_most(convex_parts(shape.polygon), most_corners);
    double held = 0;
    for (std::size_t i = 0; i < parts.count(); ++i) {
        Piece piece;
        for (auto c = parts.begin[i]; c < parts.begin[i + 1]; ++c)
            piece.add(to_box2d(parts.corners[static_cast<std::size_t>(c)], scale));
        if (piece.count < 3 || piece.area() < least_area) continue;
        held += piece.area();
        b2PolygonShape polygon;
        polygon.Set(piece.corners.data(), piece.count);
        b2FixtureDef fixture;
        fixture.shape = &polygon;
        fixture.density = 0;
        fixture.friction = 0;
        fixture.restitutionThreshold = 0;
        body.CreateFixture(&fixture);
    }
    const double share = held / (scale * scale * shape.area);
    if (!(std::abs(share - 1) <= most_dropped))
        throw lod::Error(lod::ErrorKind::input_refused,
                         "shape " + shape.name + ": too fine for Box2D, which would hold " +
                             std::to_string(100 * share) +
                             " % of its area; raise units_per_metre (now " + std::to_string(scale) +
                             ")");
}

int index_of(b2Fixture& fixture) {
    return static_cast<int>(fixture.GetBody()->GetUserData().pointer);
}

/// Sets each pair's restitution and collects the impulses of a step.
class Listener final : public b2ContactListener {
  public:
    Listener(std::span<const lod::Body<2>> bodies, double scale) : bodies_(bodies), scale_(scale) {}

    void PreSolve(b2Contact* contact, const b2Manifold*) override {
        const auto a = static_cast<std::size_t>(index_of(*contact->GetFixtureA()));
        const auto b = static_cast<std::size_t>(index_of(*contact->GetFixtureB()));
        contact->SetRestitution(
            static_cast<float>(std::min(bodies_[a].restitution, bodies_[b].restitution)));
        contact->SetRestitutionThreshold(0);
        // Kept for PostSolve, which comes when the bodies have moved on.
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        manifolds_[contact] = manifold;
    }
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
        const b2WorldManifold& manifold = manifolds_.at(contact);
        const int a = index_of(*contact->GetFixtureA());
        const int b = index_of(*contact->GetFixtureB());
        const double turn = a < b ? 1 : -1;
        for (int i = 0; i < impulse->count; ++i) {
            const float j = impulse->normalImpulses[i];
            if (j <= 0) continue;
            contacts.push_back({std::min(a, b), std::max(a, b),
                                from_box2d(manifold.points[i], scale_),
                                turn * from_box2d(manifold.normal, 1), j / scale_});
        }
    }

    std::vector<Box2dContact> contacts;

  private:
    std::span<const lod::Body<2>> bodies_;
    double scale_;
    std::map<const b2Contact*, b2WorldManifold> manifolds_;
};

b2Body& add_body(b2World& world, const lod::Body<2>& body, const Shape& shape, std::size_t index,
                 double scale) {
    b2BodyDef definition;
    definition.type = body.is_static() ? b2_staticBody : b2_dynamicBody;
    definition.position = to_box2d(body.position, scale);
    definition.angle = static_cast<float>(body.orientation);
    definition.linearVelocity = to_box2d(body.velocity, scale);
    definition.angularVelocity = static_cast<float>(body.spin[0]);
    definition.allowSleep = false;
    definition.userData.pointer = index;
    b2Body& made = *world.CreateBody(&definition);
    add_fixtures(made, shape, scale);
    if (body.is_static()) return made;
    b2MassData mass;
    mass.mass = static_cast<float>(1 / body.inverse_mass);
    mass.center.SetZero();
    mass.I = static_cast<float>(scale * scale * body.inertia(0, 0));
    made.SetMassData(&mass);
    return made;
}

void read_pose(const b2Body& from, lod::Body<2>& to, double scale) {
    to.position = from_box2d(from.GetPosition(), scale);
    to.orientation = from.GetAngle();
}

void read_velocity(const b2Body& from, lod::Body<2>& to, double scale) {
    to.velocity = from_box2d(from.GetLinearVelocity(), scale);
    to.spin[0] = from.GetAngularVelocity();
}

}  // namespace

Box2dImpact run_to_impact(std::span<const lod::Body<2>> bodies,
                          std::span<const Shape* const> shapes, const Box2dSettings& settings) {
    const double scale = settings.units_per_metre;
    b2World world({0, 0});
    world.SetAllowSleeping(false);
    Listener listener(bodies, scale);
    world.SetContactListener(&listener);
    std::vector<b2Body*> made;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        made.push_back(&add_body(world, bodies[i], *shapes[i], i, scale));

    Box2dImpact impact;
    impact.before.assign(bodies.begin(), bodies.end());
    for (int step = 0; step < settings.most_steps && !impact.happened; ++step) {
        lod::check_interrupted();
        impact.time = step * settings.time_step;
        for (std::size_t i = 0; i < made.size(); ++i) {
            read_pose(*made[i], impact.before[i], scale);
            read_velocity(*made[i], impact.before[i], scale);
        }
        constexpr int no_position_iterations = 0;  // velocities are what is compared
        world.Step(static_cast<float>(settings.time_step), settings.velocity_iterations,
                   no_position_iterations);
        impact.happened = !listener.contacts.empty();
    }
    impact.after = impact.before;
    for (std::size_t i = 0; i < made.size(); ++i) read_velocity(*made[i], impact.after[i], scale);
    impact.contacts = std::move(listener.contacts);
    return impact;
}

}  // namespace lod2d
