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
