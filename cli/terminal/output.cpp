#include "cli/terminal/output.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <nlohmann/json.hpp>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/to_chars.hpp"

namespace cli {

void print(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw lod::Error(lod::ErrorKind::output_failed, std::string("cannot write the result: ") +
                                                            std::strerror(errno) +
                                                            "; send it elsewhere");
}

void print(const nlohmann::ordered_json& json) {
    // A name need not be UTF-8.
    print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void remark(const std::string& line) {
    std::string text = line;
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::cerr << "lodlab: " << text << '\n';
}

void remark_all(std::span<const std::string> lines) {
    constexpr std::size_t most = 5;
    const std::size_t shown = lines.size() <= most + 1 ? lines.size() : most;
    for (const std::string& line : lines.first(shown)) remark(line);
    if (shown < lines.size())
        remark("and " + std::to_string(lines.size() - shown) + " more like the last");
}

std::string readable(double number, int digits) {
    return lod::number_text(number, std::chars_format::general, digits);
}

std::string right(const std::string& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

}  // namespace cli
