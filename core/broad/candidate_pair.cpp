#include "lodlab/core/broad/candidate_pair.hpp"

#include <string>

#include "lodlab/core/base/error.hpp"

namespace lod {

void check_candidates(std::size_t candidates) {
    if (candidates > most_candidates)
        throw Error(ErrorKind::limit_exceeded,
                    "more than " + std::to_string(most_candidates) +
                        " pairs of bodies are near each other, more than a frame takes; move the "
                        "bodies apart, or take fewer");
}

}  // namespace lod
