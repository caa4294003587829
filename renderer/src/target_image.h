// SPDX-License-Identifier: MIT
// The images a frame is drawn into, and the render pass that says how. After each frame the colour image is ready to be
// copied from.
#pragma once

#include "eyes.h"
#include "memory.h"

namespace flg::render {

constexpr VkFormat color_format = VK_FORMAT_R8G8B8A8_SRGB;
constexpr VkFormat encoded_color_format = VK_FORMAT_R8G8B8A8_UNORM;  // the same bytes, taken as they are
constexpr VkFormat depth_format = VK_FORMAT_D32_SFLOAT;

// The render pass of the main view; the caller destroys it. For both eyes images have two layers, and what is drawn goes to
// both (multiview).
VkRenderPass make_main_pass(VkDevice device, VkSampleCountFlagBits samples, Eyes eyes);

// What a target is drawn by.
struct TargetPasses {
    VkRenderPass main[2];  // by Eyes
    VkRenderPass ui;
};

class TargetImage {
public:
    TargetImage(DeviceMemory& memory, const TargetPasses& passes, VkSampleCountFlagBits samples, uint32_t width,
                uint32_t height, Eyes eyes = Eyes::one);
    ~TargetImage();
    TargetImage(const TargetImage&) = delete;
    TargetImage& operator=(const TargetImage&) = delete;

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    VkFramebuffer framebuffer() const { return framebuffer_; }
    VkFramebuffer ui_framebuffer() const { return ui_framebuffer_; }  // null for both eyes
    VkImage color() const { return color_.handle(); }
    Eyes eyes() const { return eyes_; }
    bool drawn = false;

private:
    void create(DeviceMemory& memory, const TargetPasses& passes, VkSampleCountFlagBits samples);
    void destroy();

    VkDevice device_;
    uint32_t width_, height_;
    Eyes eyes_;
    DeviceImage color_, multisampled_, depth_;
    VkImageView encoded_view_ = VK_NULL_HANDLE;
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
    VkFramebuffer ui_framebuffer_ = VK_NULL_HANDLE;
};

}  // namespace flg::render
