// Figures in block characters, read back by what a terminal would show.
#include "lodlab/viz/paint/blocks.hpp"

#include <array>
#include <map>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/viz/figure/figure.hpp"
#include "tests/catch.hpp"

using namespace viz;

namespace {

using Seen = std::array<int, 3>;  // red, green, blue

/// Every quarter of every cell that a terminal of 24 bits shows, in rows from the top.
std::vector<std::vector<Seen>> shown(const std::string& text) {
    const std::map<std::string, unsigned> quarters{
        {" ", 0}, {"▘", 1}, {"▝", 2},  {"▀", 3},  {"▖", 4},  {"▌", 5},  {"▞", 6},  {"▛", 7},
        {"▗", 8}, {"▚", 9}, {"▐", 10}, {"▜", 11}, {"▄", 12}, {"▙", 13}, {"▟", 14}, {"█", 15}};
    std::vector<std::vector<Seen>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::vector<Seen> upper;
        std::vector<Seen> lower;
        Seen fore{};
        Seen back{};
        for (std::size_t at = 0; at < line.size();) {
            int layer = 0;
            Seen colour{};
            int length = 0;
            if (std::sscanf(line.c_str() + at, "\033[%d;2;%d;%d;%dm%n", &layer, &colour[0],
                            &colour[1], &colour[2], &length) == 4) {
                (layer == 38 ? fore : back) = colour;
                at += static_cast<std::size_t>(length);
                continue;
            }
            if (line.compare(at, 4, "\033[0m") == 0) break;
            const std::string glyph = line.substr(at, line[at] == ' ' ? 1 : 3);
            const unsigned mask = quarters.at(glyph);
            at += glyph.size();
            for (unsigned i = 0; i < 4; ++i)
                (i < 2 ? upper : lower).push_back((mask >> i & 1U) != 0 ? fore : back);
        }
        rows.push_back(upper);
        rows.push_back(lower);
    }
    return rows;
}

Figure one_disc() {
    Panel panel;
    panel.view = {{-1, -1}, {1, 1}};
    panel.marks.push_back(Disc{{.role = Role::body}, {0.5, 0.5}, 0.4});
    Figure figure;
    figure.panels.push_back(panel);
    figure.aspect = 1;
    return figure;
}

BlockOptions of_24_bits(int columns, int rows) {
    return {.columns = columns, .rows = rows, .colours = TerminalColours::direct};
}

}  // namespace

TEST_CASE("a disc stands where it is, on the page's ground", "[blocks]") {
    const auto rows = shown(block_text(one_disc(), of_24_bits(60, 30)));
    REQUIRE(rows.size() == 60);
    const Seen ground{255, 255, 255};
    const auto at = [&](double across, double down) {
        const auto& row = rows[static_cast<std::size_t>(down * static_cast<double>(rows.size()))];
        return row[static_cast<std::size_t>(across * static_cast<double>(row.size()))];
    };
    CHECK(at(0.75, 0.25) != ground);
    for (const auto& [across, down] : {std::pair{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.75}})
        CHECK(at(across, down) == ground);
}

TEST_CASE("a picture in blocks is no wider and no higher than asked, at its page's shape",
          "[blocks]") {
    Figure figure = one_disc();
    for (const double aspect : {0.5, 1.0, 4.0 / 3, 3.0})
        for (const auto& [columns, rows] : {std::pair{80, 30}, {40, 100}, {10, 3}, {1, 1}}) {
            figure.aspect = aspect;
            const auto seen = shown(block_text(figure, of_24_bits(columns, rows)));
            const double wide = static_cast<double>(seen.front().size()) / 2;
            const double high = static_cast<double>(seen.size()) / 2;
            CAPTURE(aspect, columns, rows, wide, high);
            CHECK(wide <= columns);
            CHECK(high <= rows);
            // Cells are twice as high as wide, and a side is right to a cell.
            CHECK((wide + 1) >= aspect * 2 * (high - 1));
            CHECK((wide - 1) <= aspect * 2 * (high + 1));
            for (const auto& row : seen) CHECK(row.size() == seen.front().size());
        }
}

TEST_CASE("words are left out, and a figure of nothing else is nothing", "[blocks]") {
    Figure figure = one_disc();
    const std::string plain = block_text(figure, of_24_bits(40, 20));
    figure.panels[0].marks.push_back(Label{{}, {0, 0}, "words"});
    figure.panels[0].title = "words";
    CHECK(block_text(figure, of_24_bits(40, 20)) == plain);
    Figure list;
    list.panels.emplace_back();
    list.panels[0].entries.push_back({{}, "words"});
    CHECK(block_text(list).empty());
}

TEST_CASE("a terminal of 256 colours is asked for white as its cube has it", "[blocks]") {
    const std::string text = block_text(one_disc(), {.columns = 20, .rows = 10});
    CHECK_THAT(text, lodtest::contains("\033[48;5;231m"));
    CHECK(text.find(";2;") == std::string::npos);
    CHECK(text.ends_with("\033[0m\n"));
}

TEST_CASE("a figure that cannot be drawn is refused in blocks as in files", "[blocks]") {
    Figure figure = one_disc();
    figure.panels[0].marks.push_back(Disc{{}, {0, 0}, -1});
    CHECK_THROWS_AS(block_text(figure), lod::Error);
}
