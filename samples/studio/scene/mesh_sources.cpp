// SPDX-License-Identifier: MIT
#include "scene/mesh_sources.h"

#include <filesystem>
#include <fstream>

#include "scenes/scenes.h"
#include "shell/studio_error.h"

namespace flg::studio {
namespace {

constexpr const char* kPrefix = "builtin:";
constexpr const char* kBuiltin[] = {"ball", "torus", "cloth", "vase", "cat"};
constexpr uint32_t kFigureLevels = 4;  // 88 thousand triangles

scenes::Mesh make_builtin(const std::string& name) {
    if (name == "ball") return scenes::make_ball_mesh();
    if (name == "torus") return scenes::make_torus();
    if (name == "cloth") return scenes::make_cloth();
    if (name == "vase") return scenes::make_vase(360);
    if (name == "cat") return scenes::make_figure();
    std::string names;
    for (const char* known : kBuiltin) names += (names.empty() ? "" : ", ") + std::string(known);
    throw StudioError("There is no built-in mesh \"" + name + "\"; there are " + names + ".");
}

}  // namespace

bool is_builtin_mesh(const std::string& source) {
    return source.starts_with(kPrefix);
}

OpenedMesh open_builtin(filigree::Context& context, const std::string& source) {
    const std::string name = source.substr(std::string(kPrefix).size());
    const scenes::Mesh mesh = make_builtin(name);
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, &mesh.vertices[0].x, 0, 0};
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    FlgMeshView input = flgMeshViewDefaults();
    input.vertex_count = static_cast<uint32_t>(mesh.vertices.size());
    input.triangle_count = static_cast<uint32_t>(mesh.triangles.size());
    input.columns = &column;
    input.column_count = 1;
    input.triangles = mesh.triangles[0].data();
    desc.mesh = &input;
    desc.weld_distance = name == "ball" ? scenes::kFaceSeam : 0.0f;
    OpenedMesh opened{{}, {}, name};
    opened.surface = context.surface(desc, &opened.job);
    if (name != "cat") return opened;
    // It is made of blocks: rounded off. The blocks' surface is kept by that job.
    filigree::SurfaceRefineDesc refine;
    refine.scheme = FLG_SUBDIVISION_LOOP;
    refine.levels = kFigureLevels;
    filigree::Surface round = opened.surface.refine(refine, &opened.job);
    opened.surface = std::move(round);
    return opened;
}

std::span<const char* const> builtin_meshes() {
    return kBuiltin;
}

std::future<MeshFile> read_mesh(const std::string& path) {
    if (!std::ifstream(path, std::ios::binary)) throw StudioError(path + " cannot be read: there is no such file.");
    return std::async(std::launch::async, [path] {
        FlgMeshFile read = nullptr;
        if (flgMeshFileRead(path.c_str(), nullptr, &read) != FLG_OK) return MeshFile{nullptr, flgIoErrorGetMessage()};
        return MeshFile{std::shared_ptr<FlgMeshFileT>(read, flgMeshFileRelease), {}};
    });
}

OpenedMesh open_file(filigree::Context& context, const MeshFile& file, const std::string& path) {
    FlgMeshView read = flgMeshViewDefaults();
    if (flgMeshFileGetView(file.file.get(), &read) != FLG_OK) throw StudioError(flgIoErrorGetMessage());
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh = &read;
    OpenedMesh opened{{}, {}, std::filesystem::path(path).stem().string()};
    opened.surface = context.surface(desc, &opened.job);
    return opened;
}

}  // namespace flg::studio
