#include <numbers>

#include "lodlab/lod2d/source/svg/text.hpp"

namespace lod2d {
namespace {

/// Draws a path from the text of `d`, one command at a time.
class PathParser {
  public:
    explicit PathParser(std::string_view d) : reader_(d) {}

    CurvePath parse() {
        if (reader_.at_end()) return {};
        if (reader_.peek() != 'M' && reader_.peek() != 'm') reader_.fail("M or m to begin");
        while (!reader_.at_end()) run(command());
        return std::move(path_);
    }

  private:
    char command() {
        static constexpr std::string_view known = "MmLlHhVvCcSsQqTtAaZz";
        if (known.find(reader_.peek()) == std::string_view::npos)
            reader_.fail("one of the commands M L H V C S Q T A Z");
        return reader_.take();
    }

    /// A command letter draws once for every set of numbers after it.
    void run(char letter) {
        relative_ = letter >= 'a';
        const char upper = relative_ ? static_cast<char>(letter - 'a' + 'A') : letter;
        if (upper == 'Z') {
            path_.close();
            previous_ = 'Z';
            return;
        }
        char drawing = upper;
        reader_.skip_spaces();
        do {
            draw(drawing);
            previous_ = drawing;
            if (drawing == 'M') drawing = 'L';
            reader_.skip_separator();
        } while (reader_.number_follows());
    }

    void draw(char upper) {
        const Point from = path_.current();
        switch (upper) {
            case 'M':
                path_.move_to(point());
                break;
            case 'L':
                path_.line_to(point());
                break;
            case 'H':
                path_.line_to({number() + (relative_ ? from.x() : 0), from.y()});
                break;
            case 'V':
                path_.line_to({from.x(), number() + (relative_ ? from.y() : 0)});
                break;
            case 'C': {
                const Point control = point();
                cubic(control);
                break;
            }
            case 'S':
                cubic(previous_ == 'C' || previous_ == 'S' ? mirrored() : from);
                break;
            case 'Q':
                quadratic(point());
                break;
            case 'T':
                quadratic(previous_ == 'Q' || previous_ == 'T' ? mirrored() : from);
                break;
            case 'A':
                arc();
                break;
            default:
                break;
        }
    }

    void cubic(const Point& control_1) {
        control_ = point();
        const Point to = point();
        path_.cubic_to(control_1, control_, to);
    }

    void quadratic(const Point& control) {
        control_ = control;
        path_.quadratic_to(control, point());
    }

    void arc() {
        const double rx = number();
        const double ry = number();
        const double tilt = number() * (std::numbers::pi / 180);
        reader_.skip_separator();
        const bool large = reader_.flag();
        reader_.skip_separator();
        const bool sweep = reader_.flag();
        path_.arc_to({rx, ry, tilt, large, sweep}, point());
    }

    [[nodiscard]] Point mirrored() const { return 2 * path_.current() - control_; }

    double number() {
        reader_.skip_separator();
        return reader_.number();
    }

    Point point() {
        const double x = number();
        const double y = number();
        return relative_ ? Point(path_.current() + Point(x, y)) : Point(x, y);
    }

    SvgReader reader_;
    CurvePath path_;
    bool relative_ = false;
    char previous_ = 'M';
    Point control_ = Point::Zero();  ///< of the last curve, for S and T
};

}  // namespace

CurvePath parse_svg_path(std::string_view d) {
    return PathParser(d).parse();
}

}  // namespace lod2d
