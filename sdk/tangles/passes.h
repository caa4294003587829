// SPDX-License-Identifier: MIT
// Kernels that go over their data in passes, one unit after the other.
#pragma once

#include <cstdint>

namespace flg {

// Spends `count` units: `step()` does one and returns false at the end of a pass, from where the next begins at 0. The last
// of the passes is `done`; true once it is reached.
template <class Pass, class Place, class Step>
bool run_passes(uint32_t count, Pass& pass, Place& at, Step step) {
    for (; count > 0 && pass != Pass::done; --count) {
        if (step()) continue;
        at = 0;
        pass = static_cast<Pass>(static_cast<int>(pass) + 1);
    }
    return pass == Pass::done;
}

}  // namespace flg
