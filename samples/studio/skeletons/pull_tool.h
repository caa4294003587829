// SPDX-License-Identifier: MIT
// Drags any point of the body; where it is let go of it stays, as a pin. A click sets a pin, or takes one away. While
// it records, keys are taken from each drag, one drag after the other.
#pragma once

#include <optional>

#include "skeletons/part_picking.h"
#include "skeletons/pull_solver.h"

struct ImDrawList;

namespace flg::studio {

class PullTool {
public:
    explicit PullTool(Editor& editor)
        : editor_(editor), solver_(editor.app.context, editor.app.jobs, editor.app.notices) {}

    // Once a frame, while the body is seen pulled. `posed`: its vertices as its bones have them; empty: at rest.
    void update(std::vector<float> posed);
    void pointer(const Pointer& mouse);
    void overlay(ImDrawList& list) const;
    void drop() { dragged_.reset(), taken_.reset(); }
    void leave();
    bool is_dragging() const { return dragged_.has_value(); }

    bool records = false;
    void play(bool on);
    bool is_playing() const { return plays_; }
    void release_all();
    void forget_record();

    const PullSolver& solver() const { return solver_; }
    bool busy() const { return solver_.busy() || plays_; }
    // Of what is shown: the pins, or those of the record.
    const std::vector<PullPin>& shown_pins() const { return shown_; }

private:
    std::span<const float> positions() const;
    std::optional<size_t> pin_at(glm::vec2 px) const;
    void press(const Pointer& mouse);
    void drag(const Pointer& mouse);
    void release();

    Editor& editor_;
    PullSolver solver_;
    std::vector<float> posed_;
    std::vector<PullPin> shown_;
    std::optional<size_t> hovered_, dragged_;  // pins
    bool is_new_ = false, is_moved_ = false;
    glm::vec2 grab_px_{0.0f};
    glm::vec3 grab_at_{0.0f}, grab_by_{0.0f};
    // The record with the drag that is under way.
    std::optional<PullRecord> taken_;
    float taken_from_ = 0.0f;
    double grab_seconds_ = 0.0, last_key_ = 0.0;
    bool plays_ = false;
    double play_from_ = 0.0;
};

}  // namespace flg::studio
