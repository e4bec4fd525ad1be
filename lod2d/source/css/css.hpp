#pragma once

#include <map>
#include <string>
#include <string_view>

#include "lodlab/lod2d/source/css/css_selectors.hpp"

namespace lod2d {

/// Rewrites CSS so that a library with an old or small CSS understands it as a browser does: names
/// and keywords in lower case, comments gone, @media of screens opened, the custom properties of
/// the root put in place. What it cannot say so is a doubt in the notes.
class SvgCss {
  public:
    explicit SvgCss(SvgNotes& notes) : notes_(notes) {}

    void set_frame(const SvgFrame& frame) { frame_ = frame; }

    /// Learns the custom properties (--name: value) of a sheet, or of the root's own declarations.
    void learn(std::string_view sheet);
    void learn_root(std::string_view declarations);

    [[nodiscard]] std::string sheet(std::string_view text);
    /// The insides of `style`, or of a rule.
    [[nodiscard]] std::string declarations(std::string_view text);
    /// What `display` is instead of an opacity: "none" for 0, else "" or, where a sheet fades,
    /// "inline". Opacity makes groups, whose drawing is another; all that counts of it is nothing.
    [[nodiscard]] std::string display_for(std::string_view opacity);
    /// The value of a property; "" where the declaration is to be left out.
    [[nodiscard]] std::string value(std::string_view property, std::string_view text);

    [[nodiscard]] bool sheets_transform() const { return transforms_; }

  private:
    struct Custom {
        std::string value;
        bool of_root = true;  ///< every declaration is
    };
    void learn_from(std::string_view declarations, bool of_root);
    std::string at_rule(std::string_view name, std::string_view prelude, std::string_view block);
    void put_declaration(const std::string& name, std::string_view text, std::string& result);
    /// With custom properties put in place, so many at most.
    std::string substituted(std::string text, int& left);

    SvgNotes& notes_;
    SvgSelectors selectors_{notes_};
    SvgFrame frame_;
    bool transforms_ = false;   ///< a sheet has transform
    bool sheets_fade_ = false;  ///< a sheet has opacity: 0
    bool sheets_display_ = false;
    std::map<std::string, Custom, std::less<>> custom_;
};

/// Whether a media query is right of a screen of unknown size; nothing where that decides.
[[nodiscard]] bool is_for_screens(std::string_view query, bool& known);

}  // namespace lod2d
