// SPDX-License-Identifier: MIT
#include "mesh_model.h"

#include <algorithm>

#include "documents/failure.h"

namespace flg::cli {
namespace {

constexpr FlgPartEvent root_event = FLG_PART_EVENT_ROOT;
constexpr uint32_t no_part = FLG_NO_INDEX, first = 0;
constexpr uint8_t as_drawn = 0;

}  // namespace

MeshModel::MeshModel(Session& session, const std::string& file, const FlgBoneThresholds& thresholds, Report& report)
    : file_(file) {
    FlgSkinFromMeshDesc desc = flgSkinFromMeshDefaults();
    desc.mesh = &file_.view();
    desc.thresholds = &thresholds;
    FlgSkin made = {};
    FlgJob job = {};
    check(flgSkinCreateFromMesh(session.context(), &desc, &made, &job), file);
    session.finish({{{job, file}}}, report);
    check(flgSkinGetView(session.context(), made, &skin_), file);

    looks_ = looks_of(file_, skin_, report);
    const uint32_t joints = skin_.joint_count;
    places_.assign(skin_.joint_positions, skin_.joint_positions + 3 * size_t{joints});
    pinned_.assign(joints, 0);
    parts_.assign(joints, 0);
    bones_.joint_count = joints;
    bones_.joint_positions = skin_.joint_positions;
    bones_.joint_radii = skin_.joint_radii;
    bones_.joint_parents = skin_.joint_parents;
    bones_.joint_parts = parts_.data();
    bones_.joint_names = bones_.joint_keys = skin_.joint_names;
    bones_.joint_places = places_.data();
    bones_.joint_pinned = pinned_.data();
    bones_.part_count = 1;
    bones_.part_events = &root_event;
    bones_.part_parents = bones_.part_twins = &no_part;
    bones_.part_joints = bones_.part_sources = &first;
    bones_.part_mirrored = &as_drawn;
    std::copy(std::begin(skin_.origin), std::end(skin_.origin), bones_.origin);

    DrawnPart part;
    part.name = "mesh";
    std::copy(std::begin(skin_.mirror), std::end(skin_.mirror), drawing_.mirror.begin());
    part.is_mirrored = std::any_of(skin_.mirror, skin_.mirror + 3, [](float value) { return value != 0; });
    drawing_.parts.push_back(part);
}

}  // namespace flg::cli
