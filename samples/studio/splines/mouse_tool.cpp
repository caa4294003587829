// SPDX-License-Identifier: MIT
#include "splines/mouse_tool.h"

#include <algorithm>
#include <cmath>

#include "shell/widgets.h"

namespace flg::studio::splines {
namespace {

constexpr float kClick = 3.0f;      // of the layout: a click stays within
constexpr double kCoincide = 2e-3;  // of the scene's size: points in a row are farther apart
constexpr double kHover = 0.35;     // of a body's length, over the surface
constexpr double kMaxSlope = 12.0;  // of the curve's own speed, 1
constexpr double kRest_s = 0.6;
constexpr double kSmallest = 2e-3;  // of the scene's size

// The shortest turn from one direction to another.
glm::dquat between(const glm::dvec3& from, const glm::dvec3& to) {
    const double cosine = glm::dot(from, to);
    if (cosine < -0.9999) return glm::dquat(1.0, 0.0, 0.0, 0.0);
    const glm::dvec3 axis = glm::cross(from, to);
    return glm::normalize(glm::dquat(1.0 + cosine, axis.x, axis.y, axis.z));
}

// A rotation with x along `heading`, y as near to `up` as that allows.
glm::dquat aimed(const glm::dvec3& heading, const glm::dvec3& up) {
    const glm::dvec3 x = glm::normalize(heading);
    glm::dvec3 z = glm::cross(x, up);
    if (!(glm::length(z) > 1e-6)) z = glm::cross(x, glm::dvec3(1.0, 0.0, 0.0));
    z = glm::normalize(z);
    return glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z)));
}

}  // namespace

glm::dvec3 MouseTool::towards_viewer() const {
    const render::Camera& camera = editor_.app.view.orbit.camera;
    return glm::normalize(glm::dvec3(camera.eye - camera.target));
}

SurfaceRef MouseTool::ground_under(glm::vec2 px) const {
    if (editor_.ground.kind == "mesh") {
        if (const auto hit = editor_.app.scene.hit(editor_.app.view.ray(px))) return {"mesh", hit->mesh->id};
    }
    return editor_.ground_now();
}

void MouseTool::pointer(const Pointer& mouse) {
    if (mouse.pressed) {
        hot_ = find_handle(editor_, mouse.px);
        rests_since_ = editor_.app.seconds;
        press(mouse);
        return;
    }
    if (editor_.dragging && mouse.down) drag(mouse);
    if (editor_.dragging && !mouse.down) drop();
    const Handle before = hot_;
    if (!editor_.dragging) hot_ = mouse.inside && !mouse.down ? find_handle(editor_, mouse.px) : Handle{};
    if (editor_.dragging || hot_ != before) rests_since_ = editor_.app.seconds;
}

void MouseTool::press(const Pointer& mouse) {
    pressed_px_ = mouse.px;
    moved_ = fresh_ = answers_ = false;
    if (hot_.kind == HandleKind::solid || hot_.kind == HandleKind::solid_end || hot_.kind == HandleKind::solid_size)
        take_solid(hot_);
    else if (editor_.tool == Tool::curves)
        press_curves(mouse);
    else if (editor_.tool == Tool::obstacles)
        press_obstacles(mouse);
    else
        press_motions(mouse);
}

void MouseTool::take(const Handle& handle, const glm::dvec3& place) {
    hot_ = handle;
    editor_.dragging = true;
    offset_px_ = glm::vec2(0.0f);
    if (const auto at = editor_.app.view.project(place); at && !fresh_) offset_px_ = pressed_px_ - *at;
}

// ---- Curves

void MouseTool::press_curves(const Pointer& mouse) {
    Curve* const chosen = editor_.chosen_curve();
    if (mouse.double_clicked && editor_.drawing != 0) {
        editor_.end_drawing();
        return;
    }
    if (hot_.kind != HandleKind::none) editor_.begins_new = false;
    switch (hot_.kind) {
        case HandleKind::point: {
            const bool drawn = editor_.drawing == chosen->id;
            const bool last = hot_.index + 1 == static_cast<int>(chosen->points.size());
            answers_ = !chosen->closed && (drawn ? hot_.index == 0 && chosen->points.size() > 2 : last);
            editor_.point = hot_.index;
            take(hot_, editor_.surfaces.to_world(chosen->ground, chosen->points[static_cast<size_t>(hot_.index)]));
            return;
        }
        case HandleKind::span: {
            const size_t after = static_cast<size_t>(hot_.index) + 1;
            const glm::dvec3& before = chosen->points[static_cast<size_t>(hot_.index)];
            const auto place = editor_.surfaces.follow(chosen->ground, editor_.app.view.ray(mouse.px),
                                                       editor_.surfaces.to_world(chosen->ground, before));
            if (!place) return;
            chosen->points.insert(chosen->points.begin() + static_cast<std::ptrdiff_t>(after),
                                  editor_.surfaces.to_own(chosen->ground, place->position));
            editor_.point = static_cast<int>(after);
            fresh_ = true;
            take({HandleKind::point, chosen->id, editor_.point}, place->position);
            return;
        }
        case HandleKind::begin_slope:
        case HandleKind::end_slope:
            if (const auto tip = slope_tip(editor_, *chosen, hot_.kind == HandleKind::begin_slope)) take(hot_, *tip);
            return;
        case HandleKind::curve: editor_.choose_curve(hot_.item); return;
        default: add_point(mouse.px);
    }
}

