// SPDX-License-Identifier: MIT
#include "inflation/surface_extraction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "core/failure.h"
#include "runtime/each.h"

namespace flg {

namespace {

// ---- Which crossed edges of a cube belong to one sheet of the surface in it: the patches of dual marching cubes
// (Nielson: Dual marching cubes, 2004), made at compile time. Corner i is at (i & 1, i >> 1 & 1, i >> 2). Edge 4 * axis
// + s + 2 * t goes along the axis from the corner at s of the axis after it and t of the one after that. A face with
// two opposite corners inside cuts off those outside: what is inside stays together.

constexpr uint32_t cube_corner(uint32_t axis, uint32_t along, uint32_t s, uint32_t t) {
    return (along << axis) | (s << ((axis + 1) % 3)) | (t << ((axis + 2) % 3));
}

struct DualCase {
    std::array<uint8_t, 12> patch;  // by edge; for those that are crossed
    uint8_t count;
};

// A face across `axis`, at its far end or not: its edges along the next axis at t = 0 and 1, then along the one after
// at s = 0 and 1.
constexpr std::array<uint32_t, 4> face_edges(uint32_t axis, uint32_t far) {
    const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    // Along u: s is of v, t of axis. Along v: s is of axis, t of u.
    return {4 * u + 0 + 2 * far, 4 * u + 1 + 2 * far, 4 * v + far + 0, 4 * v + far + 2};
}

constexpr std::array<DualCase, 256> make_dual_cases() {
    std::array<DualCase, 256> cases{};
    for (uint32_t inside = 0; inside < 256; ++inside) {
        std::array<uint8_t, 12> root{};
        for (uint8_t e = 0; e < 12; ++e) root[e] = e;
        const auto find = [&](uint32_t e) {
            while (root[e] != e) e = root[e];
            return static_cast<uint8_t>(e);
        };
        const auto join = [&](uint32_t a, uint32_t b) { root[find(a)] = find(b); };
        const auto is_inside = [&](uint32_t corner) { return (inside >> corner & 1) != 0; };
        for (uint32_t axis = 0; axis < 3; ++axis) {
            for (uint32_t far = 0; far < 2; ++far) {
                const auto edges = face_edges(axis, far);
                // Corners of the face by (u, v); at each, the edges along u (0 or 1) and along v (2 or 3).
                uint32_t crossed = 0, list[4] = {};
                const bool c00 = is_inside(cube_corner(axis, far, 0, 0)), c10 = is_inside(cube_corner(axis, far, 1, 0)),
                           c01 = is_inside(cube_corner(axis, far, 0, 1)), c11 = is_inside(cube_corner(axis, far, 1, 1));
                if (c00 != c10) list[crossed++] = edges[0];
                if (c01 != c11) list[crossed++] = edges[1];
                if (c00 != c01) list[crossed++] = edges[2];
                if (c10 != c11) list[crossed++] = edges[3];
                if (crossed == 2) join(list[0], list[1]);
                if (crossed < 4) continue;
                // Opposite corners: the two outside are cut off.
                if (c00) {
                    join(edges[0], edges[3]);  // around (1, 0)
                    join(edges[1], edges[2]);  // around (0, 1)
                } else {
                    join(edges[0], edges[2]);
                    join(edges[1], edges[3]);
                }
            }
        }
        DualCase& out = cases[inside];
        std::array<uint8_t, 12> number{};
        for (auto& n : number) n = 255;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            for (uint32_t s = 0; s < 2; ++s) {
                for (uint32_t t = 0; t < 2; ++t) {
                    const uint32_t edge = 4 * axis + s + 2 * t;
                    if (is_inside(cube_corner(axis, 0, s, t)) == is_inside(cube_corner(axis, 1, s, t))) continue;
                    uint8_t& patch = number[find(edge)];
                    if (patch == 255) patch = out.count++;
                    out.patch[edge] = patch;
                }
            }
        }
    }
    return cases;
}

inline constexpr std::array<DualCase, 256> dual_cases = make_dual_cases();

constexpr double max_blocks = 4e6;
constexpr double min_spacing = 1e-7;             // of how far from the origin it is: vertices are floats
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
    if (!(spacing >= min_spacing * farthest))
        throw Failure(FLG_ERROR_LIMIT, "parts: lie up to %.3g from the origin, too far for triangles of %.3g", farthest,
                      spacing);
    middle_ = (low + high) / 2;
    double blocks = 1;
    for (uint32_t k = 0; k < 3; ++k) {
        const double count = std::ceil(((high - low)[k] + 2 * parts.widest_blend() + 4 * spacing) / (cells * spacing));
        blocks *= count;
        if (!(count < 1e5) || !(blocks <= max_blocks))
            throw Failure(
                FLG_ERROR_LIMIT,
                "parts: triangles of %.3g are too small for a model of %.3g by %.3g by %.3g: more than %g blocks of "
                "8 cells",
                spacing, (high - low).x(), (high - low).y(), (high - low).z(), max_blocks);
        counts_[k] = static_cast<uint32_t>(count);
        half_[k] = count * cells / 2;
    }
    block_at_ = Buffer<uint32_t>(static_cast<size_t>(blocks), memory);
}

