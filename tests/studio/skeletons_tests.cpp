// SPDX-License-Identifier: MIT
// The Skeletons workspace's lines, places and poses, without a window.
#include <gtest/gtest.h>

#include <numbers>

#include "shell/studio_error.h"
#include "skeletons/contour_edits.h"
#include "skeletons/drawing_file.h"
#include "skeletons/history.h"
#include "skeletons/joint_edits.h"
#include "skeletons/joint_symmetry.h"
#include "skeletons/rig.h"
#include "skeletons/weight_brush.h"
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

TEST(StudioContour, PointsThatFollowAreNearAlongTheLine) {
    // A thin strip: the point across is near, but not along the line.
    Ring strip;
    for (int i = 0; i <= 100; ++i) strip.emplace_back(0.1 * i, 0.0);
    for (int i = 100; i >= 0; --i) strip.emplace_back(0.1 * i, 0.2);
    const std::vector<double> shares = follow_shares(strip, 50, 1.0);
    EXPECT_EQ(shares[50], 1.0);
    EXPECT_EQ(shares[151], 0.0) << "across";
    for (int i = 0; i < 10; ++i) {
        EXPECT_NEAR(shares[50 + i], shares[50 - i], 1e-12);
        EXPECT_GT(shares[50 + i], shares[50 + i + 1]);
    }
    EXPECT_NEAR(shares[60], 0.0, 1e-12);
    const Contour contour{{strip, {{1, 0.05}, {2, 0.05}, {2, 0.1}}}};
    const Contour moved = with_point_moved(contour, {0, 50}, {0.0, -1.0}, 1.0);
    EXPECT_EQ(moved.rings[1], contour.rings[1]);
    EXPECT_EQ(moved.rings[0][50], glm::dvec2(strip[50].x, -1.0));
    for (size_t i = 0; i < strip.size(); ++i) EXPECT_NEAR(moved.rings[0][i].y, strip[i].y - shares[i], 1e-12);
    // Alone.
    const std::vector<double> alone = follow_shares(strip, 0, 0.0);
    EXPECT_EQ(alone[0], 1.0);
    EXPECT_EQ(alone[1] + alone.back(), 0.0);
    // Around the ring's first point.
    EXPECT_GT(follow_shares(strip, 201, 1.0)[0], 0.5);
    const Contour more = with_point_after(contour, {1, 2}, {1.5, 0.06});
    EXPECT_EQ(more.rings[1].back(), glm::dvec2(1.5, 0.06));
    EXPECT_EQ(without_point(more, {1, 3}).rings, contour.rings);
}

// A strip of squares, folded to a closed flat surface: vertices 2 i and 2 i + 1 at x = i.
struct FlatSkin {
    explicit FlatSkin(uint32_t count) {
        for (uint32_t i = 0; i < count; ++i)
            for (const float y : {0.0f, 1.0f}) {
                positions.insert(positions.end(), {static_cast<float>(i), y, 0.0f});
                joints.insert(joints.end(), {static_cast<uint16_t>(i < count / 2 ? 0 : 1), 0, 0, 0});
                weights.insert(weights.end(), {1, 0, 0, 0});
            }
        for (uint32_t i = 0; i + 1 < count; ++i) {
            const uint32_t a = 2 * i, b = a + 1, c = a + 2, d = a + 3;
            triangles.insert(triangles.end(), {a, c, b, b, c, d, a, b, c, b, d, c});
        }
        parts.assign(2 * count, 0);
        view = flgSkinViewDefaults();
        view.vertex_count = 2 * count;
        view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        view.joint_count = 3;
        view.positions = positions.data();
        view.triangles = triangles.data();
        view.vertex_joints = joints.data();
        view.vertex_weights = weights.data();
        view.vertex_parts = parts.data();
        view.joint_parents = parents;
    }
    std::vector<float> positions, weights;
    std::vector<uint16_t> joints;
    std::vector<uint32_t> triangles, parts;
    const uint32_t parents[3] = {FLG_NO_INDEX, 0, 1};
    FlgSkinView view;
};

