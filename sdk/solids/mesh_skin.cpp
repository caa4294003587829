// SPDX-License-Identifier: MIT
#include "solids/mesh_skin.h"

#include <algorithm>
#include <cmath>

#include "runtime/each.h"
#include "solids/curve_joints.h"
#include "solids/limb_names.h"
#include "solids/solid_regions.h"

namespace flg {

namespace {

constexpr uint32_t most_vertices = 1u << 20, most_joints = 65535;
constexpr double size_by_diagonal = 3;  // what thresholds are shares of

// A bone from each joint's parent to it; of one joint alone the bone is the point.
struct Bones {
    explicit Bones(Memory* memory) : segments(memory), ends(memory), parents(memory) {}

    std::pmr::vector<BoneSegment> segments;
    std::pmr::vector<uint32_t> ends, parents;
};

Task<Bones> bones_of(Pace& pace, const BoneTree& tree) {
    Bones bones(pace.memory());
    co_await each(pace, tree.joints.size(), Cost::tens_of_ns, [&](uint32_t j) {
        const BoneJoint& joint = tree.joints[j];
        bones.parents.push_back(joint.parent);
        if (joint.parent == no_joint) return;
        const BoneJoint& parent = tree.joints[joint.parent];
        bones.segments.push_back({parent.at, joint.at, parent.radius, joint.radius, joint.parent, 0});
        bones.ends.push_back(j);
    });
    if (bones.segments.empty()) {
        const BoneJoint& only = tree.joints[0];
        bones.segments.push_back({only.at, only.at, only.radius, only.radius, 0, 0});
        bones.ends.push_back(0);
    }
    co_return bones;
}

// The repaired mesh, as weights are spread over it.
Task<MergedMesh> mesh_to_bind(Pace& pace, const Mesh& mesh) {
    MergedMesh out;
    out.positions = Buffer<Vec3>(mesh.vertex_count(), pace.memory());
    out.triangles = Buffer<TriangleVertices>(mesh.triangle_count(), pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::some_ns,
                  [&](uint32_t v) { std::construct_at(&out.positions[v], mesh.position(v)); });
    double sum = 0;
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        const Triple& corners = mesh.triangles[t];
        out.triangles[t] = corners;
        for (int k = 0; k < 3; ++k) sum += (mesh.position(corners[k]) - mesh.position(corners[(k + 1) % 3])).norm();
    });
    out.spacing = sum / (3.0 * mesh.triangle_count());
    co_return out;
}

struct Binding {
    BoneWeights weights;       // of the repaired mesh
    Buffer<Position> normals;  // likewise
};

// What the host sees: its own vertices and triangles, each with what its welded one has.
Task<void> carry_over(Pace& pace, const MeshSkinRequest& request, const RepairedMesh& repaired, const Binding& bound,
                      HeldSkin& skin) {
    const FlgMeshView& input = request.mesh->view;
    const uint32_t vertices = input.vertex_count, triangles = input.triangle_count;
    Memory* const memory = pace.memory();
    skin.mesh.positions = Buffer<Vec3>(vertices, memory);
    skin.mesh.normals = Buffer<Vec3>(vertices, memory);
    skin.mesh.triangles = Buffer<TriangleVertices>(triangles, memory);
    skin.mesh.parts = Buffer<uint32_t>(vertices, memory);
    skin.mesh.triangle_parts = Buffer<uint32_t>(triangles, memory);
    skin.weights = {Buffer<std::array<uint16_t, 4>>(vertices, memory), Buffer<std::array<float, 4>>(vertices, memory)};
    const auto column_of = [&](FlgAttribute attribute) -> const float* {
        for (const FlgColumn& column : request.mesh->columns)
            if (column.attribute == attribute) return column.data;
        return nullptr;
    };
    const float *const positions = column_of(FLG_ATTRIBUTE_POSITION), *const normals = column_of(FLG_ATTRIBUTE_NORMAL);
    const Buffer<uint32_t>& welded_to = repaired.vertices.of_input;
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
        const uint32_t welded = welded_to.empty() ? v : welded_to[v];
        std::construct_at(&skin.mesh.positions[v], load_vec3(positions + size_t{3} * v));
        Vec3 normal = normals ? load_vec3(normals + size_t{3} * v) : Vec3::Zero();
        if (!(normal.norm() > 0) && welded != no_index) normal = load_vec3(bound.normals[welded].data());
        std::construct_at(&skin.mesh.normals[v], normal.norm() > 0 ? Vec3(normal.normalized()) : request.up);
        if (welded != no_index) {
            skin.weights.joints[v] = bound.weights.joints[welded];
            skin.weights.weights[v] = bound.weights.weights[welded];
        } else {
            // No triangle has it.
            skin.weights.joints[v] = {};
            skin.weights.weights[v] = {1, 0, 0, 0};
        }
        skin.mesh.parts[v] = skin.tree.joints[skin.weights.joints[v][0]].part;
    });
    co_await each(pace, triangles, Cost::some_ns, [&](uint32_t t) {
        TriangleVertices& corners = skin.mesh.triangles[t];
        for (uint32_t k = 0; k < 3; ++k) corners[k] = input.triangles[size_t{3} * t + k];
        const Buffer<uint32_t>& parts = skin.mesh.parts;
        skin.mesh.triangle_parts[t] = parts[corners[1]] == parts[corners[2]] ? parts[corners[1]] : parts[corners[0]];
    });
}

