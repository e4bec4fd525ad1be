#include "lodlab/core/frame/integrate.hpp"

namespace lod {

template <int Dim>
void integrate(std::span<Body<Dim>> bodies, double h) {
    for (Body<Dim>& body : bodies) {
        if (body.is_static()) continue;
        body.position += h * body.velocity;
        const int steps = Space<Dim>::free_turn_steps(body.orientation, body.inertia,
                                                      body.inverse_inertia, body.spin, h);
        for (int step = 0; step < steps; ++step) {
            const auto [turn, spin] = Space<Dim>::free_turn(
                body.orientation, body.inertia, body.inverse_inertia, body.spin, h / steps);
            body.orientation = Space<Dim>::turned(body.orientation, turn);
            body.spin = spin;
        }
    }
}

template void integrate(std::span<Body<2>>, double);
template void integrate(std::span<Body<3>>, double);

}  // namespace lod
