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

// Binds what skinned surfaces take; returns whether there are any.
bool bind_skins(VkCommandBuffer commands, const SurfacePipelines& pipelines, const SurfaceSets& sets) {
    if (!sets.joints) return false;
    const VkDescriptorSet both[] = {sets.view, sets.joints};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.skinned_layout(), 0, 2, both, 0,
                            nullptr);
    return true;
}

void bind_surface(VkCommandBuffer commands, const SurfacePipelines& pipelines, const SurfaceSets& sets) {
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.layout(), 0, 1, &sets.view, 0,
                            nullptr);
}

// A run of triangles after the other, each with its texture.
void draw_runs(VkCommandBuffer commands, const SurfacePipelines& pipelines, const DeviceSurface& surface,
               SurfaceDraws& draws) {
    bind_vertices(commands, textured_binding, surface.uvs);
    vkCmdBindIndexBuffer(commands, surface.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    uint32_t first = 0;
    for (const SurfaceData::Run& run : surface.runs) {
        const VkDescriptorSet set = surface.textures->set_of(run.texture);
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.textured_layout(), texture_set, 1,
                                &set, 0, nullptr);
        vkCmdDrawIndexed(commands, run.index_count, 1, first, 0, 0);
        first += run.index_count;
        ++draws.calls;
    }
    draws.triangles += surface.index_count / 3;
}

constexpr VkShaderStageFlags both_stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

void push_surface(VkCommandBuffer commands, VkPipelineLayout layout, const DeviceSurface& surface) {
    vkCmdPushConstants(commands, layout, both_stages, 0, sizeof surface.push, &surface.push);
}

void record_textured(VkCommandBuffer commands, const SurfacePipelines& pipelines, const SurfaceSets& sets,
                     const SurfaceStore& store, SurfaceDraws& draws) {
    bool is_bound = false;
    for (const auto& [id, surface] : store.items()) {
        if (!surface->visible || !surface->textures || (surface->skin && !sets.joints)) continue;
        if (!is_bound) {
            const VkDescriptorSet both[] = {sets.view, sets.joints};
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.textured_layout(), 0,
                                    sets.joints ? 2 : 1, both, 0, nullptr);
            is_bound = true;
        }
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                          surface->skin ? pipelines.textured_skinned(surface->skin->skinning, sets.eyes)
                                        : pipelines.textured(sets.eyes));
        push_surface(commands, pipelines.textured_layout(), *surface);
        bind_vertices(commands, 0, surface->positions);
        bind_vertices(commands, 1, surface->vertices);
        if (surface->skin) bind_vertices(commands, 2, surface->skin->vertices);
        draw_runs(commands, pipelines, *surface, draws);
    }
}

}  // namespace

DeviceSurface::DeviceSurface(const SurfacePlace& to, const FlgMeshView& mesh, const SurfaceLook& look,
                             std::span<const float> field)
    : DeviceSurface(to, prepare_surface(mesh, look, field), look) {}

DeviceSurface::DeviceSurface(const SurfacePlace& to, const SurfaceData& data, const SurfaceLook& look)
    : casts_shadow(look.casts_shadow) {
    fill(to, data, look);
}

