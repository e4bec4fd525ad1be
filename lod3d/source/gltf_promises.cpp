// What glTF files promise and require, against what they hold and what is read.
#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/lod3d/source/binary_number.hpp"
#include "lodlab/lod3d/source/import_scene.hpp"
#include "lodlab/lod3d/source/text_words.hpp"

namespace lod3d {
namespace {

namespace fs = std::filesystem;

/// One file being checked.
struct File {
    SceneFile from;
    std::uint64_t size = 0;
    const ImportLimits& limits;

    [[noreturn]] void refuse(const std::string& why) const {
        throw lod::Error(lod::ErrorKind::input_refused, from.name + ": " + why);
    }
    [[noreturn]] void exceed(const std::string& why) const {
        throw lod::Error(lod::ErrorKind::limit_exceeded, from.name + ": " + why);
    }
    [[nodiscard]] std::string read(std::uint64_t first, std::uint64_t count) const {
        std::ifstream in(from.path, std::ios::binary);
        std::string bytes(static_cast<std::size_t>(std::min(count, size - std::min(first, size))),
                          '\0');
        in.seekg(static_cast<std::streamoff>(first));
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        if (!in) refuse("cannot be read");
        return bytes;
    }
    /// Says what the header promises: so many things, at least so many bytes each.
    void check_promise(double count, double bytes_each, const std::string& what) const {
        if (!(count >= 0)) refuse("the header promises a negative number of " + what);
        if (count * bytes_each > static_cast<double>(size)) {
            std::string number = std::to_string(count);
            refuse("the header promises " + number.substr(0, number.find('.')) + " " + what +
                   ", which " + std::to_string(size) + " bytes cannot hold");
        }
    }
    void check_triangles(double count) const {
        if (count <= static_cast<double>(limits.most_triangles)) return;
        std::string number = std::to_string(count);
        exceed(number.substr(0, number.find('.')) + " triangles, more than the limit of " +
               std::to_string(limits.most_triangles) + "; simplify the mesh or raise the limit");
    }
};

/// The JSON text of a .gltf file, or of the first chunk of a .glb file.
std::string gltf_text(const File& file) {
    const std::string head = file.read(0, 20);
    if (!head.starts_with("glTF")) return file.read(0, file.size);
    if (head.size() < 20) file.refuse("ends within its header");
    const std::uint32_t length = binary_number<std::uint32_t>(head, 12);
    file.check_promise(length, 1, "bytes of JSON");
    return file.read(20, length);
}

using Json = nlohmann::json;

/// The entry of an object's array; null where there is none.
const Json& entry(const Json& object, const char* list, const Json& number) {
    static const Json none;
    const auto found = object.is_object() ? object.find(list) : object.end();
    if (found == object.end() || !found->is_array() || !number.is_number_unsigned()) return none;
    const auto at = number.get<std::size_t>();
    return at < found->size() ? (*found)[at] : none;
}

const Json& member(const Json& object, const char* name) {
    static const Json none;
    const auto found = object.is_object() ? object.find(name) : object.end();
    return found == object.end() ? none : *found;
}

double count_of(const Json& accessor) {
    const Json& count = member(accessor, "count");
    return count.is_number() ? count.get<double>() : 0;
}

/// What the buffers that the file brings or names hold together [bytes].
double bytes_of_buffers(const File& file, const Json& json) {
    double held = static_cast<double>(file.size);
    for (const Json& buffer : member(json, "buffers")) {
        const Json& uri = member(buffer, "uri");
        if (!uri.is_string()) continue;
        const std::string name = uri.get<std::string>();
        if (name.starts_with("data:")) continue;
        std::error_code none;
        const auto size = fs::file_size(file.from.path.parent_path() / name, none);
        if (none) continue;  // the importer says that it is missing
        if (size > file.limits.most_bytes)
            file.exceed(name + " is larger than the limit of " +
                        std::to_string(file.limits.most_bytes) + " bytes");
        held += static_cast<double>(size);
    }
    return held;
}

/// Triangles of a mesh: by its indices where it has some, else by its vertices.
double triangles_of(const Json& json, const Json& mesh) {
    double triangles = 0;
    for (const Json& primitive : member(mesh, "primitives")) {
        const Json& indices = member(primitive, "indices");
        const Json& vertices = member(member(primitive, "attributes"), "POSITION");
        const double corners =
            count_of(entry(json, "accessors", indices.is_null() ? vertices : indices));
        const Json& mode = member(primitive, "mode");
        constexpr int list = 4;  // a strip or a fan makes one of each corner
        const bool listed = !mode.is_number() || mode.get<int>() <= list;
        triangles += listed ? corners / 3 : corners;
    }
    return triangles;
}

/// Extensions that change no triangle, by how their names begin.
constexpr std::array<std::string_view, 7> harmless{"KHR_materials_", "KHR_texture_", "KHR_lights_",
                                                   "KHR_animation_", "KHR_xmp",      "EXT_texture_",
                                                   "MSFT_texture_"};

struct KnownMend {
    std::string_view extension;
    std::string_view mend;
};
constexpr std::array<KnownMend, 4> mends{
    {{"KHR_draco_mesh_compression", "save it without Draco compression"},
     {"EXT_meshopt_compression", "save it without meshopt compression"},
     {"KHR_meshopt_compression", "save it without meshopt compression"},
     {"KHR_mesh_quantization", "save its positions as floats"}}};

void check_extensions(const File& file, const Json& json) {
    for (const Json& one : member(json, "extensionsRequired")) {
        if (!one.is_string()) continue;
        const auto name = one.get<std::string>();
        if (std::ranges::any_of(harmless, [&](auto begin) { return name.starts_with(begin); }))
            continue;
        const auto known = std::ranges::find(mends, name, &KnownMend::extension);
        file.refuse("requires the extension " + in_quotes(name) + ", which is not read; " +
                    std::string(known == mends.end() ? "save it without" : known->mend));
    }
}

/// The importer takes any numbers for floats.
void check_positions(const File& file, const Json& json) {
    constexpr int float_type = 5126;
    for (const Json& mesh : member(json, "meshes"))
        for (const Json& primitive : member(mesh, "primitives")) {
            const Json& accessor =
                entry(json, "accessors", member(member(primitive, "attributes"), "POSITION"));
            const Json& type = member(accessor, "componentType");
            if (type.is_number() && type.get<double>() != float_type)
                file.refuse("has positions of the component type " + type.dump() +
                            ", which takes KHR_mesh_quantization; that is not read: save its "
                            "positions as floats");
        }
}

std::string from_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                          : c == '+'             ? 62
                          : c == '/'             ? 63
                                                 : -1;
        if (value < 0) continue;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += static_cast<char>(bits >> held & 0xff);
    }
    return bytes;
}

