#pragma once

/// \file
/// From contacts to new velocities: the ways to resolve many contacts at once, by name.

#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/base/names.hpp"
#include "lodlab/core/response/net_impulse.hpp"

namespace lod {

/// How the impulses of many contacts become one change of velocities.
enum class Response {
    net,         ///< the energy-exact net impulse (default)
    sum,         ///< teaching: the sum of independent impulses; may multiply energy
    mean,        ///< teaching: the mean of them per body pair; loses energy
    sequential,  ///< reference: equation (1) contact after contact until none approaches
    /// Reference: frictionless Newton impacts, all contacts at once: u+ >= -e u. Never adds energy,
    /// but a contact that was parting at u may approach at e u afterwards.
    lcp,
    reflections,  ///< reference: generalised reflections (Smith, Kaufman, Vouga, Tamstorf and
                  ///< Grinspun, Reflections on Simultaneous Impact, 2012)
};
/// Their words in scenes, options and messages.
[[nodiscard]] constexpr std::array<std::string_view, 6> names_of(Response) {
    return {"net", "sum", "mean", "sequential", "lcp", "reflections"};
}
static_assert(names_of(Response{}).size() == static_cast<std::size_t>(Response::reflections) + 1);

/// Resolves all contacts of an instant: changes the velocities and spins of the bodies and writes
/// the total impulse of each contact (>= 0, same order as `impacts`). What `net` does is said at
/// NetImpulse. The references work island by island, an island being what hangs together by
/// contacts between moving bodies.
///
/// A resolver keeps its storage: a warm call allocates nothing.
template <int Dim>
class Resolver {
  public:
    /// How often `net` asks a pair of bodies at most; what approaches after that waits a frame.
    static constexpr int most_visits = 32;
    /// What `net` costs at most for a node pair of a front, whose patch has few points: each visit
    /// asks for one closing velocity a point, and a last one finds what still approaches.
    static constexpr std::uint64_t row_visits_of_a_node_pair =
        (most_visits + 1) * most_patch_points<Dim>;
    static constexpr int most_sequential_sweeps = 64;
    /// A contact counts as approaching only beyond this share of the largest closing speed that the
    /// island began with.
    static constexpr double settled_share = 1e-12;
    /// Newton impacts are solved until a sweep changes no closing velocity by more than this share
    /// of the fastest contact point's speed: some ten units of rounding.
    static constexpr double gauss_seidel_share = 2e-15;
    static constexpr int most_reflections = 1000;

    /// See the class. `impulses` is replaced. `executor`: whose threads do the
    /// parts of `net`, and carry inertia to the world.
    ResponseReport resolve(Response response, std::span<const Impact<Dim>> impacts,
                           std::span<Body<Dim>> bodies, std::vector<double>& impulses,
                           Executor* executor = nullptr);

    /// Whose clock may end `net` between two rounds; nothing: no clock. It must outlive resolve.
    Budget* budget = nullptr;

  private:
    struct Island {
        std::int32_t first = 0;  ///< into order_
        std::int32_t count = 0;
    };

    using Impacts = std::span<const Impact<Dim>>;
    using Bodies = std::span<Body<Dim>>;
    using Impulses = std::vector<double>;

    void resolve_islands(Response response, Impacts impacts, Bodies bodies, Impulses& impulses);
    void find_islands(Impacts impacts, std::span<const Body<Dim>> bodies);
    [[nodiscard]] std::span<const std::int32_t> contacts_of(const Island& island) const {
        return std::span(order_).subspan(static_cast<std::size_t>(island.first),
                                         static_cast<std::size_t>(island.count));
    }
    [[nodiscard]] double fastest_approach(const Island& island, Impacts impacts,
                                          std::span<const Body<Dim>> bodies) const;
    void sequential_sweeps(const Island& island, double threshold, Impacts impacts, Bodies bodies,
                           Impulses& impulses);
    [[nodiscard]] double gauss_seidel_tolerance(const Island& island, Impacts impacts,
                                                std::span<const Body<Dim>> bodies) const;
    void resolve_lcp(const Island& island, Impacts impacts, Bodies bodies, Impulses& impulses);
    void resolve_reflections(const Island& island, double threshold, Impacts impacts, Bodies bodies,
                             Impulses& impulses);
    void resolve_independently(bool mean, Impacts impacts, Bodies bodies, Impulses& impulses);

    std::vector<Inertia<Dim>> inverse_inertia_;  ///< world frame, of each body
    std::vector<std::int32_t> root_;             ///< union-find over bodies
    std::vector<std::int32_t> order_;            ///< contacts, island by island
    std::vector<Island> islands_;
    std::vector<double> part_;    ///< of each contact: its impulse in one round of reflections
    std::vector<double> target_;  ///< least closing velocity of each contact after the impact
    std::vector<std::int32_t> violated_;
    NetImpulse<Dim> net_;
    ResponseReport report_;
};

extern template class Resolver<2>;
extern template class Resolver<3>;

}  // namespace lod
