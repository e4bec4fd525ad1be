#include "lodlab/core/tree/hull.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace lod {

/// The edges of a polytope, each once, in the order in which the faces run through them.
template <int Dim>
void add_edges(const Hull<Dim>& hull, std::vector<HullEdge>& edges) {
    if (!Space<Dim>::facets_close) return;
    const std::size_t before = edges.size();
    for (std::size_t face = 0; face < hull.faces.size(); ++face) {
        const std::vector<std::int32_t>& loop = hull.faces[face];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const std::int32_t from = loop[i];
            const std::int32_t to = loop[(i + 1) % loop.size()];
            const auto met = std::find_if(
                edges.begin() + static_cast<std::ptrdiff_t>(before), edges.end(),
                [&](const HullEdge& edge) { return edge.from == to && edge.to == from; });
            if (met != edges.end())
                met->right = static_cast<std::int32_t>(face);
            else
                edges.push_back(
                    {from, to, static_cast<std::int32_t>(face), static_cast<std::int32_t>(face)});
        }
    }
}

template <int Dim>
bool HullView<Dim>::is_closed() const {
    // In space an edge goes from corner to corner; in the plane a side ends at a corner where
    // another begins: then from and to are ends of sides.
    std::vector<std::array<std::int32_t, 2>> sides;
    for (std::size_t face = 0; face < normals.size(); ++face) {
        const auto corners_of = loop(face);
        if (!Space<Dim>::facets_close) {
            sides.push_back({corners_of[0], -1});
            sides.push_back({-1, corners_of[1]});
            continue;
        }
        for (std::size_t i = 0; i < corners_of.size(); ++i)
            sides.push_back({corners_of[i], corners_of[(i + 1) % corners_of.size()]});
    }
    std::sort(sides.begin(), sides.end());
    if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
    return !sides.empty() && std::all_of(sides.begin(), sides.end(), [&](const auto& edge) {
        return std::binary_search(sides.begin(), sides.end(), std::array{edge[1], edge[0]});
    });
}

template <int Dim>
void NodeHulls<Dim>::add_half_space(const Vector<Dim>& normal) {
    normals_.push_back(normal);
    offsets_.push_back(0);
    inner_.push_back(0);
    loop_begin_.push_back(static_cast<std::int32_t>(loops_.size()));
    edge_begin_.push_back(static_cast<std::int32_t>(edges_.size()));
    tight_.push_back(1);
    round_.push_back(0);
    corner_begin_.push_back(static_cast<std::int32_t>(corners_.size()));
    face_begin_.push_back(static_cast<std::int32_t>(normals_.size()));
}

template <int Dim>
void NodeHulls<Dim>::add(const Hull<Dim>& hull) {
    std::vector<Vector<Dim>> facet;
    for (const std::vector<std::int32_t>& face : hull.faces) {
        facet.clear();
        for (const std::int32_t corner : face)
            facet.push_back(hull.corners[static_cast<std::size_t>(corner)]);
        const Vector<Dim> normal = Space<Dim>::area_vector(facet).normalized();
        double offset = -std::numeric_limits<double>::infinity();
        for (const Vector<Dim>& corner : facet) offset = std::max(offset, normal.dot(corner));
        normals_.push_back(normal);
        offsets_.push_back(offset);
        loops_.insert(loops_.end(), face.begin(), face.end());
        loop_begin_.push_back(static_cast<std::int32_t>(loops_.size()));
    }
    for (std::size_t face = 0; face < hull.faces.size(); ++face)
        inner_.push_back(face < hull.inner.size() && hull.inner[face]);
    add_edges(hull, edges_);
    edge_begin_.push_back(static_cast<std::int32_t>(edges_.size()));
    tight_.push_back(hull.tight);
    round_.push_back(hull.round);
    for (std::size_t corner = 0; corner < hull.corners.size(); ++corner)
        cut_.push_back(corner < hull.cut.size() && hull.cut[corner]);
    corners_.insert(corners_.end(), hull.corners.begin(), hull.corners.end());
    corner_begin_.push_back(static_cast<std::int32_t>(corners_.size()));
    face_begin_.push_back(static_cast<std::int32_t>(normals_.size()));
}

template <int Dim>
void NodeHulls<Dim>::find_best(std::span<const std::int32_t> parent) {
    best_.resize(tight_.size());
    for (std::size_t node = 0; node < best_.size(); ++node) {
        best_[node] = static_cast<std::int32_t>(node);
        if (parent[node] < 0) continue;
        const std::int32_t above = best_[static_cast<std::size_t>(parent[node])];
        if (tight_[static_cast<std::size_t>(above)]) best_[node] = above;
    }
}

template <int Dim>
HullView<Dim> NodeHulls<Dim>::of(int node) const {
    const auto n = static_cast<std::size_t>(node);
    const auto corner = static_cast<std::size_t>(corner_begin_[n]);
    const auto face = static_cast<std::size_t>(face_begin_[n]);
    const auto edge = static_cast<std::size_t>(edge_begin_[n]);
    const std::size_t edges = static_cast<std::size_t>(edge_begin_[n + 1]) - edge;
    const std::size_t corners = static_cast<std::size_t>(corner_begin_[n + 1]) - corner;
    const std::size_t faces = static_cast<std::size_t>(face_begin_[n + 1]) - face;
    HullView<Dim> view;
    view.corners = std::span(corners_).subspan(corner, corners);
    view.normals = std::span(normals_).subspan(face, faces);
    view.offsets = std::span(offsets_).subspan(face, faces);
    view.inner = std::span(inner_).subspan(face, faces);
    view.cut = std::span(cut_).subspan(corner, corners);
    view.loop_begin = std::span(loop_begin_).subspan(face, faces + 1);
    view.loops = loops_;
    view.edges = std::span(edges_).subspan(edge, edges);
    return view;
}

template struct HullView<2>;
template struct HullView<3>;
template class NodeHulls<2>;
template class NodeHulls<3>;

}  // namespace lod
