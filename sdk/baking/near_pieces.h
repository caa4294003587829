// SPDX-License-Identifier: MIT
// The pieces of borders around one triangle of the surface, in the plane of the mesh's triangle that it lies on, and
// which of them is nearest to each of a few texels. A kernel, as any number of borders may meet at a vertex.
#pragma once

#include <cmath>

#include "baking/border_pieces.h"
#include "core/vec.h"

namespace flg {

// A triangle of the mesh as texels lie on it: its own axes, in units about as long as a texel, so that numbers of any
// mesh are of the same size.
struct TexelPlane {
    // False: the triangle has no area in the map.
    bool set(const Buffer<Position>& positions, const Triple& corners, const float* uvs, uint32_t size);
    float x(double right, double down) const {
        return static_cast<float>(step_x * (right - corner[0]) + row_x * (down - corner[1]));
    }
    float y(double down) const { return static_cast<float>(row_y * (down - corner[1])); }
    // What a texel measures at most.
    double diagonal() const { return step_x + std::abs(row_x) + row_y; }

    Vec3 origin, axis_x, axis_y, axis_z;
    double unit = 1, per_metre = 1;           // metres, and how many there are in one
    std::array<double, 2> corner{};           // texels: where the origin is
    double step_x = 0, row_x = 0, row_y = 0;  // one texel on along x, one row on along x and y
};

struct NearPiece {
    // Of a texel, across it.
    float width(const TexelPlane& plane) const;

    float x, y, z, along_x, along_y, along_z, inverse_length_sq;
    uint32_t piece;
};

// Texels of one triangle, side by side in a vector's lanes.
struct TexelBatch {
    static constexpr uint32_t lanes = 8;

    uint32_t count = 0;
    std::array<std::array<uint32_t, 2>, lanes> texels;  // column and row
    std::array<float, lanes> x, y;                      // on the plane
    std::array<float, lanes> distances_sq;              // to the nearest piece; infinite: there is none
    std::array<int32_t, lanes> nearest;                 // of the pieces gathered
};

class NearPieces {
public:
    NearPieces(const BorderPieces& borders, Memory* memory) : borders_(borders), pieces_(memory) {}

    // All that may be nearest around these vertices are still to be gathered: those at a vertex, and those that go on
    // from the ends of its nearest one where there are none.
    void begin(const Triple& vertices);
    bool is_gathered() const { return hub_ == hub_count_; }
    // About so many units of tens of nanoseconds; returns them.
    uint32_t gather(const TexelPlane& plane, uint32_t units);

    // Likewise: looks for the batch's nearest pieces, from the first one again after begin_search().
    void begin_search(TexelBatch& batch);
    bool is_searched() const { return searched_ == pieces_.size(); }
    uint32_t search(TexelBatch& batch, uint32_t units);

    const NearPiece& operator[](size_t i) const { return pieces_[i]; }

private:
    void add_hub(uint32_t vertex);
    bool is_known(uint32_t vertex) const;
    void add_piece(const TexelPlane& plane, uint32_t piece);

    const BorderPieces& borders_;
    std::pmr::vector<NearPiece> pieces_;
    std::array<uint32_t, 6> hubs_{};  // vertices whose pieces are gathered
    uint32_t hub_count_ = 0, hub_ = 0, end_ = 0;
    size_t searched_ = 0;
};

}  // namespace flg
