// SPDX-License-Identifier: MIT
// The sun's depth image. It is drawn again only when curves or light have changed.
#pragma once

#include "memory.h"

namespace flg::render {

class ShadowMap {
public:
    // Size 0: an image of one pixel that nothing is drawn into, so that the shaders have something to bind.
    ShadowMap(DeviceMemory& memory, uint32_t size);
    ~ShadowMap();
    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;

    void begin(VkCommandBuffer commands) const;
    void end(VkCommandBuffer commands) const { vkCmdEndRenderPass(commands); }
    VkRenderPass pass() const { return pass_; }
    // Of how much of the sun reaches a depth, and of the depths themselves.
    VkDescriptorImageInfo descriptor() const {
        return {sampler_, image_.view(), VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL};
    }
    VkDescriptorImageInfo depth_descriptor() const {
        return {depth_sampler_, image_.view(), VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL};
    }

private:
    VkDevice device_;
    uint32_t size_;
    DeviceImage image_;
    VkRenderPass pass_ = VK_NULL_HANDLE;
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
    VkSampler sampler_ = VK_NULL_HANDLE;
    VkSampler depth_sampler_ = VK_NULL_HANDLE;
};

}  // namespace flg::render
