// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_asset.h"

#include <algorithm>
#include <optional>

#include "io/base/failure.h"
#include "io/base/json_text.h"
#include "io/gltf/gltf_leftovers.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_scene.h"
#include "io/gltf/gltf_triangles.h"
#include "io/gltf/kept_bytes.h"
#include "io/gltf/mixed_vertices.h"

namespace flg::io {

namespace {

constexpr uint32_t no_record = UINT32_MAX;
constexpr uint64_t own_material = UINT64_MAX;

// A primitive of triangles that the scene shows, as flgMeshFileRead reads it.
struct ShownPrimitive {
    const Json* json;
    uint64_t node, mesh, index;
    Transform transform;  // from the mesh's coordinates to the view's
    String place;
    uint32_t first = 0;        // of its triangles in the input
    Vector<uint32_t> corners;  // its vertices, three a triangle
    GltfValues positions;
    Vector<uint32_t> triangles;  // of the surface, that lie in these
    bool is_changed = false;
    String primitives;  // what it is written as, if so

    uint32_t triangle_count() const { return static_cast<uint32_t>(corners.size() / 3); }
    bool is_mirrored() const { return determinant(transform) < 0; }
    Vec3 stored(uint32_t vertex) const {
        return {positions.number(vertex, 0), positions.number(vertex, 1), positions.number(vertex, 2)};
    }
};

Vec3 placed(const Transform& t, const Vec3& p) {
    return {t[0] * p.x + t[3] * p.y + t[6] * p.z + t[9], t[1] * p.x + t[4] * p.y + t[7] * p.z + t[10],
            t[2] * p.x + t[5] * p.y + t[8] * p.z + t[11]};
}

// Back, by Cramer's rule; of a transform that flattens, null.
std::optional<Vec3> taken_back(const Transform& t, const Vec3& p) {
    const Vec3 x{t[0], t[1], t[2]}, y{t[3], t[4], t[5]}, z{t[6], t[7], t[8]};
    const double size = dot(x, cross(y, z));
    if (size == 0) return {};
    const Vec3 d = p - Vec3{t[9], t[10], t[11]};
    return Vec3{dot(d, cross(y, z)) / size, dot(x, cross(d, z)) / size, dot(x, cross(y, d)) / size};
}

Vec3 load(const float* p) {
    return {p[0], p[1], p[2]};
}

class AssetWriter {
public:
    AssetWriter(const Path& asset, const CheckedMesh& mesh)
        : document_(asset), mesh_(mesh), provenance_(*mesh.provenance()) {}

    String write() {
        read_shown(asset_triangles());
        for (ShownPrimitive& shown : shown_) shown.is_changed = is_changed(shown);
        begin_bytes();
        for (ShownPrimitive& shown : shown_)
            if (shown.is_changed) rewrite(shown);
        String text = document_text();
        return glb_file(std::move(text), glb_->binary());
    }

private:
    // ---- what there is

    uint32_t asset_triangles() {
        uint32_t count = 0;
        visit_primitives(document_, mesh_.origin(), [&](const GltfPrimitive& primitive) {
            if (primitive.mode < gltf_triangles) return;
            const GltfVertices vertices = read_vertices(document_, primitive);
            ShownPrimitive& shown = shown_.emplace_back();
            shown.json = &primitive.json;
            shown.node = primitive.node;
            shown.mesh = primitive.mesh;
            shown.index = primitive.index;
            shown.transform = primitive.transform;
            shown.place = primitive.place;
            shown.first = count;
            shown.positions = vertices.positions;
            const Vector<uint32_t> indices =
                read_indices(read_index_values(document_, primitive), vertices.positions.count);
            const bool mirrored = shown.is_mirrored();
            visit_triangles(primitive.mode, indices, [&](uint32_t a, uint32_t b, uint32_t c) {
                if (mirrored) std::swap(b, c);
                shown.corners.insert(shown.corners.end(), {a, b, c});
            });
            count += shown.triangle_count();
        });
        return count;
    }

