#include "cli/stage/compare_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "cli/terminal/output.hpp"
#include "lodlab/viz/draw/motion/draw_comparison.hpp"

namespace cli {
namespace {

constexpr std::size_t most_levels = 5;       ///< of a still, besides the exact run
constexpr std::size_t most_film_panels = 3;  ///< of a video, besides Box2D's
constexpr double crowd_share = 1.5;          ///< of the time of the last first impact
constexpr int few_bodies = 3;                ///< that move: a film can dwell on their collision

/// So many of the levels, evenly from the coarsest to the finest.
std::vector<std::size_t> some_levels(std::size_t levels, std::size_t most) {
    std::vector<std::size_t> chosen;
    const std::size_t count = std::min(levels, most);
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(count == 1 ? 0 : (i * (levels - 1) + (count - 1) / 2) / (count - 1));
    return chosen;
}

/// Box2D's contacts of one frame as a frame's record, pair by pair.
void add_contacts(std::vector<lod2d::Box2dContact> contacts, lod::FrameRecord<2>& record) {
    std::stable_sort(contacts.begin(), contacts.end(), [](const auto& p, const auto& q) {
        return std::pair(p.a, p.b) < std::pair(q.a, q.b);
    });
    for (const lod2d::Box2dContact& contact : contacts) {
        const bool same = !record.pairs.empty() && record.pairs.back().bodies.a == contact.a &&
                          record.pairs.back().bodies.b == contact.b;
        if (!same) {
            lod::PairRecord pair;
            pair.bodies = {contact.a, contact.b};
            pair.verdict = lod::Verdict::true_collision;
            pair.first_contact = static_cast<std::int32_t>(record.impacts.size());
            record.pairs.push_back(pair);
        }
        ++record.pairs.back().contact_count;
        record.impacts.push_back({contact.a,
                                  contact.b,
                                  static_cast<std::int32_t>(record.pairs.size() - 1),
                                  {contact.point, contact.normal, 0}});
        record.impulses.push_back(contact.impulse);
    }
}

viz::Run<2> box2d_seen(const scenes::Setup<2>& setup, const lod2d::Box2dRun& run) {
    viz::Run<2> result;
    result.name = "Box2D";
    result.time_step = run.frame_step;
    for (std::size_t i = 0; i < setup.bodies.size(); ++i)
        result.visuals.push_back(visual_of<2>(*setup.shapes[i], setup.scene.bodies[i].name));
    auto impact = run.impacts.begin();
    for (std::size_t frame = 0; frame < run.frames.size(); ++frame) {
        const double until = (static_cast<double>(frame + 1) - 1e-9) * run.frame_step;
        std::vector<lod2d::Box2dContact> contacts;
        for (; impact != run.impacts.end() && impact->time < until; ++impact)
            contacts.insert(contacts.end(), impact->contacts.begin(), impact->contacts.end());
        lod::FrameRecord<2> record;
        add_contacts(std::move(contacts), record);
        viz::add_instant(result, run.frames[frame], record);
    }
    return result;
}

int moving(const scenes::Setup<2>& setup) {
    return static_cast<int>(std::count_if(setup.bodies.begin(), setup.bodies.end(),
                                          [](const auto& body) { return !body.is_static(); }));
}

/// "123", "4.5", "0.07", "0": no more digits than a reader takes in.
std::string whole_or_first(double number) {
    if (std::abs(number) >= 10) return readable(std::round(number), 9);
    const double hundredths = std::round(100 * number) / 100;
    return readable(hundredths, std::abs(hundredths) < 1 ? 1 : 2);
}

/// "12 ms early" against the reference, "late", or "never" where nothing is there.
std::string delay_words(const std::optional<measure::Collision<2>>& collision,
                        double reference_time) {
    if (!collision) return "never";
    const double delay = collision->time - reference_time;
    return whole_or_first(std::abs(1e3 * delay)).append(delay < 0 ? " ms early" : " ms late");
}

/// "Level 2: 12 ms early, 34 % off", by the first impact of all.
std::string heading(const measure::Comparison& comparison, std::size_t level) {
    std::string words = "Level " + std::to_string(level);
    if (comparison.first_impacts.empty()) return words;
    const measure::FirstImpact& impact = comparison.first_impacts.front();
    const auto& seen = impact.levels[level];
    const auto& reference = impact.exact ? impact.exact : impact.box2d;
    if (!reference) return words.append(seen ? ": a collision out of nothing" : ": no collision");
    words.append(": ").append(delay_words(seen, reference->time));
    if (!seen) return words;
    const double error = measure::impact_error(*reference, *seen).impulse;
    return words.append(", ").append(whole_or_first(100 * error)).append(" % off");
}

std::vector<viz::Run<2>> runs_of(const scenes::Setup<2>& setup,
                                 const measure::Comparison& comparison, std::size_t most,
                                 bool with_words) {
    std::vector<viz::Run<2>> runs;
    for (const std::size_t level : some_levels(comparison.levels.size(), most))
        runs.push_back(
            seen<2>(setup, comparison.levels[level].run,
                    with_words ? heading(comparison, level) : "Level " + std::to_string(level)));
    return runs;
}

std::string title_of(const scenes::Scene& scene) {
    return viz::literal_text(scene.title.empty() ? scene.name : scene.title);
}

/// The end of the run; where many bodies move, soon after all have met somebody: later their paths
/// have nothing to do with each other.
double picture_time(const scenes::Setup<2>& setup, const measure::Comparison& comparison) {
    const double end = static_cast<double>(setup.scene.frames()) * setup.scene.time_step;
    if (moving(setup) <= few_bodies || comparison.first_impacts.empty()) return end;
    double last = 0;
    for (const measure::FirstImpact& impact : comparison.first_impacts)
        if (impact.box2d) last = std::max(last, impact.box2d->time);
    return last > 0 ? std::min(end, crowd_share * last) : end;
}

viz::Figure figure_of(const scenes::Setup<2>& setup, const measure::Comparison& comparison) {
    auto runs = runs_of(setup, comparison, most_levels, true);
    runs.push_back(seen<2>(setup, comparison.exact.run, "Exact contacts"));
    const viz::Run<2> reference = box2d_seen(setup, comparison.box2d);
    const double end = picture_time(setup, comparison);
    viz::ComparisonWords words;
    words.title = title_of(setup.scene) + ": every level over Box2D";
    words.caption =
        "Dashed: Box2D. Headings: time and impulse of the first impact against the exact one. "
        "After several impacts paths part.";
    viz::Figure figure = viz::comparison<2>(runs, reference, end, words);
    figure.columns = runs.size() > 4 ? 3 : runs.size() > 1 ? 2 : 1;
    return figure;
}

viz::Animation film_of(const scenes::Setup<2>& setup, const measure::Comparison& comparison) {
    auto runs = runs_of(setup, comparison, most_film_panels, false);
    const viz::Run<2> reference = box2d_seen(setup, comparison.box2d);
    const bool any = std::any_of(runs.begin(), runs.end(),
                                 [](const auto& run) { return viz::first_impact(run) >= 0; });
    if (moving(setup) <= few_bodies && any) {
        runs.push_back(reference);
        viz::ImpactMotion choice;
        choice.title = title_of(setup.scene) + ": lodlab's levels, and Box2D";
        return viz::impact_motion<2>(runs, choice);
    }
    viz::ComparisonMotion choice;
    choice.words.title = title_of(setup.scene) + ": lodlab's levels, and Box2D";
    choice.words.caption = "Dashed: where Box2D has the bodies at the same time.";
    return viz::comparison_motion<2>(runs, reference, choice);
}

}  // namespace

Drawing drawing_of(const scenes::Setup<2>& setup, const measure::Comparison& comparison) {
    Drawing drawing;
    drawing.figure = [&setup, &comparison] {
        return framed<2>(figure_of(setup, comparison), setup.scene);
    };
    drawing.animation = [&setup, &comparison] {
        return framed<2>(film_of(setup, comparison), setup.scene);
    };
    return drawing;
}

}  // namespace cli
