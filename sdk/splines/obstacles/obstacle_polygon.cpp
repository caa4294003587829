// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle_polygon.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

struct PolygonObstacle::Shape {
    std::pmr::vector<Vertex> vertices;
    Box box;
    double core_depth;
};

namespace {

constexpr uint32_t net = 8;
constexpr double near_edge = 1e-3;  // of its length: inside, unless others are as near

template <class V>
double cross(const V& o, const V& a, const V& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

template <class V>
bool meet(const V& a, const V& b, const V& c, const V& d) {
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
    if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
    const double c_side = cross(a, b, c), d_side = cross(a, b, d), a_side = cross(c, d, a), b_side = cross(c, d, b);
    return !((c_side > 0 && d_side > 0) || (c_side < 0 && d_side < 0)) &&
           !((a_side > 0 && b_side > 0) || (a_side < 0 && b_side < 0));
}

// Neighbouring edges meet in their corner only, unless one folds back onto the other.
template <class V>
void check_edges(const std::pmr::vector<V>& v) {
    const uint32_t n = static_cast<uint32_t>(v.size());
    for (uint32_t i = 0; i < n; ++i) {
        const V &a = v[i], &b = v[(i + 1) % n], &c = v[(i + 2) % n];
        if (a.x == b.x && a.y == b.y) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a polygon's edge %u has no length", i);
        const double forward = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
        if (cross(a, b, c) == 0 && forward < 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a polygon's edges %u and %u lie on each other", i, (i + 1) % n);
        }
        for (uint32_t j = i + 2; j < n; ++j) {
            if (i == 0 && j + 1 == n) continue;
            if (meet(a, b, v[j], v[(j + 1) % n])) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a polygon's edges %u and %u meet", i, j);
            }
        }
    }
}

// The depth to which the polygon stays in one piece: half of its narrowest neck, which has a corner that points inwards
// on one side at least; and no more than area over perimeter, which a disc inside always exceeds.
template <class V>
double depth_of_core(const std::pmr::vector<V>& v, double area) {
    const uint32_t n = static_cast<uint32_t>(v.size());
    double perimeter = 0, neck = std::numeric_limits<double>::infinity();
    for (uint32_t i = 0; i < n; ++i) {
        const V &a = v[(i + n - 1) % n], &b = v[i], &c = v[(i + 1) % n];
        perimeter += std::hypot(c.x - b.x, c.y - b.y);
        if (cross(a, b, c) >= 0) continue;
        for (uint32_t j = 0; j < n; ++j) {
            const V &p = v[j], &q = v[(j + 1) % n];
            const double along_x = q.x - p.x, along_y = q.y - p.y;
            const double share =
                ((b.x - p.x) * along_x + (b.y - p.y) * along_y) / (along_x * along_x + along_y * along_y);
            const double t = std::clamp(share, 0.0, 1.0);
            const double to_x = p.x + t * along_x - b.x, to_y = p.y + t * along_y - b.y;
            // Places inside whose nearest point is the corner lie between the normals of its edges.
            const bool opposite =
                to_x * (b.x - a.x) + to_y * (b.y - a.y) >= 0 && to_x * (c.x - b.x) + to_y * (c.y - b.y) <= 0;
            const double away = std::hypot(to_x, to_y);
            if (opposite && away > 0 && j != i && (j + 1) % n != i) neck = std::min(neck, away);
        }
    }
    return std::min(0.5 * neck, area / perimeter);
}

}  // namespace

PolygonObstacle::PolygonObstacle(std::span<const double> numbers, Memory* memory)
    : PolygonObstacle([&] {
          const size_t n = numbers.size() / 2;
          if (n < 3 || n > max_vertices) {
              throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a polygon has %zu vertices, it must have 3 to %u", n,
                            max_vertices);
          }
          Shape shape{std::pmr::vector<Vertex>(n, memory), {}, 0};
          double area = 0;
          for (size_t i = 0; i < n; ++i) {
              const Vertex v{numbers[2 * i], numbers[2 * i + 1]};
              if (!std::isfinite(v.x) || !std::isfinite(v.y)) {
                  throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a polygon's vertex %zu is not finite", i);
              }
              shape.vertices[i] = v;
              if (i == 0) shape.box = {{v.x, v.y}, {v.x, v.y}};
              shape.box.lower = {std::min(shape.box.lower[0], v.x), std::min(shape.box.lower[1], v.y)};
              shape.box.upper = {std::max(shape.box.upper[0], v.x), std::max(shape.box.upper[1], v.y)};
              if (i > 1) area += 0.5 * cross(shape.vertices[0], shape.vertices[i - 1], shape.vertices[i]);
          }
          check_edges(shape.vertices);
          if (area < 0) std::reverse(shape.vertices.begin(), shape.vertices.end());
          shape.core_depth = depth_of_core(shape.vertices, std::abs(area));
          return shape;
      }()) {}