    void read_shown(uint32_t count) {
        if (count != provenance_.input_triangle_count) {
            fail(FLG_ERROR_INVALID_ARGUMENT, "desc.provenance.input_triangle_count",
                 "is %u, but desc.asset shows %u triangles", provenance_.input_triangle_count, count);
        }
        for (uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
            const uint32_t source = provenance_.triangles[t];
            const auto behind = std::upper_bound(shown_.begin(), shown_.end(), source,
                                                 [](uint32_t s, const ShownPrimitive& p) { return s < p.first; });
            std::prev(behind)->triangles.push_back(t);
        }
        records_of_vertex_.assign(mesh_.vertex_count(), no_record);
        bent_.assign(mesh_.triangle_count(), false);
        // Displaced by less than this is not displaced: positions were rounded.
        Vec3 size{};
        for (size_t v = 0; v < mesh_.vertex_count(); ++v) {
            const Vec3 p = load(mesh_.position.at(v));
            size = {std::max(size.x, std::abs(p.x)), std::max(size.y, std::abs(p.y)), std::max(size.z, std::abs(p.z))};
        }
        constexpr double roundings = 1e-6;
        tolerance_ = roundings * length(size);
        for (const ShownPrimitive& shown : shown_) {
            for (const uint32_t t : shown.triangles) {
                bool moved = false;
                for (uint32_t k = 0; k < 3; ++k) moved |= corner_of(shown, t, k).is_moved;
                bent_[t] = moved;
            }
        }
    }

    // Corner k of a triangle of the surface, as a mix of the primitive's vertices.
    MixedVertex corner_of(const ShownPrimitive& shown, uint32_t t, uint32_t k) const {
        MixedVertex mix;
        mix.vertex = mesh_.triangle(t)[k];
        mix.count = 0;
        const uint32_t source = provenance_.triangles[t];
        const uint32_t* const roots = provenance_.input_vertices + size_t{3} * source;
        const uint32_t* const own = &shown.corners[size_t{3} * (source - shown.first)];
        const FlgSourceWeights& lies = provenance_.weights[mix.vertex];
        const std::array<double, 3> weights = {1 - double{lies.weights[0]} - double{lies.weights[1]}, lies.weights[0],
                                               lies.weights[1]};
        Vec3 local;
        for (size_t i = 0; i < 3 && lies.vertices[i] != FLG_NO_INDEX; ++i) {
            const auto at = std::find(roots, roots + 3, lies.vertices[i]) - roots;
            if (at == 3) {
                fail(FLG_ERROR_INVALID_ARGUMENT, "desc.provenance.weights[" + to_text(mix.vertex) + "]",
                     "is in none of the input's triangle %u, in which triangle %u lies", source, t);
            }
            mix.from[mix.count] = own[at];
            mix.weights[mix.count++] = weights[i];
            local = local + weights[i] * shown.stored(own[at]);
        }
        if (mix.count == 0) {
            fail(FLG_ERROR_INVALID_ARGUMENT, "desc.provenance.weights[" + to_text(mix.vertex) + "]", "names no vertex");
        }
        const Vec3 is = load(mesh_.position.at(mix.vertex));
        if (length(is - placed(shown.transform, local)) > tolerance_) {
            if (const std::optional<Vec3> back = taken_back(shown.transform, is)) {
                mix.is_moved = true;
                mix.position = *back;
            }
        }
        mix.is_bent = bent_[t];
        return mix;
    }

    // A label below the table's size is a material of it.
    uint64_t material_of(uint32_t t) const {
        const uint32_t label = mesh_.region(t);
        return label < mesh_.materials().size() ? label : own_material;
    }

    bool is_changed(const ShownPrimitive& shown) const {
        return std::any_of(shown.triangles.begin(), shown.triangles.end(), [&](uint32_t t) {
            if (material_of(t) != own_material) return true;
            for (uint32_t k = 0; k < 3; ++k) {
                const MixedVertex corner = corner_of(shown, t, k);
                if (corner.count != 1 || corner.is_bent) return true;
            }
            return false;
        });
    }

    // ---- what becomes of a primitive

    // The place of a vertex among the records: one a vertex of the primitive that is kept, one a place between.
    uint32_t record_of(const MixedVertex& mix) {
        uint32_t& kept = record_of_own_[mix.from[0]];
        const auto same = [&](uint32_t record) {
            const MixedVertex& other = records_[record];
            return other.is_bent == mix.is_bent && other.count == mix.count &&
                   std::equal(mix.from.begin(), mix.from.begin() + mix.count, other.from.begin());
        };
        if (mix.count == 1 && !mix.is_bent && kept != no_record) return kept;
        uint32_t& head = records_of_vertex_[mix.vertex];
        for (uint32_t record = head; record != no_record; record = next_record_[record])
            if (same(record)) return record;
        const auto record = static_cast<uint32_t>(records_.size());
        records_.push_back(mix);
        next_record_.push_back(head);
        head = record;
        if (mix.count == 1 && !mix.is_bent) kept = record;
        return record;
    }