DeviceSurface::DeviceSurface(const SurfacePlace& to, const FlgSkinView& view, const SurfaceLook& look)
    : casts_shadow(look.casts_shadow) {
    SkinData data = prepare_skin(view, look);
    fill(to, data.surface, look);
    std::vector<float> rest;
    for (uint32_t j = 0; j < view.joint_count; ++j) rest.insert(rest.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    Buffer skin_vertices = to.ring.make_filled(data.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::surfaces);
    skin = std::make_unique<DeviceSkin>(DeviceSkin{std::move(skin_vertices), std::move(data.bounds), view.joint_count,
                                                   FLG_SKINNING_LINEAR, std::move(rest)});
}

void DeviceSurface::fill(const SurfacePlace& to, const SurfaceData& data, const SurfaceLook& look) {
    UploadRing& ring = to.ring;
    push = push_of(data, look);
    place(placement);
    box = data.box;
    index_count = static_cast<uint32_t>(data.indices.size());
    border_count = static_cast<uint32_t>(data.borders.size());
    positions = ring.make_filled(data.positions, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::surfaces);
    vertices = ring.make_filled(data.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::surfaces);
    indices = ring.make_filled(data.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, MemoryUse::surfaces);
    borders = ring.make_filled(data.borders, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::surfaces);
    if (data.runs.empty()) return;
    runs = data.runs;
    uvs = ring.make_filled(data.uvs, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::surfaces);
    textures = std::make_unique<SurfaceTextures>(to.memory, ring, to.texture_layout, look.textures);
}

void DeviceSurface::place(const Placement& at) {
    placement = at;
    push.turn = {at.turn.x, at.turn.y, at.turn.z, at.turn.w};
    push.at = glm::vec4(at.at, at.scale);
}

void DeviceSurface::add_targets(UploadTargets& targets) const {
    for (const Buffer* buffer : {&positions, &vertices, &indices, &borders})
        targets.buffers.push_back(buffer->handle());
    if (skin) targets.buffers.push_back(skin->vertices.handle());
    if (!textures) return;
    targets.buffers.push_back(uvs.handle());
    textures->add_targets(targets);
}

Box SurfaceStore::bounds() const {
    Box box;
    for (const auto& [id, surface] : items())
        if (surface->visible) box.add(surface->placement.box(surface->box));
    return box;
}

void SurfaceStore::set_pose(SurfaceId id, FlgSkinning skinning, std::span<const float> transforms) {
    DeviceSurface& surface = at(id.value);
    if (!surface.skin) fail("The surface %llu has no joints.", static_cast<unsigned long long>(id.value));
    DeviceSkin& skin = *surface.skin;
    check_pose(skinning, transforms, skin.joint_count);
    skin.transforms.assign(transforms.begin(), transforms.end());
    skin.skinning = skinning;
    surface.box = skin.bounds.at(skinning, transforms);
}

void SurfaceStore::gather_joints(std::vector<float>& joints) {
    constexpr size_t vector_floats = 4;
    joints.clear();
    for (const auto& [id, surface] : items()) {
        if (!surface->visible || !surface->skin) continue;
        surface->push.first_joint = static_cast<uint32_t>(joints.size() / vector_floats);
        joints.insert(joints.end(), surface->skin->transforms.begin(), surface->skin->transforms.end());
    }
}

SurfaceDraws record_surfaces(VkCommandBuffer commands, const SurfacePipelines& pipelines, const SurfaceSets& sets,
                             const SurfaceStore& store) {
    SurfaceDraws draws;
    if (store.items().empty()) return draws;
    record_textured(commands, pipelines, sets, store, draws);
    bind_surface(commands, pipelines, sets);
    for (const auto& [id, surface] : store.items()) {
        if (!surface->visible || surface->skin || surface->textures) continue;
        push_surface(commands, pipelines.layout(), *surface);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.surface(sets.eyes));
        bind_vertices(commands, 0, surface->positions);
        bind_vertices(commands, 1, surface->vertices);
        draw_triangles(commands, *surface, draws);
    }
    if (!bind_skins(commands, pipelines, sets)) return draws;
    for (const auto& [id, surface] : store.items()) {
        if (!surface->visible || !surface->skin || surface->textures) continue;
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                          pipelines.skinned(surface->skin->skinning, sets.eyes));
        push_surface(commands, pipelines.skinned_layout(), *surface);
        bind_vertices(commands, 0, surface->positions);
        bind_vertices(commands, 1, surface->vertices);
        bind_vertices(commands, 2, surface->skin->vertices);
        draw_triangles(commands, *surface, draws);
    }
    return draws;
}

SurfaceDraws record_borders(VkCommandBuffer commands, const SurfacePipelines& pipelines, const SurfaceSets& sets,
                            const SurfaceStore& store) {
    SurfaceDraws draws;
    for (const auto& [id, surface] : store.items()) {
        if (!surface->visible || surface->border_count == 0) continue;
        if (draws.calls == 0) {
            bind_surface(commands, pipelines, sets);
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.border(sets.eyes));
        }
        bind_vertices(commands, 0, surface->borders);
        vkCmdDraw(commands, border_vertices, surface->border_count, 0, 0);
        draws.triangles += uint64_t{border_vertices / 3} * surface->border_count;
        ++draws.calls;
    }
    return draws;
}

SurfaceDraws record_surface_shadows(VkCommandBuffer commands, const SurfacePipelines& pipelines,
                                    const SurfaceSets& sets, const SurfaceStore& store) {
    SurfaceDraws draws;
    if (store.items().empty()) return draws;
    bind_surface(commands, pipelines, sets);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.shadow());
    for (const auto& [id, surface] : store.items()) {
        if (!surface->visible || !surface->casts_shadow || surface->skin) continue;
        push_surface(commands, pipelines.layout(), *surface);
        bind_vertices(commands, 0, surface->positions);
        draw_triangles(commands, *surface, draws);
    }
    if (!bind_skins(commands, pipelines, sets)) return draws;
    for (const auto& [id, surface] : store.items()) {
        if (!surface->visible || !surface->casts_shadow || !surface->skin) continue;
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.skinned_shadow(surface->skin->skinning));
        push_surface(commands, pipelines.skinned_layout(), *surface);
        bind_vertices(commands, 0, surface->positions);
        bind_vertices(commands, 2, surface->skin->vertices);
        draw_triangles(commands, *surface, draws);
    }
    return draws;
}

}  // namespace flg::render
