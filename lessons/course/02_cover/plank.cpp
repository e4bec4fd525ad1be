#include "lessons/course/02_cover/lesson.hpp"
#include "lessons/engine/meeting.hpp"
#include "lodlab/core/builder/certify.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/draw/motion/draw_motion.hpp"

namespace lessons::cover {
namespace {

using lod::Sphere;

const viz::Box view = box(-2.4, -1.8, 2.4, 1.8);

/// The circles through the corners of equal rectangles, which the plank is cut into.
Circles grid(int columns, int rows) {
    const Vec corner(2.0 / columns, 0.5 / rows);
    Circles circles;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            circles.push_back(
                {Vec((2 * column + 1 - columns) * corner.x(), (2 * row + 1 - rows) * corner.y()),
                 corner.norm() + bound});
    return circles;
}

/// A tree of two levels: a circle round all, and the circles.
std::shared_ptr<const lod::SphereTree<2>> tree_over(const Circles& circles) {
    std::vector<lod::TreeNode<2>> nodes(1);
    for (const Sphere<2>& circle : circles) {
        double& reach = nodes[0].sphere.radius;
        reach = std::max(reach, circle.centre.norm() + circle.radius);
        nodes[0].children.push_back(static_cast<int>(nodes.size()));
        nodes.push_back({circle, Vec::Zero(), {}});
    }
    return std::make_shared<const lod::SphereTree<2>>(lod::lay_out<2>(nodes));
}

/// The plank, and a ball that comes to it.
Meeting with_ball(const Circles& circles, double radius, const Vec& place) {
    Meeting meeting{
        lod2d::generate("box:4,1"), scaled(lod2d::generate("disc"), 2 * radius), {}, {}};
    meeting.a = actor("plank", meeting.shape_a, tree_over(circles));
    meeting.b = actor(
        "ball", meeting.shape_b,
        std::make_shared<const lod::SphereTree<2>>(lod::single_sphere<2>({Vec(0, 0), radius})));
    meeting.b.body.position = place;
    return meeting;
}

viz::Panel draw(const Meeting& meeting, const Circles& circles) {
    viz::Panel panel;
    panel.view = view;
    add_body(panel, meeting.a, 0);
    for (const Sphere<2>& circle : circles)
        add_ball(panel, circle, style(viz::Role::level_node, 0, 1));
    return panel;
}

/// A cover of the plank by equal rectangles: its picture, and how far it stands out.
void give_cover(Lesson& lesson, const std::string& name, int columns, int rows) {
    const Circles circles = grid(columns, rows);
    const Meeting plank = with_ball(circles, 0.5, Vec(0, 2));
    viz::Panel panel = draw(plank, circles);
    if (rows * columns == 1) panel.view = viz::grown(box_round(circles), 0.15);
    const double out = add_whisker(panel, lod2d::BoundaryIndex(plank.shape_a.polygon), circles, 0);
    give(lesson, name + " radius", number(circles[0].radius, 3, "m"));
    give(lesson, name + " out", number(out, 3, "m"));
    give(lesson, name + " circles", count(circles.size()));
    give(lesson, name + " tests", count(circles.size() * circles.size()));
    give(lesson, name, std::move(panel), {{"stands out by", name + " out"}});
}

/// Four circles that are needed and two that are not.
void give_spare(Lesson& lesson) {
    const Circles circles{{Vec(-1.5, 0), 0.708}, {Vec(-0.5, 0), 0.708}, {Vec(0, 0), 0.8},
                          {Vec(0.5, 0), 0.708},  {Vec(1, 0), 0.6},      {Vec(1.5, 0), 0.708}};
    const Meeting plank = with_ball(circles, 0.5, Vec(0, 2));
    const lod2d::PolygonPiece shape(plank.shape_a.polygon);
    viz::Panel panel = draw(plank, circles);
    Picks picks;
    std::string spare;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        Circles others = circles;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        const std::string name = shown_count(i + 1);
        const Sphere<2>& circle = circles[i];
        picks.push_back({name, at(circle.centre), circle.radius, covers(others, shape), ""});
        if (picks.back().right) spare += (spare.empty() ? "" : " and ") + name;
        add_label(panel, viz::Role::body, circle.centre + Vec(0, circle.radius), name, 0);
    }
    give(lesson, "spare", words(spare));
    give(lesson, "spare circles", std::move(picks));
    give(lesson, "six", std::move(panel));
}

/// The corners of the pieces where one circle is too small: which of them lie outside.
viz::Panel refused(const Meeting& holed, const Circles& circles) {
    viz::Panel panel = draw(holed, circles);
    const std::vector<lod2d::PolygonPiece> pieces =
        lod::split<2>(lod2d::PolygonPiece(holed.shape_a.polygon), circles);
    for (std::size_t i = 0; i < circles.size(); ++i) {
        add_piece(panel, pieces[i].parts(), static_cast<int>(i));
        for (const Vec& corner : corners_of(pieces[i])) {
            const bool outside = (corner - circles[i].centre).norm() > circles[i].radius;
            const viz::Role role = outside ? viz::Role::true_collision : viz::Role::contact;
            panel.marks.push_back(viz::Dot{style(role), at(corner), outside ? 1.5 : 0.7});
        }
    }
    return panel;
}

/// One of the four circles is too small, and a ball lies where it leaves a hole.
void give_hole(Lesson& lesson) {
    const Circles sound = grid(4, 1);
    Circles spoiled = sound;
    spoiled[2].radius *= shrunk;
    constexpr double radius = 0.12;
    const Meeting holed = with_ball(spoiled, radius, Vec(0.2, 0.47));
    const auto said_of = [&](const Circles& circles) {
        const Meeting meeting = with_ball(circles, radius, holed.b.body.position);
        const auto levels = lod::traverse_levels<2>(meeting.a.body, meeting.b.body);
        return words(levels.back().pairs.empty() ? "apart" : "they meet");
    };
    const lod2d::PolygonPiece shape(holed.shape_a.polygon);
    const lod::LevelCertificate bad = lod::certify<2>(*holed.a.body.tree, shape).back();
    std::size_t tests = 0;
    for (const lod2d::PolygonPiece& piece : lod::split<2>(shape, sound))
        tests += corners_of(piece).size();
    give(lesson, "proof tests", count(tests));
    give(lesson, "spoiled covers", words(covers(spoiled, shape) ? "certified, too" : "refused"));
    give(lesson, "uncovered", number(100 * bad.uncovered, 1, "%"));
    give(lesson, "bad verdict", said_of(spoiled));
    give(lesson, "good verdict", said_of(sound));
    give(lesson, "ball", number(100 * radius, 0, "cm"));
    viz::Panel panel = draw(holed, spoiled);
    panel.view = box(-1.3, -1.1, 2.3, 1.6);
    add_ball(panel, sound[2], style(viz::Role::reference));
    add_body(panel, holed.b, 1);
    add_label(panel, viz::Role::body, holed.b.body.position, "ball", 1, radius);
    give(lesson, "hole", std::move(panel),
         {{"four sound circles say", "good verdict"}, {"with one too small", "bad verdict"}});
    give(lesson, "refused", refused(holed, spoiled));
    live::Scene play = to_play_with({holed.a, holed.b}, view, live::Told::verdicts);
    play.settings.contact_model = lod::ContactModel::centre_line;
    give(lesson, std::move(play));
}

/// A ball falls on the plank, whose cover is whole or lacks a circle.
void animate(Lesson& lesson) {
    constexpr double seconds = 2.2;
    std::vector<viz::Run<2>> runs;
    for (const std::string key : {"whole", "holed"}) {
        Circles circles = grid(4, 1);
        if (key == "holed") circles.erase(circles.begin() + 2);
        Meeting meeting = with_ball(circles, 0.2, Vec(0.5, 1.7));
        meeting.b.body.velocity = Vec(0, -1.5);
        lod::make_static(meeting.a.body);
        runs.push_back(run_of(meeting, down_to(1, lod::ContactModel::centre_line, 1.0 / 120),
                              seconds, video_words(lesson, key)));
    }
    viz::ImpactMotion motion;
    motion.seconds = 4;
    motion.title = video_words(lesson, "title");
    lesson.animation = viz::impact_motion<2>(runs, motion);
}

}  // namespace

void give_plank(Lesson& lesson) {
    give_cover(lesson, "one", 1, 1);
    give_cover(lesson, "four", 4, 1);
    give_cover(lesson, "strips", 8, 1);
    give_cover(lesson, "sixteen", 8, 2);
    give_spare(lesson);
    give_hole(lesson);
    animate(lesson);
}

}  // namespace lessons::cover
