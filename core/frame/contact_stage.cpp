#include "lodlab/core/frame/contact_stage.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// Numbers of things in lists.
constexpr std::int32_t as_number(std::size_t i) {
    return static_cast<std::int32_t>(i);
}

constexpr NodePair roots;
constexpr std::size_t pairs_unlooked = 8;  ///< between two looks at the clock

/// Copies a part of one list into another.
template <class T>
void copy_part(const std::vector<T>& from, std::size_t first, std::size_t count, std::vector<T>& to,
               std::size_t place) {
    const std::span<const T> part = std::span<const T>(from).subspan(first, count);
    std::copy(part.begin(), part.end(), to.begin() + static_cast<std::ptrdiff_t>(place));
}

}  // namespace

template <int Dim>
void ContactStage<Dim>::Lists::clear() const {
    node_pairs.clear();
    impacts.clear();
    contact_nodes.clear();
}

template <int Dim>
std::optional<std::uint64_t> ContactStage<Dim>::model(const ContactTask<Dim>& task,
                                                      Executor* executor,
                                                      FrameRecord<Dim>& record) {
    workers_.resize(workers_of(executor));
    record.pairs.resize(task.pairs.size());
    end_ = static_cast<std::size_t>(
        std::min<std::uint64_t>(task.budget.most_modelled(), task.pairs.size()));
    if (parts_of(executor, task.pairs.size(), pairs_of_a_part) > 1) {
        model_in_parts(task, *executor, record);
    } else {
        const Lists all{record.node_pairs, record.impacts, record.contact_nodes};
        all.clear();
        end_ = model_pairs(task, {0, task.pairs.size()}, all, record.pairs);
    }
    return end_ < task.pairs.size() ? std::optional<std::uint64_t>(end_) : std::nullopt;
}

/// Appends the contacts of some pairs. Returns the first that is left to its roots, or the last
/// one's successor.
template <int Dim>
std::size_t ContactStage<Dim>::model_pairs(const ContactTask<Dim>& task, const Part& part,
                                           const Lists& lists, std::vector<PairRecord>& pairs) {
    Worker& worker = workers_[part.worker];
    auto finest = std::lower_bound(
        task.true_shapes.begin(), task.true_shapes.end(), as_number(part.begin),
        [](const FinestPair<Dim>& pair, std::int32_t first) { return pair.pair < first; });
    std::size_t end = std::clamp(end_, part.begin, part.end);
    const bool looks = end_ == task.pairs.size() && task.budget.governs_contacts();
    std::size_t modelled = 0;
    for (std::size_t p = part.begin; p < part.end; ++p) {
        const ListedFront& front = task.fronts.of_pair[p];
        PairRecord& result = pairs[p];
        result = {};
        result.bodies = task.pairs[p];
        result.level = front.level;
        result.verdict = front.verdict;
        result.tests = front.tests;
        result.first_contact = as_number(lists.impacts.size());
        result.nodes.first = as_number(lists.node_pairs.size());
        if (finest != task.true_shapes.end() && finest->pair == as_number(p)) {
            take_exact(*finest++, lists, result);
        } else if (front.pairs.count > 0) {
            const bool may = !front.by_roots && p < end;
            if (may && looks && modelled++ % pairs_unlooked == 0 &&
                is_late(task, p, lists.impacts.size()))
                end = p;
            if (may && p < end)
                model_front(task, {p, task.fronts.pairs(p)}, worker, lists, result);
            else
                touch_roots(task, p, worker, lists, result);
        }
        result.contact_count = as_number(lists.impacts.size()) - result.first_contact;
    }
    return end;
}

/// Whether the clock leaves time only for the rest to touch by their roots.
template <int Dim>
bool ContactStage<Dim>::is_late(const ContactTask<Dim>& task, std::size_t pair,
                                std::size_t contacts) const {
    const std::size_t rest = task.pairs.size() - pair;
    return task.budget.is_late({task.bodies.size(), contacts * workers_.size(),
                                task.fronts.meeting * rest / task.pairs.size()});
}

/// The contact of a pair at level 0, whichever level its front has reached.
template <int Dim>
void ContactStage<Dim>::touch_roots(const ContactTask<Dim>& task, std::size_t pair, Worker& worker,
                                    const Lists& lists, PairRecord& result) {
    if (result.level > 0) result.verdict = Verdict::possible;
    result.level = 0;
    const PosedTree<Dim>& a = task.world_S[at(result.bodies.a)];
    const PosedTree<Dim>& b = task.world_S[at(result.bodies.b)];
    if (!touches_by_hulls(task.choice, a.tree(), b.tree()))
        return model_front(task, {pair, {&roots, 1}}, worker, lists, result);
    if (const auto contact = root_contact(a, b)) {
        lists.impacts.push_back({result.bodies.a, result.bodies.b, as_number(pair), *contact});
        lists.contact_nodes.push_back({result.nodes.first, 1});
    }
    lists.node_pairs.push_back(roots);
    result.nodes.count = 1;
}

