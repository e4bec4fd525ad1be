#include "lodlab/viz/paint/space/render.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "lodlab/core/base/stop.hpp"
#include "lodlab/viz/paint/space/ground.hpp"
#include "lodlab/viz/paint/space/layer.hpp"

namespace viz {
namespace {

using Vector3 = lod::Vector<3>;

constexpr int samples = 3;          ///< along each side of a pixel
constexpr int tile = 8;             ///< pixels
constexpr int most_hits = 48;       ///< along one line of sight; what lies behind is not seen
constexpr double hides = 0.5;       ///< what covers so much hides marks behind it
constexpr double alike = 1.0 / 48;  ///< two samples of one colour: no more are needed
static_assert(SurfaceLayer::band_rows % tile == 0);

Vector3 vector(Rgb c) {
    return {c.r, c.g, c.b};
}

/// An ink in light and in shadow.
struct Shades {
    Vector3 dark;
    Vector3 bright;
    Vector3 outline;
    Shades(Rgb rgb, Theme theme, bool clear) {
        const Vector3 ink = vector(rgb);
        dark = (theme == Theme::light ? 0.72 : 0.42) * ink;
        bright = ink + 0.4 * (Vector3::Constant(1) - ink);
        outline = clear && theme == Theme::dark ? bright : Vector3(0.5 * ink);
    }
    [[nodiscard]] Vector3 at(double facing) const {
        return dark + std::max(0.0, facing) * (bright - dark);
    }
};

/// How much a role's surfaces cover, and how strong their lines are.
struct Solidity {
    double fill;  ///< seen straight on; towards its rim a clear ball covers more
    double rim;
    double line;   ///< opacity
    double width;  ///< of the line [px of a page]
    bool meets = false;
    bool doubled = false;
};
Solidity solidity_of(Role role) {
    switch (role) {
        case Role::body:
        case Role::wall:
        case Role::reached:
            return {1, 1, 1, 1.25};
        case Role::ghost:
            return {0.24, 0.5, 0.5, 1};
        case Role::node:
        case Role::dropped_node:
            return {0.03, 0.3, 0.6, 1};
        case Role::meeting_node:
            return {0.3, 0.8, 1, 2.25, true};
        case Role::true_collision:
            return {0.35, 0.85, 1, 2.25, true, true};
        default:
            return {0.18, 0.75, 1, 1.25};
    }
}

struct Hit {
    double depth = std::numeric_limits<double>::infinity();
    Vector3 colour = Vector3::Zero();
    double alpha = 0;
    bool solid = true;  ///< hides marks; the ground does not
};

/// What a line of sight meets, nearest first.
class Hits {
  public:
    void clear() { count_ = 0; }
    void add(const Hit& hit) {
        if (hit.alpha <= 0) return;
        if (count_ == most_hits) {
            if (hit.depth >= hits_[most_hits - 1].depth) return;
            --count_;
        }
        int i = count_++;
        for (; i > 0 && hits_[at(i - 1)].depth > hit.depth; --i) hits_[at(i)] = hits_[at(i - 1)];
        hits_[at(i)] = hit;
    }
    struct Blend {
        Vector3 colour = Vector3::Zero();
        double cover = 0;
        double depth = std::numeric_limits<double>::infinity();  ///< where marks are hidden
    };
    [[nodiscard]] Blend blend() const {
        Blend result;
        double clear = 1;
        double solid_clear = 1;
        for (int i = 0; i < count_; ++i) {
            const Hit& hit = hits_[at(i)];
            result.colour += clear * hit.alpha * hit.colour;
            clear *= 1 - hit.alpha;
            if (hit.solid && solid_clear >= hides) {
                solid_clear *= 1 - hit.alpha;
                if (solid_clear < hides) result.depth = hit.depth;
            }
            if (clear < 1e-3) break;
        }
        result.cover = 1 - clear;
        return result;
    }

