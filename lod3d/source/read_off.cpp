#include <array>
#include <optional>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod3d/source/mesh_draft.hpp"
#include "lodlab/lod3d/source/text_words.hpp"

namespace lod3d {
namespace {

/// What stands in a vertex, by the letters before OFF: [ST][C][N][4].
struct OffForm {
    int texture = 0;
    int colour = 0;
    int normal = 0;
    int position = 3;
};

/// How the numbers of a file are taken to stand. The format leaves that open in places.
struct OffLayout {
    int counts = 3;         ///< vertices, faces and edges; some programs leave out the edges
    int vertex_values = 3;  ///< numbers of a vertex, its position first
    bool faces_end_lines;   ///< what follows a face on its line, a colour, is no face
};

class OffReader {
  public:
    OffReader(std::string_view text, const std::string& name, const ImportLimits& limits)
        : text_(text),
          words_(text, TextWords::Comments::after_hash),
          name_(name),
          limits_(limits) {}

    /// Tries the layouts, likely ones first; the refusal is that of the likeliest.
    FileMesh read() {
        read_keyword();
        std::optional<lod::Error> refusal;
        for (const int counts : likely_counts())
            for (const int values : likely_vertex_values(counts))
                for (const bool faces_end_lines : {false, true}) {
                    try {
                        return read_as({counts, values, faces_end_lines});
                    } catch (const lod::Error& error) {
                        if (error.kind() != lod::ErrorKind::input_refused) throw;
                        if (!refusal && faces_end_lines) refusal = error;
                    }
                }
        throw lod::Error(*refusal);
    }

  private:
    [[noreturn]] void refuse(const TextWords& at, const std::string& why) const {
        lod::refuse_input(name_ + ", line " + std::to_string(at.line()), why);
    }

    /// The keyword in any case, or none; "OFF8 6 12" has the counts glued to it.
    void read_keyword() {
        const TextWords beginning = words_;
        const std::string_view word = words_.next();
        std::string_view rest = word;
        const auto take = [&](std::string_view letters) {
            if (!is_word(rest.substr(0, letters.size()), letters)) return false;
            rest.remove_prefix(letters.size());
            return true;
        };
        if (take("st")) form_.texture = 2;
        if (take("c")) form_.colour = 4;
        if (word.starts_with("nOFF") || rest.starts_with("4n"))
            refuse(words_, "is of the form nOFF, of any dimension; save it as OFF");
        if (take("n")) form_.normal = 3;
        if (take("4")) form_.position = 4;
        if (!take("off")) {
            form_ = {};
            words_ = beginning;
            if (!integer_in(word))
                refuse(words_, "is no OFF: it begins with " + in_quotes(word) +
                                   " and neither with OFF nor with its counts");
            return;
        }
        words_.step_back(rest.size());
        TextWords after = words_;
        if (is_word(after.next(), "binary"))
            refuse(words_, "is a binary OFF, which is not read; save it as text");
    }

    /// The numbers of the line of counts: three, or two where the edges are left out.
    [[nodiscard]] std::vector<int> likely_counts() const {
        TextWords at = words_;
        if (at.next().empty() || at.next_on_line().empty()) return {3};
        return at.next_on_line().empty() ? std::vector<int>{2, 3} : std::vector<int>{3};
    }

    /// Where every vertex has a line of its own, as many as stand there; else as the keyword says,
    /// with three numbers of a colour or four.
    [[nodiscard]] std::vector<int> likely_vertex_values(int counts) const {
        TextWords at = words_;
        const auto vertices = integer_in(at.next()).value_or(0);
        for (int i = 1; i < counts; ++i) at.next();
        std::vector<int> likely;
        if (const int of_line = values_of_lines(at, vertices); of_line >= form_.position)
            likely.push_back(of_line);
        const int said = form_.position + form_.normal + form_.colour + form_.texture;
        if (likely.empty() || likely[0] != said) likely.push_back(said);
        if (form_.colour > 0) likely.push_back(said - 1);
        return likely;
    }

