#include "cli/arguments/named_files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/lod2d/source/load.hpp"
#include "lodlab/lod2d/source/svg/source.hpp"
#include "lodlab/lod3d/source/binary_number.hpp"
#include "lodlab/scenes/places.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

constexpr std::size_t most_bytes = std::size_t{1} << 30;
constexpr std::size_t most_of_library = std::size_t{1} << 24;
constexpr std::string_view blanks = " \t\v\f";

/// "%20" as a blank.
std::string without_percents(const std::string& address) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string name;
    for (std::size_t i = 0; i < address.size(); ++i) {
        const auto digit = [&](std::size_t at) {
            const char c = at < address.size() ? address[at] : ' ';
            return digits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
        };
        const bool is_byte = address[i] == '%' && digit(i + 1) != std::string_view::npos &&
                             digit(i + 2) != std::string_view::npos;
        name += is_byte ? static_cast<char>(16 * digit(i + 1) + digit(i + 2)) : address[i];
        if (is_byte) i += 2;
    }
    return name;
}

/// What a line holds from each of its words on: names may have blanks, and options before them.
void add_ends_of_line(std::string_view line, Names& names) {
    while (!line.empty() && (blanks.find(line.back()) != std::string_view::npos))
        line.remove_suffix(1);
    while (!line.empty()) {
        const std::size_t begin = line.find_first_not_of(blanks);
        if (begin == std::string_view::npos) return;
        line.remove_prefix(begin);
        names.emplace_back(line);
        const std::size_t end = std::min(line.find_first_of(blanks), line.size());
        names.emplace_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

/// The names in the lines that begin so, in any case; with no beginning, in all.
Names names_in_lines(std::string_view text, std::string_view beginning) {
    Names names;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        std::string_view line = text.substr(0, end);
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        text.remove_prefix(std::min(end + 1, text.size()));
        const bool wanted =
            line.size() >= beginning.size() &&
            std::equal(beginning.begin(), beginning.end(), line.begin(), [](char a, char b) {
                return (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b) == a;
            });
        if (wanted) add_ends_of_line(line.substr(beginning.size()), names);
    }
    return names;
}

/// Every text of a glTF file that is called an address.
Names names_in_gltf(const std::string& text) {
    constexpr std::size_t glb_header = 20;
    const bool binary = text.starts_with("glTF") && text.size() > glb_header;
    const std::size_t begin = binary ? glb_header : 0;
    const std::size_t size = binary ? lod3d::binary_number<std::uint32_t>(text, 12) : text.size();
    Names names;
    const auto json =
        nlohmann::json::parse(std::string_view(text).substr(begin, size), nullptr, false);
    std::vector<const nlohmann::json*> waiting{&json};
    while (!waiting.empty()) {
        const nlohmann::json& at = *waiting.back();
        waiting.pop_back();
        if (at.is_object() && at.contains("uri") && at["uri"].is_string())
            names.push_back(at["uri"].get<std::string>());
        if (at.is_structured())
            for (const auto& inner : at) waiting.push_back(&inner);
    }
    return names;
}

/// Whether what stands before a quote or a bracket says that an address follows.
bool address_follows(std::string_view before) {
    constexpr std::size_t looked_at = 24;
    if (before.size() > looked_at) before.remove_prefix(before.size() - looked_at);
    while (!before.empty() && std::string_view(" \t\r\n\"'(=").find(before.back()) != before.npos)
        before.remove_suffix(1);
    return std::ranges::any_of(
        std::array<std::string_view, 5>{"href", "src", "url", "@import", "SYSTEM"},
        [&](std::string_view word) { return before.ends_with(word); });
}

/// Entities that stand for one letter, by name or number.
std::string without_entities(const std::string& text) {
    constexpr std::array<std::pair<std::string_view, char>, 5> named{
        {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
    std::string plain;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t end = text[at] == '&' ? text.find(';', at) : std::string::npos;
        const std::string entity =
            end == std::string::npos ? "" : text.substr(at + 1, end - at - 1);
        const auto known = std::ranges::find(named, std::string_view(entity),
                                             &std::pair<std::string_view, char>::first);
        int number = known != named.end() ? known->second : 0;
        const bool hexadecimal = entity.starts_with("#x");
        if (entity.starts_with("#")) {
            const char* digits = entity.data() + (hexadecimal ? 2 : 1);
            std::from_chars(digits, entity.data() + entity.size(), number, hexadecimal ? 16 : 10);
        }
        const bool is_letter = number > 0 && number < 128;
        plain += is_letter ? static_cast<char>(number) : text[at];
        if (is_letter) at = end;
    }
    return plain;
}

Names names_in_xml(std::string_view text) {
    constexpr std::string_view around = "\"'()";
    Names names;
    for (std::size_t begin = text.find_first_of(around); begin != text.npos;
         begin = text.find_first_of(around, begin + 1)) {
        const std::size_t end = text.find_first_of(around, begin + 1);
        if (end != text.npos && end > begin + 1 && address_follows(text.substr(0, begin + 1)))
            names.push_back(without_entities(std::string(text.substr(begin + 1, end - begin - 1))));
    }
    return names;
}

Names names_in(const std::string& text, std::string_view ending) {
    if (ending == "gltf" || ending == "glb") return names_in_gltf(text);
    if (lod2d::is_drawing_format(ending)) return names_in_xml(text);
    if (ending == "obj") return names_in_lines(text, "mtllib");
    if (ending == "ply")
        return names_in_lines(text.substr(0, text.find("end_header")), "comment texturefile");
    if (ending == "mtl") return names_in_lines(text, "");
    return {};
}

std::string text_of(const fs::path& file, std::string_view ending) {
    std::string text = lod::read_text_file(file, ending == "mtl" ? most_of_library : most_bytes);
    return lod2d::is_drawing_format(ending) ? lod2d::svg_source(file.string(), text, most_bytes)
                                            : text;
}

bool is_named_in(const fs::path& input, const fs::path& file, bool is_library) {
    const std::string ending = is_library ? "mtl" : lod::ending_of(input);
    std::string text;
    try {
        text = text_of(input, ending);
    } catch (const lod::Error&) {
        return false;  // whoever reads it says what is wrong
    }
    const fs::path folder = input.parent_path();
    std::error_code ignored;
    if (text.find(file.filename().string()) != std::string::npos) {
        const fs::path inside = file.lexically_relative(fs::canonical(folder, ignored));
        if (!inside.empty() && *inside.begin() != "..") return true;
    }
    for (std::string name : names_in(text, ending)) {
        std::ranges::replace(name, '\\', '/');
        for (const std::string& spelling : {name, without_percents(name)}) {
            if (spelling.find('\0') != std::string::npos) continue;
            const fs::path named = folder / spelling;
            if (fs::equivalent(named, file, ignored)) return true;
            if (ending == "obj" && fs::is_regular_file(named, ignored) &&
                is_named_in(named, file, true))
                return true;
        }
    }
    return false;
}

}  // namespace

bool names_file(const fs::path& input, const fs::path& file) {
    std::error_code ignored;
    const std::string ending = lod::ending_of(input);
    const bool may_name = ending == "gltf" || ending == "glb" || ending == "obj" ||
                          ending == "ply" || ending == "3ds" || lod2d::is_drawing_format(ending);
    if (!may_name || !fs::exists(file, ignored)) return false;
    // Readers look beside the name that they are given, which may be a link.
    return is_named_in(fs::absolute(input), file, false) ||
           (fs::is_symlink(input, ignored) &&
            is_named_in(fs::canonical(input, ignored), file, false));
}

}  // namespace cli
