// SPDX-License-Identifier: MIT
#include "skeletons/part_picking.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

#include "skeletons/model_picture.h"

namespace flg::studio {
namespace {

// Where the ray meets a triangle (Moller and Trumbore 1997): how far along it, and the shares of the second and the
// third corner; none where it misses.
std::optional<glm::vec3> meet(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
    const float turn = glm::dot(ab, p);
    if (turn == 0.0f) return std::nullopt;
    const glm::vec3 from = ray.origin - a, q = glm::cross(from, ab);
    const float u = glm::dot(from, p) / turn, v = glm::dot(ray.direction, q) / turn;
    const float distance = glm::dot(ac, q) / turn;
    if (u < 0.0f || v < 0.0f || u + v > 1.0f || !(distance > 0.0f)) return std::nullopt;
    return glm::vec3(distance, u, v);
}

std::optional<PartHit> pick_body(const LiveModel::Skinned& skin, const Ray& ray) {
    const auto hit = pick_skin(skin.view, {skin.view.positions, size_t{3} * skin.view.vertex_count}, ray);
    if (!hit) return std::nullopt;
    const uint32_t part = skin.view.vertex_parts[skin.view.triangles[3 * size_t{hit->triangle}]];
    return PartHit{skin.parts[part], hit->position, skin.is_image[part]};
}

}  // namespace

std::optional<SkinHit> pick_skin(const FlgSkinView& skin, std::span<const float> positions, const Ray& ray) {
    std::optional<SkinHit> found;
    float nearest = std::numeric_limits<float>::infinity();
    const auto at = [&](uint32_t vertex) { return glm::make_vec3(positions.data() + 3 * size_t{vertex}); };
    for (uint32_t t = 0; t < skin.triangle_count; ++t) {
        const uint32_t* corners = skin.triangles + 3 * size_t{t};
        const auto met = meet(ray, at(corners[0]), at(corners[1]), at(corners[2]));
        if (!met || met->x >= nearest) continue;
        nearest = met->x;
        found = SkinHit{t, {1.0f - met->y - met->z, met->y, met->z}, ray.origin + nearest * ray.direction};
    }
    return found;
}

std::optional<PartHit> pick_part(const Editor& editor, glm::vec2 px) {
    const View& view = editor.app.view;
    const Ray ray = view.ray(px);
    if (const LiveModel::Skinned* skin = editor.live.skin()) {
        const auto hit = pick_body(*skin, ray);
        // The body may be older than the drawing.
        if (hit && editor.drawing().find(hit->id) != nullptr) return hit;
    }
    std::optional<PartHit> found;
    double smallest = std::numeric_limits<double>::infinity();
    for (const DrawnPart& part : editor.drawing().parts) {
        const Ring& outline = part.contour->rings[0];
        const double area = area_of(outline) * part.scale * part.scale;
        if (!part.visible || area >= smallest) continue;
        for (const bool is_image : {false, true}) {
            if (is_image && !part.mirrored) continue;
            const glm::vec4* mirror = is_image ? &editor.drawing().mirror : nullptr;
            if (!is_in_polygon(ring_in_window(view, part, outline, mirror), px)) continue;
            glm::dvec3 centre = part.centre();
            if (is_image) centre = mirrored(*mirror, centre);
            const glm::vec3 sight = view.orbit.camera.target - view.orbit.camera.eye;
            const auto place = meet_plane(ray, glm::vec3(centre), sight);
            if (!place) continue;
            found = PartHit{part.id, *place, is_image};
            smallest = area;
        }
    }
    return found;
}

std::vector<glm::vec2> ring_in_window(const View& view, const DrawnPart& part, const Ring& ring,
                                      const glm::vec4* mirror) {
    // Of contours from files: more cannot be seen.
    constexpr size_t kMost = 2000;
    const size_t step = ring.size() / kMost + 1;
    const glm::dmat4 matrix = part.matrix();
    std::vector<glm::vec2> polygon;
    for (size_t i = 0; i < ring.size(); i += step) {
        const glm::dvec2& p = ring[i];
        glm::dvec3 at(matrix * glm::dvec4(p, 0.0, 1.0));
        if (mirror != nullptr) at = mirrored(*mirror, at);
        const auto px = view.project(glm::vec3(at));
        if (!px) return {};
        polygon.push_back(*px);
    }
    return polygon;
}

bool is_in_polygon(std::span<const glm::vec2> polygon, glm::vec2 px) {
    return is_inside(Ring(polygon.begin(), polygon.end()), glm::dvec2(px));
}

std::optional<glm::dvec2> meet_part(const View& view, const DrawnPart& part, glm::vec2 px, const glm::vec4* mirror) {
    const glm::dmat4 matrix = part.matrix();
    const auto shown = [&](const glm::dvec3& p) { return mirror != nullptr ? mirrored(*mirror, p) : p; };
    const glm::dvec3 at = shown(glm::dvec3(matrix[3])), over = shown(glm::dvec3(matrix[3] + matrix[2]));
    const auto place = meet_plane(view.ray(px), glm::vec3(at), glm::normalize(glm::vec3(over - at)));
    if (!place) return std::nullopt;
    return glm::dvec2(glm::inverse(matrix) * glm::dvec4(shown(glm::dvec3(*place)), 1.0));
}

std::optional<uint32_t> joint_at(const View& view, glm::vec2 px, const Rig& rig, const PosedJoints& joints,
                                 float reach) {
    std::optional<uint32_t> found;
    float nearest = std::numeric_limits<float>::infinity();
    for (uint32_t j = 0; j < rig.count(); ++j) {
        const auto at = view.project(joints.at[j]);
        if (!at) continue;
        const float ball = joint_radius(rig, j) / std::max(view.metres_per_px(joints.at[j]), 1e-9f);
        const float distance = glm::distance(*at, px);
        if (distance > std::max(reach, ball) || distance >= nearest) continue;
        nearest = distance;
        found = j;
    }
    return found;
}

}  // namespace flg::studio
