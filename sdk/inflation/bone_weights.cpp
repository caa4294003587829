// SPDX-License-Identifier: MIT
#include "inflation/bone_weights.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/failure.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t no_column = UINT32_MAX, joint_limit = 65536;
constexpr double min_edge_weight = 1e-3;
// Of the radius: bones that are so much farther than the nearest have no weight to begin with.
constexpr double soft = 0.25;
constexpr double min_radius = 0.5;  // of the lattice's spacing: bones without one
// Weights below it become 0; all others are less by it before they are made to sum to 1.
constexpr double cut_off = 0.005;
constexpr uint32_t bones_a_step = 256;
constexpr uint32_t kept = 5;  // the largest weights of each vertex: four, and what they are above

void check(const BoneSegment& bone, uint32_t number) {
    if (bone.joint >= joint_limit)
        throw Failure(FLG_ERROR_LIMIT, "weights: bone %u belongs to joint %u; there are at most %u", number, bone.joint,
                      joint_limit);
    if (!bone.from.allFinite() || !bone.to.allFinite() || !(bone.from_radius >= 0) || !(bone.to_radius >= 0) ||
        !std::isfinite(bone.from_radius + bone.to_radius))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "weights: bone %u has an end or a radius that is not finite, or below 0", number);
}

// The joints that have bones, numbered: a column of the right-hand side each.
struct Joints {
    explicit Joints(Memory* memory) : column_of(joint_limit, memory), joint_of(memory) {}

    Buffer<uint32_t> column_of;
    std::pmr::vector<uint16_t> joint_of;
};

Task<Joints> number_joints(Pace& pace, std::span<const BoneSegment> bones) {
    Joints joints(pace.memory());
    co_await each(pace, joint_limit, Cost::some_ns, [&](uint32_t j) { joints.column_of[j] = no_column; });
    co_await each(pace, bones.size(), Cost::tens_of_ns, [&](uint32_t i) {
        check(bones[i], i);
        joints.column_of[bones[i].joint] = 0;
    });
    co_await each(pace, joint_limit, Cost::some_ns, [&](uint32_t j) {
        if (joints.column_of[j] == no_column) return;
        joints.column_of[j] = static_cast<uint32_t>(joints.joint_of.size());
        joints.joint_of.push_back(static_cast<uint16_t>(j));
    });
    co_return joints;
}

// The joints of the nearest bones of a vertex.
class Nearest {
public:
    struct Near {
        uint32_t column = 0;
        double distance = 0;
        double radius = 0;
    };

    void offer(const Vec3& position, const BoneSegment& bone, uint32_t column) {
        const Vec3 along = bone.to - bone.from, from = position - bone.from;
        const double length = along.squaredNorm();
        const double share = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
        const Near near{column, (from - share * along).norm(),
                        bone.from_radius + share * (bone.to_radius - bone.from_radius)};
        const auto before = [](const Near& a, const Near& b) {
            return a.distance < b.distance || (a.distance == b.distance && a.column < b.column);
        };
        // A joint's nearest bone counts.
        uint32_t place = 0;
        while (place < count_ && near_[place].column != near.column) ++place;
        if (place < count_) {
            if (!before(near, near_[place])) return;
        } else if (count_ < near_.size()) {
            place = count_++;
        } else if (before(near, near_.back())) {
            place = count_ - 1;
        } else {
            return;
        }
        near_[place] = near;
        for (; place > 0 && before(near_[place], near_[place - 1]); --place) std::swap(near_[place], near_[place - 1]);
    }
    std::span<const Near> found() const { return {near_.data(), count_}; }

private:
    std::array<Near, 4> near_{};
    uint32_t count_ = 0;
};

struct Spreading {
    Spreading(size_t vertices, Memory* memory)
        : area(vertices, memory),
          radius_squared(vertices, memory),
          first_columns(vertices, memory),
          first_weights(vertices, memory),
          largest(vertices, memory),
          largest_joints(vertices, memory) {}

    void clear(uint32_t vertex) {
        area[vertex] = 0;
        largest[vertex].fill(0);
        largest_joints[vertex].fill(0);
    }

