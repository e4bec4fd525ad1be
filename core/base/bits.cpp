#include "lodlab/core/base/bits.hpp"

namespace lod::layout {

const char LOD_LAYOUT = 0;

}  // namespace lod::layout
