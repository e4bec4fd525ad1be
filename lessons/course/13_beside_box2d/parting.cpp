#include <array>

#include "lessons/course/13_beside_box2d/lesson.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

namespace lessons::box2d {
namespace {

using lod::Body;
using Vec = lod::Vector<2>;

constexpr double scale = 64;  // units of Box2D a metre: skins of a sixth of a millimetre

/// A spinning rod that meets a box; the later the frames begin, the nearer they stand.
Meeting spinning_rod(Meeting meeting, double later) {
    meeting.a.body.velocity = Vec(1, 0);
    meeting.a.body.spin[0] = 4;
    meeting.a.body.position = Vec(-1.2, 0) + later * meeting.a.body.velocity;
    meeting.a.body.orientation = 1.7 + later * meeting.a.body.spin[0];
    meeting.b.body.position = Vec(0, 0.35);
    return meeting;
}

/// The mean error of both programs over frames that begin at different moments.
struct MeanErrors {
    double lodlab = 0;
    double box2d = 0;
};

MeanErrors errors_with(const Meeting& rod_and_box, double time_step) {
    constexpr int starts = 12;
    MeanErrors mean;
    for (int i = 0; i < starts; ++i) {
        const Meeting meeting = spinning_rod(rod_and_box, time_step * i / starts);
        const auto exact = exact_collision_of(meeting, 2);
        const auto settings = down_to(1000, lod::ContactModel::hull, time_step);
        mean.lodlab +=
            measure::impact_error(exact, collision_of(meeting, settings, 2)).impulse / starts;
        const lod2d::Box2dImpact impact = impact_by_box2d(meeting, time_step, scale);
        auto seen = exact;
        seen.before = {impact.before[0], impact.before[1]};
        seen.after = {impact.after[0], impact.after[1]};
        mean.box2d += measure::impact_error(exact, seen).impulse / starts;
    }
    return mean;
}

/// Three boxes of 1 kg in a row; the first arrives, the others touch.
std::vector<Body<2>> row_of_three(const lod2d::Shape& shape) {
    const viz::Actor<2> one = actor("box", shape, tree_of(shape, 2));
    std::vector<Body<2>> bodies(3, one.body);
    bodies[0].position = Vec(-1.5, 0);
    bodies[0].velocity = Vec(1, 0);
    bodies[2].position = Vec(1, 0);
    return bodies;
}

void run(std::vector<Body<2>>& bodies, lod::FrameSettings settings, int frames) {
    lod::FrameStorage<2> storage;
    for (int i = 0; i < frames; ++i) {
        lod::Budget budget = lod::Budget::unlimited();
        lod::advance<2>(bodies, settings, budget, storage);
    }
}

/// The row before, or after an answer.
viz::Panel row_panel(const std::vector<Body<2>>& bodies, const lod2d::Shape& shape,
                     const std::string& title) {
    constexpr double velocity_length = 0.8;
    viz::Panel panel;
    panel.view = box(-2.1, -0.55, 2.7, 0.85);
    panel.title = title;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        viz::Actor<2> one = actor("box", shape);
        one.body = bodies[i];
        viz::add_body(panel, one, static_cast<int>(i));
        const Vec v = bodies[i].velocity;
        const auto index = static_cast<int>(i);
        if (v.norm() < 1e-6) continue;
        const Vec x = one.body.position;
        add_arrow(panel, viz::Role::velocity, x, x + velocity_length * v, "", index);
        add_label(panel, viz::Role::body, x + Vec(0, 0.68), with_unit(shown(v.x(), 2), "m/s"),
                  index);
    }
    return panel;
}

/// A star and an L between four walls.
struct Room {
    lod2d::Shape star = lod2d::generate("star:5");
    lod2d::Shape L = lod2d::generate("L");
    std::vector<Body<2>> bodies;

