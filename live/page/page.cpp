#include "lodlab/live/page/page.hpp"

#include <array>
#include <cmath>
#include <map>

#include "lodlab/core/base/error.hpp"
#include "lodlab/live/outline.hpp"
#include "lodlab/live/page/embedded.hpp"
#include "lodlab/live/picture.hpp"
#include "lodlab/live/sources.hpp"
#include "lodlab/lod2d/shape/generators.hpp"
#include "lodlab/viz/paint/palette.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace live {
namespace {

constexpr std::array drawn{viz::Role::body,           viz::Role::wall,
                           viz::Role::ghost,          viz::Role::node,
                           viz::Role::level_node,     viz::Role::meeting_node,
                           viz::Role::true_collision, viz::Role::dropped_node,
                           viz::Role::contact,        viz::Role::normal,
                           viz::Role::impulse,        viz::Role::velocity,
                           viz::Role::trajectory,     viz::Role::reference,
                           viz::Role::construction,   viz::Role::note};
constexpr int body_inks = 3;

constexpr const char* playground_controls = R"(<section class="part" aria-label="Shapes">
<div class="drawing"><button type="button" class="draw-0">Draw A</button><label class="file">SVG for A<input type="file" class="open-0" accept=".svg,image/svg+xml"></label>
<button type="button" class="draw-1">Draw B</button><label class="file">SVG for B<input type="file" class="open-1" accept=".svg,image/svg+xml"></label>
<button type="button" class="save-scene">Save scene</button></div>
<label class="slider"><span>Levels below root</span><input type="range" class="depth" min="0" max="6" step="1" value="4"><output class="depth-value">4</output></label>
<p class="told" role="status">Draw an outline, or drop an SVG onto the picture.</p>
</section>)";

std::string hexadecimal(const viz::Rgb& ink) {
    std::string text = "#";
    for (const double share : {ink.r, ink.g, ink.b}) {
        const auto byte = static_cast<unsigned>(std::lround(255 * share));
        text += "0123456789abcdef"[byte >> 4];
        text += "0123456789abcdef"[byte & 0xf];
    }
    return text;
}

std::string number(double value) {
    const auto hundredths = std::lround(100 * value);
    return std::to_string(hundredths / 100) + "." +
           std::to_string(hundredths % 100 + 100).substr(1);
}

/// Whether a role's ink is that of its body.
bool has_own_ink(viz::Role role) {
    return viz::pen(viz::Theme::light, role, 0).ink == viz::body_ink(viz::Theme::light, 0);
}

std::string variables(viz::Theme theme) {
    const viz::PageInks page = viz::page_inks(theme);
    std::string text = "--ground:" + hexadecimal(page.ground) +
                       ";--panel:" + hexadecimal(page.panel) + ";--text:" + hexadecimal(page.text) +
                       ";--muted:" + hexadecimal(page.muted) + ";--grid:" + hexadecimal(page.grid) +
                       ";--edge:" + hexadecimal(page.muted) + ";";
    for (int body = 0; body < body_inks; ++body)
        text +=
            "--body-" + std::to_string(body) + ":" + hexadecimal(viz::body_ink(theme, body)) + ";";
    for (const viz::Role role : drawn)
        if (!has_own_ink(role))
            text += "--" + std::string(viz::role_name(role)) + ":" +
                    hexadecimal(viz::pen(theme, role, 0).ink) + ";";
    return text;
}

