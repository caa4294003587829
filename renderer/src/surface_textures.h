// SPDX-License-Identifier: MIT
// Pictures that surfaces are covered with: on the device with all their coarser levels, as what draws binds them.
#pragma once

#include <vector>

#include "device.h"
#include "filigree_renderer/surface_look.h"
#include "memory.h"
#include "upload_ring.h"

namespace flg::render {

// Half as many pixels each way, down to one: means of four, of light rather than of bytes. The first is the image.
std::vector<Image> coarser_levels(const Image& image);

// One of a surface.
struct DeviceSurfaceTexture {
    DeviceImage image;
    VkDescriptorSet set = VK_NULL_HANDLE;
};

// Those of a surface, with the sets that bind them.
class SurfaceTextures {
public:
    // `layout`: of a set with one of them. The first is white: what has none.
    SurfaceTextures(DeviceMemory& memory, UploadRing& ring, VkDescriptorSetLayout layout,
                    const std::vector<SurfaceTexture>& textures);
    ~SurfaceTextures();
    SurfaceTextures(const SurfaceTextures&) = delete;
    SurfaceTextures& operator=(const SurfaceTextures&) = delete;

    // `texture`: no_texture is white.
    VkDescriptorSet set_of(uint32_t texture) const { return textures_[texture == no_texture ? 0 : texture + 1].set; }
    void add_targets(UploadTargets& targets) const;

private:
    void add(DeviceMemory& memory, UploadRing& ring, VkDescriptorSetLayout layout, const SurfaceTexture& texture);
    void destroy();

    VkDevice device_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    std::vector<VkSampler> samplers_;
    std::vector<DeviceSurfaceTexture> textures_;
};

}  // namespace flg::render
