#pragma once

/// \file
/// A scene of the plane as a page of one file, which runs in a browser without any network.

#include <string>
#include <string_view>

#include "lodlab/live/scene.hpp"

namespace live {

/// Whether this build has the module that runs in a page.
[[nodiscard]] bool has_module();
/// Throws lod::Error (not installed), with the mend, where it has none.
void check_module();

/// What every page needs that holds scenes: for pages of several files, which share it. Its script
/// offers lodlabLive.mount (live/page/live.js), the module lodlabModule.
struct Component {
    std::string style;
    std::string script;
    std::string_view module;
};
/// Throws as check_module.
[[nodiscard]] Component component();

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
