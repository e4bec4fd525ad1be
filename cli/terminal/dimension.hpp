#pragma once

#include <type_traits>

namespace cli {

/// Calls once, with the dimension as a constant: call(dimension) where dimension() is 2 or 3. The
/// one place where a command that was understood becomes one of the plane or of space.
template <class Call>
void in_dimension(int dim, const Call& call) {
    if (dim == 3)
        call(std::integral_constant<int, 3>());
    else
        call(std::integral_constant<int, 2>());
}

}  // namespace cli
