#include <cmath>

#include "lessons/exercises/words.hpp"
#include "lodlab/core/base/to_chars.hpp"

namespace exercises {
namespace {

constexpr int digits = 10;
constexpr int most_listed = 6;

class Teller {
  public:
    explicit Teller(const std::vector<double>& numbers) : numbers_(numbers) {}

    std::string tell(std::string_view format) {
        std::string text;
        for (std::size_t i = 0; i < format.size(); ++i) {
            if (format[i] != '{') {
                text += format[i];
                continue;
            }
            const std::size_t close = closing(format, i);
            text += field(format.substr(i + 1, close - i - 1));
            i = close;
        }
        return text;
    }

  private:
    static std::size_t closing(std::string_view format, std::size_t open) {
        int depth = 0;
        for (std::size_t i = open; i < format.size(); ++i) {
            depth += format[i] == '{' ? 1 : format[i] == '}' ? -1 : 0;
            if (depth == 0) return i;
        }
        return format.size();
    }

    double next() { return at_ < numbers_.size() ? numbers_[at_++] : NAN; }

    std::string field(std::string_view inside) {
        if (inside.starts_with("skip")) return skip(inside.substr(4));
        if (inside == "yes") return next() != 0 ? "yes" : "no";
        if (inside.starts_with("list ")) return list(inside.substr(5), true);
        if (inside.starts_with("count ")) return list(inside.substr(6), false);
        const double number = next();
        if (std::isnan(number)) return "nan";
        if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
        return lod::number_text(number, std::chars_format::general, digits);
    }

    std::string skip(std::string_view how_many) {
        for (int left = how_many.empty() ? 1 : std::stoi(std::string(how_many)); left > 0; --left)
            next();
        return {};
    }

    std::string list(std::string_view each, bool shown) {
        const double count = next();
        if (!(count > 0)) return shown ? "none" : "0";
        std::string text;
        for (int i = 0; i < count && at_ < numbers_.size(); ++i) {
            const std::string one = tell(each);
            if (i < most_listed) text += (i > 0 ? ", " : "") + one;
        }
        if (!shown) return lod::number_text(count, std::chars_format::general, digits);
        return count > most_listed ? text + ", ..." : text;
    }

    const std::vector<double>& numbers_;
    std::size_t at_ = 0;
};

}  // namespace

std::string told(std::string_view format, const std::vector<double>& numbers) {
    return Teller(numbers).tell(format);
}

}  // namespace exercises
