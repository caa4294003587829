// SPDX-License-Identifier: MIT
// Bodies of parts, and skins: made, shown, released.
#include <algorithm>
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/mesh_inputs.h"
#include "api/thresholds.h"
#include "bones/part_body.h"
#include "solids/mesh_skin.h"

namespace flg {

namespace {

constexpr uint32_t fewest_cells = 1000, most_cells = 1u << 24, most_vertices = 1u << 20;
constexpr uint32_t fewest_vertices = 100, largest_limit = 1u << 22;

FlgPartMeshDesc default_part_mesh_desc() {
    auto desc = sized<FlgPartMeshDesc>();
    desc.thickness = 1;
    return desc;
}

FlgSkinDesc default_skin_desc() {
    auto desc = sized<FlgSkinDesc>();
    desc.vertex_count = 10000;
    desc.max_vertices = 200000;
    desc.blend = -1;
    return desc;
}

FlgSkinFromMeshDesc default_mesh_skin_desc() {
    auto desc = sized<FlgSkinFromMeshDesc>();
    desc.cell_count = 600000;
    desc.up[1] = 1;
    return desc;
}

Vec3 read_direction(const float (&direction)[3], const char* argument) {
    for (const float value : direction)
        check_range(is_coordinate(value), argument, value, "finite and at most 1e30 in size");
    return load_vec3(direction);
}

constexpr uint32_t least_vertices = 4;  // of a closed surface
constexpr float weight_error = 0.001f;

// A vertex' weights with sum 1, the largest first; each joint once.
void bind_vertex(const uint16_t* joints, const float* weights, uint32_t vertex, VertexJoints& out_joints,
                 VertexWeights& out_weights) {
    out_joints = {};
    out_weights = {};
    float sum = 0;
    size_t used = 0;
    for (size_t k = 0; k < 4; ++k) {
        if (!(weights[k] >= 0 && weights[k] <= 1))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.vertex_weights[%zu] is %g, must be 0 to 1",
                          4 * size_t{vertex} + k, static_cast<double>(weights[k]));
        sum += weights[k];
        if (weights[k] == 0) continue;
        const size_t same = std::find(out_joints.begin(), out_joints.begin() + used, joints[k]) - out_joints.begin();
        out_joints[same] = joints[k];
        out_weights[same] += weights[k];
        used = std::max(used, same + 1);
    }
    if (!(std::abs(sum - 1) <= weight_error))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.vertex_weights: those of vertex %u sum up to %g, must be 1",
                      vertex, static_cast<double>(sum));
    for (size_t k = 0; k < used; ++k) out_weights[k] /= sum;
    for (size_t k = 1; k < used; ++k)
        for (size_t i = k; i > 0 && out_weights[i] > out_weights[i - 1]; --i) {
            std::swap(out_weights[i], out_weights[i - 1]);
            std::swap(out_joints[i], out_joints[i - 1]);
        }
}
constexpr float half_turn = 3.14159274f;

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgPartMeshDescInit(FlgPartMeshDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_part_mesh_desc());
}

FlgResult flgPartMeshCreate(FlgContext context, const FlgPartMeshDesc* desc, FlgPartMesh* out_mesh, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_mesh, "out_mesh", out_job);
        const FlgPartMeshDesc read = read_struct(desc, default_part_mesh_desc(), "desc");
        check_range(read.thickness >= 0.01f && read.thickness <= 100, "desc.thickness", read.thickness, "0.01 to 100");
        check_range(read.spacing >= 0 && std::isfinite(read.spacing), "desc.spacing", read.spacing,
                    "0, or above and finite");
        const auto out = self.make(self.part_meshes);
        out->part = self.parts.get(read.part.id, "desc.part");
        out->options = {read.thickness, read.spacing};
        Submission submission(self, read.job);
        submission.read(*out->part, "desc.part");
        submission.job().strand.start(make_part_mesh(submission.pace(), out));
        *out_mesh = {submission.commit(self.part_meshes, out, out_job)};
    });
}

FlgResult flgPartMeshViewInit(FlgPartMeshView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgPartMeshGetView(FlgContext context, FlgPartMesh mesh, FlgPartMeshView* out_view) {
    return get_view(out_view, [&] { return get_context(context).part_meshes.get(mesh.id, "mesh"); });
}

FlgResult flgPartMeshRelease(FlgContext context, FlgPartMesh mesh) {
    return release(context, &Context::part_meshes, mesh, "mesh");
}

FlgResult flgSkinDescInit(FlgSkinDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_skin_desc());
}

FlgResult flgSkinCreate(FlgContext context, const FlgSkinDesc* desc, FlgSkin* out_skin, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_skin, "out_skin", out_job);
        const FlgSkinDesc read = read_struct(desc, default_skin_desc(), "desc");
        check_range(read.max_vertices >= fewest_vertices && read.max_vertices <= largest_limit, "desc.max_vertices",
                    read.max_vertices, "100 to 4194304");
        check_range(read.vertex_count >= fewest_vertices && read.vertex_count <= read.max_vertices, "desc.vertex_count",
                    read.vertex_count, "100 to max_vertices");
        check_range(is_coordinate(read.blend), "desc.blend", read.blend, "finite and at most 1e30 in size");
        check_range(read.corner_angle >= 0 && read.corner_angle <= half_turn, "desc.corner_angle", read.corner_angle,
                    "0 to pi");
        const auto out = self.make(self.skins);
        out->model = self.models.get(read.model.id, "desc.model");
        out->options.vertices = read.vertex_count;
        out->options.max_vertices = read.max_vertices;
        out->options.blend = read.blend;
        out->options.corner_angle = static_cast<double>(read.corner_angle);
        Submission submission(self, read.job);
        submission.read(*out->model, "desc.model");
        submission.job().strand.start(make_skin(submission.pace(), out));
        *out_skin = {submission.commit(self.skins, out, out_job)};
    });
}

