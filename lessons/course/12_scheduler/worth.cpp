#include <algorithm>
#include <array>

#include "lessons/course/12_scheduler/lesson.hpp"

namespace lessons::scheduler {
namespace {

using lod::Priority;

constexpr auto policies = lod::choices<Priority>();
using Errors = std::array<Error, policies.size()>;

Errors errors_under(const Crowd& crowd, std::uint64_t quota) {
    Errors errors;
    for (std::size_t i = 0; i < policies.size(); ++i)
        errors[i] = error_of(crowd, policies[i], quota);
    return errors;
}

/// A row for each policy, its errors as bars.
viz::Panel bars(const Errors& errors, bool attended) {
    constexpr double names = 0.42;  // how far to the left the names begin, in errors
    constexpr double room = 0.12;   // at the right
    constexpr double high = 0.36;   // a bar
    double most = 0;
    for (const Error& error : errors) most = std::max({most, error.all, error.attended});
    viz::Panel panel;
    panel.view = box(-names, -0.2, most + room, static_cast<double>(policies.size()));
    panel.axes = viz::Axes{{"share that is wrong", viz::Scale::linear, {0, 0.2, 0.4, 0.6}, false},
                           {"", viz::Scale::linear, {}, false, true}};
    const auto add_bar = [&](double low, double length, int part) {
        panel.marks.push_back(
            viz::Path{style(viz::Role::share, part),
                      {{{0, low}, {length, low}, {length, low + high}, {0, low + high}}}});
    };
    for (std::size_t i = 0; i < policies.size(); ++i) {
        const double low = static_cast<double>(policies.size() - 1 - i);
        const double told = attended ? errors[i].attended : errors[i].all;
        if (attended) add_bar(low, told, 1);
        add_bar(low + (attended ? high : high / 2), errors[i].all, 0);
        const double tip = attended ? std::max(told, errors[i].all) : told;
        add_label(panel, viz::Role::note, {tip, low + high}, shown(told, 2));
        add_label(panel, viz::Role::note, {-names, low + high},
                  viz::literal_text(std::string(lod::name_of(policies[i]))));
    }
    return panel;
}

}  // namespace

void give_worth(Lesson& lesson, const Crowd& crowd) {
    const Errors errors = errors_under(crowd, crowd.quota());
    const Errors tight = errors_under(crowd, crowd.dearest / 5);
    for (std::size_t i = 0; i < policies.size(); ++i) {
        const std::string name(lod::name_of(policies[i]));
        give(lesson, name + " error", number(errors[i].all, 2));
        give(lesson, name + " attended", number(errors[i].attended, 2));
        give(lesson, name + " tight", number(tight[i].all, 2));
    }
    give(lesson, "frames", count(crowd.before.size()));
    give(lesson, "tight quota", count(crowd.dearest / 5));
    give(lesson, "worth", bars(errors, false));
    give(lesson, "worth attended", bars(errors, true));
}

}  // namespace lessons::scheduler