    /// How many words each of the next lines has, blank ones left out; 0 where they differ.
    [[nodiscard]] static int values_of_lines(TextWords at, std::int64_t lines) {
        constexpr int most = 64;
        int values = 0;
        for (std::int64_t i = 0; i < lines; ++i) {
            if (i % 4096 == 0) lod::check_interrupted();
            int here = at.next().empty() ? 0 : 1;
            while (here > 0 && here <= most && !at.next_on_line().empty()) ++here;
            if (here == 0 || here > most || (i > 0 && here != values)) return 0;
            values = here;
        }
        return values;
    }

    FileMesh read_as(const OffLayout& layout) const {
        MeshDraft draft(name_, text_.size(), {"line", 0}, limits_);
        TextWords words = words_;
        const std::int64_t vertices = count(words, "vertices");
        const std::int64_t faces = count(words, "faces");
        if (layout.counts == 3) count(words, "edges");
        const std::size_t left = text_.size() - words.place() + 1;
        draft.check_promise(static_cast<double>(vertices), 2 * form_.position, left, "vertices");
        draft.check_promise(static_cast<double>(faces), 4, left, "faces");
        draft.check_triangles(static_cast<double>(faces));
        for (std::int64_t i = 0; i < vertices; ++i) add_vertex(words, layout.vertex_values, draft);
        for (std::int64_t i = 0; i < faces; ++i) add_face(words, layout.faces_end_lines, draft);
        std::vector<std::string> remarks;
        if (const std::string_view word = words.next(); !word.empty()) {
            const std::string what =
                "what follows the last face, from line " + std::to_string(words.line());
            if (!layout.faces_end_lines) refuse(words, what + " is not announced");
            remarks.push_back("passed over " + what);
        }
        FileMesh file = draft.finish("its counts announce no faces");
        file.remarks = std::move(remarks);
        return file;
    }

    std::int64_t count(TextWords& words, const char* what) const {
        const std::string_view word = words.next();
        const auto value = integer_in(word);
        if (!value)
            refuse(words, std::string("the number of ") + what + " should stand here, not " +
                              in_quotes(word));
        return *value;
    }

    void add_vertex(TextWords& words, int values, MeshDraft& draft) const {
        std::array<double, 4> position{0, 0, 0, 1};
        std::uint64_t line = 0;
        for (int i = 0; i < values; ++i) {
            const std::string_view word = words.next();
            if (i == 0) line = words.line();
            if (word.empty()) refuse(words, "the file ends within the vertices; is it cut short?");
            if (i >= form_.position) continue;
            const auto value = number_in(word);
            if (!value) refuse(words, "a vertex has " + in_quotes(word) + ", which is no number");
            position[static_cast<std::size_t>(i)] = *value;
            if (i < 3) draft.note_digits(word, *value);
        }
        draft.add_vertex(Point(position[0], position[1], position[2]) / position[3], line);
    }

    void add_face(TextWords& words, bool ends_line, MeshDraft& draft) const {
        const auto next = [&](const char* what) {
            const std::string_view word = words.next();
            if (word.empty()) refuse(words, "the file ends within the faces; is it cut short?");
            const auto value = integer_in(word);
            if (!value)
                refuse(words, std::string("a face has ") + in_quotes(word) + " where " + what +
                                  " should stand");
            return *value;
        };
        const std::int64_t corners = next("the number of its corners");
        const std::uint64_t line = words.line();
        if (corners < 0) refuse(words, "a face has " + std::to_string(corners) + " corners");
        draft.check_triangles(static_cast<double>(corners) - 2);
        std::vector<std::int64_t> face;
        for (std::int64_t k = 0; k < corners; ++k) {
            face.push_back(next("a vertex index"));
            draft.tick();
        }
        draft.add_polygon(face, line);
        if (ends_line) words.skip_line();
    }

    std::string_view text_;
    TextWords words_;  ///< at the counts
    const std::string& name_;
    const ImportLimits& limits_;
    OffForm form_;
};

}  // namespace

FileMesh read_off(std::string_view bytes, const std::string& name, const ImportLimits& limits) {
    const std::string_view text = text_in(bytes, name);
    if (text.empty()) lod::refuse_input(name, "is empty");
    return OffReader(text, name, limits).read();
}

}  // namespace lod3d
