#include "lodlab/core/broad/candidate_pair.hpp"

#include <string>

#include "lodlab/core/base/error.hpp"

namespace lod {

void check_candidates(std::size_t pairs) {
    if (pairs <= most_candidates) return;
    throw Error(ErrorKind::limit_exceeded,
                "more than " + std::to_string(most_candidates) +
                    " pairs of bodies are near each other in one frame; move the bodies apart, or "
                    "take fewer than 4096 at one place");
}

}  // namespace lod
