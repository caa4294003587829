// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_sleeve.h"

namespace flg {

uint32_t next_about(const Mesh& mesh, const RegionSet& regions, uint32_t vertex, uint32_t triangle,
                    bool counter_clockwise) {
    const Triple& t = mesh.triangles[triangle];
    const uint32_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    const uint32_t next = mesh.neighbours[triangle][counter_clockwise ? (k + 2) % 3 : k];
    return next != no_index && regions.contains(mesh.regions[next]) ? next : no_index;
}

void GeodesicSleeve::clear() {
    triangles_.clear();
    complete_ = false;
}

void GeodesicSleeve::enter(uint32_t triangle) {
    const uint32_t count = triangles_.size();
    if (complete_ || (count > 0 && triangles_.back() == triangle)) return;
    SurfacePoint unused;
    if (count > 1 && triangles_[count - 2] == triangle) {
        triangles_.pop_back();
    } else {
        if (find_in(mesh_, from_, triangle, unused)) triangles_.clear();
        triangles_.push_back(triangle);
    }
    complete_ = find_in(mesh_, to_, triangle, unused);
}

void GeodesicSleeve::turn(uint32_t vertex, bool counter_clockwise, uint32_t triangle) {
    for (uint32_t at = triangles_.back(); at != triangle;) {
        at = next_about(mesh_, regions_, vertex, at, counter_clockwise);
        enter(at);
    }
}

bool GeodesicSleeve::turn_to(uint32_t vertex, uint32_t triangle, uint32_t& cost) {
    uint32_t left = last(), right = last();
    while (left != triangle && right != triangle) {
        ++cost;
        if (left != no_index) left = next_about(mesh_, regions_, vertex, left, true);
        if (right != no_index) right = next_about(mesh_, regions_, vertex, right, false);
        if (left == no_index && right == no_index) return false;
    }
    turn(vertex, left == triangle, triangle);
    return true;
}

}  // namespace flg
