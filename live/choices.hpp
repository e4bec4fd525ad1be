#pragma once

/// \file
/// What a stage may be set to by words, in one table: for the calls of a page and for its controls.

#include <span>
#include <string_view>

#include "lodlab/live/stage.hpp"

namespace live {

/// Something that is set to one of several words.
struct StageChoice {
    std::string_view name;
    std::span<const std::string_view> words;        ///< that there are
    void (*choose)(Stage&, std::string_view word);  ///< throws lod::Error (usage) for another
};

/// The one of that name; null where there is none.
[[nodiscard]] const StageChoice* find_stage_choice(std::string_view name);
/// The same. Throws lod::Error (usage), naming all, where there is none.
[[nodiscard]] const StageChoice& stage_choice(std::string_view name);

}  // namespace live
