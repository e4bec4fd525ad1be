#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/contact.hpp"

namespace lod {

/// One contact of the response stage: what touches, where, and which collision it belongs to.
template <int Dim>
struct Impact {
    std::int32_t a = 0;     ///< index of body A
    std::int32_t b = 0;     ///< index of body B
    std::int32_t pair = 0;  ///< contacts of one body pair carry the same number
    Contact<Dim> contact;
};

/// How the impulses of many contacts become one change of velocities.
enum class Response {
    net,   ///< the energy-exact net impulse (default)
    sum,   ///< teaching: the sum of independent impulses; multiplies energy
    mean,  ///< teaching: the mean of them per body pair; loses energy
};

/// Closing velocity v_c at a contact (paper, eq. 3): the normal part of B's velocity relative to
/// A's [m/s]. Negative when the bodies approach.
template <int Dim>
[[nodiscard]] double closing_velocity(const Body<Dim>& a, const Body<Dim>& b,
                                      const Contact<Dim>& contact);

/// K of equation (1) [1/kg]: how much v_c changes for a unit impulse along the normal.
template <int Dim>
[[nodiscard]] double inverse_effective_mass(const Body<Dim>& a, const Body<Dim>& b,
                                            const Contact<Dim>& contact);

/// The impulse of a single contact (paper, eq. 1) [N s], >= 0; 0 when the bodies are parting
/// already or neither can move. Restitution is the smaller of the two.
template <int Dim>
[[nodiscard]] double single_impulse(const Body<Dim>& a, const Body<Dim>& b,
                                    const Contact<Dim>& contact);

/// Pushes B along +n and A along -n with the impulse j [N s] at the contact point.
template <int Dim>
void apply_impulse(Body<Dim>& a, Body<Dim>& b, const Contact<Dim>& contact, double j);

/// Resolves all contacts of an instant: changes the velocities and spins of the bodies and writes
/// the total impulse of each contact (>= 0, same order as `impacts`).
///
/// `net`: contacts of pairs that share a moving body form an island. Within an island, with the
/// closing velocities u_i < 0 of the approaching contacts and the coupling A_ik, the direction is
/// d_i = -u_i / A_ii and the impulse j = s d with s = -(1 + e)(d.u) / (d^T A d), so that kinetic
/// energy changes by exactly -(1 - e^2)/2 (d.u)^2 / (d^T A d). Repeated while contacts approach
/// (at most most_net_rounds), then single impulses in turn (at most most_sequential_sweeps): an
/// elastic pair whose normals face each other within some 45 degrees takes 8 rounds at the very
/// most, an inelastic one nears its end geometrically. Contacts that contradict each other, as
/// where two bodies hook into each other, may go on approaching after that.
/// d^T A d is found from the net impulses on the bodies: linear in the contacts.
///
/// A resolver keeps its storage: a warm call allocates nothing.
template <int Dim>
class Resolver {
  public:
    static constexpr int most_net_rounds = 32;
    static constexpr int most_sequential_sweeps = 64;
    /// A contact counts as approaching only beyond this share of the largest closing speed that the
    /// island began with.
    static constexpr double settled_share = 1e-12;

    void resolve(Response response, std::span<const Impact<Dim>> impacts,
                 std::span<Body<Dim>> bodies, std::vector<double>& impulses);

    /// The most rounds that one island took in the last call.
    [[nodiscard]] int rounds() const { return rounds_; }

  private:
    struct Island {
        std::int32_t first = 0;  ///< into order_
        std::int32_t count = 0;
    };
    struct Push {  ///< net impulse on one body, and the net moment about its centre of mass
        Vector<Dim> linear;
        Spin<Dim> angular;
    };

    void find_islands(std::span<const Impact<Dim>> impacts, std::span<const Body<Dim>> bodies);
    void resolve_net(const Island& island, std::span<const Impact<Dim>> impacts,
                     std::span<Body<Dim>> bodies, std::vector<double>& impulses);
    bool net_round(const Island& island, double threshold, std::span<const Impact<Dim>> impacts,
                   std::span<Body<Dim>> bodies, std::vector<double>& impulses);
    void sequential_sweeps(const Island& island, double threshold,
                           std::span<const Impact<Dim>> impacts, std::span<Body<Dim>> bodies,
                           std::vector<double>& impulses);
    void resolve_independently(bool mean, std::span<const Impact<Dim>> impacts,
                               std::span<Body<Dim>> bodies, std::vector<double>& impulses);

    std::vector<Inertia<Dim>> inverse_inertia_;  ///< world frame, of each body
    std::vector<std::int32_t> root_;             ///< union-find over bodies
    std::vector<std::int32_t> order_;            ///< contacts, island by island
    std::vector<Island> islands_;
    std::vector<double> direction_;  ///< d of each contact
    std::vector<Push> push_;         ///< of each body
    std::vector<std::uint64_t> marked_;  ///< of each body: the last sweep that counted it
    std::uint64_t mark_ = 0;
    int rounds_ = 0;
};

extern template class Resolver<2>;
extern template class Resolver<3>;

}  // namespace lod
