// SPDX-License-Identifier: MIT
// Isolines cut into a mesh of 2 million triangles, and what is kept beside it brought up to date.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/cut_mesh.h"
#include "bench/groups.h"

namespace flg::bench {
namespace {

constexpr uint32_t kTriangles = 2'000'000;
constexpr double kOneLevelMs = 25, kTenLevelsMs = 50, kUpdateMs = 60;
constexpr int kCutRuns = 3;

void add_rows(CutMesh& mesh, uint32_t levels, double bar_ms, const char* what, std::vector<Row>& rows) {
    std::vector<double> cut_ms, update_ms;
    double max_us = HUGE_VAL;
    for (int run = 0; run < kCutRuns; ++run) {
        mesh.reset();
        const CutMesh::Times times = mesh.cut_isolines(levels);
        cut_ms.push_back(times.cut_ms);
        update_ms.push_back(times.update_ms);
        max_us = std::min(max_us, times.max_slice_us);
    }
    char note[96];
    std::snprintf(note, sizeof note, "%zu triangles new or changed; longest chunk %.0f us", mesh.changes().size(),
                  max_us);
    const std::string name = std::string("2 M triangles: ") + what;
    rows.push_back(below(name + " cut in", median(cut_ms), "ms", bar_ms, note));
    if (levels == 1) rows.push_back(below(name + ", local update", median(update_ms), "ms", kUpdateMs));
}

}  // namespace

std::vector<Row> run_cutting() {
    CutMesh mesh(kTriangles);
    std::vector<Row> rows;
    add_rows(mesh, 1, kOneLevelMs, "one isoline", rows);
    add_rows(mesh, 10, kTenLevelsMs, "ten isolines", rows);
    return rows;
}

}  // namespace flg::bench
