#include <algorithm>

#include "lessons/course/05_circles_to_spheres/lesson.hpp"
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

std::string pairs_text(std::size_t pairs) {
    return shown_count(pairs) + (pairs == 1 ? " pair" : " pairs");
}

/// All levels side by side.
viz::Figure montage(const Links& links, const std::string& title) {
    viz::Figure figure = viz::traversal<3>(links.a, links.b, links.fronts, {}, at_the_links);
    for (std::size_t level = 0; level < figure.panels.size(); ++level) {
        const std::size_t pairs = links.fronts[level].pairs.size();
        figure.panels[level].title = "Level " + std::to_string(level) + ": " +
                                     (pairs == 0 ? "no pairs, apart" : pairs_text(pairs));
    }
    figure.columns = static_cast<int>(figure.panels.size());
    figure.title = title;
    figure.caption.clear();
    figure.numbers = {{"tests", shown_count(links.fronts.back().tests)},
                      {"verdict", in_words(links.fronts.back().verdict)}};
    return figure;
}

void step_apart(Lesson& lesson, const Links& links) {
    for (std::size_t level = 0; level < links.fronts.size(); ++level)
        lesson.numbers["link pairs " + std::to_string(level)] =
            count(links.fronts[level].pairs.size());
    const auto leaves = static_cast<std::uint64_t>(links.a.body.tree->level_nodes(1000).size());
    lesson.numbers["link tests"] = count(links.fronts.back().tests);
    lesson.numbers["link levels"] = count(links.fronts.size() - 1);
    lesson.numbers["leaf pairs"] = count(leaves * leaves);
    add_step(lesson, "Two links of a chain",
             "Hang one ring in another. They do not touch, and yet they cannot be parted: nothing "
             "in the plane is like it. The traversal of lesson 3 does not mind. Level 0: the roots "
             "overlap, by far. Level 1: {{number: link pairs 1}} pairs of beads, drawn bold. At "
             "level {{number: link levels}} **no two spheres meet**, and that is proof, after "
             "{{number: link tests}} tests; there are {{number: leaf pairs}} pairs of leaves.\n\n"
             "**Predict:** look at the chain from the front, from the side and from above, and "
             "draw its shadow each time. In how many of the three shadows will the two rings "
             "overlap?",
             montage(links, "Linked, and proved apart"),
             {{"tests", "link tests"}, {"pairs of leaves", "leaf pairs"}}, "links");
}

void step_collision(Lesson& lesson, const Links& links) {
    lesson.numbers["pulled tests"] = count(links.fronts.back().tests);
    lesson.numbers["pulled pairs"] = count(links.fronts.back().pairs.size());
    add_step(lesson, "Pull the chain",
             "Pull the second ring to the right until tube meets tube. Now the last front holds "
             "{{number: pulled pairs}} pairs of leaves: a *true collision*. The triangles "
             "themselves, asked one by one, " +
                 std::string(links.touch ? "touch as well" : "do not touch yet") +
                 ". Each pair of leaves is a contact, with its point on a line of centres and a "
                 "push along it, exactly as in lesson 4.",
             montage(links, "Tube against tube: the leaves meet"),
             {{"tests", "pulled tests"}, {"pairs of leaves", "pulled pairs"}});
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

void step_shadows(Lesson& lesson, const Links& links) {
    viz::Figure figure;
    figure.title = "Three shadows overlap, and the rings are apart";
    figure.columns = 3;
    int overlapping = 0;
    for (const auto& [axis, name] :
         {std::pair{2, "from the front"}, {0, "from the side"}, {1, "from above"}}) {
        Shadow cast = cast_shadow(links, axis);
        const std::string key = std::string("shadow ") + name;
        lesson.numbers[key] = count(cast.pairs);
        cast.panel.title =
            std::string(name) + ": " + pairs_text(static_cast<std::size_t>(cast.pairs));
        figure.panels.push_back(std::move(cast.panel));
        if (cast.pairs > 0) ++overlapping;
    }
    lesson.numbers["overlapping shadows"] = count(overlapping);
    figure.alt =
        "The circles that the spheres of both rings throw as shadows along the three axes. In "
        "every shadow many circles of the one ring overlap circles of the other.";
    figure.numbers = {{"pairs of spheres that meet", lesson.numbers["link pairs 2"].text}};
    add_step(lesson, "Shadows say less than spheres",
             "A page is flat, and the paper shows its collisions in space as projections. An "
             "orthographic shadow of a sphere is a circle of the same radius, so it is easy to "
             "draw. But look: the free chain of before, the leaves of both trees. In "
             "**{{number: overlapping shadows}} of 3** shadows circles overlap, {{number: shadow "
             "from the front}}, {{number: shadow from the side}} and {{number: shadow from above}} "
             "pairs of them. In space {{number: link pairs 2}} pairs of spheres meet.\n\n"
             "It is the same one-way street as ever. Shadows apart: the bodies are apart, for a "
             "shadow never moves points farther from each other. Shadows overlap: *possible*. "
             "That is why the program tests spheres, and why a picture of space needs light, "
             "outlines and a view that turns.",
             std::move(figure),
             {{"from the front", "shadow from the front"},
              {"from the side", "shadow from the side"},
              {"from above", "shadow from above"},
              {"in space", "link pairs 2"}},
             "shadows");
}

/// Once round the free chain, a level for each third of the way.
void animate(Lesson& lesson, const Links& links) {
    constexpr int pictures = 36;
    constexpr int held = 4;  // frames
    lesson.animation.title = "Once round two links of a chain, level by level";
    lesson.animation.frames_per_second = 30;
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

void add_links(Lesson& lesson, const Ring& ring) {
    const Links links = make_links(ring, hanging_free);
    step_apart(lesson, links);
    step_shadows(lesson, links);
    step_collision(lesson, make_links(ring, pulled));
    animate(lesson, links);
}

}  // namespace lessons::spheres
