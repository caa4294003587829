// SPDX-License-Identifier: MIT
// Device memory in blocks, shared out first fit; buffers and images made of it. Buffers and images never share a block,
// so that bufferImageGranularity need not be thought of. A released range may be given out again at once: release only
// what the device has done with (frame.h keeps the rest until then).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "device.h"

namespace flg::render {

class MemoryBlock;

enum class MemoryUse { curves, surfaces, textures, targets, shadow_map, staging, other };
constexpr size_t memory_uses = 7;

struct Allocation {
    MemoryBlock* block = nullptr;
    VkDeviceSize offset = 0;
    VkDeviceSize size = 0;
    MemoryUse use = MemoryUse::other;
};

class DeviceMemory {
public:
    // limit_bytes 0: four fifths of what the device has of its own.
    DeviceMemory(const Device& device, VkDeviceSize limit_bytes);
    ~DeviceMemory();
    DeviceMemory(const DeviceMemory&) = delete;
    DeviceMemory& operator=(const DeviceMemory&) = delete;

    enum class Place { device, host, readback };  // the last two mapped and coherent, readback cached if it can be
    enum class Kind { buffer, image };
    // Throws Error beyond the limit, and where the device has no more; nothing has changed then.
    Allocation allocate(const VkMemoryRequirements& requirements, Place place, Kind kind, MemoryUse use);
    void release(const Allocation& allocation);
    // Called when memory runs out: releases what the device has done with. May wait for it.
    std::function<void()> reclaim;

    const Device& device() const { return device_; }
    MemoryReport report() const;

private:
    uint32_t memory_type(uint32_t allowed_types, Place place) const;
    bool take(uint32_t type, Kind kind, const VkMemoryRequirements& requirements, Allocation* out);
    bool add_block(uint32_t type, Kind kind, VkDeviceSize least);
    void release_idle_blocks();

    const Device& device_;
    VkPhysicalDeviceMemoryProperties properties_{};
    std::vector<std::unique_ptr<MemoryBlock>> blocks_;
    VkDeviceSize limit_bytes_;
    VkDeviceSize held_bytes_ = 0;
    std::array<VkDeviceSize, memory_uses> used_bytes_{};
};

class Buffer {
public:
    Buffer() = default;
    Buffer(DeviceMemory& memory, VkDeviceSize size, VkBufferUsageFlags usage, DeviceMemory::Place place, MemoryUse use);
    ~Buffer();
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;

    VkBuffer handle() const { return buffer_; }
    VkDeviceSize size() const { return size_; }
    void* mapped() const { return mapped_; }

private:
    DeviceMemory* memory_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceSize size_ = 0;
    Allocation allocation_;
    void* mapped_ = nullptr;
};

struct ImageDesc {
    uint32_t width = 0;
    uint32_t height = 0;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkImageUsageFlags usage = 0;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
    VkImageCreateFlags flags = 0;
    MemoryUse use = MemoryUse::targets;
    uint32_t layers = 1;
    uint32_t levels = 1;
};

// A 2D image, or an array of some, with one view of all of it.
class DeviceImage {
public:
    DeviceImage() = default;
    DeviceImage(DeviceMemory& memory, const ImageDesc& desc);
    ~DeviceImage();
    DeviceImage(DeviceImage&& other) noexcept;
    DeviceImage& operator=(DeviceImage&& other) noexcept;

    VkImage handle() const { return image_; }
    VkImageView view() const { return view_; }

private:
    DeviceMemory* memory_ = nullptr;
    VkImage image_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    Allocation allocation_;
};

}  // namespace flg::render
