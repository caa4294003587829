// SPDX-License-Identifier: MIT
// What a rig knows of joints, as JSON in glTF: extras of their nodes (docs/rigs.md), and the extension VRMC_vrm.
//
// Source: VRM Consortium, VRMC_vrm-1.0: meta, humanoid.
#pragma once

#include "filigree/filigree_io.h"
#include "io/base/memory.h"

namespace flg::io {

// `{"filigree":{...}}`. Places are relative to the joint, which is at `position`.
String json_rig_joint(const FlgRigJoint& joint, const float* position);

// `"extensions":{...}` of a document whose joints are nodes from the first one on.
String json_vrm(const FlgVrm& vrm, const String& model_name, size_t joint_count, size_t first_node);

}  // namespace flg::io
