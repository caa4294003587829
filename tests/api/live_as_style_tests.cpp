// SPDX-License-Identifier: MIT
// A stroke just drawn becomes a style by the next frame.
#include "api/live_inputs.h"

namespace flg::test {
namespace {

constexpr uint32_t frame_us = 11'000;  // at 90 Hz

// A curly stroke of 600 samples.
Samples curly() {
    Samples curls = drawn(600, 3);
    for (size_t i = 0; i < curls.size(); ++i) {
        curls[i].position[1] += 0.05f * std::sin(0.1f * static_cast<float>(i));
        curls[i].position[2] += 0.05f * std::cos(0.1f * static_cast<float>(i));
    }
    return curls;
}

// Every look at the clock finds it 10 us further: as long as the chunk of work between two looks is meant to take.
struct ChunkClock {
    std::atomic<uint64_t> looks{0};

    const FlgClock* hook() const { return &hook_; }

    const FlgClock hook_{sizeof(FlgClock), this,
                         [](void* self) { return 10'000 * static_cast<ChunkClock*>(self)->looks.fetch_add(1); }};
};

TEST(LiveStrokeAsStyle, EndAndStyleFitIntoOneFrameOfChunks) {
    ChunkClock clock;
    LiveHost host(0, clock.hook());
    const Samples curls = curly();
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, curls.data(), curls.size());
    // In one frame the trigger is released and the style asked for ...
    const LiveHost::Ended ended = host.end(stroke);
    FlgStyleDesc style_desc = flgStyleDefaults();
    style_desc.style = ended.samples;
    FlgStyle style{};
    ASSERT_EQ(flgStyleCreate(host.context, &style_desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgStyleInfo info{};
    info.struct_size = sizeof info;
    EXPECT_EQ(flgStyleGetInfo(host.context, style, &info), FLG_NOT_READY);
    // ... and in the next it is there. The style needs more than a tenth of the frame: the clock does count its work.
    const uint64_t before = clock.looks;
    ASSERT_EQ(flgContextTick(host.context, frame_us, nullptr), FLG_OK);
    EXPECT_EQ(flgStyleGetInfo(host.context, style, &info), FLG_OK) << "after " << clock.looks - before << " chunks";
    EXPECT_EQ(info.point_count, 600u);
    EXPECT_GT(clock.looks - before, 110u);
}

TEST(LiveStrokeAsStyle, AWorkersStyleIsThereAtTheNextTick) {
    LiveHost host(1);
    const Samples curls = curly();
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, curls.data(), curls.size());
    const LiveHost::Ended ended = host.end(stroke);
    host.finish();
    FlgStyleDesc style_desc = flgStyleDefaults();
    style_desc.style = ended.samples;
    FlgStyle style{};
    ASSERT_EQ(flgStyleCreate(host.context, &style_desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
    while (flgContextWait(host.context, 100'000) == FLG_NOT_READY) {}  // for the worker, however slow the machine
    FlgStyleInfo info{};
    info.struct_size = sizeof info;
    EXPECT_EQ(flgStyleGetInfo(host.context, style, &info), FLG_NOT_READY);
    ASSERT_EQ(flgContextTick(host.context, frame_us, nullptr), FLG_OK);
    EXPECT_EQ(flgStyleGetInfo(host.context, style, &info), FLG_OK);
}

}  // namespace
}  // namespace flg::test
