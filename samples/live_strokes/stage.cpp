// SPDX-License-Identifier: MIT
#include "live_strokes/stage.h"

#include <array>
#include <span>

namespace flg::samples {
namespace {

constexpr uint32_t kSides = 48;

struct Turned {
    std::vector<glm::vec3> positions, normals;
    std::vector<uint32_t> triangles;
};

// A profile of (height, radius) turned about an axis: `along` is where heights go. Edges stay sharp.
Turned turned(std::span<const glm::vec2> profile, glm::vec3 along) {
    const glm::vec3 right = glm::normalize(glm::cross(along, glm::vec3(along.y, along.z, along.x)));
    const glm::vec3 back = glm::cross(right, along);
    Turned mesh;
    for (size_t p = 0; p + 1 < profile.size(); ++p) {
        const glm::vec2 step = profile[p + 1] - profile[p];
        const auto first = static_cast<uint32_t>(mesh.positions.size());
        for (uint32_t side = 0; side <= kSides; ++side) {
            const float angle = 6.2831853f * static_cast<float>(side) / static_cast<float>(kSides);
            const glm::vec3 out = std::cos(angle) * right + std::sin(angle) * back;
            for (size_t end = p; end < p + 2; ++end) {
                mesh.positions.push_back(profile[end].x * along + profile[end].y * out);
                mesh.normals.push_back(glm::normalize(step.x * out - step.y * along));
            }
            if (side == kSides) continue;
            const uint32_t a = first + 2 * side;
            mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
        }
    }
    return mesh;
}

// From its tip at the origin to the hand's end.
render::SurfaceId upload_controller(render::Renderer& renderer, glm::vec3 color) {
    const glm::vec2 profile[] = {{0.0f, 0.0f},     {0.004f, 0.004f}, {0.030f, 0.009f}, {0.034f, 0.017f},
                                 {0.120f, 0.015f}, {0.150f, 0.019f}, {0.156f, 0.015f}, {0.157f, 0.0f}};
    const Turned mesh = turned(profile, {0, 0, 1});
    const size_t count = mesh.positions.size();
    std::vector<uint16_t> joints(4 * count, 0);
    std::vector<float> weights(4 * count, 0.0f);
    for (size_t i = 0; i < count; ++i) weights[4 * i] = 1.0f;
    const std::vector<uint32_t> parts(count, 0);
    const float origin[3] = {0, 0, 0};
    const uint32_t root = FLG_NO_INDEX;
    const char* name = "controller";
    FlgSkinView skin = {};
    skin.struct_size = sizeof skin;
    skin.vertex_count = static_cast<uint32_t>(count);
    skin.triangle_count = static_cast<uint32_t>(mesh.triangles.size() / 3);
    skin.joint_count = 1;
    skin.positions = &mesh.positions[0].x;
    skin.normals = &mesh.normals[0].x;
    skin.triangles = mesh.triangles.data();
    skin.vertex_joints = joints.data();
    skin.vertex_weights = weights.data();
    skin.vertex_parts = parts.data();
    skin.joint_positions = origin;
    skin.joint_parents = &root;
    skin.joint_names = &name;
    render::SurfaceLook look;
    look.material = {.color = color, .metallic = 0.1f, .roughness = 0.35f};
    return renderer.upload(skin, look);
}

void upload_floor(render::Renderer& renderer) {
    const glm::vec2 profile[] = {{-0.02f, 1.3f}, {0.0f, 1.28f}, {0.0f, 0.0f}};
    const Turned mesh = turned(profile, {0, 1, 0});
    std::vector<glm::vec3> positions = mesh.positions;
    for (glm::vec3& p : positions) p.z -= 0.35f;
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, &positions[0].x, 0, 0},
                                 {FLG_ATTRIBUTE_NORMAL, 3, &mesh.normals[0].x, 0, 0}};
    FlgMeshView view = {};
    view.struct_size = sizeof view;
    view.vertex_count = static_cast<uint32_t>(positions.size());
    view.triangle_count = static_cast<uint32_t>(mesh.triangles.size() / 3);
    view.columns = columns;
    view.column_count = 2;
    view.triangles = mesh.triangles.data();
    render::SurfaceLook look;
    look.material = {.color = {0.55f, 0.52f, 0.48f}, .roughness = 0.8f};
    renderer.upload(view, look);
}

}  // namespace

Stage::Stage(render::Renderer& renderer) : renderer_(renderer) {
    upload_floor(renderer);
    drawing_ = upload_controller(renderer, {0.06f, 0.06f, 0.07f});
    other_ = upload_controller(renderer, {0.30f, 0.30f, 0.32f});
}

void Stage::place(const XrFrame& frame) {
    const auto pose = [&](render::SurfaceId id, const XrPose& to) {
        const glm::mat3 turn = glm::mat3_cast(to.orientation);
        float rows[12];
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) rows[4 * row + column] = turn[column][row];
            rows[4 * row + 3] = to.position[row];
        }
        renderer_.set_pose(id, FLG_SKINNING_LINEAR, rows);
    };
    pose(drawing_, frame.drawing.pose);
    pose(other_, frame.other.pose);
}

}  // namespace flg::samples
