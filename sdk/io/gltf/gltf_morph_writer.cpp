// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_morph_writer.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "io/base/json_text.h"
#include "io/base/vec3.h"

namespace flg::io {

namespace {

Vec3 load(const float* p) {
    return {p[0], p[1], p[2]};
}

// By the least turn that takes `from` to `to`, both of length 1.
Vec3 turned_by(const Vec3& from, const Vec3& to, const Vec3& vector) {
    const Vec3 axis = cross(from, to);
    const double cosine = dot(from, to);
    constexpr double opposite = 1e-9;  // there is no least turn any more
    if (1 + cosine < opposite) return -1 * vector;
    return cosine * vector + cross(axis, vector) + (dot(axis, vector) / (1 + cosine)) * axis;
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
    if (morphs_.targets().empty()) return "";
    const WeldedPlaces places(mesh_.positions, mesh_.vertex_count);
    String list;
    for (const FlgMorphTarget& target : morphs_.targets()) {
        if (!list.empty()) list += ',';
        const size_t moves = glb_.add_moves(written(target.moves), true);
        const Vector<float> normals =
            target.normal_moves ? written(target.normal_moves) : written(turned(places, target.moves).data());
        list += "{\"POSITION\":" + to_text(moves) + ",\"NORMAL\":" + to_text(glb_.add_moves(normals, false)) + "}";
    }
    return ",\"targets\":[" + list + "]";
}

String MorphWriter::mesh_members() const {
    if (morphs_.targets().empty()) return "";
    String weights, names;
    for (size_t i = 0; i < morphs_.targets().size(); ++i) {
        const char* name = morphs_.targets()[i].name;
        weights += i == 0 ? "0" : ",0";
        names += (i == 0 ? "" : ",") + json_text(name ? String(name) : "target " + to_text(i));
    }
    return ",\"weights\":[" + weights + "],\"extras\":{\"targetNames\":[" + names + "]}";
}

String MorphWriter::add_sampler(const FlgMorphAnimation& animation) {
    const size_t count = animation.key_count * morphs_.targets().size();
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

// What is added to normals where triangles turn: they turn with the mean of these, by area. Where nothing moves it is 0
// to the bit.
Vector<float> MorphWriter::turned(const WeldedPlaces& places, const float* moves) const {
    Vector<Vec3> before(places.count()), after(places.count());
    for (size_t t = 0; t < mesh_.triangle_count; ++t) {
        const uint32_t* c = mesh_.triangles + 3 * t;
        Vec3 rest[3], moved[3];
        for (size_t k = 0; k < 3; ++k) {
            rest[k] = load(mesh_.positions + 3 * size_t{c[k]});
            moved[k] = rest[k] + load(moves + 3 * size_t{c[k]});
        }
        const Vec3 n = cross(rest[1] - rest[0], rest[2] - rest[0]);
        const Vec3 m = cross(moved[1] - moved[0], moved[2] - moved[0]);
        for (size_t k = 0; k < 3; ++k) {
            before[places[c[k]]] = before[places[c[k]]] + n;
            after[places[c[k]]] = after[places[c[k]]] + m;
        }
    }
    Vector<float> out(3 * size_t{mesh_.vertex_count});
    for (size_t v = 0; v < mesh_.vertex_count; ++v) {
        const Vec3 &from = before[places[v]], &to = after[places[v]];
        if (!(length(from) > 0 && length(to) > 0) || (from.x == to.x && from.y == to.y && from.z == to.z)) continue;
        const Vec3 normal = load(mesh_.normals + 3 * v);
        const Vec3 added = turned_by(normalized(from), normalized(to), normal) - normal;
        out[3 * v] = static_cast<float>(added.x);
        out[3 * v + 1] = static_cast<float>(added.y);
        out[3 * v + 2] = static_cast<float>(added.z);
    }
    return out;
}

}  // namespace flg::io
