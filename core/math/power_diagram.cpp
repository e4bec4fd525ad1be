#include "lodlab/core/math/power_diagram.hpp"

namespace lod {
namespace {

/// |x - c|^2 - r^2 <= |x - c'|^2 - r'^2, with the squares of x gone.
template <int Dim>
HalfSpace<Dim> closer_to(const Sphere<Dim>& own, const Sphere<Dim>& other, bool keeps_border) {
    HalfSpace<Dim> side;
    side.normal = 2 * (other.centre - own.centre);
    side.offset = (other.centre - own.centre).dot(other.centre + own.centre) -
                  (other.radius - own.radius) * (other.radius + own.radius);
    side.keeps_border = keeps_border;
    const bool same_ball = side.normal.isZero(0) && side.offset == 0;
    if (same_ball && !keeps_border) side.offset = -1;
    return side;
}

}  // namespace

template <int Dim>
std::vector<HalfSpace<Dim>> power_cell(std::span<const Sphere<Dim>> balls, std::size_t own) {
    std::vector<HalfSpace<Dim>> cell;
    cell.reserve(balls.size());
    for (std::size_t other = 0; other < balls.size(); ++other)
        if (other != own) cell.push_back(closer_to<Dim>(balls[own], balls[other], own < other));
    return cell;
}

template std::vector<HalfSpace<2>> power_cell(std::span<const Sphere<2>>, std::size_t);
template std::vector<HalfSpace<3>> power_cell(std::span<const Sphere<3>>, std::size_t);

}  // namespace lod
