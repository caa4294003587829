// SPDX-License-Identifier: MIT
// Plane drawings: lines, dots and filled shapes in the plane z = 0, seen from in front.
#pragma once

#include <deque>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "filigree/filigree_model.h"
#include "gallery/looks.h"
#include "gallery/workshop.h"
#include "panels/panels.h"

namespace flg::gallery {

using namespace panels;

using Line = std::vector<glm::dvec2>;

// Later strokes lie over earlier ones. Stays where it is until the picture is taken.
class Sketch {
public:
    // Widths of lines and dots are in `unit`s.
    Sketch(Workshop& workshop, double unit) : workshop_(workshop), unit_(unit) {}
    Sketch(const Sketch&) = delete;
    Sketch& operator=(const Sketch&) = delete;

    void lines(std::span<const Line> list, glm::vec3 color, double width);
    void line(const Line& one, glm::vec3 color, double width) { lines({&one, 1}, color, width); }
    void ring(Line points, glm::vec3 color, double width);
    void dots(std::span<const glm::dvec2> places, glm::vec3 color, double width);
    // Balls of these radii at both ends, and the cone around them, behind all lines.
    void cone(glm::dvec2 from, double from_radius, glm::dvec2 to, double to_radius, glm::vec3 color);
    // What a body covers, without its height, below all lines; or as it is, with all lines in front of it.
    void fill(const FlgPartMeshView& body, glm::vec3 color);
    void stand(const FlgPartMeshView& body, glm::vec3 color);

    Panel panel(float margin = 1.06f) const;

private:
    struct Fill {
        std::vector<float> positions;
        std::vector<uint32_t> triangles;
        FlgColumn column;
        glm::vec3 color;
    };
    void add(const std::vector<scenes::Curve>& curves, glm::vec3 color, double radius);
    Fill& add(const FlgPartMeshView& body, glm::vec3 color);

    Workshop& workshop_;
    double unit_;
    float height_ = 0.0f;    // of the next stroke above the plane
    bool in_front_ = false;  // lines are drawn over bodies
    glm::vec3 sight_ = {0.0f, 0.0f, -1.0f};
    std::deque<filigree::CurveSet> sets_;
    std::deque<Fill> fills_;
    std::vector<Layer> bodies_, layers_;
};

}  // namespace flg::gallery
