// What the headers of mesh files promise, against what the files can hold.
#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "lodlab/core/error.hpp"
#include "lodlab/core/from_chars.hpp"
#include "lodlab/lod3d/import_limits.hpp"

namespace lod3d {
namespace {

namespace fs = std::filesystem;

/// One file being checked.
struct File {
    fs::path path;
    std::uint64_t size = 0;
    const ImportLimits& limits;

    [[noreturn]] void refuse(const std::string& why) const {
        throw lod::Error(lod::ErrorKind::input_refused, path.string() + ": " + why);
    }
    [[noreturn]] void exceed(const std::string& why) const {
        throw lod::Error(lod::ErrorKind::limit_exceeded, path.string() + ": " + why);
    }
    [[nodiscard]] std::string read(std::uint64_t from, std::uint64_t count) const {
        std::ifstream in(path, std::ios::binary);
        std::string bytes(static_cast<std::size_t>(std::min(count, size - std::min(from, size))),
                          '\0');
        in.seekg(static_cast<std::streamoff>(from));
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

constexpr std::uint64_t most_header = 1 << 16;

/// Words of a text, '#' comments left out.
std::vector<std::string_view> words(std::string_view text, std::size_t most) {
    std::vector<std::string_view> found;
    std::size_t at = 0;
    while (at < text.size() && found.size() < most) {
        at = text.find_first_not_of(" \t\r\n", at);
        if (at == std::string_view::npos) break;
        if (text[at] == '#') {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(" \t\r\n#", at), text.size());
        found.push_back(text.substr(at, end - at));
        at = end;
    }
    return found;
}

double number(std::string_view word) {
    double value = 0;
    const auto result = lod::from_chars(word.data(), word.data() + word.size(), value);
    return result.ec == std::errc() ? value : 0;
}

/// Of four bytes, the least first, whatever the order of this machine.
std::uint32_t number_at(const std::string& bytes, std::size_t place) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[place + i]);
    return value;
}

void check_off(const File& file) {
    const std::string head = file.read(0, most_header);
    const auto found = words(head, 8);
    std::size_t at = 0;
    double values_each = 3;  // of a vertex; the keyword may ask for more
    if (at < found.size() && found[at].ends_with("OFF")) ++at;
    if (found.size() < at + 2) return;  // the importer says what is wrong
    file.check_promise(number(found[at]), 2 * values_each, "vertices");
    file.check_promise(number(found[at + 1]), 4, "faces");
    file.check_triangles(number(found[at + 1]));
}

void check_stl(const File& file) {
    constexpr std::uint64_t header = 84;
    if (file.size < header) return;
    const std::string head = file.read(0, header);
    const std::uint32_t count = number_at(head, 80);
    const bool fits = header + 50ull * count == file.size;
    if (!fits && head.starts_with("solid")) return;  // text
    file.check_promise(count, 50, "triangles");
    file.check_triangles(count);
}

int size_of_ply_type(std::string_view type) {
    if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
    if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
    if (type == "double" || type == "float64") return 8;
    return 4;
}

void check_ply(const File& file) {
    const std::string head = file.read(0, most_header);
    const std::size_t end = head.find("end_header");
    if (!head.starts_with("ply")) return;  // the importer says what is wrong
    if (end == std::string::npos) file.refuse("the header does not end; is the file cut short?");
    const bool text = head.find("format ascii") < end;
    std::string element;
    double count = 0;
    double bytes = 0;
    const auto finish = [&] {
        if (element.empty()) return;
        file.check_promise(count, std::max(bytes, 1.0), "of element " + element);
        if (element == "face") file.check_triangles(count);
    };
    std::string_view rest(head.data(), end);
    while (!rest.empty()) {
        const std::size_t line_end = std::min(rest.find('\n'), rest.size());
        const auto found = words(rest.substr(0, line_end), 5);
        rest.remove_prefix(std::min(line_end + 1, rest.size()));
        if (found.size() >= 3 && found[0] == "element") {
            finish();
            element = found[1];
            count = number(found[2]);
            bytes = 0;
        } else if (found.size() >= 3 && found[0] == "property") {
            const bool list = found[1] == "list";
            bytes += text ? 2 : size_of_ply_type(list ? found[2] : found[1]);
        }
    }
    finish();
}

/// OBJ promises nothing; its faces are counted.
void check_obj(const File& file) {
    std::ifstream in(file.path, std::ios::binary);
    std::vector<char> block(1 << 20);
    double faces = 0;
    char before = '\n';
    while (in) {
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        for (std::streamsize i = 0; i < in.gcount(); ++i) {
            const char c = block[static_cast<std::size_t>(i)];
            faces += c == 'f' && before == '\n';
            before = c;
        }
        lod::check_interrupted();
    }
    file.check_triangles(faces);
}

/// The JSON text of a .gltf file, or of the first chunk of a .glb file.
std::string gltf_text(const File& file) {
    const std::string head = file.read(0, 20);
    if (!head.starts_with("glTF")) return file.read(0, file.size);
    if (head.size() < 20) file.refuse("ends within its header");
    const std::uint32_t length = number_at(head, 12);
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
        const auto size = fs::file_size(file.path.parent_path() / name, none);
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

/// Every accessor's elements must fit into the buffers. A mesh counts for each node that shows it.
void check_gltf(const File& file) {
    const auto json = Json::parse(gltf_text(file), nullptr, false);
    if (!json.is_object()) return;  // the importer says what is wrong
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
}

std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    if (!ending.empty()) ending.erase(0, 1);
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

}  // namespace

bool is_mesh_format(const std::string& ending) {
    constexpr std::array<std::string_view, 7> known{"obj", "ply",  "stl", "off",
                                                    "3ds", "gltf", "glb"};
    return std::find(known.begin(), known.end(), ending) != known.end();
}

void check_declared_counts(const fs::path& path, const ImportLimits& limits) {
    File file{path, 0, limits};
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::exists(status)) file.refuse("no such file");
    if (!fs::is_regular_file(status)) file.refuse("is no regular file");
    const std::string ending = ending_of(path);
    if (!is_mesh_format(ending))
        file.refuse("no mesh format that is read; give obj, ply, stl, off, 3ds, gltf or glb");
    file.size = fs::file_size(path, error);
    if (error) file.refuse(error.message());
    if (file.size == 0) file.refuse("is empty");
    if (file.size > limits.most_bytes)
        file.exceed(std::to_string(file.size) + " bytes, more than the limit of " +
                    std::to_string(limits.most_bytes) + "; simplify the mesh or raise the limit");
    if (ending == "off") check_off(file);
    if (ending == "stl") check_stl(file);
    if (ending == "ply") check_ply(file);
    if (ending == "obj") check_obj(file);
    if (ending == "gltf" || ending == "glb") check_gltf(file);
}

}  // namespace lod3d
