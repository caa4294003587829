// SPDX-License-Identifier: MIT
// The images a frame is drawn into, and the render pass that says how: first the picture with its depths, from these
// how much of what is around each point is open, from all of them the finished picture. After each frame that is ready
// to be copied from.
#pragma once

#include <span>

#include "eyes.h"
#include "filigree_renderer/camera.h"
#include "memory.h"

namespace flg::render {

constexpr VkFormat color_format = VK_FORMAT_R8G8B8A8_SRGB;
constexpr VkFormat encoded_color_format = VK_FORMAT_R8G8B8A8_UNORM;  // the same bytes, taken as they are
constexpr VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
constexpr VkFormat occlusion_format = VK_FORMAT_R16G16_SFLOAT;  // open share, depth
constexpr VkFormat mean_format = VK_FORMAT_R16G16B16A16_SFLOAT;

// The render pass of the main view; the caller destroys it. For both eyes images have two layers, and what is drawn
// goes to both (multiview).
VkRenderPass make_main_pass(VkDevice device, VkSampleCountFlagBits samples, Eyes eyes);

class FinishPass;

// What a target is drawn by.
struct TargetPasses {
    VkRenderPass main[2];  // by Eyes
    VkRenderPass ui;
    const FinishPass& finish;
};

// What a picture shows: while it stays the same, a picture can get better from frame to frame.
struct PictureKey {
    Camera camera;
    glm::ivec4 viewport{0};
    uint64_t revision = 0;  // of the scene; 0: nothing that could be gone on with
    bool operator==(const PictureKey& other) const;
};

class TargetImage {
public:
    // What the finish of a layer draws into and reads.
    struct Layer {
        VkImageView depth = VK_NULL_HANDLE, scene = VK_NULL_HANDLE, occlusion = VK_NULL_HANDLE, color = VK_NULL_HANDLE;
        VkFramebuffer occlusion_framebuffer = VK_NULL_HANDLE, framebuffer = VK_NULL_HANDLE;
        VkDescriptorSet set = VK_NULL_HANDLE;
    };

    TargetImage(DeviceMemory& memory, const TargetPasses& passes, VkSampleCountFlagBits samples, uint32_t width,
                uint32_t height, Eyes eyes = Eyes::one);
    ~TargetImage();
    TargetImage(const TargetImage&) = delete;
    TargetImage& operator=(const TargetImage&) = delete;

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    VkFramebuffer framebuffer() const { return framebuffer_; }  // of the main pass
    const Layer& layer(uint32_t index) const { return layers_[index]; }
    VkFramebuffer ui_framebuffer() const { return ui_framebuffer_; }  // null for both eyes
    VkImage color() const { return color_.handle(); }
    Eyes eyes() const { return eyes_; }
    // The mean of frames, of a picture for one eye. Made when it is first needed.
    void need_mean(DeviceMemory& memory, const FinishPass& finish);
    VkFramebuffer mean_framebuffer() const { return mean_framebuffer_; }
    VkImage mean() const { return mean_.handle(); }

    bool drawn = false;
    PictureKey key;        // of the last frame
    uint32_t refined = 0;  // frames in the mean

private:
    void create(DeviceMemory& memory, const TargetPasses& passes, VkSampleCountFlagBits samples);
    void create_layer(uint32_t index, const TargetPasses& passes);
    VkFramebuffer make_framebuffer(VkRenderPass pass, std::span<const VkImageView> views, uint32_t width,
                                   uint32_t height) const;
    void destroy();

    VkDevice device_;
    uint32_t width_, height_;
    Eyes eyes_;
    DeviceImage color_, scene_, multisampled_, depth_, occlusion_, mean_;
    Layer layers_[2];
    VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
    VkImageView encoded_view_ = VK_NULL_HANDLE;
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
    VkFramebuffer ui_framebuffer_ = VK_NULL_HANDLE;
    VkFramebuffer mean_framebuffer_ = VK_NULL_HANDLE;
};

}  // namespace flg::render
