// The only file that knows assimp.
#include "lodlab/lod3d/source/import_scene.hpp"

#include <assimp/DefaultIOSystem.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/BaseImporter.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/io/files/child_process.hpp"

namespace lod3d {
namespace {

namespace fs = std::filesystem;

/// Opens files of one folder, and of those below it, only.
class FolderOnly final : public Assimp::IOSystem {
  public:
    explicit FolderOnly(const fs::path& folder) : folder_(fs::weakly_canonical(folder)) {}

    [[nodiscard]] bool Exists(const char* file) const override { return files_.Exists(file); }
    [[nodiscard]] char getOsSeparator() const override { return files_.getOsSeparator(); }
    void Close(Assimp::IOStream* stream) override { files_.Close(stream); }

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        const fs::path path = fs::weakly_canonical(file);
        const auto differ = std::mismatch(folder_.begin(), folder_.end(), path.begin(), path.end());
        if (differ.first != folder_.end()) return nullptr;
        std::error_code error;
        if (!fs::is_regular_file(path, error)) return nullptr;
        return files_.Open(file, mode);
    }

  private:
    fs::path folder_;
    Assimp::DefaultIOSystem files_;
};

/// Leaves only the importers that read the ending, so that none is chosen by guessing.
void keep_importers_of(Assimp::Importer& importer, const std::string& ending) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        std::istringstream endings(importer.GetImporterInfo(i)->mFileExtensions);
        bool reads = false;
        for (std::string known; endings >> known;) reads |= known == ending;
        if (!reads) importer.UnregisterLoader(importer.GetImporter(i));
    }
}

/// A pose in a scene: 3 rows of a rotation, scaled, and a place. Composed in double.
struct Placing {
    lod::Matrix<3> turn = lod::Matrix<3>::Identity();
    Point move = Point::Zero();

    Placing() = default;
    explicit Placing(const aiMatrix4x4& m) {
        for (unsigned r = 0; r < 3; ++r) {
            for (unsigned c = 0; c < 3; ++c)
                turn(static_cast<int>(r), static_cast<int>(c)) = static_cast<double>(m[r][c]);
            move[static_cast<int>(r)] = static_cast<double>(m[r][3]);
        }
    }
    /// The most by which it stretches an axis.
    [[nodiscard]] double scale() const { return turn.cwiseAbs().maxCoeff(); }
    [[nodiscard]] Point carry(const Point& p) const { return turn * p + move; }
    [[nodiscard]] Placing then(const Placing& inner) const {
        Placing both;
        both.turn = turn * inner.turn;
        both.move = carry(inner.move);
        return both;
    }
};

/// A mesh in 32-bit numbers, where each is so far from the next.
struct Imported {
    Mesh mesh;
    double step = 0;  ///< as the placing scales it [m]
};

void add_mesh(const aiMesh& from, const Placing& pose, Imported& into) {
    Mesh& mesh = into.mesh;
    const auto first = static_cast<std::int32_t>(mesh.vertices.size());
    for (unsigned v = 0; v < from.mNumVertices; ++v) {
        const aiVector3D& at = from.mVertices[v];
        const float largest = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)});
        const double step =
            std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
        into.step = std::max(into.step, step * pose.scale());
        mesh.vertices.push_back(pose.carry(Point(at.x, at.y, at.z)));
    }
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
        const aiFace& face = from.mFaces[f];
        if (face.mNumIndices != 3) continue;  // points and lines bound nothing
        Triangle triangle;
        for (unsigned k = 0; k < 3; ++k)  // an index beyond the mesh stays beyond all vertices
            triangle[k] = face.mIndices[k] < from.mNumVertices
                              ? first + static_cast<std::int32_t>(face.mIndices[k])
                              : -1;
        mesh.triangles.push_back(triangle);
    }
}

Imported triangles_of_scene(const fs::path& path, const std::string& ending) {
    Assimp::Importer importer;
    importer.SetIOHandler(new FolderOnly(fs::absolute(path).parent_path()));
    keep_importers_of(importer, ending);
    const aiScene* scene = importer.ReadFile(fs::absolute(path).string(), aiProcess_Triangulate);
    if (!scene) {
        const std::string why = importer.GetErrorString();
        if (why.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
        throw std::runtime_error(why);
    }
    Imported imported;
    struct Waiting {
        const aiNode* node;
        Placing pose;
    };
    std::vector<Waiting> waiting;
    if (scene->mRootNode) waiting.push_back({scene->mRootNode, Placing()});
    while (!waiting.empty()) {
        const auto [node, above] = waiting.back();
        waiting.pop_back();
        const Placing pose = above.then(Placing(node->mTransformation));
        for (unsigned m = 0; m < node->mNumMeshes; ++m)
            add_mesh(*scene->mMeshes[node->mMeshes[m]], pose, imported);
        for (unsigned c = 0; c < node->mNumChildren; ++c)
            waiting.push_back({node->mChildren[c], pose});
    }
    return imported;
}

/// What the child says before the mesh.
struct Counts {
    std::uint64_t vertices;
    std::uint64_t triangles;
    double step;
};

void send_scene(lod::ChildPipe& pipe, const SceneFile& file) {
    const auto [mesh, step] = triangles_of_scene(file.path, file.ending);
    pipe.send(Counts{mesh.vertices.size(), mesh.triangles.size(), step});
    pipe.send(mesh.vertices.data(), mesh.vertices.size() * sizeof(Point));
    pipe.send(mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
}

void check_counts(const Counts& counts, const SceneFile& file, const ImportLimits& limits) {
    if (counts.triangles > limits.most_triangles || counts.vertices > 3 * limits.most_triangles)
        throw lod::Error(lod::ErrorKind::limit_exceeded,
                         file.name + ": " + std::to_string(counts.triangles) + " triangles and " +
                             std::to_string(counts.vertices) +
                             " vertices, more than the limit of " +
                             std::to_string(limits.most_triangles) +
                             " triangles; simplify the mesh or raise the limit");
    if (counts.triangles == 0)
        lod::refuse_input(file.name, "holds no triangles; does its scene show a mesh?");
}

}  // namespace

FileMesh import_scene(const SceneFile& file, const ImportLimits& limits) {
    if (file.ending != "3ds") check_gltf(file, limits);
    lod::ChildProcess child({file.name, "the importer"}, {limits.most_memory, limits.most_seconds},
                            [&](lod::ChildPipe& pipe) { send_scene(pipe, file); });
    const auto counts = child.receive<Counts>();
    check_counts(counts, file, limits);
    FileMesh result;
    result.remarks.emplace_back(
        "coordinates were read as 32-bit numbers; all that is computed, and the certificate of the "
        "tree, is about the mesh of those");
    Mesh& mesh = result.mesh;
    mesh.vertices.resize(counts.vertices);
    mesh.triangles.resize(counts.triangles);
    child.receive(mesh.vertices.data(), mesh.vertices.size() * sizeof(Point));
    child.receive(mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    // What the scene moves as a whole keeps its digits.
    const bool made_near = counts.step < coordinate_step(mesh, 24);
    result.step = made_near ? 0 : counts.step;
    return result;
}

}  // namespace lod3d
