// SPDX-License-Identifier: MIT
// Smooth motions of rigid bodies (Hofer, Pottmann: Energy-minimizing splines in manifolds, 2004, sec. 4 and 5).
#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "filigree/filigree_motion.h"
#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "support/bodies.h"

namespace flg::gallery {
namespace {

using samples::Body, samples::Copies, samples::moved_by;

constexpr glm::vec3 kPale = {0.78f, 0.74f, 0.66f}, kBlue = {0.03f, 0.13f, 0.50f}, kStone = {0.33f, 0.36f, 0.38f};

using Pose = std::array<double, 12>;

Pose pose_of(const glm::dvec3& place, const glm::dquat& turn) {
    const glm::dmat3 m = glm::mat3_cast(turn);  // by columns
    return {m[0][0], m[1][0], m[2][0], place.x, m[0][1], m[1][1], m[2][1], place.y, m[0][2], m[1][2], m[2][2], place.z};
}

glm::dquat about(const glm::dvec3& axis, double degrees) {
    return glm::angleAxis(glm::radians(degrees), glm::normalize(axis));
}

// Keys a second apart, and what is asked of the motion through them.
struct Keys {
    std::vector<Pose> poses;
    std::vector<double> times{};
    FlgMotionDesc desc = flgMotionDefaults();
};

filigree::Motion motion_of(Workshop& workshop, const Body& body, Keys& keys, uint32_t positions) {
    keys.times.clear();
    for (size_t i = 0; i < keys.poses.size(); ++i) keys.times.push_back(static_cast<double>(i));
    keys.desc.key_count = static_cast<uint32_t>(keys.poses.size());
    keys.desc.times = keys.times.data();
    keys.desc.poses = keys.poses[0].data();
    keys.desc.body_points = &body.positions[0].x;
    keys.desc.body_point_count = static_cast<uint32_t>(body.positions.size());
    keys.desc.position_count = positions;
    return workshop.finished(workshop.context().motion(keys.desc));
}

std::vector<Pose> poses_of(const filigree::Motion& motion) {
    const FlgMotionView view = motion.view();
    std::vector<Pose> poses(view.position_count);
    std::copy_n(view.poses, 12 * poses.size(), poses[0].data());
    return poses;
}

// Pictures of motions that are kept until they are taken.
class Show {
public:
    explicit Show(Workshop& workshop) : workshop_(workshop) { panel_.ground = false; }

