// SPDX-License-Identifier: MIT
// An input thread draws while the host's thread is inside other calls, and waits for none of them.
#include <condition_variable>
#include <mutex>
#include <thread>

#include "api/live_inputs.h"

namespace flg::test {
namespace {

// Something that one thread waits in, from when it is armed until another opens it.
class Gate {
public:
    void arm() {
        std::lock_guard lock(mutex_);
        armed_ = true;
    }
    void pass() {
        std::unique_lock lock(mutex_);
        if (!armed_) return;
        inside_ = true;
        changed_.notify_all();
        changed_.wait(lock, [&] { return !armed_; });
        inside_ = false;
    }
    void wait_until_someone_is_inside() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return inside_; });
    }
    bool occupied() {
        std::lock_guard lock(mutex_);
        return inside_;
    }
    void open() {
        std::lock_guard lock(mutex_);
        armed_ = false;
        changed_.notify_all();
    }
    // Keeps the job whose slice begins.
    const FlgProfiler* profiler() const { return &profiler_; }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool armed_ = false, inside_ = false;
    const FlgProfiler profiler_{sizeof(FlgProfiler), this,
                                [](void* self, const char*) { static_cast<Gate*>(self)->pass(); }, [](void*) {}};
};

// Draws with all calls that a pen makes; what was heard is the same whatever happens beside.
Heard draw(LiveHost& host, FlgLiveStroke stroke, const Samples& samples) {
    Heard heard;
    for (size_t i = 0; i < samples.size(); ++i) {
        heard.add(host.push(stroke, &samples[i], 1));
        heard.add(host.tip(stroke));
        if (i % 50 == 49) {
            EXPECT_EQ(flgLiveStrokeUndo(host.context, stroke, 10, nullptr), FLG_OK) << flgErrorGetMessage();
            heard.add(host.push(stroke, &samples[i - 9], 10));
            EXPECT_EQ(host.info(stroke).sample_count, i + 1);
        }
    }
    heard.add(host.points(stroke));
    return heard;
}