// Bones lie inside of a mesh. One with holes has an inside, a sheet has none.
Task<void> require_inside(Pace& pace, const Mesh& mesh) {
    constexpr double least = 1e-3;  // of the volume, by the area to the power of 1.5: 0.09 for a ball
    const Vec3 from = mesh.position(mesh.triangles[0][0]);
    double volume = 0, area = 0;
    uint32_t border = 0;
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        const Triple& corners = mesh.triangles[t];
        const Vec3 a = mesh.position(corners[0]) - from, b = mesh.position(corners[1]) - from,
                   c = mesh.position(corners[2]) - from;
        volume += a.dot(b.cross(c)) / 6;
        area += (b - a).cross(c - a).norm() / 2;
        for (const uint32_t across : mesh.neighbours[t]) border += across == no_index;
    });
    if (border > 0 && !(std::abs(volume) > least * area * std::sqrt(area)))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.mesh is a sheet: %u of its edges have one triangle, and it encloses next to nothing, so "
                      "bones have no room in it",
                      border);
}

Task<void> find_bones(Pace& pace, const MeshSkinRequest& request, const Mesh& mesh, SolidGrid& grid, HeldSkin& skin) {
    const MeshExtent extent = co_await measure_extent(pace, mesh);
    const double size = size_by_diagonal * std::max((extent.upper - extent.lower).norm(), grid.cell);
    const Buffer<float> depths = co_await solid_depths(pace, grid);
    const double share = size / (request.thresholds.detail > 0 ? static_cast<double>(request.thresholds.detail) : 1);
    const CurveSkeleton curves =
        co_await curve_skeleton(pace, grid, depths, static_cast<double>(request.thresholds.prune) * share);
    skin.tree = co_await curve_joints(pace, curves, grid.frame, request.thresholds, size);
    if (skin.tree.joints.size() > most_joints)
        throw Failure(FLG_ERROR_LIMIT,
                      "a skin has at most %u joints, this one would have %zu: lower desc.thresholds.detail",
                      most_joints, skin.tree.joints.size());
    const bool is_found = request.left.norm() == 0;
    Vec3 left = Vec3::Zero();
    if (grid.frame.is_mirrored) {
        left = grid.frame.axes.col(0);
        if (!is_found && left.dot(request.left) < 0) left = -left;
    } else if (!is_found) {
        left = request.left.normalized();
    }
    NamedLimbs limbs = name_limbs(skin.tree, request.up, left, is_found, pace.memory());
    if (grid.frame.is_mirrored) {
        skin.mirror_normal = left.dot(limbs.left) < 0 ? Vec3(-left) : left;
        skin.mirror_offset = skin.mirror_normal.dot(grid.frame.middle);
    }
    skin.names = std::move(limbs.names);
}

}  // namespace

Task<void> make_mesh_skin(Pace& pace, std::shared_ptr<HeldSkin> skin, std::shared_ptr<MeshSkinRequest> request) {
    RepairedMesh repaired(pace.memory());
    co_await repair_mesh(pace, request->mesh->view, request->repair, repaired);
    const Mesh& mesh = repaired.mesh;
    if (mesh.vertex_count() > most_vertices)
        throw Failure(FLG_ERROR_LIMIT, "desc.mesh has %u vertices, more than the limit of %u", mesh.vertex_count(),
                      most_vertices);
    co_await require_inside(pace, mesh);
    const SolidFrame frame = co_await find_solid_frame(pace, mesh);
    SolidGrid grid = co_await fill_solid(pace, mesh, frame, request->cells);
    co_await join_solid_pieces(pace, grid);
    co_await find_bones(pace, *request, mesh, grid, *skin);

    const Bones bones = co_await bones_of(pace, skin->tree);
    const Buffer<uint32_t> nearest = co_await nearest_bones_within(pace, grid, mesh, bones.segments);
    grid.inside = {};
    co_await pace;
    MergedMesh bound = co_await mesh_to_bind(pace, mesh);
    Binding binding;
    binding.weights = co_await bone_weights(pace, bound, NearestBones{{nearest.data(), nearest.size()}, bones.ends},
                                            BoneRig{bones.segments, bones.parents}, BoneWeightOptions());
    bound.positions = {};
    co_await pace;
    binding.normals = co_await find_vertex_normals(pace, mesh);
    co_await carry_over(pace, *request, repaired, binding, *skin);
    co_await each(pace, skin->mesh.positions.size(), Cost::tens_of_ns, [&](uint32_t v) { skin->show_vertex(v); });
    co_await each(pace, skin->tree.joints.size(), Cost::some_ns, [&](uint32_t j) { skin->show_joint(j); });
}

}  // namespace flg
