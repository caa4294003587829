// SPDX-License-Identifier: MIT
#include "splines/ornaments.h"

#include <algorithm>

#include "scenes/scenes.h"
#include "support/curve_source.h"

namespace flg::studio::splines {
namespace {

constexpr const char* kStyles[] = {
    "loops", "curls",  "braid",     "knots",  "wave",    "knit", "zigzag",   "tremor", "bubbles", "clouds", "fret",
    "grass", "hearts", "heartbeat", "leaves", "ripples", "rope", "rosettes", "script", "scrolls", "stars",  "thorns"};
constexpr uint32_t kMaxPoints = 2'000'000;
// Turns what was drawn above the curve to its side.
constexpr float kFlat[9] = {1.0f, 0.0f, 0.0f, 0.0f, 0.0f, -1.0f, 0.0f, 1.0f, 0.0f};

}  // namespace

std::span<const char* const> style_names() {
    return kStyles;
}

const filigree::Style* StyleCache::find(const std::string& name) {
    auto found = styles_.find(name);
    if (found == styles_.end()) {
        if (std::find(std::begin(kStyles), std::end(kStyles), name) == std::end(kStyles))
            throw StudioError("There is no style " + name + ".");
        const samples::CurveSource source("builtin:" + name);
        const filigree::CurveSet example = app_.context.curve_set(source.view());
        FlgStyleDesc desc = flgStyleDefaults();
        desc.style = example.get();
        filigree::Job job;
        found = styles_.emplace(name, app_.context.style(desc, &job)).first;
        app_.jobs.add("Learning style " + name, std::move(job), {}, Jobs::Shown::quiet);
    }
    return found->second.ready() ? &found->second : nullptr;
}

void Decorator::update(const FoundCurve& found, uint64_t version, const Ornament& ornament, float height,
                       const std::string& name) {
    if (ended_ && ended_->done) {
        if (ended_->good) {
            result_ = std::move(running_);
            ++version_;
        }
        running_.reset();
        ended_.reset();
    }
    if (!ornament.on || found.nodes.empty()) {
        wants_ = false;
        submitted_ = {};
        if (result_) result_.reset(), ++version_;
        return;
    }
    const Wanted wanted{version, ornament, height};
    wants_ = wanted != submitted_;
    if (!wants_ || ended_ || !found.final) return;
    const filigree::Style* const style = style_cache_.find(ornament.style);
    if (style == nullptr) return;
    submitted_ = wanted;
    wants_ = false;
    const NodeArrays nodes(found, height);
    const filigree::CurveSet target = app_.context.curve_set(nodes.view());
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = style->get();
    desc.target = target.get();
    desc.magnitude = ornament.magnitude;
    desc.scale = ornament.size / std::max(style->info().displacement_rms, 1e-9f);
    desc.frame = found.normals.empty() ? FLG_FRAME_METHOD_ROTATION_MINIMIZING : FLG_FRAME_METHOD_SUPPLIED;
    if (ornament.flat) std::copy(std::begin(kFlat), std::end(kFlat), desc.basis);
    desc.max_points = kMaxPoints;
    filigree::Job job;
    running_ = app_.context.stylize(desc, &job);
    ended_ = std::make_shared<Ended>();
    app_.jobs.add(
        "Stylizing " + name, std::move(job),
        [ended = std::weak_ptr(ended_)](const FlgJobStatus& status) {
            if (const auto mine = ended.lock()) mine->done = true, mine->good = status.result == FLG_OK;
        },
        Jobs::Shown::quiet);
}

NodeArrays::NodeArrays(const FoundCurve& found, float height)
    : positions_(found.nodes),
      normals_(found.normals),
      offsets_{0, static_cast<uint32_t>(found.nodes.size())},
      flags_{static_cast<uint8_t>(found.closed ? FLG_CURVE_CLOSED : 0)} {
    for (size_t i = 0; i < normals_.size(); ++i) positions_[i] += height * normals_[i];
    columns_[0] = {FLG_ATTRIBUTE_POSITION, 3, &positions_[0].x, 0, 0};
    columns_[1] = {FLG_ATTRIBUTE_NORMAL, 3, normals_.empty() ? nullptr : &normals_[0].x, 0, 0};
}

FlgCurveSetView NodeArrays::view() const {
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 1;
    view.curve_offsets = offsets_;
    view.curve_flags = flags_;
    view.columns = columns_;
    view.column_count = normals_.empty() ? 1 : 2;
    return view;
}

}  // namespace flg::studio::splines