    void copies(const Body& body, const std::vector<Pose>& poses, float fade) {
        Copies& all = copies_.emplace_back();
        for (const Pose& pose : poses) all.add(body, pose.data(), kPale, fade);
        render::SurfaceLook look;
        look.material.roughness = 0.55f;
        panel_.surfaces.push_back({all.view(), look});
    }
    // The way of a point of the body.
    double path(const std::vector<Pose>& poses, const glm::dvec3& point, glm::vec3 color, float radius, bool closed) {
        scenes::Curve curve;
        curve.closed = closed;
        double length = 0.0;
        glm::dvec3 last(0.0);
        for (const Pose& pose : poses) {
            const glm::dvec3 at = moved_by(pose.data(), point);
            if (!curve.points.empty()) length += glm::distance(at, last);
            curve.points.push_back(to_point(at));
            last = at;
        }
        add({curve}, color, radius);
        return length;
    }
    void balls(const std::vector<Pose>& poses, const glm::dvec3& point, glm::vec3 color, float radius) {
        std::vector<scenes::Curve> curves;
        for (const Pose& pose : poses) curves.push_back(dot(moved_by(pose.data(), point)));
        add(curves, color, radius);
    }
    void add(const std::vector<scenes::Curve>& curves, glm::vec3 color, float radius) {
        render::CurveLook look = tube(color, radius);
        look.sides = 32;
        look.gloss = 0.2f;
        sets_.push_back(workshop_.curves(curves));
        panel_.layers.push_back({Columns(sets_.back().view()).without(FLG_ATTRIBUTE_COLOR), look});
    }
    Panel& panel() { return panel_; }

private:
    Workshop& workshop_;
    Panel panel_;
    std::deque<Copies> copies_;
    std::deque<filigree::CurveSet> sets_;
};

std::vector<Pose> every(const std::vector<Pose>& poses, size_t step, size_t first = 0) {
    std::vector<Pose> some;
    for (size_t i = first; i < poses.size(); i += step) some.push_back(poses[i]);
    return some;
}

std::vector<Panel> panels_of(std::deque<Show>& shows, bool together = true) {
    std::vector<Panel> panels;
    for (Show& show : shows) panels.push_back(show.panel());
    if (together) aim_together(panels);
    return panels;
}

// Fig. 9: between two positions, the free motion of the body, and a turn about one axis at constant speed.
void shortest(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kPositions = 161, kEvery = 16;
    const Body body = samples::oar();
    const glm::dvec3 from(-0.9, 0.0, 0.0), to(0.9, 0.0, 0.0), tip = 1.1 * glm::dvec3(1.0, 0.0, 0.0);
    const glm::dquat first = about({0, 0, 1}, 130.0), last = about({0, 0, 1}, 50.0) * about({1, 0, 0}, 170.0);
    Keys keys{{pose_of(from, first), pose_of(to, last)}};
    keys.desc.energy = FLG_SPLINE_ENERGY_E1;
    const std::vector<Pose> free = poses_of(motion_of(workshop, body, keys, kPositions));
    std::vector<Pose> turned;
    for (uint32_t i = 0; i < kPositions; ++i) {
        const double t = i / (kPositions - 1.0);
        turned.push_back(pose_of(glm::mix(from, to, t), glm::slerp(first, last, t)));
    }
    std::deque<Show> shows;
    for (const bool is_free : {true, false}) {
        Show& show = shows.emplace_back(workshop);
        const std::vector<Pose>& own = is_free ? free : turned;
        const std::vector<Pose> copies = every(own, kEvery);
        show.copies(body, {copies.front(), copies.back()}, 0.0f);
        show.copies(body, {copies.begin() + 1, copies.end() - 1}, 0.45f);
        const double lengths[] = {show.path(free, tip, kBlue, is_free ? 0.022f : 0.009f, false),
                                  show.path(turned, tip, kGold, is_free ? 0.009f : 0.022f, false)};
        if (is_free)
            std::printf("blade: %.2f m by the metric of the body, %.2f m by quaternions\n", lengths[0], lengths[1]);
        show.panel().sight = {0.55f, -0.75f, -1.0f};
    }
    std::vector<Panel> panels = panels_of(shows);
    entitle(panels, {"By how far its points go", "Turned about one axis"});
    studio.take("motion_shortest", panels, 2, kWidth, 400);
}

// Fig. 10: one body through the same four positions and back, by three energies.
void cyclic(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kPositions = 240, kEvery = 15;
    const Body body = samples::hammer();
    Keys keys;
    for (int i = 0; i < 4; ++i) {
        const double a = 90.0 * i, r = 1.6;
        const glm::dvec3 place(r * std::cos(glm::radians(a)), 0.5 * (i % 2), -r * std::sin(glm::radians(a)));
        keys.poses.push_back(pose_of(
            place, about({0, 1, 0}, a) * about({1, 0, 0}, i % 2 == 0 ? -70.0 : 60.0) * about({0, 0, 1}, 40.0 * i)));
    }
    keys.desc.closed = 1;
    keys.desc.tension = 60.0;
    std::deque<Show> shows;
    for (const auto& [energy, title] :
         {std::pair{FLG_SPLINE_ENERGY_E2, "E2: bends least"}, std::pair{FLG_SPLINE_ENERGY_ET, "E2 + 60 E1: tighter"},
          std::pair{FLG_SPLINE_ENERGY_E1, "E1: shortest, flies freely between"}}) {
        keys.desc.energy = energy;
        const std::vector<Pose> poses = poses_of(motion_of(workshop, body, keys, kPositions));
        Show& show = shows.emplace_back(workshop);
        show.copies(body, keys.poses, 0.0f);
        show.copies(body, every(poses, kEvery), 0.6f);
        show.path(poses, {0.0, -0.62, 0.0}, kBlue, 0.03f, true);
        show.panel().sight = {-0.15f, -1.3f, -0.9f};
        show.panel().margin = 1.05f;
        show.panel().title = title;
    }
    shows[0].panel().keys = {{kRed, "four given positions"}, {kBlue, "way of the handle's end"}};
    studio.take("motion_cyclic", panels_of(shows), 3, kWidth, 400);
}

// Fig. 11: a motion as it was measured, and the smooth one near it.
void smoothed(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kKeys = 30;
    const Body body = samples::glider();
    std::mt19937 random(11);
    std::normal_distribution<double> noise;
    Keys keys;
    for (uint32_t i = 0; i < kKeys; ++i) {
        const double t = i / (kKeys - 1.0), x = 15.0 * t;
        const glm::dvec3 place(x, 0.9 * std::sin(7.0 * t), 1.5 * std::sin(6.3 * t));
        const double climb = std::atan2(6.3 * std::cos(7.0 * t), 15.0),
                     turn = std::atan2(-9.4 * std::cos(6.3 * t), 15.0);
        const glm::dquat way = about({0, 1, 0}, glm::degrees(turn)) * about({0, 0, 1}, glm::degrees(climb)) *
                               about({1, 0, 0}, 45.0 * std::sin(6.3 * t));
        const glm::dvec3 axis(noise(random), noise(random), noise(random));
        const glm::dvec3 shake(0.04 * noise(random), 0.13 * noise(random), 0.13 * noise(random));
        keys.poses.push_back(pose_of(place + shake, about(axis, 15.0 * noise(random)) * way));
    }
    keys.desc.smoothing = 12.0;
    const uint32_t positions = 8 * (kKeys - 1) + 1;
    const filigree::Motion motion = motion_of(workshop, body, keys, positions);
    const std::vector<Pose> smooth = poses_of(motion);
    std::vector<Pose> at_keys;
    for (uint32_t k = 0; k < kKeys; ++k) at_keys.push_back(smooth[motion.view().key_positions[k]]);
    const glm::dvec3 nose(0.6, 0.05, 0.0);
    std::deque<Show> shows;
    for (const bool is_smooth : {false, true}) {
        Show& show = shows.emplace_back(workshop);
        show.copies(body, is_smooth ? at_keys : keys.poses, 0.0f);
        show.path(is_smooth ? smooth : keys.poses, nose, is_smooth ? kBlue : kGold, 0.022f, false);
        show.panel().sight = {0.0f, -1.0f, -0.75f};
        show.panel().margin = 1.03f;
    }
    std::vector<Panel> panels = panels_of(shows);
    entitle(panels, {"As measured", "Smoothed"});
    studio.take("motion_smoothed", panels, 1, kWidth, 480);
}

// Fig. 16: a motion as it would be, and one that keeps out of five obstacles, twice.
void obstacles(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kPositions = 271, kEvery = 18;
    const Body body = samples::top();
    Keys keys{{pose_of({-1.9, -0.8, 0.3}, about({0, 0, 1}, 0.0)), pose_of({-0.8, 0.9, -0.9}, about({1, 1, 0}, 100.0)),
               pose_of({0.8, -0.9, 0.9}, about({0, 1, 1}, 170.0)), pose_of({2.1, 0.7, -0.2}, about({1, 0, 1}, 80.0))}};
    const filigree::Motion unconstrained = motion_of(workshop, body, keys, kPositions);
    const std::vector<Pose> straight = poses_of(unconstrained);
    // Where the motion would pass, a little aside.
    struct Solid {
        double share;
        glm::dvec3 aside, along;
        double radius;
    };
    constexpr Solid kSolids[] = {{0.17, {0.0, -0.10, 0.05}, {0.0, 0.0, 0.0}, 0.34},
                                 {0.42, {0.05, -0.1, 0.1}, {0.0, 0.9, 0.0}, 0.20},
                                 {0.56, {0.0, 0.1, 0.0}, {0.0, 0.0, 0.0}, 0.28},
                                 {0.80, {0.0, 0.05, -0.1}, {0.3, 0.0, 0.9}, 0.18},
                                 {0.91, {0.1, -0.2, 0.1}, {0.0, 0.0, 0.0}, 0.22}};
    std::vector<FlgObstacle> solids;
    for (const Solid& solid : kSolids) {
        const Pose& pose = straight[static_cast<size_t>(solid.share * (kPositions - 1))];
        const glm::dvec3 middle = glm::dvec3(pose[3], pose[7], pose[11]) + solid.aside;
        FlgObstacle obstacle = flgObstacleDefaults();
        obstacle.kind = solid.along == glm::dvec3(0.0) ? FLG_OBSTACLE_KIND_BALL : FLG_OBSTACLE_KIND_CAPSULE;
        for (int c = 0; c < 3; ++c) {
            obstacle.centre[c] = middle[c] - solid.along[c];
            obstacle.to[c] = middle[c] + solid.along[c];
        }
        obstacle.radius = solid.radius;
        solids.push_back(obstacle);
    }
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.obstacles = solids.data();
    desc.obstacle_count = static_cast<uint32_t>(solids.size());
    desc.clearance = body.radius();
    const filigree::Obstacles all = workshop.context().obstacles(desc);
    keys.desc.obstacles = all.get();
    const std::vector<Pose> around = poses_of(motion_of(workshop, body, keys, kPositions));
    std::deque<Show> shows;
    for (int i = 0; i < 4; ++i) {
        const bool free = i % 2 == 0;
        const std::vector<Pose>& poses = free ? straight : around;
        Show& show = shows.emplace_back(workshop);
        show.copies(body, keys.poses, 0.0f);
        show.copies(body, every(poses, kEvery), 0.5f);
        show.path(poses, {0.0, 0.0, 0.0}, free ? kGold : kBlue, 0.028f, false);
        for (const FlgObstacle& obstacle : solids) {
            scenes::Curve curve = dot(glm::vec3(obstacle.centre[0], obstacle.centre[1], obstacle.centre[2]));
            if (obstacle.kind == FLG_OBSTACLE_KIND_CAPSULE)
                curve.points = {to_point({obstacle.centre[0], obstacle.centre[1], obstacle.centre[2]}),
                                to_point({obstacle.to[0], obstacle.to[1], obstacle.to[2]})};
            show.add({curve}, kStone, static_cast<float>(obstacle.radius));
        }
        show.panel().margin = 1.06f;
        show.panel().sight = i < 2 ? glm::vec3(0.25f, -0.45f, -1.0f) : glm::vec3(-0.5f, -1.2f, -0.6f);
    }
    std::vector<Panel> panels = panels_of(shows, false);
    aim_together({panels.data(), 2});
    aim_together({panels.data() + 2, 2});
    entitle(panels, {"As if nothing were there", "Around five obstacles", "the same, from above"});
    panels[0].keys = {{kRed, "given positions of the top"}, {kGold, "way of its middle"}, {kStone, "obstacles"}};
    studio.take("motion_obstacles", panels, 2, kWidth, 760);
}

constexpr Picture kPictures[] = {
    {"motion_shortest", "The shortest motion of a long body, against a turn about one axis", true, shortest},
    {"motion_cyclic", "Cyclic motions of one body by E2, Et and E1", true, cyclic},
    {"motion_smoothed", "A measured motion, and the smooth one near it", true, smoothed},
    {"motion_obstacles", "A motion without and with five obstacles", true, obstacles},
};

}  // namespace

std::span<const Picture> motion_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
