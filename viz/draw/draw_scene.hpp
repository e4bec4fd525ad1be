#pragma once

/// \file
/// The parts that figures of bodies are made of: outlines, nodes, contacts, impulses. World frame,
/// metres. In the plane all goes into the panel's marks; in space bodies and nodes go into its
/// scene, and what stands for points and ways into marks over it, pale where a surface hides them.

#include <span>

#include "lodlab/viz/draw/scene_view.hpp"

namespace viz {

/// Marks in the order in which they are drawn.
using Marks = std::vector<Mark>;

/// An empty panel that shows a view.
template <int Dim>
[[nodiscard]] Panel blank_panel(const View<Dim>& view);

/// The outline of a body (its leaves where it has none): a wall where it is static.
template <int Dim>
void add_body(Panel& panel, const Actor<Dim>& actor, int number, double opacity = 1);

/// The same in any style.
template <int Dim>
void add_body(Panel& panel, const Actor<Dim>& actor, const Style& style);

/// The outline as it was at another time.
template <int Dim>
void add_ghost(Panel& panel, const Actor<Dim>& actor, int number, double opacity);

/// Nodes of the body's tree, all in one style, each with its level.
template <int Dim>
void add_nodes(Panel& panel, const lod::Body<Dim>& body, std::span<const int> nodes,
               const Style& style);
/// The same of the body of that number.
template <int Dim>
void add_nodes(Panel& panel, const lod::Body<Dim>& body, std::span<const int> nodes, Role role,
               int number) {
    add_nodes<Dim>(panel, body, nodes, Style{.role = role, .body = number});
}

/// A body and its number in a picture.
template <int Dim>
struct NumberedBody {
    const lod::Body<Dim>& body;
    int number = 0;
};

/// The nodes of both bodies that a list of pairs names, each once: meeting nodes, or true
/// collisions where a leaf meets a leaf.
template <int Dim>
void add_meeting_nodes(Panel& panel, const NumberedBody<Dim>& a, const NumberedBody<Dim>& b,
                       std::span<const lod::NodePair> pairs, double opacity = 1);

/// A dot for every contact; smaller dots where there are many.
template <int Dim>
void add_contact_points(Panel& panel, std::span<const lod::Contact<Dim>> contacts,
                        double opacity = 1);

/// Arrows of one length [m] along the normals, from the points: none where there are more than 16.
template <int Dim>
void add_normals(Panel& panel, std::span<const lod::Contact<Dim>> contacts, double length,
                 double opacity = 1);

/// An arrow, its label beside its tip.
template <int Dim>
void add_arrow(Panel& panel, const Style& style, const lod::Vector<Dim>& tail,
               const lod::Vector<Dim>& tip, const std::string& label);

/// A line through points.
template <int Dim>
void add_line(Panel& panel, const Style& style, std::span<const lod::Vector<Dim>> points,
              double start_opacity);

/// Whether a spin is said in words.
enum class SpinWords { left_out, shown };

/// The velocity of a body's centre as an arrow, `metres_per_speed` long for 1 m/s, with its value
/// and, where asked for, the spin below it.
template <int Dim>
void add_velocity(Panel& panel, const NumberedBody<Dim>& numbered, double metres_per_speed,
                  double opacity = 1, SpinWords spin = SpinWords::left_out);

/// The name of one of several bodies, with a letter behind it where two have the same.
template <int Dim>
[[nodiscard]] std::string shown_name(const std::vector<Visual<Dim>>& visuals, std::size_t number);

/// A name beside the body's outline, on the side away from a point of the panel.
template <int Dim>
void add_name(Panel& panel, const Actor<Dim>& actor, const std::string& name, int number,
              Point away_from);

/// The names of two bodies, each on the side away from the other; beside the root nodes where those
/// are drawn.
enum class Beside { outlines, roots };
/// Numbers 0 and 1.
template <int Dim>
void add_names(Panel& panel, const Actor<Dim>& a, const Actor<Dim>& b,
               Beside beside = Beside::outlines);

/// The body that a pair's nodes belong to, by number.
template <int Dim>
[[nodiscard]] Actor<Dim> actor_of(const Run<Dim>& run, std::size_t instant, int number);

/// The distance between the outlines of two bodies [m]: 0 where they overlap, negative where it is
/// not known.
template <int Dim>
[[nodiscard]] double gap(const Actor<Dim>& a, const Actor<Dim>& b);

/// All contacts of a record.
template <int Dim>
[[nodiscard]] std::vector<lod::Contact<Dim>> contacts_of(const lod::FrameRecord<Dim>& record);

/// The overlapping nodes behind a pair's contacts; none where these come from the shapes
/// themselves.
template <int Dim>
[[nodiscard]] std::span<const lod::NodePair> nodes_of(const lod::FrameRecord<Dim>& record,
                                                      const lod::PairRecord& pair);

/// The words of a verdict: "not colliding", "possible collision", "true collision".
[[nodiscard]] const char* verdict_words(lod::Verdict verdict);

/// The same point as figures have it.
[[nodiscard]] inline Point point_of(const lod::Vector<2>& v) {
    return {v.x(), v.y()};
}

}  // namespace viz
