// SPDX-License-Identifier: MIT
#include "packing.h"

#include <algorithm>
#include <cmath>

#include "vk.h"

namespace flg::render {
namespace {

// The inverse, to 0.2 %, of the polynomial in packing.glsl; cheaper than pow, a million times a second.
uint32_t srgb_byte(float linear) {
    const float v = std::clamp(linear, 0.0f, 1.0f);
    const float s1 = std::sqrt(v), s2 = std::sqrt(s1), s3 = std::sqrt(s2);
    const float srgb = 0.585122381f * s1 + 0.783140355f * s2 - 0.368262736f * s3;
    return static_cast<uint32_t>(std::clamp(srgb, 0.0f, 1.0f) * 255.0f + 0.5f);
}

}  // namespace

Column find_column(std::span<const FlgColumn> columns, FlgAttribute attribute, uint32_t components, const char* name) {
    for (const FlgColumn& column : columns) {
        if (column.attribute != attribute) continue;
        if (!column.data) fail("The column %s has no data.", name);
        if (column.components != components)
            fail("The column %s has %u floats a point instead of %u.", name, column.components, components);
        if (column.stride % sizeof(float) != 0)
            fail("The column %s has a stride of %u bytes, which is no multiple of 4.", name, column.stride);
        return {reinterpret_cast<const char*>(column.data), column.stride ? column.stride : components * sizeof(float)};
    }
    return {};
}

bool is_usable(glm::vec3 p) {
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(p[i]) <= largest_coordinate)) return false;
    return true;
}

void check_in(float value, float low, float high, const char* name) {
    if (!(value >= low && value <= high)) fail("The look's %s is %g; it must be in %g to %g.", name, value, low, high);
}

void check_color(glm::vec3 color, const char* name) {
    for (int i = 0; i < 3; ++i) check_in(color[i], 0.0f, 1.0f, name);
}

uint32_t pack_normal(glm::vec3 n) {
    n /= std::max(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1e-30f);
    glm::vec2 p(n.x, n.y);
    if (n.z < 0.0f)
        p = {(1.0f - std::abs(n.y)) * (n.x >= 0.0f ? 1.0f : -1.0f),
             (1.0f - std::abs(n.x)) * (n.y >= 0.0f ? 1.0f : -1.0f)};
    const auto snorm = [](float v) {
        const float scaled = v * 32767.0f;
        const auto rounded = static_cast<int16_t>(scaled + (scaled < 0.0f ? -0.5f : 0.5f));
        return static_cast<uint32_t>(static_cast<uint16_t>(rounded));
    };
    return snorm(p.x) | snorm(p.y) << 16;
}

uint32_t pack_color(glm::vec3 c) {
    return srgb_byte(c.x) | srgb_byte(c.y) << 8 | srgb_byte(c.z) << 16 | 0xff000000u;
}

}  // namespace flg::render
