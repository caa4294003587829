// SPDX-License-Identifier: MIT
#include "surfaces/repair/mesh_repair.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "core/failure.h"
#include "core/float_precision.h"
#include "core/random.h"
#include "runtime/each.h"
#include "surfaces/mesh/adjacency.h"
#include "surfaces/mesh/marks.h"

namespace flg {

namespace {

constexpr float max_coordinate = 1e30f;
// Of more triangles at an edge than this, duplicates not counted, all are left open.
constexpr size_t max_paired_triangles = 32;
// Triangles lower than this share of their longest edge are counted as flat.
constexpr double flat_height = 1e-6;

// The edges of triangles, joined two by two: of each corner, the corner whose edge is joined to the one that starts
// here; no_index at a border. Unlike a mesh's neighbours mates need no vertices to be followed, so that they hold while
// windings differ and vertices are still to be split. They take the place where the mesh's neighbours will be.
class Mates {
public:
    explicit Mates(GrowingBuffer<Triple>& place) : mates_(place) {}

    Corner operator[](Corner corner) const { return mates_[corner / 3][corner % 3]; }
    void leave_open(Corner corner) { mates_[corner / 3][corner % 3] = no_index; }
    void join(Corner a, Corner b) {
        mates_[a / 3][a % 3] = b;
        mates_[b / 3][b % 3] = a;
    }
    // Makes the edge, and what it was joined to, a border. False if it is one.
    bool cut(Corner corner) {
        const Corner mate = (*this)[corner];
        if (mate == no_index) return false;
        leave_open(mate);
        leave_open(corner);
        return true;
    }

    // The next corner of the same vertex counter-clockwise, clockwise; no_index at the end of an open fan. Between
    // triangles whose windings agree.
    Corner turn(Corner corner) const { return (*this)[previous_corner(corner)]; }
    Corner turn_back(Corner corner) const {
        const Corner across = (*this)[corner];
        return across == no_index ? no_index : next_corner(across);
    }

private:
    GrowingBuffer<Triple>& mates_;
};

struct Repair {
    Repair(const FlgMeshView& view, RepairedMesh& result, Memory* memory)
        : input(view),
          mesh(result.mesh),
          report(result.report),
          vertices(result.vertices),
          triangles(result.triangles),
          mates(result.mesh.neighbours),
          copies(memory) {}

    uint32_t vertex_count() const { return input.vertex_count + static_cast<uint32_t>(copies.size()); }

    const FlgMeshView& input;
    Mesh& mesh;
    MeshReport& report;
    IndexMap &vertices, &triangles;
    Buffer<uint32_t> welded;  // the vertex that each one is from now on; empty if all stay themselves
    Mates mates;
    std::pmr::deque<uint32_t> copies;  // vertices behind those of the input: of which they are copies
};

// ---- Positions

const FlgColumn& position_column(const FlgMeshView& input) {
    for (uint32_t i = 0; i < input.column_count; ++i) {
        if (input.columns[i].attribute == FLG_ATTRIBUTE_POSITION) return input.columns[i];
    }
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "none of the mesh's %u columns is FLG_ATTRIBUTE_POSITION",
                  input.column_count);
}

void check_size(const FlgMeshView& input) {
    if (input.vertex_count == 0 || input.triangle_count == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the mesh is empty: it has %u vertices and %u triangles",
                      input.vertex_count, input.triangle_count);
    }
    if (input.vertex_count > max_mesh_corners || input.triangle_count > max_mesh_corners / 3) {
        throw Failure(FLG_ERROR_LIMIT, "the mesh has %u vertices and %u triangles, the limit is %u and %u",
                      input.vertex_count, input.triangle_count, max_mesh_corners, max_mesh_corners / 3);
    }
}

