// SPDX-License-Identifier: MIT
#include "splines/hand.h"

#include <algorithm>
#include <cmath>

namespace flg::studio::splines {
namespace {

constexpr float kClick = 3.0f;          // of the layout: a click stays within
constexpr double kCoincide = 2e-3;      // of the scene's size: points in a row are farther apart
constexpr double kHover = 0.35;         // of a body's length, over the surface
constexpr double kLongestSlope = 12.0;  // of the curve's own speed, 1
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

glm::dvec3 Hand::towards_viewer() const {
    const render::Camera& camera = stage_.desk.view.orbit.camera;
    return glm::normalize(glm::dvec3(camera.eye - camera.target));
}

Ground Hand::ground_under(glm::vec2 px) const {
    if (stage_.ground.kind == "mesh") {
        if (const auto hit = stage_.desk.scene.hit(stage_.desk.view.ray(px))) return {"mesh", hit->mesh->id};
    }
    return stage_.ground_now();
}

void Hand::pointer(const Pointer& mouse) {
    if (mouse.pressed) {
        hot_ = find_handle(stage_, mouse.px);
        rests_since_ = stage_.desk.seconds;
        press(mouse);
        return;
    }
    if (stage_.dragging && mouse.down) drag(mouse);
    if (stage_.dragging && !mouse.down) drop();
    const Handle before = hot_;
    if (!stage_.dragging) hot_ = mouse.inside && !mouse.down ? find_handle(stage_, mouse.px) : Handle{};
    if (stage_.dragging || hot_ != before) rests_since_ = stage_.desk.seconds;
}

void Hand::press(const Pointer& mouse) {
    pressed_px_ = mouse.px;
    moved_ = fresh_ = answers_ = false;
    if (hot_.grip == Grip::solid || hot_.grip == Grip::solid_end || hot_.grip == Grip::solid_size)
        take_solid(hot_);
    else if (stage_.tool == Tool::curves)
        press_curves(mouse);
    else if (stage_.tool == Tool::obstacles)
        press_obstacles(mouse);
    else
        press_motions(mouse);
}

void Hand::take(const Handle& handle, const glm::dvec3& place) {
    hot_ = handle;
    stage_.dragging = true;
    offset_px_ = glm::vec2(0.0f);
    if (const auto at = stage_.desk.view.project(place); at && !fresh_) offset_px_ = pressed_px_ - *at;
}

// ---- Curves

void Hand::press_curves(const Pointer& mouse) {
    Curve* const chosen = stage_.chosen_curve();
    if (mouse.double_clicked && stage_.drawing != 0) {
        stage_.end_drawing();
        return;
    }
    switch (hot_.grip) {
        case Grip::point: {
            const bool drawn = stage_.drawing == chosen->id;
            const bool last = hot_.index + 1 == static_cast<int>(chosen->points.size());
            answers_ = !chosen->closed && (drawn ? hot_.index == 0 && chosen->points.size() > 2 : last);
            stage_.point = hot_.index;
            take(hot_, chosen->points[static_cast<size_t>(hot_.index)]);
            return;
        }
        case Grip::span: {
            const size_t after = static_cast<size_t>(hot_.index) + 1;
            const auto place = stage_.grounds.follow(chosen->ground, stage_.desk.view.ray(mouse.px),
                                                     chosen->points[static_cast<size_t>(hot_.index)]);
            if (!place) return;
            chosen->points.insert(chosen->points.begin() + static_cast<std::ptrdiff_t>(after), place->position);
            stage_.point = static_cast<int>(after);
            fresh_ = true;
            take({Grip::point, chosen->id, stage_.point}, place->position);
            return;
        }
        case Grip::begin_slope:
        case Grip::end_slope:
            if (const auto tip = slope_tip(stage_, *chosen, hot_.grip == Grip::begin_slope)) take(hot_, *tip);
            return;
        case Grip::curve: stage_.choose_curve(hot_.item); return;
        default: add_point(mouse.px);
    }
}

void Hand::add_point(glm::vec2 px) {
    Curve* curve = stage_.document.curve(stage_.drawing);
    const Ground ground = curve != nullptr ? curve->ground : ground_under(px);
    const Ray ray = stage_.desk.view.ray(px);
    const glm::dvec3 anchor = curve != nullptr && !curve->points.empty()
                                  ? curve->points.back()
                                  : glm::dvec3(stage_.desk.view.orbit.camera.target);
    const auto place = stage_.grounds.meet(ground, ray, anchor);
    if (!place) {
        if (curve != nullptr && stage_.desk.scene.hit(ray)) {
            stage_.desk.notices.add(Weight::info, curve->name + " stays on " + stage_.grounds.title(curve->ground) +
                                                      ". Press Enter to end it, then begin another one here.");
        }
        return;
    }
    if (curve == nullptr) curve = &stage_.add_curve(ground);
    const bool there = std::any_of(curve->points.begin(), curve->points.end(), [&](const glm::dvec3& p) {
        return glm::distance(p, place->position) < kCoincide * stage_.size();
    });
    if (there) return;
    curve->points.push_back(place->position);
    stage_.point = static_cast<int>(curve->points.size()) - 1;
    fresh_ = true;
    take({Grip::point, curve->id, stage_.point}, place->position);
}

void Hand::drag_slope(const Ray& ray, Curve& curve) {
    const bool begin = hot_.grip == Grip::begin_slope;
    const glm::dvec3 at = begin ? curve.points.front() : curve.points.back();
    const glm::dvec3 normal = curve.ground.kind == "space" ? towards_viewer() : stage_.grounds.normal(curve.ground, at);
    const auto tip = meet_plane(ray, glm::vec3(at), glm::vec3(normal));
    if (!tip) return;
    glm::dvec3 slope = (glm::dvec3(*tip) - at) / slope_length(stage_);
    const double length = glm::length(slope);
    if (!(length > 1e-3)) return;
    if (length > kLongestSlope) slope *= kLongestSlope / length;
    (begin ? curve.begin_slope : curve.end_slope) = slope;
}

// ---- Obstacles

void Hand::take_solid(const Handle& handle) {
    stage_.obstacle = handle.item;
    held_solid_ = *stage_.chosen_obstacle();
    const Ground ground = stage_.ground_now();
    on_ground_ = false;
    if (ground.kind != "space") {
        const double slack = 0.5 * reach_of(held_solid_);
        if (const Shape* const shape = find_shape(ground.kind)) {
            const auto place = nearest(*shape, held_solid_.centre);
            on_ground_ = place && glm::distance(place->position, held_solid_.centre) < slack;
        } else if (const SceneMesh* const mesh = stage_.desk.scene.find(ground.mesh); mesh != nullptr && mesh->ready) {
            const auto hit = stage_.desk.scene.nearest(*mesh, glm::vec3(held_solid_.centre));
            on_ground_ = hit && glm::distance(glm::dvec3(hit->position()), held_solid_.centre) < slack;
        }
    }
    take(handle, handle.grip == Grip::solid_end    ? held_solid_.to
                 : handle.grip == Grip::solid_size ? size_handle(stage_, held_solid_)
                                                   : held_solid_.centre);
}

void Hand::press_obstacles(const Pointer& mouse) {
    const Ground ground = ground_under(mouse.px);
    const glm::dvec3 anchor = stage_.desk.view.orbit.camera.target;
    auto place = stage_.grounds.meet(ground, stage_.desk.view.ray(mouse.px), anchor);
    // Beside the surface it is put into space.
    if (!place) place = stage_.grounds.meet({"space", 0}, stage_.desk.view.ray(mouse.px), anchor);
    if (!place) return;
    const Obstacle& added = stage_.add_obstacle(stage_.kind, place->position);
    fresh_ = true;
    take_solid({Grip::solid, added.id, 0});
}

void Hand::drag_solid(const Ray& ray, Obstacle& obstacle) {
    const double least = kSmallest * stage_.size();
    if (hot_.grip == Grip::solid) {
        std::optional<Place> place;
        if (on_ground_)
            place = stage_.grounds.meet(ground_under(stage_.desk.view.project(obstacle.centre).value_or(pressed_px_)),
                                        ray, obstacle.centre);
        if (!place) place = stage_.grounds.meet({"space", 0}, ray, obstacle.centre);
        if (!place) return;
        obstacle.to += place->position - obstacle.centre;
        obstacle.centre = place->position;
        return;
    }
    const glm::dvec3 through = hot_.grip == Grip::solid_end ? held_solid_.to : obstacle.centre;
    const auto at = meet_plane(ray, glm::vec3(through), glm::vec3(towards_viewer()));
    if (!at) return;
    if (hot_.grip == Grip::solid_end) {
        obstacle.to = *at;
        return;
    }
    const double far = std::max(glm::distance(glm::dvec3(*at), obstacle.centre), least);
    if (obstacle.kind == FLG_OBSTACLE_BOX)
        obstacle.half = glm::max(held_solid_.half * (far / reach_of(held_solid_)), glm::dvec3(least));
    else
        obstacle.radius = far;
}

// ---- Motions

void Hand::press_motions(const Pointer& mouse) {
    Motion* motion = stage_.chosen_motion();
    if (hot_.grip == Grip::key && motion != nullptr) {
        stage_.key = hot_.index;
        stage_.play(false);
        held_key_ = motion->keys[static_cast<size_t>(hot_.index)];
        stage_.seconds = held_key_.time;
        normal_ = stage_.grounds.normal(motion->ground, held_key_.place);
        take(hot_, held_key_.place);
        return;
    }
    if (hot_.grip == Grip::ring && motion != nullptr && stage_.key >= 0) {
        held_key_ = motion->keys[static_cast<size_t>(stage_.key)];
        angle_ = 0.0;
        fresh_ = true;  // the mouse is where it takes hold
        const Handle ring = hot_;
        take(ring, held_key_.place);
        turn_key(stage_.desk.view.ray(mouse.px), motion->keys[static_cast<size_t>(stage_.key)]);
        return;
    }
    const Ray ray = stage_.desk.view.ray(mouse.px);
    const bool first = motion == nullptr || motion->keys.empty();
    const Ground ground = motion != nullptr ? motion->ground : ground_under(mouse.px);
    const glm::dvec3 anchor = first ? glm::dvec3(stage_.desk.view.orbit.camera.target) : motion->keys.back().place;
    auto place = stage_.grounds.meet(ground, ray, anchor);
    const bool flies = !place || ground.kind == "space";
    if (!place) place = stage_.grounds.meet({"space", 0}, ray, anchor);
    if (!place) return;
    if (motion == nullptr) motion = &stage_.add_motion(ground);
    const glm::dvec3 up = flies ? glm::dvec3(0.0, 1.0, 0.0) : place->normal;
    const glm::dvec3 at = flies ? place->position : place->position + kHover * motion->size * up;
    const render::Camera& camera = stage_.desk.view.orbit.camera;
    const glm::dvec3 heading =
        first ? glm::dvec3(glm::cross(camera.target - camera.eye, camera.up)) : at - motion->keys.back().place;
    if (!first && glm::length(heading) < kCoincide * stage_.size()) return;
    held_key_ = stage_.add_key(*motion, at, up, heading);
    stage_.play(false);
    stage_.seconds = held_key_.time;
    normal_ = up;
    fresh_ = true;
    take({Grip::key, motion->id, stage_.key}, at);
}

void Hand::drag_key(const Ray& ray, Motion& motion) {
    Key& key = motion.keys[static_cast<size_t>(hot_.index)];
    const bool flies = motion.ground.kind == "space";
    if (fresh_) {
        // The drag that follows the click says where its nose points.
        const auto at = meet_plane(ray, glm::vec3(key.place), glm::vec3(flies ? towards_viewer() : normal_));
        if (!at) return;
        const glm::dvec3 heading = glm::dvec3(*at) - key.place;
        if (glm::length(heading) > kCoincide * stage_.size())
            key.turn = flies ? aimed(heading, {0.0, 1.0, 0.0}) : upright(normal_, heading);
        return;
    }
    if (!flies) {
        if (const auto place = stage_.grounds.meet(motion.ground, ray, held_key_.place)) {
            key.place = place->position + kHover * motion.size * place->normal;
            key.turn = glm::normalize(between(normal_, place->normal) * held_key_.turn);
            return;
        }
    }
    if (const auto place = stage_.grounds.meet({"space", 0}, ray, held_key_.place)) key.place = place->position;
}

void Hand::turn_key(const Ray& ray, Key& key) {
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

void Hand::drag(const Pointer& mouse) {
    moved_ = moved_ || glm::distance(mouse.px, pressed_px_) > kClick * stage_.desk.scale;
    if (!moved_) return;
    const Ray ray = stage_.desk.view.ray(mouse.px - offset_px_);
    if (Curve* const curve = stage_.document.curve(hot_.item)) {
        if (hot_.grip == Grip::begin_slope || hot_.grip == Grip::end_slope) {
            drag_slope(ray, *curve);
        } else {
            glm::dvec3& point = curve->points[static_cast<size_t>(hot_.index)];
            if (const auto place = stage_.grounds.follow(curve->ground, ray, point)) point = place->position;
        }
    } else if (Obstacle* const obstacle = stage_.document.obstacle(hot_.item)) {
        drag_solid(ray, *obstacle);
    } else if (Motion* const motion = stage_.document.motion(hot_.item)) {
        if (hot_.grip == Grip::ring)
            turn_key(ray, motion->keys[static_cast<size_t>(stage_.key)]);
        else
            drag_key(ray, *motion);
    }
}

void Hand::drop() {
    stage_.dragging = false;
    if (moved_ || !answers_) return;
    Curve* const curve = stage_.document.curve(hot_.item);
    if (curve == nullptr) return;
    if (stage_.drawing != curve->id) {
        stage_.drawing = curve->id;
        return;
    }
    curve->closed = true;
    stage_.end_drawing();
}

const char* Hand::tip() const {
    if (stage_.dragging || stage_.desk.seconds - rests_since_ < kRest_s) return "";
    switch (hot_.grip) {
        case Grip::point: {
            const Curve* const curve = stage_.document.curve(hot_.item);
            if (curve == nullptr) return "";
            const bool drawn = stage_.drawing == curve->id;
            if (!curve->closed && drawn && hot_.index == 0 && curve->points.size() > 2)
                return "Click to close the curve";
            if (!curve->closed && !drawn && hot_.index + 1 == static_cast<int>(curve->points.size()))
                return "Drag to move, click to go on from here, Delete to remove";
            return "Drag to move, Delete to remove";
        }
        case Grip::span: return "Press to put a point here, and drag it";
        case Grip::curve: return "Click to choose this curve";
        case Grip::begin_slope:
        case Grip::end_slope: return "Drag: the curve's direction at its end; farther out it goes straighter";
        case Grip::solid: return "Drag to move the obstacle, Delete to remove";
        case Grip::solid_end: return "Drag the capsule's other end";
        case Grip::solid_size: return "Drag to change its size";
        case Grip::key: return "Drag to move this key, Delete to remove";
        case Grip::ring: return "Drag to turn the body";
        case Grip::none: break;
    }
    return "";
}

}  // namespace flg::studio::splines
