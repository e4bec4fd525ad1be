#pragma once

/// \file
/// Motion of bodies that are too fast for frames to see: none passes through another.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "lodlab/core/contact/front_contacts.hpp"
#include "lodlab/core/frame/meeting_queue.hpp"
#include "lodlab/core/math/box_tree.hpp"
#include "lodlab/core/response/response.hpp"

namespace lod {

/// What is looked at between two frames, where a body moves further than its own thickness and
/// could pass through another that no frame sees it in. Not in the paper, which tests instants.
struct SweepSettings {
    bool on = false;
    int deepest_level = 1000;  ///< of the trees that are swept; no budget is asked
    bool exact = false;        ///< the true shapes instead, where both bodies have one
    double tolerance = 1e-9;   ///< of the true shapes' touching [m], see ImpactSettings
    int most_impacts = 64;     ///< of a body in one frame; it stays where it has one more
};

/// A contact that a body ran into between two frames.
template <int Dim>
struct SweptImpact {
    std::int32_t a = 0;  ///< body numbers
    std::int32_t b = 0;
    double time = 0;       ///< since the frame's instant [s]
    Contact<Dim> contact;  ///< as it was then
    double impulse = 0;    ///< [N s]
};

/// How far a body reaches through: the least width of a hull of the tree's entry level, so of the
/// whole where it has no hollow, of its wall where it has one [m]. Where a tree has no hulls, the
/// least diameter of a leaf. Infinite for a half-space. Arms of a body may be thinner.
template <int Dim>
[[nodiscard]] double thickness(const SphereTree<Dim>& tree);

/// How far any point of a body moves in h seconds at most [m].
template <int Dim>
[[nodiscard]] double reach_of_motion(const Body<Dim>& body, double h);

/// Moves bodies freely for a time step, as integrate() does, but stops those that would pass
/// through others: bodies that move further than their thickness are swept against all others,
/// first as the balls that hold them, then by their trees at instants no further apart than half a
/// thickness of motion, or by their true shapes. Impacts are answered one after the other in the
/// order of time, each by its two bodies alone, which then go on.
///
/// Where a body is fast, a tree holds the boxes of all bodies' ways through the step, and each fast
/// body is compared with those alone whose ways come near its own: n log n for n bodies, as much
/// again for each pair of ways that come near, and log n an impact and a pair that it may bring
/// about. What an impact does not move keeps the impacts that it was going to have.
///
/// Bodies that overlap meet where they approach. A body
/// with more than most_impacts in a frame stays where it has one more, and others meet it there.
template <int Dim>
class Sweeper {
  public:
    /// How an impact between two frames is answered.
    struct Model {
        ContactModel contact_model = ContactModel::hull;
        PointModel point_model = PointModel::radius_ratio;
        Response response = Response::net;
    };

    /// Replaces `found`. Without a fast body this is integrate(), to the bit.
    void advance(std::span<Body<Dim>> bodies, double time_step, const SweepSettings& settings,
                 const Model& model, std::vector<SweptImpact<Dim>>& found);

    /// How many boxes the last advance() looked at, and pairs of bodies.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    /// The next impact of two bodies, A's number below B's.
    struct Meeting {
        double time = 0;  ///< since the beginning of the step [s]
        std::int32_t a = 0;
        std::int32_t b = 0;
        std::vector<Contact<Dim>> contacts;
        Body<Dim> body_a;  ///< at that time
        Body<Dim> body_b;
    };
    struct Span {
        double begin = 0;
        double end = 0;
    };

    [[nodiscard]] bool begin(std::span<Body<Dim>> bodies, double time_step);
    [[nodiscard]] Box<Dim> way_of(std::size_t body) const;
    void list_near(std::size_t body);
    void go_on(const Meeting& meeting);
    [[nodiscard]] bool is_fast(std::size_t body) const;
    [[nodiscard]] Body<Dim> at_time(std::size_t body, double time) const;
    [[nodiscard]] bool may_meet(std::size_t a, std::size_t b, Span& span) const;
    [[nodiscard]] bool next_meeting(std::size_t a, std::size_t b, Meeting& meeting);
    [[nodiscard]] bool exact_meeting(const Span& span, Meeting& meeting);
    [[nodiscard]] bool swept_meeting(const Span& span, Meeting& meeting);
    [[nodiscard]] bool meet_between(double free, double met, double step, Meeting& meeting);
    [[nodiscard]] bool may_meet_border(std::size_t body, std::size_t border, Span& span) const;
    /// Whether the trees meet then and approach; fills `front_` and the meeting's bodies.
    [[nodiscard]] bool approach_at(Meeting& pair, double time, double step);
    void find_those_of(std::size_t body);
    void answer(Meeting& meeting, std::vector<SweptImpact<Dim>>& found);
    [[nodiscard]] bool hold(const Meeting& meeting);

    std::span<Body<Dim>> bodies_;
    double time_step_ = 0;
    SweepSettings settings_;
    Model model_;

    std::vector<std::shared_ptr<const SphereTree<Dim>>> measured_;  ///< the trees of thickness_
    std::vector<double> thickness_;
    std::vector<double> now_;  ///< of each body: to when it has moved [s]
    std::vector<int> impacts_of_;
    std::vector<char> held_;  ///< moves no further in this step
    MeetingQueue<Meeting> meetings_;

    BoxTree<Dim> ways_{std::span<const Box<Dim>>()};  ///< of each body's way and those before
    std::vector<Box<Dim>> way_boxes_;
    std::vector<std::size_t> half_spaces_;
    std::vector<std::size_t> near_;
    std::vector<std::uint64_t> sought_in_;  ///< of each body: the last round that sought for it
    std::uint64_t round_ = 0;
    std::uint64_t steps_ = 0;

    PosedTree<Dim> posed_a_;
    PosedTree<Dim> posed_b_;
    FrontList list_;
    FrontContacts<Dim> front_contacts_;
    FrontModel<Dim> front_;
    Resolver<Dim> resolver_;
    std::vector<Impact<Dim>> impacts_;
    std::vector<double> impulses_;
};

extern template class Sweeper<2>;
extern template class Sweeper<3>;

}  // namespace lod
