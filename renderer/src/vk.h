// SPDX-License-Identifier: MIT
// Vulkan, and how its results become errors.
#pragma once

#include <vulkan/vulkan.h>

#include "filigree_renderer/error.h"

namespace flg::render {

// Throws an Error; `format` as for printf.
[[noreturn, gnu::format(printf, 1, 2)]] void fail(const char* format, ...);

const char* result_name(VkResult result);

// Throws if `result` is an error, DeviceLost for that one; `what` completes "The device could not ...".
void check(VkResult result, const char* what);

}  // namespace flg::render
