#include <cmath>
#include <fstream>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/solid/generators.hpp"
#include "lodlab/viz/draw/draw_traits.hpp"
#include "lodlab/viz/draw/surface.hpp"
#include "lodlab/viz/figure/check.hpp"
#include "lodlab/viz/paint/space/render.hpp"
#include "lodlab/viz/paint/write.hpp"
#include "tests/catch.hpp"
#include "tests/viz/scratch.hpp"

using namespace viz;
using Vector3 = lod::Vector<3>;

namespace {

constexpr double right_angle = 1.5707963267948966;

/// Looks along -z at the origin from so far away.
Camera straight(double distance, bool perspective) {
    return {{0, 0, distance}, {0, 0, 0}, {0, 1, 0}, perspective};
}

Ball ball(Role role, int body, Point3 centre, double radius) {
    return {{.role = role, .body = body}, centre, radius};
}

/// 100 x 100 pixels of the panel from -1 to 1: pixel (50, 50) lies right below the middle.
SpaceRendering hundred() {
    return {{{-1, -1}, {1, 1}}, 100, 100, 1, Theme::light};
}

struct Pixel {
    int blue;
    int green;
    int red;
    int cover;
};
Pixel pixel(const SpacePicture& picture, int x, int y) {
    const std::uint8_t* at = picture.image.pixels.data() + y * picture.image.stride + 4 * x;
    return {at[0], at[1], at[2], at[3]};
}
float depth(const SpacePicture& picture, int x, int y) {
    return picture.depth[static_cast<std::size_t>(y * picture.image.width + x)];
}
/// Blue is body A's ink, red (vermilion) body B's.
bool is_of_a(const Pixel& p) {
    return p.blue > p.red + 20;
}
bool is_of_b(const Pixel& p) {
    return p.red > p.blue + 20;
}

/// A square of two triangles, facing +z, at z = 0.
Surface square(double half) {
    lod3d::Mesh mesh;
    mesh.vertices = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return surface_of(mesh);
}

}  // namespace

TEST_CASE("orthographic views leave out the depth, perspective divides by it", "[space]") {
    const Camera flat = straight(5, false);
    CHECK(project(flat, {0.3, -0.2, 4}) == Point{0.3, -0.2});
    CHECK(project(flat, {0.3, -0.2, 40}) == Point{0.3, -0.2});  // behind the eye, too
    // At depth 2 of an eye 5 away from the target a metre shows 5 / 2 times as long.
    const Camera deep = straight(5, true);
    const Point near = project(deep, {0.4, 0.2, 3});
    CHECK(near.x == Approx(1.0));
    CHECK(near.y == Approx(0.5));
    CHECK(project(deep, {0.4, 0.2, 0}).x == Approx(0.4));
    CHECK(depth_of(deep, {0.4, 0.2, 3}) == Approx(2));
    CHECK(magnification(deep, {0, 0, -5}) == Approx(0.5));
    CHECK(std::isfinite(project(deep, {0.4, 0.2, 30}).x));
}

TEST_CASE("a camera in orbit stands where its angles say", "[space]") {
    const Camera from_x = orbit({1, 2, 3}, 4, right_angle, 0, false);
    CHECK(vector3(from_x.eye).isApprox(Vector3(5, 2, 3)));
    // From +x, +z lies on the left.
    CHECK(project(from_x, {1, 2, 4}).x == Approx(-1));
    const Camera above = orbit(Vector3::Zero(), 2, 0, right_angle / 3, false);
    CHECK(above.eye.y == Approx(1));  // sin 30 degrees
    // The ground's far side lies higher on the panel, by the sine of the elevation.
    CHECK(project(above, {0, 0, -1}).y == Approx(0.5));
}

