// SPDX-License-Identifier: MIT
// Render passes: how many pictures the main one draws at once, and which there are.
#pragma once

#include <cstdint>

#include "vk.h"

namespace flg::render {

enum class Eyes : uint32_t { one = 0, both = 1 };

constexpr uint32_t layers_of(Eyes eyes) {
    return eyes == Eyes::both ? 2 : 1;
}

// The passes that pipelines draw in.
struct RenderPasses {
    VkRenderPass main[2];           // by Eyes
    VkSampleCountFlagBits samples;  // of those
    VkRenderPass shadow;
};

}  // namespace flg::render
