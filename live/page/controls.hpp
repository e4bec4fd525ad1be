#pragma once

/// \file
/// The controls that live/page/controls.js offers, by name: which of them a scene shows.

#include <array>
#include <string_view>

namespace live {

/// Each has an element of this name in controls.js.
inline constexpr std::array<std::string_view, 18> control_names{
    "time",          "speed",    "contacts", "energy",   "level",       "budget",
    "reserve",       "shown",    "tests",    "equation", "restitution", "policy",
    "contact_model", "response", "pairs",    "inside",   "state",       "save"};

/// Names with commas between them; one of a choice may be followed by the words that it offers, all
/// of them where none follow: "level, policy level_order first_come". Throws lod::Error (usage) for
/// a name or word that there is not.
void check_controls(std::string_view controls);

}  // namespace live
