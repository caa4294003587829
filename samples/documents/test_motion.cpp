// SPDX-License-Identifier: MIT
#include "documents/test_motion.h"

#include <cmath>

namespace flg::cli {
namespace {

constexpr uint32_t key_count = 25;
constexpr float seconds = 2;
constexpr double swing = 0.16;    // radians, of each joint against the one before it
constexpr double later_by = 0.5;  // radians of the cycle, from joint to joint

}  // namespace

FlgSkinAnimation TestMotion::animation() const {
    FlgSkinAnimation out = flgSkinAnimationDefaults();
    out.name = name;
    out.key_count = static_cast<uint32_t>(times.size());
    out.times = times.data();
    out.rotations = rotations.data();
    if (!translations.empty()) out.translations = translations.data();
    return out;
}

TestMotion make_test_motion(const FlgModelView& model, const ModelDrawing& drawing) {
    const double turn = 2 * std::acos(-1.0);
    TestMotion motion;
    std::vector<uint32_t> depth(model.joint_count, 0);
    for (uint32_t j = 0; j < model.joint_count; ++j)
        if (model.joint_parents[j] != FLG_NO_INDEX) depth[j] = depth[model.joint_parents[j]] + 1;
    for (uint32_t key = 0; key < key_count; ++key) {
        const double share = static_cast<double>(key) / (key_count - 1);
        motion.times.push_back(static_cast<float>(share) * seconds);
        for (uint32_t j = 0; j < model.joint_count; ++j) {
            const uint32_t part = model.joint_parts[j];
            const std::array<double, 12>& placement = drawing.parts[model.part_sources[part]].placement;
            const double phase = turn * share - later_by * depth[j] + (model.part_mirrored[part] ? turn / 2 : 0);
            // The root stays, so that the model does.
            const double angle = depth[j] == 0 ? 0 : swing * std::sin(phase);
            const double scale = std::hypot(placement[2], placement[6], placement[10]);
            for (const size_t k : {2u, 6u, 10u})
                motion.rotations.push_back(static_cast<float>(std::sin(angle / 2) * placement[k] / scale));
            motion.rotations.push_back(static_cast<float>(std::cos(angle / 2)));
        }
    }
    return motion;
}

}  // namespace flg::cli