void MouseTool::add_point(glm::vec2 px) {
    Curve* curve = editor_.document.curve(editor_.drawing);
    const SurfaceRef ground = curve != nullptr ? curve->ground : ground_under(px);
    const Ray ray = editor_.app.view.ray(px);
    const glm::dvec3 anchor = curve != nullptr && !curve->points.empty()
                                  ? editor_.surfaces.to_world(ground, curve->points.back())
                                  : glm::dvec3(editor_.app.view.orbit.camera.target);
    const auto place = editor_.surfaces.meet(ground, ray, anchor);
    if (!place) {
        if (curve != nullptr && editor_.app.scene.hit(ray))
            editor_.app.notices.add(Weight::info, curve->name + " stays on " + editor_.surfaces.title(curve->ground) +
                                                      ". Press Enter to end it, then start another curve here.");
        else
            editor_.app.notices.add(Weight::info,
                                    "No surface here. Click on the surface, or choose another one under Stays on.");
        return;
    }
    if (curve == nullptr) curve = &editor_.add_curve(ground);
    const bool there = std::any_of(curve->points.begin(), curve->points.end(), [&](const glm::dvec3& p) {
        return glm::distance(editor_.surfaces.to_world(ground, p), place->position) < kCoincide * editor_.size();
    });
    if (there) return;
    curve->points.push_back(editor_.surfaces.to_own(ground, place->position));
    editor_.point = static_cast<int>(curve->points.size()) - 1;
    fresh_ = true;
    take({HandleKind::point, curve->id, editor_.point}, place->position);
}

void MouseTool::drag_slope(const Ray& ray, Curve& curve) {
    const bool begin = hot_.kind == HandleKind::begin_slope;
    const glm::dvec3 at = editor_.surfaces.to_world(curve.ground, begin ? curve.points.front() : curve.points.back());
    const glm::dvec3 normal =
        curve.ground.kind == "space" ? towards_viewer() : editor_.surfaces.normal(curve.ground, at);
    const auto tip = meet_plane(ray, glm::vec3(at), glm::vec3(normal));
    if (!tip) return;
    glm::dvec3 slope = (glm::dvec3(*tip) - at) / slope_length(editor_);
    const double length = glm::length(slope);
    if (!(length > 1e-3)) return;
    if (length > kMaxSlope) slope *= kMaxSlope / length;
    (begin ? curve.begin_slope : curve.end_slope) =
        glm::conjugate(glm::dquat(editor_.surfaces.placement(curve.ground).turn)) * slope;
}

// ---- Obstacles

void MouseTool::take_solid(const Handle& handle) {
    editor_.obstacle = handle.item;
    held_solid_ = *editor_.chosen_obstacle();
    const SurfaceRef ground = editor_.ground_now();
    on_ground_ = false;
    if (ground.kind != "space") {
        const double slack = 0.5 * reach_of(held_solid_);
        if (const Shape* const shape = find_shape(ground.kind)) {
            const auto place = nearest(*shape, held_solid_.centre);
            on_ground_ = place && glm::distance(place->position, held_solid_.centre) < slack;
        } else if (const SceneMesh* const mesh = editor_.app.scene.find(ground.mesh); mesh != nullptr && mesh->ready) {
            const auto hit = editor_.app.scene.nearest(*mesh, glm::vec3(held_solid_.centre));
            on_ground_ = hit && glm::distance(glm::dvec3(hit->position()), held_solid_.centre) < slack;
        }
    }
    take(handle, handle.kind == HandleKind::solid_end    ? held_solid_.to
                 : handle.kind == HandleKind::solid_size ? size_handle(editor_, held_solid_)
                                                         : held_solid_.centre);
}

