#pragma once

#include <string>
#include <string_view>

#include "lodlab/core/base/error.hpp"
#include "tests/catch.hpp"

namespace lodtest {

/// What is said in place of a result.
struct Refusal {
    lod::ErrorKind kind;
    std::string line;
};

/// The refusal of a call, in one line; `asked` names the call where it is accepted.
template <class Call>
Refusal refusal_of(std::string_view asked, Call call) {
    try {
        static_cast<void>(call());
    } catch (const lod::Error& error) {
        CHECK(std::string_view(error.what()).find('\n') == std::string_view::npos);
        return {error.kind(), error.what()};
    }
    FAIL("accepted: " << asked);
    return {};
}

}  // namespace lodtest
