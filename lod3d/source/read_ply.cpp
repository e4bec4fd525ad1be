#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/source/binary_number.hpp"
#include "lodlab/lod3d/source/ply_header.hpp"
#include "lodlab/lod3d/source/text_words.hpp"

namespace lod3d {
namespace {

/// Goes through the numbers after the header.
class PlyValues {
  public:
    PlyValues(std::string_view bytes, const PlyHeader& header, MeshDraft& draft)
        : bytes_(bytes),
          words_(bytes.substr(header.end), TextWords::Comments::none),
          header_(header),
          draft_(draft),
          place_(header.end) {}

    [[nodiscard]] std::uint64_t place() const {
        return header_.format == PlyFormat::ascii ? header_.lines + words_.line() : place_;
    }

    double next(PlyType type) {
        draft_.tick();
        if (header_.format == PlyFormat::ascii) return next_word();
        if (size_of(type) > bytes_.size() - place_) refuse_end();
        const std::size_t at = place_;
        place_ += size_of(type);
        const auto order =
            header_.format == PlyFormat::little_endian ? std::endian::little : std::endian::big;
        switch (type) {
            case PlyType::none:
                break;
            case PlyType::int8:
                return binary_number<std::int8_t>(bytes_, at, order);
            case PlyType::uint8:
                return binary_number<std::uint8_t>(bytes_, at, order);
            case PlyType::int16:
                return binary_number<std::int16_t>(bytes_, at, order);
            case PlyType::uint16:
                return binary_number<std::uint16_t>(bytes_, at, order);
            case PlyType::int32:
                return binary_number<std::int32_t>(bytes_, at, order);
            case PlyType::uint32:
                return binary_number<std::uint32_t>(bytes_, at, order);
            case PlyType::int64:
                return static_cast<double>(binary_number<std::int64_t>(bytes_, at, order));
            case PlyType::uint64:
                return static_cast<double>(binary_number<std::uint64_t>(bytes_, at, order));
            case PlyType::float32:
                return binary_number<float>(bytes_, at, order);
            case PlyType::float64:
                return binary_number<double>(bytes_, at, order);
        }
        return 0;
    }

    /// What the last number was read from; empty in a binary file.
    [[nodiscard]] std::string_view last_word() const { return word_; }

    /// A whole number, such as a list's length or a vertex index.
    std::int64_t next_whole(PlyType type, const char* what) {
        const double value = next(type);
        constexpr double most = 1ll << 53;
        if (!(std::abs(value) <= most) || value != std::floor(value))
            draft_.refuse_at(place(), std::string(what) + " is " + std::to_string(value) +
                                          ", which is no whole number");
        return static_cast<std::int64_t>(value);
    }

    std::int64_t next_length(const PlyProperty& list) {
        const std::int64_t length = next_whole(list.count_type, "the length of a list");
        if (length < 0)
            draft_.refuse_at(place(), "a list has the negative length " + std::to_string(length));
        return length;
    }

    void skip(const PlyProperty& property) {
        if (!property.is_list()) {
            next(property.type);
            return;
        }
        for (std::int64_t left = next_length(property); left > 0; --left) next(property.type);
    }

    /// What follows the last element, as a remark; empty where nothing does.
    std::string left_over() {
        if (header_.format == PlyFormat::ascii)
            return words_.next().empty() ? ""
                                         : "passed over what follows the last element, from line " +
                                               std::to_string(place());
        if (place_ == bytes_.size()) return "";
        return "passed over " + std::to_string(bytes_.size() - place_) +
               " bytes after the last element";
    }

  private:
    double next_word() {
        word_ = words_.next();
        if (word_.empty()) refuse_end();
        const auto value = number_in(word_);
        if (!value) draft_.refuse_at(place(), in_quotes(word_) + " stands where a number should");
        return *value;
    }

    [[noreturn]] void refuse_end() const {
        draft_.refuse("the file ends before all that its header promises; is it cut short?");
    }

    std::string_view bytes_;
    TextWords words_;
    const PlyHeader& header_;
    MeshDraft& draft_;
    std::size_t place_;
    std::string_view word_;
};

class PlyReader {
  public:
    PlyReader(const PlyHeader& header, std::string_view bytes, MeshDraft& draft)
        : header_(header), values_(bytes, header, draft), draft_(draft) {
        has_strips_ = std::any_of(header.elements.begin(), header.elements.end(),
                                  [](const PlyElement& element) {
                                      return element.name == "tristrips" && element.count > 0;
                                  });
    }

    FileMesh read() {
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty() || element.count == 0) continue;  // takes no bytes
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_lists(element, [&](const PlyProperty& list) { face(list); });
            else if (element.name == "tristrips")
                read_lists(element, [&](const PlyProperty& list) { strips(list); });
            else
                for (std::int64_t i = 0; i < element.count; ++i)
                    for (const PlyProperty& property : element.properties) values_.skip(property);
        }
        const bool repeated = strips_repeat_faces();
        if (!repeated)
            for (const StripTriangle& one : strips_) draft_.add_polygon(one.corners, one.place);
        FileMesh file = draft_.finish(
            "it needs an element face, or tristrips, with a list of "
            "vertex indices");
        file.step = std::max(file.step, coordinate_step(file.mesh, bits_));
        if (repeated)
            file.remarks.emplace_back("passed over its tristrips, which repeat its faces");
        const std::string left = values_.left_over();
        if (!left.empty()) file.remarks.push_back(left);
        return file;
    }

