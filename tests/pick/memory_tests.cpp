// SPDX-License-Identifier: MIT
// A scene's memory: its own from the host's allocator, Embree's as far as the host grants it.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "filigree/filigree_pick.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

struct Host {
    std::atomic<int64_t> calls{0}, live{0}, failing{-1};
    std::atomic<int64_t> asked{0}, granted{0}, refusing{-1};

    const FlgAllocator allocator{sizeof(FlgAllocator), this,
                                 [](void* self, size_t size, size_t alignment) -> void* {
                                     auto& host = *static_cast<Host*>(self);
                                     if (host.calls++ == host.failing) return nullptr;
                                     host.live += static_cast<int64_t>(size);
                                     return std::aligned_alloc(alignment,
                                                               (size + alignment - 1) / alignment * alignment);
                                 },
                                 [](void* self, void* memory, size_t size, size_t) {
                                     static_cast<Host*>(self)->live -= static_cast<int64_t>(size);
                                     std::free(memory);
                                 }};
    FlgPickSceneDesc desc() {
        FlgPickSceneDesc desc = flgPickSceneDefaults();
        desc.allocator = &allocator;
        desc.user_data = this;
        desc.embree_memory = [](void* self, int64_t bytes) -> uint32_t {
            auto& host = *static_cast<Host*>(self);
            if (bytes > 0 && host.asked++ == host.refusing) return 0;
            host.granted += bytes;
            return 1;
        };
        return desc;
    }
};

struct Shown {
    const Soup soup;
    const FlgColumn column{FLG_ATTRIBUTE_POSITION, 3, soup.positions[0].data(), 0, 0};
    FlgMeshView mesh{};
    FlgSurfaceView surface{};
    const float line[6] = {3, 0, 0, 4, 0, 0};
    const uint32_t offsets[2] = {0, 2};
    const FlgColumn line_column{FLG_ATTRIBUTE_POSITION, 3, line, 0, 0};
    FlgCurveSetView curves{};

    explicit Shown(const Soup& shown = torus(20, 12)) : soup(shown) {
        mesh.struct_size = sizeof mesh;
        mesh.vertex_count = static_cast<uint32_t>(soup.positions.size());
        mesh.triangle_count = static_cast<uint32_t>(soup.triangles.size());
        mesh.column_count = 1;
        mesh.columns = &column;
        mesh.triangles = soup.triangles[0].data();
        surface.struct_size = sizeof surface;
        surface.mesh = &mesh;
        curves.struct_size = sizeof curves;
        curves.curve_count = 1;
        curves.curve_offsets = offsets;
        curves.columns = &line_column;
        curves.column_count = 1;
    }
};

