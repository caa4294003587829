// SPDX-License-Identifier: MIT
#include "io/base/checked_views.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "io/base/checks.h"
#include "io/base/entry_point.h"
#include "io/base/failure.h"
#include "io/base/json_text.h"
#include "io/base/limits.h"
#include "io/base/mesh_data.h"
#include "io/base/pictures.h"
#include "io/base/skin_data.h"

namespace flg::io {

namespace {

constexpr uint32_t max_columns = 16;
constexpr uint32_t max_components = 16;

struct ColumnRule {
    FlgAttribute attribute;
    uint32_t components;
};
constexpr ColumnRule rules[] = {
    {FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_RADIUS, 1},       {FLG_ATTRIBUTE_COLOR, 4},
    {FLG_ATTRIBUTE_TANGENT, 3},  {FLG_ATTRIBUTE_NORMAL, 3},       {FLG_ATTRIBUTE_TIME, 1},
    {FLG_ATTRIBUTE_PRESSURE, 1}, {FLG_ATTRIBUTE_ORIENTATION, 4},  {FLG_ATTRIBUTE_STYLE_INDEX, 1},
    {FLG_ATTRIBUTE_RADII, 3},    {FLG_ATTRIBUTE_ANGLE, 1},        {FLG_ATTRIBUTE_WIDTH, 1},
    {FLG_ATTRIBUTE_SPEED, 1},    {FLG_ATTRIBUTE_DISPLACEMENT, 3}, {FLG_ATTRIBUTE_UV, 2},
};

}  // namespace

Column resolved(const FlgColumn& column) {
    return {column.data, column.stride == 0 ? column.components * sizeof(float) : column.stride};
}

Vector<float> packed(const Column& column, size_t point_count, uint32_t components) {
    Vector<float> values;
    values.reserve(point_count * components);
    for (size_t i = 0; i < point_count; ++i) values.insert(values.end(), column.at(i), column.at(i) + components);
    return values;
}

CheckedColumns::CheckedColumns(const FlgColumn* columns, uint32_t count, size_t point_count)
    : columns_(columns), count_(count) {
    if (count < 1 || count > max_columns) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.column_count", "is %u, must be 1 to %u", count, max_columns);
    }
    if (!columns) fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns", "is null");
    for (uint32_t i = 0; i < count; ++i) check(i, point_count);
    if (!find(FLG_ATTRIBUTE_POSITION)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns", "has no FLG_ATTRIBUTE_POSITION");
    }
}

Column CheckedColumns::find(FlgAttribute attribute) const {
    for (uint32_t i = 0; i < count_; ++i) {
        if (columns_[i].attribute == attribute) return resolved(columns_[i]);
    }
    return {};
}

void CheckedColumns::check(uint32_t index, size_t point_count) const {
    const FlgColumn& column = columns_[index];
    const String place = "view.columns[" + to_text(index) + "]";
    for (uint32_t i = 0; i < index; ++i) {
        if (columns_[i].attribute == column.attribute) {
            fail(FLG_ERROR_INVALID_ARGUMENT, place, "has the same attribute (%d) as column %u", column.attribute, i);
        }
    }
    const auto rule = std::find_if(std::begin(rules), std::end(rules),
                                   [&](const ColumnRule& r) { return r.attribute == column.attribute; });
    if (rule == std::end(rules) && column.attribute < FLG_ATTRIBUTE_USER) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".attribute", "is %d, no attribute known", column.attribute);
    }
    const bool fits = rule == std::end(rules) ? column.components >= 1 && column.components <= max_components
                                              : column.components == rule->components;
    if (!fits) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".components", "is %u, which does not fit attribute %d",
             column.components, column.attribute);
    }
    if (!column.data) fail(FLG_ERROR_INVALID_ARGUMENT, place + ".data", "is null");
    if (column.stride % sizeof(float) != 0 ||
        (column.stride != 0 && column.stride < column.components * sizeof(float))) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".stride", "is %u, must be a multiple of 4 and at least %zu",
             column.stride, column.components * sizeof(float));
    }
    const Column values = resolved(column);
    const bool is_length = column.attribute == FLG_ATTRIBUTE_POSITION || column.attribute == FLG_ATTRIBUTE_RADIUS;
    for (size_t point = 0; point < point_count; ++point) {
        for (uint32_t i = 0; i < column.components; ++i) {
            const float value = values.at(point)[i];
            if (!std::isfinite(value) || (is_length && std::abs(value) > max_coordinate)) {
                fail(FLG_ERROR_INVALID_ARGUMENT, place + ".data", "has %g at point %zu: must be finite%s",
                     double{value}, point, is_length ? " and at most 1e30 in size" : "");
            }
            if (column.attribute == FLG_ATTRIBUTE_RADIUS && value < 0) {
                fail(FLG_ERROR_INVALID_ARGUMENT, place + ".data", "has the radius %g at point %zu: must be >= 0",
                     double{value}, point);
            }
        }
    }
}