void resample(const LiveHost& host, FlgCurveSet curves, uint32_t times) {
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = curves;
    desc.spacing = 0.05f;
    for (uint32_t k = 0; k < times; ++k) {
        FlgCurveSet out{};
        EXPECT_EQ(flgCurveSetResample(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(flgCurveSetRelease(host.context, out), FLG_OK);
    }
}

TEST(LiveThreads, APenDrawsWhileATickIsInsideAJobThatDoesNotEnd) {
    Gate gate;
    LiveHost host(0, nullptr, gate.profiler());
    const Samples samples = drawn(200);
    const Heard alone = draw(host, host.begin(), samples);
    const FlgCurveSet curves = host.create(arcs(3));

    const FlgLiveStroke stroke = host.begin();
    resample(host, curves, 1);
    gate.arm();
    std::thread ticker([&] { host.finish(); });
    gate.wait_until_someone_is_inside();
    // If any of its calls waited for the tick, this would never return.
    const Heard beside = draw(host, stroke, samples);
    EXPECT_TRUE(gate.occupied());
    gate.open();
    ticker.join();
    EXPECT_TRUE(beside == alone);
}

// The tick is inside the job that ends a stroke, while a pen draws another and looks at the ended one.
TEST(LiveThreads, AnotherStrokesEndRunsMeanwhile) {
    Gate gate;
    LiveHost host(0, nullptr, gate.profiler());
    const Samples samples = drawn(200);
    const FlgLiveStroke first = host.begin(), second = host.begin();
    const Heard alone = draw(host, first, samples);
    gate.arm();
    const LiveHost::Ended ended = host.end(first);
    std::thread ticker([&] { host.finish(); });
    gate.wait_until_someone_is_inside();
    // A pen that comes late hears so; it sees the stroke as it was, with its tip.
    FlgCurveSetView view = flgCurveSetViewDefaults();
    expect_failure(push_samples(host.context, first, samples.data(), 1, &view), FLG_ERROR_INVALID_ARGUMENT,
                   "stroke has ended");
    EXPECT_GT(host.tip(first).curve_count, 0u);
    EXPECT_EQ(host.info(first).ended, 1u);
    EXPECT_TRUE(draw(host, second, samples) == alone);
    gate.open();
    ticker.join();
    EXPECT_EQ(host.result_of(ended.job), FLG_OK);
}

// A pen draws stroke after stroke while the host's thread begins others, so many that what keeps them must grow, ends
// and releases some, and ticks. With a thread sanitizer this is the test of the header's rule.
TEST(LiveThreads, TheHostDoesWhatItLikesMeanwhile) {
    for (uint32_t workers : {0u, 2u}) {
        LiveHost host(workers);
        host.live.max_samples = 512;
        host.live.max_points = 1024;
        const Samples samples = drawn(120);
        const FlgCurveSet curves = host.create(arcs(3));
        const Heard alone = draw(host, host.begin(), samples);
        constexpr uint32_t strokes = 12;
        std::vector<FlgLiveStroke> mine;
        for (uint32_t k = 0; k < strokes; ++k) mine.push_back(host.begin());
        std::atomic<uint32_t> drawn_count{0}, rounds{0};
        bool same = true;
        std::thread pen([&] {
            for (FlgLiveStroke stroke : mine) {
                same = draw(host, stroke, samples) == alone && same;
                // So that there is something beside, on any machine.
                for (const uint32_t from = rounds; rounds.load() < from + 2;) std::this_thread::yield();
                drawn_count.fetch_add(1);
            }
        });
        std::vector<FlgLiveStroke> others;
        uint32_t gone = 0;
        while (drawn_count.load() < strokes) {
            for (int k = 0; k < 5 && others.size() < 400; ++k) others.push_back(host.begin());
            const FlgLiveStroke other = others[gone % others.size()];
            if (gone < others.size()) {
                ++gone;
                host.push(other, samples.data(), 30);
                const LiveHost::Ended ended = host.end(other);
                flgCurveSetRelease(host.context, ended.samples);
                flgCurveSetRelease(host.context, ended.stylized);
                flgJobRelease(host.context, ended.job);
                EXPECT_EQ(flgLiveStrokeRelease(host.context, other), FLG_OK);
            }
            resample(host, curves, 2);
            EXPECT_EQ(flgContextTick(host.context, 200, nullptr), FLG_OK);
            rounds.fetch_add(1);
        }
        pen.join();
        host.finish();
        EXPECT_TRUE(same);
    }
}

// Handed over and back by an atomic: ended by the host's thread while the pen still looks, as the header allows it to
// once it holds the stroke.
TEST(LiveThreads, ALateLookAtAnEndedStrokeIsOneOrTheOther) {
    LiveHost host;
    const Samples samples = drawn(120);
    const FlgLiveStroke stroke = host.begin();
    host.push(stroke, samples.data(), samples.size());
    const uint32_t before = host.info(stroke).point_count;
    const LiveHost::Ended ended = host.end(stroke);
    std::atomic<bool> over{false};
    std::atomic<uint32_t> looks{0};
    uint32_t least = UINT32_MAX, most = 0;
    std::thread pen([&] {
        do {
            const uint32_t points = host.info(stroke).point_count;
            least = std::min(least, points);
            most = std::max(most, points);
            host.tip(stroke);
            looks.fetch_add(1);
        } while (!over.load());
        most = std::max(most, host.info(stroke).point_count);
    });
    while (looks.load() == 0) std::this_thread::yield();
    while (host.status_of(ended.job).state != FLG_JOB_STATE_FINISHED) flgContextTick(host.context, 20, nullptr);
    over = true;
    pen.join();
    EXPECT_EQ(least, before);
    EXPECT_EQ(most, heard_of(host.view_of(ended.stylized)).points());
}

}  // namespace
}  // namespace flg::test
