// SPDX-License-Identifier: MIT
#include "inflation/height_field.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t batch = 16;
constexpr double source = 4;
// Keeps heights above zero where triangles are obtuse; it is felt nowhere else.
constexpr double least_weight = 1e-6;

}  // namespace

HeightField::HeightField(InflatedPart& part, Memory* memory)
    : part_(part),
      memory_(memory),
      row_of_vertex_(part.points.size(), memory),
      cotangents_(part.triangles.size(), memory),
      load_(part.points.size(), memory),
      places_(memory) {
    part.squares = Buffer<double>(part.points.size(), memory);
    places_.reserve(part.points.size());
}

bool HeightField::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void HeightField::step() {
    const auto vertices = static_cast<uint32_t>(part_.points.size());
    const auto triangles = static_cast<uint32_t>(part_.triangles.size());
    constexpr uint32_t width = CholeskySolve::width;
    switch (pass_) {
        case Pass::number:
            for (const uint32_t stop = std::min(vertices, at_ + batch); at_ < stop; ++at_) {
                row_of_vertex_[at_] = part_.on_border[at_] ? no_row : rows_++;
                load_[at_] = 0;
                if (!part_.on_border[at_]) places_.emplace_back(part_.points[at_].x, part_.points[at_].y, 0);
            }
            if (at_ < vertices) break;
            at_ = 0;
            pass_ = Pass::weigh;
            break;
        case Pass::weigh:
            for (const uint32_t stop = std::min(triangles, at_ + batch / 2); at_ < stop; ++at_) {
                const TriangleVertices& t = part_.triangles[at_];
                const Point2 &a = part_.points[t[0]], &b = part_.points[t[1]], &c = part_.points[t[2]];
                const double twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                const auto cotangent = [&](const Point2& at, const Point2& p, const Point2& q) {
                    return 0.5 * ((p.x - at.x) * (q.x - at.x) + (p.y - at.y) * (q.y - at.y)) / twice;
                };
                cotangents_[at_] = {cotangent(a, b, c), cotangent(b, c, a), cotangent(c, a, b)};
                for (const uint32_t vertex : t) load_[vertex] += source * twice / 6;
            }
            if (at_ < triangles) break;
            laplacian_.emplace(LaplacianInput{.triangles = {part_.triangles.data(), triangles},
                                              .cotangents = {cotangents_.data(), triangles},
                                              .row_of_vertex = {row_of_vertex_.data(), vertices},
                                              .row_count = rows_,
                                              .least_weight = least_weight},
                               matrix_, memory_);
            pass_ = Pass::assemble;
            break;
        case Pass::assemble:
            if (!laplacian_->run(1)) break;
            laplacian_.reset();
            order_.emplace(matrix_, places_, memory_);
            pass_ = Pass::order;
            break;
        case Pass::order:
            if (!order_->run(1)) break;
            cholesky_.emplace(matrix_, order_->take_order(), memory_);
            order_.reset();
            pass_ = Pass::factor;
            break;
        case Pass::factor:
            if (!cholesky_->run(1)) break;
            right_ = Buffer<double>(size_t{width} * rows_, memory_);
            at_ = 0;
            pass_ = Pass::load;
            break;
        case Pass::load:
            for (const uint32_t stop = std::min(vertices, at_ + batch); at_ < stop; ++at_) {
                if (row_of_vertex_[at_] == no_row) continue;
                double* row = &right_[size_t{width} * row_of_vertex_[at_]];
                std::fill_n(row, width, 0);
                row[0] = load_[at_];
            }
            if (at_ < vertices) break;
            solve_.emplace(*cholesky_, std::span<double>(right_.data(), right_.size()), memory_);
            pass_ = Pass::solve;
            break;
        case Pass::solve:
            if (!solve_->run(1)) break;
            at_ = 0;
            pass_ = Pass::write;
            break;
        case Pass::write:
            for (const uint32_t stop = std::min(vertices, at_ + batch); at_ < stop; ++at_) {
                const uint32_t row = row_of_vertex_[at_];
                const double square = row == no_row ? 0 : std::max(0.0, right_[size_t{width} * row]);
                part_.squares[at_] = square;
                part_.highest = std::max(part_.highest, part_.thickness * std::sqrt(square));
            }
            if (at_ == vertices) pass_ = Pass::done;
            break;
        case Pass::done: break;
    }
}

}  // namespace flg