void MouseTool::press_obstacles(const Pointer& mouse) {
    const SurfaceRef ground = ground_under(mouse.px);
    const glm::dvec3 anchor = editor_.app.view.orbit.camera.target;
    auto place = editor_.surfaces.meet(ground, editor_.app.view.ray(mouse.px), anchor);
    // Beside the surface it is put into space.
    if (!place) place = editor_.surfaces.meet({"space", 0}, editor_.app.view.ray(mouse.px), anchor);
    if (!place) return;
    const Obstacle& added = editor_.add_obstacle(editor_.kind, place->position);
    fresh_ = true;
    take_solid({HandleKind::solid, added.id, 0});
}

void MouseTool::drag_solid(const Ray& ray, Obstacle& obstacle) {
    const double least = kSmallest * editor_.size();
    if (hot_.kind == HandleKind::solid) {
        std::optional<Place> place;
        if (on_ground_)
            place = editor_.surfaces.meet(ground_under(editor_.app.view.project(obstacle.centre).value_or(pressed_px_)),
                                          ray, obstacle.centre);
        if (!place) place = editor_.surfaces.meet({"space", 0}, ray, obstacle.centre);
        if (!place) return;
        obstacle.to += place->position - obstacle.centre;
        obstacle.centre = place->position;
        return;
    }
    const glm::dvec3 through = hot_.kind == HandleKind::solid_end ? held_solid_.to : obstacle.centre;
    const auto at = meet_plane(ray, glm::vec3(through), glm::vec3(towards_viewer()));
    if (!at) return;
    if (hot_.kind == HandleKind::solid_end) {
        obstacle.to = *at;
        return;
    }
    const double far = std::max(glm::distance(glm::dvec3(*at), obstacle.centre), least);
    if (obstacle.kind == FLG_OBSTACLE_KIND_BOX)
        obstacle.half = glm::max(held_solid_.half * (far / reach_of(held_solid_)), glm::dvec3(least));
    else
        obstacle.radius = far;
}

// ---- Motions

void MouseTool::press_motions(const Pointer& mouse) {
    Motion* motion = editor_.chosen_motion();
    if (hot_.kind == HandleKind::key && motion != nullptr) {
        editor_.key = hot_.index;
        editor_.play(false);
        held_key_ = motion->keys[static_cast<size_t>(hot_.index)];
        editor_.seconds = held_key_.time;
        normal_ = editor_.surfaces.normal(motion->ground, held_key_.place);
        take(hot_, held_key_.place);
        return;
    }
    if (hot_.kind == HandleKind::ring && motion != nullptr && editor_.key >= 0) {
        held_key_ = motion->keys[static_cast<size_t>(editor_.key)];
        angle_ = 0.0;
        fresh_ = true;  // the mouse is where it takes hold
        const Handle ring = hot_;
        take(ring, held_key_.place);
        turn_key(editor_.app.view.ray(mouse.px), motion->keys[static_cast<size_t>(editor_.key)]);
        return;
    }
    const Ray ray = editor_.app.view.ray(mouse.px);
    const bool first = motion == nullptr || motion->keys.empty();
    const SurfaceRef ground = motion != nullptr ? motion->ground : ground_under(mouse.px);
    const glm::dvec3 anchor = first ? glm::dvec3(editor_.app.view.orbit.camera.target) : motion->keys.back().place;
    auto place = editor_.surfaces.meet(ground, ray, anchor);
    const bool flies = !place || ground.kind == "space";
    if (!place) place = editor_.surfaces.meet({"space", 0}, ray, anchor);
    if (!place) return;
    if (motion == nullptr) motion = &editor_.add_motion(ground);
    const glm::dvec3 up = flies ? glm::dvec3(0.0, 1.0, 0.0) : place->normal;
    const glm::dvec3 at = flies ? place->position : place->position + kHover * motion->size * up;
    const render::Camera& camera = editor_.app.view.orbit.camera;
    const glm::dvec3 heading =
        first ? glm::dvec3(glm::cross(camera.target - camera.eye, camera.up)) : at - motion->keys.back().place;
    if (!first && glm::length(heading) < kCoincide * editor_.size()) return;
    held_key_ = editor_.add_key(*motion, at, up, heading);
    editor_.play(false);
    editor_.seconds = held_key_.time;
    normal_ = up;
    fresh_ = true;
    take({HandleKind::key, motion->id, editor_.key}, at);
}

