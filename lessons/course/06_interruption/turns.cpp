#include <algorithm>
#include <numeric>

#include "lessons/course/06_interruption/lesson.hpp"

namespace lessons::interruption {

// listing: turns_of
std::vector<Turn> turns_of(const Costs& costs, lod::Priority order, Stop stop,
                           std::uint64_t quota) {
    // Level 0 of both, whatever the quota.
    std::vector<Turn> turns = {Turn{0, 0, 0, 1}, Turn{1, 0, 1, 1}};
    std::array<int, 2> next{1, 1};
    std::uint64_t spent = 2;
    const auto waits = [&](int pair) {
        const auto p = static_cast<std::size_t>(pair);
        return static_cast<std::size_t>(next[p]) < costs[p].size();
    };
    while (waits(0) || waits(1)) {
        int pair = waits(0) ? 0 : 1;
        const bool by_turns = order == lod::Priority::level_order;
        if (waits(1) && by_turns && next[1] < next[0]) pair = 1;
        const auto p = static_cast<std::size_t>(pair);
        Turn turn{pair, next[p], spent, costs[p][static_cast<std::size_t>(next[p])]};
        if (spent + turn.tests <= quota) {
            spent += turn.tests;
            ++next[p];
        } else if (stop == Stop::clock) {
            turn.tests = std::max(quota, spent) - spent;
            turn.end = End::lost;
        } else {
            turn.end = End::left_out;
            next[p] = static_cast<int>(costs[p].size());  // waits no more
        }
        turns.push_back(turn);
        if (turn.end == End::lost) break;
    }
    return turns;
}
// end of listing

std::array<int, 2> finished(const std::vector<Turn>& turns) {
    std::array<int, 2> levels{0, 0};
    for (const Turn& turn : turns)
        if (turn.end == End::done) levels[static_cast<std::size_t>(turn.pair)] = turn.level;
    return levels;
}

namespace {

viz::Style style_of(const Turn& turn) {
    if (turn.end == End::lost) return style(viz::Role::excess);
    if (turn.end == End::left_out) return style(viz::Role::reference);
    return style(viz::Role::reached, turn.pair, turn.level);
}

}  // namespace

viz::Panel chart(const std::vector<Turn>& turns, std::uint64_t most, std::uint64_t quota) {
    constexpr double row = 1.7;    // from row to row
    constexpr double high = 0.95;  // a block
    constexpr double names = 32;   // tests: how far to the left the rows' names begin
    constexpr double every = 20;   // tests, from tick to tick
    viz::Panel panel;
    const auto end = static_cast<double>(most);
    panel.view = box(-names, -0.15, 1.02 * end, 2 * row);
    panel.axes = viz::Axes{{"tests of the frame", viz::Scale::linear, {}, true},
                           {"", viz::Scale::linear, {}, false, true}};
    for (double tick = 0; tick <= end; tick += every) panel.axes->x.ticks.push_back(tick);
    for (const Turn& turn : turns) {
        const double low = turn.pair == 0 ? row : 0;
        const auto from = static_cast<double>(turn.begin);
        const double to = from + static_cast<double>(turn.tests);
        panel.marks.push_back(viz::Path{
            style_of(turn), {{{from, low}, {to, low}, {to, low + high}, {from, low + high}}}});
        if (turn.level > 0)
            add_label(panel, viz::Role::note, {(from + to) / 2, low + high},
                      turn.end == End::lost ? "lost" : std::to_string(turn.level));
    }
    for (const auto& [name, low] : {std::pair{"pair 1", row}, {"pair 2", 0.0}})
        add_label(panel, viz::Role::note, {-names, low + high / 2}, name);
    if (quota == 0) return panel;
    const auto x = static_cast<double>(quota);
    viz::Polyline line{style(viz::Role::normal), {{x, -0.15}, {x, 2 * row - 0.1}}, 1, {}};
    line.end_label = shown_count(quota);
    panel.marks.push_back(std::move(line));
    return panel;
}

}  // namespace lessons::interruption
