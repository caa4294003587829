// SPDX-License-Identifier: MIT
// The Skeletons workspace's lines, places and poses, without a window.
#include <gtest/gtest.h>

#include <numbers>

#include "shell/studio_error.h"
#include "skeletons/drawing_file.h"
#include "skeletons/history.h"
#include "skeletons/joint_edits.h"
#include "skeletons/rig.h"
#include "tools/program.h"

namespace flg::studio {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// A circle about (3, 1), as a hand draws it: from `from` to `to` of a turn.
std::vector<glm::dvec2> arc(double radius, double from, double to) {
    std::vector<glm::dvec2> path;
    for (int i = 0; i <= 200; ++i) {
        const double angle = kTurn * (from + (to - from) * i / 200.0);
        path.emplace_back(3.0 + radius * std::cos(angle), 1.0 + radius * std::sin(angle));
    }
    return path;
}

TEST(StudioContour, ClosesWhatAHandDrew) {
    // Closed, left open a little, and with ends that overshoot each other.
    std::vector<glm::dvec2> spiral = arc(1.0, 0.0, 1.05);
    for (size_t i = 0; i < spiral.size(); ++i) {
        const double share = static_cast<double>(i) / 200.0;
        spiral[i] = glm::dvec2(3.0, 1.0) + (spiral[i] - glm::dvec2(3.0, 1.0)) * (1.0 + 0.04 * (share - 0.5));
    }
    // Straight on at its end, across its beginning.
    spiral.back() += glm::dvec2(-0.3, 0.0);
    for (const auto& path : {arc(1.0, 0.0, 1.0), arc(1.0, 0.0, 0.97), spiral}) {
        const Ring ring = ring_of_path(path, 0.02);
        ASSERT_GE(ring.size(), 24u);
        EXPECT_NEAR(area_of(ring), 0.5 * kTurn, 0.1);
        EXPECT_NEAR(length_of(ring), kTurn, 0.2);
        EXPECT_LT(glm::distance(centre_of(ring), glm::dvec2(3.0, 1.0)), 0.05);
        EXPECT_TRUE(crossings_of({{ring}}, 16).empty());
        EXPECT_TRUE(is_inside(ring, {3.2, 0.6}));
        EXPECT_FALSE(is_inside(ring, {4.2, 1.0}));
        const double edge = length_of(ring) / static_cast<double>(ring.size());
        for (size_t i = 0; i < ring.size(); ++i)
            EXPECT_NEAR(glm::distance(ring[i], ring[(i + 1) % ring.size()]), edge, 0.5 * edge);
    }
}

TEST(StudioContour, TakesNoClickForALine) {
    EXPECT_TRUE(ring_of_path({}, 0.02).empty());
    EXPECT_TRUE(ring_of_path(std::vector<glm::dvec2>(50, {1.0, 1.0}), 0.02).empty());
    EXPECT_TRUE(ring_of_path(arc(0.02, 0.0, 1.0), 0.02).empty());
    // There and back on one line.
    std::vector<glm::dvec2> line;
    for (int i = 0; i <= 100; ++i) line.emplace_back(0.02 * (i < 50 ? i : 100 - i), 0.0);
    EXPECT_TRUE(ring_of_path(line, 0.02).empty());
}

TEST(StudioContour, SaysWhereALineCrossesItself) {
    const Contour bow{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}};
    const auto places = crossings_of(bow, 16);
    ASSERT_EQ(places.size(), 1u);
    EXPECT_LT(glm::distance(places[0], glm::dvec2(1.0, 1.0)), 1e-12);
    const Contour holed{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{3, 1}, {5, 2}, {3, 3}}}};
    EXPECT_EQ(crossings_of(holed, 16).size(), 2u);
    EXPECT_EQ(crossings_of(holed, 1).size(), 1u);
}

