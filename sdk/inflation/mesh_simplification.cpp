// SPDX-License-Identifier: MIT
#include "inflation/mesh_simplification.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t none = UINT32_MAX;
constexpr uint32_t max_ring = 24;        // neighbours of a vertex that collapses make
constexpr double towards_middle = 1e-3;  // by the quadric's size: where it says nothing, new vertices are in between
constexpr double max_away = 1;           // of a new vertex from the edge's middle, by its length
constexpr double border_hold = 10;       // of borders, by that of the surface
constexpr double weight_hold = 0.02;     // by the change of weights along an edge, squared, and its length^4
constexpr double length_hold = 1e-4;     // by an edge's length^4
constexpr double min_turn = 0.2;         // cosine: how far triangles may turn at once
constexpr double min_breadth = 0.08;     // of a triangle's height by its longest side

// The sum of squared distances to planes, by area.
struct Quadric {
    void add(const Vec3& normal, const Vec3& at, double area) {
        a += area * normal * normal.transpose();
        const double offset = -normal.dot(at);
        b += area * offset * normal;
        c += area * offset * offset;
    }
    void add(const Quadric& other) {
        a += other.a;
        b += other.b;
        c += other.c;
    }
    double at(const Vec3& p) const { return std::max(0.0, p.dot(a * p) + 2 * b.dot(p) + c); }

    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Vec3 b = Vec3::Zero();
    double c = 0;
};

// How a vertex may move: anywhere, along the border it is on, or not at all.
enum class Hold : uint8_t { free, border, fixed };

struct Collapse {
    double cost = HUGE_VAL;
    uint32_t into = none;
};

// Vertices by the cost of their cheapest collapse.
class CollapseQueue {
public:
    CollapseQueue(uint32_t vertices, Memory* memory)
        : heap_(vertices, memory), place_(vertices, memory), collapse_(vertices, memory), size_(vertices) {}

    void begin(uint32_t vertex, const Collapse& collapse) {
        heap_[vertex] = place_[vertex] = vertex;
        collapse_[vertex] = collapse;
    }
    // From the last parent to the first.
    void order(uint32_t parent) { sink(parent); }
    uint32_t first() const { return heap_[0]; }
    const Collapse& of(uint32_t vertex) const { return collapse_[vertex]; }
    void change(uint32_t vertex, const Collapse& collapse) {
        collapse_[vertex] = collapse;
        rise(place_[vertex]);
        sink(place_[vertex]);
    }
    void remove(uint32_t vertex) {
        const uint32_t place = place_[vertex];
        swap(place, --size_);
        if (place == size_) return;
        rise(place);
        sink(place);
    }

private:
    bool before(uint32_t a, uint32_t b) const {
        const double first = collapse_[heap_[a]].cost, second = collapse_[heap_[b]].cost;
        return first < second || (first == second && heap_[a] < heap_[b]);
    }
    void swap(uint32_t a, uint32_t b) {
        std::swap(heap_[a], heap_[b]);
        place_[heap_[a]] = a;
        place_[heap_[b]] = b;
    }
    void rise(uint32_t at) {
        for (; at > 0 && before(at, (at - 1) / 2); at = (at - 1) / 2) swap(at, (at - 1) / 2);
    }
    void sink(uint32_t at) {
        for (;;) {
            uint32_t least = at;
            for (uint32_t child = 2 * at + 1; child <= 2 * at + 2; ++child)
                if (child < size_ && before(child, least)) least = child;
            if (least == at) return;
            swap(at, least);
            at = least;
        }
    }

    Buffer<uint32_t> heap_, place_;
    Buffer<Collapse> collapse_;
    uint32_t size_;
};

using Joints = VertexJoints;
using Weights = VertexWeights;

