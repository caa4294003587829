// SPDX-License-Identifier: MIT
// Rigid bodies, and copies of them at the positions of a motion, in one mesh.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "filigree/filigree_surface.h"

namespace flg::samples {

// Around its barycentre, that of its vertices. Each vertex has a colour.
struct Body {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> colors;
    std::vector<uint32_t> triangles;

    // The distance of its farthest vertex from its barycentre, metres.
    double radius() const;
};

Body oar();     // 2.4 metres along x, the blade at +x
Body hammer();  // 1.1 metres along y, the head above
Body glider();  // of folded paper, 1 metre, flies along x, y upwards
Body top();     // a spinning top, half a metre along y

// Positions are rows as in FlgMotionView: 12 numbers, rotation and place.
glm::dvec3 moved_by(const double* pose, const glm::dvec3& point);

class Copies {
public:
    // `fade`: how much of its colours is replaced by `faded`, 0 to 1.
    void add(const Body& body, const double* pose, glm::vec3 faded, float fade);
    // Lives until a copy is added.
    FlgMeshView view();

private:
    std::vector<glm::vec3> positions_;
    std::vector<glm::vec4> colors_;
    std::vector<uint32_t> triangles_;
    FlgColumn columns_[2] = {};
};

}  // namespace flg::samples
