#include "lodlab/core/base/error.hpp"

#include <algorithm>
#include <utility>

namespace lod {

namespace {

std::string without_controls(std::string line) {
    const auto is_control = [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7f;
    };
    std::replace_if(line.begin(), line.end(), is_control, ' ');
    return line;
}

}  // namespace

Error::Error(ErrorKind kind, std::string line)
    : std::runtime_error(without_controls(std::move(line))), kind_(kind) {}

void refuse_input(const std::string& name, const std::string& why) {
    throw Error(ErrorKind::input_refused, name + ": " + why);
}

void refuse_choice(std::string_view what, std::string_view name,
                   std::span<const std::string_view> names) {
    std::string line = "no ";
    line.append(what).append(" is called \"").append(name).append("\"; choose ");
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) line += i + 1 < names.size() ? ", " : " or ";
        line += names[i];
    }
    throw Error(ErrorKind::usage, line);
}

}  // namespace lod
