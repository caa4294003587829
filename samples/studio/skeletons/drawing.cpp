// SPDX-License-Identifier: MIT
#include "skeletons/drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flg::studio {
namespace {

constexpr size_t kMaxName = 48;  // bytes; the SDK takes 63 with what it adds

}  // namespace

glm::dmat4 DrawnPart::matrix() const {
    const glm::dvec3 angle = glm::radians(turn);
    const glm::dquat turned = glm::angleAxis(angle.z, glm::dvec3(0, 0, 1)) *
                              glm::angleAxis(angle.y, glm::dvec3(0, 1, 0)) *
                              glm::angleAxis(angle.x, glm::dvec3(1, 0, 0));
    glm::dmat4 matrix(scale * glm::mat3_cast(turned));
    matrix[3] = {at, 1.0};
    return matrix;
}

std::array<double, 12> DrawnPart::placement() const {
    const glm::dmat4 from = matrix();
    std::array<double, 12> rows;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) rows[static_cast<size_t>(4 * row + column)] = from[column][row];
    return rows;
}

glm::dvec3 DrawnPart::centre() const {
    return matrix() * glm::dvec4(centre_of(contour->rings[0]), 0.0, 1.0);
}

void DrawnPart::place(const glm::dvec3& turn_degrees, double size) {
    const glm::dvec3 before = centre();
    turn = turn_degrees;
    scale = size;
    at += before - centre();
}

const DrawnPart* Drawing::find(uint32_t id) const {
    const auto found = std::find_if(parts.begin(), parts.end(), [id](const DrawnPart& part) { return part.id == id; });
    return found == parts.end() ? nullptr : &*found;
}

DrawnPart* Drawing::find(uint32_t id) {
    return const_cast<DrawnPart*>(std::as_const(*this).find(id));
}

std::string Drawing::free_name(const std::string& base, uint32_t but_of) const {
    // Whole characters of UTF-8.
    size_t length = std::min(base.size(), kMaxName);
    while (length > 0 && length < base.size() && (static_cast<unsigned char>(base[length]) & 0xc0) == 0x80) --length;
    const std::string wanted = length == 0 ? "part" : base.substr(0, length);
    const auto is_taken = [&](const std::string& name) {
        return std::any_of(parts.begin(), parts.end(),
                           [&](const DrawnPart& part) { return part.id != but_of && part.name == name; });
    };
    // "leg" and "leg 2" are followed by "leg 3".
    const size_t digits = wanted.find_last_not_of("0123456789") + 1;
    const bool is_numbered = digits > 1 && digits < wanted.size() && wanted[digits - 1] == ' ';
    const std::string stem = is_numbered ? wanted.substr(0, digits - 1) : wanted;
    std::string name = wanted;
    for (int number = 2; is_taken(name); ++number) name = stem + " " + std::to_string(number);
    return name;
}

bool Drawing::has_mirrored_parts() const {
    return std::any_of(parts.begin(), parts.end(), [](const DrawnPart& part) { return part.mirrored; });
}

render::Box Drawing::box() const {
    render::Box box;
    for (const DrawnPart& part : parts) {
        if (!part.visible) continue;
        const glm::dmat4 matrix = part.matrix();
        const double depth = radius_of(part.contour->rings[0]) * part.thickness;
        for (const glm::dvec2& p : part.contour->rings[0]) {
            for (const double z : {-depth, depth}) {
                const glm::dvec3 at(matrix * glm::dvec4(p, z, 1.0));
                box.add({at, at});
                if (part.mirrored) box.add({mirrored(mirror, at), mirrored(mirror, at)});
            }
        }
    }
    return box;
}

glm::dvec3 mirrored(const glm::vec4& plane, const glm::dvec3& point) {
    const glm::dvec3 normal(plane);
    const double distance = (glm::dot(normal, point) - static_cast<double>(plane.w)) / glm::dot(normal, normal);
    return point - 2.0 * distance * normal;
}

double depth_beside(const Drawing& drawing, const Ring& outline, float thickness) {
    // Shares of half the widths, so that the two do not touch each other and still go into the body.
    constexpr double kApart = 1.25, kIntoBody = 0.6;
    double body = 0.0;
    for (const DrawnPart& part : drawing.parts) {
        if (!part.visible || part.mirrored) continue;
        const glm::dmat4 to_part = glm::inverse(part.matrix());
        const bool meets = std::any_of(outline.begin(), outline.end(), [&](const glm::dvec2& p) {
            return is_inside(part.contour->rings[0], glm::dvec2(to_part * glm::dvec4(p, 0.0, 1.0)));
        });
        if (meets) body = std::max(body, part.scale * part.thickness * radius_of(part.contour->rings[0]));
    }
    return std::max(kApart * thickness * radius_of(outline), kIntoBody * body);
}

void set_placement(DrawnPart& part, const std::array<double, 12>& rows) {
    const glm::dvec3 x(rows[0], rows[4], rows[8]);
    part.scale = glm::length(x);
    part.at = {rows[3], rows[7], rows[11]};
    part.turn =
        glm::degrees(glm::dvec3(std::atan2(rows[9], rows[10]), std::asin(std::clamp(-rows[8] / part.scale, -1.0, 1.0)),
                                std::atan2(rows[4], rows[0])));
}

}  // namespace flg::studio
