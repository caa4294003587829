// SPDX-License-Identifier: MIT
#include "inflation/merge_parts.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/failure.h"
#include "inflation/bone_weights.h"
#include "inflation/sharp_corners.h"
#include "inflation/surface_extraction.h"
#include "runtime/each.h"
#include "skeletons/node_clusters.h"

namespace flg {

namespace {

// ---- Makes the triangles of a surface even: vertices move towards the mean of their neighbours, along the surface,
// and back onto it (Newton's method along the gradient); sides are flipped towards Delaunay where that keeps the
// surface and the manifold.

constexpr uint32_t rounds = 6;               // of smoothing
constexpr uint32_t flips_before[] = {1, 3};  // rounds that flips come before
constexpr uint32_t max_flip_rounds = 4;
constexpr uint32_t max_newton_steps = 5;  // one or two as a rule
constexpr double near_enough = 1e-3;      // by the spacing
constexpr double max_step = 0.5;          // onto the surface, by the spacing
constexpr double min_turn = 0.3;          // cosine between triangles whose side may be flipped
constexpr double noise = 1e-9;
constexpr uint32_t corners_before = 2;  // the round that corners get their vertices before
constexpr double corner_length = 1.5;   // over which contours turn at a corner, by the spacing
constexpr double corner_reach = 3;      // of the vertex that is nearest to one, likewise

Task<Buffer<Across>> triangles_across(Pace& pace, uint32_t vertices, std::span<const TriangleVertices> triangles) {
    // Side k of a triangle begins at the corner after k.
    const Groups sides = co_await group_by(pace, 3 * triangles.size(), vertices,
                                           [=](uint32_t i) { return triangles[i / 3][(i + 1) % 3]; });
    Buffer<Across> across(triangles.size(), pace.memory());
    co_await each(pace, triangles.size(), Cost::tens_of_ns, [&](uint32_t triangle) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t from = triangles[triangle][(k + 1) % 3], to = triangles[triangle][(k + 2) % 3];
            for (const uint32_t side : sides.of(to))
                if (triangles[side / 3][(side + 2) % 3] == from) across[triangle][k] = side / 3;
        }
    });
    co_return across;
}

struct Improvement {
    // Onto the surface, along the gradient.
    void land(uint32_t vertex) {
        Vec3& p = positions[vertex];
        PartUnion::Sample sample = parts.sample(p);
        double share = 1;
        for (uint32_t i = 0; i < max_newton_steps; ++i) {
            const double steep = sample.gradient.squaredNorm();
            if (steep < noise || std::fabs(sample.value) < near_enough * spacing) break;
            const double along = std::clamp(sample.value / std::sqrt(steep), -max_step * spacing, max_step * spacing);
            const Vec3 next = p - share * along / std::sqrt(steep) * sample.gradient;
            const PartUnion::Sample there = parts.sample(next);
            if (std::fabs(there.value) >= std::fabs(sample.value)) {
                // Too far, next to an edge of the surface.
                share /= 2;
                continue;
            }
            p = next;
            sample = there;
        }
        std::construct_at(&samples[vertex], sample);
    }

    void move(uint32_t vertex) {
        if (is_fixed[vertex]) return;
        Vec3 step = sums[vertex] / counts[vertex] - positions[vertex];
        const Vec3& normal = samples[vertex].gradient;
        const double steep = normal.squaredNorm();
        if (steep > noise) step -= normal * (normal.dot(step) / steep);
        positions[vertex] += step;
        land(vertex);
    }

    void put(uint32_t vertex, const SharpCorner& corner) {
        is_fixed[vertex] = 1;
        positions[vertex] = corner.at;
        PartUnion::Sample sample = parts.sample(corner.at);
        // A tip is flat: its slope says little.
        if (sample.gradient.squaredNorm() < noise) sample.gradient = samples[vertex].gradient;
        sample.part = corner.part;
        std::construct_at(&samples[vertex], sample);
    }

