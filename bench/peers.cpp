#include "bench/peers.hpp"

#include <box2d/box2d.h>
#include <chipmunk/chipmunk.h>

#include <numbers>
#include <string>

#include "lodlab/core/math/trigonometry.hpp"

namespace bench {
namespace {

constexpr double wall_reach = 2000;  ///< of a half-space along its border [m]
constexpr double wall_depth = 10;    ///< [m]

const std::vector<lod2d::Ring>& pieces_of(const PiecedShape* shape) {
    static const std::vector<lod2d::Ring> wall{
        {{-wall_reach, -wall_depth}, {wall_reach, -wall_depth}, {wall_reach, 0}, {-wall_reach, 0}}};
    return shape == nullptr ? wall : shape->pieces;
}

/// On a circle about the origin.
lod2d::Point on_circle(double radius, double angle) {
    const auto [sine, cosine] = lod::sine_cosine(angle);
    return {radius * cosine, radius * sine};
}

PiecedShape pieced(const char* name, const lod2d::Ring& outline, std::vector<lod2d::Ring> pieces) {
    PiecedShape made{lod2d::make_shape(name, {{outline}}), std::move(pieces)};
    for (lod2d::Ring& piece : made.pieces)
        for (lod2d::Point& corner : piece) corner -= made.shape.centroid;
    return made;
}

PiecedShape star() {
    constexpr double fifth = 2 * std::numbers::pi / 5;
    lod2d::Ring outline;
    lod2d::Ring core;
    std::vector<lod2d::Ring> pieces;
    for (int i = 0; i < 5; ++i) {
        core.push_back(on_circle(0.22, fifth * (i + 0.5)));
        outline.push_back(on_circle(0.5, fifth * i));
        outline.push_back(core.back());
        pieces.push_back(
            {on_circle(0.22, fifth * (i - 0.5)), on_circle(0.5, fifth * i), core.back()});
    }
    pieces.push_back(core);
    return pieced("star", outline, pieces);
}

PiecedShape gear() {
    constexpr double eighth = 2 * std::numbers::pi / 8;
    lod2d::Ring outline;
    lod2d::Ring core;
    std::vector<lod2d::Ring> pieces;
    for (int i = 0; i < 8; ++i) {
        core.push_back(on_circle(0.36, eighth * i));
        const lod2d::Point next = on_circle(0.36, eighth * (i + 1));
        const double middle = eighth * (i + 0.5);
        const lod2d::Ring tooth{core.back() + 0.25 * (next - core.back()),
                                on_circle(0.5, middle - 0.11), on_circle(0.5, middle + 0.11),
                                core.back() + 0.75 * (next - core.back())};
        outline.push_back(core.back());
        outline.insert(outline.end(), tooth.begin(), tooth.end());
        pieces.push_back(tooth);
    }
    pieces.push_back(core);
    return pieced("gear", outline, pieces);
}

PiecedShape angle() {
    constexpr double arm = 0.4;  ///< so that no corner is further than half a metre from the centre
    const lod2d::Ring outline{{0, 0},
                              {2 * arm, 0},
                              {2 * arm, 0.75 * arm},
                              {0.75 * arm, 0.75 * arm},
                              {0.75 * arm, 2 * arm},
                              {0, 2 * arm}};
    return pieced("L", outline,
                  {{outline[0], outline[1], outline[2], {0, 0.75 * arm}},
                   {{0, 0.75 * arm}, outline[3], outline[4], outline[5]}});
}

class Box2d final : public Peer {
  public:
    Box2d(std::span<const lod::Body<2>> bodies, Shapes shapes, int iterations)
        : iterations_(iterations) {
        world_.SetAllowSleeping(false);
        for (std::size_t i = 0; i < bodies.size(); ++i) made_.push_back(add(bodies[i], shapes[i]));
    }

    void step(double seconds) override { world_.Step(static_cast<float>(seconds), iterations_, 3); }

    void read(std::span<lod::Body<2>> bodies) const override {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            bodies[i].velocity = {made_[i]->GetLinearVelocity().x, made_[i]->GetLinearVelocity().y};
            bodies[i].spin[0] = made_[i]->GetAngularVelocity();
        }
    }

  private:
    static b2Vec2 narrow(const lod::Vector<2>& v) {
        return {static_cast<float>(v.x()), static_cast<float>(v.y())};
    }

