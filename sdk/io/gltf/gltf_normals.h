// SPDX-License-Identifier: MIT
// NORMAL of a primitive, placed as its vertices are.
#pragma once

#include <array>
#include <optional>

#include "io/base/vec3.h"
#include "io/gltf/gltf_scene.h"

namespace flg::io {

class GltfNormals {
public:
    // None: the primitive has none.
    static std::optional<GltfNormals> read(const GltfDocument& document, const GltfPrimitive& primitive,
                                           uint64_t vertex_count) {
        const std::optional<GltfValues> values = read_attribute(document, primitive, "NORMAL");
        if (!values) return {};
        if (values->components != 3 || (values->component_type != gltf_float && !values->normalized))
            fail(FLG_ERROR_FORMAT, values->place, "holds normals that are not three floats");
        if (values->count != vertex_count)
            fail(FLG_ERROR_FORMAT, values->place + ".count", "is %llu, but there are %llu positions",
                 static_cast<unsigned long long>(values->count), static_cast<unsigned long long>(vertex_count));
        return GltfNormals(*values);
    }

    // Of length 1, as a plane across it turns with the transform; 0 0 0 where it has no direction.
    std::array<float, 3> at(uint32_t vertex, const Transform& t) const {
        const float given[3] = {values_.number(vertex, 0), values_.number(vertex, 1), values_.number(vertex, 2)};
        for (const float value : given)
            if (!std::isfinite(value)) refuse_value(values_, vertex, value);
        const Vec3 x{t[0], t[1], t[2]}, y{t[3], t[4], t[5]}, z{t[6], t[7], t[8]};
        Vec3 n{given[0], given[1], given[2]};
        if (t != identity_transform) {
            const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
            const double side = determinant(t) < 0 ? -1 : 1;
            n = {side * (yz.x * n.x + zx.x * n.y + xy.x * n.z), side * (yz.y * n.x + zx.y * n.y + xy.y * n.z),
                 side * (yz.z * n.x + zx.z * n.y + xy.z * n.z)};
        }
        constexpr double off_by = 1e-6;  // nearer to length 1 than this it keeps its bits
        if (length(n) > 0 && std::abs(length(n) - 1) > off_by) n = normalized(n);
        return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    }

private:
    explicit GltfNormals(GltfValues values) : values_(std::move(values)) {}

    GltfValues values_;
};

}  // namespace flg::io