Task<void> read_positions(Pace& pace, Repair& repair) {
    const FlgColumn& column = position_column(repair.input);
    check_size(repair.input);
    const size_t stride = column.stride == 0 ? 3 : column.stride / sizeof(float);
    repair.mesh.positions = GrowingBuffer<Position>(repair.input.vertex_count, pace.memory());
    const float* const values = column.data;
    Position* const positions = repair.mesh.positions.data();
    co_await each(pace, repair.input.vertex_count, Cost::some_ns, [=](uint32_t v) {
        const float* position = values + v * stride;
        for (uint32_t k = 0; k < 3; ++k) {
            if (!(std::abs(position[k]) <= max_coordinate)) {
                throw Failure(
                    FLG_ERROR_INVALID_ARGUMENT,
                    "vertex %u of the mesh is at (%g, %g, %g): coordinates must be finite and at most %g in size", v,
                    double{position[0]}, double{position[1]}, double{position[2]}, double{max_coordinate});
            }
            positions[v][k] = position[k];
        }
    });
}

Task<void> check_precision(Pace& pace, const Repair& repair) {
    const auto& positions = repair.mesh.positions;
    const uint32_t* const triangles = repair.input.triangles;
    const uint32_t vertices = repair.input.vertex_count;
    EdgePrecision precision;
    co_await each(pace, repair.input.triangle_count, Cost::tens_of_ns, [&](uint32_t t) {
        const uint32_t* const corners = triangles + size_t{3} * t;
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = corners[k], b = corners[(k + 1) % 3];
            if (a < vertices && b < vertices) precision.add(positions[a].data(), positions[b].data());
        }
    });
    precision.check("the mesh", "give positions relative to an origin near it (FlgMeshView::origin)");
}

// ---- Welding. In order of index, a vertex joins the first vertex before it that lies within the distance and was not
// itself joined to another; so that joining never runs along a chain of vertices.
//
// Vertices that others can join are kept in chains by the cell they lie in, cells of twice the distance wide, so that
// eight cells hold whatever is near. Chains start in a table of one entry a vertex, found by the cell's hash.

class Weld {
public:
    Weld(const GrowingBuffer<Position>& positions, double distance, Memory* memory)
        : positions_(positions),
          distance_(distance),
          first_in_cell_(std::bit_ceil(positions.size()), memory),
          next_in_cell_(positions.size(), memory),
          joined_to_(positions.size(), memory) {}

    uint32_t cell_count() const { return static_cast<uint32_t>(first_in_cell_.size()); }
    void clear(uint32_t cell) { first_in_cell_[cell] = no_index; }
    // In rising order. At distance 0 vertices are joined whose coordinates are equal.
    void join(uint32_t vertex) {
        const Vec3 position = load_vec3(positions_[vertex].data());
        uint32_t cell, first = vertex;
        if (distance_ == 0) {
            cell = cell_of(position);
            first = find(cell, position, first);
        } else {
            const Vec3 place = position / (2 * distance_);
            const Vec3 corner = place.array().floor();
            cell = cell_of(corner);
            for (uint32_t k = 0; k < 8; ++k) {
                Vec3 near = corner;
                for (uint32_t axis = 0; axis < 3; ++axis) {
                    if (k >> axis & 1) near[axis] += place[axis] - corner[axis] < 0.5 ? -1 : 1;
                }
                first = find(cell_of(near), position, first);
            }
        }
        joined_to_[vertex] = first;
        if (first != vertex) {
            ++joined_count_;
        } else {
            next_in_cell_[vertex] = std::exchange(first_in_cell_[cell], vertex);
        }
    }

    uint32_t joined_count() const { return joined_count_; }
    Buffer<uint32_t> take() { return std::move(joined_to_); }
    void free_table() { first_in_cell_ = {}; }
    void free_chains() { next_in_cell_ = {}; }

private:
    uint32_t cell_of(const Vec3& cell) const {
        uint64_t hash = 0;
        for (double x : cell) hash = mix64(hash ^ std::bit_cast<uint64_t>(x + 0.0));  // -0 is 0
        return static_cast<uint32_t>(hash & (first_in_cell_.size() - 1));
    }
    // The first vertex of the cell's chain within the distance; `first` if that comes before it.
    uint32_t find(uint32_t cell, const Vec3& position, uint32_t first) const {
        for (uint32_t other = first_in_cell_[cell]; other != no_index; other = next_in_cell_[other]) {
            const double apart = (load_vec3(positions_[other].data()) - position).squaredNorm();
            if (apart <= distance_ * distance_) first = std::min(first, other);
        }
        return first;
    }