    // Whether a vertex is next to the vertex at a corner of a triangle.
    bool joined(uint32_t triangle, uint32_t corner, uint32_t vertex) const {
        const uint32_t centre = triangles[triangle][corner];
        uint32_t here = triangle, k = corner;
        do {
            if (triangles[here][(k + 1) % 3] == vertex) return true;
            here = across[here][(k + 1) % 3];
            const TriangleVertices& t = triangles[here];
            k = t[0] == centre ? 0 : t[1] == centre ? 1 : 2;
        } while (here != triangle);
        return false;
    }

    bool improves(uint32_t triangle, uint32_t side, uint32_t other, uint32_t other_side) const {
        const TriangleVertices &t = triangles[triangle], &o = triangles[other];
        const uint32_t a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3], d = o[other_side];
        const Vec3 &pa = positions[a], &pb = positions[b], &pc = positions[c], &pd = positions[d];
        const Vec3 first = (pb - pa).cross(pc - pa), second = (pc - pd).cross(pb - pd);
        const double lengths = first.norm() * second.norm();
        // The cotangents at a and d: their sum is below 0 if the angles are more than half a turn.
        const double cosine_a = (pb - pa).dot(pc - pa), cosine_d = (pc - pd).dot(pb - pd);
        if (cosine_a * second.norm() + cosine_d * first.norm() >= -noise * lengths) return false;
        if (first.dot(second) < min_turn * lengths) return false;
        const Vec3 made = (pb - pa).cross(pd - pa), made_too = (pd - pa).cross(pc - pa), both = first + second;
        if (made.dot(both) <= min_turn * made.norm() * both.norm() ||
            made_too.dot(both) <= min_turn * made_too.norm() * both.norm())
            return false;
        return !joined(triangle, side, d);
    }

    // Of triangles (a, b, c) and (d, c, b) makes (a, b, d) and (a, d, c).
    void flip(uint32_t triangle) {
        for (uint32_t side = 0; side < 3; ++side) {
            const uint32_t other = across[triangle][side];
            const TriangleVertices t = triangles[triangle], o = triangles[other];
            const uint32_t a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
            const uint32_t j = o[0] != b && o[0] != c ? 0 : o[1] != b && o[1] != c ? 1 : 2;
            const uint32_t d = o[j];
            if (a == d || !improves(triangle, side, other, j)) continue;
            const uint32_t beyond_ab = across[triangle][(side + 2) % 3], beyond_ca = across[triangle][(side + 1) % 3];
            const uint32_t beyond_bd = across[other][(j + 1) % 3], beyond_dc = across[other][(j + 2) % 3];
            triangles[triangle] = {a, b, d};
            across[triangle] = {beyond_bd, other, beyond_ab};
            triangles[other] = {a, d, c};
            across[other] = {beyond_dc, beyond_ca, triangle};
            for (uint32_t& beyond : across[beyond_bd])
                if (beyond == other) beyond = triangle;
            for (uint32_t& beyond : across[beyond_ca])
                if (beyond == triangle) beyond = other;
            ++flips;
            return;
        }
    }

    const PartUnion& parts;
    double spacing;
    std::span<Vec3> positions;
    std::span<TriangleVertices> triangles;
    Buffer<PartUnion::Sample> samples;
    Buffer<Vec3> sums;  // of neighbours
    Buffer<uint32_t> counts;
    Buffer<uint8_t> is_fixed;
    Buffer<Across> across;
    uint32_t flips = 0;
};

Task<void> flip_sides(Pace& pace, Improvement& mesh) {
    for (uint32_t round = 0; round < max_flip_rounds; ++round) {
        mesh.flips = 0;
        co_await each(pace, mesh.triangles.size(), Cost::hundreds_of_ns, [&](uint32_t t) { mesh.flip(t); });
        if (mesh.flips == 0) break;
    }
}

Task<void> smooth(Pace& pace, Improvement& mesh) {
    const size_t vertices = mesh.positions.size();
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
        std::construct_at(&mesh.sums[v], Vec3::Zero());
        mesh.counts[v] = 0;
    });
    co_await each(pace, mesh.triangles.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const TriangleVertices& t = mesh.triangles[i];
        for (uint32_t k = 0; k < 3; ++k) {
            mesh.sums[t[k]] += mesh.positions[t[(k + 1) % 3]];
            ++mesh.counts[t[k]];
        }
    });
    co_await each(pace, vertices, Cost::hundreds_of_ns, [&](uint32_t v) { mesh.move(v); });
}

