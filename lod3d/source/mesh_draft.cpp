#include "lodlab/lod3d/source/mesh_draft.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod3d/mesh/mesh_faults.hpp"
#include "lodlab/lod3d/source/cut_polygon.hpp"
#include "lodlab/lod3d/source/text_words.hpp"

namespace lod3d {
namespace {

std::string whole(double count) {
    const std::string digits = std::to_string(count);
    return digits.substr(0, digits.find('.'));
}

constexpr std::size_t most_vertices = std::numeric_limits<std::int32_t>::max();

}  // namespace

double coordinate_step(const Mesh& mesh, int significant_bits) {
    double largest = 0;
    for (const Point& p : mesh.vertices) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) + 1 - significant_bits) : 0;
}

MeshDraft::MeshDraft(std::string name, std::size_t bytes, Numbering numbering,
                     const ImportLimits& limits)
    : name_(std::move(name)),
      bytes_(bytes),
      numbering_(numbering),
      limits_(limits),
      deadline_(std::chrono::steady_clock::now() +
                std::chrono::milliseconds(static_cast<long>(1000 * limits.most_seconds))) {
    if (bytes == 0) refuse("is empty");
}

void MeshDraft::add_vertex(const Point& p, std::uint64_t place) {
    if (vertices_.size() >= most_vertices || vertices_.size() >= 3 * limits_.most_triangles)
        exceed("more than " + std::to_string(vertices_.size()) + " vertices, which the limit of " +
               std::to_string(limits_.most_triangles) +
               " triangles allows; simplify the mesh or raise the limit");
    vertices_.push_back(p);
    vertex_places_.push_back(place);
    tick();
}

void MeshDraft::note_digits(std::string_view word, double value) {
    const double size = std::abs(value);
    if (!has_fractions_) has_fractions_ = word.find_first_of(".,eE") != std::string_view::npos;
    if (!(size > 0) || !std::isfinite(size) || 2 * size < largest_) return;
    const WrittenDigits digits = digits_of(word);
    const bool first = size > 2 * largest_;
    significant_ = first ? digits.significant : std::max(significant_, digits.significant);
    decimals_ = first ? digits.decimals : std::max(decimals_, digits.decimals);
    largest_ = std::max(largest_, size);
}

/// The step between written coordinates next to each other [m]. 0 where it is fine enough for the
/// mesh, and where few digits seem to be meant: a program that rounds writes six and more, and a
/// text of whole numbers alone is one of a grid.
double MeshDraft::written_step(const Mesh& mesh) const {
    constexpr int rounded = 6;
    constexpr double fine = 1e-6;  // of the size
    if (significant_ < rounded || !has_fractions_) return 0;
    double step = 1;
    for (int i = std::min(decimals_, 40); i > 0; --i) step /= 10;
    for (int i = std::max(decimals_, -40); i < 0; ++i) step *= 10;
    return step > fine * bounding_box(mesh).size().maxCoeff() ? step : 0;
}

void MeshDraft::add_polygon(std::span<const std::int64_t> corners, std::uint64_t place) {
    tick();
    if (corners.size() < 3) return;
    triangles_ += corners.size() - 2;
    if (triangles_ > limits_.most_triangles) check_triangles(static_cast<double>(triangles_));
    for (const std::int64_t corner : corners) {
        if (corner < 0 || corner >= static_cast<std::int64_t>(most_vertices))
            refuse_vertex(corner, place);
        corners_.push_back(static_cast<std::int32_t>(corner));
    }
    polygons_.push_back({corners_.size(), place});
}

