#pragma once

/// \file
/// The stage of a frame that makes contacts of every pair's front.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/contact/front_contacts.hpp"
#include "lodlab/core/frame/frame_record.hpp"

namespace lod {

/// What a frame makes contacts of.
template <int Dim>
struct ContactTask {
    std::span<const Body<Dim>> bodies;
    std::span<const CandidatePair> pairs;
    std::span<const PosedTree<Dim>> world_S;
    const Fronts& fronts;
    std::span<const FinestPair<Dim>> true_shapes;  ///< in the order of the pairs
    ContactChoice choice;
    double time_step = 0;  ///< [s], > 0
    const Budget& budget;  ///< whose clock may be over before all is modelled
};

/// Models the contacts of every candidate pair, from its front or from its true shapes. Parts of
/// the pairs are done by an executor's threads and put together in the order of the pairs, so that
/// the lists are the same however many there are.
///
/// Where a budget's clock is over, the contacts of the pairs that are left are those of their root
/// balls at level 0, whichever level their fronts had reached, and so are those of pairs that were
/// not taken to their entry levels (ListedFront::by_roots). It is looked at once in eight pairs.
///
/// Keeps its storage: a warm call allocates nothing where the executor does not.
template <int Dim>
class ContactStage {
  public:
    /// Replaces pairs, node_pairs, impacts and contact_nodes of the record. Returns from which pair
    /// on contacts were those of root balls; nothing where the budget ended none.
    std::optional<std::uint64_t> model(const ContactTask<Dim>& task, Executor* executor,
                                       FrameRecord<Dim>& record);

  private:
    /// Lists of a record, or of a part of it.
    struct Lists {
        std::vector<NodePair>& node_pairs;
        std::vector<Impact<Dim>>& impacts;
        std::vector<Range>& contact_nodes;
        void clear() const;
    };
    /// What one thread needs of its own.
    struct Worker {
        FrontContacts<Dim> front_contacts;
        FrontModel<Dim> front;  ///< of one pair
        std::vector<NodePair> node_pairs;
        std::vector<Impact<Dim>> impacts;
        std::vector<Range> contact_nodes;
        [[nodiscard]] Lists lists() { return {node_pairs, impacts, contact_nodes}; }
    };
    /// Where the contacts of a part of the pairs lie in its worker's lists, and where they go.
    struct Modelled {
        std::size_t worker = 0;
        std::size_t first_node_pair = 0;
        std::size_t node_pairs = 0;
        std::size_t first_impact = 0;
        std::size_t impacts = 0;
        std::size_t node_pairs_before = 0;  ///< of the parts before
        std::size_t impacts_before = 0;
        std::size_t modelled = 0;  ///< the first pair that touches by its roots, or the end
    };

    /// A pair and the nodes of it that overlap.
    struct Touching {
        std::size_t pair = 0;
        std::span<const NodePair> nodes;
    };

    std::size_t model_pairs(const ContactTask<Dim>& task, const Part& part, const Lists& lists,
                            std::vector<PairRecord>& pairs);
    [[nodiscard]] bool is_late(const ContactTask<Dim>& task, std::size_t pair,
                               std::size_t contacts) const;
    static void touch_roots(const ContactTask<Dim>& task, std::size_t pair, Worker& worker,
                            const Lists& lists, PairRecord& result);
    static void model_front(const ContactTask<Dim>& task, const Touching& touching, Worker& worker,
                            const Lists& lists, PairRecord& result);
    static void take_exact(const FinestPair<Dim>& finest, const Lists& lists, PairRecord& result);
    void model_in_parts(const ContactTask<Dim>& task, Executor& executor, FrameRecord<Dim>& record);
    void model_part(const ContactTask<Dim>& task, const Part& part, FrameRecord<Dim>& record);
    void put_together(Executor& executor, std::size_t count, FrameRecord<Dim>& record);
    void put_in_place(const Modelled& part, std::span<PairRecord> pairs,
                      FrameRecord<Dim>& record) const;

    std::vector<Worker> workers_;
    std::vector<Modelled> parts_;
    std::size_t end_ = 0;  ///< pairs from there on touch by their roots
};

extern template class ContactStage<2>;
extern template class ContactStage<3>;

}  // namespace lod
