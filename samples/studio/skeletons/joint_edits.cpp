// SPDX-License-Identifier: MIT
#include "skeletons/joint_edits.h"

#include <algorithm>

namespace flg::studio {
namespace {

void forget(Drawing& drawing, const std::string& key, FlgJointEditKind kind) {
    std::erase_if(drawing.joint_edits, [&](const JointEdit& edit) { return edit.joint == key && edit.kind == kind; });
}

bool is_made_by(const JointEdit& edit, const std::string& key) {
    return edit.kind == FLG_JOINT_EDIT_KIND_SPLIT && edit.name == key;
}

std::string without_side(const std::string& key) {
    return key.ends_with(".L") || key.ends_with(".R") ? key.substr(0, key.size() - 2) : key;
}

}  // namespace

std::string key_of(const Rig& rig, uint32_t joint) {
    return without_side(rig.keys[joint]);
}

void pin_joint(Drawing& drawing, const std::string& key, const glm::dvec3& at) {
    forget(drawing, key, FLG_JOINT_EDIT_KIND_PIN);
    drawing.joint_edits.push_back(
        {.kind = FLG_JOINT_EDIT_KIND_PIN, .joint = key, .name = {}, .at = {at.x, at.y, at.z}});
}

void unpin_joint(Drawing& drawing, const std::string& key) {
    forget(drawing, key, FLG_JOINT_EDIT_KIND_PIN);
}

std::string split_bone(Drawing& drawing, const Rig& rig, const std::string& key) {
    const auto is_taken = [&](const std::string& name) {
        const auto has = [&](const std::string& other) { return without_side(other) == name; };
        return std::any_of(rig.keys.begin(), rig.keys.end(), has) ||
               std::any_of(rig.names.begin(), rig.names.end(), has) ||
               std::any_of(drawing.joint_edits.begin(), drawing.joint_edits.end(),
                           [&](const JointEdit& edit) { return edit.name == name; });
    };
    std::string name = key + "_half";
    for (int i = 2; is_taken(name); ++i) name = key + "_half" + std::to_string(i);
    drawing.joint_edits.push_back({.kind = FLG_JOINT_EDIT_KIND_SPLIT, .joint = key, .name = name});
    return name;
}

void merge_joint(Drawing& drawing, const std::string& key) {
    const bool was_made = std::any_of(drawing.joint_edits.begin(), drawing.joint_edits.end(),
                                      [&](const JointEdit& edit) { return is_made_by(edit, key); });
    reset_joint(drawing, key);
    if (!was_made) drawing.joint_edits.push_back({.kind = FLG_JOINT_EDIT_KIND_MERGE, .joint = key, .name = {}});
}

void rename_joint(Drawing& drawing, const std::string& key, const std::string& name) {
    forget(drawing, key, FLG_JOINT_EDIT_KIND_RENAME);
    if (!name.empty() && name != key)
        drawing.joint_edits.push_back({.kind = FLG_JOINT_EDIT_KIND_RENAME, .joint = key, .name = name});
}

void reset_joint(Drawing& drawing, const std::string& key) {
    std::erase_if(drawing.joint_edits,
                  [&](const JointEdit& edit) { return edit.joint == key || is_made_by(edit, key); });
}

void rename_part(Drawing& drawing, const std::string& from, const std::string& to) {
    const auto follow = [&](std::string& key) {
        if (key.starts_with(from + "_")) key.replace(0, from.size(), to);
    };
    for (JointEdit& edit : drawing.joint_edits) {
        follow(edit.joint);
        if (edit.kind == FLG_JOINT_EDIT_KIND_SPLIT) follow(edit.name);
    }
    for (WeightStrokePtr& shared : drawing.weight_strokes) {
        WeightStroke stroke = *shared;
        follow(stroke.joint);
        follow(stroke.mirror_joint);
        for (WeightDab& dab : stroke.dabs)
            if (dab.place.part == from) dab.place.part = to;
        if (stroke != *shared) shared = std::make_shared<const WeightStroke>(std::move(stroke));
    }
    for (PullPin& pin : drawing.pulls.pins)
        if (pin.place.part == from) pin.place.part = to;
    if (drawing.pulls.record) {
        PullRecord record = *drawing.pulls.record;
        for (BodyPlace& place : record.places)
            if (place.part == from) place.part = to;
        drawing.pulls.record = std::make_shared<const PullRecord>(std::move(record));
    }
    for (auto& pair : drawing.apart) std::replace(pair.begin(), pair.end(), from, to);
}

}  // namespace flg::studio
