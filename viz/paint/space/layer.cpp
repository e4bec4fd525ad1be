#include "lodlab/viz/paint/space/layer.hpp"

#include <cmath>
#include <limits>

#include "lodlab/core/base/lists.hpp"

namespace viz {
namespace {

using Vector3 = lod::Vector<3>;

constexpr float nowhere = std::numeric_limits<float>::infinity();
constexpr double off_screen = 1e7;  ///< samples; what is projected further is left out

/// Twice the area of a triangle of the sample grid, positive anticlockwise with y up.
template <class Corner>
double doubled_area(const Corner& a, const Corner& b, const Corner& c) {
    return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
}

}  // namespace

SurfaceLayer::SurfaceLayer(const Facets& facets, const Eye& eye, const Vector3& light,
                           const Grain& grain)
    : surface_(*facets.surface),
      samples_(grain.samples),
      perspective_(eye.perspective),
      half_line_(grain.line * grain.samples / 2),
      lift_(2.5 * grain.line * eye.metres_per_pixel) {
    lod::Matrix<3> R;
    for (int axis = 0; axis < 3; ++axis)
        R.set_col(axis, vector3(facets.axes[static_cast<std::size_t>(axis)]));
    const Vector3 origin = vector3(facets.origin);
    const double least = eye.nearest_depth();
    corners_.reserve(surface_.vertices.size());
    for (const Point3& v : surface_.vertices) {
        const Vector3 seen = eye.seen(origin + R * vector3(v));
        const Point p = eye.pixel(seen);
        const bool shown =
            seen.z() > least && std::abs(p.x) < off_screen && std::abs(p.y) < off_screen;
        corners_.push_back({samples_ * p.x, samples_ * p.y, shown ? seen.z() : nowhere});
    }
    // The light in the body's frame, where the normals are.
    const Vector3 world_light =
        light.x() * eye.axes.right + light.y() * eye.axes.up + light.z() * eye.axes.forward;
    find_facing(R.transpose() * world_light);
    find_segments();
    sort_into_bands(grain.height);
}

void SurfaceLayer::find_facing(const Vector3& local_light) {
    facing_.reserve(surface_.normals.size());
    for (const std::array<Point3, 3>& normals : surface_.normals) {
        std::array<float, 3>& facing = facing_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            facing[k] = static_cast<float>(vector3(normals[k]).dot(local_light));
    }
    for (const auto& [a, b, c] : surface_.triangles)
        front_.push_back(
            doubled_area(corners_[lod::at(a)], corners_[lod::at(b)], corners_[lod::at(c)]) > 0);
}

bool SurfaceLayer::visible(std::size_t triangle) const {
    if (!front_[triangle]) return false;  // the back of a closed surface is never seen
    const auto& [a, b, c] = surface_.triangles[triangle];
    return corners_[lod::at(a)].depth < nowhere && corners_[lod::at(b)].depth < nowhere &&
           corners_[lod::at(c)].depth < nowhere;
}

void SurfaceLayer::find_segments() {
    for (const Surface::Edge& edge : surface_.edges) {
        const bool left = front_[lod::at(edge.left)] != 0;
        const bool right = edge.right >= 0 && front_[lod::at(edge.right)] != 0;
        if (!(left || right) || (left == right && !edge.sharp)) continue;
        const Segment segment{corners_[lod::at(edge.from)], corners_[lod::at(edge.to)], edge.sharp};
        if (segment.a.depth < nowhere && segment.b.depth < nowhere) segments_.push_back(segment);
    }
}

void SurfaceLayer::sort_into_bands(int height) {
    const int bands = (height + band_rows - 1) / band_rows;
    triangles_in_.resize(lod::at(bands));
    segments_in_.resize(lod::at(bands));
    double left = off_screen;
    double right = -off_screen;
    const auto add = [&](std::vector<std::vector<int>>& lists, int number, double low,
                         double high) {
        const double rows = band_rows * samples_;
        const int first = static_cast<int>(std::clamp(std::floor(low / rows), 0.0, bands + 0.0));
        const int last = static_cast<int>(std::clamp(std::floor(high / rows), -1.0, bands - 1.0));
        for (int band = first; band <= last; ++band) lists[lod::at(band)].push_back(number);
    };
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
        if (!visible(t)) continue;
        const auto& [i, j, k] = surface_.triangles[t];
        const Corner& a = corners_[lod::at(i)];
        const Corner& b = corners_[lod::at(j)];
        const Corner& c = corners_[lod::at(k)];
        add(triangles_in_, static_cast<int>(t), std::min({a.y, b.y, c.y}),
            std::max({a.y, b.y, c.y}));
        left = std::min({left, a.x, b.x, c.x});
        right = std::max({right, a.x, b.x, c.x});
    }
    for (std::size_t s = 0; s < segments_.size(); ++s) {
        const Segment& segment = segments_[s];
        add(segments_in_, static_cast<int>(s), std::min(segment.a.y, segment.b.y) - half_line_,
            std::max(segment.a.y, segment.b.y) + half_line_);
    }
    const auto column = [&](double x) {
        return static_cast<int>(std::clamp(std::floor(x / samples_), -1e4, 1e5));
    };
    first_column_ = std::max(0, column(left - half_line_) - 1);
    columns_ = std::max(0, column(right + half_line_) + 2 - first_column_);
    columns_ = std::min(columns_, 20000);
    row_ = lod::at(columns_) * lod::at(samples_);
}

