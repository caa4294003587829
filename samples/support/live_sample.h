// SPDX-License-Identifier: MIT
// Samples of a hand as structs: what an input thread records, and flgLiveStrokePush reads in place.
#pragma once

#include <span>

#include "filigree/filigree_live.h"

namespace flg::samples {

struct LiveSample {
    float position[3] = {};
    float orientation[4] = {};  // all zero: none
    float pressure = 0;
    double time = 0;
};

inline FlgLiveSampleView view_of(std::span<const LiveSample> samples) {
    FlgLiveSampleView view = flgLiveSampleViewDefaults();
    if (samples.empty()) return view;
    view.sample_count = static_cast<uint32_t>(samples.size());
    view.stride = sizeof(LiveSample);
    view.positions = samples[0].position;
    view.orientations = samples[0].orientation;
    view.pressures = &samples[0].pressure;
    view.times = &samples[0].time;
    return view;
}

inline FlgLiveSampleView view_of(const LiveSample& sample) {
    return view_of({&sample, 1});
}

}  // namespace flg::samples
