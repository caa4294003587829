// SPDX-License-Identifier: MIT
#include "upload_ring.h"

#include <algorithm>
#include <cstring>

namespace flg::render {
namespace {

constexpr VkDeviceSize staging_bytes = VkDeviceSize{4} << 20;  // a block
constexpr VkDeviceSize texel_bytes = 4;                        // copies to images begin at multiples of it
constexpr size_t kept_blocks = 2;                              // more are given back once idle

}  // namespace

UploadRing::Block& UploadRing::block_with(VkDeviceSize bytes) {
    if (!filling_.empty()) {
        Block& block = filling_.back();
        block.used = (block.used + texel_bytes - 1) / texel_bytes * texel_bytes;
        if (staging_bytes - block.used >= bytes) return block;
    }
    if (free_.empty()) {
        filling_.push_back({Buffer(memory_, staging_bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, DeviceMemory::Place::host,
                                   MemoryUse::staging)});
    } else {
        filling_.push_back(std::move(free_.back()));
        free_.pop_back();
    }
    return filling_.back();
}

void UploadRing::upload(const Buffer& target, const void* data, VkDeviceSize size) {
    stage(target, 0, data, size);
}

void UploadRing::rewrite(const Buffer& target, VkDeviceSize offset, const void* data, VkDeviceSize size) {
    stage(target, offset, data, size);
    rewrites_ |= size > 0;
}

void UploadRing::stage(const Buffer& target, VkDeviceSize offset, const void* data, VkDeviceSize size) {
    const char* from = static_cast<const char*>(data);
    VkDeviceSize done = 0;
    while (done < size) {
        Block& block = block_with(1);
        const VkDeviceSize count = std::min(size - done, staging_bytes - block.used);
        std::memcpy(static_cast<char*>(block.buffer.mapped()) + block.used, from + done, count);
        copies_.push_back({block.buffer.handle(), target.handle(), {block.used, offset + done, count}});
        block.used += count;
        done += count;
    }
}

void UploadRing::upload(const DeviceImage& target, std::span<const Image> levels) {
    images_.push_back(target.handle());
    for (uint32_t level = 0; level < levels.size(); ++level) stage_level(target, levels[level], level);
}

void UploadRing::stage_level(const DeviceImage& target, const Image& image, uint32_t level) {
    const VkDeviceSize row_bytes = texel_bytes * image.width;
    for (uint32_t y = 0; y < image.height;) {
        Block& block = block_with(row_bytes);
        const uint32_t rows =
            std::min(image.height - y, static_cast<uint32_t>((staging_bytes - block.used) / row_bytes));
        std::memcpy(static_cast<char*>(block.buffer.mapped()) + block.used, image.at(0, y), rows * row_bytes);
        VkBufferImageCopy region{};
        region.bufferOffset = block.used;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
        region.imageOffset.y = static_cast<int32_t>(y);
        region.imageExtent = {image.width, rows, 1};
        image_copies_.push_back({block.buffer.handle(), target.handle(), region});
        block.used += rows * row_bytes;
        y += rows;
    }
}

VkDeviceSize UploadRing::record(VkCommandBuffer commands) {
    if (copies_.empty() && images_.empty()) return 0;
    VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    if (rewrites_) {
        barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                             VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
    }
    VkDeviceSize bytes = 0;
    for (const ImageCopy& copy : image_copies_)
        bytes += texel_bytes * copy.region.imageExtent.width * copy.region.imageExtent.height;
    record_images(commands);
    for (const Copy& copy : copies_) {
        vkCmdCopyBuffer(commands, copy.source, copy.target, 1, &copy.region);
        bytes += copy.region.size;
    }
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_INDEX_READ_BIT | VK_ACCESS_VERTEX_ATTRIBUTE_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_VERTEX_INPUT_BIT, 0, 1, &barrier, 0,
                         nullptr, 0, nullptr);
    return bytes;
}

void UploadRing::submitted(uint64_t frame) {
    for (Block& block : filling_) {
        block.frame = frame;
        in_flight_.push_back(std::move(block));
    }
    filling_.clear();
    copies_.clear();
    image_copies_.clear();
    images_.clear();
    rewrites_ = false;
}

void UploadRing::cancel(UploadTargets targets) {
    if (copies_.empty() && images_.empty()) return;
    const auto is_one_of = [](const auto& sorted) {
        return [&](const auto& target) { return std::binary_search(sorted.begin(), sorted.end(), target); };
    };
    std::sort(targets.buffers.begin(), targets.buffers.end());
    std::sort(targets.images.begin(), targets.images.end());
    const auto is_buffer = is_one_of(targets.buffers);
    const auto is_image = is_one_of(targets.images);
    std::erase_if(copies_, [&](const Copy& copy) { return is_buffer(copy.target); });
    std::erase_if(image_copies_, [&](const ImageCopy& copy) { return is_image(copy.target); });
    std::erase_if(images_, is_image);
    reuse_blocks();
}

void UploadRing::record_images(VkCommandBuffer commands) const {
    if (images_.empty()) return;
    std::vector<VkImageMemoryBarrier> barriers(images_.size(), {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER});
    for (size_t i = 0; i < images_.size(); ++i) {
        VkImageMemoryBarrier& barrier = barriers[i];
        barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = images_[i];
        barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, 1};
    }
    const auto count = static_cast<uint32_t>(barriers.size());
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0,
                         nullptr, count, barriers.data());
    for (const ImageCopy& copy : image_copies_)
        vkCmdCopyBufferToImage(commands, copy.source, copy.target, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                               &copy.region);
    for (VkImageMemoryBarrier& barrier : barriers) {
        barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
        barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
        barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    }
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, 0, 0, nullptr,
                         0, nullptr, count, barriers.data());
}

void UploadRing::reuse(Block block) {
    block.used = 0;
    if (free_.size() < kept_blocks) free_.push_back(std::move(block));
}

void UploadRing::reuse_blocks() {
    std::vector<VkBuffer> sources;
    sources.reserve(copies_.size() + image_copies_.size());
    for (const Copy& copy : copies_) sources.push_back(copy.source);
    for (const ImageCopy& copy : image_copies_) sources.push_back(copy.source);
    std::sort(sources.begin(), sources.end());
    std::erase_if(filling_, [&](Block& block) {
        if (std::binary_search(sources.begin(), sources.end(), block.buffer.handle())) return false;
        reuse(std::move(block));
        return true;
    });
}

void UploadRing::recycle(uint64_t finished_frame) {
    std::erase_if(in_flight_, [&](Block& block) {
        if (block.frame > finished_frame) return false;
        reuse(std::move(block));
        return true;
    });
}

}  // namespace flg::render
