#include "lodlab/io/tree_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/files/read_file.hpp"

namespace io {
namespace {

using nlohmann::json;

constexpr const char* format_name = "lodlab tree";
constexpr int format_version = 2;

void append(std::string& text, double value) {
    char digits[32];
    const auto end = lod::to_chars(digits, digits + sizeof digits, value).ptr;
    const std::string_view number(digits, static_cast<std::size_t>(end - digits));
    text += number == "-0" ? "-0.0" : number;  // "-0" would be read as the whole number 0
}

template <std::size_t Size>
void append(std::string& text, const std::array<std::vector<double>, Size>& columns,
            std::size_t row) {
    text += '[';
    for (std::size_t d = 0; d < Size; ++d) {
        if (d > 0) text += ", ";
        append(text, columns[d][row]);
    }
    text += ']';
}

template <class Items, class Each>
void append_list(std::string& text, const Items& items, const Each& each) {
    text += '[';
    bool first = true;
    for (const auto& item : items) {
        if (!std::exchange(first, false)) text += ", ";
        each(item);
    }
    text += ']';
}

template <int Dim>
void append(std::string& text, const lod::HullView<Dim>& hull, bool tight, bool round) {
    text += ", \"hull\": {\"corners\": ";
    append_list(text, hull.corners, [&](const lod::Vector<Dim>& corner) {
        append_list(text, corner, [&](double x) { append(text, x); });
    });
    text += ", \"faces\": ";
    std::vector<std::size_t> faces(hull.normals.size());
    std::iota(faces.begin(), faces.end(), 0u);
    append_list(text, faces, [&](std::size_t face) {
        append_list(text, hull.loop(face),
                    [&](std::int32_t corner) { text += std::to_string(corner); });
    });
    std::erase_if(faces, [&](std::size_t face) { return hull.inner[face] == 0; });
    if (tight) text += ", \"tight\": true";
    if (round) text += ", \"round\": true";
    text += ", \"inner\": ";
    append_list(text, faces, [&](std::size_t face) { text += std::to_string(face); });
    std::vector<std::size_t> cut(hull.corners.size());
    std::iota(cut.begin(), cut.end(), 0u);
    std::erase_if(cut, [&](std::size_t corner) { return hull.cut[corner] == 0; });
    if (!cut.empty()) text += ", \"cut\": ";
    if (!cut.empty())
        append_list(text, cut, [&](std::size_t corner) { text += std::to_string(corner); });
    text += '}';
}

/// Reads one tree; knows where it is, for errors.
class Reader {
  public:
    Reader(std::string source, int dim) : source_(std::move(source)), dim_(dim) {}

    [[noreturn]] void refuse(const std::string& where, const std::string& why) const {
        throw lod::Error(lod::ErrorKind::input_refused,
                         source_ + ": " + where + why + "; save the tree again with lodlab");
    }

    json parsed(std::string_view text) const {
        try {
            return json::parse(text);
        } catch (const json::exception& e) {
            // "[json.exception.parse_error.101] parse error at line 1, column 5: ..."
            const std::string why = e.what();
            refuse("",
                   "not JSON: " +
                       why.substr(why.find("] ") == std::string::npos ? 0 : why.find("] ") + 2));
        }
    }

    const json& member(const json& object, const char* key, const std::string& where) const {
        if (!object.is_object()) refuse(where, "not an object");
        const auto it = object.find(key);
        if (it == object.end()) refuse(where, std::string("the key \"") + key + "\" is missing");
        return *it;
    }

    std::size_t count(const json& value, const std::string& where) const {
        if (!value.is_number_unsigned()) refuse(where, "not a whole number of 0 or more");
        return value.get<std::size_t>();
    }

    double number(const json& value, const std::string& where) const {
        if (!value.is_number()) refuse(where, "not a number");
        const double number = value.get<double>();
        if (!std::isfinite(number)) refuse(where, "not finite");
        return number;
    }

    template <int Dim>
    lod::Vector<Dim> vector(const json& value, const std::string& where) const {
        if (!value.is_array() || value.size() != Dim)
            refuse(where, "not a list of " + std::to_string(Dim) + " numbers");
        lod::Vector<Dim> v;
        for (int d = 0; d < Dim; ++d) v[d] = number(value[static_cast<std::size_t>(d)], where);
        return v;
    }

    void check_head(const json& file) const {
        if (const json& format = member(file, "format", ""); format != format_name)
            refuse("", std::string("the format is not \"") + format_name + "\"");
        if (const json& version = member(file, "version", ""); version != format_version)
            refuse("", "version " + version.dump() + " of the format is not known, only " +
                           std::to_string(format_version));
        if (const json& dim = member(file, "dim", ""); dim != dim_)
            refuse("", "a tree of dimension " + dim.dump() + ", not " + std::to_string(dim_));
    }