  private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    std::array<Hit, most_hits> hits_;
    int count_ = 0;
};

/// A ball ready to be drawn, in the eye's frame.
struct Lit {
    Vector3 centre;
    double radius;
    Shades shades;
    Solidity how;
    double opacity;
    int body;
    std::size_t family;  ///< balls of one style: what is seen is their common outside
};

/// The numbers of the balls that may be seen in each tile.
class Tiles {
  public:
    Tiles(int width, int height)
        : columns_((width + tile - 1) / tile),
          rows_((height + tile - 1) / tile),
          balls_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

    [[nodiscard]] const std::vector<int>& at(int x, int y) const {
        return balls_[static_cast<std::size_t>(y / tile * columns_ + x / tile)];
    }
    /// `cover`: a box of pixels, y down.
    void add(int number, const Box& cover) {
        const auto clamped = [](double v, int count) {
            return static_cast<int>(std::clamp(std::floor(v / tile), -1.0, count + 0.0));
        };
        const int x0 = std::max(0, clamped(cover.low.x, columns_));
        const int x1 = std::min(columns_ - 1, clamped(cover.high.x, columns_));
        const int y0 = std::max(0, clamped(cover.low.y, rows_));
        const int y1 = std::min(rows_ - 1, clamped(cover.high.y, rows_));
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                balls_[static_cast<std::size_t>(y * columns_ + x)].push_back(number);
    }

  private:
    int columns_;
    int rows_;
    std::vector<std::vector<int>> balls_;
};

/// A box of pixels that holds a ball's picture; generous in perspective.
Box cover_of(const Eye& eye, const Vector3& centre, double radius) {
    constexpr double everywhere = 1e9;
    if (eye.perspective && centre.z() <= 1.01 * radius)
        return {{-everywhere, -everywhere}, {everywhere, everywhere}};
    // The silhouette's circle is a little larger than the ball seen from afar.
    const double reach = eye.perspective
                             ? radius / std::sqrt(1 - std::pow(radius / centre.z(), 2)) *
                                   (1 + std::hypot(centre.x(), centre.y()) / centre.z())
                             : radius;
    const double pixels = reach * eye.magnification(centre.z() - (eye.perspective ? radius : 0)) /
                          eye.metres_per_pixel;
    const Point p = eye.pixel(centre);
    return {{p.x - pixels - 1, p.y - pixels - 1}, {p.x + pixels + 1, p.y + pixels + 1}};
}

class SpacePainter {
  public:
    SpacePainter(const SpaceScene& scene, const SpaceRendering& choice)
        : choice_(choice),
          eye_(scene.camera, choice.view, choice.width),
          light_(Vector3(-0.55, 0.75, -0.5).normalized()),
          cut_ink_(vector(pen(choice.theme, Role::true_collision, 0).ink)),
          tiles_(choice.width, choice.height) {
        if (scene.ground) ground_.emplace(*scene.ground, eye_, choice.theme, choice.line);
        for (const Ball& ball : scene.balls) prepare(ball);
        for (const Facets& facets : scene.facets) {
            const Pen look = pen(choice.theme, facets.style);
            const Solidity how = solidity_of(facets.style.role);
            const double opacity = facets.style.opacity;  // lines of a clear body stay strong
            coats_.push_back({Shades(look.inside.value_or(look.ink), choice.theme, false),
                              how.fill * opacity, how.line * std::sqrt(opacity)});
            layers_.emplace_back(
                facets, eye_, light_,
                SurfaceLayer::Grain{how.width * choice.line, choice.height, samples});
        }
    }

    void draw_band(int first_row, SpacePicture& picture) {
        active_.clear();
        for (std::size_t i = 0; i < layers_.size(); ++i)
            if (layers_[i].draw_band(first_row)) active_.push_back(i);
        const int end = std::min(choice_.height, first_row + SurfaceLayer::band_rows);
        for (int y = first_row; y < end; ++y)
            for (int x = 0; x < choice_.width; ++x) draw_pixel(x, y, picture);
    }

