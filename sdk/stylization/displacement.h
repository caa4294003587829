// SPDX-License-Identifier: MIT
// Displacement of a style from its guide, in the guide's moving frame (Minarcik, Fiser, Sykora, sec. 4.3).
#pragma once

#include <span>

#include "core/memory.h"
#include "core/vec.h"
#include "runtime/task.h"

namespace flg {

// Metres along tangent, first normal and second normal (tangent x normal) of each point, as three arrays.
struct Displacement {
    Buffer<double> along_tangent;
    Buffer<double> along_normal;
    Buffer<double> along_binormal;

    Displacement() = default;
    Displacement(uint32_t count, Memory* memory)
        : along_tangent(count, memory), along_normal(count, memory), along_binormal(count, memory) {}
    uint32_t size() const { return static_cast<uint32_t>(along_tangent.size()); }
};

// What it is computed from: points of the guide with their frames, in the float columns that resampling gives, and for
// each the point of the style that belongs to it. Use the same frames here and in synthesis: then a style applied to
// its own guide gives the style back.
struct GuideAndStyle {
    const float* positions = nullptr;
    const float* tangents = nullptr;
    const float* normals = nullptr;
    std::span<const Vec3> matched;
};

// Fills in `out`, which has as many points; returns the root mean square of the displacements' lengths, metres. About
// 5 ns a point.
Task<double> displace(Pace& pace, GuideAndStyle input, Displacement& out);

}  // namespace flg