/// The contacts of a pair from its nodes that overlap.
template <int Dim>
void ContactStage<Dim>::model_front(const ContactTask<Dim>& task, const Touching& touching,
                                    Worker& worker, const Lists& lists, PairRecord& result) {
    const std::size_t a = at(result.bodies.a);
    const std::size_t b = at(result.bodies.b);
    worker.front_contacts.model({task.world_S[a], task.world_S[b], touching.nodes}, task.choice,
                                pair_motion(task.bodies[a], task.bodies[b], task.time_step),
                                worker.front);
    for (const auto& [contact, nodes] : worker.front.contacts) {
        lists.impacts.push_back(
            {result.bodies.a, result.bodies.b, as_number(touching.pair), contact});
        lists.contact_nodes.push_back({result.nodes.first + nodes.first, nodes.count});
    }
    const std::vector<NodePair>& node_pairs = worker.front.node_pairs;
    result.nodes.count = as_number(node_pairs.size());
    lists.node_pairs.insert(lists.node_pairs.end(), node_pairs.begin(), node_pairs.end());
    if (result.nodes.count == 0) result.verdict = Verdict::apart;
}

/// The contacts of a pair whose true shapes were asked.
template <int Dim>
void ContactStage<Dim>::take_exact(const FinestPair<Dim>& finest, const Lists& lists,
                                   PairRecord& result) {
    result.finest = finest.backtracked ? Finest::backtrack : Finest::exact;
    result.impact_time = finest.touch.time;
    for (const Contact<Dim>& contact : finest.contacts) {
        lists.impacts.push_back({result.bodies.a, result.bodies.b, finest.pair, contact});
        lists.contact_nodes.push_back({result.nodes.first, 0});
    }
}

template <int Dim>
void ContactStage<Dim>::model_in_parts(const ContactTask<Dim>& task, Executor& executor,
                                       FrameRecord<Dim>& record) {
    const std::size_t count = task.pairs.size();
    parts_.resize(parts_of(&executor, count, pairs_of_a_part));
    for (Worker& worker : workers_) worker.lists().clear();
    each_part(&executor, count, pairs_of_a_part,
              [&](const Part& part) { model_part(task, part, record); });
    // The first pair at which a thread found the clock over; what others modelled behind it goes.
    for (std::size_t i = 0; i < parts_.size(); ++i)
        if (parts_[i].modelled < std::min(count, (i + 1) * pairs_of_a_part))
            end_ = std::min(end_, parts_[i].modelled);
    if (end_ < count)
        each_part(&executor, count, pairs_of_a_part, [&](const Part& part) {
            if (parts_[part.number].modelled > std::max(end_, part.begin))
                model_part(task, part, record);
        });
    put_together(executor, count, record);
}

template <int Dim>
void ContactStage<Dim>::model_part(const ContactTask<Dim>& task, const Part& part,
                                   FrameRecord<Dim>& record) {
    Worker& worker = workers_[part.worker];
    Modelled& done = parts_[part.number];
    done.worker = part.worker;
    done.first_node_pair = worker.node_pairs.size();
    done.first_impact = worker.impacts.size();
    done.modelled = model_pairs(task, part, worker.lists(), record.pairs);
    done.node_pairs = worker.node_pairs.size() - done.first_node_pair;
    done.impacts = worker.impacts.size() - done.first_impact;
}

template <int Dim>
void ContactStage<Dim>::put_together(Executor& executor, std::size_t count,
                                     FrameRecord<Dim>& record) {
    std::size_t node_pairs = 0;
    std::size_t impacts = 0;
    for (Modelled& part : parts_) {
        part.node_pairs_before = node_pairs;
        part.impacts_before = impacts;
        node_pairs += part.node_pairs;
        impacts += part.impacts;
    }
    record.node_pairs.resize(node_pairs);
    record.impacts.resize(impacts);
    record.contact_nodes.resize(impacts);
    each_part(&executor, count, pairs_of_a_part, [&](const Part& part) {
        const std::span<PairRecord> pairs(record.pairs);
        put_in_place(parts_[part.number], pairs.subspan(part.begin, part.end - part.begin), record);
    });
}

/// Puts what a worker has found of some pairs behind what was found of those before.
template <int Dim>
void ContactStage<Dim>::put_in_place(const Modelled& part, std::span<PairRecord> pairs,
                                     FrameRecord<Dim>& record) const {
    const Worker& worker = workers_[part.worker];
    copy_part(worker.node_pairs, part.first_node_pair, part.node_pairs, record.node_pairs,
              part.node_pairs_before);
    copy_part(worker.impacts, part.first_impact, part.impacts, record.impacts, part.impacts_before);
    copy_part(worker.contact_nodes, part.first_impact, part.impacts, record.contact_nodes,
              part.impacts_before);
    const std::int32_t nodes = as_number(part.node_pairs_before) - as_number(part.first_node_pair);
    const std::int32_t contacts = as_number(part.impacts_before) - as_number(part.first_impact);
    for (PairRecord& pair : pairs) {
        pair.nodes.first += nodes;
        pair.first_contact += contacts;
    }
    const std::span<Range> moved(record.contact_nodes);
    for (Range& range : moved.subspan(part.impacts_before, part.impacts)) range.first += nodes;
}

template class ContactStage<2>;
template class ContactStage<3>;

}  // namespace lod
