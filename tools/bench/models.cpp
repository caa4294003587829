// SPDX-License-Identifier: MIT
// A drawn animal of eight contours: its bones, as a host gets them from contours; another pose of a part; and its skin,
// also while the host goes on with its frames.
#include <chrono>
#include <cmath>
#include <thread>

#include "bench/groups.h"
#include "bench/host.h"
#include "filigree/filigree_model.h"

namespace flg::bench {
namespace {

constexpr int kModelRuns = 15;
constexpr double kBonesMs = 2, kMoveMs = 0.5, kSkinMs = 500, kTickUs = 2500, kChunkUs = 100;
constexpr uint32_t kVertices = 10000, kBudgetUs = 2000;
constexpr double kFrameMs = 1000.0 / 90;

using Outline = std::vector<double>;

// What a hand draws around a way: about 250 points, a little off.
Outline around(const std::vector<std::array<double, 3>>& way) {
    constexpr uint32_t points = 250;
    std::vector<std::array<double, 2>> sides;
    const size_t n = way.size();
    const auto side = [&](size_t i, double sign) {
        const auto &a = way[i == 0 ? 0 : i - 1], &b = way[std::min(i + 1, n - 1)];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        sides.push_back({way[i][0] - sign * (b[1] - a[1]) / length * way[i][2],
                         way[i][1] + sign * (b[0] - a[0]) / length * way[i][2]});
    };
    for (size_t i = 0; i < n; ++i) side(i, -1);
    for (size_t i = n; i-- > 0;) side(i, 1);
    Outline outline;
    for (uint32_t k = 0; k < points; ++k) {  // a closed Catmull-Rom curve
        const double at = static_cast<double>(k) * static_cast<double>(sides.size()) / points;
        const auto i = static_cast<size_t>(at);
        const double t = at - static_cast<double>(i);
        for (size_t x = 0; x < 2; ++x) {
            const auto p = [&](size_t step) { return sides[(i + step + sides.size() - 1) % sides.size()][x]; };
            outline.push_back(
                p(1) +
                0.5 * t *
                    (p(2) - p(0) +
                     t * (2 * p(0) - 5 * p(1) + 4 * p(2) - p(3) + t * (3 * (p(1) - p(2)) + p(3) - p(0)))) +
                0.004 * std::sin(1.7 * k + 2.0 * static_cast<double>(x)));
        }
    }
    return outline;
}

const std::vector<Outline>& outlines() {
    static const std::vector<Outline> all = {
        around({{-3, 0, 0.9}, {-1, 0.2, 1.1}, {1, 0.1, 1.0}, {3, 0.4, 0.9}}),
        around({{2.8, 1.2, 0.7}, {3.6, 1.7, 1.0}, {4.6, 1.6, 0.5}}),
        around({{3.2, 2.2, 0.4}, {3.2, 3.0, 0.25}, {3.3, 3.6, 0.08}}),
        around({{2.3, 0.2, 0.55}, {2.3, -1.2, 0.4}, {2.35, -2.6, 0.28}, {2.7, -3.0, 0.25}}),
        around({{-2.2, 0.1, 0.75}, {-1.9, -0.9, 0.6}, {-2.4, -1.8, 0.34}, {-2.1, -3.0, 0.27}}),
        around({{-2.7, 0.6, 0.35}, {-3.6, 1.0, 0.3}, {-4.1, 2.2, 0.27}, {-3.6, 3.5, 0.2}}),
        around({{4.4, 1.5, 0.3}, {4.9, 1.4, 0.35}, {5.3, 1.35, 0.2}}),
        around({{-1.0, 1.0, 0.4}, {0.0, 1.5, 0.5}, {1.0, 1.0, 0.4}}),
    };
    return all;
}

// Which parts are there twice, and how far off the middle.
constexpr double kDepths[] = {0, 0, 0.5, 0.55, 0.6, 0, 0, 0};

class Animal {
public:
    explicit Animal(uint32_t workers = 0, const FlgClock& clock = flgClockDefaults())
        : host_(flgAllocatorDefaults(), clock, workers) {}

