// SPDX-License-Identifier: MIT
#include "memory.h"

#include <algorithm>
#include <utility>

namespace flg::render {
namespace {

constexpr VkDeviceSize block_bytes = VkDeviceSize{16} << 20;  // larger things get a block of their own
constexpr const char* use_names[memory_uses] = {"curves",         "surfaces", "textures", "targets",
                                                "the shadow map", "staging",  "frames"};

VkDeviceSize align_up(VkDeviceSize value, VkDeviceSize alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

}  // namespace

// One vkAllocateMemory; its free ranges, sorted, never touching each other.
class MemoryBlock {
public:
    // Null where the device has no memory left.
    static std::unique_ptr<MemoryBlock> make(VkDevice device, uint32_t type, DeviceMemory::Kind kind, VkDeviceSize size,
                                             bool map) {
        std::unique_ptr<MemoryBlock> block(new MemoryBlock(device, type, kind, size));
        VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
        info.allocationSize = size;
        info.memoryTypeIndex = type;
        VkResult result = vkAllocateMemory(device, &info, nullptr, &block->memory_);
        if (result == VK_SUCCESS && map)
            result = vkMapMemory(device, block->memory_, 0, VK_WHOLE_SIZE, 0, &block->mapped_);
        if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY ||
            result == VK_ERROR_TOO_MANY_OBJECTS || result == VK_ERROR_MEMORY_MAP_FAILED)
            return nullptr;
        check(result, "give memory");
        return block;
    }
    ~MemoryBlock() { vkFreeMemory(device_, memory_, nullptr); }
    MemoryBlock(const MemoryBlock&) = delete;
    MemoryBlock& operator=(const MemoryBlock&) = delete;

    bool fits(uint32_t type, DeviceMemory::Kind kind) const { return type == type_ && kind == kind_; }
    bool fits(const MemoryBlock& other) const { return fits(other.type_, other.kind_); }
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
            out->block = this;
            out->offset = begin;
            out->size = size;
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
    MemoryBlock(VkDevice device, uint32_t type, DeviceMemory::Kind kind, VkDeviceSize size)
        : device_(device), type_(type), kind_(kind), size_(size), free_{{0, size}} {}

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

DeviceMemory::DeviceMemory(const Device& device, VkDeviceSize limit_bytes)
    : device_(device), limit_bytes_(limit_bytes) {
    vkGetPhysicalDeviceMemoryProperties(device.physical(), &properties_);
    if (limit_bytes_) return;
    VkDeviceSize own_bytes = 0;
    for (uint32_t i = 0; i < properties_.memoryHeapCount; ++i)
        if (properties_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            own_bytes += properties_.memoryHeaps[i].size;
    limit_bytes_ = own_bytes / 5 * 4;
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

Allocation DeviceMemory::allocate(const VkMemoryRequirements& requirements, Place place, Kind kind, MemoryUse use) {
    const uint32_t type = memory_type(requirements.memoryTypeBits, place);
    Allocation allocation;
    bool taken = take(type, kind, requirements, &allocation);
    if (!taken && reclaim) {
        reclaim();
        release_idle_blocks();
        taken = take(type, kind, requirements, &allocation);
    }
    if (!taken) {
        const auto asked = static_cast<unsigned long long>(requirements.size);
        const auto held = static_cast<unsigned long long>(held_bytes_);
        const char* name = use_names[static_cast<size_t>(use)];
        if (requirements.size > limit_bytes_ - std::min(held_bytes_, limit_bytes_))
            fail("%llu bytes were asked for, for %s; %llu are held, and the limit is %llu.", asked, name, held,
                 static_cast<unsigned long long>(limit_bytes_));
        fail("%llu bytes were asked for, for %s; %llu are held, and the device has no more.", asked, name, held);
    }
    allocation.use = use;
    used_bytes_[static_cast<size_t>(use)] += allocation.size;
    return allocation;
}

bool DeviceMemory::take(uint32_t type, Kind kind, const VkMemoryRequirements& requirements, Allocation* out) {
    for (auto& block : blocks_)
        if (block->fits(type, kind) && block->take(requirements.size, requirements.alignment, out)) return true;
    return add_block(type, kind, requirements.size) &&
           blocks_.back()->take(requirements.size, requirements.alignment, out);
}

bool DeviceMemory::add_block(uint32_t type, Kind kind, VkDeviceSize least) {
    // By type, not by place: where all memory can be mapped, as on CPU devices, both share blocks.
    const bool mappable = properties_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
    const bool map = kind == Kind::buffer && mappable;
    // Where there is little left, no more than is needed.
    for (const VkDeviceSize size : {std::max(block_bytes, least), least}) {
        if (size > limit_bytes_ - std::min(held_bytes_, limit_bytes_)) continue;
        auto block = MemoryBlock::make(device_.handle(), type, kind, size, map);
        if (!block) continue;
        blocks_.push_back(std::move(block));
        held_bytes_ += size;
        return true;
    }
    return false;
}

void DeviceMemory::release_idle_blocks() {
    std::erase_if(blocks_, [this](const auto& block) {
        if (block->empty()) held_bytes_ -= block->size();
        return block->empty();
    });
}

void DeviceMemory::release(const Allocation& allocation) {
    MemoryBlock* block = allocation.block;
    block->give(allocation.offset, allocation.size);
    used_bytes_[static_cast<size_t>(allocation.use)] -= allocation.size;
    if (!block->empty()) return;
    // One idle block of the usual size is kept of each kind, for what comes next.
    const bool is_spare =
        block->size() == block_bytes && std::none_of(blocks_.begin(), blocks_.end(), [&](auto& other) {
            return other.get() != block && other->fits(*block) && other->empty();
        });
    if (is_spare) return;
    held_bytes_ -= block->size();
    std::erase_if(blocks_, [block](const auto& candidate) { return candidate.get() == block; });
}

MemoryReport DeviceMemory::report() const {
    const auto used = [this](MemoryUse use) { return used_bytes_[static_cast<size_t>(use)]; };
    return {limit_bytes_,
            held_bytes_,
            used(MemoryUse::curves),
            used(MemoryUse::surfaces),
            used(MemoryUse::textures),
            used(MemoryUse::targets),
            used(MemoryUse::shadow_map),
            used(MemoryUse::staging),
            used(MemoryUse::other)};
}

Buffer::Buffer(DeviceMemory& memory, VkDeviceSize size, VkBufferUsageFlags usage, DeviceMemory::Place place,
               MemoryUse use)
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
        allocation_ = memory.allocate(requirements, place, DeviceMemory::Kind::buffer, use);
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
    info.mipLevels = desc.levels;
    info.arrayLayers = desc.layers;
    info.samples = desc.samples;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = desc.usage;
    info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    check(vkCreateImage(device, &info, nullptr, &image_), "make an image");
    VkMemoryRequirements requirements;
    vkGetImageMemoryRequirements(device, image_, &requirements);
    try {
        allocation_ = memory.allocate(requirements, DeviceMemory::Place::device, DeviceMemory::Kind::image, desc.use);
        memory_ = &memory;
        check(vkBindImageMemory(device, image_, allocation_.block->memory(), allocation_.offset), "bind memory");
        VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
        view_info.image = image_;
        view_info.viewType = desc.layers == 1 ? VK_IMAGE_VIEW_TYPE_2D : VK_IMAGE_VIEW_TYPE_2D_ARRAY;
        view_info.format = desc.format;
        view_info.subresourceRange = {desc.aspect, 0, desc.levels, 0, desc.layers};
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
