// SPDX-License-Identifier: MIT
// What the renderer takes of curves, point by point. Values are those of the view, or the look's where it has none;
// only positions are checked as they are read.
#pragma once

#include "filigree_renderer/renderer.h"
#include "packing.h"

namespace flg::render {

// Throws Error for a look that can't be used.
void check_look(const CurveLook& look);
// Throws Error unless the view's offsets tell its curves apart, and there are columns if there are curves.
void check_view(const FlgCurveSetView& view);

class CurveColumns {
public:
    // Throws Error for columns that can't be read.
    explicit CurveColumns(const FlgCurveSetView& view);

    bool has_normals() const { return bool(normal_); }
    bool has_displacements() const { return bool(displacement_); }
    // Throws Error unless it can be used.
    glm::vec3 position(uint32_t point) const;
    // Throws Error unless all else can be.
    void check(uint32_t point) const;

    float radius(uint32_t point, const CurveLook& look) const {
        return (radius_ ? radius_.at<float>(point) : look.radius) * look.radius_scale;
    }
    // `to_end`: 0 = the look's first colour to 1 = its last.
    glm::vec3 color(uint32_t point, const CurveLook& look, float to_end) const {
        return color_ ? glm::vec3(color_.at<glm::vec4>(point)) : glm::mix(look.color, look.color_end, to_end);
    }
    glm::vec3 normal(uint32_t point) const { return normal_.at<glm::vec3>(point); }
    glm::vec3 displacement(uint32_t point) const { return displacement_.at<glm::vec3>(point); }

private:
    Column position_, radius_, color_, normal_, displacement_;
};

}  // namespace flg::render
