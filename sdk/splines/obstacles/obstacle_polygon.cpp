// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle_polygon.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "splines/obstacles/obstacle_shapes.h"

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

namespace {

// Of a prism: that of the box around it, which checks its numbers.
Obstacle::Box box_around(const PolygonObstacle& polygon, const double* centre, const double* axes, double half_height) {
    double half[3] = {0, 0, half_height};
    Obstacle::Place middle{};
    std::copy_n(centre, 3, middle.begin());
    for (uint32_t i = 0; i < 2; ++i) {
        half[i] = 0.5 * (polygon.box().upper[i] - polygon.box().lower[i]);
        const double along = 0.5 * (polygon.box().upper[i] + polygon.box().lower[i]);
        for (uint32_t k = 0; k < 3; ++k)
            middle[k] += along * (axes == nullptr ? (i == k ? 1.0 : 0.0) : axes[3 * i + k]);
    }
    return BoxObstacle(3, middle.data(), half, axes).box();
}

}  // namespace

PrismObstacle::PrismObstacle(PolygonObstacle polygon, const double* centre, const double* axes, double half_height)
    : Obstacle(3, box_around(polygon, centre, axes, half_height), true, std::min(polygon.core_depth(), half_height)),
      polygon_(std::move(polygon)),
      half_height_(half_height) {
    std::copy_n(centre, 3, centre_.begin());
    for (uint32_t i = 0; i < 3; ++i)
        for (uint32_t k = 0; k < 3; ++k) axes_[i][k] = axes == nullptr ? (i == k ? 1 : 0) : axes[3 * i + k];
    Place core = centre_;
    for (uint32_t i = 0; i < 2; ++i)
        for (uint32_t k = 0; k < 3; ++k) core[k] += polygon_.core()[i] * axes_[i][k];
    set_core(core);
}

// By the distances a from the polygon and b from the two faces: beside the prism, over it, off its rim, or in it.
double PrismObstacle::evaluate(const double* x, double* gradient, double* second) const {
    double local[3] = {};
    for (uint32_t i = 0; i < 3; ++i)
        for (uint32_t k = 0; k < 3; ++k) local[i] += axes_[i][k] * (x[k] - centre_[k]);
    double flat[2], flat_second[4];
    const bool derives = gradient != nullptr || second != nullptr;
    const double a = polygon_.evaluate(local, derives ? flat : nullptr, second != nullptr ? flat_second : nullptr),
                 b = std::abs(local[2]) - half_height_, up = local[2] < 0 ? -1 : 1;
    const bool off_rim = a > 0 && b > 0;
    const double value = off_rim ? std::hypot(a, b) : std::max(a, b);
    if (!derives) return value;
    // Shares of a and b.
    const double beside = off_rim ? a / value : a >= b ? 1 : 0, over = off_rim ? b / value : a >= b ? 0 : 1;
    const double g[3] = {beside * flat[0], beside * flat[1], over * up};
    double h[9] = {};
    for (uint32_t i = 0; i < 2 && second != nullptr; ++i)
        for (uint32_t j = 0; j < 2; ++j) h[3 * i + j] = beside * flat_second[2 * i + j];
    if (off_rim && second != nullptr) {
        const double side[3] = {flat[0], flat[1], 0}, top[3] = {0, 0, up};
        for (uint32_t i = 0; i < 3; ++i)
            for (uint32_t j = 0; j < 3; ++j)
                h[3 * i + j] += (side[i] * side[j] + top[i] * top[j] - g[i] * g[j]) / value;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        if (gradient != nullptr) gradient[k] = axes_[0][k] * g[0] + axes_[1][k] * g[1] + axes_[2][k] * g[2];
        for (uint32_t l = 0; l < 3 && second != nullptr; ++l) {
            second[3 * k + l] = 0;
            for (uint32_t i = 0; i < 3; ++i)
                for (uint32_t j = 0; j < 3; ++j) second[3 * k + l] += axes_[i][k] * h[3 * i + j] * axes_[j][l];
        }
    }
    return value;
}

void PrismObstacle::draw(double clearance, Wires& wires) const {
    class Raised final : public Wires {
    public:
        Raised(const PrismObstacle& of, double half, Wires& to) : of_(of), half_(half), to_(to) {}
        void line(const Place& a, const Place& b) override {
            to_.line(at(a, half_), at(b, half_));
            to_.line(at(a, -half_), at(b, -half_));
            to_.line(at(a, -half_), at(a, half_));
        }

    private:
        Place at(const Place& flat, double height) const {
            Place out = of_.centre_;
            for (uint32_t k = 0; k < 3; ++k)
                out[k] += flat[0] * of_.axes_[0][k] + flat[1] * of_.axes_[1][k] + height * of_.axes_[2][k];
            return out;
        }
        const PrismObstacle& of_;
        double half_;
        Wires& to_;
    };
    Raised raised(*this, half_height_ + clearance, wires);
    polygon_.draw(clearance, raised);
}

}  // namespace flg
