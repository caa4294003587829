// SPDX-License-Identifier: MIT
#include "splines/motion_view.h"

#include <cmath>
#include <utility>

#include "splines/bodies.h"

namespace flg::studio::splines {
namespace {

constexpr glm::vec3 kPale{0.78f, 0.74f, 0.66f}, kPath{0.85f, 0.36f, 0.03f};
constexpr float kGhostFade = 0.72f, kKeyFade = 0.35f;
constexpr float kPathRadius = 0.012f;  // of the body's length
// Keys are left out of the ghosts' row: a ghost nearer than this to one, in shares of the ghosts' distance, is not
// drawn.
constexpr double kApart = 0.3;

render::SurfaceLook body_look() {
    render::SurfaceLook look;
    look.material.roughness = 0.5f;
    return look;
}

}  // namespace

void LiveMotion::remove() {
    app_.renderer.remove(std::exchange(body_, {}));
    app_.renderer.remove(std::exchange(ghosts_, {}));
    app_.renderer.remove(std::exchange(path_, {}));
}

void LiveMotion::show_ghosts(const Motion& motion) {
    const samples::Body& body = unit_body(motion.body);
    const FoundMotion& found = solver_.found();
    samples::Copies copies;
    for (const Key& key : motion.keys)
        copies.add(body, rows_of({key.place, key.turn}, motion.size).data(), kPale, kKeyFade);
    const double apart = (found.end() - found.begin()) / (motion.ghosts + 1);
    for (int i = 1; i <= motion.ghosts && !found.poses.empty(); ++i) {
        const double seconds = found.begin() + i * apart;
        bool clear = true;
        for (const Key& key : motion.keys) clear = clear && std::abs(key.time - seconds) > kApart * apart;
        if (clear) copies.add(body, rows_of(found.at(seconds), motion.size).data(), kPale, kGhostFade);
    }
    const FlgMeshView view = copies.view();
    if (ghosts_.value == 0)
        ghosts_ = app_.renderer.upload(view, body_look());
    else
        app_.renderer.update(ghosts_, view, body_look());
}

void LiveMotion::show_path(const Motion& motion) {
    const FoundMotion& found = solver_.found();
    if (found.poses.size() < 2) {
        app_.renderer.remove(std::exchange(path_, {}));
        return;
    }
    std::vector<glm::vec3> places;
    for (const Pose& pose : found.poses) places.emplace_back(pose.place);
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, &places[0].x, 0, 0};
    const uint32_t offsets[] = {0, static_cast<uint32_t>(places.size())};
    const uint8_t flags[] = {static_cast<uint8_t>(found.closed ? FLG_CURVE_CLOSED : 0)};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.curve_flags = flags;
    view.columns = &column;
    view.column_count = 1;
    render::CurveLook look;
    look.shape = render::Shape::tube;
    look.color = look.color_end = kPath;
    look.radius = kPathRadius * static_cast<float>(motion.size);
    if (path_.value == 0)
        path_ = app_.renderer.upload(view, look);
    else
        app_.renderer.update(path_, view, look);
}

void LiveMotion::show_body(const Motion& motion, double seconds) {
    const FoundMotion& found = solver_.found();
    const Pose pose = !found.poses.empty() ? found.at(seconds) : Pose{motion.keys[0].place, motion.keys[0].turn};
    if (body_.value != 0 && pose.place == at_.place && pose.turn == at_.turn) return;
    at_ = pose;
    samples::Copies copy;
    copy.add(unit_body(motion.body), rows_of(pose, motion.size).data(), {}, 0.0f);
    if (body_.value == 0)
        body_ = app_.renderer.upload(copy.view(), body_look());
    else
        app_.renderer.update(body_, copy.view(), body_look());
}

void LiveMotion::update(const Motion& motion, const std::vector<Obstacle>& obstacles, double seconds) {
    if (motion.keys.size() > 1)
        solver_.want(problem_of(motion, obstacles), motion.name);
    else
        solver_.want(std::nullopt, motion.name);
    solver_.update();
    Shown wanted{solver_.version(), motion.keys, motion.body,
                 motion.ghosts,     motion.size, motion.visible && !motion.keys.empty() && app_.scene.in_sight()};
    if (wanted != shown_) {
        const bool other_body = wanted.body != shown_.body || wanted.size != shown_.size || !wanted.visible;
        shown_ = std::move(wanted);
        if (other_body) remove();
        if (shown_.visible) {
            show_ghosts(motion);
            show_path(motion);
        }
    }
    if (shown_.visible) show_body(motion, seconds);
}

}  // namespace flg::studio::splines
