#include "lodlab/lod2d/source/resolve/resolve.hpp"

#include "lodlab/io/files/child_process.hpp"
#include "lodlab/lod2d/source/resolve/cairo_script.hpp"
#include "lodlab/lod2d/source/resolve/prepare.hpp"
#include "lodlab/lod2d/source/resolve/render.hpp"

namespace lod2d {
namespace {

/// What the child says before the script.
struct ScriptHead {
    std::uint64_t letters;
    double linear[4];
    double offset[2];
    double precision;
};

void send_script(lod::ChildPipe& pipe, const SvgScript& script) {
    const auto& [linear, offset] = script.to_page;
    pipe.send(ScriptHead{script.text.size(),
                         {linear(0, 0), linear(0, 1), linear(1, 0), linear(1, 1)},
                         {offset.x(), offset.y()},
                         script.precision});
    pipe.send(script.text.data(), script.text.size());
}

SvgScript receive_script(lod::ChildProcess& child) {
    const auto head = child.receive<ScriptHead>();
    const auto& [a, b, c, d] = head.linear;
    SvgScript script{std::string(head.letters, '\0'),
                     {{a, b, c, d}, {head.offset[0], head.offset[1]}},
                     head.precision};
    child.receive(script.text.data(), script.text.size());
    return script;
}

/// By a child process, as a rule: drawings can be written on which Cairo never ends.
SvgScript rendered(const std::string& name, const PreparedSvg& svg, const SvgSettings& settings) {
    if (!settings.in_child) return render_svg(name, svg);
    lod::ChildProcess child(
        {"cannot read " + name, "librsvg"}, {settings.most_memory, settings.most_seconds},
        [&](lod::ChildPipe& pipe) { send_script(pipe, render_svg(name, svg)); });
    return receive_script(child);
}

/// The next power of ten above, as "1e-9".
std::string power_of_ten(double value) {
    int exponent = 0;
    for (double power = 0.1; power >= value && exponent < 12; power /= 10) ++exponent;
    std::string text = "1e-";
    text += std::to_string(exponent);
    return text;
}

}  // namespace

SvgDrawing resolve_svg(const SvgXml& xml, const SvgSettings& settings) {
    PreparedSvg svg = prepare_svg(xml, settings);
    const SvgScript script = rendered(xml.name, svg, settings);
    SvgDrawing drawing = read_cairo_script(xml.name, script.text, script.to_page);
    svg.notes.whole.insert(svg.notes.whole.end(), drawing.notes.whole.begin(),
                           drawing.notes.whole.end());
    drawing.notes = std::move(svg.notes);
    drawing.notes.remarks.insert(
        drawing.notes.remarks.begin(),
        "outlines come through librsvg " + librsvg_version() + ", to about " +
            power_of_ten(script.precision) +
            " of the drawing's size (its circles to 3e-4 of their radius)");
    if (svg.paged) {
        Box page;
        page.hold({0, 0});
        page.hold({svg.size.x(), -svg.size.y()});
        drawing.page = page;
    }
    return drawing;
}

}  // namespace lod2d
