// SPDX-License-Identifier: MIT
// Surfaces that can't be drawn are refused with a sentence, and leave the renderer as it was.
#include <limits>

#include "meshes.h"

namespace flg::render::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

class SurfaceErrors : public RendererTest {
protected:
    void expect_refused(const FlgMeshView& view, const char* part, const SurfaceLook& look = {},
                        const std::vector<float>& field = {}) {
        expect_error([&] { renderer.upload(view, look, field); }, part);
        EXPECT_TRUE(renderer.bounds().empty());
    }
    Mesh mesh_ = sheet(1, 1, 2, 2);  // 9 vertices, 8 triangles
};

TEST_F(SurfaceErrors, Views) {
    expect_refused(FlgMeshView{}, "no triangles");
    FlgMeshView view = mesh_.view();
    view.triangle_count = 0;
    expect_refused(view, "no triangles");
    view = mesh_.view();
    view.triangles = nullptr;
    expect_refused(view, "no triangles");
    view = mesh_.view();
    view.columns = nullptr;
    expect_refused(view, "no columns");
    view = mesh_.view();
    mesh_.columns[0].attribute = FLG_ATTRIBUTE_TANGENT;
    expect_refused(view, "no POSITION");
    view = mesh_.view();
    mesh_.columns[0].components = 2;
    expect_refused(view, "POSITION has 2 floats");
    view = mesh_.view();
    mesh_.columns[0].data = nullptr;
    expect_refused(view, "POSITION has no data");
    view = mesh_.view();
    mesh_.columns[0].stride = 13;
    expect_refused(view, "13 bytes");
}

TEST_F(SurfaceErrors, Indices) {
    mesh_.triangles[7] = 9;
    expect_refused(mesh_.view(), "Triangle 2 names vertex 9; the mesh has 9 vertices");
    mesh_.triangles[7] = 0xffffffffu;
    expect_refused(mesh_.view(), "Triangle 2");
    mesh_.triangles[7] = 0;
    FlgMeshView view = mesh_.view();
    view.vertex_count = 0;
    expect_refused(view, "Triangle 0 names vertex 0; the mesh has 0 vertices");
}

// The counts alone decide: there are no arrays of that size.
TEST_F(SurfaceErrors, TooMany) {
    FlgMeshView view = mesh_.view();
    view.vertex_count = 1u << 24;
    expect_refused(view, "16777216 vertices; the renderer takes at most 16777215");
    view = mesh_.view();
    view.triangle_count = (1u << 26) + 1;
    expect_refused(view, "67108865 triangles");
}

TEST_F(SurfaceErrors, Values) {
    for (const float bad : {nan, infinity, -infinity, 1e31f}) {
        Mesh mesh = mesh_;
        mesh.positions[4].y = bad;
        expect_refused(mesh.view(), "Vertex 4 is at");
    }
    Mesh mesh = mesh_;
    mesh.normals.assign(9, {0, 0, 1});
    mesh.normals[2].x = nan;
    expect_refused(mesh.view(), "Vertex 2 has a normal");
    mesh = mesh_;
    mesh.colors.assign(9, {1, 1, 1, 1});
    mesh.colors[3].y = infinity;
    expect_refused(mesh.view(), "Vertex 3 has a colour");
}

TEST_F(SurfaceErrors, Fields) {
    expect_refused(mesh_.view(), "8 values; the mesh has 9 vertices", {}, std::vector<float>(8));
    std::vector<float> field(9);
    field[5] = nan;
    expect_refused(mesh_.view(), "vertex 5 is not a number", {}, field);
}

TEST_F(SurfaceErrors, Looks) {
    const FlgMeshView view = mesh_.view();
    expect_refused(view, "metallic", {.material = {.metallic = 2}});
    expect_refused(view, "roughness", {.material = {.roughness = nan}});
    expect_refused(view, "color", {.material = {.color = {-1, 0, 0}}});
    expect_refused(view, "color", {.regions = {{}, {.color = {nan, 0, 0}}}});
    expect_refused(view, "field_low", {.field_low = nan});
    expect_refused(view, "field_high", {.field_high = infinity});
    expect_refused(view, "isoline_spacing", {.isoline_spacing = -1});
    expect_refused(view, "isoline_width_px", {.isoline_width_px = 0});
    expect_refused(view, "isoline_color", {.isoline_color = {0, 2, 0}});
    expect_refused(view, "border_width_px", {.border_width_px = 0.1f});
    expect_refused(view, "border_color", {.border_color = {0, 0, nan}});
    expect_refused(view, "border_width_px", {.material = {.border_width_px = 65}});
    expect_refused(view, "border_color", {.regions = {{.border_color = {2, 0, 0}}}});
}

TEST_F(SurfaceErrors, AFailedUpdateChangesNothing) {
    Target target(renderer, 64, 64);
    const SurfaceId id = renderer.upload(mesh_.view());
    const Image before = picture(target);
    mesh_.triangles[0] = 100;
    expect_error([&] { renderer.update(id, mesh_.view()); }, "Triangle 0");
    EXPECT_EQ(differing_pixels(picture(target), before), 0u);
    expect_error([&] { renderer.update({77}, mesh_.view()); }, "no surfaces with the id 77");
    expect_error([&] { renderer.remove(SurfaceId{77}); }, "no surfaces with the id 77");
}

}  // namespace
}  // namespace flg::render::test
