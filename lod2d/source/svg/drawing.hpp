#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lodlab/lod2d/source/paths/filled_paths.hpp"
#include "lodlab/lod2d/source/paths/stroke.hpp"

namespace lod2d {

/// What a drawing's reader has to say, for the user: a remark each.
struct SvgNotes {
    struct Kind {
        std::string one;   ///< "text"
        std::string many;  ///< "texts"
        std::size_t count = 0;
    };

    std::vector<Kind> left_out;        ///< drawn by a browser, and not part of the shape
    std::vector<Kind> whole;           ///< part of the shape as a whole, where a browser shows some
    std::vector<std::string> doubts;   ///< what may be seen in another way, a line each
    std::vector<std::string> remarks;  ///< how it was read

    static void count(std::vector<Kind>& kinds, const std::string& one, const std::string& many,
                      std::size_t more = 1);
    void doubt(const std::string& line);  ///< once each

    /// All of it as lines, but for how it was read: what `strict` refuses.
    [[nodiscard]] std::vector<std::string> losses() const;
};

/// Regions, all of which something must lie in to be seen.
using SvgClips = std::vector<std::shared_ptr<const FilledPath>>;

struct SvgFill {
    FilledPath region;  ///< frame of the page
    SvgClips clips;     ///< frame of the page
};

/// A line drawn with a pen, both in the frame of its element.
struct SvgStroke {
    CurvePath path;
    StrokeStyle style;
    Affine to_page;
    bool around_fill = false;  ///< the same path is filled too
    SvgClips clips;            ///< frame of the page
};

/// What a document draws. The frame of the page is turned upright (y up), in units of any size.
struct SvgDrawing {
    std::vector<SvgFill> fills;
    std::vector<SvgStroke> strokes;
    std::optional<Box> page;  ///< what a browser shows of it; nothing: all
    bool plain = false;       ///< read by ourselves, to the last bit
    SvgNotes notes;
};

}  // namespace lod2d
