#include "lodlab/lod2d/source/svg/drawing.hpp"

#include <algorithm>

namespace lod2d {
namespace {

/// "2 texts, 1 image".
std::string listed(const std::vector<SvgNotes::Kind>& kinds) {
    std::string list;
    for (const SvgNotes::Kind& kind : kinds)
        list += (list.empty() ? "" : ", ") + std::to_string(kind.count) + " " +
                (kind.count == 1 ? kind.one : kind.many);
    return list;
}

}  // namespace

void SvgNotes::count(std::vector<Kind>& kinds, const std::string& one, const std::string& many,
                     std::size_t more) {
    if (more == 0) return;
    const auto known = std::ranges::find(kinds, one, &Kind::one);
    if (known == kinds.end())
        kinds.push_back({one, many, more});
    else
        known->count += more;
}

void SvgNotes::doubt(const std::string& line) {
    if (std::ranges::find(doubts, line) == doubts.end()) doubts.push_back(line);
}

std::vector<std::string> SvgNotes::losses() const {
    std::vector<std::string> lines;
    if (!left_out.empty()) lines.emplace_back("left out ").append(listed(left_out));
    if (!whole.empty()) lines.emplace_back("taken whole: ").append(listed(whole));
    lines.insert(lines.end(), doubts.begin(), doubts.end());
    return lines;
}

}  // namespace lod2d
