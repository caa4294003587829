// SPDX-License-Identifier: MIT
#include "frame.h"

#include <algorithm>
#include <cstring>

namespace flg::render {
namespace {

constexpr uint32_t moment_queries = 2;  // in a multiview pass one is written for each view

constexpr VkDeviceSize min_instance_bytes = 64 << 10;
constexpr VkDeviceSize min_joint_bytes = 16 << 10;
constexpr VkDeviceSize min_ui_bytes = 128 << 10;

}  // namespace

FrameSlot::FrameSlot(DeviceMemory& memory, const Pipelines& pipelines, VkDescriptorSetLayout joints_layout,
                     const ShadowMap& shadow_map)
    : memory_(memory), device_(memory.device().handle()) {
    try {
        create(pipelines, shadow_map);
        create_joints(joints_layout);
    } catch (...) {
        destroy();
        throw;
    }
}

FrameSlot::~FrameSlot() {
    destroy();
}

void FrameSlot::create(const Pipelines& pipelines, const ShadowMap& shadow_map) {
    VkCommandPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool_info.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool_info.queueFamilyIndex = memory_.device().queue_family();
    check(vkCreateCommandPool(device_, &pool_info, nullptr, &pool_), "make a command pool");
    VkCommandBufferAllocateInfo commands_info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    commands_info.commandPool = pool_;
    commands_info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    commands_info.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(device_, &commands_info, &commands_), "make a command buffer");
    VkFenceCreateInfo fence_info{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    check(vkCreateFence(device_, &fence_info, nullptr, &done_), "make a fence");
    if (memory_.device().timestamp_bits() > 0) {
        VkQueryPoolCreateInfo query_info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
        query_info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        query_info.queryCount = moment_count * moment_queries;
        check(vkCreateQueryPool(device_, &query_info, nullptr, &queries_), "make a query pool");
        times_ = Buffer(memory_, moment_count * sizeof(uint64_t), VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                        DeviceMemory::Place::readback, MemoryUse::other);
    }

    const VkDeviceSize alignment = memory_.device().properties().limits.minUniformBufferOffsetAlignment;
    constexpr VkDeviceSize view_bytes = 2 * sizeof(ViewUniforms);  // one an eye
    view_stride_ = (view_bytes + alignment - 1) / alignment * alignment;
    uniforms_ = Buffer(memory_, view_sets * view_stride_, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, DeviceMemory::Place::host,
                       MemoryUse::other);
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, view_sets},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2 * view_sets}};
    VkDescriptorPoolCreateInfo descriptor_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    descriptor_info.maxSets = view_sets;
    descriptor_info.poolSizeCount = 2;
    descriptor_info.pPoolSizes = sizes;
    check(vkCreateDescriptorPool(device_, &descriptor_info, nullptr, &descriptors_), "make a descriptor pool");
    VkDescriptorSetLayout layouts[view_sets];
    std::fill(std::begin(layouts), std::end(layouts), pipelines.view_layout());
    VkDescriptorSetAllocateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    set_info.descriptorPool = descriptors_;
    set_info.descriptorSetCount = view_sets;
    set_info.pSetLayouts = layouts;
    check(vkAllocateDescriptorSets(device_, &set_info, views_), "make descriptor sets");
    const VkDescriptorImageInfo shadow = shadow_map.descriptor(), shadow_depths = shadow_map.depth_descriptor();
    for (uint32_t i = 0; i < view_sets; ++i) {
        const VkDescriptorBufferInfo uniforms{uniforms_.handle(), i * view_stride_, view_bytes};
        VkWriteDescriptorSet writes[3]{};
        for (auto& write : writes) {
            write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
            write.dstSet = views_[i];
            write.descriptorCount = 1;
        }
        writes[0].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        writes[0].pBufferInfo = &uniforms;
        writes[1].dstBinding = 1;
        writes[1].descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        writes[1].pImageInfo = &shadow;
        writes[2].dstBinding = 2;
        writes[2].descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        writes[2].pImageInfo = &shadow_depths;
        vkUpdateDescriptorSets(device_, 3, writes, 0, nullptr);
    }
}

void FrameSlot::create_joints(VkDescriptorSetLayout layout) {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1};
    VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool_info.maxSets = 1;
    pool_info.poolSizeCount = 1;
    pool_info.pPoolSizes = &size;
    check(vkCreateDescriptorPool(device_, &pool_info, nullptr, &joints_pool_), "make a descriptor pool");
    VkDescriptorSetAllocateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    set_info.descriptorPool = joints_pool_;
    set_info.descriptorSetCount = 1;
    set_info.pSetLayouts = &layout;
    check(vkAllocateDescriptorSets(device_, &set_info, &joints_set_), "make a descriptor set");
}

void FrameSlot::destroy() {
    vkDestroyDescriptorPool(device_, joints_pool_, nullptr);
    vkDestroyDescriptorPool(device_, descriptors_, nullptr);
    vkDestroyQueryPool(device_, queries_, nullptr);
    vkDestroyFence(device_, done_, nullptr);
    vkDestroyCommandPool(device_, pool_, nullptr);
}

void FrameSlot::wait() const {
    const auto wait_for_it = [this] { return vkWaitForFences(device_, 1, &done_, VK_TRUE, UINT64_MAX); };
    if (submitted_) check(memory_.device().unless_lost(wait_for_it), "finish a frame");
}