void check_origin(const double (&origin)[3], const char* name) {
    for (size_t k = 0; k < 3; ++k) {
        if (std::abs(origin[k]) <= double{max_coordinate}) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, String(name) + "[" + to_text(k) + "]",
             "is %g, must be finite and at most 1e30 in size", origin[k]);
    }
}

CheckedView::CheckedView(const FlgCurveSetView* view) {
    view_ = read_given(view, "view");
    check_origin(view_.origin, "view.origin");
    check_curves();
    const CheckedColumns columns(view_.columns, view_.column_count, point_count());
    if (columns.find(FLG_ATTRIBUTE_UV))
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns", "has FLG_ATTRIBUTE_UV, which is of meshes");
    position = columns.find(FLG_ATTRIBUTE_POSITION);
    radius = columns.find(FLG_ATTRIBUTE_RADIUS);
    color = columns.find(FLG_ATTRIBUTE_COLOR);
    normal = columns.find(FLG_ATTRIBUTE_NORMAL);
}

void CheckedView::check_curves() const {
    if (view_.curve_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_count", "is 0: there is nothing to write");
    if (!view_.curve_offsets) fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets", "is null");
    if (view_.curve_offsets[0] != 0) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets[0]", "is %u, must be 0", view_.curve_offsets[0]);
    }
    for (uint32_t c = 0; c < view_.curve_count; ++c) {
        if (view_.curve_offsets[c + 1] <= view_.curve_offsets[c]) {
            fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets[" + to_text(c + 1) + "]",
                 "is %u, not above %u: every curve needs a point", view_.curve_offsets[c + 1], view_.curve_offsets[c]);
        }
    }
    if (point_count() > max_points) {
        fail(FLG_ERROR_LIMIT, "view", "has %zu points, more than the limit of 2^31", point_count());
    }
}

FlgMeshMaterial material_defaults() {
    auto material = sized<FlgMeshMaterial>();
    material.texture = FLG_NO_INDEX;
    material.color[0] = material.color[1] = material.color[2] = 1;
    material.roughness = 0.6f;
    return material;
}

namespace {

// Refuses what no material can be; `place` names it, and ends with a dot.
void check_material(const FlgMeshMaterial& material, const String& place) {
    constexpr size_t max_name = 255;
    constexpr float widest_border_px = 64;
    const auto check_in = [&](float value, float most, const char* member) {
        if (value >= 0 && value <= most) return;
        fail(FLG_ERROR_INVALID_ARGUMENT, place + member, "is %g, must be from 0 to %g", double{value}, double{most});
    };
    if (material.name && (strnlen(material.name, max_name + 1) > max_name || !is_utf8(material.name))) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + "name", "must be UTF-8 of at most 255 bytes");
    }
    for (const float value : material.color) check_in(value, 1, "color");
    check_in(material.metallic, 1, "metallic");
    check_in(material.roughness, 1, "roughness");
    for (const float value : material.border_color) check_in(value, 1, "border_color");
    check_in(material.border_width_px, widest_border_px, "border_width_px");
}