/// The bytes of a buffer; none where they are not to be had, which the importer says.
std::string bytes_of_buffer(const File& file, const Json& json, const Json& number) {
    const Json& uri = member(entry(json, "buffers", number), "uri");
    if (uri.is_string()) {
        const auto& name = uri.get_ref<const std::string&>();
        if (name.starts_with("data:"))
            return from_base64(
                std::string_view(name).substr(std::min(name.find(','), name.size())));
        const fs::path folder = fs::absolute(file.from.path).parent_path();
        const fs::path path = folder / name;
        std::error_code none;
        const fs::path inside =
            fs::weakly_canonical(path, none).lexically_relative(fs::canonical(folder, none));
        if (none || inside.empty() || *inside.begin() == "..") return {};  // stays closed
        const File there{{path, name, ""}, fs::file_size(path, none), file.limits};
        return none || there.size > file.limits.most_bytes ? "" : there.read(0, there.size);
    }
    const std::string head = file.read(0, 20);
    if (!head.starts_with("glTF")) return {};
    constexpr std::uint64_t chunk_head = 8;
    const std::uint64_t after_json = 20 + std::uint64_t{binary_number<std::uint32_t>(head, 12)};
    return file.read(after_json + chunk_head, file.size);
}

std::uint64_t whole_of(const Json& object, const char* name) {
    const Json& value = member(object, name);
    return value.is_number_unsigned() ? value.get<std::uint64_t>() : 0;
}

