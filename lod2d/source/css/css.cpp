#include "lodlab/lod2d/source/css/css.hpp"

#include <algorithm>
#include <vector>

#include "lodlab/lod2d/source/svg/text.hpp"
#include "lodlab/lod2d/source/svg/words.hpp"

namespace lod2d {
namespace {

/// Where the string that begins at `i` ends, or i itself.
std::size_t after_string(std::string_view text, std::size_t i) {
    if (text[i] != '"' && text[i] != '\'') return i;
    const char quote = text[i];
    for (++i; i < text.size() && text[i] != quote; ++i)
        if (text[i] == '\\') ++i;
    return std::min(i, text.size() - 1);
}

/// The first of `wanted` outside strings and brackets, from `i`; the size where there is none.
std::size_t find_outside(std::string_view text, std::string_view wanted, std::size_t i = 0) {
    int depth = 0;
    for (; i < text.size(); ++i) {
        i = after_string(text, i);
        if (depth == 0 && wanted.find(text[i]) != std::string_view::npos) return i;
        if (std::string_view("([{").find(text[i]) != std::string_view::npos) ++depth;
        if (depth > 0 && std::string_view(")]}").find(text[i]) != std::string_view::npos) --depth;
    }
    return text.size();
}

std::string without_comments(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t end = after_string(text, i);
        if (end != i) {
            result += text.substr(i, end - i + 1);
            i = end;
        } else if (text.substr(i).starts_with("/*")) {
            const std::size_t close = text.find("*/", i + 2);
            if (close == std::string_view::npos) break;
            result += ' ';
            i = close + 1;
        } else if (text.substr(i).starts_with("<!--")) {
            i += 3;
        } else if (text.substr(i).starts_with("-->")) {
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

/// Calls visit(name in lower case, value) for each declaration.
template <typename Visit>
void visit_declarations(std::string_view text, Visit&& visit) {
    while (!text.empty()) {
        const std::size_t end = find_outside(text, ";");
        const std::string_view declaration = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t colon = declaration.find(':');
        if (colon == std::string_view::npos) continue;
        const std::string_view name = trimmed(declaration.substr(0, colon));
        visit(name.starts_with("--") ? std::string(name) : lower(name),
              trimmed(declaration.substr(colon + 1)));
    }
}

/// Calls rule(selector, block) and at(name, prelude, block) for what a sheet holds.
template <typename Rule, typename At>
void visit_rules(std::string_view text, Rule&& rule, At&& at) {
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\f;}"), text.size()));
        if (text.empty()) return;
        const bool of_at = text.front() == '@';
        const std::size_t end = find_outside(text, of_at ? ";{" : "{");
        const std::string_view prelude = trimmed(text.substr(0, end));
        std::string_view block;
        if (end < text.size() && text[end] == '{') {
            const std::size_t close = find_outside(text, "}", end + 1);
            block = text.substr(end + 1, close - end - 1);
            text.remove_prefix(std::min(close + 1, text.size()));
        } else {
            text.remove_prefix(std::min(end + 1, text.size()));
        }
        if (!of_at) {
            rule(prelude, block);
            continue;
        }
        const std::size_t name = std::min(prelude.find_first_of(" \t\r\n\f(\"'"), prelude.size());
        at(lower(prelude.substr(1, name - 1)), trimmed(prelude.substr(name)), block);
    }
}

/// Lower case but for links and strings, whose case says something.
std::string lower_outside_links(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::size_t end = after_string(text, i);
        if (lower(text.substr(i, 4)) == "url(") {
            result += "url(";
            i += 4;
            end = std::min(text.find(')', i), text.size() - 1);
        }
        if (end == i)
            result += lower(text.substr(i, 1));
        else
            result += text.substr(i, end - i + 1);
        i = end;
    }
    return result;
}

bool is_no_opacity(std::string_view text) {
    SvgReader reader(trimmed(text));
    try {
        return reader.number() <= 0;
    } catch (const SvgTextError&) {
        return false;
    }
}

}  // namespace

