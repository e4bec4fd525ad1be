#include "lodlab/scenes/setup.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/frame/broad_phase.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/sha256.hpp"
#include "lodlab/scenes/places.hpp"

namespace scenes {
namespace {

/// Shapes, borders and trees that were made already, by all that decides what they are.
template <int Dim>
struct ShapeCache {
    using SharedShape = std::shared_ptr<const Shape<Dim>>;
    using SharedTree = std::shared_ptr<const lod::SphereTree<Dim>>;
    using ShapeKey = std::tuple<std::string, std::optional<double>, bool, bool, bool, bool>;
    std::map<ShapeKey, SharedShape> shapes;
    std::map<std::pair<const Shape<Dim>*, TreeChoice>, SharedTree> trees;
    std::map<const Shape<Dim>*, typename Shapes<Dim>::Border> borders;
    std::map<const Shape<Dim>*, std::shared_ptr<const lod::ExactShape<Dim>>> exact;

    const typename Shapes<Dim>::Border& border_of(const Shape<Dim>& shape) {
        const auto known = borders.find(&shape);
        if (known != borders.end()) return known->second;
        return borders.emplace(&shape, Shapes<Dim>::border_of(shape)).first->second;
    }
};

constexpr std::size_t most_shape_bytes = std::size_t{1} << 30;

/// What makes a shape another one on another machine: its file has other bytes than the scene was
/// made with, or its outlines are those of a font that is installed here.
std::string remark_on_source(const BodySpec& spec) {
    if (spec.shape.starts_with("text:"))
        return spec.shape +
               " is drawn by the font of this machine; where another one is installed the shape, "
               "and its motion, is another";
    if (spec.sha256.empty()) return "";
    const std::filesystem::path file =
        in_package(spec.shape) ? package_file(spec.shape) : spec.file;
    if (io::sha256(lod::read_text_file(file, most_shape_bytes)) == spec.sha256) return "";
    return "the scene was made with another version of " + spec.shape +
           "; its motion may be another than described";
}

template <int Dim>
typename ShapeCache<Dim>::ShapeKey key_of(const BodySpec& spec) {
    return {spec.file.empty() ? spec.shape : spec.file.string(),
            spec.size,
            spec.fill,
            spec.strokes,
            spec.page,
            spec.strict};
}

template <int Dim>
typename ShapeCache<Dim>::SharedShape shape_of(const BodySpec& spec, double raise_limits,
                                               ShapeCache<Dim>& made,
                                               std::vector<std::string>& warnings) {
    const std::string name = spec.file.empty() ? spec.shape : spec.file.string();
    auto& shape = made.shapes[key_of<Dim>(spec)];
    if (!shape) {
        shape = std::make_shared<const Shape<Dim>>(Shapes<Dim>::named(
            name, {spec.size, spec.fill, raise_limits, spec.strokes, spec.strict, spec.page}));
        std::vector<std::string> remarks = Shapes<Dim>::remarks(*shape);
        remarks.push_back(remark_on_source(spec));
        std::erase(remarks, "");
        for (const std::string& line : remarks)
            warnings.push_back(spec.where + ": body " + spec.name + ": " + line);
    }
    return shape;
}

TreeChoice tree_choice_of(const BodySpec& spec) {
    return {spec.builder, spec.branching, spec.depth, {}, {}, {}};
}

template <int Dim>
typename ShapeCache<Dim>::SharedTree shared_tree(const BodySpec& spec, const Shape<Dim>& shape,
                                                 const io::TreeCache& cache,
                                                 const std::function<void(double)>& progress,
                                                 ShapeCache<Dim>& made) {
    const TreeChoice choice = tree_choice_of(spec);
    auto& tree = made.trees[{&shape, choice}];
    if (!tree) {
        auto settings = Shapes<Dim>::settings(choice);
        settings.progress = progress;
        tree = std::make_shared<const lod::SphereTree<Dim>>(tree_of<Dim>(shape, settings, cache));
    }
    return tree;
}

/// The first numbers of a triple: a vector of the scene's dimension.
template <int Dim>
lod::Vector<Dim> vector_of(const Triple& triple) {
    lod::Vector<Dim> vector;
    for (int i = 0; i < Dim; ++i) vector[i] = triple[static_cast<std::size_t>(i)];
    return vector;
}

/// The last numbers of a triple: in the plane the turn about the third axis.
template <int Dim>
lod::Spin<Dim> spin_of(const Triple& triple) {
    constexpr int size = lod::Space<Dim>::spin_size;
    lod::Spin<Dim> spin;
    for (int i = 0; i < size; ++i) spin[i] = triple[static_cast<std::size_t>(3 - size + i)];
    return spin;
}

template <int Dim>
lod::Body<Dim> body_of(const BodySpec& spec, const Shape<Dim>& shape,
                       typename ShapeCache<Dim>::SharedTree tree) {
    lod::Body<Dim> body;
    body.tree = std::move(tree);
    body.restitution = spec.restitution;
    body.position = vector_of<Dim>(spec.position);
    body.orientation =
        lod::Space<Dim>::turned(lod::Space<Dim>::unturned(), spec.angle * spin_of<Dim>(spec.axis));
    body.velocity = vector_of<Dim>(spec.velocity);
    body.spin = spin_of<Dim>(spec.spin);
    if (spec.is_static) {
        lod::make_static(body);
    } else {
        const double measure = Shapes<Dim>::measure(shape);
        const double mass = spec.mass.value_or(spec.density * measure);
        const lod::Inertia<Dim> inertia = mass / measure * Shapes<Dim>::second_moment(shape);
        lod::set_mass<Dim>(body, mass, inertia);
    }
    lod::check_body(body, spec.name);
    return body;
}

/// The shape of one entry, and whether its tree is asked for in words that are known: all that can
/// be wrong with it is found before the first tree is built.
template <int Dim>
std::shared_ptr<const Shape<Dim>> loaded(const BodySpec& spec, double raise_limits,
                                         ShapeCache<Dim>& made,
                                         std::vector<std::string>& warnings) {
    if (spec.shape != half_space_name) {
        static_cast<void>(Shapes<Dim>::settings(tree_choice_of(spec)));
        return shape_of(spec, raise_limits, made, warnings);
    }
    auto& shape = made.shapes[key_of<Dim>(spec)];
    if (!shape) shape = std::make_shared<const Shape<Dim>>(Shapes<Dim>::half_space());
    return shape;
}

/// The tree and the body of one entry, whose shape is loaded.
template <int Dim>
void add_body(const BodySpec& spec, const SetupOptions& options,
              const std::function<void(double)>& progress, Setup<Dim>& setup,
              ShapeCache<Dim>& made) {
    const Shape<Dim>& shape = *setup.shapes[setup.bodies.size()];
    typename ShapeCache<Dim>::SharedTree tree =
        spec.shape == half_space_name ? std::make_shared<const lod::SphereTree<Dim>>(
                                            lod::half_space<Dim>(lod::Vector<Dim>::Unit(1)))
                                      : shared_tree(spec, shape, options.cache, progress, made);
    setup.bodies.push_back(body_of<Dim>(spec, shape, std::move(tree)));
    auto& exact = made.exact[&shape];
    if (!exact) exact = Shapes<Dim>::exact_of(shape);
    setup.bodies.back().exact = exact;
}

/// Does something about one entry; what is refused names it.
template <class Work>
void at(const BodySpec& spec, const Work& work) {
    lod::check_interrupted();
    try {
        work();
    } catch (const lod::Error& error) {
        // A shape that is misspelt in a file is input that is refused, not wrong usage.
        const auto kind =
            error.kind() == lod::ErrorKind::usage ? lod::ErrorKind::input_refused : error.kind();
        throw lod::Error(kind, spec.where + ": body " + spec.name + ": " + error.what());
    }
}

/// A line for every two bodies, not both static, whose shapes share a point at the start.
template <int Dim>
void warn_of_overlaps(Setup<Dim>& setup, ShapeCache<Dim>& made) {
    std::vector<lod::PosedTree<Dim>> world_S(setup.bodies.size());
    for (std::size_t i = 0; i < world_S.size(); ++i) world_S[i].pose(setup.bodies[i]);
    std::vector<lod::CandidatePair> candidates;
    lod::BroadPhase<Dim>().find(setup.bodies, world_S, candidates);
    for (const lod::CandidatePair& pair : candidates) {
        lod::check_interrupted();
        const auto a = static_cast<std::size_t>(pair.a);
        const auto b = static_cast<std::size_t>(pair.b);
        if (!Shapes<Dim>::touch(made.border_of(*setup.shapes[a]), setup.bodies[a],
                                made.border_of(*setup.shapes[b]), setup.bodies[b]))
            continue;
        setup.warnings.push_back(
            setup.scene.bodies[b].where + ": bodies " + setup.scene.bodies[a].name + " and " +
            setup.scene.bodies[b].name +
            " touch or overlap at the start; move one of them if that is not meant");
    }
}

}  // namespace

template <int Dim>
Setup<Dim> set_up(const Scene& scene, const SetupOptions& options) {
    Setup<Dim> setup;
    setup.scene = scene;
    ShapeCache<Dim> made;
    const auto count = static_cast<double>(scene.bodies.size());
    for (const BodySpec& spec : scene.bodies)
        at(spec, [&] {
            setup.shapes.push_back(loaded(spec, options.raise_limits, made, setup.warnings));
        });
    for (const BodySpec& spec : scene.bodies) {
        const auto done = static_cast<double>(setup.bodies.size());
        const auto progress = [&](double share) {
            if (options.progress) options.progress((done + share) / count);
        };
        at(spec, [&] { add_body(spec, options, progress, setup, made); });
    }
    warn_of_overlaps(setup, made);
    return setup;
}

template Setup<2> set_up(const Scene&, const SetupOptions&);
template Setup<3> set_up(const Scene&, const SetupOptions&);

}  // namespace scenes
