// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/exact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/failure.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Of the mean edge.
constexpr double bucket_width = 0.5;
// So that a few long edges do not ask for a ring without end.
constexpr double max_buckets = 4000;
constexpr uint32_t windows_at_a_time = 64;  // some 10 us
constexpr size_t max_window_bytes = size_t{1} << 31;
// Ways that differ by less, of themselves or the longest edge, are as long.
constexpr double distance_rounding = 1e-13;
// A corner that is so little beside a window, radians, counts as lit: the gaps between windows are narrower. What that
// makes distances too short by is the square of it.
constexpr double angle_rounding = 1e-9;

// The angles of a and b together, of length 1.
Vec2 turned(const Vec2& a, const Vec2& b) {
    return Vec2(a.x() * b.x() - a.y() * b.y(), a.x() * b.y() + a.y() * b.x()).normalized();
}
Vec2 mirrored(const Vec2& a) {
    return {a.x(), -a.y()};
}
// Of an angle from no to a whole turn, but for rounding.
bool is_half_turn(const Vec2& a) {
    return a.x() < 0 ? a.y() <= angle_rounding : a.y() < -angle_rounding;
}

// Where the ray through a place on the x axis meets the line from `start` in a direction, within its length.
double meeting(const Vec2& ray, double place, const Vec2& start, const Vec2& direction, double length,
               double parallel) {
    const double s = cross(ray, Vec2(place - start.x(), -start.y())) / cross(ray, direction);
    return s >= 0 ? std::min(s, length) : s < 0 ? 0 : parallel;
}

// In the corner's own coordinates: its second edge, of length 1.
Vec2 second_edge(const ExactFace& face, uint32_t k) {
    const Vec2 edge(face.along[k], face.above[k]);
    const double length = edge.norm();
    return length > 0 ? Vec2(edge / length) : Vec2(1, 0);
}

}  // namespace

ExactSolver::ExactSolver(const Mesh& mesh, const ExactFaces& faces, const SolveLimits& limits, Memory* memory)
    : mesh_(mesh),
      faces_(faces),
      limits_(limits),
      vertices_(mesh.vertex_count(), memory),
      holders_(size_t{3} * mesh.triangle_count(), memory),
      windows_(memory),
      waiting_(memory),
      fan_(memory) {
    const double width = std::max(bucket_width * faces.mean, faces.longest / max_buckets);
    buckets_per_metre_ = width > 0 ? 1 / width : 1;
    const auto span = static_cast<uint32_t>(2 * faces.longest * buckets_per_metre_) + 3;
    windows_.reset(span);
    waiting_.reset(span);
}

Task<void> begin_exact(Pace& pace, ExactSolver& solver) {
    co_await each(pace, solver.vertices_.size(), Cost::some_ns, [&](uint32_t v) {
        solver.vertices_[v] = {Vec2::Zero(), infinity, no_index, no_index};
    });
    co_await each(pace, solver.holders_.size(), Cost::some_ns, [&](uint32_t corner) {
        solver.holders_[corner] = {infinity, 0, 0};
    });
}

Task<void> spread_exact(Pace& pace, ExactSolver& solver) {
    for (;;) {
        const ExactSolver::Event event = solver.run(windows_at_a_time);
        if (event == ExactSolver::Event::end) break;
        if (event == ExactSolver::Event::vertex) co_await ExactSolver::leave(pace, solver, solver.leaving_);
        co_await pace;
    }
    co_await repeat(pace, Cost::microseconds, [&] { return solver.windows_.give_back(); });
    co_await repeat(pace, Cost::microseconds, [&] { return solver.waiting_.give_back(); });
}

Task<void> take_exact_field(Pace& pace, const ExactSolver& solver, float max_distance, bool labelled,
                            DistanceField& field) {
    const size_t count = solver.faces().bends.size();
    field.distances = Buffer<float>(count, pace.memory());
    field.labels = Buffer<uint32_t>(labelled ? count : 0, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t v) {
        const auto distance = static_cast<float>(solver.distance(v));
        const bool is_reached = distance <= max_distance;
        field.distances[v] = is_reached ? distance : unreachable;
        if (labelled) field.labels[v] = is_reached && distance != unreachable ? solver.label(v) : no_index;
    });
}

double ExactSolver::slack_at(double distance) const {
    return distance_rounding * (distance + faces_.longest);
}

uint32_t ExactSolver::bucket_of(double distance) const {
    return static_cast<uint32_t>(std::min(distance * buckets_per_metre_, 4e9));
}

// Never into a bucket that is behind, nor beyond the ring's end: from there it goes on when its time has come.
uint32_t ExactSolver::place_in_ring(double distance) {
    const uint32_t bucket = std::max(bucket_of(distance), bucket_), last = bucket_ + windows_.span() - 1;
    if (bucket <= last) return bucket;
    any_beyond_ring_ = true;
    return last;
}