Vector<FlgMeshMaterial> read_materials(const FlgMeshMaterial* given, uint32_t count) {
    Vector<FlgMeshMaterial> materials;
    if (count != 0) check_argument(given, "desc.materials");
    for (uint32_t i = 0; i < count; ++i) {
        const String place = "desc.materials[" + to_text(i) + "]";
        materials.push_back(read_element<Longer::cut>(given, i, material_defaults(), place.c_str()));
        check_material(materials.back(), place + ".");
    }
    return materials;
}

}  // namespace

CheckedMesh::CheckedMesh(const FlgMeshView* view, const FlgMeshFileWriteDesc* desc) {
    view_ = read_given(view, "view");
    if (desc) desc_ = read_given(desc, "desc");
    check_origin(view_.origin, "view.origin");
    const CheckedColumns columns(view_.columns, view_.column_count, view_.vertex_count);
    position = columns.find(FLG_ATTRIBUTE_POSITION);
    color = columns.find(FLG_ATTRIBUTE_COLOR);
    uv = columns.find(FLG_ATTRIBUTE_UV);
    normal = columns.find(FLG_ATTRIBUTE_NORMAL);
    check_triangles();
    if (desc_.face_column_count > max_face_columns) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.face_column_count", "is %u, must be at most %u", desc_.face_column_count,
             max_face_columns);
    }
    if (desc_.face_column_count != 0) check_argument(desc_.face_columns, "desc.face_columns");
    for (uint32_t i = 0; i < desc_.face_column_count; ++i) {
        const String place = "desc.face_columns[" + to_text(i) + "]";
        face_columns_.push_back(
            read_element<Longer::cut>(desc_.face_columns, i, sized<FlgMeshFaceColumn>(), place.c_str()));
        check_face_column(i);
    }
    materials_ = read_materials(desc_.materials, desc_.material_count);
    if (!asset()) {
        if (!materials_.empty() && split_regions()) check_labels();
        return;
    }
    provenance_ = read_given(desc_.provenance, "desc.provenance");
    check_provenance();
}

void CheckedMesh::check_provenance() const {
    const auto check_count = [](const char* name, uint32_t count, uint32_t in_view) {
        if (count != in_view)
            fail(FLG_ERROR_INVALID_ARGUMENT, name, "is %u, but view has %u: it is another surface's", count, in_view);
    };
    check_count("desc.provenance.vertex_count", provenance_->vertex_count, view_.vertex_count);
    check_count("desc.provenance.triangle_count", provenance_->triangle_count, view_.triangle_count);
    check_argument(provenance_->triangles, "desc.provenance.triangles");
    check_argument(provenance_->input_vertices, "desc.provenance.input_vertices");
    check_argument(provenance_->weights, "desc.provenance.weights");
    for (size_t t = 0; t < triangle_count(); ++t) {
        if (provenance_->triangles[t] < provenance_->input_triangle_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.provenance.triangles[" + to_text(t) + "]",
             "is %u, but the input has %u triangles", provenance_->triangles[t], provenance_->input_triangle_count);
    }
}

void CheckedMesh::check_triangles() const {
    if (view_.triangle_count == 0) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.triangle_count", "is 0: there is nothing to write");
    }
    check_argument(view_.triangles, "view.triangles");
    // Signed indices in .ply; .glb keeps the last value of 32 bits for itself.
    if (view_.vertex_count > static_cast<uint32_t>(INT32_MAX)) {
        fail(FLG_ERROR_LIMIT, "view.vertex_count", "is %u, more than the limit of 2^31 - 1", view_.vertex_count);
    }
    const size_t corner_count = 3 * triangle_count();
    for (size_t i = 0; i < corner_count; ++i) {
        if (view_.triangles[i] < view_.vertex_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.triangles[" + to_text(i) + "]", "is %u, but there are %u vertices",
             view_.triangles[i], view_.vertex_count);
    }
}

