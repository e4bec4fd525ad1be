// In place of lod3d/source/import_scene.cpp where assimp and child processes are not: refuses 3DS
// and glTF.

#include "lodlab/core/base/error.hpp"
#include "lodlab/lod3d/source/import_scene.hpp"

namespace lod3d {

FileMesh import_scene(const SceneFile& file, const ImportLimits&) {
    throw lod::Error(lod::ErrorKind::not_installed,
                     file.name + ": this build of lodlab reads no ." + file.ending +
                         "; save it as OBJ, PLY, STL or OFF");
}

}  // namespace lod3d
