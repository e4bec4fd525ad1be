#include <algorithm>
#include <array>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/source/binary_number.hpp"
#include "lodlab/lod3d/source/mesh_draft.hpp"
#include "lodlab/lod3d/source/text_words.hpp"

namespace lod3d {
namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t record_size = 50;  // normal, three corners, two bytes more
constexpr std::size_t count_place = 80;

std::uint32_t promised(std::string_view bytes) {
    return binary_number<std::uint32_t>(bytes, count_place);
}

Point corner_at(std::string_view bytes, std::size_t record, std::size_t which) {
    const std::size_t at = record + 12 * (which + 1);
    return {binary_number<float>(bytes, at), binary_number<float>(bytes, at + 4),
            binary_number<float>(bytes, at + 8)};
}

/// Whether a file is one of text: no byte at its beginning is one that texts don't have.
bool is_text(std::string_view bytes) {
    constexpr std::size_t looked_at = 512;
    const std::string_view looked = bytes.substr(0, looked_at);
    return std::none_of(looked.begin(), looked.end(), [](char c) {
        return static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r' &&
               c != '\v' && c != '\f';
    });
}

/// Whether bytes after the last promised record are records of triangles, and not something else.
bool are_triangles(std::string_view bytes, std::size_t first) {
    if (bytes.size() <= first || (bytes.size() - first) % record_size != 0) return false;
    for (std::size_t record = first; record < bytes.size(); record += record_size) {
        const Point a = corner_at(bytes, record, 0);
        const Point b = corner_at(bytes, record, 1);
        const Point c = corner_at(bytes, record, 2);
        if (!is_usable(a) || !is_usable(b) || !is_usable(c) || a == b || b == c || c == a)
            return false;
    }
    return true;
}

// ---- binary ----

/// How many records to read. Refuses a count that the file does not bear out; where none is
/// promised, the records that are there count.
std::size_t count_records(std::string_view bytes, const MeshDraft& draft,
                          std::vector<std::string>& remarks) {
    const std::uint64_t count = promised(bytes);
    const std::uint64_t there = (bytes.size() - header_size) / record_size;
    if (count > there)
        draft.refuse("the header promises " + std::to_string(count) + " triangles, but its " +
                     std::to_string(bytes.size()) + " bytes hold " + std::to_string(there) +
                     "; is the file cut short? Save it again, or mend the count (bytes 80 to 83)");
    const std::size_t end = header_size + static_cast<std::size_t>(count) * record_size;
    if (end == bytes.size()) return static_cast<std::size_t>(count);
    if (are_triangles(bytes, end)) {
        if (count > 0)
            draft.refuse("the header promises " + std::to_string(count) +
                         " triangles, but there are " + std::to_string(there) +
                         "; mend the count (bytes 80 to 83), or cut the file after byte " +
                         std::to_string(end));
        remarks.push_back("the header promises 0 triangles; the " + std::to_string(there) +
                          " that are there were read");
        return static_cast<std::size_t>(there);
    }
    remarks.push_back("passed over " + std::to_string(bytes.size() - end) +
                      " bytes after the last triangle");
    return static_cast<std::size_t>(count);
}

FileMesh read_binary(std::string_view bytes, const std::string& name, const ImportLimits& limits) {
    MeshDraft draft(name, bytes.size(), {"byte", 0}, limits);
    if (bytes.size() < header_size)
        draft.refuse(
            "is no STL: it begins with no \"solid\", as a text would, and is shorter than "
            "the header of a binary file");
    std::vector<std::string> remarks;
    const std::size_t count = count_records(bytes, draft, remarks);
    draft.check_triangles(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t record = header_size + i * record_size;
        const std::int64_t first = draft.vertices();
        for (std::size_t k = 0; k < 3; ++k)
            draft.add_vertex(corner_at(bytes, record, k), record + 12 * (k + 1));
        draft.add_polygon(std::array{first, first + 1, first + 2}, record);
    }
    FileMesh file = draft.finish("its header promises none");
    file.step = coordinate_step(file.mesh, 24);
    file.remarks = std::move(remarks);
    return file;
}

// ---- text ----

class StlTextReader {
  public:
    StlTextReader(std::string_view text, const std::string& name, const ImportLimits& limits)
        : words_(text, TextWords::Comments::none), draft_(name, text.size(), {"line", 0}, limits) {}