TEST_CASE("what is nearer covers what is behind, whatever the order", "[space]") {
    const Ball near = ball(Role::body, 0, {0, 0, 0.5}, 0.3);
    const Ball far = ball(Role::body, 1, {0, 0, -0.5}, 0.6);
    for (const bool swapped : {false, true}) {
        SpaceScene scene;
        scene.camera = straight(5, false);
        scene.balls = swapped ? std::vector{far, near} : std::vector{near, far};
        const SpacePicture picture = render_space(scene, hundred());
        CHECK(is_of_a(pixel(picture, 50, 50)));
        CHECK(is_of_b(pixel(picture, 50, 27)));  // 0.46 above the middle: beyond the near ball
        CHECK(pixel(picture, 2, 2).cover == 0);  // nothing
        CHECK(depth(picture, 50, 50) == Approx(4.2).margin(1e-3));  // 5 - 0.5 - 0.3
        CHECK(std::isinf(depth(picture, 2, 2)));
    }
}

TEST_CASE("two balls that cut each other share the picture where their spheres do", "[space]") {
    // Radii 0.6 and 0.6, centres 0.6 apart across: they cut in the plane x = 0.
    SpaceScene scene;
    scene.camera = straight(5, false);
    scene.balls = {ball(Role::body, 0, {-0.3, 0, 0}, 0.6), ball(Role::body, 1, {0.3, 0, 0}, 0.6)};
    const SpacePicture picture = render_space(scene, hundred());
    for (const int y : {35, 50, 65}) {
        CHECK(is_of_a(pixel(picture, 46, y)));
        CHECK(is_of_b(pixel(picture, 53, y)));
    }
}

TEST_CASE("the circle in which meeting balls cut each other has the right radius", "[space]") {
    // Along the line of sight: R = 0.5 and 0.5, centres 0.6 apart; they cut in a circle of radius
    // sqrt(0.25 - 0.09) = 0.4, which is seen from the front at 0.4 / 0.02 = 20 pixels.
    SpaceScene scene;
    scene.camera = straight(5, false);
    scene.balls = {ball(Role::meeting_node, 0, {0, 0, 0.3}, 0.5),
                   ball(Role::meeting_node, 1, {0, 0, -0.3}, 0.5)};
    // Seen from the side the circle is a line at x = 0, as far up as 0.4.
    scene.camera = {{5, 0, 0}, {0, 0, 0}, {0, 1, 0}, false};
    const SpacePicture picture = render_space(scene, hundred());
    const auto is_cut = [&](int x, int y) {
        const Pixel p = pixel(picture, x, y);
        return p.red > 120 && p.green < 70 && p.blue < 90;
    };
    int highest = 100;
    for (int y = 0; y < 100; ++y)
        for (int x = 48; x < 52; ++x)
            if (is_cut(x, y)) highest = std::min(highest, y);
    CHECK(highest >= 29);  // 50 - 20, and half a line
    CHECK(highest <= 32);
    CHECK(is_cut(49, 50) != false);
    CHECK_FALSE(is_cut(44, 50));
    CHECK_FALSE(is_cut(56, 50));
}

