#include "lodlab/lod2d/cairo_script.hpp"

#include <algorithm>
#include <map>

#include "lodlab/core/error.hpp"
#include "lodlab/core/from_chars.hpp"

namespace lod2d {
namespace {

struct Pattern {
    enum class Kind { solid, gradient, group } kind = Kind::solid;
    std::size_t seen = 1;   ///< of the colours: those with ink
    std::size_t stops = 1;  ///< colours
    std::size_t surface = 0;
    bool placed = false;  ///< moved from where it was drawn
};

/// A surface with the state of its drawing.
struct Surface {
    SvgDrawing drawn;
    CurvePath path;
    bool path_filled = false;
    Pattern source;
    FillRule rule = FillRule::nonzero;
    StrokeStyle pen = {2.0, StrokeJoin::miter, StrokeCap::butt, 10.0, {}, 0};  // Cairo's defaults
    lod::Matrix<2> matrix = lod::Matrix<2>::Identity();
    SvgClips clips;
};

using Numbers = std::vector<double>;

/// What lies on the stack: a number, or the place of something in the table of its kind.
struct Value {
    enum class Kind { number, name, numbers, pattern, surface, mark } kind = Kind::mark;
    double number = 0;
    std::size_t place = 0;
};

/// Runs a script: a language of a stack, as PostScript.
class ScriptReader {
  public:
    ScriptReader(const std::string& name, std::string_view script, const Affine& to_page)
        : name_(name), script_(script), to_page_(to_page) {}

    SvgDrawing read();

  private:
    [[noreturn]] void fail(std::string_view word) const {
        lod::refuse_input("cannot read " + name_,
                          "Cairo draws it by '" + std::string(word) +
                              "', which is not understood; save it as a plain SVG");
    }

    std::string_view next_word();
    void run(std::string_view word);
    bool run_stack(std::string_view word);
    bool run_surface(std::string_view word);
    bool run_paint(std::string_view word);
    bool run_pen(std::string_view word);
    bool run_path(std::string_view word);
    bool run_drawing(std::string_view word);

    Value take(Value::Kind kind) {
        if (stack_.empty() || stack_.back().kind != kind) fail(word_);
        const Value value = stack_.back();
        stack_.pop_back();
        return value;
    }
    double number() { return take(Value::Kind::number).number; }
    std::string name() { return names_[take(Value::Kind::name).place]; }
    Numbers numbers() { return arrays_[take(Value::Kind::numbers).place]; }
    Pattern pattern() { return patterns_[take(Value::Kind::pattern).place]; }
    std::size_t surface() { return take(Value::Kind::surface).place; }
    void push(double value) { stack_.push_back({Value::Kind::number, value, 0}); }
    template <typename T>
    void push(Value::Kind kind, std::vector<T>& table, T thing) {
        table.push_back(std::move(thing));
        stack_.push_back({kind, 0, table.size() - 1});
    }
    void push(Numbers array) { push(Value::Kind::numbers, arrays_, std::move(array)); }
    void push(const Pattern& ink) { push(Value::Kind::pattern, patterns_, ink); }
    void drop(int count) {
        for (; count > 0; --count) (void)number();
    }
    std::size_t place_from_top(std::size_t i) const {
        if (i >= stack_.size()) fail(word_);
        return stack_.size() - 1 - i;
    }
    Surface& at() {
        if (stack_.empty() || stack_.back().kind != Value::Kind::surface) fail(word_);
        return surfaces_[stack_.back().place];
    }
    void push_surface() { push(Value::Kind::surface, surfaces_, Surface()); }
    Point point() {
        const double y = number();
        return {number(), y};
    }
    FilledPath on_page(const CurvePath& path, FillRule rule) const {
        FilledPath region{path, rule};
        region.path.transform(to_page_);
        return region;
    }
    /// Whether the source has ink; notes what it has not.
    bool inked(Surface& surface);
    void fill();
    void stroke();
    void paint();
    void set_matrix();

