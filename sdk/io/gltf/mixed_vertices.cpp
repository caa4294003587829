// SPDX-License-Identifier: MIT
#include "io/gltf/mixed_vertices.h"

#include <algorithm>
#include <cmath>

#include "io/base/failure.h"
#include "io/base/json_text.h"
#include "io/gltf/gltf_scene.h"

namespace flg::io {

namespace {

constexpr const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};

GltfValues read_values(const GltfDocument& document, const JsonMember& attribute, const String& place,
                       std::span<const MixedVertex> vertices) {
    const String here = place + "." + String(attribute.name);
    if (!attribute.value.is_count()) fail(FLG_ERROR_FORMAT, here, "is no whole number >= 0");
    GltfValues values = document.accessor(attribute.value.count(), here);
    for (const MixedVertex& vertex : vertices) {
        for (uint32_t k = 0; k < vertex.count; ++k) {
            if (vertex.from[k] < values.count) continue;
            fail(FLG_ERROR_FORMAT, values.place + ".count", "is %llu, but there are more positions",
                 static_cast<unsigned long long>(values.count));
        }
    }
    return values;
}

void append_mixed(const GltfValues& values, const MixedVertex& vertex, Vector<float>& to) {
    for (uint32_t c = 0; c < values.components; ++c) {
        double sum = 0;
        for (uint32_t k = 0; k < vertex.count; ++k) {
            const float value = values.number(vertex.from[k], c);
            if (!std::isfinite(value)) refuse_value(values, vertex.from[k], value);
            sum += vertex.count == 1 ? double{value} : vertex.weights[k] * value;
        }
        to.push_back(static_cast<float>(sum));
    }
}

Vector<float> mixed(const GltfValues& values, std::span<const MixedVertex> vertices) {
    Vector<float> to;
    to.reserve(vertices.size() * values.components);
    for (const MixedVertex& vertex : vertices) append_mixed(values, vertex, to);
    return to;
}

size_t nearest(const MixedVertex& vertex) {
    const auto end = vertex.weights.begin() + vertex.count;
    return static_cast<size_t>(std::max_element(vertex.weights.begin(), end) - vertex.weights.begin());
}

// Names of an application's own begin so. Where all such values are whole numbers they are labels, which have no mix.
bool are_labels(const String& name, const GltfValues& values) {
    if (!name.starts_with('_')) return false;
    for (uint64_t v = 0; v < values.count; ++v) {
        for (uint32_t c = 0; c < values.components; ++c) {
            const float value = values.number(v, c);
            if (value != std::floor(value)) return false;
        }
    }
    return true;
}

Vector<float> nearest_values(const GltfValues& values, std::span<const MixedVertex> vertices) {
    Vector<float> to;
    to.reserve(vertices.size() * values.components);
    for (const MixedVertex& vertex : vertices) {
        const uint32_t from = vertex.from[vertex.count == 1 ? 0 : nearest(vertex)];
        for (uint32_t c = 0; c < values.components; ++c) to.push_back(values.number(from, c));
    }
    return to;
}

// The first three numbers of each as directions; a fourth, a tangent's sign, is that of the nearest vertex.
Vector<float> mixed_directions(const GltfValues& values, std::span<const MixedVertex> vertices) {
    Vector<float> to = mixed(values, vertices);
    for (size_t i = 0; i < vertices.size(); ++i) {
        const MixedVertex& vertex = vertices[i];
        if (vertex.count == 1 && !vertex.is_bent) continue;
        float* const at = &to[i * values.components];
        Vec3 direction{at[0], at[1], at[2]};
        if (vertex.is_bent && values.components == 3) direction = vertex.normal;
        // A tangent lies in the surface.
        if (vertex.is_bent && values.components > 3)
            direction = direction - dot(direction, vertex.normal) * vertex.normal;
        direction = normalized(direction);
        at[0] = static_cast<float>(direction.x);
        at[1] = static_cast<float>(direction.y);
        at[2] = static_cast<float>(direction.z);
        if (values.components > 3) at[3] = values.number(vertex.from[nearest(vertex)], 3);
    }
    return to;
}

// What an accessor has besides its values: a name, extras, extensions.
String further_members(const GltfDocument& document, const JsonMember& attribute) {
    constexpr std::string_view known[] = {"bufferView", "byteOffset", "componentType", "count", "type",
                                          "normalized", "sparse",     "min",           "max"};
    String text;
    for (const JsonMember& member : document.element("accessors", attribute.value.count(), "accessors").members()) {
        if (std::find(std::begin(known), std::end(known), member.name) == std::end(known))
            text.append(",").append(json_text(member.name)).append(":").append(json_text(member.value));
    }
    return text;
}

size_t add(GlbBuilder& glb, const Vector<float>& values, uint32_t components, bool with_bounds,
           const String& further = "") {
    const size_t view = glb.add_view(values, components);
    const size_t count = values.size() / components;
    return with_bounds ? glb.add_positions(view, values, 0, count, further)
                       : glb.add_accessor(view, 0, count, glb_float, types[components], further);
}

struct Influence {
    uint32_t joint;
    double weight;
};

// The largest first.
void mix_influences(std::span<const GltfValues> joints, std::span<const GltfValues> weights, const MixedVertex& vertex,
                    Vector<Influence>& to) {
    to.clear();
    for (uint32_t k = 0; k < vertex.count; ++k) {
        for (size_t set = 0; set < joints.size(); ++set) {
            for (uint32_t c = 0; c < 4; ++c) {
                const float stored = weights[set].number(vertex.from[k], c);
                if (!std::isfinite(stored)) refuse_value(weights[set], vertex.from[k], stored);
                const double weight = double{stored} * vertex.weights[k];
                const auto joint = static_cast<uint32_t>(joints[set].number(vertex.from[k], c));
                const auto same =
                    std::find_if(to.begin(), to.end(), [&](const Influence& i) { return i.joint == joint; });
                if (vertex.count == 1 || same == to.end())
                    to.push_back({joint, weight});
                else
                    same->weight += weight;
            }
        }
    }
    const size_t kept = 4 * joints.size();
    if (vertex.count == 1) return;
    std::sort(to.begin(), to.end(), [](const Influence& a, const Influence& b) {
        return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
    });
    to.resize(kept);
    double sum = 0;
    for (const Influence& influence : to) sum += influence.weight;
    for (Influence& influence : to) {
        if (sum > 0) influence.weight /= sum;
        if (influence.weight == 0) influence.joint = 0;
    }
}

String add_influences(const GltfDocument& document, const Json& attributes, const String& place,
                      std::span<const MixedVertex> vertices, GlbBuilder& glb) {
    Vector<GltfValues> joints, weights;
    for (size_t set = 0;; ++set) {
        const Json* const joint = attributes.find("JOINTS_" + to_text(set));
        const Json* const weight = attributes.find("WEIGHTS_" + to_text(set));
        if (!joint && !weight) break;
        if (!joint || !weight) fail(FLG_ERROR_FORMAT, place, "has one alone of JOINTS_%zu and WEIGHTS_%zu", set, set);
        joints.push_back(read_values(document, {"JOINTS_" + to_text(set), *joint}, place, vertices));
        weights.push_back(read_values(document, {"WEIGHTS_" + to_text(set), *weight}, place, vertices));
        if (joints.back().components != 4 || weights.back().components != 4)
            fail(FLG_ERROR_FORMAT, joints.back().place, "holds joints, or its weights, that are not four a vertex");
        if (joints.back().component_type != gltf_unsigned_byte && joints.back().component_type != gltf_unsigned_short)
            fail(FLG_ERROR_FORMAT, joints.back().place, "holds joints that are no whole numbers of 8 or 16 bits");
    }
    Vector<Vector<uint16_t>> numbers(joints.size());
    Vector<Vector<float>> values(joints.size());
    Vector<Influence> influences;
    for (const MixedVertex& vertex : vertices) {
        mix_influences(joints, weights, vertex, influences);
        for (size_t i = 0; i < 4 * joints.size(); ++i) {
            numbers[i / 4].push_back(static_cast<uint16_t>(influences[i].joint));
            values[i / 4].push_back(static_cast<float>(influences[i].weight));
        }
    }
    String members;
    for (size_t set = 0; set < joints.size(); ++set) {
        size_t accessor;
        if (joints[set].component_type == gltf_unsigned_byte) {
            const Vector<uint8_t> narrow(numbers[set].begin(), numbers[set].end());
            accessor = glb.add_accessor(glb.add_view(narrow), 0, vertices.size(), glb_unsigned_byte, "VEC4");
        } else {
            accessor = glb.add_accessor(glb.add_view(numbers[set]), 0, vertices.size(), glb_unsigned_short, "VEC4");
        }
        members += ",\"JOINTS_" + to_text(set) + "\":" + to_text(accessor);
        members += ",\"WEIGHTS_" + to_text(set) + "\":" + to_text(add(glb, values[set], 4, false));
    }
    return members;
}

}  // namespace