bool is_for_screens(std::string_view query, bool& known) {
    const std::string text = lower(trimmed(query));
    known = true;
    if (text.empty()) return true;
    bool any = false;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const std::string_view one = trimmed(rest.substr(0, comma));
        rest.remove_prefix(std::min(comma + 1, rest.size()));
        if (is_one_of(one, {"all", "screen", "only screen", "only all", "not print"}))
            any = true;
        else if (!is_one_of(one,
                            {"print", "only print", "speech", "aural", "tty", "handheld",
                             "projection", "braille", "embossed", "tv", "not all", "not screen"}) &&
                 !one.starts_with("print and"))
            known = false;
    }
    if (any) known = true;
    return any;
}

void SvgCss::learn_from(std::string_view declarations, bool of_root) {
    visit_declarations(declarations, [&](const std::string& name, std::string_view value) {
        transforms_ = transforms_ || name == "transform" || name == "-webkit-transform";
        if (!name.starts_with("--")) return;
        const auto [custom, added] = custom_.try_emplace(name);
        custom->second.of_root = (added || custom->second.of_root) && of_root;
        custom->second.value = value;
    });
}

void SvgCss::learn(std::string_view text) {
    const std::string clean = without_comments(text);
    const std::string small = lower(clean);
    for (std::size_t at = small.find("opacity"); at != std::string::npos;
         at = small.find("opacity", at + 1)) {
        if (at > 0 && (small[at - 1] == '-' || small[at - 1] == '.')) continue;
        const std::size_t colon = small.find_first_not_of(" \t\r\n", at + 7);
        if (colon == std::string::npos || small[colon] != ':') continue;
        const std::size_t end = std::min(small.find_first_of(";}!", colon), small.size());
        sheets_fade_ = sheets_fade_ || is_no_opacity(small.substr(colon + 1, end - colon - 1));
    }
    sheets_display_ = sheets_display_ || small.find("display") != std::string::npos;
    if (sheets_fade_ && sheets_display_)
        notes_.doubt("its style sheet hides by opacity and by display, which may hide too much");
    visit_rules(
        clean,
        [&](std::string_view selector, std::string_view block) {
            const std::string of = lower(selector);
            learn_from(block, is_one_of(of, {":root", "svg", "*", "html", "body", "svg:root",
                                             ":root, svg", "html, svg"}));
        },
        [&](const std::string&, std::string_view, std::string_view block) {
            learn_from(block, false);
            if (block.find('{') != std::string_view::npos)
                visit_rules(
                    block,
                    [&](std::string_view, std::string_view inner) { learn_from(inner, false); },
                    [](const std::string&, std::string_view, std::string_view) {});
        });
}

void SvgCss::learn_root(std::string_view declarations) {
    const bool sheets_transform = transforms_;
    learn_from(without_comments(declarations), true);
    transforms_ = sheets_transform;
}

std::string SvgCss::substituted(std::string text, int& left) {
    constexpr std::size_t most_letters = 100'000;
    while (true) {
        const std::size_t at = lower(text).find("var(");
        if (at == std::string::npos) return text;
        const std::size_t close = find_outside(text, ")", at + 4);
        const std::string inside(text.substr(at + 4, close - at - 4));
        const std::size_t comma = find_outside(inside, ",");
        const std::string name(trimmed(std::string_view(inside).substr(0, comma)));
        const auto custom = custom_.find(name);
        const bool is_ours = custom != custom_.end() && custom->second.of_root;
        const bool falls_back = custom == custom_.end() && comma < inside.size();
        if (--left < 0 || text.size() > most_letters || !(is_ours || falls_back)) {
            notes_.doubt("its style says var(" + name +
                         "), which is not resolved here; write the value itself");
            return {};
        }
        std::string put = is_ours
                              ? custom->second.value
                              : std::string(trimmed(std::string_view(inside).substr(comma + 1)));
        text.replace(at, close - at + 1, substituted(std::move(put), left));
    }
}

