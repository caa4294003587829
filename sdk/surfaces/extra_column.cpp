// SPDX-License-Identifier: MIT
#include "surfaces/extra_column.h"

#include <algorithm>

namespace flg {

Task<GrowingBuffer<float>> copy_values(Pace& pace, const Buffer<float>& from) {
    constexpr size_t chunk = 4000;  // about 10 us
    GrowingBuffer<float> copy(from.size(), pace.memory());
    for (size_t i = 0; i < from.size(); i += chunk) {
        std::copy_n(from.data() + i, std::min(chunk, from.size() - i), copy.data() + i);
        co_await pace;
    }
    co_return copy;
}

}  // namespace flg