// All that a scene does; what it hits, if it came so far.
FlgResult run(const FlgPickSceneDesc& desc, uint32_t& triangle) {
    const Shown shown;
    FlgPickScene scene = nullptr;
    FlgResult result = flgPickSceneCreate(&desc, &scene);
    if (result != FLG_OK) {
        EXPECT_EQ(scene, nullptr);
        return result;
    }
    const uint32_t changed[] = {5, 6, 7};
    result = flgPickSceneSetSurface(scene, 1, &shown.surface, nullptr, 0);
    if (result == FLG_OK) result = flgPickSceneSetCurves(scene, 2, &shown.curves, 0.01f);
    if (result == FLG_OK) result = flgPickSceneCommit(scene);
    if (result == FLG_OK) result = flgPickSceneSetSurface(scene, 1, &shown.surface, changed, 3);
    if (result == FLG_OK) result = flgPickSceneCommit(scene);
    const std::vector<FlgRay> rays(10'000, FlgRay{{0, 0, 9}, 0, {0.09f, 0.01f, -1}, 99});
    std::vector<FlgHit> hits(rays.size());
    if (result == FLG_OK) result = flgPickSceneCastRays(scene, rays.data(), 10'000, hits.data());
    if (result == FLG_OK) triangle = hits[9'999].element;
    flgPickSceneDestroy(scene);
    return result;
}

TEST(PickMemory, EachAllocationMayFail) {
    Host host;
    uint32_t whole = 0;
    ASSERT_EQ(run(host.desc(), whole), FLG_OK) << flgPickErrorGetMessage();
    ASSERT_NE(whole, FLG_NO_INDEX);
    const int64_t count = host.calls;
    EXPECT_GT(count, 15);
    EXPECT_EQ(host.live, 0);
    for (int64_t n = 0; n < count; ++n) {
        SCOPED_TRACE(n);
        host.calls = 0;
        host.failing = n;
        uint32_t triangle = 0;
        EXPECT_EQ(run(host.desc(), triangle), FLG_ERROR_OUT_OF_MEMORY);
        EXPECT_STREQ(flgPickErrorGetMessage(), "no memory is left");
        EXPECT_EQ(host.live, 0);
    }
    host.failing = -1;
    uint32_t again = 0;
    EXPECT_EQ(run(host.desc(), again), FLG_OK);
    EXPECT_EQ(again, whole);
}

TEST(PickMemory, EmbreesMayBeRefused) {
    Host host;
    uint32_t whole = 0;
    ASSERT_EQ(run(host.desc(), whole), FLG_OK) << flgPickErrorGetMessage();
    const int64_t count = host.asked;
    EXPECT_GT(count, 5);
    EXPECT_EQ(host.granted, 0);
    for (int64_t n = 0; n < count; ++n) {
        SCOPED_TRACE(n);
        host.asked = 0;
        host.refusing = n;
        uint32_t triangle = 0;
        EXPECT_EQ(run(host.desc(), triangle), FLG_ERROR_OUT_OF_MEMORY) << flgPickErrorGetMessage();
        EXPECT_NE(std::string(flgPickErrorGetMessage()).find("no memory is left"), std::string::npos)
            << flgPickErrorGetMessage();
        EXPECT_EQ(host.live, 0);
    }
    host.refusing = -1;
    uint32_t again = 0;
    EXPECT_EQ(run(host.desc(), again), FLG_OK);
    EXPECT_EQ(again, whole);
}

TEST(PickMemory, ASceneThatWasRefusedGoesOn) {
    // Large enough that Embree's threads share the work.
    const Shown shown(torus(300, 200));
    Host host;
    FlgPickSceneDesc desc = host.desc();
    desc.threads = 2;
    FlgPickScene scene = nullptr;
    ASSERT_EQ(flgPickSceneCreate(&desc, &scene), FLG_OK);
    host.asked = 0;
    for (int64_t n = 0;; ++n) {
        host.asked = 0;
        host.refusing = n;
        FlgResult result = flgPickSceneSetSurface(scene, 1, &shown.surface, nullptr, 0);
        if (result == FLG_OK) result = flgPickSceneCommit(scene);
        if (result == FLG_OK) break;
        ASSERT_EQ(result, FLG_ERROR_OUT_OF_MEMORY) << flgPickErrorGetMessage();
        ASSERT_LT(n, 1000);
    }
    const FlgRay ray{{0, 0, 9}, 0, {0.09f, 0.01f, -1}, 99};
    FlgHit hit{};
    ASSERT_EQ(flgPickSceneCastRays(scene, &ray, 1, &hit), FLG_OK);
    EXPECT_EQ(hit.object, 1u);
    flgPickSceneDestroy(scene);
    EXPECT_EQ(host.live, 0);
}

TEST(PickMemory, HalfAnAllocatorIsRefused) {
    Host host;
    FlgAllocator half = host.allocator;
    half.free = nullptr;
    FlgPickSceneDesc desc = flgPickSceneDefaults();
    desc.allocator = &half;
    FlgPickScene scene = nullptr;
    EXPECT_EQ(flgPickSceneCreate(&desc, &scene), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgPickErrorGetMessage(), "desc.allocator.free is null, but the other function is not");
    half = host.allocator;
    half.allocate = nullptr;
    EXPECT_EQ(flgPickSceneCreate(&desc, &scene), FLG_ERROR_INVALID_ARGUMENT);
    half.struct_size = 1;
    EXPECT_EQ(flgPickSceneCreate(&desc, &scene), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(scene, nullptr);
    EXPECT_EQ(host.calls, 0);
}

}  // namespace
}  // namespace flg::test
