#include "lodlab/scenes/trace/trace_json.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lodlab/io/whole_number.hpp"
#include "lodlab/scenes/trace/trace.hpp"

namespace scenes {
namespace {

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

double number_from(const Json& json) {
    if (!json.is_number()) throw std::invalid_argument(json.dump() + " is no number");
    return json.get<double>();
}

/// The next numbers of a row.
template <int Rows, int Cols>
void take(const double*& next, lod::FixedMatrix<Rows, Cols>& numbers) {
    for (double& number : numbers) number = *next++;
}
void take(const double*& next, double& number) {
    number = *next++;
}
void take(const double*& next, lod::Quaternion& q) {
    lod::FixedMatrix<4, 1> coeffs;
    take(next, coeffs);
    q = lod::Quaternion::of_coeffs(coeffs);
}

template <class Numbers>
Json array_of(const Numbers& numbers) {
    Json list = Json::array();
    append(numbers, list);
    return list;
}

}  // namespace

std::uint64_t from_hexadecimal(const std::string& text) {
    std::uint64_t number = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size())
        throw std::invalid_argument("\"" + text + "\" is no hexadecimal number");
    return number;
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
std::vector<State<Dim>> states_from(const std::vector<double>& numbers) {
    std::vector<State<Dim>> all(numbers.size() / numbers_of_a_state(Dim));
    const double* next = numbers.data();
    for (State<Dim>& state : all) {
        take(next, state.position);
        take(next, state.orientation);
        take(next, state.velocity);
        take(next, state.spin);
    }
    return all;
}

std::size_t numbers_of_a_state(int dim) {
    constexpr std::size_t in_the_plane = 2 + 1 + 2 + 1;
    constexpr std::size_t in_space = 3 + 4 + 3 + 3;
    return dim == 3 ? in_space : in_the_plane;
}

std::vector<double> numbers_from(const Json& states, int dim) {
    std::vector<double> numbers;
    for (const Json& state : states) {
        if (!state.is_array() || state.size() != numbers_of_a_state(dim))
            throw std::invalid_argument("a body has another number of numbers");
        for (const Json& number : state) numbers.push_back(number_from(number));
    }
    return numbers;
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

namespace {

Json viewer_json(const lod::Viewer& viewer) {
    return {{"fixation", viewer.fixation},
            {"eye", viewer.eye ? Json(*viewer.eye) : Json()},
            {"distance", viewer.distance},
            {"half_sensitivity", viewer.half_sensitivity},
            {"speed", viewer.speed},
            {"distractor", viewer.distractor},
            {"behind_another", viewer.behind_another}};
}

}  // namespace

Json json_of(const lod::FrameSettings& settings) {
    Json json{{"time_step", settings.time_step},
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
    if (settings.priority == lod::Priority::perceptual)
        json["viewer"] = viewer_json(settings.viewer);
    if (settings.organisation != lod::Organisation::interleaved)
        json["organisation"] = lod::name_of(settings.organisation);
    return json;
}

namespace {

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

lod::Viewer viewer_from(const Json& json) {
    lod::Viewer viewer;
    viewer.fixation = json.at("fixation").get<lod::Viewer::Point>();
    if (!json.at("eye").is_null()) viewer.eye = json.at("eye").get<lod::Viewer::Point>();
    viewer.distance = number_from(json.at("distance"));
    viewer.half_sensitivity = number_from(json.at("half_sensitivity"));
    viewer.speed = number_from(json.at("speed"));
    viewer.distractor = number_from(json.at("distractor"));
    viewer.behind_another = number_from(json.at("behind_another"));
    return viewer;
}

}  // namespace

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
    if (json.contains("organisation"))
        settings.organisation = choice<lod::Organisation>(json.at("organisation"));
    if (json.contains("viewer")) settings.viewer = viewer_from(json.at("viewer"));
    if (!(settings.time_step > 0 && settings.time_step <= 1))
        throw std::invalid_argument("time_step is out of range");
    return settings;
}

Json json_of(const std::optional<lod::Cut>& cut) {
    if (!cut) return {};
    Json json{{"pair", cut->pair}, {"level", cut->level}, {"tests", cut->tests}};
    if (cut->counted)
        json["counted"] = {{"from", cut->counted->from},
                           {"quota", cut->counted->quota},
                           {"pair_cost", cut->counted->pair_cost},
                           {"level_cost", cut->counted->level_cost}};
    if (cut->answered) json["answered"] = *cut->answered;
    if (cut->entered) json["entered"] = *cut->entered;
    if (cut->modelled) json["modelled"] = *cut->modelled;
    if (cut->rounds) json["rounds"] = *cut->rounds;
    return json;
}

std::optional<lod::Cut> cut_from(const Json& json) {
    if (json.is_null()) return std::nullopt;
    lod::Cut cut{io::whole_number<std::int32_t>(json.at("pair")),
                 io::whole_number<std::int32_t>(json.at("level")),
                 io::whole_number<std::uint64_t>(json.at("tests"))};
    if (json.contains("answered"))
        cut.answered = io::whole_number<std::uint64_t>(json.at("answered"));
    if (json.contains("entered")) cut.entered = io::whole_number<std::uint64_t>(json.at("entered"));
    if (json.contains("modelled"))
        cut.modelled = io::whole_number<std::uint64_t>(json.at("modelled"));
    if (json.contains("rounds")) cut.rounds = io::whole_number<std::int32_t>(json.at("rounds"));
    if (!json.contains("counted")) return cut;
    const Json& counted = json.at("counted");
    cut.counted = {io::whole_number<std::uint64_t>(counted.at("from")),
                   io::whole_number<std::uint64_t>(counted.at("quota")),
                   number_from(counted.at("pair_cost")),
                   io::whole_number<std::uint64_t>(counted.at("level_cost"))};
    return cut;
}

Json json_of(const Limits& limits) {
    Json json = Json::object();
    if (limits.level) json["level"] = *limits.level;
    if (limits.node_tests) json["node_tests"] = *limits.node_tests;
    if (limits.milliseconds) json["milliseconds"] = *limits.milliseconds;
    return json;
}

Limits limits_from(const Json& json) {
    Limits limits;
    if (json.contains("level")) limits.level = io::whole_number<int>(json.at("level"));
    if (json.contains("node_tests"))
        limits.node_tests = io::whole_number<std::uint64_t>(json.at("node_tests"));
    if (json.contains("milliseconds")) limits.milliseconds = number_from(json.at("milliseconds"));
    if (limits.milliseconds && !(*limits.milliseconds >= 0 && *limits.milliseconds <= 1e9))
        throw std::invalid_argument("milliseconds is out of range");
    return limits;
}

std::string hexadecimal(std::uint64_t number) {
    std::string text(16, '0');
    for (std::size_t i = 0; i < text.size(); ++i)
        text[i] = "0123456789abcdef"[(number >> (60 - 4 * i)) & 15];
    return text;
}

#define SCENES_INSTANTIATE(Dim)                                               \
    template Json states(const std::vector<State<Dim>>&);                     \
    template std::vector<State<Dim>> states_from(const std::vector<double>&); \
    template Json pairs(const lod::FrameRecord<Dim>&);                        \
    template Json swept(const lod::FrameRecord<Dim>&);
SCENES_INSTANTIATE(2)
SCENES_INSTANTIATE(3)
#undef SCENES_INSTANTIATE

}  // namespace scenes