    const GrowingBuffer<Position>& positions_;
    double distance_;
    Buffer<uint32_t> first_in_cell_;  // a power of two of them
    Buffer<uint32_t> next_in_cell_;
    Buffer<uint32_t> joined_to_;
    uint32_t joined_count_ = 0;
};

Task<void> weld_vertices(Pace& pace, Repair& repair, float distance) {
    if (!(distance >= 0 && distance <= std::numeric_limits<float>::max())) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the weld distance is %g, must be finite and not negative",
                      double{distance});
    }
    Weld weld(repair.mesh.positions, distance, pace.memory());
    co_await each(pace, weld.cell_count(), Cost::some_ns, [&](uint32_t cell) { weld.clear(cell); });
    co_await each(pace, repair.input.vertex_count, distance == 0 ? Cost::tens_of_ns : Cost::hundreds_of_ns,
                  [&](uint32_t v) { weld.join(v); });
    repair.report.welded_vertices = weld.joined_count();
    if (weld.joined_count() > 0) repair.welded = weld.take();
    weld.free_table();
    co_await pace;
    weld.free_chains();
    co_await pace;
}

// ---- Triangles

void mark_dropped(Triple& triangle) {
    triangle[0] = no_index;
}
bool is_dropped(const Triple& triangle) {
    return triangle[0] == no_index;
}

// Drops the triangles that are marked. Others may have been dropped before.
Task<void> drop_triangles(Pace& pace, Repair& repair) {
    IndexMap& map = repair.triangles;
    GrowingBuffer<Triple>& triangles = repair.mesh.triangles;
    const uint32_t inputs = repair.input.triangle_count;
    if (map.is_identity()) {
        map.of_input = Buffer<uint32_t>(inputs, pace.memory());
        map.to_input = GrowingBuffer<uint32_t>(inputs, pace.memory());
        co_await each(pace, inputs, Cost::some_ns, [&](uint32_t t) { map.of_input[t] = map.to_input[t] = t; });
    }
    uint32_t kept = 0;
    co_await each(pace, triangles.size(), Cost::some_ns, [&](uint32_t t) {
        const uint32_t from = map.to_input[t];
        if (is_dropped(triangles[t])) {
            map.of_input[from] = no_index;
        } else {
            map.of_input[from] = kept;
            map.to_input[kept] = from;
            triangles[kept++] = triangles[t];
        }
    });
    triangles.resize(kept);
    map.to_input.resize(kept);
    if (kept == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "nothing is left of the mesh: each of its %u triangles names a vertex twice", inputs);
    }
}

// `welded`: the vertex that each one is from now on; null if all stay themselves.
Triple read_triangle(const FlgMeshView& input, const uint32_t* welded, uint32_t triangle) {
    Triple corners;
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t vertex = input.triangles[size_t{3} * triangle + k];
        if (vertex >= input.vertex_count) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "triangle %u of the mesh names vertex %u; there are %u vertices",
                          triangle, vertex, input.vertex_count);
        }
        corners[k] = welded ? welded[vertex] : vertex;
    }
    return corners;
}

Task<void> read_triangles(Pace& pace, Repair& repair) {
    const FlgMeshView input = repair.input;
    repair.mesh.triangles = GrowingBuffer<Triple>(input.triangle_count, pace.memory());
    Triple* const triangles = repair.mesh.triangles.data();
    const uint32_t* const welded = repair.welded.data();
    uint32_t degenerate = 0;
    co_await each(pace, input.triangle_count, Cost::some_ns, [=, &degenerate](uint32_t t) {
        const Triple corners = read_triangle(input, welded, t);
        triangles[t] = corners;
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
            mark_dropped(triangles[t]);
            ++degenerate;
        }
    });
    repair.report.degenerate_triangles = degenerate;
    if (degenerate > 0) co_await drop_triangles(pace, repair);
}

