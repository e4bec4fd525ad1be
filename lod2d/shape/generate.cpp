#include "lodlab/lod2d/shape/generators.hpp"

namespace lod2d {

bool names_generator(std::string_view spec) {
    return lod::find_generator(generators(), spec) != nullptr;
}

Shape generate(std::string_view spec) {
    return make_shape(std::string(spec), lod::make_from_spec(generators(), spec));
}

}  // namespace lod2d
