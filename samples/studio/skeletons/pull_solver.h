// SPDX-License-Identifier: MIT
// The body as pins hold it, on top of its pose: jobs, one frame after another, each from the one before.
#pragma once

#include "filigree/filigree_pull.h"
#include "skeletons/body_place.h"

namespace flg::studio {

class PullSolver {
public:
    explicit PullSolver(filigree::Context& context, Jobs& jobs, Notices& notices)
        : context_(context), jobs_(jobs), notices_(notices) {}

    // Once a frame. `pose`: of the skin's vertices; empty: at rest.
    void update(const LiveModel& live, const Drawing& drawing, std::span<const PullPin> pins, std::vector<float> pose);
    void clear();
    // It begins at the pose again.
    void restart() { last_.reset(), coming_.reset(); }
    bool busy() const;

    // 3 per vertex; empty: nothing is pulled, the body is as its pose has it.
    std::span<const float> positions() const { return positions_; }
    uint64_t revision() const { return revision_; }
    // Pins whose part is not there.
    size_t lost_count() const { return lost_; }

private:
    using PullOwner = filigree::detail::Owner<FlgPull, flgPullRelease>;
    using PulledOwner = filigree::detail::Owner<FlgPulled, flgPulledRelease>;
    void begin(const FlgSkinView& skin);
    void take();

    filigree::Context& context_;
    Jobs& jobs_;
    Notices& notices_;
    PullOwner pull_;
    PulledOwner last_, coming_;
    bool is_current_ = false;  // the second: of the pins and the pose there are now
    uint64_t of_ = 0;          // the shape's revision
    bool failed_ = false;
    std::vector<PullPin> pins_;  // that `handles_` are of
    std::vector<FlgPullHandle> handles_;
    std::vector<float> pose_;
    size_t lost_ = 0;
    float size_ = 0.0f;  // of the body, metres
    int to_settle_ = 0;  // frames that are still made although nothing changes
    std::vector<float> positions_;
    uint64_t revision_ = 0;
};

}  // namespace flg::studio
