#include "lodlab/core/broad/box_grid.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "lodlab/core/base/bit_cast.hpp"
#include "lodlab/core/base/lists.hpp"

namespace lod {
namespace {

constexpr std::size_t exponents = 2048;  ///< of a double
constexpr int widest_group = 3;          ///< factors of two from its smallest to its largest
constexpr std::size_t most_groups = 16;  ///< smaller boxes than these tell apart share the last
constexpr std::size_t few = 8;           ///< boxes that are compared with each other box
constexpr std::size_t sample = 63;       ///< boxes whose median says where most of them are
constexpr std::size_t pencils_of_a_part = 4;
constexpr std::uint64_t next_sheet = std::uint64_t{1} << 32;  ///< from a pencil's number
constexpr std::uint64_t most_shifts = 16;  ///< of a box: beyond, sorting anew is cheaper

// Cells are counted from 1, so that each has one before it and one after it.
constexpr double most_cells = 0xfffffffd;
constexpr double parts_of_cell = 8;  ///< of places along a pencil, which need not be exact
constexpr double half_of_cells = 0x7fffffff / parts_of_cell;

/// More than what rounding adds to a box and to its place in the grid: those are a few units of
/// what is counted in cells, of which there are at most 2^32, and of the place of the middle.
constexpr double wider = 1 + 0x1p-16;
constexpr double rounding = 32 * std::numeric_limits<double>::epsilon();

/// The power of two below a size.
std::size_t exponent(double size) {
    return static_cast<std::size_t>(bit_cast<std::uint64_t>(size) >> 52 & (exponents - 1));
}

/// Clamped, so that any number has a cell; nearer ones never lie in further cells.
std::uint32_t clamped(double cell) {
    if (!(cell < most_cells)) return static_cast<std::uint32_t>(most_cells);
    return cell > 0 ? static_cast<std::uint32_t>(cell) : 0;
}

template <int Dim>
double side(const Box<Dim>& box) {
    const Vector<Dim> size = box.size();
    return *std::max_element(size.begin(), size.end());
}

}  // namespace

template <int Dim>
void BoxGrid<Dim>::find(std::span<const BodyBox<Dim>> boxes, Executor* executor,
                        std::vector<CandidatePair>& pairs) {
    steps_ = 0;
    met_.resize(workers_of(executor));
    for (Met& met : met_) {
        met.pairs.clear();
        met.steps = 0;
    }
    divide_by_size(boxes);
    const std::span<const std::int32_t> chosen(by_size_);
    for (const Group& group : groups_) {
        if (group.end - group.begin <= few) {
            try_each(boxes, group);
            continue;
        }
        place_grid(boxes, group);
        lay_out(boxes, chosen.subspan(group.begin, group.end - group.begin), own_);
        each_part(executor, own_.list.size() - 1, pencils_of_a_part,
                  [&](const Part& part) { meet_within(own_, part, met_[part.worker]); });
        if (group.end == chosen.size()) break;
        lay_out(boxes, chosen.subspan(group.end), finer_);
        each_part(executor, finer_.list.size() - 1, pencils_of_a_part,
                  [&](const Part& part) { meet_between(finer_, own_, part, met_[part.worker]); });
    }
    for (const Met& met : met_) {
        pairs.insert(pairs.end(), met.pairs.begin(), met.pairs.end());
        steps_ += met.steps;
    }
}

/// A group takes in the next smaller power of two as long as that does not outnumber it, for many
/// small boxes would crowd a grid of large cells, and a few large ones would make the cells so.
template <int Dim>
void BoxGrid<Dim>::divide_by_size(std::span<const BodyBox<Dim>> boxes) {
    refill(of_exponent_, exponents, std::size_t{0});
    for (const auto& [box, body] : boxes) ++of_exponent_[exponent(side(box))];
    groups_.clear();
    std::size_t begin = 0;
    std::size_t top = 0;  // exponent of the group's largest
    for (std::size_t i = exponents; i-- > 0;) {
        const std::size_t count = of_exponent_[i];
        of_exponent_[i] = begin;  // now where its boxes begin
        if (count == 0) continue;
        const bool joins =
            !groups_.empty() &&
            (groups_.size() == most_groups ||
             (top - i < widest_group && count <= groups_.back().end - groups_.back().begin));
        if (!joins) {
            groups_.push_back({0, begin, begin});
            top = i;
        }
        begin += count;
        groups_.back().end = begin;
    }
    by_size_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        by_size_[of_exponent_[exponent(side(boxes[i].box))]++] = static_cast<std::int32_t>(i);
    for (Group& group : groups_)
        for (std::size_t i = group.begin; i < group.end; ++i)
            group.largest = std::max(group.largest, side(boxes[at(by_size_[i])].box));
}

/// Around the median of a sample, so that a few boxes that are far away do not matter.
template <int Dim>
void BoxGrid<Dim>::place_grid(std::span<const BodyBox<Dim>> boxes, const Group& group) {
    Box<Dim> all;
    for (std::size_t i = group.begin; i < group.end; ++i) all.hold(boxes[at(by_size_[i])].box);
    const std::size_t stride = (group.end - group.begin + sample - 1) / sample;
    Vector<Dim> middle;
    for (int d = 0; d < Dim; ++d) {
        sample_.clear();
        for (std::size_t i = group.begin; i < group.end; i += stride)
            sample_.push_back(boxes[at(by_size_[i])].box.low[d]);
        const auto half = sample_.begin() + static_cast<std::ptrdiff_t>(sample_.size() / 2);
        std::nth_element(sample_.begin(), half, sample_.end());
        middle[d] = *half;
    }
    grid_.cell = std::max(wider * group.largest + rounding * middle.cwiseAbs().maxCoeff(),
                          std::numeric_limits<double>::min());
    grid_.cells_a_metre = 1 / grid_.cell;
    for (int d = 0; d < Dim; ++d)
        grid_.origin[d] = std::max(all.low[d], middle[d] - half_of_cells * grid_.cell);
    const Vector<Dim> size = all.size();
    std::iota(grid_.axes.begin(), grid_.axes.end(), 0);
    std::sort(grid_.axes.begin(), grid_.axes.end(),
              [&](int i, int k) { return size[i] > size[k] || (size[i] == size[k] && i < k); });
}

template <int Dim>
GridCell BoxGrid<Dim>::cell_of(const Box<Dim>& box) const {
    const Vector<Dim> cell = (box.low - grid_.origin) * grid_.cells_a_metre;
    GridCell result;
    for (std::size_t d = Dim - 1; d > 0; --d)
        result.pencil = result.pencil << 32 | (clamped(cell[grid_.axes[d]]) + std::uint64_t{1});
    result.along = clamped(parts_of_cell * cell[grid_.axes[0]]);
    return result;
}

template <int Dim>
void BoxGrid<Dim>::lay_out(std::span<const BodyBox<Dim>> boxes,
                           std::span<const std::int32_t> chosen, Pencils& pencils) {
    cells_.clear();
    for (const std::int32_t i : chosen) {
        cells_.push_back(cell_of(boxes[at(i)].box));
        cells_.back().box = i;
    }
    sort_cells(cells_, spare_);
    pencils.boxes.clear();
    pencils.list.clear();
    for (const GridCell& cell : cells_) {
        if (pencils.list.empty() || pencils.list.back().number != cell.pencil)
            pencils.list.push_back({cell.pencil, pencils.boxes.size()});
        pencils.boxes.push_back(boxes[at(cell.box)]);
    }
    pencils.list.push_back({std::numeric_limits<std::uint64_t>::max(), pencils.boxes.size()});
    for (std::size_t i = 0; i + 1 < pencils.list.size(); ++i)
        put_in_order(
            std::span(pencils.boxes)
                .subspan(pencils.list[i].begin, pencils.list[i + 1].begin - pencils.list[i].begin));
}

/// By insertion, for their cells are in order already.
template <int Dim>
void BoxGrid<Dim>::put_in_order(std::span<BodyBox<Dim>> pencil) {
    const auto is_before = [axis = grid_.axes[0]](const BodyBox<Dim>& a, const BodyBox<Dim>& b) {
        return a.box.low[axis] < b.box.low[axis] ||
               (a.box.low[axis] == b.box.low[axis] && a.body < b.body);
    };
    std::uint64_t shifts = 0;
    for (std::size_t i = 1; i < pencil.size(); ++i) {
        if (!is_before(pencil[i], pencil[i - 1])) continue;
        const BodyBox<Dim> box = pencil[i];
        std::size_t place = i;
        for (; place > 0 && is_before(box, pencil[place - 1]); --place)
            pencil[place] = pencil[place - 1];
        pencil[place] = box;
        shifts += i - place;
        if (shifts > most_shifts * pencil.size()) {
            std::sort(pencil.begin(), pencil.end(), is_before);
            break;
        }
    }
    steps_ += shifts;
}

/// Those of a group of few with each other and with all smaller ones.
template <int Dim>
void BoxGrid<Dim>::try_each(std::span<const BodyBox<Dim>> boxes, const Group& group) {
    for (std::size_t i = group.begin; i < group.end; ++i) {
        for (std::size_t k = i + 1; k < by_size_.size(); ++k)
            meet(boxes[at(by_size_[i])], boxes[at(by_size_[k])], met_.front());
        check_candidates(met_.front().pairs.size());
    }
}

template <int Dim>
void BoxGrid<Dim>::meet(const BodyBox<Dim>& a, const BodyBox<Dim>& b, Met& met) {
    ++met.steps;
    if (a.box.meets(b.box))
        met.pairs.push_back({std::min(a.body, b.body), std::max(a.body, b.body)});
}

/// The pairs of one pencil.
template <int Dim>
void BoxGrid<Dim>::sweep(std::span<const BodyBox<Dim>> pencil, Met& met) const {
    const int along = grid_.axes[0];
    for (std::size_t i = 0; i < pencil.size(); ++i) {
        for (std::size_t k = i + 1; k < pencil.size(); ++k) {
            if (pencil[k].box.low[along] > pencil[i].box.high[along]) {
                ++met.steps;
                break;
            }
            meet(pencil[i], pencil[k], met);
        }
        check_candidates(met.pairs.size());
    }
}

/// Those of two pencils. Requires: no box of the other is longer than a cell.
template <int Dim>
void BoxGrid<Dim>::sweep(std::span<const BodyBox<Dim>> pencil, std::span<const BodyBox<Dim>> other,
                         Met& met) const {
    const int along = grid_.axes[0];
    std::size_t begin = 0;
    for (const BodyBox<Dim>& a : pencil) {
        const double low = a.box.low[along] - grid_.cell;
        for (; begin < other.size() && other[begin].box.low[along] < low; ++begin) ++met.steps;
        for (std::size_t k = begin; k < other.size(); ++k) {
            if (other[k].box.low[along] > a.box.high[along]) {
                ++met.steps;
                break;
            }
            meet(a, other[k], met);
        }
        check_candidates(met.pairs.size());
    }
}

/// Each pencil with those after it around it: the next of its sheet, three of the next sheet.
template <int Dim>
void BoxGrid<Dim>::meet_within(const Pencils& own, const Part& part, Met& met) const {
    constexpr int sheets = Dim - 2;  // beside each: none in the plane
    std::size_t above = own.first_from(own.list[part.begin].number + next_sheet - 1);
    for (std::size_t i = part.begin; i < part.end; ++i) {
        sweep(own.of(i), met);
        const std::uint64_t number = own.list[i].number;
        if (own.list[i + 1].number == number + 1) sweep(own.of(i), own.of(i + 1), met);
        for (int sheet = 1; sheet <= sheets; ++sheet) {
            const std::uint64_t middle = number + next_sheet;
            while (own.list[above].number < middle - 1) ++above;
            for (std::size_t k = above; k + 1 < own.list.size() && own.list[k].number <= middle + 1;
                 ++k)
                sweep(own.of(i), own.of(k), met);
        }
    }
}

/// Each pencil of smaller boxes with all around it of the group.
template <int Dim>
void BoxGrid<Dim>::meet_between(const Pencils& finer, const Pencils& own, const Part& part,
                                Met& met) const {
    constexpr int sheets = Dim - 2;
    for (int sheet = -sheets; sheet <= sheets; ++sheet) {
        const std::uint64_t beside = static_cast<std::uint64_t>(std::int64_t{sheet}) * next_sheet;
        std::size_t first = own.first_from(finer.list[part.begin].number + beside - 1);
        for (std::size_t i = part.begin; i < part.end; ++i) {
            const std::uint64_t middle = finer.list[i].number + beside;
            while (own.list[first].number < middle - 1) ++first;
            for (std::size_t k = first; k + 1 < own.list.size() && own.list[k].number <= middle + 1;
                 ++k)
                sweep(finer.of(i), own.of(k), met);
        }
    }
}

template class BoxGrid<2>;
template class BoxGrid<3>;

}  // namespace lod