Task<void> put_corners(Pace& pace, Improvement& mesh, double angle) {
    const std::pmr::vector<SharpCorner> corners =
        co_await sharp_corners(pace, mesh.parts, angle, corner_length * mesh.spacing);
    const Buffer<uint32_t> vertices = co_await vertices_at(pace, corners, mesh.positions, corner_reach * mesh.spacing);
    co_await each(pace, corners.size(), Cost::hundreds_of_ns, [&](uint32_t c) {
        if (vertices[c] != UINT32_MAX) mesh.put(vertices[c], corners[c]);
    });
}

struct ImprovedMesh {
    Buffer<PartUnion::Sample> samples;  // what the union is at each vertex
    Buffer<Across> across;
    Buffer<uint8_t> is_fixed;  // by vertex: a sharp corner
};

// Of a closed manifold near the surface of the union, with sides of about `spacing`. All outlive the task. Takes about
// 5 us a vertex.
Task<ImprovedMesh> improve_mesh(Pace& pace, const PartUnion& parts, double spacing, double corner_angle,
                                std::span<Vec3> positions, std::span<TriangleVertices> triangles) {
    Memory* memory = pace.memory();
    const auto vertices = static_cast<uint32_t>(positions.size());
    Improvement mesh{.parts = parts,
                     .spacing = spacing,
                     .positions = positions,
                     .triangles = triangles,
                     .samples = Buffer<PartUnion::Sample>(vertices, memory),
                     .sums = Buffer<Vec3>(vertices, memory),
                     .counts = Buffer<uint32_t>(vertices, memory),
                     .is_fixed = Buffer<uint8_t>(vertices, memory),
                     .across = {}};
    co_await each(pace, vertices, Cost::hundreds_of_ns, [&](uint32_t v) {
        mesh.is_fixed[v] = 0;
        mesh.land(v);
    });
    mesh.across = co_await triangles_across(pace, vertices, triangles);
    for (uint32_t round = 0; round < rounds; ++round) {
        if (round == corners_before && corner_angle > 0) co_await put_corners(pace, mesh, corner_angle);
        if (std::find(std::begin(flips_before), std::end(flips_before), round) != std::end(flips_before))
            co_await flip_sides(pace, mesh);
        co_await smooth(pace, mesh);
    }
    co_return ImprovedMesh{std::move(mesh.samples), std::move(mesh.across), std::move(mesh.is_fixed)};
}

// A plane that is turned anyhow goes through 1.5 cells an area of one face, in the mean.
constexpr double cells_by_area = 1.5;
constexpr double surface_by_shape = 3;  // of a part, by the area of its contour, about
constexpr double coarser = 2;           // the lattice that the surface is measured on
constexpr double surplus = 1.005;       // of vertices, as counts are only about right
constexpr uint32_t max_tries = 4;       // until there are enough
// Of the radius of the thinnest part: lattice points are so near to each other that none falls between them.
constexpr double max_spacing = 0.8;
constexpr uint32_t min_vertices = 100;
constexpr uint32_t speck = 16;     // vertices: a ball as thin as the lattice allows has more
constexpr double gap_cells = 1.5;  // between parts that are kept apart: no edge of the lattice reaches across

// From how many vertices the coarse lattice gives: the spacing that gives as many as asked for, or what the thinnest
// part needs.
double fine_spacing(const PartUnion& parts, double coarse, double counted, const MergeOptions& options) {
    const double wanted = coarse * std::sqrt(counted / (surplus * options.vertices));
    uint32_t thinnest = 0;
    for (uint32_t i = 1; i < parts.parts().size(); ++i)
        if (parts.parts()[i].radius() < parts.parts()[thinnest].radius()) thinnest = i;
    const double needed = max_spacing * parts.parts()[thinnest].radius();
    const double vertices = counted * (coarse / needed) * (coarse / needed);
    if (needed < wanted && !(vertices <= options.max_vertices))
        throw Failure(
            FLG_ERROR_LIMIT,
            "merge: part %u is so thin, %.3g, that the surface would need about %.3g vertices; the limit is %u",
            thinnest, parts.parts()[thinnest].radius(), vertices, options.max_vertices);
    return std::min(wanted, needed);
}

