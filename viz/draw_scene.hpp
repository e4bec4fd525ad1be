#pragma once

#include <span>

#include "viz/scene_view.hpp"

// Marks that every drawing of bodies is made of. World frame, metres.

namespace viz {

using Marks = std::vector<Mark>;

/// The outline of a body (its leaves where it has none): a wall where it is static.
void add_body(Marks& marks, const Actor& actor, int number, double opacity = 1);

/// The outline as it was at another time.
void add_ghost(Marks& marks, const Actor& actor, int number, double opacity);

/// Nodes of the body's tree.
void add_nodes(Marks& marks, const lod::Body<2>& body, std::span<const int> nodes, Role role,
               int number, double opacity = 1);

/// The nodes of both bodies that a list of pairs names, each once: meeting nodes, or true
/// collisions where a leaf meets a leaf.
void add_meeting_nodes(Marks& marks, const lod::Body<2>& a, const lod::Body<2>& b, int number_a,
                       int number_b, std::span<const lod::NodePair> pairs, double opacity = 1);

/// A dot for every contact; smaller dots where there are many.
void add_contact_points(Marks& marks, std::span<const lod::Contact<2>> contacts,
                        double opacity = 1);

/// Arrows of one length [m] along the normals, from the points: none where there are more than 16.
void add_normals(Marks& marks, std::span<const lod::Contact<2>> contacts, double length,
                 double opacity = 1);

enum class SpinWords { left_out, shown };

/// The velocity of a body's centre as an arrow, `metres_per_speed` long for 1 m/s, with its value
/// and, where asked for, the spin below it.
void add_velocity(Marks& marks, const lod::Body<2>& body, int number, double metres_per_speed,
                  double opacity = 1, SpinWords spin = SpinWords::left_out);

/// The name of one of several bodies, with a letter behind it where two have the same.
[[nodiscard]] std::string shown_name(const std::vector<Look>& looks, std::size_t number);

/// A name beside the body's outline, on the side away from a point.
void add_name(Marks& marks, const Actor& actor, const std::string& name, int number,
              Point away_from);

/// The names of two bodies, each on the side away from the other; beside the root nodes where those
/// are drawn.
enum class Beside { outlines, roots };
void add_names(Marks& marks, const Actor& a, const Actor& b, Beside beside = Beside::outlines);

/// The body that a pair's nodes belong to, by number.
[[nodiscard]] Actor actor_of(const Run& run, std::size_t instant, int number);

/// All contacts of a record.
[[nodiscard]] std::vector<lod::Contact<2>> contacts_of(const lod::FrameRecord<2>& record);

/// The words of a verdict: "not colliding", "possible collision", "true collision".
[[nodiscard]] const char* verdict_words(lod::Verdict verdict);

[[nodiscard]] inline Point point_of(const lod::Vector<2>& v) {
    return {v.x(), v.y()};
}
[[nodiscard]] double longer_side(const Box& box);

}  // namespace viz
