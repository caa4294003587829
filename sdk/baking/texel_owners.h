// SPDX-License-Identifier: MIT
// Which triangle of the mesh each texel of a band belongs to: exactly one, in whole 256ths of a texel, by the rule that
// a middle on an edge belongs to one of its two sides.
#pragma once

#include "baking/bake_request.h"
#include "baking/texture_bands.h"

namespace flg {

// Claims of texels that have an owner already, deeper than rounding explains.
struct Overlaps {
    uint32_t count = 0;
    uint32_t texels = 0;             // that have an owner
    uint32_t first = 0, second = 0;  // triangles of the first claim
    uint32_t x = 0, y = 0;           // its texel
};

[[noreturn]] void refuse_overlap(const Overlaps& overlaps, uint32_t size);

class TexelOwners {
public:
    TexelOwners(const BakeRequest& request, const Bands& bands, uint32_t band, Memory* memory);

    size_t size() const { return owners_.size(); }
    void clear(uint32_t texel) { owners_[texel] = no_index; }

    // A triangle's texels, row by row: run() does one row and returns its length, 0 once there is none.
    void begin(uint32_t triangle);
    uint32_t run();

    // Of a texel in rows [first_row, end_row): whether it is to be drawn; once.
    bool take(uint32_t x, uint32_t y) {
        uint32_t& owner = owners_[at(x, y)];
        if (owner >= taken) return false;  // no_index too
        owner |= taken;
        return true;
    }
    bool is_taken(uint32_t x, uint32_t y) const {
        const uint32_t owner = owners_[at(x, y)];
        return owner >= taken && owner != no_index;
    }

    const uint32_t first_row, end_row;
    Overlaps overlaps;

private:
    static constexpr uint32_t taken = 1u << 31;
    static constexpr int64_t parts = 256;  // of a texel

    // Edges, at 0 or above within.
    struct Exact {
        bool set(const float* uvs, uint32_t size);
        int64_t at(uint32_t edge, uint32_t x, uint32_t y) const {
            return from[edge] + dx[edge] * int64_t{x} + dy[edge] * int64_t{y};
        }
        double depth(uint32_t x, uint32_t y) const;  // texels from the nearest edge

        std::array<int64_t, 3> from, dx, dy;
        uint32_t left, right, top, bottom;
    };
    size_t at(uint32_t x, uint32_t y) const { return size_t{y - first_row} * size_ + x; }
    void claim_again(uint32_t x, uint32_t y);

    const BakeRequest& request_;
    uint32_t size_;
    Buffer<uint32_t> owners_;
    Exact exact_{};
    uint32_t triangle_ = no_index;
    uint32_t row_ = 0, stop_ = 0;
};

}  // namespace flg
