#include "lodlab/live/choices.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "lodlab/core/base/error.hpp"

namespace live {
namespace {

template <class Kind>
constexpr auto words_of = names_of(Kind{});

constexpr std::array all_choices{
    StageChoice{"policy", words_of<lod::Priority>,
                [](Stage& stage, std::string_view word) {
                    stage.set_policy(lod::chosen<lod::Priority>(word, "policy"));
                }},
    StageChoice{"contact_model", words_of<lod::ContactModel>,
                [](Stage& stage, std::string_view word) {
                    stage.set_contact_model(lod::chosen<lod::ContactModel>(word, "contact model"));
                }},
    StageChoice{"response", words_of<lod::Response>,
                [](Stage& stage, std::string_view word) {
                    stage.set_response(lod::chosen<lod::Response>(word, "response"));
                }},
    StageChoice{"shown", words_of<Shown>,
                [](Stage& stage, std::string_view word) {
                    stage.show(lod::chosen<Shown>(word, "kind of nodes shown"));
                }},
};

}  // namespace

const StageChoice* find_stage_choice(std::string_view name) {
    const auto found = std::find_if(all_choices.begin(), all_choices.end(),
                                    [&](const StageChoice& one) { return one.name == name; });
    return found != all_choices.end() ? &*found : nullptr;
}

const StageChoice& stage_choice(std::string_view name) {
    if (const StageChoice* found = find_stage_choice(name)) return *found;
    std::string names;
    for (const StageChoice& one : all_choices)
        names += (names.empty() ? "" : ", ") + std::string(one.name);
    throw lod::Error(lod::ErrorKind::usage,
                     "a stage has no choice '" + std::string(name) + "'; there are: " + names);
}

}  // namespace live
