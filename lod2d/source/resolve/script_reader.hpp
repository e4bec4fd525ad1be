#pragma once

#include <algorithm>
#include <map>

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/source/svg/drawing.hpp"

// The insides of read_cairo_script().
namespace lod2d::cairo_script {

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

}  // namespace lod2d::cairo_script
