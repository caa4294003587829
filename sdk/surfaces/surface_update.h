// SPDX-License-Identifier: MIT
// What a surface keeps beside its mesh, brought up to date after a change of the mesh.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh_edit.h"
#include "surfaces/surface.h"

namespace flg {

// The change stands, whatever happens here: if memory runs out, what can't be brought up to date is dropped, and made anew
// when it is needed next. `revision`: the surface's after the change.
Task<void> update_after_edit(Pace& pace, Surface& surface, const MeshEdit& edit, uint32_t revision);

}  // namespace flg
