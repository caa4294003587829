// SPDX-License-Identifier: MIT
// Distances of patches (Minarcik, Fiser, Sykora, eq. 5), one row of the matrix after the other:
//   rho_sq(i, c) = sum over k = -p..p of |d[i+k] - d[c+k]|^2
// for all i and c whose patches lie within one style curve each; with attributes (sec. 5) each term has the squared
// distances of their values added. A row follows from the one before it by
//   rho_sq(i, c) = rho_sq(i-1, c-1) + |d[i+p] - d[c+p]|^2 - |d[i-1-p] - d[c-1-p]|^2,
// which costs the same for any p and needs two rows of memory. A style curve's first row is summed directly; its entries
// are, the matrix being symmetric, also the first column of its block. Rounding of what is added and taken away remains:
// entries are exact to about N epsilon times the largest, and clamped at 0 by readers.
#pragma once

#include <span>

#include "core/memory.h"
#include "filigree/filigree.h"
#include "stylization/displacement.h"

namespace flg {

// One number a point that counts in distances besides the displacement (sec. 5): a component of an attribute. Numbers are
// metres, that is, multiplied by the attribute's weight already.
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

    uint32_t node_count() const { return boundaries.back(); }
    uint32_t curve_count() const { return static_cast<uint32_t>(boundaries.size()) - 1; }
    // Centres of the curve's patches: first_patch to end_patch - 1.
    uint32_t first_patch(uint32_t curve) const { return boundaries[curve] + patch; }
    uint32_t end_patch(uint32_t curve) const {
        const uint32_t end = boundaries[curve + 1];
        return end > first_patch(curve) + patch ? end - patch : first_patch(curve);
    }
};

// The scene has at least one patch. A unit is up to 256 entries of the matrix, about 0.4 us, for the displacement or a
// channel.
class PatchRows {
public:
    PatchRows(const StyleScene& scene, Memory* memory) : PatchRows(scene, scene.patch, memory) {}
    // For patches of another size, at most scene.patch, around the same centres.
    PatchRows(const StyleScene& scene, uint32_t patch, Memory* memory);

    // Goes on with the next row, spending units; true when it is complete. Not to be called when done().
    bool advance(uint32_t& units);
    // The row that is complete is the last.
    bool done() const { return complete_ && row_ == last_row_; }

    // The complete row: entry [c] is rho_sq(index(), c); infinite where c is not the centre of a patch, also at c = -1
    // and at c = node_count(). May be below zero by rounding.
    const double* row() const { return current_.data() + 1; }
    uint32_t index() const { return row_; }
    // The style curve it belongs to.
    uint32_t curve() const { return curve_; }

private:
    enum class Stage : uint8_t { fill, first_rows, rows };

    bool fill(uint32_t& units);
    bool sum_first_rows(uint32_t& units);
    void sum_block(uint32_t end);
    void begin_row();
    void compute_block(uint32_t end);
    bool next_channel();
    // The block of columns that begins at column_ ends here.
    uint32_t block_end() const;
    void begin_columns(uint32_t curve);
    uint32_t skip_empty(uint32_t curve) const;
    double* first_row(uint32_t curve) { return first_rows_.data() + static_cast<size_t>(curve) * scene_.node_count(); }

    StyleScene scene_;
    uint32_t patch_;
    Buffer<double> current_, previous_;  // with one entry more at both ends
    Buffer<double> first_rows_;
    Stage stage_ = Stage::fill;
    bool complete_ = false;
    uint32_t curve_ = 0;  // of row_
    uint32_t row_ = 0;
    uint32_t last_row_ = 0;
    uint32_t column_curve_ = 0;  // where the next block of columns begins
    uint32_t column_ = 0;
    uint32_t channel_ = 0;  // what of the block comes next: the displacement, then each channel
    uint32_t term_ = 0;     // first rows: how many of the block's 2p + 1 terms are summed
};

}  // namespace flg
