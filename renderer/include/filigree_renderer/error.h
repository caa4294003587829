// SPDX-License-Identifier: MIT
// The renderer's exceptions: one sentence that names the argument and its value, or Vulkan's reason.
#pragma once

#include <stdexcept>

namespace flg::render {

class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The device is gone: unplugged, reset, hung up, or taken back by the system. Until Renderer::recover() succeeds, every
// call that needs the device throws this; objects can still be destroyed.
class DeviceLost : public Error {
public:
    using Error::Error;
};

}  // namespace flg::render
