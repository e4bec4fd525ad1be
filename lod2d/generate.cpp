#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "lod2d/generators.hpp"

namespace lod2d {
namespace {

std::string list_of_names() {
    std::string list;
    for (const Generator& generator : generators())
        list += (list.empty() ? "" : ", ") + std::string(generator.name);
    return list;
}

const Generator* find(std::string_view spec) {
    const std::string_view name = spec.substr(0, spec.find(':'));
    for (const Generator& generator : generators())
        if (generator.name == name) return &generator;
    return nullptr;
}

std::string short_number(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return std::string(text, end);
}

double parse_value(std::string_view text, std::string_view spec, const Generator& generator,
                   const GeneratorParameter& parameter) {
    const auto about = [&] {
        return "cannot make '" + std::string(spec) + "': " + std::string(parameter.name) + " is '" +
               std::string(text) + "'; ";
    };
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, value);
    if (failure != std::errc{} || stop != end)
        throw lod::Error(lod::ErrorKind::usage,
                         about() + "write numbers, as in " + usage(generator));
    const bool in_range = value >= parameter.least && value <= parameter.most;
    if (!in_range || (parameter.whole && value != std::floor(value)))
        throw lod::Error(lod::ErrorKind::input_refused,
                         about() + "give a " + (parameter.whole ? "whole " : "") + "number from " +
                             short_number(parameter.least) + " to " + short_number(parameter.most) +
                             " (" + std::string(parameter.meaning) + ")");
    return value;
}

std::vector<double> parse_values(std::string_view spec, const Generator& generator) {
    std::vector<double> values;
    for (const GeneratorParameter& parameter : generator.parameters)
        values.push_back(parameter.standard);
    if (spec.find(':') == std::string_view::npos) return values;
    std::string_view rest = spec.substr(spec.find(':') + 1);
    for (std::size_t i = 0;; ++i) {
        if (i == values.size())
            throw lod::Error(lod::ErrorKind::usage, "cannot make '" + std::string(spec) +
                                                        "': too many numbers; write " +
                                                        usage(generator));
        const std::size_t comma = rest.find(',');
        values[i] = parse_value(rest.substr(0, comma), spec, generator, generator.parameters[i]);
        if (comma == std::string_view::npos) return values;
        rest.remove_prefix(comma + 1);
    }
}

}  // namespace

std::string usage(const Generator& generator) {
    std::string text(generator.name);
    char before = ':';
    for (const GeneratorParameter& parameter : generator.parameters) {
        text += before + std::string(parameter.name);
        before = ',';
    }
    return text;
}

bool names_generator(std::string_view spec) {
    return find(spec) != nullptr;
}

Shape generate(std::string_view spec) {
    const Generator* generator = find(spec);
    if (!generator)
        throw lod::Error(lod::ErrorKind::usage, "no generator is called '" +
                                                    std::string(spec.substr(0, spec.find(':'))) +
                                                    "'; choose one of: " + list_of_names());
    return make_shape(std::string(spec), generator->make(parse_values(spec, *generator)));
}

}  // namespace lod2d
