#include "lodlab/scenes/trace/trace_writer.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/scenes/trace/frame_mark.hpp"
#include "lodlab/scenes/trace/trace_copy.hpp"
#include "lodlab/scenes/trace/trace_json.hpp"
#include "lodlab/scenes/trace/trace_text.hpp"

namespace scenes {
namespace {

constexpr std::int64_t usual_key_frames = 100;
constexpr std::int64_t fewest_key_frames = 10;
constexpr std::int64_t most_states = 500'000;  // of the frames from one key frame to the next

std::int64_t key_frames_of(const TraceSettings& settings, std::size_t bodies) {
    if (settings.key_frames > 0) return settings.key_frames;
    const auto count = static_cast<std::int64_t>(std::max<std::size_t>(bodies, 1));
    return std::clamp(most_states / count, fewest_key_frames, usual_key_frames);
}

}  // namespace

TraceCopy::TraceCopy(const Trace& trace) : trace_(trace) {
    if (trace.head().version != trace_version)
        throw lod::Error(lod::ErrorKind::input_refused,
                         trace.source() +
                             ": a trace of version 2 does not tell the limits of its run, so the "
                             "run cannot go on; run it anew");
}

void TraceCopy::give(const std::function<void(std::int64_t)>& begin,
                     const std::function<void(std::string_view)>& write) const {
    write(trace_.text_->bytes(0, trace_.keys_.front().offset));
    for (std::size_t key = 0; key + 1 < trace_.keys_.size(); ++key) {
        lod::check_interrupted();
        const std::int64_t frame = trace_.keys_[key].frame;
        static_cast<void>(trace_.interval(frame));  // damaged it would be refused
        begin(frame);
        write(trace_.bytes_of(key));
    }
}

template <int Dim>
TraceWriter<Dim>::TraceWriter(const std::filesystem::path& path, const TraceOrigin<Dim>& origin,
                              const TraceSettings& settings)
    : file_(path), settings_(settings) {
    settings_.key_frames = key_frames_of(settings, origin.bodies.size());
    file_.write(checked_line({{"lodlab_trace", trace_version},
                              {"scene", origin.scene},
                              {"dim", Dim},
                              {"fingerprint", hexadecimal(fingerprint(origin.bodies))},
                              {"settings", json_of(origin.settings)},
                              {"limits", json_of(origin.limits)},
                              {"key_frames", settings_.key_frames},
                              {"records", settings_.records}},
                             TraceLine::head));
}

template <int Dim>
TraceWriter<Dim>::TraceWriter(const std::filesystem::path& path, const Trace& earlier)
    : file_(path),
      settings_{earlier.head().key_frames, earlier.head().has_records},
      frame_(earlier.frames()) {
    const auto begin = [&](std::int64_t frame) { keys_.emplace_back(frame, file_.size()); };
    TraceCopy(earlier).give(begin, [&](std::string_view text) { file_.write(text); });
}

template <int Dim>
void TraceWriter<Dim>::write_bodies(const std::vector<State<Dim>>& bodies, TraceLine line) {
    keys_.emplace_back(frame_, file_.size());
    file_.write(checked_line({{"key_frame", frame_}, {"bodies", states(bodies)}}, line));
}

template <int Dim>
void TraceWriter<Dim>::add(const Step<Dim>& step, const std::vector<State<Dim>>& after) {
    if (frame_ % settings_.key_frames == 0) write_bodies(step.before, TraceLine::entry);
    Json line = json_of(frame_, mark_of(step, after));
    if (settings_.records) {
        line["tests"] = step.record.tests;
        line["bodies"] = states(step.before);
        line["pairs"] = pairs(step.record);
        if (!step.record.swept.empty()) line["swept"] = swept(step.record);
    }
    file_.write(checked_line(line, TraceLine::entry));
    ++frame_;
    end_ = after;
}

template <int Dim>
void TraceWriter<Dim>::finish() {
    write_bodies(end_, TraceLine::end);
    Json index = Json::array();
    for (const auto& [frame, offset] : keys_) index.push_back({frame, offset});
    file_.write(checked_line({{"places", std::move(index)}}, TraceLine::index));
    file_.commit();
}

template <int Dim>
void write_trace(const std::filesystem::path& path, const std::string& scene,
                 std::span<const lod::Body<Dim>> bodies_at_start, const Run<Dim>& run,
                 const TraceSettings& settings) {
    TraceWriter<Dim> writer(path, {scene, bodies_at_start, run.settings, run.limits}, settings);
    for (std::size_t k = 0; k < run.steps.size(); ++k) {
        lod::check_interrupted();
        writer.add(run.steps[k], k + 1 < run.steps.size() ? run.steps[k + 1].before : run.end);
    }
    writer.finish();
}

#define SCENES_INSTANTIATE(Dim)                                                 \
    template class TraceWriter<Dim>;                                            \
    template void write_trace(const std::filesystem::path&, const std::string&, \
                              std::span<const lod::Body<Dim>>, const Run<Dim>&, \
                              const TraceSettings&);
SCENES_INSTANTIATE(2)
SCENES_INSTANTIATE(3)
#undef SCENES_INSTANTIATE

}  // namespace scenes
