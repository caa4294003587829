// SPDX-License-Identifier: MIT
#include "surface_store.h"

namespace flg::render {
namespace {

SurfacePush push_of(const SurfaceData& data, const SurfaceLook& look) {
    const float span = data.field_high - data.field_low;
    SurfacePush push{};
    push.isoline_color = look.isoline_color;
    push.isoline_half_width_px = 0.5f * look.isoline_width_px;
    push.field_low = data.field_low;
    push.colors_per_unit = span != 0.0f ? 1.0f / span : 0.0f;
    push.isolines_per_unit = data.has_field && look.isoline_spacing > 0.0f ? 1.0f / look.isoline_spacing : 0.0f;
    push.flags =
        (data.has_field && look.show_field ? SurfacePush::shows_field : 0) | (look.smooth ? 0 : SurfacePush::is_flat);
    return push;
}

void bind_view(VkCommandBuffer commands, const SurfacePipelines& pipelines, VkDescriptorSet view) {
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.layout(), 0, 1, &view, 0, nullptr);
}

void bind_vertices(VkCommandBuffer commands, uint32_t binding, const Buffer& buffer) {
    const VkBuffer handle = buffer.handle();
    const VkDeviceSize no_offset = 0;
    vkCmdBindVertexBuffers(commands, binding, 1, &handle, &no_offset);
}

void draw_triangles(VkCommandBuffer commands, const DeviceSurface& surface, SurfaceDraws& draws) {
    vkCmdBindIndexBuffer(commands, surface.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, surface.index_count, 1, 0, 0, 0);
    draws.triangles += surface.index_count / 3;
    ++draws.calls;
}

}  // namespace

DeviceSurface::DeviceSurface(UploadRing& ring, const FlgMeshView& mesh, const SurfaceLook& look,
                             std::span<const float> field)
    : casts_shadow(look.casts_shadow) {
    const SurfaceData data = prepare_surface(mesh, look, field);
    push = push_of(data, look);
    box = data.box;
    index_count = static_cast<uint32_t>(data.indices.size());
    border_count = static_cast<uint32_t>(data.borders.size());
    positions = ring.make_filled(data.positions, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    vertices = ring.make_filled(data.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    indices = ring.make_filled(data.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    borders = ring.make_filled(data.borders, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
}

Box SurfaceStore::bounds() const {
    Box box;
    for (const auto& [id, surface] : items()) box.add(surface->box);
    return box;
}

SurfaceDraws record_surfaces(VkCommandBuffer commands, const SurfacePipelines& pipelines, VkDescriptorSet view,
                             const SurfaceStore& store) {
    SurfaceDraws draws;
    if (store.items().empty()) return draws;
    bind_view(commands, pipelines, view);
    for (const auto& [id, surface] : store.items()) {
        vkCmdPushConstants(commands, pipelines.layout(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                           sizeof surface->push, &surface->push);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.surface());
        bind_vertices(commands, 0, surface->positions);
        bind_vertices(commands, 1, surface->vertices);
        draw_triangles(commands, *surface, draws);
        if (surface->border_count == 0) continue;
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.border());
        bind_vertices(commands, 0, surface->borders);
        vkCmdDraw(commands, border_vertices, surface->border_count, 0, 0);
        draws.triangles += uint64_t{border_vertices / 3} * surface->border_count;
        ++draws.calls;
    }
    return draws;
}

SurfaceDraws record_surface_shadows(VkCommandBuffer commands, const SurfacePipelines& pipelines, VkDescriptorSet view,
                                    const SurfaceStore& store) {
    SurfaceDraws draws;
    if (store.items().empty()) return draws;
    bind_view(commands, pipelines, view);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.shadow());
    for (const auto& [id, surface] : store.items()) {
        if (!surface->casts_shadow) continue;
        bind_vertices(commands, 0, surface->positions);
        draw_triangles(commands, *surface, draws);
    }
    return draws;
}

}  // namespace flg::render