  private:
    void read_vertices(const PlyElement& element) {
        std::array<std::size_t, 3> axis{};
        for (std::size_t d = 0; d < 3; ++d) {
            const std::string name(1, "xyz"[d]);
            const auto found =
                std::find_if(element.properties.begin(), element.properties.end(),
                             [&](const PlyProperty& p) { return p.name == name && !p.is_list(); });
            if (found == element.properties.end())
                draft_.refuse("element vertex has no property " + name + "; add it to the header");
            axis[d] = static_cast<std::size_t>(found - element.properties.begin());
            if (header_.format != PlyFormat::ascii && found->type == PlyType::float32) bits_ = 24;
        }
        std::vector<double> row(element.properties.size(), 0.0);
        for (std::int64_t i = 0; i < element.count; ++i) {
            std::uint64_t place = values_.place();
            for (std::size_t p = 0; p < row.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (property.is_list())
                    values_.skip(property);
                else
                    row[p] = values_.next(property.type);
                if (std::find(axis.begin(), axis.end(), p) != axis.end())
                    draft_.note_digits(values_.last_word(), row[p]);
                if (p == 0 && header_.format == PlyFormat::ascii) place = values_.place();
            }
            draft_.add_vertex({row[axis[0]], row[axis[1]], row[axis[2]]}, place);
        }
    }

    /// The property that lists vertices: by its name, else the only list that there is.
    const PlyProperty& vertex_list(const PlyElement& element) const {
        const PlyProperty* only = nullptr;
        int lists = 0;
        for (const PlyProperty& property : element.properties) {
            if (!property.is_list()) continue;
            if (property.name == "vertex_indices" || property.name == "vertex_index")
                return property;
            only = &property;
            ++lists;
        }
        if (lists != 1)
            draft_.refuse("element " + element.name +
                          " has no list vertex_indices; name its list of vertices so");
        return *only;
    }

    template <class Read>
    void read_lists(const PlyElement& element, const Read& read) {
        const PlyProperty& list = vertex_list(element);
        for (std::int64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) {
                if (&property == &list)
                    read(list);
                else
                    values_.skip(property);
            }
    }

    void face(const PlyProperty& list) {
        const std::int64_t length = values_.next_length(list);
        const std::uint64_t place = values_.place();
        draft_.check_triangles(static_cast<double>(length) - 2);
        corners_.clear();
        for (std::int64_t k = 0; k < length; ++k)
            corners_.push_back(values_.next_whole(list.type, "a vertex index"));
        draft_.add_polygon(corners_, place);
        if (!has_strips_ || length < 3) return;
        std::sort(corners_.begin(), corners_.end());
        for (const std::int64_t corner : corners_) faces_of_[corner].push_back(faces_.size());
        faces_.push_back(corners_);
    }

    /// Each vertex makes a triangle with the two before it, turned the other way than the last; a
    /// negative index ends a strip and begins the next.
    void strips(const PlyProperty& list) {
        constexpr std::int64_t minus_one_unsigned = 0xffffffff;
        std::array<std::int64_t, 2> last{};
        std::int64_t length = 0;  // of the strip so far
        for (std::int64_t left = values_.next_length(list); left > 0; --left) {
            const std::int64_t v = values_.next_whole(list.type, "a vertex index");
            if (v < 0 || v == minus_one_unsigned) {
                length = 0;
                continue;
            }
            if (length >= 2 && last[0] != last[1] && last[1] != v && v != last[0]) {
                draft_.check_triangles(static_cast<double>(strips_.size()) + 1);
                strips_.push_back({length % 2 == 0 ? std::array{last[0], last[1], v}
                                                   : std::array{last[1], last[0], v},
                                   values_.place()});
            }
            last = {last[1], v};
            ++length;
        }
    }

    struct StripTriangle {
        std::array<std::int64_t, 3> corners;
        std::uint64_t place;
    };

    /// Whether there are faces, and strips of which each triangle has the corners of one.
    [[nodiscard]] bool strips_repeat_faces() const {
        if (faces_.empty() || strips_.empty()) return false;
        return std::all_of(strips_.begin(), strips_.end(), [&](const StripTriangle& one) {
            const auto around = faces_of_.find(one.corners[0]);
            return around != faces_of_.end() &&
                   std::any_of(around->second.begin(), around->second.end(), [&](std::size_t face) {
                       return std::all_of(one.corners.begin(), one.corners.end(),
                                          [&](std::int64_t corner) {
                                              return std::binary_search(faces_[face].begin(),
                                                                        faces_[face].end(), corner);
                                          });
                   });
        });
    }

    const PlyHeader& header_;
    PlyValues values_;
    MeshDraft& draft_;
    std::vector<std::int64_t> corners_;
    std::vector<StripTriangle> strips_;
    // Of a file that has strips besides: corners in order, and the faces of a corner.
    bool has_strips_ = false;
    std::vector<std::vector<std::int64_t>> faces_;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> faces_of_;
    int bits_ = 53;  ///< of a coordinate
};

}  // namespace

FileMesh read_ply(std::string_view bytes, const std::string& name, const ImportLimits& limits) {
    const std::string_view text = text_in(bytes, name);
    const bool ascii =
        text.substr(0, text.find("end_header")).find("format ascii") != std::string_view::npos;
    MeshDraft draft(name, text.size(), {ascii ? "line" : "byte", 0}, limits);
    const PlyHeader header = read_ply_header(text, draft);
    return PlyReader(header, text, draft).read();
}

}  // namespace lod3d
