#pragma once

/// \file
/// A picture as data: panels of marks with roles, no colours and no pixels. You may make one by
/// hand.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace viz {

/// A point of a panel: metres in a scene (x to the right, y up), units of the axes in a plot.
struct Point {
    double x = 0;
    double y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

using Ring = std::vector<Point>;  ///< closed: the last point joins the first

/// What a mark stands for. A palette turns a role into ink, line and fill (viz/paint/palette.hpp).
enum class Role {
    body,            ///< outline of a body, faintly filled, in the body's ink
    wall,            ///< a body that no impulse moves
    ghost,           ///< outline of a body at an earlier time, in the body's ink
    node,            ///< a node that does not go on
    level_node,      ///< a node of the level that a picture shows, in its body's ink
    meeting_node,    ///< a node that intersects one of the other body: bold, in its body's ink
    true_collision,  ///< a leaf that intersects a leaf: doubled, so that grey print shows it
    dropped_node,    ///< a node whose tests are thrown away: dashed, in its body's ink
    contact,         ///< contact point
    normal,          ///< contact normal
    impulse,
    velocity,      ///< in the body's ink
    trajectory,    ///< in the body's ink, fading into the past
    reference,     ///< exact or Box2D: dashed, thinner
    curve,         ///< a curve of a plot, in the ink of series `body`
    band,          ///< what a curve spreads over, in the ink of series `body`
    construction,  ///< lines that only help to see: centre lines, radii, lids
    reached,       ///< a body filled by the level that its pairs reached: `level`
    share,         ///< a part of a bar, told from its neighbours by tone: `body` 0, 1, ...
    excess,        ///< the part of a bar that is beyond what it may be
    note,          ///< words
};

/// The deepest level that Role::reached has an ink of its own for; deeper ones share it.
inline constexpr int deepest_ink = 5;

/// The role's name in JSON: "meeting_node".
[[nodiscard]] const char* role_name(Role role);

/// Belongs to every mark.
struct Style {
    Role role = Role::note;
    int body = 0;    ///< whose ink: 0 is A, 1 is B, more follow; series number in a plot
    int level = -1;  ///< of the tree, -1 where it has none: for readers of the data, and the ink
                     ///< of Role::reached
    double opacity = 1;  ///< 0 to 1: age of a ghost, a mark that is just appearing
};

/// A disc of true size. radius >= 0.
struct Disc {
    Style style;
    Point centre;
    double radius = 0;
};

/// How far in front of the eye a mark over a scene in space lies [m], along the view: what lies
/// behind a surface is drawn pale. This one: in front of everything.
inline constexpr double in_front = -1e12;

/// A dot of constant size on the page; `size` 1 is the usual one.
struct Dot {
    Style style;
    Point at;
    double size = 1;  ///< 0.2 to 3
    double depth = in_front;
};

/// A region bounded by rings, holes by the even-odd rule.
struct Path {
    Style style;
    std::vector<Ring> rings;
};

/// An open line. `start_opacity` < 1 lets it fade in from its first point: the past of a
/// trajectory. `end_label` names it at its last point.
struct Polyline {
    Style style;
    std::vector<Point> points;
    double start_opacity = 1;
    std::string end_label;
    std::vector<double> depths{};  ///< one a point, or none: in_front
};

/// An arrow; `label` stands beside its tip (the value of an impulse).
struct Arrow {
    Style style;
    Point tail;
    Point tip;
    std::string label;
    double tail_depth = in_front;
    double tip_depth = in_front;
};

/// Words beside what they name, in its ink: placed by the canvas round the anchor, at least
/// `clearance` away (the radius of a disc, in the panel's units), and never over the anchor's mark
/// or another label.
struct Label {
    Style style;
    Point anchor;
    std::string text;
    double clearance = 0;
};

/// What a mark can be.
using AnyMark = std::variant<Disc, Dot, Path, Polyline, Arrow, Label>;

/// Any of the marks. Copied and moved out of line: g++ 12 warns falsely where it inlines them.
struct Mark : AnyMark {
    using AnyMark::AnyMark;
    /// Copied and moved as any value.
    /// @{
    Mark(const Mark& other);
    Mark(Mark&& other) noexcept;
    Mark& operator=(const Mark& other);
    Mark& operator=(Mark&& other) noexcept;
    /// @}
    ~Mark();
};

/// A point of the world in space [m]; y is up.
struct Point3 {
    double x = 0;
    double y = 0;
    double z = 0;
    friend bool operator==(const Point3&, const Point3&) = default;
};

/// Where the reader stands. World frame, metres. The point on the panel under a point of space lies
/// at metres as long as they look at the target's distance, from the target at the origin, x to the
/// right, y up (viz/figure/camera.hpp).
struct Camera {
    Point3 eye{0, 0, 5};
    Point3 target{0, 0, 0};    ///< not the eye
    Point3 up{0, 1, 0};        ///< not along the view
    bool perspective = false;  ///< for showing; orthographic, which sees behind the eye too, for
                               ///< comparing
};

/// A ball of true size in space. radius >= 0.
struct Ball {
    Style style;
    Point3 centre;
    double radius = 0;
};

/// Triangles in space, anticlockwise seen from outside. Body frame, metres. See surface_of.
struct Surface {
    std::vector<Point3> vertices;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<Point3, 3>> normals;  ///< one a corner: smooth but over sharp edges
    /// An edge between two triangles, or at the border.
    struct Edge {
        int from = 0;
        int to = 0;
        int left = 0;        ///< one of its triangles
        int right = -1;      ///< the other; -1: none
        bool sharp = false;  ///< drawn wherever it is seen; others on the silhouette only
    };
    std::vector<Edge> edges;
    std::vector<Point3> outermost;  ///< furthest in many directions: enough to frame the surface
};

/// A surface where its body stands: x -> origin + axes x.
struct Facets {
    Style style;
    std::shared_ptr<const Surface> surface;  ///< never null
    Point3 origin;
    std::array<Point3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< columns, unit vectors
};

/// A level grid under the bodies that takes their soft contact shadows.
struct Ground {
    double height = 0;          ///< y of the plane [m]
    double spacing = 1;         ///< between the grid's lines [m], > 0
    Point3 centre;              ///< the grid fades out round this place
    double reach = 1;           ///< ... so far from it [m], > 0
    std::vector<Ball> casters;  ///< what casts shadows: a coarse level of each body's tree
};

/// Bodies in space as data. A canvas shows them as a shaded picture in which surfaces hide, shine
/// through and cut each other where they truly do.
struct SpaceScene {
    Camera camera;
    std::vector<Ball> balls;
    std::vector<Facets> facets;
    std::optional<Ground> ground;
};

/// A box of the panel's coordinates.
struct Box {
    Point low;
    Point high;
};

/// How values are laid along an axis.
enum class Scale { linear, logarithmic };

/// One axis of a plot.
struct Axis {
    std::string label;  ///< with the unit: "time [s]"
    Scale scale = Scale::linear;
    std::vector<double> ticks;   ///< chosen by the canvas when empty
    bool whole_numbers = false;  ///< ticks at whole numbers only (levels, counts)
    bool hidden = false;         ///< neither ticks nor name: the values mean nothing
};

/// The axes of a plot.
struct Axes {
    Axis x;
    Axis y;
};

/// Where a panel stands in the figure's grid, counted from the top left.
struct Cell {
    int row = 0;
    int column = 0;
    int rows = 1;
    int columns = 1;
};

/// A line of a list: what is drawn so, and how much there is of it.
struct Entry {
    Style style;
    std::string words;
    std::string value{};  ///< at the right end
};

/// One picture of a figure. A scene keeps its shape (one metre is as long across as up) and shows
/// at least `view`; a plot (with axes) stretches `view` over its cell. A scene in space is drawn
/// first, as its camera sees it; marks are drawn over it in order, words last.
struct Panel {
    std::string title;
    Box view;
    std::optional<Axes> axes;
    std::vector<Mark> marks;
    std::optional<Cell> cell;  ///< the next free cell when not set
    std::optional<SpaceScene> space{};
    std::vector<Entry> entries{};  ///< where there are any the panel is a list of them, no picture
};

/// Whether a panel shows a scene: it is neither a plot nor a list.
[[nodiscard]] inline bool shows_scene(const Panel& panel) {
    return !panel.axes && panel.entries.empty();
}

/// A number that matters, shown top right: "tests", "48".
struct Quantity {
    std::string name;
    std::string value;
};

/// A picture that answers one question, as data. Texts may hold `*v*` for italics (symbols of the
/// equations) and `_a` or `_{ab}` for subscripts; a backslash before a character
/// shows the character itself.
struct Figure {
    std::string title;              ///< a sentence
    std::vector<Quantity> numbers;  ///< top right
    std::string caption;            ///< one line at the foot
    std::string alt;                ///< the same picture in words, made from the record
    std::vector<Panel> panels;
    int columns = 0;                         ///< of the grid; 0: chosen by the number of panels
    std::vector<double> column_weights;      ///< relative widths; equal when empty
    std::vector<double> row_weights;         ///< relative heights; equal when empty
    std::vector<std::string> row_titles;     ///< left of each row of the grid, or empty
    std::vector<std::string> column_titles;  ///< above each column of the grid, or empty
    bool shared_scale = true;                ///< all scene panels show a metre equally long
    bool scale_bar = true;                   ///< a bar with its length, where there is a scene
    double aspect = 16.0 / 9;                ///< width over height of the page, 0.2 to 5
};

/// A figure held for a number of frames.
struct Shot {
    std::function<Figure()> draw;  ///< called when its turn comes, perhaps twice
    int frames = 1;                ///< >= 1
};

/// A video, as data.
struct Animation {
    double frames_per_second = 30;
    std::string title;  ///< kept in the file where the format has a place for it
    std::vector<Shot> shots;
};

/// The number of frames of the whole animation.
[[nodiscard]] int frame_count(const Animation& animation);

/// Adds one figure, held for so many seconds (at least one frame).
void hold(Animation& animation, Figure figure, double seconds);

/// The text without the marks of italics and subscripts.
[[nodiscard]] std::string plain_text(const std::string& text);

/// A name from outside (a file, a scene) as a text that shows it letter by letter.
[[nodiscard]] std::string literal_text(const std::string& name);

}  // namespace viz
