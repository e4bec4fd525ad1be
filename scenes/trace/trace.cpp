#include "lodlab/scenes/trace/trace.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/exact/exact_shape.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/core/math/bit_hash.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/whole_number.hpp"
#include "lodlab/scenes/trace/frame_mark.hpp"
#include "lodlab/scenes/trace/old_trace.hpp"
#include "lodlab/scenes/trace/trace_json.hpp"
#include "lodlab/scenes/trace/trace_text.hpp"

namespace scenes {
namespace {

constexpr std::string_view begins = "{\"lodlab_trace\":";
constexpr std::int64_t most_frames = 1'000'000'000'000;

int version_of(std::string_view line) {
    if (!line.starts_with(begins)) return 0;
    int version = 0;
    std::from_chars(line.data() + begins.size(), line.data() + line.size(), version);
    return version;
}

/// The next line of a text that ends with a newline; takes it away.
std::string_view take_line(std::string_view& text) {
    const std::size_t length = text.find('\n');
    if (length == std::string_view::npos) throw std::invalid_argument("a line is missing");
    const std::string_view line = text.substr(0, length);
    text.remove_prefix(length + 1);
    return line;
}

std::vector<double> key_frame_from(const Json& json, const TraceHead& head, std::int64_t frame) {
    if (io::whole_number<std::int64_t>(json.at("key_frame")) != frame)
        throw std::invalid_argument("another frame stands where key frame " +
                                    std::to_string(frame) + " should");
    return numbers_from(json.at("bodies"), head.dim);
}

}  // namespace

Trace::Trace(std::shared_ptr<TraceText> text, std::string source)
    : source_(std::move(source)), text_(std::move(text)) {
    try {
        const std::string head = text_->first_line();
        const int version = version_of(head);
        if (version > trace_version)
            throw std::invalid_argument("it is of version " + std::to_string(version) +
                                        ", this lodlab reads 2 and 3");
        if (version < trace_version) {
            read_old(text_->bytes(0, text_->size()));
            text_.reset();
            return;
        }
        read_head(head);
        const std::string index = text_->last_line();
        if (!index.starts_with("\"index\":"))
            throw std::invalid_argument("it is cut short: its last line is no index of its frames");
        read_index(index, head.size() + 1);
    } catch (const std::exception& error) {
        refuse(error.what());
    }
}

void Trace::refuse(const std::string& why) const {
    throw lod::Error(lod::ErrorKind::input_refused, source_ + ": not a trace of lodlab: " + why +
                                                        "; write one with lodlab simulate --trace");
}

void Trace::read_head(std::string_view line) {
    const Json json = object_of(line, TraceLine::head);
    head_.scene = json.at("scene").get<std::string>();
    head_.dim = io::whole_number<int>(json.at("dim"));
    if (head_.dim != 2 && head_.dim != 3) throw std::invalid_argument("dim is neither 2 nor 3");
    head_.fingerprint = from_hexadecimal(json.at("fingerprint").get_ref<const std::string&>());
    head_.settings = settings_from(json.at("settings"));
    head_.limits = limits_from(json.at("limits"));
    head_.key_frames = io::whole_number<std::int64_t>(json.at("key_frames"));
    if (head_.key_frames < 1 || head_.key_frames > most_frames)
        throw std::invalid_argument("key_frames is out of range");
    head_.has_records = json.at("records").get<bool>();
}

void Trace::read_index(std::string_view line, std::uint64_t head_bytes) {
    const Json index = object_of(line, TraceLine::index);
    for (const Json& key : index.at("places")) {
        if (!key.is_array() || key.size() != 2)
            throw std::invalid_argument("its index is no list of frames and places");
        keys_.push_back(
            {io::whole_number<std::int64_t>(key[0]), io::whole_number<std::uint64_t>(key[1])});
    }
    if (keys_.size() < 2 || keys_.back().frame < 1) throw std::invalid_argument("it has no frames");
    if (keys_.front().offset != head_bytes)
        throw std::invalid_argument("its index does not begin with its first frame");
    check_index(text_->size() - line.size() - 1);
}

/// Key frames at equal distances, the end behind the last, their lines one behind the other.
void Trace::check_index(std::uint64_t index_begins) const {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const bool last = i + 1 == keys_.size();
        const std::int64_t before = last ? keys_[i - 1].frame : 0;
        const bool fits =
            last ? keys_[i].frame > before && keys_[i].frame <= before + head_.key_frames
                 : keys_[i].frame == static_cast<std::int64_t>(i) * head_.key_frames;
        const std::uint64_t next = last ? index_begins : keys_[i + 1].offset;
        if (!fits || keys_[i].frame > most_frames || keys_[i].offset >= next)
            throw std::invalid_argument("its index is out of order");
    }
}

