// SPDX-License-Identifier: MIT
// A drawn model away from rest: its joints are turned, and what lies on it follows its skin.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "filigree/filigree_model.h"
#include "filigree/filigree_surface.h"
#include "filigree_renderer/surface_look.h"

namespace flg::studio {

// Joints and weights, four of each a place.
struct SkinWeights {
    std::vector<uint16_t> joints;
    std::vector<float> weights;
};

// A copy of a skin at rest. Places near it are held by what holds its vertices around them.
class SkinCopy {
public:
    explicit SkinCopy(const FlgSkinView& skin);
    // Cost: about 2 us a place.
    SkinWeights hold(std::span<const glm::vec3> places) const;

private:
    uint64_t cell_of(const glm::vec3& place, const glm::ivec3& beside) const;

    std::vector<glm::vec3> positions_;
    SkinWeights hold_;
    float cell_;  // metres
    std::unordered_map<uint64_t, std::vector<uint32_t>> cells_;
};

class Bend {
public:
    // Another skin: at rest.
    void take(const FlgSkinView& skin);
    void rest();
    // As flgSkinPose makes them.
    void pose(std::vector<float> dual_quaternions);
    bool is_bent() const { return !dual_quaternions_.empty(); }
    // Null before take().
    const std::shared_ptr<const SkinCopy>& skin() const { return skin_; }
    std::span<const float> dual_quaternions() const { return dual_quaternions_; }
    // Counts poses; never the same for two of them.
    uint64_t revision() const { return revision_; }
    // Moves places of the model's space, and their normals.
    void move(const SkinWeights& hold, std::vector<glm::vec3>& positions, std::vector<glm::vec3>& normals) const;

private:
    std::shared_ptr<const SkinCopy> skin_;
    std::vector<float> dual_quaternions_;
    uint64_t revision_ = 0;
};

// A mesh on a skin, for the renderer: it bends there. Regions have their materials, but no lines between them.
struct BentMesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<uint32_t> triangles, parts;
    SkinWeights hold;
    render::SurfaceLook look;

    FlgSkinView view(size_t joint_count) const;
};

// What a mesh is: copied, so that a thread can take its time.
struct MeshCopy {
    std::vector<glm::vec3> positions, colors;  // no colours: those of the look
    std::vector<uint32_t> triangles, labels;   // no labels: no regions
    render::SurfaceLook look;

    MeshCopy(const FlgMeshView& mesh, render::SurfaceLook look);
};
BentMesh bend_mesh(const MeshCopy& mesh, const SkinCopy& skin);

}  // namespace flg::studio
