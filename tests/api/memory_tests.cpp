// SPDX-License-Identifier: MIT
// What a context holds, by kind, and a limit on it.
#include "api/live_inputs.h"
#include "api/memory_uses.h"
#include "api/part_inputs.h"
#include "api/surface_inputs.h"

namespace flg::test {
namespace {

// Every kind by itself: the sum is what the host has given, and the total says so too.
MemoryUses memory_of(const Host& host) {
    const MemoryUses memory = memory_uses(host.context);
    for (const FlgMemoryUse* use : {&memory.styles, &memory.surfaces, &memory.curves, &memory.models, &memory.caches,
                                    &memory.scratch, &memory.runtime}) {
        EXPECT_LE(use->bytes, use->peak_bytes);
    }
    EXPECT_EQ(memory.sum(), static_cast<uint64_t>(host.allocator.live_bytes.load()));
    EXPECT_EQ(memory.total.bytes, memory.sum());
    EXPECT_GE(memory.total.peak_bytes, memory.sum());
    return memory;
}

TEST(ContextGetMemory, KnowsAContextWithoutObjects) {
    const Host host;
    const MemoryUses memory = memory_of(host);
    EXPECT_GT(memory.runtime.bytes, 1000u);
    EXPECT_LT(memory.runtime.bytes, 8000u);
    EXPECT_EQ(memory.total.bytes, memory.runtime.bytes);
}

TEST(ContextGetMemory, RefusesWhatIsNoContextOrStruct) {
    const Host host;
    FlgMemoryUse use = flgMemoryUseDefaults();
    use.bytes = 7;
    expect_failure(flgContextGetMemory({}, FLG_MEMORY_KIND_TOTAL, &use), FLG_ERROR_INVALID_HANDLE, "context is null");
    EXPECT_EQ(use.bytes, 0u);
    expect_failure(flgContextGetMemory(host.context, FLG_MEMORY_KIND_TOTAL, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_use is null");
    const auto beyond = static_cast<FlgMemoryKind>(FLG_MEMORY_KIND_RUNTIME + 1);
    expect_failure(flgContextGetMemory(host.context, beyond, &use), FLG_ERROR_INVALID_ARGUMENT, "kind is 8");
    expect_failure(flgContextSetMemoryLimit(host.context, beyond, 1), FLG_ERROR_INVALID_ARGUMENT, "kind is 8");
    expect_failure(flgContextSetMemoryLimit({}, FLG_MEMORY_KIND_TOTAL, 1), FLG_ERROR_INVALID_HANDLE, "context is null");
    use.struct_size = 4;
    expect_failure(flgContextGetMemory(host.context, FLG_MEMORY_KIND_TOTAL, &use), FLG_ERROR_INVALID_ARGUMENT,
                   "struct_size");
}

TEST(ContextGetMemory, CountsCurvesStylesAndTheirCaches) {
    const Host host;
    constexpr uint32_t points = 10'000;
    Curves line;
    for (uint32_t i = 0; i < points; ++i) line.add_point(i, 0, 0);
    line.end_curve();
    const FlgCurveSet set = host.create(line);
    const MemoryUses with_curve = memory_of(host);
    EXPECT_GE(with_curve.curves.bytes, points * 3 * sizeof(float));
    EXPECT_LE(with_curve.curves.bytes, points * 3 * sizeof(float) + 2000);
    EXPECT_EQ(with_curve.scratch.bytes, 0u);

    FlgStyleDesc desc = flgStyleDefaults();
    desc.point_count = 256;
    desc.style = host.create(coil());
    FlgStyle style{};
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
    EXPECT_GT(memory_of(host).scratch.bytes, 0u);  // the task's frame
    host.finish();
    const MemoryUses with_style = memory_of(host);
    EXPECT_GT(with_style.styles.bytes, 256u * 100);
    EXPECT_EQ(with_style.caches.bytes, 0u);
    EXPECT_EQ(with_style.scratch.bytes, 0u);
    EXPECT_GT(with_style.scratch.peak_bytes, 0u);

    ASSERT_EQ(flgStyleWarm(host.context, style, 0, nullptr, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const MemoryUses warm = memory_of(host);
    EXPECT_GT(warm.caches.bytes, 256u * 256);
    EXPECT_EQ(warm.styles.bytes, with_style.styles.bytes);

    FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
    stylize.style = style;
    stylize.target = host.create(arcs(2));
    const uint64_t before = memory_of(host).curves.bytes;
    FlgCurveSet out{};
    ASSERT_EQ(flgCurveSetStylize(host.context, &stylize, &out, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const MemoryUses stylized = memory_of(host);
    const FlgCurveSetView view = host.view_of(out);
    EXPECT_GE(stylized.curves.bytes - before, size_t{view.curve_offsets[view.curve_count]} * 3 * sizeof(float));
    EXPECT_EQ(stylized.scratch.bytes, 0u);
    EXPECT_EQ(stylized.caches.bytes, warm.caches.bytes);

    ASSERT_EQ(flgCurveSetRelease(host.context, set), FLG_OK);
    ASSERT_EQ(flgCurveSetRelease(host.context, out), FLG_OK);
    ASSERT_EQ(flgCurveSetRelease(host.context, stylize.target), FLG_OK);
    ASSERT_EQ(flgCurveSetRelease(host.context, desc.style), FLG_OK);
    ASSERT_EQ(flgStyleRelease(host.context, style), FLG_OK);
    host.finish();
    const MemoryUses none = memory_of(host);
    for (const FlgMemoryUse use : {none.styles, none.surfaces, none.curves, none.models, none.caches, none.scratch}) {
        EXPECT_EQ(use.bytes, 0u);
    }
    EXPECT_EQ(none.curves.peak_bytes, stylized.curves.peak_bytes);
}

TEST(ContextGetMemory, CountsSurfacesAndTheirSolvers) {
    for (const uint32_t workers : {0u, 2u}) {
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = workers;
        const SurfaceHost host(desc);
        const FlgSurface surface = host.start_surface(sphere(16));
        host.finish();
        const MemoryUses with_surface = memory_of(host);
        EXPECT_GT(with_surface.surfaces.bytes, 6u * 16 * 16 * 2 * 30);
        EXPECT_EQ(with_surface.caches.bytes, 0u);
        EXPECT_EQ(with_surface.scratch.bytes, 0u);
        const FlgField field = host.start_distances(surface, 3);
        host.finish();
        const MemoryUses with_field = memory_of(host);
        EXPECT_GT(with_field.caches.bytes, with_surface.surfaces.bytes);
        EXPECT_GT(with_field.surfaces.bytes, with_surface.surfaces.bytes);
        EXPECT_EQ(with_field.scratch.bytes, 0u);
        ASSERT_EQ(flgFieldRelease(host.context, field), FLG_OK);
        ASSERT_EQ(flgSurfaceRelease(host.context, surface), FLG_OK);
        host.finish();
        const MemoryUses none = memory_of(host);
        EXPECT_EQ(none.surfaces.bytes, 0u);
        EXPECT_EQ(none.caches.bytes, 0u);
    }
}

TEST(ContextGetMemory, CountsModels) {
    const PartHost host;
    std::vector<double> ellipse;
    for (int i = 0; i < 60; ++i) {
        ellipse.push_back(3 * std::cos(2 * M_PI * i / 60));
        ellipse.push_back(std::sin(2 * M_PI * i / 60));
    }
    const FlgPart part = host.part(ellipse);
    host.finish();
    EXPECT_GT(memory_of(host).models.bytes, 2000u);
    EXPECT_EQ(memory_of(host).scratch.bytes, 0u);
    ASSERT_EQ(flgPartRelease(host.context, part), FLG_OK);
    EXPECT_EQ(memory_of(host).models.bytes, 0u);
}

// A cancelled job leaves nothing of what it worked with.
TEST(ContextGetMemory, CountsNothingOfACancelledJob) {
    const SurfaceHost host;
    const FlgSurface surface = host.surface(sphere(48));
    const MemoryUses before = memory_of(host);
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    const uint32_t vertex = 5;
    desc.surface = surface;
    desc.vertices = &vertex;
    desc.vertex_count = 1;
    FlgField field{};
    FlgJob job{};
    ASSERT_EQ(flgFieldCreateGeodesic(host.context, &desc, &field, &job), FLG_OK) << flgErrorGetMessage();
    for (int i = 0; i < 10; ++i) ASSERT_EQ(flgContextTick(host.context, 50, nullptr), FLG_OK);
    EXPECT_GT(memory_of(host).scratch.bytes, 0u);
    ASSERT_EQ(flgJobCancel(host.context, job), FLG_OK);
    host.finish();
    ASSERT_EQ(flgFieldRelease(host.context, field), FLG_OK);
    EXPECT_EQ(memory_of(host).scratch.bytes, 0u);
    EXPECT_LE(memory_of(host).surfaces.bytes, before.surfaces.bytes + 1000);  // who waits for whom
}

TEST(ContextMemoryLimit, IsNamedByCallsAndJobs) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 0;
    desc.memory_limit = 200'000;
    const Host host(desc);
    Curves line;
    for (uint32_t i = 0; i < 20'000; ++i) line.add_point(i, 0, 0);
    line.end_curve();
    const FlgCurveSetView view = line.view();
    FlgCurveSet set{};
    expect_failure(flgCurveSetCreate(host.context, &view, &set), FLG_ERROR_OUT_OF_MEMORY,
                   "memory_limit is 200000 bytes, which leaves no room for ");
    EXPECT_EQ(set.id, 0u);
    FlgStyleDesc style_desc = flgStyleDefaults();
    style_desc.style = host.create(coil());
    style_desc.point_count = 1024;
    FlgStyle style{};
    FlgJob job{};
    ASSERT_EQ(flgStyleCreate(host.context, &style_desc, &style, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_OUT_OF_MEMORY);
    EXPECT_NE(std::string(host.status_of(job).error).find("memory_limit is 200000 bytes, "), std::string::npos)
        << host.status_of(job).error;
    const MemoryUses memory = memory_of(host);
    EXPECT_LE(memory.total.peak_bytes, 200'000u);
    EXPECT_EQ(memory.scratch.bytes, 0u);
    host.create(coil());  // what there is room for still works
}

// Of calls, caches and results of jobs; other kinds are not touched, and a limit that is lifted is gone.
TEST(ContextMemoryLimit, OfAKindHoldsForThatKindAlone) {
    for (const uint32_t workers : {0u, 2u}) {
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = workers;
        const Host host(desc);
        Curves line;
        for (uint32_t i = 0; i < 20'000; ++i) line.add_point(i, 0, 0);
        line.end_curve();
        const FlgCurveSetView view = line.view();
        const FlgCurveSet before = host.create(line);
        ASSERT_EQ(flgContextSetMemoryLimit(host.context, FLG_MEMORY_KIND_CURVES, 400'000), FLG_OK);
        EXPECT_EQ(memory_of(host).curves.limit, 400'000u);
        EXPECT_EQ(memory_of(host).styles.limit, 0u);
        FlgCurveSet set{};
        expect_failure(flgCurveSetCreate(host.context, &view, &set), FLG_ERROR_OUT_OF_MEMORY,
                       "the limit of curves is 400000 bytes, which leaves no room for ");

        // A job works with scratch; its result counts as curves when it ends.
        FlgCurveSetResampleDesc resample = flgCurveSetResampleDefaults();
        resample.curves = before;
        resample.spacing = 0.5f;
        FlgJob job{};
        ASSERT_EQ(flgCurveSetResample(host.context, &resample, &set, &job), FLG_OK) << flgErrorGetMessage();
        host.finish();
        EXPECT_EQ(host.result_of(job), FLG_ERROR_OUT_OF_MEMORY);
        EXPECT_NE(std::string(host.status_of(job).error).find("the limit of curves is 400000 bytes"), std::string::npos)
            << host.status_of(job).error;
        ASSERT_EQ(flgCurveSetRelease(host.context, set), FLG_OK);
        EXPECT_LE(memory_of(host).curves.bytes, 400'000u);

        // Below what is held: nothing further, and nothing is taken away.
        ASSERT_EQ(flgContextSetMemoryLimit(host.context, FLG_MEMORY_KIND_CURVES, 10), FLG_OK);
        Curves arc = arcs(1, 2);
        const FlgCurveSetView small = arc.view();
        EXPECT_EQ(flgCurveSetCreate(host.context, &small, &set), FLG_ERROR_OUT_OF_MEMORY);
        EXPECT_EQ(host.view_of(before).curve_offsets[1], 20'000u);
        ASSERT_EQ(flgContextSetMemoryLimit(host.context, FLG_MEMORY_KIND_CURVES, 0), FLG_OK);
        ASSERT_EQ(flgCurveSetResample(host.context, &resample, &set, &job), FLG_OK) << flgErrorGetMessage();
        host.finish();
        EXPECT_EQ(host.result_of(job), FLG_OK);

        ASSERT_EQ(flgContextSetMemoryLimit(host.context, FLG_MEMORY_KIND_SCRATCH, 1000), FLG_OK);
        FlgStyleDesc style_desc = flgStyleDefaults();
        style_desc.style = host.create(coil());
        style_desc.point_count = 1024;
        FlgStyle style{};
        ASSERT_EQ(flgStyleCreate(host.context, &style_desc, &style, &job), FLG_OK) << flgErrorGetMessage();
        host.finish();
        EXPECT_EQ(host.result_of(job), FLG_ERROR_OUT_OF_MEMORY);
        EXPECT_NE(std::string(host.status_of(job).error).find("the limit of scratch is 1000 bytes"), std::string::npos)
            << host.status_of(job).error;
    }
}

TEST(ContextMemoryLimit, HoldsForTheContextItself) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 0;
    desc.memory_limit = 100;
    HostAllocator allocator;
    desc.allocator = allocator.hook();
    FlgContext context{};
    expect_failure(flgContextCreate(&desc, &context), FLG_ERROR_OUT_OF_MEMORY, "memory_limit is 100 bytes");
    EXPECT_EQ(context.id, 0u);
    EXPECT_EQ(allocator.live_bytes, 0);
}

}  // namespace
}  // namespace flg::test
