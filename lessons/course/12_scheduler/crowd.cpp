#include <algorithm>

#include "lessons/course/12_scheduler/lesson.hpp"
#include "lodlab/core/base/random.hpp"
#include "lodlab/lod2d/shape/generators.hpp"

namespace lessons::scheduler {
namespace {

using lod::Body;
using Vec = lod::Vector<2>;

/// Shapes in rows that overlap a little here and there, all on their way to the middle.
std::vector<Body<2>> place_crowd(std::vector<viz::Visual<2>>& visuals) {
    constexpr int depth = 3;
    constexpr int columns = 7;
    constexpr int rows = 5;
    constexpr double pitch = 0.85;  // [m]
    constexpr double turn = 6.28;   // [rad]
    std::vector<viz::Actor<2>> kinds;
    for (const char* name : {"star:5", "gear:7", "L"}) {
        const lod2d::Shape shape = lod2d::generate(name);
        kinds.push_back(actor(name, shape, tree_of(shape, depth)));
    }
    lod::Random random(5);
    std::vector<Body<2>> bodies;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const auto kind = static_cast<std::size_t>(random.next() * 3);
            Body<2> body = kinds[kind].body;
            body.position.x() = pitch * (column - (columns - 1) / 2.0) + random.next(-0.1, 0.1);
            body.position.y() = pitch * (row - (rows - 1) / 2.0) + random.next(-0.1, 0.1);
            body.orientation = random.next(0, turn);
            body.velocity = -2 * body.position / (pitch * columns / 2);
            body.velocity.x() += random.next(-0.5, 0.5);
            body.velocity.y() += random.next(-0.5, 0.5);
            body.spin[0] = random.next(-1, 1);
            bodies.push_back(body);
            visuals.push_back(kinds[kind].visual);
        }
    return bodies;
}

/// The attention of each body: the most that one of its pairs has.
std::vector<double> attention_of(const std::vector<Body<2>>& bodies,
                                 const std::vector<lod::CandidatePair>& pairs) {
    std::vector<double> of_pair;
    lod::Attention<2>().weigh(looking_at(-aside), bodies, pairs, of_pair);
    std::vector<double> attention(bodies.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const std::int32_t body : {pairs[i].a, pairs[i].b})
            attention[lod::at(body)] = std::max(attention[lod::at(body)], of_pair[i]);
    return attention;
}

}  // namespace

Crowd::Crowd() {
    constexpr int frames = 20;
    std::vector<Body<2>> bodies = place_crowd(visuals);
    lod::FrameStorage<2> storage;
    for (int frame = 0; frame < frames; ++frame) {
        before.push_back(bodies);
        lod::Budget budget = lod::Budget::unlimited();
        const auto& record = lod::advance<2>(bodies, {}, budget, storage);
        after.push_back(bodies);
        candidates.push_back(storage.candidates);
        dearest = std::max(dearest, record.tests);
        if (frame == 0) first = record.tests;
    }
}

lod::Viewer looking_at(double right) {
    lod::Viewer viewer;
    viewer.fixation = {right, 0, 0};
    return viewer;
}

lod::FrameRecord<2> first_frame(const Crowd& crowd, lod::Priority policy,
                                const lod::Viewer& viewer) {
    lod::FrameSettings settings;
    settings.priority = policy;
    settings.viewer = viewer;
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::node_tests(crowd.quota(), pair_cost);
    return lod::detect<2>(crowd.before.front(), settings, budget, storage);
}

live::Scene play(const Crowd& crowd) {
    std::vector<viz::Actor<2>> actors;
    for (std::size_t i = 0; i < crowd.visuals.size(); ++i)
        actors.push_back({crowd.visuals[i], crowd.before.front()[i]});
    live::Scene scene =
        to_play_with(std::move(actors), box(-3.4, -2.4, 3.4, 2.4), live::Told::verdicts);
    scene.settings.priority = lod::Priority::level_order;
    scene.settings.viewer = looking_at(-aside);
    scene.budget = crowd.quota();
    scene.pair_cost = pair_cost;
    return scene;
}

// listing: error_of
Error error_of(const Crowd& crowd, lod::Priority policy, std::uint64_t quota) {
    lod::FrameSettings settings;
    settings.priority = policy;
    settings.viewer = looking_at(-aside);
    lod::FrameStorage<2> storage;
    Error wrong;
    Error change;
    for (std::size_t frame = 0; frame < crowd.before.size(); ++frame) {
        std::vector<Body<2>> bodies = crowd.before[frame];
        lod::Budget budget = lod::Budget::node_tests(quota, pair_cost);
        (void)lod::advance<2>(bodies, settings, budget, storage);
        const auto attention = attention_of(crowd.before[frame], crowd.candidates[frame]);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const Body<2>& right = crowd.after[frame][i];
            const double mass = 1 / right.inverse_mass;
            const double off = mass * (bodies[i].velocity - right.velocity).norm();
            const double due = mass * (right.velocity - crowd.before[frame][i].velocity).norm();
            wrong.all += off;
            change.all += due;
            wrong.attended += attention[i] * off;
            change.attended += attention[i] * due;
        }
    }
    return {wrong.all / change.all, wrong.attended / change.attended};
}
// end of listing

}  // namespace lessons::scheduler
