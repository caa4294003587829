// SPDX-License-Identifier: MIT
// Outlines of surfaces behind the C ABI: parts that nobody drew.
#include <cmath>
#include <functional>

#include "api/host.h"
#include "filigree/filigree_model.h"

namespace flg::test {
namespace {

struct Triangles {
    std::vector<float> positions;
    std::vector<uint32_t> triangles, regions;

    uint32_t add(double x, double y, double z) {
        for (const double v : {x, y, z}) positions.push_back(static_cast<float>(v));
        return static_cast<uint32_t>(positions.size() / 3) - 1;
    }
    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t region = 0) {
        triangles.insert(triangles.end(), {a, b, c, a, c, d});
        regions.insert(regions.end(), {region, region});
    }
};

Triangles torus(double ring, double tube, double x = 0) {
    constexpr uint32_t n = 96, m = 32;
    Triangles out;
    for (uint32_t i = 0; i < n; ++i) {
        for (uint32_t k = 0; k < m; ++k) {
            const double a = 2 * M_PI * i / n, b = 2 * M_PI * k / m, r = ring + tube * std::cos(b);
            out.add(x + r * std::cos(a), r * std::sin(a), tube * std::sin(b));
        }
    }
    for (uint32_t i = 0; i < n; ++i)
        for (uint32_t k = 0; k < m; ++k)
            out.quad(i * m + k, (i + 1) % n * m + k, (i + 1) % n * m + (k + 1) % m, i * m + (k + 1) % m);
    return out;
}

// Squares with x and y from 0 to 8, tilted about the x axis; those from 2 to 5 in x and 1 to 3 in y are region 1.
Triangles sheet() {
    Triangles out;
    for (uint32_t y = 0; y <= 8; ++y)
        for (uint32_t x = 0; x <= 8; ++x) out.add(x, 0.8 * y, 0.6 * y);
    for (uint32_t y = 0; y < 8; ++y)
        for (uint32_t x = 0; x < 8; ++x)
            out.quad(9 * y + x, 9 * y + x + 1, 9 * y + x + 10, 9 * y + x + 9, x >= 2 && x < 5 && y >= 1 && y < 3);
    return out;
}

double area(const FlgContourView& contour, uint32_t ring) {
    double sum = 0;
    const uint32_t begin = contour.ring_offsets[ring], end = contour.ring_offsets[ring + 1];
    for (uint32_t i = begin; i < end; ++i) {
        const double *a = contour.points + 2 * i, *b = contour.points + 2 * (i + 1 == end ? begin : i + 1);
        sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return sum;
}

struct OutlineHost : Host {
    using Host::Host;

    FlgSurface surface(const Triangles& mesh) const {
        FlgSurfaceDesc desc = flgSurfaceDefaults();
        FlgColumn column{FLG_ATTRIBUTE_POSITION, 3, mesh.positions.data(), 0, 0};
        FlgMeshView input = flgMeshViewDefaults();
        input.vertex_count = static_cast<uint32_t>(mesh.positions.size() / 3);
        input.triangle_count = static_cast<uint32_t>(mesh.triangles.size() / 3);
        input.triangles = mesh.triangles.data();
        input.regions = mesh.regions.data();
        input.columns = &column;
        input.column_count = 1;
        desc.mesh = &input;
        FlgSurface out{};
        EXPECT_EQ(flgSurfaceCreate(context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        return out;
    }
    FlgResult outline(const FlgOutlineDesc& desc, FlgOutlineView& view) const {
        FlgOutline out{};
        const FlgResult made = flgOutlineCreate(context, &desc, &out, nullptr);
        if (made != FLG_OK) return made;
        EXPECT_EQ(flgOutlineGetView(context, out, &view), FLG_NOT_READY);
        EXPECT_EQ(flgContextTick(context, FLG_UNLIMITED, nullptr), FLG_OK);
        return flgOutlineGetView(context, out, &view);
    }
};

TEST(Outline, OfATorusIsARing) {
    const OutlineHost host;
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = host.surface(torus(2, 0.5));
    desc.direction[2] = 3;
    FlgOutlineView view = flgOutlineViewDefaults();
    ASSERT_EQ(host.outline(desc, view), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(view.contour->ring_count, 2u);
    // Of 96 corners: their chords are 0.03 % of the area inside.
    EXPECT_NEAR(area(*view.contour, 0), M_PI * 2.5 * 2.5, 0.02);
    EXPECT_NEAR(area(*view.contour, 1), -M_PI * 1.5 * 1.5, 0.01);
    // Edge-on it is a strip with round ends.
    desc.direction[2] = 0;
    desc.direction[0] = 1;
    ASSERT_EQ(host.outline(desc, view), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(view.contour->ring_count, 1u);
    EXPECT_NEAR(area(*view.contour, 0), 4 * 1 + M_PI * 0.25, 0.03);
}

TEST(Outline, OfAFlatRegionIsItsBorderInItsPlane) {
    const OutlineHost host;
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = host.surface(sheet());
    const uint32_t region = 1;
    desc.regions = &region;
    desc.region_count = 1;
    FlgOutlineView view = flgOutlineViewDefaults();
    ASSERT_EQ(host.outline(desc, view), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(view.contour->ring_count, 1u);
    EXPECT_NEAR(area(*view.contour, 0), 6, 1e-5);
    // Back in its place each point is on the region's border.
    for (uint32_t i = 0; i < view.contour->point_count; ++i) {
        const double *p = view.contour->points + 2 * i, *m = view.placement;
        const double x = m[0] * p[0] + m[1] * p[1] + m[3], y = m[4] * p[0] + m[5] * p[1] + m[7];
        const double z = m[8] * p[0] + m[9] * p[1] + m[11];
        EXPECT_NEAR(z, 0.75 * y, 1e-5);
        const double along = y / 0.8;
        const bool on_side = std::abs(x - 2) < 1e-5 || std::abs(x - 5) < 1e-5;
        const bool on_end = std::abs(along - 1) < 1e-5 || std::abs(along - 3) < 1e-5;
        EXPECT_TRUE((on_side && along > 0.999 && along < 3.001) || (on_end && x > 1.999 && x < 5.001))
            << x << " " << along;
    }
}

TEST(Outline, OfSeveralPiecesIsTheLargest) {
    const OutlineHost host;
    Triangles both = torus(2, 0.5);
    const Triangles small = torus(1, 0.4, 10);
    const auto first = static_cast<uint32_t>(both.positions.size() / 3);
    both.positions.insert(both.positions.end(), small.positions.begin(), small.positions.end());
    for (const uint32_t v : small.triangles) both.triangles.push_back(first + v);
    both.regions.resize(both.triangles.size() / 3, 0);
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = host.surface(both);
    desc.direction[2] = 1;
    FlgOutlineView view = flgOutlineViewDefaults();
    ASSERT_EQ(host.outline(desc, view), FLG_OK) << flgErrorGetMessage();
    EXPECT_NEAR(area(*view.contour, 0), M_PI * 2.5 * 2.5, 0.02);
}

TEST(Outline, BecomesAPartWithBonesInsideOfTheMesh) {
    const OutlineHost host;
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = host.surface(torus(2, 0.5));
    desc.direction[2] = 1;
    FlgOutlineView outline = flgOutlineViewDefaults();
    ASSERT_EQ(host.outline(desc, outline), FLG_OK) << flgErrorGetMessage();
    FlgPartDesc part_desc = flgPartDefaults();
    part_desc.contour = outline.contour;
    FlgModelPart part = flgModelPartDefaults();
    ASSERT_EQ(flgPartCreate(host.context, &part_desc, &part.part, nullptr), FLG_OK) << flgErrorGetMessage();
    std::copy(outline.placement, outline.placement + 12, part.placement);
    FlgModelDesc model_desc = flgModelDefaults();
    model_desc.parts = &part;
    model_desc.part_count = 1;
    FlgBoneThresholds thresholds = flgBoneThresholdsDefaults();
    thresholds.simplify = 0.0025f;  // near the middle of the tube
    model_desc.thresholds = &thresholds;
    FlgModel model{};
    ASSERT_EQ(flgModelCreate(host.context, &model_desc, &model, nullptr), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(flgContextTick(host.context, FLG_UNLIMITED, nullptr), FLG_OK);
    FlgModelView view = flgModelViewDefaults();
    ASSERT_EQ(flgModelGetView(host.context, model, &view), FLG_OK) << flgErrorGetMessage();
    ASSERT_GT(view.joint_count, 5u);
    for (uint32_t j = 0; j < view.joint_count; ++j) {
        const float* p = view.joint_positions + 3 * j;
        EXPECT_NEAR(std::hypot(p[0], p[1]), 2, 0.15);
        EXPECT_NEAR(p[2], 0, 1e-5);
    }
}

TEST(Outline, RefusesWhatHasNone) {
    const OutlineHost host;
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = host.surface(torus(2, 0.5));
    FlgOutlineView view = flgOutlineViewDefaults();
    const auto refused = [&](const FlgOutlineDesc& bad, const std::string& words) {
        EXPECT_EQ(host.outline(bad, view), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgErrorGetMessage()).find(words), std::string::npos) << flgErrorGetMessage();
    };
    FlgOutlineDesc bad = desc;
    bad.direction[1] = NAN;
    refused(bad, "desc.direction is nan");
    bad = desc;
    const uint32_t region = 7;
    bad.direction[2] = 1;
    bad.regions = &region;
    refused(bad, "desc.region_count is 0");
    bad.region_count = 1;
    refused(bad, "desc.regions have no triangles");
    bad.surface = {};
    FlgOutline out{77};
    EXPECT_EQ(flgOutlineCreate(host.context, &bad, &out, nullptr), FLG_ERROR_INVALID_HANDLE);
    EXPECT_EQ(out.id, 0u);
}

}  // namespace
}  // namespace flg::test
