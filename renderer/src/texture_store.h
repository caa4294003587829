// SPDX-License-Identifier: MIT
// Pictures on the device that the user interface draws with. Their values are sampled as they are, in sRGB.
#pragma once

#include "device_store.h"
#include "filigree_renderer/image.h"
#include "filigree_renderer/ui.h"
#include "upload_ring.h"

namespace flg::render {

// Linear, clamped; and the layout of the set that it and an image are bound by.
class TextureSampler {
public:
    explicit TextureSampler(const Device& device);
    ~TextureSampler();
    TextureSampler(const TextureSampler&) = delete;
    TextureSampler& operator=(const TextureSampler&) = delete;

    VkSampler handle() const { return sampler_; }
    VkDescriptorSetLayout layout() const { return layout_; }

private:
    VkDevice device_;
    VkSampler sampler_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
};

// One upload.
struct DeviceTexture {
    DeviceTexture(DeviceMemory& memory, UploadRing& ring, const TextureSampler& sampler, const Image& image);
    ~DeviceTexture();
    DeviceTexture(const DeviceTexture&) = delete;
    DeviceTexture& operator=(const DeviceTexture&) = delete;

    void add_targets(UploadTargets& targets) const { targets.images.push_back(image.handle()); }

    VkDevice device;
    DeviceImage image;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;
};

class TextureStore : public DeviceStore<DeviceTexture> {
public:
    TextureStore(DeviceMemory& memory, UploadRing& ring, const TextureSampler& sampler);

    // Throws Error if there is none with this id.
    VkDescriptorSet set_of(TextureId id) const { return id.value == 0 ? white_.set : at(id.value).set; }

private:
    DeviceTexture white_;
};

}  // namespace flg::render
