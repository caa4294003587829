// SPDX-License-Identifier: MIT
#include "camera_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "documents/failure.h"
#include "documents/motion_file.h"
#include "spline_obstacles.h"

namespace flg::cli {

CameraMotion::CameraMotion(const std::string& file, const std::string& obstacles, Session& session, Report& report) {
    const MotionFile keys = read_motion_file(file);
    FlgMotionDesc desc = desc_of(keys);
    SplineObstacles around;
    if (!obstacles.empty()) {
        around = read_obstacles(session, obstacles, 3, report);
        desc.obstacles = around.handle;
        desc.sides = around.sides.data();
        desc.side_count = static_cast<uint32_t>(around.sides.size());
    }
    FlgMotion motion = {};
    FlgJob job = {};
    check(flgMotionCreate(session.context(), &desc, &motion, &job), file);
    session.finish({{{job, file}}}, report);
    view_ = flgMotionViewDefaults();
    check(flgMotionGetView(session.context(), motion, &view_), file);
    report.counts["keys"] = view_.key_count;
    report.counts["positions"] = view_.position_count;
}

render::Camera CameraMotion::at(double time, const glm::vec3& middle) const {
    if (closed())
        time = begin() + std::fmod(std::fmod(time - begin(), end() - begin()) + end() - begin(), end() - begin());
    const double* const times = view_.times;
    const auto after = static_cast<uint32_t>(std::upper_bound(times, times + position_count(), time) - times);
    const uint32_t second = std::clamp(after, 1u, position_count() - 1), first = second - 1;
    const double share = std::clamp((time - times[first]) / (times[second] - times[first]), 0.0, 1.0);
    std::array<double, 12> pose;
    for (uint32_t c = 0; c < 12; ++c) {
        const double from = view_.poses[size_t{12} * first + c];
        pose[c] = from + share * (view_.poses[size_t{12} * (second % view_.position_count) + c] - from);
    }
    const auto column = [&](uint32_t c) {
        return glm::vec3(static_cast<float>(pose[c]), static_cast<float>(pose[4 + c]), static_cast<float>(pose[8 + c]));
    };
    render::Camera camera;
    camera.eye = column(3);
    const float away = glm::length(middle - camera.eye);
    camera.target = camera.eye - (away > 0 ? away : 1.0f) * glm::normalize(column(2));
    camera.up = glm::normalize(column(1));
    return camera;
}

}  // namespace flg::cli
