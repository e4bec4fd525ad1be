#include "lodlab/viz/paint/space/ground.hpp"

#include <cmath>

namespace viz {
namespace {

using Vector3 = lod::Vector<3>;

constexpr int lattice = 192;  ///< places along each side
constexpr double least_slope = 1e-3;

/// How much of the evenly bright sky a ball hides from a point of the ground (exact where the ball
/// stands wholly above the ground).
double hidden_sky(const Ball& ball, const Vector3& point) {
    const Vector3 to = vector3(ball.centre) - point;
    const double r2 = ball.radius * ball.radius;
    const double d2 = std::max(to.squaredNorm(), r2);
    return std::min(1.0, std::max(0.0, to.y()) * r2 / (d2 * std::sqrt(d2)));
}

}  // namespace

GroundPicture::GroundPicture(const Ground& ground, const Eye& eye, Theme theme, double line)
    : eye_(eye),
      height_(ground.height),
      spacing_(ground.spacing),
      reach_(ground.reach),
      centre_(vector3(ground.centre)),
      world_up_(eye.turned(Vector3::UnitY())),
      half_line_(0.5 * line) {
    const PageInks inks = page_inks(theme);
    const bool dark = theme == Theme::dark;
    const Rgb grid = mixed(inks.grid, inks.muted, dark ? 0.25 : 0.2);
    grid_ink_ = {grid.r, grid.g, grid.b};
    shadow_ink_ = dark ? Vector3::Zero() : Vector3(0.12, 0.14, 0.18);
    shadow_strength_ = dark ? 0.75 : 0.5;
    cast(ground);
}

void GroundPicture::cast(const Ground& ground) {
    shade_.resize(static_cast<std::size_t>(lattice) * lattice);
    for (int i = 0; i < lattice; ++i) {
        for (int j = 0; j < lattice; ++j) {
            const auto along = [](int k) { return 2.0 * k / (lattice - 1) - 1; };
            const Vector3 point(centre_.x() + reach_ * along(j), height_,
                                centre_.z() + reach_ * along(i));
            double open = 1;
            for (const Ball& caster : ground.casters) open *= 1 - hidden_sky(caster, point);
            shade_[static_cast<std::size_t>(i * lattice + j)] = static_cast<float>(1 - open);
        }
    }
}

double GroundPicture::shade(double x, double z) const {
    const auto place = [](double v) {
        return std::clamp((v + 1) / 2, 0.0, 1.0) * (lattice - 1.001);
    };
    const double u = place(x);
    const double v = place(z);
    const auto column = static_cast<std::size_t>(u);
    const auto row = static_cast<std::size_t>(v);
    const double s = u - static_cast<double>(column);
    const double t = v - static_cast<double>(row);
    const float* at = &shade_[row * lattice + column];
    return (1 - t) * ((1 - s) * at[0] + s * at[1]) +
           t * ((1 - s) * at[lattice] + s * at[lattice + 1]);
}

GroundPicture::Seen GroundPicture::look(const Eye::Ray& ray) const {
    const double falls = -ray.along.dot(world_up_);
    if (falls < least_slope) return {};
    const double depth = (eye_.origin.y() + ray.from.dot(world_up_) - height_) / falls;
    if (depth <= eye_.nearest_depth()) return {};
    const Vector3 point = eye_.world(ray.at(depth));
    const double x = point.x() - centre_.x();
    const double z = point.z() - centre_.z();
    const double fade = std::clamp(1.7 * (1 - std::hypot(x, z) / reach_), 0.0, 1.0);
    if (fade <= 0) return {};
    const double dark = fade * shadow_strength_ * shade(x / reach_, z / reach_);
    // The width of a line on the ground that looks as wide as on the page, by direction.
    const double pixel = eye_.metres_per_pixel / eye_.magnification(depth);
    const double slope = falls / ray.along.norm();
    const auto line_at = [&](double v, const Vector3& across) {
        const double away = std::abs(v / spacing_ - std::round(v / spacing_)) * spacing_;
        const double seen = std::abs(across.dot(eye_.axes.right));
        const double share = std::sqrt(seen * seen + (1 - seen * seen) * slope * slope);
        return std::clamp(half_line_ + 0.5 - away * share / pixel, 0.0, 1.0);
    };
    const double line =
        fade * std::max(line_at(point.x(), Vector3::UnitX()), line_at(point.z(), Vector3::UnitZ()));
    Seen seen{depth, Vector3::Zero(), dark + (1 - dark) * line};
    if (seen.alpha > 0)
        seen.colour = (dark * shadow_ink_ + (1 - dark) * line * grid_ink_) / seen.alpha;
    return seen;
}

}  // namespace viz