void expect_valid(const PaintedWeights& painted, uint32_t vertices) {
    for (uint32_t v = 0; v < vertices; ++v) {
        float sum = 0.0f;
        for (uint32_t k = 4 * v; k < 4 * v + 4; ++k) {
            sum += painted.weights()[k];
            EXPECT_TRUE(painted.weights()[k] >= 0.0f && painted.weights()[k] <= painted.weights()[4 * v]);
        }
        EXPECT_NEAR(sum, 1.0f, 1e-5f);
    }
}

TEST(StudioWeights, StayWholeUnderEveryBrush) {
    const FlatSkin skin(20);
    PaintedWeights painted;
    painted.begin(skin.view);
    PaintedWeights::Dab dab{.seed = 8, .at = {4, 0, 0}, .radius = 2.5f, .strength = 0.5f, .joint = 2};
    painted.paint(dab);
    EXPECT_FLOAT_EQ(painted.of_joint(2)[8], 0.5f);
    EXPECT_FLOAT_EQ(painted.of_joint(0)[8], 0.5f);
    EXPECT_GT(painted.of_joint(2)[10], 0.0f);
    EXPECT_EQ(painted.of_joint(2)[14], 0.0f) << "outside of the brush";
    expect_valid(painted, 40);
    dab.brush = WeightBrush::subtract;
    dab.strength = 1.0f;
    painted.paint(dab);
    EXPECT_NEAR(painted.of_joint(2)[8], 0.0f, 1e-6f);
    // From what follows one joint alone to the joint before; the root's stays.
    dab.seed = 38, dab.at = {19, 0, 0}, dab.joint = 1;
    painted.paint(dab);
    EXPECT_FLOAT_EQ(painted.of_joint(0)[38], 1.0f);
    dab.joint = 0;
    painted.paint(dab);
    EXPECT_FLOAT_EQ(painted.of_joint(0)[38], 1.0f);
    expect_valid(painted, 40);
    // Where weights jump, smoothing makes steps smaller.
    painted.begin(skin.view);
    const auto jump = [&] { return std::abs(painted.of_joint(1)[20] - painted.of_joint(1)[18]); };
    EXPECT_EQ(jump(), 1.0f);
    dab = {.seed = 20, .at = {10, 0, 0}, .radius = 4.0f, .brush = WeightBrush::smooth, .strength = 0.5f};
    for (int i = 0; i < 8; ++i) painted.paint(dab);
    EXPECT_LT(jump(), 0.5f);
    expect_valid(painted, 40);
}

TEST(StudioWeights, ReachOnlyWhatHangsTogether) {
    FlatSkin skin(20);
    // The strip comes back beside itself: the second half lies 0.5 in front of the first.
    for (uint32_t v = 20; v < 40; ++v) {
        skin.positions[3 * v] = 19.0f - skin.positions[3 * v];
        skin.positions[3 * v + 2] = 0.5f;
    }
    PaintedWeights painted;
    painted.begin(skin.view);
    painted.paint({.seed = 4, .at = {2, 0, 0}, .radius = 3.0f, .strength = 1.0f, .joint = 2});
    EXPECT_FLOAT_EQ(painted.of_joint(2)[4], 1.0f);
    for (uint32_t v = 24; v < 40; ++v) EXPECT_EQ(painted.of_joint(2)[v], 0.0f) << v;
}

