// SPDX-License-Identifier: MIT
#ifdef FLG_WITH_IO
#include "hardening/saved_documents.h"

#include <algorithm>
#include <ostream>
#include <vector>

#include "filigree/filigree_io.h"
#include "hardening/scenarios.h"

namespace flg::test {
namespace {

FlgResult save_tangle(const std::string& path, uint32_t version) {
    // As many regions as take a side file, which is smaller than the document.
    std::vector<uint32_t> regions;
    for (uint32_t i = 0; i < 20; ++i) regions.push_back(i + version);
    FlgTangleStep step{};
    step.struct_size = sizeof step;
    step.kind = FLG_TANGLE_STEP_KIND_GROUP;
    step.regions = regions.data();
    step.region_count = static_cast<uint32_t>(regions.size());
    const FlgTangleStep* const steps[] = {&step};
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    history.step_count = history.made_count = 1;
    history.steps = steps;
    history.box_max[0] = 1;
    return flgTangleFileWrite(path.c_str(), &history, nullptr);
}

std::string load_tangle(const std::string& path) {
    FlgTangleFile file = nullptr;
    if (flgTangleFileRead(path.c_str(), nullptr, &file) != FLG_OK) return flgIoErrorGetMessage();
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    EXPECT_EQ(flgTangleFileGetHistory(file, &history), FLG_OK);
    std::string all;
    append(all, history.steps[0]->regions, history.steps[0]->region_count);
    flgTangleFileRelease(file);
    return all;
}

FlgResult save_curves(const std::string& path, uint32_t version) {
    Curves curves = arcs(1, 4 + version, 3);
    const FlgCurveSetView view = curves.view();
    return flgCurveFileWrite(path.c_str(), &view, nullptr);
}

std::string load_curves(const std::string& path) {
    FlgCurveFile file = nullptr;
    if (flgCurveFileRead(path.c_str(), nullptr, &file) != FLG_OK) return flgIoErrorGetMessage();
    FlgCurveSetView view = flgCurveSetViewDefaults();
    EXPECT_EQ(flgCurveFileGetView(file, &view), FLG_OK);
    std::string all = bits(view);
    flgCurveFileRelease(file);
    return all;
}

FlgResult save_mesh(const std::string& path, uint32_t version) {
    MeshArrays mesh = plane(1 + version);
    const FlgMeshView view = mesh.view();
    return flgMeshFileWrite(path.c_str(), &view, nullptr);
}

std::string load_mesh(const std::string& path) {
    FlgMeshFile file = nullptr;
    if (flgMeshFileRead(path.c_str(), nullptr, &file) != FLG_OK) return flgIoErrorGetMessage();
    FlgMeshView view = flgMeshViewDefaults();
    EXPECT_EQ(flgMeshFileGetView(file, &view), FLG_OK);
    std::string all;
    append(all, view.triangles, size_t{3} * view.triangle_count);
    append(all, view.columns[0].data, size_t{3} * view.vertex_count);
    flgMeshFileRelease(file);
    return all;
}

}  // namespace

std::span<const Document> documents() {
    static const Document all[] = {
        {"tangle.json", save_tangle, load_tangle},
        {"curves.xyz", save_curves, load_curves},
        {"curves.glb", save_curves, load_curves},
        {"mesh.ply", save_mesh, load_mesh},
    };
    return all;
}

std::string name_of(const Document& document) {
    std::string name = document.name;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

void PrintTo(const Document& document, std::ostream* out) {
    *out << document.name;
}

}  // namespace flg::test
#endif