Task<SurfaceGrid> SurfaceGrid::make(Pace& pace, const PartUnion& parts, double spacing) {
    SurfaceGrid grid(parts, spacing, pace.memory());
    co_await each(pace, grid.block_at_.size(), Cost::some_ns, [&](uint32_t i) { grid.block_at_[i] = no_block; });
    for (const ImplicitPart& part : parts.parts())
        co_await each(pace, part.part().points.size(), Cost::hundreds_of_ns,
                      [&](uint32_t vertex) { grid.seed(part, vertex); });
    // Blocks spread to others, which come after them.
    for (uint32_t number = 0; number < grid.blocks_.size(); ++number) {
        grid.blocks_[number].values = Buffer<float>(size_t{corners} * corners * corners, pace.memory());
        co_await each(pace, size_t{corners} * corners, Cost::microseconds,
                      [&, number](uint32_t row) { grid.evaluate_row(grid.blocks_[number], row); });
        for (uint32_t face = 0; face < 6; ++face) grid.spread(number, face);
        co_await each(pace, size_t{cells} * cells, Cost::tens_of_ns,
                      [&, number](uint32_t row) { grid.count_row(grid.blocks_[number], row); });
    }
    co_return grid;
}

Task<void> SurfaceGrid::clear(Pace& pace, SurfaceGrid& grid) {
    co_await each(pace, grid.blocks_.size(), Cost::microseconds, [&](uint32_t) { grid.blocks_.pop_back(); });
}

