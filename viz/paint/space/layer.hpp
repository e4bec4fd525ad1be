#pragma once

#include <vector>

#include "lodlab/viz/paint/space/eye.hpp"

namespace viz {

/// One surface as the eye sees it, ready to be drawn in bands of rows: for each sample of a band
/// its depth and how much it faces the light. Where lines of its silhouette and its sharp edges
/// pass, it says so.
class SurfaceLayer {
  public:
    struct Sample {
        float depth;   ///< infinite: the surface is not there
        float facing;  ///< cosine between normal and light, -1 to 1; on_line: a line passes
    };
    static constexpr float on_line = 2;

    /// How finely a surface is drawn.
    struct Grain {
        double line = 1;  ///< width [pixels]
        int height = 0;   ///< of the picture [pixels]
        int samples = 1;  ///< along each side of a pixel
    };

    /// `light`: unit, in the eye's frame.
    SurfaceLayer(const Facets& facets, const Eye& eye, const lod::Vector<3>& light,
                 const Grain& grain);

    /// Draws the rows from `first_row`, as many as a band has; says whether the surface is there.
    bool draw_band(int first_row);
    static constexpr int band_rows = 32;

    /// Whether a band that has the surface may show it in a column of pixels.
    [[nodiscard]] bool covers(int pixel_x) const {
        return pixel_x >= first_column_ && pixel_x < first_column_ + columns_;
    }
    /// Coordinates of the sample grid; requires covers().
    [[nodiscard]] const Sample& at(int sample_x, int sample_y) const {
        return band_[static_cast<std::size_t>(sample_y - first_row_ * samples_) * row_ +
                     static_cast<std::size_t>(sample_x - first_column_ * samples_)];
    }

  private:
    struct Corner {
        double x;  ///< of the sample grid
        double y;
        double depth;
    };
    struct Segment {
        Corner a;
        Corner b;
        bool sharp;
    };
    void find_facing(const lod::Vector<3>& local_light);
    void find_segments();
    void sort_into_bands(int height);
    void draw_triangle(std::size_t triangle);
    void draw_segment(const Segment& segment);
    [[nodiscard]] bool falls_away_beside(const Segment& segment) const;
    [[nodiscard]] Sample* row_at(int y);
    [[nodiscard]] bool visible(std::size_t triangle) const;

    const Surface& surface_;
    int samples_;
    bool perspective_;
    double half_line_;             ///< [samples]
    double lift_;                  ///< lines win against the surface by so much depth [m]
    std::vector<Corner> corners_;  ///< one a vertex
    std::vector<char> front_;      ///< one a triangle: turned to the eye
    std::vector<std::array<float, 3>> facing_;  ///< the light, one a corner
    std::vector<Segment> segments_;
    std::vector<std::vector<int>> triangles_in_;  ///< of each band
    std::vector<std::vector<int>> segments_in_;
    int first_column_ = 0;
    int columns_ = 0;
    std::size_t row_ = 0;
    int first_row_ = 0;
    std::vector<Sample> band_;
};

}  // namespace viz