    template <int Dim>
    lod::TreeNode<Dim> node(const json& value, std::size_t place, std::size_t nodes,
                            std::size_t& next_child) const {
        const std::string at = "node " + std::to_string(place) + ": ";
        lod::TreeNode<Dim> node;
        node.sphere.centre = vector<Dim>(member(value, "centre", at), at + "the centre is ");
        node.sphere.radius = number(member(value, "radius", at), at + "the radius is ");
        if (node.sphere.radius < 0) refuse(at, "the radius is negative");
        node.mean_normal = vector<Dim>(member(value, "normal", at), at + "the normal is ");
        if (!(node.mean_normal.norm() <= 1 + 1e-9)) refuse(at, "the normal is longer than 1");
        const json& children = member(value, "children", at);
        if (!children.is_array()) refuse(at, "the children are not a list");
        for (const json& child : children) {
            const std::size_t number = count(child, at + "a child is ");
            if (number >= nodes) refuse(at, "child " + std::to_string(number) + " does not exist");
            if (number != next_child || number <= place)
                refuse(at, "child " + std::to_string(number) + " where " +
                               std::to_string(next_child) + " should come next");
            node.children.push_back(static_cast<int>(number));
            ++next_child;
        }
        return node;
    }

    /// Which of `size` things a list names by their numbers.
    std::vector<bool> chosen(const json& numbers, std::size_t size, const std::string& thing,
                             const std::string& at) const {
        std::vector<bool> chosen(size, false);
        if (!numbers.is_array()) refuse(at, "not a list of " + thing + "s");
        for (const json& number : numbers) {
            const std::size_t place = count(number, at + "a " + thing + "'s number is ");
            if (place >= size) refuse(at, thing + " " + std::to_string(place) + " does not exist");
            chosen[place] = true;
        }
        return chosen;
    }

    template <int Dim>
    lod::Hull<Dim> hull(const json& value, std::size_t place) const {
        const std::string at = "node " + std::to_string(place) + ": the hull: ";
        lod::Hull<Dim> hull;
        const json& corners = member(value, "corners", at);
        const json& faces = member(value, "faces", at);
        if (!corners.is_array() || corners.size() > lod::most_hull_corners<Dim>)
            refuse(at, "not a list of at most " + std::to_string(lod::most_hull_corners<Dim>) +
                           " corners");
        if (!faces.is_array() || faces.size() > lod::most_hull_faces<Dim>)
            refuse(at,
                   "not a list of at most " + std::to_string(lod::most_hull_faces<Dim>) + " faces");
        if (corners.size() <= Dim || faces.size() <= Dim) refuse(at, "it encloses nothing");
        for (const json& corner : corners)
            hull.corners.push_back(vector<Dim>(corner, at + "a corner is "));
        for (const json& face : faces) {
            if (!face.is_array() || face.size() < Dim) refuse(at, "a face has too few corners");
            std::vector<std::int32_t>& loop = hull.faces.emplace_back();
            for (const json& number : face) {
                const std::size_t corner = count(number, at + "a corner's number is ");
                if (corner >= hull.corners.size())
                    refuse(at, "corner " + std::to_string(corner) + " does not exist");
                loop.push_back(static_cast<std::int32_t>(corner));
            }
        }
        hull.inner = chosen(member(value, "inner", at), hull.faces.size(), "face", at);
        if (const auto cut = value.find("cut"); cut != value.end())
            hull.cut = chosen(*cut, hull.corners.size(), "corner", at);
        if (const auto tight = value.find("tight"); tight != value.end())
            hull.tight = *tight == true;
        if (const auto round = value.find("round"); round != value.end())
            hull.round = *round == true;
        return hull;
    }

    /// Every node has a hull but those below a tight one.
    template <int Dim>
    void add_hulls(const json& file, const json& list, lod::SphereTree<Dim>& tree) const {
        std::vector<char> covered(list.size(), 0);
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::string at = "node " + std::to_string(i) + ": ";
            if (i > 0) covered[i] = covered[tree.index(tree.parent[i])];
            if (covered[i] != 0 && list[i].contains("hull"))
                refuse(at, "it has a hull of its own, below one that is tight");
            if (covered[i] != 0) {
                tree.hulls.add({});
                continue;
            }
            const lod::Hull<Dim> own = hull<Dim>(member(list[i], "hull", at), i);
            covered[i] = own.tight;
            tree.hulls.add(own);
        }
        tree.hulls.find_best(tree.parent);
        const std::size_t entry = count(member(file, "entry_level", ""), "the entry level is ");
        if (entry >= static_cast<std::size_t>(tree.levels()))
            refuse("", "the entry level is " + std::to_string(entry) + ", deeper than the tree");
        tree.hulls.entry_level = static_cast<int>(entry);
    }

