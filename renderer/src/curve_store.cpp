// SPDX-License-Identifier: MIT
#include "curve_store.h"

#include <algorithm>
#include <cmath>

namespace flg::render {
namespace {

constexpr uint32_t max_columns = 32;
constexpr float largest_magnitude_offset = 1e6f;
// Depth is 1 near and 0 infinitely far: what is in front begins here, before all that is further away than a twentieth
// of the way to the camera's target.
constexpr float depth_in_front = 0.04f;

void check_size(const Device& device, size_t points) {
    const size_t most = device.properties().limits.maxStorageBufferRange / sizeof(glm::vec4);
    if (points > most) fail("The curves have %zu points; this device takes %zu in an upload.", points, most);
}

}  // namespace

IndexPatterns::IndexPatterns(UploadRing& ring) {
    std::vector<uint16_t> indices;
    for (uint32_t columns = 2; columns <= max_columns; ++columns) {
        first_[columns] = static_cast<uint32_t>(indices.size());
        const uint32_t strips = columns == 2 ? 1 : columns;
        for (uint32_t ring_index = 0; ring_index < chunk_segments; ++ring_index) {
            for (uint32_t side = 0; side < strips; ++side) {
                const uint32_t here = ring_index * columns, next = here + columns;
                const uint32_t other = (side + 1) % columns;
                for (const uint32_t i :
                     {here + side, here + other, next + side, next + side, here + other, next + other})
                    indices.push_back(static_cast<uint16_t>(i));
            }
        }
    }
    buffer_ = ring.make_filled(indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, MemoryUse::other);
}

DeviceCurves::DeviceCurves(DeviceMemory& memory, UploadRing& ring, const Pipelines& pipelines,
                           const FlgCurveSetView& view, const CurveLook& wanted_look)
    : look(wanted_look), data(prepare_curves(view, wanted_look)), device(memory.device().handle()) {
    check_size(memory.device(), data.centers.size());
    const VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    centers = ring.make_filled(data.centers, usage, MemoryUse::curves);
    looks = ring.make_filled(data.looks, usage, MemoryUse::curves);
    chunks = ring.make_filled(data.chunks, usage, MemoryUse::curves);
    if (data.has_displacements) displacements = ring.make_filled(data.displacements, usage, MemoryUse::curves);
    bind(pipelines);
    data.centers = {};
    data.looks = {};
    data.displacements = {};
}

DeviceCurves::DeviceCurves(DeviceMemory& memory, const Pipelines& pipelines, const CurveLook& wanted_look,
                           uint32_t capacity)
    : look(wanted_look), device(memory.device().handle()) {
    check_look(look);
    if (capacity < 2 || capacity > max_growing_points)
        fail("The capacity is %u; it must be 2 to %u.", capacity, max_growing_points);
    check_size(memory.device(), capacity);
    growing = std::make_unique<GrowingCurve>(data, look, capacity);
    const auto room = [&](size_t count, size_t size) {
        return Buffer(memory, count * size, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                      DeviceMemory::Place::device, MemoryUse::curves);
    };
    centers = room(data.centers.capacity(), sizeof data.centers[0]);
    looks = room(data.looks.capacity(), sizeof data.looks[0]);
    chunks = room(data.chunks.capacity(), sizeof data.chunks[0]);
    bind(pipelines);
}

void DeviceCurves::bind(const Pipelines& pipelines) {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, curve_buffers};
    VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool_info.maxSets = 1;
    pool_info.poolSizeCount = 1;
    pool_info.pPoolSizes = &size;
    check(vkCreateDescriptorPool(device, &pool_info, nullptr, &pool), "make a descriptor pool");
    try {
        const VkDescriptorSetLayout layout = pipelines.curves_layout();
        VkDescriptorSetAllocateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
        set_info.descriptorPool = pool;
        set_info.descriptorSetCount = 1;
        set_info.pSetLayouts = &layout;
        check(vkAllocateDescriptorSets(device, &set_info, &set), "make a descriptor set");
    } catch (...) {
        vkDestroyDescriptorPool(device, pool, nullptr);
        throw;
    }
    // Without displacements the shader reads none; something must be bound nevertheless.
    const Buffer& last = data.has_displacements ? displacements : centers;
    const VkDescriptorBufferInfo buffers[curve_buffers] = {{centers.handle(), 0, VK_WHOLE_SIZE},
                                                           {looks.handle(), 0, VK_WHOLE_SIZE},
                                                           {chunks.handle(), 0, VK_WHOLE_SIZE},
                                                           {last.handle(), 0, VK_WHOLE_SIZE}};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.descriptorCount = curve_buffers;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = buffers;
    vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
}

DeviceCurves::~DeviceCurves() {
    vkDestroyDescriptorPool(device, pool, nullptr);
}

