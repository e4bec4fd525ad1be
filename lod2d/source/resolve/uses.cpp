#include "lodlab/lod2d/source/resolve/uses.hpp"

#include <pugixml.hpp>
#include <unordered_map>

namespace lod2d {
namespace {

using pugi::xml_node;

/// Counts what is drawn, each target of a `use` once.
class UseCount {
  public:
    UseCount(const SvgXml& xml, const SvgSettings& settings) : xml_(xml), settings_(settings) {
        collect(xml.root());
    }

    /// Elements drawn by this one, itself included, up to the limit and one more.
    std::size_t count(const xml_node& node, int depth) {
        if (depth > settings_.most_depth)
            xml_.refuse(node,
                        "its elements are nested deeper than " +
                            std::to_string(settings_.most_depth) +
                            "; simplify it or raise the limit",
                        lod::ErrorKind::limit_exceeded);
        std::size_t sum = 1;
        for (const xml_node& child : node.children())
            if (child.type() == pugi::node_element) sum += count(child, depth + 1);
        if (local_name(node.name()) == "use") sum += count_target(node, depth);
        if (sum > settings_.most_elements)
            xml_.refuse(node,
                        "it draws more than " + std::to_string(settings_.most_elements) +
                            " elements; simplify it or raise the limit",
                        lod::ErrorKind::limit_exceeded);
        return sum;
    }

  private:
    struct Target {
        xml_node node;
        std::size_t count = 0;
        bool in_use = false;
    };

    void collect(const xml_node& node) {
        if (const auto id = node.attribute("id")) targets_.try_emplace(id.value(), Target{node});
        for (const xml_node& child : node.children()) collect(child);
    }

    std::size_t count_target(const xml_node& use, int depth) {
        const std::string link = svg_link(use);
        const auto found = link.starts_with('#') ? targets_.find(link.substr(1)) : targets_.end();
        if (found == targets_.end()) return 0;
        Target& target = found->second;
        if (target.in_use)
            xml_.refuse(use, "<use> of '" + link + "' draws itself; break the circle");
        if (target.count == 0) {
            target.in_use = true;
            target.count = count(target.node, depth + 1);
            target.in_use = false;
        }
        return target.count;
    }

    const SvgXml& xml_;
    const SvgSettings& settings_;
    std::unordered_map<std::string, Target> targets_;
};

}  // namespace

void check_svg_uses(const SvgXml& xml, const SvgSettings& settings) {
    (void)UseCount(xml, settings).count(xml.root(), 0);
}

}  // namespace lod2d
