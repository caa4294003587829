// SPDX-License-Identifier: MIT
#include "splines/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flg::studio::splines {
namespace {

constexpr double kSphere = 0.6, kTorus = 0.6, kTorusTube = 0.24;

double square(double a) {
    return a * a;
}

// ---- Values. Those of formulas are sdk/splines' (implicit_formulas.cpp)

double plane(double /*x*/, double /*y*/, double z) {
    return z;
}
double sphere(double x, double y, double z) {
    return std::sqrt(x * x + y * y + z * z) - kSphere;
}
double torus(double x, double y, double z) {
    return std::hypot(std::hypot(x, y) - kTorus, z) - kTorusTube;
}
double ellipsoid(double x, double y, double z) {
    return square(x) + square(y / 0.7) + square(z / 0.5) - 1;
}
double eight(double x, double y, double z) {
    const double xx = square(x);
    return square(xx * (xx - 1) + square(y)) + square(z) - 0.03;
}
double heart(double x, double y, double z) {
    const double inner = square(x) + 2.25 * square(y) + square(z) - 1;
    return inner * square(inner) - (square(x) + 9.0 / 80 * square(y)) * z * square(z) - 0.01;
}
double tangle_cube(double x, double y, double z) {
    const auto along = [](double a) {
        const double aa = square(2 * a);
        return aa * (aa - 5);
    };
    return along(x) + along(y) + along(z) + 11.8;
}

FlgManifoldShapeDesc formula(const char* name) {
    FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
    desc.shape = FLG_MANIFOLD_SHAPE_FORMULA;
    desc.name = name;
    return desc;
}

constexpr Shape kShapes[] = {
    {"plane", "A plane", 1.0, plane,
     [] {
         FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
         desc.shape = FLG_MANIFOLD_SHAPE_PLANE;
         return desc;
     }},
    {"sphere", "A sphere", 0.65, sphere,
     [] {
         FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
         desc.shape = FLG_MANIFOLD_SHAPE_SPHERE;
         desc.radius = kSphere;
         return desc;
     }},
    {"torus", "A torus", 0.9, torus,
     [] {
         FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
         desc.shape = FLG_MANIFOLD_SHAPE_TORUS;
         desc.radius = kTorus;
         desc.tube_radius = kTorusTube;
         return desc;
     }},
    {"ellipsoid", "An ellipsoid", 1.05, ellipsoid, [] { return formula("ellipsoid"); }},
    {"genus2", "A figure of eight", 1.2, eight, [] { return formula("genus2"); }},
    {"heart", "A heart", 1.4, heart, [] { return formula("heart"); }},
    {"tangle_cube", "A tangle cube", 1.35, tangle_cube, [] { return formula("tangle_cube"); }},
};

double value_at(const Shape& shape, const glm::dvec3& own) {
    return shape.value(own.x, own.y, own.z);
}

glm::dvec3 gradient_at(const Shape& shape, const glm::dvec3& p) {
    const double bit = 1e-5 * shape.half;
    glm::dvec3 gradient;
    for (glm::length_t c = 0; c < 3; ++c) {
        glm::dvec3 step(0.0);
        step[c] = bit;
        gradient[c] = (value_at(shape, p + step) - value_at(shape, p - step)) / (2 * bit);
    }
    return gradient;
}

Place place_at(const Shape& shape, const glm::dvec3& own) {
    const glm::dvec3 gradient = gradient_at(shape, own);
    const double length = glm::length(gradient);
    return {to_world(own), length > 0 ? to_world(gradient / length) : glm::dvec3(0.0, 1.0, 0.0)};
}

}  // namespace

std::span<const Shape> shapes() {
    return kShapes;
}

const Shape* find_shape(std::string_view name) {
    const auto* found =
        std::find_if(std::begin(kShapes), std::end(kShapes), [&](const Shape& shape) { return name == shape.name; });
    return found == std::end(kShapes) ? nullptr : found;
}

