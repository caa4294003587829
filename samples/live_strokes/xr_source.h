// SPDX-License-Identifier: MIT
// Where a headset's poses come from and its frames go: what OpenXR gives, without OpenXR. README.md says function by
// function how a session takes the place of the replay. Metres, seconds, right-handed, y up; poses look along -z.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "filigree_renderer/camera.h"

namespace flg::samples {

struct XrPose {
    glm::vec3 position{0.0f};
    glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};
};

struct XrEye {
    XrPose pose;
    render::FieldOfView field;
};

struct XrController {
    XrPose pose;           // of its tip
    float trigger = 0.0f;  // 0 to 1; 0: not touched
};

// Everything is as it is predicted to be when the frame is displayed.
struct XrFrame {
    double display_s = 0;  // from the session's start
    XrEye eyes[2];         // left, right
    XrController drawing, other;
    uint32_t missed = 0;  // displays since the frame before that had to show an old picture
};

class XrSource {
public:
    virtual ~XrSource() = default;

    virtual double period_s() const = 0;  // between displays
    // Waits until it is time to begin the next frame. False: the session is over.
    virtual bool wait_frame(XrFrame& out_frame) = 0;
    // Around all that is drawn.
    virtual void begin_frame() = 0;
    virtual void end_frame() = 0;
};

// The camera of one eye.
inline render::Camera camera_of(const XrEye& eye) {
    render::Camera camera;
    camera.eye = eye.pose.position;
    camera.target = eye.pose.position + eye.pose.orientation * glm::vec3(0, 0, -1);
    camera.up = eye.pose.orientation * glm::vec3(0, 1, 0);
    camera.field = eye.field;
    return camera;
}

}  // namespace flg::samples
