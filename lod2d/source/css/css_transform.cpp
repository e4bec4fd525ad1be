#include <cmath>
#include <numbers>
#include <vector>

#include "lodlab/core/math/trigonometry.hpp"
#include "lodlab/lod2d/source/css/css_values.hpp"
#include "lodlab/lod2d/source/svg/text.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"

namespace lod2d {
namespace {

/// No transform: browsers leave it out.
struct NoTransform {};
/// A transform that takes more than this reader knows.
struct BeyondThePlane {};

/// One function of a transform, with its arguments.
class Function {
  public:
    Function(std::string_view name, std::string_view inside, const SvgFrame& frame)
        : name_(name), frame_(frame) {
        while (!inside.empty()) {
            const std::size_t comma = std::min(inside.find(','), inside.size());
            arguments_.push_back(trimmed(inside.substr(0, comma)));
            inside.remove_prefix(std::min(comma + 1, inside.size()));
        }
    }

    [[nodiscard]] std::string followed() const;

  private:
    struct Value {
        double number;
        std::string unit;  ///< "%" too
    };
    [[nodiscard]] Value value(std::size_t i) const {
        SvgReader reader(arguments_[i]);
        Value value{reader.number(), {}};
        value.unit = reader.take_if('%') ? "%" : std::string(reader.letters());
        if (!reader.at_end()) throw NoTransform{};
        return value;
    }
    [[nodiscard]] double number(std::size_t i) const {
        const auto [number, unit] = value(i);
        if (!unit.empty() && unit != "%") throw NoTransform{};
        return unit == "%" ? number / 100 : number;
    }
    [[nodiscard]] double length(std::size_t i, int axis) const {
        const auto [number, unit] = value(i);
        if (unit.empty() && number != 0) throw NoTransform{};
        if (unit == "%" && frame_.percent_of) return number / 100 * (*frame_.percent_of)[axis];
        if (unit == "rem" && frame_.root_font) return number * *frame_.root_font;
        if (unit == "q") return number * 96 / 101.6;
        if (!is_one_of(unit, {"", "px", "pt", "pc", "mm", "cm", "in"})) throw BeyondThePlane{};
        return parse_svg_length(arguments_[i], 0);
    }
    [[nodiscard]] double degrees(std::size_t i) const {
        const auto [number, unit] = value(i);
        if (unit == "deg" || (unit.empty() && number == 0)) return number;
        if (unit == "grad") return number * 0.9;
        if (unit == "turn") return number * 360;
        if (unit == "rad") return number * (180 / std::numbers::pi);
        throw NoTransform{};
    }
    void require(std::size_t least, std::size_t most) const {
        if (arguments_.size() < least || arguments_.size() > most) throw NoTransform{};
    }
    [[nodiscard]] std::string in_space() const;

    std::string_view name_;
    const SvgFrame& frame_;
    std::vector<std::string_view> arguments_;
};

std::string called(const std::string& function, std::initializer_list<double> values) {
    std::string text = function + "(";
    for (const double value : values) {
        if (text.back() != '(') text += ',';
        text += decimal(value);
    }
    return text + ") ";
}

std::string moved(double x, double y) {
    return called("matrix", {1, 0, 0, 1, x, y});
}

std::string skewed(double degrees_x, double degrees_y) {
    const auto slope = [](double degrees) {
        const lod::SineCosine of =
            lod::sine_cosine(std::remainder(degrees, 360) * (std::numbers::pi / 180));
        return of.sine / of.cosine;
    };
    return called("matrix", {1, slope(degrees_y), slope(degrees_x), 1, 0, 0});
}

std::string turned(double degrees) {
    return "rotate(" + decimal(degrees) + "deg) ";
}

/// Of functions of space, those that stay in the plane.
std::string Function::in_space() const {
    if (name_ == "translatez") return require(1, 1), std::string();
    if (name_ == "scalez") return require(1, 1), std::string();
    if (name_ == "rotatez") return require(1, 1), turned(degrees(0));
    if (name_ == "translate3d") return require(3, 3), moved(length(0, 0), length(1, 1));
    if (name_ == "scale3d") return require(3, 3), called("scale", {number(0), number(1)});
    if (name_ == "rotate3d") {
        require(4, 4);
        if (number(0) != 0 || number(1) != 0) throw BeyondThePlane{};
        return number(2) == 0 ? std::string() : turned(number(2) > 0 ? degrees(3) : -degrees(3));
    }
    if (name_ == "matrix3d") {
        require(16, 16);
        for (const std::size_t i : {2U, 3U, 6U, 7U, 8U, 9U, 11U})
            if (number(i) != 0) throw BeyondThePlane{};
        if (number(15) != 1) throw BeyondThePlane{};
        return called("matrix",
                      {number(0), number(1), number(4), number(5), number(12), number(13)});
    }
    if (is_one_of(name_, {"rotatex", "rotatey", "perspective"})) throw BeyondThePlane{};
    throw NoTransform{};
}

std::string Function::followed() const {
    const std::size_t n = arguments_.size();
    if (name_ == "translate") return require(1, 2), moved(length(0, 0), n > 1 ? length(1, 1) : 0);
    if (name_ == "translatex") return require(1, 1), moved(length(0, 0), 0);
    if (name_ == "translatey") return require(1, 1), moved(0, length(0, 1));
    if (name_ == "scale") return require(1, 2), called("scale", {number(0), number(n > 1 ? 1 : 0)});
    if (name_ == "scalex") return require(1, 1), called("scale", {number(0), 1});
    if (name_ == "scaley") return require(1, 1), called("scale", {1, number(0)});
    if (name_ == "rotate") return require(1, 1), turned(degrees(0));
    if (name_ == "skew") return require(1, 2), skewed(degrees(0), n > 1 ? degrees(1) : 0);
    if (name_ == "skewx") return require(1, 1), skewed(degrees(0), 0);
    if (name_ == "skewy") return require(1, 1), skewed(0, degrees(0));
    if (name_ != "matrix") return in_space();
    require(6, 6);
    return called("matrix", {number(0), number(1), number(2), number(3), number(4), number(5)});
}

}  // namespace

std::optional<std::string> followed_transform(std::string_view text, const SvgFrame& frame) {
    std::string result;
    bool leaves_plane = false;
    try {
        for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
            const std::size_t open = std::min(text.find('('), text.size());
            const std::size_t close = text.find(')', open);
            if (close == std::string_view::npos) return "";
            try {
                result +=
                    Function(text.substr(0, open), text.substr(open + 1, close - open - 1), frame)
                        .followed();
            } catch (const BeyondThePlane&) {
                leaves_plane = true;  // what follows may be no transform still
            }
            text.remove_prefix(close + 1);
        }
    } catch (const NoTransform&) {
        return "";
    } catch (const SvgTextError&) {
        return "";
    }
    if (leaves_plane) return std::nullopt;
    return result.empty() ? "none" : result;
}

}  // namespace lod2d