  private:
    struct Coat {  ///< of a layer
        Shades shades;
        double fill;
        double line;
    };

    void prepare(const Ball& ball) {
        const Pen look = pen(choice_.theme, ball.style);
        const Vector3 centre = eye_.seen(vector3(ball.centre));
        const Box cover = cover_of(eye_, centre, ball.radius);
        Solidity how = solidity_of(ball.style.role);
        // A line never fills the ball that it surrounds.
        const double pixels = (cover.high.x - cover.low.x) / 2;
        how.width = std::min(how.width * choice_.line, std::max(0.6, 0.16 * pixels));
        tiles_.add(static_cast<int>(lit_.size()), cover);
        const auto family = std::find_if(families_.begin(), families_.end(),
                                         [&](const Style& of) { return same_pen(of, ball.style); });
        const auto number = static_cast<std::size_t>(family - families_.begin());
        if (family == families_.end()) families_.push_back(ball.style);
        lit_.push_back({centre, ball.radius,
                        Shades(look.inside.value_or(look.ink), choice_.theme, true), how,
                        ball.style.opacity, ball.style.body, number});
    }

    [[nodiscard]] Hits::Blend look(int sample_x, int sample_y) {
        const Eye::Ray ray = eye_.ray((sample_x + 0.5) / samples, (sample_y + 0.5) / samples);
        const int x = sample_x / samples;
        const int y = sample_y / samples;
        hits_.clear();
        const std::vector<int>& near = tiles_.at(x, y);
        nearest_.assign(families_.size(), Hit{});
        for (const int i : near) hit_ball(ray, lit_[static_cast<std::size_t>(i)], near);
        for (const Hit& hit : nearest_) hits_.add(hit);
        for (const std::size_t i : active_)
            if (layers_[i].covers(x)) hit_layer(layers_[i].at(sample_x, sample_y), coats_[i]);
        if (ground_) {
            const GroundPicture::Seen seen = ground_->look(ray);
            hits_.add({seen.depth, seen.colour, seen.alpha, false});
        }
        return hits_.blend();
    }

    void hit_layer(const SurfaceLayer::Sample& sample, const Coat& coat) {
        if (!(sample.depth < std::numeric_limits<float>::infinity())) return;
        const bool line = sample.facing == SurfaceLayer::on_line;
        hits_.add({sample.depth, line ? coat.shades.outline : coat.shades.at(sample.facing),
                   line ? coat.line : coat.fill, true});
    }

    void hit_ball(const Eye::Ray& ray, const Lit& ball, const std::vector<int>& near) {
        const Vector3 to = ball.centre - ray.from;
        const double a = ray.along.squaredNorm();
        const double b = to.dot(ray.along);
        const double miss2 = std::max(0.0, to.squaredNorm() - b * b / a);
        const double half2 = ball.radius * ball.radius - miss2;
        if (half2 < 0) return;
        const double depth = (b - std::sqrt(half2 * a)) / a;
        Hit& hit = nearest_[ball.family];
        if (depth <= eye_.nearest_depth() || depth >= hit.depth) return;
        const double pixel = eye_.metres_per_pixel / eye_.magnification(depth);
        const double to_edge = (ball.radius - std::sqrt(miss2)) / pixel;
        const double inner = to_edge - ball.how.width - 2.5 * choice_.line;
        if (to_edge < ball.how.width ||
            (ball.how.doubled && inner > 0 && inner < 1.25 * choice_.line)) {
            hit = {depth, ball.shades.outline, ball.opacity * ball.how.line, true};
            return;
        }
        const Vector3 point = ray.at(depth);
        const Vector3 normal = (point - ball.centre) / ball.radius;
        if (ball.how.meets && on_cut(ball, normal, point, pixel, near)) {
            hit = {depth, cut_ink_, ball.opacity, true};
            return;
        }
        const double turned = 1 - std::abs(normal.dot(ray.along)) / std::sqrt(a);
        const double fill = ball.how.fill + (ball.how.rim - ball.how.fill) * turned * turned;
        hit = {depth, ball.shades.at(normal.dot(light_)), ball.opacity * fill, true};
    }

