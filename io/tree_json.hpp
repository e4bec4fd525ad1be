#pragma once

/// \file
/// A tree in a JSON file and back, to the same bits.

#include <filesystem>
#include <string>
#include <string_view>

#include "lodlab/core/tree/tree.hpp"

namespace io {

/// A tree as JSON text, without loss: every number is the shortest that reads back to the same
/// bits.
///
///     {"format": "lodlab tree", "version": 2, "dim": 2, "nodes": 5, "levels": [1, 4],
///      "entry_level": 0, "tree": [
///        {"centre": [0, 0], "radius": 1, "normal": [0, 0], "children": [1, 2, 3, 4],
///         "hull": {"corners": [[-1, -1], ...], "faces": [[0, 1], ...], "inner": [2], "cut": [4]}},
///        {"centre": [0.5, 0.5], "radius": 0.5, "normal": [0.6, 0.6], "children": []},
///        ...]}
///
/// Nodes stand level by level, the root first, a node's children side by side; a child is named by
/// its place in the list, from 0. Metres, body frame; the normal is the mean outward unit normal of
/// the surface that a node stands for. "nodes" and "levels" (nodes of each level) are checked.
///
/// A tree with hulls (core/tree/hull.hpp) has an "entry_level", and every node a "hull" but those
/// below a "tight" one: its faces by their corners' places; "inner" names the faces within the
/// shape, "cut" the corners that only a cut made (left out where there are none), "tight" and
/// "round" are true where they stand.
template <int Dim>
[[nodiscard]] std::string tree_to_json(const lod::SphereTree<Dim>& tree);

/// Reads what tree_to_json wrote, to the same bits. `source` names the text in errors.
/// Throws lod::Error (input refused) where the text is not such a tree: other format, version or
/// dimension, missing or wrong keys, numbers that are not finite, a negative radius, a normal
/// longer than 1, children that do not exist, come twice or out of order, counts that are not so.
template <int Dim>
[[nodiscard]] lod::SphereTree<Dim> tree_from_json(std::string_view text, const std::string& source);

/// Complete or absent (io/files/output_file.hpp). Throws lod::Error (output failed).
template <int Dim>
void save_tree(const std::filesystem::path& path, const lod::SphereTree<Dim>& tree);

/// Throws lod::Error: input refused, or limit exceeded for files larger than most_bytes.
template <int Dim>
[[nodiscard]] lod::SphereTree<Dim> load_tree(const std::filesystem::path& path,
                                             std::size_t most_bytes = 512 * 1024 * 1024);

}  // namespace io