  private:
    std::string source_;
    int dim_;
};

}  // namespace

template <int Dim>
std::string tree_to_json(const lod::SphereTree<Dim>& tree) {
    std::string text = "{\"format\": \"" + std::string(format_name) +
                       "\", \"version\": " + std::to_string(format_version) +
                       ", \"dim\": " + std::to_string(Dim) +
                       ", \"nodes\": " + std::to_string(tree.size()) + ", \"levels\": [";
    for (std::size_t level = 0; level + 1 < tree.level_begin.size(); ++level) {
        if (level > 0) text += ", ";
        text += std::to_string(tree.level_begin[level + 1] - tree.level_begin[level]);
    }
    text += ']';
    if (!tree.hulls.empty()) text += ", \"entry_level\": " + std::to_string(tree.hulls.entry_level);
    text += ",\n \"tree\": [";
    for (int node = 0; node < tree.size(); ++node) {
        const auto at = tree.index(node);
        text += node > 0 ? ",\n  {\"centre\": " : "\n  {\"centre\": ";
        append(text, tree.centre, at);
        text += ", \"radius\": ";
        append(text, tree.radius[at]);
        text += ", \"normal\": ";
        append(text, tree.normal, at);
        text += ", \"children\": [";
        for (int child = 0; child < tree.child_count[at]; ++child) {
            if (child > 0) text += ", ";
            text += std::to_string(tree.first_child[at] + child);
        }
        text += ']';
        if (tree.has_hulls() && !tree.hulls.of(node).empty())
            append(text, tree.hulls.of(node), tree.hulls.is_tight(node), tree.hulls.is_round(node));
        text += '}';
    }
    return text + "]}\n";
}

template <int Dim>
lod::SphereTree<Dim> tree_from_json(std::string_view text, const std::string& source) {
    const Reader reader(source, Dim);
    const json file = reader.parsed(text);
    reader.check_head(file);
    const json& list = reader.member(file, "tree", "");
    if (!list.is_array() || list.empty()) reader.refuse("", "\"tree\" is not a list of nodes");
    if (list.size() != reader.count(reader.member(file, "nodes", ""), "\"nodes\" is "))
        reader.refuse("", "\"nodes\" is not " + std::to_string(list.size()) +
                              ", as many as there are in \"tree\"");
    std::vector<lod::TreeNode<Dim>> nodes;
    nodes.reserve(list.size());
    std::size_t next_child = 1;
    for (const json& value : list)
        nodes.push_back(reader.node<Dim>(value, nodes.size(), list.size(), next_child));
    if (next_child != nodes.size())
        reader.refuse("", "node " + std::to_string(next_child) + " is nobody's child");
    lod::SphereTree<Dim> tree = lod::lay_out<Dim>(nodes);
    if (list.front().contains("hull")) reader.add_hulls(file, list, tree);
    json levels = json::array();
    for (int level = 0; level < tree.levels(); ++level)
        levels.push_back(tree.level_begin[tree.index(level + 1)] -
                         tree.level_begin[tree.index(level)]);
    if (reader.member(file, "levels", "") != levels)
        reader.refuse("", "\"levels\" is not " + levels.dump() + ", as the nodes say");
    return tree;
}

template <int Dim>
void save_tree(const std::filesystem::path& path, const lod::SphereTree<Dim>& tree) {
    lod::write_text_file(path, tree_to_json(tree));
}

template <int Dim>
lod::SphereTree<Dim> load_tree(const std::filesystem::path& path, std::size_t most_bytes) {
    return tree_from_json<Dim>(lod::read_text_file(path, most_bytes), path.string());
}

#define IO_INSTANTIATE(Dim)                                                                  \
    template std::string tree_to_json(const lod::SphereTree<Dim>&);                          \
    template lod::SphereTree<Dim> tree_from_json<Dim>(std::string_view, const std::string&); \
    template void save_tree(const std::filesystem::path&, const lod::SphereTree<Dim>&);      \
    template lod::SphereTree<Dim> load_tree<Dim>(const std::filesystem::path&, std::size_t);
IO_INSTANTIATE(2)
IO_INSTANTIATE(3)
#undef IO_INSTANTIATE

}  // namespace io
