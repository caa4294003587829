// SPDX-License-Identifier: MIT
// Where the scene's meshes come from: files, and what is built in.
#pragma once

#include <span>
#include <string>

#include "filigree/filigree.hpp"

namespace flg::studio {

// ball, torus, cloth, vase, cat: what builtin: takes.
std::span<const char* const> builtin_meshes();

struct OpenedMesh {
    filigree::Surface surface;  // in the making
    filigree::Job job;          // that makes it
    std::string name;           // for the user
};

// A file (.obj, .ply, .off, .glb, .gltf) or builtin:NAME. Throws StudioError for what can't be read.
OpenedMesh open_mesh(filigree::Context& context, const std::string& source);

}  // namespace flg::studio
