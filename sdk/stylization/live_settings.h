// SPDX-License-Identifier: MIT
// What a live stroke is drawn with.
#pragma once

#include <array>
#include <span>

#include "stylization/path_trees.h"
#include "stylization/steering.h"
#include "stylization/style.h"
#include "stylization/style_choice.h"

namespace flg {

struct LiveStyle {
    const PreparedStyle* style = nullptr;
    PathTrees* trees = nullptr;      // all there
    PathTrees* hot_trees = nullptr;  // likewise, of a driven temperature's other end
    double scale = 1;
    // If it is known: how many points of the style the stroke will have, the last of which are its end cap; and its
    // displacements, fitted.
    uint32_t point_count = 0;
    std::span<const Vec3> displacement{};

    double spacing() const { return style->spacing() * scale; }
};

struct LiveSettings {
    std::array<LiveStyle, styles_max> styles;  // as the host numbers them
    uint32_t style_count = 1;
    double style_blend = 0;  // metres; of several styles above 0
    StyleDrives drives{};
    double magnitude = 1;
    double min_radius = 0, max_radius = 0;                        // metres
    double smoothing = 0;                                         // seconds
    FlgFrameMethod frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING;  // or FLG_FRAME_METHOD_SUPPLIED
    std::array<double, 9> basis{1, 0, 0, 0, 1, 0, 0, 0, 1};       // row-major
    bool from_start = true;
    uint64_t seed = 1;
    uint32_t max_points = 0;
    bool end_cap = false;  // is wanted once the stroke has ended

    std::span<const LiveStyle> all() const { return {styles.data(), style_count}; }
    // Of the stroke's points: those of the style whose points are closest together.
    double spacing() const {
        double least = styles[0].spacing();
        for (const LiveStyle& style : all()) least = std::min(least, style.spacing());
        return least;
    }
};

}  // namespace flg