    void add_parts() {
        for (size_t i = 0; i < outlines().size(); ++i) {
            FlgPartDesc desc = flgPartDefaults();
            FlgContourView drawn = flgContourViewDefaults();
            drawn.points = outlines()[i].data();
            drawn.point_count = static_cast<uint32_t>(outlines()[i].size() / 2);
            desc.contour = &drawn;
            FlgModelPart part = flgModelPartDefaults();
            check(flgPartCreate(host_.context(), &desc, &part.part, nullptr));
            part.placement[11] = kDepths[i];
            part.mirrored = kDepths[i] > 0;
            part.thickness = 0.8f;
            parts_.push_back(part);
        }
    }
    FlgModel add_model() {
        FlgModelDesc desc = flgModelDefaults();
        desc.parts = parts_.data();
        desc.part_count = static_cast<uint32_t>(parts_.size());
        desc.mirror[0] = 0;
        desc.mirror[2] = 1;
        FlgModel model{};
        check(flgModelCreate(host_.context(), &desc, &model, nullptr));
        return model;
    }
    FlgSkin add_skin(FlgModel model, FlgJob& job) {
        FlgSkinDesc desc = flgSkinDefaults();
        desc.model = model;
        desc.vertex_count = kVertices;
        FlgSkin skin{};
        check(flgSkinCreate(host_.context(), &desc, &skin, &job));
        return skin;
    }
    void release_parts() {
        for (const FlgModelPart& part : parts_) check(flgPartRelease(host_.context(), part.part));
        parts_.clear();
    }
    void move_tail(double x) { parts_[5].placement[3] = x; }
    uint32_t joints(FlgModel model) {
        FlgModelView view = flgModelViewDefaults();
        check(flgModelGetView(host_.context(), model, &view));
        return view.joint_count;
    }
    Host& host() { return host_; }

private:
    Host host_;
    std::vector<FlgModelPart> parts_;
};

double bones_ms(Animal& animal, uint32_t& joints) {
    return median_ms(kModelRuns, [&] {
        FlgModel model{};
        const double ms = time_ms([&] {
            animal.add_parts();
            model = animal.add_model();
            animal.host().run();
        });
        joints = animal.joints(model);
        check(flgModelRelease(animal.host().context(), model));
        animal.release_parts();
        return ms;
    });
}

double move_ms(Animal& animal) {
    animal.add_parts();
    animal.host().run();
    double x = 0;
    return median_ms(kModelRuns, [&] {
        animal.move_tail(x += 0.01);
        FlgModel model{};
        const double ms = time_ms([&] {
            model = animal.add_model();
            animal.host().run();
        });
        check(flgModelRelease(animal.host().context(), model));
        return ms;
    });
}

double skin_ms(Animal& animal, uint32_t& vertices) {
    const FlgModel model = animal.add_model();
    animal.host().run();
    return median_ms(3, [&] {
        FlgJob job{};
        FlgSkin skin{};
        const double ms = time_ms([&] {
            skin = animal.add_skin(model, job);
            animal.host().run();
        });
        FlgSkinView view = flgSkinViewDefaults();
        check(flgSkinGetView(animal.host().context(), skin, &view));
        vertices = view.vertex_count;
        check(flgSkinRelease(animal.host().context(), skin));
        return ms;
    });
}

struct Frames {
    double max_tick_us = 0, seen_ms = 0;
};

struct Chunk {
    float us = 0;
    std::string stage;
};

uint64_t processor_ns(void*) {
    return static_cast<uint64_t>(thread_ms() * 1e6);
}

// Of the whole way from contours to the skin, in processor time: what else the machine does is left out.
Chunk max_slice() {
    Animal animal(0, {sizeof(FlgClock), nullptr, processor_ns});
    animal.add_parts();
    FlgJob job{};
    animal.add_skin(animal.add_model(), job);
    Chunk longest;
    FlgFrameReport report{};
    do {
        report = {};
        report.struct_size = sizeof report;
        check(flgContextTick(animal.host().context(), kBudgetUs, &report));
        if (report.max_slice_us > longest.us) longest = {report.max_slice_us, report.max_slice_stage};
    } while (report.jobs_pending > 0);
    animal.host().check_done(job);
    return longest;
}

// The whole way from contours to the skin, with one worker, while the host ticks 90 times a second.
Frames play_frames() {
    using Clock = std::chrono::steady_clock;
    Animal animal(1);
    const Clock::time_point begin = Clock::now();
    animal.add_parts();
    FlgJob job{};
    animal.add_skin(animal.add_model(), job);
    Frames frames;
    FlgFrameReport report{};
    do {
        report = {};
        report.struct_size = sizeof report;
        const Clock::time_point tick = Clock::now();
        check(flgContextTick(animal.host().context(), kBudgetUs, &report));
        const double us = std::chrono::duration<double, std::micro>(Clock::now() - tick).count();
        frames.max_tick_us = std::max(frames.max_tick_us, us);
        std::this_thread::sleep_until(tick + std::chrono::duration<double, std::milli>(kFrameMs));
    } while (report.jobs_pending > 0);
    animal.host().check_done(job);
    frames.seen_ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    return frames;
}

}  // namespace

std::vector<Row> run_models() {
    Animal animal;
    uint32_t joints = 0, vertices = 0;
    const double bones = bones_ms(animal, joints), move = move_ms(animal), skin = skin_ms(animal, vertices);
    const Frames frames = play_frames();
    const Chunk chunk = max_slice();
    return {
        below("bones of 8 contours, clean-up to refined skeleton", bones, "ms", kBonesMs,
              std::to_string(joints) + " joints"),
        below("bones again after a part was moved", move, "ms", kMoveMs),
        below("inflation, merging, weights of 11 parts", skin, "ms", kSkinMs, std::to_string(vertices) + " vertices"),
        below("contours to skin at 90 Hz, one worker: longest tick", frames.max_tick_us, "us", kTickUs,
              "seen after " + std::to_string(static_cast<int>(frames.seen_ms)) + " ms"),
        below("contours to skin: longest chunk", chunk.us, "us", kChunkUs, chunk.stage)};
}

}  // namespace flg::bench