std::string SvgCss::value(std::string_view property, std::string_view raw) {
    std::string text = without_comments(raw);
    if (lower(text).find("var(") != std::string::npos) {
        int left = 200;  // references, so that those that name each other end
        text = substituted(std::move(text), left);
    }
    text = lower_outside_links(trimmed(text));
    std::string important;
    if (const std::size_t mark = text.find('!'); mark != std::string::npos) {
        important = " !important";
        text = trimmed(std::string_view(text).substr(0, mark));
    }
    if (property.starts_with("-")) return text + important;
    text = followed_value(property, std::move(text), frame_, notes_);
    return text.empty() ? text : text + important;
}

std::string SvgCss::display_for(std::string_view opacity) {
    const std::string text = value("opacity", opacity);
    const std::size_t mark = text.find(" !");
    const std::string important = mark == std::string::npos ? "" : text.substr(mark);
    if (is_no_opacity(text.substr(0, mark))) return "none" + important;
    return sheets_fade_ ? "inline" + important : "";
}

std::string SvgCss::declarations(std::string_view text) {
    const std::string clean = without_comments(text);
    std::string result;
    visit_declarations(clean, [&](const std::string& name, std::string_view value_text) {
        if (name.starts_with("--")) return;
        if (name.starts_with("-webkit-"))
            return put_declaration(name.substr(8), value_text, result);
        put_declaration(name, value_text, result);
    });
    return result;
}

void SvgCss::put_declaration(const std::string& name, std::string_view text, std::string& result) {
    if (name.find_first_of("{}&") != std::string::npos ||
        text.find('{') != std::string_view::npos) {
        notes_.doubt("its style sheet nests rules, which is not followed here");
        return;
    }
    if (name == "opacity") {
        const std::string display = display_for(text);
        if (!display.empty()) result += "display:" + display + ";";
        return;
    }
    const std::string put = value(name, text);
    if (!put.empty()) result += name + ":" + put + ";";
}

std::string SvgCss::at_rule(std::string_view name, std::string_view prelude,
                            std::string_view block) {
    if (name == "namespace") return selectors_.declare(prelude), std::string();
    if (is_one_of(name, {"charset", "font-face", "keyframes", "page", "property"})) return {};
    if (name == "import") {
        notes_.doubt("its style sheet imports another (" + std::string(prelude) +
                     "), which is not read");
        return {};
    }
    if (name == "media") {
        bool known = true;
        const bool screens = is_for_screens(prelude, known);
        if (!known)
            notes_.doubt("its style sheet has rules for @media " + std::string(prelude) +
                         ", which are left out");
        return screens ? sheet(block) : std::string();
    }
    notes_.doubt("its style sheet has rules in @" + std::string(name) + ", which are left out");
    return {};
}

std::string SvgCss::sheet(std::string_view text) {
    const std::string clean = without_comments(text);
    std::string result;
    visit_rules(
        clean,
        [&](std::string_view selector, std::string_view block) {
            const auto followed = selectors_.followed(selector);
            if (!followed) return;
            visit_declarations(block, [&](const std::string& name, std::string_view) {
                if (is_one_of(name, {"x", "y", "width", "height"}) &&
                    SvgSelectors::may_take_viewports(*followed, frame_))
                    notes_.doubt("its style sheet sets " + name +
                                 ", which is not followed here for <use> and <svg>");
                if (name == "transform" &&
                    is_one_of(lower(*followed), {"svg", ":root", "svg:root", "*"}))
                    notes_.doubt("the transform of its outermost <svg> is not followed here");
            });
            result += *followed + "{" + declarations(block) + "}\n";
        },
        [&](const std::string& name, std::string_view prelude, std::string_view block) {
            result += at_rule(name, prelude, block);
        });
    return result;
}

}  // namespace lod2d