FlgResult flgSkinFromMeshDescInit(FlgSkinFromMeshDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_mesh_skin_desc());
}

FlgResult flgSkinCreateFromMesh(FlgContext context, const FlgSkinFromMeshDesc* desc, FlgSkin* out_skin,
                                FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_skin, "out_skin", out_job);
        const FlgSkinFromMeshDesc read = read_struct(desc, default_mesh_skin_desc(), "desc");
        check_range(read.cell_count >= fewest_cells && read.cell_count <= most_cells, "desc.cell_count",
                    read.cell_count, "1000 to 16777216");
        check_range(std::isfinite(read.weld_distance), "desc.weld_distance", read.weld_distance, "finite");
        const FlgMeshView mesh = read_struct(read.mesh, sized<FlgMeshView>(), "desc.mesh");
        if (mesh.vertex_count > most_vertices)
            throw Failure(FLG_ERROR_LIMIT, "desc.mesh.vertex_count is %u, more than the limit of %u", mesh.vertex_count,
                          most_vertices);
        Memory* const memory = self.memory[MemoryKind::models];
        const auto request = make_object<MeshSkinRequest>(memory);
        request->cells = read.cell_count;
        request->thresholds = read_thresholds(read.thresholds, default_thresholds(), "desc.thresholds");
        request->up = read_direction(read.up, "desc.up");
        if (!(request->up.norm() > 0)) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.up has no length");
        request->up.normalize();
        request->left = read_direction(read.left, "desc.left");
        if (read.weld_distance >= 0) request->repair.weld_distance = read.weld_distance;
        Submission submission(self, read.job);
        request->mesh = copy_described_mesh(memory, mesh);
        const auto out = self.make(self.skins);
        out->origin = read_origin(mesh.origin, "desc.mesh.origin");
        submission.job().strand.start(make_mesh_skin(submission.pace(), out, request));
        *out_skin = {submission.commit(self.skins, out, out_job)};
    });
}

FlgResult flgSkinSimplifyDescInit(FlgSkinSimplifyDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgSkinSimplifyDesc>());
}

FlgResult flgSkinSimplify(FlgContext context, const FlgSkinSimplifyDesc* desc, FlgSkin* out_skin, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_skin, "out_skin", out_job);
        const FlgSkinSimplifyDesc read = read_struct(desc, sized<FlgSkinSimplifyDesc>(), "desc");
        check_range(read.vertex_count >= least_vertices, "desc.vertex_count", read.vertex_count, "at least 4");
        const std::shared_ptr<const HeldSkin> source = self.skins.get(read.skin.id, "desc.skin");
        if (!source->model)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.skin was made of a mesh; skins of models have levels");
        const auto out = self.make(self.skins);
        out->model = source->model;
        out->options.vertices = read.vertex_count;
        Submission submission(self, read.job);
        submission.read(*source, "desc.skin");
        submission.job().strand.start(make_simpler_skin(submission.pace(), source, out));
        *out_skin = {submission.commit(self.skins, out, out_job)};
    });
}

FlgResult flgSkinSetWeightsDescInit(FlgSkinSetWeightsDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgSkinSetWeightsDesc>());
}

FlgResult flgSkinSetWeights(FlgContext context, const FlgSkinSetWeightsDesc* desc, FlgSkin* out_skin, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_skin, "out_skin", out_job);
        const FlgSkinSetWeightsDesc read = read_struct(desc, sized<FlgSkinSetWeightsDesc>(), "desc");
        check_range(read.vertex_count >= 1 && read.vertex_count <= largest_limit, "desc.vertex_count",
                    read.vertex_count, "1 to 4194304");
        require(read.vertex_joints, "desc.vertex_joints");
        require(read.vertex_weights, "desc.vertex_weights");
        const std::shared_ptr<const HeldSkin> source = self.skins.get(read.skin.id, "desc.skin");
        const auto out = self.make(self.skins);
        out->model = source->model;
        out->options = source->options;
        Submission submission(self, read.job);
        submission.read(*source, "desc.skin");
        Memory* const memory = self.memory[MemoryKind::models];
        out->weights.joints = Buffer<VertexJoints>(read.vertex_count, memory);
        out->weights.weights = Buffer<VertexWeights>(read.vertex_count, memory);
        for (uint32_t v = 0; v < read.vertex_count; ++v)
            bind_vertex(read.vertex_joints + 4 * size_t{v}, read.vertex_weights + 4 * size_t{v}, v,
                        out->weights.joints[v], out->weights.weights[v]);
        submission.job().strand.start(make_bound_skin(submission.pace(), source, out));
        *out_skin = {submission.commit(self.skins, out, out_job)};
    });
}

FlgResult flgSkinGetView(FlgContext context, FlgSkin skin, FlgSkinView* out_view) {
    return get_view(out_view, [&] { return get_context(context).skins.get(skin.id, "skin"); });
}

FlgResult flgSkinRelease(FlgContext context, FlgSkin skin) {
    return release(context, &Context::skins, skin, "skin");
}

}  // extern "C"
