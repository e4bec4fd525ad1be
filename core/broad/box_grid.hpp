#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lodlab/core/base/executor.hpp"
#include "lodlab/core/broad/body_box.hpp"
#include "lodlab/core/broad/candidate_pair.hpp"
#include "lodlab/core/broad/sort_cells.hpp"

namespace lod {

/// Finds the pairs of boxes that meet, anew at each call: in a grid of pencils, which are cells
/// open along the axis on which the boxes spread widest. A box lies in the pencil of its low end
/// alone; none is wider than a pencil, so that it meets only those of its own and of the next
/// around it. Pencils are lists in order of low ends, and swept two by two. Only those that hold
/// something exist, so that it does not matter how far the boxes spread.
///
/// Boxes of unlike size lie in grids of their own, in groups from the largest down, and in each
/// grid all smaller boxes are laid out, too. A few large ones are compared with all instead.
template <int Dim>
class BoxGrid {
  public:
    /// Appends every pair, in no order. `executor`: whose threads sweep the pencils. Requires:
    /// is_somewhere() each; none is empty.
    void find(std::span<const BodyBox<Dim>> boxes, Executor* executor,
              std::vector<CandidatePair>& pairs);
    /// How many pairs of boxes the last `find` compared, to put them in order and to see whether
    /// they meet.
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

  private:
    /// Boxes of like size.
    struct Group {
        double largest = 0;  ///< side of a box [m]
        std::size_t begin = 0;
        std::size_t end = 0;  ///< into by_size_; what follows is smaller
    };
    struct Pencil {
        std::uint64_t number = 0;
        std::size_t begin = 0;  ///< into boxes
    };
    /// Boxes in order of pencils, those of a pencil in order of their low ends along it.
    struct Pencils {
        std::vector<BodyBox<Dim>> boxes;
        std::vector<Pencil> list;  ///< ends with one that has the last number of all, and no box
        [[nodiscard]] std::span<const BodyBox<Dim>> of(std::size_t i) const {
            return std::span(boxes).subspan(list[i].begin, list[i + 1].begin - list[i].begin);
        }
        /// The first one that has such a number or a larger one.
        [[nodiscard]] std::size_t first_from(std::uint64_t number) const {
            const auto before = [](const Pencil& pencil, std::uint64_t than) {
                return pencil.number < than;
            };
            return static_cast<std::size_t>(
                std::lower_bound(list.begin(), list.end(), number, before) - list.begin());
        }
    };
    /// Axes and cells of the grid of one group.
    struct Grid {
        std::array<int, Dim> axes;  ///< the first is that of the pencils
        Vector<Dim> origin;
        double cell = 1;  ///< width of a pencil [m]
        double cells_a_metre = 1;
    };

    void divide_by_size(std::span<const BodyBox<Dim>> boxes);
    void place_grid(std::span<const BodyBox<Dim>> boxes, const Group& group);
    [[nodiscard]] GridCell cell_of(const Box<Dim>& box) const;
    void lay_out(std::span<const BodyBox<Dim>> boxes, std::span<const std::int32_t> chosen,
                 Pencils& pencils);
    void put_in_order(std::span<BodyBox<Dim>> pencil);
    /// What one thread has found.
    struct Met {
        std::vector<CandidatePair> pairs;
        std::uint64_t steps = 0;
    };
    void try_each(std::span<const BodyBox<Dim>> boxes, const Group& group);
    static void meet(const BodyBox<Dim>& a, const BodyBox<Dim>& b, Met& met);
    void sweep(std::span<const BodyBox<Dim>> pencil, Met& met) const;
    void sweep(std::span<const BodyBox<Dim>> pencil, std::span<const BodyBox<Dim>> other,
               Met& met) const;
    void meet_within(const Pencils& own, const Part& part, Met& met) const;
    void meet_between(const Pencils& finer, const Pencils& own, const Part& part, Met& met) const;

    std::vector<std::int32_t> by_size_;  ///< boxes, by groups
    std::vector<Group> groups_;          ///< from the largest down
    std::vector<std::size_t> of_exponent_;
    std::vector<double> sample_;
    Grid grid_;
    Pencils own_;
    Pencils finer_;
    std::vector<GridCell> cells_;
    std::vector<GridCell> spare_;
    std::vector<Met> met_;  ///< one a worker
    std::uint64_t steps_ = 0;
};

extern template class BoxGrid<2>;
extern template class BoxGrid<3>;

}  // namespace lod
