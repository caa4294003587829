// SPDX-License-Identifier: MIT
// Strands, a long ribbon, a decorated mesh with displaced normals and a user interface in one scene and one frame: each
// is drawn as it is alone, and hides and shadows the others.
#include "meshes.h"

namespace flg::render::test {
namespace {

Curves strands(uint32_t count) {
    Curves curves;
    for (uint32_t s = 0; s < count; ++s) {
        const float angle = 2.399963f * static_cast<float>(s);
        const float away = std::sqrt(static_cast<float>(s) / static_cast<float>(count));
        const glm::vec3 out(std::cos(angle), 0, std::sin(angle));
        for (int i = 0; i < 30; ++i) {
            const float t = static_cast<float>(i) / 29.0f;
            curves.add((0.5f * away + 0.3f * t) * out + glm::vec3(0, 0.9f - 0.3f * away + 0.3f * t * (1.0f - t), 0));
        }
        curves.end();
    }
    return curves;
}

// Around the mesh's middle, up and down.
Curves ribbon(uint32_t points) {
    Curves curves;
    for (uint32_t i = 0; i < points; ++i) {
        const float t = 40 * pi * static_cast<float>(i) / static_cast<float>(points);
        curves.add({1.0f * std::cos(t), 0.3f * std::sin(0.31f * t), 1.0f * std::sin(t)});
    }
    curves.end();
    return curves;
}

// A ball whose normals wave as if it did, in eight regions.
Mesh decorated(uint32_t steps) {
    Mesh mesh = sphere(0.7f, steps);
    for (const glm::vec3& p : mesh.positions)
        mesh.normals.push_back(glm::normalize(p / 0.7f + 0.4f * glm::sin(30.0f * p)));
    for (size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const glm::vec3 p = mesh.positions[mesh.triangles[t]];
        mesh.regions.push_back((p.x > 0 ? 1u : 0u) + (p.y > 0 ? 2u : 0u) + (p.z > 0 ? 4u : 0u));
    }
    return mesh;
}

SurfaceLook decorated_look() {
    SurfaceLook look;
    for (int i = 0; i < 8; ++i) {
        const float t = static_cast<float>(i) / 7.0f;
        look.regions.push_back({.color = {0.1f + 0.7f * t, 0.3f, 0.8f - 0.7f * t}, .roughness = 0.3f + 0.5f * t});
    }
    look.border_width_px = 3.0f;
    return look;
}

TEST_F(RendererTest, EverythingInOneScene) {
    Curves hair = strands(200), band = ribbon(20'000);
    Mesh ball = decorated(80);
    const auto upload = [&](Renderer& to, int parts) {
        if (parts & 1) to.upload(hair.view(), {.shape = Shape::tube, .radius = 0.004f});
        if (parts & 2) to.upload(band.view(), {.radius = 0.02f});
        if (parts & 4) to.upload(ball.view(), decorated_look());
    };
    const UiVertex vertices[] = {{{0, 0}, {0, 0}, ~0u}, {{30, 0}, {0, 0}, ~0u}, {{0, 30}, {0, 0}, ~0u}};
    const uint16_t indices[] = {0, 1, 2};
    const UiCommand commands[] = {{0, 3, 0, {}, {0, 0, 30, 30}}};
    const DrawOptions options{.ui = {vertices, indices, commands}};

    Target target(renderer, 320, 180);
    upload(renderer, 7);
    const Camera camera = frame_box(renderer.bounds(), {-1, -0.4f, -1}, target.aspect());
    renderer.draw(target, camera, options);
    const Image all = renderer.capture(target);
    const FrameStats stats = renderer.stats();
    EXPECT_LE(stats.draw_calls, 40u);
    EXPECT_EQ(all.at(2, 2)[0], 255) << "the interface is over it";

    uint64_t triangles = 0;
    for (const int part : {1, 2, 4}) {
        renderer.clear();
        upload(renderer, part);
        renderer.draw(target, camera, options);
        triangles += renderer.stats().triangles;
        renderer.clear();
        upload(renderer, 7 - part);
        renderer.draw(target, camera, options);
        EXPECT_GT(differing_pixels(renderer.capture(target), all), 200u) << "without part " << part;
    }
    EXPECT_EQ(stats.triangles, triangles) << "of each alone";
    renderer.clear();
    upload(renderer, 7);
    renderer.draw(target, camera, options);
    EXPECT_EQ(renderer.capture(target).pixels, all.pixels);
}

}  // namespace
}  // namespace flg::render::test
