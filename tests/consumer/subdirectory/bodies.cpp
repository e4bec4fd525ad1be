// A body of 2 kg that moves at 3 m/s has 9 J, by core alone.
#include <lodlab/core.hpp>

int main() {
    lod::Body<2> body;
    lod::set_mass(body, 2, lod::Inertia<2>::Constant(1));
    body.velocity = {3, 0};
    const lod::Body<2> bodies[]{body};
    return lod::kinetic_energy<2>(bodies) == 9 ? 0 : 1;
}
