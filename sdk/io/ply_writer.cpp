// SPDX-License-Identifier: MIT
// Source: Turk, The PLY Polygon File Format (1994). Columns are float properties of the vertices, in the view's order;
// labels are uint properties of the faces, behind the list that all readers look for.
#include "io/ply_writer.h"

#include <bit>
#include <cstring>

#include "io/column_names.h"
#include "io/failure.h"
#include "io/limits.h"

namespace flg::io {

static_assert(std::endian::native == std::endian::little, "values are copied as they lie in memory");

namespace {

std::string write_header(const CheckedMesh& mesh) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment Filigree\nelement vertex " +
                       std::to_string(mesh.vertex_count()) + "\n";
    for (const FlgColumn& column : mesh.columns()) {
        for (uint32_t k = 0; k < column.components; ++k) {
            text += "property float " + column_name(column.attribute, column.components, k) + "\n";
        }
    }
    text += "element face " + std::to_string(mesh.triangle_count()) + "\nproperty list uchar int vertex_indices\n";
    if (mesh.regions()) text += "property uint region\n";
    for (const FlgMeshFaceColumn& column : mesh.face_columns()) {
        text.append("property uint ").append(column.name) += '\n';
    }
    return text + "end_header\n";
}

char* put(char* to, const void* values, size_t size) {
    std::memcpy(to, values, size);
    return to + size;
}

}  // namespace

std::string write_ply(const CheckedMesh& mesh) {
    std::string file = write_header(mesh);
    size_t vertex_size = 0;
    for (const FlgColumn& column : mesh.columns()) vertex_size += column.components * sizeof(float);
    const size_t labels = (mesh.regions() ? 1 : 0) + mesh.face_columns().size();
    const size_t face_size = 1 + (3 + labels) * sizeof(uint32_t);
    const size_t header_size = file.size();
    const size_t total = header_size + mesh.vertex_count() * vertex_size + mesh.triangle_count() * face_size;
    if (total > max_bytes) fail(FLG_ERROR_LIMIT, "", "would take %zu bytes, more than the limit of 2 GiB", total);
    file.resize(total);

    char* to = file.data() + header_size;
    for (size_t i = 0; i < mesh.vertex_count(); ++i) {
        for (const FlgColumn& column : mesh.columns()) {
            to = put(to, resolved(column).at(i), column.components * sizeof(float));
        }
    }
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        *to++ = 3;
        to = put(to, mesh.triangle(t), 3 * sizeof(uint32_t));
        if (mesh.regions()) to = put(to, mesh.regions() + t, sizeof(uint32_t));
        for (const FlgMeshFaceColumn& column : mesh.face_columns()) to = put(to, column.values + t, sizeof(uint32_t));
    }
    return file;
}

}  // namespace flg::io