    // Half cotangents of a triangle.
    std::array<double, 3> measure(const MergedMesh& mesh, uint32_t triangle) {
        const TriangleVertices& t = mesh.triangles[triangle];
        const Vec3 p[3] = {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
        // Of a triangle without area the cotangents are of one with a little: what it joins stays joined.
        const double twice = std::max((p[1] - p[0]).cross(p[2] - p[0]).norm(),
                                      1e-6 * ((p[1] - p[0]).squaredNorm() + (p[2] - p[0]).squaredNorm()));
        std::array<double, 3> cotangents;
        for (uint32_t k = 0; k < 3; ++k) {
            cotangents[k] = 0.5 * (p[(k + 1) % 3] - p[k]).dot(p[(k + 2) % 3] - p[k]) / twice;
            area[t[k]] += twice / 6;
        }
        return cotangents;
    }

    // What a vertex begins with.
    void begin(uint32_t vertex, std::span<const Nearest::Near> near, double least, double reach) {
        const double radius = std::max(near[0].radius, least);
        radius_squared[vertex] = reach * reach * radius * radius;
        double weights[4] = {}, sum = 0;
        for (uint32_t k = 0; k < near.size(); ++k) {
            const double left = std::max(0.0, 1 - (near[k].distance - near[0].distance) / (soft * radius));
            sum += weights[k] = left * left;
        }
        for (uint32_t k = 0; k < 4; ++k) {
            first_columns[vertex][k] = k < near.size() ? near[k].column : no_column;
            first_weights[vertex][k] = static_cast<float>(weights[k] / sum);
        }
    }

    // Eight columns of a row, from `column` on: the areas times the weights that it begins with.
    void load(uint32_t vertex, uint32_t column, double* row) const {
        std::fill_n(row, solve_width, 0);
        for (uint32_t k = 0; k < 4; ++k) {
            const uint32_t own = first_columns[vertex][k];
            if (own != no_column && own >= column && own < column + solve_width)
                row[own - column] = area[vertex] * static_cast<double>(first_weights[vertex][k]);
        }
    }

    void collect(uint32_t vertex, const double* row, std::span<const uint16_t> joints) {
        auto& weights = largest[vertex];
        auto& weighed = largest_joints[vertex];
        for (uint32_t k = 0; k < joints.size(); ++k) {
            const auto weight = static_cast<float>(row[k]);
            if (weight <= weights[kept - 1]) continue;
            uint32_t place = kept - 1;
            for (; place > 0 && weights[place - 1] < weight; --place) {
                weights[place] = weights[place - 1];
                weighed[place] = weighed[place - 1];
            }
            weights[place] = weight;
            weighed[place] = joints[k];
        }
    }

    // All weights are less by the fifth, so that those that come in or go out do so at 0.
    void finish(uint32_t vertex, BoneWeights& out) const {
        const auto& weights = largest[vertex];
        const double least = std::max(cut_off, static_cast<double>(weights[kept - 1]));
        double left[4], sum = 0;
        for (uint32_t k = 0; k < 4; ++k) sum += left[k] = std::max(0.0, weights[k] - least);
        if (!(sum > 1e-6)) {
            // Five or more joints move it alike.
            sum = 4;
            std::fill_n(left, 4, 1.0);
        }
        for (uint32_t k = 0; k < 4; ++k) {
            const auto weight = static_cast<float>(left[k] / sum);
            out.weights[vertex][k] = weight;
            out.joints[vertex][k] = weight > 0 ? largest_joints[vertex][k] : uint16_t{0};
        }
    }

    Buffer<double> area, radius_squared;
    Buffer<std::array<uint32_t, 4>> first_columns;  // of a vertex, with the weights it begins with
    Buffer<std::array<float, 4>> first_weights;
    Buffer<std::array<float, kept>> largest;
    Buffer<std::array<uint16_t, kept>> largest_joints;
};

// Each vertex looks at the bones of its part, at all bones if the part has none.
Task<void> begin_at_nearest_bones(Pace& pace, const MergedMesh& mesh, std::span<const BoneSegment> bones,
                                  const Joints& joints, double reach, Spreading& all) {
    uint32_t parts = 0;
    for (const BoneSegment& bone : bones) parts = std::max(parts, bone.part + 1);
    const Groups of_part =
        co_await group_by(pace, bones.size(), parts, [&](uint32_t bone) { return bones[bone].part; });
    Buffer<uint32_t> all_bones(bones.size(), pace.memory());
    co_await each(pace, bones.size(), Cost::some_ns, [&](uint32_t bone) { all_bones[bone] = bone; });
    // A step is a vertex and some of the bones, as there may be many.
    const auto blocks = static_cast<uint32_t>((bones.size() + bones_a_step - 1) / bones_a_step);
    const double least = min_radius * mesh.spacing;
    Nearest nearest;
    co_await each_by_work(pace, mesh.positions.size() * blocks, Cost::tens_of_ns, [&](uint32_t step) {
        const uint32_t vertex = step / blocks, block = step % blocks, part = mesh.parts[vertex];
        std::span<const uint32_t> near(all_bones.begin(), all_bones.end());
        if (part < parts && !of_part.of(part).empty()) near = of_part.of(part);
        if (block == 0) nearest = {};
        const size_t first = std::min<size_t>(size_t{block} * bones_a_step, near.size());
        const auto some = near.subspan(first, std::min<size_t>(bones_a_step, near.size() - first));
        for (const uint32_t bone : some)
            nearest.offer(mesh.positions[vertex], bones[bone], joints.column_of[bones[bone].joint]);
        if (block + 1 == blocks) all.begin(vertex, nearest.found(), least, reach);
        return static_cast<uint32_t>(1 + some.size());
    });
}

}  // namespace

