// SPDX-License-Identifier: MIT
// Maps of a unit square that an isoline cuts, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "filigree/filigree_bake.h"

namespace flg::test {
namespace {

struct Square {
    const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const std::vector<uint32_t> triangles = {0, 1, 2, 0, 2, 3};
    std::vector<float> uvs = {0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1};
    FlgContext context = {};
    FlgTangle tangle = {};
    FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
    FlgMeshView mesh = flgMeshViewDefaults();

    void run(FlgJob job) {
        FlgJobStatus status = flgJobStatusDefaults();
        do {
            flgContextTick(context, FLG_UNLIMITED, nullptr);
            flgJobGetStatus(context, job, &status);
        } while (status.result == FLG_NOT_READY);
        last = status.result;
        if (last != FLG_OK) error = status.error;
    }
    FlgResult last = FLG_OK;
    std::string error;

    // The edge x = 0 is a line; the contour lies at `delta` from it.
    explicit Square(float delta) {
        FlgContextDesc desc = flgContextDefaults();
        EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK);
        mesh.vertex_count = 4;
        mesh.triangle_count = 2;
        mesh.column_count = 1;
        mesh.columns = &column;
        mesh.triangles = triangles.data();
        FlgSurfaceDesc made = flgSurfaceDefaults();
        made.mesh = &mesh;
        made.provenance = 1;
        FlgSurface surface = {};
        FlgJob job = {};
        EXPECT_EQ(flgSurfaceCreate(context, &made, &surface, &job), FLG_OK);
        run(job);
        EXPECT_EQ(flgTangleCreate(context, surface, nullptr, &tangle, &job), FLG_OK);
        run(job);
        FlgTangleSeeds seeds = flgTangleSeedsDefaults();
        const FlgBorderStretch stretch = {0, 0.75f, 1.0f};
        seeds.stretches = &stretch;
        seeds.stretch_count = 1;
        FlgTangleDivideDesc divide = flgTangleDivideDefaults();
        const uint32_t root = 0;
        divide.tangle = tangle;
        divide.regions = &root;
        divide.region_count = 1;
        divide.a = &seeds;
        divide.delta = delta;
        EXPECT_EQ(flgTangleDivide(context, &divide, &job), FLG_OK) << flgErrorGetMessage();
        run(job);
        EXPECT_EQ(last, FLG_OK) << error;
    }
    ~Square() { flgContextDestroy(context); }
};

TEST(Baking, ASquareThatALineDividesIsDrawnToTheTexel) {
    constexpr uint32_t size = 64;
    constexpr float line = 0.3f;
    Square square(line);
    std::vector<uint32_t> ids(size * size);
    std::vector<float> distances(size * size);
    std::vector<uint8_t> borders(size * size);
    FlgTangleBakeDesc desc = flgTangleBakeDefaults();
    desc.size = size;
    desc.tangle = square.tangle;
    desc.mesh = &square.mesh;
    desc.corner_uvs = square.uvs.data();
    desc.border_width = 0.1f;
    desc.ids = ids.data();
    desc.distances = distances.data();
    desc.borders = borders.data();
    FlgJob job = {};
    ASSERT_EQ(flgTangleBake(square.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    square.run(job);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
    double covered = 0;
    for (uint32_t y = 0; y < size; ++y) {
        for (uint32_t x = 0; x < size; ++x) {
            const float middle = (static_cast<float>(x) + 0.5f) / size;
            const uint32_t texel = y * size + x;
            EXPECT_EQ(ids[texel], middle < line ? ids[0] : ids[size - 1]) << x << ' ' << y;
            EXPECT_NEAR(distances[texel], std::abs(middle - line), 1e-5f) << x << ' ' << y;
            covered += borders[texel] / 255.0;
        }
    }
    EXPECT_NE(ids[0], ids[size - 1]);
    EXPECT_NEAR(covered / (size * size), 0.1 * 1.0, 1e-3);
}

TEST(Baking, OverlapsAreRefusedWithBothTriangles) {
    Square square(0.3f);
    square.uvs = {0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1, 1};
    std::vector<uint32_t> ids(64 * 64);
    FlgTangleBakeDesc desc = flgTangleBakeDefaults();
    desc.size = 64;
    desc.tangle = square.tangle;
    desc.mesh = &square.mesh;
    desc.corner_uvs = square.uvs.data();
    desc.ids = ids.data();
    FlgJob job = {};
    ASSERT_EQ(flgTangleBake(square.context, &desc, &job), FLG_OK);
    square.run(job);
    EXPECT_EQ(square.last, FLG_ERROR_INVALID_ARGUMENT);
    desc.size = 0;
    EXPECT_EQ(flgTangleBake(square.context, &desc, &job), FLG_ERROR_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace flg::test
