// SPDX-License-Identifier: MIT
// A host without worker threads, for measurements through the C ABI.
#pragma once

#include <string>
#include <vector>

#include "filigree/filigree.h"
#include "scenes/scenes.h"

namespace flg::bench {

// Throws std::runtime_error with the SDK's sentence.
void check(FlgResult result);

class Host {
public:
    // The hooks must outlive it; without them, the C++ runtime's memory and the system's clock.
    explicit Host(const FlgAllocator& allocator = {}, const FlgClock& clock = {});
    ~Host();
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    FlgContext context() const { return context_; }
    FlgCurveSet add(const scenes::Curve& curve);
    FlgStyle prepare(FlgCurveSet curve, uint32_t point_count, FlgJob* job = nullptr);
    // Ticks without a budget until nothing is pending.
    void run();
    FlgStyleInfo info(FlgStyle style);
    // Throws if the job failed.
    void check_done(FlgJob job);

private:
    FlgContext context_ = nullptr;
};

// The scale at which a target of this length gets `count` points from the style.
float scale_for(const FlgStyleInfo& style, double target_length, uint32_t count);

double length_of(const scenes::Curve& curve);

}  // namespace flg::bench