TEST_CASE("a surface is where its triangles are, seen from its front only", "[space]") {
    SpaceScene scene;
    scene.camera = straight(5, true);
    Facets facets{
        {.role = Role::body}, std::make_shared<const Surface>(square(0.5)), {0, 0, 2.5}, {}};
    facets.axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    scene.facets = {facets};
    // Half way to the eye the square of half side 0.5 shows as one of half side 1: it fills all.
    SpacePicture picture = render_space(scene, hundred());
    CHECK(is_of_a(pixel(picture, 3, 3)));
    CHECK(depth(picture, 50, 50) == Approx(2.5).margin(1e-5));
    scene.facets[0].origin = {0, 0, 0};
    picture = render_space(scene, hundred());
    CHECK(is_of_a(pixel(picture, 27, 50)));  // half side 0.5: 25 pixels
    CHECK(pixel(picture, 22, 50).cover == 0);
    scene.facets[0].axes = {{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};  // turned away
    CHECK(pixel(render_space(scene, hundred()), 40, 60).cover == 0);
}

TEST_CASE("a mesh shines through a clear ball and hides what is behind it", "[space]") {
    SpaceScene scene;
    scene.camera = straight(5, false);
    scene.facets = {
        {{.role = Role::body}, std::make_shared<const Surface>(square(0.3)), {0, 0, 0}, {}}};
    scene.facets[0].axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    scene.balls = {ball(Role::level_node, 1, {0, 0, 0}, 0.8)};
    const SpacePicture picture = render_space(scene, hundred());
    CHECK(is_of_a(pixel(picture, 45, 55)));
    CHECK(pixel(picture, 45, 55).cover == 255);
    CHECK(pixel(picture, 80, 50).cover < 255);
    CHECK(pixel(picture, 80, 50).cover > 0);
}

TEST_CASE("a ball casts its shadow on the ground below it", "[space]") {
    SpaceScene scene;
    scene.camera = orbit(Vector3::Zero(), 5, 0, right_angle / 1.5, false);
    scene.ground = Ground{0, 100, {0.01, 0, 0.01}, 50, {ball(Role::body, 0, {0, 0.3, 0}, 0.3)}};
    const SpacePicture with = render_space(scene, hundred());
    scene.ground->casters.clear();
    const SpacePicture without = render_space(scene, hundred());
    CHECK(pixel(with, 60, 55).cover > pixel(without, 60, 55).cover + 10);
    CHECK(std::isinf(depth(with, 60, 55)));  // the ground hides no marks
}

TEST_CASE("a scene is drawn to the same bits twice, in both themes", "[space]") {
    SpaceScene scene;
    scene.camera = orbit(Vector3::Zero(), 4, 0.4, 0.3, true);
    scene.balls = {ball(Role::meeting_node, 0, {-0.2, 0, 0}, 0.5),
                   ball(Role::true_collision, 1, {0.3, 0.1, 0}, 0.4)};
    scene.ground = Ground{-0.6, 0.25, {0, -0.6, 0}, 2, scene.balls};
    for (const Theme theme : {Theme::light, Theme::dark}) {
        SpaceRendering choice = hundred();
        choice.theme = theme;
        const SpacePicture first = render_space(scene, choice);
        const SpacePicture second = render_space(scene, choice);
        CHECK(first.image.pixels == second.image.pixels);
        CHECK(first.depth == second.depth);
    }
}

TEST_CASE("a picture of a scene may be cut anywhere: its parts agree", "[space]") {
    SpaceScene scene;
    scene.camera = straight(5, true);
    const auto mesh = std::make_shared<const Surface>(surface_of(lod3d::generate("ring").mesh));
    scene.facets = {{{.role = Role::body}, mesh, {0, 0, 0}, {}}};
    scene.facets[0].axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    scene.balls = {ball(Role::level_node, 1, {0.1, 0, 0}, 0.4)};
    const SpacePicture whole = render_space(scene, hundred());
    SpaceRendering part = hundred();
    part.view = {{-1, 0}, {1, 1}};
    part.height = 50;
    const SpacePicture upper = render_space(scene, part);
    int different = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 100; ++x)
            different += pixel(whole, x, y).red != pixel(upper, x, y).red ? 1 : 0;
    CHECK(different <= 5);  // lines of the silhouette may end a pixel sooner where a picture ends
}

TEST_CASE("a view frames all that it took in, from every side", "[space]") {
    const std::vector<lod::Sphere<3>> balls{
        {{0, 0, 0}, 1}, {{3, 0.5, -1}, 0.2}, {{-1, 2, 2}, 0.7}, {{0, -1.5, 0.3}, 0.1}};
    for (const bool perspective : {false, true}) {
        for (const double azimuth : {0.0, 0.9, 2.5, 4.4}) {
            SpaceView view({.azimuth = azimuth, .elevation = 0.4, .perspective = perspective});
            for (const auto& one : balls) view.take_in(one.centre, one.radius);
            const Camera camera = view.camera();
            const Box box = view.box();
            const CameraAxes axes = axes_of(camera);
            for (const auto& one : balls) {
                for (const Vector3& way : {axes.right, axes.up, axes.forward}) {
                    for (const double side : {-1.0, 1.0}) {
                        const Point p = project(camera, one.centre + side * one.radius * way);
                        CHECK(p.x >= box.low.x - 1e-9);
                        CHECK(p.y >= box.low.y - 1e-9);
                        CHECK(p.x <= box.high.x + 1e-9);
                        CHECK(p.y <= box.high.y + 1e-9);
                        CHECK(depth_of(camera, one.centre + side * one.radius * way) > 0);
                    }
                }
            }
        }
    }
}

