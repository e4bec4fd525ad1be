#include "lodlab/core/builder/cover.hpp"

namespace lod {

CoverSettings scaled(CoverSettings settings, double effort) {
    for (int* number :
         {&settings.starts, &settings.finalists, &settings.foresight_starts, &settings.foresights})
        *number = std::max(1, static_cast<int>(std::lround(effort * *number)));
    return settings;
}

}  // namespace lod
