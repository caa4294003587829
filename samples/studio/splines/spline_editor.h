// SPDX-License-Identifier: MIT
// The workspace without its widgets: document, history, what is chosen, what is live, and the acts that change the
// document.
#pragma once

#include <functional>
#include <map>
#include <memory>

#include "splines/curve_view.h"
#include "splines/history.h"
#include "splines/motion_view.h"
#include "splines/solids.h"

namespace flg::studio::splines {

enum class Tool { curves, obstacles, motions };

class SplineEditor {
public:
    explicit SplineEditor(AppContext& app);

    AppContext& app;
    Document document;
    History history{document};
    SurfaceLookup surfaces{app};

    // ---- What is chosen: ids, 0 for none; indices of points and keys, -1 for none
    Tool tool = Tool::curves;
    SurfaceRef ground;  // of what is begun next; a mesh of id 0 is the one that is clicked
    uint32_t curve = 0, obstacle = 0, motion = 0;
    int point = -1, key = -1;
    uint32_t drawing = 0;     // the curve that clicks go on with
    bool begins_new = false;  // the panel is for the next curve, not for the chosen one
    FlgObstacleKind kind = FLG_OBSTACLE_KIND_BALL;
    bool dragging = false;  // something in the picture: no step of undo is taken
    bool editing = false;   // a widget is being used: likewise
    bool in_front = false;

    // ---- Playing
    bool playing = false;
    double seconds = 0.0;  // of the chosen motion

    Curve* chosen_curve() { return document.curve(curve); }
    const Curve* chosen_curve() const { return document.curve(curve); }
    Obstacle* chosen_obstacle() { return document.obstacle(obstacle); }
    const Obstacle* chosen_obstacle() const { return document.obstacle(obstacle); }
    Motion* chosen_motion() { return document.motion(motion); }
    const Motion* chosen_motion() const { return document.motion(motion); }
    // Null while there is none.
    const LiveCurve* live_curve(uint32_t id) const;
    const LiveMotion* live_motion(uint32_t id) const;
    // Where new points come: that of `ground`, with the active mesh for none.
    SurfaceRef ground_now() const;
    double size() const { return surfaces.size(); }

    // ---- Acts
    Curve& add_curve(const SurfaceRef& on);
    void end_drawing();
    // The next click begins another curve.
    void begin_new();
    void choose_curve(uint32_t id);
    void remove_curve(uint32_t id);
    void remove_point(Curve& curve, int index);
    // Sizes of the scene, for what is new.
    Obstacle& add_obstacle(FlgObstacleKind of, const glm::dvec3& at);
    void remove_obstacle(uint32_t id);
    Motion& add_motion(const SurfaceRef& on);
    // Behind the last key, a second later; up is `normal`, its nose to `heading`, if that is not along it.
    Key& add_key(Motion& motion, const glm::dvec3& at, const glm::dvec3& normal, const glm::dvec3& heading);
    void remove_motion(uint32_t id);
    void remove_key(Motion& motion, int index);
    void play(bool on);
    // What is being dragged goes back to where it was; false if it had not been moved.
    bool give_up();
    void undo();
    void redo();
    // Makes a step of what is new.
    void settle();
    // Called with each step that is made.
    std::function<void()> did;
    // All anew, with no way back.
    void replace(Document other);

    // Once a frame.
    void update();
    bool busy() const;
    void device_lost();

private:
    void settle_choice();
    void advance(double elapsed);

    StyleCache style_cache_{app};
    std::map<uint32_t, std::unique_ptr<LiveCurve>> live_curves_;
    std::map<uint32_t, std::unique_ptr<LiveMotion>> live_motions_;
    SolidsView solids_{app};
    double last_seconds_ = -1.0;
};

// A rotation with y along `up` and x as near to `heading` as that allows.
glm::dquat upright(const glm::dvec3& up, const glm::dvec3& heading);

}  // namespace flg::studio::splines
