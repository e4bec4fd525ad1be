#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenes {

/// The candidate that `word` was probably meant to be: the one that the fewest letters inserted,
/// deleted, changed or swapped with their neighbour turn into it. Empty when none comes near (more
/// than a third of the word's letters would have to change).
[[nodiscard]] std::string_view nearest(std::string_view word,
                                       std::span<const std::string_view> candidates);

/// " (did you mean depth?)", or nothing when no candidate comes near.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       std::span<const std::string_view> candidates);

/// "net, sum, mean": the candidates for a message.
[[nodiscard]] std::string listed(std::span<const std::string_view> candidates);

/// The parts between the letters `by`: one more than there are of them.
[[nodiscard]] std::vector<std::string> parted(const std::string& text, char by);

}  // namespace scenes
