// SPDX-License-Identifier: MIT
#include "io/mesh_measures.h"

#include <algorithm>

namespace flg::io {

namespace {

uint32_t count_different(const std::vector<uint32_t>& labels) {
    // Neighbours mostly share their label: only where one changes it is kept.
    std::vector<uint32_t> changes;
    for (uint32_t label : labels) {
        if (changes.empty() || changes.back() != label) changes.push_back(label);
    }
    std::sort(changes.begin(), changes.end());
    return static_cast<uint32_t>(std::unique(changes.begin(), changes.end()) - changes.begin());
}

}  // namespace

MeshMeasures measure(MeshData& data) {
    MeshMeasures result;
    std::copy_n(data.positions.data(), 3, result.box_min);
    std::copy_n(data.positions.data(), 3, result.box_max);
    for (size_t i = 0; i < data.positions.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) {
            result.box_min[k] = std::min(result.box_min[k], data.positions[i + k]);
            result.box_max[k] = std::max(result.box_max[k], data.positions[i + k]);
        }
    }
    if (!data.regions.empty()) result.region_count = count_different(data.regions);

    std::vector<uint8_t> used(data.vertex_count());
    Tally repeats, unused;
    for (size_t i = 0; i < data.triangles.size(); i += 3) {
        const uint32_t a = data.triangles[i], b = data.triangles[i + 1], c = data.triangles[i + 2];
        if (a == b || b == c || c == a) repeats.add(i / 3);
        used[a] = used[b] = used[c] = 1;
    }
    for (size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) unused.add(i);
    }
    data.warn(repeats, "triangle", "names a vertex twice");
    data.warn(unused, "vertex", "in no triangle");
    return result;
}

}  // namespace flg::io