    FileMesh read() {
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            draft_.tick();
            if (is_word(word, "solid") && !in_facet_)
                pass_name();
            else if (is_word(word, "endsolid"))
                words_.skip_line();
            else if (is_word(word, "facet"))
                begin_facet();
            else if (is_word(word, "vertex"))
                vertex();
            else if (is_word(word, "endfacet"))
                end_facet();
            else if (is_word(word, "end"))
                end();
        }
        if (in_facet_)
            draft_.refuse_at(facet_line_, "the file ends within this facet; is it cut short?");
        return draft_.finish("its triangles should stand between \"facet\" and \"endfacet\"");
    }

  private:
    /// The rest of a line that begins with "solid", unless the first facet stands on it.
    void pass_name() {
        for (TextWords rest = words_;;) {
            const TextWords here = rest;
            const std::string_view word = rest.next_on_line();
            if (word.empty()) return words_.skip_line();
            TextWords after = rest;
            if (!is_word(word, "facet") || !is_word(after.next_on_line(), "normal") ||
                !number_in(after.next_on_line()))
                continue;
            words_ = here;
            return;
        }
    }

    /// In two words: "end facet", "end loop", "end solid".
    void end() {
        TextWords rest = words_;
        const std::string_view what = rest.next_on_line();
        if (is_word(what, "solid")) return words_.skip_line();
        if (!is_word(what, "facet") && !is_word(what, "loop")) return;
        words_ = rest;
        if (is_word(what, "facet")) end_facet();
    }

    void begin_facet() {
        if (in_facet_)
            draft_.refuse_at(facet_line_, "a facet does not end before the next; add \"endfacet\"");
        in_facet_ = true;
        facet_line_ = words_.line();
        corners_.clear();
    }

    void vertex() {
        if (!in_facet_) draft_.refuse_at(words_.line(), "a vertex stands outside all facets");
        const std::uint64_t line = words_.line();
        Point p;
        for (int d = 0; d < 3; ++d) {
            const std::string_view word = words_.next();
            const auto value = number_in(word);
            if (!value)
                draft_.refuse_at(words_.line(),
                                 word.empty()
                                     ? "the file ends within a vertex; is it cut short?"
                                     : "a vertex has " + in_quotes(word) + ", which is no number");
            p[d] = *value;
            draft_.note_digits(word, *value);
        }
        corners_.push_back(draft_.vertices());
        draft_.add_vertex(p, line);
    }

    void end_facet() {
        if (!in_facet_) draft_.refuse_at(words_.line(), "\"endfacet\" without a facet");
        if (corners_.size() < 3)
            draft_.refuse_at(facet_line_, "a facet has " + std::to_string(corners_.size()) +
                                              " corners; three are needed");
        draft_.add_polygon(corners_, facet_line_);
        in_facet_ = false;
    }

    TextWords words_;
    MeshDraft draft_;
    bool in_facet_ = false;
    std::uint64_t facet_line_ = 0;
    std::vector<std::int64_t> corners_;
};

}  // namespace

FileMesh read_stl(std::string_view bytes, const std::string& name, const ImportLimits& limits) {
    const bool fits = bytes.size() >= header_size &&
                      header_size + record_size * std::uint64_t{promised(bytes)} == bytes.size();
    if (fits || !is_text(bytes)) {
        if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
            static_cast<void>(text_in(bytes, name));  // refuses it
        return read_binary(bytes, name, limits);
    }
    const std::string_view text = text_in(bytes, name);
    const std::string_view first = TextWords(text, TextWords::Comments::none).next();
    if (!is_word(first, "solid") && !bytes.empty())
        lod::refuse_input(name, "is a text but no STL: it begins with " + in_quotes(first) +
                                    " and not with \"solid\"");
    return StlTextReader(text, name, limits).read();
}

}  // namespace lod3d
