#include "lodlab/scenes/trace/old_trace.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "lodlab/io/whole_number.hpp"
#include "lodlab/scenes/trace/trace_json.hpp"

namespace scenes {
namespace {

constexpr int old_version = 2;
constexpr std::int64_t key_frames = 100;

TraceHead head_from(const Json& json) {
    if (const int version = io::whole_number<int>(json.at("lodlab_trace")); version != old_version)
        throw std::invalid_argument("it is of version " + std::to_string(version) +
                                    ", this lodlab reads 2 and 3");
    TraceHead head;
    head.version = old_version;
    head.scene = json.at("scene").get<std::string>();
    head.dim = json.contains("dim") ? io::whole_number<int>(json.at("dim")) : 2;
    head.fingerprint = from_hexadecimal(json.at("fingerprint").get_ref<const std::string&>());
    head.settings = settings_from(json.at("settings"));
    head.key_frames = key_frames;
    return head;
}

}  // namespace

OldTrace old_trace_from(std::string_view text) {
    const Json json = Json::parse(text);
    OldTrace trace;
    trace.head = head_from(json);
    std::int64_t number = 0;
    for (const Json& frame : json.at("frames")) {
        // The bodies were told in every frame, and by no program needed.
        const bool told = frame.contains("bodies");
        if (number == 0 || (told && number % key_frames == 0)) {
            trace.intervals.push_back({number, {}, {}});
            if (told)
                trace.intervals.back().states = numbers_from(frame.at("bodies"), trace.head.dim);
        }
        FrameMark mark;
        mark.cut = cut_from(frame.at("cut"));
        mark.hashes.motion = from_hexadecimal(frame.at("state_hash").get_ref<const std::string&>());
        trace.intervals.back().frames.push_back(mark);
        ++number;
    }
    if (number == 0) throw std::invalid_argument("it has no frames");
    return trace;
}

}  // namespace scenes
