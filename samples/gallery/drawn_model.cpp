// SPDX-License-Identifier: MIT
#include "gallery/drawn_model.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <thread>

#include "filigree/filigree.hpp"
#include "gallery/marks.h"

namespace flg::gallery {
namespace {

const cli::CommonOptions& common() {
    static const cli::CommonOptions options = {
        .report = "", .workers = std::max(1u, std::thread::hardware_concurrency()), .quiet = true};
    return options;
}

struct Place {
    glm::vec3 at;
    float radius;
};

// A Catmull-Rom curve through the places.
scenes::Curve smooth(const std::vector<Place>& places) {
    constexpr int kSteps = 16;
    scenes::Curve curve;
    const size_t last = places.size() - 1;
    for (size_t i = 0; i < last; ++i) {
        const glm::vec3 &b = places[i].at, &c = places[i + 1].at;
        const glm::vec3 a = i == 0 ? b : places[i - 1].at, d = i + 1 == last ? c : places[i + 2].at;
        for (int k = 0; k < kSteps + (i + 1 == last); ++k) {
            const float t = static_cast<float>(k) / kSteps;
            const glm::vec3 p =
                b + 0.5f * t * (c - a + t * (2.0f * a - 5.0f * b + 4.0f * c - d + t * (3.0f * (b - c) + d - a)));
            curve.points.push_back(to_point(p));
            curve.radii.push_back(glm::mix(places[i].radius, places[i + 1].radius, t));
        }
    }
    return curve;
}

}  // namespace

cli::ModelDrawing drawing_of(const char* name) {
    return cli::read_model_drawing(std::string(FLG_MODEL_DRAWINGS) + "/" + name + ".json");
}

DrawnModel::DrawnModel(const cli::ModelDrawing& drawing, uint32_t vertices)
    : report_("skeleton", common()), session_(common()) {
    FlgSkinDesc desc = flgSkinDefaults();
    desc.model = cli::make_drawn_model(session_, drawing, "a drawing", report_);
    desc.vertex_count = vertices;
    filigree::check(flgModelGetView(session_.context(), desc.model, &bones_));
    FlgSkin skin = {};
    FlgJob job = {};
    filigree::check(flgSkinCreate(session_.context(), &desc, &skin, &job));
    session_.finish({{{job, "its surface"}}}, report_);
    filigree::check(flgSkinGetView(session_.context(), skin, &skin_));
    motion_ = cli::make_test_motion(bones_, drawing);
    for (uint32_t p = 0; p < bones_.part_count; ++p) {
        const FlgMeshMaterial& from = drawing.parts[bones_.part_sources[p]].material;
        look_.regions.push_back({.color = glm::make_vec3(from.color), .roughness = from.roughness});
    }
    rest();
}

void DrawnModel::take_pose(const float* rotations, const float* translation) {
    matrices_.resize(size_t{12} * skin_.joint_count), dual_quaternions_.resize(size_t{8} * skin_.joint_count);
    filigree::check(flgSkinPose(&skin_, rotations, translation, matrices_.data(), dual_quaternions_.data()));
    posed_.resize(size_t{3} * skin_.vertex_count);
    filigree::check(
        flgSkinDeform(&skin_, FLG_SKINNING_DUAL_QUATERNION, dual_quaternions_.data(), posed_.data(), nullptr));
}

void DrawnModel::rest() {
    take_pose(nullptr, nullptr);
}

void DrawnModel::pose(float time) {
    std::vector<float> rotations(size_t{4} * skin_.joint_count);
    float translation[3];
    const FlgSkinAnimation animation = motion_.animation();
    filigree::check(flgSkinAnimationSample(&animation, skin_.joint_count, time, rotations.data(), translation));
    take_pose(rotations.data(), translation);
}

SkinLayer DrawnModel::surface() const {
    return {skin_, look_, dual_quaternions_};
}

std::vector<glm::vec3> DrawnModel::joints() const {
    std::vector<glm::vec3> places;
    for (size_t j = 0; j < skin_.joint_count; ++j) {
        const glm::vec4 p(glm::make_vec3(skin_.joint_positions + 3 * j), 1.0f);
        const float* m = &matrices_[12 * j];
        places.emplace_back(glm::dot(glm::make_vec4(m), p), glm::dot(glm::make_vec4(m + 4), p),
                            glm::dot(glm::make_vec4(m + 8), p));
    }
    return places;
}

void DrawnModel::lift(scenes::Curve& curve, const glm::vec3& to_eye) const {
    // Shares of the shape's radius: of the surface that counts, aside and towards the eye; and above it.
    constexpr float kAside = 0.3f, kReach = 2.6f, kAbove = 0.08f;
    constexpr size_t kNear = 6;  // heights are the mean of so many on both sides
    std::vector<glm::vec3> points;
    std::vector<float> heights;
    for (size_t i = 0; i < curve.points.size(); ++i) {
        const glm::vec3 p(curve.points[i].x, curve.points[i].y, curve.points[i].z);
        const float radius = curve.radii[i];
        float height = 0.0f;
        for (size_t v = 0; v < posed_.size(); v += 3) {
            const glm::vec3 d = glm::make_vec3(&posed_[v]) - p;
            const float along = glm::dot(d, to_eye);
            if (along <= height || along > kReach * radius) continue;
            if (glm::length(d - along * to_eye) < kAside * radius) height = along;
        }
        points.push_back(p), heights.push_back(height + kAbove * radius);
    }
    const size_t last = points.size() - 1;
    for (size_t i = 0; i <= last; ++i) {
        const size_t from = i - std::min(kNear, i), to = std::min(i + kNear, last);
        float height = 0.0f;
        for (size_t k = from; k <= to; ++k) height += heights[k] / static_cast<float>(to - from + 1);
        curve.points[i] = to_point(points[i] + height * to_eye);
        const glm::vec3 along = glm::normalize(points[std::min(i + 1, last)] - points[i - std::min<size_t>(i, 1)]);
        const glm::vec3 aside =
            glm::normalize(glm::cross(along, to_eye + 1e-3f * glm::vec3(along.y, along.z, along.x)));
        curve.normals.push_back(to_point(glm::cross(aside, along)));
    }
}

std::vector<scenes::Curve> DrawnModel::limbs(const glm::vec3& sight) const {
    const std::vector<glm::vec3> at = joints();
    const uint32_t count = bones_.joint_count;
    // How far it is to the farthest end beyond a joint, and over which child.
    std::vector<float> reach(count, 0.0f);
    std::vector<uint32_t> next(count, FLG_NO_INDEX);
    for (uint32_t j = count; j-- > 0;) {
        const uint32_t parent = bones_.joint_parents[j];
        if (parent == FLG_NO_INDEX) continue;
        const float length = reach[j] + glm::distance(at[j], at[parent]);
        if (next[parent] == FLG_NO_INDEX || length > reach[parent]) reach[parent] = length, next[parent] = j;
    }
    std::vector<scenes::Curve> curves;
    for (uint32_t j = 0; j < count; ++j) {
        const uint32_t parent = bones_.joint_parents[j];
        if (parent == FLG_NO_INDEX || (next[parent] == j && bones_.joint_parents[parent] != FLG_NO_INDEX)) continue;
        std::vector<Place> places;
        // Limbs begin where they leave the body.
        if (next[parent] == j || next[j] == FLG_NO_INDEX) places.push_back({at[parent], bones_.joint_radii[j]});
        for (uint32_t k = j; k != FLG_NO_INDEX; k = next[k]) places.push_back({at[k], bones_.joint_radii[k]});
        if (places.size() < 2) continue;
        curves.push_back(smooth(places));
        lift(curves.back(), -glm::normalize(sight));
    }
    return curves;
}

std::vector<scenes::Curve> DrawnModel::straight_bones() const {
    const std::vector<glm::vec3> at = joints();
    std::vector<scenes::Curve> curves;
    for (uint32_t j = 0; j < bones_.joint_count; ++j) {
        if (bones_.joint_parents[j] == FLG_NO_INDEX) continue;
        curves.emplace_back().points = {to_point(at[bones_.joint_parents[j]]), to_point(at[j])};
    }
    return curves;
}

std::vector<scenes::Curve> DrawnModel::joint_balls() const {
    std::vector<scenes::Curve> balls;
    for (const glm::vec3& p : joints()) balls.push_back(dot(p));
    return balls;
}

}  // namespace flg::gallery