// One vertex of a part's own surface, on both sides.
void SurfaceGrid::seed(const ImplicitPart& part, uint32_t vertex) {
    const InflatedPart& shape = part.part();
    for (const double side : {-1.0, 1.0}) {
        const Point2& p = shape.points[vertex];
        const double height = side * part.thickness() * std::sqrt(shape.squares[vertex]);
        const Vec3 place = part.place(Vec3(p.x, p.y, part.lift(p.x, p.y) + height));
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

void SurfaceGrid::evaluate_row(Block& block, uint32_t row) const {
    const uint32_t y = cells * block.at[1] + row % corners, z = cells * block.at[2] + row / corners;
    for (uint32_t x = 0; x < corners; ++x)
        block.values[corners * row + x] = static_cast<float>(parts_.sample(place(cells * block.at[0] + x, y, z)).value);
}

// Goes on beyond a face that the surface crosses.
void SurfaceGrid::spread(uint32_t number, uint32_t face) {
    const Block& block = blocks_[number];
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

void SurfaceGrid::count_row(Block& block, uint32_t row) {
    const uint32_t y = row % cells, z = row / cells;
    for (uint32_t x = 0; x < cells; ++x) {
        const uint32_t inside = inside_corners(block, x, y, z);
        if (inside == 0 || inside == 255) continue;
        if (block.vertices.empty()) block.vertices = Buffer<uint32_t>(size_t{cells} * cells * cells, memory_);
        block.vertices[cells * row + x] = vertex_count_;
        vertex_count_ += dual_cases[inside].count;
        const bool low = (inside & 1) != 0;
        for (uint32_t axis = 0; axis < 3; ++axis) crossed_count_ += low != ((inside >> (1u << axis) & 1) != 0);
    }
}

namespace {

constexpr uint32_t cells = SurfaceGrid::cells, corners = SurfaceGrid::corners;
constexpr std::array<uint32_t, 3> strides = {1, corners, corners* corners};

struct Cell {
    uint32_t block = 0;
    std::array<uint32_t, 3> at{};  // in the block
    uint32_t inside = 0;           // its corners
};

struct Extraction {
    void place_vertices(const SurfaceGrid::Block& here, uint32_t x, uint32_t y, uint32_t z) {
        const uint32_t inside = SurfaceGrid::inside_corners(here, x, y, z);
        if (inside == 0 || inside == 255) return;
        const DualCase& sheets = dual_cases[inside];
        Vec3 sums[4] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
        uint32_t counts[4] = {};
        const float* values = &here.values[(z * corners + y) * corners + x];
        const auto value = [&](uint32_t corner) -> double {
            return values[(corner & 1) + (corner >> 1 & 1) * strides[1] + (corner >> 2) * strides[2]];
        };
        for (uint32_t edge = 0; edge < 12; ++edge) {
            const uint32_t axis = edge / 4, s = edge & 1, t = edge >> 1 & 1;
            const uint32_t a = cube_corner(axis, 0, s, t), b = cube_corner(axis, 1, s, t);
            if ((inside >> a & 1) == (inside >> b & 1)) continue;
            Vec3 crossing(a & 1, a >> 1 & 1, a >> 2);
            crossing[axis] += std::clamp(value(a) / (value(a) - value(b)), 0.0, 1.0);
            sums[sheets.patch[edge]] += crossing;
            ++counts[sheets.patch[edge]];
        }
        const Vec3 corner = grid.place(cells * here.at[0] + x, cells * here.at[1] + y, cells * here.at[2] + z);
        for (uint32_t k = 0; k < sheets.count; ++k)
            out.positions.push_back(corner + grid.spacing() * (sums[k] / counts[k]));
    }

    Cell cell_at(std::array<uint32_t, 3> at) const {
        Cell cell;
        cell.block = grid.block_at(at[0] / cells, at[1] / cells, at[2] / cells);
        for (uint32_t k = 0; k < 3; ++k) cell.at[k] = at[k] % cells;
        cell.inside = SurfaceGrid::inside_corners(blocks[cell.block], cell.at[0], cell.at[1], cell.at[2]);
        return cell;
    }

    uint32_t vertex_of(const Cell& cell, uint32_t edge) const {
        return blocks[cell.block].vertices[(cell.at[2] * cells + cell.at[1]) * cells + cell.at[0]] +
               dual_cases[cell.inside].patch[edge];
    }

    // Around the edge along `axis` from a corner of the block.
    void add_polygon(const SurfaceGrid::Block& here, uint32_t axis, uint32_t x, uint32_t y, uint32_t z) {
        const float* values = &here.values[(z * corners + y) * corners + x];
        const bool from_inside = values[0] >= 0;
        if (from_inside == (values[strides[axis]] >= 0)) return;
        const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        const std::array<uint32_t, 3> corner = {cells * here.at[0] + x, cells * here.at[1] + y, cells * here.at[2] + z};
        // Cells around it, counter-clockwise seen from the end of the edge; the edge is at (s, t) of each.
        constexpr uint32_t around[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
        Cell cell[4];
        uint32_t vertex[8];  // of cells, and in between of middles
        uint32_t count = 0;
        for (uint32_t k = 0; k < 4; ++k) {
            std::array<uint32_t, 3> at = corner;
            at[u] -= around[k][0];
            at[v] -= around[k][1];
            cell[k] = cell_at(at);
        }
        const auto edge_of = [&](uint32_t k) { return 4 * axis + around[k][0] + 2 * around[k][1]; };
        std::array<uint32_t, 3> outside = corner;  // the end of the edge that is not inside
        if (from_inside) ++outside[axis];
        for (uint32_t k = 0; k < 4; ++k) {
            const uint32_t next = (k + 1) % 4;
            const uint32_t own = vertex_of(cell[k], edge_of(k)), other = vertex_of(cell[next], edge_of(next));
            vertex[count++] = own;
            // The face between this cell and the next: across u or v, at the side where the edge is not the same.
            const bool across_u = around[k][0] != around[next][0];
            const uint32_t face_axis = across_u ? u : v;
            const auto edges = face_edges(face_axis, around[k][across_u ? 0 : 1]),
                       next_edges = face_edges(face_axis, around[next][across_u ? 0 : 1]);
            const auto crossed = [&](uint32_t edge) {
                const uint32_t a = cube_corner(edge / 4, 0, edge & 1, edge >> 1 & 1),
                               b = cube_corner(edge / 4, 1, edge & 1, edge >> 1 & 1);
                return (cell[k].inside >> a & 1) != (cell[k].inside >> b & 1);
            };
            bool doubled = true;
            for (uint32_t e = 0; e < 4 && doubled; ++e)
                doubled = crossed(edges[e]) && vertex_of(cell[k], edges[e]) == own &&
                          vertex_of(cell[next], next_edges[e]) == other;
            if (!doubled) continue;
            // The face, by its lowest corner.
            std::array<uint32_t, 3> low = corner;
            const uint32_t other_axis = across_u ? v : u;
            low[other_axis] -= around[k][across_u ? 1 : 0];
            const uint32_t cut_off = ((outside[0] - low[0]) | (outside[1] - low[1]) << 1 | (outside[2] - low[2]) << 2);
            const auto [entry, added] = middles.try_emplace({low[0], low[1], low[2], face_axis, cut_off},
                                                            static_cast<uint32_t>(out.positions.size()));
            if (added) out.positions.push_back((out.positions[own] + out.positions[other]) / 2);
            vertex[count++] = entry->second;
        }
        if (!from_inside) std::reverse(vertex, vertex + count);
        const auto add = [&](uint32_t a, uint32_t b, uint32_t c) { out.triangles.push_back({a, b, c}); };
        if (count > 4) {
            Vec3 centre = Vec3::Zero();
            for (uint32_t k = 0; k < count; ++k) centre += out.positions[vertex[k]] / count;
            const auto number = static_cast<uint32_t>(out.positions.size());
            out.positions.push_back(centre);
            for (uint32_t k = 0; k < count; ++k) add(vertex[k], vertex[(k + 1) % count], number);
            return;
        }
        const bool first = (out.positions[vertex[0]] - out.positions[vertex[2]]).squaredNorm() <=
                           (out.positions[vertex[1]] - out.positions[vertex[3]]).squaredNorm();
        const uint32_t s = first ? 0 : 1;
        add(vertex[s], vertex[s + 1], vertex[s + 2]);
        add(vertex[s], vertex[s + 2], vertex[(s + 3) % 4]);
    }

    const SurfaceGrid& grid;
    const std::pmr::vector<SurfaceGrid::Block>& blocks;
    DualSurface& out;
    std::pmr::map<std::array<uint32_t, 5>, uint32_t> middles;  // by face and the corner outside that is cut off
};

// action(block, x, y, z) for all cells of blocks that have vertices: others have no crossed edges of their own.
template <class Action>
Task<void> each_cell(Pace& pace, const std::pmr::vector<SurfaceGrid::Block>& blocks, Action action) {
    constexpr uint32_t rows = cells * cells;
    return each_by_work(pace, blocks.size() * rows, Cost::tens_of_ns, [=, &blocks](uint32_t i) {
        const SurfaceGrid::Block& block = blocks[i / rows];
        if (block.vertices.empty()) return uint32_t{1};
        for (uint32_t x = 0; x < cells; ++x) action(block, x, i % cells, i % rows / cells);
        return 2 * cells;
    });
}

}  // namespace

Task<DualSurface> extract_surface(Pace& pace, const SurfaceGrid& grid) {
    Memory* memory = pace.memory();
    DualSurface surface{std::pmr::vector<Vec3>(memory), std::pmr::vector<TriangleVertices>(memory)};
    surface.positions.reserve(grid.vertex_count());
    surface.triangles.reserve(2 * size_t{grid.crossed_count()});
    Extraction extraction{grid, grid.blocks(), surface, std::pmr::map<std::array<uint32_t, 5>, uint32_t>(memory)};
    using Block = SurfaceGrid::Block;
    co_await each_cell(pace, grid.blocks(), [&](const Block& block, uint32_t x, uint32_t y, uint32_t z) {
        extraction.place_vertices(block, x, y, z);
    });
    co_await each_cell(pace, grid.blocks(), [&](const Block& block, uint32_t x, uint32_t y, uint32_t z) {
        for (uint32_t axis = 0; axis < 3; ++axis) extraction.add_polygon(block, axis, x, y, z);
    });
    co_return surface;
}

}  // namespace flg