// Half the squared difference: 1 between vertices that move with other joints.
double change_of_weights(const Joints& joints_a, const Weights& a, const Joints& joints_b, const Weights& b) {
    double sum = 0;
    for (uint32_t i = 0; i < 4; ++i) {
        double other = 0;
        for (uint32_t k = 0; k < 4; ++k)
            if (joints_b[k] == joints_a[i] && b[k] > 0) other = static_cast<double>(b[k]);
        if (a[i] > 0) sum += (static_cast<double>(a[i]) - other) * (static_cast<double>(a[i]) - other);
    }
    for (uint32_t k = 0; k < 4; ++k) {
        bool known = !(b[k] > 0);
        for (uint32_t i = 0; i < 4; ++i) known = known || (joints_a[i] == joints_b[k] && a[i] > 0);
        if (!known) sum += static_cast<double>(b[k]) * static_cast<double>(b[k]);
    }
    return sum / 2;
}

class Simplification {
public:
    Simplification(const MergedMesh& mesh, const BoneWeights& weights, Memory* memory)
        : weighed_(!weights.weights.empty()),
          position_(mesh.positions.size(), memory),
          normal_(mesh.positions.size(), memory),
          quadric_(mesh.positions.size(), memory),
          hold_(mesh.positions.size(), memory),
          joints_(weights.joints.size(), memory),
          weight_(weights.weights.size(), memory),
          first_(mesh.positions.size(), memory),
          next_(3 * mesh.triangles.size(), memory),
          triangles_(mesh.triangles.size(), memory),
          part_(mesh.triangles.size(), memory),
          queue_(static_cast<uint32_t>(mesh.positions.size()), memory),
          middle_(mesh.positions[0]),
          left_(static_cast<uint32_t>(mesh.positions.size())) {}

    void begin_vertex(const MergedMesh& mesh, const BoneWeights& weights, uint32_t v) {
        std::construct_at(&position_[v], mesh.positions[v] - middle_);
        std::construct_at(&normal_[v], mesh.normals[v]);
        std::construct_at(&quadric_[v]);
        hold_[v] = mesh.is_fixed[v] ? Hold::fixed : Hold::free;
        first_[v] = none;
        if (!weighed_) return;
        joints_[v] = weights.joints[v];
        weight_[v] = weights.weights[v];
    }

    void begin_triangle(const MergedMesh& mesh, uint32_t t) {
        triangles_[t] = mesh.triangles[t];
        part_[t] = mesh.triangle_parts[t];
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 across = (position_[b] - position_[a]).cross(position_[c] - position_[a]);
        const double twice = across.norm();
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t v = triangles_[t][k];
            next_[3 * t + k] = first_[v];
            first_[v] = 3 * t + k;
            if (twice > 0) quadric_[v].add(across / twice, position_[a], twice / 6);
        }
    }

    // Borders hold their vertices.
    void begin_border(uint32_t v) {
        gather(v, ring_);
        uint32_t borders = 0;
        for (uint32_t i = 0; i < ring_.count; ++i) borders += is_border(ring_, i);
        if (borders != 0 && borders != 2) hold_[v] = Hold::fixed;
        if (borders == 2 && hold_[v] == Hold::free) hold_[v] = Hold::border;
        for (uint32_t i = 0; i < ring_.count && borders != 0; ++i) {
            if (!is_border(ring_, i)) continue;
            const Vec3 along = position_[ring_.at[i]] - position_[v];
            const Vec3 side = along.cross(normal_[v]);
            if (side.norm() > 0)
                quadric_[v].add(side.normalized(), position_[v], border_hold * along.squaredNorm() / 2);
        }
    }

    void begin_collapse(uint32_t v) { queue_.begin(v, best(v)); }
    void order(uint32_t parent) { queue_.order(parent); }

    // The next collapse; false: none is left that may be done.
    bool step() {
        const uint32_t from = queue_.first();
        const Collapse next = queue_.of(from);
        if (next.into == none) return false;
        if (const Vec3 at = place(from, next.into); may_collapse(from, next.into, at)) {
            collapse(from, next.into, at);
        } else {
            queue_.change(from, best_allowed(from));
        }
        return true;
    }

    uint32_t left() const { return left_; }
    bool is_there(uint32_t v) const { return first_[v] != none; }
    uint32_t triangle_count() const { return static_cast<uint32_t>(triangles_.size()) - 2 * removed_; }
    Vec3 position(uint32_t v) const { return position_[v] + middle_; }
    Vec3 normal(uint32_t v) const { return normal_[v]; }
    bool is_fixed(uint32_t v) const { return hold_[v] == Hold::fixed; }
    const Joints& joints(uint32_t v) const { return joints_[v]; }
    const Weights& weights(uint32_t v) const { return weight_[v]; }
    bool is_triangle(uint32_t t) const { return triangles_[t][0] != none; }
    const TriangleVertices& triangle(uint32_t t) const { return triangles_[t]; }
    uint32_t part(uint32_t t) const { return part_[t]; }

