// SPDX-License-Identifier: MIT
// Joints of two drawings of one part that are the same: limbs turned, drawn with more joints, or not there.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "bones/joint_matching.h"
#include "runtime/run_now.h"

namespace flg::test {
namespace {

using Tree = std::vector<DrawnJoint>;

std::vector<uint32_t> matched(const Tree& now, const Tree& then, double near, bool haltingly = true) {
    const Buffer<uint32_t> same = run_now(
        std::pmr::new_delete_resource(), [&](Pace& pace) { return match_joints(pace, now, then, near); }, haltingly);
    return {same.begin(), same.end()};
}

// A palm with a wrist and five fingers of three joints; all fingers turned about the palm.
Tree hand(double turn, uint32_t joints_a_finger = 3) {
    Tree hand = {{{0, 0}, no_joint_before}, {{0, -1}, 0}, {{0, -2.5}, 1}};
    for (int finger = 0; finger < 5; ++finger) {
        const double angle = M_PI / 2 + 0.4 * (finger - 2) + turn;
        uint32_t before = 0;
        for (uint32_t k = 0; k < joints_a_finger; ++k) {
            const double radius = 1 + 1.4 * (k + 1) / joints_a_finger;
            hand.push_back({{radius * std::cos(angle), radius * std::sin(angle)}, before});
            before = static_cast<uint32_t>(hand.size()) - 1;
        }
    }
    return hand;
}

// Turned by nearly as much as there is between two fingers: each tip is nearest to where the next one was.
TEST(JointMatching, FingersThatTurnTogetherStayWhoTheyAre) {
    const Tree then = hand(0);
    for (const double turn : {-0.35, -0.3, -0.1, 0.1, 0.25, 0.35}) {
        const std::vector<uint32_t> same = matched(hand(turn), then, 0.5);
        for (uint32_t j = 0; j < same.size(); ++j) EXPECT_EQ(same[j], j) << turn;
    }
}

TEST(JointMatching, OneFingerThatIsGoneTakesNoOtherWithIt) {
    const Tree then = hand(0);
    for (uint32_t gone = 0; gone < 5; ++gone) {
        Tree now;
        std::vector<uint32_t> was;
        for (uint32_t j = 0; j < then.size(); ++j) {
            if (j >= 3 + 3 * gone && j < 6 + 3 * gone) continue;
            now.push_back(hand(0.1)[j]);
            if (now.back().before != no_joint_before && now.back().before >= 6 + 3 * gone) now.back().before -= 3;
            was.push_back(j);
        }
        EXPECT_EQ(matched(now, then, 0.3), was) << gone;
    }
}

// Along a limb with more joints than before, ends stay ends, and those between are by their share of the length.
TEST(JointMatching, MoreJointsALimbKeepItsEndsAndThoseAtTheirPlaces) {
    const Tree then = hand(0, 2), now = hand(0.3, 4);
    const std::vector<uint32_t> same = matched(now, then, 0.2);
    for (uint32_t finger = 0; finger < 5; ++finger) {
        EXPECT_EQ(same[3 + 4 * finger + 3], 3 + 2 * finger + 1);
        EXPECT_EQ(same[3 + 4 * finger + 1], 3 + 2 * finger);
        EXPECT_EQ(same[3 + 4 * finger + 0], no_joint_before);
        EXPECT_EQ(same[3 + 4 * finger + 2], no_joint_before);
    }
}

// An arm whose parts bend at shoulder and elbow, farther than joints are from each other.
TEST(JointMatching, AnArmThatBendsKeepsItsJoints) {
    const auto arm = [](double shoulder, double elbow) {
        Tree tree = {{{0, 0}, no_joint_before}, {{-1, 0}, 0}, {{-1, -3}, 1}};
        Point2 at{0, 0};
        double angle = shoulder;
        for (int k = 0; k < 4; ++k) {
            if (k == 2) angle += elbow;
            at = {at.x + std::cos(angle), at.y + std::sin(angle)};
            tree.push_back({at, k == 0 ? 0 : static_cast<uint32_t>(tree.size()) - 1});
        }
        return tree;
    };
    for (const double elbow : {-0.8, 0.5, 0.9}) {
        const std::vector<uint32_t> same = matched(arm(0.4, elbow), arm(0, 0), 0.4);
        for (uint32_t j = 0; j < same.size(); ++j) EXPECT_EQ(same[j], j) << elbow;
    }
}

// Both ways, in any pieces of work, wherever the drawing is.
TEST(JointMatching, IsTheSameBackwardsInPausesAndElsewhere) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> off(-0.15, 0.15);
    uint32_t matches = 0;
    for (int round = 0; round < 20; ++round) {
        Tree then = hand(0, 3), now = hand(0.2, round % 2 == 0 ? 3 : 4);
        for (DrawnJoint& joint : now) joint.at = {joint.at.x + off(random), joint.at.y + off(random)};
        const std::vector<uint32_t> same = matched(now, then, 0.4), back = matched(then, now, 0.4);
        EXPECT_EQ(same, matched(now, then, 0.4, false));
        for (uint32_t j = 0; j < same.size(); ++j) {
            if (same[j] == no_joint_before) continue;
            ++matches;
            EXPECT_EQ(back[same[j]], j) << round;
        }
        const std::vector<uint32_t> here = matched(now, then, 0.4);
        for (Tree* tree : {&now, &then})
            for (DrawnJoint& joint : *tree) joint.at = {-joint.at.y + 64, joint.at.x - 32};
        EXPECT_EQ(matched(now, then, 0.4), here) << round;
    }
    EXPECT_GT(matches, 20 * 14u);
}

TEST(JointMatching, NothingIsMatchedWithNothing) {
    EXPECT_TRUE(matched({}, hand(0), 1).empty());
    const std::vector<uint32_t> same = matched(hand(0), {}, 1);
    EXPECT_EQ(same, std::vector<uint32_t>(same.size(), no_joint_before));
}

}  // namespace
}  // namespace flg::test
