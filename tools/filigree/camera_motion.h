// SPDX-License-Identifier: MIT
// A camera that follows a motion: it is the body, looks along its -z and has its +y upwards.
#pragma once

#include <string>

#include "documents/session.h"
#include "filigree/filigree_motion.h"
#include "filigree_renderer/camera.h"

namespace flg::cli {

class CameraMotion {
public:
    // Makes the motion of a file of keyframes (motion_file.h), around the obstacles of a file (spline_obstacles.h)
    // unless that is empty. The session must outlive it. Throws InputError.
    CameraMotion(const std::string& file, const std::string& obstacles, Session& session, Report& report);

    // When it begins and ends; of a closed one, when it comes round.
    double begin() const { return view_.times[0]; }
    double end() const { return view_.times[position_count() - 1]; }
    bool closed() const { return view_.closed != 0; }

    // At a time, closed motions at any: between the motion's positions, which are close together. `middle`: what the
    // picture is about, metres; only how far away that is counts.
    render::Camera at(double time, const glm::vec3& middle) const;

private:
    // The first one of a closed motion again.
    uint32_t position_count() const { return view_.position_count + (closed() ? 1 : 0); }

    FlgMotionView view_ = {};
};

}  // namespace flg::cli
