// SPDX-License-Identifier: MIT
// Moves data to device buffers without a stall: it is copied into mapped staging blocks at once, and from there by the
// next frame's command buffer. Blocks come back when the device has finished that frame.
#pragma once

#include <algorithm>
#include <vector>

#include "filigree_renderer/image.h"
#include "memory.h"

namespace flg::render {

class UploadRing {
public:
    explicit UploadRing(DeviceMemory& memory) : memory_(memory) {}

    // `target` must live until the next recorded frame is done.
    void upload(const Buffer& target, const void* data, VkDeviceSize size);
    // The same for an image of RGBA bytes, which must be new; it can be sampled from the next recorded frame on.
    void upload(const DeviceImage& target, const Image& image);
    // The same into a buffer from `offset` on, of which frames in flight may still read: the copy waits for them.
    void rewrite(const Buffer& target, VkDeviceSize offset, const void* data, VkDeviceSize size);
    // A buffer on the device that holds these from the next recorded frame on.
    template <class T>
    Buffer make_filled(const std::vector<T>& values, VkBufferUsageFlags usage) {
        const VkDeviceSize bytes = values.size() * sizeof(T);
        Buffer buffer(memory_, std::max(bytes, least_bytes), usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                      DeviceMemory::Place::device);
        upload(buffer, values.data(), bytes);
        return buffer;
    }
    // Records all pending copies, and that shaders wait for them; returns how many bytes.
    VkDeviceSize record(VkCommandBuffer commands, uint64_t frame);
    void recycle(uint64_t finished_frame);

private:
    static constexpr VkDeviceSize least_bytes = 16;  // of a buffer in which there is nothing

    struct Block {
        Buffer buffer;
        VkDeviceSize used = 0;
        uint64_t frame = 0;
    };
    void stage(const Buffer& target, VkDeviceSize offset, const void* data, VkDeviceSize size);

    struct Copy {
        VkBuffer source;
        VkBuffer target;
        VkBufferCopy region;
    };
    struct ImageCopy {
        VkBuffer source;
        VkImage target;
        VkBufferImageCopy region;
    };
    // One that has room for so many bytes, at most those of a block.
    Block& block_with(VkDeviceSize bytes);
    void record_images(VkCommandBuffer commands);

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
