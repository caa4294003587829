// SPDX-License-Identifier: MIT
#include "inflation/part_mesh.h"

#include <algorithm>
#include <cmath>

#include "skeletons/plane.h"

namespace flg {

namespace {

constexpr uint32_t batch = 16;
// Of the vertices that a part should have if it is round, and of the most that it gets for being narrow.
constexpr double usual_vertices = 500, most_for_width = 3000;
constexpr double vertices_by_area = 0.866;  // area of a lattice's cell, by its spacing squared
constexpr double most_lattice_places = 1e6, most_border_points = 2e4;
// By the spacing: how far points may be off the way between those around them to be dropped; edges that are divided; what
// the lattice keeps from points of the border.
constexpr double off_line = 0.02, longest_edge = 1.3, clearance = 0.75;
constexpr uint32_t longest_chain = 64;

// From the line through a and b.
double off(const Point2& a, const Point2& b, const Point2& p) {
    const double length = distance(a, b);
    if (length == 0) return distance(a, p);
    return std::fabs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
}

Point2 between(const Point2& a, const Point2& b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

}  // namespace

PartMesh::PartMesh(const InflationOptions& options, InflatedPart& out, Memory* memory)
    : out_(out),
      contour_(out.contour),
      memory_(memory),
      wanted_spacing_(options.spacing),
      low_(out.contour.points[0]),
      high_(out.contour.points[0]),
      border_(memory),
      next_(memory),
      owner_(memory),
      kept_(memory) {
    out.thickness = options.thickness;
}

bool PartMesh::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void PartMesh::step() {
    switch (pass_) {
        case Pass::measure: {
            const Point2 &p = contour_.points[at_], &q = contour_.points[contour_.next(at_)], &o = contour_.points[0];
            low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
            high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
            perimeter_ += distance(p, q);
            twice_area_ += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
            if (++at_ == contour_.size()) measure_end();
            break;
        }
        case Pass::thin: thin(); break;
        case Pass::triangulate:
            if (triangulation_->run(1)) end_triangulation();
            break;
        case Pass::number:
            for (const uint32_t stop = std::min(triangulation_->triangle_count(), at_ + batch); at_ < stop; ++at_)
                number_[at_] = triangulation_->is_inside(at_) ? static_cast<int32_t>(inside_count_++) : -1;
            if (at_ == triangulation_->triangle_count()) begin_lattice();
            break;
        case Pass::clear: {
            const auto places = static_cast<uint32_t>(lattice_.size());
            for (const uint32_t stop = std::min(places, at_ + 8 * batch); at_ < stop; ++at_) lattice_[at_] = 0;
            if (at_ < places) break;
            at_ = 0;
            pass_ = Pass::mark;
            break;
        }
        case Pass::mark:
            mark(at_);
            if (++at_ == border_.size()) {
                at_ = 0;
                searched_ = 0;
                pass_ = Pass::choose;
            }
            break;
        // Counts the places of the lattice that are inside: what memory is needed.
        case Pass::choose:
            for (const auto stop = std::min<uint32_t>(static_cast<uint32_t>(lattice_.size()), at_ + batch); at_ < stop;
                 ++at_) {
                if (at_ % lattice_width_ == 0) inside_ = false;
                inside_ ^= (lattice_[at_] & 1) != 0;
                const bool taken = inside_ && (lattice_[at_] & 2) == 0;
                lattice_[at_] = taken;
                searched_ += taken;
            }
            if (at_ == lattice_.size()) {
                const uint32_t vertices = border_count_ + searched_;
                most_vertices_ = 2 * vertices + 64;
                const size_t room = 2 * size_t{most_vertices_} + 64;
                mesh_.emplace(room, 2 * room, memory_);
                waiting_ = Buffer<int32_t>(2 * room, memory_);
                is_waiting_ = Buffer<uint8_t>(2 * room, memory_);
                at_ = 0;
                pass_ = Pass::extract;
            }
            break;
        case Pass::extract: {
            // Vertices, then triangles.
            const uint32_t triangles = triangulation_->triangle_count(), all = border_count_ + triangles;
            for (const uint32_t stop = std::min(all, at_ + batch); at_ < stop; ++at_) {
                if (at_ < border_count_) {
                    mesh_->add_vertex(border_[at_], true);
                    continue;
                }
                const uint32_t t = at_ - border_count_;
                if (number_[t] < 0) continue;
                const auto& from = triangulation_->triangle(t);
                PlaneMesh::Triangle to{from.vertices, {-1, -1, -1}};
                for (uint32_t k = 0; k < 3; ++k)
                    if (!from.is_edge[k] && from.neighbours[k] >= 0) to.neighbours[k] = number_[from.neighbours[k]];
                mesh_->add_triangle(to);
                mesh_->check(static_cast<int32_t>(mesh_->triangle_count()) - 1);
            }
            if (at_ == all) end_extraction();
            break;
        }
        case Pass::legalize:
            if (mesh_->legalize([this](int32_t t) { changed(t); })) pass_ = then_;
            break;
        case Pass::fill: fill(); break;
        case Pass::search: search(); break;
        case Pass::gather:
            for (const uint32_t stop = std::min(mesh_->triangle_count(), at_ + batch); at_ < stop; ++at_)
                changed(static_cast<int32_t>(at_));
            if (at_ == mesh_->triangle_count()) pass_ = Pass::refine;
            break;
        case Pass::refine: refine(); break;
        case Pass::write: write(); break;
        case Pass::done: break;
    }
}

Point2 PartMesh::scaled(const Point2& p) const {
    return {std::ldexp(p.x - middle_.x, -exponent_), std::ldexp(p.y - middle_.y, -exponent_)};
}

void PartMesh::measure_end() {
    const double width = high_.x - low_.x, height = high_.y - low_.y;
    middle_ = {low_.x + width / 2, low_.y + height / 2};
    exponent_ = std::ilogb(std::max(width, height));
    const double area = std::max(twice_area_ / 2, 1e-12 * width * height);
    out_.area = area;
    double spacing = wanted_spacing_;
    if (!(spacing > 0))
        spacing = std::max(std::min(std::sqrt(area / (vertices_by_area * usual_vertices)), area / (4 * perimeter_)),
                           std::sqrt(area / (vertices_by_area * most_for_width)));
    spacing = std::max({spacing, std::sqrt(width * height / (vertices_by_area * most_lattice_places)),
                        perimeter_ / most_border_points});
    out_.spacing = spacing;
    spacing_ = std::ldexp(spacing, -exponent_);
    at_ = 0;
    pass_ = Pass::thin;
}

// Keeps a point, or drops it: if all points dropped since the last one kept are nearly on the way to the next.
void PartMesh::thin() {
    const uint32_t begin = contour_.offsets[ring_], end = contour_.offsets[ring_ + 1];
    if (at_ == begin) kept_.assign(1, at_++);
    if (at_ < end) {
        const uint32_t last = kept_.back();
        const Point2 from = scaled(contour_.points[last]), to = scaled(contour_.points[contour_.next(at_)]);
        bool keep = !thinned_ || at_ - last >= longest_chain || distance(from, to) > spacing_;
        for (uint32_t i = last + 1; i <= at_ && !keep; ++i)
            keep = off(from, to, scaled(contour_.points[i])) > off_line * spacing_;
        if (keep) kept_.push_back(at_);
        ++at_;
    }
    if (at_ == end) end_ring();
}

void PartMesh::end_ring() {
    const uint32_t begin = contour_.offsets[ring_], end = contour_.offsets[ring_ + 1];
    if (kept_.size() < 3) {
        kept_.clear();
        for (uint32_t i = begin; i < end; ++i) kept_.push_back(i);
    }
    const auto first = static_cast<uint32_t>(border_.size());
    for (size_t i = 0; i < kept_.size(); ++i) add_edge(kept_[i], kept_[i + 1 == kept_.size() ? 0 : i + 1]);
    next_.back() = first;
    if (++ring_ == contour_.ring_count()) end_thinning();
}

void PartMesh::add_edge(uint32_t from, uint32_t to) {
    const Point2 a = scaled(contour_.points[from]), b = scaled(contour_.points[to]);
    const double length = distance(a, b);
    const auto pieces =
        length > longest_edge * spacing_ ? static_cast<uint32_t>(std::ceil(length / spacing_ - 0.3)) : 1u;
    for (uint32_t i = 0; i < pieces; ++i) {
        border_.push_back(i == 0 ? a : between(a, b, static_cast<double>(i) / pieces));
        next_.push_back(static_cast<uint32_t>(border_.size()));
        owner_.push_back(from);
    }
}

void PartMesh::end_thinning() {
    border_count_ = static_cast<uint32_t>(border_.size());
    triangulation_.emplace(border_, next_, memory_);
    pass_ = Pass::triangulate;
}

void PartMesh::end_triangulation() {
    ContourFault fault = triangulation_->fault();
    if (fault.kind != ContourFault::Kind::none) {
        if (!thinned_) {
            fault.first = owner_[fault.first];
            fault.second = owner_[fault.second];
            throw describe_fault(contour_, fault);
        }
        thinned_ = false;
        border_.clear();
        next_.clear();
        owner_.clear();
        triangulation_.reset();
        at_ = ring_ = 0;
        pass_ = Pass::thin;
        return;
    }
    number_ = Buffer<int32_t>(triangulation_->triangle_count(), memory_);
    at_ = 0;
    pass_ = Pass::number;
}

void PartMesh::begin_lattice() {
    const Point2 low = scaled(low_), high = scaled(high_);
    lattice_origin_ = low;
    lattice_width_ = static_cast<uint32_t>((high.x - low.x) / spacing_) + 2;
    lattice_height_ = static_cast<uint32_t>((high.y - low.y) / (spacing_ * vertices_by_area)) + 2;
    lattice_ = Buffer<uint8_t>(size_t{lattice_width_} * lattice_height_, memory_);
    at_ = 0;
    pass_ = Pass::clear;
}

Point2 PartMesh::lattice_point(uint32_t row, uint32_t column) const {
    return {lattice_origin_.x + spacing_ * (column + (row % 2 == 0 ? 0.25 : 0.75)),
            lattice_origin_.y + spacing_ * vertices_by_area * (row + 0.5)};
}

// Of the lattice: what is too near to a point of the border, and where the edge from it crosses the rows.
void PartMesh::mark(uint32_t vertex) {
    const Point2 &a = border_[vertex], &b = border_[next_[vertex]];
    const double reach = clearance * spacing_, row_height = spacing_ * vertices_by_area;
    const auto row_at = [&](double y) {
        return static_cast<int>(std::ceil((y - lattice_origin_.y) / row_height - 0.5));
    };
    const auto column_at = [&](double x, int row) {
        return static_cast<int>(std::ceil((x - lattice_origin_.x) / spacing_ - (row % 2 == 0 ? 0.25 : 0.75)));
    };
    const int width = static_cast<int>(lattice_width_), height = static_cast<int>(lattice_height_);
    for (int row = std::max(0, row_at(a.y - reach)); row < std::min(height, row_at(a.y + reach) + 1); ++row) {
        for (int column = std::max(0, column_at(a.x - reach, row));
             column < std::min(width, column_at(a.x + reach, row) + 1); ++column) {
            if (distance(a, lattice_point(row, column)) < reach) lattice_[size_t{lattice_width_} * row + column] |= 2;
        }
    }
    // Rows with a.y < y <= b.y, or the other way around: each crossing counts for one edge.
    for (int row = std::max(0, row_at(std::min(a.y, b.y)) - 1);
         row <= std::min(height - 1, row_at(std::max(a.y, b.y)) + 1); ++row) {
        const double y = lattice_point(row, 0).y;
        if ((a.y < y) == (b.y < y)) continue;
        const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        const int column = std::max(0, column_at(x, row));
        if (column < width) lattice_[size_t{lattice_width_} * row + column] ^= 1;
    }
}

void PartMesh::end_extraction() {
    triangulation_.reset();
    number_ = {};
    at_ = 0;
    legalize_then(Pass::fill);
}

void PartMesh::legalize_then(Pass pass) {
    then_ = pass;
    pass_ = Pass::legalize;
}

}  // namespace flg