void CheckedMesh::check_face_column(uint32_t index) const {
    constexpr size_t max_name = 63;
    const String place = "desc.face_columns[" + to_text(index) + "]";
    const FlgMeshFaceColumn& column = face_columns_[index];
    check_argument(column.name, (place + ".name").c_str());
    check_argument(column.values, (place + ".values").c_str());
    const std::string_view name(column.name, strnlen(column.name, max_name + 1));
    const bool sound = !name.empty() && name.size() <= max_name && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!sound || name == "region" || name == "vertex_indices") {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".name", "is %s, which is no name for a face column",
             cited(name).c_str());
    }
    for (uint32_t i = 0; i < index; ++i) {
        if (name != face_columns_[i].name) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".name", "is %s, as that of column %u", cited(name).c_str(), i);
    }
}

void CheckedMesh::check_labels() const {
    for (size_t t = 0; t < triangle_count(); ++t) {
        if (region(t) < desc_.material_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.regions[" + to_text(t) + "]", "is %u, but there are %u materials",
             region(t), desc_.material_count);
    }
}

namespace {

constexpr double length_tolerance = 1e-3;
constexpr double sum_tolerance = 1e-4;
constexpr uint32_t max_parts = 1u << 24;  // floats tell them apart
constexpr uint32_t max_levels = 16;

}  // namespace

namespace {

// Those that VRM 1.0 asks for.
constexpr const char* vrm_bones_needed[] = {"hips",          "spine",         "head",          "leftUpperLeg",
                                            "leftLowerLeg",  "leftFoot",      "rightUpperLeg", "rightLowerLeg",
                                            "rightFoot",     "leftUpperArm",  "leftLowerArm",  "leftHand",
                                            "rightUpperArm", "rightLowerArm", "rightHand"};

}  // namespace

CheckedSkin::CheckedSkin(const FlgSkinFileWriteDesc* desc) {
    desc_ = read_given(desc, "desc");
    meshes_.push_back(read_given(desc_.skin, "desc.skin"));
    check_origin(skin().origin, "desc.skin.origin");
    check_name(desc_.name, "desc.name");
    check_joints();
    check_mesh(skin(), "desc.skin");
    check_levels();
    check_textures();
    check_colors();
    if (desc_.animation_count != 0) check_argument(desc_.animations, "desc.animations");
    for (uint32_t i = 0; i < desc_.animation_count; ++i) {
        const String place = element_of("desc.animations", i);
        animations_.push_back(read_element<Longer::cut>(desc_.animations, i, sized<FlgSkinAnimation>(), place.c_str()));
        check_animation(animations_.back(), place);
    }
    materials_ = read_materials(desc_.materials, desc_.material_count);
    for (uint32_t i = 0; i < materials_.size(); ++i)
        if (materials_[i].texture != FLG_NO_INDEX && materials_[i].texture >= textures_.size())
            fail(FLG_ERROR_INVALID_ARGUMENT, element_of("desc.materials", i) + ".texture",
                 "is %u, but there are %zu textures", materials_[i].texture, textures_.size());
    morphs_ = CheckedMorphs(desc_, meshes_);
    check_labels(skin(), "desc.skin");
    for (uint32_t i = 0; i < desc_.level_count; ++i) check_labels(meshes_[i + 1], element_of("desc.levels", i));
    if (desc_.rig) check_rig();
    if (desc_.vrm) check_vrm();
}

