// SPDX-License-Identifier: MIT
#include "surfaces/field_levels.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"

namespace flg {

namespace {

// The least and the largest finite value; infinite and -infinite if there is none.
struct Extent {
    float least = unreachable, largest = -unreachable;
};

Task<Extent> extent_of(Pace& pace, const DistanceField& field) {
    Extent extent;
    co_await each_value(pace, field, Cost::some_ns, [&extent, read = field.distances.data()](uint32_t i) {
        if (!std::isfinite(read[i])) return;
        extent.least = std::min(extent.least, read[i]);
        extent.largest = std::max(extent.largest, read[i]);
    });
    co_return extent;
}

struct Steps {
    double first = 0, end = 0;  // whole numbers
};

// Which k the levels first + k * every of the request have that lie within the values, or, if it says how many there
// are to be, not above them.
Steps steps_within(const Extent& extent, const LevelRequest& request) {
    const auto step_of = [&](float value) { return (double{value} - request.first) / request.every; };
    Steps steps;
    if (extent.largest < request.first) return steps;
    steps.end = std::floor(step_of(extent.largest)) + 1;
    if (request.count != 0) {
        steps.end = std::min<double>(request.count, steps.end);
    } else {
        steps.first = std::clamp(std::ceil(step_of(extent.least)), 0.0, steps.end);
    }
    return steps;
}

}  // namespace

Task<Buffer<float>> list_levels(Pace& pace, const DistanceField& field, const LevelRequest& request, uint32_t most) {
    Buffer<float> levels;
    if (!request.values.empty()) {
        levels = Buffer<float>(request.values.size(), pace.memory());
        std::copy(request.values.begin(), request.values.end(), levels.begin());
    } else {
        const Extent extent = co_await extent_of(pace, field);
        const Steps steps = steps_within(extent, request);
        const double count = steps.end - steps.first;
        if (count > most) {
            throw Failure(FLG_ERROR_LIMIT, "levels every %g from %g to %g are %.0f, more than %u",
                          static_cast<double>(request.every), request.first + steps.first * request.every,
                          static_cast<double>(extent.largest), count, most);
        }
        levels = Buffer<float>(static_cast<size_t>(count), pace.memory());
        for (size_t k = 0; k < levels.size(); ++k) {
            levels[k] = static_cast<float>(request.first + (steps.first + static_cast<double>(k)) * request.every);
        }
    }
    if (levels.size() > most) throw Failure(FLG_ERROR_LIMIT, "%zu levels are more than %u", levels.size(), most);
    for (size_t k = 1; k < levels.size(); ++k) {
        if (levels[k] <= levels[k - 1]) {
            throw Failure(FLG_ERROR_LIMIT, "levels %zu and %zu are both %g: too close for floats", k - 1, k,
                          static_cast<double>(levels[k]));
        }
    }
    co_return levels;
}

}  // namespace flg
