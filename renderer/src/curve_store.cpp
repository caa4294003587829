// SPDX-License-Identifier: MIT
#include "curve_store.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flg::render {
namespace {

constexpr uint32_t max_columns = 32;
constexpr float largest_magnitude_offset = 1e6f;
// Depth is 1 near and 0 infinitely far: what is in front begins here, before all that is further away than a twentieth
// of the way to the camera's target.
constexpr float depth_in_front = 0.04f;

uint32_t points_in_a_buffer(const Device& device) {
    return static_cast<uint32_t>(device.properties().limits.maxStorageBufferRange / sizeof(glm::vec4));
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
                           const FlgCurveSetView& view, const CurveLook& wanted_look, uint32_t max_points)
    : look(wanted_look) {
    const VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    for (CurveData& data : prepare_curves(view, look, max_points ? max_points : points_in_a_buffer(memory.device()))) {
        DevicePart& part = parts.emplace_back(std::move(data), memory.device().handle());
        part.centers = ring.make_filled(part.data.centers, usage, MemoryUse::curves);
        part.looks = ring.make_filled(part.data.looks, usage, MemoryUse::curves);
        part.chunks = ring.make_filled(part.data.chunks, usage, MemoryUse::curves);
        if (part.data.has_displacements)
            part.displacements = ring.make_filled(part.data.displacements, usage, MemoryUse::curves);
        part.bind(pipelines);
        part.data.centers = {};
        part.data.looks = {};
        part.data.displacements = {};
    }
}

DeviceCurves::DeviceCurves(DeviceMemory& memory, const Pipelines& pipelines, const CurveLook& wanted_look,
                           uint32_t capacity)
    : look(wanted_look) {
    check_look(look);
    const uint32_t most = std::min(max_growing_points, points_in_a_buffer(memory.device()));
    if (capacity < 2 || capacity > most) fail("The capacity is %u; it must be 2 to %u.", capacity, most);
    DevicePart& part = parts.emplace_back(CurveData(), memory.device().handle());
    growing = std::make_unique<GrowingCurve>(part.data, look, capacity);
    const auto room = [&](size_t count, size_t size) {
        return Buffer(memory, count * size, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                      DeviceMemory::Place::device, MemoryUse::curves);
    };
    part.centers = room(part.data.centers.capacity(), sizeof part.data.centers[0]);
    part.looks = room(part.data.looks.capacity(), sizeof part.data.looks[0]);
    part.chunks = room(part.data.chunks.capacity(), sizeof part.data.chunks[0]);
    part.bind(pipelines);
}

DevicePart::DevicePart(DevicePart&& other) noexcept
    : data(std::move(other.data)),
      device(other.device),
      centers(std::move(other.centers)),
      looks(std::move(other.looks)),
      chunks(std::move(other.chunks)),
      displacements(std::move(other.displacements)),
      pool(std::exchange(other.pool, VK_NULL_HANDLE)),
      set(other.set) {}

DevicePart::~DevicePart() {
    vkDestroyDescriptorPool(device, pool, nullptr);
}

void DevicePart::bind(const Pipelines& pipelines) {
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

void DeviceCurves::add_targets(UploadTargets& targets) const {
    for (const DevicePart& part : parts)
        for (const Buffer* buffer : {&part.centers, &part.looks, &part.chunks, &part.displacements})
            targets.buffers.push_back(buffer->handle());
}

Box DeviceCurves::box() const {
    Box box;
    for (const DevicePart& part : parts) box.add(part.data.box_at(magnitude_offset));
    return box;
}

void CurveStore::set_magnitude_offset(CurvesId id, float offset) {
    DeviceCurves& curves = at(id.value);
    if (!curves.has_displacements())
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
            const DevicePart& part = curves->parts.front();
            rewrite(part.centers, part.data.centers, changes.first_point, changes.point_count);
            rewrite(part.looks, part.data.looks, changes.first_point, changes.point_count);
            rewrite(part.chunks, part.data.chunks, changes.first_chunk, changes.chunk_count);
        });
        curves->growing->changes_uploaded();
    }
}

Box CurveStore::bounds() const {
    Box box;
    for (const auto& [id, curves] : items())
        if (curves->visible) box.add(curves->box());
    return box;
}

void CurveStore::select(std::span<const ViewUniforms> views, bool shadow, DrawList& list,
                        std::vector<uint32_t>& instances) const {
    ChunkSelector selector(views);
    for (const auto& [id, curves] : items()) {
        if (!curves->visible) continue;
        if (shadow && (!curves->look.casts_shadow || curves->look.shape == Shape::line)) continue;
        for (const DevicePart& part : curves->parts) {
            const auto first_bin = static_cast<uint32_t>(list.bins.size());
            selector.select(part.data, curves->look, curves->magnitude_offset, instances, list.bins);
            const auto bin_count = static_cast<uint32_t>(list.bins.size()) - first_bin;
            if (bin_count) list.items.push_back({curves.get(), part.set, first_bin, bin_count});
        }
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
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.layout(), 1, 1, &item.set, 0,
                                nullptr);
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