    void rewrite(ShownPrimitive& shown) {
        records_.clear();
        next_record_.clear();
        record_of_own_.assign(shown.positions.count, no_record);
        Map<uint64_t, Vector<uint32_t>> corners;  // records, by material
        const auto add = [&](uint64_t material, std::array<uint32_t, 3> triangle) {
            if (shown.is_mirrored()) std::swap(triangle[1], triangle[2]);
            corners[material].insert(corners[material].end(), triangle.begin(), triangle.end());
        };
        Vector<bool> is_there(shown.triangle_count());
        for (const uint32_t t : shown.triangles) {
            is_there[provenance_.triangles[t] - shown.first] = true;
            std::array<uint32_t, 3> triangle{};
            for (uint32_t k = 0; k < 3; ++k) triangle[k] = record_of(corner_of(shown, t, k));
            add(material_of(t), triangle);
        }
        bend_normals(shown);
        add_lost(shown, is_there, add);
        for (const MixedVertex& record : records_) records_of_vertex_[record.vertex] = no_record;
        put_in_order(corners);
        shown.primitives = text_of(shown, corners);
    }

    // Triangles that the surface does not have.
    template <class Add>
    void add_lost(const ShownPrimitive& shown, const Vector<bool>& is_there, const Add& add) {
        for (uint32_t s = 0; s < is_there.size(); ++s) {
            if (is_there[s]) continue;
            std::array<uint32_t, 3> triangle{};
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t own = shown.corners[size_t{3} * s + k];
                uint32_t& record = record_of_own_[own];
                if (record == no_record) {
                    record = static_cast<uint32_t>(records_.size());
                    records_.emplace_back().from[0] = own;
                    next_record_.push_back(no_record);
                }
                triangle[k] = record;
            }
            add(own_material, triangle);
        }
    }

    // Normals of what was moved: of the triangles around, by area, on the same side of a hard edge.
    void bend_normals(const ShownPrimitive& shown) {
        if (std::none_of(records_.begin(), records_.end(), [](const MixedVertex& r) { return r.is_bent; })) return;
        const std::optional<GltfValues> stored = normals_of(shown);
        const auto normal_of = [&](const MixedVertex& record) {
            Vec3 sum;
            for (uint32_t k = 0; stored && k < record.count; ++k) {
                const uint32_t v = record.from[k];
                sum = sum + record.weights[k] * Vec3{stored->number(v, 0), stored->number(v, 1), stored->number(v, 2)};
            }
            return normalized(sum);
        };
        Vector<Vec3> before(records_.size());
        for (size_t r = 0; r < records_.size(); ++r) before[r] = normal_of(records_[r]);
        constexpr double same_side = 0.9999;
        for (const uint32_t t : shown.triangles) {
            const Vec3 a = local_position(shown, t, 0), b = local_position(shown, t, 1),
                       c = local_position(shown, t, 2);
            const double side = shown.is_mirrored() ? -1 : 1;
            const Vec3 area = side * cross(b - a, c - a);
            for (uint32_t k = 0; k < 3; ++k) {
                const MixedVertex corner = corner_of(shown, t, k);
                if (!corner.is_bent) continue;
                const Vec3 own = normal_of(corner);
                for (uint32_t r = records_of_vertex_[corner.vertex]; r != no_record; r = next_record_[r])
                    if (records_[r].is_bent && (!stored || dot(before[r], own) > same_side))
                        records_[r].normal = records_[r].normal + area;
            }
        }
        for (size_t r = 0; r < records_.size(); ++r) {
            if (!records_[r].is_bent) continue;
            records_[r].normal = normalized(records_[r].normal);
            if (length(records_[r].normal) == 0) records_[r].normal = length(before[r]) > 0 ? before[r] : Vec3{0, 0, 1};
        }
    }

    std::optional<GltfValues> normals_of(const ShownPrimitive& shown) const {
        const Json* const index = shown.json->find("attributes")->find("NORMAL");
        if (!index || !index->is_count()) return {};
        GltfValues values = document_.accessor(index->count(), shown.place + ".attributes.NORMAL");
        if (values.components != 3 || values.count != shown.positions.count) return {};
        return values;
    }

