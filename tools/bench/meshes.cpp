// SPDX-License-Identifier: MIT
#include "bench/meshes.h"

#include <cmath>
#include <numbers>

#include "core/random.h"

namespace flg::bench {

namespace {

constexpr double kLongWayPerShort = 2.5;  // cells around the torus for each around its tube
constexpr double kTube = 0.4, kBump = 0.05, kShift = 0.3;

constexpr uint32_t kOctaves = 7;

// Random numbers at whole places, 0 to 1, and smoothly between.
double smooth_noise(double x, double y, uint64_t seed) {
    const double column = std::floor(x), row = std::floor(y);
    const auto at = [&](double i, double j) {
        return random_unit(seed, static_cast<uint64_t>(column + i), static_cast<uint32_t>(row + j));
    };
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double u = ease(x - column), v = ease(y - row);
    return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
}

void add_point(MeshArrays& mesh, double u, double v, double height) {
    const double bump = height * std::sin(9 * u) * std::sin(7 * v + 2 * std::sin(3 * u));
    const double tube = kTube + bump, ring = 1 + tube * std::cos(v);
    for (const double x : {ring * std::cos(u), ring * std::sin(u), tube * std::sin(v)}) {
        mesh.positions.push_back(static_cast<float>(x));
    }
}

MeshArrays torus_with(uint32_t triangle_count, double height, double shift) {
    const auto across = static_cast<uint32_t>(std::sqrt(triangle_count / 2.0 / kLongWayPerShort));
    const uint32_t around = triangle_count / 2 / across;
    constexpr double turn = 2 * std::numbers::pi;
    MeshArrays mesh;
    mesh.positions.reserve(size_t{3} * around * across);
    mesh.triangles.reserve(size_t{6} * around * across);
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < across; ++j)
            add_point(mesh, turn * (i + shift * std::sin(j)) / around, turn * j / across, height);
    }
    const auto at = [&](uint32_t i, uint32_t j) { return i % around * across + j % across; };
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < across; ++j) {
            const uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            for (const uint32_t v : {a, b, c, a, c, d}) mesh.triangles.push_back(v);
        }
    }
    return mesh;
}

}  // namespace

FlgMeshView MeshArrays::view(FlgColumn& column) const {
    column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
    FlgMeshView view = flgMeshViewDefaults();
    view.vertex_count = static_cast<uint32_t>(positions.size() / 3);
    view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
    view.column_count = 1;
    view.columns = &column;
    view.triangles = triangles.data();
    return view;
}

MeshArrays rough_ground(uint32_t triangle_count) {
    const auto cells = static_cast<uint32_t>(std::sqrt(triangle_count / 2.0));
    MeshArrays mesh;
    for (uint32_t j = 0; j <= cells; ++j) {
        for (uint32_t i = 0; i <= cells; ++i) {
            const double x = double(i) / cells, y = double(j) / cells;
            double height = 0.15, frequency = 3, z = 0;
            for (uint32_t octave = 0; octave < kOctaves; ++octave, height /= 2, frequency *= 2)
                z += height * smooth_noise(frequency * x, frequency * y, octave);
            for (const double c : {x, y, z}) mesh.positions.push_back(static_cast<float>(c));
        }
    }
    for (uint32_t j = 0; j < cells; ++j) {
        for (uint32_t i = 0; i < cells; ++i) {
            const uint32_t a = j * (cells + 1) + i, b = a + 1, c = b + cells + 1, d = a + cells + 1;
            for (const uint32_t v : {a, b, c, a, c, d}) mesh.triangles.push_back(v);
        }
    }
    return mesh;
}

void add_noise(MeshArrays& mesh, double share) {
    double edges = 0;
    const auto at = [&](size_t corner, uint32_t c) {
        return double{mesh.positions[size_t{3} * mesh.triangles[corner] + c]};
    };
    for (size_t t = 0; t < mesh.triangles.size(); t += 3)
        edges += std::hypot(at(t, 0) - at(t + 1, 0), at(t, 1) - at(t + 1, 1), at(t, 2) - at(t + 1, 2));
    const double mean = edges / (mesh.triangles.size() / 3.0);
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.positions[i] += static_cast<float>(share * mean * (random_unit(1, i, 0) - 0.5));
}

MeshArrays bumpy_torus(uint32_t triangle_count) {
    return torus_with(triangle_count, kBump, kShift);
}

MeshArrays wavy_torus(uint32_t triangle_count, double height) {
    return torus_with(triangle_count, height, 0);
}

}  // namespace flg::bench