bool FrameSlot::busy() const {
    return submitted_ && vkGetFenceStatus(device_, done_) != VK_SUCCESS;
}

VkCommandBuffer FrameSlot::begin() {
    check(vkResetCommandPool(device_, pool_, 0), "reset a command pool");
    VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(commands_, &info), "begin a command buffer");
    if (queries_) vkCmdResetQueryPool(commands_, queries_, 0, moment_count * moment_queries);
    return commands_;
}

void FrameSlot::submit(const FrameSubmission& submission) {
    check(vkEndCommandBuffer(commands_), "end a command buffer");
    submitted_ = false;
    check(vkResetFences(device_, 1, &done_), "reset a fence");
    const VkPipelineStageFlags wait_stage = VK_PIPELINE_STAGE_TRANSFER_BIT;
    VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
    info.waitSemaphoreCount = submission.wait ? 1 : 0;
    info.pWaitSemaphores = &submission.wait;
    info.pWaitDstStageMask = &wait_stage;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    info.signalSemaphoreCount = submission.signal ? 1 : 0;
    info.pSignalSemaphores = &submission.signal;
    const Device& device = memory_.device();
    check(device.unless_lost([&] { return vkQueueSubmit(device.queue(), 1, &info, done_); }), "take a frame");
    submitted_ = true;
}

void FrameSlot::mark(Moment moment) {
    if (!queries_) return;
    const auto stage =
        moment == Moment::begin ? VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT : VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT;
    vkCmdWriteTimestamp(commands_, stage, queries_, moment_queries * static_cast<uint32_t>(moment));
    if (moment != Moment::end) return;
    // Copied by the device: vkGetQueryPoolResults waits for all frames in flight on some drivers (lavapipe).
    for (uint32_t i = 0; i < moment_count; ++i)
        vkCmdCopyQueryPoolResults(commands_, queries_, moment_queries * i, 1, times_.handle(), i * sizeof(uint64_t),
                                  sizeof(uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
    VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands_, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                         nullptr, 0, nullptr);
}

double FrameSlot::elapsed_ms(Moment from, Moment to) const {
    if (!queries_ || frame == 0) return -1.0;
    uint64_t ticks[moment_count];
    std::memcpy(ticks, times_.mapped(), sizeof ticks);
    const uint32_t bits = memory_.device().timestamp_bits();
    const uint64_t mask = bits >= 64 ? ~uint64_t{0} : (uint64_t{1} << bits) - 1;
    const uint64_t passed = (ticks[static_cast<uint32_t>(to)] - ticks[static_cast<uint32_t>(from)]) & mask;
    return 1e-6 * static_cast<double>(passed) * memory_.device().properties().limits.timestampPeriod;
}

void FrameSlot::set_views(std::span<const ViewUniforms> main, const ViewUniforms& sun) {
    auto* bytes = static_cast<char*>(uniforms_.mapped());
    std::memcpy(bytes, main.data(), main.size_bytes());
    std::memcpy(bytes + view_stride_, &main.back(), sizeof main.back());
    std::memcpy(bytes + 2 * view_stride_, &sun, sizeof sun);
}

VkBuffer FrameSlot::set_instances(const std::vector<uint32_t>& instances) {
    const VkDeviceSize bytes = instances.size() * sizeof(uint32_t);
    if (instances_.size() < std::max<VkDeviceSize>(bytes, 1))
        instances_ = Buffer(memory_, std::max(min_instance_bytes, 2 * bytes), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                            DeviceMemory::Place::host, MemoryUse::other);
    if (bytes) std::memcpy(instances_.mapped(), instances.data(), bytes);
    return instances_.handle();
}

VkDescriptorSet FrameSlot::set_joints(const std::vector<float>& joints) {
    if (joints.empty()) return VK_NULL_HANDLE;
    const VkDeviceSize bytes = joints.size() * sizeof(float);
    const uint32_t max_bytes = memory_.device().properties().limits.maxStorageBufferRange;
    if (bytes > max_bytes)
        fail("The joints of all skins take %zu bytes; this device takes %u.", static_cast<size_t>(bytes), max_bytes);
    if (joints_.size() < bytes) {
        joints_ = Buffer(memory_, std::max(min_joint_bytes, 2 * bytes), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                         DeviceMemory::Place::host, MemoryUse::other);
        const VkDescriptorBufferInfo buffer{joints_.handle(), 0, std::min<VkDeviceSize>(joints_.size(), max_bytes)};
        VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
        write.dstSet = joints_set_;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &buffer;
        vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
    }
    std::memcpy(joints_.mapped(), joints.data(), bytes);
    return joints_set_;
}

UiBuffers FrameSlot::set_ui(const UiFrame& ui) {
    const VkDeviceSize vertices = ui.vertices.size_bytes(), bytes = vertices + ui.indices.size_bytes();
    if (ui_.size() < bytes)
        ui_ = Buffer(memory_, std::max(min_ui_bytes, 2 * bytes),
                     VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT, DeviceMemory::Place::host,
                     MemoryUse::other);
    auto* mapped = static_cast<char*>(ui_.mapped());
    std::copy(ui.vertices.begin(), ui.vertices.end(), reinterpret_cast<UiVertex*>(mapped));
    std::copy(ui.indices.begin(), ui.indices.end(), reinterpret_cast<uint16_t*>(mapped + vertices));
    return {ui_.handle(), vertices};
}

}  // namespace flg::render
