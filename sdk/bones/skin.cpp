// SPDX-License-Identifier: MIT
#include "bones/skin.h"

#include <deque>

#include "bones/bone_segments.h"
#include "bones/part_body.h"

namespace flg {
namespace {

constexpr uint32_t batch = 32;

static_assert(sizeof(std::array<uint16_t, 4>) == 4 * sizeof(uint16_t));
static_assert(sizeof(std::array<float, 4>) == 4 * sizeof(float));

// Bodies of all parts, those that are there more than once only once.
Task<void> inflate_parts(Pace& pace, const HeldModel& model, std::pmr::deque<PartBody>& bodies,
                         std::pmr::vector<PlacedPart>& placed) {
    std::pmr::vector<const HeldPart*> done(pace.memory());
    for (const ModelPart& part : model.parts) {
        size_t body = std::find(done.begin(), done.end(), part.part.get()) - done.begin();
        if (body == done.size()) {
            done.push_back(part.part.get());
            bodies.emplace_back(pace.memory());
            co_await inflate(pace, *part.part, InflationOptions(), bodies.back());
        }
        PlacedPart out;
        out.part = &bodies[body].inflated;
        out.thickness = part.thickness;
        Eigen::Matrix<double, 3, 4> placement = part.placement;
        placement.col(3) = part.place(bodies[body].origin);
        placement.leftCols<3>() *= bodies[body].scale;
        for (int i = 0; i < 12; ++i) out.placement[i] = placement(i / 4, i % 4);
        placed.push_back(out);
    }
}

}  // namespace

void HeldSkin::show_vertex(size_t vertex) {
    for (int i = 0; i < 3; ++i) {
        columns_.positions.push_back(static_cast<float>(mesh.positions[vertex][i]));
        columns_.normals.push_back(static_cast<float>(mesh.normals[vertex][i]));
    }
}

void HeldSkin::show() noexcept {
    const FlgModelView& bones = model->view();
    view_ = {.struct_size = sizeof view_,
             .vertex_count = static_cast<uint32_t>(mesh.positions.size()),
             .triangle_count = static_cast<uint32_t>(mesh.triangles.size()),
             .joint_count = bones.joint_count,
             .positions = columns_.positions.data(),
             .normals = columns_.normals.data(),
             .triangles = mesh.triangles.data()->data(),
             .vertex_joints = weights.joints.data()->data(),
             .vertex_weights = weights.weights.data()->data(),
             .vertex_parts = mesh.parts.data(),
             .joint_positions = bones.joint_positions,
             .joint_parents = bones.joint_parents,
             .joint_names = bones.joint_names};
}

Task<void> make_skin(Pace& pace, std::shared_ptr<HeldSkin> skin) {
    const HeldModel& model = *skin->model;
    std::pmr::deque<PartBody> bodies(pace.memory());
    std::pmr::vector<PlacedPart> placed(pace.memory());
    co_await inflate_parts(pace, model, bodies, placed);
    co_await merge_parts(pace, placed, skin->options, skin->mesh);
    const std::pmr::vector<BoneSegment> bones = bone_segments(model.tree, model.part_joints, pace.memory());
    co_await weigh_bones(pace, skin->mesh, bones, BoneWeightOptions(), skin->weights);
    for (size_t v = 0; v < skin->mesh.positions.size(); ++v) {
        skin->show_vertex(v);
        if (v % batch == 0) co_await pace;
    }
}

}  // namespace flg
