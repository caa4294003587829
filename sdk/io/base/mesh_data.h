// SPDX-License-Identifier: MIT
// What readers of meshes fill: vertices, triangles and labels in flat arrays, as in FlgMeshView, and what is odd about
// them.
#pragma once

#include <cstdint>
#include <span>

#include "filigree/filigree_io.h"
#include "io/base/column_names.h"
#include "io/base/failure.h"
#include "io/base/files.h"
#include "io/base/limits.h"
#include "io/base/memory.h"
#include "io/base/placing.h"
#include "io/base/tally.h"

namespace flg::io {

constexpr uint32_t max_face_columns = 16;

struct FaceColumn {
    String name;
    Vector<uint32_t> values;
};

// Of a region; as FlgMeshMaterial.
struct MaterialData {
    String name;
    float color[3] = {1, 1, 1};
    float metallic = 1, roughness = 1;
    float border_color[3] = {0, 0, 0};
    float border_width_px = 0;
    uint32_t texture = FLG_NO_INDEX;
    bool two_sided = false;
};

// As FlgTexture, with its picture.
struct TextureData {
    String name;
    FlgTextureWrap wrap_u = FLG_TEXTURE_WRAP_REPEAT, wrap_v = FLG_TEXTURE_WRAP_REPEAT;
    bool nearest = false;
    ByteBlock picture;
};

// A face of more than three corners; its fan lies at `first` in the triangles.
struct PolygonFan {
    uint32_t first;
    uint32_t corners;
};

struct MeshData {
    const char* format = "";
    Vector<float> positions;
    Placing placing;
    Vector<VertexColumn> columns;  // besides positions
    Vector<uint32_t> triangles;    // three vertices each
    Vector<uint32_t> regions;      // one a triangle, or empty
    Vector<FaceColumn> face_columns;
    Vector<MaterialData> materials;  // by region, or empty
    Vector<TextureData> textures;
    Vector<float> corner_uvs;  // 6 a triangle, up to the last that has some
    Vector<PolygonFan> fans;
    uint64_t polygon_count = 0;
    Vector<String> warnings;

    size_t vertex_count() const { return positions.size() / 3; }
    size_t triangle_count() const { return triangles.size() / 3; }

    void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
        triangles.insert(triangles.end(), {a, b, c});
        ++polygon_count;
    }

    // A face of at least three corners, as a fan from its first.
    void add_polygon(std::span<const uint32_t> corners) {
        if (corners.size() > 3) {
            check_room(0, corners.size(), "");
            fans.push_back({static_cast<uint32_t>(triangle_count()), static_cast<uint32_t>(corners.size())});
        }
        for (size_t k = 2; k < corners.size(); ++k) {
            triangles.insert(triangles.end(), {corners[0], corners[k - 1], corners[k]});
        }
        ++polygon_count;
    }

    // Faces may share vertices, and meshes be shown many times: a small file could ask for very much.
    void check_room(uint64_t more_vertices, uint64_t more_triangles, const String& place) const {
        // As if all vertices had colours.
        uint64_t vertex_bytes = (3 + 4) * sizeof(float);
        for (const VertexColumn& column : columns) vertex_bytes += column.components * sizeof(float);
        const uint64_t uv_bytes = corner_uvs.empty() ? 0 : 6 * sizeof(float);
        const uint64_t triangle_bytes = (4 + face_columns.size()) * sizeof(uint32_t) + uv_bytes;
        const uint64_t vertices = vertex_count() + more_vertices;
        const uint64_t all_triangles = triangle_count() + more_triangles;
        if (vertices > max_bytes || all_triangles > max_bytes ||
            vertices * vertex_bytes + all_triangles * triangle_bytes > max_bytes) {
            fail(FLG_ERROR_LIMIT, place, "the mesh takes more than the limit of 2 GiB");
        }
    }

    void warn(const Tally& tally, const char* unit, const char* what) { io::warn(warnings, tally, unit, what); }
};

}  // namespace flg::io
