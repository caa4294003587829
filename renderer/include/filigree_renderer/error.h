// SPDX-License-Identifier: MIT
// How the renderer says that it can't go on: one sentence that names the argument and its value, or Vulkan's reason.
#pragma once

#include <stdexcept>

namespace flg::render {

class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The device is gone: unplugged, reset, hung up, or taken back by the system. Until Renderer::recover() succeeds, whatever
// needs the device throws this; everything can be destroyed as ever.
class DeviceLost : public Error {
public:
    using Error::Error;
};

}  // namespace flg::render
