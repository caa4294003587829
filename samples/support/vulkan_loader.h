// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace flg::samples {

// Mesa's device selection layer tries to reach a Wayland compositor and complains on stderr where there can't be one.
// Call before Vulkan is used, with one thread running.
inline void calm_vulkan_loader() {
    if (std::getenv("XDG_RUNTIME_DIR") == nullptr) setenv("NODEVICE_SELECT", "1", 0);
}

}  // namespace flg::samples