MixedAttributes add_mixed_attributes(const GltfDocument& document, const Json& attributes, const String& place,
                                     std::span<const MixedVertex> vertices, GlbBuilder& glb) {
    String members;
    MixedAttributes out;
    for (const JsonMember& attribute : attributes.members()) {
        if (attribute.name.starts_with("JOINTS_") || attribute.name.starts_with("WEIGHTS_")) continue;
        const GltfValues values = read_values(document, attribute, place, vertices);
        const bool of_positions = attribute.name == "POSITION";
        const bool of_directions = attribute.name == "NORMAL" || attribute.name == "TANGENT";
        if ((of_positions || of_directions) && values.components < 3)
            fail(FLG_ERROR_FORMAT, values.place, "holds fewer than three numbers a vertex");
        Vector<float> numbers = of_directions                                ? mixed_directions(values, vertices)
                                : are_labels(String(attribute.name), values) ? nearest_values(values, vertices)
                                                                             : mixed(values, vertices);
        for (size_t i = 0; of_positions && i < vertices.size(); ++i) {
            if (!vertices[i].is_moved) continue;
            const Vec3& position = vertices[i].position;
            numbers[3 * i] = static_cast<float>(position.x);
            numbers[3 * i + 1] = static_cast<float>(position.y);
            numbers[3 * i + 2] = static_cast<float>(position.z);
        }
        const size_t accessor =
            add(glb, numbers, values.components, of_positions, further_members(document, attribute));
        String& list = attribute.name == "COLOR_0" ? out.colors : members;
        list.append(",").append(json_text(attribute.name)).append(":").append(to_text(accessor));
    }
    members += add_influences(document, attributes, place, vertices, glb);
    out.uncolored = members.substr(1);
    return out;
}

String add_mixed_target(const GltfDocument& document, const Json& target, const String& place,
                        std::span<const MixedVertex> vertices, GlbBuilder& glb) {
    String members;
    for (const JsonMember& attribute : target.members()) {
        const GltfValues values = read_values(document, attribute, place, vertices);
        const Vector<float> numbers = mixed(values, vertices);
        const size_t accessor = values.components == 3 ? glb.add_moves(numbers, attribute.name == "POSITION")
                                                       : add(glb, numbers, values.components, false);
        separate(members);
        members += json_text(attribute.name) + ":" + to_text(accessor);
    }
    return members;
}

}  // namespace flg::io