// ---- Joining the triangles of each edge two by two
// - Of triangles with the same three vertices, however wound, only the first counts.
// - Two triangles are joined, however wound.
// - Of more, those pass through each other or touch: triangles that are wound against each other are joined, the
//   flattest pair first, and of pairs as flat as each other (two boxes that touch in an edge) the convex one, so that
//   solids come apart rather than grow together. What is left over stays open.

class Pairing {
public:
    Pairing(Repair& repair, const Buffer<Corner>& sorted, Memory* memory)
        : positions_(repair.mesh.positions),
          triangles_(repair.mesh.triangles),
          sorted_(sorted),
          mates_(repair.mates),
          corners_(memory),
          sheets_(memory),
          duplicates_(memory) {}

    // The corners of an edge, as each_edge() has them.
    uint32_t pair(uint32_t begin, uint32_t end) {
        const Corner corner = sorted_[begin];
        if (end - begin == 1) {
            mates_.leave_open(corner);
        } else if (end - begin == 2 && apex_of(corner) != apex_of(sorted_[begin + 1])) {
            join(corner, sorted_[begin + 1]);
        } else {
            return pair_more(begin, end);
        }
        return 1;
    }

    uint32_t crowded_count() const { return crowded_count_; }
    // Some joined triangles are wound against each other's sense.
    bool winding_differs() const { return winding_differs_; }
    // Triangles that have the vertices of an earlier one, each up to three times.
    const std::pmr::deque<uint32_t>& duplicates() const { return duplicates_; }

private:
    struct Sheet {
        Corner corner;
        Vec3 away;     // from the edge, unit length; 0 for triangles without area
        bool forward;  // along the edge from its lesser to its greater vertex
    };
    uint32_t start_of(Corner corner) const { return triangles_[corner / 3][corner % 3]; }
    uint32_t apex_of(Corner corner) const { return triangles_[corner / 3][(corner + 2) % 3]; }
    Vec3 position(uint32_t vertex) const { return load_vec3(positions_[vertex].data()); }

    void join(Corner a, Corner b) {
        mates_.join(a, b);
        if (start_of(a) == start_of(b)) winding_differs_ = true;
    }

    uint32_t pair_more(uint32_t begin, uint32_t end) {
        corners_.assign(sorted_.begin() + begin, sorted_.begin() + end);
        for (Corner corner : corners_) mates_.leave_open(corner);
        drop_duplicates();
        const auto count = static_cast<uint32_t>(corners_.size());
        if (count == 2) join(corners_[0], corners_[1]);
        if (count > 2) ++crowded_count_;
        if (count <= 2 || count > max_paired_triangles) return 2 * (end - begin);
        pair_sheets(edge_at(triangles_, corners_[0]));
        return 2 * (end - begin) + count * count * count / 32;
    }

    // Sorted by apex, duplicates lie side by side, the first triangle first.
    void drop_duplicates() {
        std::sort(corners_.begin(), corners_.end(),
                  [this](Corner a, Corner b) { return std::pair(apex_of(a), a) < std::pair(apex_of(b), b); });
        size_t kept = 1;
        for (size_t i = 1; i < corners_.size(); ++i) {
            if (apex_of(corners_[i]) == apex_of(corners_[kept - 1])) {
                duplicates_.push_back(triangle_of(corners_[i]));
            } else {
                corners_[kept++] = corners_[i];
            }
        }
        corners_.resize(kept);
    }