    [[nodiscard]] std::vector<const lod2d::Shape*> shapes() const {
        return {&star, &L, &L, &L, &L, &L};  // Box2D takes a wall's border, not its shape
    }
};

Room make_room() {
    Room room;
    const Meeting meeting = meeting_of("star:5", "L", 4);
    room.bodies = meeting.bodies();
    room.bodies[0].position = Vec(-0.9, 0.2);
    room.bodies[0].velocity = Vec(1.3, 0.5);
    room.bodies[1].position = Vec(0.9, -0.1);
    room.bodies[1].velocity = Vec(-0.9, 0.4);
    for (const Vec& inwards : {Vec(1, 0), Vec(-1, 0), Vec(0, 1), Vec(0, -1)}) {
        Body<2> wall;
        lod::make_static(wall);
        wall.tree = std::make_shared<const lod::SphereTree<2>>(lod::half_space<2>(inwards));
        wall.position = -Vec(1.8 * inwards.x(), 1.3 * inwards.y());
        room.bodies.push_back(wall);
    }
    return room;
}

constexpr double frame_step = 1.0 / 60;
constexpr int watched = 300;  // frames

lod2d::Box2dRun room_by_box2d(const Room& room, double time_step) {
    lod2d::Box2dSettings settings;
    settings.time_step = time_step;
    settings.units_per_metre = 16;
    return lod2d::run_box2d(room.bodies, room.shapes(), watched, frame_step, settings);
}

using Way = std::vector<Vec>;  ///< of the star, frame by frame

Way way_of(const lod2d::Box2dRun& run) {
    Way way;
    for (const auto& bodies : run.frames) way.push_back(bodies[0].position);
    return way;
}

Way way_by_lodlab(const Room& room, int steps_a_frame) {
    std::vector<Body<2>> bodies = room.bodies;
    const lod::FrameSettings settings =
        down_to(1000, lod::ContactModel::hull, frame_step / steps_a_frame);
    Way way{bodies[0].position};
    for (int i = 0; i < watched; ++i) {
        run(bodies, settings, steps_a_frame);
        way.push_back(bodies[0].position);
    }
    return way;
}

viz::Curve apart(const Way& one, const Way& other, int series, const std::string& name) {
    viz::Curve curve;
    curve.name = name;
    curve.series = series;
    for (std::size_t i = 1; i < one.size(); i += 4)
        curve.points.push_back(
            {static_cast<double>(i) * frame_step, std::max(1e-6, (one[i] - other[i]).norm())});
    return curve;
}

viz::Panel rod_panel(const Meeting& start) {
    viz::Panel panel;
    panel.view = box(-1.85, -0.6, 0.7, 1.0);
    viz::add_body(panel, start.a, 0);
    viz::add_body(panel, start.b, 1);
    const Vec x = start.a.body.position;
    add_arrow(panel, viz::Role::velocity, x, x + 0.4 * start.a.body.velocity, "*v*_a");
    return panel;
}

}  // namespace

void give_steps(Lesson& lesson) {
    const Meeting rod_and_box = meeting_of("rod:1,0.1", "box:1,1", 3);
    give(lesson, "rod", rod_panel(spinning_rod(rod_and_box, 0)));
    std::array<viz::Curve, 2> curves;
    curves[0].name = "lodlab";
    curves[1].name = "Box2D";
    for (const int rate : {60, 120, 240, 480, 960}) {
        const MeanErrors mean = errors_with(rod_and_box, 1.0 / rate);
        curves[0].points.push_back({static_cast<double>(rate), mean.lodlab});
        curves[1].points.push_back({static_cast<double>(rate), mean.box2d});
        if (rate != 60 && rate != 960) continue;
        give(lesson, "lodlab " + std::to_string(rate),
             number(100 * mean.lodlab, rate == 60 ? 1 : 2, "%"));
        give(lesson, "Box2D " + std::to_string(rate),
             number(100 * mean.box2d, rate == 60 ? 1 : 2, "%"));
    }
    curves[1].series = 1;
    curves[0].dots = curves[1].dots = true;
    const viz::Axes axes{
        {"frames a second", viz::Scale::logarithmic, {60, 120, 240, 480, 960}, true},
        {"error of the impulse, mean", viz::Scale::logarithmic, {}, false}};
    give(lesson, "steps", viz::plot_panel("", axes, {curves[0], curves[1]}));
}