/// How each role is drawn, by the palette of all our pictures, in both themes.
std::string inks() {
    const std::string light = variables(viz::Theme::light);
    const std::string dark = variables(viz::Theme::dark);
    std::string text = ":root{color-scheme:light dark;" + light + "}\n" +
                       "@media(prefers-color-scheme:dark){:root{" + dark + "}}\n" +
                       ":root[data-theme=light]{color-scheme:light;" + light + "}\n" +
                       ":root[data-theme=dark]{color-scheme:dark;" + dark + "}\n";
    for (int body = 0; body < body_inks; ++body)
        text +=
            ".body-" + std::to_string(body) + "{--own:var(--body-" + std::to_string(body) + ")}\n";
    for (const viz::Role role : drawn) {
        const std::string name = viz::role_name(role);
        const viz::Pen pen = viz::pen(viz::Theme::light, role, 0);
        const std::string ink = has_own_ink(role) ? "var(--own)" : "var(--" + name + ")";
        text += ".marks ." + name + "{stroke:" + ink + ";fill:" + ink +
                ";fill-opacity:" + number(pen.fill) + ";stroke-width:" + number(pen.width) +
                (pen.dashed ? ";stroke-dasharray:5 4" : "") + "}.words ." + name + "{fill:" + ink +
                "}\n";
    }
    return text;
}

std::string escaped(const std::string& text) {
    const std::map<char, const char*> signs{
        {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
    std::string result;
    for (const char letter : text) {
        const auto sign = signs.find(letter);
        if (sign == signs.end())
            result += letter;
        else
            result += sign->second;
    }
    return result;
}

/// What stands between script tags must not end them: in JSON, "<\/" is the same text.
std::string within_script(std::string text) {
    for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 2))
        text.insert(at + 1, 1, '\\');
    return text;
}

/// A template with each {{name}} replaced.
std::string filled(std::string_view page, const std::map<std::string, std::string>& values) {
    std::string text;
    while (!page.empty()) {
        const std::size_t open = page.find("{{");
        text += page.substr(0, open);
        if (open == std::string_view::npos) break;
        const std::size_t close = page.find("}}", open);
        text += values.at(std::string(page.substr(open + 2, close - open - 2)));
        page.remove_prefix(close + 2);
    }
    return text;
}

/// All that draws and plays a scene by the module.
std::string script() {
    std::string text = "const lodlabSources = \"" + std::string(sources()) + "\";\n";
    for (const std::string_view part :
         {embedded::figure_js(), embedded::controls_js(), embedded::numbers_js(),
          embedded::handles_js(), embedded::inside_js(), embedded::live_js()})
        text += part;
    return text;
}

}  // namespace

bool has_module() {
    return !embedded::module_js().empty();
}

void check_module() {
    if (!has_module())
        throw lod::Error(lod::ErrorKind::not_installed,
                         "this lodlab was built without the module that runs in a page; "
                         "scripts/wasm builds it, then configure and build lodlab again");
}

Component component() {
    check_module();
    Component parts;
    parts.style = std::string(embedded::live_css()) + inks();
    parts.script = script();
    parts.module = embedded::module_js();
    return parts;
}

std::string page_text(const Scene& scene, PageKind kind) {
    check_module();
    const bool is_playground = kind == PageKind::playground;
    viz::Figure start = picture(Stage(scene));
    const std::string title = viz::plain_text(start.title);
    start.title.clear();  // the page has it
    const double wide = scene.view.high.x - scene.view.low.x;
    const double high = scene.view.high.y - scene.view.low.y;
    return filled(
        embedded::page_html(),
        {{"title", escaped(title)},
         {"style", std::string(embedded::page_css())},
         {"component", std::string(embedded::live_css())},
         {"inks", inks()},
         {"still", viz::web_svg_text(start)},
         {"aspect", number(wide / high)},
         {"scene", within_script(scene_text(scene))},
         {"module", within_script(std::string(embedded::module_js()))},
         {"live", script()},
         {"playground", is_playground ? playground_controls : ""},
         {"playground_script", is_playground ? std::string(embedded::playground_js()) : ""},
         {"script", std::string(embedded::page_js())}});
}

std::string playground_text() {
    std::vector<DrawnOutline> outlines;
    for (const char* name : {"star:5", "blob:7"}) {
        const viz::Visual<2> visual = viz::visual_of(lod2d::generate(name));
        outlines.push_back({name, visual.outline[0]});
    }
    return page_text(scene_of(outlines, 4), PageKind::playground);
}

}  // namespace live
