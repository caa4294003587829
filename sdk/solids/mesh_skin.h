// SPDX-License-Identifier: MIT
// Bones and weights for a mesh that nobody drew: its solid's curves, joints on these, and weights that begin with the
// bone that is nearest within the solid. The mesh stays as it is: a repaired copy is what is looked at.
#pragma once

#include "bones/skin.h"
#include "surfaces/surface_jobs.h"

namespace flg {

struct MeshSkinRequest {
    std::shared_ptr<const MeshInput> mesh;
    RepairOptions repair;
    FlgBoneThresholds thresholds{};
    Vec3 up = Vec3::UnitY();
    Vec3 left = Vec3::Zero();  // of length 0: to be found
    uint32_t cells = 0;
};

// The whole of flgSkinCreateFromMesh.
Task<void> make_mesh_skin(Pace& pace, std::shared_ptr<HeldSkin> skin, std::shared_ptr<MeshSkinRequest> request);

}  // namespace flg
