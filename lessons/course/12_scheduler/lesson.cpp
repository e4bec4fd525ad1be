#include "lessons/course/12_scheduler/lesson.hpp"

#include <algorithm>

namespace lessons {
namespace scheduler {
namespace {

using lod::Priority;
using Record = lod::FrameRecord<2>;

viz::Run<2> run_of(const Crowd& crowd, const Record& record) {
    viz::Run<2> run;
    run.visuals = crowd.visuals;
    viz::add_instant(run, crowd.before.front(), record);
    return run;
}

/// The scene above its lists, so that they can be read on a narrow page; the bar beside it.
void lay_out(viz::Figure& figure) {
    figure.aspect = 1.05;
    figure.row_weights = {1.5, 1};
    const bool bar = figure.panels.size() > 2;
    figure.columns = bar ? 3 : 1;
    figure.column_weights = bar ? std::vector<double>{1, 0.95, 0.42} : std::vector<double>{};
    figure.panels[0].cell = viz::Cell{0, 0, 1, bar ? 2 : 1};
    figure.panels[1].cell = viz::Cell{1, 0};
    if (!bar) return;
    figure.panels[2].cell = viz::Cell{1, 1, 1, 2};
    figure.panels[3].cell = viz::Cell{0, 2};
}

/// The crowd by the levels that it reached, and what the quota went into.
viz::Figure draw(const Crowd& crowd, const Record& record, bool limited,
                 std::optional<std::array<double, 3>> fixation = {}) {
    viz::CrowdChoice choice;
    if (limited) choice.quota.node_tests = crowd.quota();
    choice.fixation = fixation;
    viz::Figure figure = viz::crowd_picture<2>(run_of(crowd, record), 0, choice);
    std::erase_if(figure.numbers,
                  [](const viz::Quantity& one) { return one.name != "mean level"; });
    lay_out(figure);
    return figure;
}

/// Pairs that nothing proved apart, at a level.
std::size_t pairs_at(const Record& record, int level) {
    return static_cast<std::size_t>(
        std::count_if(record.pairs.begin(), record.pairs.end(), [&](const lod::PairRecord& pair) {
            return pair.verdict != lod::Verdict::apart && pair.level == level;
        }));
}

void give_crowd(Lesson& lesson, const Crowd& crowd) {
    lod::FrameStorage<2> storage;
    lod::Budget budget = lod::Budget::unlimited();
    const Record& record = lod::detect<2>(crowd.before.front(), {}, budget, storage);
    give(lesson, "bodies", count(crowd.visuals.size()));
    give(lesson, "candidates", count(record.pairs.size()));
    give(lesson, "meeting", count(record.levels_reached().pairs));
    give(lesson, "wanted", count(record.tests));
    give(lesson, "quota", count(crowd.quota()));
    give(lesson, "crowd", draw(crowd, record, false));
}

void give_level_order(Lesson& lesson, const Crowd& crowd) {
    const Record record = first_frame(crowd, Priority::level_order, {});
    const std::uint64_t left = record.spending.tests_left.value_or(0);
    give(lesson, "spent", count(record.tests));
    give(lesson, "reserved", count(crowd.quota() - record.tests - left));
    give(lesson, "left", count(left));
    give(lesson, "level order mean", number(record.levels_reached().mean, 1));
    give(lesson, "level order leaves", count(pairs_at(record, 3)));
    give(lesson, "level_order", draw(crowd, record, true));
}

void give_first_come(Lesson& lesson, const Crowd& crowd) {
    const Record record = first_frame(crowd, Priority::first_come, {});
    give(lesson, "first come mean", number(record.levels_reached().mean, 1));
    give(lesson, "first come leaves", count(pairs_at(record, 3)));
    give(lesson, "first come roots", count(pairs_at(record, 0)));
    for (std::size_t body = 0; lesson.numbers.count("L entry") == 0; ++body)
        if (crowd.visuals[body].name == "L")
            give(lesson, "L entry", count(crowd.before[0][body].tree->hulls.entry_level));
    give(lesson, "first_come", draw(crowd, record, true));
}

/// A level that waits: what it costs, and what it is expected to bring.
struct Offer {
    std::uint64_t tests = 0;
    double fall = 0;  ///< [m]
    [[nodiscard]] double value() const { return fall / static_cast<double>(tests); }
};

/// All levels that are asked for in the first frame, by a policy of our own that listens.
std::vector<Offer> offers_of(const Crowd& crowd) {
    std::vector<Offer> offers;
    lod::FrameStorage<2> storage;
    // listing: own policy
    storage.scheduler.own_value = [&](const lod::LevelOffer<2>& offer) {
        offers.push_back({offer.tests, offer.error_fall});
        return offer.error_fall / static_cast<double>(offer.tests);  // as best_gain
    };
    // end of listing
    lod::Budget budget = lod::Budget::node_tests(crowd.quota(), pair_cost);
    (void)lod::detect<2>(crowd.before.front(), {}, budget, storage);
    return offers;
}

void give_best_gain(Lesson& lesson, const Crowd& crowd) {
    const std::vector<Offer> offers = offers_of(crowd);
    const auto by = [&](auto key) {
        return *std::max_element(offers.begin(), offers.end(),
                                 [&](const Offer& x, const Offer& y) { return key(x) < key(y); });
    };
    const double widest = by([](const Offer& offer) { return offer.fall; }).fall;
    // Of those that bring most in all the dearest, and what brings most a test.
    const Offer large = by([&](const Offer& offer) {
        return offer.fall == widest ? static_cast<double>(offer.tests) : 0.0;
    });
    const Offer worthy = by([&](const Offer& offer) {
        return offer.fall < 0.8 * widest && offer.value() > 1.3 * large.value() ? offer.fall : 0;
    });
    for (const auto& [name, offer] :
         {std::pair{"first offer ", large}, {"second offer ", worthy}}) {
        give(lesson, std::string(name) + "tests", count(offer.tests));
        give(lesson, std::string(name) + "fall", number(1000 * offer.fall, 0, "mm"));
        give(lesson, std::string(name) + "value", number(1000 * offer.value(), 2, "mm"));
    }
    const Record record = first_frame(crowd, Priority::best_gain, {});
    give(lesson, "best gain mean", number(record.levels_reached().mean, 1));
    give(lesson, "best_gain", draw(crowd, record, true));
    const Record traded = first_frame(crowd, Priority::trade, {});
    int differing = 0;
    for (std::size_t i = 0; i < record.pairs.size(); ++i)
        differing += record.pairs[i].level == traded.pairs[i].level ? 0 : 1;
    give(lesson, "trade differs", count(differing));
}

/// The mean level of the pairs that meet on one side of the middle.
double mean_level(const Crowd& crowd, const Record& record, bool right) {
    double sum = 0;
    int pairs = 0;
    for (const lod::PairRecord& pair : record.pairs) {
        const auto x = [&](std::int32_t body) {
            return crowd.before.front()[lod::at(body)].position.x();
        };
        if (pair.verdict == lod::Verdict::apart) continue;
        if ((x(pair.bodies.a) + x(pair.bodies.b) > 0) != right) continue;
        sum += pair.level;
        ++pairs;
    }
    return sum / pairs;
}

void give_perceptual(Lesson& lesson, const Crowd& crowd) {
    for (const auto& [name, place] : {std::pair{"left", -aside}, {"right", aside}}) {
        const lod::Viewer viewer = looking_at(place);
        const Record record = first_frame(crowd, Priority::perceptual, viewer);
        const std::string look = std::string("look ") + name + ", ";
        give(lesson, look + "left half", number(mean_level(crowd, record, false), 1));
        give(lesson, look + "right half", number(mean_level(crowd, record, true), 1));
        give(lesson, std::string("look ") + name, draw(crowd, record, true, viewer.fixation));
    }
}

void give_closing_speed(Lesson& lesson, const Crowd& crowd) {
    const Record record = first_frame(crowd, Priority::closing_speed, {});
    give(lesson, "closing mean", number(record.levels_reached().mean, 1));
    give(lesson, "closing_speed", draw(crowd, record, true));
}

/// The observer looks from the left to the right.
void animate(Lesson& lesson, const Crowd& crowd) {
    constexpr int steps = 40;
    const std::string title = video_words(lesson, "title");
    for (int i = 0; i <= steps; ++i)
        lesson.animation.shots.push_back(
            {[crowd, i, title] {
                 const lod::Viewer viewer = looking_at(aside * (2.0 * i / steps - 1));
                 viz::Figure figure = draw(crowd, first_frame(crowd, Priority::perceptual, viewer),
                                           true, viewer.fixation);
                 figure.title = title;
                 return figure;
             },
             i == steps ? 60 : 4});
}

}  // namespace
}  // namespace scheduler

void make_scheduler(Lesson& lesson) {
    const scheduler::Crowd crowd;
    scheduler::give_crowd(lesson, crowd);
    scheduler::give_level_order(lesson, crowd);
    scheduler::give_first_come(lesson, crowd);
    scheduler::give_closing_speed(lesson, crowd);
    scheduler::give_best_gain(lesson, crowd);
    scheduler::give_perceptual(lesson, crowd);
    scheduler::give_worth(lesson, crowd);
    give(lesson, scheduler::play(crowd));
    scheduler::animate(lesson, crowd);
}

}  // namespace lessons