void CheckedSkin::check_rig() {
    rig_ = read_given(desc_.rig, "desc.rig");
    if (rig_->joint_count != joint_count())
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.rig.joint_count", "is %u, but the skin has %zu joints",
             rig_->joint_count, joint_count());
    check_argument(rig_->joints, "desc.rig.joints");
    for (uint32_t j = 0; j < joint_count(); ++j) {
        const FlgRigJoint& joint = rig_->joints[j];
        const String place = element_of("desc.rig.joints", j);
        check_floats(joint.capsule_start, 3, place + ".capsule_start");
        check_floats(joint.capsule_end, 3, place + ".capsule_end");
        check_floats(&joint.capsule_radius, 1, place + ".capsule_radius");
        check_floats(joint.limit_axis, 3, place + ".limit_axis");
        check_floats(&joint.limit_swing, 1, place + ".limit_swing");
        check_floats(&joint.limit_twist_min, 1, place + ".limit_twist_min");
        check_floats(&joint.limit_twist_max, 1, place + ".limit_twist_max");
    }
}

void CheckedSkin::check_vrm() {
    vrm_ = read_given(desc_.vrm, "desc.vrm");
    if (vrm_->author_count == 0)
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.vrm.author_count", "is 0: VRM asks for an author");
    check_argument(vrm_->authors, "desc.vrm.authors");
    for (uint32_t i = 0; i < vrm_->author_count; ++i) {
        check_argument(vrm_->authors[i], element_of("desc.vrm.authors", i).c_str());
        check_name(vrm_->authors[i], element_of("desc.vrm.authors", i));
        if (*vrm_->authors[i] == 0)
            fail(FLG_ERROR_INVALID_ARGUMENT, element_of("desc.vrm.authors", i), "is empty: VRM asks for an author");
    }
    check_name(vrm_->name, "desc.vrm.name");
    check_name(vrm_->license_url, "desc.vrm.license_url");
    check_argument(vrm_->bones, "desc.vrm.bones");
    Vector<std::string_view> bones;
    for (uint32_t j = 0; j < joint_count(); ++j) {
        if (!vrm_->bones[j]) continue;
        check_name(vrm_->bones[j], element_of("desc.vrm.bones", j));
        bones.push_back(vrm_->bones[j]);
    }
    std::sort(bones.begin(), bones.end());
    const auto twice = std::adjacent_find(bones.begin(), bones.end());
    if (twice != bones.end())
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.vrm.bones", "has two joints that are %s", String(*twice).c_str());
    for (const char* needed : vrm_bones_needed) {
        if (std::binary_search(bones.begin(), bones.end(), std::string_view(needed))) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.vrm.bones", "has no %s, which VRM asks for", needed);
    }
}

void CheckedSkin::check_joints() const {
    if (skin().joint_count == 0 || skin().joint_count > max_joints) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.skin.joint_count", "is %u, must be 1 to %u", skin().joint_count,
             max_joints);
    }
    check_floats(skin().joint_positions, 3 * joint_count(), "desc.skin.joint_positions");
    check_argument(skin().joint_parents, "desc.skin.joint_parents");
    for (uint32_t j = 0; j < skin().joint_count; ++j) {
        const uint32_t parent = skin().joint_parents[j];
        if (parent != FLG_NO_INDEX && parent >= j) {
            fail(FLG_ERROR_INVALID_ARGUMENT, element_of("desc.skin.joint_parents", j),
                 "is %u, must be lower than the joint, or FLG_NO_INDEX", parent);
        }
        if (!skin().joint_names) continue;
        check_argument(skin().joint_names[j], element_of("desc.skin.joint_names", j).c_str());
        check_name(skin().joint_names[j], element_of("desc.skin.joint_names", j));
    }
}

void CheckedSkin::check_mesh(const FlgSkinView& mesh, const String& place) const {
    if (mesh.vertex_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, place + ".vertex_count", "is 0, must be at least 1");
    const size_t vertices = mesh.vertex_count, triangles = mesh.triangle_count;
    check_floats(mesh.positions, 3 * vertices, place + ".positions");
    check_floats(mesh.normals, 3 * vertices, place + ".normals");
    check_argument(mesh.vertex_joints, (place + ".vertex_joints").c_str());
    check_argument(mesh.vertex_weights, (place + ".vertex_weights").c_str());
    for (size_t v = 0; v < vertices; ++v) {
        check_binding(mesh, place, v);
        if (part_of_vertex(mesh, v) < max_parts) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".vertex_parts", v), "is %u, must be below %u",
             part_of_vertex(mesh, v), max_parts);
    }
    check_triangles(mesh, place);
    if (mesh.corner_uvs) check_floats(mesh.corner_uvs, 6 * triangles, place + ".corner_uvs");
    for (size_t t = 0; mesh.triangle_parts && t < triangles; ++t) {
        if (mesh.triangle_parts[t] < max_parts) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".triangle_parts", t), "is %u, must be below %u",
             mesh.triangle_parts[t], max_parts);
    }
}

