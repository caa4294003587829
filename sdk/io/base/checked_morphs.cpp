// SPDX-License-Identifier: MIT
#include "io/base/checked_morphs.h"

#include <algorithm>

#include "io/base/checks.h"
#include "io/base/entry_point.h"

namespace flg::io {

namespace {

constexpr uint32_t max_targets = 65535;

FlgMorphAnimation animation_defaults() {
    auto animation = sized<FlgMorphAnimation>();
    animation.animation = FLG_NO_INDEX;
    return animation;
}

}  // namespace

CheckedMorphs::CheckedMorphs(const FlgSkinFileWriteDesc& desc, std::span<const FlgSkinView> meshes)
    : count_(desc.morph_count), has_levels_(desc.level_morphs != nullptr) {
    if (desc.morph_count > max_targets)
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.morph_count", "is %u, must be at most %u", desc.morph_count,
             max_targets);
    if (desc.morph_count != 0) check_argument(desc.morphs, "desc.morphs");
    add_targets(desc.morphs, meshes[0].vertex_count, 0, "desc.morphs");
    for (size_t level = 1; has_levels_ && level < meshes.size(); ++level)
        add_targets(desc.level_morphs, meshes[level].vertex_count, static_cast<uint32_t>((level - 1) * count_),
                    "desc.level_morphs");
    if (desc.morph_animation_count == 0) return;
    check_argument(desc.morph_animations, "desc.morph_animations");
    if (targets_.empty())
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.morph_animation_count", "is %u, but there are no morphs",
             desc.morph_animation_count);
    for (uint32_t i = 0; i < desc.morph_animation_count; ++i) {
        const String place = element_of("desc.morph_animations", i);
        const auto read = read_element<Longer::cut>(desc.morph_animations, i, animation_defaults(), place.c_str());
        check_animation(read, desc.animation_count, place);
        const auto shares = [&](const FlgMorphAnimation& other) { return other.animation == read.animation; };
        if (read.animation != FLG_NO_INDEX && std::any_of(animations_.begin(), animations_.end(), shares))
            fail(FLG_ERROR_INVALID_ARGUMENT, place + ".animation", "is %u, as that of another", read.animation);
        animations_.push_back(read);
    }
}

void CheckedMorphs::add_targets(const FlgMorphTarget* from, size_t vertex_count, uint32_t first, const String& list) {
    for (uint32_t i = first; i < first + count_; ++i) {
        const String place = element_of(list, i);
        targets_.push_back(read_element<Longer::cut>(from, i, sized<FlgMorphTarget>(), place.c_str()));
        check_target(targets_.back(), vertex_count, place);
    }
}

void CheckedMorphs::check_target(const FlgMorphTarget& target, size_t vertex_count, const String& place) const {
    check_name(target.name, place + ".name");
    check_floats(target.moves, 3 * vertex_count, place + ".moves");
    if (target.normal_moves) check_floats(target.normal_moves, 3 * vertex_count, place + ".normal_moves");
}

void CheckedMorphs::check_animation(const FlgMorphAnimation& animation, uint32_t skin_animations,
                                    const String& place) const {
    check_name(animation.name, place + ".name");
    if (animation.key_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, place + ".key_count", "is 0, must be at least 1");
    check_times(animation.times, animation.key_count, place + ".times");
    check_floats(animation.weights, count_ * animation.key_count, place + ".weights");
    if (animation.animation != FLG_NO_INDEX && animation.animation >= skin_animations)
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".animation", "is %u, but there are %u animations",
             animation.animation, skin_animations);
}

}  // namespace flg::io