    void pair_sheets(const Edge& edge) {
        const Vec3 origin = position(edge.lesser);
        const Vec3 along = (position(edge.greater) - origin).stableNormalized();
        sheets_.clear();
        for (Corner corner : corners_) {
            const Vec3 to_apex = position(apex_of(corner)) - origin;
            sheets_.push_back(
                {corner, (to_apex - to_apex.dot(along) * along).stableNormalized(), start_of(corner) == edge.lesser});
        }
        // 0 if b goes on where a ends, 2 if it folds back onto it. The inside of b is before it, turning about the
        // edge.
        const auto bend = [&](const Sheet& a, const Sheet& b) {
            constexpr double concave = 1e-3;
            return 1 + a.away.dot(b.away) + (along.dot(b.away.cross(a.away)) > 0 ? 0 : concave);
        };
        for (;;) {
            size_t best_a = 0, best_b = 0;
            double best = 4;
            for (size_t a = 0; a < sheets_.size(); ++a) {
                for (size_t b = 0; b < sheets_.size(); ++b) {
                    if (!sheets_[a].forward || sheets_[b].forward) continue;
                    const double value = bend(sheets_[a], sheets_[b]);
                    if (value < best) {
                        best = value;
                        best_a = a;
                        best_b = b;
                    }
                }
            }
            if (best == 4) return;
            mates_.join(sheets_[best_a].corner, sheets_[best_b].corner);
            sheets_.erase(sheets_.begin() + static_cast<ptrdiff_t>(std::max(best_a, best_b)));
            sheets_.erase(sheets_.begin() + static_cast<ptrdiff_t>(std::min(best_a, best_b)));
        }
    }

    const GrowingBuffer<Position>& positions_;
    const GrowingBuffer<Triple>& triangles_;
    const Buffer<Corner>& sorted_;
    Mates& mates_;
    std::pmr::vector<Corner> corners_;  // of a crowded edge
    std::pmr::vector<Sheet> sheets_;    // of them, those not joined yet
    std::pmr::deque<uint32_t> duplicates_;
    uint32_t crowded_count_ = 0;
    bool winding_differs_ = false;
};

// True if the windings of joined triangles differ.
Task<bool> join_triangles(Pace& pace, Repair& repair) {
    Mesh& mesh = repair.mesh;
    mesh.neighbours = GrowingBuffer<Triple>(mesh.triangles.size(), pace.memory());
    for (;;) {
        const Buffer<Corner> sorted =
            co_await sort_by_edge(pace, mesh.triangles, repair.vertex_count(), mesh.neighbours);
        Pairing pairing(repair, sorted, pace.memory());
        co_await each_edge(pace, mesh.triangles, sorted,
                           [&](uint32_t begin, uint32_t end) { return pairing.pair(begin, end); });
        repair.report.crowded_edges = pairing.crowded_count();
        const auto& duplicates = pairing.duplicates();
        if (duplicates.empty()) co_return pairing.winding_differs();
        co_await each(pace, duplicates.size(), Cost::some_ns, [&](uint32_t i) {
            Triple& triangle = mesh.triangles[duplicates[i]];
            repair.report.duplicate_triangles += !is_dropped(triangle);
            mark_dropped(triangle);
        });
        co_await drop_triangles(pace, repair);
        mesh.neighbours.resize(mesh.triangles.size());
    }
}

// ---- One winding for triangles that are joined. Each component is flooded, first within patches whose windings agree,
// then from patch to patch. The winding of most of the component's triangles stays, on a tie that of the first. Where
// patches can't agree all around, as in a Moebius strip, the edge between them is cut open; edges within a patch never
// are.

class Winding {
public:
    Winding(Repair& repair, Memory* memory)
        : triangles_(repair.mesh.triangles),
          mates_(repair.mates),
          states_(triangles_.size(), memory),
          flood_(triangles_.size(), memory),
          crossings_(memory) {}

    void clear(uint32_t triangle) { states_[triangle] = State::unseen; }
    bool is_seen(uint32_t triangle) const { return states_[triangle] != State::unseen; }

    void begin_component(uint32_t triangle) {
        flood_size_ = flooded_ = turned_size_ = 0;
        reach(triangle, State::kept);
    }
    // Goes on from a triangle, or over an edge between patches; false when the component is whole.
    bool flood() {
        if (flooded_ < flood_size_) {
            spread(flood_[flooded_++]);
        } else if (!crossings_.empty()) {
            cross(crossings_.front());
            crossings_.pop_front();
        } else {
            return false;
        }
        return true;
    }
    uint32_t component_size() const { return flood_size_; }
    // Those of the component, in the order in which they were met, that are wound against most.
    void flip(uint32_t begin, uint32_t end) {
        const State minority = 2 * turned_size_ > flood_size_ ? State::kept : State::turned;
        for (; begin < end; ++begin)
            if (states_[flood_[begin]] == minority) flip(flood_[begin]);
    }

