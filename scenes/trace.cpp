#include "lodlab/scenes/trace.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/core/exact/exact_shape.hpp"
#include "lodlab/core/frame/state_hash.hpp"
#include "lodlab/core/math/bit_hash.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/io/files/read_file.hpp"
#include "lodlab/io/whole_number.hpp"

namespace scenes {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_bytes = 500'000'000;

std::uint64_t from_hexadecimal(const std::string& text) {
    std::uint64_t number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size())
        throw std::invalid_argument("\"" + text + "\" is no hexadecimal number");
    return number;
}

template <int Rows, int Cols>
void append(const lod::FixedMatrix<Rows, Cols>& numbers, Json& list) {
    for (const double number : numbers) list.push_back(number);
}
void append(double number, Json& list) {
    list.push_back(number);
}
void append(const lod::Quaternion& q, Json& list) {
    append(q.coeffs(), list);
}

template <class Numbers>
Json array_of(const Numbers& numbers) {
    Json list = Json::array();
    append(numbers, list);
    return list;
}

template <int Dim>
Json states(const std::vector<State<Dim>>& all) {
    Json list = Json::array();
    for (const State<Dim>& state : all) {
        Json numbers = Json::array();
        append(state.position, numbers);
        append(state.orientation, numbers);
        append(state.velocity, numbers);
        append(state.spin, numbers);
        list.push_back(std::move(numbers));
    }
    return list;
}

template <int Dim>
Json pairs(const lod::FrameRecord<Dim>& record) {
    Json list = Json::array();
    for (const lod::PairRecord& pair : record.pairs) {
        Json contacts = Json::array();
        for (std::int32_t k = 0; k < pair.contact_count; ++k) {
            const auto c = static_cast<std::size_t>(pair.first_contact + k);
            const lod::Contact<Dim>& contact = record.impacts[c].contact;
            Json nodes = Json::array();
            for (const lod::NodePair& behind : record.nodes_of(record.contact_nodes[c]))
                nodes.push_back({behind.a, behind.b});
            contacts.push_back({{"nodes", std::move(nodes)},
                                {"point", array_of(contact.point)},
                                {"normal", array_of(contact.normal)},
                                {"depth", contact.depth},
                                {"impulse", record.impulses[c]}});
        }
        list.push_back({{"a", pair.bodies.a},
                        {"b", pair.bodies.b},
                        {"level", pair.level},
                        {"verdict", lod::name_of(pair.verdict)},
                        {"tests", pair.tests},
                        {"finest", lod::name_of(pair.finest)},
                        {"impact_time", pair.impact_time},
                        {"contacts", std::move(contacts)}});
    }
    return list;
}

template <int Dim>
Json swept(const lod::FrameRecord<Dim>& record) {
    Json list = Json::array();
    for (const lod::SweptImpact<Dim>& met : record.swept)
        list.push_back({{"a", met.a},
                        {"b", met.b},
                        {"time", met.time},
                        {"point", array_of(met.contact.point)},
                        {"normal", array_of(met.contact.normal)},
                        {"depth", met.contact.depth},
                        {"impulse", met.impulse}});
    return list;
}

Json settings_json(const lod::FrameSettings& settings) {
    return {{"time_step", settings.time_step},
            {"deepest_level", settings.deepest_level},
            {"response", lod::name_of(settings.response)},
            {"contact_model", lod::name_of(settings.contact_model)},
            {"point_model", lod::name_of(settings.point_model)},
            {"priority", lod::name_of(settings.priority)},
            {"finest",
             {{"level", lod::name_of(settings.finest.level)},
              {"most_pairs", settings.finest.most_pairs},
              {"cost", settings.finest.cost},
              {"tolerance", settings.finest.tolerance}}},
            {"sweep",
             {{"on", settings.sweep.on},
              {"deepest_level", settings.sweep.deepest_level},
              {"exact", settings.sweep.exact},
              {"tolerance", settings.sweep.tolerance},
              {"most_impacts", settings.sweep.most_impacts}}}};
}

template <class Choice>
Choice choice(const Json& json) {
    const auto& name = json.get_ref<const std::string&>();
    if (const std::optional<Choice> found = lod::named<Choice>(name)) return *found;
    throw std::invalid_argument("\"" + name + "\" is no setting");
}

lod::SweepSettings sweep_from(const Json& json) {
    lod::SweepSettings sweep;
    sweep.on = json.at("on").get<bool>();
    sweep.deepest_level = io::whole_number<int>(json.at("deepest_level"));
    sweep.exact = json.at("exact").get<bool>();
    sweep.tolerance = json.at("tolerance").get<double>();
    sweep.most_impacts = io::whole_number<int>(json.at("most_impacts"));
    if (!(sweep.tolerance > 0)) throw std::invalid_argument("tolerance is out of range");
    return sweep;
}

lod::FrameSettings settings_from(const Json& json) {
    lod::FrameSettings settings;
    settings.time_step = json.at("time_step").get<double>();
    settings.deepest_level = io::whole_number<int>(json.at("deepest_level"));
    settings.response = choice<lod::Response>(json.at("response"));
    if (json.contains("finest")) {  // traces from before there was one have none
        const Json& finest = json.at("finest");
        settings.finest.level = choice<lod::Finest>(finest.at("level"));
        settings.finest.most_pairs = io::whole_number<int>(finest.at("most_pairs"));
        settings.finest.cost = io::whole_number<std::uint64_t>(finest.at("cost"));
        settings.finest.tolerance = finest.at("tolerance").get<double>();
        if (!(settings.finest.tolerance > 0))
            throw std::invalid_argument("tolerance is out of range");
    }
    if (json.contains("sweep")) settings.sweep = sweep_from(json.at("sweep"));
    settings.contact_model =
        json.contains("contact_model")
            ? choice<lod::ContactModel>(json.at("contact_model"))
            : lod::ContactModel::centre_line;  // traces from before there was a choice
    settings.point_model = choice<lod::PointModel>(json.at("point_model"));
    settings.priority = choice<lod::Priority>(json.at("priority"));
    if (!(settings.time_step > 0 && settings.time_step <= 1))
        throw std::invalid_argument("time_step is out of range");
    return settings;
}

