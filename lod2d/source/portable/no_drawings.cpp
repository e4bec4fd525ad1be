// In place of lod2d/source/svg.cpp and lod2d/source/font.cpp where their libraries are not: refuses
// drawings and texts.

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod2d/source/font.hpp"
#include "lodlab/lod2d/source/svg.hpp"

namespace lod2d {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw lod::Error(lod::ErrorKind::not_installed,
                     name + ": this build of lodlab reads no " + what +
                         "; take a generator, or a build with LODLAB_PORTABLE=OFF");
}

}  // namespace

Shape load_svg(const std::filesystem::path& path, const SvgSettings&) {
    refuse(path.string(), "drawings");
}

Shape parse_svg(const std::string& name, std::string_view, const SvgSettings&) {
    refuse(name, "drawings");
}

Shape text_shape(std::string_view text, const FontSettings&) {
    refuse("text:" + std::string(text), "fonts");
}

}  // namespace lod2d
