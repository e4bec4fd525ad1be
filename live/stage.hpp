#pragma once

/// \file
/// A scene that a reader plays with: drags, turns, runs, and sets anew while it runs.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lodlab/live/scene.hpp"
#include "lodlab/scenes/trace/events.hpp"

namespace live {

/// An impulse of the last moments, for pictures.
struct Hit {
    std::int64_t frame = 0;  ///< that gave it
    lod::Contact<2> contact;
    double impulse = 0;  ///< [N s]
};

/// Which nodes a picture shows.
enum class Shown {
    near,     ///< those that the last level of each near pair tested
    circles,  ///< all of the deepest level, of every body
    hulls,    ///< the hulls of these
};
/// Their words in pages.
[[nodiscard]] constexpr std::array<std::string_view, 3> names_of(Shown) {
    return {"near", "circles", "hulls"};
}
static_assert(names_of(Shown{}).size() == static_cast<std::size_t>(Shown::hulls) + 1);

/// A pair of bodies that are near, as the present frame finds them.
struct NearPair {
    lod::PairRecord record;
    std::vector<lod::Front> fronts;  ///< level by level down to the record's
    double gap = -1;  ///< between the true shapes [m], 0 where they overlap; negative: not asked
    double stands_out = 0;  ///< how far both bodies' nodes stand out at that level, by estimate [m]
};

/// The frame that would come next, taken apart.
struct FrameApart {
    scenes::Step<2> step;
    std::vector<scenes::Event<2>> events;  ///< those that Scene::told goes as far as
};

/// Holds a scene, its bodies as they stand now, and what a frame finds of them there. The same
/// calls give the same bits on every machine.
class Stage {
  public:
    /// Shows the scene's start.
    explicit Stage(Scene scene);

    /// As it is set now; its actors stand where it started.
    [[nodiscard]] const Scene& scene() const { return scene_; }
    /// As they stand.
    [[nodiscard]] std::span<const lod::Body<2>> bodies() const { return bodies_; }
    /// One of them, with its outline.
    [[nodiscard]] viz::Actor<2> actor(std::size_t body) const;
    /// What a frame finds at the present instant. Its impulses are those of no frame yet.
    [[nodiscard]] const lod::FrameRecord<2>& record() const { return looking_.record; }
    /// The pairs that are near, in the order of the record.
    [[nodiscard]] const std::vector<NearPair>& pairs() const { return pairs_; }
    /// The impulses of the last third of a second, the newest last.
    [[nodiscard]] const std::vector<Hit>& hits() const { return hits_; }
    /// Which nodes pictures show.
    [[nodiscard]] Shown shown() const { return shown_; }
    /// Frames since the start.
    [[nodiscard]] std::int64_t frame() const { return frame_; }
    /// [s] since the start.
    [[nodiscard]] double time() const;
    /// Of the bodies as they stand.
    [[nodiscard]] std::uint64_t state_hash() const;

    /// What the next frame does to the bodies as they stand, event by event. Kept until something
    /// changes; moves nothing.
    [[nodiscard]] const FrameApart& apart();
    /// Pictures show that frame as of one of its events, from 0; nothing: the stage as it stands.
    /// Whatever changes the stage leaves that frame. Throws lod::Error (usage) for an event that is
    /// not there.
    void look_inside(std::optional<std::size_t> event);
    /// The event that pictures stand at.
    [[nodiscard]] std::optional<std::size_t> event() const { return event_; }
    /// The frame that is taken apart. Requires: event().
    [[nodiscard]] const FrameApart& inside() const { return *apart_; }
    /// What sentences call the bodies.
    [[nodiscard]] std::vector<std::string> names() const;

    /// Runs so many frames. Throws lod::Error as lod::advance does.
    void step(int frames = 1);
    /// Back to the start; what was set stays.
    void reset();

    /// Puts a body there; a half-space stays where it is. Throws lod::Error (usage) for a body that
    /// is not there or a place that no picture can hold.
    void place(std::size_t body, const lod::Vector<2>& position, double angle);
    /// How it moves from now on. A static body stays. Throws as place.
    void move(std::size_t body, const lod::Vector<2>& velocity, double spin);

    void set_level(int deepest);                          ///< >= 0; beyond the leaves: to them
    void set_budget(std::optional<std::uint64_t> tests);  ///< a frame; nothing: no limit
    void set_pair_cost(double tests);                     ///< >= 0, what each node pair reserves
    void set_restitution(double restitution);             ///< 0 to 1, of all bodies
    void set_policy(lod::Priority priority);
    void set_contact_model(lod::ContactModel model);
    void set_response(lod::Response response);
    void set_fixation(const lod::Vector<2>& point);  ///< of Priority::perceptual

    void show(Shown shown) { shown_ = shown; }

  private:
    [[nodiscard]] lod::Budget budget() const;
    void look();
    lod::Body<2>& body_at(std::size_t body);

    Scene scene_;
    std::vector<lod::Body<2>> bodies_;
    std::int64_t frame_ = 0;
    Shown shown_ = Shown::near;
    lod::FrameStorage<2> running_;
    lod::FrameStorage<2> looking_;  ///< apart, so that looking changes nothing that frames remember
    std::vector<NearPair> pairs_;
    std::vector<Hit> hits_;
    std::optional<FrameApart> apart_;
    std::optional<std::size_t> event_;
};

}  // namespace live