Task<uint32_t> count_vertices(Pace& pace, const PartUnion& parts, double spacing) {
    SurfaceGrid grid = co_await SurfaceGrid::make(pace, parts, spacing);
    co_await SurfaceGrid::clear(pace, grid);
    co_return std::max(grid.vertex_count(), 1u);
}

// Of at least so many vertices, as a rule: with a smaller spacing where the given one gives fewer.
Task<DualSurface> surface_on_lattice(Pace& pace, PartUnion& parts, uint32_t vertices, double& spacing) {
    for (uint32_t tries = 1;; ++tries) {
        parts.set_gap(gap_cells * spacing);
        SurfaceGrid grid = co_await SurfaceGrid::make(pace, parts, spacing);
        if (grid.vertex_count() >= vertices || tries == max_tries) {
            DualSurface surface = co_await extract_surface(pace, grid);
            co_await SurfaceGrid::clear(pace, grid);
            co_return surface;
        }
        const double more = std::pow(surplus, tries + 1);
        spacing *= std::sqrt(std::max(1.0, static_cast<double>(grid.vertex_count())) / (more * vertices));
        co_await SurfaceGrid::clear(pace, grid);
    }
}

Vec3 outwards(const PartUnion::Sample& sample) {
    const double steep = sample.gradient.norm();
    return steep > 0 ? Vec3(-sample.gradient / steep) : Vec3(Vec3::UnitZ());
}

// Where parts are cut off each other, slivers may be left that are no more than a corner of the lattice.
Task<void> drop_specks(Pace& pace, DualSurface& surface) {
    const auto vertices = static_cast<uint32_t>(surface.positions.size());
    NodeClusters pieces(vertices, pace.memory());
    Buffer<uint32_t> size(vertices, pace.memory()), number(vertices, pace.memory());
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
        pieces.begin(v);
        size[v] = 0;
    });
    co_await each(pace, surface.triangles.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const TriangleVertices& t = surface.triangles[i];
        pieces.join(t[0], t[1]);
        pieces.join(t[1], t[2]);
    });
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) { ++size[pieces.first(v)]; });
    uint32_t kept = 0, kept_triangles = 0;
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
        if (size[pieces.first(v)] < speck) return;
        number[v] = kept;
        surface.positions[kept++] = surface.positions[v];
    });
    if (kept == 0 || kept == vertices) co_return;
    co_await each(pace, surface.triangles.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const TriangleVertices& t = surface.triangles[i];
        if (size[pieces.first(t[0])] >= speck)
            surface.triangles[kept_triangles++] = {number[t[0]], number[t[1]], number[t[2]]};
    });
    surface.positions.resize(kept);
    surface.triangles.resize(kept_triangles);
}

}  // namespace

double expected_spacing(std::span<const PlacedPart> parts, uint32_t vertices) {
    double area = 0;
    for (const PlacedPart& part : parts) {
        const auto& m = part.placement;
        area += surface_by_shape * part.part->area * (m[0] * m[0] + m[4] * m[4] + m[8] * m[8]);
    }
    return std::sqrt(cells_by_area * area / vertices);
}

