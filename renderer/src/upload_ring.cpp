// SPDX-License-Identifier: MIT
#include "upload_ring.h"

#include <algorithm>
#include <cstring>

namespace flg::render {
namespace {

constexpr VkDeviceSize staging_bytes = VkDeviceSize{4} << 20;  // a block
constexpr size_t kept_blocks = 4;                              // more are given back once idle

}  // namespace

void UploadRing::upload(const Buffer& target, const void* data, VkDeviceSize size) {
    const char* from = static_cast<const char*>(data);
    VkDeviceSize done = 0;
    while (done < size) {
        if (filling_.empty() || filling_.back().used == staging_bytes) {
            if (free_.empty()) {
                filling_.push_back(
                    {Buffer(memory_, staging_bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, DeviceMemory::Place::host)});
            } else {
                filling_.push_back(std::move(free_.back()));
                free_.pop_back();
            }
        }
        Block& block = filling_.back();
        const VkDeviceSize count = std::min(size - done, staging_bytes - block.used);
        std::memcpy(static_cast<char*>(block.buffer.mapped()) + block.used, from + done, count);
        copies_.push_back({block.buffer.handle(), target.handle(), {block.used, done, count}});
        block.used += count;
        done += count;
    }
}

VkDeviceSize UploadRing::record(VkCommandBuffer commands, uint64_t frame) {
    if (copies_.empty()) return 0;
    VkDeviceSize bytes = 0;
    for (const Copy& copy : copies_) {
        vkCmdCopyBuffer(commands, copy.source, copy.target, 1, &copy.region);
        bytes += copy.region.size;
    }
    copies_.clear();
    VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_INDEX_READ_BIT | VK_ACCESS_VERTEX_ATTRIBUTE_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_VERTEX_INPUT_BIT, 0, 1, &barrier, 0,
                         nullptr, 0, nullptr);
    while (!filling_.empty()) {
        in_flight_.push_back(std::move(filling_.front()));
        in_flight_.back().frame = frame;
        filling_.pop_front();
    }
    return bytes;
}

void UploadRing::recycle(uint64_t finished_frame) {
    while (!in_flight_.empty() && in_flight_.front().frame <= finished_frame) {
        Block block = std::move(in_flight_.front());
        in_flight_.pop_front();
        block.used = 0;
        if (free_.size() < kept_blocks) free_.push_back(std::move(block));
    }
}

}  // namespace flg::render
