#include "lessons/embed/lines.hpp"
#include "lessons/engine/filler.hpp"
#include "lessons/engine/lessons.hpp"
#include "lessons/engine/sketch.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/live/page/controls.hpp"

namespace lessons {
namespace {

/// The path of a source from lessons/course on.
std::string short_path(std::string path) {
    const std::size_t folder = path.rfind("lessons/course/");
    return folder == std::string::npos ? path : path.substr(folder);
}

void remember(Lesson& lesson, const std::string& what, const std::string& name,
              const Place& place) {
    const std::string where = short_path(place.file) + ":" + std::to_string(place.line);
    const auto [before, is_new] = lesson.given.emplace(what + name, where);
    if (!is_new)
        throw lod::Error(
            lod::ErrorKind::input_refused,
            where + ": the " + what + "'" + name + "' is given already, in " + before->second);
}

Step filled_step(const StepScript& script, Filler& filler) {
    Step step{script.title, trimmed(filler.fill(script.text, script.line)), script.figure, {}, {}};
    filler.use_figure(script.figure, script.figure_line);
    for (const ShownTag& tag : script.shown)
        step.numbers.push_back({tag.told, filler.number(tag.name, tag.format, tag.line)});
    for (const QuestionScript& question : script.questions)
        step.questions.push_back(make_question(question, filler));
    return step;
}

/// Gives a figure the words below its tag.
void caption(Lesson& lesson, const std::string& name, const Words& words, Filler& filler) {
    viz::Figure& figure = lesson.figures.at(name);
    const int line = lesson.script.figures.at(name);
    for (const auto& [key, said] : words) {
        if (key != "title" && key != "alt")
            refuse_line(lesson.script.where, said.line,
                        "a figure has no '" + key + "'; it has a title and an alt");
        (key == "title" ? figure.title : figure.alt) = filler.fill(said);
    }
    if (!words.count("title"))
        refuse_line(lesson.script.where, line,
                    "figure '" + name + "' has no title; add a line 'title: ...' below its tag");
    if (figure.alt.empty())
        refuse_line(lesson.script.where, line,
                    "figure '" + name + "' has no alt text; add a line 'alt: ...' below its tag");
}

/// What the lines below the live part's tag say of it.
void complete_live(Lesson& lesson, Filler& filler) {
    LivePart& live = *lesson.live;
    const auto say = [&](const std::string& key) -> const KeyText& {
        const auto found = lesson.script.live.find(key);
        if (found == lesson.script.live.end())
            refuse_line(
                lesson.script.where, lesson.script.live_line,
                "the live part has no " + key + "; add a line '" + key + ": ...' below its tag");
        return found->second;
    };
    live.title = filler.fill(say("title"));
    live.task = filler.fill(say("try"));
    const KeyText& controls = say("controls");
    live.controls = controls.text;
    try {
        live::check_controls(live.controls);
    } catch (const lod::Error& unknown) {
        refuse_line(lesson.script.where, controls.line, unknown.what());
    }
    for (const auto& [key, said] : lesson.script.live)
        if (key != "title" && key != "try" && key != "controls")
            refuse_line(lesson.script.where, said.line,
                        "a live part has no '" + key + "'; it has title, try and controls");
    live.scene.title = live.title;
}

void check_video_words(const Lesson& lesson) {
    for (const auto& [key, said] : lesson.script.video)
        if (key != "title" && !lesson.said.count(key))
            refuse_line(lesson.script.where, said.line,
                        "the lesson's code asks for no words '" + key + "' of its video");
}

}  // namespace

void give(Lesson& lesson, const std::string& name, Number number, Place place) {
    remember(lesson, "number ", name, place);
    lesson.numbers[name] = std::move(number);
}

void give(Lesson& lesson, const std::string& name, viz::Figure figure, Place place) {
    remember(lesson, "figure ", name, place);
    lesson.figures[name] = std::move(figure);
}

void give(Lesson& lesson, const std::string& name, viz::Panel panel, const Header& header,
          Place place) {
    viz::Figure figure = figure_of(std::move(panel));
    for (const auto& [told, number] : header)
        figure.numbers.push_back(
            {told, find_given(lesson.numbers, "number", number, short_path(place.file), place.line)
                       .text});
    give(lesson, name, std::move(figure), place);
}

void give(Lesson& lesson, const std::string& name, Picks picks, Place place) {
    remember(lesson, "picks ", name, place);
    lesson.picks[name] = std::move(picks);
}

void give(Lesson& lesson, live::Scene scene, Place place) {
    remember(lesson, "live part", "", place);
    scene.name = lesson.entry.slug;
    lesson.live = LivePart{std::move(scene), {}, {}, {}};
}

std::string video_words(Lesson& lesson, const std::string& key) {
    const KeyText& said =
        find_given(lesson.script.video, "video's words", key, lesson.script.where, 1);
    lesson.said.insert(key);
    return Filler(lesson).fill(said);
}

void complete(Lesson& lesson) {
    Filler filler(lesson);
    lesson.text = filler.fill(lesson.script.text, 0);
    for (const StepScript& step : lesson.script.steps)
        lesson.steps.push_back(filled_step(step, filler));
    for (const auto& [name, words] : lesson.script.words) caption(lesson, name, words, filler);
    if (!lesson.animation.shots.empty()) lesson.animation.title = video_words(lesson, "title");
    if (lesson.script.live_line > 0) complete_live(lesson, filler);
    check_video_words(lesson);
    check_questions(lesson);
    filler.check_all_used();
}

}  // namespace lessons