/// The largest of the whole numbers that an accessor has in these bytes; 0 where it has none there.
std::uint64_t largest_of(const Json& accessor, const Json& view, std::string_view bytes) {
    const std::uint64_t type = whole_of(accessor, "componentType");
    const std::uint64_t size = type == 5121 ? 1 : type == 5123 ? 2 : type == 5125 ? 4 : 0;
    if (size == 0) return 0;
    const std::uint64_t stride = std::max(size, whole_of(view, "byteStride"));
    const std::uint64_t count = whole_of(accessor, "count");
    std::uint64_t largest = 0;
    std::uint64_t at = whole_of(view, "byteOffset") + whole_of(accessor, "byteOffset");
    for (std::uint64_t i = 0; i < count && size <= bytes.size() && at <= bytes.size() - size;
         ++i, at += stride) {
        if (i % 65536 == 0) lod::check_interrupted();
        const std::uint64_t value = size == 1   ? binary_number<std::uint8_t>(bytes, at)
                                    : size == 2 ? binary_number<std::uint16_t>(bytes, at)
                                                : binary_number<std::uint32_t>(bytes, at);
        largest = std::max(largest, value);
    }
    return largest;
}

/// The importer leaves out the triangles that name vertices which are not there, and says nothing.
void check_indices(const File& file, const Json& json) {
    Json loaded;
    std::string bytes;
    std::size_t number = 0;
    for (const Json& mesh : member(json, "meshes")) {
        for (const Json& primitive : member(mesh, "primitives")) {
            const Json& accessor = entry(json, "accessors", member(primitive, "indices"));
            const Json& view = entry(json, "bufferViews", member(accessor, "bufferView"));
            const Json& buffer = member(view, "buffer");
            if (buffer.is_null() || !member(accessor, "sparse").is_null()) continue;
            if (buffer != loaded) bytes = bytes_of_buffer(file, json, buffer);
            loaded = buffer;
            const double vertices = count_of(
                entry(json, "accessors", member(member(primitive, "attributes"), "POSITION")));
            const std::uint64_t largest = largest_of(accessor, view, bytes);
            if (largest > 0 && static_cast<double>(largest) >= vertices)
                file.refuse("a face of mesh " + std::to_string(number) +
                            " names the vertex index " + std::to_string(largest) +
                            ", but there are " +
                            std::to_string(static_cast<std::uint64_t>(vertices)) +
                            " vertices, numbered from 0; mend the face");
        }
        ++number;
    }
}

}  // namespace

/// Every accessor's elements must fit into the buffers. A mesh counts for each node that shows it.
void check_gltf(const SceneFile& from, const ImportLimits& limits) {
    std::error_code error;
    const File file{from, fs::file_size(from.path, error), limits};
    if (error) file.refuse(error.message());
    const auto json = Json::parse(gltf_text(file), nullptr, false);
    if (!json.is_object()) return;  // the importer says what is wrong
    check_extensions(file, json);
    check_positions(file, json);
    const double held = bytes_of_buffers(file, json);
    for (const Json& accessor : member(json, "accessors"))
        if (count_of(accessor) > held)
            file.refuse("an accessor promises " + member(accessor, "count").dump() +
                        " elements, which " + std::to_string(static_cast<std::uint64_t>(held)) +
                        " bytes cannot hold");
    double triangles = 0;
    for (const Json& mesh : member(json, "meshes")) triangles += triangles_of(json, mesh);
    double shown = 0;
    for (const Json& node : member(json, "nodes"))
        shown += triangles_of(json, entry(json, "meshes", member(node, "mesh")));
    file.check_triangles(std::max(triangles, shown));
    check_indices(file, json);
}

}  // namespace lod3d
