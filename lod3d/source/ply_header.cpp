#include "lodlab/lod3d/source/ply_header.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod3d/source/text_words.hpp"

namespace lod3d {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};

constexpr std::array<TypeName, 18> type_names{{{"char", PlyType::int8},
                                               {"int8", PlyType::int8},
                                               {"uchar", PlyType::uint8},
                                               {"uint8", PlyType::uint8},
                                               {"short", PlyType::int16},
                                               {"int16", PlyType::int16},
                                               {"ushort", PlyType::uint16},
                                               {"uint16", PlyType::uint16},
                                               {"int", PlyType::int32},
                                               {"int32", PlyType::int32},
                                               {"uint", PlyType::uint32},
                                               {"uint32", PlyType::uint32},
                                               {"int64", PlyType::int64},
                                               {"uint64", PlyType::uint64},
                                               {"float", PlyType::float32},
                                               {"float32", PlyType::float32},
                                               {"double", PlyType::float64},
                                               {"float64", PlyType::float64}}};

class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, const MeshDraft& draft)
        : bytes_(bytes), words_(bytes, TextWords::Comments::none), draft_(draft) {}

    PlyHeader read() {
        const std::string_view magic = words_.next();
        if (!is_word(magic, "ply")) draft_.refuse("is no PLY: it does not begin with \"ply\"");
        const std::size_t after_magic = words_.place();
        for (;;) {
            lod::check_interrupted();
            words_.skip_line();
            const std::string_view word = words_.next();
            if (word.empty()) draft_.refuse("the header does not end; is the file cut short?");
            if (word == "end_header") break;
            statement(word);
        }
        if (!has_format_) draft_.refuse("the header names no format; add \"format ascii 1.0\"");
        end_header(after_magic);
        return std::move(header_);
    }

  private:
    [[noreturn]] void refuse_line(const std::string& why) const {
        lod::refuse_input(draft_.name() + ", line " + std::to_string(words_.line()), why);
    }

    void statement(std::string_view word) {
        if (word == "format") return format();
        if (word == "element") return element();
        if (word == "property") return property();
        if (word == "comment" || word == "obj_info") return;
        refuse_line("the header has " + in_quotes(word) +
                    ", which is neither format, element, property nor comment");
    }

    void format() {
        const std::string_view word = words_.next_on_line();
        has_format_ = true;
        if (word == "ascii")
            header_.format = PlyFormat::ascii;
        else if (word == "binary_little_endian")
            header_.format = PlyFormat::little_endian;
        else if (word == "binary_big_endian")
            header_.format = PlyFormat::big_endian;
        else
            refuse_line("the format " + in_quotes(word) +
                        " is none of ascii, binary_little_endian and binary_big_endian");
    }

    void element() {
        PlyElement element;
        element.name = words_.next_on_line();
        const std::string_view count = words_.next_on_line();
        const auto value = integer_in(count);
        if (element.name.empty() || !value)
            refuse_line("an element needs a name and a count, which " + in_quotes(count) +
                        " is not");
        if (*value < 0) draft_.refuse("the header promises a negative number of " + element.name);
        element.count = *value;
        add_to_size();
        header_.elements.push_back(std::move(element));
    }

    void property() {
        if (header_.elements.empty()) refuse_line("a property stands before all elements");
        PlyProperty property;
        std::string_view word = words_.next_on_line();
        if (word == "list") {
            property.count_type = type_in(words_.next_on_line());
            word = words_.next_on_line();
        }
        property.type = type_in(word);
        property.name = words_.next_on_line();
        if (property.name.empty()) refuse_line("a property has no name");
        add_to_size();
        header_.elements.back().properties.push_back(std::move(property));
    }

    PlyType type_in(std::string_view word) const {
        const auto found = std::find_if(type_names.begin(), type_names.end(),
                                        [&](const TypeName& one) { return one.name == word; });
        if (found == type_names.end())
            refuse_line(
                "a property has the type " + in_quotes(word) +
                "; PLY has char to double and int8 to float64, some programs int64 and uint64");
        return found->type;
    }

    /// Keeps the header itself from taking memory without end.
    void add_to_size() {
        constexpr int most = 10'000;
        if (++size_ > most)
            draft_.exceed("the header has more than " + std::to_string(most) +
                          " elements and properties; leave out what is not needed");
    }

    /// The line end after end_header is one of those that the header has: a CR alone may be
    /// followed by a byte of data that reads as LF.
    void end_header(std::size_t after_magic) {
        const std::size_t after = words_.place();
        words_.skip_line();
        header_.end = words_.place();
        const auto cr_alone = [&](std::size_t at) {
            return bytes_.substr(at).starts_with("\r") && !bytes_.substr(at).starts_with("\r\n");
        };
        if (cr_alone(after_magic) && bytes_.substr(after).starts_with("\r"))
            header_.end = after + 1;
        header_.lines = words_.line() - 1;
    }

    std::string_view bytes_;
    TextWords words_;
    const MeshDraft& draft_;
    PlyHeader header_;
    bool has_format_ = false;
    int size_ = 0;
};

/// The fewest bytes of one of an element.
double least_size(const PlyElement& element, PlyFormat format) {
    double bytes = 0;
    for (const PlyProperty& property : element.properties)
        bytes += format == PlyFormat::ascii
                     ? 2  // a digit and what separates it
                     : static_cast<double>(
                           size_of(property.is_list() ? property.count_type : property.type));
    return bytes;
}

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::none:
            return 0;
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::int64:
        case PlyType::uint64:
        case PlyType::float64:
            return 8;
    }
    return 0;
}

PlyHeader read_ply_header(std::string_view bytes, const MeshDraft& draft) {
    PlyHeader header = HeaderReader(bytes, draft).read();
    const std::size_t left = bytes.size() - header.end + 1;  // the last line may have no end
    for (const PlyElement& element : header.elements) {
        const auto count = static_cast<double>(element.count);
        const double each = least_size(element, header.format);
        if (each > 0) draft.check_promise(count, each, left, "of element " + element.name);
        if (element.name == "face") draft.check_triangles(count);
    }
    return header;
}

}  // namespace lod3d
