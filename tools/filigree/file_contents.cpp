// SPDX-License-Identifier: MIT
#include "file_contents.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "documents/failure.h"
#include "documents/progress.h"

namespace flg::cli {

FileContents read_contents(const std::string& name) {
    say_step("reading " + name);
    std::string extension = std::filesystem::path(name).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    const bool mesh_only = extension == ".ply" || extension == ".off";
    const bool both = extension == ".obj" || extension == ".gltf" || extension == ".glb";
    FileContents contents;
    std::string why_no_mesh;
    if (is_builtin_mesh(name)) {
        contents.mesh.emplace(name);
        return contents;
    }
    if (mesh_only || both) {
        try {
            contents.mesh.emplace(name);
        } catch (const InputError& error) {
            if (mesh_only) throw;
            why_no_mesh = error.what();
        }
    }
    if (mesh_only) return contents;
    if (contents.mesh && extension != ".obj") {
        try {
            contents.skin = SkinFile::read(name);
        } catch (const InputError& error) {
            contents.why_no_skin = error.what();
        }
    }
    try {
        contents.curves.emplace(name);
    } catch (const samples::SourceError& error) {
        if (!both) throw;
        if (!contents.mesh) throw InputError(why_no_mesh + "; as curves: " + error.what());
    }
    return contents;
}

}  // namespace flg::cli