void CheckedSkin::check_binding(const FlgSkinView& mesh, const String& place, size_t vertex) const {
    const uint16_t* joints = mesh.vertex_joints + joints_a_vertex * vertex;
    const float* weights = mesh.vertex_weights + joints_a_vertex * vertex;
    double sum = 0;
    for (size_t k = 0; k < joints_a_vertex; ++k) {
        const size_t i = joints_a_vertex * vertex + k;
        if (joints[k] >= joint_count()) {
            fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".vertex_joints", i), "is %u, but there are %zu joints",
                 joints[k], joint_count());
        }
        if (!(weights[k] >= 0 && weights[k] <= 1 + sum_tolerance)) {
            fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".vertex_weights", i), "is %g, must be 0 to 1",
                 double{weights[k]});
        }
        for (size_t other = 0; weights[k] > 0 && other < k; ++other) {
            if (joints[other] != joints[k] || weights[other] == 0) continue;
            fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".vertex_joints", i),
                 "is %u, which vertex %zu has already", joints[k], vertex);
        }
        sum += weights[k];
    }
    if (std::abs(sum - 1) <= sum_tolerance) return;
    fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".vertex_weights", joints_a_vertex * vertex),
         "and the next three sum up to %g, must be 1", sum);
}

void CheckedSkin::check_triangles(const FlgSkinView& mesh, const String& place) const {
    if (mesh.triangle_count == 0)
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".triangle_count", "is 0: there is nothing to write");
    check_argument(mesh.triangles, (place + ".triangles").c_str());
    for (size_t i = 0; i < 3 * size_t{mesh.triangle_count}; ++i) {
        if (mesh.triangles[i] < mesh.vertex_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".triangles", i), "is %u, but there are %u vertices",
             mesh.triangles[i], mesh.vertex_count);
    }
}

void CheckedSkin::check_levels() {
    if (desc_.level_count > max_levels)
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.level_count", "is %u, must be at most %u", desc_.level_count,
             max_levels);
    if (desc_.level_count != 0) check_argument(desc_.levels, "desc.levels");
    for (uint32_t i = 0; i < desc_.level_count; ++i) {
        const String place = element_of("desc.levels", i);
        meshes_.push_back(read_element<Longer::cut>(desc_.levels, i, sized<FlgSkinView>(), place.c_str()));
        if (meshes_.back().joint_count != joint_count())
            fail(FLG_ERROR_INVALID_ARGUMENT, place + ".joint_count", "is %u, but the skin has %zu joints",
                 meshes_.back().joint_count, joint_count());
        check_mesh(meshes_.back(), place);
    }
}

