// SPDX-License-Identifier: MIT
#include "inflation/bone_weights.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>
#include <vector>

#include "core/failure.h"
#include "inflation/bone_regions.h"
#include "inflation/four_joints.h"
#include "inflation/pivots.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t no_column = UINT32_MAX, joint_limit = 65536;
constexpr double min_edge_weight = 1e-3;
// Of the radius: bones that are so much farther than the nearest have no weight to begin with.
constexpr double soft = 0.25;
constexpr double min_radius = 0.5;   // of the lattice's spacing: bones without one
constexpr double min_spread = 1;     // by the lattice's spacing: over some edges, however thin the shape is
constexpr double edge_share = 0.75;  // of the longest edge at a vertex: weights change by about a third along it
constexpr double pivot_share = 0.6;  // of the distance to a joint, by the reach
constexpr double fading = 0.7;       // of that distance, by the way from where regions meet
constexpr uint32_t bones_a_step = 256;

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
        uint32_t bone = 0, column = 0;
        double distance = 0;
        double radius = 0;
    };

    void offer(const Vec3& position, std::span<const BoneSegment> bones, uint32_t number, uint32_t column) {
        add(look(position, bones, number, column));
    }
    // By the distance from the shape around the bone, which is at least `least`. Returns it.
    double offer_shape(const Vec3& position, std::span<const BoneSegment> bones, uint32_t number, uint32_t column,
                       double least) {
        Near near = look(position, bones, number, column);
        near.distance = std::max(near.distance - near.radius, least);
        add(near);
        return near.distance;
    }
    std::span<const Near> found() const { return {near_.data(), count_}; }

private:
    static Near look(const Vec3& position, std::span<const BoneSegment> bones, uint32_t number, uint32_t column) {
        const BoneSegment& bone = bones[number];
        const Vec3 along = bone.to - bone.from, from = position - bone.from;
        const double length = along.squaredNorm();
        const double share = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
        return {number, column, (from - share * along).norm(),
                bone.from_radius + share * (bone.to_radius - bone.from_radius)};
    }

    void add(const Near& near) {
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

    std::array<Near, 4> near_{};
    uint32_t count_ = 0;
};

struct Spreading {
    Spreading(size_t vertices, Memory* memory)
        : area(vertices, memory),
          bone(vertices, memory),
          radius(vertices, memory),
          spread(vertices, memory),
          first_columns(vertices, memory),
          first_weights(vertices, memory),
          largest(vertices, memory) {}

