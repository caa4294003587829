// SPDX-License-Identifier: MIT
// What `filigree info` says of a skin.
#include <algorithm>
#include <iostream>

#include "info.h"

namespace flg::cli {
namespace {

constexpr uint32_t kMaxNames = 12;  // printed; the report has all

// How many vertices have 1, 2, 3 and 4 joints.
std::vector<uint64_t> count_influences(const FlgSkinView& view) {
    std::vector<uint64_t> counts(4, 0);
    for (size_t v = 0; v < view.vertex_count; ++v) {
        const float* weights = view.vertex_weights + 4 * v;
        const auto used = std::count_if(weights, weights + 4, [](float w) { return w > 0.0f; });
        ++counts[static_cast<size_t>(std::max<std::ptrdiff_t>(used, 1)) - 1];
    }
    return counts;
}

}  // namespace

void describe_skin(const SkinFile& skin, Report& report) {
    const FlgSkinView& view = skin.view();
    const auto roots =
        static_cast<uint64_t>(std::count(view.joint_parents, view.joint_parents + view.joint_count, FLG_NO_INDEX));
    const std::vector<uint64_t> influences = count_influences(view);
    nlohmann::ordered_json names = nlohmann::ordered_json::array(), animations = nlohmann::ordered_json::array(),
                           shapes = nlohmann::ordered_json::array();
    std::cout << "skin: " << view.joint_count << " joints (" << roots << " without a parent), "
              << view.joint_count - roots << " bones, " << skin.info().part_count
              << " parts; vertices of 1 to 4 joints: " << influences[0] << " " << influences[1] << " " << influences[2]
              << " " << influences[3] << "\njoints:";
    for (uint32_t j = 0; j < view.joint_count; ++j) {
        if (j < kMaxNames) std::cout << (j == 0 ? " " : ", ") << view.joint_names[j];
        names.push_back(view.joint_names[j]);
    }
    std::cout << (view.joint_count > kMaxNames ? ", ...\n" : "\n");
    for (const FlgSkinAnimation& animation : skin.animations()) {
        const float start = animation.times[0], end = animation.times[animation.key_count - 1];
        std::cout << "animation: " << animation.name << ", " << animation.key_count << " keys, " << start << " to "
                  << end << " s" << (animation.translations != nullptr ? ", moves the roots" : "") << "\n";
        animations.push_back({{"name", animation.name}, {"keys", animation.key_count}, {"start", start}, {"end", end}});
    }
    for (const FlgMorphAnimation& animation : skin.morph_animations()) {
        const float start = animation.times[0], end = animation.times[animation.key_count - 1];
        std::cout << "shapes: " << animation.name << ", " << animation.key_count << " keys of "
                  << skin.info().morph_count << " morph targets, " << start << " to " << end << " s\n";
        shapes.push_back({{"name", animation.name}, {"keys", animation.key_count}, {"start", start}, {"end", end}});
    }
    if (skin.info().texture_count > 0) std::cout << "textures: " << skin.info().texture_count << "\n";
    for (uint32_t i = 0; i < skin.info().warning_count; ++i) {
        std::cout << "odd: " << skin.info().warnings[i] << "\n";
        report.note(skin.name() + ": " + skin.info().warnings[i]);
    }
    report.parameters["joints"] = names;
    report.parameters["animations"] = animations;
    if (!shapes.empty()) report.parameters["shapes"] = shapes;
    report.counts["joints"] = view.joint_count;
    report.counts["root_joints"] = roots;
    report.counts["parts"] = skin.info().part_count;
    report.counts["joints_of_vertices"] = influences;
    if (skin.info().morph_count > 0) report.counts["morph_targets"] = skin.info().morph_count;
    if (skin.info().texture_count > 0) report.counts["textures"] = skin.info().texture_count;
}

}  // namespace flg::cli
