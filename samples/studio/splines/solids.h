// SPDX-License-Identifier: MIT
// Obstacles in the picture.
#pragma once

#include <map>

#include "shell/workspace.h"
#include "splines/model.h"

namespace flg::studio::splines {

struct SolidMesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<uint32_t> triangles;
};
SolidMesh mesh_of(const Obstacle& obstacle);

class SolidsView {
public:
    explicit SolidsView(AppContext& app) : app_(app) {}
    ~SolidsView();
    SolidsView(const SolidsView&) = delete;
    SolidsView& operator=(const SolidsView&) = delete;

    // `chosen` is shown brighter.
    void update(const std::vector<Obstacle>& obstacles, uint32_t chosen);
    void device_lost() { drawn_.clear(); }

private:
    struct Drawn {
        Obstacle obstacle;
        bool chosen = false;
        render::SurfaceId id{};
    };
    AppContext& app_;
    std::map<uint32_t, Drawn> drawn_;
};

}  // namespace flg::studio::splines
