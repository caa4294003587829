// SPDX-License-Identifier: MIT
// Hands that draw, and a host that listens to them.
#pragma once

#include <functional>

#include "api/host.h"
#include "filigree/filigree_live.h"

namespace flg::test {

struct LiveSample {
    float position[3];
    float orientation[4];
    float pressure;
    double time;
};
using Samples = std::vector<LiveSample>;

inline FlgLiveSampleView view_of(const LiveSample* samples, size_t count) {
    FlgLiveSampleView view = flgLiveSampleViewDefaults();
    view.sample_count = static_cast<uint32_t>(count);
    view.stride = sizeof(LiveSample);
    view.positions = samples->position;
    view.orientations = samples->orientation;
    view.pressures = &samples->pressure;
    view.times = &samples->time;
    return view;
}

inline FlgResult push_samples(FlgContext context, FlgLiveStroke stroke, const LiveSample* samples, size_t count,
                              FlgCurveSetView* out_new) {
    const FlgLiveSampleView view = view_of(samples, count);
    return flgLiveStrokePush(context, stroke, &view, out_new);
}

// Where a hand is after `s` metres of a stroke with curls; nearly even in arc length.
inline void hand_position(double s, float* out) {
    out[0] = static_cast<float>(0.8 * s + 0.05 * std::sin(7 * s));
    out[1] = static_cast<float>(1.2 + 0.15 * std::sin(5 * s));
    out[2] = static_cast<float>(0.15 * std::cos(5 * s) + 0.1 * s * s);
}

// `count` samples in two seconds of a stroke of `metres`.
inline Samples drawn(uint32_t count, double metres = 2) {
    Samples samples(count);
    for (uint32_t i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1);
        hand_position(metres * u, samples[i].position);
        const double turn = 0.4 + 0.3 * u;
        samples[i].orientation[0] = static_cast<float>(std::sin(turn));
        samples[i].orientation[3] = static_cast<float>(std::cos(turn));
        samples[i].pressure = static_cast<float>(0.5 + 0.4 * std::sin(9 * u));
        samples[i].time = 1000.25 + 2 * u;
    }
    return samples;
}

// All floats that a host was shown, push by push, column by column.
struct Heard {
    std::vector<std::vector<float>> columns;
    std::vector<FlgAttribute> attributes;

    void add(const FlgCurveSetView& view) {
        if (columns.empty()) {
            columns.resize(view.column_count);
            for (uint32_t k = 0; k < view.column_count; ++k) attributes.push_back(view.columns[k].attribute);
        }
        if (view.curve_count == 0) return;
        for (uint32_t k = 0; k < view.column_count; ++k) {
            const FlgColumn& column = view.columns[k];
            const float* end = column.data + size_t{view.curve_offsets[1]} * column.components;
            columns[k].insert(columns[k].end(), column.data, end);
        }
    }
    size_t points() const { return columns.empty() ? 0 : columns[0].size() / 3; }
    const std::vector<float>& of(FlgAttribute attribute) const {
        for (size_t k = 0; k < attributes.size(); ++k) {
            if (attributes[k] == attribute) return columns[k];
        }
        static const std::vector<float> none;
        return none;
    }
    bool operator==(const Heard&) const = default;
};

inline Heard heard_of(const FlgCurveSetView& view) {
    Heard heard;
    heard.add(view);
    return heard;
}

// A host with a style that is ready and warm.
class LiveHost : public Host {
public:
    explicit LiveHost(uint32_t workers = 0, const FlgClock* clock = nullptr, const FlgProfiler* profiler = nullptr,
                      const FlgLog* log = nullptr)
        : Host([&] {
              FlgContextDesc desc = flgContextDefaults();
              desc.worker_count = workers;
              desc.clock = clock;
              desc.profiler = profiler;
              desc.log = log;
              return desc;
          }()) {
        FlgStyleDesc desc = flgStyleDefaults();
        desc.point_count = 256;
        desc.style = create(coil());
        EXPECT_EQ(flgStyleCreate(context, &desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
        warm(0);
        live.style = style;
        live.scale = 0.3f;
        live.max_samples = 4096;
        live.max_points = 8192;
    }

    void warm(float temperature) {
        FlgJob job{};
        EXPECT_EQ(flgStyleWarm(context, style, temperature, nullptr, &job), FLG_OK) << flgErrorGetMessage();
        finish();
        EXPECT_EQ(result_of(job), FLG_OK) << status_of(job).error;
    }
    FlgLiveStroke begin() { return begin(live); }
    FlgLiveStroke begin(const FlgLiveStrokeDesc& desc) {
        FlgLiveStroke stroke{};
        EXPECT_EQ(flgLiveStrokeBegin(context, &desc, &stroke), FLG_OK) << flgErrorGetMessage();
        return stroke;
    }
    FlgCurveSetView push(FlgLiveStroke stroke, const LiveSample* samples, size_t count) {
        FlgCurveSetView view = flgCurveSetViewDefaults();
        EXPECT_EQ(push_samples(context, stroke, samples, count, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }
    // In bursts of these sizes, again and again.
    Heard push_in_bursts(FlgLiveStroke stroke, const Samples& samples, const std::vector<size_t>& sizes) {
        Heard heard;
        size_t at = 0;
        for (size_t k = 0; at < samples.size(); ++k) {
            const size_t count = std::min(sizes[k % sizes.size()], samples.size() - at);
            heard.add(push(stroke, samples.data() + at, count));
            at += count;
        }
        return heard;
    }
    FlgCurveSetView points(FlgLiveStroke stroke) {
        FlgCurveSetView view = flgCurveSetViewDefaults();
        EXPECT_EQ(flgLiveStrokeGetPoints(context, stroke, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }
    FlgCurveSetView tip(FlgLiveStroke stroke) {
        FlgCurveSetView view = flgCurveSetViewDefaults();
        EXPECT_EQ(flgLiveStrokeGetTip(context, stroke, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }
    FlgLiveStrokeInfo info(FlgLiveStroke stroke) {
        FlgLiveStrokeInfo info{};
        info.struct_size = sizeof info;
        EXPECT_EQ(flgLiveStrokeGetInfo(context, stroke, &info), FLG_OK) << flgErrorGetMessage();
        return info;
    }
    struct Ended {
        FlgCurveSet stylized{}, samples{};
        FlgJob job{};
    };
    Ended end(FlgLiveStroke stroke) {
        Ended ended;
        EXPECT_EQ(flgLiveStrokeEnd(context, stroke, nullptr, &ended.stylized, &ended.samples, &ended.job), FLG_OK)
            << flgErrorGetMessage();
        return ended;
    }
    Heard replay(const FlgLiveStrokeDesc& desc, FlgCurveSet samples) {
        FlgCurveSet out{};
        FlgJob job{};
        EXPECT_EQ(flgLiveStrokeReplay(context, &desc, samples, nullptr, &out, &job), FLG_OK) << flgErrorGetMessage();
        finish(200);
        EXPECT_EQ(result_of(job), FLG_OK) << status_of(job).error;
        return heard_of(view_of(out));
    }

    FlgStyle style{};
    FlgLiveStrokeDesc live = flgLiveStrokeDefaults();
};

}  // namespace flg::test
