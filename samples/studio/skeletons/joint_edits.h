// SPDX-License-Identifier: MIT
// What users set about joints, as edits of the drawing (FlgJointEdit). Keys are without the side that mirror images
// add, so an edit is of both.
#pragma once

#include "skeletons/rig.h"

namespace flg::studio {

// A joint's key, without .L or .R.
std::string key_of(const Rig& rig, uint32_t joint);

// Instead of an earlier pin. `at`: in the drawing of the joint's part.
void pin_joint(Drawing& drawing, const std::string& key, const glm::dvec3& at);
void unpin_joint(Drawing& drawing, const std::string& key);
// A new joint half-way between a joint and its parent. Returns its key.
std::string split_bone(Drawing& drawing, const Rig& rig, const std::string& key);
// The joint becomes one with its parent; one that a split made is not made.
void merge_joint(Drawing& drawing, const std::string& key);
// An empty name, or the key itself: as before.
void rename_joint(Drawing& drawing, const std::string& key, const std::string& name);
// All that was set about a joint.
void reset_joint(Drawing& drawing, const std::string& key);
// After a part has another name, so have its joints.
void rename_part(Drawing& drawing, const std::string& from, const std::string& to);

}  // namespace flg::studio
