#include "lodlab/core/frame/frame.hpp"

#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/frame/integrate.hpp"

namespace lod {
namespace {

template <int Dim>
void pose_all(std::span<const Body<Dim>> bodies, std::vector<PosedTree<Dim>>& world_S) {
    if (world_S.size() != bodies.size()) world_S.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) world_S[i].pose(bodies[i]);
}

/// The contacts of a pair, from its front at the last finished level.
template <int Dim>
void model_front(std::span<const Body<Dim>> bodies, const FrameSettings& settings, std::size_t p,
                 FrameStorage<Dim>& storage) {
    const auto [a, b] = storage.candidates[p];
    const auto at_a = static_cast<std::size_t>(a);
    const auto at_b = static_cast<std::size_t>(b);
    storage.front_contacts.model(
        {storage.world_S[at_a], storage.world_S[at_b], storage.fronts.pairs(p)},
        {settings.contact_model, settings.point_model},
        pair_motion(bodies[at_a], bodies[at_b], settings.time_step), storage.front);
    FrameRecord<Dim>& record = storage.record;
    PairRecord& result = record.pairs[p];
    for (const auto& [contact, nodes] : storage.front.contacts) {
        record.impacts.push_back({a, b, static_cast<std::int32_t>(p), contact});
        record.contact_nodes.push_back({result.nodes.first + nodes.first, nodes.count});
    }
    result.nodes.count = static_cast<std::int32_t>(storage.front.node_pairs.size());
    record.node_pairs.insert(record.node_pairs.end(), storage.front.node_pairs.begin(),
                             storage.front.node_pairs.end());
    if (result.nodes.count == 0) result.verdict = Verdict::apart;
}

/// The contacts of a pair whose true shapes were asked.
template <int Dim>
void take_exact(const FinestPair<Dim>& finest, FrameRecord<Dim>& record) {
    PairRecord& result = record.pairs[static_cast<std::size_t>(finest.pair)];
    result.finest = finest.backtracked ? Finest::backtrack : Finest::exact;
    result.impact_time = finest.touch.time;
    for (const Contact<Dim>& contact : finest.contacts) {
        record.impacts.push_back({result.bodies.a, result.bodies.b, finest.pair, contact});
        record.contact_nodes.push_back({result.nodes.first, 0});
    }
}

/// The contacts of every pair.
template <int Dim>
void model_contacts(std::span<const Body<Dim>> bodies, const FrameSettings& settings,
                    FrameStorage<Dim>& storage) {
    FrameRecord<Dim>& record = storage.record;
    record.pairs.clear();
    record.node_pairs.clear();
    record.impacts.clear();
    record.contact_nodes.clear();
    const std::vector<FinestPair<Dim>>& true_shapes = storage.true_shapes.found();
    auto finest = true_shapes.begin();
    for (std::size_t p = 0; p < storage.candidates.size(); ++p) {
        const ListedFront& front = storage.fronts.of_pair[p];
        const auto first = static_cast<std::int32_t>(record.impacts.size());
        const auto first_node = static_cast<std::int32_t>(record.node_pairs.size());
        record.pairs.push_back({storage.candidates[p],
                                front.level,
                                front.verdict,
                                front.tests,
                                first,
                                0,
                                {first_node, 0}});
        if (finest != true_shapes.end() && finest->pair == static_cast<std::int32_t>(p))
            take_exact(*finest++, record);
        else
            model_front(bodies, settings, p, storage);
        record.pairs[p].contact_count = static_cast<std::int32_t>(record.impacts.size()) - first;
    }
}

/// A bound by the fronts and the true shapes' contacts alone, as Budget reserves it.
template <int Dim>
std::uint64_t reserved_row_visits(const FrameStorage<Dim>& storage) {
    std::uint64_t node_pairs = 0;
    for (const ListedFront& front : storage.fronts.of_pair)
        node_pairs += static_cast<std::uint64_t>(front.pairs.count);
    for (const FinestPair<Dim>& pair : storage.true_shapes.found())
        node_pairs += pair.contacts.size();
    return node_pairs * Resolver<Dim>::row_visits_of_a_node_pair;
}

/// Puts the bodies of backtracked pairs where they stood at their time of impact.
template <int Dim>
void rewind(const FrameStorage<Dim>& storage, std::span<Body<Dim>> bodies) {
    for (const FinestPair<Dim>& pair : storage.true_shapes.found()) {
        if (!pair.backtracked) continue;
        const auto [a, b] = storage.candidates[static_cast<std::size_t>(pair.pair)];
        bodies[static_cast<std::size_t>(a)] = pair.touch.a;
        bodies[static_cast<std::size_t>(b)] = pair.touch.b;
    }
}

/// And lets them move on from there to the present.
template <int Dim>
void catch_up(const FrameStorage<Dim>& storage, std::span<Body<Dim>> bodies) {
    for (const FinestPair<Dim>& pair : storage.true_shapes.found()) {
        if (!pair.backtracked) continue;
        const auto [a, b] = storage.candidates[static_cast<std::size_t>(pair.pair)];
        for (const std::int32_t body : {a, b})
            integrate(bodies.subspan(static_cast<std::size_t>(body), 1), -pair.touch.time);
    }
}

}  // namespace

