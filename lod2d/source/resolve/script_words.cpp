#include <algorithm>

#include "lodlab/lod2d/source/resolve/script_reader.hpp"

namespace lod2d::cairo_script {

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

}  // namespace lod2d::cairo_script