void MouseTool::drag_key(const Ray& ray, Motion& motion) {
    Key& key = motion.keys[static_cast<size_t>(hot_.index)];
    const bool flies = motion.ground.kind == "space";
    if (fresh_) {
        // The drag that follows the click says where its nose points.
        const auto at = meet_plane(ray, glm::vec3(key.place), glm::vec3(flies ? towards_viewer() : normal_));
        if (!at) return;
        const glm::dvec3 heading = glm::dvec3(*at) - key.place;
        if (glm::length(heading) > kCoincide * editor_.size())
            key.turn = flies ? aimed(heading, {0.0, 1.0, 0.0}) : upright(normal_, heading);
        return;
    }
    if (!flies) {
        if (const auto place = editor_.surfaces.meet(motion.ground, ray, held_key_.place)) {
            key.place = place->position + kHover * motion.size * place->normal;
            key.turn = glm::normalize(between(normal_, place->normal) * held_key_.turn);
            return;
        }
    }
    if (const auto place = editor_.surfaces.meet({"space", 0}, ray, held_key_.place)) key.place = place->position;
}

void MouseTool::turn_key(const Ray& ray, Key& key) {
    const glm::dmat3 axes = glm::mat3_cast(held_key_.turn);
    const glm::dvec3 axis = axes[hot_.index];
    const glm::dvec3 u = axes[(hot_.index + 1) % 3], v = axes[(hot_.index + 2) % 3];
    const auto at = meet_plane(ray, glm::vec3(key.place), glm::vec3(axis));
    if (!at) return;
    const glm::dvec3 arm = glm::dvec3(*at) - key.place;
    const double angle = std::atan2(glm::dot(arm, v), glm::dot(arm, u));
    if (!moved_) {
        angle_ = angle;
        return;
    }
    key.turn = glm::normalize(glm::angleAxis(angle - angle_, axis) * held_key_.turn);
}

// ---- All

void MouseTool::drag(const Pointer& mouse) {
    moved_ = moved_ || glm::distance(mouse.px, pressed_px_) > kClick * editor_.app.scale;
    if (!moved_) return;
    const Ray ray = editor_.app.view.ray(mouse.px - offset_px_);
    if (Curve* const curve = editor_.document.curve(hot_.item)) {
        if (hot_.kind == HandleKind::begin_slope || hot_.kind == HandleKind::end_slope) {
            drag_slope(ray, *curve);
        } else {
            glm::dvec3& point = curve->points[static_cast<size_t>(hot_.index)];
            if (const auto place =
                    editor_.surfaces.follow(curve->ground, ray, editor_.surfaces.to_world(curve->ground, point)))
                point = editor_.surfaces.to_own(curve->ground, place->position);
        }
    } else if (Obstacle* const obstacle = editor_.document.obstacle(hot_.item)) {
        drag_solid(ray, *obstacle);
    } else if (Motion* const motion = editor_.document.motion(hot_.item)) {
        if (hot_.kind == HandleKind::ring)
            turn_key(ray, motion->keys[static_cast<size_t>(editor_.key)]);
        else
            drag_key(ray, *motion);
    }
}

void MouseTool::drop() {
    editor_.dragging = false;
    if (moved_ || !answers_) return;
    Curve* const curve = editor_.document.curve(hot_.item);
    if (curve == nullptr) return;
    if (editor_.drawing != curve->id) {
        editor_.drawing = curve->id;
        return;
    }
    curve->closed = true;
    editor_.end_drawing();
}

const char* MouseTool::tip() const {
    if (editor_.dragging || hot_.kind == HandleKind::none) return "";
    const double left_s = kRest_s - (editor_.app.seconds - rests_since_);
    if (left_s > 0.0) {
        ui::frame_in(left_s);
        return "";
    }
    switch (hot_.kind) {
        case HandleKind::point: {
            const Curve* const curve = editor_.document.curve(hot_.item);
            if (curve == nullptr) return "";
            const bool drawn = editor_.drawing == curve->id;
            if (!curve->closed && drawn && hot_.index == 0 && curve->points.size() > 2)
                return "Click to close the curve";
            if (!curve->closed && !drawn && hot_.index + 1 == static_cast<int>(curve->points.size()))
                return "Drag to move, click to continue from here, Delete to remove";
            return "Drag to move, Delete to remove";
        }
        case HandleKind::span: return "Press to insert a point, then drag it";
        case HandleKind::curve: return "Click to select this curve";
        case HandleKind::begin_slope:
        case HandleKind::end_slope: return "Drag to set the direction of the curve at its end";
        case HandleKind::solid: return "Drag to move the obstacle, Delete to remove";
        case HandleKind::solid_end: return "Drag to move the capsule's other end";
        case HandleKind::solid_size: return "Drag to resize";
        case HandleKind::key: return "Drag to move this key, Delete to remove";
        case HandleKind::ring: return "Drag to turn the body";
        case HandleKind::none: break;
    }
    return "";
}

}  // namespace flg::studio::splines
