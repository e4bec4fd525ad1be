#include "lodlab/core/frame/contact_stage.hpp"

#include <algorithm>

#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

/// Numbers of things in lists.
constexpr std::int32_t as_number(std::size_t i) {
    return static_cast<std::int32_t>(i);
}

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
void ContactStage<Dim>::model(const ContactTask<Dim>& task, Executor* executor,
                              FrameRecord<Dim>& record) {
    workers_.resize(workers_of(executor));
    record.pairs.resize(task.pairs.size());
    if (parts_of(executor, task.pairs.size(), pairs_of_a_part) > 1)
        return model_in_parts(task, *executor, record);
    const Lists all{record.node_pairs, record.impacts, record.contact_nodes};
    all.clear();
    model_pairs(task, {0, task.pairs.size()}, workers_.front(), all, record.pairs);
}

/// Appends the contacts of some pairs.
template <int Dim>
void ContactStage<Dim>::model_pairs(const ContactTask<Dim>& task, const Part& part, Worker& worker,
                                    const Lists& lists, std::vector<PairRecord>& pairs) {
    auto finest = std::lower_bound(
        task.true_shapes.begin(), task.true_shapes.end(), as_number(part.begin),
        [](const FinestPair<Dim>& pair, std::int32_t first) { return pair.pair < first; });
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
        if (finest != task.true_shapes.end() && finest->pair == as_number(p))
            take_exact(*finest++, lists, result);
        else if (front.pairs.count > 0)
            model_front(task, p, worker, lists, result);
        result.contact_count = as_number(lists.impacts.size()) - result.first_contact;
    }
}

/// The contacts of a pair, from its front at the last finished level.
template <int Dim>
void ContactStage<Dim>::model_front(const ContactTask<Dim>& task, std::size_t pair, Worker& worker,
                                    const Lists& lists, PairRecord& result) {
    const std::size_t a = at(result.bodies.a);
    const std::size_t b = at(result.bodies.b);
    worker.front_contacts.model(
        {task.world_S[a], task.world_S[b], task.fronts.pairs(pair)}, task.choice,
        pair_motion(task.bodies[a], task.bodies[b], task.time_step), worker.front);
    for (const auto& [contact, nodes] : worker.front.contacts) {
        lists.impacts.push_back({result.bodies.a, result.bodies.b, as_number(pair), contact});
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
    each_part(&executor, count, pairs_of_a_part, [&](const Part& part) {
        Worker& worker = workers_[part.worker];
        Modelled& done = parts_[part.number];
        done.worker = part.worker;
        done.first_node_pair = worker.node_pairs.size();
        done.first_impact = worker.impacts.size();
        model_pairs(task, part, worker, worker.lists(), record.pairs);
        done.node_pairs = worker.node_pairs.size() - done.first_node_pair;
        done.impacts = worker.impacts.size() - done.first_impact;
    });
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
