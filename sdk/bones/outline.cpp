// SPDX-License-Identifier: MIT
// Triangles seen from the front and, turned over, those seen from behind cover the outline's inside; so it is where the
// borders of both sets wind around. They are put together to one ring, from loop to loop and back again by the same
// ways, which counts for nothing; the repair of contours (contour_repair.h) takes what it winds around, and of that the
// largest piece with its holes.
#include "bones/outline.h"

#include <algorithm>

#include "runtime/each.h"
#include "skeletons/contour_repair.h"

namespace flg {
namespace {

constexpr size_t max_sides = 1 << 24;

bool counts(const HeldOutline& outline, uint32_t triangle) {
    const uint32_t region = outline.surface->mesh().regions[triangle];
    return outline.regions.empty() || (region < outline.regions.size() && outline.regions[region]);
}

// Area vectors and positions of all triangles that count.
struct Sums {
    Vec3 area = Vec3::Zero(), middle = Vec3::Zero();
    uint32_t count = 0;
};

Task<Sums> sum_triangles(Pace& pace, const HeldOutline& outline) {
    const Mesh& mesh = outline.surface->mesh();
    Sums sums;
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t triangle) {
        if (!counts(outline, triangle)) return;
        const Triple& t = mesh.triangles[triangle];
        const Vec3 a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
        sums.area += (b - a).cross(c - a);
        sums.middle += (a + b + c) / 3;
        ++sums.count;
    });
    co_return sums;
}

OutlinePlane plane_of(const Sums& sums, Vec3 towards) {
    if (sums.count == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.regions have no triangles");
    if (towards.squaredNorm() == 0) towards = sums.area;
    if (!(towards.squaredNorm() > 0))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.direction is 0, and the triangles look in all directions alike: say from where");
    OutlinePlane plane;
    plane.towards = towards.normalized();
    // Up is up, or where it is looked at from above or below, away from the viewer.
    const Vec3 world_up = std::abs(plane.towards.y()) < 0.99 ? Vec3::UnitY() : Vec3(-Vec3::UnitZ());
    plane.right = world_up.cross(plane.towards).normalized();
    plane.up = plane.towards.cross(plane.right);
    plane.origin = sums.middle / sums.count;
    return plane;
}

// Sides of triangles to what is not seen from the same side, in the order that keeps the covered inside to the left.
class Borders {
public:
    Borders(const HeldOutline& outline, Memory* memory)
        : outline_(outline),
          mesh_(outline.surface->mesh()),
          first_side_(mesh_.vertex_count(), memory),
          sides_(std::min(3 * size_t{mesh_.triangle_count()}, max_sides), memory) {}

    size_t count() const { return count_; }
    void clear(uint32_t vertex) { first_side_[vertex] = no_index; }

    void add_sides(uint32_t triangle) {
        if (!counts(outline_, triangle)) return;
        const bool front = is_front(triangle);
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t other = mesh_.neighbours[triangle][k];
            if (other != no_index && counts(outline_, other) && is_front(other) == front) continue;
            const uint32_t a = mesh_.triangles[triangle][k], b = mesh_.triangles[triangle][(k + 1) % 3];
            const uint32_t from = front ? a : b, to = front ? b : a;
            if (count_ == max_sides) throw Failure(FLG_ERROR_LIMIT, "the outline has more than %zu sides", max_sides);
            sides_[count_] = {to, first_side_[from]};
            first_side_[from] = static_cast<uint32_t>(count_++);
        }
    }

    // Takes a side that begins at a vertex; returns where it ends, no_index: there is none left.
    uint32_t follow(uint32_t vertex) {
        const uint32_t side = first_side_[vertex];
        if (side == no_index) return no_index;
        first_side_[vertex] = sides_[side].next;
        return sides_[side].to;
    }

private:
    struct Side {
        uint32_t to;
        uint32_t next;  // from the same vertex; no_index: none
    };

    bool is_front(uint32_t triangle) const {
        const Triple& t = mesh_.triangles[triangle];
        const Vec3 a = mesh_.position(t[0]);
        return (mesh_.position(t[1]) - a).cross(mesh_.position(t[2]) - a).dot(outline_.plane.towards) > 0;
    }

    const HeldOutline& outline_;
    const Mesh& mesh_;
    Buffer<uint32_t> first_side_;  // by vertex
    Buffer<Side> sides_;
    size_t count_ = 0;
};

// One ring, not cleaned.
Task<Contour> trace_borders(Pace& pace, const HeldOutline& outline) {
    const Mesh& mesh = outline.surface->mesh();
    Borders borders(outline, pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t vertex) { borders.clear(vertex); });
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns,
                  [&](uint32_t triangle) { borders.add_sides(triangle); });

    Contour ring(pace.memory());
    ring.points.reserve(2 * borders.count());
    ring.input_points.reserve(2 * borders.count());
    std::pmr::vector<uint32_t> loop_begins(pace.memory());
    loop_begins.reserve(borders.count() / 2);
    const auto add_point = [&](uint32_t vertex) {
        const Vec3 p = mesh.position(vertex) - outline.plane.origin;
        ring.points.push_back({p.dot(outline.plane.right), p.dot(outline.plane.up)});
        ring.input_points.push_back(vertex);
    };
    // Sides until there are none: as many end at a vertex as begin there, so a way ends where it began.
    uint32_t here = no_index, vertex = 0;
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        const bool is_on_loop = here != no_index;
        here = borders.follow(is_on_loop ? here : vertex);
        if (here == no_index) return ++vertex < mesh.vertex_count();
        if (!is_on_loop) {
            loop_begins.push_back(vertex);
            add_point(vertex);
        }
        add_point(here);
        return true;
    });
    // Back by the ways between the loops; the last one's own beginning is there already.
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        if (loop_begins.size() <= 1) return false;
        loop_begins.pop_back();
        add_point(loop_begins.back());
        return true;
    });
    // The ring is closed by itself.
    if (ring.size() > 1) {
        ring.points.pop_back();
        ring.input_points.pop_back();
    }
    ring.offsets.push_back(0);
    ring.offsets.push_back(ring.size());
    co_return ring;
}

}  // namespace

void HeldOutline::show() noexcept {
    view_contour_ = {.struct_size = sizeof view_contour_,
                     .point_count = contour.size(),
                     .points = &contour.points.data()->x,
                     .ring_offsets = contour.offsets.data(),
                     .ring_count = contour.ring_count(),
                     .reserved = 0};
    view_ = {};
    view_.struct_size = sizeof view_;
    write_origin(surface->origin, view_.origin);
    view_.contour = &view_contour_;
    for (int row = 0; row < 3; ++row) {
        view_.placement[4 * row] = plane.right[row];
        view_.placement[4 * row + 1] = plane.up[row];
        view_.placement[4 * row + 2] = plane.towards[row];
        view_.placement[4 * row + 3] = plane.origin[row];
    }
}

Task<void> make_outline(Pace& pace, std::shared_ptr<HeldOutline> outline) {
    pace.stage("outline");
    const Sums sums = co_await sum_triangles(pace, *outline);
    outline->plane = plane_of(sums, outline->towards);
    const Contour borders = co_await trace_borders(pace, *outline);
    outline->contour = co_await repair_contour(pace, borders);
}

}  // namespace flg