private:
    // The neighbours of a vertex, with the parts of the triangles on both sides of the edge to each.
    struct Ring {
        static constexpr uint32_t capacity = 64;
        uint32_t index(uint32_t v) {
            uint32_t i = 0;
            while (i < count && at[i] != v) ++i;
            if (i == count && count < capacity) at[count++] = v;
            return std::min(i, capacity - 1);
        }
        bool has(uint32_t v) const { return std::find(at.begin(), at.begin() + count, v) != at.begin() + count; }

        std::array<uint32_t, capacity> at, left, right;
        uint32_t count = 0;
    };

    void gather(uint32_t v, Ring& ring) const {
        ring.count = 0;
        for (uint32_t corner = first_[v]; corner != none; corner = next_[corner]) {
            const TriangleVertices& t = triangles_[corner / 3];
            const uint32_t k = corner % 3;
            ring.left[ring.index(t[(k + 1) % 3])] = part_[corner / 3];
            ring.right[ring.index(t[(k + 2) % 3])] = part_[corner / 3];
        }
    }
    static bool is_border(const Ring& ring, uint32_t i) { return ring.left[i] != ring.right[i]; }

    // Whether holds allow an edge to collapse; borders do so along themselves.
    bool may_move(uint32_t a, uint32_t b, bool is_border) const {
        if (hold_[a] == Hold::fixed && hold_[b] == Hold::fixed) return false;
        return hold_[a] == Hold::free || hold_[b] == Hold::free || is_border;
    }

    // Where the vertex that an edge becomes is best.
    Vec3 place(uint32_t a, uint32_t b) const {
        if (hold_[a] != hold_[b]) return hold_[a] > hold_[b] ? position_[a] : position_[b];
        const Vec3 &p = position_[a], &q = position_[b], along = q - p;
        Vec3 half = (p + q) / 2;
        Quadric sum = quadric_[a];
        sum.add(quadric_[b]);
        if (hold_[a] == Hold::border) {
            const double steep = along.dot(sum.a * along), slope = along.dot(sum.a * half + sum.b);
            const double share = steep > 0 ? std::clamp(-slope / steep, -0.5, 0.5) : 0;
            return half + share * along;
        }
        const double size = towards_middle * sum.a.trace();
        if (!(size > 0)) return half;
        const Eigen::Matrix3d a_held = sum.a + size * Eigen::Matrix3d::Identity();
        const Vec3 best = a_held.inverse() * (size * half - sum.b);
        return (best - half).squaredNorm() <= max_away * max_away * along.squaredNorm() ? best : half;
    }

    double cost(uint32_t a, uint32_t b) const {
        const Vec3 at = place(a, b);
        const double squared = (position_[a] - position_[b]).squaredNorm();
        double hold = length_hold;
        if (weighed_) hold += weight_hold * change_of_weights(joints_[a], weight_[a], joints_[b], weight_[b]);
        return quadric_[a].at(at) + quadric_[b].at(at) + hold * squared * squared;
    }

    // Into a vertex of a lower number: so each edge is looked at once.
    Collapse best(uint32_t v) {
        gather(v, ring_);
        Collapse least;
        for (uint32_t i = 0; i < ring_.count; ++i) {
            const uint32_t into = ring_.at[i];
            if (into > v || !may_move(v, into, is_border(ring_, i))) continue;
            const double own = cost(v, into);
            if (own < least.cost || (own == least.cost && into < least.into)) least = {own, into};
        }
        return least;
    }

    Collapse best_allowed(uint32_t v) {
        gather(v, ring_);
        std::array<Collapse, Ring::capacity> all;
        uint32_t count = 0;
        for (uint32_t i = 0; i < ring_.count; ++i) {
            const uint32_t into = ring_.at[i];
            if (into < v && may_move(v, into, is_border(ring_, i))) all[count++] = {cost(v, into), into};
        }
        std::sort(all.begin(), all.begin() + count, [](const Collapse& a, const Collapse& b) {
            return a.cost < b.cost || (a.cost == b.cost && a.into < b.into);
        });
        for (uint32_t i = 0; i < count; ++i)
            if (may_collapse(v, all[i].into, place(v, all[i].into))) return all[i];
        return {};
    }

    bool may_collapse(uint32_t a, uint32_t b, const Vec3& at) {
        gather(a, ring_);
        gather(b, other_);
        const uint32_t made = ring_.count + other_.count - 4;
        if (made < 3 || made > max_ring || ring_.count == Ring::capacity) return false;
        uint32_t common = 0;
        for (uint32_t i = 0; i < ring_.count; ++i) {
            if (!other_.has(ring_.at[i])) continue;
            ++common;
            // Both other sides of a triangle that goes are borders: the border would end there.
            if (is_border(ring_, i) && is_border(other_, other_.index(ring_.at[i]))) return false;
        }
        return common == 2 && keeps_turned(a, b, at) && keeps_turned(b, a, at);
    }

    // Whether the triangles of `v` but for those at `other` stay triangles that face the same way when it moves.
    bool keeps_turned(uint32_t v, uint32_t other, const Vec3& at) const {
        for (uint32_t corner = first_[v]; corner != none; corner = next_[corner]) {
            const TriangleVertices& t = triangles_[corner / 3];
            const uint32_t b = t[(corner % 3 + 1) % 3], c = t[(corner % 3 + 2) % 3];
            if (b == other || c == other) continue;
            const Vec3 &pb = position_[b], &pc = position_[c];
            const Vec3 before = (pb - position_[v]).cross(pc - position_[v]), after = (pb - at).cross(pc - at);
            const double size = after.norm();
            if (!(after.dot(before) > min_turn * size * before.norm())) return false;
            const double longest =
                std::max({(pb - at).squaredNorm(), (pc - at).squaredNorm(), (pb - pc).squaredNorm()});
            if (size < min_breadth * longest && size < before.norm()) return false;
        }
        return true;
    }

    void collapse(uint32_t gone, uint32_t kept, const Vec3& at) {
        const Vec3 along = position_[gone] - position_[kept];
        const double length = along.squaredNorm();
        const double share = length > 0 ? std::clamp(along.dot(at - position_[kept]) / length, 0.0, 1.0) : 0.5;
        if (weighed_) mix_weights(joints_[kept], weight_[kept], joints_[gone], weight_[gone], share);
        const Vec3 normal = (1 - share) * normal_[kept] + share * normal_[gone];
        if (normal.norm() > 0) normal_[kept] = normal.normalized();
        position_[kept] = at;
        quadric_[kept].add(quadric_[gone]);
        hold_[kept] = std::max(hold_[kept], hold_[gone]);
        // Two triangles go; the others of the vertex that goes are the other's.
        for (uint32_t corner = first_[gone], after; corner != none; corner = after) {
            after = next_[corner];
            TriangleVertices& t = triangles_[corner / 3];
            if (t[0] == kept || t[1] == kept || t[2] == kept) {
                for (uint32_t k = 0; k < 3; ++k)
                    if (t[k] != gone) unlink(t[k], 3 * (corner / 3) + k);
                t = {none, none, none};
                continue;
            }
            t[corner % 3] = kept;
            next_[corner] = first_[kept];
            first_[kept] = corner;
        }
        first_[gone] = none;
        queue_.remove(gone);
        --left_;
        ++removed_;
        gather(kept, kept_ring_);
        queue_.change(kept, best(kept));
        for (uint32_t i = 0; i < kept_ring_.count; ++i)
            if (kept_ring_.at[i] > kept) queue_.change(kept_ring_.at[i], best(kept_ring_.at[i]));
    }

    void unlink(uint32_t v, uint32_t corner) {
        uint32_t* link = &first_[v];
        while (*link != corner) link = &next_[*link];
        *link = next_[corner];
    }

    bool weighed_;
    Buffer<Vec3> position_, normal_;  // positions from the middle: quadrics square them
    Buffer<Quadric> quadric_;
    Buffer<Hold> hold_;
    Buffer<Joints> joints_;
    Buffer<Weights> weight_;
    Buffer<uint32_t> first_, next_;  // the corners of a vertex
    Buffer<TriangleVertices> triangles_;
    Buffer<uint32_t> part_;
    CollapseQueue queue_;
    Vec3 middle_;
    Ring ring_, other_, kept_ring_;
    uint32_t left_, removed_ = 0;
};

}  // namespace