void Trace::read_old(std::string_view text) {
    OldTrace old = old_trace_from(text);
    head_ = std::move(old.head);
    old_ = std::move(old.intervals);
    for (const TraceInterval& interval : old_) keys_.push_back({interval.first, 0});
    keys_.push_back({old_.back().first + static_cast<std::int64_t>(old_.back().frames.size()), 0});
}

std::size_t Trace::key_of(std::int64_t frame) const {
    const auto behind =
        std::upper_bound(keys_.begin(), keys_.end(), frame,
                         [](std::int64_t number, const Key& key) { return number < key.frame; });
    return static_cast<std::size_t>(behind - keys_.begin()) - 1;
}

std::string Trace::bytes_of(std::size_t key) const {
    return text_->bytes(keys_[key].offset, keys_[key + 1].offset);
}

TraceInterval Trace::parsed(std::size_t key, std::string_view text) const {
    TraceInterval interval;
    interval.first = keys_[key].frame;
    interval.states =
        key_frame_from(object_of(take_line(text), TraceLine::entry), head_, interval.first);
    const std::size_t bodies = interval.states.size() / numbers_of_a_state(head_.dim);
    for (std::int64_t frame = interval.first; frame < keys_[key + 1].frame; ++frame) {
        const Json json = object_of(take_line(text), TraceLine::entry);
        if (io::whole_number<std::int64_t>(json.at("frame")) != frame)
            throw std::invalid_argument("another frame stands where frame " +
                                        std::to_string(frame) + " should");
        interval.frames.push_back(mark_from(json));
        if (interval.frames.back().bodies.size() != bodies)
            throw std::invalid_argument("frame " + std::to_string(frame) +
                                        " has another number of bodies");
    }
    if (!text.empty()) throw std::invalid_argument("a line is too many");
    return interval;
}

TraceInterval Trace::interval(std::int64_t frame) const {
    const std::size_t key = key_of(frame);
    if (!old_.empty()) return old_[key];
    try {
        return parsed(key, bytes_of(key));
    } catch (const std::exception& error) {
        refuse("frames " + std::to_string(keys_[key].frame) + " to " +
               std::to_string(keys_[key + 1].frame - 1) + " are damaged: " + error.what());
    }
}

std::vector<double> Trace::end() const {
    if (!old_.empty()) return {};
    try {
        const std::string text =
            text_->bytes(keys_.back().offset, text_->size() - text_->last_line().size() - 1);
        std::string_view rest = text;
        std::vector<double> states =
            key_frame_from(object_of(take_line(rest), TraceLine::end), head_, frames());
        if (!rest.empty()) throw std::invalid_argument("a line is too many");
        return states;
    } catch (const std::exception& error) {
        refuse("its end is damaged: " + std::string(error.what()));
    }
}

template <int Dim>
std::uint64_t fingerprint(std::span<const lod::Body<Dim>> bodies) {
    lod::BitHash all;
    for (const lod::Body<Dim>& body : bodies) {
        all.add(body.inverse_mass);
        all.add(body.inertia);
        all.add(body.restitution);
        all.add(body.position);
        all.add(body.orientation);
        all.add(body.velocity);
        all.add(body.spin);
        all.add(lod::tree_hash(*body.tree));
        all.add(body.exact ? body.exact->hash() : std::uint64_t{0});
    }
    return all.value();
}

Trace read_trace(const std::filesystem::path& path) {
    lod::OpenFile file = lod::open_file(path);
    auto in = std::make_unique<std::ifstream>(std::move(file.in));
    return {std::make_shared<TraceText>(std::move(in), file.bytes), path.string()};
}

Trace parse_trace(std::string_view text, const std::string& source) {
    auto in = std::make_unique<std::istringstream>(std::string(text));
    return {std::make_shared<TraceText>(std::move(in), text.size()), source};
}

template std::uint64_t fingerprint(std::span<const lod::Body<2>>);
template std::uint64_t fingerprint(std::span<const lod::Body<3>>);

}  // namespace scenes
