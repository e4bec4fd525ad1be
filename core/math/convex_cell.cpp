#include "lodlab/core/math/convex_cell.hpp"

#include <algorithm>
#include <cmath>

#include "lodlab/core/math/polygon.hpp"

namespace lod {

template <int Dim>
std::size_t clip_facet(std::span<const Vector<Dim>> facet, const HalfSpace<Dim>& side,
                       std::vector<Vector<Dim>>& out) {
    const std::size_t before = out.size();
    clip_corners<Dim>(
        facet, Space<Dim>::facets_close, [&](const Vector<Dim>& p) { return side.side(p); },
        [&](const Vector<Dim>& p) { out.push_back(p); });
    if (out.size() - before < static_cast<std::size_t>(Dim)) out.resize(before);
    return out.size() - before;
}

template <int Dim>
ConvexCell<Dim>::ConvexCell(const Box<Dim>& box) : box_(box) {
    for (int axis = 0; axis < Dim; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            Face face;
            face.side.normal = sign * Vector<Dim>::Unit(axis);
            face.side.offset = sign > 0 ? box.high[axis] : -box.low[axis];
            // Around the face: each other axis from low to high, then back again.
            Vector<Dim> corner = box.low;
            corner[axis] = sign > 0 ? box.high[axis] : box.low[axis];
            face.corners.push_back(corner);
            for (const bool up : {true, false})
                for (int other = 1; other < Dim; ++other) {
                    const int u = (axis + other) % Dim;
                    corner[u] = up ? box.high[u] : box.low[u];
                    face.corners.push_back(corner);
                }
            face.corners.pop_back();
            faces_.push_back(face);
        }
}

template <int Dim>
std::vector<Vector<Dim>> ConvexCell<Dim>::section(const HalfSpace<Dim>& side) const {
    const Vector<Dim> middle = 0.5 * (box_.low + box_.high);
    const Vector<Dim> normal = side.normal.stableNormalized();
    const double reach = 2 * (box_.high - box_.low).norm();
    const Vector<Dim> foot = middle - (side.side(middle) / side.normal.norm()) * normal;
    const auto patch = Space<Dim>::patch(foot, normal, reach);
    std::vector<Vector<Dim>> facet(patch.begin(), patch.end());
    std::vector<Vector<Dim>> clipped;
    for (const Face& face : faces_) {
        clipped.clear();
        clip_facet<Dim>(facet, face.side, clipped);
        facet.swap(clipped);
        if (facet.empty()) break;
    }
    return facet;
}

template <int Dim>
void ConvexCell<Dim>::clip(const HalfSpace<Dim>& side) {
    bool some_outside = false;
    bool some_inside = false;
    for (const Face& face : faces_)
        for (const Vector<Dim>& p : face.corners)
            (side.side(p) > 0 ? some_outside : some_inside) = true;
    if (!some_outside) return;
    if (!some_inside) return faces_.clear();
    Face fresh{side, section(side)};
    std::vector<Vector<Dim>> clipped;
    std::size_t kept = 0;
    for (Face& face : faces_) {
        clipped.clear();
        if (clip_facet<Dim>(face.corners, side, clipped) == 0) continue;
        face.corners.assign(clipped.begin(), clipped.end());
        if (&faces_[kept] != &face) faces_[kept] = std::move(face);
        ++kept;
    }
    faces_.resize(kept);
    if (!fresh.corners.empty()) faces_.push_back(std::move(fresh));
}

template <int Dim>
bool ConvexCell<Dim>::holds(const Vector<Dim>& p) const {
    return !faces_.empty() && std::all_of(faces_.begin(), faces_.end(),
                                          [&](const Face& face) { return face.side.side(p) <= 0; });
}

template <int Dim>
std::vector<Vector<Dim>> ConvexCell<Dim>::corners() const {
    std::vector<Vector<Dim>> all;
    for (const Face& face : faces_) all.insert(all.end(), face.corners.begin(), face.corners.end());
    return all;
}

template <int Dim>
double ConvexCell<Dim>::measure() const {
    if (faces_.empty()) return 0;
    const Vector<Dim> origin = faces_.front().corners.front();
    double measure = 0;  // cones from the origin over the faces, whatever way they are turned
    for (const Face& face : faces_) {
        const Vector<Dim> area = Space<Dim>::area_vector(face.corners);
        measure += std::abs(area.dot(face.corners[0] - origin)) / (Dim * (Dim - 1));
    }
    return measure;
}

#define LOD_INSTANTIATE(Dim)                                                                  \
    template std::size_t clip_facet<Dim>(std::span<const Vector<Dim>>, const HalfSpace<Dim>&, \
                                         std::vector<Vector<Dim>>&);                          \
    template class ConvexCell<Dim>;
LOD_INSTANTIATE(2)
LOD_INSTANTIATE(3)
#undef LOD_INSTANTIATE

}  // namespace lod
