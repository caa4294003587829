// SPDX-License-Identifier: MIT
// Exact geodesic distances: the lengths of shortest paths over the triangles, but for rounding. Windows
// (exact_window.h) go on from triangle to triangle in the order of their distances; they are not kept. Xin, Wang:
// Improving Chen & Han's algorithm on the discrete geodesic problem (2009); buckets in place of the heap as in Xu,
// Wang, Liu, Liu, He: Fast wavefront propagation (2015).
//
// What bounds the number of windows
// - One angle, one split: of the windows that enter a triangle by the same edge and light its opposite corner, only the
//   one that is nearest to it goes on across both other edges, others across one.
// - What is nearer by way of an edge's ends is cut off a window: a departure from Xin and Wang, who drop windows that
//   are so from end to end.
// - A shortest path crosses no triangle twice, so there is an end to runs of narrow triangles, even to those around a
//   spike without area. Elsewhere each crossing takes some way.
//
// Departures: light goes on from a vertex only where a path may turn there, by at least half a turn on either side. All
// vertices tell their neighbours along the edges, so no distance exceeds that along edges, whatever the triangles.
// Lines are sources too.
#pragma once

#include "core/growing_list.h"
#include "surfaces/geodesics/bucket_queue.h"
#include "surfaces/geodesics/distance_field.h"
#include "surfaces/geodesics/exact_faces.h"
#include "surfaces/geodesics/exact_window.h"

namespace flg {

// About 100 bytes a triangle, 72 of corners, 32 a vertex, and 56 for each window that waits.
class ExactSolver {
public:
    // All outlive the solver; the faces are laid out.
    ExactSolver(const Mesh& mesh, const ExactFaces& faces, const SolveLimits& limits, Memory* memory);

    // ---- for sources, see exact_sources.h ----

    // Light that goes out from a vertex in all directions.
    void start_at(uint32_t vertex, uint32_t label);
    // From `corner`, at a vertex, the way to the source leads in a direction, of length 1, given from the corner's
    // first edge; or in none, if the vertex lies where the way came from.
    void reach(Corner corner, double distance, const Vec2& direction, uint32_t label);
    void send(Window window);
    // Some sources are no vertices.
    void allow_sources_inside() { sources_inside_ = true; }
    const ExactFaces& faces() const { return faces_; }
    // Copies the windows that may light places of the triangle they enter that are so far away, in metres.
    void keep_windows(double distance, GrowingList<Window>& out) {
        kept_distance_ = distance;
        kept_ = &out;
    }

    // ---- after ----

    double distance(uint32_t vertex) const { return vertices_[vertex].distance; }
    uint32_t label(uint32_t vertex) const { return vertices_[vertex].label; }
    uint64_t window_count() const { return window_count_; }

private:
    friend Task<void> begin_exact(Pace&, ExactSolver&);
    friend Task<void> spread_exact(Pace&, ExactSolver&);
    // What is known of a vertex.
    struct Vertex {
        Vec2 direction;  // to the source, see reach()
        double distance;
        Corner corner;  // of the direction; no_index: there is none
        uint32_t label;
    };
    // A vertex that waits, as long as its distance is this one.
    struct Waiting {
        uint32_t vertex;
        double distance;
    };
    // The window that is nearest to the corner opposite to its edge.
    struct Holder {
        double distance, x, y;  // at the corner; where the way to it begins, in the edge's coordinates
    };
    enum class Event { none, vertex, end };

    // Crosses `count` windows, about 150 ns each, or fewer: until a vertex is to be left, or the field is complete.
    // (How many there will be is not known: a loop of its own.)
    Event run(uint32_t count);
    void next_bucket();
    uint32_t bucket_of(double distance) const;
    uint32_t place_in_ring(double distance);
    struct Entry;
    void cross_triangle(Window window);
    void keep(const Window& window, const ExactFace& face);
    void split(const Entry& entry, double distance, bool& left, bool& right);
    void pass_left(const Entry& entry);
    void pass_right(const Entry& entry);
    static Task<void> leave(Pace& pace, ExactSolver& solver, uint32_t vertex);
    static Task<void> list_fan(Pace& pace, ExactSolver& solver, uint32_t vertex, Corner first);
    void tell_along_edges(Corner corner, double distance, uint32_t label);
    void light(Corner corner, const Vertex& state, const Vec2* from, const Vec2* to);
    bool targets_are_nearer_than(double distance);
    double slack_at(double distance) const;

    const Mesh& mesh_;
    const ExactFaces& faces_;
    const SolveLimits& limits_;
    Buffer<Vertex> vertices_;
    Buffer<Holder> holders_;  // by the corner of the edge
    BucketQueue<Window> windows_;
    BucketQueue<Waiting> waiting_;
    GrowingList<Corner> fan_;  // of the vertex that is being left; no_index: not within the regions
    double buckets_per_metre_;
    uint32_t bucket_ = 0;  // that is being emptied
    uint32_t leaving_ = no_index;
    bool any_beyond_ring_ = false;
    bool sources_inside_ = false;
    bool is_complete_ = false;
    double kept_distance_ = 0;
    GrowingList<Window>* kept_ = nullptr;
    uint32_t targets_met_ = 0;  // the first targets that have a distance
    double furthest_target_ = 0;
    uint64_t window_count_ = 0;
};

// Before sources are given, and after.
Task<void> begin_exact(Pace& pace, ExactSolver& solver);
// Fails with FLG_ERROR_LIMIT if more than 2 GB of windows wait.
Task<void> spread_exact(Pace& pace, ExactSolver& solver);

// Copies the field out, with labels if wanted. What is beyond the limit is unreachable.
Task<void> take_exact_field(Pace& pace, const ExactSolver& solver, float max_distance, bool labelled,
                            DistanceField& field);

}  // namespace flg
