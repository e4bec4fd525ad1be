#include "core/frame.hpp"

#include "core/integrate.hpp"

namespace lod {
namespace {

template <int Dim>
void pose_all(std::span<const Body<Dim>> bodies, std::vector<PosedTree<Dim>>& world_S) {
    if (world_S.size() != bodies.size()) world_S.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) world_S[i].pose(bodies[i]);
}

/// The contacts of every pair, from its front at the last finished level.
template <int Dim>
void model_contacts(std::span<const Body<Dim>> bodies, const FrameSettings& settings,
                    FrameStorage<Dim>& storage) {
    FrameRecord<Dim>& record = storage.record;
    record.pairs.clear();
    record.node_pairs.clear();
    record.impacts.clear();
    for (std::size_t p = 0; p < storage.candidates.size(); ++p) {
        const auto [a, b] = storage.candidates[p];
        const Front& front = storage.fronts[p];
        const auto first = static_cast<std::int32_t>(record.impacts.size());
        const auto& world_a = storage.world_S[static_cast<std::size_t>(a)];
        const auto& world_b = storage.world_S[static_cast<std::size_t>(b)];
        const Vector<Dim> between = bodies[static_cast<std::size_t>(b)].position -
                                    bodies[static_cast<std::size_t>(a)].position;
        storage.front_contacts.model(world_a, world_b, front.pairs, settings.contact_model,
                                     settings.point_model, between, storage.contacts);
        for (const auto& [nodes, contact] : storage.contacts) {
            record.node_pairs.push_back(nodes);
            record.impacts.push_back({a, b, static_cast<std::int32_t>(p), contact});
        }
        const auto count = static_cast<std::int32_t>(record.impacts.size()) - first;
        record.pairs.push_back({{a, b}, front.level, front.verdict, front.tests, first, count});
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
    storage.resolver.resolve(settings.response, record.impacts, bodies, record.impulses);
    record.energy_after = kinetic_energy<Dim>(bodies);
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