void ExactSolver::start_at(uint32_t vertex, uint32_t label) {
    Vertex& state = vertices_[vertex];
    if (state.distance == 0 && state.corner == no_index) return;
    state = {Vec2::Zero(), 0, no_index, label};
    waiting_.push(place_in_ring(0), {vertex, 0});
}

void ExactSolver::reach(Corner corner, double distance, const Vec2& direction, uint32_t label) {
    const uint32_t vertex = faces_.faces[triangle_of(corner)].vertices[corner % 3];
    Vertex& state = vertices_[vertex];
    if (!(distance < state.distance)) {
        if (distance == state.distance && state.corner != no_index) state.label = std::min(state.label, label);
        return;
    }
    state = {direction, distance, direction.squaredNorm() > 0 ? corner : no_index, label};
    if (distance <= limits_.distance) waiting_.push(place_in_ring(distance), {vertex, distance});
}

void ExactSolver::send(Window window) {
    const ExactFace& face = faces_.faces[triangle_of(window.edge)];
    const uint32_t k = window.edge % 3;
    const double start = vertices_[face.vertices[k]].distance, end = vertices_[face.vertices[(k + 1) % 3]].distance;
    if (!window.trim(start, end, face.lengths[k], slack_at(window.before))) return;
    const double least = window.least_distance();
    if (!(least <= limits_.distance)) return;
    windows_.push(place_in_ring(least), window);
}

ExactSolver::Event ExactSolver::run(uint32_t count) {
    if (windows_.bytes() > max_window_bytes) {
        throw Failure(FLG_ERROR_LIMIT,
                      "accuracy is exact: between %u triangles there are more windows than fit into %zu MB",
                      mesh_.triangle_count(), max_window_bytes >> 20);
    }
    for (; count > 0; --count) {
        if (is_complete_) return Event::end;
        Window window;
        Waiting waiting;
        if (windows_.pop(bucket_, window)) {
            const double least = any_beyond_ring_ ? window.least_distance() : 0;
            if (bucket_of(least) > bucket_) {
                windows_.push(place_in_ring(least), window);
            } else {
                ++window_count_;
                cross_triangle(window);
            }
        } else if (!waiting_.pop(bucket_, waiting)) {
            next_bucket();
        } else if (bucket_of(waiting.distance) > bucket_) {
            waiting_.push(place_in_ring(waiting.distance), waiting);
        } else if (vertices_[waiting.vertex].distance == waiting.distance) {
            leaving_ = waiting.vertex;
            return Event::vertex;
        }
    }
    return Event::none;
}

void ExactSolver::next_bucket() {
    ++bucket_;
    const double done = bucket_ / buckets_per_metre_;
    const bool none_waits = windows_.size() == 0 && waiting_.size() == 0;
    is_complete_ = none_waits || done > limits_.distance || targets_are_nearer_than(done);
}

bool ExactSolver::targets_are_nearer_than(double distance) {
    const auto& targets = limits_.targets;
    if (targets.empty()) return false;
    for (; targets_met_ < targets.size(); ++targets_met_) {
        const double target = vertices_[targets[targets_met_]].distance;
        if (target > distance) return false;
        furthest_target_ = std::max(furthest_target_, target);
    }
    return furthest_target_ < distance;
}

// A window as it enters a triangle.
struct ExactSolver::Entry {
    Entry(const ExactFace& of_face, const Window& of_window)
        : window(of_window),
          face(of_face),
          k(window.edge % 3),
          next((k + 1) % 3),
          previous((k + 2) % 3),
          apex(face.along[k], face.above[k]),
          left(window.ray_to({window.begin, 0})),
          right(window.ray_to({window.end, 0})),
          up(window.ray_to(apex)),
          beside_left(cross(apex - Vec2(window.begin, 0), left)),
          beside_right(cross(right, apex - Vec2(window.end, 0))) {}

    // Whether its rays meet the edge to the left of the opposite corner, and the one to the right.
    bool goes_left() const { return beside_left >= 0; }
    bool goes_right() const { return beside_right >= 0; }
    bool lights_apex() const {
        if (goes_left() && goes_right()) return true;
        const Vec2& ray = goes_left() ? right : left;
        const double size = window.is_straight() ? face.lengths[k] : up.norm() * ray.norm();
        return (goes_left() ? beside_right : beside_left) >= -angle_rounding * size;
    }
    // Rays that pass by the corner cross the way to it from the window's end that is further from it.
    bool is_beaten(double at_apex, double slack) const {
        if (goes_left() && goes_right()) return false;
        const Vec2 far(goes_left() ? window.begin : window.end, 0);
        return window.distance_at(far) > at_apex + (apex - far).norm() + slack;
    }

