// SPDX-License-Identifier: MIT
// A motion in the picture: the body where it is now, faded copies along its way, and its barycentre's path.
#pragma once

#include "splines/motion_solver.h"

namespace flg::studio::splines {

class LiveMotion {
public:
    explicit LiveMotion(AppContext& app) : app_(app), solver_(app) {}
    ~LiveMotion() { remove(); }
    LiveMotion(const LiveMotion&) = delete;
    LiveMotion& operator=(const LiveMotion&) = delete;

    // Once a frame; `seconds` is where the body is shown.
    void update(const Motion& motion, const std::vector<Obstacle>& obstacles, double seconds);
    bool busy() const { return solver_.busy(); }
    void device_lost() { body_ = ghosts_ = {}, path_ = {}, shown_ = {}; }

    const FoundMotion& found() const { return solver_.found(); }
    const std::string& error() const { return solver_.error(); }

private:
    // What copies and path depend on.
    struct Shown {
        uint64_t version = 0;
        std::vector<Key> keys;
        int body = 0, ghosts = 0;
        double size = 0.0;
        bool visible = false;
        bool operator==(const Shown&) const = default;
    };

    void remove();
    void show_ghosts(const Motion& motion);
    void show_path(const Motion& motion);
    void show_body(const Motion& motion, double seconds);

    AppContext& app_;
    MotionSolver solver_;
    render::SurfaceId body_{}, ghosts_{};
    render::CurvesId path_{};
    Shown shown_;
    Pose at_;
};

}  // namespace flg::studio::splines
