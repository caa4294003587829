// SPDX-License-Identifier: MIT
#include "surfaces/field_levels.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t scan_chunk = 10'000;  // values, about 10 us

// The largest finite value, or `first` if none is larger.
Task<float> largest_value(Pace& pace, const Buffer<float>& values, float first) {
    float largest = first;
    for (size_t i = 0; i < values.size(); ++i) {
        if (values[i] > largest && std::isfinite(values[i])) largest = values[i];
        if (i % scan_chunk == 0) co_await pace;
    }
    co_return largest;
}

}  // namespace

Task<Buffer<float>> list_levels(Pace& pace, const Buffer<float>& values, const LevelRequest& request, uint32_t most) {
    Buffer<float> levels;
    if (!request.values.empty()) {
        levels = Buffer<float>(request.values.size(), pace.memory());
        std::copy(request.values.begin(), request.values.end(), levels.begin());
    } else {
        const double largest = co_await largest_value(pace, values, request.first);
        const double reachable = std::floor((largest - request.first) / request.every) + 1;
        const double count = request.count == 0 ? reachable : std::min<double>(request.count, reachable);
        if (count > most) {
            throw Failure(FLG_ERROR_LIMIT, "levels every %g from %g to %g are %.0f, more than %u",
                          static_cast<double>(request.every), static_cast<double>(request.first), largest, count, most);
        }
        levels = Buffer<float>(static_cast<size_t>(count), pace.memory());
        for (size_t k = 0; k < levels.size(); ++k) {
            levels[k] = static_cast<float>(request.first + static_cast<double>(k) * request.every);
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
