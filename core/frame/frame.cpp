#include "lodlab/core/frame/frame.hpp"

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/frame/integrate.hpp"

namespace lod {
namespace {

template <int Dim>
void pose_all(std::span<const Body<Dim>> bodies, Executor* executor,
              std::vector<PosedTree<Dim>>& world_S) {
    if (world_S.size() != bodies.size()) world_S.resize(bodies.size());
    each_part(executor, bodies.size(), bodies_of_a_part, [&](const Part& part) {
        const std::size_t count = part.end - part.begin;
        PosedTree<Dim>::pose_all(bodies.subspan(part.begin, count),
                                 std::span(world_S).subspan(part.begin, count));
    });
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
    pose_all(bodies, storage.executor, storage.world_S);
    storage.broad_phase.find(bodies, storage.world_S, storage.candidates, storage.executor);
    const RefineTask<Dim> task{
        bodies,
        storage.candidates,
        storage.world_S,
        {settings.deepest_level, settings.contact_model == ContactModel::hull},
        settings.priority,
        settings.viewer,
        settings.organisation,
        storage.executor};
    const std::uint64_t spent_before = budget.spent();
    storage.scheduler.refine_all(task, budget, storage.fronts);
    storage.true_shapes.clear();
    if (!budget.refused() && settings.finest.level != Finest::leaves)
        storage.true_shapes.refine({bodies, storage.candidates, storage.scheduler.rank(task),
                                    settings.finest, settings.time_step},
                                   budget, storage.fronts);
    storage.record.spending = {
        storage.scheduler.counts(), budget.tests_left(), {}, budget.after_levels()};
    storage.record.turns = storage.scheduler.turns();
    storage.record.tests = budget.spent() - spent_before;
    const auto modelled = storage.contacts.model({bodies,
                                                  storage.candidates,
                                                  storage.world_S,
                                                  storage.fronts,
                                                  storage.true_shapes.found(),
                                                  {settings.contact_model, settings.point_model},
                                                  settings.time_step,
                                                  budget},
                                                 storage.executor, storage.record);
    budget.contacts_done(modelled, {bodies.size(), storage.record.impacts.size(),
                                    storage.scheduler.counts().by_roots});
    storage.record.cut = budget.cut();
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
    storage.resolver.budget = &budget;
    record.response = storage.resolver.resolve(settings.response, record.impacts, bodies,
                                               record.impulses, storage.executor);
    storage.resolver.budget = nullptr;
    budget.response_done();
    record.cut = budget.cut();
    record.energy_after = kinetic_energy<Dim>(bodies);
    catch_up(storage, bodies);
    if (settings.sweep.on)
        storage.sweeper.advance(bodies, settings.time_step, settings.sweep,
                                {settings.contact_model, settings.point_model, settings.response},
                                record.swept);
    else
        each_part(storage.executor, bodies.size(), bodies_of_a_part, [&](const Part& part) {
            integrate(bodies.subspan(part.begin, part.end - part.begin), settings.time_step);
        });
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
