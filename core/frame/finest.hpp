#pragma once

/// \file
/// The levels after the leaves: contact of true shapes, and backtracking to their time of impact.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/names.hpp"
#include "lodlab/core/exact/time_of_impact.hpp"
#include "lodlab/core/frame/schedule.hpp"

namespace lod {

/// How far a frame goes beyond the leaves (section 4.2: polygon tests and backtracking are the
/// "possible final level of detail to be applied to the highest-priority collisions only").
enum class Finest {
    leaves,     ///< no further
    exact,      ///< the true shapes: whether they overlap, and where they touched
    backtrack,  ///< and the response happens at the time of impact, not at the end of the frame
};
/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 3> names_of(Finest) {
    return {"leaves", "exact", "backtrack"};
}
static_assert(names_of(Finest{}).size() == static_cast<std::size_t>(Finest::backtrack) + 1);

/// The levels after the leaves, as a setting of frames.
struct FinestDetail {
    Finest level = Finest::leaves;
    int most_pairs = 8;  ///< of a frame, the first in the order of priority
    /// Node tests that one pair's exact query counts as in the budget. No such query has a fixed
    /// price (section 3): this is about what one of two gears takes, some 10 us. A deadline is
    /// checked before each query, and one query may overrun it.
    std::uint64_t cost = 2000;
    double tolerance = 1e-9;  ///< of touching [m], see ImpactSettings
};

/// What the true shapes of two bodies say of the instant at which nodes of theirs overlap.
enum class ExactVerdict {
    apart,       ///< they share no point and are further apart than the tolerance
    touched,     ///< they overlap, or touch; the contacts are known
    unresolved,  ///< they overlap at every moment that was looked at: the leaves' contacts stand
};

/// The exact level of one pair.
template <int Dim>
struct ExactContact {
    ExactVerdict verdict = ExactVerdict::apart;
    /// When the shapes touched last or will touch next, from now [s]: at most one look_back before
    /// (negative), or after, 0 where they touch now.
    double time = 0;
    Body<Dim> a;  ///< at that moment
    Body<Dim> b;
    std::vector<Contact<Dim>> contacts;  ///< of that moment
};

/// Exact contact of two bodies, which may overlap a little: the contacts of the moment at which
/// they touched, as they came, found by going back for `look_back` seconds of free motion and then
/// on to the time of impact. Where they overlapped then, too, the moment at which they will come
/// apart within look_back seconds stands for it: bodies that were pushed and still part.
/// Requires: the exact shapes of both, look_back > 0.
template <int Dim>
[[nodiscard]] ExactContact<Dim> exact_contact(const Body<Dim>& a, const Body<Dim>& b,
                                              double look_back, double tolerance = 1e-9);

/// The contacts of another moment as they stand now: a point and a normal go half with each body.
/// `depth` is by how much the two surfaces have passed each other since along the normal.
template <int Dim>
[[nodiscard]] std::vector<Contact<Dim>> carried_contacts(const ExactContact<Dim>& touch,
                                                         const Body<Dim>& a, const Body<Dim>& b);

/// The exact level of one candidate pair in a frame.
template <int Dim>
struct FinestPair {
    std::int32_t pair = 0;     ///< into the candidates
    bool backtracked = false;  ///< the response happens at `touch.time`, with touch.a, touch.b
    ExactContact<Dim> touch;
    std::vector<Contact<Dim>> contacts;  ///< for the response; of now, or of touch.time
};

/// The candidate pairs of a frame, and how far beyond the leaves they go.
template <int Dim>
struct TrueShapeTask {
    std::span<const Body<Dim>> bodies;
    std::span<const CandidatePair> pairs;
    std::span<const std::int32_t> order;  ///< of priority
    FinestDetail detail;
    double time_step = 0;  ///< [s], > 0
};

/// The levels after the leaves (see schedule.hpp, whose refine_all goes before).
template <int Dim>
class TrueShapePass {
  public:
    /// Asks the true shapes of those pairs whose leaves overlap, in the order of priority, until
    /// the budget ends or most_pairs have been asked. A pair whose bodies have no exact shape is
    /// passed over. Clears the front of a pair that turns out to be apart.
    ///
    /// Backtracking rewinds two bodies alone, so a pair is backtracked only if it touched within
    /// the last time_step and no body of it that moves is in any other collision of the frame;
    /// otherwise its contacts are carried to the present. Where the budget cuts something short,
    /// Budget::cut says where.
    void refine(const TrueShapeTask<Dim>& task, Budget& budget, Fronts& fronts);
    /// Forgets what was found.
    void clear() { found_.clear(); }

    /// In the order of the candidates.
    [[nodiscard]] const std::vector<FinestPair<Dim>>& found() const { return found_; }
    /// How many pairs the last `refine` looked at, again and again: three times each at most.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    bool ask(const TrueShapeTask<Dim>& task, std::int32_t pair, Budget& budget, Fronts& fronts);
    void settle_backtracking(const TrueShapeTask<Dim>& task, const Fronts& fronts);
    void count_collisions(const TrueShapeTask<Dim>& task, const Fronts& fronts);
    [[nodiscard]] bool collides_elsewhere(const TrueShapeTask<Dim>& task, const Fronts& fronts,
                                          std::size_t own) const;

    std::vector<FinestPair<Dim>> found_;
    std::vector<std::int32_t> collisions_;  ///< of each body
    std::uint64_t node_pairs_ = 0;          ///< of all fronts, or true contacts in their place
    std::uint64_t steps_ = 0;
};

extern template class TrueShapePass<2>;
extern template class TrueShapePass<3>;

}  // namespace lod
