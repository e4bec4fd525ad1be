#include <algorithm>
#include <cctype>
#include <chrono>
#include <future>
#include <kainjow/mustache.hpp>
#include <mutex>
#include <nlohmann/json.hpp>

#include "lessons/book/book.hpp"
#include "lessons/book/output_folder.hpp"
#include "lessons/book/page.hpp"
#include "lessons/embed/markdown.hpp"
#include "lessons/embed/source.hpp"
#include "lessons/engine/embedded.hpp"
#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/live/page/page.hpp"
#include "lodlab/viz/film/video.hpp"
#include "lodlab/viz/film/write.hpp"
#include "lodlab/viz/paint/write.hpp"

namespace lessons {
namespace {

namespace fs = std::filesystem;

/// Counts pictures and frames, and tells the caller how far the book has come; from one thread at a
/// time.
class Meter {
  public:
    explicit Meter(const BookOptions& options) : options_(options) {}

    void expect(double work) { total_ += work; }
    void did(const std::string& what, double work) {
        lod::check_interrupted();
        const std::lock_guard alone(mutex_);
        done_ += work;
        if (!options_.progress) return;
        const double share = total_ > 0 ? std::min(done_ / total_, 1.0) : 1;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        options_.progress({what, share, share > 0 ? spent.count() * (1 / share - 1) : -1});
    }

  private:
    const BookOptions& options_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    double done_ = 0;
    double total_ = 0;
};

constexpr double picture_work = 2;  ///< for both themes, each about as long as a frame of video
constexpr double video_themes = 2;

double work_of(const Lesson& lesson, bool video) {
    const auto pictures = static_cast<double>(lesson.figures.size());
    return picture_work * pictures +
           (video ? video_themes * viz::frame_count(lesson.animation) : 0);
}

class BookWriter {
  public:
    BookWriter(const fs::path& root, const BookOptions& options)
        : root_(root), options_(options), meter_(options) {}

    void write() {
        std::vector<Lesson> all;
        for (const Entry& entry : list())
            if (options_.lessons.empty() ||
                std::find(options_.lessons.begin(), options_.lessons.end(), entry.number) !=
                    options_.lessons.end())
                all.push_back(run(entry.number));
        if (all.empty())
            throw lod::Error(lod::ErrorKind::usage, "no such lesson; `lodlab lesson` lists them");
        choose_video_format();
        for (const Lesson& lesson : all) meter_.expect(work_of(lesson, with_video(lesson)));
        for (const char* name : {"book.css", "book.js", "grade.js", "index.js", "questions.js"})
            lod::write_text_file(root_ / name, embedded_files().at(name));
        write_live_files(all);
        for (std::size_t i = 0; i < all.size(); ++i) write_lesson(all, i);
        write_index(all);
    }

  private:
    /// MP4, where its encoder is installed; else WebM.
    void choose_video_format() {
        if (!options_.video) return;
        for (const char* ending : {"mp4", "webm"})
            if (ending_.empty() && !viz::video_encoder(ending).empty()) ending_ = ending;
        if (ending_.empty() && options_.warn)
            options_.warn("no video encoder is installed; the book is written without videos");
    }

    [[nodiscard]] bool with_video(const Lesson& lesson) const {
        return !ending_.empty() && !lesson.animation.shots.empty();
    }

    /// Letters, digits and underscores, so that no address has to be escaped.
    static std::string picture_name(std::string figure, bool narrow = false) {
        for (char& c : figure)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return figure + (narrow ? ".narrow.svg" : ".svg");
    }

    void film(const fs::path& path, const Lesson& lesson, viz::Theme theme) {
        viz::WriteOptions how;
        how.theme = theme;
        how.quality = options_.video_quality;
        how.few_bytes = true;
        if (theme == viz::Theme::light) how.warn = options_.warn;  // once for both
        const std::string what = "lesson " + std::to_string(lesson.entry.number) + ": video";
        how.progress = [&, before = 0](const viz::Progress& progress) mutable {
            meter_.did(what, progress.done - before);
            before = progress.done;
        };
        viz::write_animation(path, lesson.animation, how);
    }

    /// Both themes at once: each film is made by one thread, so that its bytes are the same
    /// anywhere.
    VideoFiles write_video(const fs::path& folder, const Lesson& lesson) {
        if (!with_video(lesson)) return {};
        VideoFiles files{"lesson_light." + ending_, "lesson_dark." + ending_, "poster.svg"};
        viz::write_web_svg(folder / files.poster, lesson.animation.shots.front().draw());
        auto dark = std::async(std::launch::async,
                               [&] { film(folder / files.dark, lesson, viz::Theme::dark); });
        film(folder / files.light, lesson, viz::Theme::light);
        dark.get();
        return files;
    }

