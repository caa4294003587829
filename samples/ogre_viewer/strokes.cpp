// SPDX-License-Identifier: MIT
#include "strokes.h"

#include <algorithm>

#include "scene_curves.h"

namespace viewer {
namespace {

constexpr double kSampleRate = 90;  // hertz: a headset's
constexpr double kPause = 2;        // seconds, before the flourish is drawn again
constexpr uint32_t kHandSamples = 270;
constexpr uint32_t kMaxPoints = 1 << 15;

}  // namespace

Bouquet::Bouquet(filigree::Context& context, Ogre::SceneNode& node, const Ogre::MaterialPtr& material)
    : node_(node), material_(material) {
    // Nothing here waits: the second job gets what the first one makes.
    const filigree::CurveSet loops = curve_set(context, {flg::scenes::make_style("loops")});
    FlgStyleDesc style = flgStyleDefaults();
    style.style = loops.get();
    style.point_count = 256;  // as fine as it has to be from across a room
    style_ = context.style(style);
    stems_ = curve_set(context, flg::scenes::make_bouquet());
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = style_.get();
    desc.target = stems_.get();
    desc.scale = 0.2f;
    stylized_ = context.stylize(desc);
}

void Bouquet::update() {
    if (object_ || !stylized_.ready()) return;
    const FlgCurveSetView view = stylized_.view();
    CurveObject::Look look;
    look.radius_scale = 0.22f;
    object_ = std::make_unique<CurveObject>(view.curve_offsets[view.curve_count], view.curve_count, look, material_);
    object_->append(view);
    node_.attachObject(object_.get());
    stylized_.reset();  // the graphics card has it now
}

LiveStroke::LiveStroke(filigree::Context& context, Ogre::SceneNode& node, const Ogre::MaterialPtr& material)
    : context_(context), object_(kMaxPoints, 1, {0.006f, 1.0f, Ogre::ColourValue(0.02f, 0.22f, 0.55f)}, material) {
    node.attachObject(&object_);
    const filigree::CurveSet example = curve_set(context, {flg::scenes::make_style("curls")});
    style_ = context.style({example});
    warming_ = style_.warm();
    const flg::scenes::Curve flourish = flg::scenes::make_target("flourish", kHandSamples);
    for (const flg::scenes::Point& p : flourish.points) {
        flg::samples::LiveSample sample = {};
        sample.position[0] = p.x, sample.position[1] = p.y, sample.position[2] = p.z;
        sample.time = static_cast<double>(hand_.size()) / kSampleRate;
        hand_.push_back(sample);
    }
}

void LiveStroke::begin() {
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    desc.style = style_.get();
    desc.scale = 0.24f;
    desc.min_radius = 0.0045f;
    desc.max_points = kMaxPoints;
    stroke_ = context_.begin(desc);
    taken_ = 0;
    object_.clear();
}

void LiveStroke::update(double time) {
    if (!ready()) return;
    if (!stroke_ || time - begun_ > hand_.back().time + kPause) {
        if (stroke_) begun_ = time;
        begin();
    }
    size_t due = taken_;
    while (due < hand_.size() && hand_[due].time <= time - begun_) ++due;
    // What is new, and nothing else, goes to the graphics card.
    object_.append(stroke_.push(flg::samples::view_of({hand_.data() + taken_, due - taken_})), taken_ > 0);
    if (due > taken_) largest_upload_ = std::max(largest_upload_, object_.uploaded_bytes());
    taken_ = due;
}

}  // namespace viewer
