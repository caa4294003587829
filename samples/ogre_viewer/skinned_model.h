// SPDX-License-Identifier: MIT
// A drawn model as an Ogre::Mesh with its Ogre::Skeleton: contours to parts to bones to skin, by jobs that follow each
// other without the host; then bones, weights and an animation in OGRE's own terms.
#pragma once

#include <OgreAnimationState.h>
#include <OgreMesh.h>
#include <OgreSceneNode.h>
#include <OgreSkeleton.h>

#include <vector>

#include "drawing.h"
#include "filigree/filigree.hpp"

namespace viewer {

class SkinnedModel {
public:
    // `material` takes its colour from the vertices. The entity appears under the node once its jobs are done.
    SkinnedModel(filigree::Context& context, const Drawing& drawing, Ogre::SceneNode& node,
                 const Ogre::MaterialPtr& material);

    void update(float time);  // once a frame, after the tick: the animation's time, seconds
    bool ready() const { return animation_ != nullptr; }

private:
    void build();

    Ogre::SceneNode& node_;
    Ogre::MaterialPtr material_;
    std::vector<Ogre::ColourValue> colours_;  // of the drawing's parts
    filigree::Model model_;
    filigree::Skin skin_;
    Ogre::AnimationState* animation_ = nullptr;
};

}  // namespace viewer