void CheckedSkin::check_textures() {
    const auto check = [&](const FlgTexture& texture, const String& place) {
        const Bytes picture{texture.picture, texture.picture_size};
        if (!is_png(picture) && !is_jpeg(picture))
            fail(FLG_ERROR_INVALID_ARGUMENT, place, "is neither a PNG nor a JPEG file");
        for (const FlgSkinView& mesh : meshes_)
            if (!mesh.corner_uvs) fail(FLG_ERROR_INVALID_ARGUMENT, place, "needs the corner_uvs of all meshes");
        textures_.push_back(texture);
    };
    if (!desc_.texture && desc_.texture_size != 0)
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.texture", "is null, but has a size");
    if (desc_.texture) {
        if (desc_.texture_count != 0) fail(FLG_ERROR_INVALID_ARGUMENT, "desc.texture", "is there, and so are textures");
        // At its edge the picture goes on: bodies reach a little beyond their outlines.
        auto only = sized<FlgTexture>();
        only.wrap_u = only.wrap_v = FLG_TEXTURE_WRAP_CLAMP;
        only.picture = desc_.texture;
        only.picture_size = desc_.texture_size;
        check(only, "desc.texture");
    }
    if (desc_.texture_count != 0) check_argument(desc_.textures, "desc.textures");
    for (uint32_t i = 0; i < desc_.texture_count; ++i) {
        const String place = element_of("desc.textures", i);
        const auto texture = read_element<Longer::cut>(desc_.textures, i, sized<FlgTexture>(), place.c_str());
        check_argument(texture.picture, (place + ".picture").c_str());
        check_name(texture.name, place + ".name");
        for (const FlgTextureWrap wrap : {texture.wrap_u, texture.wrap_v})
            if (wrap < FLG_TEXTURE_WRAP_REPEAT || wrap > FLG_TEXTURE_WRAP_MIRROR)
                fail(FLG_ERROR_INVALID_ARGUMENT, place, "wraps by %d, which is none of FLG_TEXTURE_WRAP_",
                     static_cast<int>(wrap));
        check(texture, place + ".picture");
    }
}

void CheckedSkin::check_colors() const {
    if (desc_.vertex_colors) check_floats(desc_.vertex_colors, 4 * size_t{skin().vertex_count}, "desc.vertex_colors");
}

// With one for all, each material has it.
uint32_t CheckedSkin::texture_of(const FlgMeshMaterial& material) const {
    return desc_.texture ? 0 : material.texture;
}

// Parts that have no material.
void CheckedSkin::check_labels(const FlgSkinView& mesh, const String& place) const {
    if (desc_.material_count <= 1) return;
    for (size_t v = 0; v < mesh.vertex_count; ++v) {
        if (part_of_vertex(mesh, v) < desc_.material_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".vertex_parts", v), "is %u, but there are %u materials",
             part_of_vertex(mesh, v), desc_.material_count);
    }
    for (size_t t = 0; t < mesh.triangle_count; ++t) {
        if (part_of_triangle(mesh, t) < desc_.material_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".triangle_parts", t), "is %u, but there are %u materials",
             part_of_triangle(mesh, t), desc_.material_count);
    }
}

uint32_t part_of_vertex(const FlgSkinView& skin, size_t vertex) {
    return skin.vertex_parts ? skin.vertex_parts[vertex] : 0;
}

uint32_t part_of_triangle(const FlgSkinView& skin, size_t triangle) {
    if (skin.triangle_parts) return skin.triangle_parts[triangle];
    const uint32_t* c = skin.triangles + 3 * triangle;
    const uint32_t a = part_of_vertex(skin, c[0]), b = part_of_vertex(skin, c[1]);
    return b == part_of_vertex(skin, c[2]) ? b : a;
}

void CheckedSkin::check_animation(const FlgSkinAnimation& animation, const String& place) const {
    check_name(animation.name, place + ".name");
    if (animation.key_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, place + ".key_count", "is 0, must be at least 1");
    check_times(animation.times, animation.key_count, place + ".times");
    const size_t turns = animation.key_count * joint_count();
    check_floats(animation.rotations, 4 * turns, place + ".rotations");
    for (size_t i = 0; i < turns; ++i) {
        const float* q = animation.rotations + 4 * i;
        const double size = std::hypot(std::hypot(double{q[0]}, q[1]), std::hypot(double{q[2]}, q[3]));
        if (std::abs(size - 1) <= length_tolerance) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, element_of(place + ".rotations", 4 * i),
             "starts a quaternion that is %g long, must be 1", size);
    }
    if (animation.translations)
        check_floats(animation.translations, 3 * size_t{animation.key_count}, place + ".translations");
}

}  // namespace flg::io
