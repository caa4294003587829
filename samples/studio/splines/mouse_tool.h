// SPDX-License-Identifier: MIT
// The left button in the picture: takes hold of handles, drags them, drops what is new.
#pragma once

#include "splines/handles.h"

namespace flg::studio::splines {

class MouseTool {
public:
    explicit MouseTool(SplineEditor& editor) : editor_(editor) {}

    void pointer(const Pointer& mouse);
    // Under the mouse, or held.
    const Handle& hot() const { return hot_; }
    // What the mouse would do here, once it rests; empty where the help says it.
    const char* tip() const;

private:
    void press(const Pointer& mouse);
    void press_curves(const Pointer& mouse);
    void add_point(glm::vec2 px);
    void press_motions(const Pointer& mouse);
    void press_obstacles(const Pointer& mouse);
    // `place`: where the handle is.
    void take(const Handle& handle, const glm::dvec3& place);
    void take_solid(const Handle& handle);
    void drag(const Pointer& mouse);
    void drag_slope(const Ray& ray, Curve& curve);
    void drag_solid(const Ray& ray, Obstacle& obstacle);
    void drag_key(const Ray& ray, Motion& motion);
    void turn_key(const Ray& ray, Key& key);
    void drop();
    // What the ground is under the mouse, where meshes are it.
    SurfaceRef ground_under(glm::vec2 px) const;
    glm::dvec3 towards_viewer() const;

    SplineEditor& editor_;
    Handle hot_;
    double rests_since_ = 0.0;
    glm::vec2 pressed_px_{0.0f}, offset_px_{0.0f};  // where it was pressed, and how far that is from the handle
    bool moved_ = false;                            // farther than a click does
    bool fresh_ = false;                            // what is held was made by this press
    bool answers_ = false;                          // a click on it closes the curve, or goes on drawing it
    bool on_ground_ = false;                        // an obstacle that is dragged along the ground
    Key held_key_;
    Obstacle held_solid_;
    glm::dvec3 normal_{0.0, 1.0, 0.0};
    double angle_ = 0.0;
};

}  // namespace flg::studio::splines
