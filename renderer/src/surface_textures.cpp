// SPDX-License-Identifier: MIT
#include "surface_textures.h"

#include <algorithm>
#include <cmath>

#include "pipeline_build.h"

namespace flg::render {
namespace {

constexpr size_t channels = 4;

VkSamplerAddressMode address_of(Wrap wrap) {
    if (wrap == Wrap::clamp) return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    return wrap == Wrap::mirror ? VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT : VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

void check_image(const Image& image, uint32_t most) {
    if (image.width == 0 || image.height == 0 || image.width > most || image.height > most)
        fail("A surface's texture has %u x %u pixels; each must be 1 to %u.", image.width, image.height, most);
    const size_t bytes = channels * image.width * image.height;
    if (image.pixels.size() != bytes)
        fail("A surface's texture of %u x %u pixels comes with %zu bytes; it must be %zu.", image.width, image.height,
             image.pixels.size(), bytes);
}

Image half_of(const Image& from) {
    Image to{std::max(1u, from.width / 2), std::max(1u, from.height / 2), {}};
    to.pixels.reserve(channels * to.width * to.height);
    for (uint32_t y = 0; y < to.height; ++y) {
        for (uint32_t x = 0; x < to.width; ++x) {
            const uint32_t right = std::min(2 * x + 1, from.width - 1), below = std::min(2 * y + 1, from.height - 1);
            const uint32_t left = std::min(2 * x, right), above = std::min(2 * y, below);
            for (size_t c = 0; c < channels; ++c) {
                // sRGB is about the square root of light; alpha is even.
                double sum = 0;
                for (const uint8_t* pixel :
                     {from.at(left, above), from.at(right, above), from.at(left, below), from.at(right, below)})
                    sum += c + 1 == channels ? pixel[c] : pixel[c] * pixel[c];
                const double mean = 0.25 * sum;
                to.pixels.push_back(static_cast<uint8_t>((c + 1 == channels ? mean : std::sqrt(mean)) + 0.5));
            }
        }
    }
    return to;
}

}  // namespace

std::vector<Image> coarser_levels(const Image& image) {
    std::vector<Image> levels = {image};
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(half_of(levels.back()));
    return levels;
}

SurfaceTextures::SurfaceTextures(DeviceMemory& memory, UploadRing& ring, VkDescriptorSetLayout layout,
                                 const std::vector<SurfaceTexture>& textures)
    : device_(memory.device().handle()) {
    for (const SurfaceTexture& texture : textures)
        check_image(texture.image, memory.device().properties().limits.maxImageDimension2D);
    const auto count = static_cast<uint32_t>(textures.size() + 1);
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, count};
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = count;
    info.poolSizeCount = 1;
    info.pPoolSizes = &size;
    check(vkCreateDescriptorPool(device_, &info, nullptr, &pool_), "make a descriptor pool");
    try {
        textures_.reserve(count);
        add(memory, ring, layout, {{1, 1, {255, 255, 255, 255}}, Wrap::repeat, Wrap::repeat, false});
        for (const SurfaceTexture& texture : textures) add(memory, ring, layout, texture);
    } catch (...) {
        destroy();
        throw;
    }
}

void SurfaceTextures::add(DeviceMemory& memory, UploadRing& ring, VkDescriptorSetLayout layout,
                          const SurfaceTexture& texture) {
    const std::vector<Image> levels = coarser_levels(texture.image);
    ImageDesc desc{texture.image.width,
                   texture.image.height,
                   VK_FORMAT_R8G8B8A8_SRGB,
                   VK_SAMPLE_COUNT_1_BIT,
                   VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                   VK_IMAGE_ASPECT_COLOR_BIT,
                   0,
                   MemoryUse::textures};
    desc.levels = static_cast<uint32_t>(levels.size());
    DeviceSurfaceTexture& made = textures_.emplace_back();
    made.image = DeviceImage(memory, desc);
    VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    sampler.magFilter = texture.nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
    sampler.minFilter = VK_FILTER_LINEAR;
    sampler.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    sampler.addressModeU = address_of(texture.wrap_u);
    sampler.addressModeV = sampler.addressModeW = address_of(texture.wrap_v);
    sampler.maxLod = VK_LOD_CLAMP_NONE;
    samplers_.push_back(VK_NULL_HANDLE);
    check(vkCreateSampler(device_, &sampler, nullptr, &samplers_.back()), "make a sampler");
    VkDescriptorSetAllocateInfo set{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    set.descriptorPool = pool_;
    set.descriptorSetCount = 1;
    set.pSetLayouts = &layout;
    check(vkAllocateDescriptorSets(device_, &set, &made.set), "make a descriptor set");
    const VkDescriptorImageInfo image{samplers_.back(), made.image.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = made.set;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &image;
    vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
    ring.upload(made.image, levels);
}

void SurfaceTextures::add_targets(UploadTargets& targets) const {
    for (const DeviceSurfaceTexture& texture : textures_) targets.images.push_back(texture.image.handle());
}

SurfaceTextures::~SurfaceTextures() {
    destroy();
}

void SurfaceTextures::destroy() {
    for (VkSampler sampler : samplers_) vkDestroySampler(device_, sampler, nullptr);
    vkDestroyDescriptorPool(device_, pool_, nullptr);
}

}  // namespace flg::render