/// The row, for readers to play with.
live::Scene play_row(const lod2d::Shape& shape, const std::vector<Body<2>>& bodies,
                     double time_step) {
    std::vector<viz::Actor<2>> actors;
    for (const char* name : {"A", "B", "C"}) {
        viz::Visual<2> visual = viz::visual_of(shape);
        visual.name = name;
        actors.push_back({std::move(visual), bodies[actors.size()]});
    }
    live::Scene scene = to_play_with(std::move(actors), box(-2.4, -1.4, 2.9, 1.4));
    scene.settings = down_to(1000, lod::ContactModel::hull, time_step);
    return scene;
}

void give_row(Lesson& lesson) {
    const lod2d::Shape shape = lod2d::generate("box:1,1");
    constexpr double time_step = 1.0 / 240;
    constexpr int frames = 240;
    std::vector<Body<2>> net = row_of_three(shape);
    std::vector<Body<2>> lcp = net;
    const std::vector<Body<2>> start = net;
    lod::FrameSettings settings = down_to(1000, lod::ContactModel::hull, time_step);
    run(net, settings, frames);
    settings.response = lod::Response::lcp;
    run(lcp, settings, frames);
    lod2d::Box2dSettings how;
    how.time_step = time_step;
    const std::array<const lod2d::Shape*, 3> shapes{&shape, &shape, &shape};
    const std::vector<Body<2>> box2d =
        lod2d::run_box2d(start, shapes, frames, time_step, how).frames.back();
    const auto energy = [](const std::vector<Body<2>>& bodies) {
        return number(lod::kinetic_energy<2>(bodies), 2, "J");
    };
    give(lesson, play_row(shape, start, time_step));
    double apart = 0;
    for (const std::size_t i : {0u, 1u, 2u})
        apart = std::max(apart, (lcp[i].velocity - box2d[i].velocity).norm());
    give(lesson, "net 3", number(net[2].velocity.x(), 2, "m/s"));
    give(lesson, "net 2", number(net[1].velocity.x(), 2, "m/s"));
    give(lesson, "box2d 1", number(box2d[0].velocity.x(), 2, "m/s"));
    give(lesson, "box2d 3", number(box2d[2].velocity.x(), 2, "m/s"));
    give(lesson, "law apart", tiny(apart, "m/s"));
    give(lesson, "energy start", energy(start));
    give(lesson, "energy lodlab", energy(net));
    give(lesson, "energy box2d", energy(box2d));
    give(lesson, "rows",
         figure_of({row_panel(net, shape, "lodlab"), row_panel(box2d, shape, "Box2D")}, 1));
    give(lesson, "laws",
         figure_of({row_panel(box2d, shape, "Box2D"), row_panel(lcp, shape, "lodlab, lcp")}, 1));
}

void give_paths(Lesson& lesson) {
    const Room room = make_room();
    const lod2d::Box2dRun box2d = room_by_box2d(room, 1.0 / 960);
    const Way theirs = way_of(box2d);
    const Way finer = way_of(room_by_box2d(room, 1.0 / 1920));
    const Way ours = way_by_lodlab(room, 16);
    const auto at = [&](const Way& one, double seconds) {
        const auto frame = static_cast<std::size_t>(seconds / frame_step + 0.5);
        return (one[frame] - theirs[frame]).norm();
    };
    for (int s : {2, 3}) {
        give(lesson, "ours " + std::to_string(s), number(100 * at(ours, s), 1, "cm"));
        give(lesson, "finer " + std::to_string(s), number(100 * at(finer, s), 1, "cm"));
    }
    give(lesson, "impacts", count(box2d.impacts.size()));
    const viz::Axes axes{{"time [s]", viz::Scale::linear, {}, false},
                         {"how far apart the stars are [m]", viz::Scale::logarithmic, {}, false}};
    give(lesson, "paths",
         viz::plot_panel(
             "", axes, {apart(ours, theirs, 0, "lodlab"), apart(finer, theirs, 1, "finer Box2D")}));
}

}  // namespace lessons::box2d
