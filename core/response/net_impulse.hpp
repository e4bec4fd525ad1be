#pragma once

/// \file
/// The default response: one net impulse a pair, exact in energy, in bounded time.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/response/impact_row.hpp"
#include "lodlab/core/response/pairs_of_bodies.hpp"
#include "lodlab/core/tree/budget.hpp"

namespace lod {

/// What a response did, and what it left.
struct ResponseReport {
    int most_visits = 0;           ///< to one pair, or the most rounds of one island
    std::uint64_t row_visits = 0;  ///< closing velocities asked for: what its time is linear in
    std::int32_t approaching = 0;  ///< contacts that go on approaching: they wait a frame
    double fastest = 0;            ///< the largest of their closing speeds [m/s]
    std::int32_t unasked = 0;      ///< pairs that were to be asked again when the clock was over
};

/// The energy-exact net impulse of many contacts, each pair by itself and then all that act on each
/// other together (METHOD.md, the default response).
///
/// A pair's contacts approach with u_i < 0 and have the effective masses 1/A_ii. With
///     d_i = -u_i/A_ii,   g = sum d_i J_i,   w = sum d_i (-u_i),   q = g^T M^-1 g,   sigma = w/q
/// the pair's own impulse at e = 0 is sigma g: the same however often contacts are repeated.
///
/// Pairs that approach now and share moving bodies act at once. With
///     D_p = (1 + e_p) sigma_p g_p,   S = sum (1 + e_p)^2 sigma_p w_p,
/// and Q the inverse-mass norm of the sum of all D_p, body by body, every D_p is scaled by s = S/Q.
/// Where pairs do not act on each other s = 1. Kinetic energy is kept exactly at e = 1 and never
/// grows at e <= 1.
///
/// Where a body is so heavy that the pairs at it hardly act on each other, each *leans* on it as on
/// a wall and does not share its scale with the others. What the clusters that are left do to each
/// other is found by Jacobi's method on their scales, sum_k G_ck s_k = S_c, where G_ck is the
/// inverse-mass product of the summed D_p of two clusters. So a static body is the limit of heavy
/// ones. The scale of all that hang together then makes energy exact, as above.
///
/// One such step is a *round*. It keeps momentum and is exact in energy by itself, so that the
/// response may end after any. Only pairs of bodies that a round has changed are asked again, in
/// the order of their numbers, and each at most most_visits times: the work is bounded by that
/// number times the contacts.
///
/// Keeps its storage: a warm call allocates nothing.
template <int Dim>
class NetImpulse {
  public:
    /// Resolves all contacts; adds each one's impulse [N s] to `impulses`, same order as `impacts`.
    ResponseReport resolve(std::span<const Impact<Dim>> impacts, std::span<Body<Dim>> bodies,
                           std::span<double> impulses, int most_visits);

    /// Whose threads gather bodies, work out contacts and what pairs by themselves ask for;
    /// nothing: the calling one alone. It must outlive resolve, whose bits do not depend on it.
    Executor* executor = nullptr;
    /// Whose clock may end it after any round but the first; nothing: no clock. It must outlive
    /// resolve.
    Budget* budget = nullptr;

  private:
    using Row = ImpactRow<Dim>;
    using Push = ImpactPush<Dim>;
    struct Pair {
        std::int32_t a = 0;  ///< into touched_
        std::int32_t b = 0;
        std::int32_t first = 0;  ///< into rows_
        std::int32_t end = 0;
        bool moves_a = false;  ///< not static
        bool moves_b = false;
        int visits = 0;
        double restitution = 0;
        double threshold = 0;  ///< a contact approaches beyond this speed [m/s]
        double scale = 0;      ///< (1 + e) sigma of this round
        Push push_a;           ///< D of this round
        Push push_b;
        double norm_a = 0;  ///< its square by the inverse mass and inertia of A
        double norm_b = 0;
        std::int32_t cluster = 0;
    };
    /// What one round does to a body. `round` says for which round the rest was written. What
    /// stands after `push` is kept for the body that a set is named by.
    struct BodyRound {
        std::uint64_t round = 0;
        std::int32_t group = 0;    ///< union-find over bodies that hang together
        std::int32_t cluster = 0;  ///< the same without those that are leaned on
        double strain = 0;         ///< sum over its pairs of the root of their norm at it
        Push push;                 ///< sum of s D
        double squares = 0;        ///< of a cluster: S
        double reaction = 0;       ///< of a cluster: sum_k G_ck s_k
        double diagonal = 0;       ///< of a cluster: about G_cc
        double scale = 1;          ///< of a cluster: s
        bool leans = false;        ///< of a group: whether it has several clusters
        double group_squares = 0;  ///< of a group: sum of s S
        double group_norm = 0;     ///< of a group: s^T G s
    };
    /// What a part of the pairs that a round asks came to.
    struct Asked {
        std::size_t begin = 0;
        std::size_t approaching = 0;  ///< from there on in approaching_
        int most_visits = 0;
        std::uint64_t row_visits = 0;
    };
    using Set = std::int32_t BodyRound::*;

    void prepare(std::span<const Impact<Dim>> impacts);
    [[nodiscard]] Row row(const Impact<Dim>& impact) const;
    void list_neighbours();
    /// The push's square by the body's inverse mass and inertia.
    [[nodiscard]] double inverse_norm(std::int32_t body, const Push& push) const {
        return push.inverse_norm(touched_[body].inverse_mass, touched_[body].inverse_inertia);
    }
    void ask();
    [[nodiscard]] bool approaches(Pair& pair);
    [[nodiscard]] std::int32_t root_of(Set set, std::int32_t body);
    void unite(Set set, std::int32_t a, std::int32_t b);
    void enter(std::int32_t body, double norm);
    [[nodiscard]] bool leans(const Pair& pair, std::int32_t body, double norm) const;
    void join(Pair& pair);
    void add_pushes(std::span<const std::int32_t> to, std::span<const std::int32_t> of_pairs);
    template <class Visit>
    void each_pair(std::span<const std::int32_t> pairs, const Visit& visit);
    template <class Visit>
    void each_changed(const Visit& visit);
    void relax();
    [[nodiscard]] double product(std::int32_t body, const Push& push) const;
    void apply(std::span<double> impulses);
    void round(std::span<double> impulses);
    void ask_neighbours(int most_visits);
    [[nodiscard]] bool goes_on(std::int32_t rounds, std::size_t before);
    void report_rest(int most_visits);

    TouchedBodies<Dim> touched_;
    std::vector<std::int32_t> order_;  ///< contacts, pair by pair
    std::vector<Row> rows_;
    std::vector<Pair> pairs_;
    PairsOfBodies neighbours_;         ///< of moving bodies
    std::vector<std::int32_t> asked_;  ///< pairs of this round
    std::vector<Asked> asked_parts_;
    std::vector<std::int32_t> approaching_;
    std::vector<std::int32_t> changed_;         ///< bodies
    std::vector<std::int32_t> leaning_bodies_;  ///< of them: those of groups of several clusters
    std::vector<std::int32_t> leaning_pairs_;   ///< the same of approaching_
    std::vector<BodyRound> body_;
    std::vector<std::uint64_t> queued_;  ///< of each pair: the last round that asks for it
    std::uint64_t round_ = 0;
    ResponseReport report_;
};

extern template class NetImpulse<2>;
extern template class NetImpulse<3>;

}  // namespace lod
