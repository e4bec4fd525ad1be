#include <array>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/source/mesh_draft.hpp"
#include "lodlab/lod3d/source/text_words.hpp"

namespace lod3d {
namespace {

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& name, const ImportLimits& limits)
        : words_(text, TextWords::Comments::after_hash),
          draft_(name, text.size(), {"line", 1}, limits) {}

    FileMesh read() {
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            draft_.tick();
            if (word == "v") vertex();
            if (word == "f" || word == "fo") face();
            if (word == "surf" || word == "curv") free_form_ = true;
            words_.skip_line();
        }
        return draft_.finish(free_form_ ? "free-form surfaces are not read, save it as polygons"
                                        : "its faces should stand in lines that begin with f");
    }

  private:
    /// The statement's next word, also on the next line where a backslash ends this one.
    std::string_view argument() {
        for (;;) {
            std::string_view word = words_.next_on_line();
            if (word.ends_with(';')) return last(word);
            if (!word.ends_with('\\')) return word;
            TextWords rest = words_;
            if (!rest.next_on_line().empty()) return word;
            words_.skip_line();
            word.remove_suffix(1);
            if (!word.empty()) return word;
        }
    }

    /// Of a word at the end of a statement what stands before its semicolon.
    std::string_view last(std::string_view word) {
        TextWords rest = words_;
        if (const std::string_view more = rest.next_on_line(); !more.empty())
            draft_.refuse_at(words_.line(), "has " + in_quotes(more) +
                                                " after a semicolon; begin a new line there");
        word.remove_suffix(1);
        return word;
    }

    void vertex() {
        const std::uint64_t line = words_.line();
        std::array<double, 4> values{0, 0, 0, 1};
        std::size_t count = 0;
        for (std::string_view word = argument(); !word.empty(); word = argument()) {
            if (count < values.size()) {
                const auto value = number_in(word);
                if (!value && count < 3)
                    draft_.refuse_at(words_.line(),
                                     "a vertex has " + in_quotes(word) + ", which is no number");
                values[count] = value.value_or(1);
                if (count < 3) draft_.note_digits(word, values[count]);
            }
            ++count;
        }
        if (count < 3)
            draft_.refuse_at(line, "a vertex has " + std::to_string(count) +
                                       " numbers; three are needed, x y z");
        const double weight = count == 4 ? values[3] : 1;  // more numbers are a colour
        draft_.add_vertex(Point(values[0], values[1], values[2]) / weight, line);
    }

    void face() {
        const std::uint64_t line = words_.line();
        corners_.clear();
        for (std::string_view word = argument(); !word.empty(); word = argument()) {
            corners_.push_back(corner(word));
            draft_.check_triangles(static_cast<double>(corners_.size()) - 2);
            draft_.tick();
        }
        draft_.add_polygon(corners_, line);
    }

    /// Of v, v/vt, v//vn or v/vt/vn, counted from 0.
    std::int64_t corner(std::string_view word) {
        const auto index = integer_in(word.substr(0, word.find('/')));
        if (!index)
            draft_.refuse_at(words_.line(), "a face has " + in_quotes(word) +
                                                ", which begins with no vertex index");
        if (*index == 0)
            draft_.refuse_at(words_.line(),
                             "a face names the vertex index 0; OBJ numbers vertices from 1");
        if (*index > 0) return *index - 1;
        if (*index < -draft_.vertices())
            draft_.refuse_at(words_.line(), "a face names the vertex index " +
                                                std::to_string(*index) + ", but only " +
                                                std::to_string(draft_.vertices()) +
                                                " vertices stand before it");
        return draft_.vertices() + *index;
    }

    TextWords words_;
    MeshDraft draft_;
    std::vector<std::int64_t> corners_;
    bool free_form_ = false;
};

}  // namespace

FileMesh read_obj(std::string_view bytes, const std::string& name, const ImportLimits& limits) {
    return ObjReader(text_in(bytes, name), name, limits).read();
}

}  // namespace lod3d
