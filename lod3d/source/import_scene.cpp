// The only file that knows assimp.
#include "lodlab/lod3d/source/import_scene.hpp"

#include <assimp/DefaultIOSystem.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <assimp/BaseImporter.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"

namespace lod3d {
namespace {

namespace fs = std::filesystem;

// ---- in the child ----

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

void send(int pipe, const void* bytes, std::size_t count) {
    const char* at = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t sent = write(pipe, at, count);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) _exit(1);
        at += sent;
        count -= static_cast<std::size_t>(sent);
    }
}

/// What the child says first: a mesh of these counts follows, or a refusal of `vertices` letters.
struct Announcement {
    enum Kind : std::uint64_t { mesh, refusal, out_of_memory } kind;
    std::uint64_t vertices;
    std::uint64_t triangles;
    double step;
};

void send_refusal(int pipe, Announcement::Kind kind, std::string why) {
    for (char& c : why)
        if (c == '\n' || c == '\r') c = ' ';
    const Announcement says{kind, why.size(), 0, 0};
    send(pipe, &says, sizeof says);
    send(pipe, why.data(), why.size());
}

void limit_resources(const ImportLimits& limits) {
    const rlim_t seconds = static_cast<rlim_t>(limits.most_seconds) + 2;
    const rlimit cpu{seconds, seconds};
    setrlimit(RLIMIT_CPU, &cpu);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if defined(__has_feature)
#define LOD3D_SANITIZED (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#else
#define LOD3D_SANITIZED 0
#endif
#if !LOD3D_SANITIZED  // sanitizers map terabytes that they never touch
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + limits.most_memory;
    const rlimit memory{bytes, bytes};
    setrlimit(RLIMIT_AS, &memory);
#endif
#endif
}

[[noreturn]] void run_child(int pipe, const SceneFile& file, const ImportLimits& limits) {
    for (const int signal : {SIGINT, SIGTERM})  // what is ignored stays so
        if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    try {
        limit_resources(limits);
        const auto [mesh, step] = triangles_of_scene(file.path, file.ending);
        const Announcement says{Announcement::mesh, mesh.vertices.size(), mesh.triangles.size(),
                                step};
        send(pipe, &says, sizeof says);
        send(pipe, mesh.vertices.data(), mesh.vertices.size() * sizeof(Point));
        send(pipe, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    } catch (const std::bad_alloc&) {
        send_refusal(pipe, Announcement::out_of_memory, "");
    } catch (const std::exception& error) {
        send_refusal(pipe, Announcement::refusal, error.what());
    } catch (...) {
        send_refusal(pipe, Announcement::refusal, "the importer failed");
    }
    _exit(0);
}

// ---- in the parent ----

/// The child and the pipe from it; ends both, whatever happens.
class Child {
  public:
    Child(const SceneFile& file, const ImportLimits& limits)
        : name_(file.name),
          limits_(limits),
          deadline_(std::chrono::steady_clock::now() +
                    std::chrono::milliseconds(static_cast<long>(1000 * limits.most_seconds))) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) refuse(std::strerror(errno));
        process_ = fork();
        if (process_ == 0) run_child(ends[1], file, limits);
        close(ends[1]);
        pipe_ = ends[0];
        if (process_ < 0) refuse(std::strerror(errno));
    }
    ~Child() {
        close(pipe_);
        if (process_ <= 0) return;
        kill(process_, SIGKILL);
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    void receive(void* bytes, std::size_t count) {
        char* at = static_cast<char*>(bytes);
        while (count > 0) {
            await();
            const ssize_t got = read(pipe_, at, count);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) refuse("the importer broke down on it");
            at += got;
            count -= static_cast<std::size_t>(got);
        }
    }

    [[noreturn]] void refuse(const std::string& why) const {
        throw lod::Error(lod::ErrorKind::input_refused, name_ + ": " + why);
    }
    [[noreturn]] void exceed(const std::string& why) const {
        throw lod::Error(lod::ErrorKind::limit_exceeded, name_ + ": " + why);
    }

  private:
    /// Until there is something to read. An interruption is noticed within a tenth of a second.
    void await() const {
        for (;;) {
            lod::check_interrupted();
            if (std::chrono::steady_clock::now() >= deadline_)
                exceed("reading it took longer than the limit of " +
                       std::to_string(static_cast<long>(limits_.most_seconds)) + " s");
            pollfd waiting{pipe_, POLLIN, 0};
            if (poll(&waiting, 1, 100) > 0) return;
        }
    }

    std::string name_;
    const ImportLimits& limits_;
    std::chrono::steady_clock::time_point deadline_;
    pid_t process_ = -1;
    int pipe_ = -1;
};

}  // namespace

FileMesh import_scene(const SceneFile& file, const ImportLimits& limits) {
    if (file.ending != "3ds") check_gltf(file, limits);
    Child child(file, limits);
    Announcement says{};
    child.receive(&says, sizeof says);
    if (says.kind == Announcement::out_of_memory)
        child.exceed("reading it took more than the limit of " +
                     std::to_string(limits.most_memory >> 20) + " MB");
    if (says.kind == Announcement::refusal) {
        std::string why(std::min<std::uint64_t>(says.vertices, 500), ' ');
        child.receive(why.data(), why.size());
        child.refuse(why);
    }
    if (says.triangles > limits.most_triangles || says.vertices > 3 * limits.most_triangles)
        child.exceed(std::to_string(says.triangles) + " triangles and " +
                     std::to_string(says.vertices) + " vertices, more than the limit of " +
                     std::to_string(limits.most_triangles) +
                     " triangles; simplify the mesh or raise the limit");
    if (says.triangles == 0) child.refuse("holds no triangles; does its scene show a mesh?");
    FileMesh result;
    result.remarks.emplace_back(
        "coordinates were read as 32-bit numbers; all that is computed, and the certificate of the "
        "tree, is about the mesh of those");
    Mesh& mesh = result.mesh;
    mesh.vertices.resize(says.vertices);
    mesh.triangles.resize(says.triangles);
    child.receive(mesh.vertices.data(), mesh.vertices.size() * sizeof(Point));
    child.receive(mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
    // What the scene moves as a whole keeps its digits.
    const bool made_near = says.step < coordinate_step(mesh, 24);
    result.step = made_near ? 0 : says.step;
    return result;
}

}  // namespace lod3d
