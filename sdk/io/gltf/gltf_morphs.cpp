// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_morphs.h"

#include <cmath>

namespace flg::io {

void GltfMorphReader::append(const GltfPrimitive& primitive, uint64_t node, uint64_t vertex_count) {
    const Json* const targets = gltf_array(primitive.json, "targets", primitive.place);
    const size_t count = targets ? targets->size() : 0;
    const bool is_first = vertex_count_ == 0;
    vertex_count_ += vertex_count;
    has_any_ = has_any_ || count > 0;
    if (is_first) {
        node_ = node;
        targets_.resize(count);
    }
    is_uneven_ = is_uneven_ || node != node_ || count != targets_.size();
    if (is_uneven_) {
        targets_.clear();
        return;
    }
    // A small file may claim very much: targets without values are zeros.
    constexpr uint64_t vertex_bytes = 6 * sizeof(float);
    if (count != 0 && vertex_count_ > max_bytes / vertex_bytes / count)
        fail(FLG_ERROR_LIMIT, primitive.place + ".targets", "take more than the limit of 2 GiB");
    for (size_t i = 0; i < count; ++i) {
        const Json& target = (*targets)[i];
        if (!target.is_object()) fail(FLG_ERROR_FORMAT, primitive.place + ".targets", "has one that is no object");
        append_values(target, "POSITION", primitive, vertex_count, targets_[i].moves);
        append_values(target, "NORMAL", primitive, vertex_count, targets_[i].normal_moves);
    }
}

void GltfMorphReader::append_values(const Json& target, const char* name, const GltfPrimitive& primitive,
                                    uint64_t vertex_count, Vector<float>& to) const {
    const size_t begin = to.size();
    to.resize(begin + 3 * vertex_count);
    if (!target.find(name)) return;
    const String place = primitive.place + ".targets";
    const GltfValues values = document_.accessor(gltf_required(target, name, place), place + "." + name);
    if (values.components != 3 || (values.component_type != gltf_float && !values.normalized))
        fail(FLG_ERROR_FORMAT, values.place, "holds moves that are not three floats a vertex");
    if (values.count != vertex_count)
        fail(FLG_ERROR_FORMAT, values.place + ".count", "is %llu, but there are %llu positions",
             static_cast<unsigned long long>(values.count), static_cast<unsigned long long>(vertex_count));
    const Transform& t = primitive.transform;
    for (uint32_t v = 0; v < vertex_count; ++v) {
        const float m[3] = {values.number(v, 0), values.number(v, 1), values.number(v, 2)};
        for (size_t row = 0; row < 3; ++row) {
            const float moved = static_cast<float>(t[row] * m[0] + t[3 + row] * m[1] + t[6 + row] * m[2]);
            if (!(std::abs(moved) <= max_coordinate)) refuse_value(values, v, moved);
            to[begin + 3 * size_t{v} + row] = moved;
        }
    }
}

// By the convention that programs keep to.
String GltfMorphReader::name_of(size_t target) const {
    const Json& node = document_.element("nodes", node_, "nodes");
    const Json& mesh = document_.element("meshes", gltf_required(node, "mesh", "nodes"), "nodes");
    const Json* const extras = mesh.find("extras");
    const Json* const names = extras ? extras->find("targetNames") : nullptr;
    constexpr size_t longest_name = 255;
    if (names && target < names->size() && (*names)[target].is_string() &&
        (*names)[target].string().size() <= longest_name)
        return String((*names)[target].string());
    return "target " + to_text(target);
}

void GltfMorphReader::finish(SkinData& data) {
    if (is_uneven_ && has_any_) data.warnings.push_back("the skin's primitives have different morph targets: left out");
    for (size_t i = 0; i < targets_.size(); ++i) targets_[i].name = name_of(i);
    data.morphs = std::move(targets_);
}

bool GltfMorphReader::read_animation(const Json& animation, const String& place, const String& name, uint32_t index,
                                     SkinData& data) const {
    const Json* const channels = gltf_array(animation, "channels", place);
    const Json* const samplers = gltf_array(animation, "samplers", place);
    for (size_t i = 0; channels && !data.morphs.empty() && i < channels->size(); ++i) {
        const String here = place + ".channels[" + to_text(i) + "]";
        const Json* const target = (*channels)[i].find("target");
        const Json* const path = target ? target->find("path") : nullptr;
        if (!path || !(*path == "weights") || gltf_unsigned(*target, "node", node_ + 1, here) != node_) continue;
        const uint64_t number = gltf_required((*channels)[i], "sampler", here);
        if (!samplers || number >= samplers->size())
            fail(FLG_ERROR_FORMAT, here + ".sampler", "is %llu, but there are %zu",
                 static_cast<unsigned long long>(number), samplers ? samplers->size() : 0);
        const Json& sampler = (*samplers)[number];
        const String sampler_place = place + ".samplers[" + to_text(number) + "]";
        const Json* const interpolation = sampler.find("interpolation");
        if (interpolation && !(*interpolation == "LINEAR")) {
            data.warnings.push_back(here + " moves morph targets, but not LINEAR: left out");
            return false;
        }
        const GltfValues times = document_.accessor(gltf_required(sampler, "input", sampler_place), sampler_place);
        const GltfValues weights = document_.accessor(gltf_required(sampler, "output", sampler_place), sampler_place);
        for (const GltfValues* values : {&times, &weights})
            if (values->components != 1 || (values->component_type != gltf_float && !values->normalized))
                fail(FLG_ERROR_FORMAT, values->place, "holds times or weights that are no floats");
        if (times.count == 0 || times.count > max_bytes || weights.count != times.count * data.morphs.size())
            fail(FLG_ERROR_FORMAT, weights.place + ".count", "is %llu, but %zu targets have %llu keys",
                 static_cast<unsigned long long>(weights.count), data.morphs.size(),
                 static_cast<unsigned long long>(times.count));
        if (weights.count > max_bytes / sizeof(float))
            fail(FLG_ERROR_LIMIT, weights.place + ".count", "takes more than the limit of 2 GiB");
        MorphAnimationData read;
        read.name = name;
        read.animation = index;
        for (uint64_t key = 0; key < times.count; ++key) {
            const float time = times.number(key, 0);
            const bool rises = read.times.empty() ? time >= 0 : time > read.times.back();
            if (!rises || !(time <= max_coordinate))
                fail(FLG_ERROR_FORMAT, times.place, "time %llu is %g: times rise from 0 or later",
                     static_cast<unsigned long long>(key), double{time});
            read.times.push_back(time);
        }
        for (uint64_t k = 0; k < weights.count; ++k) {
            const float weight = weights.number(k, 0);
            if (!(std::abs(weight) <= max_coordinate))
                fail(FLG_ERROR_FORMAT, weights.place, "weight %llu is %g, must be finite",
                     static_cast<unsigned long long>(k), double{weight});
            read.weights.push_back(weight);
        }
        data.morph_animations.push_back(std::move(read));
        return true;
    }
    return false;
}

}  // namespace flg::io
