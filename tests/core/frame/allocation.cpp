// Counts allocations by replacing operator new, so it stands in an executable of its own.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "tests/catch.hpp"
#include "tests/core/bodies.hpp"
#include "tests/core/executors.hpp"
#include "tests/core/frame/clock.hpp"

namespace {
std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void* counted(std::size_t size, std::align_val_t alignment) {
    ++allocations;
    const auto step = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
    throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return counted(size, alignment);
}
// The library's own versions without exceptions would not go with the operator delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(std::max<std::size_t>(size, 1));
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(std::max<std::size_t>(size, 1));
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

using namespace lod;
using namespace lodtest;

namespace {

template <int Dim>
std::vector<Body<Dim>> crowd(int count = 20) {
    Random random(91);
    std::vector<Body<Dim>> bodies;
    for (int i = 0; i < count; ++i) {
        bodies.push_back(random_body<Dim>(random));
        bodies.back().velocity = -bodies.back().position;
        bodies.back().tree = random_tree<Dim>(random, 3, 4, random.in(0.4, 1.0));
    }
    return bodies;
}

/// Runs frames from the same start and returns how many allocations they took. Copies the numbers
/// of the bodies only, not the bodies: a copied vector would allocate.
template <int Dim>
std::size_t allocations_of(std::vector<Body<Dim>>& bodies, const std::vector<Body<Dim>>& start,
                           const FrameSettings& settings, FrameStorage<Dim>& storage, int frames) {
    std::copy(start.begin(), start.end(), bodies.begin());
    const std::size_t before = allocations;
    for (int frame = 0; frame < frames; ++frame) {
        Budget budget = Budget::node_tests(2000, 2.0);
        advance<Dim>(bodies, settings, budget, storage);
    }
    return allocations - before;
}

}  // namespace

TEST_CASE("the counter sees allocations", "[allocation]") {
    const std::size_t before = allocations;
    const auto number = std::make_unique<double>(1.0);
    CHECK(allocations == before + 1);
}

TEMPLATE_TEST_CASE_SIG("a warm frame allocates nothing", "[allocation]", ((int Dim), Dim), 2, 3) {
    const auto start = crowd<Dim>();
    auto bodies = start;
    for (const Response response : {Response::net, Response::sum, Response::mean}) {
        FrameSettings settings;
        settings.response = response;
        for (const ContactModel model :
             {ContactModel::centre_line, ContactModel::node_normal, ContactModel::hull}) {
            settings.contact_model = model;
            FrameStorage<Dim> storage;
            CHECK(allocations_of(bodies, start, settings, storage, 30) > 0);
            // The very same frames again, that is with every size met once before.
            CHECK(allocations_of(bodies, start, settings, storage, 30) == 0);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("a warm frame allocates nothing under any policy", "[allocation]",
                       ((int Dim), Dim), 2, 3) {
    const auto start = crowd<Dim>();
    auto bodies = start;
    for (const Priority priority : choices<Priority>()) {
        FrameStorage<Dim> storage;
        CHECK(allocations_of(bodies, start, {.priority = priority}, storage, 30) > 0);
        storage.scheduler.trade.held.clear();  // or else the frames are others
        CHECK(allocations_of(bodies, start, {.priority = priority}, storage, 30) == 0);
    }
    const FrameSettings stores{.organisation = Organisation::stored};
    FrameStorage<Dim> storage;
    CHECK(allocations_of(bodies, start, stores, storage, 30) > 0);
    CHECK(allocations_of(bodies, start, stores, storage, 30) == 0);
}

TEMPLATE_TEST_CASE_SIG(
    "a warm frame allocates nothing where an executor that does not does its parts", "[allocation]",
    ((int Dim), Dim), 2, 3) {
    const auto start = crowd<Dim>(60);
    auto bodies = start;
    for (const int workers : {2, 16}) {
        FrameStorage<Dim> storage;
        ShuffledExecutor executor(workers);
        storage.executor = &executor;
        CHECK(allocations_of(bodies, start, {}, storage, 30) > 0);
        CHECK(executor.parts() > 30);
        executor.restart();
        CHECK(allocations_of(bodies, start, {}, storage, 30) == 0);
    }
}

TEMPLATE_TEST_CASE_SIG("a moving crowd allocates nothing once warm", "[allocation]",
                       ((int Dim), Dim), 2, 3) {
    // Bodies on circles through one place, at speeds of their own: they never meet twice alike.
    Random random(92);
    std::vector<Body<Dim>> bodies;
    for (int i = 0; i < 20; ++i) {
        bodies.push_back(random_body<Dim>(random));
        bodies.back().tree = random_tree<Dim>(random, 3, 4, random.in(0.4, 1.0));
    }
    FrameStorage<Dim> storage;
    const auto frames = [&](int first, int count) {
        const std::size_t before = allocations;
        for (int frame = first; frame < first + count; ++frame) {
            for (std::size_t i = 0; i < bodies.size(); ++i) {
                const auto pace = 0.05 + 0.005 * static_cast<double>(i);
                const SineCosine turn = sine_cosine(pace * frame + static_cast<double>(i));
                bodies[i].position = planar<Dim>(turn.cosine - 1, turn.sine);
            }
            Budget budget = frame % 2 == 0 ? Budget::unlimited() : Budget::node_tests(20000, 2.0);
            advance<Dim>(bodies, {}, budget, storage);
        }
        return allocations - before;
    };
    CHECK(frames(0, 1800) > 0);  // until it has seen its greatest crowds
    CHECK(frames(1800, 400) == 0);
}

TEMPLATE_TEST_CASE_SIG("a single frame warms up for its like", "[allocation]", ((int Dim), Dim), 2,
                       3) {
    const auto start = crowd<Dim>();
    auto bodies = start;
    FrameStorage<Dim> storage;
    allocations_of(bodies, start, {}, storage, 1);
    for (int repeat = 0; repeat < 5; ++repeat)
        CHECK(allocations_of(bodies, start, {}, storage, 1) == 0);
}

TEMPLATE_TEST_CASE_SIG("finding pairs anew allocates nothing, even where a wall has moved",
                       "[allocation]", ((int Dim), Dim), 2, 3) {
    Random random(93);
    std::vector<Body<Dim>> bodies;
    for (int i = 0; i < 400; ++i) {
        bodies.push_back(disc<Dim>(1, std::pow(10, random.in(-2, 0)), {0, 0}));
        bodies.back().position = random_vector<Dim>(random, 10);
        if (i % 8 == 0) make_static(bodies.back());
    }
    bodies[0].tree = random_tree<Dim>(random, 5, 4, 10);  // a wall
    bodies[8].tree =
        std::make_shared<SphereTree<Dim>>(half_space<Dim>(Vector<Dim>(Vector<Dim>::Unit(1))));
    std::vector<PosedTree<Dim>> world_S(bodies.size());
    BroadPhase<Dim> broad_phase;
    std::vector<CandidatePair> pairs;
    const auto allocations_of_a_search = [&] {
        for (std::size_t i = 0; i < bodies.size(); ++i) world_S[i].pose(bodies[i]);
        const std::size_t before = allocations;
        broad_phase.find(bodies, world_S, pairs);
        return allocations - before;
    };
    CHECK(allocations_of_a_search() > 0);
    CHECK(pairs.size() > 100);
    CHECK(allocations_of_a_search() == 0);
    bodies[0].position[0] += 1e-9;
    CHECK(allocations_of_a_search() == 0);
}
