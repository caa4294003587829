// SPDX-License-Identifier: MIT
// What the maps show of one triangle of the surface. A kernel, as a triangle may cover a whole map.
//
// A texel's place on the mesh is that of the mesh's triangle, flat from corner to corner; there the nearest of the
// border's pieces around the triangle's corners is found, and the texel's width across it: lines and blends end
// softly over that.
#pragma once

#include "baking/baked_shape.h"
#include "baking/near_pieces.h"
#include "baking/texel_owners.h"

namespace flg {

// All that bands share.
struct Canvas {
    Canvas(const BakeRequest& of_request, const Surface& of_surface, const RegionTree& of_tree, Memory* memory)
        : request(of_request), surface(of_surface), tree(of_tree), bands(of_request.size), overlaps(memory) {}

    const BakeRequest& request;
    const Surface& surface;
    const RegionTree& tree;
    Bands bands;
    BakedShape shape;
    BorderPieces borders;
    Buffer<TexelTriangle> triangles;      // the surface's
    Groups mesh_triangles, in_band;       // by band: the mesh's, the surface's
    Buffer<uint64_t> covered;             // a bit a texel, row by row
    std::pmr::vector<Overlaps> overlaps;  // by band

    size_t words() const { return (size_t{request.size} + 63) / 64; }  // of a row of `covered`
    bool is_covered(uint32_t x, uint32_t y) const { return (covered[y * words() + x / 64] >> x % 64 & 1) != 0; }
};

class TexelPainter {
public:
    TexelPainter(const Canvas& canvas, TexelOwners& owners, Memory* memory);

    // Returns what that cost, in units of tens of nanoseconds.
    uint32_t begin(uint32_t triangle);
    // Paints for about so many units; returns them, 0 once the triangle is whole.
    uint32_t run(uint32_t units);

private:
    // Where on the triangle a value rises: from, a texel to the right, a row down.
    struct Rise {
        double from = 0, dx = 0, dy = 0;
        double at(double x, double y) const { return from + dx * x + dy * y; }
    };
    // In units of the plane.
    struct Nearest {
        float distance;
        const NearPiece* piece;  // null: none
    };

    void set_heights(uint32_t triangle);
    void begin_row();
    uint32_t take_texels();
    void paint(uint32_t x, uint32_t y, const Nearest& found);
    void paint_height(size_t texel, double right, double down);
    uint8_t share_of_line(const Nearest& found) const;
    void write_blends(size_t texel, const Nearest& found) const;

    const Canvas& canvas_;
    TexelOwners& owners_;
    const bool wants_distances_, wants_heights_;
    NearPieces near_;
    TexelBatch batch_{};
    std::array<Rise, 3> weights_;
    std::array<double, 3> slack_{}, columns_{};  // columns until a weight is one less
    std::array<float, 3> heights_{}, slopes_x_{}, slopes_y_{};
    bool is_flat_ = true;
    uint32_t label_ = 0;
    TexelPlane plane_;
    float half_line_ = 0, half_texel_ = 0;         // of borders, and the most of a texel: units of the plane
    uint32_t left_ = 0, right_ = 0, end_row_ = 0;  // of the triangle; the last column is one of it
    uint32_t x_ = 0, y_ = 0, stop_ = 0;            // of this row
};

// What texels show that no triangle covers.
void paint_background(const BakeRequest& request, size_t texel);

}  // namespace flg
