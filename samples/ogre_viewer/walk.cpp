// SPDX-License-Identifier: MIT
#include "walk.h"

#include <OgreAnimation.h>
#include <OgreAnimationTrack.h>
#include <OgreBone.h>
#include <OgreKeyFrame.h>

#include <cmath>

namespace viewer {
namespace {

constexpr float kSeconds = 1.2f;
constexpr int kKeys = 24;

// Which turns about an axis, how far, and when within the cycle. The animal looks along +x, its left is -z.
struct Swing {
    const char* bone;
    Ogre::Vector3 axis;
    float degrees, phase;
};

// Legs across from each other go together; knees bend while a foot is in the air.
const Swing kSwings[] = {
    {"front_leg_0.L", Ogre::Vector3::UNIT_Z, 20, 0.00f}, {"front_leg_1.L", Ogre::Vector3::UNIT_Z, 22, 0.78f},
    {"front_leg_0.R", Ogre::Vector3::UNIT_Z, 20, 0.50f}, {"front_leg_1.R", Ogre::Vector3::UNIT_Z, 22, 0.28f},
    {"hind_leg_0.L", Ogre::Vector3::UNIT_Z, 20, 0.50f},  {"hind_leg_1.L", Ogre::Vector3::UNIT_Z, 10, 0.30f},
    {"hind_leg_3.L", Ogre::Vector3::UNIT_Z, 16, 0.30f},  {"hind_leg_0.R", Ogre::Vector3::UNIT_Z, 20, 0.00f},
    {"hind_leg_1.R", Ogre::Vector3::UNIT_Z, 10, 0.80f},  {"hind_leg_3.R", Ogre::Vector3::UNIT_Z, 16, 0.80f},
    {"tail_0", Ogre::Vector3::UNIT_X, 12, 0.00f},        {"tail_1", Ogre::Vector3::UNIT_X, 14, 0.90f},
    {"tail_2", Ogre::Vector3::UNIT_X, 16, 0.80f},        {"tail_3", Ogre::Vector3::UNIT_X, 18, 0.70f},
    {"neck_0", Ogre::Vector3::UNIT_Z, 4, 0.25f},         {"head_0", Ogre::Vector3::UNIT_Y, 9, 0.10f},
};

}  // namespace

void add_walk(Ogre::Skeleton& skeleton) {
    Ogre::Animation* const walk = skeleton.createAnimation(kWalk, kSeconds);
    walk->setRotationInterpolationMode(Ogre::Animation::RIM_SPHERICAL);
    for (const Swing& swing : kSwings) {
        if (!skeleton.hasBone(swing.bone)) continue;
        Ogre::Bone* const bone = skeleton.getBone(swing.bone);
        Ogre::NodeAnimationTrack* const track = walk->createNodeTrack(bone->getHandle(), bone);
        for (int key = 0; key <= kKeys; ++key) {
            const float share = static_cast<float>(key) / kKeys;
            const float angle = swing.degrees * std::sin(Ogre::Math::TWO_PI * (share + swing.phase));
            track->createNodeKeyFrame(share * kSeconds)->setRotation({Ogre::Degree(angle), swing.axis});
        }
    }
}

}  // namespace viewer
