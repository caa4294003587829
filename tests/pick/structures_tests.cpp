// SPDX-License-Identifier: MIT
// What a commit builds, by the memory that Embree asks for while it does: one object's change leaves the structures of
// the others. Not with sanitizers, which have a heap of their own.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FLG_OTHER_HEAP
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define FLG_OTHER_HEAP
#endif

#ifndef FLG_OTHER_HEAP
#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

#include "filigree/filigree_pick.h"
#include "surfaces/test_meshes.h"

namespace {

std::atomic<size_t> bytes_asked{0};

}  // namespace

// In the C library's place: Embree takes its structures' memory by it.
extern "C" [[gnu::visibility("default")]] int posix_memalign(void** out, size_t alignment, size_t size) noexcept {
    bytes_asked += size;
    *out = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    return *out ? 0 : ENOMEM;
}

namespace flg::test {
namespace {

size_t asked_by_commit(FlgPickScene scene) {
    const size_t before = bytes_asked;
    EXPECT_EQ(flgPickSceneCommit(scene), FLG_OK) << flgPickErrorGetMessage();
    return bytes_asked - before;
}

TEST(PickStructures, TheFirstCurvesLeaveASurfacesAsItIs) {
    const Soup soup = torus(300, 200);
    const FlgColumn positions{FLG_ATTRIBUTE_POSITION, 3, soup.positions[0].data(), 0, 0};
    FlgSurfaceView surface{};
    surface.struct_size = sizeof surface;
    FlgMeshView mesh{};
    mesh.struct_size = sizeof mesh;
    mesh.vertex_count = static_cast<uint32_t>(soup.positions.size());
    mesh.triangle_count = static_cast<uint32_t>(soup.triangles.size());
    mesh.column_count = 1;
    mesh.columns = &positions;
    mesh.triangles = soup.triangles[0].data();
    surface.mesh = &mesh;
    const float line[] = {3, 0, 0, 4, 0, 0};
    const FlgColumn points{FLG_ATTRIBUTE_POSITION, 3, line, 0, 0};
    const uint32_t offsets[] = {0, 2};
    const FlgCurveSetView curves{sizeof curves, 1, offsets, nullptr, &points, 1, 0, {}};

    FlgPickScene scene = nullptr;
    ASSERT_EQ(flgPickSceneCreate(nullptr, &scene), FLG_OK) << flgPickErrorGetMessage();
    ASSERT_EQ(flgPickSceneSetSurface(scene, 0, &surface, nullptr, 0), FLG_OK);
    const size_t for_surface = asked_by_commit(scene);
    ASSERT_EQ(flgPickSceneSetCurves(scene, 1, &curves, 0.1f), FLG_OK);
    const size_t for_curves = asked_by_commit(scene);
    EXPECT_GT(for_surface, 50 * soup.triangles.size());
    EXPECT_LT(for_curves, for_surface / 5);

    const FlgRay rays[] = {{{1.2f, 0, 5}, 0, {0, 0, -1}, HUGE_VALF}, {{3.5f, 0, 5}, 0, {0, 0, -1}, HUGE_VALF}};
    FlgHit hits[2];
    ASSERT_EQ(flgPickSceneCastRays(scene, rays, 2, hits), FLG_OK);
    EXPECT_EQ(hits[0].object, 0u);
    EXPECT_EQ(hits[1].object, 1u);
    flgPickSceneDestroy(scene);
}

}  // namespace
}  // namespace flg::test
#endif
