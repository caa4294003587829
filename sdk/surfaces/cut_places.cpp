// SPDX-License-Identifier: MIT
#include "surfaces/cut_places.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr int32_t scale = CutTriangulation::scale, snapping = CutTriangulation::tolerance;

}  // namespace

CutPlace place_of(const Mesh& mesh, const SurfacePoint& point) {
    const auto x = std::clamp(static_cast<int32_t>(std::lround(double{point.u} * scale)), 0, scale);
    const auto y = std::clamp(static_cast<int32_t>(std::lround(double{point.v} * scale)), 0, scale - x);
    const std::array<int32_t, 3> weights = {scale - x - y, x, y};
    const Triple& vertices = mesh.triangles[point.triangle];
    const auto at_vertex = [&](size_t k) {
        return CutPlace{CutPlace::Kind::vertex, vertices[k % 3], {}, vertices[k % 3]};
    };
    const auto largest = static_cast<size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
    if (weights[largest] >= scale - snapping) return at_vertex(largest);
    const auto least = static_cast<size_t>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    if (weights[least] > snapping) return {CutPlace::Kind::inside, point.triangle, {x, y}, no_index};

    const size_t k = (least + 1) % 3;
    const double end = weights[(k + 1) % 3], both = end + weights[k];
    auto along = static_cast<int32_t>(std::lround(scale * (end / both)));
    if (along <= snapping) return at_vertex(k);
    if (along >= scale - snapping) return at_vertex(k + 1);
    Corner edge = 3 * point.triangle + static_cast<uint32_t>(k);
    const Corner across = mesh.opposite(edge);
    if (across < edge) {
        edge = across;
        along = scale - along;
    }
    return {CutPlace::Kind::edge, edge, {along, 0}, no_index};
}

Corner corner_in(const Mesh& mesh, const CutPlace& place, uint32_t triangle) {
    switch (place.kind) {
        case CutPlace::Kind::vertex:
            for (uint32_t k = 0; k < 3; ++k) {
                if (mesh.triangles[triangle][k] == place.where) return 3 * triangle + k;
            }
            return no_index;
        case CutPlace::Kind::edge: {
            if (triangle_of(place.where) == triangle) return place.where;
            const Corner across = mesh.opposite(place.where);
            return across != no_index && triangle_of(across) == triangle ? across : no_index;
        }
        case CutPlace::Kind::inside: return place.where == triangle ? 3 * triangle : no_index;
    }
    return no_index;
}

}  // namespace flg
