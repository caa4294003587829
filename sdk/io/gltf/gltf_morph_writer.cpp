// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_morph_writer.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "io/base/json_text.h"
#include "io/base/vec3.h"

namespace flg::io {

namespace {

Vec3 load(const float* p) {
    return {p[0], p[1], p[2]};
}

using Matrix = Eigen::Matrix3d;

// The turn that takes what was summed up from there to here best (Arun, Huang, Blostein: Least-squares fitting of two
// 3-D point sets, 1987).
Matrix turn_of(const Matrix& sum) {
    const Eigen::JacobiSVD<Matrix> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix sides = Matrix::Identity();
    sides(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0 ? -1 : 1;
    return svd.matrixV() * sides * svd.matrixU().transpose();
}

// Of where it was, times where it is.
void add_pair(const Vec3& before, const Vec3& after, Matrix& sum) {
    sum += Eigen::Vector3d(before.x, before.y, before.z) * Eigen::RowVector3d(after.x, after.y, after.z);
}

}  // namespace

WeldedPlaces::WeldedPlaces(const float* positions, size_t vertex_count) : places_(vertex_count) {
    Vector<uint32_t> order(vertex_count);
    std::iota(order.begin(), order.end(), 0u);
    const auto at = [&](uint32_t v) {
        const float* p = positions + 3 * size_t{v};
        return std::array<float, 3>{p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f};  // -0 is 0
    };
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return at(a) < at(b); });
    for (size_t i = 0; i < order.size(); ++i) {
        if (i == 0 || at(order[i]) != at(order[i - 1])) ++count_;
        places_[order[i]] = static_cast<uint32_t>(count_ - 1);
    }
}

String MorphWriter::add_targets() {
    if (targets_.empty()) return "";
    const WeldedPlaces places(mesh_.positions, mesh_.vertex_count);
    String list;
    for (const FlgMorphTarget& target : targets_) {
        if (!list.empty()) list += ',';
        const size_t moves = glb_.add_moves(written(target.moves), true);
        const Vector<float> normals =
            target.normal_moves ? written(target.normal_moves) : written(turned(places, target.moves).data());
        list += "{\"POSITION\":" + to_text(moves) + ",\"NORMAL\":" + to_text(glb_.add_moves(normals, false)) + "}";
    }
    return ",\"targets\":[" + list + "]";
}

String MorphWriter::mesh_members(std::span<const FlgMorphTarget> named) const {
    if (targets_.empty()) return "";
    String weights, names;
    for (size_t i = 0; i < targets_.size(); ++i) {
        const char* name = named[i].name;
        weights += i == 0 ? "0" : ",0";
        if (i > 0) names += ',';
        names += json_text(name ? String(name) : "target " + to_text(i));
    }
    return ",\"weights\":[" + weights + "],\"extras\":{\"targetNames\":[" + names + "]}";
}

String MorphWriter::add_sampler(const FlgMorphAnimation& animation) {
    const size_t count = animation.key_count * targets_.size();
    const size_t times = glb_.add_times({animation.times, animation.key_count});
    const size_t weights =
        glb_.add_accessor(glb_.add_plain_view({animation.weights, count}), 0, count, glb_float, "SCALAR");
    return "{\"input\":" + to_text(times) + ",\"output\":" + to_text(weights) + "}";
}

Vector<float> MorphWriter::written(const float* values) const {
    Vector<float> out;
    out.reserve(3 * sources_.size());
    for (const uint32_t v : sources_) out.insert(out.end(), values + 3 * size_t{v}, values + 3 * size_t{v} + 3);
    return out;
}

// What is added to normals where triangles turn: they turn as these do, by area. Where nothing turns it is 0.
Vector<float> MorphWriter::turned(const WeldedPlaces& places, const float* moves) const {
    Vector<Matrix> sums(places.count(), Matrix::Zero());
    Vector<bool> moves_any(places.count());
    for (size_t t = 0; t < mesh_.triangle_count; ++t) {
        const uint32_t* c = mesh_.triangles + 3 * t;
        Vec3 rest[3], moved[3];
        for (size_t k = 0; k < 3; ++k) {
            rest[k] = load(mesh_.positions + 3 * size_t{c[k]});
            moved[k] = rest[k] + load(moves + 3 * size_t{c[k]});
        }
        const Vec3 n = cross(rest[1] - rest[0], rest[2] - rest[0]);
        const Vec3 m = cross(moved[1] - moved[0], moved[2] - moved[0]);
        // Edges lie in the surface: how it is turned about them, normals say, as long as the edges are.
        const double scale = length(n) > 0 && length(m) > 0 ? 1 / std::sqrt(length(n) * length(m)) : 0;
        Matrix sum = Matrix::Zero();
        add_pair(scale * n, m, sum);
        bool turns = false;
        for (size_t k = 0; k < 3; ++k) {
            const Vec3 edge = rest[(k + 1) % 3] - rest[k], now = moved[(k + 1) % 3] - moved[k];
            add_pair(edge, now, sum);
            turns = turns || edge.x != now.x || edge.y != now.y || edge.z != now.z;
        }
        for (size_t k = 0; k < 3; ++k) {
            sums[places[c[k]]] += sum;
            if (turns) moves_any[places[c[k]]] = true;
        }
    }
    Vector<float> out(3 * size_t{mesh_.vertex_count});
    for (size_t v = 0; v < mesh_.vertex_count; ++v) {
        if (!moves_any[places[v]]) continue;
        const Eigen::Vector3d normal = Eigen::Vector3f(mesh_.normals + 3 * v).cast<double>();
        const Eigen::Vector3d added = turn_of(sums[places[v]]) * normal - normal;
        for (int k = 0; k < 3; ++k) out[3 * v + static_cast<size_t>(k)] = static_cast<float>(added[k]);
    }
    return out;
}

}  // namespace flg::io
