#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "lodlab/lod2d/source/css/css_values.hpp"

namespace lod2d {

/// Selectors of style sheets as a library is to see them, which knows no namespaces.
class SvgSelectors {
  public:
    explicit SvgSelectors(SvgNotes& notes) : notes_(notes) {}

    /// The prelude of a rule @namespace: a prefix, if any, and what it stands for.
    void declare(std::string_view prelude);

    /// Nothing where the rule is to be left out. A doubt where it selects by more than is followed.
    [[nodiscard]] std::optional<std::string> followed(std::string_view selector);

    /// Whether the selector may take an element whose place and size are not those of a shape.
    [[nodiscard]] static bool may_take_viewports(std::string_view selector, const SvgFrame& frame);

  private:
    void check_pseudo_classes(std::string_view selector);

    SvgNotes& notes_;
    std::map<std::string, bool, std::less<>> is_of_svg_;  ///< of a prefix
    bool of_another_ = false;                             ///< names without a prefix
};

}  // namespace lod2d
