/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Rigs that engines know: the limbs of a skeleton, names of humanoid standards, a T-pose, joint limits and capsules for
 * ragdolls, test motions. Follows the grammar of filigree.h. Metres, radians.
 *
 * [any thread] All functions here: they need no context and keep no state. They check their input before they write
 * anything: on failure arrays stay unchanged. They take joints as FlgModelView, FlgSkinView and files have them.
 */
#ifndef FILIGREE_FILIGREE_RIG_H
#define FILIGREE_FILIGREE_RIG_H

#include "filigree_model.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Maximum joints of a rig. */
#define FLG_RIG_MAX_JOINTS 1024u

/* What a joint belongs to. */
typedef enum FlgLimb {
    FLG_LIMB_TRUNK = 0, /* the root, and what legs, arms and the head hang on */
    FLG_LIMB_NECK = 1,
    FLG_LIMB_HEAD = 2,
    FLG_LIMB_ARM = 3,   /* a pair of limbs that do not reach the ground: wings and claws too */
    FLG_LIMB_LEG = 4,
    FLG_LIMB_TAIL = 5,
    FLG_LIMB_OTHER = 6, /* ears, fingers, horns: what hangs on a limb or the trunk and is none of these */
    FLG_LIMB_FORCE_32BIT = 0x7fffffff
} FlgLimb;

/* Where an arm or a leg bends. */
typedef enum FlgLimbPlace {
    FLG_LIMB_PLACE_NONE = 0,   /* any other joint */
    FLG_LIMB_PLACE_UPPER = 1,  /* shoulder or hip */
    FLG_LIMB_PLACE_MIDDLE = 2, /* elbow or knee, a hinge; limbs of two joints have none */
    FLG_LIMB_PLACE_END = 3,    /* hand or foot */
    FLG_LIMB_PLACE_FORCE_32BIT = 0x7fffffff
} FlgLimbPlace;

/* A joint's place in the rig, the bone that turns with it, and how far it may turn. */
typedef struct FlgRigJoint {
    FlgLimb limb;
    FlgLimbPlace place;
    int32_t side;          /* 1: left, -1: right, 0: the middle, or not known */
    uint32_t pair;         /* of legs: 0 is the pair in front; without sides each leg is a pair. Else 0 */
    uint32_t index;        /* along the limb, 0 where it begins at the trunk. Of the trunk: from the root */
    uint32_t next;         /* the joint at the other end of its bone, where the limb goes on; FLG_NO_INDEX: a tip */
    /* A capsule around the bone, within the hull of the balls at both ends. Its radius is the smaller ball's, but at
     * least half the larger one's: then it ends where the body is as thin. */
    float capsule_start[3]; /* metres, as the joint's position at rest */
    float capsule_end[3];   /* metres, likewise */
    float capsule_radius;   /* metres; 0: a tip has no bone */
    /* A rotation is within the limits if it is a twist about `limit_axis`, then a swing of the axis. A hinge twists
     * about its own axis and does not swing; others twist about their bone. At rest a joint is not turned. */
    float limit_axis[3];    /* of length 1, in the model's space */
    float limit_swing;      /* radians, 0 to pi */
    float limit_twist_min;  /* radians, -pi to 0 */
    float limit_twist_max;  /* radians, 0 to pi */
} FlgRigJoint;

typedef struct FlgRigFindDesc {
    uint32_t struct_size;
    uint32_t joint_count;          /* 1 to FLG_RIG_MAX_JOINTS */
    const float* joint_positions;  /* 3 per joint, metres */
    const float* joint_radii;      /* one per joint: radius of the shape around it, metres, 0 or above */
    const uint32_t* joint_parents; /* one per joint, lower than its own index; FLG_NO_INDEX: a root */
    float up[3];                   /* of any length above 0. Default 0 1 0 */
    float left[3]; /* to the model's left, as FlgModelDesc::mirror; it looks along left x up. 0 0 0: to be found. Then
                      the model faces +z if its limbs are mirror images, and else is drawn from the side and looks
                      where its head is. Default 0 0 0 */
} FlgRigFindDesc;

FLG_API FlgResult flgRigFindDescInit(FlgRigFindDesc* desc, uint32_t struct_size);

/* What the other functions take. Refers to the host's arrays, which must live as long. */
typedef struct FlgRig {
    uint32_t struct_size;
    uint32_t joint_count;
    const float* joint_positions;  /* the descriptor's */
    const uint32_t* joint_parents; /* the descriptor's */
    const FlgRigJoint* joints;     /* one per joint */
    float up[3];                   /* up, left and forward are at right angles, of length 1 */
    float left[3];                 /* to the model's left */
    float forward[3];              /* where it looks */
    float ground;                  /* metres along `up`: where the shape ends below */
    uint32_t leg_count;
    uint32_t arm_count;            /* 0 or 2 */
} FlgRig;