    void clear(uint32_t vertex) {
        area[vertex] = 0;
        largest[vertex] = {};
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
    void begin(uint32_t vertex, std::span<const Nearest::Near> near, double least) {
        bone[vertex] = near[0].bone;
        radius[vertex] = std::max(near[0].radius, least);
        double weights[4] = {}, sum = 0;
        for (uint32_t k = 0; k < near.size(); ++k) {
            const double left = std::max(0.0, 1 - (near[k].distance - near[0].distance) / (soft * radius[vertex]));
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
                row[own - column] += area[vertex] * static_cast<double>(first_weights[vertex][k]);
        }
    }

    void collect(uint32_t vertex, const double* row, std::span<const uint16_t> joints) {
        auto& [weights, weighed] = largest[vertex];
        for (uint32_t k = 0; k < joints.size(); ++k) {
            const auto weight = static_cast<float>(row[k]);
            if (weight <= weights[ManyJoints::limit - 1]) continue;
            uint32_t place = ManyJoints::limit - 1;
            for (; place > 0 && weights[place - 1] < weight; --place) {
                weights[place] = weights[place - 1];
                weighed[place] = weighed[place - 1];
            }
            weights[place] = weight;
            weighed[place] = joints[k];
        }
    }

    Buffer<double> area;
    Buffer<uint32_t> bone;                          // that most of a vertex begins with
    Buffer<double> radius;                          // of the shape
    Buffer<double> spread;                          // T
    Buffer<std::array<uint32_t, 4>> first_columns;  // of a vertex, with the weights it begins with
    Buffer<std::array<float, 4>> first_weights;
    Buffer<ManyJoints> largest;
};

// Each vertex begins with the bones of its part; with the nearest of all in space where that has none.
Task<void> begin_within_parts(Pace& pace, const MergedMesh& mesh, std::span<const PlacedPart> parts, const BoneRig& rig,
                              const Joints& joints, Spreading& all) {
    const std::span<const BoneSegment> bones = rig.bones;
    const Groups of_part = co_await group_by(pace, bones.size(), parts.size(), [&](uint32_t bone) {
        return bones[bone].part < parts.size() ? bones[bone].part : no_key;
    });
    std::pmr::vector<BoneRegions> regions(pace.memory());
    for (uint32_t part = 0; part < parts.size(); ++part)
        regions.push_back(co_await BoneRegions::make(pace, parts[part], bones, of_part.of(part)));
    // A step is a vertex and some of the bones, as there may be many.
    const auto blocks = static_cast<uint32_t>((bones.size() + bones_a_step - 1) / bones_a_step);
    const double least_radius = min_radius * mesh.spacing;
    Nearest nearest;
    bool in_part = false;
    co_await each_by_work(pace, mesh.positions.size() * blocks, Cost::tens_of_ns, [&](uint32_t step) {
        const uint32_t vertex = step / blocks, block = step % blocks, part = mesh.parts[vertex];
        const auto offer = [&](uint32_t bone) {
            nearest.offer(mesh.positions[vertex], bones, bone, joints.column_of[bones[bone].joint]);
        };
        uint32_t work = 8;
        if (block == 0) {
            nearest = {};
            const BoneRegions::Found found = regions[part].at(mesh.positions[vertex]);
            in_part = found.count > 0;
            for (uint32_t k = 0; k < found.count; ++k) {
                offer(found.bones[k]);
                for (const uint32_t other : regions[part].next_to(found.bones[k])) offer(other);
                work += 1 + static_cast<uint32_t>(regions[part].next_to(found.bones[k]).size());
            }
        }
        if (!in_part) {
            const uint32_t begin = block * bones_a_step;
            const auto end = static_cast<uint32_t>(std::min<size_t>(begin + size_t{bones_a_step}, bones.size()));
            for (uint32_t bone = begin; bone < end; ++bone) offer(bone);
            work += end - begin;
        }
        if (block + 1 == blocks) all.begin(vertex, nearest.found(), least_radius);
        return work;
    });
    for (; !regions.empty(); regions.pop_back()) co_await pace;
}

// Each vertex begins with the bone that is nearest, as somebody else knows it, and with those that it touches.
Task<void> begin_at_bones(Pace& pace, const MergedMesh& mesh, NearestBones known, const BoneRig& rig,
                          const Joints& joints, Spreading& all) {
    const std::span<const BoneSegment> bones = rig.bones;
    const auto joint_of = [&](uint32_t end) { return end % 2 == 0 ? bones[end / 2].joint : known.ends[end / 2]; };
    const Groups ends_at = co_await group_by(pace, 2 * bones.size(), joint_limit, joint_of);
    const double least_radius = min_radius * mesh.spacing;
    co_await each_by_work(pace, mesh.positions.size(), Cost::tens_of_ns, [&](uint32_t vertex) {
        const uint32_t own = known.of_vertex[vertex];
        const Vec3& position = mesh.positions[vertex];
        const auto column_of = [&](uint32_t bone) { return joints.column_of[bones[bone].joint]; };
        Nearest nearest;
        // None is nearer than the nearest.
        const double least = nearest.offer_shape(position, bones, own, column_of(own), -HUGE_VAL);
        uint32_t work = 8;
        for (const uint32_t end : {2 * own, 2 * own + 1})
            for (const uint32_t other : ends_at.of(joint_of(end))) {
                if (other / 2 == own) continue;
                nearest.offer_shape(position, bones, other / 2, column_of(other / 2), least);
                ++work;
            }
        all.begin(vertex, nearest.found(), least_radius);
        return work;
    });
}

// T of each vertex.
Task<void> choose_spread(Pace& pace, const MergedMesh& mesh, const Groups& corners, const BoneRig& rig,
                         const Pivots& pivots, double reach, Spreading& all) {
    const size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
    Buffer<double> longest(vertices, pace.memory());
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) { all.spread[v] = longest[v] = 0; });
    struct Entry {
        double distance;
        uint32_t vertex;
        auto operator<=>(const Entry&) const = default;
    };
    // A vector that grows would be copied in one slice.
    std::priority_queue<Entry, std::pmr::deque<Entry>> queue(std::less<Entry>(), std::pmr::deque<Entry>(pace.memory()));
    const auto offer = [&](uint32_t vertex, double distance) {
        if (!(distance > all.spread[vertex])) return;
        all.spread[vertex] = distance;
        queue.push({distance, vertex});
    };
    co_await each_by_work(pace, 3 * triangles, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t v = mesh.triangles[i / 3][i % 3], w = mesh.triangles[i / 3][(i + 1) % 3];
        const uint32_t a = rig.bones[all.bone[v]].joint, b = rig.bones[all.bone[w]].joint;
        const Pivots::Between between = pivots.between(a, b, mesh.positions[v]);
        offer(v, between.farthest);
        offer(w, between.farthest);
        const double length = (mesh.positions[w] - mesh.positions[v]).norm();
        longest[v] = std::max(longest[v], length);
        longest[w] = std::max(longest[w], length);
        return 1 + between.count;
    });
    Slice slice(Cost::tens_of_ns);
    while (!queue.empty()) {
        const auto [distance, from] = queue.top();
        queue.pop();
        if (slice.is_over(4)) co_await pace;
        if (distance < all.spread[from]) continue;
        for (const uint32_t corner : corners.of(from)) {
            const uint32_t to = mesh.triangles[corner / 3][(corner + 1) % 3];
            offer(to, distance - fading * (mesh.positions[to] - mesh.positions[from]).norm());
        }
    }
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
        const double length = std::max({reach * all.radius[v], reach * pivot_share * all.spread[v],
                                        min_spread * mesh.spacing, edge_share * longest[v]});
        all.spread[v] = length * length;
    });
}

