// SPDX-License-Identifier: MIT
// Stylized curves: a bouquet by one job, and a stroke that is stylized while a hand draws it.
#pragma once

#include <OgreSceneNode.h>

#include <memory>
#include <vector>

#include "curve_object.h"
#include "filigree/filigree.hpp"
#include "support/live_sample.h"

namespace viewer {

// Stems of the built-in bouquet with the style of one example stroke. Appears once its job is done.
class Bouquet {
public:
    Bouquet(filigree::Context& context, Ogre::SceneNode& node, const Ogre::MaterialPtr& material);

    void update();  // once a frame, after the tick
    bool ready() const { return object_ != nullptr; }

private:
    Ogre::SceneNode& node_;
    Ogre::MaterialPtr material_;
    filigree::Style style_;
    filigree::CurveSet stems_, stylized_;
    std::unique_ptr<CurveObject> object_;
};

// A flourish, drawn again and again by a hand that moves at an even pace.
class LiveStroke {
public:
    LiveStroke(filigree::Context& context, Ogre::SceneNode& node, const Ogre::MaterialPtr& material);

    // Once a frame: the hand has moved on to where it is at that time, seconds since it was ready. The stroke grows.
    void update(double time);
    bool ready() const { return warming_.finished(); }

    uint32_t points() const { return object_.point_count(); }
    size_t largest_upload() const { return largest_upload_; }

private:
    void begin();

    filigree::Context& context_;
    filigree::Style style_;
    filigree::Job warming_;
    std::vector<flg::samples::LiveSample> hand_;
    double begun_ = 0;
    size_t taken_ = 0;  // samples of the hand
    filigree::LiveStroke stroke_;
    CurveObject object_;
    size_t largest_upload_ = 0;
};

}  // namespace viewer
