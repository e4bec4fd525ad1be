#pragma once

/// \file
/// A figure for a terminal, in block characters.

#include <string>

#include "lodlab/viz/figure/figure.hpp"
#include "lodlab/viz/paint/options.hpp"

namespace viz {

/// How many colours a terminal shows.
enum class TerminalColours {
    indexed,  ///< the 240 of the usual 256 that are the same everywhere
    direct,   ///< 24 bits
};

/// The size and the colours of a figure in a terminal.
struct BlockOptions {
    int columns = 80;  ///< at most so many characters across, 1 to 1000
    int rows = 30;     ///< and down
    Theme theme = Theme::light;
    TerminalColours colours = TerminalColours::indexed;
};

/// The shapes of a figure, without its words, which would be too small: each character shows four
/// quarters of its cell in two colours. Cells are taken to be twice as high as wide. Lines end with
/// the terminal's own colours. Throws lod::Error (input refused) as the writers of files do.
[[nodiscard]] std::string block_text(const Figure& figure, const BlockOptions& options = {});

}  // namespace viz