// begin(joints, spreading) is the task that says what each vertex begins with.
template <class Begin>
Task<ManyWeights> weigh(Pace& pace, const MergedMesh& mesh, BoneRig rig, BoneWeightOptions options, Begin begin) {
    pace.stage("weights");
    if (rig.bones.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "weights: there are no bones");
    if (!(options.reach >= 0.05 && options.reach <= 2))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "weights: reach is %g; it is within 0.05 and 2", options.reach);
    Memory* memory = pace.memory();
    const auto vertices = static_cast<uint32_t>(mesh.positions.size());
    const size_t triangles = mesh.triangles.size();
    const Joints joints = co_await number_joints(pace, rig.bones);
    Spreading all(vertices, memory);
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) { all.clear(v); });
    Buffer<std::array<double, 3>> cotangents(triangles, memory);
    co_await each(pace, triangles, Cost::tens_of_ns, [&](uint32_t t) { cotangents[t] = all.measure(mesh, t); });
    co_await begin(joints, all);
    const Pivots pivots = co_await Pivots::make(pace, rig);
    const Groups corners =
        co_await group_by(pace, 3 * triangles, vertices, [&](uint32_t i) { return mesh.triangles[i / 3][i % 3]; });
    co_await choose_spread(pace, mesh, corners, rig, pivots, options.reach, all);

    const LaplacianInput input{.triangles = {mesh.triangles.data(), triangles},
                               .cotangents = {cotangents.data(), triangles},
                               .row_count = vertices,
                               .mass = {all.area.data(), vertices},
                               .scale = {all.spread.data(), vertices},
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
    // Large arrays are given back one by one: all at once that can take longer than a slice may.
    factor.values = {};
    co_await pace;
    factor.rows = {};
    co_await pace;
    values = {};
    co_await pace;
    co_return ManyWeights{std::move(all.largest), std::move(all.spread)};
}

}  // namespace