std::optional<Place> meet(const Shape& shape, const Ray& ray) {
    const glm::dvec3 from = to_shape(ray.origin), along = to_shape(ray.direction);
    // The part of the ray within the cube.
    double begin = 0.0, end = 1e30;
    for (glm::length_t c = 0; c < 3; ++c) {
        if (std::abs(along[c]) < 1e-12) {
            if (std::abs(from[c]) > shape.half) return std::nullopt;
            continue;
        }
        const double a = (-shape.half - from[c]) / along[c], b = (shape.half - from[c]) / along[c];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (!(begin < end)) return std::nullopt;
    constexpr int kSteps = 400;
    const double step = (end - begin) / kSteps;
    double before = begin;
    const bool inside = value_at(shape, from + begin * along) < 0;
    for (int i = 1; i <= kSteps; ++i) {
        const double here = begin + i * step;
        if ((value_at(shape, from + here * along) < 0) == inside) {
            before = here;
            continue;
        }
        double low = before, high = here;
        while (high - low > 1e-6 * shape.half) {
            const double middle = 0.5 * (low + high);
            ((value_at(shape, from + middle * along) < 0) == inside ? low : high) = middle;
        }
        return place_at(shape, from + 0.5 * (low + high) * along);
    }
    return std::nullopt;
}

std::optional<Place> nearest(const Shape& shape, const glm::dvec3& world) {
    glm::dvec3 p = glm::clamp(to_shape(world), glm::dvec3(-shape.half), glm::dvec3(shape.half));
    constexpr int kSteps = 60;
    for (int i = 0; i < kSteps; ++i) {
        const double value = value_at(shape, p);
        const glm::dvec3 gradient = gradient_at(shape, p);
        const double square = glm::dot(gradient, gradient);
        if (!(square > 0)) return std::nullopt;
        const glm::dvec3 step = value / square * gradient;
        const double length = glm::length(step), longest = 0.1 * shape.half;
        if (length < 1e-6 * shape.half) return place_at(shape, p);
        p -= length > longest ? longest / length * step : step;
    }
    return std::nullopt;
}

ShapeMesh mesh_of(const Shape& shape) {
    constexpr uint32_t kCells = 72, n = kCells + 1;
    const double spacing = 2 * shape.half / kCells;
    std::vector<float> values(size_t{n} * n * n);
    const auto index = [](uint32_t x, uint32_t y, uint32_t z) { return (size_t{z} * n + y) * n + x; };
    const auto own = [&](double x, double y, double z) { return spacing * glm::dvec3(x, y, z) - shape.half; };
    for (uint32_t z = 0; z < n; ++z) {
        for (uint32_t y = 0; y < n; ++y) {
            for (uint32_t x = 0; x < n; ++x) values[index(x, y, z)] = static_cast<float>(value_at(shape, own(x, y, z)));
        }
    }
    ShapeMesh mesh;
    std::vector<uint32_t> vertex(values.size(), UINT32_MAX);
    for (uint32_t z = 0; z < kCells; ++z) {
        for (uint32_t y = 0; y < kCells; ++y) {
            for (uint32_t x = 0; x < kCells; ++x) {
                // Where both signs are: the middle, brought onto the surface.
                int below = 0;
                for (uint32_t k = 0; k < 8; ++k)
                    below += values[index(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2))] < 0;
                if (below == 0 || below == 8) continue;
                const glm::dvec3 middle = to_world(own(x + 0.5, y + 0.5, z + 0.5));
                const Place place = nearest(shape, middle).value_or(Place{middle, {0.0, 1.0, 0.0}});
                vertex[index(x, y, z)] = static_cast<uint32_t>(mesh.positions.size());
                mesh.positions.emplace_back(place.position);
                mesh.normals.emplace_back(place.normal);
            }
        }
    }
    const std::array<size_t, 3> step = {1, n, size_t{n} * n};
    for (uint32_t z = 1; z < kCells; ++z) {
        for (uint32_t y = 1; y < kCells; ++y) {
            for (uint32_t x = 1; x < kCells; ++x) {
                const size_t here = index(x, y, z);
                for (size_t axis = 0; axis < 3; ++axis) {
                    const bool low = values[here] < 0, high = values[here + step[axis]] < 0;
                    if (low == high) continue;
                    const size_t u = step[(axis + 1) % 3], v = step[(axis + 2) % 3];
                    uint32_t a = vertex[here - u - v], b = vertex[here - v], c = vertex[here], d = vertex[here - u];
                    if (!low) std::swap(b, d);
                    mesh.triangles.insert(mesh.triangles.end(), {a, b, c, a, c, d});
                }
            }
        }
    }
    return mesh;
}

}  // namespace flg::studio::splines
