// SPDX-License-Identifier: MIT
#include "skeletons/weight_layer.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "skeletons/body_place.h"

namespace flg::studio {
namespace {

constexpr size_t kDabsPerFrame = 128;
constexpr double kLostReach = 4.0;  // radii from the surface: dabs further away were on something that is gone

}  // namespace

void WeightLayer::begin() {
    weights_.begin(editor_.live.automatic());
    of_ = editor_.live.shape_revision();
    painted_.clear(), lost_.clear();
    next_dab_ = 0;
    is_given_ = editor_.drawing().weight_strokes.empty() && !editor_.live.is_bound();
    ++revision_;
}

void WeightLayer::update(bool is_shown) {
    const std::vector<WeightStrokePtr>& strokes = editor_.drawing().weight_strokes;
    if (editor_.live.skin() == nullptr) of_ = 0;
    if (editor_.live.skin() == nullptr || editor_.live.busy() || editor_.is_acting()) return;
    if (!is_shown && strokes.empty() && !editor_.live.is_bound()) return;
    const bool goes_on = of_ == editor_.live.shape_revision() && painted_.size() <= strokes.size() &&
                         std::equal(painted_.begin(), painted_.end(), strokes.begin());
    if (!goes_on) begin();
    for (size_t left = kDabsPerFrame; left > 0 && painted_.size() < strokes.size();) {
        const WeightStrokePtr& stroke = strokes[painted_.size()];
        bool is_whole = lost_.empty() || lost_.back() != stroke;
        for (; left > 0 && next_dab_ < stroke->dabs.size(); --left)
            is_whole = paint_dab(*stroke, stroke->dabs[next_dab_++]) && is_whole;
        if (!is_whole && (lost_.empty() || lost_.back() != stroke)) lost_.push_back(stroke);
        is_given_ = false;
        if (next_dab_ < stroke->dabs.size()) return;
        painted_.push_back(stroke);
        next_dab_ = 0;
    }
    if (painted_.size() < strokes.size()) return;
    if (!is_given_) {
        if (strokes.empty())
            editor_.live.unbind();
        else
            editor_.live.bind(weights_.joints(), weights_.weights());
        is_given_ = true;
    }
    if (!lost_.empty() && !has_told_)
        editor_.app.notices.add(Weight::warning,
                                "Some painted weights have no joint or place on the body now. They are kept for when "
                                "they have one again.");
    has_told_ = !lost_.empty();
}

bool WeightLayer::busy() const {
    const bool is_painted = of_ == editor_.live.shape_revision() && painted_ == editor_.drawing().weight_strokes;
    const bool has_work = !editor_.drawing().weight_strokes.empty() || editor_.live.is_bound();
    return editor_.live.skin() != nullptr && has_work && !(is_painted && is_given_);
}

const PaintedWeights* WeightLayer::weights() const {
    const bool is_painted =
        of_ != 0 && of_ == editor_.live.shape_revision() && painted_.size() >= editor_.drawing().weight_strokes.size();
    return is_painted && editor_.live.skin() != nullptr ? &weights_ : nullptr;
}

bool WeightLayer::paint_dab(const WeightStroke& stroke, const WeightDab& dab) {
    const LiveModel::Skinned& skin = *editor_.live.skin();
    const auto& keys = skin.rig.keys;
    const auto joint = std::find(keys.begin(), keys.end(), dab.is_mirror ? stroke.mirror_joint : stroke.joint);
    if (joint == keys.end()) return false;
    const auto found = find_place(editor_.drawing(), skin, dab.place);
    if (!found) return false;
    const glm::dvec3 surface(glm::make_vec3(skin.view.positions + 3 * size_t{found->vertex}));
    const double radius = dab.radius * found->scale, away = glm::distance(surface, found->at);
    if (away > kLostReach * radius) return false;
    // The surface may be elsewhere by now, as of a thicker part.
    weights_.paint({.seed = found->vertex,
                    .at = glm::vec3(away > 0.5 * radius ? surface : found->at),
                    .radius = static_cast<float>(radius),
                    .brush = stroke.brush,
                    .strength = stroke.strength,
                    .joint = static_cast<uint16_t>(joint - keys.begin())});
    ++revision_;
    return true;
}

void WeightLayer::paint(const WeightStroke& stroke, const WeightDab& dab) {
    if (weights() != nullptr) paint_dab(stroke, dab);
}

void WeightLayer::keep(WeightStroke stroke) {
    auto kept = std::make_shared<const WeightStroke>(std::move(stroke));
    editor_.commit();
    editor_.change("weights").weight_strokes.push_back(kept);
    editor_.commit();
    if (of_ != 0) painted_.push_back(std::move(kept));
    is_given_ = false;
}

void WeightLayer::forget_lost() {
    editor_.commit();
    std::erase_if(editor_.change("weights").weight_strokes, [this](const WeightStrokePtr& stroke) {
        return std::find(lost_.begin(), lost_.end(), stroke) != lost_.end();
    });
    editor_.commit();
}

}  // namespace flg::studio
