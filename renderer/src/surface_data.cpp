// SPDX-License-Identifier: MIT
#include "surface_data.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "packing.h"
#include "surface_normals.h"
#include "surface_regions.h"
#include "vk.h"

namespace flg::render {
namespace {

constexpr uint32_t max_triangles = 1u << 26;
constexpr uint32_t field_known = 0xff0000u;  // in a material's bits

void check_material(const Material& material) {
    check_color(material.color, "color");
    check_in(material.metallic, 0.0f, 1.0f, "metallic");
    check_in(material.roughness, 0.0f, 1.0f, "roughness");
    if (material.border_width_px != 0.0f) check_in(material.border_width_px, 0.5f, 64.0f, "border_width_px");
    check_color(material.border_color, "border_color");
}

void check_look(const SurfaceLook& look) {
    check_material(look.material);
    for (const Material& material : look.regions) check_material(material);
    check_in(look.field_low, -largest_coordinate, largest_coordinate, "field_low");
    check_in(look.field_high, -largest_coordinate, largest_coordinate, "field_high");
    check_in(look.isoline_spacing, 0.0f, largest_coordinate, "isoline_spacing");
    check_in(look.isoline_width_px, 0.5f, 64.0f, "isoline_width_px");
    check_color(look.isoline_color, "isoline_color");
    if (look.border_width_px != 0.0f) check_in(look.border_width_px, 0.5f, 64.0f, "border_width_px");
    check_color(look.border_color, "border_color");
}

void check_mesh(const FlgMeshView& mesh) {
    if (mesh.triangle_count == 0 || !mesh.triangles) fail("The mesh has no triangles.");
    if (mesh.column_count == 0 || !mesh.columns) fail("The mesh has no columns.");
    if (mesh.vertex_count > max_vertices)
        fail("The mesh has %u vertices; the renderer takes at most %u.", mesh.vertex_count, max_vertices);
    if (mesh.triangle_count > max_triangles)
        fail("The mesh has %u triangles; the renderer takes at most %u.", mesh.triangle_count, max_triangles);
    for (uint32_t corner = 0; corner < 3 * mesh.triangle_count; ++corner)
        if (mesh.triangles[corner] >= mesh.vertex_count)
            fail("Triangle %u names vertex %u; the mesh has %u vertices.", corner / 3, mesh.triangles[corner],
                 mesh.vertex_count);
}

struct PackedMaterial {
    uint32_t color;
    glm::vec3 linear_color;
    uint32_t metallic_and_roughness;
};

PackedMaterial pack_material(const Material& material) {
    const auto byte = [](float share) { return static_cast<uint32_t>(255.0f * share + 0.5f); };
    return {packed_color(material.color), material.color, byte(material.metallic) | byte(material.roughness) << 8};
}

class Builder {
public:
    Builder(const FlgMeshView& mesh, const SurfaceLook& look, std::span<const float> field)
        : mesh_(mesh),
          look_(look),
          field_(field),
          triangles_(mesh.triangles, 3 * size_t{mesh.triangle_count}),
          normal_(find_column({mesh.columns, mesh.column_count}, FLG_ATTRIBUTE_NORMAL, 3, "NORMAL")),
          color_(find_column({mesh.columns, mesh.column_count}, FLG_ATTRIBUTE_COLOR, 4, "COLOR")) {
        if (look.regions.empty()) materials_.push_back(pack_material(look.material));
        for (const Material& material : look.regions) materials_.push_back(pack_material(material));
    }

    SurfaceData build() {
        read_positions();
        read_field();
        check_vertex_colors();
        SplitVertices split = split_regions();
        if (!look_.textures.empty() && !look_.corner_uvs.empty()) {
            split_uvs(split);
            gather_runs(split);
        }
        const uint32_t count = mesh_.vertex_count + static_cast<uint32_t>(split.copied.size());
        if (count > max_vertices)
            fail(
                "The mesh has %u vertices, those between regions counted once a region; the renderer takes at most %u.",
                count, max_vertices);
        data_.vertices.resize(count);
        data_.positions.reserve(count);
        for (const uint32_t source : split.copied) data_.positions.push_back(data_.positions[source]);
        if (look_.smooth && !normal_) normals_ = creased_normals(data_.positions, split.indices, split.copied);
        write_columns_of_view();
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t source = i < mesh_.vertex_count ? i : split.copied[i - mesh_.vertex_count];
            finish_vertex(i, source, split.label_of.empty() ? 0 : split.label_of[i]);
        }
        if (!normals_.empty()) write_normals(normals_, &data_.vertices[0].normal, sizeof(SurfaceVertex));
        data_.indices = std::move(split.indices);
        data_.copied = std::move(split.copied);
        return std::move(data_);
    }

private:
    void read_positions() {
        const Column position = find_column({mesh_.columns, mesh_.column_count}, FLG_ATTRIBUTE_POSITION, 3, "POSITION");
        if (!position) fail("The mesh has no POSITION column.");
        data_.positions.resize(mesh_.vertex_count);
        for (uint32_t i = 0; i < mesh_.vertex_count; ++i) {
            const auto p = position.at<glm::vec3>(i);
            if (!is_usable(p))
                fail("Vertex %u is at (%g, %g, %g); positions must be finite, at most 1e30.", i, p.x, p.y, p.z);
            data_.positions[i] = p;
            data_.box.add({p, p});
        }
    }