TEST_CASE("what moves, moves across the picture from left to right", "[space]") {
    for (const Vector3& way : {Vector3(1, 0, 0), Vector3(0, 0, 1), Vector3(-1, 0.3, 2)}) {
        SpaceView view(Viewpoint{}, way);
        view.take_in(Vector3::Zero(), 1);
        const CameraAxes axes = axes_of(view.camera());
        CHECK(way.dot(axes.right) > 0.85 * std::hypot(way.x(), way.z()));
    }
}

TEST_CASE("a box has twelve sharp edges and flat faces, a ring of tubes none", "[space]") {
    const Surface box = surface_of(lod3d::generate("box").mesh);
    CHECK(std::count_if(box.edges.begin(), box.edges.end(),
                        [](const Surface::Edge& edge) { return edge.sharp; }) == 12);
    for (const auto& corners : box.normals)
        for (const Point3& n : corners)
            CHECK(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) == Approx(1));
    CHECK(box.outermost.size() == 8);
    const Surface ring = surface_of(lod3d::generate("ring").mesh);
    CHECK(std::none_of(ring.edges.begin(), ring.edges.end(),
                       [](const Surface::Edge& edge) { return edge.sharp; }));
}

TEST_CASE("a scene in space that cannot be drawn is refused by panel and part", "[space]") {
    Figure figure;
    Panel panel;
    panel.view = {{-1, -1}, {1, 1}};
    panel.space = SpaceScene{straight(5, false), {ball(Role::body, 0, {0, 0, 0}, 1)}, {}, {}};
    figure.panels = {panel};
    CHECK_NOTHROW(check_figure(figure));
    const auto refused = [&](const std::string& word) {
        CHECK_THROWS_WITH(check_figure(figure), lodtest::contains(word));
        figure.panels = {panel};
    };
    figure.panels[0].space->balls[0].centre.z = std::nan("");
    refused("panel 1, ball 1");
    figure.panels[0].space->balls[0].radius = -1;
    refused("below zero");
    figure.panels[0].space->camera.eye = {0, 0, 0};
    refused("looks nowhere");
    figure.panels[0].space->camera.eye = {0, 3, 0};
    refused("along its own up");
    figure.panels[0].space->facets.push_back({});
    refused("no surface");
    figure.panels[0].space->ground = Ground{0, 0, {}, 1, {}};
    refused("ground");
}

TEST_CASE("a figure with a scene in space is written in every format, the same twice", "[space]") {
    const sample::Scratch folder;
    Figure figure;
    figure.title = "A ball";
    figure.alt = "One ball in space.";
    figure.aspect = 5;
    WriteOptions small;  // a small page: quick
    small.quality = Quality::draft;
    Panel panel;
    panel.view = {{-1, -1}, {1, 1}};
    panel.space = SpaceScene{straight(5, false), {ball(Role::body, 0, {0, 0, 0}, 1)}, {}, {}};
    panel.marks = {Arrow{{.role = Role::normal}, {0, 0}, {0.5, 0}, "*n*", 6, 4}};
    figure.panels = {panel};
    const auto bytes_of = [](const std::filesystem::path& path) {
        std::ifstream in(path, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return text.str();
    };
    for (const char* ending : {"png", "svg", "pdf", "json"}) {
        INFO(ending);
        const auto first = folder / (std::string("a.") + ending);
        const auto second = folder / (std::string("b.") + ending);
        write_figure(first, figure, small);
        write_figure(second, figure, small);
        CHECK(bytes_of(first) == bytes_of(second));
    }
    CHECK_THAT(bytes_of(folder / "a.json"), lodtest::contains("\"perspective\": false"));
    const std::string svg = bytes_of(folder / "a.svg");
    CHECK_THAT(svg, lodtest::contains("data:image/png"));
    CHECK_THAT(svg, lodtest::contains("One ball in space."));
}
