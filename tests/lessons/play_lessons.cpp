// Plays the scene of each lesson's live part by the calls that its page makes.
//
// Usage: play_lessons FOLDER    FOLDER/SLUG.json: the scene; FOLDER/SLUG.txt: what came of it
//                               (tests/live/played.hpp)

#include <cstdio>
#include <exception>
#include <filesystem>

#include "lessons/engine/lessons.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/live/sources.hpp"
#include "tests/live/played.hpp"

int main(int count, char** arguments) {
    if (count != 2) return 2;
    const std::filesystem::path folder = arguments[1];
    std::filesystem::create_directories(folder);
    lod::write_text_file(folder / "sources", live::sources());
    try {
        for (const lessons::Entry& entry : lessons::list()) {
            const lessons::Lesson lesson = lessons::run(entry.number);
            if (!lesson.live) continue;
            const std::string scene = live::scene_text(lesson.live->scene);
            lod::write_text_file(folder / (entry.slug + ".json"), scene);
            lod::write_text_file(folder / (entry.slug + ".txt"), lodtest::played(scene));
        }
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
    return 0;
}
