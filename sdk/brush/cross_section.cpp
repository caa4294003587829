// SPDX-License-Identifier: MIT
#include "brush/cross_section.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

float cosine(double angle) {
    return static_cast<float>(std::cos(angle));
}
float sine(double angle) {
    return static_cast<float>(std::sin(angle));
}

}  // namespace

uint32_t CrossSection::vertex_count(const Style& style) {
    if (!style.tube()) return 2;
    if (style.hard) return 2 * style.sides;
    return style.sides + (style.uv ? 1 : 0);
}

CrossSection::CrossSection(const Style& style) : vertices(vertex_count(style)), quads(quad_count(style)) {
    if (!style.tube()) {
        for (uint32_t v = 0; v < 2; ++v) {
            place[0][v] = 0;
            place[1][v] = v == 0 ? -1.0f : 1.0f;
            normal[0][v] = 1;
            normal[1][v] = 0;
            around[v] = static_cast<float>(v);
        }
        left[0] = 0;
        right[0] = 1;
        return;
    }
    const uint32_t sides = style.sides;
    const double side = full_turn / sides;
    for (uint32_t v = 0; v < vertices; ++v) {
        // The corners of a hard section come in pairs, one for each side.
        const uint32_t corner = style.hard ? (v + 1) / 2 : v;
        const double angle = side * (corner % sides);
        const uint32_t faced = v / 2;
        const double facing = style.hard ? side * (faced + 0.5) : angle;
        place[0][v] = cosine(angle);
        place[1][v] = sine(angle);
        normal[0][v] = cosine(facing);
        normal[1][v] = sine(facing);
        around[v] = static_cast<float>(corner) / static_cast<float>(sides);
    }
    for (uint32_t q = 0; q < quads; ++q) {
        left[q] = style.hard ? 2 * q : q;
        right[q] = style.hard ? 2 * q + 1 : (q + 1) % vertices;
    }
}

CapProfile::CapProfile(const Style& style, FlgBrushCap cap) {
    switch (cap) {
        case FLG_BRUSH_CAP_FLAT:
            if (!style.tube()) return;
            rows[row_count++] = {1, 0, 0, 1};
            apex = true;
            return;
        case FLG_BRUSH_CAP_ROUND:
            row_count = std::max(2u, (style.sides + 3) / 4);
            for (uint32_t i = 0; i < row_count; ++i) {
                const double angle = full_turn / 4 * i / row_count;
                rows[i] = {i == 0 ? 1 : cosine(angle), sine(angle), cosine(angle), sine(angle)};
            }
            apex = true;
            apex_ahead = 1;
            return;
        case FLG_BRUSH_CAP_TAPERED: {
            const float length = style.cap_length, slant = std::sqrt(1 + length * length);
            rows[row_count++] = {1, 0, length / slant, 1 / slant};
            rows[row_count++] = {0, length, length / slant, 1 / slant};
            return;
        }
        case FLG_BRUSH_CAP_NONE:
        case FLG_BRUSH_CAP_FORCE_32BIT: return;
    }
}

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