TEST(StudioPulls, RecordsArePlayedBetweenTheirKeys) {
    const BodyPlace tip{"arm", false, {1, 2, 0}}, foot{"leg", true, {0, 0, 0}};
    PullRecord record;
    EXPECT_TRUE(record.at(0.0f).empty());
    record.add(0.0f, {{tip, {0, 0, 0}}});
    record.add(1.0f, {{tip, {2, 0, 0}}, {foot, {0, 1, 0}}});
    record.add(2.0f, {{foot, {0, 3, 0}}});
    EXPECT_EQ(record.places.size(), 2u);
    EXPECT_EQ(record.length(), 2.0f);
    EXPECT_EQ(record.at(0.5f), (std::vector<PullPin>{{tip, {1, 0, 0}}}));
    EXPECT_EQ(record.at(1.5f), (std::vector<PullPin>{{tip, {2, 0, 0}}, {foot, {0, 2, 0}}}));
    for (const float after : {2.0f, 9.0f}) EXPECT_EQ(record.at(after), (std::vector<PullPin>{{foot, {0, 3, 0}}}));
    EXPECT_EQ(record.at(-1.0f), (std::vector<PullPin>{{tip, {0, 0, 0}}}));
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
    const BodyPlace place{"leg", true, {0.25, 0.5, -0.125}};
    drawing.weight_strokes.push_back(std::make_shared<WeightStroke>(
        WeightStroke{WeightBrush::subtract, "leg_0.L", "leg_0.R", 0.25f, {{place, 0.5, true}, {place, 0.25, false}}}));
    drawing.pulls.pins = {{place, {1.0f, 0.5f, 0.0f}}};
    PullRecord record;
    record.add(0.0f, drawing.pulls.pins);
    record.add(0.5f, {});
    drawing.pulls.record = std::make_shared<PullRecord>(record);
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
    ASSERT_EQ(again.weight_strokes.size(), 1u);
    EXPECT_EQ(*again.weight_strokes[0], *drawing.weight_strokes[0]);
    EXPECT_EQ(again.pulls.pins, drawing.pulls.pins);
    ASSERT_TRUE(again.pulls.record);
    EXPECT_EQ(*again.pulls.record, record);
    EXPECT_EQ(document_json(again), document_json(drawing));
    EXPECT_TRUE(drawing_of_document(document_json(Drawing{})).parts.empty());

    const test::Folder folder;
    write_drawing(drawing, (folder / "drawing.json").string());
    std::vector<std::string> warnings;
    EXPECT_EQ(drawing_json(read_drawing((folder / "drawing.json").string(), warnings)), drawing_json(drawing));
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(folder.list().size(), 1u);
    EXPECT_THROW(write_drawing(Drawing{}, (folder / "none.json").string()), StudioError);
    EXPECT_THROW(write_drawing(drawing, (folder / "no/such.json").string()), StudioError);
}

// By keys and places, as the model had them; so edits and poses find their joints again.
TEST(StudioDrawing, DocumentsKeepWhoJointsAre) {
    const char* const keys[] = {"body_3", "leg_0.L"};
    const double places[] = {0.1, 0.2, 0, -1.0 / 3, 2, 0.5};
    const uint32_t parents[] = {FLG_NO_INDEX, 0};
    FlgModelView view = flgModelViewDefaults();
    view.joint_count = 2;
    view.joint_keys = keys;
    view.joint_places = places;
    view.joint_parents = parents;
    const nlohmann::json joints = cli::KeptJoints::json_of(view);
    const auto kept = joints_of_document({{"joints", nlohmann::json::parse(joints.dump())}});
    ASSERT_TRUE(kept);
    const FlgModelView again = kept->view();
    ASSERT_EQ(again.joint_count, 2u);
    for (size_t j = 0; j < 2; ++j) {
        EXPECT_STREQ(again.joint_keys[j], keys[j]);
        EXPECT_EQ(again.joint_parents[j], parents[j]);
        for (size_t k = 0; k < 3; ++k) EXPECT_EQ(again.joint_places[3 * j + k], places[3 * j + k]);
    }
    EXPECT_EQ(cli::KeptJoints::json_of(again), joints);
    EXPECT_FALSE(joints_of_document(nlohmann::json::object()));
    EXPECT_THROW(joints_of_document({{"joints", 7}}), StudioError);
    EXPECT_THROW(joints_of_document({{"joints", {{{"key", "a"}, {"parent", 0}, {"place", {0, 0, 0}}}}}}), StudioError);
    EXPECT_THROW(joints_of_document({{"joints", {{{"key", "a"}, {"parent", nullptr}, {"place", {0}}}}}}), StudioError);
}

