#pragma once

/// \file
/// A scene of the plane as a page of one file, which runs in a browser without any network.

#include <string>

#include "lodlab/live/scene.hpp"

namespace live {

/// Throws lod::Error (not installed), with the mend, where this build has no module for pages.
void check_module();

/// The page as HTML: the scene, the module that runs it, and the still picture of the scene's start
/// for readers without JavaScript. Throws as check_module.
[[nodiscard]] std::string page_text(const Scene& scene);

}  // namespace live
