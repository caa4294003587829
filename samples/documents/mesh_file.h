// SPDX-License-Identifier: MIT
// A mesh from a file, with its memory.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filigree/filigree_io.h"

namespace flg::cli {

class MeshFile {
public:
    // Throws InputError.
    explicit MeshFile(const std::string& name);

    const std::string& name() const { return name_; }
    // Lives as long as this.
    const FlgMeshView& view() const { return view_; }
    const FlgMeshFileInfo& info() const { return info_; }
    std::vector<FlgMeshFaceColumn> face_columns() const;
    // By region; empty where the file has none with a colour.
    std::vector<FlgMeshMaterial> materials() const;

private:
    std::string name_;
    std::unique_ptr<FlgMeshFileT, decltype(&flgMeshFileRelease)> file_{nullptr, flgMeshFileRelease};
    FlgMeshView view_ = {};
    FlgMeshFileInfo info_ = {};
};

// The positions of a mesh.
const FlgColumn& positions_of(const FlgMeshView& mesh);

}  // namespace flg::cli
