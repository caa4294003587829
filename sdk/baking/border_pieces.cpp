// SPDX-License-Identifier: MIT
#include "baking/border_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surfaces/mesh/fan_walk.h"

namespace flg {

namespace {

// The vertices whose neighbours are still to be offered something; each is in it at most once.
class VertexQueue {
public:
    VertexQueue(uint32_t vertices, Memory* memory) : ring_(vertices, memory), waits_(vertices, memory) {}

    void clear(uint32_t vertex) { waits_[vertex] = 0; }
    void push(uint32_t vertex) {
        if (waits_[vertex]) return;
        waits_[vertex] = 1;
        ring_[(first_ + count_++) % ring_.size()] = vertex;
    }
    uint32_t pop() {
        const uint32_t vertex = ring_[first_];
        first_ = (first_ + 1) % ring_.size();
        --count_;
        waits_[vertex] = 0;
        return vertex;
    }
    bool empty() const { return count_ == 0; }

private:
    Buffer<uint32_t> ring_;
    Buffer<uint8_t> waits_;
    size_t first_ = 0, count_ = 0;
};

double distance_sq(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double length_sq = along.squaredNorm();
    const double t = length_sq > 0 ? std::clamp((p - a).dot(along) / length_sq, 0.0, 1.0) : 0;
    return (p - a - t * along).squaredNorm();
}

class NearestPieces {
public:
    NearestPieces(const Mesh& mesh, const Buffer<Position>& places, BorderPieces& borders, Memory* memory)
        : mesh_(mesh),
          places_(places),
          borders_(borders),
          distances_(mesh.vertex_count(), memory),
          queue_(mesh.vertex_count(), memory) {}

    void clear(uint32_t v) {
        queue_.clear(v);
        const auto here = borders_.at_vertex.of(v);
        borders_.nearest[v] = here.empty() ? no_index : here.front() / 2;
        distances_[v] = here.empty() ? std::numeric_limits<float>::infinity() : 0.0f;
    }
    void begin(uint32_t v) {
        if (distances_[v] == 0) queue_.push(v);
    }
    bool at_end() const { return queue_.empty(); }
    // Offers a vertex's pieces to its neighbours; returns how many it offered.
    uint32_t offer() {
        const uint32_t v = queue_.pop();
        uint32_t offered = 0;
        visit_fan(mesh_, v, [&](uint32_t neighbour, Corner) {
            ++offered;
            const Vec3 place = load_vec3(places_[neighbour].data());
            // What is nearer already than any of them can be.
            const double way = (place - load_vec3(places_[v].data())).norm();
            if (double{distances_[neighbour]} <= double{distances_[v]} - way) return;
            borders_.visit_near(v, [&](uint32_t piece) {
                ++offered;
                const auto [a, b] = borders_.pieces[piece].ends;
                const auto found = static_cast<float>(
                    std::sqrt(distance_sq(place, load_vec3(places_[a].data()), load_vec3(places_[b].data()))));
                if (found >= distances_[neighbour]) return;
                distances_[neighbour] = found;
                borders_.nearest[neighbour] = piece;
                queue_.push(neighbour);
            });
        });
        return offered;
    }

private:
    const Mesh& mesh_;
    const Buffer<Position>& places_;
    BorderPieces& borders_;
    Buffer<float> distances_;
    VertexQueue queue_;
};

}  // namespace

Task<BorderPieces> find_border_pieces(Pace& pace, const Mesh& mesh, const RegionTree& tree,
                                      const Buffer<Position>& places) {
    std::pmr::deque<BorderPiece> found(pace.memory());
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        for (Corner edge = 3 * t; edge < 3 * t + 3; ++edge) {
            const uint32_t across = mesh.neighbour_at(edge);
            if (across == no_index || across < t) continue;
            const uint32_t here = mesh.regions[t], there = mesh.regions[across];
            if (here == there || tree[here].look == tree[there].look) continue;
            found.push_back({{mesh.vertex_at(edge), mesh.vertex_at(next_corner(edge))}, {here, there}});
        }
    });
    BorderPieces borders;
    borders.pieces = Buffer<BorderPiece>(found.size(), pace.memory());
    co_await each(pace, found.size(), Cost::some_ns, [&](uint32_t i) { borders.pieces[i] = found[i]; });
    borders.at_vertex = co_await group_by(pace, 2 * borders.pieces.size(), mesh.vertex_count(),
                                          [&](uint32_t i) { return borders.pieces[i / 2].ends[i % 2]; });
    borders.nearest = Buffer<uint32_t>(mesh.vertex_count(), pace.memory());
    NearestPieces nearest(mesh, places, borders, pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) { nearest.clear(v); });
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) { nearest.begin(v); });
    for (Slice slice(Cost::tens_of_ns); !nearest.at_end();)
        if (slice.is_over(nearest.offer())) co_await pace;
    co_return borders;
}

}  // namespace flg
