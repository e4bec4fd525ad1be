#include "lodlab/core/frame.hpp"

#include "lodlab/core/integrate.hpp"

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
    const Vector<Dim> between =
        bodies[static_cast<std::size_t>(b)].position - bodies[static_cast<std::size_t>(a)].position;
    storage.front_contacts.model(storage.world_S[static_cast<std::size_t>(a)],
                                 storage.world_S[static_cast<std::size_t>(b)],
                                 storage.fronts[p].pairs, settings.contact_model,
                                 settings.point_model, between, storage.contacts);
    for (const auto& [nodes, contact] : storage.contacts) {
        storage.record.node_pairs.push_back(nodes);
        storage.record.impacts.push_back({a, b, static_cast<std::int32_t>(p), contact});
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
    auto finest = storage.finest.begin();
    for (std::size_t p = 0; p < storage.candidates.size(); ++p) {
        const CandidatePair pair = storage.candidates[p];
        const Front& front = storage.fronts[p];
        const auto number = static_cast<std::int32_t>(p);
        const auto first = static_cast<std::int32_t>(record.impacts.size());
        record.pairs.push_back({pair, front.level, front.verdict, front.tests, first});
        PairRecord& result = record.pairs.back();
        if (finest != storage.finest.end() && finest->pair == number) {
            result.finest = finest->backtracked ? Finest::backtrack : Finest::exact;
            result.impact_time = finest->touch.time;
            for (const Contact<Dim>& contact : finest->contacts) {
                record.node_pairs.push_back({-1, -1});
                record.impacts.push_back({pair.a, pair.b, number, contact});
            }
            ++finest;
        } else {
            model_front(bodies, settings, p, storage);
        }
        result.contact_count = static_cast<std::int32_t>(record.impacts.size()) - first;
    }
}

/// Puts the bodies of backtracked pairs where they stood at their time of impact.
template <int Dim>
void rewind(const FrameStorage<Dim>& storage, std::span<Body<Dim>> bodies) {
    for (const FinestPair<Dim>& pair : storage.finest) {
        if (!pair.backtracked) continue;
        const auto [a, b] = storage.candidates[static_cast<std::size_t>(pair.pair)];
        bodies[static_cast<std::size_t>(a)] = pair.touch.a;
        bodies[static_cast<std::size_t>(b)] = pair.touch.b;
    }
}

/// And lets them move on from there to the present.
template <int Dim>
void catch_up(const FrameStorage<Dim>& storage, std::span<Body<Dim>> bodies) {
    for (const FinestPair<Dim>& pair : storage.finest) {
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
    prioritise<Dim>(settings.priority, bodies, storage.candidates, storage.order, storage.scratch);
    const std::uint64_t spent_before = budget.spent();
    storage.record.interrupted =
        refine_all<Dim>(storage.candidates, storage.order, settings.deepest_level, storage.world_S,
                        budget, storage.fronts, storage.scratch);
    storage.finest.clear();
    if (!storage.record.interrupted)
        storage.record.interrupted =
            refine_finest<Dim>(bodies, storage.candidates, storage.order, settings.finest,
                               settings.time_step, budget, storage.fronts, storage.finest);
    storage.record.tests = budget.spent() - spent_before;
    model_contacts(bodies, settings, storage);
    storage.record.impulses.assign(storage.record.impacts.size(), 0.0);
    storage.record.energy_before = kinetic_energy(bodies);
    storage.record.energy_after = storage.record.energy_before;
    return storage.record;
}

template <int Dim>
const FrameRecord<Dim>& advance(std::span<Body<Dim>> bodies, const FrameSettings& settings,
                                Budget& budget, FrameStorage<Dim>& storage) {
    FrameRecord<Dim>& record = storage.record;
    detect<Dim>(bodies, settings, budget, storage);
    rewind(storage, bodies);
    storage.resolver.resolve(settings.response, record.impacts, bodies, record.impulses);
    record.energy_after = kinetic_energy<Dim>(bodies);
    catch_up(storage, bodies);
    integrate(bodies, settings.time_step);
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