    Vec3 local_position(const ShownPrimitive& shown, uint32_t t, uint32_t k) const {
        const Vec3 is = load(mesh_.position.at(mesh_.triangle(t)[k]));
        return taken_back(shown.transform, is).value_or(is);
    }

    // The primitive's vertices in their order, then those between.
    void put_in_order(Map<uint64_t, Vector<uint32_t>>& corners) {
        Vector<uint32_t> order(records_.size());
        for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
            const auto key = [&](uint32_t r) {
                return std::pair(records_[r].count == 1 ? uint64_t{records_[r].from[0]} : UINT64_MAX, r);
            };
            return key(a) < key(b);
        });
        Vector<uint32_t> place(order.size());
        Vector<MixedVertex> sorted;
        sorted.reserve(order.size());
        for (uint32_t i = 0; i < order.size(); ++i) {
            place[order[i]] = i;
            sorted.push_back(records_[order[i]]);
        }
        records_ = std::move(sorted);
        for (auto& [material, list] : corners)
            for (uint32_t& record : list) record = place[record];
    }

    String text_of(const ShownPrimitive& shown, const Map<uint64_t, Vector<uint32_t>>& corners) {
        const Json& json = *shown.json;
        String rest;
        for (const JsonMember& member : json.members()) {
            if (member.name == "attributes" || member.name == "indices" || member.name == "mode" ||
                member.name == "material" || member.name == "targets" || member.name == "extensions")
                continue;
            rest += "," + json_text(member.name) + ":" + json_text(member.value);
        }
        const MixedAttributes attributes =
            add_mixed_attributes(document_, *json.find("attributes"), shown.place + ".attributes", records_, *glb_);
        String targets;
        const Json* const shapes = gltf_array(json, "targets", shown.place);
        for (size_t i = 0; shapes && i < shapes->size(); ++i) {
            const String here = shown.place + ".targets[" + to_text(i) + "]";
            separate(targets);
            targets += "{" + add_mixed_target(document_, (*shapes)[i], here, records_, *glb_) + "}";
        }
        if (!targets.empty()) rest += ",\"targets\":[" + targets + "]";
        String text;
        for (const auto& [material, list] : corners) {
            separate(text);
            // Colours of vertices would tint what has a material of its own.
            text += "{\"attributes\":{" + attributes.uncolored + (material == own_material ? attributes.colors : "") +
                    "},\"indices\":" + to_text(glb_->add_indices(list));
            if (material != own_material) {
                const auto label = static_cast<uint32_t>(material);
                text += ",\"material\":" + to_text(new_material(label, is_two_sided(json)));
            } else if (const Json* const own = json.find("material")) {
                text += ",\"material\":" + json_text(*own);
            }
            text += extensions_of(json, material == own_material);
            text += rest + "}";
        }
        return text;
    }

    // Sheets are seen from both sides with any material.
    bool is_two_sided(const Json& primitive) const {
        const Json* const own = primitive.find("material");
        if (!own || !own->is_count() || own->count() >= document_.size("materials")) return false;
        const Json* const value = document_.element("materials", own->count(), "materials").find("doubleSided");
        return value && value->is_boolean() && value->boolean();
    }

    // Without what would put the triangles of before, or a variant of the material, in the place of these.
    static String extensions_of(const Json& primitive, bool has_own_material) {
        const Json* const extensions = primitive.find("extensions");
        String text;
        if (!extensions) return text;
        for (const JsonMember& extension : extensions->members()) {
            if (extension.name == "KHR_draco_mesh_compression" ||
                (!has_own_material && extension.name == "KHR_materials_variants"))
                continue;
            separate(text);
            text += json_text(extension.name) + ":" + json_text(extension.value);
        }
        return text.empty() ? text : ",\"extensions\":{" + text + "}";
    }

    uint64_t new_material(uint32_t label, bool two_sided) {
        const auto [found, is_new] =
            materials_.try_emplace({label, two_sided}, document_.size("materials") + materials_.size());
        if (is_new) {
            FlgMeshMaterial material = mesh_.materials()[label];
            if (two_sided) material.two_sided = 1;
            separate(material_texts_);
            material_texts_ += json_material(material, "region " + to_text(label));
        }
        return found->second;
    }

    // ---- the document

    // All bytes that are still used, and the places in the document's lists that are free.
    void begin_bytes() {
        Map<uint64_t, uint64_t> nodes_of_mesh;
        for (uint64_t n = 0; n < document_.size("nodes"); ++n)
            if (const Json* const mesh = document_.element("nodes", n, "nodes").find("mesh"); mesh && mesh->is_count())
                ++nodes_of_mesh[mesh->count()];
        const auto is_gone = [&](uint64_t mesh, uint64_t primitive) {
            return nodes_of_mesh[mesh] <= 1 && std::any_of(shown_.begin(), shown_.end(), [&](const ShownPrimitive& s) {
                       return s.is_changed && s.mesh == mesh && s.index == primitive;
                   });
        };
        GltfLeftovers left = find_leftovers(document_, is_gone);
        for (uint64_t v = 0; v < document_.size("bufferViews"); ++v) {
            if (std::binary_search(left.views.begin(), left.views.end(), v)) continue;
            const String place = "bufferViews[" + to_text(v) + "]";
            const Json& view = document_.element("bufferViews", v, place);
            kept_.add(document_, view, place);
        }
        String bytes = kept_.merge(document_);
        glb_.emplace(GlbBuilder::Places{document_.size("bufferViews"), std::move(left.views)},
                     GlbBuilder::Places{document_.size("accessors"), std::move(left.accessors)}, std::move(bytes));
    }

    String image_text(uint64_t index) {
        const String place = "images[" + to_text(index) + "]";
        const Json& image = document_.element("images", index, place);
        if (!image.find("uri")) return json_text(image);
        const ByteBlock picture = document_.image(index, place);
        String text;
        for (const JsonMember& member : image.members()) {
            if (member.name != "uri" && member.name != "mimeType")
                text += "," + json_text(member.name) + ":" + json_text(member.value);
        }
        return "{\"bufferView\":" + to_text(glb_->add_file(picture.bytes())) + ",\"mimeType\":\"" +
               picture_kind(as_text(picture.bytes()), place) + "\"" + text + "}";
    }

    static const char* picture_kind(std::string_view bytes, const String& place) {
        if (bytes.starts_with("\x89PNG")) return "image/png";
        if (bytes.starts_with("\xff\xd8")) return "image/jpeg";
        if (bytes.starts_with("RIFF") && bytes.substr(0, 16).find("WEBP") != bytes.npos) return "image/webp";
        if (bytes.starts_with("\xabKTX 20")) return "image/ktx2";
        fail(FLG_ERROR_FORMAT, place + ".uri", "is no PNG, JPEG, WebP or KTX 2 file");
    }

    // Which mesh a node shows now; meshes that are new are at the end of the list.
    void divide_meshes(Vector<String>& meshes, Map<uint64_t, uint64_t>& mesh_of_node) const {
        Map<uint64_t, uint64_t> shown_by;  // nodes that show a mesh as it was
        for (uint64_t n = 0; n < document_.size("nodes"); ++n) {
            const Json& node = document_.element("nodes", n, "nodes");
            if (node.find("mesh")) ++shown_by[gltf_required(node, "mesh", "nodes[" + to_text(n) + "].mesh")];
        }
        for (size_t begin = 0, end = 0; begin < shown_.size(); begin = end) {
            const ShownPrimitive& first = shown_[begin];
            while (end < shown_.size() && shown_[end].node == first.node && shown_[end].mesh == first.mesh) ++end;
            const std::span<const ShownPrimitive> placement(&first, end - begin);
            const bool changed = std::any_of(placement.begin(), placement.end(),
                                             [](const ShownPrimitive& shown) { return shown.is_changed; });
            if (!changed) continue;
            const String text = mesh_text(placement);
            if (first.node == no_node || shown_by[first.mesh] == 1) {
                meshes[first.mesh] = text;
                continue;
            }
            --shown_by[first.mesh];
            mesh_of_node[first.node] = meshes.size();
            meshes.push_back(text);
        }
    }

    String mesh_text(std::span<const ShownPrimitive> placement) const {
        const Json& mesh = document_.element("meshes", placement.front().mesh, "meshes");
        const Json& primitives = *mesh.find("primitives");
        String list, text;
        for (size_t i = 0; i < primitives.size(); ++i) {
            const auto shown =
                std::find_if(placement.begin(), placement.end(), [&](const ShownPrimitive& s) { return s.index == i; });
            if (i != 0) list += ',';
            list += shown == placement.end() || !shown->is_changed ? json_text(primitives[i]) : shown->primitives;
        }
        for (const JsonMember& member : mesh.members())
            if (member.name != "primitives") text += "," + json_text(member.name) + ":" + json_text(member.value);
        return "{\"primitives\":[" + list + "]" + text + "}";
    }

    String node_text(uint64_t index, const Map<uint64_t, uint64_t>& mesh_of_node) const {
        const Json& node = document_.element("nodes", index, "nodes");
        const auto mesh = mesh_of_node.find(index);
        if (mesh == mesh_of_node.end()) return json_text(node);
        String text = "{\"mesh\":" + to_text(mesh->second);
        for (const JsonMember& member : node.members())
            if (member.name != "mesh") text += "," + json_text(member.name) + ":" + json_text(member.value);
        return text + "}";
    }

    // A list of the document, each element by `text_of`, then those that were added.
    template <class TextOf>
    String list(const char* name, TextOf text_of, const String& added = "") const {
        String text;
        for (uint64_t i = 0; i < document_.size(name); ++i) {
            separate(text);
            text += text_of(i);
        }
        if (!added.empty()) separate(text);
        text += added;
        return text.empty() ? text : ",\"" + String(name) + "\":[" + text + "]";
    }

    // The same of what the builder adds to.
    template <class TextOf>
    String list(const char* name, const Vector<String>& texts, TextOf text_of) const {
        String text;
        for (uint64_t i = 0; i < texts.size(); ++i) {
            separate(text);
            text += texts[i].empty() ? text_of(i) : texts[i];
        }
        return text.empty() ? text : ",\"" + String(name) + "\":[" + text + "]";
    }

    String document_text() {
        const auto own = [&](const char* name) {
            return [this, name](uint64_t i) { return json_text((*document_.root().find(name))[i]); };
        };
        Vector<String> meshes(document_.size("meshes"));
        for (uint64_t m = 0; m < meshes.size(); ++m) meshes[m] = own("meshes")(m);
        Map<uint64_t, uint64_t> mesh_of_node;
        divide_meshes(meshes, mesh_of_node);
        String mesh_list;
        for (const String& mesh : meshes) {
            separate(mesh_list);
            mesh_list += mesh;
        }

        String text = "{\"asset\":" + json_text(*document_.root().find("asset"));
        for (const JsonMember& member : document_.root().members()) {
            if (member.name == "asset" || member.name == "buffers" || member.name == "bufferViews" ||
                member.name == "accessors" || member.name == "meshes" || member.name == "nodes" ||
                member.name == "materials" || member.name == "images")
                continue;
            text += "," + json_text(member.name) + ":" + json_text(member.value);
        }
        text += list("nodes", [&](uint64_t n) { return node_text(n, mesh_of_node); });
        text += ",\"meshes\":[" + mesh_list + "]";
        text += list("materials", own("materials"), material_texts_);
        text += list("images", [this](uint64_t i) { return image_text(i); });
        glb_->fill_places();
        text += list("accessors", glb_->accessors(), own("accessors"));
        text += list("bufferViews", glb_->views(), [this](uint64_t v) {
            const String place = "bufferViews[" + to_text(v) + "]";
            return kept_.moved_view(document_.element("bufferViews", v, place), place);
        });
        return text + ",\"buffers\":[{\"byteLength\":" + to_text(glb_->binary().size()) + "}]}";
    }

    GltfDocument document_;
    const CheckedMesh& mesh_;
    const FlgSurfaceProvenanceView& provenance_;
    Vector<ShownPrimitive> shown_;
    Vector<bool> bent_;  // triangles with a vertex that was moved
    double tolerance_ = 0;

    // Of the primitive at hand; those of one vertex of the surface are a list.
    Vector<MixedVertex> records_;
    Vector<uint32_t> next_record_, records_of_vertex_, record_of_own_;

    std::optional<GlbBuilder> glb_;
    KeptBytes kept_;
    Map<std::pair<uint32_t, bool>, uint64_t> materials_;  // by label, and whether both sides are seen
    String material_texts_;
};

}  // namespace

String write_glb_asset(const Path& asset, const CheckedMesh& mesh) {
    try {
        return AssetWriter(asset, mesh).write();
    } catch (const Failure& failure) {
        // What is wrong is in the asset, or in what the host hands over.
        if (failure.place().starts_with("desc.")) throw;
        const String separator = failure.place().empty() ? "" : ":";
        fail(failure.result(), asset.name() + separator + failure.place(), "%s", failure.what());
    }
}

}  // namespace flg::io