    /// Whether a point of a ball's surface lies on the circle where a meeting ball of another body
    /// cuts it.
    [[nodiscard]] bool on_cut(const Lit& ball, const Vector3& normal, const Vector3& point,
                              double pixel, const std::vector<int>& near) const {
        const double half_line = 1.25 * choice_.line * pixel;
        for (const int i : near) {
            const Lit& other = lit_[static_cast<std::size_t>(i)];
            if (!other.how.meets || other.body == ball.body) continue;
            const Vector3 from = point - other.centre;
            const double away = from.norm();
            if (std::abs(away - other.radius) > half_line || away == 0) continue;
            const double slope = normal.cross(from / away).norm();
            if (std::abs(away - other.radius) < half_line * slope) return true;
        }
        return false;
    }

    void draw_pixel(int x, int y, SpacePicture& picture) {
        const Hits::Blend first = look(samples * x, samples * y);
        const Hits::Blend last = look(samples * x + samples - 1, samples * y + samples - 1);
        Vector3 colour = (first.colour + last.colour) / 2;
        double cover = (first.cover + last.cover) / 2;
        const double apart = (first.colour - last.colour).cwiseAbs().maxCoeff();
        if (std::max(apart, std::abs(first.cover - last.cover)) > alike) {
            colour *= 2;
            cover *= 2;
            for (int i = 1; i + 1 < samples * samples; ++i) {
                const Hits::Blend more = look(samples * x + i % samples, samples * y + i / samples);
                colour += more.colour;
                cover += more.cover;
            }
            colour /= samples * samples;
            cover /= samples * samples;
        }
        const auto byte = [](double v) {
            return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0)));
        };
        const auto row = static_cast<std::size_t>(y);
        const auto column = static_cast<std::size_t>(x);
        std::uint8_t* out = picture.image.pixels.data() +
                            row * static_cast<std::size_t>(picture.image.stride) + 4 * column;
        out[0] = byte(std::min(colour.z(), cover));
        out[1] = byte(std::min(colour.y(), cover));
        out[2] = byte(std::min(colour.x(), cover));
        out[3] = byte(cover);
        picture.depth[row * static_cast<std::size_t>(choice_.width) + column] =
            static_cast<float>(std::min(first.depth, last.depth));
    }

    const SpaceRendering& choice_;
    Eye eye_;
    Vector3 light_;  ///< where it comes from, in the eye's frame
    Vector3 cut_ink_;
    std::optional<GroundPicture> ground_;
    std::vector<Lit> lit_;
    std::vector<Style> families_;
    std::vector<Hit> nearest_;  ///< of each family, along the present line of sight
    Tiles tiles_;
    std::vector<Coat> coats_;  ///< one a layer
    std::vector<SurfaceLayer> layers_;
    std::vector<std::size_t> active_;  ///< layers that the present band shows
    Hits hits_;
};

}  // namespace

SpacePicture render_space(const SpaceScene& scene, const SpaceRendering& choice) {
    const auto pixels =
        static_cast<std::size_t>(choice.width) * static_cast<std::size_t>(choice.height);
    SpacePicture picture{{choice.width, choice.height, 4 * choice.width, {}}, {}};
    picture.image.pixels.resize(4 * pixels);
    picture.depth.resize(pixels);
    SpacePainter painter(scene, choice);
    for (int row = 0; row < choice.height; row += SurfaceLayer::band_rows) {
        lod::check_interrupted();
        painter.draw_band(row, picture);
    }
    return picture;
}

}  // namespace viz
