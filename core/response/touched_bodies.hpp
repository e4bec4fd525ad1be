#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/base/lists.hpp"
#include "lodlab/core/response/impact.hpp"

namespace lod {

/// What a response asks of a body, together.
template <int Dim>
struct TouchedBody {
    Vector<Dim> velocity;
    Spin<Dim> spin;
    double inverse_mass = 0;
    Inertia<Dim> inverse_inertia;  ///< world frame
    Vector<Dim> position;
    double restitution = 1;
    std::int32_t body = 0;  ///< its number among all

    /// As Body's of the same name.
    [[nodiscard]] bool is_static() const { return inverse_mass == 0; }
};

/// The bodies that have contacts, numbered anew without gaps and in the same order: of a large
/// crowd most touch nothing, and what lies between them would fill the caches. Keeps its storage.
template <int Dim>
class TouchedBodies {
  public:
    /// Takes over those of some impacts.
    void gather(std::span<const Impact<Dim>> impacts, std::span<const Body<Dim>> bodies,
                Executor* executor) {
        refill(number_, bodies.size(), 0);
        for (const Impact<Dim>& impact : impacts) number_[at(impact.a)] = number_[at(impact.b)] = 1;
        list_.clear();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (number_[i] == 0) continue;
            number_[i] = static_cast<std::int32_t>(list_.size());
            list_.emplace_back().body = static_cast<std::int32_t>(i);
        }
        each_part(executor, list_.size(), bodies_of_a_part, [&](const Part& part) {
            for (std::size_t i = part.begin; i < part.end; ++i) {
                prefetch(bodies[at(list_[(std::min)(i + ahead, part.end - 1)].body)]);
                take(bodies, list_[i]);
            }
        });
    }
    /// Gives their velocities back.
    void give_back(std::span<Body<Dim>> bodies) const {
        for (const TouchedBody<Dim>& touched : list_) {
            bodies[at(touched.body)].velocity = touched.velocity;
            bodies[at(touched.body)].spin = touched.spin;
        }
    }

    /// How many there are.
    [[nodiscard]] std::size_t size() const { return list_.size(); }
    /// The number here of a body that has contacts.
    [[nodiscard]] std::int32_t number(std::int32_t body) const { return number_[at(body)]; }
    /// By the number here.
    [[nodiscard]] TouchedBody<Dim>& operator[](std::int32_t i) { return list_[at(i)]; }
    [[nodiscard]] const TouchedBody<Dim>& operator[](std::int32_t i) const { return list_[at(i)]; }

  private:
    static constexpr std::size_t ahead = 8;  ///< bodies that are fetched before they are needed

    static void take(std::span<const Body<Dim>> bodies, TouchedBody<Dim>& touched) {
        const Body<Dim>& body = bodies[at(touched.body)];
        touched.velocity = body.velocity;
        touched.spin = body.spin;
        touched.inverse_mass = body.inverse_mass;
        touched.inverse_inertia = world_inverse_inertia(body);
        touched.position = body.position;
        touched.restitution = body.restitution;
    }

    std::vector<std::int32_t> number_;  ///< of each body: its number here
    std::vector<TouchedBody<Dim>> list_;
};

}  // namespace lod