Task<EvenMesh> merge_evenly(Pace& pace, std::span<const PlacedPart> placed, MergeOptions options) {
    pace.stage("merge");
    if (placed.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "merge: there are no parts");
    if (options.vertices < min_vertices)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "merge: %u vertices asked for; a surface has %u or more",
                      options.vertices, min_vertices);
    PartUnion parts = co_await PartUnion::make(pace, placed, options.blend);
    // A lattice that gives about a fourth of the vertices.
    const double coarse = coarser * expected_spacing(placed, options.vertices);
    parts.set_gap(gap_cells * coarse / coarser);
    const uint32_t counted = co_await count_vertices(pace, parts, coarse);
    double spacing = fine_spacing(parts, coarse, counted, options);
    DualSurface surface = co_await surface_on_lattice(pace, parts, options.vertices, spacing);
    const bool some_apart =
        std::any_of(placed.begin(), placed.end(), [](const auto& p) { return !p.apart_from.empty(); });
    if (some_apart) co_await drop_specks(pace, surface);
    ImprovedMesh improved =
        co_await improve_mesh(pace, parts, spacing, options.corner_angle, surface.positions, surface.triangles);
    Memory* memory = pace.memory();
    const size_t vertices = surface.positions.size(), triangles = surface.triangles.size();
    EvenMesh even{.parts = std::move(parts),
                  .mesh = {.positions = Buffer<Vec3>(vertices, memory),
                           .normals = Buffer<Vec3>(vertices, memory),
                           .triangles = Buffer<TriangleVertices>(triangles, memory),
                           .parts = Buffer<uint32_t>(vertices, memory),
                           .triangle_parts = {},
                           .is_fixed = std::move(improved.is_fixed),
                           .spacing = spacing,
                           .even_vertices = static_cast<uint32_t>(vertices)},
                  .samples = std::move(improved.samples),
                  .across = std::move(improved.across)};
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
        std::construct_at(&even.mesh.positions[v], surface.positions[v]);
        std::construct_at(&even.mesh.normals[v], outwards(even.samples[v]));
        even.mesh.parts[v] = even.samples[v].part;
    });
    co_await each(pace, triangles, Cost::some_ns, [&](uint32_t t) { even.mesh.triangles[t] = surface.triangles[t]; });
    co_return even;
}

namespace {

// Of a mesh that was cut.
Task<ManyWeights> carried(Pace& pace, const ManyWeights& weights, std::span<const BorderOrigin> origins) {
    const size_t all = origins.size();
    ManyWeights out{Buffer<ManyJoints>(all, pace.memory()), Buffer<double>(all, pace.memory())};
    co_await each(pace, all, Cost::hundreds_of_ns, [&](uint32_t v) {
        const auto& [of, shares] = origins[v];
        out.of_vertex[v] = weights.of_vertex[of[0]];
        out.spread[v] = 0;
        for (uint32_t k = 0; k < 3; ++k)
            if (shares[k] > 0) out.spread[v] += shares[k] * weights.spread[of[k]];
        if (shares[1] > 0) mix_weights(out.of_vertex[v], weights.of_vertex[of[1]], shares[1] / (shares[0] + shares[1]));
        if (shares[2] > 0) mix_weights(out.of_vertex[v], weights.of_vertex[of[2]], shares[2]);
    });
    co_return out;
}

}  // namespace

Task<MergedMesh> cut_merged(Pace& pace, EvenMesh& even, ManyWeights* weights) {
    pace.stage("borders");
    MergedMesh& from = even.mesh;
    BorderedMesh cut = co_await cut_at_borders(pace, even.parts,
                                               {.spacing = from.spacing,
                                                .positions = {from.positions.data(), from.positions.size()},
                                                .triangles = {from.triangles.data(), from.triangles.size()},
                                                .across = {even.across.data(), even.across.size()},
                                                .samples = {even.samples.data(), even.samples.size()},
                                                .is_fixed = {from.is_fixed.data(), from.is_fixed.size()}});
    Memory* memory = pace.memory();
    const size_t inner = from.positions.size(), vertices = cut.positions.size();
    MergedMesh mesh{.positions = std::move(cut.positions),
                    .normals = Buffer<Vec3>(vertices, memory),
                    .triangles = std::move(cut.triangles),
                    .parts = Buffer<uint32_t>(vertices, memory),
                    .triangle_parts = std::move(cut.triangle_parts),
                    .is_fixed = Buffer<uint8_t>(vertices, memory),
                    .spacing = from.spacing,
                    .even_vertices = from.even_vertices};
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
        std::construct_at(&mesh.normals[v], outwards(cut.samples[v]));
        mesh.parts[v] = cut.samples[v].part;
        mesh.is_fixed[v] = v < inner ? from.is_fixed[v] : uint8_t{0};
    });
    if (weights) *weights = co_await carried(pace, *weights, {cut.origins.data(), cut.origins.size()});
    co_return mesh;
}

Task<MergedMesh> merge_parts(Pace& pace, std::span<const PlacedPart> placed, MergeOptions options) {
    EvenMesh even = co_await merge_evenly(pace, placed, options);
    co_return co_await cut_merged(pace, even, nullptr);
}

}  // namespace flg