Json cut_json(const lod::Cut& cut) {
    return {{"pair", cut.pair}, {"level", cut.level}, {"tests", cut.tests}};
}

lod::Cut cut_from(const Json& json) {
    return {io::whole_number<std::int32_t>(json.at("pair")),
            io::whole_number<std::int32_t>(json.at("level")),
            io::whole_number<std::uint64_t>(json.at("tests"))};
}

Trace trace_from(const Json& json) {
    Trace trace;
    if (io::whole_number<int>(json.at("lodlab_trace")) != trace_version)
        throw std::invalid_argument("it has another version");
    trace.scene = json.at("scene").get<std::string>();
    trace.fingerprint = from_hexadecimal(json.at("fingerprint").get_ref<const std::string&>());
    trace.settings = settings_from(json.at("settings"));
    for (const Json& frame : json.at("frames")) {
        const Json& cut = frame.at("cut");
        trace.cuts.push_back(cut.is_null() ? std::nullopt : std::optional(cut_from(cut)));
        trace.state_hashes.push_back(
            from_hexadecimal(frame.at("state_hash").get_ref<const std::string&>()));
    }
    if (trace.cuts.empty()) throw std::invalid_argument("it has no frames");
    return trace;
}

}  // namespace

std::string hexadecimal(std::uint64_t number) {
    std::string text(16, '0');
    for (std::size_t i = 0; i < text.size(); ++i)
        text[i] = "0123456789abcdef"[(number >> (60 - 4 * i)) & 15];
    return text;
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

template <int Dim>
void write_trace(const std::filesystem::path& path, const std::string& scene,
                 std::span<const lod::Body<Dim>> bodies_at_start, const Run<Dim>& run) {
    lod::OutputFile file(path);
    const Json head = {{"lodlab_trace", trace_version},
                       {"scene", scene},
                       {"dim", Dim},
                       {"fingerprint", hexadecimal(fingerprint(bodies_at_start))},
                       {"settings", settings_json(run.settings)}};
    std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);  // a name
    text.pop_back();  // the closing brace
    file.write(text + ",\n\"frames\": [\n");
    for (std::size_t k = 0; k < run.steps.size(); ++k) {
        lod::check_interrupted();
        const Step<Dim>& step = run.steps[k];
        Json frame = {{"cut", step.record.cut ? cut_json(*step.record.cut) : Json()},
                      {"state_hash", hexadecimal(step.state_hash)},
                      {"tests", step.record.tests},
                      {"bodies", states(step.before)},
                      {"pairs", pairs(step.record)}};
        if (!step.record.swept.empty()) frame["swept"] = swept(step.record);
        file.write(frame.dump() + (k + 1 < run.steps.size() ? ",\n" : "\n"));
    }
    file.write("],\n\"end\": " + Json({{"bodies", states(run.end)}}).dump() + "}\n");
    file.commit();
}

Trace parse_trace(std::string_view text, const std::string& source) {
    try {
        return trace_from(Json::parse(text));
    } catch (const std::exception& error) {
        throw lod::Error(lod::ErrorKind::input_refused,
                         source + ": not a trace of lodlab: " + error.what() +
                             "; write one with lodlab simulate --trace");
    }
}

Trace read_trace(const std::filesystem::path& path) {
    return parse_trace(lod::read_text_file(path, most_bytes), path.string());
}

template <int Dim>
Run<Dim> replay(const Trace& trace, std::vector<lod::Body<Dim>> bodies, RunOptions options) {
    if (fingerprint(std::span<const lod::Body<Dim>>(bodies)) != trace.fingerprint)
        throw lod::Error(lod::ErrorKind::input_refused,
                         "the scene is not the one of the trace (" + trace.scene +
                             ", or it has been changed since); name the scene of the trace");
    options.settings = trace.settings;
    options.frames = static_cast<std::int64_t>(trace.cuts.size());
    options.limits = {};
    options.cuts = trace.cuts;
    Run<Dim> result = run(std::move(bodies), options);
    for (std::size_t k = 0; k < result.steps.size(); ++k)
        if (result.steps[k].state_hash != trace.state_hashes[k])
            throw lod::Error(lod::ErrorKind::input_refused,
                             "the replay differs from the trace from frame " + std::to_string(k) +
                                 " on; the trace was edited or written by another version");
    return result;
}

#define SCENES_INSTANTIATE(Dim)                                                  \
    template std::uint64_t fingerprint(std::span<const lod::Body<Dim>>);         \
    template void write_trace(const std::filesystem::path&, const std::string&,  \
                              std::span<const lod::Body<Dim>>, const Run<Dim>&); \
    template Run<Dim> replay(const Trace&, std::vector<lod::Body<Dim>>, RunOptions);
SCENES_INSTANTIATE(2)
SCENES_INSTANTIATE(3)
#undef SCENES_INSTANTIATE

}  // namespace scenes
