// SPDX-License-Identifier: MIT
#include <algorithm>

#include "scene_makers.h"

namespace flg::scenes {
namespace {

constexpr uint32_t kUsualHairs = 2000, kUsualFlowLines = 120, kMostCurves = 100'000;

uint32_t curve_count(uint32_t wanted, uint32_t usual) {
    return wanted == 0 ? usual : std::min(wanted, kMostCurves);
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

}  // namespace

const std::vector<std::string>& scene_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Maker& maker : kMakers) list.emplace_back(maker.name);
        return list;
    }();
    return names;
}

Scene make_scene(std::string_view name, uint32_t count) {
    for (const Maker& maker : kMakers) {
        if (name == maker.name) return {maker.make(count), maker.network};
    }
    return {};
}

}  // namespace flg::scenes