    static bool has_live_part(const Lesson& lesson) { return lesson.live && live::has_module(); }

    /// What all live parts share.
    void write_live_files(const std::vector<Lesson>& all) {
        if (std::none_of(all.begin(), all.end(), has_live_part)) return;
        const live::Component component = live::component();
        lod::write_text_file(root_ / "live.css", component.style);
        lod::write_text_file(root_ / "live.js", component.script);
        lod::write_text_file(root_ / "lodlab.js", std::string(component.module));
        lod::write_text_file(root_ / "live_part.js", embedded_files().at("live_part.js"));
    }

    /// Its scene as a script, for a page that lies on a disk reads no other file.
    static std::string write_scene(const fs::path& folder, const Lesson& lesson) {
        if (!has_live_part(lesson)) return {};
        constexpr const char* name = "scene.js";
        const nlohmann::json text = live::scene_text(lesson.live->scene);
        lod::write_text_file(folder / name, "var lodlabScene = " + text.dump() + ";\n");
        return name;
    }

    static kainjow::mustache::data neighbour(const Lesson& lesson) {
        kainjow::mustache::data data;
        data.set("slug", lesson.entry.slug);
        data.set("title", lesson.entry.title);
        return data;
    }

    static std::string filled(const char* name, kainjow::mustache::data& data) {
        kainjow::mustache::mustache page(embedded_files().at(name));
        const std::string html = page.render(data);
        if (!page.is_valid())
            throw lod::Error(lod::ErrorKind::output_failed,
                             std::string(name) + ": " + page.error_message());
        return html;
    }

    void write_lesson(const std::vector<Lesson>& all, std::size_t i) {
        const Lesson& lesson = all[i];
        const fs::path folder = root_ / lesson.entry.slug;
        fs::create_directory(folder);
        const std::string what = "lesson " + std::to_string(lesson.entry.number) + ": pictures";
        for (const auto& [name, figure] : lesson.figures) {
            viz::write_web_svg(folder / picture_name(name), without_words(figure),
                               picture_width(figure));
            if (const auto narrow = narrow_picture(figure))
                viz::write_web_svg(folder / picture_name(name, true), without_words(narrow->figure),
                                   narrow->width);
            meter_.did(what, picture_work);
        }
        kainjow::mustache::data data;
        const PageFiles files{write_video(folder, lesson), write_scene(folder, lesson)};
        data.set("body", lesson_html(lesson, files, picture_name));
        data.set("live", !files.scene.empty());
        data.set("title", lesson.entry.title);
        data.set("number", std::to_string(lesson.entry.number));
        if (i > 0) data.set("previous", neighbour(all[i - 1]));
        if (i + 1 < all.size()) data.set("following", neighbour(all[i + 1]));
        lod::write_text_file(folder / "index.html", filled("lesson.html", data));
    }

    void write_index(const std::vector<Lesson>& all) {
        kainjow::mustache::data entries{kainjow::mustache::data::type::list};
        for (const Lesson& lesson : all) {
            kainjow::mustache::data entry;
            entry.set("slug", lesson.entry.slug);
            entry.set("number", std::to_string(lesson.entry.number));
            entry.set("title", lesson.entry.title);
            entry.set("steps", std::to_string(lesson.steps.size()));
            std::size_t questions = 0;
            for (const Step& step : lesson.steps) questions += step.questions.size();
            entry.set("questions", std::to_string(questions));
            const std::string& first = lesson.steps.front().figure;
            entry.set("picture", picture_name(first));
            entry.set("size", size_attributes(lesson.figures.at(first)));
            entry.set("alt", viz::plain_text(lesson.figures.at(first).alt));
            entries.push_back(entry);
        }
        kainjow::mustache::data data;
        data.set("lessons", entries);
        lod::write_text_file(root_ / "index.html", filled("index.html", data));
    }

    fs::path root_;
    const BookOptions& options_;
    Meter meter_;
    std::string ending_;
};

}  // namespace

void write_book(const std::filesystem::path& directory, const BookOptions& options) {
    OutputFolder output(directory);
    BookWriter(output.path(), options).write();
    output.commit();
}

}  // namespace lessons
