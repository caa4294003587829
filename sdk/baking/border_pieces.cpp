// SPDX-License-Identifier: MIT
#include "baking/border_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/growing_list.h"
#include "surfaces/mesh/fan_walk.h"

namespace flg {

namespace {

// The vertices whose neighbours are still to be offered something; each is in it at most once. They wait by blocks of
// their numbers: a block's go on among themselves while a core's cache holds them.
class VertexQueue {
public:
    VertexQueue(uint32_t vertices, Memory* memory)
        : next_(vertices, memory), blocks_((size_t{vertices} + block_size - 1) / block_size, memory) {}

    void clear(uint32_t vertex) {
        next_[vertex] = no_index;
        blocks_[vertex / block_size] = {no_index, no_index};
    }
    void push(uint32_t vertex) {
        if (next_[vertex] != no_index) return;
        next_[vertex] = vertex;
        Block& block = blocks_[vertex / block_size];
        if (block.first == no_index) {
            block.first = vertex;
        } else {
            next_[block.last] = vertex;
        }
        block.last = vertex;
        ++count_;
    }
    uint32_t pop() {
        while (blocks_[block_].first == no_index) block_ = block_ + 1 < blocks_.size() ? block_ + 1 : 0;
        Block& block = blocks_[block_];
        const uint32_t vertex = block.first;
        block.first = vertex == block.last ? no_index : next_[vertex];
        next_[vertex] = no_index;
        --count_;
        return vertex;
    }
    bool empty() const { return count_ == 0; }

private:
    static constexpr uint32_t block_size = 4096;
    struct Block {
        uint32_t first, last;  // first is no_index: none waits
    };

