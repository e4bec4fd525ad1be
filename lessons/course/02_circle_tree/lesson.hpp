#pragma once

#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/lod2d/builder/piece.hpp"
#include "lodlab/lod2d/builder/tree_report.hpp"

namespace lessons::tree {

using Tree = lod::SphereTree<2>;
using Facts = std::vector<lod2d::LevelReport>;

/// The shape of the lesson with its tree and what each level is worth.
struct Crescent {
    lod2d::Shape shape;
    std::shared_ptr<const Tree> tree;
    viz::Actor<2> body;
    viz::Box view;  ///< holds every circle, so that all pictures share it
    Facts facts;
};

/// The outline alone, in the shared view.
[[nodiscard]] viz::Panel panel_of(const Crescent& crescent);

/// What of its parent's piece each child of a node owns.
[[nodiscard]] std::vector<lod2d::PolygonPiece> pieces_of_children(const lod2d::PolygonPiece& piece,
                                                                  const Tree& tree, int node);

/// Draws a piece in the ink of body `index`.
void add_piece(viz::Panel& panel, const lod2d::PolygonPiece& piece, int index);

/// What a tree without coverage does, and the certificate (bad_tree.cpp).
void give_bad_tree(Lesson& lesson, const Crescent& crescent);

}  // namespace lessons::tree
