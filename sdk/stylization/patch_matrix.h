// SPDX-License-Identifier: MIT
// The patch matrix (Minarcik, Fiser, Sykora, sec. 4.4), one row after the other: distances of patches of one size
// (eq. 5), or of several sizes (sec. 4.5.4: "one can simply sum the similarity matrices for several patch sizes p",
// weighted),
//   M(i, c) = sum over sizes m of weight_m * rho_(p_m)(i, c),
//   rho_sq(i, c) = sum over k = -p..p of |d[i+k] - d[c+k]|^2
// for all i and c that have a patch of the largest size within one style curve each; with attributes (sec. 5) each term
// has the squared distances of their values added. A row follows from the one before it by
//   rho_sq(i, c) = rho_sq(i-1, c-1) + |d[i+p] - d[c+p]|^2 - |d[i-1-p] - d[c-1-p]|^2,
// which costs the same for any p and needs two rows of memory. A style curve's first row is summed directly; its
// entries are, the matrix being symmetric, also the first column of its block. Rounding of what is added and taken away
// remains: entries are exact to about N epsilon times the largest, and clamped at 0 by readers.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/memory.h"
#include "filigree/filigree.h"
#include "runtime/task.h"
#include "stylization/displacement.h"

namespace flg {

// One number a point that counts in distances besides the displacement (sec. 5): a component of an attribute. Numbers
// are metres, that is, multiplied by the attribute's weight already.
struct PatchChannel {
    Buffer<double> values;
    double period = 0;  // above 0: values are 0 to period, and as far apart as around a circle of that length
};

// The style curves of a scene, one behind the other in the same arrays.
struct StyleScene {
    const Displacement* displacement = nullptr;
    // Where each curve begins, and at last the number of points. Curves of less than 2p + 1 points have no patch.
    std::span<const uint32_t> boundaries;
    // p: a patch is 2p + 1 points. With several sizes the largest: it says which points are centres of patches.
    uint32_t patch = 0;
    std::span<const FlgPatchSize> sizes = {};  // several sizes and their weights (sec. 4.5.4); none: `patch` alone
    std::span<const PatchChannel> channels = {};
    // The first and the last points of all, so many, are caps: no patch reaches into them.
    uint32_t start_cap = 0, end_cap = 0;

    uint32_t node_count() const { return boundaries.back(); }
    uint32_t curve_count() const { return static_cast<uint32_t>(boundaries.size()) - 1; }
    // Centres of the curve's patches: first_patch to end_patch - 1.
    uint32_t first_patch(uint32_t curve) const { return std::max(boundaries[curve], start_cap) + patch; }
    uint32_t end_patch(uint32_t curve) const {
        const uint32_t end = std::min(boundaries[curve + 1], node_count() - end_cap);
        return end > first_patch(curve) + patch ? end - patch : first_patch(curve);
    }
};

// Stays a kernel: a row takes a few microseconds, too short for a task of its own, and its reader goes on in between.
//
//     co_await begin_matrix(pace, matrix);
//     while (matrix.next_row()) {
//         while (!matrix.make_part()) if (slice.is_over()) co_await pace;
//         ... matrix.row() ...
//     }
class PatchMatrix {
public:
    // Columns that are worked on in one go: part of one curve's patches.
    struct Columns {
        uint32_t curve, begin, end;
    };

    // The scene has at least one patch; what it points to outlives the matrix.
    PatchMatrix(const StyleScene& scene, Memory* memory);

    // False after the last.
    bool next_row();
    // True when the row is complete. Up to 256 entries of one size's matrix, for the displacement or a channel: about
    // 0.4 us.
    bool make_part();

    // The complete row: entry [c] is M(index(), c) squared; infinite where c is not the centre of a patch, also at c =
    // -1 and at c = node_count(). May be below zero by rounding.
    const double* row() const { return (several_ ? costs_ : sizes_.front().current).data() + 1; }
    uint32_t index() const { return row_; }
    // The style curve it belongs to.
    uint32_t curve() const { return curve_; }
    std::span<const Columns> columns() const { return columns_; }

private:
    struct Size {
        uint32_t patch;
        Buffer<double> current, previous;  // with one entry more at both ends
        Buffer<double> first_rows;         // one a curve
    };

    friend Task<void> begin_matrix(Pace& pace, PatchMatrix& matrix);
    void sum(Size& size, uint32_t curve, const Columns& columns, uint32_t term, uint32_t channel) const;
    void roll(Size& size, const Columns& columns) const;
    void add(const Size& size, const Columns& columns);
    const double* first_row(const Size& size, uint32_t curve) const {
        return size.first_rows.data() + size_t{curve} * scene_.node_count();
    }
    uint32_t skip_empty(uint32_t curve) const;

    StyleScene scene_;
    bool several_;
    std::pmr::vector<Size> sizes_;
    std::pmr::vector<Columns> columns_;
    Buffer<double> costs_;  // of several sizes, with one entry more at both ends
    uint32_t curve_ = 0, row_ = 0;
    bool begun_ = false;
    uint32_t size_ = 0, part_ = 0, channel_ = 0;  // what of the row comes next; channel 0 is the displacement
};

// Before the first row: sums the curves' first rows.
Task<void> begin_matrix(Pace& pace, PatchMatrix& matrix);

}  // namespace flg
