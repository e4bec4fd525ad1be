#include "lodlab/measure/reference/box2d_reference.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/math/trigonometry.hpp"

namespace lod2d {
namespace {

constexpr std::size_t most_corners = b2_maxPolygonVertices;
/// Box2D welds corners nearer than half its slop.
constexpr float weld = 0.5f * b2_linearSlop;
/// A piece must keep some area in single precision; Box2D asserts more than 1.2e-7.
constexpr float least_area = 1e-5f;
constexpr double most_dropped = 1e-3;    ///< share of a shape's area
constexpr double same_direction = 1e-3;  ///< between two unit normals
constexpr double border_reach = 1000;    ///< of a half-space, from its position [m]

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

/// Gives a body the shape's convex pieces; see run_box2d for what is refused.
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

/// Gives a body the border of a half-space, whose bodies come from the side of its normal.
void add_border(b2Body& body, const lod::Vector<2>& normal, double scale) {
    const Point along = border_reach * Point(normal.y(), -normal.x());
    b2EdgeShape edge;
    // What comes from the right of the way from the second to the third is met.
    edge.SetOneSided(to_box2d(2 * along, scale), to_box2d(along, scale), to_box2d(-along, scale),
                     to_box2d(-2 * along, scale));
    b2FixtureDef fixture;
    fixture.shape = &edge;
    fixture.friction = 0;
    fixture.restitutionThreshold = 0;
    body.CreateFixture(&fixture);
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
            add({std::min(a, b), std::max(a, b), from_box2d(manifold.points[i], scale_),
                 turn * from_box2d(manifold.normal, 1), j / scale_});
        }
    }

    std::vector<Box2dContact> contacts;

  private:
    /// A corner where two pieces join is found once for each of them.
    void add(const Box2dContact& contact) {
        const auto same = [&](const Box2dContact& other) {
            return other.a == contact.a && other.b == contact.b &&
                   (other.point - contact.point).norm() * scale_ <= b2_linearSlop &&
                   (other.normal - contact.normal).norm() <= same_direction;
        };
        const auto found = std::find_if(contacts.begin(), contacts.end(), same);
        if (found == contacts.end())
            contacts.push_back(contact);
        else
            found->impulse += contact.impulse;
    }

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
    if (body.tree && body.tree->is_half_space())
        add_border(made, *body.tree->half_space, scale);
    else
        add_fixtures(made, shape, scale);
    if (body.is_static()) return made;
    b2MassData mass;
    mass.mass = static_cast<float>(1 / body.inverse_mass);
    mass.center.SetZero();
    mass.I = static_cast<float>(scale * scale * body.inertia(0, 0));
    made.SetMassData(&mass);
    return made;
}

/// The bodies in Box2D, stepped one time step at a time.
class World {
  public:
    World(std::span<const lod::Body<2>> bodies, std::span<const Shape* const> shapes, double step,
          const Box2dSettings& settings)
        : now_(bodies.begin(), bodies.end()),
          step_(step),
          settings_(settings),
          listener_(now_, settings.units_per_metre) {
        world_.SetAllowSleeping(false);
        world_.SetWarmStarting(false);
        world_.SetContinuousPhysics(false);
        world_.SetContactListener(&listener_);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            made_.push_back(&add_body(world_, bodies[i], *shapes[i], i, settings.units_per_metre));
    }

    [[nodiscard]] const std::vector<lod::Body<2>>& now() const { return now_; }

    /// One step. What it did happened at the instant at which it began.
    Box2dImpact step() {
        lod::check_interrupted();
        check_speeds();
        Box2dImpact impact;
        impact.before = now_;
        listener_.contacts.clear();
        constexpr int no_position_iterations = 0;  // velocities are what is compared
        world_.Step(static_cast<float>(step_), settings_.velocity_iterations,
                    no_position_iterations);
        for (std::size_t i = 0; i < made_.size(); ++i) read(*made_[i], now_[i]);
        impact.contacts = std::move(listener_.contacts);
        impact.happened = !impact.contacts.empty();
        impact.after = impact.before;
        for (std::size_t i = 0; i < now_.size(); ++i) {
            impact.after[i].velocity = now_[i].velocity;
            impact.after[i].spin = now_[i].spin;
        }
        return impact;
    }

  private:
    void read(const b2Body& from, lod::Body<2>& to) const {
        if (to.is_static()) return;
        to.position = from_box2d(from.GetPosition(), settings_.units_per_metre);
        to.orientation = lod::wrapped_angle(from.GetAngle());
        to.velocity = from_box2d(from.GetLinearVelocity(), settings_.units_per_metre);
        to.spin[0] = from.GetAngularVelocity();
    }

    /// Box2D shortens, without a word, a step that goes too far.
    void check_speeds() const {
        for (std::size_t i = 0; i < now_.size(); ++i) {
            const double way = now_[i].velocity.norm() * step_ * settings_.units_per_metre;
            const double turn = std::abs(now_[i].spin[0]) * step_;
            if (way < double{b2_maxTranslation} && turn < double{b2_maxRotation}) continue;
            throw lod::Error(lod::ErrorKind::limit_exceeded,
                             "body number " + std::to_string(i + 1) + " moves " +
                                 std::to_string(way) + " units and turns " + std::to_string(turn) +
                                 " rad in one step of Box2D, which allows 2 and 1.57; shorten its "
                                 "time step (now " +
                                 std::to_string(step_) + " s)");
        }
    }

    std::vector<lod::Body<2>> now_;
    double step_;
    Box2dSettings settings_;
    Listener listener_;
    b2World world_{{0, 0}};
    std::vector<b2Body*> made_;
};

}  // namespace

Box2dRun run_box2d(std::span<const lod::Body<2>> bodies, std::span<const Shape* const> shapes,
                   std::int64_t frames, double frame_step, const Box2dSettings& settings) {
    constexpr double rounding = 1e-9;
    const double steps = std::max(1.0, std::ceil(frame_step / settings.time_step - rounding));
    World world(bodies, shapes, frame_step / steps, settings);
    Box2dRun run;
    run.frame_step = frame_step;
    run.frames.push_back(world.now());
    for (std::int64_t frame = 0; frame < frames; ++frame) {
        for (double step = 0; step < steps; ++step) {
            Box2dImpact impact = world.step();
            if (!impact.happened) continue;
            impact.time = (static_cast<double>(frame) + step / steps) * frame_step;
            run.impacts.push_back(std::move(impact));
        }
        run.frames.push_back(world.now());
        if (settings.progress)
            settings.progress(static_cast<double>(frame + 1) / static_cast<double>(frames));
    }
    return run;
}

Box2dImpact run_to_impact(std::span<const lod::Body<2>> bodies,
                          std::span<const Shape* const> shapes, const Box2dSettings& settings) {
    World world(bodies, shapes, settings.time_step, settings);
    Box2dImpact impact;
    impact.before.assign(bodies.begin(), bodies.end());
    for (int step = 0; step < settings.most_steps && !impact.happened; ++step) {
        impact = world.step();
        impact.time = step * settings.time_step;
    }
    if (!impact.happened) impact.before = impact.after = world.now();
    return impact;
}

}  // namespace lod2d