FLG_API FlgResult flgRigInit(FlgRig* rig, uint32_t struct_size);

/* Finds limbs, capsules and limits of a skeleton. Of several trees it looks at the largest; the others are
 * FLG_LIMB_OTHER.
 *   out_joints  one per joint
 *   out_rig     refers to out_joints and the descriptor's arrays
 * Legs reach down to the ground and lie beside the middle; seen from the side, they hang. Arms are the longest pair of
 * mirrored limbs that is left, near the trunk; the head is the thickest and highest limb in the middle, the tail the
 * longest of the others. Cost: 0.2 us a joint and 20 ns for two tips: 5 ms at most, for 1024 joints of which half are
 * tips. Takes no memory for up to 64 joints, else up to 500 bytes a joint of the C++ runtime's. */
FLG_API FlgResult flgRigFind(const FlgRigFindDesc* desc, FlgRigJoint* out_joints, FlgRig* out_rig);

/* Who names the bones of a humanoid. */
typedef enum FlgRigStandard {
    FLG_RIG_STANDARD_VRM = 0,    /* VRM 1.0: hips, spine, leftUpperArm, ... */
    FLG_RIG_STANDARD_UNITY = 1,  /* Unity's HumanBodyBones: Hips, Spine, LeftUpperArm, ... */
    FLG_RIG_STANDARD_UNREAL = 2, /* Unreal Engine's mannequin: pelvis, spine_01, upperarm_l, ... */
    FLG_RIG_STANDARD_FORCE_32BIT = 0x7fffffff
} FlgRigStandard;

/* The bones of a humanoid, by the names of a standard.
 *   out_names  one per joint: a name that lives as long as the library; null: the joint is none of the standard's
 * Needs two arms and two legs of at least three joints each, a head, and a joint of the spine between hips and arms.
 * FLG_ERROR_INVALID_ARGUMENT if one is missing; the message says "no humanoid" and which. Cost: 0.1 us a joint. */
FLG_API FlgResult flgRigGetNames(const FlgRig* rig, FlgRigStandard standard, const char** out_names);

/* The rotations that bring a humanoid from rest to a T-pose: each arm straight and level to its side, turned the
 * shortest way, so that palms which face the body at rest face down. Legs stay. Take them for flgSkinPose: a skin that
 * is deformed so, with its joints where they are then, is at rest in the T-pose.
 *   out_rotations  4 per joint, as FlgSkinAnimation
 * FLG_ERROR_INVALID_ARGUMENT without two arms. Cost: 0.1 us a joint. */
FLG_API FlgResult flgRigGetTPose(const FlgRig* rig, float* out_rotations);

/* Motions that show whether a model moves well. */
typedef enum FlgRigMotion {
    FLG_RIG_MOTION_WALK = 0, /* on the spot, with all legs: two in turn, four one after the other, more in two sets.
                                1.2 s a cycle look natural */
    FLG_RIG_MOTION_IDLE = 1, /* breathes and looks about, on standing feet. 4 s */
    FLG_RIG_MOTION_WAVE = 2, /* the right arm, or else the right front leg, is lifted, waves and comes back. 3 s */
    FLG_RIG_MOTION_FORCE_32BIT = 0x7fffffff
} FlgRigMotion;

/* The pose of a motion. Arms of those who stand on two legs hang down in all of them, however they are at rest. Motions
 * repeat without a seam: phase 1 is phase 0. All rotations are within the limits.
 *   phase            share of the cycle, finite
 *   out_rotations    4 per joint, as FlgSkinAnimation
 *   out_translation  3: of all roots, metres
 *   out_travel       3, or null: how far the model walks in a cycle, metres: move it so, and standing feet stay
 * Standing feet slide by less than 0.0001 of the way of a cycle, if legs reach as far. FLG_ERROR_INVALID_ARGUMENT if
 * the rig has no limbs for the motion; the message names them. Cost: 0.3 us a joint; takes no memory. */
FLG_API FlgResult flgRigMotionSample(const FlgRig* rig, FlgRigMotion motion, float phase, float* out_rotations,
                                     float* out_translation, float* out_travel);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgRigFindDesc flgRigFindDefaults(void) {
    FlgRigFindDesc desc;
    flgRigFindDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgRig flgRigDefaults(void) {
    FlgRig rig;
    flgRigInit(&rig, (uint32_t)sizeof rig);
    return rig;
}

#ifdef __cplusplus
}
#endif

#endif
