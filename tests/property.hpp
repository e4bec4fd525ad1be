#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <sstream>

#include "tests/catch.hpp"

/// Holds a property against `cases` random inputs of a fixed seed. On failure prints the seed and
/// the smallest input found that breaks it.
template <typename Property>
void check_property(std::uint64_t seed, int cases, Property&& property) {
    rc::detail::TestParams params;
    params.seed = seed;
    params.maxSuccess = cases;
    const auto result = rc::detail::checkTestable(std::forward<Property>(property),
                                                  rc::detail::TestMetadata(), params);
    std::ostringstream message;
    rc::detail::printResultMessage(result, message);
    INFO("seed " << seed << ": " << message.str());
    CHECK(result.template is<rc::detail::SuccessResult>());
}
