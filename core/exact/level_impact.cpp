#include "lodlab/core/exact/level_impact.hpp"

#include "lodlab/core/exact/ball_union.hpp"

namespace lod {

template <int Dim>
TimeOfImpact<Dim> level_impact(const Body<Dim>& a, const Body<Dim>& b, int level,
                               const ImpactSettings& settings) {
    const auto coarse = [&](Body<Dim> body) {
        body.exact = std::make_shared<BallUnion<Dim>>(*body.tree, level);
        return body;
    };
    auto touch = time_of_impact(coarse(a), coarse(b), settings);
    touch.a.exact = a.exact;
    touch.b.exact = b.exact;
    return touch;
}

template <int Dim>
NearestApproach<Dim> nearest_approach(const Body<Dim>& a, const Body<Dim>& b,
                                      const ImpactSettings& settings, int looks) {
    NearestApproach<Dim> nearest{0, a, b, separation(a, b)};
    const double step = settings.horizon / (looks - 1);
    Body<Dim> now_a = a;
    Body<Dim> now_b = b;
    for (int look = 1; look < looks; ++look) {
        now_a = moved_freely(now_a, step, settings.longest_turn);
        now_b = moved_freely(now_b, step, settings.longest_turn);
        const Separation<Dim> gap = separation(now_a, now_b);
        if (gap.distance < nearest.gap.distance) nearest = {look * step, now_a, now_b, gap};
    }
    return nearest;
}

#define LOD_INSTANTIATE(Dim)                                                           \
    template TimeOfImpact<Dim> level_impact(const Body<Dim>&, const Body<Dim>&, int,   \
                                            const ImpactSettings&);                    \
    template NearestApproach<Dim> nearest_approach(const Body<Dim>&, const Body<Dim>&, \
                                                   const ImpactSettings&, int);
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
