// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification.
// A glTF document written again, with other triangles in its meshes: those that they were cut into.
//
// Invariants
// - What no triangle was cut in, moved or given a material keeps its JSON, its accessors and its bytes; so does all
//   that is no mesh, known to this library or not. Buffers become one, pictures of other files become part of it; bytes
//   that only triangles of before used are left out.
// - A vertex of a changed primitive that was there keeps its values; new ones have the mix that their place in a
//   triangle asks for (mixed_vertices.h). Seams stay seams: two corners share a vertex where they shared one, or lie at
//   one place between the same vertices.
// - A mesh that several nodes show is divided where they differ. Triangles that the surface lost (those that name a
//   place twice, or stand twice) are written as they were.
#pragma once

#include "io/base/checked_views.h"
#include "io/base/files.h"

namespace flg::io {

// Of the mesh's asset, with its triangles. The provenance is of the mesh as flgMeshFileRead gives it.
String write_glb_asset(const Path& asset, const CheckedMesh& mesh);

}  // namespace flg::io
