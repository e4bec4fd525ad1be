#include "lodlab/core/frame/schedule/entries.hpp"

#include <limits>

#include "tests/catch.hpp"

using namespace lod;

namespace {

/// Fronts of pairs that meet, or do not.
std::vector<ListedFront> fronts_of(std::initializer_list<bool> meeting) {
    std::vector<ListedFront> fronts;
    for (const bool meets : meeting) fronts.emplace_back().pairs.count = meets ? 1 : 0;
    return fronts;
}

/// The numbers of the pairs that may go on.
std::vector<std::size_t> chosen(std::uint64_t most, const std::vector<double>& weights,
                                std::vector<ListedFront> fronts) {
    Entries entries;
    entries.choose(most, weights, fronts);
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < fronts.size(); ++i)
        if (fronts[i].pairs.count > 0 && !fronts[i].by_roots) result.push_back(i);
    return result;
}

using Numbers = std::vector<std::size_t>;

}  // namespace

TEST_CASE("of pairs that meet the weightiest go to their entry levels, ties by number",
          "[entries]") {
    const auto fronts = fronts_of({true, true, false, true, true});
    const std::vector<double> weights{1, 3, 9, 2, 3};
    CHECK(chosen(0, weights, fronts) == Numbers{});
    CHECK(chosen(1, weights, fronts) == Numbers{1});
    CHECK(chosen(2, weights, fronts) == Numbers{1, 4});
    CHECK(chosen(3, weights, fronts) == Numbers{1, 3, 4});
    CHECK(chosen(9, weights, fronts) == Numbers{0, 1, 3, 4});
}

TEST_CASE("without weights the first pairs go on, and one that is no number comes last",
          "[entries]") {
    const auto fronts = fronts_of({false, true, true, true});
    CHECK(chosen(2, {}, fronts) == Numbers{1, 2});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(chosen(2, {0, nan, -1, -2}, fronts) == Numbers{2, 3});
}
