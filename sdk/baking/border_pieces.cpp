// SPDX-License-Identifier: MIT
#include "baking/border_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

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
    // Offers vertices' pieces to their neighbours, about so many; returns how many, 0 once nothing is left.
    uint32_t offer(uint32_t units) {
        uint32_t offered = 0;
        while (offered < units && (vertex_ != no_index || next_vertex())) {
            const auto room = static_cast<size_t>(units - offered);
            const size_t stop = is_near_enough() ? piece_ : std::min(piece_count(), piece_ + room);
            offered += 1 + static_cast<uint32_t>(stop - piece_);
            const bool is_whole = stop == piece_ || stop == piece_count();
            for (; piece_ < stop; ++piece_) offer_piece();
            if (is_whole) next_neighbour();
        }
        return offered;
    }

private:
    bool next_vertex() {
        if (queue_.empty()) return false;
        vertex_ = queue_.pop();
        first_ = triangle_ = triangle_of(mesh_.corner_of_vertex[vertex_]);
        is_last_ = false;
        place_ = load_vec3(places_[vertex_].data());
        const auto here = borders_.at_vertex.of(vertex_);
        const auto& ends = borders_.pieces[borders_.nearest[vertex_]].ends;
        lists_ = {here.empty() ? borders_.at_vertex.of(ends[0]) : here, {}};
        if (here.empty()) lists_[1] = borders_.at_vertex.of(ends[1]);
        begin_neighbour(mesh_.triangles[triangle_][following_corner(place_in(mesh_.triangles[triangle_], vertex_))]);
        return true;
    }
    void next_neighbour() {
        if (is_last_) {
            vertex_ = no_index;
            return;
        }
        const Triple& vertices = mesh_.triangles[triangle_];
        const uint32_t previous = following_corner(following_corner(place_in(vertices, vertex_)));
        const uint32_t last = vertices[previous];
        triangle_ = mesh_.neighbours[triangle_][previous];
        is_last_ = triangle_ == first_ || triangle_ == no_index;
        if (is_last_) return begin_neighbour(last);
        const Triple& following = mesh_.triangles[triangle_];
        begin_neighbour(following[following_corner(place_in(following, vertex_))]);
    }
    void begin_neighbour(uint32_t vertex) {
        neighbour_ = vertex;
        neighbour_place_ = load_vec3(places_[vertex].data());
        piece_ = 0;
    }
    size_t piece_count() const { return lists_[0].size() + lists_[1].size(); }
    // Nearer already than any of the pieces can be.
    bool is_near_enough() const {
        const float known = distances_[neighbour_];
        return known == 0 || double{known} <= double{distances_[vertex_]} - (neighbour_place_ - place_).norm();
    }
    void offer_piece() {
        const size_t first = lists_[0].size();
        const uint32_t piece = (piece_ < first ? lists_[0][piece_] : lists_[1][piece_ - first]) / 2;
        const auto [a, b] = borders_.pieces[piece].ends;
        const auto found = static_cast<float>(
            std::sqrt(distance_sq(neighbour_place_, load_vec3(places_[a].data()), load_vec3(places_[b].data()))));
        if (found >= distances_[neighbour_]) return;
        distances_[neighbour_] = found;
        borders_.nearest[neighbour_] = piece;
        queue_.push(neighbour_);
    }

    const Mesh& mesh_;
    const Buffer<Position>& places_;
    BorderPieces& borders_;
    Buffer<float> distances_;
    VertexQueue queue_;
    // Whose pieces are offered, and to which neighbour; no_index: none's.
    uint32_t vertex_ = no_index, neighbour_ = no_index;
    Vec3 place_, neighbour_place_;
    uint32_t first_ = 0, triangle_ = 0;  // of the fan: where it began, where it is
    bool is_last_ = false;               // neighbour of the fan
    std::array<std::span<const uint32_t>, 2> lists_;
    size_t piece_ = 0;  // of the lists together
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
    Slice slice(Cost::tens_of_ns);
    while (const uint32_t offered = nearest.offer(slice.left()))
        if (slice.is_over(offered)) co_await pace;
    while (!found.empty()) {
        found.erase(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(std::min<size_t>(found.size(), 2048)));
        co_await pace;
    }
    co_return borders;
}

}  // namespace flg
