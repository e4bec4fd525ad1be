#include "lodlab/lod2d/source/svg/source.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/utf8.hpp"

namespace lod2d {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& why,
                         lod::ErrorKind kind = lod::ErrorKind::input_refused) {
    throw lod::Error(kind, "cannot read " + name + ": " + why);
}

std::string unpacked(const std::string& name, std::string_view bytes, std::size_t most_bytes) {
    z_stream stream{};
    constexpr int gzip_with_largest_window = 15 + 16;
    if (inflateInit2(&stream, gzip_with_largest_window) != Z_OK)
        refuse(name, "no memory to unpack it; unpack it with gunzip first");
    std::string copy(bytes);  // zlib reads through a pointer that is not const
    stream.next_in = reinterpret_cast<Bytef*>(copy.data());
    stream.avail_in = static_cast<uInt>(copy.size());
    std::string text;
    std::string block(1 << 16, '\0');
    int status = Z_OK;
    while (status == Z_OK && text.size() <= most_bytes) {
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        status = inflate(&stream, Z_NO_FLUSH);
        text.append(block, 0, block.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    if (text.size() > most_bytes)
        refuse(name,
               "unpacked it has more than " + std::to_string(most_bytes) +
                   " bytes; simplify it or raise the limit",
               lod::ErrorKind::limit_exceeded);
    if (status != Z_STREAM_END)
        refuse(name, "it is compressed and broken; try gunzip, or save it again");
    return text;
}

void append_utf8(std::uint32_t code, std::string& text) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) return put(code);
    if (code < 0x800) {
        put(0xC0 | code >> 6);
    } else if (code < 0x10000) {
        put(0xE0 | code >> 12);
        put(0x80 | (code >> 6 & 0x3F));
    } else {
        put(0xF0 | code >> 18);
        put(0x80 | (code >> 12 & 0x3F));
        put(0x80 | (code >> 6 & 0x3F));
    }
    put(0x80 | (code & 0x3F));
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
    const auto unit = [&](std::size_t i) {
        const auto first = static_cast<std::uint8_t>(bytes[i]);
        const auto second = static_cast<std::uint8_t>(bytes[i + 1]);
        return static_cast<std::uint32_t>(big_endian ? first << 8 | second : second << 8 | first);
    };
    std::string text;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        std::uint32_t code = unit(i);
        const bool leads = code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size();
        if (leads && unit(i + 2) >= 0xDC00 && unit(i + 2) < 0xE000) {
            code = 0x10000 + ((code - 0xD800) << 10) + (unit(i + 2) - 0xDC00);
            i += 2;
        }
        append_utf8(code, text);
    }
    return text;
}

/// The encoding that the XML declaration names, in lower case.
std::string declared_encoding(std::string_view text) {
    if (!text.starts_with("<?xml")) return {};
    const std::string_view head = text.substr(0, text.find("?>"));
    const std::size_t at = head.find("encoding");
    const std::size_t open = head.find_first_of("'\"", at);
    if (at == std::string_view::npos || open == std::string_view::npos) return {};
    std::string name(head.substr(open + 1, head.find(head[open], open + 1) - open - 1));
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
}

/// Bytes that are no UTF-8 are taken as Latin-1: of a drawing only its ASCII matters.
std::string with_valid_utf8(std::string_view text) {
    const bool latin = declared_encoding(text).starts_with("iso-8859");
    std::string valid;
    valid.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = latin ? (text[i] & 0x80 ? 0 : 1) : lod::utf8_length(text, i);
        if (length == 0)
            append_utf8(static_cast<std::uint8_t>(text[i]), valid);
        else
            valid.append(text.substr(i, length));
        i += std::max<std::size_t>(length, 1);
    }
    return valid;
}

constexpr std::string_view spaces = " \t\r\n";

/// The text between quotes at the start of `text`, and drops it from there.
std::string quoted(std::string_view& text) {
    const std::size_t open = text.find_first_not_of(spaces);
    if (open == std::string_view::npos || (text[open] != '"' && text[open] != '\'')) return {};
    const std::size_t close = text.find(text[open], open + 1);
    std::string inside(text.substr(open + 1, close - open - 1));
    text.remove_prefix(std::min(close, text.size() - 1) + 1);
    return inside;
}

}  // namespace

std::string svg_source(const std::string& name, std::string_view bytes, std::size_t most_bytes) {
    std::string unpacked_bytes;
    if (bytes.starts_with("\x1f\x8b")) {
        unpacked_bytes = unpacked(name, bytes, most_bytes);
        bytes = unpacked_bytes;
    }
    if (bytes.empty()) refuse(name, "the file is empty");
    std::string text;
    if (bytes.starts_with("\xFE\xFF") || bytes.starts_with(std::string_view("\0<", 2)))
        text = from_utf16(bytes, true);
    else if (bytes.starts_with("\xFF\xFE") || bytes.starts_with(std::string_view("<\0", 2)))
        text = from_utf16(bytes, false);
    else
        text = with_valid_utf8(bytes);
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    if (text.find('<') == std::string::npos) refuse(name, "it is no SVG file");
    return text;
}

std::vector<SvgEntity> svg_entities(std::string_view source) {
    std::vector<SvgEntity> entities;
    const std::size_t doctype = source.find("<!DOCTYPE");
    if (doctype == std::string_view::npos) return entities;
    std::string_view rest = source.substr(doctype);
    const std::size_t open = rest.find_first_of("[>");
    if (open == std::string_view::npos || rest[open] == '>') return entities;
    rest.remove_prefix(open + 1);
    while (true) {
        const std::size_t at = rest.find_first_of("<]");
        if (at == std::string_view::npos || rest[at] == ']') return entities;
        rest.remove_prefix(at);
        if (rest.starts_with("<!--")) {
            rest.remove_prefix(std::min(rest.find("-->"), rest.size()));
            continue;
        }
        constexpr std::string_view opening = "<!ENTITY";
        if (!rest.starts_with(opening)) {
            rest.remove_prefix(std::min(rest.find('>'), rest.size()));
            continue;
        }
        rest.remove_prefix(opening.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(spaces), rest.size()));
        const std::size_t end = std::min(rest.find_first_of(spaces), rest.size());
        SvgEntity entity{std::string(rest.substr(0, end)), {}, false};
        rest.remove_prefix(end);
        rest.remove_prefix(std::min(rest.find_first_not_of(spaces), rest.size()));
        entity.outside = rest.starts_with("SYSTEM") || rest.starts_with("PUBLIC");
        if (!entity.outside) entity.text = quoted(rest);
        const bool known = std::ranges::any_of(
            entities, [&](const SvgEntity& other) { return other.name == entity.name; });
        if (!known && entity.name != "%") entities.push_back(std::move(entity));
    }
}

std::string svg_place(std::string_view source, std::size_t offset) {
    const std::string_view before = source.substr(0, offset);
    const auto line = std::ranges::count(before, '\n') + 1;
    const std::size_t last_break = before.rfind('\n');
    const std::size_t column =
        last_break == std::string_view::npos ? offset + 1 : offset - last_break;
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

}  // namespace lod2d
