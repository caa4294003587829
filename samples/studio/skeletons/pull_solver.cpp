// SPDX-License-Identifier: MIT
#include "skeletons/pull_solver.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace flg::studio {
namespace {

constexpr int kMostFrames = 120;  // until it is as good as still
constexpr float kStill = 3e-4f;   // of the body's size: nothing moves more in a frame
constexpr float kAtRest = 1e-5f;  // likewise: pins that hold the body where it is

}  // namespace

void PullSolver::clear() {
    pull_.reset(), last_.reset(), coming_.reset();
    of_ = 0;
    failed_ = false;
    pins_.clear(), handles_.clear(), pose_.clear();
    lost_ = 0;
    to_settle_ = 0;
    if (!positions_.empty()) ++revision_;
    positions_.clear();
}

void PullSolver::begin(const FlgSkinView& skin) {
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, skin.positions, 0, 0}};
    FlgMeshView mesh = flgMeshViewDefaults();
    mesh.vertex_count = skin.vertex_count;
    mesh.triangle_count = skin.triangle_count;
    mesh.columns = columns;
    mesh.column_count = 1;
    mesh.triangles = skin.triangles;
    FlgPullDesc desc = flgPullDefaults();
    desc.weld_distance = -1.0f;
    desc.mesh = &mesh;
    FlgPull handle{};
    FlgJob job{};
    if (flgPullCreate(context_.get(), &desc, &handle, &job) != FLG_OK) {
        failed_ = true;
        return notices_.add(Weight::error, std::string("The body cannot be pulled: ") + flgErrorGetMessage());
    }
    pull_ = PullOwner(context_.get(), handle);
    jobs_.add("Getting the body ready to be pulled", filigree::Job(context_.get(), job), {}, Jobs::Shown::quiet);
}

void PullSolver::take() {
    if (!coming_) return;
    FlgPulledView view = flgPulledViewDefaults();
    const FlgResult result = flgPulledGetView(context_.get(), coming_.get(), &view);
    if (result == FLG_NOT_READY) return;
    if (result != FLG_OK) {
        failed_ = true;
        notices_.add(Weight::error, std::string("The body cannot be pulled: ") + flgErrorGetMessage());
        return coming_.reset();
    }
    const size_t count = 3 * size_t{view.vertex_count};
    float moved = positions_.empty() ? size_ : 0.0f;
    for (size_t i = 0; i < positions_.size(); ++i) moved = std::max(moved, std::abs(view.positions[i] - positions_[i]));
    // What was asked before the last change says nothing about it.
    if (is_current_ && moved < kStill * size_) to_settle_ = 0;
    positions_.assign(view.positions, view.positions + count);
    last_ = std::move(coming_);
    coming_.reset();
    ++revision_;
}

void PullSolver::update(const LiveModel& live, const Drawing& drawing, std::span<const PullPin> pins,
                        std::vector<float> pose) {
    const LiveModel::Skinned* skin = live.skin();
    if (skin == nullptr || (of_ != 0 && of_ != live.shape_revision())) clear();
    if (skin == nullptr) return;
    const bool is_new = of_ != live.shape_revision();
    // The mesh is made ready before it is pulled for the first time, so that nothing is waited for then.
    if (is_new) begin(skin->view);
    of_ = live.shape_revision();
    size_ = skin->rig.size;
    if (failed_) return;
    take();
    if (is_new || !std::equal(pins.begin(), pins.end(), pins_.begin(), pins_.end())) {
        pins_.assign(pins.begin(), pins.end());
        handles_.clear();
        lost_ = 0;
        for (const PullPin& pin : pins_) {
            const auto found = find_place(drawing, *skin, pin.place);
            if (!found || handles_.size() == FLG_PULL_MAX_HANDLES) {
                ++lost_;
                continue;
            }
            FlgPullHandle& handle = handles_.emplace_back(flgPullHandleDefaults());
            std::fill_n(handle.vertices, 3, found->vertex);
            const glm::vec3 to = glm::make_vec3(skin->view.positions + 3 * size_t{found->vertex}) + pin.by;
            std::copy_n(&to.x, 3, handle.position);
        }
        // Back at once, where it would be a long way round by round.
        const bool is_at_rest = std::all_of(pins_.begin(), pins_.end(),
                                            [&](const PullPin& pin) { return glm::length(pin.by) < kAtRest * size_; });
        if (is_at_rest) restart();
        to_settle_ = kMostFrames;
        is_current_ = false;
    }
    if (pose != pose_) {
        pose_ = std::move(pose);
        to_settle_ = kMostFrames;
        is_current_ = false;
    }
    if (handles_.empty()) {
        restart();
        if (!positions_.empty()) ++revision_;
        positions_.clear();
        to_settle_ = 0;
    }
    if (coming_ || to_settle_ == 0) return;
    --to_settle_;
    FlgPulledDesc desc = flgPulledDefaults();
    FlgJobOptions urgent = flgJobOptionsDefaults();
    urgent.priority = FLG_PRIORITY_HIGH;
    desc.job = &urgent;
    desc.pull = pull_.get();
    desc.handles = handles_.data();
    desc.handle_count = static_cast<uint32_t>(handles_.size());
    desc.positions = pose_.empty() ? nullptr : pose_.data();
    if (last_) desc.previous = last_.get();
    FlgPulled handle{};
    if (flgPulledCreate(context_.get(), &desc, &handle, nullptr) != FLG_OK) {
        failed_ = true;
        return notices_.add(Weight::error, std::string("The body cannot be pulled: ") + flgErrorGetMessage());
    }
    coming_ = PulledOwner(context_.get(), handle);
    is_current_ = true;
}

bool PullSolver::busy() const {
    return !failed_ && (coming_ || to_settle_ > 0);
}

}  // namespace flg::studio
