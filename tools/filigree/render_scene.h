// SPDX-License-Identifier: MIT
// What `filigree render` draws: the curves and meshes of its files, and how they look.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "choices.h"
#include "documents/report.h"
#include "file_contents.h"
#include "filigree_renderer/renderer.h"

namespace flg::cli {

struct SceneOptions {
    std::vector<std::string> files;
    Shapes as = Shapes::automatic;
    double radius = 0.0;           // of curves that bring none, metres; 0 = from the size of the whole
    std::string field;             // a file, or empty
    double every = 0.0;            // between isolines; 0 = a round number that gives about 20
    PoseOptions pose;              // of all skins
    std::string camera_obstacles;  // a file, or empty
    std::string camera_motion;     // a file, or empty; the pose's time is the camera's too
    bool bones = false;            // whether joints and bones are drawn over them
};

// By the file's materials; where it has several regions and none, in colours of ours with lines between.
render::SurfaceLook look_of(const MeshFile& mesh);
// Likewise by parts; without lines, which no pose moves.
render::SurfaceLook look_of(const SkinFile& skin);

class RenderScene {
public:
    // Reads the files and notes in the report what is in them; throws InputError, UsageError, SourceError.
    RenderScene(const SceneOptions& options, Report& report);

    void upload(render::Renderer& renderer) const;
    // Of curves and meshes, skins as they are posed.
    std::vector<glm::vec3> points() const;

private:
    struct Skin {
        SkinFile file;
        SkinPose pose;
    };

    void add_skin(FileContents& contents, const std::string& name, Report& report);
    void read_field(Report& report);
    void upload_skins(render::Renderer& renderer) const;
    void upload_curves(render::Renderer& renderer) const;

    const SceneOptions& options_;
    std::vector<samples::CurveSource> curves_;
    std::vector<MeshFile> meshes_;
    std::vector<Skin> skins_;
    std::vector<float> field_;  // of the only mesh; else empty
    double spacing_ = 0.0;      // of isolines
};

}  // namespace flg::cli
