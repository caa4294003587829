// SPDX-License-Identifier: MIT
#include "inflation/surface_grid.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double most_blocks = 4e6;
constexpr double least_spacing = 1e-7;           // of how far from the origin it is: vertices are floats
constexpr double deep = 2 * SurfaceGrid::cells;  // in cells: what is so far inside of the union is not near its surface

}  // namespace

SurfaceGrid::SurfaceGrid(const PartUnion& parts, double spacing, Memory* memory)
    : parts_(parts), spacing_(spacing), memory_(memory), blocks_(memory) {
    Vec3 low = parts.parts()[0].low(), high = parts.parts()[0].high();
    for (const ImplicitPart& part : parts.parts()) {
        low = low.cwiseMin(part.low());
        high = high.cwiseMax(part.high());
    }
    const double farthest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
    if (!(spacing >= least_spacing * farthest))
        throw Failure(FLG_ERROR_LIMIT, "parts: lie up to %.3g from the origin, too far for triangles of %.3g", farthest,
                      spacing);
    middle_ = (low + high) / 2;
    double blocks = 1;
    for (uint32_t k = 0; k < 3; ++k) {
        const double count = std::ceil(((high - low)[k] + 2 * parts.widest_blend() + 4 * spacing) / (cells * spacing));
        blocks *= count;
        if (!(count < 1e5) || !(blocks <= most_blocks))
            throw Failure(
                FLG_ERROR_LIMIT,
                "parts: triangles of %.3g are too small for a model of %.3g by %.3g by %.3g: more than %g blocks of "
                "8 cells",
                spacing, (high - low).x(), (high - low).y(), (high - low).z(), most_blocks);
        counts_[k] = static_cast<uint32_t>(count);
        half_[k] = count * cells / 2;
    }
    block_at_ = Buffer<uint32_t>(static_cast<size_t>(blocks), memory);
}

bool SurfaceGrid::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

bool SurfaceGrid::release(uint32_t count) {
    for (; count > 0 && !blocks_.empty(); --count) blocks_.pop_back();
    return blocks_.empty();
}

void SurfaceGrid::step() {
    switch (pass_) {
        case Pass::clear: {
            const auto size = static_cast<uint32_t>(block_at_.size());
            const uint32_t stop = std::min(size, at_ + 1024);
            std::fill(block_at_.data() + at_, block_at_.data() + stop, no_block);
            at_ = stop;
            if (at_ < size) break;
            at_ = 0;
            pass_ = Pass::seed;
            break;
        }
        case Pass::seed: seed(); break;
        case Pass::next:
            if (block_ == blocks_.size()) {
                pass_ = Pass::done;
                break;
            }
            blocks_[block_].values = Buffer<float>(size_t{corners} * corners * corners, memory_);
            at_ = 0;
            pass_ = Pass::evaluate;
            break;
        case Pass::evaluate:
            evaluate_row();
            if (++at_ < corners * corners) break;
            at_ = 0;
            pass_ = Pass::spread;
            break;
        case Pass::spread:
            spread(at_);
            if (++at_ < 6) break;
            at_ = 0;
            pass_ = Pass::count;
            break;
        case Pass::count:
            count_row();
            if (++at_ < cells * cells) break;
            ++block_;
            pass_ = Pass::next;
            break;
        case Pass::done: break;
    }
}

// One vertex of a part's own surface, on both sides.
void SurfaceGrid::seed() {
    const ImplicitPart& part = parts_.parts()[part_];
    const InflatedPart& shape = part.part();
    for (const double side : {-1.0, 1.0}) {
        const Point2& p = shape.points[at_];
        const Vec3 place = part.place(Vec3(p.x, p.y, side * part.thickness() * std::sqrt(shape.squares[at_])));
        if (parts_.sample(place).value > deep * spacing_) continue;
        // The blocks of all cells around it.
        for (uint32_t i = 0; i < 8; ++i) {
            std::array<int64_t, 3> at{};
            for (uint32_t k = 0; k < 3; ++k) {
                const double cell = (place[k] - middle_[k]) / spacing_ + half_[k] + ((i >> k & 1) != 0 ? 1 : -1);
                at[k] = static_cast<int64_t>(std::floor(cell / cells));
            }
            activate(at);
        }
    }
    if (++at_ < shape.points.size()) return;
    at_ = 0;
    if (++part_ == parts_.parts().size()) pass_ = Pass::next;
}

void SurfaceGrid::activate(const std::array<int64_t, 3>& at) {
    for (uint32_t k = 0; k < 3; ++k)
        if (at[k] < 0 || at[k] >= counts_[k]) return;
    uint32_t& place = block_at_[(static_cast<size_t>(at[2]) * counts_[1] + static_cast<size_t>(at[1])) * counts_[0] +
                                static_cast<size_t>(at[0])];
    if (place != no_block) return;
    place = static_cast<uint32_t>(blocks_.size());
    Block& block = blocks_.emplace_back();
    for (uint32_t k = 0; k < 3; ++k) block.at[k] = static_cast<uint32_t>(at[k]);
}

void SurfaceGrid::evaluate_row() {
    Block& block = blocks_[block_];
    const uint32_t y = cells * block.at[1] + at_ % corners, z = cells * block.at[2] + at_ / corners;
    for (uint32_t x = 0; x < corners; ++x)
        block.values[corners * at_ + x] = static_cast<float>(parts_.sample(place(cells * block.at[0] + x, y, z)).value);
}

// Goes on beyond a face that the surface crosses.
void SurfaceGrid::spread(uint32_t face) {
    const Block& block = blocks_[block_];
    const uint32_t axis = face / 2, far = face % 2;
    constexpr std::array<uint32_t, 3> strides = {1, corners, corners * corners};
    const uint32_t first = far * cells * strides[axis];
    const uint32_t su = strides[(axis + 1) % 3], sv = strides[(axis + 2) % 3];
    bool any = false, all = true;
    for (uint32_t v = 0; v < corners; ++v)
        for (uint32_t u = 0; u < corners; ++u) {
            const bool inside = block.values[first + u * su + v * sv] >= 0;
            any |= inside;
            all &= inside;
        }
    if (any == all) return;
    std::array<int64_t, 3> at = {block.at[0], block.at[1], block.at[2]};
    at[axis] += far == 0 ? -1 : 1;
    activate(at);
}

void SurfaceGrid::count_row() {
    Block& block = blocks_[block_];
    const uint32_t y = at_ % cells, z = at_ / cells;
    for (uint32_t x = 0; x < cells; ++x) {
        const uint32_t inside = inside_corners(block, x, y, z);
        if (inside == 0 || inside == 255) continue;
        if (block.vertices.empty()) block.vertices = Buffer<uint32_t>(size_t{cells} * cells * cells, memory_);
        block.vertices[cells * at_ + x] = vertex_count_;
        vertex_count_ += dual_cases[inside].count;
        const bool low = (inside & 1) != 0;
        for (uint32_t axis = 0; axis < 3; ++axis) crossed_count_ += low != ((inside >> (1u << axis) & 1) != 0);
    }
}

}  // namespace flg
