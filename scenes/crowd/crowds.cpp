#include "lodlab/scenes/crowd/crowds.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "lodlab/core/base/random.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/scenes/places.hpp"

namespace scenes {
namespace {

constexpr double quarter = std::numbers::pi / 2;
constexpr double radius = 0.5;  ///< of the circle about the centre of mass that holds a body [m]
constexpr double margin = 0.1;  ///< between a wall and the cells beside it [m]

/// What the makers of crowds are given.
struct Wish {
    int bodies;
    lod::Random random;

    explicit Wish(std::span<const double> values)
        : bodies(static_cast<int>(values[0])), random(static_cast<std::uint64_t>(values[1])) {}

    /// Towards every side by `most` at most.
    double either_side(double most) { return random.next(-most, most); }
};

/// The scene without bodies.
Scene empty(const char* name, const char* title, int dim) {
    Scene scene;
    scene.name = name;
    scene.title = title;
    scene.dim = dim;
    scene.time_step = 1.0 / 60;
    return scene;
}

/// A half-space whose border goes through `position`, its outside turned from y by that angle.
void add_wall(const char* name, const Triple& position, const Triple& axis, double angle,
              Scene& scene) {
    BodySpec wall;
    wall.name = name;
    wall.shape = half_space_name;
    wall.is_static = true;
    wall.position = position;
    wall.axis = axis;
    wall.angle = angle;
    wall.where = scene.name;
    scene.bodies.push_back(wall);
}

constexpr Triple about_z{0, 0, 1};
constexpr Triple about_x{1, 0, 0};

void add_sides(double half, Scene& scene) {
    add_wall("left", {-half, 0, 0}, about_z, -quarter, scene);
    add_wall("right", {half, 0, 0}, about_z, quarter, scene);
}

/// A closed box about the origin.
void add_box(double half, Scene& scene) {
    add_wall("floor", {0, -half, 0}, about_z, 0, scene);
    add_wall("ceiling", {0, half, 0}, about_z, 2 * quarter, scene);
    add_sides(half, scene);
    if (scene.dim == 2) return;
    add_wall("back", {0, 0, -half}, about_x, quarter, scene);
    add_wall("front", {0, 0, half}, about_x, -quarter, scene);
}

/// The longer side of a generator's shape whose outline stays within `radius`.
double size_within(const char* spec) {
    const lod2d::Shape shape = lod2d::generate(spec);
    double reach = 0;
    for (const lod2d::Ring& ring : shape.polygon.rings)
        for (const lod2d::Point& corner : ring) reach = std::max(reach, corner.norm());
    return lod2d::bounds(shape.polygon).size().maxCoeff() * radius / reach;
}

/// Star, gear or L `number` of a crowd.
BodySpec plane_body(int number) {
    struct Trait {
        const char* name;
        const char* spec;
        double size;
    };
    static const Trait traits[] = {{"star", "star:5", size_within("star:5")},
                                   {"gear", "gear:9", size_within("gear:9")},
                                   {"L", "L", size_within("L")}};
    const Trait& trait = traits[static_cast<std::size_t>(number) % std::size(traits)];
    BodySpec body;
    body.name = trait.name + (" " + std::to_string(number + 1));
    body.shape = trait.spec;
    body.size = trait.size;
    return body;
}

/// Cells along the side of the least square, or cube, that has so many.
int side_of(int cells, int dim) {
    const auto holds = [dim](int side) { return dim == 2 ? side * side : side * side * side; };
    int side = 1;
    while (holds(side) < cells) ++side;
    return side;
}

/// A body of the plane in each cell of a square of that pitch, anywhere in it and turned any way.
/// Returns half the side of the square.
double fill_square(double pitch, Wish& wish, Scene& scene) {
    const int side = side_of(wish.bodies, 2);
    const double half = 0.5 * pitch * side;
    const double slack = 0.5 * pitch - radius;
    for (int i = 0; i < wish.bodies; ++i) {
        BodySpec body = plane_body(i);
        body.where = scene.name;
        body.position = {(i % side + 0.5) * pitch - half + wish.either_side(slack),
                         (i / side + 0.5) * pitch - half + wish.either_side(slack), 0};
        body.angle = wish.either_side(2 * quarter);
        body.spin = {0, 0, wish.either_side(4)};
        scene.bodies.push_back(body);
    }
    return half + margin;
}

Scene make_gas(const char* name, const char* title, double pitch, Wish wish) {
    Scene scene = empty(name, title, 2);
    const double half = fill_square(pitch, wish, scene);
    for (BodySpec& body : scene.bodies)
        body.velocity = {wish.either_side(4), wish.either_side(4), 0};
    add_box(half, scene);
    return scene;
}

Scene make_dense_gas(std::span<const double> values) {
    return make_gas("gas", "A dense gas of stars, gears and Ls", 1.1, Wish(values));
}

Scene make_sparse_gas(std::span<const double> values) {
    return make_gas("sparse", "A sparse gas of stars, gears and Ls", 1.9, Wish(values));
}

Scene make_implode(std::span<const double> values) {
    Wish wish(values);
    Scene scene = empty("implode", "Stars, gears and Ls fall to one centre", 2);
    const double half = fill_square(1.6, wish, scene);
    for (BodySpec& body : scene.bodies) {
        const lod::Vector<2> place(body.position[0], body.position[1]);
        const lod::Vector<2> inwards = place / -std::max(place.norm(), 1e-9);
        body.velocity = {4 * inwards.x() + wish.either_side(0.3),
                         4 * inwards.y() + wish.either_side(0.3), 0};
    }
    add_box(half, scene);
    return scene;
}

Scene make_rain(std::span<const double> values) {
    Wish wish(values);
    Scene scene = empty("rain", "Stars, gears and Ls rain on a floor and hardly bounce", 2);
    const double half = fill_square(1.6, wish, scene);
    for (BodySpec& body : scene.bodies)
        body.velocity = {wish.either_side(0.3), -4 + wish.either_side(1), 0};
    add_wall("floor", {0, -half, 0}, about_z, 0, scene);
    add_sides(half, scene);
    for (BodySpec& body : scene.bodies) body.restitution = 0.2;
    return scene;
}

Scene make_bunnies(std::span<const double> values) {
    constexpr double pitch = 1.7;  ///< more than twice what a bunny reaches from its centre [m]
    Wish wish(values);
    Scene scene = empty("bunnies", "A gas of bunnies", 3);
    const int side = side_of(wish.bodies, 3);
    const double half = 0.5 * pitch * side;
    const auto place = [&](int cell) { return (cell + 0.5) * pitch - half; };
    for (int i = 0; i < wish.bodies; ++i) {
        BodySpec body;
        body.name = "bunny " + std::to_string(i + 1);
        body.where = scene.name;
        body.shape = "package:glmark2-data/bunny.obj";
        body.size = 1;
        body.position = {place(i % side), place(i / side % side), place(i / side / side)};
        body.angle = wish.either_side(2 * quarter);
        body.velocity = {wish.either_side(2), wish.either_side(2), wish.either_side(2)};
        body.spin = {wish.either_side(2), wish.either_side(2), wish.either_side(2)};
        scene.bodies.push_back(body);
    }
    add_box(half + margin, scene);
    return scene;
}

GeneratorParameter bodies(double most) {
    return {"BODIES", "how many", 100, 1, most, true};
}
const GeneratorParameter seed{"SEED", "of all random numbers", 1, 0, 1e9, true};

}  // namespace

std::span<const Crowd> crowds() {
    static const std::vector<Crowd> all = {
        {"gas",
         "stars, gears and Ls, close together, at up to 4 m/s each way, in a closed box",
         {bodies(50'000), seed},
         make_dense_gas},
        {"sparse", "the same with three times the room", {bodies(50'000), seed}, make_sparse_gas},
        {"implode",
         "the same, falling to one centre at 4 m/s",
         {bodies(50'000), seed},
         make_implode},
        {"rain",
         "the same, falling on a floor at 4 m/s, where they hardly bounce",
         {bodies(50'000), seed},
         make_rain},
        {"bunnies",
         "in space: bunnies of 1 m at up to 2 m/s each way, in a closed cube",
         {bodies(10'000), seed},
         make_bunnies},
    };
    return all;
}

bool names_crowd(std::string_view spec) {
    return spec.find(':') != std::string_view::npos &&
           lod::find_generator(crowds(), spec) != nullptr;
}

Scene crowd(std::string_view spec) {
    return lod::make_from_spec(crowds(), spec);
}

Scene named_scene(const std::string& name) {
    std::error_code ignored;
    if (names_crowd(name) && !std::filesystem::exists(name, ignored)) return crowd(name);
    return load_scene(scene_file(name));
}

}  // namespace scenes