Task<BoneWeights> bone_weights(Pace& pace, const MergedMesh& mesh, std::span<const BoneSegment> bones,
                               BoneWeightOptions options) {
    pace.stage("weights");
    if (bones.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "weights: there are no bones");
    if (!(options.reach >= 0.05 && options.reach <= 2))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "weights: reach is %g; it is within 0.05 and 2", options.reach);
    Memory* memory = pace.memory();
    const auto vertices = static_cast<uint32_t>(mesh.positions.size());
    const size_t triangles = mesh.triangles.size();
    const Joints joints = co_await number_joints(pace, bones);
    Spreading all(vertices, memory);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) { all.clear(v); });
    Buffer<std::array<double, 3>> cotangents(triangles, memory);
    co_await each(pace, triangles, Cost::tens_of_ns, [&](uint32_t t) { cotangents[t] = all.measure(mesh, t); });
    co_await begin_at_nearest_bones(pace, mesh, bones, joints, options.reach, all);

    const LaplacianInput input{.triangles = {mesh.triangles.data(), triangles},
                               .cotangents = {cotangents.data(), triangles},
                               .row_count = vertices,
                               .mass = {all.area.data(), vertices},
                               .scale = {all.radius_squared.data(), vertices},
                               .min_weight = min_edge_weight};
    CholeskyFactor factor = co_await factorize_laplacian(pace, input, {mesh.positions.data(), vertices});
    cotangents = {};
    co_await pace;

    Buffer<double> values(size_t{solve_width} * vertices, memory);
    const std::span<double> rows(values.data(), values.size());
    const std::span<const uint16_t> joint_of(joints.joint_of);
    for (uint32_t column = 0; column < joint_of.size(); column += solve_width) {
        const auto some = joint_of.subspan(column, std::min<size_t>(solve_width, joint_of.size() - column));
        co_await each(pace, vertices, Cost::tens_of_ns,
                      [&](uint32_t v) { all.load(v, column, &values[size_t{solve_width} * v]); });
        co_await solve(pace, factor, rows);
        co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
            for (uint32_t k = 0; k < solve_width; ++k) values[size_t{solve_width} * v + k] *= all.area[v];
        });
        co_await solve(pace, factor, rows);
        co_await each(pace, vertices, Cost::tens_of_ns,
                      [&](uint32_t v) { all.collect(v, &values[size_t{solve_width} * v], some); });
    }
    BoneWeights weights{Buffer<std::array<uint16_t, 4>>(vertices, memory),
                        Buffer<std::array<float, 4>>(vertices, memory)};
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) { all.finish(v, weights); });
    // Large arrays are given back one by one: all at once that can take longer than a slice may.
    factor.values = {};
    co_await pace;
    factor.rows = {};
    co_await pace;
    values = {};
    co_await pace;
    co_return weights;
}

}  // namespace flg