bool SurfaceLayer::draw_band(int first_row) {
    first_row_ = first_row;
    const std::size_t band = lod::at(first_row / band_rows);
    if (triangles_in_[band].empty() && segments_in_[band].empty()) return false;
    band_.assign(row_ * lod::at(band_rows * samples_), {nowhere, 0});
    for (const int t : triangles_in_[band]) draw_triangle(lod::at(t));
    for (const int s : segments_in_[band]) draw_segment(segments_[lod::at(s)]);
    return true;
}

SurfaceLayer::Sample* SurfaceLayer::row_at(int y) {
    return band_.data() + lod::at(y - first_row_ * samples_) * row_;
}

/// Samples stand in the middle of their cells: sample i at i + 1/2.
void SurfaceLayer::draw_triangle(std::size_t triangle) {
    const auto& [i, j, k] = surface_.triangles[triangle];
    const Corner& a = corners_[lod::at(i)];
    const Corner& b = corners_[lod::at(j)];
    const Corner& c = corners_[lod::at(k)];
    const double area = doubled_area(a, b, c);
    const auto first = [](double v, int least) {
        return std::max(least, static_cast<int>(std::ceil(v - 0.5)));
    };
    const auto last = [](double v, int most) {
        return std::min(most, static_cast<int>(std::floor(v - 0.5)));
    };
    const int left = first_column_ * samples_;
    const int top = first_row_ * samples_;
    const int x0 = first(std::min({a.x, b.x, c.x}), left);
    const int x1 = last(std::max({a.x, b.x, c.x}), left + columns_ * samples_ - 1);
    const int y0 = first(std::min({a.y, b.y, c.y}), top);
    const int y1 = last(std::max({a.y, b.y, c.y}), top + band_rows * samples_ - 1);
    // In perspective the inverse of the depth is linear over the picture.
    const auto linear = [&](double depth) { return perspective_ ? 1 / depth : depth; };
    const double za = linear(a.depth);
    const double zb = linear(b.depth);
    const double zc = linear(c.depth);
    const std::array<float, 3>& facing = facing_[triangle];
    for (int y = y0; y <= y1; ++y) {
        Sample* row = row_at(y);
        for (int x = x0; x <= x1; ++x) {
            const Corner p{x + 0.5, y + 0.5, 0};
            const double u = doubled_area(p, b, c) / area;
            const double v = doubled_area(a, p, c) / area;
            const double w = 1 - u - v;
            if (u < 0 || v < 0 || w < 0) continue;
            const auto depth = static_cast<float>(linear(u * za + v * zb + w * zc));
            Sample& sample = row[x - left];
            if (depth >= sample.depth) continue;
            sample = {depth, static_cast<float>(u * facing[0] + v * facing[1] + w * facing[2])};
        }
    }
}

/// Whether the surface ends or falls back on one side of a silhouette's part: folds of a wrinkled
/// surface turn away, too, and would only speckle it.
bool SurfaceLayer::falls_away_beside(const Segment& segment) const {
    const auto& [a, b, sharp] = segment;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double beside = 2 * half_line_ + 1;
    const double dx = length > 0 ? -(b.y - a.y) / length * beside : beside;
    const double dy = length > 0 ? (b.x - a.x) / length * beside : 0;
    const double back = (a.depth + b.depth) / 2 + lift_;
    for (const double side : {-1.0, 1.0}) {
        const int x = static_cast<int>(std::floor((a.x + b.x) / 2 + side * dx));
        const int y = static_cast<int>(std::floor((a.y + b.y) / 2 + side * dy));
        const bool in_band =
            y >= first_row_ * samples_ && y < (first_row_ + band_rows) * samples_ &&
            x >= first_column_ * samples_ && x < (first_column_ + columns_) * samples_;
        if (!in_band || at(x, y).depth > back) return true;
    }
    return false;
}

void SurfaceLayer::draw_segment(const Segment& segment) {
    const auto& [a, b, sharp] = segment;
    if (!sharp && !falls_away_beside(segment)) return;
    const int left = first_column_ * samples_;
    const int top = first_row_ * samples_;
    const int x0 = std::max(left, static_cast<int>(std::floor(std::min(a.x, b.x) - half_line_)));
    const int x1 = std::min(left + columns_ * samples_ - 1,
                            static_cast<int>(std::ceil(std::max(a.x, b.x) + half_line_)));
    const int y0 = std::max(top, static_cast<int>(std::floor(std::min(a.y, b.y) - half_line_)));
    const int y1 = std::min(top + band_rows * samples_ - 1,
                            static_cast<int>(std::ceil(std::max(a.y, b.y) + half_line_)));
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length2 = std::max(1e-12, dx * dx + dy * dy);
    for (int y = y0; y <= y1; ++y) {
        Sample* row = row_at(y);
        for (int x = x0; x <= x1; ++x) {
            const double px = x + 0.5 - a.x;
            const double py = y + 0.5 - a.y;
            const double t = std::clamp((px * dx + py * dy) / length2, 0.0, 1.0);
            const double away = std::hypot(px - t * dx, py - t * dy);
            if (away > half_line_) continue;
            const double depth = a.depth + t * (b.depth - a.depth) - lift_;
            Sample& sample = row[x - left];
            if (static_cast<float>(depth) < sample.depth)
                sample = {static_cast<float>(depth + lift_), on_line};
        }
    }
}

}  // namespace viz
