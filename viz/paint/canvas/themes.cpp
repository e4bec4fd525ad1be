#include "lodlab/viz/paint/canvas/themes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string_view>
#include <utility>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/from_chars.hpp"

namespace viz {
namespace {

/// "rgb(100%,50%,0%)" as "#ff8000".
std::string hex(std::string_view rgb) {
    std::string text = "#";
    const char* at = rgb.data() + 4;
    for (int channel = 0; channel < 3; ++channel) {
        while (*at == ' ') ++at;
        double share = 0;
        const char* const end = lod::from_chars(at, rgb.data() + rgb.size(), share).ptr;
        const long value = std::lround(share * 255 / 100);
        char digits[8];
        std::snprintf(digits, sizeof digits, "%02lx", std::clamp(value, 0L, 255L));
        text += digits;
        at = end + (end[0] == '%' ? 1 : 0) + 1;
    }
    return text;
}

/// a, b, ..., z, ba, bb, ...
std::string letters(std::size_t number) {
    std::string name(1, static_cast<char>('a' + number % 26));
    return number < 26 ? name : letters(number / 26) + name;
}

/// Walks along both SVGs and writes one.
class Join {
  public:
    Join(std::string_view light, std::string_view dark) : light_(light), dark_(dark) {}

    std::string joined() {
        while (a_ < light_.size()) {
            const std::size_t next = std::min(light_.find("rgb(", a_), light_.find("<image ", a_));
            copy_until(std::min(next, light_.size()));
            if (a_ == light_.size()) break;
            if (light_[a_] == 'r')
                join_ink();
            else
                join_picture();
        }
        if (b_ != dark_.size()) refuse();
        const std::size_t place = out_.find("</desc>") + std::string_view("</desc>").size();
        return out_.insert(place, style());
    }

  private:
    [[noreturn]] static void refuse() {
        throw lod::Error(lod::ErrorKind::output_failed,
                         "cannot draw the figure for both themes: they differ in more than inks");
    }

    void copy_until(std::size_t end) {
        const std::string_view part = light_.substr(a_, end - a_);
        if (dark_.substr(b_, part.size()) != part) refuse();
        out_ += part;
        a_ = end;
        b_ += part.size();
    }

    /// The text from here on to `closing`, which is part of it.
    static std::string_view take(std::string_view text, std::size_t& at, char closing) {
        const std::size_t end = text.find(closing, at);
        if (end == std::string_view::npos) refuse();
        const std::string_view taken = text.substr(at, end + 1 - at);
        at = end + 1;
        return taken;
    }

    void join_ink() {
        const std::string light = hex(take(light_, a_, ')'));
        const std::string dark = hex(take(dark_, b_, ')'));
        if (light == dark) {
            out_ += light;
            return;
        }
        const auto [ink, is_new] = inks_.emplace(std::pair{light, dark}, letters(inks_.size()));
        out_ += "var(--" + ink->second + ")";
    }

    /// Both pictures under one id, of which one is shown.
    void join_picture() {
        const std::string_view light = take(light_, a_, '>');
        const std::string_view dark = take(dark_, b_, '>');
        const std::size_t id = light.find("id=\"");
        if (id == std::string_view::npos || dark.substr(0, id) != light.substr(0, id)) refuse();
        const std::size_t end = light.find('"', id + 4) + 1;
        const std::size_t tag = std::string_view("<image").size();
        out_ += "<g " + std::string(light.substr(id, end - id)) + ">";
        for (const auto& [picture, name] : {std::pair{light, "L"}, {dark, "D"}})
            out_ += "<image class=\"" + std::string(name) + "\"" +
                    std::string(picture.substr(tag, id - 1 - tag)) +
                    std::string(picture.substr(end));
        out_ += "</g>";
        has_pictures_ = true;
    }

    [[nodiscard]] std::string style() const {
        std::string light;
        std::string dark;
        for (const auto& [inks, name] : inks_) {
            light += "--" + name + ":" + inks.first + ";";
            dark += "--" + name + ":" + inks.second + ";";
        }
        std::string text = ":root{" + light + "}";
        if (has_pictures_) text += ".D{display:none}";
        text += "@media(prefers-color-scheme:dark){:root{" + dark + "}";
        if (has_pictures_) text += ".L{display:none}.D{display:inline}";
        return "\n<style>" + text + "}</style>";
    }

    std::string_view light_;
    std::string_view dark_;
    std::size_t a_ = 0;
    std::size_t b_ = 0;
    std::string out_;
    std::map<std::pair<std::string, std::string>, std::string> inks_;
    bool has_pictures_ = false;
};

}  // namespace

std::string for_both_themes(const std::string& light, const std::string& dark) {
    return Join(light, dark).joined();
}

}  // namespace viz
