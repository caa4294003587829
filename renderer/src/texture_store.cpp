// SPDX-License-Identifier: MIT
#include "texture_store.h"

#include "pipeline_build.h"

namespace flg::render {
namespace {

constexpr VkFormat texture_format = VK_FORMAT_R8G8B8A8_UNORM;

void check_image(const Image& image, uint32_t most) {
    if (image.width == 0 || image.height == 0 || image.width > most || image.height > most)
        fail("The texture has %u x %u pixels; each must be 1 to %u.", image.width, image.height, most);
    const size_t bytes = size_t{4} * image.width * image.height;
    if (image.pixels.size() != bytes)
        fail("The texture of %u x %u pixels comes with %zu bytes; it must be %zu.", image.width, image.height,
             image.pixels.size(), bytes);
}

}  // namespace

TextureSampler::TextureSampler(const Device& device) : device_(device.handle()) {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    check(vkCreateSampler(device_, &info, nullptr, &sampler_), "make a sampler");
    const VkDescriptorSetLayoutBinding binding{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1,
                                               VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    try {
        layout_ = make_set_layout(device_, {&binding, 1});
    } catch (...) {
        vkDestroySampler(device_, sampler_, nullptr);
        throw;
    }
}

TextureSampler::~TextureSampler() {
    vkDestroyDescriptorSetLayout(device_, layout_, nullptr);
    vkDestroySampler(device_, sampler_, nullptr);
}

DeviceTexture::DeviceTexture(DeviceMemory& memory, UploadRing& ring, const TextureSampler& sampler, const Image& pixels)
    : device(memory.device().handle()) {
    check_image(pixels, memory.device().properties().limits.maxImageDimension2D);
    image = DeviceImage(memory, {pixels.width, pixels.height, texture_format, VK_SAMPLE_COUNT_1_BIT,
                                 VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                 VK_IMAGE_ASPECT_COLOR_BIT, 0, MemoryUse::textures});
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};
    VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool_info.maxSets = 1;
    pool_info.poolSizeCount = 1;
    pool_info.pPoolSizes = &size;
    check(vkCreateDescriptorPool(device, &pool_info, nullptr, &pool), "make a descriptor pool");
    try {
        const VkDescriptorSetLayout layout = sampler.layout();
        VkDescriptorSetAllocateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
        set_info.descriptorPool = pool;
        set_info.descriptorSetCount = 1;
        set_info.pSetLayouts = &layout;
        check(vkAllocateDescriptorSets(device, &set_info, &set), "make a descriptor set");
        ring.upload(image, pixels);
    } catch (...) {
        vkDestroyDescriptorPool(device, pool, nullptr);
        throw;
    }
    const VkDescriptorImageInfo info{sampler.handle(), image.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &info;
    vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
}

DeviceTexture::~DeviceTexture() {
    vkDestroyDescriptorPool(device, pool, nullptr);
}

TextureStore::TextureStore(DeviceMemory& memory, UploadRing& ring, const TextureSampler& sampler)
    : DeviceStore("textures", ring), white_(memory, ring, sampler, {1, 1, {255, 255, 255, 255}}) {}

}  // namespace flg::render