PolygonObstacle::PolygonObstacle(Shape&& shape)
    : Obstacle(2, shape.box, true, shape.core_depth),
      vertices_(std::move(shape.vertices)),
      runs_((vertices_.size() + run_size - 1) / run_size, vertices_.get_allocator().resource()) {
    for (uint32_t i = 0; i < vertices_.size(); ++i) {
        Run& run = runs_[i / run_size];
        if (i % run_size == 0) run = {vertices_[i].x, vertices_[i].y, vertices_[i].x, vertices_[i].y};
        for (const Vertex& v : {vertices_[i], vertices_[next(i)]}) {
            run = {std::min(run.lower_x, v.x), std::min(run.lower_y, v.y), std::max(run.upper_x, v.x),
                   std::max(run.upper_y, v.y)};
        }
    }
    set_core(find_core());
}

// The deepest of the middle, of places next to the edges' middles and of a net.
PolygonObstacle::Place PolygonObstacle::find_core() const {
    Place best{};
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](double x, double y) {
        const Place at{x, y};
        const double d = evaluate(at.data(), nullptr, nullptr);
        if (d < least) least = d, best = at;
    };
    for (uint32_t i = 0; i < vertices_.size(); ++i) {
        const Vertex &a = vertices_[i], &b = vertices_[next(i)];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        for (const double by : {core_depth(), near_edge * length}) {
            look(0.5 * (a.x + b.x) - by * (b.y - a.y) / length, 0.5 * (a.y + b.y) + by * (b.x - a.x) / length);
        }
    }
    for (uint32_t k = 1; k < net * net; ++k) {
        const uint32_t column = k % net, row = k / net;
        const double u = double(column) / net, v = double(row) / net;
        look(box().lower[0] + u * (box().upper[0] - box().lower[0]),
             box().lower[1] + v * (box().upper[1] - box().lower[1]));
    }
    return best;
}

double PolygonObstacle::evaluate(const double* x, double* gradient, double* second) const {
    const Vertex p{x[0], x[1]};
    double least = std::numeric_limits<double>::infinity(), at = 0;
    uint32_t edge = 0;
    for (uint32_t r = 0; r < runs_.size(); ++r) {
        const Run& run = runs_[r];
        const double off_x = std::max({run.lower_x - p.x, p.x - run.upper_x, 0.0});
        const double off_y = std::max({run.lower_y - p.y, p.y - run.upper_y, 0.0});
        if (off_x * off_x + off_y * off_y >= least) continue;
        const uint32_t end = std::min((r + 1) * run_size, static_cast<uint32_t>(vertices_.size()));
        for (uint32_t i = r * run_size; i < end; ++i) {
            const Vertex &a = vertices_[i], &b = vertices_[next(i)];
            const double along_x = b.x - a.x, along_y = b.y - a.y;
            const double share =
                ((p.x - a.x) * along_x + (p.y - a.y) * along_y) / (along_x * along_x + along_y * along_y);
            const double t = std::clamp(share, 0.0, 1.0);
            const double to_x = p.x - a.x - t * along_x, to_y = p.y - a.y - t * along_y;
            const double square = to_x * to_x + to_y * to_y;
            if (square < least) least = square, edge = i, at = share;
        }
    }
    // Off an edge the side is that of its line; off a corner, that which the corner does not point away from.
    const Vertex &a = vertices_[edge], &b = vertices_[next(edge)];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const bool corner = at <= 0 || at >= 1;
    const uint32_t nearest = at <= 0 ? edge : next(edge);
    const Vertex& v = vertices_[nearest];
    if (corner && least > 0) {
        const Vertex& before = vertices_[nearest == 0 ? vertices_.size() - 1 : nearest - 1];
        const double sign = cross(before, v, vertices_[next(nearest)]) > 0 ? 1 : -1;
        const double rho = std::sqrt(least);
        const double g[2] = {sign * (p.x - v.x) / rho, sign * (p.y - v.y) / rho};
        if (gradient != nullptr) std::copy_n(g, 2, gradient);
        if (second != nullptr) {
            second[0] = sign * g[1] * g[1] / rho;
            second[1] = second[2] = -sign * g[0] * g[1] / rho;
            second[3] = sign * g[0] * g[0] / rho;
        }
        return sign * rho;
    }
    const double g[2] = {(b.y - a.y) / length, (a.x - b.x) / length};
    if (gradient != nullptr) std::copy_n(g, 2, gradient);
    if (second != nullptr) std::fill_n(second, 4, 0.0);
    return (p.x - a.x) * g[0] + (p.y - a.y) * g[1];
}

void PolygonObstacle::draw(double clearance, Wires& wires) const {
    for (uint32_t i = 0; i < vertices_.size(); ++i) {
        const Vertex &a = vertices_[i], &b = vertices_[next(i)];
        const double out = clearance / std::hypot(b.x - a.x, b.y - a.y);
        const double x = out * (b.y - a.y), y = out * (a.x - b.x);
        wires.line({a.x + x, a.y + y}, {b.x + x, b.y + y});
    }
}

}  // namespace flg
