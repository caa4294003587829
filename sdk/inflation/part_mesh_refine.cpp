// SPDX-License-Identifier: MIT
// Of the triangulation of a part: points come in.
#include <algorithm>
#include <cmath>

#include "inflation/part_mesh.h"

namespace flg {

namespace {

constexpr uint32_t batch = 64;  // places, triangles or vertices a unit
constexpr uint32_t longest_walk = 200;
// By the spacing: edges that triangles are not improved below, and the largest circle through a triangle.
constexpr double least_edge = 1.0 / 8, largest_circle = 1.0;
constexpr double circle_by_edge = 1.18;  // of a triangle with an angle of 25 degrees

double squared(const Point2& a, const Point2& b) {
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

Point2 middle(const Point2& a, const Point2& b) {
    return {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
}

Point2 circumcentre(const Point2& a, const Point2& b, const Point2& c) {
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double bb = bx * bx + by * by, cc = cx * cx + cy * cy, twice = 2 * (bx * cy - by * cx);
    return {a.x + (cy * bb - by * cc) / twice, a.y + (bx * cc - cx * bb) / twice};
}

}  // namespace

// The next place of the lattice that is taken.
void PartMesh::fill() {
    const auto places = static_cast<uint32_t>(lattice_.size());
    const uint32_t stop = std::min(places, at_ + batch);
    while (at_ < stop && lattice_[at_] == 0) ++at_;
    if (at_ == places) {
        lattice_ = {};
        refining_ = true;
        at_ = 0;
        pass_ = Pass::gather;
        return;
    }
    if (at_ == stop) return;
    const uint32_t row = at_ / lattice_width_;
    const Point2 point = lattice_point(row, at_ % lattice_width_);
    const int32_t from = mesh_->triangle_of(row == lattice_row_ ? last_ : row_first_);
    const PlaneMesh::Place place = mesh_->locate(from, point, longest_walk);
    if (place.triangle < 0 || place.beyond) {
        // A notch in between: looked for everywhere.
        searched_ = 0;
        pass_ = Pass::search;
        return;
    }
    insert_at(place);
}

void PartMesh::search() {
    const Point2 point = lattice_point(at_ / lattice_width_, at_ % lattice_width_);
    for (const uint32_t stop = std::min(mesh_->triangle_count(), searched_ + batch / 2); searched_ < stop;
         ++searched_) {
        const auto t = static_cast<int32_t>(searched_);
        const PlaneMesh::Place place = mesh_->locate(t, point, 1);
        if (place.triangle != t || place.beyond) continue;
        insert_at(place);
        return;
    }
    if (searched_ < mesh_->triangle_count()) return;
    ++at_;
    pass_ = Pass::fill;
}

void PartMesh::insert_at(const PlaneMesh::Place& place) {
    const uint32_t row = at_ / lattice_width_;
    if (mesh_->insert(place.triangle, place.side, lattice_point(row, at_ % lattice_width_))) {
        last_ = static_cast<int32_t>(mesh_->vertex_count()) - 1;
        if (row != lattice_row_) row_first_ = last_;
        lattice_row_ = row;
    }
    ++at_;
    legalize_then(Pass::fill);
}

void PartMesh::changed(int32_t triangle) {
    if (!refining_) return;
    while (known_ < mesh_->triangle_count()) is_waiting_[known_++] = 0;
    if (is_waiting_[triangle] != 0) return;
    is_waiting_[triangle] = 1;
    waiting_[(first_waiting_ + waiting_count_++) % waiting_.size()] = triangle;
}

void PartMesh::refine() {
    if (waiting_count_ == 0) {
        const size_t vertices = mesh_->vertex_count(), triangles = mesh_->triangle_count();
        out_.points = Buffer<Point2>(vertices, memory_);
        out_.on_border = Buffer<uint8_t>(vertices, memory_);
        out_.triangles = Buffer<TriangleVertices>(triangles, memory_);
        at_ = 0;
        pass_ = Pass::write;
        return;
    }
    const int32_t t = waiting_[first_waiting_];
    first_waiting_ = first_waiting_ + 1 == waiting_.size() ? 0 : first_waiting_ + 1;
    --waiting_count_;
    is_waiting_[t] = 0;
    if (split_chord(t)) return;
    if (mesh_->vertex_count() < most_vertices_) improve(t);
}

bool PartMesh::split_chord(int32_t triangle) {
    for (uint32_t k = 0; k < 3; ++k) {
        if (!mesh_->is_chord(triangle, k)) continue;
        const PlaneMesh::Triangle& t = mesh_->triangle(triangle);
        const Point2 point = middle(mesh_->point(t.vertices[(k + 1) % 3]), mesh_->point(t.vertices[(k + 2) % 3]));
        // A chord so short that its middle is not between its ends' neighbours is beyond what doubles can part.
        if (!mesh_->insert(triangle, static_cast<int32_t>(k), point))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: at (%.9g, %.9g) it is too narrow to be inflated",
                          std::ldexp(point.x, exponent_) + middle_.x, std::ldexp(point.y, exponent_) + middle_.y);
        legalize_then(Pass::refine);
        return true;
    }
    return false;
}

// Adds the centre of a bad triangle's circle, or splits the edge of the border that is in its way.
void PartMesh::improve(int32_t triangle) {
    const PlaneMesh::Triangle& t = mesh_->triangle(triangle);
    const Point2 p[3] = {mesh_->point(t.vertices[0]), mesh_->point(t.vertices[1]), mesh_->point(t.vertices[2])};
    double across[3];
    for (uint32_t k = 0; k < 3; ++k) across[k] = squared(p[(k + 1) % 3], p[(k + 2) % 3]);
    const auto sharpest = static_cast<uint32_t>(std::min_element(across, across + 3) - across);
    const double shortest = across[sharpest];
    if (shortest < least_edge * least_edge * spacing_ * spacing_) return;
    const Point2 centre = circumcentre(p[0], p[1], p[2]);
    const double radius = squared(centre, p[0]);
    const bool corner = t.neighbours[(sharpest + 1) % 3] < 0 && t.neighbours[(sharpest + 2) % 3] < 0;
    const bool sharp = radius > circle_by_edge * circle_by_edge * shortest && !corner;
    if (!sharp && radius <= largest_circle * largest_circle * spacing_ * spacing_) return;
    const PlaneMesh::Place place = mesh_->locate(triangle, centre, longest_walk);
    if (place.triangle < 0) return;
    if (place.beyond) {
        split_border(place.triangle, static_cast<uint32_t>(place.side));
        return;
    }
    // An edge of the border that would see the new point at more than a right angle is split instead.
    const PlaneMesh::Triangle around = mesh_->triangle(place.triangle);
    const auto split_if_seen = [&](int32_t index) {
        const PlaneMesh::Triangle& near = mesh_->triangle(index);
        for (uint32_t k = 0; k < 3; ++k) {
            if (near.neighbours[k] >= 0) continue;
            const Point2 &a = mesh_->point(near.vertices[(k + 1) % 3]), &b = mesh_->point(near.vertices[(k + 2) % 3]);
            if ((a.x - centre.x) * (b.x - centre.x) + (a.y - centre.y) * (b.y - centre.y) >= 0) continue;
            split_border(index, k);
            return true;
        }
        return false;
    };
    if (split_if_seen(place.triangle)) return;
    for (const int32_t neighbour : around.neighbours)
        if (neighbour >= 0 && split_if_seen(neighbour)) return;
    if (mesh_->insert(place.triangle, place.side, centre)) legalize_then(Pass::refine);
}

void PartMesh::split_border(int32_t triangle, uint32_t side) {
    const PlaneMesh::Triangle& t = mesh_->triangle(triangle);
    const Point2 &a = mesh_->point(t.vertices[(side + 1) % 3]), &b = mesh_->point(t.vertices[(side + 2) % 3]);
    if (squared(a, b) < 4 * least_edge * least_edge * spacing_ * spacing_) return;
    if (mesh_->insert(triangle, static_cast<int32_t>(side), middle(a, b))) legalize_then(Pass::refine);
}

void PartMesh::write() {
    const uint32_t vertices = mesh_->vertex_count(), all = vertices + mesh_->triangle_count();
    for (const uint32_t stop = std::min(all, at_ + batch); at_ < stop; ++at_) {
        if (at_ >= vertices) {
            const auto& corners = mesh_->triangle(static_cast<int32_t>(at_ - vertices)).vertices;
            for (uint32_t k = 0; k < 3; ++k) out_.triangles[at_ - vertices][k] = static_cast<uint32_t>(corners[k]);
            continue;
        }
        const auto vertex = static_cast<int32_t>(at_);
        const Point2& p = mesh_->point(vertex);
        out_.on_border[at_] = mesh_->on_border(vertex);
        const bool original = at_ < border_count_ && (at_ == 0 || owner_[at_] != owner_[at_ - 1]);
        out_.points[at_] = original
                               ? contour_.points[owner_[at_]]
                               : Point2{std::ldexp(p.x, exponent_) + middle_.x, std::ldexp(p.y, exponent_) + middle_.y};
    }
    if (at_ == all) {
        mesh_.reset();
        pass_ = Pass::done;
    }
}

}  // namespace flg
