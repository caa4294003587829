// SPDX-License-Identifier: MIT
#include "curve_store.h"

#include <algorithm>
#include <cmath>

namespace flg::render {
namespace {

constexpr uint32_t most_columns = 32;
constexpr float largest_magnitude_offset = 1e6f;
// Depth is 1 near and 0 infinitely far: what is in front begins here, before all that is further away than a twentieth of the
// way to the camera's target.
constexpr float depth_in_front = 0.04f;

}  // namespace

IndexPatterns::IndexPatterns(UploadRing& ring) {
    std::vector<uint16_t> indices;
    for (uint32_t columns = 2; columns <= most_columns; ++columns) {
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
    buffer_ = ring.make_filled(indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
}

DeviceCurves::DeviceCurves(DeviceMemory& memory, UploadRing& ring, const Pipelines& pipelines,
                           const FlgCurveSetView& view, const CurveLook& wanted_look)
    : look(wanted_look), data(prepare_curves(view, wanted_look)), device(memory.device().handle()) {
    const VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const uint32_t most_bytes = memory.device().properties().limits.maxStorageBufferRange;
    if (data.centers.size() * sizeof data.centers[0] > most_bytes)
        fail("The curves have %zu points; this device takes %zu in an upload.", data.centers.size(),
             most_bytes / sizeof data.centers[0]);
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
        centers = ring.make_filled(data.centers, usage);
        looks = ring.make_filled(data.looks, usage);
        chunks = ring.make_filled(data.chunks, usage);
        if (data.has_displacements) displacements = ring.make_filled(data.displacements, usage);
    } catch (...) {
        vkDestroyDescriptorPool(device, pool, nullptr);
        throw;
    }
    data.centers = {};
    data.looks = {};
    data.displacements = {};
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

void CurveStore::set_magnitude_offset(CurvesId id, float offset) {
    DeviceCurves& curves = at(id.value);
    if (!curves.data.has_displacements)
        fail("The curves %llu were uploaded without a DISPLACEMENT column.", static_cast<unsigned long long>(id.value));
    if (!(std::abs(offset) <= largest_magnitude_offset))
        fail("The magnitude offset is %g; it must be in -%g to %g.", offset, largest_magnitude_offset,
             largest_magnitude_offset);
    curves.magnitude_offset = offset;
}

Box CurveStore::bounds() const {
    Box box;
    for (const auto& [id, curves] : items())
        if (curves->visible) box.add(curves->data.box_at(curves->magnitude_offset));
    return box;
}

void CurveStore::select(const ViewUniforms& view, bool shadow, DrawList& list, std::vector<uint32_t>& instances) const {
    ChunkSelector selector(view);
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
                       const DrawList& list, VkBuffer instances, const VkViewport* viewport) {
    if (list.items.empty()) return 0;
    const bool shadow = viewport == nullptr;
    bool in_front = false;
    const auto set_depths = [&](bool to_front) {
        if (shadow || to_front == in_front) return;
        in_front = to_front;
        VkViewport changed = *viewport;
        changed.minDepth = to_front ? depth_in_front : viewport->minDepth;
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
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                          shadow ? pipelines.curve_shadow(look.shape, displaced) : pipelines.curve(look, displaced));
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
