// SPDX-License-Identifier: MIT
// The eight macros: what they make of a cylinder, as one step.
#include "tangles/tangle_host.h"

namespace flg::test {
namespace {

const Regions root = {0};

FlgTangleApplyMacroDesc macro(FlgTangle tangle, FlgTangleMacro kind) {
    FlgTangleApplyMacroDesc desc = flgTangleApplyMacroDefaults();
    desc.tangle = tangle;
    desc.kind = kind;
    desc.regions = root.data();
    desc.region_count = 1;
    return desc;
}

FlgResult apply(const TangleHost& host, const FlgTangleApplyMacroDesc& desc) {
    FlgJob job{};
    EXPECT_EQ(flgTangleApplyMacro(host.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return host.result_of(job);
}

TEST(TangleMacros, EachIsOneStep) {
    for (int kind = FLG_TANGLE_MACRO_SUNBURST; kind <= FLG_TANGLE_MACRO_CELLS; ++kind) {
        const TangleHost host;
        const FlgSurface surface = host.surface(cylinder(60, 20));
        const FlgTangle tangle = host.tangle(surface);
        const std::string before = bits(host.view(surface));
        FlgTangleApplyMacroDesc desc = macro(tangle, static_cast<FlgTangleMacro>(kind));
        desc.size = 0.15f;
        desc.spacing = 0.5f;
        ASSERT_EQ(apply(host, desc), FLG_OK) << "macro " << kind;
        expect_valid(host, surface, tangle, host.report(surface).area);
        EXPECT_GT(host.info(tangle).leaf_count, 1u) << "macro " << kind;
        EXPECT_EQ(host.info(tangle).undo_count, 1u);
        const std::string after = bits(host.view(surface));
        ASSERT_EQ(host.undo(tangle), FLG_OK);
        EXPECT_EQ(bits(host.view(surface)), before) << "macro " << kind;
        EXPECT_EQ(host.info(tangle).redo_count, 1u);
        ASSERT_EQ(host.redo(tangle), FLG_OK);
        EXPECT_EQ(bits(host.view(surface)), after) << "macro " << kind;
    }
}

TEST(TangleMacros, AGridIsAChequerboard) {
    const TangleHost host;
    const FlgSurface surface = host.surface(cylinder(48, 20));
    const FlgTangle tangle = host.tangle(surface);
    const double whole = host.report(surface).area;
    FlgTangleApplyMacroDesc desc = macro(tangle, FLG_TANGLE_MACRO_GRID);
    desc.count = 4;
    desc.size = static_cast<float>(whole / 2 / 12);
    ASSERT_EQ(apply(host, desc), FLG_OK);
    const FlgSurfaceView view = host.view(surface);
    const std::map<uint32_t, double> cells = areas(view);
    ASSERT_EQ(cells.size(), 48u);
    for (const auto& [label, area] : cells) EXPECT_NEAR(area, whole / 48, 0.02 * whole / 48);
    expect_chequered(host, surface, tangle);
}

// A tube whose lower border is a third longer than the upper one.
MeshArrays flared(uint32_t around, uint32_t rows) {
    MeshArrays mesh = cylinder(around, rows);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const float wide = 1 + (2 - mesh.positions[3 * v + 2]) / 6;
        mesh.positions[3 * v] *= wide;
        mesh.positions[3 * v + 1] *= wide;
    }
    return mesh;
}

// Whatever its length, a border gets an even number of strips: those that touch are of different groups.
TEST(TangleMacros, SunburstsCloseWithoutASeam) {
    const TangleHost host;
    for (const float size : {0.31f, 0.47f, 0.52f, 0.6f, 1.1f, 40.0f}) {
        const FlgSurface surface = host.surface(cylinder(96, 24));
        const FlgTangle tangle = host.tangle(surface);
        FlgTangleApplyMacroDesc desc = macro(tangle, FLG_TANGLE_MACRO_SUNBURST);
        desc.size = size;
        ASSERT_EQ(apply(host, desc), FLG_OK) << size;
        const size_t strips = host.leaves(tangle).size();
        EXPECT_EQ(strips % 2, 0u) << size;
        EXPECT_NEAR(static_cast<double>(strips), std::max(4.0, 2 * M_PI / size), 1.01) << size;
        expect_valid(host, surface, tangle, host.report(surface).area);
        expect_chequered(host, surface, tangle);
    }
}

TEST(TangleMacros, SunburstsStartFromTheLongestBorderOrTheOneThatIsNamed) {
    const TangleHost host;
    for (const uint32_t border : {FLG_NO_INDEX, 0u, 1u}) {
        const FlgSurface surface = host.surface(flared(96, 24));
        const FlgTangle tangle = host.tangle(surface);
        ASSERT_LT(host.view(surface).mesh->triangles[0], 96u);
        FlgTangleApplyMacroDesc desc = macro(tangle, FLG_TANGLE_MACRO_SUNBURST);
        desc.border = border;
        desc.size = 0.4f;
        ASSERT_EQ(apply(host, desc), FLG_OK);
        // The least edge is one of the first row of triangles, which is the lower one.
        const double length = border == 1 ? 2 * M_PI : 8 * M_PI / 3;
        EXPECT_EQ(host.leaves(tangle).size(), 2 * static_cast<size_t>(std::lround(length / 0.4 / 2))) << border;
    }
    const FlgSurface surface = host.surface(flared(24, 4));
    FlgTangleApplyMacroDesc desc = macro(host.tangle(surface), FLG_TANGLE_MACRO_SUNBURST);
    desc.border = 2;
    EXPECT_EQ(apply(host, desc), FLG_ERROR_INVALID_ARGUMENT);
}

// However narrow the strip: one row of petals at least.
TEST(TangleMacros, FlowersFitIntoNarrowStrips) {
    const TangleHost host;
    const FlgSurface surface = host.surface(cylinder(160, 40));
    const FlgTangle tangle = host.tangle(surface);
    FlgTangleApplyMacroDesc desc = macro(tangle, FLG_TANGLE_MACRO_FLOWER);
    desc.count = 2;
    desc.spacing = 30;
    ASSERT_EQ(apply(host, desc), FLG_OK);
    expect_valid(host, surface, tangle, host.report(surface).area);
    // The strip is 2 m wide and 6.28 m long: samples are 1.5 m apart at least, and 0.75 m from its borders.
    uint32_t petals = 0;
    for (const uint32_t leaf : host.leaves(tangle)) petals += host.region(tangle, leaf).part == 2;
    EXPECT_GE(petals, 3u);
    EXPECT_LE(petals, 6u);
}

TEST(TangleMacros, RefuseWhatTheyCantDo) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(8));
    const FlgTangle tangle = host.tangle(surface);
    const std::string before = bits(host.view(surface));
    for (const FlgTangleMacro kind : {FLG_TANGLE_MACRO_SUNBURST, FLG_TANGLE_MACRO_GRID}) {
        EXPECT_EQ(apply(host, macro(tangle, kind)), FLG_ERROR_INVALID_ARGUMENT) << "a square has one border";
    }
    EXPECT_EQ(bits(host.view(surface)), before);
    EXPECT_EQ(host.info(tangle).undo_count, 0u);
    FlgTangleApplyMacroDesc bad = macro(tangle, FLG_TANGLE_MACRO_POLKA_DOTS);
    bad.size = 0;
    EXPECT_EQ(flgTangleApplyMacro(host.context, &bad, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    bad = macro(tangle, static_cast<FlgTangleMacro>(8));
    EXPECT_EQ(flgTangleApplyMacro(host.context, &bad, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    bad = macro(tangle, FLG_TANGLE_MACRO_FRAMES);
    bad.count = 1'000'000;
    EXPECT_EQ(flgTangleApplyMacro(host.context, &bad, nullptr), FLG_ERROR_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace flg::test
