// SPDX-License-Identifier: MIT
// A host for measurements through the C ABI, without worker threads unless it asks for some.
#pragma once

#include <span>
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
    explicit Host(const FlgAllocator& allocator = flgAllocatorDefaults(), const FlgClock& clock = flgClockDefaults(),
                  uint32_t workers = 0);
    ~Host();
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    FlgContext context() const { return context_; }
    FlgCurveSet add(const scenes::Curve& curve) { return add(std::span(&curve, 1)); }
    // With further columns.
    FlgCurveSet add(std::span<const scenes::Curve> curves, std::span<const FlgColumn> more = {});
    FlgStyle prepare(FlgCurveSet curve, uint32_t point_count, FlgJob* job = nullptr);
    // Ticks without a budget until nothing is pending.
    void run();
    FlgStyleInfo info(FlgStyle style);
    // Throws if the set's job failed.
    FlgCurveSetView view(FlgCurveSet set);
    // Throws if the job failed.
    void check_done(FlgJob job);

private:
    FlgContext context_{};
};

// The scale at which a target of this length gets `count` points from the style.
float scale_for(const FlgStyleInfo& style, double target_length, uint32_t count);

double length_of(const scenes::Curve& curve);

}  // namespace flg::bench
