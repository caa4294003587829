// SPDX-License-Identifier: MIT
// A session without a headset: a recording holds the controller, the head moves slowly, and displays come at an even
// rate.
#pragma once

#include <chrono>

#include "live_strokes/recording.h"
#include "live_strokes/xr_source.h"

namespace flg::samples {

class ReplaySource : public XrSource {
public:
    // `paced`: frames begin when a display of `hertz` would ask for them, and displays that come too early are missed.
    // Otherwise each is begun at once and none is missed: the same poses every time.
    ReplaySource(const Recording& recording, double seconds, double hertz, bool paced);

    double period_s() const override { return period_s_; }
    bool wait_frame(XrFrame& out_frame) override;
    void begin_frame() override {}
    void end_frame() override {}

private:
    const Recording& recording_;
    double seconds_, period_s_;
    bool paced_;
    std::chrono::steady_clock::time_point start_;
    uint64_t display_ = 0;  // that the frame at hand is for
};

}  // namespace flg::samples
