// SPDX-License-Identifier: MIT
// Graphs of bones: split, contracted, connected (Fig. 9 of the paper) and refined.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bones/bone_graph.h"
#include "bones/connection.h"
#include "bones/refinement.h"
#include "runtime/run_now.h"

namespace flg::test {
namespace {

Memory* memory() {
    return std::pmr::new_delete_resource();
}

uint32_t joint_count(const BoneGraph& graph) {
    uint32_t count = 0;
    for (uint32_t j = 0; j < graph.joints().size(); ++j) count += graph.is_there(j);
    return count;
}

uint32_t bone_count(const BoneGraph& graph) {
    uint32_t count = 0;
    for (const BoneGraph::Bone& bone : graph.bones()) count += !bone.gone;
    return count;
}

// Degrees are what the lists hold, all reach each other, and there is one bone less than joints.
void expect_tree(const BoneGraph& graph) {
    EXPECT_EQ(bone_count(graph) + 1, joint_count(graph));
    uint32_t first = 0;
    for (uint32_t j = 0; j < graph.joints().size(); ++j) {
        if (!graph.is_there(j)) continue;
        first = j;
        uint32_t ends = 0;
        for (uint32_t end = graph.first_end(j); end != no_number; end = graph.next_end(end), ++ends) {
            const uint32_t bone = BoneGraph::bone_of(end);
            ASSERT_FALSE(graph.bones()[bone].gone);
            ASSERT_TRUE(graph.is_there(graph.other(bone, j)));
            ASSERT_TRUE(graph.bones()[bone].joints[0] == j || graph.bones()[bone].joints[1] == j);
        }
        EXPECT_EQ(ends, graph.joints()[j].degree);
    }
    const uint32_t root[] = {first};
    const OrderedBones ordered = run_haltingly(memory(), [&](Pace& pace) { return order_bones(pace, graph, root); });
    const BoneTree& tree = ordered.tree;
    EXPECT_EQ(tree.joints.size(), joint_count(graph));
    for (size_t j = 1; j < tree.joints.size(); ++j) EXPECT_LT(tree.joints[j].parent, j);
}

// With all other parts but its twin.
PartLink connected(BoneGraph& graph, const NewPart& part, uint32_t twin = no_number) {
    std::vector<uint8_t> may_meet;
    for (uint32_t p = 0; p < 4; ++p) may_meet.push_back(p != part.number && p != twin);
    return run_haltingly(memory(), [&](Pace& pace) { return connect_part(pace, graph, part, {may_meet}); });
}

// A horizontal torso of three bones from x = 0 to 9, two thick, of part 0.
BoneGraph torso() {
    BoneGraph graph(memory());
    for (int i = 0; i < 4; ++i) graph.add_joint({3.0 * i, 0, 0}, 2, 0);
    for (uint32_t i = 0; i < 3; ++i) graph.add_bone(i, i + 1, 0);
    return graph;
}

// A leg that hangs down from a place, never from a leg.
PartLink hang_leg(BoneGraph& graph, double x, double y, uint32_t part = 1) {
    constexpr double radius = 0.5;
    const auto first_joint = static_cast<uint32_t>(graph.joints().size());
    const uint32_t hip = graph.add_joint({x, y, 0}, radius, part), knee = graph.add_joint({x, y - 4, 0}, radius, part);
    graph.add_bone(hip, knee, part);
    return connected(graph, {part, first_joint, knee + 1, {}}, part == 1 ? no_number : part - 1);
}

TEST(Connection, BoneSplitEventBetweenTheBonesEnds) {
    BoneGraph graph = torso();
    const PartLink link = hang_leg(graph, 4, -1.5);
    EXPECT_EQ(link.event, PartLink::Event::bone_split);
    EXPECT_EQ(link.parent, 0u);
    EXPECT_EQ(graph.joints()[link.parent_joint].at, Vec3(4, 0, 0));
    EXPECT_EQ(graph.joints()[link.parent_joint].degree, 3u);
    EXPECT_EQ(graph.joints()[link.parent_joint].radius, 2);
    EXPECT_EQ(graph.joints()[link.joint].at, Vec3(4, -1.5, 0));
    EXPECT_EQ(joint_count(graph), 7u);
    expect_tree(graph);
}

TEST(Connection, JointConnectEventBeyondTheBonesEnds) {
    BoneGraph graph = torso();
    const PartLink link = hang_leg(graph, 10, -1);
    EXPECT_EQ(link.event, PartLink::Event::joint_connect);
    EXPECT_EQ(link.parent_joint, 3u);
    EXPECT_EQ(graph.joints()[3].degree, 2u);
    EXPECT_EQ(joint_count(graph), 6u);
    expect_tree(graph);
}

TEST(Connection, ExactlyAtAJointNoBoneOfNoLengthIsMade) {
    BoneGraph graph = torso();
    const PartLink link = hang_leg(graph, 3, -1);
    EXPECT_EQ(link.event, PartLink::Event::joint_connect);
    EXPECT_EQ(link.parent_joint, 1u);
    expect_tree(graph);
}

TEST(Connection, ThinPartsMeetByTheirBalls) {
    BoneGraph graph = torso();
    EXPECT_EQ(hang_leg(graph, 4, -2.7).event, PartLink::Event::bone_split);  // 2.7 from a bone of 2, by a ball of 0.5
    BoneGraph other = torso();
    const PartLink apart = hang_leg(other, 4, -2.8);
    EXPECT_EQ(apart.event, PartLink::Event::root);
    EXPECT_EQ(apart.parent, no_number);
    EXPECT_EQ(bone_count(other), 4u);
}

TEST(Connection, PartsMeetByTheirOutlines) {
    // A wing whose axis begins far out: only its edge is inside of the torso.
    for (const double edge : {1.9, 2.1}) {
        BoneGraph graph = torso();
        const uint32_t root = graph.add_joint({4, 5, 0}, 0.1, 1), tip = graph.add_joint({4, 9, 0}, 0.1, 1);
        graph.add_bone(root, tip, 1);
        const Vec3 outline[] = {{4, 9, 0}, {5, edge, 0}};
        const PartLink link = connected(graph, {1, 4, 6, outline});
        EXPECT_EQ(link.event, edge < 2 ? PartLink::Event::bone_split : PartLink::Event::root);
        EXPECT_EQ(link.joint, edge < 2 ? root : no_number);
        EXPECT_EQ(link.parent, edge < 2 ? 0 : no_number);
    }
}

TEST(Connection, TakesTheNearestOfSeveralParents) {
    BoneGraph graph = torso();
    // A second part that touches nothing, right where the third one is.
    const uint32_t a = graph.add_joint({4, -1.4, 0.5}, 0.4, 1), b = graph.add_joint({4, -1.4, 9}, 0.4, 1);
    graph.add_bone(a, b, 1);
    const auto first_joint = static_cast<uint32_t>(graph.joints().size());
    const uint32_t hip = graph.add_joint({4, -1.5, 0.6}, 0.2, 2);
    const PartLink link = connected(graph, {2, first_joint, hip + 1, {}});
    EXPECT_EQ(link.parent, 1u);
    EXPECT_EQ(link.joint, hip);
    // With that one for its twin it hangs on the torso.
    BoneGraph again = torso();
    again.add_bone(again.add_joint({4, -1.4, 0.5}, 0.4, 1), again.add_joint({4, -1.4, 9}, 0.4, 1), 1);
    again.add_joint({4, -1.5, 0.6}, 0.2, 2);
    const PartLink second = connected(again, {2, first_joint, first_joint + 1, {}}, 1);
    EXPECT_EQ(second.parent, 0u);
}

TEST(Connection, SameBitsWithPauses) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> at(-3, 12);
    for (int round = 0; round < 100; ++round) {
        BoneGraph whole = torso();
        hang_leg(whole, at(random), -1.5);
        const auto joint = static_cast<uint32_t>(whole.joints().size());
        const Vec3 hip(at(random), at(random) / 4, 0), outline[] = {hip, hip + Vec3(0, 2, 0)};
        whole.add_bone(whole.add_joint(hip, 0.3, 2), whole.add_joint(hip + Vec3(0, 4, 1), 0.2, 2), 2);
        BoneGraph paused = whole;
        const NewPart part{2, joint, joint + 2, outline};
        const PartLink expected = run_now(memory(), [&](Pace& pace) { return connect_part(pace, whole, part, {}); });
        const PartLink link = connected(paused, part);
        ASSERT_EQ(link.event, expected.event);
        ASSERT_EQ(link.joint, expected.joint);
        ASSERT_EQ(link.parent_joint, expected.parent_joint);
        ASSERT_EQ(joint_count(paused), joint_count(whole));
    }
}

TEST(Connection, APartOfOneJointCanBeHungOn) {
    BoneGraph graph(memory());
    graph.add_joint({0, 0, 0}, 2, 0);
    const PartLink link = hang_leg(graph, 0, -1);
    EXPECT_EQ(link.event, PartLink::Event::joint_connect);
    EXPECT_EQ(link.parent_joint, 0u);
    expect_tree(graph);
}

void refine(BoneGraph& graph, const RefinementThresholds& thresholds, uint32_t parts = 2, bool haltingly = false) {
    const std::vector<RefinementThresholds> all(parts + 1, thresholds);
    const auto make = [&](Pace& pace) { return flg::refine(pace, graph, all); };
    run_now(memory(), make, haltingly);
}

TEST(Refinement, JunctionsNearEachOtherBecomeOne) {
    // Fig. 11: two legs on a torso, a little apart.
    BoneGraph graph = torso();
    hang_leg(graph, 4, -1.5);
    hang_leg(graph, 4.3, -1.4, 2);
    ASSERT_EQ(joint_count(graph), 10u);
    refine(graph, {0.5, 0, 0}, 3);
    EXPECT_EQ(joint_count(graph), 9u);
    expect_tree(graph);
    uint32_t junctions = 0;
    for (uint32_t j = 0; j < graph.joints().size(); ++j)
        if (graph.is_there(j) && graph.joints()[j].degree == 4) ++junctions;
    EXPECT_EQ(junctions, 1u);
}

TEST(Refinement, SleevesBetweenMergedJunctionsGoToo) {
    BoneGraph graph = torso();
    hang_leg(graph, 2.9, -1.5);
    hang_leg(graph, 3.1, -1.5, 2);  // torso's joint at 3 is between them
    refine(graph, {0.5, 0, 0}, 3);
    EXPECT_EQ(joint_count(graph), 4u + 4u);  // 0, one for 2.9 to 3.1, 6, 9
    expect_tree(graph);
}

TEST(Refinement, ShortBranchesArePruned) {
    BoneGraph graph = torso();
    graph.add_bone(1, graph.add_joint({3, 0.4, 0}, 0.3, 0), 0);
    graph.add_bone(2, graph.add_joint({6, 1.5, 0}, 0.3, 0), 0);
    refine(graph, {0, 1, 0});
    EXPECT_EQ(joint_count(graph), 5u);
    EXPECT_TRUE(graph.is_there(5));
    EXPECT_FALSE(graph.is_there(4));
    EXPECT_EQ(graph.heir(4), 1u);
    expect_tree(graph);
}

// The outline of a limb that was scribbled: its axis has a twig at each of the outline's teeth.
TEST(Refinement, TwigsDoNotMakeALimbOneJoint) {
    constexpr uint32_t teeth = 40;
    constexpr double apart = 0.25;
    BoneGraph graph(memory());
    const auto along = [](uint32_t k) { return apart * k + (k == 0 ? -1 : k == teeth ? 1 : 0); };
    for (uint32_t k = 0; k <= teeth; ++k) {
        graph.add_joint({along(k), 0, 0}, 0.3, 0);
        if (k > 0) graph.add_bone(k - 1, k, 0);
    }
    for (uint32_t k = 1; k < teeth; ++k)
        graph.add_bone(k, graph.add_joint({apart * k, k % 2 == 0 ? 0.3 : -0.3, 0}, 0.1, 0), 0);
    refine(graph, {0.5, 0.5, 0});
    EXPECT_EQ(joint_count(graph), teeth + 1);
    for (uint32_t k = 0; k <= teeth; ++k) EXPECT_EQ(graph.joints()[k].at, Vec3(along(k), 0, 0));
    expect_tree(graph);
}

TEST(Refinement, ATreeWithoutJunctionsIsNeverPruned) {
    BoneGraph graph = torso();
    refine(graph, {100, 100, 0});
    EXPECT_EQ(joint_count(graph), 4u);
}

TEST(Refinement, InnerBonesCollapseAndEndsStay) {
    BoneGraph graph = torso();
    refine(graph, {0, 0, 100});
    EXPECT_EQ(joint_count(graph), 3u);  // the ends and one between them
    EXPECT_TRUE(graph.is_there(0) && graph.is_there(3));
    expect_tree(graph);
}

TEST(Refinement, JunctionsStayWhereTheyAreWhenSleevesCollapse) {
    BoneGraph graph = torso();
    const PartLink link = hang_leg(graph, 3.2, -1.5);
    refine(graph, {0, 0, 0.3});
    EXPECT_TRUE(graph.is_there(link.parent_joint));
    EXPECT_FALSE(graph.is_there(1));
    EXPECT_EQ(graph.joints()[link.parent_joint].at, Vec3(3.2, 0, 0));
    expect_tree(graph);
}

TEST(Refinement, PartsHaveThresholdsOfTheirOwn) {
    BoneGraph graph = torso();
    hang_leg(graph, 4, -1.5);
    const std::vector<RefinementThresholds> thresholds = {{0, 0, 0}, {0, 100, 0}, {0, 0, 0}};
    run_now(memory(), [&](Pace& pace) { return flg::refine(pace, graph, thresholds); });
    EXPECT_EQ(joint_count(graph), 7u) << "the leg's branch goes over to the torso: the model's threshold holds";
    BoneGraph again = torso();
    hang_leg(again, 4, -1.5);
    refine(again, {0, 100, 0});
    EXPECT_LT(joint_count(again), 7u);
}

// Three junctions in a palm, each within the next one's ball, with two fingers each.
TEST(Refinement, JunctionsWithinEachOthersBallsAreOneWhereManyLimbsLeave) {
    for (const uint32_t fingers : {1u, 2u}) {
        BoneGraph graph(memory());
        for (int i = 0; i < 3; ++i) graph.add_joint({1.5 * i, 0, 0}, 2, 0);
        for (uint32_t i = 0; i < 2; ++i) graph.add_bone(i, i + 1, 0);
        for (uint32_t i = 0; i < 3; ++i)
            for (uint32_t k = 0; k < (i == 1 ? 1 : fingers); ++k)
                graph.add_bone(i, graph.add_joint({1.5 * i, 8, 1.0 * k}, 0.5, 0), 0);
        RefinementThresholds thresholds{0.1, 0.1, 0};
        thresholds.hub = 1;
        const uint32_t before = joint_count(graph);
        refine(graph, thresholds, 1);
        EXPECT_EQ(joint_count(graph), fingers == 1 ? before : before - 2);
        expect_tree(graph);
    }
}

TEST(Refinement, WhatNowhereBulgesIsPruned) {
    // A ball with two stubs, a neck with a head that is wider than the ball.
    BoneGraph graph(memory());
    const uint32_t trunk = graph.add_joint({0, 0, 0}, 2, 0);
    graph.add_bone(trunk, graph.add_joint({1.8, 0, 0}, 0.5, 0), 0);
    graph.add_bone(trunk, graph.add_joint({-1.8, 0, 0}, 0.5, 0), 0);
    const uint32_t neck = graph.add_joint({0, 2.5, 0}, 0.5, 0), head = graph.add_joint({0, 6, 0}, 3, 0);
    graph.add_bone(trunk, neck, 0);
    graph.add_bone(neck, head, 0);
    graph.add_bone(trunk, graph.add_joint({0, -6, 0}, 1, 0), 0);
    RefinementThresholds thresholds{0.1, 0.1, 0};
    thresholds.bulge = 0.25;
    thresholds.widest_at = graph.joints()[head].at;
    thresholds.widest = graph.joints()[head].radius;
    refine(graph, thresholds, 1);
    EXPECT_EQ(joint_count(graph), 4u);
    EXPECT_TRUE(graph.is_there(head)) << "it is the widest itself";
    expect_tree(graph);
}

TEST(Refinement, OfRandomTreesLeavesATree) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(-1, 1), share(0, 0.6);
    for (int round = 0; round < 300; ++round) {
        BoneGraph graph(memory());
        const uint32_t n = 2 + random() % 60;
        graph.add_joint({at(random), at(random), at(random)}, 0.1, 0);
        for (uint32_t j = 1; j < n; ++j) {
            const uint32_t part = random() % 3;
            graph.add_joint({at(random), at(random), at(random)}, 0.1 + 0.1 * share(random), part);
            const uint32_t parent = random() % j;
            graph.add_bone(parent, j, graph.joints()[parent].part == part ? part : no_number);
        }
        BoneGraph paused = graph;
        const RefinementThresholds thresholds = {share(random), share(random), share(random)};
        refine(graph, thresholds, 3);
        expect_tree(graph);
        refine(paused, thresholds, 3, true);
        ASSERT_EQ(joint_count(paused), joint_count(graph));
        for (uint32_t j = 0; j < n; ++j) ASSERT_EQ(paused.heir(j), graph.heir(j));
        // Once more changes what pruning and collapsing have made new, and comes to an end.
        for (uint32_t before = joint_count(graph) + 1; joint_count(graph) < before;) {
            before = joint_count(graph);
            refine(graph, thresholds, 3);
            expect_tree(graph);
        }
        ASSERT_GE(joint_count(graph), 1u);
    }
}

}  // namespace
}  // namespace flg::test
