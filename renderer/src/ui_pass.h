// SPDX-License-Identifier: MIT
// The user interface, drawn over a target's finished picture. The picture is seen as plain 8-bit values, so that
// blending is of sRGB values.
#pragma once

#include <utility>

#include "frame.h"
#include "shaders.h"
#include "texture_store.h"

namespace flg::render {

// Throws Error for what can't be drawn: indices beyond the vertices, textures that are not there.
void check_ui(const UiFrame& ui, const TextureStore& textures);

class UiPass {
public:
    UiPass(const Device& device, const Shaders& shaders, VkDescriptorSetLayout texture_layout);
    ~UiPass();
    UiPass(const UiPass&) = delete;
    UiPass& operator=(const UiPass&) = delete;

    // With those of another for the same device.
    void swap_pipelines(UiPass& other) { std::swap(pipeline_, other.pipeline_); }

    VkRenderPass handle() const { return pass_; }
    // Of a checked frame, which `buffers` hold. Returns the number of draw calls.
    uint32_t record(VkCommandBuffer commands, VkFramebuffer framebuffer, VkExtent2D extent, const UiFrame& ui,
                    const UiBuffers& buffers, const TextureStore& textures) const;

private:
    void destroy();

    VkDevice device_;
    VkRenderPass pass_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace flg::render