    uint32_t flipped_count() const { return flipped_count_; }
    uint32_t cut_count() const { return cut_count_; }

private:
    enum class State : uint8_t { unseen, kept, turned };

    void reach(uint32_t triangle, State state) {
        states_[triangle] = state;
        flood_[flood_size_++] = triangle;
        turned_size_ += state == State::turned;
    }
    bool agrees(Corner corner) const {
        const Corner mate = mates_[corner];
        return triangles_[mate / 3][mate % 3] != triangles_[corner / 3][corner % 3];
    }
    void spread(uint32_t triangle) {
        for (Corner corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
            if (mates_[corner] == no_index) continue;
            const uint32_t other = triangle_of(mates_[corner]);
            if (!agrees(corner)) {
                crossings_.push_back(corner);
            } else if (!is_seen(other)) {
                reach(other, states_[triangle]);
            }
        }
    }
    void cross(Corner corner) {
        if (mates_[corner] == no_index) return;  // cut from the other side
        const uint32_t triangle = triangle_of(corner), other = triangle_of(mates_[corner]);
        if (!is_seen(other)) {
            reach(other, states_[triangle] == State::kept ? State::turned : State::kept);
        } else if (states_[other] == states_[triangle]) {
            cut_count_ += mates_.cut(corner);
        }
    }
    // The corners 1 and 2 change places, and so the edges 0 and 2.
    void flip(uint32_t triangle) {
        std::swap(triangles_[triangle][1], triangles_[triangle][2]);
        const Corner first = 3 * triangle, last = first + 2;
        const Corner first_mate = mates_[first], last_mate = mates_[last];
        mates_.leave_open(first);
        mates_.leave_open(last);
        if (last_mate != no_index) mates_.join(first, last_mate);
        if (first_mate != no_index) mates_.join(last, first_mate);
        ++flipped_count_;
    }

    GrowingBuffer<Triple>& triangles_;
    Mates& mates_;
    Buffer<State> states_;
    Buffer<uint32_t> flood_;                      // triangles of the component, in the order in which they were met
    std::pmr::deque<Corner> crossings_;           // from triangles of flood_, where windings do not agree
    uint32_t flood_size_ = 0, flooded_ = 0;       // how many were met, and gone on from
    uint32_t turned_size_ = 0;                    // of those met, those turned against the first
    uint32_t flipped_count_ = 0, cut_count_ = 0;  // of all components
};

Task<void> align_windings(Pace& pace, Repair& repair) {
    const uint32_t triangles = repair.mesh.triangle_count();
    Winding winding(repair, pace.memory());
    co_await each(pace, triangles, Cost::some_ns, [&](uint32_t t) { winding.clear(t); });
    Slice slice(Cost::tens_of_ns);
    for (uint32_t first = 0; first < triangles; ++first) {
        if (slice.is_over()) co_await pace;
        if (winding.is_seen(first)) continue;
        winding.begin_component(first);
        while (winding.flood())
            if (slice.is_over()) co_await pace;
        for (Portion part(slice, 0, winding.component_size()); part.next();) {
            winding.flip(part.begin, part.end);
            if (part.is_over()) co_await pace;
        }
    }
    repair.report.flipped_triangles = winding.flipped_count();
    repair.report.cut_edges = winding.cut_count();
}

// ---- One fan a vertex: the first fan keeps the vertex, the others (bow-ties, edges that were left open) get copies of
// it. Returns which vertices are used, those that were copies before among them. About 10 ns a corner.

