// SPDX-License-Identifier: MIT
// One curve as a brush reads it, point after point.
#pragma once

#include <cstddef>
#include <cstdint>

#include "brush/library.h"
#include "core/vec.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

// A column with its stride resolved; null data: there is none.
struct Column {
    const float* data = nullptr;
    size_t stride = 0;  // floats

    explicit operator bool() const { return data != nullptr; }
    const float* at(size_t point) const { return data + point * stride; }
};

// What a brush knows of a point. Zero normals say nothing.
struct Point {
    float position[3];
    float radius;
    float color[4];
    float normal[3];
};

inline bool same_place(const float* a, const float* b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

inline Vec3 chord(const float* from, const float* to) {
    return load_vec3(to) - load_vec3(from);
}

// Finite values; radii and, where there is no column, the defaults are at least 0.
struct Curve {
    Column position, radius, color, normal;
    uint32_t count = 0;
    bool closed = false;
    float default_radius = 0;
    float radius_scale = 1;
    float default_color[4] = {1, 1, 1, 1};

    float radius_at(size_t i) const { return radius_scale * (radius ? *radius.at(i) : default_radius); }
    Point point(size_t i) const {
        Point p = {};
        const float* const place = position.at(i);
        const float* const rgba = color ? color.at(i) : default_color;
        for (size_t k = 0; k < 3; ++k) p.position[k] = place[k];
        for (size_t k = 0; k < 4; ++k) p.color[k] = rgba[k];
        if (normal) {
            const float* const given = normal.at(i);
            for (size_t k = 0; k < 3; ++k) p.normal[k] = given[k];
        }
        p.radius = radius_at(i);
        return p;
    }
    // The number of points without those at a closed curve's end that repeat its first.
    uint32_t distinct_count() const {
        uint32_t last = count;
        while (closed && last > 1 && same_place(position.at(last - 1), position.at(0))) --last;
        return last;
    }
};

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
