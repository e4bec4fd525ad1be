#include "lodlab/core/base/generator.hpp"

#include <cmath>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/from_chars.hpp"
#include "lodlab/core/base/to_chars.hpp"

namespace lod {
namespace {

double parse_value(std::string_view text, std::string_view spec, const std::string& usage,
                   const GeneratorParameter& parameter) {
    const auto about = [&] {
        return "cannot make '" + std::string(spec) + "': " + std::string(parameter.name) + " is '" +
               std::string(text) + "'; ";
    };
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, failure] = from_chars(text.data(), end, value);
    if (failure != std::errc{} || stop != end)
        throw Error(ErrorKind::usage, about() + "write numbers, as in " + usage);
    const bool in_range = value >= parameter.least && value <= parameter.most;
    if (!in_range || (parameter.whole && value != std::floor(value)))
        throw Error(ErrorKind::input_refused,
                    about() + "give a " + (parameter.whole ? "whole " : "") + "number from " +
                        number_text(parameter.least) + " to " + number_text(parameter.most) + " (" +
                        std::string(parameter.meaning) + ")");
    return value;
}

}  // namespace

std::string generator_usage(std::string_view name, std::span<const GeneratorParameter> parameters) {
    std::string text(name);
    char before = ':';
    for (const GeneratorParameter& parameter : parameters) {
        text += before + std::string(parameter.name);
        before = ',';
    }
    return text;
}

std::vector<double> read_generator_values(std::string_view spec,
                                          std::span<const GeneratorParameter> parameters) {
    std::vector<double> values;
    for (const GeneratorParameter& parameter : parameters) values.push_back(parameter.standard);
    const std::size_t colon = spec.find(':');
    if (colon == std::string_view::npos) return values;
    const std::string usage = generator_usage(spec.substr(0, colon), parameters);
    std::string_view rest = spec.substr(colon + 1);
    for (std::size_t i = 0;; ++i) {
        if (i == values.size())
            throw Error(ErrorKind::usage, "cannot make '" + std::string(spec) +
                                              "': too many numbers; write " + usage);
        const std::size_t comma = rest.find(',');
        values[i] = parse_value(rest.substr(0, comma), spec, usage, parameters[i]);
        if (comma == std::string_view::npos) return values;
        rest.remove_prefix(comma + 1);
    }
}

}  // namespace lod
