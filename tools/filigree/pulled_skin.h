// SPDX-License-Identifier: MIT
// A skin pulled over time, as a script says: frame by frame, each from the one before; and as morph targets, one for
// each frame that is needed so that shapes between two of them are near enough to what was pulled. Its levels of detail
// move as it does where they are nearest to it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "documents/pull_script.h"
#include "documents/session.h"
#include "filigree/filigree_io.h"
#include "filigree/filigree_pull.h"

namespace flg::cli {

class PulledSkin {
public:
    // `animations`: of the skin, of which the script may name one. `skin` and they outlive this. Throws InputError.
    PulledSkin(Session& session, const PullScript& script, const FlgSkinView& skin,
               const std::vector<FlgSkinAnimation>& animations, Report& report);
    PulledSkin(const PulledSkin&) = delete;
    PulledSkin& operator=(const PulledSkin&) = delete;

    std::vector<FlgMorphTarget> targets() const;
    // The same shapes of levels of detail, one level after the other. They live until it is called again.
    std::vector<FlgMorphTarget> targets_of(const std::vector<FlgSkinView>& levels);
    // Of the script's name. Belongs to the animation `index` if the script names a motion.
    FlgMorphAnimation animation(uint32_t index) const;
    // The bones' motion meanwhile, frame by frame; null: they rest.
    const FlgSkinAnimation* bones() const { return motion_.rotations.empty() ? nullptr : &bones_; }
    // Where vertices are at the frame nearest to a time, relative to the skin's origin. Throws InputError about
    // `--pulled-at` where there is none.
    std::vector<float> positions_at(double time) const;

private:
    struct Point {
        std::array<uint32_t, 3> vertices;
        std::array<float, 3> shares;
    };
    struct Motion {
        std::vector<float> times, rotations, translations;
    };

    // In one of these triangles.
    Point nearest_point(const std::array<double, 3>& at, std::span<const uint32_t> triangles,
                        double* distance = nullptr) const;
    void find_points();
    void find_motion(const std::vector<FlgSkinAnimation>& animations);
    void pull(Session& session, Report& report);
    std::vector<float> matrices_at(size_t frame) const;
    void move_to_rest(size_t frame, const float* positions);
    void choose_targets();
    double error_between(size_t from, size_t to, size_t frame) const;
    void describe(Report& report) const;

    const PullScript& script_;
    const FlgSkinView& skin_;
    double size_ = 0;
    std::vector<Point> points_;
    std::vector<double> times_;
    Motion motion_;
    FlgSkinAnimation bones_ = flgSkinAnimationDefaults();
    std::vector<std::vector<float>> moves_;        // by frame, 3 a vertex: before bones move it
    std::vector<size_t> keys_;                     // frames
    std::vector<uint32_t> target_of_key_;          // FLG_NO_INDEX: at rest
    std::vector<size_t> targets_;                  // the frames that they are
    std::vector<std::vector<float>> level_moves_;  // level by level, by target
    std::vector<std::string> names_;
    std::vector<float> key_times_, weights_;
    double largest_error_ = 0, error_time_ = 0;
};

}  // namespace flg::cli
