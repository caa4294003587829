// SPDX-License-Identifier: MIT
#include "memory.h"

#include <algorithm>
#include <utility>

namespace flg::render {
namespace {

constexpr VkDeviceSize block_bytes = VkDeviceSize{16} << 20;  // larger things get a block of their own

VkDeviceSize align_up(VkDeviceSize value, VkDeviceSize alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

}  // namespace

// One vkAllocateMemory; its free ranges, sorted, never touching each other.
class MemoryBlock {
public:
    MemoryBlock(VkDevice device, uint32_t type, DeviceMemory::Kind kind, VkDeviceSize size, bool map)
        : device_(device), type_(type), kind_(kind), size_(size), free_{{0, size}} {
        VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
        info.allocationSize = size;
        info.memoryTypeIndex = type;
        check(vkAllocateMemory(device, &info, nullptr, &memory_), "give memory");
        if (!map) return;
        const VkResult result = vkMapMemory(device, memory_, 0, VK_WHOLE_SIZE, 0, &mapped_);
        if (result == VK_SUCCESS) return;
        vkFreeMemory(device, memory_, nullptr);
        check(result, "map memory");
    }
    ~MemoryBlock() { vkFreeMemory(device_, memory_, nullptr); }
    MemoryBlock(const MemoryBlock&) = delete;
    MemoryBlock& operator=(const MemoryBlock&) = delete;

    bool fits(uint32_t type, DeviceMemory::Kind kind) const { return type == type_ && kind == kind_; }
    bool empty() const { return free_.size() == 1 && free_[0].size == size_; }
    VkDeviceSize size() const { return size_; }
    VkDeviceMemory memory() const { return memory_; }
    void* mapped() const { return mapped_; }

    bool take(VkDeviceSize size, VkDeviceSize alignment, Allocation* out) {
        for (size_t i = 0; i < free_.size(); ++i) {
            const Range range = free_[i];
            const VkDeviceSize begin = align_up(range.begin, alignment);
            const VkDeviceSize end = begin + size;
            if (end > range.begin + range.size) continue;
            free_.erase(free_.begin() + static_cast<ptrdiff_t>(i));
            if (end < range.begin + range.size) give(end, range.begin + range.size - end);
            if (begin > range.begin) give(range.begin, begin - range.begin);
            *out = {this, begin, size};
            return true;
        }
        return false;
    }

