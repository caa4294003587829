// SPDX-License-Identifier: MIT
// A value that one thread writes again and again and another one looks at, neither ever waiting: three copies change
// hands.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace flg {

template <class T>
class TripleBuffer {
public:
    // Before any use: to make the three alike.
    std::array<T, 3>& all() { return values_; }

    // The writer's copy, whatever was in it, until it is handed over.
    T& write() { return values_[writing_]; }
    void hand_over() { writing_ = ready_.exchange(writing_ | fresh, std::memory_order_acq_rel) & 3; }

    // The reader: takes what was handed over last; false if it has that already.
    bool take() {
        if ((ready_.load(std::memory_order_relaxed) & fresh) == 0) return false;
        reading_ = ready_.exchange(reading_, std::memory_order_acq_rel) & 3;
        return true;
    }
    T& read() { return values_[reading_]; }

private:
    static constexpr uint32_t fresh = 4;
    std::array<T, 3> values_;
    uint32_t writing_ = 0, reading_ = 1;
    std::atomic<uint32_t> ready_{2};
};

}  // namespace flg
