#include "lodlab/lod3d/source/load_mesh.hpp"

#include <array>
#include <fstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/lod3d/mesh/mesh_faults.hpp"
#include "lodlab/lod3d/source/import_scene.hpp"
#include "lodlab/lod3d/source/mesh_readers.hpp"
#include "lodlab/lod3d/source/text_words.hpp"

namespace lod3d {
namespace {

namespace fs = std::filesystem;

using Reader = FileMesh (*)(std::string_view, const std::string&, const ImportLimits&);

struct Format {
    std::string_view ending;
    Reader read;  ///< null: assimp reads it
};

constexpr std::array<Format, 7> formats{{{"obj", read_obj},
                                         {"ply", read_ply},
                                         {"stl", read_stl},
                                         {"off", read_off},
                                         {"3ds", nullptr},
                                         {"gltf", nullptr},
                                         {"glb", nullptr}}};

const Format* format_of(std::string_view ending) {
    for (const Format& format : formats)
        if (format.ending == ending) return &format;
    return nullptr;
}

/// The size of a file that may be read [bytes].
std::uint64_t checked_size(const SceneFile& file, const ImportLimits& limits) {
    std::error_code error;
    const auto status = fs::status(file.path, error);
    if (!fs::exists(status)) lod::refuse_input(file.name, "no such file");
    if (!fs::is_regular_file(status)) lod::refuse_input(file.name, "is no regular file");
    if (!format_of(file.ending))
        lod::refuse_input(file.name,
                          "no mesh format that is read; give obj, ply, stl, off, 3ds, gltf or glb");
    const std::uint64_t size = fs::file_size(file.path, error);
    if (error) lod::refuse_input(file.name, error.message());
    if (size == 0) lod::refuse_input(file.name, "is empty");
    if (size > limits.most_bytes)
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         file.name + ": " + std::to_string(size) +
                             " bytes, more than the limit of " + std::to_string(limits.most_bytes) +
                             "; simplify the mesh or raise the limit");
    return size;
}

std::string bytes_of(const SceneFile& file, std::uint64_t size) {
    std::ifstream in(file.path, std::ios::binary);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!in) lod::refuse_input(file.name, "cannot be read");
    return bytes;
}

/// Refuses a file that begins as those of another format do.
void check_beginning(std::string_view bytes, const SceneFile& file) {
    const auto refuse = [&](const std::string& format) {
        lod::refuse_input(file.name, "begins as a file of the format " + format +
                                         " does; if it is one, let its name end in ." + format);
    };
    const std::string_view first = TextWords(bytes.substr(0, 64), TextWords::Comments::none).next();
    if (first == "ply" && file.ending != "ply") refuse("ply");
    if (first.ends_with("OFF") && file.ending != "off") refuse("off");
    if (bytes.starts_with("glTF") && file.ending != "glb") refuse("glb");
}

/// Says where neighbouring numbers of the file are so far apart that the mesh shows it, and would
/// show it less nearer to the origin.
void remark_on_digits(FileMesh& file) {
    const Box box = bounding_box(file.mesh);
    const double longest = box.size().maxCoeff();
    const double farthest = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
    constexpr double shows = 5e-10;  // of the size
    if (!(farthest > longest) || !(file.step > shows * longest)) return;
    file.remarks.push_back(
        "stands far from the origin, where the numbers of its file are " + in_digits(file.step, 2) +
        " m apart, " + in_digits(file.step / longest, 2) +
        " of its size: its shape, and all that is computed of it, holds to that; move it to the "
        "origin where it is made");
}

}  // namespace

bool is_mesh_format(const std::string& ending) {
    return format_of(ending) != nullptr;
}

FileMesh read_mesh(const fs::path& path, const ImportLimits& limits, const std::string& name) {
    const SceneFile from{path, name.empty() ? path.string() : name, lod::ending_of(path)};
    const std::uint64_t size = checked_size(from, limits);
    const Format& format = *format_of(from.ending);
    FileMesh file;
    if (format.read) {
        const std::string bytes = bytes_of(from, size);
        check_beginning(bytes, from);
        file = format.read(bytes, from.name, limits);
    } else {
        file = import_scene(from, limits);
    }
    remark_on_digits(file);
    return file;
}

Mesh load_mesh(const fs::path& path, const ImportLimits& limits) {
    return read_mesh(path, limits).mesh;
}

}  // namespace lod3d
