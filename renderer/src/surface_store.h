// SPDX-License-Identifier: MIT
// Uploaded surfaces on the device; and drawing them.
#pragma once

#include "device_store.h"
#include "surface_data.h"
#include "surface_pipelines.h"
#include "upload_ring.h"

namespace flg::render {

// One upload.
struct DeviceSurface {
    DeviceSurface(UploadRing& ring, const FlgMeshView& mesh, const SurfaceLook& look, std::span<const float> field);

    bool casts_shadow;
    SurfacePush push;
    Box box;
    uint32_t index_count;
    uint32_t border_count;
    Buffer positions, vertices, indices, borders;
};

class SurfaceStore : public DeviceStore<DeviceSurface> {
public:
    SurfaceStore() : DeviceStore("surfaces") {}
    Box bounds() const;
};

struct SurfaceDraws {
    uint64_t triangles = 0;
    uint32_t calls = 0;
};

// Record all of them into a render pass; `view` is its descriptor set.
SurfaceDraws record_surfaces(VkCommandBuffer commands, const SurfacePipelines& pipelines, VkDescriptorSet view,
                             const SurfaceStore& store);
SurfaceDraws record_surface_shadows(VkCommandBuffer commands, const SurfacePipelines& pipelines, VkDescriptorSet view,
                                    const SurfaceStore& store);

}  // namespace flg::render