template <int Dim>
const FrameRecord<Dim>& detect(std::span<const Body<Dim>> bodies, const FrameSettings& settings,
                               Budget& budget, FrameStorage<Dim>& storage) {
    pose_all(bodies, storage.world_S);
    storage.broad_phase.find(bodies, storage.world_S, storage.candidates);
    const RefineTask<Dim> task{
        bodies,
        storage.candidates,
        storage.world_S,
        {settings.deepest_level, settings.contact_model == ContactModel::hull},
        settings.priority,
        settings.viewer,
        settings.organisation};
    const std::uint64_t spent_before = budget.spent();
    storage.scheduler.refine_all(task, budget, storage.fronts);
    storage.true_shapes.clear();
    if (!budget.refused() && settings.finest.level != Finest::leaves)
        storage.true_shapes.refine({bodies, storage.candidates, storage.scheduler.rank(task),
                                    settings.finest, settings.time_step},
                                   budget, storage.fronts);
    storage.record.spending = {storage.scheduler.counts(), budget.tests_left(), {}};
    storage.record.cut = budget.cut();
    storage.record.tests = budget.spent() - spent_before;
    model_contacts(bodies, settings, storage);
    refill(storage.record.impulses, storage.record.impacts.size(), 0.0);
    storage.record.reserved_row_visits = reserved_row_visits(storage);
    storage.record.response = {};
    storage.record.swept.clear();
    storage.record.energy_before = kinetic_energy(bodies);
    storage.record.energy_after = storage.record.energy_before;
    storage.record.spending.time_left = budget.time_left();
    return storage.record;
}

template <int Dim>
const FrameRecord<Dim>& advance(std::span<Body<Dim>> bodies, const FrameSettings& settings,
                                Budget& budget, FrameStorage<Dim>& storage) {
    FrameRecord<Dim>& record = storage.record;
    detect<Dim>(bodies, settings, budget, storage);
    rewind(storage, bodies);
    record.response =
        storage.resolver.resolve(settings.response, record.impacts, bodies, record.impulses);
    record.energy_after = kinetic_energy<Dim>(bodies);
    catch_up(storage, bodies);
    if (settings.sweep.on)
        storage.sweeper.advance(bodies, settings.time_step, settings.sweep,
                                {settings.contact_model, settings.point_model, settings.response},
                                record.swept);
    else
        integrate(bodies, settings.time_step);
    record.spending.time_left = budget.time_left();
    storage.scheduler.learn(budget);
    return record;
}

#define LOD_INSTANTIATE(Dim)                                                                      \
    template const FrameRecord<Dim>& detect(std::span<const Body<Dim>>, const FrameSettings&,     \
                                            Budget&, FrameStorage<Dim>&);                         \
    template const FrameRecord<Dim>& advance(std::span<Body<Dim>>, const FrameSettings&, Budget&, \
                                             FrameStorage<Dim>&);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
