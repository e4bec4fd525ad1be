#include <cctype>
#include <map>
#include <string_view>
#include <utility>

#include "lodlab/core/base/from_chars.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/viz/paint/canvas/themes.hpp"

namespace viz {
namespace {

bool in_number(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
}

/// Rounded to a hundredth, without zeros at the end: what is finer than a pixel is not seen.
std::string rounded(std::string_view number) {
    double value = 0;
    (void)lod::from_chars(number.data(), number.data() + number.size(), value);
    std::string text = lod::number_text(value, std::chars_format::fixed, 2);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text == "-0" ? "0" : text;
}

/// The numbers of an attribute rounded; in a path no blank that is not needed.
std::string rounded_all(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && in_number(text[end])) ++end;
        if (end > i) {
            out += rounded(text.substr(i, end - i));
        } else {
            end = i + 1;
            const bool beside_letter =
                (!out.empty() && std::isalpha(static_cast<unsigned char>(out.back()))) ||
                (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])));
            if (text[i] != ' ' || !(beside_letter || end == text.size())) out += text[i];
        }
        i = end;
    }
    return out;
}

/// Writes tag after tag anew.
class Compactor {
  public:
    void take_tag(std::string_view tag) {
        std::size_t at = 0;
        for (std::size_t name = tag.find("=\""); name != std::string_view::npos;
             name = tag.find("=\"", at)) {
            const std::size_t begin = name + 2;
            const std::size_t end = tag.find('"', begin);
            if (end == std::string_view::npos) break;
            const std::size_t blank = tag.rfind(' ', name);
            out_ += tag.substr(at, blank - at);
            take_attribute(tag.substr(blank + 1, name - blank - 1), tag.substr(begin, end - begin));
            at = end + 1;
        }
        out_ += tag.substr(at);
    }

    void take_text(std::string_view text) {
        if (text.find_first_not_of(" \n") != std::string_view::npos) out_ += text;
    }

    std::string finished() {
        std::string rules;
        for (const auto& [style, name] : names_) rules += "." + name + "{" + style + "}";
        const std::size_t place = out_.find("<style>");
        if (place != std::string::npos)
            out_.insert(place + std::string_view("<style>").size(), rules);
        return std::move(out_);
    }

  private:
    void take_attribute(std::string_view name, std::string_view value) {
        if (name == "transform" && value == "matrix(1,0,0,1,0,0)") return;
        out_ += ' ';
        if (name == "style") {
            const auto [known, is_new] = names_.emplace(value, "s" + std::to_string(names_.size()));
            out_ += "class=\"" + known->second + "\"";
            return;
        }
        out_ += name;
        out_ += "=\"";
        if (name == "d" || name == "x" || name == "y")
            out_ += rounded_all(value);
        else
            out_ += value;
        out_ += '"';
    }

    std::string out_;
    std::map<std::string, std::string, std::less<>> names_;  ///< of styles
};

}  // namespace

std::string compacted(const std::string& svg) {
    Compactor compactor;
    const std::string_view whole = svg;
    std::size_t from = 0;
    for (std::size_t open = whole.find('<'); open != std::string_view::npos;
         open = whole.find('<', from)) {
        compactor.take_text(whole.substr(from, open - from));
        const std::size_t close = whole.find('>', open);
        if (close == std::string_view::npos) break;
        compactor.take_tag(whole.substr(open, close + 1 - open));
        from = close + 1;
    }
    compactor.take_text(whole.substr(from));
    return compactor.finished();
}

}  // namespace viz