Task<SimplifiedMesh> simplify_mesh(Pace& pace, const MergedMesh& mesh, const BoneWeights& weights, uint32_t vertices) {
    pace.stage("simplify");
    Memory* memory = pace.memory();
    const auto all = static_cast<uint32_t>(mesh.positions.size());
    const auto faces = static_cast<uint32_t>(mesh.triangles.size());
    Simplification work(mesh, weights, memory);
    co_await each(pace, all, Cost::tens_of_ns, [&](uint32_t v) { work.begin_vertex(mesh, weights, v); });
    co_await each(pace, faces, Cost::tens_of_ns, [&](uint32_t t) { work.begin_triangle(mesh, t); });
    co_await each(pace, all, Cost::hundreds_of_ns, [&](uint32_t v) { work.begin_border(v); });
    co_await each(pace, all, Cost::microseconds, [&](uint32_t v) { work.begin_collapse(v); });
    co_await each(pace, all / 2, Cost::tens_of_ns, [&](uint32_t i) { work.order(all / 2 - 1 - i); });
    while (work.left() > vertices && work.step()) co_await pace;

    const uint32_t left = work.left(), left_faces = work.triangle_count();
    SimplifiedMesh out{{.positions = Buffer<Vec3>(left, memory),
                        .normals = Buffer<Vec3>(left, memory),
                        .triangles = Buffer<TriangleVertices>(left_faces, memory),
                        .parts = Buffer<uint32_t>(left, memory),
                        .triangle_parts = Buffer<uint32_t>(left_faces, memory),
                        .is_fixed = Buffer<uint8_t>(left, memory),
                        .spacing = mesh.spacing * std::sqrt(static_cast<double>(all) / left),
                        .even_vertices = left},
                       {Buffer<std::array<uint16_t, 4>>(weights.joints.empty() ? 0 : left, memory),
                        Buffer<std::array<float, 4>>(weights.weights.empty() ? 0 : left, memory)}};
    Buffer<uint32_t> number(all, memory);
    uint32_t count = 0;
    co_await each(pace, all, Cost::tens_of_ns, [&](uint32_t v) {
        if (!work.is_there(v)) return;
        number[v] = count;
        std::construct_at(&out.mesh.positions[count], work.position(v));
        std::construct_at(&out.mesh.normals[count], work.normal(v));
        out.mesh.parts[count] = mesh.parts[v];
        out.mesh.is_fixed[count] = work.is_fixed(v);
        if (!weights.weights.empty()) {
            out.weights.joints[count] = work.joints(v);
            out.weights.weights[count] = work.weights(v);
        }
        ++count;
    });
    count = 0;
    co_await each(pace, faces, Cost::tens_of_ns, [&](uint32_t t) {
        if (!work.is_triangle(t)) return;
        const TriangleVertices& from = work.triangle(t);
        out.mesh.triangles[count] = {number[from[0]], number[from[1]], number[from[2]]};
        out.mesh.triangle_parts[count++] = work.part(t);
    });
    co_return out;
}

}  // namespace flg