TEST(StudioDrawing, OutlinesOfAnSvgArePartsOfOneScale) {
    const test::Folder folder;
    folder.write("page.svg",
                 "<svg xmlns='http://www.w3.org/2000/svg' width='300' height='300'><rect width='200' height='200'/>"
                 "<rect x='250' y='9' width='9' height='9'/><rect x='280' width='0.5' height='0.5'/></svg>");
    std::vector<std::string> warnings;
    const Drawing drawing = read_drawing((folder / "page.svg").string(), warnings);
    ASSERT_EQ(drawing.parts.size(), 2u);
    for (const DrawnPart& part : drawing.parts) EXPECT_EQ(part.scale, 0.01);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("1 outline is smaller"), std::string::npos) << warnings[0];
}

TEST(StudioDrawing, RefusesWhatIsNone) {
    const test::Folder folder;
    folder.write("bad.json", "{\"parts\": [{\"name\": 1}]}");
    folder.write("bad.txt", "1 2\nnot a point\n");
    std::vector<std::string> warnings;
    for (const char* name : {"bad.json", "bad.txt", "absent.txt"})
        EXPECT_THROW(read_drawing((folder / name).string(), warnings), StudioError) << name;
    EXPECT_THROW(drawing_of_document({{"pose", 7}}), StudioError);
    EXPECT_THROW(drawing_of_document({{"drawing", {{"parts", 1}}}}), StudioError);
    EXPECT_THROW(drawing_of_document({{"weights", {{{"brush", "add"}}}}}), StudioError);
    const nlohmann::json held = nlohmann::json::array({0, 1.0, 1.0, 1.0});
    const auto key = [&](float seconds) { return nlohmann::json::array({seconds, nlohmann::json::array({held})}); };
    const nlohmann::json places = nlohmann::json::array({nlohmann::json::array({"leg", false, 0.0, 0.0, 0.0})});
    const auto pulls = [&](nlohmann::json of, nlohmann::json keys) {
        return nlohmann::json{{"pulls", {{"places", std::move(of)}, {"keys", std::move(keys)}}}};
    };
    EXPECT_TRUE(drawing_of_document(pulls(places, nlohmann::json::array({key(0), key(1)}))).pulls.record);
    EXPECT_THROW(drawing_of_document(pulls(places, nlohmann::json::array({key(1), key(0)}))), StudioError);
    EXPECT_THROW(drawing_of_document(pulls(nlohmann::json::array(), nlohmann::json::array({key(0)}))), StudioError);
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
    drawing.weight_strokes.push_back(std::make_shared<WeightStroke>(
        WeightStroke{WeightBrush::add, "arm_1.L", "", 0.5f, {{{"arm", false, {}}, 0.5, false}}}));
    drawing.pulls.pins = {{{"arm", false, {}}, {}}, {{"leg", false, {}}, {}}};
    rename_part(drawing, "arm", "wing");
    EXPECT_EQ(drawing.weight_strokes[0]->joint, "wing_1.L");
    EXPECT_EQ(drawing.weight_strokes[0]->dabs[0].place.part, "wing");
    EXPECT_EQ(drawing.pulls.pins[0].place.part, "wing");
    EXPECT_EQ(drawing.pulls.pins[1].place.part, "leg");
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

TEST(StudioRig, FindsThePlaneOfItsMirrorImage) {
    Rig rig = forked();
    rig.rest[5].x = rig.rest[8].x;
    const auto symmetry = symmetry_of(rig);
    ASSERT_TRUE(symmetry);
    EXPECT_EQ(symmetry->pairs, (std::vector<uint32_t>{0, 1, 2, 6, 7, 8, 3, 4, 5}));
    EXPECT_NEAR(std::abs(symmetry->plane.y), 1.0f, 1e-5f);
    rig.rest[5].x += 0.3f;
    EXPECT_FALSE(symmetry_of(rig));
    EXPECT_FALSE(symmetry_of(Rig{}));
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