Task<Marks> split_fans(Pace& pace, Repair& repair) {
    GrowingBuffer<Triple>& triangles = repair.mesh.triangles;
    const uint32_t inputs = repair.input.vertex_count, corners = 3 * repair.mesh.triangle_count();
    Marks visited = co_await no_marks(pace, corners);
    Marks used = co_await no_marks(pace, repair.vertex_count());
    uint32_t vertex = 0;  // of the fan
    const auto visit = [&](Corner corner) {
        visited.set(corner);
        triangles[corner / 3][corner % 3] = vertex;
    };
    Slice slice(Cost::some_ns);
    for (Corner first = 0; first < corners; ++first) {
        if (slice.is_over()) co_await pace;
        if (visited.has(first)) continue;
        vertex = triangles[first / 3][first % 3];
        if (!used.set(vertex)) {
            const uint32_t original = vertex < inputs ? vertex : repair.copies[vertex - inputs];
            vertex = repair.vertex_count();
            repair.copies.push_back(original);
        }
        visit(first);
        Corner corner = repair.mates.turn(first);
        for (; corner != no_index && corner != first; corner = repair.mates.turn(corner)) {
            visit(corner);
            if (slice.is_over()) co_await pace;
        }
        if (corner == first) continue;
        // An open fan, which goes on from its first corner the other way.
        for (corner = repair.mates.turn_back(first); corner != no_index; corner = repair.mates.turn_back(corner)) {
            visit(corner);
            if (slice.is_over()) co_await pace;
        }
    }
    co_return used;
}

// Parts edges that were left open or cut, yet still have the same two vertices because the fans there hang together
// another way round. One of them keeps its place, a joined one if there is one; triangles of the others are detached at
// the vertex where their edge starts, by cutting the edge before it too. True if edges were detached, so that fans are
// to be split once more.
Task<bool> make_edges_distinct(Pace& pace, Repair& repair) {
    const GrowingBuffer<Triple>& triangles = repair.mesh.triangles;
    Mates& mates = repair.mates;
    GrowingBuffer<Triple> scratch(triangles.size(), pace.memory());
    const Buffer<Corner> sorted = co_await sort_by_edge(pace, triangles, repair.vertex_count(), scratch);
    // Cut once all edges were looked at: cuts make edges look alike until vertices are split.
    std::pmr::deque<Corner> detached(pace.memory());
    co_await each_edge(pace, triangles, sorted, [&](uint32_t begin, uint32_t end) {
        Corner kept = sorted[begin];
        for (uint32_t i = begin + 1; i < end; ++i)
            if (mates[kept] == no_index) kept = sorted[i];
        if (mates[kept] == no_index) kept = sorted[begin];
        for (uint32_t i = begin; i < end; ++i)
            if (sorted[i] != kept && sorted[i] != mates[kept]) detached.push_back(sorted[i]);
        return end - begin;
    });
    // The fan of the corner is then its triangle alone, and so gets a vertex of its own.
    co_await each(pace, detached.size(), Cost::some_ns, [&](uint32_t i) {
        repair.report.cut_edges += mates.cut(detached[i]);
        repair.report.cut_edges += mates.cut(previous_corner(detached[i]));
    });
    co_return !detached.empty();
}

// Numbers the vertices that are used anew, in their order, copies last, and puts their positions into these places.
// Triangles keep the numbers from before.
Task<void> number_vertices(Pace& pace, Repair& repair, uint32_t used_count, const Marks& used) {
    IndexMap& map = repair.vertices;
    GrowingBuffer<Position>& positions = repair.mesh.positions;
    const size_t count = used_count + repair.copies.size();
    GrowingBuffer<Position> placed(count, pace.memory());
    map.of_input = Buffer<uint32_t>(positions.size(), pace.memory());
    map.to_input = GrowingBuffer<uint32_t>(count, pace.memory());
    uint32_t kept = 0;
    co_await each(pace, positions.size(), Cost::some_ns, [&](uint32_t v) {
        if (!repair.welded.empty() && repair.welded[v] != v) {
            map.of_input[v] = map.of_input[repair.welded[v]];  // which comes before it
        } else if (used.has(v)) {
            placed[kept] = positions[v];
            map.to_input[kept] = v;
            map.of_input[v] = kept++;
        } else {
            map.of_input[v] = no_index;
        }
    });
    co_await each(pace, repair.copies.size(), Cost::some_ns, [&](uint32_t c) {
        placed[kept] = positions[repair.copies[c]];
        map.to_input[kept++] = repair.copies[c];
    });
    positions = std::move(placed);
}

