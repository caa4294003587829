// SPDX-License-Identifier: MIT
// Memory on the device: what it is used for, that it is bounded, and that it comes back.
#include "meshes.h"

namespace flg::render::test {
namespace {

constexpr uint64_t mebi = 1 << 20;
constexpr uint64_t block = 16 * mebi;  // of memory, as the renderer takes it

uint64_t used(const MemoryReport& m) {
    return m.curves + m.surfaces + m.textures + m.targets + m.shadow_map + m.staging + m.other;
}

Image plain(uint32_t edge) {
    return {edge, edge, std::vector<uint8_t>(size_t{4} * edge * edge, 200)};
}

Options limited(uint64_t bytes) {
    Options options;
    options.validation = true;
    options.samples = 1;
    options.shadow_size = 512;
    options.memory_limit_bytes = bytes;
    return options;
}

TEST_F(RendererTest, MemoryIsReportedByUse) {
    const MemoryReport before = renderer.memory();
    EXPECT_EQ(before.curves + before.surfaces + before.targets, 0u);
    EXPECT_GE(before.shadow_map, uint64_t{4} * 512 * 512);
    EXPECT_GT(before.limit, 0u);
    Curves knot = trefoil(3000);
    Mesh ball = sphere(0.5f, 60);
    renderer.upload(knot.view());
    renderer.upload(ball.view());
    renderer.upload(plain(100));
    Target target(renderer, 128, 128);
    const MemoryReport after = renderer.memory();
    EXPECT_GE(after.curves, 3000u * 12);
    EXPECT_GE(after.surfaces, 28 * ball.positions.size() + 4 * ball.triangles.size());
    EXPECT_GE(after.textures, before.textures + 4 * 100 * 100);
    EXPECT_GE(after.targets, 2u * 4 * 128 * 128) << "colour and depth";
    EXPECT_GT(after.staging, 0u);
    EXPECT_LE(used(after), after.held);
    renderer.draw(target, front_camera());
    EXPECT_EQ(renderer.stats().device_bytes, renderer.memory().held);
}

TEST_F(RendererTest, MemoryBeyondTheLimitIsRefusedAndNothingChanges) {
    Renderer small(limited(40 * mebi));
    Target target(small, 64, 64);
    Mesh ball = sphere(0.5f, 100), large = sphere(0.4f, 800);  // 1 MB, 60 MB
    Curves knot = trefoil(300), endless = trefoil(1'500'000);
    const SurfaceId id = small.upload(ball.view());
    const CurvesId curves = small.upload(knot.view(), {.shape = Shape::tube, .radius = 0.2f});
    const TextureId texture = small.upload(plain(16));
    small.draw(target, front_camera());
    const Image before = small.capture(target);
    const MemoryReport report = small.memory();

    expect_error([&] { small.upload(large.view()); }, "for surfaces; ");
    expect_error([&] { small.update(id, large.view()); }, "the limit is 41943040");
    expect_error([&] { small.upload(endless.view()); }, "the limit is 41943040");
    expect_error([&] { small.update(curves, endless.view()); }, "the limit is 41943040");
    expect_error([&] { small.upload(plain(4000)); }, "64000000 bytes were asked for, for textures; ");
    expect_error([&] { small.update(texture, plain(4000)); }, "the limit is 41943040");
    expect_error([&] { target.resize(4000, 4000); }, "for targets; ");
    expect_error([&] { Target other(small, 4000, 4000); }, "the limit is 41943040");
    EXPECT_EQ(target.width(), 64u);

    const MemoryReport after = small.memory();
    EXPECT_EQ(after.curves, report.curves);
    EXPECT_EQ(after.surfaces, report.surfaces);
    EXPECT_EQ(after.textures, report.textures);
    EXPECT_EQ(after.targets, report.targets);
    EXPECT_LE(after.held, 40 * mebi);
    small.draw(target, front_camera());
    EXPECT_EQ(small.capture(target).pixels, before.pixels);
    small.update(id, ball.view());
    small.draw(target, front_camera());
    EXPECT_EQ(small.capture(target).pixels, before.pixels);
    expect_silence(small);
}

TEST_F(RendererTest, WhatIsFullHasRoomAgainOnceThingsAreRemoved) {
    Renderer small(limited(40 * mebi));
    Target target(small, 64, 64);
    Mesh ball = sphere(0.5f, 100);
    std::vector<SurfaceId> ids;
    for (int round = 0; round < 3; ++round) {
        size_t fitted = ids.size();
        try {
            for (;;) {
                ids.push_back(small.upload(ball.view()));
                small.draw(target, front_camera());
            }
        } catch (const Error&) {}
        EXPECT_GT(ids.size(), fitted + 3);
        EXPECT_LE(small.memory().held, 40 * mebi);
        // Without a frame in between: what the device has done with is found when it is needed.
        for (size_t i = 0; i < 5; ++i) {
            small.remove(ids.back());
            ids.pop_back();
        }
    }
    small.draw(target, front_camera());
    EXPECT_FALSE(small.bounds().empty());
    expect_silence(small);
}

TEST_F(RendererTest, MemoryStaysFlatWhileThingsComeAndGo) {
    Target target(renderer, 32, 32);
    Mesh ball = sphere(0.5f, 40);
    Curves knot = trefoil(2000);
    const SurfaceId id = renderer.upload(ball.view());
    const auto frame = [&](int i, bool draws) {
        renderer.update(id, ball.view());
        const CurvesId curves = renderer.upload(knot.view());
        const TextureId texture = renderer.upload(plain(64));
        if (draws) renderer.draw(target, front_camera());
        renderer.remove(texture);
        renderer.remove(curves);
        if (i % 7 == 0) renderer.wait_idle();
    };
    for (const bool draws : {true, false}) {
        for (int i = 0; i < 20; ++i) frame(i, draws);
        const MemoryReport settled = renderer.memory();
        uint64_t max_held = 0, max_used = 0;
        for (int i = 0; i < 500; ++i) {
            frame(i, draws);
            max_held = std::max(max_held, renderer.memory().held);
            max_used = std::max(max_used, used(renderer.memory()));
        }
        // One frame's things more or less, as frames are done sooner or later; they may need one more block.
        EXPECT_LE(max_held, settled.held + block) << draws;
        EXPECT_LE(max_used, used(settled) + 8 * mebi) << draws;
    }
}

TEST_F(RendererTest, MemoryFallsOnceAllIsRemoved) {
    Target target(renderer, 64, 64);
    renderer.draw(target, front_camera());
    renderer.wait_idle();
    const MemoryReport before = renderer.memory();
    for (const bool draws : {true, false}) {
        Mesh ball = sphere(0.5f, 300);
        Curves knot = trefoil(100'000);
        for (int i = 0; i < 3; ++i) {
            renderer.upload(ball.view());
            renderer.upload(knot.view());
        }
        if (draws) renderer.draw(target, front_camera());
        const MemoryReport full = renderer.memory();
        EXPECT_GT(full.held, before.held + 40 * mebi);
        renderer.clear();
        renderer.wait_idle();
        const MemoryReport after = renderer.memory();
        EXPECT_EQ(after.curves, 0u);
        EXPECT_EQ(after.surfaces, 0u);
        EXPECT_LE(after.held, before.held + 32 * mebi) << "but for a spare block of each kind";
        EXPECT_LE(used(after), used(before) + 8 * mebi) << "and two blocks for staging";
    }
}

}  // namespace
}  // namespace flg::render::test
