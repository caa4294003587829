// SPDX-License-Identifier: MIT
// What a surface keeps beside its mesh, brought up to date after a change of the mesh; and changes taken back.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/surface.h"

namespace flg {

// The change stands, whatever happens here: if memory runs out, what can't be brought up to date is dropped, and made
// anew when it is needed next. `revision`: the surface's after the change.
Task<void> update_after_edit(Pace& pace, Surface& surface, const MeshEdit& edit, uint32_t revision);

// Takes the surface's last edit back, or makes it again: all of it or, if it throws, nothing.
Task<void> take_back_edit(Pace& pace, Surface& surface, MeshEdit& edit, uint32_t revision);
Task<void> make_edit_again(Pace& pace, Surface& surface, MeshEdit& edit, uint32_t revision);

// What solvers need is made anew when it is needed next.
void drop_solvers(Surface& surface);

}  // namespace flg