Task<void> split_vertices(Pace& pace, Repair& repair) {
    const uint32_t inputs = repair.input.vertex_count;
    MeshReport& report = repair.report;
    for (;;) {
        const Marks used = co_await split_fans(pace, repair);
        const bool opened = report.crowded_edges + report.cut_edges > 0;
        if (opened && co_await make_edges_distinct(pace, repair)) continue;

        uint32_t used_count = 0;
        co_await each(pace, inputs, Cost::some_ns, [&](uint32_t v) { used_count += used.has(v); });
        report.split_vertices = static_cast<uint32_t>(repair.copies.size());
        report.unused_vertices = inputs - report.welded_vertices - used_count;
        if (used_count < inputs || !repair.copies.empty()) co_await number_vertices(pace, repair, used_count, used);
        co_return;
    }
}

// ---- Triangles get their vertices' final numbers and their regions, mates become neighbours, vertices get a corner.

// Twice the area is the height times the longest edge.
bool is_flat(const Mesh& mesh, const Triple& corners) {
    const Vec3 a = mesh.position(corners[0]), b = mesh.position(corners[1]), c = mesh.position(corners[2]);
    const double max_sq = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return (b - a).cross(c - a).norm() <= flat_height * max_sq;
}

Task<void> finish_mesh(Pace& pace, Repair& repair) {
    Mesh& mesh = repair.mesh;
    const uint32_t inputs = repair.input.vertex_count;
    const uint32_t first_copy = mesh.vertex_count() - repair.report.split_vertices;  // its final number
    const auto final_number = [&](uint32_t vertex) {
        if (repair.vertices.is_identity()) return vertex;
        return vertex < inputs ? repair.vertices.of_input[vertex] : vertex - inputs + first_copy;
    };
    mesh.regions = GrowingBuffer<uint32_t>(mesh.triangle_count(), pace.memory());
    mesh.corner_of_vertex = GrowingBuffer<uint32_t>(mesh.vertex_count(), pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) { mesh.corner_of_vertex[v] = no_index; });
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        Triple& corners = mesh.triangles[t];
        Triple& neighbours = mesh.neighbours[t];
        for (uint32_t k = 0; k < 3; ++k) {
            corners[k] = final_number(corners[k]);
            const bool is_open = neighbours[k] == no_index;
            // A border vertex gets the corner where its border edge leaves, the first of its fan; others any.
            uint32_t& corner = mesh.corner_of_vertex[corners[k]];
            if (is_open || corner == no_index) corner = 3 * t + k;
            if (!is_open) neighbours[k] = triangle_of(neighbours[k]);
        }
        const uint32_t from = repair.triangles.is_identity() ? t : repair.triangles.to_input[t];
        mesh.regions[t] = repair.input.regions ? repair.input.regions[from] : 0;
        repair.report.flat_triangles += is_flat(mesh, corners);
    });
    repair.report.topology = co_await find_topology(pace, mesh);
}

}  // namespace

Task<void> repair_mesh(Pace& pace, const FlgMeshView& input, RepairOptions options, RepairedMesh& repaired) {
    Repair repair(input, repaired, pace.memory());
    pace.stage("read");
    co_await read_positions(pace, repair);
    co_await check_precision(pace, repair);
    if (options.weld_distance) co_await weld_vertices(pace, repair, *options.weld_distance);
    co_await read_triangles(pace, repair);
    pace.stage("join");
    if (co_await join_triangles(pace, repair)) co_await align_windings(pace, repair);
    co_await split_vertices(pace, repair);
    pace.stage("finish");
    co_await finish_mesh(pace, repair);
}

}  // namespace flg
