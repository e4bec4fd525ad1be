#include <algorithm>

#include "lessons/course/10_circles_to_spheres/lesson.hpp"
#include "lodlab/core/tree/traversal.hpp"
#include "lodlab/lod3d/mesh/intersect.hpp"
#include "lodlab/viz/draw/draw_traversal.hpp"

namespace lessons::spheres {
namespace {

using lod::Sphere;

constexpr double quarter_turn = 3.14159265358979323846 / 2;
constexpr viz::Viewpoint at_the_links{.azimuth = 0.6, .elevation = 0.45};

/// Two rings that hang in each other like links of a chain.
struct Links {
    viz::Actor<3> a;
    viz::Actor<3> b;
    std::vector<lod::Front> fronts;
    bool touch = false;  ///< whether the meshes themselves do
};

lod3d::Pose pose_of(const lod::Body<3>& body) {
    return {lod::Space<3>::rotation(body.orientation), body.position};
}

/// The second ring stands upright in the first, its centre `shift` to the right.
Links make_links(const Ring& ring, double shift) {
    Links links{ring.body, ring.body, {}, false};
    links.b.body.position = Vec(shift, 0, 0);
    links.b.body.orientation =
        lod::Space<3>::turned(lod::Space<3>::unturned(), Vec(quarter_turn, 0, 0));
    links.fronts = lod::traverse_levels<3>(links.a.body, links.b.body);
    const lod3d::TriangleTree mesh(ring.solid.mesh);
    links.touch =
        lod3d::surfaces_intersect(mesh, pose_of(links.a.body), mesh, pose_of(links.b.body));
    return links;
}

constexpr double hanging_free = 0.38;  ///< each tube in the middle of the other's hole [m]
constexpr double pulled = 0.53;        ///< tube against tube [m]

/// All levels side by side.
viz::Figure montage(const Links& links) {
    viz::Figure figure = viz::traversal<3>(links.a, links.b, links.fronts, {}, at_the_links);
    figure.columns = static_cast<int>(figure.panels.size());
    figure.caption.clear();
    name_levels(figure, links.fronts);
    return figure;
}

void give_apart(Lesson& lesson, const Links& links) {
    const std::size_t leaves = links.a.body.tree->level_nodes(1000).size();
    for (std::size_t level = 1; level < links.fronts.size(); ++level)
        give(lesson, "link pairs " + std::to_string(level),
             count(links.fronts[level].pairs.size()));
    give(lesson, "link tests", count(links.fronts.back().tests));
    give(lesson, "link levels", count(links.fronts.size() - 1));
    give(lesson, "leaf pairs", count(leaves * leaves));
    give(lesson, "links", montage(links));
}

void give_collision(Lesson& lesson, const Links& links) {
    give(lesson, "pulled tests", count(links.fronts.back().tests));
    give(lesson, "pulled pairs", count(links.fronts.back().pairs.size()));
    give(lesson, "pulled triangles", words(links.touch ? "touch as well" : "do not touch yet"));
    give(lesson, "pulled", montage(links));
}

/// The spheres of a body's finest level, as circles in the shadow along an axis.
std::vector<Sphere<2>> shadow(const lod::Body<3>& body, int axis) {
    // listing: shadow
    std::vector<Sphere<2>> circles;
    for (const int node : body.tree->level_nodes(body.tree->levels() - 1)) {
        const Sphere<3> ball = viz::carried_node(body, node);
        const lod::Vector<2> seen(ball.centre[(axis + 1) % 3], ball.centre[(axis + 2) % 3]);
        circles.push_back({seen, ball.radius});
    }
    // end of listing
    return circles;
}

/// A shadow of the links, its overlapping circles bold.
struct Shadow {
    viz::Panel panel;
    int pairs = 0;
};

Shadow cast_shadow(const Links& links, int axis) {
    const std::vector<Sphere<2>> a = shadow(links.a.body, axis);
    const std::vector<Sphere<2>> b = shadow(links.b.body, axis);
    std::vector<bool> a_meets(a.size());
    std::vector<bool> b_meets(b.size());
    Shadow cast;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            if (lod::overlap(a[i], b[j])) {
                a_meets[i] = b_meets[j] = true;
                ++cast.pairs;
            }
    std::vector<Sphere<2>> all = a;
    all.insert(all.end(), b.begin(), b.end());
    cast.panel.view = viz::grown(box_round(all), 0.03);
    const auto add = [&](const std::vector<Sphere<2>>& circles, const std::vector<bool>& meets,
                         int body, bool bold) {
        for (std::size_t i = 0; i < circles.size(); ++i)
            if (meets[i] == bold)
                add_ball(cast.panel, circles[i],
                         style(bold ? viz::Role::meeting_node : viz::Role::node, body));
    };
    for (const bool bold : {false, true}) {
        add(a, a_meets, 0, bold);
        add(b, b_meets, 1, bold);
    }
    return cast;
}

void give_shadows(Lesson& lesson, const Links& links) {
    viz::Figure figure;
    figure.columns = 3;
    int overlapping = 0;
    for (const auto& [axis, name] :
         {std::pair{2, "from the front"}, {0, "from the side"}, {1, "from above"}}) {
        Shadow cast = cast_shadow(links, axis);
        give(lesson, std::string("shadow ") + name, count(cast.pairs));
        cast.panel.title = std::string(name).substr(std::string_view(name).rfind(' ') + 1) + ": " +
                           pairs_text(static_cast<std::size_t>(cast.pairs));
        figure.panels.push_back(std::move(cast.panel));
        if (cast.pairs > 0) ++overlapping;
    }
    give(lesson, "overlapping shadows", count(overlapping));
    figure.numbers = {{"pairs of spheres that meet", lesson.numbers["link pairs 2"].text}};
    give(lesson, "shadows", std::move(figure));
}

/// Once round the free chain, a level for each third of the way.
void animate(Lesson& lesson, const Links& links) {
    constexpr int pictures = 36;
    constexpr int held = 4;  // frames
    const int levels = static_cast<int>(links.fronts.size());
    for (int i = 0; i < pictures; ++i) {
        const auto draw = [links, levels, i] {
            const int level = i * levels / pictures;
            const double azimuth = *at_the_links.azimuth + 4 * quarter_turn * i / pictures;
            viz::Figure figure =
                viz::traversal_level<3>(links.a, links.b, links.fronts, level,
                                        {.azimuth = azimuth, .elevation = at_the_links.elevation});
            figure.caption.clear();
            return figure;
        };
        lesson.animation.shots.push_back({draw, held});
    }
}

}  // namespace

void give_links(Lesson& lesson, const Ring& ring) {
    const Links links = make_links(ring, hanging_free);
    give_apart(lesson, links);
    give_shadows(lesson, links);
    give_collision(lesson, make_links(ring, pulled));
    animate(lesson, links);
}

}  // namespace lessons::spheres