void DeviceCurves::add_targets(UploadTargets& targets) const {
    for (const Buffer* buffer : {&centers, &looks, &chunks, &displacements})
        targets.buffers.push_back(buffer->handle());
}

void CurveStore::set_magnitude_offset(CurvesId id, float offset) {
    DeviceCurves& curves = at(id.value);
    if (!curves.data.has_displacements)
        fail("The curves %llu were uploaded without a DISPLACEMENT column.", static_cast<unsigned long long>(id.value));
    if (!(std::abs(offset) <= largest_magnitude_offset))
        fail("The magnitude offset is %g; it must be in -%g to %g.", offset, largest_magnitude_offset,
             largest_magnitude_offset);
    curves.magnitude_offset = offset;
}

GrowingCurve& CurveStore::growing(CurvesId id) {
    DeviceCurves& curves = at(id.value);
    if (!curves.growing) fail("The curves %llu do not grow.", static_cast<unsigned long long>(id.value));
    return *curves.growing;
}

void CurveStore::upload_growth() {
    const auto rewrite = [&](const Buffer& buffer, const auto& values, uint32_t first, uint32_t count) {
        constexpr size_t size = sizeof values[0];
        ring_.rewrite(buffer, first * size, values.data() + first, count * size);
    };
    for (const auto& [id, curves] : items()) {
        if (!curves->growing) continue;
        const GrowingCurve::Changes changes = curves->growing->changes();
        ring_.all_or_nothing([&] {
            rewrite(curves->centers, curves->data.centers, changes.first_point, changes.point_count);
            rewrite(curves->looks, curves->data.looks, changes.first_point, changes.point_count);
            rewrite(curves->chunks, curves->data.chunks, changes.first_chunk, changes.chunk_count);
        });
        curves->growing->changes_uploaded();
    }
}

Box CurveStore::bounds() const {
    Box box;
    for (const auto& [id, curves] : items())
        if (curves->visible) box.add(curves->data.box_at(curves->magnitude_offset));
    return box;
}

void CurveStore::select(std::span<const ViewUniforms> views, bool shadow, DrawList& list,
                        std::vector<uint32_t>& instances) const {
    ChunkSelector selector(views);
    for (const auto& [id, curves] : items()) {
        if (!curves->visible) continue;
        if (shadow && (!curves->look.casts_shadow || curves->look.shape == Shape::line)) continue;
        const auto first_bin = static_cast<uint32_t>(list.bins.size());
        selector.select(curves->data, curves->look, curves->magnitude_offset, instances, list.bins);
        const auto bin_count = static_cast<uint32_t>(list.bins.size()) - first_bin;
        if (bin_count) list.items.push_back({curves.get(), first_bin, bin_count});
    }
}

uint64_t record_curves(VkCommandBuffer commands, const Pipelines& pipelines, const IndexPatterns& patterns,
                       const DrawList& list, VkBuffer instances, const CurvePass& pass) {
    if (list.items.empty()) return 0;
    const bool shadow = pass.viewport == nullptr;
    bool in_front = false;
    const auto set_depths = [&](bool to_front) {
        if (shadow || to_front == in_front) return;
        in_front = to_front;
        VkViewport changed = *pass.viewport;
        changed.minDepth = to_front ? depth_in_front : pass.viewport->minDepth;
        vkCmdSetViewport(commands, 0, 1, &changed);
    };
    uint64_t triangles = 0;
    const VkDeviceSize no_offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &instances, &no_offset);
    vkCmdBindIndexBuffer(commands, patterns.buffer(), 0, VK_INDEX_TYPE_UINT16);
    for (const DrawList::Item& item : list.items) {
        const CurveLook& look = item.curves->look;
        const bool displaced = item.curves->magnitude_offset != 0.0f;
        set_depths(look.in_front);
        vkCmdBindPipeline(
            commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
            shadow ? pipelines.curve_shadow(look.shape, displaced) : pipelines.curve(look, displaced, pass.eyes));
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.layout(), 1, 1, &item.curves->set,
                                0, nullptr);
        for (uint32_t i = item.first_bin; i < item.first_bin + item.bin_count; ++i) {
            const DrawBin& bin = list.bins[i];
            const CurvePush push{bin.columns,
                                 static_cast<uint32_t>(bin.part),
                                 cap_rings,
                                 look.caps == Caps::round,
                                 0.5f * look.line_width_px,
                                 look.gloss,
                                 item.curves->magnitude_offset,
                                 look.in_front};
            vkCmdPushConstants(commands, pipelines.layout(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
                               0, sizeof push, &push);
            const uint32_t indices = IndexPatterns::index_count(bin.columns, bin.segments);
            vkCmdDrawIndexed(commands, indices, bin.instance_count, patterns.first_index(bin.columns), 0,
                             bin.first_instance);
            triangles += uint64_t{indices / 3} * bin.instance_count;
        }
    }
    set_depths(false);
    return triangles;
}

}  // namespace flg::render