DrawnPart square(const char* name) {
    DrawnPart part;
    part.name = name;
    part.contour =
        std::make_shared<Contour>(Contour{{{{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {{1.5, 1.5}, {2.5, 1.5}, {2.0, 2.5}}}});
    return part;
}

TEST(StudioDrawing, PlacementsAreTakenApartAndPutTogether) {
    DrawnPart part = square("a");
    part.at = {0.3, -2.0, 0.7};
    part.turn = {20.0, -35.0, 110.0};
    part.scale = 1.7;
    DrawnPart again = square("b");
    set_placement(again, part.placement());
    for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(again.placement()[i], part.placement()[i], 1e-12);
    // Turned and scaled about its centre.
    const glm::dvec3 centre = part.centre();
    part.place({0.0, 80.0, 10.0}, 0.4);
    EXPECT_LT(glm::distance(part.centre(), centre), 1e-12);
    EXPECT_EQ(part.scale, 0.4);
}

TEST(StudioDrawing, ImagesAreAsFarBehindTheMirror) {
    const glm::vec4 plane(0.0f, 0.0f, -2.0f, 1.0f);  // z = -0.5
    EXPECT_LT(glm::distance(mirrored(plane, {1.0, 2.0, 3.0}), glm::dvec3(1.0, 2.0, -4.0)), 1e-12);
    Drawing drawing;
    drawing.parts.push_back(square("body"));
    // A limb beside the body does not reach the mirror, and goes into the body.
    const Ring limb = {{2.0, 0.0}, {2.3, 0.0}, {2.3, 1.6}, {2.0, 1.6}};
    const double depth = depth_beside(drawing, limb, 1.0f);
    EXPECT_GT(depth, radius_of(limb));
    EXPECT_LT(depth, radius_of(drawing.parts[0].contour->rings[0]));
}

TEST(StudioDrawing, DocumentsAndFilesKeepIt) {
    Drawing drawing;
    drawing.parts = {square("body"), square("leg")};
    // Numbers that floats hold: the command line's reader has no more.
    drawing.parts[1].at = {0.125, 0.25, 0.5};
    drawing.parts[1].turn = {0.0, 0.0, 90.0};
    drawing.parts[1].mirrored = true;
    drawing.parts[1].visible = false;
    drawing.parts[1].thresholds = FlgBoneThresholds{.struct_size = sizeof(FlgBoneThresholds),
                                                    .simplify = 0.01f,
                                                    .merge = 0.02f,
                                                    .prune = 0.03f,
                                                    .collapse = 0.04f,
                                                    .detail = 0};
    drawing.parts[1].branch_simplify = {-1.0f, 0.02f};
    drawing.mirror = {0, 0, -1, 0};
    drawing.pose.turns["leg_0.L"] = glm::angleAxis(0.5f, glm::vec3(0, 0, 1));
    drawing.pose.shift = {0.0f, 0.5f, 0.0f};
    drawing.picture = {"cat.png", {0.5, 0.25}, 2.0, 0.4f};
    pin_joint(drawing, "arm_1", {0.25, 0.5, 0});
    rename_joint(drawing, "arm_1", "elbow");
    merge_joint(drawing, "arm_2");
    drawing.parts[0].depth = 2.0f;
    const Drawing again = drawing_of_document(document_json(drawing));
    ASSERT_EQ(again.parts.size(), 2u);
    EXPECT_EQ(again.parts[1].contour->rings, drawing.parts[1].contour->rings);
    for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(again.parts[1].placement()[i], drawing.parts[1].placement()[i], 1e-12);
    EXPECT_TRUE(again.parts[0].visible && !again.parts[1].visible && again.parts[1].mirrored);
    EXPECT_EQ(again.parts[1].branch_simplify, drawing.parts[1].branch_simplify);
    EXPECT_FALSE(again.parts[0].thresholds);
    ASSERT_TRUE(again.parts[1].thresholds);
    EXPECT_EQ(again.parts[1].thresholds->prune, 0.03f);
    EXPECT_EQ(again.pose.turns, drawing.pose.turns);
    EXPECT_EQ(again.pose.shift, drawing.pose.shift);
    EXPECT_EQ(again.picture, drawing.picture);
    EXPECT_EQ(again.joint_edits, drawing.joint_edits);
    EXPECT_EQ(again.parts[0].depth, 2.0f);
    EXPECT_EQ(document_json(again), document_json(drawing));
    EXPECT_TRUE(drawing_of_document(document_json(Drawing{})).parts.empty());

    const test::Folder folder;
    write_drawing(drawing, (folder / "drawing.json").string());
    EXPECT_EQ(drawing_json(read_drawing((folder / "drawing.json").string())), drawing_json(drawing));
    EXPECT_EQ(folder.list().size(), 1u);
    EXPECT_THROW(write_drawing(Drawing{}, (folder / "none.json").string()), StudioError);
    EXPECT_THROW(write_drawing(drawing, (folder / "no/such.json").string()), StudioError);
}

TEST(StudioDrawing, RefusesWhatIsNone) {
    const test::Folder folder;
    folder.write("bad.json", "{\"parts\": [{\"name\": 1}]}");
    folder.write("bad.txt", "1 2\nnot a point\n");
    for (const char* name : {"bad.json", "bad.txt", "absent.txt"})
        EXPECT_THROW(read_drawing((folder / name).string()), StudioError) << name;
    EXPECT_THROW(drawing_of_document({{"pose", 7}}), StudioError);
    EXPECT_THROW(drawing_of_document({{"drawing", {{"parts", 1}}}}), StudioError);
}

TEST(StudioDrawing, NamesAreFreeAndWholeCharacters) {
    Drawing drawing;
    drawing.parts = {square("leg")};
    drawing.parts[0].id = 5;
    EXPECT_EQ(drawing.free_name("leg"), "leg 2");
    EXPECT_EQ(drawing.free_name("leg", 5), "leg");
    drawing.parts.push_back(square("leg 2"));
    drawing.parts[1].id = 6;
    EXPECT_EQ(drawing.free_name("leg 2"), "leg 3");
    EXPECT_EQ(drawing.free_name(""), "part");
    const std::string umlauts = drawing.free_name(std::string(47, 'a') + "\u00fc");
    EXPECT_EQ(umlauts, std::string(47, 'a'));
}

TEST(StudioJoints, EditsReplaceEachOtherAndFollowTheirPart) {
    Drawing drawing;
    Rig rig;
    rig.keys = rig.names = {"arm_0.L", "arm_1.L", "arm_1.R"};
    EXPECT_EQ(key_of(rig, 1), "arm_1");
    pin_joint(drawing, "arm_1", {1, 0, 0});
    pin_joint(drawing, "arm_1", {2, 0, 0});
    ASSERT_EQ(drawing.joint_edits.size(), 1u);
    EXPECT_EQ(drawing.joint_edits[0].at[0], 2.0);
    const std::string half = split_bone(drawing, rig, "arm_1");
    EXPECT_NE(split_bone(drawing, rig, "arm_1"), half);
    rename_joint(drawing, half, "wrist");
    rename_joint(drawing, half, half);
    EXPECT_EQ(drawing.joint_edits.size(), 3u) << "as it was called before";
    // What a split made is not made, rather than merged.
    merge_joint(drawing, half);
    EXPECT_EQ(drawing.joint_edits.size(), 2u);
    rename_part(drawing, "arm", "wing");
    EXPECT_EQ(drawing.joint_edits[0].joint, "wing_1");
    reset_joint(drawing, "wing_1");
    EXPECT_TRUE(drawing.joint_edits.empty());
}

// A spine of three joints, then two limbs of three.
Rig forked() {
    Rig rig;
    rig.rest = {{0, 0, 0},        {1, 0, 0},       {2, 0, 0},       {2.5f, -0.8f, 0}, {2.6f, -1.7f, 0},
                {2.4f, -2.4f, 0}, {2.5f, 0.8f, 0}, {2.6f, 1.7f, 0}, {2.4f, 2.4f, 0}};
    rig.parents = {FLG_NO_INDEX, 0, 1, 2, 3, 4, 2, 6, 7};
    rig.child_counts = {1, 1, 2, 1, 1, 0, 1, 1, 0};
    for (size_t j = 0; j < rig.rest.size(); ++j) rig.keys.push_back("joint_" + std::to_string(j));
    rig.names = rig.keys;
    rig.radii.assign(rig.rest.size(), 0.2f);
    rig.parts.assign(rig.rest.size(), 1);
    rig.size = 8.0f;
    return rig;
}

TEST(StudioRig, PulledJointsGoThereAndBonesKeepTheirLengths) {
    const Rig rig = forked();
    EXPECT_EQ(chain_of(rig, 5), (std::vector<uint32_t>{4, 3}));
    EXPECT_EQ(chain_of(rig, 3), (std::vector<uint32_t>{2, 1, 0}));
    EXPECT_TRUE(chain_of(rig, 0).empty());
    Pose pose;
    for (const glm::vec3 to : {glm::vec3(3.2f, -1.9f, 0.4f), glm::vec3(2.9f, -2.0f, -0.5f)}) {
        pull(rig, pose, 5, to);
        const PosedJoints joints = posed(rig, turns_of(rig, pose), pose.shift);
        EXPECT_LT(glm::distance(joints.at[5], to), 0.02f);
        for (size_t j = 1; j < rig.count(); ++j)
            EXPECT_NEAR(glm::distance(joints.at[j], joints.at[rig.parents[j]]),
                        glm::distance(rig.rest[j], rig.rest[rig.parents[j]]), 1e-4f);
        // What is not below the chain stays.
        for (const size_t j : {0u, 1u, 2u, 3u, 6u, 7u, 8u}) EXPECT_LT(glm::distance(joints.at[j], rig.rest[j]), 1e-5f);
    }
    // Out of reach: stretched towards it.
    pull(rig, pose, 5, {2.5f, -30.0f, 0.0f});
    const PosedJoints joints = posed(rig, turns_of(rig, pose), pose.shift);
    EXPECT_LT(glm::dot(glm::normalize(joints.at[5] - joints.at[3]), glm::vec3(0, 1, 0)), -0.99f);
    // The root takes all of it along.
    Pose moved;
    pull(rig, moved, 0, {1.0f, 2.0f, 3.0f});
    EXPECT_TRUE(moved.turns.empty());
    EXPECT_EQ(posed(rig, turns_of(rig, moved), moved.shift).at[8], rig.rest[8] + glm::vec3(1, 2, 3));
}

TEST(StudioRig, TwistsKeepTheBoneWhereItIs) {
    const Rig rig = forked();
    Pose pose;
    twist(rig, pose, 4, 0.7f);
    const PosedJoints joints = posed(rig, turns_of(rig, pose), pose.shift);
    for (const size_t j : {0u, 1u, 2u, 3u, 4u, 6u, 7u, 8u})
        EXPECT_LT(glm::distance(joints.at[j], rig.rest[j]), 1e-5f) << j;
    EXPECT_GT(glm::distance(joints.at[5], rig.rest[5]), 0.1f);
    twist(rig, pose, 4, -0.7f);
    EXPECT_LT(glm::distance(posed(rig, turns_of(rig, pose), pose.shift).at[5], rig.rest[5]), 1e-4f);
    // Joints that are not there any more are kept.
    pose.turns["gone_1"] = glm::angleAxis(1.0f, glm::vec3(1, 0, 0));
    set_turns(pose, rig, turns_of(rig, Pose{}));
    EXPECT_EQ(pose.turns.size(), 1u);
}

TEST(StudioHistory, AnActIsAStep) {
    History<int> history;
    int now = 0;
    EXPECT_FALSE(history.can_undo() || history.can_redo());
    for (int i = 0; i < 5; ++i) history.begin(now, "drag"), ++now;
    history.begin(now, "other");  // commits the drag
    now = 9;
    history.commit();
    now = history.undo(now);
    EXPECT_EQ(now, 5);
    now = history.undo(now);
    EXPECT_EQ(now, 0);
    EXPECT_FALSE(history.can_undo());
    now = history.redo(now);
    EXPECT_EQ(now, 5);
    history.begin(now, "third");
    now = 7;
    EXPECT_EQ(history.cancel(), 5);
    now = 5;
    EXPECT_TRUE(history.can_redo());
    now = history.redo(now);
    EXPECT_EQ(now, 9);
}

}  // namespace
}  // namespace flg::studio
