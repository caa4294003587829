// SPDX-License-Identifier: MIT
#include "surfaces/mesh/nearest_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {

namespace {

// More would only be empty: the cells that a surface passes are few among those of its box.
constexpr double cells_per_triangle = 2;
constexpr double min_cells = 64, max_cells_an_axis = 4096;

// The weights of b and c at the point of the segment b-c, or of the triangle a-b-c, that is nearest to p.
struct Nearest {
    double u, v, square;
};

Nearest on_edge(const Vec3& p, const Vec3& from, const Vec3& to, double u_from, double v_from, double u_to,
                double v_to) {
    const Vec3 along = to - from;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - from).dot(along) / length, 0.0, 1.0) : 0;
    return {u_from + t * (u_to - u_from), v_from + t * (v_to - v_from), (from + t * along - p).squaredNorm()};
}

Nearest in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, to = p - a, normal = ab.cross(ac);
    const double area = normal.squaredNorm();
    if (area > 0) {
        const double u = to.cross(ac).dot(normal) / area, v = ab.cross(to).dot(normal) / area;
        if (u >= 0 && v >= 0 && u + v <= 1) return {u, v, (u * ab + v * ac - to).squaredNorm()};
    }
    Nearest best = on_edge(p, a, b, 0, 0, 1, 0);
    for (const Nearest& other : {on_edge(p, b, c, 1, 0, 0, 1), on_edge(p, c, a, 0, 1, 0, 0)}) {
        if (other.square < best.square) best = other;
    }
    return best;
}

}  // namespace

Vec3 NearestPoints::middle(uint32_t triangle) const {
    const Triple& corners = mesh_.triangles[triangle];
    return (mesh_.position(corners[0]) + mesh_.position(corners[1]) + mesh_.position(corners[2])) / 3;
}

void NearestPoints::measure(uint32_t triangle) {
    const Vec3 centre = middle(triangle);
    lower_ = lower_.cwiseMin(centre);
    upper_ = upper_.cwiseMax(centre);
    for (const uint32_t vertex : mesh_.triangles[triangle]) {
        reach_ = std::max(reach_, (mesh_.position(vertex) - centre).norm());
    }
}

// Cubes, so many as there may be.
void NearestPoints::choose_cells() {
    const Vec3 box = upper_ - lower_;
    const double most = std::max(min_cells, cells_per_triangle * mesh_.triangle_count());
    const auto along = [&](int axis) { return std::min(std::floor(box[axis] / size_) + 1, max_cells_an_axis); };
    size_ = std::max(box.maxCoeff() / max_cells_an_axis, std::numeric_limits<double>::min());
    while (along(0) * along(1) * along(2) > most) size_ *= 1.25;
    for (int axis = 0; axis < 3; ++axis) cells_[static_cast<size_t>(axis)] = static_cast<int32_t>(along(axis));
}

NearestPoints::Cell NearestPoints::cell_of(const Vec3& place) const {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<size_t>(axis);
        const double at = std::floor((place[axis] - lower_[axis]) / size_);
        cell[k] = static_cast<int32_t>(std::clamp(at, 0.0, static_cast<double>(cells_[k] - 1)));
    }
    return cell;
}

uint32_t NearestPoints::index_of(const Cell& cell) const {
    return static_cast<uint32_t>((cell[2] * cells_[1] + cell[1]) * cells_[0] + cell[0]);
}

Task<void> build(Pace& pace, NearestPoints& nearest) {
    const uint32_t triangles = nearest.mesh_.triangle_count();
    nearest.lower_ = nearest.upper_ = nearest.middle(0);
    co_await each(pace, triangles, Cost::tens_of_ns, [&nearest](uint32_t t) { nearest.measure(t); });
    nearest.choose_cells();
    const auto& cells = nearest.cells_;
    const auto cell_of = [&nearest](uint32_t t) { return nearest.index_of(nearest.cell_of(nearest.middle(t))); };
    Groups groups = co_await group_by(pace, triangles, size_t(cells[0]) * size_t(cells[1]) * size_t(cells[2]), cell_of);
    nearest.of_cell_ =
        std::allocate_shared<Groups>(std::pmr::polymorphic_allocator<Groups>(pace.memory()), std::move(groups));
}

void NearestPoints::begin(const Vec3& place) {
    place_ = place;
    centre_ = cell_of(place_);
    last_ring_ = 0;
    for (size_t k = 0; k < 3; ++k) {
        last_ring_ = std::max({last_ring_, centre_[k], cells_[k] - 1 - centre_[k]});
    }
    square_ = std::numeric_limits<double>::infinity();
    next_ = end_ = 0;
    ring_ = 0;
    enter_ring();
}

void NearestPoints::enter_ring() {
    for (size_t k = 0; k < 3; ++k) {
        first_[k] = std::max(centre_[k] - ring_, 0);
        last_[k] = std::min(centre_[k] + ring_, cells_[k] - 1);
    }
    cell_ = first_;
    in_ring_ = true;
}

// Looks at the cell, and steps to the next one of the cube: across its inside in one go. False at the cube's end.
bool NearestPoints::next_cell() {
    const auto away = [&](size_t k) { return std::abs(cell_[k] - centre_[k]); };
    if (std::max({away(0), away(1), away(2)}) == ring_) {
        const uint32_t index = index_of(cell_);
        next_ = of_cell_->offsets[index];
        end_ = of_cell_->offsets[index + 1];
        ++cell_[0];
    } else {
        cell_[0] = centre_[0] + ring_;  // may lie beyond the grid
    }
    if (cell_[0] <= last_[0]) return true;
    cell_[0] = first_[0];
    if (++cell_[1] <= last_[1]) return true;
    cell_[1] = first_[1];
    return ++cell_[2] <= last_[2];
}

void NearestPoints::try_triangle(uint32_t triangle) {
    const Triple& corners = mesh_.triangles[triangle];
    const Nearest near =
        in_triangle(place_, mesh_.position(corners[0]), mesh_.position(corners[1]), mesh_.position(corners[2]));
    if (near.square > square_ || (near.square == square_ && triangle > found_.triangle)) return;
    square_ = near.square;
    const Vec3 a = mesh_.position(corners[0]);
    found_place_ = a + near.u * (mesh_.position(corners[1]) - a) + near.v * (mesh_.position(corners[2]) - a);
    const auto u = static_cast<float>(std::clamp(near.u, 0.0, 1.0));
    found_ = {triangle, u, std::min(static_cast<float>(std::clamp(near.v, 0.0, 1.0)), 1 - u)};
}

bool NearestPoints::find(uint32_t count) {
    for (; count > 0; --count) {
        if (next_ < end_) {
            try_triangle(of_cell_->items[next_++]);
        } else if (in_ring_) {
            in_ring_ = next_cell();
        } else {
            const double beyond = ring_ * size_ - reach_;  // what the next ring's triangles are away, at least
            if (ring_ == last_ring_ || (beyond > 0 && beyond * beyond > square_)) return true;
            ++ring_;
            enter_ring();
        }
    }
    return false;
}

}  // namespace flg
