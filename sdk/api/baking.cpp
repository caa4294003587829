// SPDX-License-Identifier: MIT
// Tangles drawn into maps: the descriptor is checked and copied, maps stay where they are.
#include <cmath>

#include "api/descriptors.h"
#include "api/host_buffers.h"
#include "api/inputs.h"
#include "api/mesh_inputs.h"
#include "api/tangle_change.h"
#include "baking/bake_tangle.h"

namespace flg {

namespace {

constexpr uint32_t max_components = 16;

FlgTangleBakeDesc default_bake_desc() {
    auto desc = sized<FlgTangleBakeDesc>();
    desc.size = 1024;
    desc.mesh_region = FLG_NO_INDEX;
    desc.padding = 16;
    desc.border_width = 0.01f;
    return desc;
}

BakedMaps read_maps(const FlgTangleBakeDesc& desc) {
    const BakedMaps maps = {desc.ids, desc.distances, desc.borders, desc.heights, desc.normals, desc.blends};
    const uint64_t texels = uint64_t{desc.size} * desc.size;
    Blocks blocks;
    bool any = false;
    const auto add = [&](const void* map, uint64_t components, uint32_t number, const char* name) {
        if (!map) return;
        any = true;
        check_aligned(map, number, name);
        const uint64_t bytes = components * number;
        blocks.add_output({BlockName("%s", name), map, bytes, bytes, texels});
    };
    add(maps.ids, 1, sizeof(uint32_t), "desc.ids");
    add(maps.distances, 1, sizeof(float), "desc.distances");
    add(maps.borders, 1, 1, "desc.borders");
    add(maps.heights, 1, sizeof(float), "desc.heights");
    add(maps.normals, 3, sizeof(float), "desc.normals");
    add(maps.blends, desc.component_count, sizeof(float), "desc.blends");
    if (!any) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc: all maps are null, nothing is to be drawn");
    blocks.check_apart();
    return maps;
}

void read_values(const FlgTangleBakeDesc& desc, Memory* memory, BakeRequest& request) {
    if (!desc.blends) return;
    check_range(desc.component_count >= 1 && desc.component_count <= max_components, "desc.component_count",
                desc.component_count, "1 to 16 with blends");
    check_range(desc.region_count >= 1 && desc.region_count <= FLG_REGION_MAX + 1, "desc.region_count",
                desc.region_count, "1 to FLG_REGION_MAX + 1 with blends");
    const float* const values = &require(desc.blend_values, "desc.blend_values");
    const size_t count = size_t{desc.component_count} * desc.region_count;
    request.region_values = Buffer<float>(count, memory);
    for (size_t i = 0; i < count; ++i) {
        if (!is_coordinate(values[i])) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.blend_values[%zu] is %g, must be finite and at most 1e30 in size", i,
                          static_cast<double>(values[i]));
        }
        request.region_values[i] = values[i];
    }
    request.component_count = desc.component_count;
    request.region_count = desc.region_count;
}

void read_bake_mesh(const FlgTangleBakeDesc& desc, Memory* memory, BakeRequest& request) {
    const FlgMeshView mesh = read_struct(desc.mesh, sized<FlgMeshView>(), "desc.mesh");
    check_counts(mesh);
    check_columns(mesh.columns, mesh.column_count, "desc.mesh");
    const FlgColumn* const column = find_column(mesh.columns, mesh.column_count, FLG_ATTRIBUTE_POSITION);
    request.positions = Buffer<Position>(mesh.vertex_count, memory);
    const BadValue bad = copy_column(*column, 0, mesh.vertex_count, request.positions.data()->data());
    if (bad.rule) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.mesh.columns[%td] holds %g at vertex %u, %s",
                      column - mesh.columns, static_cast<double>(bad.value), bad.row, bad.rule);
    }
    const float* const uvs = &require(desc.corner_uvs, "desc.corner_uvs");
    request.corner_uvs = Buffer<float>(6 * size_t{mesh.triangle_count}, memory);
    std::copy_n(uvs, request.corner_uvs.size(), request.corner_uvs.data());
    if (desc.mesh_region == FLG_NO_INDEX) return;
    request.mesh_region = desc.mesh_region;
    request.labels = copy_words(&require(mesh.regions, "desc.mesh.regions"), mesh.triangle_count, memory);
}

BakeRequest read_bake(const FlgTangleBakeDesc& desc, Memory* memory) {
    check_range(desc.size >= 1 && desc.size <= FLG_BAKE_MAX_SIZE, "desc.size", desc.size, "1 to 16384");
    check_range(desc.padding <= FLG_BAKE_MAX_PADDING, "desc.padding", desc.padding, "0 to 256");
    check_range(desc.border_width >= 0 && is_coordinate(desc.border_width), "desc.border_width", desc.border_width,
                "finite and 0 or above");
    BakeRequest request;
    request.size = desc.size;
    request.padding = desc.padding;
    request.border_width = desc.border_width;
    read_values(desc, memory, request);
    request.maps = read_maps(desc);
    read_bake_mesh(desc, memory, request);
    return request;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgTangleBakeDescInit(FlgTangleBakeDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_bake_desc());
}

FlgResult flgTangleBake(FlgContext context, const FlgTangleBakeDesc* desc, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgTangleBakeDesc read = read_struct(desc, default_bake_desc(), "desc");
        const auto tangle = self.tangles.get(read.tangle.id, "desc.tangle");
        BakeRequest request = read_bake(read, self.memory[MemoryKind::scratch]);
        Submission submission(self, read.job);
        submission.read(*tangle, "desc.tangle");
        refuse_changed_surface(*tangle, "desc.tangle");
        submission.read_surface(tangle->surface, "the surface of desc.tangle");
        submission.job().strand.start(bake_tangle(submission.pace(), tangle, std::move(request)));
        submission.commit(nullptr, MemoryKind::scratch, out_job);
    });
}

}  // extern "C"
