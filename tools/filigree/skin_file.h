// SPDX-License-Identifier: MIT
// A skin from a file, with its memory; and a pose of it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filigree/filigree_io.h"

namespace flg::cli {

class SkinFile {
public:
    // None if the file shows no skin. Throws InputError.
    static std::optional<SkinFile> read(const std::string& name);

    const std::string& name() const { return name_; }
    // Lives as long as this.
    const FlgSkinView& view() const { return view_; }
    const FlgSkinFileInfo& info() const { return info_; }
    std::vector<FlgSkinAnimation> animations() const;
    // One a part, or one for all; empty where the file says no colour.
    std::vector<FlgMeshMaterial> materials() const;
    // What materials refer to.
    std::vector<FlgTexture> textures() const;
    std::vector<FlgMorphTarget> morphs() const;
    std::vector<FlgMorphAnimation> morph_animations() const;

private:
    explicit SkinFile(const std::string& name) : name_(name) {}

    std::string name_;
    std::unique_ptr<FlgSkinFileT, decltype(&flgSkinFileRelease)> file_{nullptr, flgSkinFileRelease};
    FlgSkinView view_ = {};
    FlgSkinFileInfo info_ = {};
};

// What moves a skin's joints: at rest without a time.
struct PoseOptions {
    std::optional<double> time;  // seconds
    std::string animation;       // empty: the first
    FlgSkinning skinning = FLG_SKINNING_DUAL_QUATERNION;
};

struct SkinPose {
    std::vector<float> rest, normals;    // 3 a vertex: where morph targets move them before joints; empty: as they are
    std::vector<float> transforms;       // as the skinning takes them
    std::vector<float> positions;        // 3 a vertex
    std::vector<float> joint_positions;  // 3 a joint
};

// Throws InputError where there is no such animation.
SkinPose pose_skin(const SkinFile& skin, const PoseOptions& options);

// The skin as morph targets have it. Lives as long as both.
FlgSkinView morphed(const SkinFile& skin, const SkinPose& pose);

}  // namespace flg::cli