FileMesh MeshDraft::finish(const std::string& mend) {
    check_limits();
    FileMesh result;
    std::vector<std::int32_t> number_of(vertices_.size(), -1);
    std::vector<Point> points;
    std::vector<Triangle> cut;
    std::vector<std::int32_t> corners;
    std::size_t begin = 0;
    for (const Polygon& polygon : polygons_) {
        tick();
        corners.clear();
        for (; begin < polygon.corners_end; ++begin)
            if (corners.empty() || corners.back() != corners_[begin])
                corners.push_back(corners_[begin]);
        while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        use_corners(polygon, corners, result.mesh, number_of);
        if (corners.size() < 3) continue;
        points.clear();
        for (std::int32_t& corner : corners) {
            points.push_back(vertices_[static_cast<std::size_t>(corner)]);
            corner = number_of[static_cast<std::size_t>(corner)];
        }
        cut.clear();
        try {
            cut_polygon(points, cut);
        } catch (const lod::Error& error) {
            throw lod::Error(error.kind(), name_ + ", " + numbering_.place + " " +
                                               std::to_string(polygon.place) + ": " + error.what());
        }
        for (Triangle& triangle : cut) {
            for (std::int32_t& corner : triangle)
                corner = corners[static_cast<std::size_t>(corner)];
            result.mesh.triangles.push_back(triangle);
        }
    }
    if (result.mesh.triangles.empty()) refuse("holds no triangles; " + mend);
    result.step = std::max(coordinate_step(result.mesh, 53), written_step(result.mesh));
    return result;
}

/// Checks the vertices that a polygon names, and takes those that no other named before.
void MeshDraft::use_corners(const Polygon& polygon, std::span<const std::int32_t> corners,
                            Mesh& mesh, std::vector<std::int32_t>& number_of) const {
    for (const std::int32_t corner : corners) {
        const auto at = static_cast<std::size_t>(corner);
        if (at >= vertices_.size()) refuse_vertex(corner, polygon.place);
        if (number_of[at] >= 0 || corners.size() < 3) continue;
        if (!is_usable(vertices_[at]))
            refuse_at(vertex_places_[at],
                      "vertex " + std::to_string(corner + numbering_.first_vertex) + " is " +
                          place_in_words(vertices_[at]) +
                          ", not finite or beyond 1e100, and a face uses it; mend the number");
        number_of[at] = static_cast<std::int32_t>(mesh.vertices.size());
        mesh.vertices.push_back(vertices_[at]);
    }
}

void MeshDraft::refuse_vertex(std::int64_t number, std::uint64_t place) const {
    const std::int64_t first = numbering_.first_vertex;
    refuse_at(place, "a face names the vertex index " + std::to_string(number + first) +
                         ", but the file has " + std::to_string(vertices()) +
                         " vertices, numbered from " + std::to_string(first) + "; mend the face");
}

void MeshDraft::check_limits() const {
    lod::check_interrupted();
    if (std::chrono::steady_clock::now() >= deadline_)
        exceed("reading it took longer than the limit of " +
               std::to_string(static_cast<long>(limits_.most_seconds)) + " s");
    const std::uint64_t taken = bytes_ + vertices_.size() * (2 * sizeof(Point) + 12) +
                                corners_.size() * (sizeof(std::int32_t) + sizeof(Triangle)) +
                                polygons_.size() * sizeof(Polygon);
    if (taken > limits_.most_memory)
        exceed("reading it took more than the limit of " +
               std::to_string(limits_.most_memory >> 20) + " MB");
}

void MeshDraft::check_promise(double count, double bytes_each, std::size_t bytes_left,
                              const std::string& what) const {
    if (!(count >= 0)) refuse("the header promises a negative number of " + what);
    if (count * bytes_each <= static_cast<double>(bytes_left)) return;
    const double room = std::floor(static_cast<double>(bytes_left) / bytes_each);
    refuse("the header promises " + whole(count) + " " + what + ", and the " +
           std::to_string(bytes_left) + " bytes after it cannot hold more than " + whole(room) +
           "; is the file cut short? Save it again, or mend the number");
}

void MeshDraft::check_triangles(double count) const {
    if (count > static_cast<double>(limits_.most_triangles))
        exceed(whole(count) + " triangles, more than the limit of " +
               std::to_string(limits_.most_triangles) + "; simplify the mesh or raise the limit");
}

void MeshDraft::refuse(const std::string& why) const {
    lod::refuse_input(name_, why);
}

void MeshDraft::refuse_at(std::uint64_t place, const std::string& why) const {
    lod::refuse_input(name_ + ", " + numbering_.place + " " + std::to_string(place), why);
}

void MeshDraft::exceed(const std::string& why) const {
    throw lod::Error(lod::ErrorKind::limit_exceeded, name_ + ": " + why);
}

}  // namespace lod3d
