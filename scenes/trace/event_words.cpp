#include <array>

#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/base/to_chars.hpp"
#include "lodlab/scenes/trace/events.hpp"

namespace scenes {
namespace {

std::string told(double number) {
    return lod::number_text(number, std::chars_format::general, 4);
}

std::string vector_text(std::span<const double> vector) {
    std::string text = "(";
    for (std::size_t i = 0; i < vector.size(); ++i) text += (i > 0 ? ", " : "") + told(vector[i]);
    return text + ")";
}

std::string counted(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string found(std::uint64_t overlapping) {
    if (overlapping == 0) return "no node pair overlaps: they are apart";
    return counted(overlapping, "node pair") + (overlapping == 1 ? " overlaps" : " overlap");
}

/// Of a level that was begun, and is thrown away.
std::string lost(std::uint64_t tests, std::uint64_t needed) {
    const std::string end = tests == 1 ? " is thrown away: " : " are thrown away: ";
    if (tests < needed)
        return std::to_string(tests) + " of " + counted(needed, "node test") + end +
               "the budget ended";
    return counted(tests, "node test") + end + "too much to answer";
}

/// The words of one event.
template <int Dim>
class Words {
  public:
    Words(const Event<Dim>& event, std::span<const std::string> names, Places places)
        : event_(event), names_(names), places_(places) {}

    [[nodiscard]] std::string all() const {
        switch (event_.kind) {
            case EventKind::level:
                return level() + counted(event_.tests, "node test") + ", " +
                       found(event_.overlapping);
            case EventKind::dropped:
                return level() + lost(event_.tests, event_.needed);
            case EventKind::skipped:
                return level() + "not begun, for " + counted(event_.needed, "node test") +
                       (event_.needed == 1 ? " does" : " do") + " not fit into the budget";
            case EventKind::exact:
                return exact();
            case EventKind::contact:
                return both() + " touch" + where() + ", " + told(event_.contact.depth) + " m deep";
            case EventKind::round:
                return round();
            case EventKind::impulse:
                return push() + where();
            case EventKind::swept:
                break;
        }
        return name(event_.a) + " runs into " + name(event_.b) + " " + told(event_.time) +
               " s after the frame, and pushes by " + told(event_.impulse) + " N s" + where();
    }

  private:
    [[nodiscard]] const std::string& name(std::int32_t body) const { return names_[lod::at(body)]; }
    [[nodiscard]] std::string both() const { return name(event_.a) + " and " + name(event_.b); }
    [[nodiscard]] std::string level() const {
        return "level " + std::to_string(event_.level) + " of " + both() + ": ";
    }
    [[nodiscard]] std::string exact() const {
        const std::string who = "the true shapes of " + both();
        if (event_.overlapping == 0) return who + " are apart";
        return who + " touch in " + counted(event_.overlapping, "contact") + " at " +
               told(event_.time) + " s from the frame";
    }
    [[nodiscard]] std::string push() const {
        return name(event_.a) + " pushes " + name(event_.b) + " by " + told(event_.impulse) +
               " N s";
    }
    [[nodiscard]] std::string round() const {
        const std::string which = "round " + std::to_string(event_.round) + " of " +
                                  std::to_string(event_.rounds) + " of the response: ";
        if (event_.overlapping == 1) return which + push();
        return which + counted(event_.overlapping, "contact") + " push, the hardest of " + both() +
               " by " + told(event_.impulse) + " N s";
    }
    [[nodiscard]] std::string where() const {
        if (places_ == Places::left_out) return "";
        return " at " + vector_text(event_.contact.point) + " m along " +
               vector_text(event_.contact.normal);
    }

    const Event<Dim>& event_;
    std::span<const std::string> names_;
    Places places_;
};

std::string plural(EventKind kind) {
    if (kind == EventKind::exact || kind == EventKind::swept || kind == EventKind::dropped ||
        kind == EventKind::skipped)
        return "";
    return "s";
}

}  // namespace

template <int Dim>
std::string sentence(const Event<Dim>& event, std::span<const std::string> names, Places places) {
    return Words<Dim>(event, names, places).all();
}

template <int Dim>
std::string kinds_text(std::span<const Event<Dim>> events) {
    constexpr std::size_t kinds = names_of(EventKind{}).size();
    std::array<int, kinds> counts{};
    for (const Event<Dim>& event : events) ++counts[static_cast<std::size_t>(event.kind)];
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < kinds; ++i) {
        if (counts[i] == 0) continue;
        const auto kind = static_cast<EventKind>(i);
        parts.push_back(std::to_string(counts[i]) + " " + std::string(lod::name_of(kind)) +
                        (counts[i] == 1 ? "" : plural(kind)));
    }
    if (parts.empty()) return "no event";
    std::string text = parts[0];
    for (std::size_t i = 1; i < parts.size(); ++i)
        text += (i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return text;
}

template std::string sentence(const Event<2>&, std::span<const std::string>, Places);
template std::string sentence(const Event<3>&, std::span<const std::string>, Places);
template std::string kinds_text(std::span<const Event<2>>);
template std::string kinds_text(std::span<const Event<3>>);

}  // namespace scenes
