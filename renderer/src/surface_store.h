// SPDX-License-Identifier: MIT
// Uploaded surfaces on the device; and drawing them.
#pragma once

#include "device_store.h"
#include "filigree_renderer/placement.h"
#include "skin_data.h"
#include "surface_data.h"
#include "surface_pipelines.h"
#include "surface_textures.h"
#include "upload_ring.h"

namespace flg::render {

// What a surface that follows joints has besides. The pose stays on the host: each frame takes it along.
struct DeviceSkin {
    Buffer vertices;
    SkinBounds bounds;
    uint32_t joint_count;
    FlgSkinning skinning;
    std::vector<float> transforms;
};

// Where surfaces are made.
struct SurfacePlace {
    DeviceMemory& memory;
    UploadRing& ring;
    VkDescriptorSetLayout texture_layout;
};

// One upload.
struct DeviceSurface {
    DeviceSurface(const SurfacePlace& place, const FlgMeshView& mesh, const SurfaceLook& look,
                  std::span<const float> field);
    DeviceSurface(const SurfacePlace& place, const SurfaceData& data, const SurfaceLook& look);
    // At rest.
    DeviceSurface(const SurfacePlace& place, const FlgSkinView& skin, const SurfaceLook& look);

    bool casts_shadow;
    bool visible = true;
    SurfacePush push;
    Box box;  // of its own space
    Placement placement;
    uint32_t index_count;
    uint32_t border_count;
    Buffer positions, vertices, indices, borders;
    std::unique_ptr<DeviceSkin> skin;  // null: it stays as it is
    // With textures; else null and empty.
    std::unique_ptr<SurfaceTextures> textures;
    Buffer uvs;
    std::vector<SurfaceData::Run> runs;

    void place(const Placement& at);

    void add_targets(UploadTargets& targets) const;

private:
    void fill(const SurfacePlace& to, const SurfaceData& data, const SurfaceLook& look);
};

class SurfaceStore : public DeviceStore<DeviceSurface> {
public:
    explicit SurfaceStore(UploadRing& ring) : DeviceStore("surfaces", ring) {}
    Box bounds() const;
    void set_pose(SurfaceId id, FlgSkinning skinning, std::span<const float> transforms);
    // All joints of all skins, as they lie in the shaders' buffer.
    void gather_joints(std::vector<float>& joints);
};

struct SurfaceDraws {
    uint64_t triangles = 0;
    uint32_t calls = 0;
};

// What a pass binds.
struct SurfaceSets {
    VkDescriptorSet view;
    VkDescriptorSet joints;  // null without skins
    Eyes eyes = Eyes::one;
};

// Record all of them into a render pass.
SurfaceDraws record_surfaces(VkCommandBuffer commands, const SurfacePipelines& pipelines, const SurfaceSets& sets,
                             const SurfaceStore& store);
// The lines between regions, over a picture that is done otherwise.
SurfaceDraws record_borders(VkCommandBuffer commands, const SurfacePipelines& pipelines, const SurfaceSets& sets,
                            const SurfaceStore& store);
SurfaceDraws record_surface_shadows(VkCommandBuffer commands, const SurfacePipelines& pipelines,
                                    const SurfaceSets& sets, const SurfaceStore& store);

}  // namespace flg::render
