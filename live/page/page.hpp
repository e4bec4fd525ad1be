#pragma once

/// \file
/// A scene of the plane as a page of one file, which runs in a browser without any network.

#include <string>

#include "lodlab/live/scene.hpp"

namespace live {

/// Throws lod::Error (not installed), with the mend, where this build has no module for pages.
void check_module();

/// What a page offers beside its scene.
enum class PageKind {
    scene,       ///< nothing
    playground,  ///< outlines that are drawn, or dropped, become the bodies
};

/// The page as HTML: the scene, the module that runs it, and the still picture of the scene's start
/// for readers without JavaScript. Throws as check_module.
[[nodiscard]] std::string page_text(const Scene& scene, PageKind kind = PageKind::scene);

/// A playground that begins with a star and a gear. Throws as check_module.
[[nodiscard]] std::string playground_text();

}  // namespace live
