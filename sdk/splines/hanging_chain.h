// SPDX-License-Identifier: MIT
// A chain of straight pieces that hangs between two places and rests on planes: its energy, and how it comes to rest.
//
// The potential energy is minimized with multipliers for lengths and contacts (augmented Lagrangian; Nocedal, Wright:
// Numerical Optimization, 2006, ch. 17) by Newton's method on a block tridiagonal system, without friction.
//
// Links of one length hold where a real cable would slide: to pass a fence's edge, a joint must first rise over it. So
// a chain may also slide through its joints: how much cable has passed each is one more unknown, and pieces are as long
// as that leaves them. A barrier keeps them from vanishing, and falls. At rest the tension less the height is then the
// same all along, as it is in a cable without friction.
#pragma once

#include "splines/cable_contacts.h"

namespace flg {

struct HangingChain {
    HangingChain(const ObstacleSet& solids, uint32_t count, double length_of_each, const Vec3& downwards,
                 Memory* memory);

    // Of a piece, over `length`.
    double share(const Buffer<double>& of, uint32_t piece) const { return 1 + (of[piece + 1] - of[piece]) / length; }
    // Metres. `places` and `tension` as they are.
    double greatest_tension() const;
    // Square metres: over the weight of a metre, from the height of the first place.
    double energy() const;
    // By how much the tension less the height differs along the chain: 0 where nothing could slide.
    double unevenness() const;

    uint32_t pieces;
    double length;  // of a piece, metres, if nothing slides
    Vec3 down;
    Buffer<Vec3> places, trial;
    Buffer<double> slid, slid_trial;  // metres of cable that passed each joint, towards the first end
    Buffer<Eigen::Vector4d> gradient;
    Buffer<Eigen::Matrix4d> diagonal, coupling;
    Buffer<double> tension;  // over the weight of a metre: metres
    CableContacts contacts;
    double stiffness = 0;  // metres a metre
    double damping = 0;
    double barrier = 0;  // metres: of pieces' lengths, where they slide
    bool slides = false;
    bool is_equal = false;  // pieces have their length; else at most that
    uint32_t rounds = 0;    // of Newton's method
};

struct ChainScale {
    double tension;  // that of the cable if it hung free, metres
    double rest;     // metres: so far above solids it is laid
    double slack;    // metres: so deep it may be beside its ends
};

// Whether it came to rest from where it is, and is free of all solids.
Task<bool> settle_chain(Pace& pace, HangingChain& chain, ChainScale scale);

// Whether the chain, at rest, would fall to either side: as a whole, or a piece that lies on an edge, bent at both its
// joints. Then it is pushed to one side, by half a piece.
Task<bool> push_from_saddle(Pace& pace, HangingChain& chain);

}  // namespace flg
