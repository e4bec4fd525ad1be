#include "lodlab/lod3d/source/cut_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/base/stop.hpp"

namespace lod3d {
namespace {

using Flat = lod::Vector<2>;

/// Twice the area of a triangle; positive where it is anticlockwise.
double turn(const Flat& a, const Flat& b, const Flat& c) {
    const Flat u = b - a;
    const Flat v = c - a;
    return u.x() * v.y() - u.y() * v.x();
}

/// The polygon's shadow on the plane of two axes on which it is largest, anticlockwise there.
/// Coordinates are relative to its first corner.
std::vector<Flat> shadow(std::span<const Point> corners) {
    Point normal = Point::Zero();  // Newell's
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    int along = 0;
    for (int d = 1; d < 3; ++d)
        if (std::abs(normal[d]) > std::abs(normal[along])) along = d;
    int x = (along + 1) % 3;
    int y = (along + 2) % 3;
    if (normal[along] < 0) std::swap(x, y);
    std::vector<Flat> flat;
    flat.reserve(corners.size());
    for (const Point& p : corners) {
        const Point from_first = p - corners[0];
        flat.emplace_back(from_first[x], from_first[y]);
    }
    return flat;
}

/// Takes ears off a polygon: triangles of three corners in a row that hold no other corner.
class EarCutter {
  public:
    EarCutter(std::vector<Flat> corners, std::vector<Triangle>& triangles)
        : corner_(std::move(corners)),
          before_(corner_.size()),
          after_(corner_.size()),
          gone_(corner_.size(), 0),
          left_(corner_.size()),
          triangles_(triangles) {
        const auto count = static_cast<std::int32_t>(corner_.size());
        for (std::int32_t i = 0; i < count; ++i) {
            before_[lod::at(i)] = (i + count - 1) % count;
            after_[lod::at(i)] = (i + 1) % count;
        }
        for (std::int32_t i = 0; i < count; ++i)
            if (turn_at(i) <= 0) inward_.push_back(i);
        constexpr double most_work = 1e9;
        if (static_cast<double>(left_) * static_cast<double>(inward_.size()) > most_work)
            throw lod::Error(lod::ErrorKind::limit_exceeded,
                             "a face of " + std::to_string(left_) + " corners, of which " +
                                 std::to_string(inward_.size()) +
                                 " point inwards, takes too long to cut into triangles; divide it");
    }

    void run() {
        cut_ears(Least::positive);
        cut_ears(Least::zero);  // corners on a line with their neighbours
        while (left_ >= 3) cut(last_);
    }

  private:
    enum class Least { positive, zero };  ///< area of an ear

    [[nodiscard]] double turn_at(std::int32_t i) const {
        return turn(corner_[lod::at(before_[lod::at(i)])], corner_[lod::at(i)],
                    corner_[lod::at(after_[lod::at(i)])]);
    }

    /// Whether a corner that points inwards lies in the triangle; one at its corners does not.
    [[nodiscard]] bool blocks(std::int32_t i, const std::array<Flat, 3>& ear) const {
        const Flat& p = corner_[lod::at(i)];
        if (std::find(ear.begin(), ear.end(), p) != ear.end()) return false;
        return turn(ear[0], ear[1], p) >= 0 && turn(ear[1], ear[2], p) >= 0 &&
               turn(ear[2], ear[0], p) >= 0 && turn_at(i) <= 0;
    }

    [[nodiscard]] bool is_ear(std::int32_t i, Least least) {
        const double area = turn_at(i);
        if (!(least == Least::positive ? area > 0 : area >= 0)) return false;
        const std::array<Flat, 3> ear{corner_[lod::at(before_[lod::at(i)])], corner_[lod::at(i)],
                                      corner_[lod::at(after_[lod::at(i)])]};
        std::erase_if(inward_, [&](std::int32_t j) { return gone_[lod::at(j)] != 0; });
        return std::none_of(inward_.begin(), inward_.end(),
                            [&](std::int32_t j) { return blocks(j, ear); });
    }

    void cut(std::int32_t i) {
        const std::int32_t from = before_[lod::at(i)];
        const std::int32_t to = after_[lod::at(i)];
        triangles_.push_back({from, i, to});
        after_[lod::at(from)] = to;
        before_[lod::at(to)] = from;
        gone_[lod::at(i)] = 1;
        last_ = from;
        --left_;
    }

    /// Only the neighbours of an ear that went can become ears.
    void cut_ears(Least least) {
        std::vector<std::int32_t> tried;
        for (std::int32_t i = static_cast<std::int32_t>(corner_.size()); i-- > 0;)
            if (gone_[lod::at(i)] == 0) tried.push_back(i);
        while (!tried.empty() && left_ >= 3) {
            lod::check_interrupted();
            const std::int32_t i = tried.back();
            tried.pop_back();
            if (gone_[lod::at(i)] != 0 || !is_ear(i, least)) continue;
            const std::int32_t from = before_[lod::at(i)];
            const std::int32_t to = after_[lod::at(i)];
            cut(i);
            tried.push_back(from);
            tried.push_back(to);
        }
    }

    std::vector<Flat> corner_;
    std::vector<std::int32_t> before_;
    std::vector<std::int32_t> after_;
    std::vector<char> gone_;
    std::vector<std::int32_t> inward_;  ///< corners that do not point outwards, or did not
    std::size_t left_;
    std::int32_t last_ = 0;  ///< some corner that is left
    std::vector<Triangle>& triangles_;
};

/// Whether triangles from one corner to all sides cut the polygon.
bool is_fan(const std::vector<Flat>& corners) {
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool outwards =
            turn(corners[i], corners[(i + 1) % count], corners[(i + 2) % count]) >= 0;
        const bool seen =
            i == 0 || i + 1 == count || turn(corners[0], corners[i], corners[i + 1]) > 0;
        if (!outwards || !seen) return false;
    }
    return true;
}

void add_fan(std::int32_t first, std::int32_t count, std::vector<Triangle>& triangles) {
    for (std::int32_t i = 1; i + 1 < count; ++i)
        triangles.push_back({first, (first + i) % count, (first + i + 1) % count});
}

}  // namespace

void cut_polygon(std::span<const Point> corners, std::vector<Triangle>& triangles) {
    const auto count = static_cast<std::int32_t>(corners.size());
    if (count == 3) return add_fan(0, count, triangles);
    std::vector<Flat> flat = shadow(corners);
    if (count == 4) {  // from the corner that points inwards, if there is one
        std::int32_t first = 0;
        for (std::int32_t i = 0; i < count; ++i)
            if (turn(flat[static_cast<std::size_t>((i + 3) % 4)], flat[static_cast<std::size_t>(i)],
                     flat[static_cast<std::size_t>((i + 1) % 4)]) < 0)
                first = i;
        return add_fan(first, count, triangles);
    }
    if (is_fan(flat)) return add_fan(0, count, triangles);
    EarCutter(std::move(flat), triangles).run();
}

}  // namespace lod3d