    void give(VkDeviceSize begin, VkDeviceSize size) {
        auto next = std::lower_bound(free_.begin(), free_.end(), begin,
                                     [](const Range& range, VkDeviceSize at) { return range.begin < at; });
        next = free_.insert(next, {begin, size});
        if (next + 1 != free_.end() && next->begin + next->size == (next + 1)->begin) {
            next->size += (next + 1)->size;
            free_.erase(next + 1);
        }
        if (next != free_.begin() && (next - 1)->begin + (next - 1)->size == next->begin) {
            (next - 1)->size += next->size;
            free_.erase(next);
        }
    }

private:
    struct Range {
        VkDeviceSize begin;
        VkDeviceSize size;
    };
    VkDevice device_;
    uint32_t type_;
    DeviceMemory::Kind kind_;
    VkDeviceSize size_;
    std::vector<Range> free_;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    void* mapped_ = nullptr;
};

DeviceMemory::DeviceMemory(const Device& device) : device_(device) {
    vkGetPhysicalDeviceMemoryProperties(device.physical(), &properties_);
}

DeviceMemory::~DeviceMemory() = default;

uint32_t DeviceMemory::memory_type(uint32_t allowed_types, Place place) const {
    const VkMemoryPropertyFlags mapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const VkMemoryPropertyFlags needed = place == Place::device ? 0 : mapped;
    const VkMemoryPropertyFlags liked = place == Place::device
                                            ? VkMemoryPropertyFlags{VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT}
                                        : place == Place::readback ? mapped | VK_MEMORY_PROPERTY_HOST_CACHED_BIT
                                                                   : mapped;
    for (const VkMemoryPropertyFlags wanted : {liked, needed})
        for (uint32_t i = 0; i < properties_.memoryTypeCount; ++i)
            if ((allowed_types & (1u << i)) && (properties_.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    fail("The device has no memory of the kind that a buffer or image needs.");
}

Allocation DeviceMemory::allocate(const VkMemoryRequirements& requirements, Place place, Kind kind) {
    const uint32_t type = memory_type(requirements.memoryTypeBits, place);
    Allocation allocation;
    for (auto& block : blocks_)
        if (block->fits(type, kind) && block->take(requirements.size, requirements.alignment, &allocation))
            return allocation;
    const VkDeviceSize size = std::max(block_bytes, requirements.size);
    // By type, not by place: where all memory can be mapped, as on CPU devices, both share blocks.
    const bool mappable = properties_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
    const bool map = kind == Kind::buffer && mappable;
    blocks_.push_back(std::make_unique<MemoryBlock>(device_.handle(), type, kind, size, map));
    held_bytes_ += size;
    blocks_.back()->take(requirements.size, requirements.alignment, &allocation);
    return allocation;
}

void DeviceMemory::release(const Allocation& allocation) {
    MemoryBlock* block = allocation.block;
    block->give(allocation.offset, allocation.size);
    // Blocks of the usual size are kept for the next one; big ones are not.
    if (!block->empty() || block->size() <= block_bytes) return;
    held_bytes_ -= block->size();
    std::erase_if(blocks_, [block](const auto& candidate) { return candidate.get() == block; });
}

Buffer::Buffer(DeviceMemory& memory, VkDeviceSize size, VkBufferUsageFlags usage, DeviceMemory::Place place)
    : size_(size) {
    const VkDevice device = memory.device().handle();
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = size;
    info.usage = usage;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    check(vkCreateBuffer(device, &info, nullptr, &buffer_), "make a buffer");
    VkMemoryRequirements requirements;
    vkGetBufferMemoryRequirements(device, buffer_, &requirements);
    try {
        allocation_ = memory.allocate(requirements, place, DeviceMemory::Kind::buffer);
        memory_ = &memory;
        check(vkBindBufferMemory(device, buffer_, allocation_.block->memory(), allocation_.offset), "bind memory");
    } catch (...) {
        vkDestroyBuffer(device, buffer_, nullptr);
        if (memory_) memory.release(allocation_);
        throw;
    }
    if (place != DeviceMemory::Place::device)
        mapped_ = static_cast<char*>(allocation_.block->mapped()) + allocation_.offset;
}

Buffer::~Buffer() {
    if (!buffer_) return;
    vkDestroyBuffer(memory_->device().handle(), buffer_, nullptr);
    memory_->release(allocation_);
}

Buffer::Buffer(Buffer&& other) noexcept {
    *this = std::move(other);
}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(buffer_, other.buffer_);
    std::swap(size_, other.size_);
    std::swap(allocation_, other.allocation_);
    std::swap(mapped_, other.mapped_);
    return *this;
}

DeviceImage::DeviceImage(DeviceMemory& memory, const ImageDesc& desc) {
    const VkDevice device = memory.device().handle();
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.flags = desc.flags;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = desc.format;
    info.extent = {desc.width, desc.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = desc.samples;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = desc.usage;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    check(vkCreateImage(device, &info, nullptr, &image_), "make an image");
    VkMemoryRequirements requirements;
    vkGetImageMemoryRequirements(device, image_, &requirements);
    try {
        allocation_ = memory.allocate(requirements, DeviceMemory::Place::device, DeviceMemory::Kind::image);
        memory_ = &memory;
        check(vkBindImageMemory(device, image_, allocation_.block->memory(), allocation_.offset), "bind memory");
        VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
        view_info.image = image_;
        view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
        view_info.format = desc.format;
        view_info.subresourceRange = {desc.aspect, 0, 1, 0, 1};
        check(vkCreateImageView(device, &view_info, nullptr, &view_), "make an image view");
    } catch (...) {
        vkDestroyImage(device, image_, nullptr);
        if (memory_) memory.release(allocation_);
        throw;
    }
}

DeviceImage::~DeviceImage() {
    if (!image_) return;
    vkDestroyImageView(memory_->device().handle(), view_, nullptr);
    vkDestroyImage(memory_->device().handle(), image_, nullptr);
    memory_->release(allocation_);
}

DeviceImage::DeviceImage(DeviceImage&& other) noexcept {
    *this = std::move(other);
}

DeviceImage& DeviceImage::operator=(DeviceImage&& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(image_, other.image_);
    std::swap(view_, other.view_);
    std::swap(allocation_, other.allocation_);
    return *this;
}

}  // namespace flg::render
