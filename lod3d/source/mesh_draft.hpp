#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lodlab/lod3d/source/mesh_readers.hpp"

namespace lod3d {

/// A mesh while its file is read: collects vertices and polygons, which may name vertices that come
/// later, within the limits, and says where in the file something is wrong.
class MeshDraft {
  public:
    /// How the file numbers things.
    struct Numbering {
        const char* place = "line";  ///< what places are: "line" or "byte"
        std::int64_t first_vertex = 0;
    };
    /// `bytes`: of the file, which is held in memory, too.
    MeshDraft(std::string name, std::size_t bytes, Numbering numbering, const ImportLimits& limits);

    void add_vertex(const Point& p, std::uint64_t place);
    /// Remembers how finely the largest coordinates of a text are written.
    void note_digits(std::string_view word, double value);
    /// Vertices count from 0 here. Fewer than three corners bound nothing and are left out.
    void add_polygon(std::span<const std::int64_t> corners, std::uint64_t place);
    [[nodiscard]] std::int64_t vertices() const {
        return static_cast<std::int64_t>(vertices_.size());
    }

    /// The mesh, polygons cut into triangles. Where there are none refuses the file and says
    /// `mend`.
    [[nodiscard]] FileMesh finish(const std::string& mend);

    [[nodiscard]] const std::string& name() const { return name_; }

    /// Looks at the clock, the memory and the stop signal now and then; every loop calls it.
    void tick() {
        if (++ticks_ % 4096 == 0) check_limits();
    }
    void check_limits() const;

    /// What a header promises: refuses more than `bytes_left` can hold at so many bytes each, and
    /// a negative number.
    void check_promise(double count, double bytes_each, std::size_t bytes_left,
                       const std::string& what) const;
    /// So many triangles would come.
    void check_triangles(double count) const;

    [[noreturn]] void refuse(const std::string& why) const;
    [[noreturn]] void refuse_at(std::uint64_t place, const std::string& why) const;
    [[noreturn]] void exceed(const std::string& why) const;

  private:
    struct Polygon {
        std::size_t corners_end;  ///< into corners_
        std::uint64_t place;
    };
    [[noreturn]] void refuse_vertex(std::int64_t number, std::uint64_t place) const;
    void use_corners(const Polygon& polygon, std::span<const std::int32_t> corners, Mesh& mesh,
                     std::vector<std::int32_t>& number_of) const;
    [[nodiscard]] double written_step(const Mesh& mesh) const;

    std::string name_;
    std::size_t bytes_;
    Numbering numbering_;
    ImportLimits limits_;
    std::chrono::steady_clock::time_point deadline_;
    std::uint64_t ticks_ = 0;
    std::vector<Point> vertices_;
    std::vector<std::uint64_t> vertex_places_;
    std::vector<std::int32_t> corners_;
    std::vector<Polygon> polygons_;
    std::uint64_t triangles_ = 0;
    double largest_ = 0;  ///< of the coordinates noted
    int significant_ = 0;
    int decimals_ = 0;
    bool has_fractions_ = false;  ///< some coordinate is no plain whole number
};

}  // namespace lod3d