    const std::string& name_;
    std::string_view script_;
    Affine to_page_;
    std::string_view word_;
    std::vector<Value> stack_;
    std::vector<std::string> names_;
    std::vector<Numbers> arrays_;
    std::vector<Pattern> patterns_;
    std::vector<Surface> surfaces_;
    std::map<std::string, Value, std::less<>> named_;
};

std::string_view ScriptReader::next_word() {
    constexpr std::string_view spaces = " \t\r\n";
    const auto skip = [&] {
        script_.remove_prefix(std::min(script_.find_first_not_of(spaces), script_.size()));
    };
    skip();
    while (script_.starts_with('%')) {
        script_.remove_prefix(std::min(script_.find('\n'), script_.size()));
        skip();
    }
    if (script_.empty()) return {};
    std::size_t length = 1;
    if (script_[0] != '[' && script_[0] != ']')
        length = std::min(script_.find_first_of(" \t\r\n[]"), script_.size());
    const std::string_view word = script_.substr(0, length);
    script_.remove_prefix(length);
    return word;
}

void ScriptReader::set_matrix() {
    const Numbers m = numbers();
    if (m.size() != 6) fail(word_);
    if (!stack_.empty() && stack_.back().kind == Value::Kind::pattern)
        patterns_[stack_.back().place].placed = true;
    else
        at().matrix = {m[0], m[2], m[1], m[3]};
}

bool ScriptReader::run_stack(std::string_view word) {
    if (word == "<<" || word == "[") {
        stack_.emplace_back();
    } else if (word == ">>") {
        while (!stack_.empty() && stack_.back().kind != Value::Kind::mark) stack_.pop_back();
        (void)take(Value::Kind::mark);
        push(Numbers{});
    } else if (word == "]") {
        Numbers array;
        while (!stack_.empty() && stack_.back().kind == Value::Kind::number)
            array.insert(array.begin(), number());
        (void)take(Value::Kind::mark);
        push(std::move(array));
    } else if (word == "dup") {
        stack_.push_back(stack_[place_from_top(0)]);
    } else if (word == "pop") {
        (void)place_from_top(0);
        stack_.pop_back();
    } else if (word == "exch") {
        std::swap(stack_[place_from_top(0)], stack_[place_from_top(1)]);
    } else if (word == "index") {
        const auto i = static_cast<std::size_t>(number());
        stack_.push_back(stack_[place_from_top(i)]);
    } else if (word == "roll") {
        const double by = number();
        const auto count = static_cast<std::size_t>(number());
        if (count == 0 || by != -1) fail(word);
        const auto first = stack_.begin() + static_cast<std::ptrdiff_t>(place_from_top(count - 1));
        std::rotate(first, first + 1, stack_.end());
    } else if (word == "def") {
        const Value value = stack_[place_from_top(0)];
        stack_.pop_back();
        named_.insert_or_assign(name(), value);
    } else if (word == "undef") {
        named_.erase(name());
    } else if (word == "get") {
        const std::string what = name();
        if (what == "source")
            push(Pattern(surfaces_[surface()].source));
        else if (what == "target")
            (void)at();
        else
            fail(what);
    } else if (word == "identity") {
        push(Numbers{1, 0, 0, 1, 0, 0});
    } else {
        return false;
    }
    return true;
}

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

bool ScriptReader::run_pen(std::string_view word) {
    if (word == "set-line-width") {
        const double width = number();
        at().pen.width = width;
    } else if (word == "set-miter-limit") {
        const double limit = number();
        at().pen.miter_limit = limit;
    } else if (word == "set-dash") {
        const double offset = number();
        Numbers dashes = numbers();
        at().pen.dashes = std::move(dashes);
        at().pen.dash_offset = offset;
    } else if (word == "set-line-cap") {
        const std::string cap = name();
        at().pen.cap = cap == "LINE_CAP_ROUND"    ? StrokeCap::round
                       : cap == "LINE_CAP_SQUARE" ? StrokeCap::square
                                                  : StrokeCap::butt;
    } else if (word == "set-line-join") {
        const std::string join = name();
        at().pen.join = join == "LINE_JOIN_ROUND"   ? StrokeJoin::round
                        : join == "LINE_JOIN_BEVEL" ? StrokeJoin::bevel
                                                    : StrokeJoin::miter;
    } else if (word == "set-fill-rule") {
        const bool evenodd = name() == "EVEN_ODD";
        at().rule = evenodd ? FillRule::evenodd : FillRule::nonzero;
    } else if (word == "set-tolerance") {
        drop(1);
    } else if (word == "set-antialias") {
        (void)name();
    } else if (word == "set-operator") {
        static constexpr std::string_view erasing[] = {"CLEAR",    "IN",   "OUT", "DEST_IN",
                                                       "DEST_OUT", "DEST", "XOR"};
        const std::string how = name();
        if (std::ranges::find(erasing, how) != std::end(erasing)) fail(how);
    } else if (word == "set-matrix") {
        set_matrix();
    } else if (word == "scale") {
        const double y = number();
        const double x = number();
        at().matrix = at().matrix * lod::Matrix<2>(x, 0, 0, y);
    } else {
        return false;
    }
    return true;
}

bool ScriptReader::run_path(std::string_view word) {
    if (word == "n") {
        at().path = {};
        at().path_filled = false;
    } else if (word == "m") {
        const Point p = point();
        at().path.move_to(p);
    } else if (word == "l") {
        const Point p = point();
        at().path.line_to(p);
    } else if (word == "c") {
        const Point p = point();
        const Point second = point();
        const Point first = point();
        at().path.cubic_to(first, second, p);
    } else if (word == "h") {
        at().path.close();
    } else if (word == "rectangle") {
        const Point size = point();
        const Point corner = point();
        CurvePath& path = at().path;
        path.move_to(corner);
        path.line_to({corner.x() + size.x(), corner.y()});
        path.line_to(corner + size);
        path.line_to({corner.x(), corner.y() + size.y()});
        path.close();
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
    if (source.kind == Pattern::Kind::group)
        SvgNotes::count(whole, "region filled with a pattern", "regions filled with patterns");
    return true;
}

void ScriptReader::fill() {
    Surface& surface = at();
    if (!inked(surface)) return;
    surface.path_filled = true;
    surface.drawn.fills.push_back({on_page(surface.path, surface.rule), surface.clips});
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

}  // namespace

SvgDrawing read_cairo_script(const std::string& name, std::string_view script,
                             const Affine& to_page) {
    return ScriptReader(name, script, to_page).read();
}

}  // namespace lod2d