    Buffer<uint32_t> next_;  // of those that wait; the last one's is itself. no_index: does not wait
    Buffer<Block> blocks_;
    size_t block_ = 0;
    uint32_t count_ = 0;
};

double distance_sq(const Vec3& p, const BorderPiece& piece) {
    const Vec3 off = p - load_vec3(piece.from.data()), along = load_vec3(piece.along.data());
    const double share = std::clamp(off.dot(along) * piece.inverse_length_sq, 0.0, 1.0);
    return (off - share * along).squaredNorm();
}

// From the corner of an edge to the next one.
BorderPiece piece_at(const Mesh& mesh, const Buffer<Position>& places, Corner edge) {
    const uint32_t from = mesh.vertex_at(edge), to = mesh.vertex_at(next_corner(edge));
    const Vec3 along = load_vec3(places[to].data()) - load_vec3(places[from].data());
    const double length_sq = along.squaredNorm();
    BorderPiece piece = {{from, to},
                         {mesh.regions[triangle_of(edge)], mesh.regions[mesh.neighbour_at(edge)]},
                         places[from],
                         {},
                         length_sq > 0 ? 1 / length_sq : 0.0};
    store_vec3(along, piece.along.data());
    return piece;
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
    // Offers vertices' pieces to themselves, until they have the nearest of these, and to their neighbours: about so
    // many; returns how many, 0 once nothing is left.
    uint32_t offer(uint32_t units) {
        uint32_t offered = 0;
        while (offered < units && (vertex_ != no_index || next_vertex())) {
            const auto room = static_cast<size_t>(units - offered);
            const size_t stop = is_near_enough() ? piece_ : std::min(piece_count(), piece_ + room);
            offered += 1 + static_cast<uint32_t>(stop - piece_);
            const bool is_whole = stop == piece_ || stop == piece_count();
            for (; piece_ < stop; ++piece_) offer_piece();
            if (!is_whole) continue;
            if (neighbour_ != vertex_) {
                next_neighbour();
            } else if (borders_.nearest[vertex_] != offered_) {
                begin_vertex();
            } else {
                begin_fan();
            }
        }
        return offered;
    }

    // Its arrays, one at a time.
    static Task<void> give_back(Pace& pace, NearestPieces& nearest) {
        nearest.distances_ = {};
        co_await pace;
        nearest.queue_ = VertexQueue(0, pace.memory());
        co_await pace;
    }

private:
    bool next_vertex() {
        if (queue_.empty()) return false;
        vertex_ = queue_.pop();
        place_ = load_vec3(places_[vertex_].data());
        begin_vertex();
        return true;
    }
    void begin_vertex() {
        offered_ = borders_.nearest[vertex_];
        const auto here = borders_.at_vertex.of(vertex_);
        const auto& ends = borders_.pieces[offered_].ends;
        lists_ = {here.empty() ? borders_.at_vertex.of(ends[0]) : here, {}};
        if (here.empty()) lists_[1] = borders_.at_vertex.of(ends[1]);
        begin_neighbour(vertex_);
    }
    void begin_fan() {
        first_ = triangle_ = triangle_of(mesh_.corner_of_vertex[vertex_]);
        is_last_ = false;
        begin_neighbour(mesh_.triangles[triangle_][following_corner(place_in(mesh_.triangles[triangle_], vertex_))]);
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
    // Nearer already than any of the pieces can be, or that has offered itself the same ones, or will.
    bool is_near_enough() const {
        const float known = distances_[neighbour_];
        if (known == 0) return true;
        if (neighbour_ == vertex_) return false;
        return borders_.nearest[neighbour_] == offered_ ||
               double{known} <= double{distances_[vertex_]} - (neighbour_place_ - place_).norm();
    }
    void offer_piece() {
        const size_t first = lists_[0].size();
        const uint32_t piece = (piece_ < first ? lists_[0][piece_] : lists_[1][piece_ - first]) / 2;
        if (piece == borders_.nearest[neighbour_]) return;
        const double found_sq = distance_sq(neighbour_place_, borders_.pieces[piece]);
        const double known = double{distances_[neighbour_]};
        if (found_sq >= known * known) return;
        const auto found = static_cast<float>(std::sqrt(found_sq));
        if (found >= distances_[neighbour_]) return;
        distances_[neighbour_] = found;
        borders_.nearest[neighbour_] = piece;
        if (neighbour_ != vertex_) queue_.push(neighbour_);
    }

    const Mesh& mesh_;
    const Buffer<Position>& places_;
    BorderPieces& borders_;
    Buffer<float> distances_;
    VertexQueue queue_;
    // Whose pieces are offered, and to which neighbour or to itself; no_index: none's.
    uint32_t vertex_ = no_index, neighbour_ = no_index, offered_ = no_index;  // the vertex's nearest then
    Vec3 place_, neighbour_place_;
    uint32_t first_ = 0, triangle_ = 0;  // of the fan: where it began, where it is
    bool is_last_ = false;               // neighbour of the fan
    std::array<std::span<const uint32_t>, 2> lists_;
    size_t piece_ = 0;  // of the lists together
};

}  // namespace

Task<BorderPieces> find_border_pieces(Pace& pace, const Mesh& mesh, const RegionTree& tree,
                                      const Buffer<Position>& places) {
    GrowingList<Corner> edges(pace.memory());
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        for (Corner edge = 3 * t; edge < 3 * t + 3; ++edge) {
            const uint32_t across = mesh.neighbour_at(edge);
            if (across == no_index || across < t) continue;
            const uint32_t here = mesh.regions[t], there = mesh.regions[across];
            if (here != there && tree[here].look != tree[there].look) edges.push_back(edge);
        }
    });
    BorderPieces borders;
    borders.pieces = Buffer<BorderPiece>(edges.size(), pace.memory());
    co_await each(pace, edges.size(), Cost::tens_of_ns,
                  [&](uint32_t i) { borders.pieces[i] = piece_at(mesh, places, edges[i]); });
    borders.at_vertex = co_await group_by(pace, 2 * borders.pieces.size(), mesh.vertex_count(),
                                          [&](uint32_t i) { return borders.pieces[i / 2].ends[i % 2]; });
    borders.nearest = Buffer<uint32_t>(mesh.vertex_count(), pace.memory());
    NearestPieces nearest(mesh, places, borders, pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) { nearest.clear(v); });
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) { nearest.begin(v); });
    Slice slice(Cost::tens_of_ns);
    while (const uint32_t offered = nearest.offer(slice.left()))
        if (slice.is_over(offered)) co_await pace;
    co_await NearestPieces::give_back(pace, nearest);
    co_return borders;
}

}  // namespace flg
