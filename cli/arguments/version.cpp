#include "cli/arguments/version.hpp"

#include <commit.hpp>

#include "lodlab/viz/film/video.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace cli {

std::string version_text() {
    return "lodlab " LODLAB_VERSION " (" LODLAB_COMMIT ")\n" + viz::drawing_libraries() + "\n" +
           viz::video_libraries();
}

}  // namespace cli
