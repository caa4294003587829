// SPDX-License-Identifier: MIT
// Device memory in blocks, shared out first fit; buffers and images made of it. Buffers and images never share a block, so
// that bufferImageGranularity need not be thought of. A released range may be given out again at once: release only what
// the device has done with (frame.h keeps the rest until then).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "device.h"

namespace flg::render {

class MemoryBlock;

struct Allocation {
    MemoryBlock* block = nullptr;
    VkDeviceSize offset = 0;
    VkDeviceSize size = 0;
};

class DeviceMemory {
public:
    explicit DeviceMemory(const Device& device);
    ~DeviceMemory();
    DeviceMemory(const DeviceMemory&) = delete;
    DeviceMemory& operator=(const DeviceMemory&) = delete;

    enum class Place { device, host, readback };  // the last two mapped and coherent, readback cached if it can be
    enum class Kind { buffer, image };
    Allocation allocate(const VkMemoryRequirements& requirements, Place place, Kind kind);
    void release(const Allocation& allocation);

    const Device& device() const { return device_; }
    VkDeviceSize held_bytes() const { return held_bytes_; }

private:
    uint32_t memory_type(uint32_t allowed_types, Place place) const;

    const Device& device_;
    VkPhysicalDeviceMemoryProperties properties_{};
    std::vector<std::unique_ptr<MemoryBlock>> blocks_;
    VkDeviceSize held_bytes_ = 0;
};

class Buffer {
public:
    Buffer() = default;
    Buffer(DeviceMemory& memory, VkDeviceSize size, VkBufferUsageFlags usage, DeviceMemory::Place place);
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
};

// A 2D image with one view of all of it.
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