    b2Body* add(const lod::Body<2>& body, const PiecedShape* shape) {
        b2BodyDef definition;
        definition.type = body.is_static() ? b2_staticBody : b2_dynamicBody;
        definition.position = narrow(body.position);
        definition.angle = static_cast<float>(body.orientation);
        definition.linearVelocity = narrow(body.velocity);
        definition.angularVelocity = static_cast<float>(body.spin[0]);
        b2Body* made = world_.CreateBody(&definition);
        for (const auto& piece : pieces_of(shape)) {
            std::vector<b2Vec2> corners;
            for (const lod2d::Point& corner : piece) corners.push_back(narrow(corner));
            b2PolygonShape polygon;
            polygon.Set(corners.data(), static_cast<int>(corners.size()));
            b2FixtureDef fixture;
            fixture.shape = &polygon;
            fixture.friction = 0;
            fixture.restitution = 1;
            fixture.restitutionThreshold = 0;
            made->CreateFixture(&fixture);
        }
        if (body.is_static()) return made;
        b2MassData mass;
        mass.mass = static_cast<float>(1 / body.inverse_mass);
        mass.center.SetZero();
        mass.I = static_cast<float>(body.inertia(0, 0));
        made->SetMassData(&mass);
        return made;
    }

    int iterations_;
    b2World world_{{0, 0}};
    std::vector<b2Body*> made_;
};

/// Frees what it made; its shapes and bodies end with it.
class Chipmunk final : public Peer {
  public:
    Chipmunk(std::span<const lod::Body<2>> bodies, Shapes shapes, int iterations)
        : space_(cpSpaceNew()) {
        cpSpaceSetIterations(space_, iterations);
        for (std::size_t i = 0; i < bodies.size(); ++i) made_.push_back(add(bodies[i], shapes[i]));
    }
    ~Chipmunk() override {
        for (cpShape* shape : shapes_) {
            cpSpaceRemoveShape(space_, shape);
            cpShapeFree(shape);
        }
        for (cpBody* body : made_) {
            cpSpaceRemoveBody(space_, body);
            cpBodyFree(body);
        }
        cpSpaceFree(space_);
    }
    Chipmunk(const Chipmunk&) = delete;
    Chipmunk& operator=(const Chipmunk&) = delete;

    void step(double seconds) override { cpSpaceStep(space_, seconds); }

    void read(std::span<lod::Body<2>> bodies) const override {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const cpVect velocity = cpBodyGetVelocity(made_[i]);
            bodies[i].velocity = {velocity.x, velocity.y};
            bodies[i].spin[0] = cpBodyGetAngularVelocity(made_[i]);
        }
    }

  private:
    cpBody* add(const lod::Body<2>& body, const PiecedShape* shape) {
        cpBody* made = body.is_static() ? cpBodyNewStatic()
                                        : cpBodyNew(1 / body.inverse_mass, body.inertia(0, 0));
        cpSpaceAddBody(space_, made);
        cpBodySetPosition(made, cpv(body.position.x(), body.position.y()));
        cpBodySetAngle(made, body.orientation);
        cpBodySetVelocity(made, cpv(body.velocity.x(), body.velocity.y()));
        cpBodySetAngularVelocity(made, body.spin[0]);
        for (const auto& piece : pieces_of(shape)) {
            std::vector<cpVect> corners;
            for (const lod2d::Point& corner : piece) corners.push_back(cpv(corner.x(), corner.y()));
            cpShape* part =
                cpPolyShapeNewRaw(made, static_cast<int>(corners.size()), corners.data(), 0);
            cpShapeSetElasticity(part, 1);
            cpShapeSetFriction(part, 0);
            shapes_.push_back(cpSpaceAddShape(space_, part));
        }
        return made;
    }

    cpSpace* space_;
    std::vector<cpBody*> made_;
    std::vector<cpShape*> shapes_;
};

}  // namespace

std::vector<PiecedShape> pieced_shapes() {
    return {star(), gear(), angle()};
}

std::unique_ptr<Peer> box2d(std::span<const lod::Body<2>> bodies, Shapes shapes, int iterations) {
    return std::make_unique<Box2d>(bodies, shapes, iterations);
}

std::unique_ptr<Peer> chipmunk(std::span<const lod::Body<2>> bodies, Shapes shapes,
                               int iterations) {
    return std::make_unique<Chipmunk>(bodies, shapes, iterations);
}

}  // namespace bench
