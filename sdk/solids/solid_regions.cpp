// SPDX-License-Identifier: MIT
#include "solids/solid_regions.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>

#include "runtime/each.h"
#include "solids/solid_steps.h"
#include "surfaces/mesh/mesh_measures.h"

namespace flg {

namespace {

constexpr uint32_t no_bone = UINT32_MAX;
constexpr double sample_spacing = 0.5;  // cells, along a bone
constexpr double within = 0.6;          // cells: how far inside of the surface a vertex is looked for
constexpr int around = 2;               // cells

struct Entry {
    float way;
    uint32_t cell;
    bool operator<(const Entry& other) const { return way != other.way ? way > other.way : cell > other.cell; }
};

uint32_t cell_at(const SolidGrid& grid, const Vec3& at) {
    const Vec3 local = grid.local(at);
    uint32_t place[3];
    for (int k = 0; k < 3; ++k)
        place[k] = static_cast<uint32_t>(std::clamp(std::floor(local[k]), 0.0, grid.size[k] - 1.0));
    return grid.number(place[0], place[1], place[2]);
}

double distance_to(const BoneSegment& bone, const Vec3& at) {
    const Vec3 along = bone.to - bone.from, from = at - bone.from;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
    return (from - share * along).norm();
}

// The cell of the solid that a vertex is at.
uint32_t cell_of_vertex(const SolidGrid& grid, const Buffer<uint32_t>& bone_of, const Vec3& at, const Vec3& normal) {
    const Vec3 sunk = at - within * grid.cell * normal;
    const uint32_t own = cell_at(grid, sunk);
    if (bone_of[own] != no_bone) return own;
    const auto place = grid.place(own);
    uint32_t best = no_bone;
    double least = HUGE_VAL;
    for (int z = -around; z <= around; ++z)
        for (int y = -around; y <= around; ++y)
            for (int x = -around; x <= around; ++x) {
                const int64_t to[] = {int64_t{place[0]} + x, int64_t{place[1]} + y, int64_t{place[2]} + z};
                bool is_there = true;
                for (int k = 0; k < 3; ++k) is_there = is_there && to[k] >= 0 && to[k] < int64_t{grid.size[k]};
                if (!is_there) continue;
                const uint32_t cell = grid.number(static_cast<uint32_t>(to[0]), static_cast<uint32_t>(to[1]),
                                                  static_cast<uint32_t>(to[2]));
                if (bone_of[cell] == no_bone) continue;
                const double distance = (grid.middle_of(cell) - sunk).squaredNorm();
                if (distance < least) least = distance, best = cell;
            }
    return best;
}

}  // namespace

Task<Buffer<uint32_t>> nearest_bones_within(Pace& pace, const SolidGrid& grid, const Mesh& mesh,
                                            std::span<const BoneSegment> bones) {
    pace.stage("regions");
    Buffer<float> ways(grid.count(), pace.memory());
    Buffer<uint32_t> bone_of(grid.count(), pace.memory());
    co_await each(pace, grid.count(), Cost::some_ns, [&](uint32_t i) {
        ways[i] = HUGE_VALF;
        bone_of[i] = no_bone;
    });
    std::priority_queue<Entry, std::pmr::deque<Entry>> queue(std::less<Entry>(), std::pmr::deque<Entry>(pace.memory()));
    const SolidSteps steps(grid);
    Slice slice(Cost::tens_of_ns);
    for (uint32_t b = 0; b < bones.size(); ++b) {
        const BoneSegment& bone = bones[b];
        const double length = (bone.to - bone.from).norm();
        const auto samples = static_cast<uint32_t>(std::ceil(length / (sample_spacing * grid.cell))) + 1;
        for (uint32_t i = 0; i <= samples; ++i) {
            const double share = static_cast<double>(i) / samples;
            const Vec3 at = bone.from + share * (bone.to - bone.from);
            const double radius = std::lerp(bone.from_radius, bone.to_radius, share);
            const uint32_t cell = cell_at(grid, at);
            const auto way = static_cast<float>(((grid.middle_of(cell) - at).norm() - radius) / grid.cell);
            if (slice.is_over(2)) co_await pace;
            if (!grid.inside[cell] || !(way < ways[cell])) continue;
            ways[cell] = way;
            bone_of[cell] = b;
            queue.push({way, cell});
        }
    }
    while (!queue.empty()) {
        const Entry entry = queue.top();
        queue.pop();
        if (slice.is_over(26)) co_await pace;
        if (entry.way > ways[entry.cell]) continue;
        for (size_t k = 0; k < steps.cells.size(); ++k) {
            const uint32_t to = entry.cell + steps.cells[k];
            const float way = entry.way + steps.lengths[k];
            if (!grid.inside[to] || !(way < ways[to])) continue;
            ways[to] = way;
            bone_of[to] = bone_of[entry.cell];
            queue.push({way, to});
        }
    }
    ways = {};
    co_await pace;
    const Buffer<Position> normals = co_await find_vertex_normals(pace, mesh);
    Buffer<uint32_t> nearest(mesh.vertex_count(), pace.memory());
    const auto count = static_cast<uint32_t>(bones.size());
    co_await each_by_work(pace, mesh.vertex_count(), Cost::tens_of_ns, [&](uint32_t v) {
        const Vec3 at = mesh.position(v);
        const uint32_t cell = cell_of_vertex(grid, bone_of, at, load_vec3(normals[v].data()));
        if (cell != no_bone) {
            nearest[v] = bone_of[cell];
            return 8u;
        }
        uint32_t best = 0;
        for (uint32_t b = 1; b < count; ++b)
            if (distance_to(bones[b], at) < distance_to(bones[best], at)) best = b;
        nearest[v] = best;
        return 32 + count;
    });
    bone_of = {};
    co_await pace;
    co_return nearest;
}

}  // namespace flg