    const Window& window;
    const ExactFace& face;
    uint32_t k, next, previous;  // corners: where the edge starts, ends, and the one opposite
    Vec2 apex, left, right, up;
    double beside_left, beside_right;
};

void ExactSolver::cross_triangle(Window window) {
    const ExactFace& face = faces_.faces[triangle_of(window.edge)];
    const uint32_t k = window.edge % 3;
    const double at_start = vertices_[face.vertices[k]].distance;
    const double at_end = vertices_[face.vertices[(k + 1) % 3]].distance;
    const double slack = slack_at(window.before);
    if (!window.trim(at_start, at_end, face.lengths[k], slack)) return;
    window.narrow_run = is_narrow(face, k) ? window.narrow_run + 1 : 0;
    if (window.narrow_run > faces_.narrow_count) return;
    if (kept_) keep(window, face);

    const Entry entry(face, window);
    const Vertex& apex = vertices_[face.vertices[entry.previous]];
    if (entry.is_beaten(apex.distance, slack)) return;
    const double distance = window.distance_at(entry.apex);
    if (entry.lights_apex() && distance <= apex.distance) {
        const Vec2 edge(-entry.apex), back(-entry.up);
        reach(3 * triangle_of(window.edge) + entry.previous, distance, turned(mirrored(edge), back), window.label);
    }
    bool left = entry.goes_left(), right = entry.goes_right();
    if (left && right) split(entry, distance, left, right);
    if (left) pass_left(entry);
    if (right) pass_right(entry);
}

void ExactSolver::keep(const Window& window, const ExactFace& face) {
    const double furthest = std::max(window.distance_at({window.begin, 0}), window.distance_at({window.end, 0})) +
                            *std::max_element(face.lengths.begin(), face.lengths.end());
    if (window.least_distance() <= kept_distance_ && kept_distance_ <= furthest) kept_->push_back(window);
}

// One angle, one split. The way to the corner from the window that holds it crosses, on one side, all that this one
// lights there; unless it begins within, which only sources that are no vertices do.
void ExactSolver::split(const Entry& entry, double distance, bool& left, bool& right) {
    const Window& window = entry.window;
    Holder& holder = holders_[window.edge];
    if (distance < holder.distance) {
        const Vec2 origin = window.origin_of(entry.apex, distance);
        holder = {distance, origin.x(), origin.y()};
        return;
    }
    const Vec2 origin(holder.x, holder.y);
    const double side = cross(entry.up, origin - entry.apex);  // above 0: it comes from the left
    const bool from_left = side != 0 ? side > 0 : entry.beside_left < entry.beside_right;
    if (sources_inside_) {
        const bool within = from_left ? cross(entry.left, origin - Vec2(window.begin, 0)) < 0
                                      : cross(entry.right, origin - Vec2(window.end, 0)) > 0;
        if (within) return;
    }
    (from_left ? left : right) = false;
}

void ExactSolver::pass_left(const Entry& entry) {
    const double length = entry.face.lengths[entry.previous];
    const Corner across = entry.face.across[entry.previous];
    if (across == no_index || !(length > 0)) return;
    const Window& window = entry.window;
    const Vec2 start = Vec2::Zero(), along = entry.apex / length;
    Window passed = window;
    passed.edge = across;
    passed.begin = meeting(entry.left, window.begin, start, along, length, 0);
    passed.end = entry.goes_right() ? length : meeting(entry.right, window.end, start, along, length, length);
    passed.move_to(start, along);
    // All rays cross the way from the corner behind them to the begin.
    const Vec2 begin = passed.begin * along, behind(entry.face.lengths[entry.k], 0);
    const double least = vertices_[entry.face.vertices[entry.next]].distance + (begin - behind).norm();
    if (window.distance_at(begin) > least + slack_at(window.before)) return;
    send(passed);
}

void ExactSolver::pass_right(const Entry& entry) {
    const double length = entry.face.lengths[entry.next];
    const Corner across = entry.face.across[entry.next];
    if (across == no_index || !(length > 0)) return;
    const Window& window = entry.window;
    const Vec2 start = entry.apex, along = (Vec2(entry.face.lengths[entry.k], 0) - entry.apex) / length;
    Window passed = window;
    passed.edge = across;
    passed.begin = entry.goes_left() ? 0 : meeting(entry.left, window.begin, start, along, length, 0);
    passed.end = meeting(entry.right, window.end, start, along, length, length);
    passed.move_to(start, along);
    const Vec2 end = start + passed.end * along;
    const double least = vertices_[entry.face.vertices[entry.k]].distance + end.norm();
    if (window.distance_at(end) > least + slack_at(window.before)) return;
    send(passed);
}

