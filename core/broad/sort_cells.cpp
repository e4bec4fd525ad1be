#include "lodlab/core/broad/sort_cells.hpp"

#include <array>
#include <cstddef>

namespace lod {
namespace {

constexpr int longest_digit = 11;  ///< [bits]: its counters stay in the first cache

/// One digit of one of the numbers.
struct Digit {
    int shift = 0;
    std::uint64_t mask = 0;
    [[nodiscard]] std::size_t of(std::uint64_t number) const {
        return static_cast<std::size_t>(number >> shift & mask);
    }
};

template <class Number>
void sort_by(const Number& number, const Digit& digit, std::vector<GridCell>& cells,
             std::vector<GridCell>& spare) {
    std::array<std::size_t, (1 << longest_digit) + 1> place{};
    for (const GridCell& cell : cells) ++place[digit.of(number(cell)) + 1];
    for (std::size_t i = 1; i <= digit.mask; ++i) place[i] += place[i - 1];
    for (const GridCell& cell : cells) spare[place[digit.of(number(cell))]++] = cell;
    cells.swap(spare);
}

/// By as few digits as the bits need in which the numbers differ.
template <class Number>
void sort_by(const Number& number, std::vector<GridCell>& cells, std::vector<GridCell>& spare) {
    std::uint64_t varies = 0;
    for (const GridCell& cell : cells) varies |= number(cell) ^ number(cells.front());
    int bits = 0;
    while (varies >> bits != 0) ++bits;
    const int digits = (bits + longest_digit - 1) / longest_digit;
    for (int i = 0; i < digits; ++i) {
        const int begin = bits * i / digits;
        const int length = bits * (i + 1) / digits - begin;
        sort_by(number, Digit{begin, (std::uint64_t{1} << length) - 1}, cells, spare);
    }
}

}  // namespace

void sort_cells(std::vector<GridCell>& cells, std::vector<GridCell>& spare) {
    constexpr std::uint64_t low_half = 0xffffffff;
    spare.resize(cells.size());
    if (cells.empty()) return;
    sort_by([](const GridCell& cell) { return std::uint64_t{cell.along}; }, cells, spare);
    sort_by([](const GridCell& cell) { return cell.pencil & low_half; }, cells, spare);
    sort_by([](const GridCell& cell) { return cell.pencil >> 32; }, cells, spare);
}

}  // namespace lod
