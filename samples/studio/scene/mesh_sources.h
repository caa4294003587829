// SPDX-License-Identifier: MIT
// Where the scene's meshes come from: files, and what is built in.
#pragma once

#include <future>
#include <memory>
#include <span>
#include <string>

#include "filigree/filigree.hpp"
#include "filigree/filigree_io.h"

namespace flg::studio {

// ball, torus, cloth, vase, cat: what builtin: takes.
std::span<const char* const> builtin_meshes();

struct OpenedMesh {
    filigree::Surface surface;  // in the making
    filigree::Job job;          // that makes it
    std::string name;           // for the user
};

bool is_builtin_mesh(const std::string& source);
// builtin:NAME. Throws StudioError for others.
OpenedMesh open_builtin(filigree::Context& context, const std::string& source);

// A file (.obj, .ply, .off, .glb, .gltf), read in a thread of its own.
struct MeshFile {
    std::shared_ptr<FlgMeshFileT> file;  // null: it could not be read
    std::string error;
};
// Throws StudioError for a file that isn't there.
std::future<MeshFile> read_mesh(const std::string& path);
OpenedMesh open_file(filigree::Context& context, const MeshFile& file, const std::string& path);

}  // namespace flg::studio