// The vertex's corners counter-clockwise, from one of them on; gaps are no_index.
Task<void> ExactSolver::list_fan(Pace& pace, ExactSolver& solver, uint32_t vertex, Corner first) {
    const Mesh& mesh = solver.mesh_;
    GrowingList<Corner>& fan = solver.fan_;
    Slice slice(Cost::tens_of_ns);
    fan.clear();
    Corner corner = first;
    do {
        fan.push_back(solver.faces_.faces[triangle_of(corner)].is_within() ? corner : no_index);
        corner = mesh.turn(corner);
        if (corner == no_index) {
            fan.push_back(no_index);
            corner = mesh.corner_of_vertex[vertex];
        }
        if (slice.is_over()) co_await pace;
    } while (corner != first);
}

void ExactSolver::tell_along_edges(Corner corner, double distance, uint32_t label) {
    const ExactFace& face = faces_.faces[triangle_of(corner)];
    const uint32_t k = corner % 3;
    const Corner after = next_corner(corner), before = previous_corner(corner);
    const double forth = face.lengths[k], back = face.lengths[before % 3];
    reach(after, distance + forth, forth > 0 ? second_edge(face, after % 3) : Vec2(0, 0), label);
    reach(before, distance + back, back > 0 ? Vec2(1, 0) : Vec2(0, 0), label);
}

// Light goes out from a vertex: where it has made half a turn on both sides; if it came from nowhere, everywhere.
Task<void> ExactSolver::leave(Pace& pace, ExactSolver& solver, uint32_t vertex) {
    const Vertex state = solver.vertices_[vertex];
    const GrowingList<Corner>& fan = solver.fan_;
    const bool everywhere = state.corner == no_index || solver.faces_.bends[vertex] == Bend::any;
    co_await list_fan(pace, solver, vertex,
                      state.corner == no_index ? solver.mesh_.corner_of_vertex[vertex] : state.corner);
    const uint32_t count = fan.size();
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        if (fan[i] != no_index) solver.tell_along_edges(fan[i], state.distance, state.label);
    });
    if (everywhere) {
        co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
            if (fan[i] != no_index) solver.light(fan[i], state, nullptr, nullptr);
        });
        co_return;
    }
    if (solver.faces_.bends[vertex] == Bend::none) co_return;
    // Half a turn counter-clockwise and clockwise: the corner that it ends in, and the direction from its first edge.
    // A gap is more than that.
    const auto angle = [&](Corner corner) { return second_edge(solver.faces_.faces[triangle_of(corner)], corner % 3); };
    Slice slice(Cost::tens_of_ns);
    uint32_t begin = 1, end = count - 1;
    Vec2 from = turned(angle(state.corner), mirrored(state.direction)), to = state.direction;
    for (; begin < count && fan[begin] != no_index; ++begin) {
        const Vec2 sum = turned(from, angle(fan[begin]));
        if (is_half_turn(sum)) break;
        from = sum;
        if (slice.is_over()) co_await pace;
    }
    for (; end > 0 && fan[end] != no_index; --end) {
        const Vec2 sum = turned(to, angle(fan[end]));
        if (is_half_turn(sum)) break;
        to = sum;
        if (slice.is_over()) co_await pace;
    }
    if (begin >= count || end == 0 || begin > end) co_return;
    from = -mirrored(from);
    if (fan[end] != no_index) to = turned(angle(fan[end]), mirrored(-mirrored(to)));
    co_await each(pace, begin, end + 1, Cost::tens_of_ns, [&](uint32_t i) {
        if (fan[i] != no_index) solver.light(fan[i], state, i == begin ? &from : nullptr, i == end ? &to : nullptr);
    });
}

// Across the triangle at one of its corners, between two directions; null: to the corner's edge.
void ExactSolver::light(Corner corner, const Vertex& state, const Vec2* from, const Vec2* to) {
    const ExactFace& face = faces_.faces[triangle_of(corner)];
    const uint32_t k = corner % 3, next = (k + 1) % 3;
    const double length = face.lengths[next];
    if (face.across[next] == no_index || !(length > 0)) return;
    const Vec2 start(face.lengths[k], 0), along = (Vec2(face.along[k], face.above[k]) - start) / length;
    // Seen from the triangle across, the edge goes the other way.
    send({.x = length - face.along[next],
          .y = -face.above[next],
          .before = state.distance,
          .begin = to ? length - meeting(*to, 0, start, along, length, length) : 0,
          .end = from ? length - meeting(*from, 0, start, along, length, 0) : length,
          .edge = face.across[next],
          .label = state.label,
          .narrow_run = 0});
}

}  // namespace flg