    void read_field() {
        if (field_.empty()) return;
        if (field_.size() != mesh_.vertex_count)
            fail("The field has %zu values; the mesh has %u vertices.", field_.size(), mesh_.vertex_count);
        float low = INFINITY, high = -INFINITY;
        for (uint32_t i = 0; i < mesh_.vertex_count; ++i) {
            if (std::isnan(field_[i])) fail("The field's value at vertex %u is not a number.", i);
            if (std::isinf(field_[i])) continue;
            low = std::min(low, field_[i]);
            high = std::max(high, field_[i]);
        }
        const bool found = look_.field_low == look_.field_high;
        data_.has_field = true;
        data_.field_low = found ? low : look_.field_low;
        data_.field_high = found ? high : look_.field_high;
    }

    void check_vertex_colors() const {
        const std::span<const float> colors = look_.vertex_colors;
        if (colors.empty()) return;
        if (colors.size() != 4 * size_t{mesh_.vertex_count})
            fail("The look has %zu vertex colours' numbers; %u vertices take %zu.", colors.size(), mesh_.vertex_count,
                 4 * size_t{mesh_.vertex_count});
        for (size_t i = 0; i < colors.size(); ++i)
            if (!(colors[i] >= 0.0f && colors[i] <= 1.0f))
                fail("The colour of vertex %zu has a %g; it must be 0 to 1.", i / 4, colors[i]);
    }

    SplitVertices split_regions() {
        const bool colors = mesh_.regions && look_.regions.size() > 1;
        const std::span<const uint32_t> labels(mesh_.regions, mesh_.regions ? mesh_.triangle_count : 0);
        if (mesh_.regions && has_borders())
            for (const LabelledEdge& edge : border_edges(triangles_, labels, mesh_.vertex_count)) add_border(edge);
        if (colors) return split_vertices(triangles_, labels, mesh_.vertex_count);
        return {{triangles_.begin(), triangles_.end()}, {}, {}};
    }

    uint32_t texture_of(size_t triangle) const {
        if (look_.regions.empty()) return look_.material.texture;
        return look_.regions[(mesh_.regions ? mesh_.regions[triangle] : 0) % look_.regions.size()].texture;
    }

    // Vertices whose corners differ in texture coordinates are there several times.
    void split_uvs(SplitVertices& split) {
        if (look_.corner_uvs.size() != 2 * triangles_.size())
            fail("The look has %zu texture coordinates; %u triangles take %zu.", look_.corner_uvs.size(),
                 mesh_.triangle_count, 2 * triangles_.size());
        constexpr uint32_t none = 0xffffffffu;
        const size_t before = mesh_.vertex_count + split.copied.size();
        std::vector<uint32_t> next(before, none);  // where a vertex is once more
        std::vector<uint8_t> has_uv(before, 0);
        data_.uvs.resize(before, glm::vec2(0.0f));
        for (size_t corner = 0; corner < split.indices.size(); ++corner) {
            const glm::vec2 uv(look_.corner_uvs[2 * corner], look_.corner_uvs[2 * corner + 1]);
            if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
                fail("Triangle %zu has texture coordinates that are not finite.", corner / 3);
            uint32_t vertex = split.indices[corner];
            if (!has_uv[vertex]) {
                has_uv[vertex] = 1;
                data_.uvs[vertex] = uv;
                continue;
            }
            while (data_.uvs[vertex] != uv && next[vertex] != none) vertex = next[vertex];
            if (data_.uvs[vertex] != uv) {
                const auto copy = static_cast<uint32_t>(data_.uvs.size());
                next[vertex] = copy;
                next.push_back(none);
                has_uv.push_back(1);
                data_.uvs.push_back(uv);
                split.copied.push_back(vertex < mesh_.vertex_count ? vertex
                                                                   : split.copied[vertex - mesh_.vertex_count]);
                if (!split.label_of.empty()) {
                    const uint32_t label = split.label_of[vertex];
                    split.label_of.push_back(label);
                }
                vertex = copy;
            }
            split.indices[corner] = vertex;
        }
    }

