#include "lodlab/core/frame/schedule/trade.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

bool comes_before(const CandidatePair& x, const CandidatePair& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
}

/// The first of them in order, the rest left out.
template <class Side, class Before>
void keep_first(std::vector<Side>& sides, std::size_t most, const Before& before) {
    const std::size_t kept = std::min(most, sides.size());
    std::partial_sort(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(kept), sides.end(),
                      before);
    sides.resize(kept);
}

}  // namespace

void Trade::plan(std::span<const CandidatePair> pairs, std::vector<std::int32_t>& targets) {
    trades_ = 0;
    collect(pairs, targets);
    keep_first(sellers_, most_trades, [](const Side& x, const Side& y) {
        return x.fall_a_test != y.fall_a_test ? x.fall_a_test < y.fall_a_test : x.pair > y.pair;
    });
    keep_first(buyers_, most_trades, [](const Side& x, const Side& y) {
        return x.fall_a_test != y.fall_a_test ? x.fall_a_test > y.fall_a_test : x.pair < y.pair;
    });
    refill(traded_, pairs.size(), char{0});
    std::size_t next_seller = 0;
    for (const Side& buyer : buyers_)
        if (traded_[at(buyer.pair)] == 0 && !buy(buyer, next_seller, targets)) break;
}

/// What each pair held, and what it may give and take.
void Trade::collect(std::span<const CandidatePair> pairs, std::vector<std::int32_t>& targets) {
    refill(targets, pairs.size(), std::int32_t{-1});
    sellers_.clear();
    buyers_.clear();
    auto known = held.begin();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        while (known != held.end() && comes_before(known->bodies, pairs[i])) ++known;
        if (known == held.end() || !(known->bodies == pairs[i])) continue;
        targets[i] = known->level;
        const auto pair = static_cast<std::int32_t>(i);
        const auto side = [pair](double fall, std::uint64_t tests) {
            return Side{fall / static_cast<double>(tests), fall, tests, pair};
        };
        if (known->last_tests > 0) sellers_.push_back(side(known->last_fall, known->last_tests));
        if (known->next_tests > 0) buyers_.push_back(side(known->next_fall, known->next_tests));
    }
}

/// Lets sellers give up their last level until they pay for the buyer's next. Returns false, with
/// nothing changed, where that gains nothing.
bool Trade::buy(const Side& buyer, std::size_t& next_seller, std::vector<std::int32_t>& targets) {
    std::uint64_t freed = 0;
    double lost = 0;
    std::size_t seller = next_seller;
    for (; freed < buyer.tests && seller < sellers_.size(); ++seller) {
        const Side& offered = sellers_[seller];
        if (offered.pair == buyer.pair || traded_[at(offered.pair)] != 0) continue;
        freed += offered.tests;
        lost += offered.fall;
    }
    if (freed < buyer.tests || !(lost < buyer.fall)) return false;
    for (; next_seller < seller; ++next_seller) {
        const std::int32_t pair = sellers_[next_seller].pair;
        if (pair == buyer.pair || traded_[at(pair)] != 0) continue;
        traded_[at(pair)] = 1;
        --targets[at(pair)];
    }
    traded_[at(buyer.pair)] = 1;
    ++targets[at(buyer.pair)];
    ++trades_;
    return true;
}

}  // namespace lod
