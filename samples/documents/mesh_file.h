// SPDX-License-Identifier: MIT
// A mesh from a file, or built in, with its memory.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filigree/filigree_io.h"
#include "scenes/scenes.h"

namespace flg::cli {

// Whether it is `builtin:NAME` or `builtin:NAME:COUNT` with the name of a mesh.
bool is_builtin_mesh(const std::string& name);

class MeshFile {
public:
    // Reads a file or makes what is built in. Throws InputError.
    explicit MeshFile(const std::string& name);

    const std::string& name() const { return name_; }
    // Lives as long as this.
    const FlgMeshView& view() const { return view_; }
    const FlgMeshFileInfo& info() const { return info_; }
    std::vector<FlgMeshFaceColumn> face_columns() const;
    // By region; empty where the file has none with a colour.
    std::vector<FlgMeshMaterial> materials() const;
    // What materials refer to.
    std::vector<FlgTexture> textures() const;

private:
    struct Builtin {
        scenes::Mesh mesh;
        FlgColumn columns[2];
    };
    void make();

    std::string name_;
    std::unique_ptr<Builtin> builtin_;
    std::unique_ptr<FlgMeshFileT, decltype(&flgMeshFileRelease)> file_{nullptr, flgMeshFileRelease};
    FlgMeshView view_ = {};
    FlgMeshFileInfo info_ = {};
};

// The positions of a mesh.
const FlgColumn& positions_of(const FlgMeshView& mesh);

}  // namespace flg::cli
