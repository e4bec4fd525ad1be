#include "lodlab/scenes/trace/trace_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lodlab/core/math/bit_hash.hpp"
#include "lodlab/scenes/trace/trace.hpp"

namespace scenes {
namespace {

constexpr std::uint64_t most_bytes = 500'000'000;  // at once
constexpr std::uint64_t block = 65536;

std::string check_of(std::string_view text) {
    lod::BitHash hash;
    hash.add(text);
    return ",\"check\":\"" + hexadecimal(hash.value()) + "\"";
}

/// What stands in place of an object's braces, so that all lines are one document.
struct Place {
    std::string_view opening;
    std::string_view closing;
};
Place place_of(TraceLine line) {
    constexpr Place places[] = {
        {"{", ",\"entries\":["}, {"{", "},"}, {"null],\"end\":{", "},"}, {"\"index\":{", "}}"}};
    return places[static_cast<std::size_t>(line)];
}

}  // namespace

std::string TraceText::bytes(std::uint64_t begin, std::uint64_t end) {
    if (end - begin > most_bytes)
        throw std::runtime_error(std::to_string(end - begin) +
                                 " bytes without a frame whose bodies it tells, the limit is " +
                                 std::to_string(most_bytes));
    std::string text(static_cast<std::size_t>(end - begin), '\0');
    in_->clear();
    in_->seekg(static_cast<std::streamoff>(begin));
    if (!in_->read(text.data(), static_cast<std::streamsize>(text.size())))
        throw std::runtime_error("byte " + std::to_string(begin) + " and what follows are gone");
    return text;
}

std::string TraceText::first_line() {
    std::string line;
    for (std::uint64_t end = 0; end < std::min(size_, most_bytes);) {
        const std::uint64_t begin = end;
        end = std::min(size_, begin + block);
        line += bytes(begin, end);
        const std::size_t newline = line.find('\n', static_cast<std::size_t>(begin));
        if (newline != std::string::npos) return line.substr(0, newline);
    }
    return {};
}

std::string TraceText::last_line() {
    std::string line;
    for (std::uint64_t begin = size_; begin > 0 && size_ - begin < most_bytes;) {
        const std::uint64_t end = begin;
        begin = end - std::min(end, block);
        line.insert(0, bytes(begin, end));
        if (line.back() != '\n') return {};
        if (line.size() < 2) continue;
        const std::size_t newline = line.rfind('\n', line.size() - 2);
        if (newline != std::string::npos)
            return line.substr(newline + 1, line.size() - newline - 2);
    }
    return {};
}

std::string checked_line(const nlohmann::ordered_json& object, TraceLine line) {
    using Handler = nlohmann::ordered_json::error_handler_t;
    std::string text = object.dump(-1, ' ', false, Handler::replace);  // a name
    text.pop_back();                                                   // the closing brace
    const auto [opening, closing] = place_of(line);
    std::string placed(opening);
    placed.append(text, 1).append(check_of(text)).append(closing);
    return placed + "\n";
}

nlohmann::ordered_json object_of(std::string_view checked_line, TraceLine line) {
    const auto [opening, closing] = place_of(line);
    const std::size_t length = check_of({}).size();
    if (checked_line.size() <= opening.size() + length + closing.size() ||
        !checked_line.starts_with(opening) || !checked_line.ends_with(closing))
        throw std::invalid_argument("a line is cut short");
    checked_line.remove_suffix(closing.size());
    std::string object = "{";
    object += checked_line.substr(opening.size());
    const std::string_view text(object.data(), object.size() - length);
    if (object.compare(text.size(), length, check_of(text)) != 0)
        throw std::invalid_argument("a line does not fit its check");
    return nlohmann::ordered_json::parse(object + "}");
}

}  // namespace scenes
