// SPDX-License-Identifier: MIT
// In which order to eliminate the unknowns of a matrix whose rows have places: nested dissection (George: Nested dissection of a
// regular finite element mesh, 1973), cut geometrically. A set is cut across one of the axes where few entries of the matrix
// cross, as around a neck (small ones: across the longest, at the mean); the points of one side that touch the other are put
// after both. Sets of at most 64 are ordered by minimum degree (exact, with what they touch
// outside counted in), as sets of bits. On meshes of surfaces the factor has about as many entries as with minimum degree on
// the whole, and each pass is linear, so that it can be stopped anywhere.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/vec.h"
#include "inflation/symmetric_matrix.h"

namespace flg {

class DissectionOrder {
public:
    // One place a row. All outlive the kernel; memory is taken at once, 28 bytes a row.
    DissectionOrder(const SymmetricMatrix& matrix, std::span<const Vec3> places, Memory* memory);

    // A unit is about 0.2 us; about 7 log2(n / 8) / 16 units a row.
    bool run(uint32_t count);
    // The row at each place of the order. For when it is done.
    Buffer<uint32_t> take_order() { return std::move(order_); }

private:
    enum class Pass { fill, next, measure, bin, scan, divide, touch, sort, copy, gather, eliminate, done };
    struct Range {
        uint32_t begin, end;
    };

    void step();
    void measure_end();
    void put_in_bins(uint32_t row);
    void scan(uint32_t row);
    void scan_end();
    void begin_division();
    bool touches_other(uint32_t row) const;
    void begin_leaf();
    void gather(uint32_t member);
    void eliminate();

    const SymmetricMatrix& matrix_;
    std::span<const Vec3> places_;
    Buffer<uint32_t> order_, sorted_;
    Buffer<uint32_t> side_;    // 2 * stamp of the range + which side; of a leaf's rows their number in it
    Buffer<uint8_t> touches_;  // whether a row of the range touches the other side
    std::pmr::vector<Range> stack_;
    Range range_{};
    uint32_t stamp_ = 0;
    uint32_t axis_ = 0;
    double cut_ = 0;
    Vec3 low_, high_, sum_;
    static constexpr uint32_t bins = 16;
    // Along each axis: rows in each bin, and how many more entries cross the cut after it than the one before.
    std::array<std::array<int32_t, bins>, 3> in_bin_{}, crossing_{};
    uint32_t counts_[2] = {}, touching_[2] = {};
    uint32_t separator_ = 0;  // the side whose touching rows separate
    uint32_t ends_[3] = {};   // where the next row of each kind goes
    uint32_t leaf_rows_[64] = {}, halo_rows_[64] = {};
    uint64_t leaf_[64] = {}, halo_[64] = {};  // what each row of the leaf touches: in it, and around it
    uint32_t degrees_[64] = {};               // of how many
    uint64_t left_ = 0;                       // rows that are not ordered yet
    uint32_t halo_count_ = 0;
    Pass pass_ = Pass::fill;
    uint32_t at_ = 0;
};

}  // namespace flg
