// SPDX-License-Identifier: MIT
#include <algorithm>

#include "scene_makers.h"

namespace flg::scenes {
namespace {

constexpr uint32_t kUsualHairs = 2000, kUsualFlowLines = 120, kMaxCurves = 100'000;

uint32_t curve_count(uint32_t wanted, uint32_t usual) {
    return wanted == 0 ? usual : std::min(wanted, kMaxCurves);
}

struct Maker {
    const char* name;
    std::vector<Curve> (*make)(uint32_t count);
    bool network;
};

constexpr Maker kMakers[] = {
    {"bouquet", [](uint32_t) { return make_bouquet(); }, false},
    {"hair", [](uint32_t count) { return make_hair(curve_count(count, kUsualHairs)); }, false},
    {"tree", [](uint32_t) { return make_tree(); }, true},
    {"icosahedron", [](uint32_t) { return make_icosahedron(); }, true},
    {"tower", [](uint32_t) { return make_tower(); }, true},
    {"flow", [](uint32_t count) { return make_flow(curve_count(count, kUsualFlowLines)); }, false},
};

constexpr struct {
    const char* name;
    Mesh (*make)(uint32_t count);
} kMeshMakers[] = {
    {"figure", [](uint32_t) { return make_figure(); }},
    {"scalp", [](uint32_t) { return make_scalp(); }},
    {"vase", [](uint32_t count) { return count == 0 ? make_vase() : make_vase(std::clamp(count, 3u, kMaxCurves)); }},
    {"dish", [](uint32_t) { return make_dish(); }},
    {"ball", [](uint32_t) { return make_ball_mesh(); }},
    {"egg", [](uint32_t) { return make_egg(); }},
    {"cloth", [](uint32_t) { return make_cloth(); }},
    {"torus", [](uint32_t) { return make_torus(); }},
};

template <class Makers>
std::vector<std::string> names_of(const Makers& makers) {
    std::vector<std::string> list;
    for (const auto& maker : makers) list.emplace_back(maker.name);
    return list;
}

}  // namespace

const std::vector<std::string>& scene_names() {
    static const std::vector<std::string> names = names_of(kMakers);
    return names;
}

const std::vector<std::string>& mesh_names() {
    static const std::vector<std::string> names = names_of(kMeshMakers);
    return names;
}

Mesh make_mesh(std::string_view name, uint32_t count) {
    for (const auto& maker : kMeshMakers) {
        if (name == maker.name) return maker.make(count);
    }
    return {};
}

Scene make_scene(std::string_view name, uint32_t count) {
    for (const Maker& maker : kMakers) {
        if (name == maker.name) return {maker.make(count), maker.network};
    }
    if (name == "head") return {{make_head()}};
    if (name == "flow_ball") return {{make_ball()}};
    return {};
}

}  // namespace flg::scenes