    // Triangles by texture, in their order otherwise.
    void gather_runs(SplitVertices& split) {
        std::map<uint32_t, std::vector<uint32_t>> indices;
        for (size_t t = 0; t < mesh_.triangle_count; ++t) {
            const uint32_t texture = texture_of(t);
            if (texture != no_texture && texture >= look_.textures.size())
                fail("A material has the texture %u; the look has %zu.", texture, look_.textures.size());
            std::vector<uint32_t>& list = indices[texture];
            list.insert(list.end(), &split.indices[3 * t], &split.indices[3 * t] + 3);
        }
        split.indices.clear();
        for (const auto& [texture, list] : indices) {
            data_.runs.push_back({texture, static_cast<uint32_t>(list.size())});
            split.indices.insert(split.indices.end(), list.begin(), list.end());
        }
    }

    bool has_borders() const {
        return look_.border_width_px > 0.0f ||
               std::ranges::any_of(look_.regions, [](const Material& m) { return m.border_width_px > 0.0f; });
    }

    void add_border(const LabelledEdge& edge) {
        const Material* material = look_.regions.empty() ? nullptr : &look_.regions[edge.label % look_.regions.size()];
        if (material && material->border_width_px == 0.0f) material = nullptr;
        const float width_px = material ? material->border_width_px : look_.border_width_px;
        if (width_px == 0.0f) return;
        data_.borders.push_back({data_.positions[edge.low], data_.positions[edge.high],
                                 packed_color(material ? material->border_color : look_.border_color),
                                 0.5f * width_px});
    }

    bool has_own_colors() const { return look_.regions.empty() && look_.vertex_colors.empty() && color_; }

    // Normals and colours that the mesh has, of its vertices.
    void write_columns_of_view() {
        for (uint32_t i = 0; i < mesh_.vertex_count; ++i) {
            if (normal_ && !is_usable(normal_.at<glm::vec3>(i))) fail("Vertex %u has a normal that is not finite.", i);
            if (has_own_colors() && !is_usable(color_.at<glm::vec3>(i)))
                fail("Vertex %u has a colour that is not finite.", i);
        }
        std::vector<FlgBufferColumn> to;
        const auto add = [&](FlgAttribute attribute, FlgNumberFormat format, uint32_t* first) {
            to.push_back({attribute, format, first, sizeof(SurfaceVertex), 0, {}, 0, 0});
        };
        if (normal_) add(FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_OCTAHEDRAL16, &data_.vertices[0].normal);
        if (has_own_colors()) add(FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_SRGB8, &data_.vertices[0].color);
        write_columns({mesh_.columns, mesh_.column_count}, mesh_.vertex_count, to);
    }

    void finish_vertex(uint32_t index, uint32_t source, uint32_t label) {
        SurfaceVertex& vertex = data_.vertices[index];
        vertex = data_.vertices[source];
        const PackedMaterial& material = materials_[label % materials_.size()];
        if (!has_own_colors())
            vertex.color = look_.vertex_colors.empty()
                               ? material.color
                               : packed_color(material.linear_color * vertex_color(look_, source));
        const bool known = data_.has_field && !std::isinf(field_[source]);
        vertex.material = material.metallic_and_roughness | (known ? field_known : 0) | own_part;
        vertex.field = known ? field_[source] : 0.0f;
    }

    const FlgMeshView& mesh_;
    const SurfaceLook& look_;
    const std::span<const float> field_;
    const std::span<const uint32_t> triangles_;
    const Column normal_, color_;
    std::vector<PackedMaterial> materials_;  // by label
    std::vector<glm::vec3> normals_;         // of vertices and copies, or empty
    SurfaceData data_;
};

}  // namespace

glm::vec3 vertex_color(const SurfaceLook& look, uint32_t vertex) {
    if (look.vertex_colors.empty()) return glm::vec3(1.0f);
    const float* const rgb = look.vertex_colors.data() + 4 * size_t{vertex};
    return {rgb[0], rgb[1], rgb[2]};
}

SurfaceData prepare_surface(const FlgMeshView& mesh, const SurfaceLook& look, std::span<const float> field) {
    check_look(look);
    check_mesh(mesh);
    return Builder(mesh, look, field).build();
}

}  // namespace flg::render
