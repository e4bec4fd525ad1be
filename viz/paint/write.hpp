#pragma once

/// \file
/// A figure as PNG, SVG, PDF or JSON, by its file's ending.

#include <filesystem>
#include <string>

#include "lodlab/viz/figure/figure.hpp"
#include "lodlab/viz/paint/options.hpp"

namespace viz {

/// Every writer makes a file that is complete or absent, the same bytes for the same input. They
/// throw lod::Error: input refused for a figure that cannot be drawn (a number that is not finite,
/// a radius below zero, an empty view), naming the panel and the mark; output failed for an
/// unwritable folder or a full disk.
void write_png(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options = {});
/// An SVG of the page.
void write_svg(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options = {});
/// A PDF of the page.
void write_pdf(const std::filesystem::path& path, const Figure& figure,
               const WriteOptions& options = {});

/// A small SVG for browsers, for both themes: light, or dark where its reader prefers that. Shaded
/// surfaces in it are WebP, and coordinates are rounded to what can be seen. The page is `width`
/// units wide, in which words keep their size: the narrower, the larger they are beside the shapes.
/// Throws as the others do.
void write_web_svg(const std::filesystem::path& path, const Figure& figure, double width = 1280);

/// The same as text, to stand within a page.
[[nodiscard]] std::string web_svg_text(const Figure& figure, double width = 1280);

/// Picks the format by the ending: png, svg, pdf, json. Any other ending throws lod::Error (usage).
void write_figure(const std::filesystem::path& path, const Figure& figure,
                  const WriteOptions& options = {});

/// Whether a path's ending names a still picture (png svg pdf json).
[[nodiscard]] bool is_figure_path(const std::filesystem::path& path);

/// The names of the versions of the drawing libraries in use, for `lodlab doctor`.
[[nodiscard]] std::string drawing_libraries();

}  // namespace viz