Task<ManyWeights> many_weights(Pace& pace, const MergedMesh& mesh, std::span<const PlacedPart> parts, BoneRig rig,
                               BoneWeightOptions options) {
    co_return co_await weigh(pace, mesh, rig, options, [&](const Joints& joints, Spreading& all) {
        return begin_within_parts(pace, mesh, parts, rig, joints, all);
    });
}

Task<BoneWeights> bone_weights(Pace& pace, const MergedMesh& mesh, std::span<const PlacedPart> parts, BoneRig rig,
                               BoneWeightOptions options) {
    const ManyWeights many = co_await many_weights(pace, mesh, parts, rig, options);
    co_return co_await keep_four_joints(pace, mesh, many, rig);
}

Task<BoneWeights> bone_weights(Pace& pace, const MergedMesh& mesh, NearestBones nearest, BoneRig rig,
                               BoneWeightOptions options) {
    const ManyWeights many = co_await weigh(pace, mesh, rig, options, [&](const Joints& joints, Spreading& all) {
        return begin_at_bones(pace, mesh, nearest, rig, joints, all);
    });
    co_return co_await keep_four_joints(pace, mesh, many, rig);
}

void mix_weights(ManyJoints& a, const ManyJoints& b, double share) {
    struct Bound {
        float weight = 0;
        uint16_t joint = 0;
        bool operator<(const Bound& other) const {
            return weight != other.weight ? weight > other.weight : joint < other.joint;
        }
    };
    std::array<Bound, 2 * ManyJoints::limit> bound;
    uint32_t count = 0;
    const auto add = [&](uint16_t joint, double weight) {
        if (!(weight > 0)) return;
        uint32_t at = 0;
        while (at < count && bound[at].joint != joint) ++at;
        if (at == count) bound[count++].joint = joint;
        bound[at].weight += static_cast<float>(weight);
    };
    for (uint32_t k = 0; k < ManyJoints::limit; ++k) add(a.joints[k], (1 - share) * static_cast<double>(a.weights[k]));
    for (uint32_t k = 0; k < ManyJoints::limit; ++k) add(b.joints[k], share * static_cast<double>(b.weights[k]));
    std::sort(bound.begin(), bound.begin() + count);
    for (uint32_t k = 0; k < ManyJoints::limit; ++k) {
        a.weights[k] = bound[k].weight;
        a.joints[k] = bound[k].joint;
    }
}

void mix_weights(VertexJoints& joints_a, VertexWeights& a, const VertexJoints& joints_b, const VertexWeights& b,
                 double share) {
    struct Bound {
        uint16_t joint;
        double weight;
    };
    std::array<Bound, 8> bound{};
    uint32_t count = 0;
    const auto add = [&](uint16_t joint, double weight) {
        if (!(weight > 0)) return;
        for (uint32_t i = 0; i < count; ++i)
            if (bound[i].joint == joint) {
                bound[i].weight += weight;
                return;
            }
        bound[count++] = {joint, weight};
    };
    for (uint32_t k = 0; k < 4; ++k) add(joints_a[k], (1 - share) * static_cast<double>(a[k]));
    for (uint32_t k = 0; k < 4; ++k) add(joints_b[k], share * static_cast<double>(b[k]));
    const auto before = [](const Bound& x, const Bound& y) {
        return x.weight > y.weight || (x.weight == y.weight && x.joint < y.joint);
    };
    for (uint32_t k = 0; k < std::min(count, 5u); ++k)
        std::swap(bound[k], *std::min_element(bound.begin() + k, bound.begin() + count, before));
    // Those above the fifth stay, by what they are above it: else a weight would jump where it is another's turn.
    const double least = count > 4 && bound[4].weight < bound[0].weight ? bound[4].weight : 0;
    for (uint32_t k = 0; k < std::min(count, 4u); ++k) bound[k].weight -= least;
    double sum = 0;
    for (uint32_t k = 0; k < std::min(count, 4u); ++k) sum += bound[k].weight;
    for (uint32_t k = 0; k < 4; ++k) {
        a[k] = k < count ? static_cast<float>(bound[k].weight / sum) : 0;
        joints_a[k] = a[k] > 0 ? bound[k].joint : uint16_t{0};
    }
}

}  // namespace flg
