#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "lodlab/lod3d/mesh/mesh.hpp"

// Meshes written as files, good or bad, by a few lines a format.

namespace lodtest {

namespace fs = std::filesystem;

template <typename Number>
std::string bytes_of(Number value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

inline std::string binary_stl(const lod3d::Mesh& mesh, std::uint32_t declared) {
    std::string bytes(80, ' ');
    bytes += bytes_of(declared);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        bytes += std::string(12, '\0');
        for (int k = 0; k < 3; ++k)
            for (int d = 0; d < 3; ++d) bytes += bytes_of(static_cast<float>(mesh.corner(t, k)[d]));
        bytes += std::string(2, '\0');
    }
    return bytes;
}

/// Text formats: the vertices and the triangles line by line, vertices numbered from `first`.
inline std::string lines_of(const lod3d::Mesh& mesh, const std::string& vertex,
                            const std::string& triangle, std::int32_t first) {
    std::ostringstream out;
    for (const lod3d::Point& p : mesh.vertices)
        out << vertex << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const lod3d::Triangle& t : mesh.triangles)
        out << triangle << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first << '\n';
    return out.str();
}

inline std::string base64(const std::string& bytes) {
    const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three =
                three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
    }
    return text;
}

inline std::string gltf(const lod3d::Mesh& mesh) {
    std::string bytes;
    for (const lod3d::Point& p : mesh.vertices)
        for (int d = 0; d < 3; ++d) bytes += bytes_of(static_cast<float>(p[d]));
    const std::string points = std::to_string(bytes.size());
    for (const lod3d::Triangle& t : mesh.triangles)
        for (const std::int32_t v : t) bytes += bytes_of(static_cast<std::uint32_t>(v));
    const std::string all = std::to_string(bytes.size());
    const std::string indices = std::to_string(12 * mesh.triangles.size());
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
           std::to_string(mesh.vertices.size()) +
           R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" +
           std::to_string(3 * mesh.triangles.size()) +
           R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" + points +
           R"(},{"buffer":0,"byteOffset":)" + points + R"(,"byteLength":)" + indices +
           R"(}],"buffers":[{"byteLength":)" + all +
           R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) + "\"}]}";
}

inline std::string text_of(const lod3d::Mesh& mesh, const std::string& format) {
    const std::string vertices = std::to_string(mesh.vertices.size());
    const std::string triangles = std::to_string(mesh.triangles.size());
    if (format == "obj") return lines_of(mesh, "v ", "f ", 1);
    if (format == "off")
        return "OFF\n" + vertices + ' ' + triangles + " 0\n" + lines_of(mesh, "", "3 ", 0);
    if (format == "ply")
        return "ply\nformat ascii 1.0\nelement vertex " + vertices +
               "\nproperty float x\nproperty float y\nproperty float z\nelement face " + triangles +
               "\nproperty list uchar int vertex_indices\nend_header\n" +
               lines_of(mesh, "", "3 ", 0);
    if (format == "stl") return binary_stl(mesh, static_cast<std::uint32_t>(mesh.triangles.size()));
    return gltf(mesh);
}

/// A folder of its own that goes away again.
class Folder {
  public:
    Folder() : path_(fs::temp_directory_path() / ("lodlab_mesh_" + std::to_string(::getpid()))) {
        fs::create_directories(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] fs::path write(const std::string& name, const std::string& bytes) const {
        fs::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path_ / name;
    }
    /// A mesh as "mesh.FORMAT".
    [[nodiscard]] fs::path write(const std::string& format, const lod3d::Mesh& mesh) const {
        return write("mesh." + format, text_of(mesh, format));
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

}  // namespace lodtest
