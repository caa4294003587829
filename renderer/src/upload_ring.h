// SPDX-License-Identifier: MIT
// Moves data to device buffers without a stall: it is copied into mapped staging blocks at once, and from there by the
// next frame's command buffer. Blocks come back when the device has finished that frame. What is no longer wanted is
// cancelled before its target goes.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "filigree_renderer/image.h"
#include "memory.h"

namespace flg::render {

// What pending copies go to.
struct UploadTargets {
    std::vector<VkBuffer> buffers;
    std::vector<VkImage> images;
};

class UploadRing {
public:
    explicit UploadRing(DeviceMemory& memory) : memory_(memory) {}

    // `target` must live until the next recorded frame is done.
    void upload(const Buffer& target, const void* data, VkDeviceSize size);
    // The same for an image of RGBA bytes, which must be new; it can be sampled from the next recorded frame on.
    void upload(const DeviceImage& target, const Image& image) { upload(target, {&image, 1}); }
    // The same with its coarser levels.
    void upload(const DeviceImage& target, std::span<const Image> levels);
    // The same into a buffer from `offset` on, of which frames in flight may still read: the copy waits for them.
    void rewrite(const Buffer& target, VkDeviceSize offset, const void* data, VkDeviceSize size);
    // A buffer on the device that holds these from the next recorded frame on.
    template <class T>
    Buffer make_filled(const std::vector<T>& values, VkBufferUsageFlags usage, MemoryUse use) {
        const VkDeviceSize bytes = values.size() * sizeof(T);
        Buffer buffer(memory_, std::max(bytes, min_bytes), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                      DeviceMemory::Place::device, use);
        upload(buffer, values.data(), bytes);
        return buffer;
    }
    // Runs `make`, which uploads; if it throws, nothing is uploaded.
    template <class Make>
    auto all_or_nothing(Make&& make) {
        const size_t copies = copies_.size(), image_copies = image_copies_.size(), images = images_.size();
        try {
            return make();
        } catch (...) {
            copies_.resize(copies);
            image_copies_.resize(image_copies);
            images_.resize(images);
            reuse_blocks();
            throw;
        }
    }
    bool pending() const { return !copies_.empty() || !image_copies_.empty(); }
    // Forgets what has not been recorded yet.
    void cancel(UploadTargets targets);
    // Records all pending copies, and that shaders wait for them; returns how many bytes. They stay pending until the
    // frame is known to be submitted.
    VkDeviceSize record(VkCommandBuffer commands);
    void submitted(uint64_t frame);
    void recycle(uint64_t finished_frame);
    // Gives back the blocks that are kept for what comes next.
    void trim() { free_.clear(); }

private:
    static constexpr VkDeviceSize min_bytes = 16;  // of a buffer in which there is nothing

    struct Block {
        Buffer buffer;
        VkDeviceSize used = 0;
        uint64_t frame = 0;
    };
    void stage_level(const DeviceImage& target, const Image& image, uint32_t level);
    void stage(const Buffer& target, VkDeviceSize offset, const void* data, VkDeviceSize size);

    struct Copy {
        VkBuffer source = VK_NULL_HANDLE;
        VkBuffer target = VK_NULL_HANDLE;
        VkBufferCopy region{};
    };
    struct ImageCopy {
        VkBuffer source = VK_NULL_HANDLE;
        VkImage target = VK_NULL_HANDLE;
        VkBufferImageCopy region{};
    };
    // One that has room for so many bytes, at most those of a block.
    Block& block_with(VkDeviceSize bytes);
    void record_images(VkCommandBuffer commands) const;
    void reuse(Block block);
    // Takes the blocks back that no pending copy is from.
    void reuse_blocks();

    DeviceMemory& memory_;
    std::vector<Block> filling_;  // what the next frame copies from
    std::vector<Block> in_flight_;
    std::vector<Block> free_;
    std::vector<Copy> copies_;
    std::vector<ImageCopy> image_copies_;
    std::vector<VkImage> images_;  // of those copies
    bool rewrites_ = false;
};

}  // namespace flg::render
