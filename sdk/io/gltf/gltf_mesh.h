// SPDX-License-Identifier: MIT
// Meshes in glTF 2.0 files: read from .gltf and .glb, written to .glb.
#pragma once

#include "core/origin.h"
#include "io/base/checked_views.h"
#include "io/base/files.h"
#include "io/base/memory.h"
#include "io/base/mesh_data.h"
#include "io/gltf/glb_builder.h"

namespace flg::io {

MeshData read_gltf_mesh(const Path& path, const Origin& origin);

// Adds the mesh's vertices and primitives; returns its materials, which finish() takes.
String add_mesh(GlbBuilder& glb, const CheckedMesh& mesh);

String write_glb_mesh(const CheckedMesh& mesh);

}  // namespace flg::io
