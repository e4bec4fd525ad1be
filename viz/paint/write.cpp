#include "lodlab/viz/paint/write.hpp"

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/viz/figure/json.hpp"

namespace viz {

bool is_figure_path(const std::filesystem::path& path) {
    const std::string ending = lod::ending_of(path);
    return ending == "png" || ending == "svg" || ending == "pdf" || ending == "json";
}

void write_figure(const std::filesystem::path& path, const Figure& figure,
                  const WriteOptions& options) {
    const std::string ending = lod::ending_of(path);
    if (ending == "png") return write_png(path, figure, options);
    if (ending == "svg") return write_svg(path, figure, options);
    if (ending == "pdf") return write_pdf(path, figure, options);
    if (ending == "json") return lod::write_text_file(path, json_text(figure));
    throw lod::Error(lod::ErrorKind::usage,
                     "cannot write " + path.string() +
                         ": its ending names no format; use one of .png .svg .pdf .json");
}

}  // namespace viz
