#include "lodlab/lod2d/source/resolve/cairo_script.hpp"

#include "lodlab/core/base/from_chars.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod2d/source/resolve/script_reader.hpp"

namespace lod2d {
namespace cairo_script {

bool ScriptReader::run_surface(std::string_view word) {
    if (word == "surface") {
        (void)numbers();
        push_surface();
    } else if (word == "context") {
        (void)at();  // a surface and what draws on it are one
    } else if (word == "similar") {
        (void)name();
        drop(2);
        (void)surface();
        push_surface();
    } else if (word == "record") {
        (void)numbers();
        (void)name();
        push_surface();
    } else {
        return false;
    }
    return true;
}

bool ScriptReader::run_paint(std::string_view word) {
    const auto solid = [&](int colours, bool alpha) {
        const bool seen = !alpha || number() > 0;
        drop(colours);
        push(Pattern{Pattern::Kind::solid, seen ? 1U : 0U, 1, 0, false});
    };
    if (word == "g") {
        solid(1, false);
    } else if (word == "rgb") {
        solid(3, false);
    } else if (word == "a") {
        solid(0, true);
    } else if (word == "rgba") {
        solid(3, true);
    } else if (word == "linear" || word == "radial") {
        drop(word == "linear" ? 4 : 6);
        push(Pattern{Pattern::Kind::gradient, 0, 0, 0, false});
    } else if (word == "add-color-stop") {
        const bool seen = number() > 0;
        drop(4);
        const Value gradient = take(Value::Kind::pattern);
        ++patterns_[gradient.place].stops;
        patterns_[gradient.place].seen += seen;
        stack_.push_back(gradient);
    } else if (word == "pattern") {
        push(Pattern{Pattern::Kind::group, 1, 1, surface(), false});
    } else if (word == "set-filter" || word == "set-extend") {
        (void)name();
    } else if (word == "set-source") {
        const Pattern ink = pattern();
        at().source = ink;
    } else {
        return false;
    }
    return true;
}

bool ScriptReader::inked(Surface& surface) {
    const Pattern& source = surface.source;
    if (source.seen == 0) return false;
    std::vector<SvgNotes::Kind>& whole = surface.drawn.notes.whole;
    if (source.seen < source.stops)
        SvgNotes::count(whole, "gradient that fades to nothing", "gradients that fade to nothing");
    if (source.kind == Pattern::Kind::group) fail(word_);
    return true;
}

void ScriptReader::fill() {
    Surface& surface = at();
    if (!inked(surface)) return;
    surface.path_filled = true;
    surface.drawn.fills.push_back({on_page(surface.path, surface.rule), surface.clips});
    surface.drawn.fills.back().region.path.drop_dots();
}

void ScriptReader::stroke() {
    Surface& surface = at();
    const lod::Matrix<2>& m = surface.matrix;
    const double determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    const bool drawn = surface.pen.width > 0 && determinant != 0;
    if (!drawn || !inked(surface)) return;
    const lod::Matrix<2> inverse(m(1, 1) / determinant, -m(0, 1) / determinant,
                                 -m(1, 0) / determinant, m(0, 0) / determinant);
    SvgStroke stroke{surface.path, surface.pen, to_page_ * Affine{m, Point::Zero()},
                     surface.path_filled, surface.clips};
    stroke.path.transform({inverse, Point::Zero()});
    surface.drawn.strokes.push_back(std::move(stroke));
}

/// Draws a group where its surface is painted.
void ScriptReader::paint() {
    Surface& surface = at();
    if (surface.source.kind != Pattern::Kind::group || surface.source.placed) fail(word_);
    const SvgDrawing group = surfaces_[surface.source.surface].drawn;
    const auto clipped = [&](SvgClips clips) {
        clips.insert(clips.end(), surface.clips.begin(), surface.clips.end());
        return clips;
    };
    for (const SvgFill& fill : group.fills)
        surface.drawn.fills.push_back({fill.region, clipped(fill.clips)});
    for (const SvgStroke& stroke : group.strokes) {
        surface.drawn.strokes.push_back(stroke);
        surface.drawn.strokes.back().clips = clipped(stroke.clips);
    }
    for (const SvgNotes::Kind& kind : group.notes.whole)
        SvgNotes::count(surface.drawn.notes.whole, kind.one, kind.many, kind.count);
}

bool ScriptReader::run_drawing(std::string_view word) {
    if (word == "fill+") {
        fill();
    } else if (word == "stroke+") {
        stroke();
    } else if (word == "clip+") {
        Surface& surface = at();
        surface.clips.push_back(
            std::make_shared<const FilledPath>(on_page(surface.path, surface.rule)));
    } else if (word == "reset-clip") {
        at().clips.clear();
    } else if (word == "paint") {
        paint();
    } else if (word == "mask") {
        const Pattern mask = pattern();
        if (mask.kind != Pattern::Kind::solid) fail(word);
        if (mask.seen > 0) paint();
    } else {
        return false;
    }
    return true;
}

void ScriptReader::run(std::string_view word) {
    word_ = word;
    double value = 0;
    const auto [end, failure] = lod::from_chars(word.data(), word.data() + word.size(), value);
    if (failure == std::errc{} && end == word.data() + word.size()) {
        push(value);
    } else if (word.starts_with('/')) {
        push(Value::Kind::name, names_, std::string(word.substr(word.find_first_not_of('/'))));
    } else if (const auto named = named_.find(word); named != named_.end()) {
        stack_.push_back(named->second);
    } else if (!run_path(word) && !run_stack(word) && !run_paint(word) && !run_pen(word) &&
               !run_drawing(word) && !run_surface(word)) {
        fail(word);
    }
}

SvgDrawing ScriptReader::read() {
    for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
        run(word);
        lod::check_interrupted();
    }
    return surfaces_.empty() ? SvgDrawing() : std::move(surfaces_.front().drawn);
}

}  // namespace cairo_script

SvgDrawing read_cairo_script(const std::string& name, std::string_view script,
                             const Affine& to_page) {
    return cairo_script::ScriptReader(name, script, to_page).read();
}

}  // namespace lod2d
