// SPDX-License-Identifier: MIT
// Hierarchies as animators expect them, over drawings made by code: roots, symmetry, numbers of joints, joints that
// last while a part is dragged, and what hosts set about joints.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "api/drawings.h"
#include "api/part_inputs.h"

namespace flg::test {
namespace {

struct Joint {
    std::string name, key, parent;  // parent: a name; none: a root
    std::array<double, 3> at;
    uint32_t part;
    bool is_pinned;
};

struct Skeleton {
    std::vector<Joint> joints;
    std::vector<uint32_t> part_parents;
    double size = 0;

    std::vector<std::string> roots() const {
        std::vector<std::string> names;
        for (const Joint& joint : joints)
            if (joint.parent.empty()) names.push_back(joint.name);
        return names;
    }
    const Joint* find(const std::string& key) const {
        for (const Joint& joint : joints)
            if (joint.key == key) return &joint;
        return nullptr;
    }
    // Every joint with its parent.
    std::set<std::string> graph() const {
        std::set<std::string> out;
        for (const Joint& joint : joints) out.insert(joint.name + " < " + joint.parent);
        return out;
    }
    // How far joints are from being their mirror images in a coordinate, by the size.
    double asymmetry(size_t coordinate) const { return asymmetry_at(coordinate, 0); }
    double asymmetry_at(size_t coordinate, double middle) const {
        double worst = 0;
        for (const Joint& joint : joints) {
            auto image = joint.at;
            image[coordinate] = 2 * middle - image[coordinate];
            double nearest = 1e300;
            for (const Joint& other : joints)
                nearest = std::min(nearest,
                                   std::hypot(other.at[0] - image[0], other.at[1] - image[1], other.at[2] - image[2]));
            worst = std::max(worst, nearest);
        }
        return worst / size;
    }
};

class Hierarchy : public testing::Test {
protected:
    FlgModelPart part(const char* name, const std::vector<double>& contour, double x = 0, double y = 0,
                      double z = 0) const {
        FlgModelPart out = flgModelPartDefaults();
        out.part = host.part(contour);
        out.name = name;
        out.placement[3] = x, out.placement[7] = y, out.placement[11] = z;
        return out;
    }

    FlgModelDesc desc_of(const std::vector<FlgModelPart>& parts) const {
        FlgModelDesc desc = flgModelDefaults();
        desc.parts = parts.data();
        desc.part_count = static_cast<uint32_t>(parts.size());
        return desc;
    }

    Skeleton made(const FlgModelDesc& desc, FlgModel* out_model = nullptr) const {
        FlgModel model{};
        EXPECT_EQ(flgModelCreate(host.context, &desc, &model, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        FlgModelView view = flgModelViewDefaults();
        EXPECT_EQ(flgModelGetView(host.context, model, &view), FLG_OK) << flgErrorGetMessage();
        Skeleton out;
        out.size = view.size;
        for (uint32_t j = 0; j < view.joint_count; ++j) {
            const float* at = view.joint_positions + 3 * j;
            const uint32_t parent = view.joint_parents[j];
            out.joints.push_back({view.joint_names[j],
                                  view.joint_keys[j],
                                  parent == FLG_NO_INDEX ? "" : view.joint_names[parent],
                                  {at[0], at[1], at[2]},
                                  view.joint_parts[j],
                                  view.joint_pinned[j] != 0});
        }
        out.part_parents.assign(view.part_parents, view.part_parents + view.part_count);
        if (out_model) *out_model = model;
        return out;
    }
    Skeleton made(const std::vector<FlgModelPart>& parts) const { return made(desc_of(parts)); }
    Skeleton made(const Line& line) const { return made({part("drawn", smooth(line))}); }
    // With the corners as they are.
    Skeleton made_of_corners(const Line& line) const {
        std::vector<double> points;
        for (const auto& point : line) points.insert(points.end(), point.begin(), point.end());
        return made({part("drawn", points)});
    }

    std::string refused(const FlgModelDesc& desc) const {
        FlgModel model{};
        if (flgModelCreate(host.context, &desc, &model, nullptr) != FLG_OK) return flgErrorGetMessage();
        host.finish();
        FlgModelView view = flgModelViewDefaults();
        EXPECT_EQ(flgModelGetView(host.context, model, &view), FLG_ERROR_INVALID_ARGUMENT);
        return flgErrorGetMessage();
    }

    PartHost host;
};

// ---- Numbers of joints, and symmetry -------------------------------------------------------------------------------

TEST_F(Hierarchy, DefaultsAreForPeople) {
    const auto count = [&](const Line& line) { return made(line).joints.size(); };
    EXPECT_NEAR(static_cast<double>(count(person())), 20, 4);
    EXPECT_LE(count(hand()), 28u);
    EXPECT_GE(count(hand()), 18u);  // three a finger
    EXPECT_GE(count(octopus()), 8u * 4 + 1);
    EXPECT_LE(count(octopus()), 8u * 6 + 6);
    EXPECT_LE(count(snake()), 24u);
    EXPECT_GE(count(snake()), 10u);
}

// A drawn head is never a circle: what its corners reach beyond the ball in its middle is no limb. Points so near an
// axis as floats are, are on it.
TEST_F(Hierarchy, RoundPartsHaveFewJoints) {
    for (int corners = 6; corners <= 14; ++corners) {
        for (const double uneven : {0.0, 0.01}) {
            Line line;
            for (int i = 0; i < corners; ++i) {
                const double angle = 2 * M_PI * i / corners, radius = 1 + uneven * std::sin(7.0 * i + corners);
                const double x = 2.45 + radius * std::cos(angle), y = 1.75 + radius * std::sin(angle);
                line.push_back({std::round(1000 * x) / 1000, std::round(1000 * y) / 1000});
            }
            std::vector<double> contour = smooth(line);
            for (double& c : contour) c = double{static_cast<float>(c)};
            EXPECT_LE(made({part("head", contour)}).joints.size(), 3u) << corners << " " << uneven;
        }
    }
}

TEST_F(Hierarchy, OneNumberMakesBonesFinerAndCoarser) {
    const std::vector<FlgModelPart> parts = {part("drawn", smooth(person()))};
    FlgModelDesc desc = desc_of(parts);
    FlgBoneThresholds thresholds = flgBoneThresholdsDefaults();
    desc.thresholds = &thresholds;
    size_t before = 0;
    for (const float detail : {0.25f, 1.0f, 4.0f}) {
        thresholds.detail = detail;
        const size_t joints = made(desc).joints.size();
        EXPECT_GT(joints, before) << detail;
        before = joints;
    }
    thresholds.detail = 21;
    EXPECT_NE(refused(desc).find("desc.thresholds.detail is 21"), std::string::npos) << flgErrorGetMessage();
}

TEST_F(Hierarchy, SymmetricDrawingsGetSymmetricJoints) {
    for (const Line& line : {person(), person_without_arms(), octopus(), spider(), starfish()}) {
        const Skeleton skeleton = made(line);
        EXPECT_LE(skeleton.asymmetry(0), 1e-6) << skeleton.joints.size();
        ASSERT_EQ(skeleton.roots().size(), 1u);
        for (const Joint& joint : skeleton.joints) {
            if (joint.parent.empty()) {
                EXPECT_LE(std::abs(joint.at[0]), 1e-6 * skeleton.size) << "the root is on the mirror axis";
            }
        }
    }
}

TEST_F(Hierarchy, WhereverAndHoweverASymmetricDrawingLies) {
    // Begun at another point, drawn the other way round, turned and moved.
    const std::vector<double> points = smooth(person());
    const size_t n = points.size() / 2;
    for (const size_t begin : {0u, 37u, 200u}) {
        for (const double turn : {0.0, 0.7, 2.5}) {
            std::vector<double> drawn;
            for (size_t i = 0; i < n; ++i) {
                const size_t k = (begin + (begin == 37 ? n - i : i)) % n;
                const double x = points[2 * k], y = points[2 * k + 1];
                drawn.push_back(x * std::cos(turn) - y * std::sin(turn) + 3);
                drawn.push_back(x * std::sin(turn) + y * std::cos(turn) - 8);
            }
            Skeleton skeleton = made({part("drawn", drawn)});
            for (Joint& joint : skeleton.joints) {
                const double x = joint.at[0] - 3, y = joint.at[1] + 8;
                joint.at[0] = x * std::cos(turn) + y * std::sin(turn);
            }
            for (Joint& joint : skeleton.joints) joint.at[1] = 0;
            EXPECT_LE(skeleton.asymmetry(0), 1e-6) << begin << " " << turn;
        }
    }
}

TEST_F(Hierarchy, JointsLieInside) {
    for (const Line& line : {person(), hand(), octopus(), spider(), starfish(), snake()}) {
        const std::vector<double> drawn = smooth(line);
        const size_t n = drawn.size() / 2;
        for (const Joint& joint : made({part("drawn", drawn)}).joints) {
            bool is_inside = false;
            for (size_t i = 0, k = n - 1; i < n; k = i++) {
                const double ax = drawn[2 * i], ay = drawn[2 * i + 1], bx = drawn[2 * k], by = drawn[2 * k + 1];
                if ((ay > joint.at[1]) != (by > joint.at[1]) &&
                    joint.at[0] < ax + (joint.at[1] - ay) / (by - ay) * (bx - ax))
                    is_inside = !is_inside;
            }
            EXPECT_TRUE(is_inside) << joint.name;
        }
    }
}

TEST_F(Hierarchy, AHeadThatIsWiderThanTheTrunkHasAJoint) {
    struct Drawn {
        Line line;
        double neck;
    };
    for (const Drawn& drawn :
         {Drawn{person_with_big_head(), 1.5}, Drawn{chibi(), 4.9}, Drawn{chibi_with_level_arms(), 4.3},
          Drawn{chibi_with_ears(), 4.9}, Drawn{chibi_without_neck(), 4.8}}) {
        for (const Skeleton& skeleton : {made(drawn.line), made_of_corners(drawn.line)}) {
            EXPECT_LE(skeleton.asymmetry(0), 1e-6);
            const auto is_head = [&](const Joint& joint) {
                return std::abs(joint.at[0]) < 1e-6 * skeleton.size && joint.at[1] > drawn.neck &&
                       !joint.parent.empty();
            };
            EXPECT_TRUE(std::any_of(skeleton.joints.begin(), skeleton.joints.end(), is_head)) << drawn.neck;
            EXPECT_LE(skeleton.joints.size(), 24u);
        }
    }
}

TEST_F(Hierarchy, TheHemOfASkirtIsNoLimb) {
    struct Drawn {
        Line line;
        double hem, legs;  // the hem's height; the legs below are so near to the middle
    };
    for (const Drawn& drawn : {Drawn{person_in_a_skirt(), 0.2, 0.22}, Drawn{person_in_a_dress(), 2.3, 1.8}}) {
        for (const Skeleton& skeleton : {made(drawn.line), made_of_corners(drawn.line)}) {
            uint32_t feet = 0;
            for (const Joint& joint : skeleton.joints) {
                const bool is_beside = std::abs(joint.at[0]) > drawn.legs && joint.at[1] < 1.6 * drawn.hem;
                EXPECT_FALSE(is_beside) << joint.name << " " << joint.at[0] << " " << joint.at[1];
                feet += joint.at[1] < drawn.hem / 2;
            }
            EXPECT_GE(feet, 2u);
        }
    }
}

TEST_F(Hierarchy, ASpineGoesOneWay) {
    for (const Line& line : {person(), thin_person(), person_with_big_head(), person_in_a_skirt()}) {
        for (const Skeleton& skeleton : {made(line), made_of_corners(line)}) {
            // From joint to joint on the axis always up, or always down.
            for (const Joint& joint : skeleton.joints) {
                const Joint* parent = skeleton.find(joint.parent);
                const Joint* before = parent ? skeleton.find(parent->parent) : nullptr;
                if (!before) continue;
                const double near = 1e-6 * skeleton.size;
                if (std::abs(joint.at[0]) > near || std::abs(parent->at[0]) > near) continue;
                EXPECT_GT((joint.at[1] - parent->at[1]) * (parent->at[1] - before->at[1]), 0) << joint.name;
            }
        }
    }
}

TEST_F(Hierarchy, FingersAndWristHangOnThePalm) {
    const Skeleton skeleton = made_of_corners(open_hand());
    ASSERT_EQ(skeleton.roots().size(), 1u);
    const Joint* palm = skeleton.find(skeleton.roots()[0]);
    const std::array<double, 2> tips[] = {{0.5, 1.1}, {0.17, 1.35}, {-0.16, 1.4}, {-0.5, 1.2}, {-0.92, 0.46}};
    std::set<std::string> limbs;
    const auto limb_at = [&](const std::array<double, 2>& tip) {
        const Joint* end = nullptr;
        for (const Joint& joint : skeleton.joints)
            if (!end || std::hypot(joint.at[0] - tip[0], joint.at[1] - tip[1]) <
                            std::hypot(end->at[0] - tip[0], end->at[1] - tip[1]))
                end = &joint;
        uint32_t count = 1;
        for (; end->parent != palm->name; end = skeleton.find(end->parent)) ++count;
        limbs.insert(end->name);
        return count;
    };
    for (const auto& tip : tips) {
        const uint32_t joints = limb_at(tip);
        EXPECT_GE(joints, 3u);
        EXPECT_LE(joints, 4u);  // with one in the palm
    }
    limb_at({0, -1});
    EXPECT_EQ(limbs.size(), 6u) << "five fingers and the wrist";
}

// Valleys as sharp as a pen draws them: fingers part at the palm, and not at the wrist.
TEST_F(Hierarchy, FingersWithSharpValleysHangOnThePalm) {
    const Skeleton skeleton = made_of_corners(sharp_hand());
    const Joint* palm = nullptr;
    for (const Joint& joint : skeleton.joints) {
        size_t limbs = joint.parent.empty() ? 0 : 1;
        for (const Joint& other : skeleton.joints) limbs += other.parent == joint.name;
        if (limbs >= 5) palm = &joint;
    }
    ASSERT_NE(palm, nullptr) << skeleton.joints.size();
    EXPECT_GT(palm->at[1], 0);
    EXPECT_LT(palm->at[1], 2);
    EXPECT_GE(skeleton.joints.size(), 18u);  // three a finger
    EXPECT_LE(skeleton.joints.size(), 28u);
}

// A cut that is as narrow as a line still parts two limbs, on the axis of the drawing or off it.
TEST_F(Hierarchy, NarrowGapsPartLimbs) {
    for (const double gap : {0.04, 0.1, 0.3})
        for (const double off : {0.0, 0.3}) {
            const double left = 2 - gap / 2, right = 2 + gap / 2;
            const Skeleton skeleton =
                made_of_corners({{0, 0}, {4 + off, 0}, {4, 8}, {right, 8}, {right, 2}, {left, 2}, {left, 8}, {0, 8}});
            size_t high[2] = {0, 0};
            for (const Joint& joint : skeleton.joints) {
                if (joint.at[1] > 2.5) {
                    EXPECT_GT(std::abs(joint.at[0] - 2), 0.5) << joint.name << " " << gap;
                }
                if (joint.at[1] > 5) ++high[joint.at[0] > 2];
            }
            EXPECT_GE(high[0], 1u) << gap << " " << off;
            EXPECT_GE(high[1], 1u) << gap << " " << off;
            if (off == 0) {
                EXPECT_LE(skeleton.asymmetry_at(0, 2), 1e-6) << gap;
            }
        }
}

// Blocks with gaps between them are one figure; what is far away is none of it.
TEST_F(Hierarchy, BlocksBesideEachOtherAreOneFigure) {
    const auto block = [&](const char* name, double left, double bottom, double right, double top) {
        return part(name, {left, bottom, right, bottom, right, top, left, top});
    };
    std::vector<FlgModelPart> parts = {block("torso", -0.8, 0, 0.8, 2.4),    block("head", -0.5, 2.5, 0.5, 3.5),
                                       block("larm", 0.85, 0.4, 1.25, 2.3),  block("rarm", -1.25, 0.4, -0.85, 2.3),
                                       block("lleg", 0.1, -2.4, 0.7, -0.05), block("rleg", -0.7, -2.4, -0.1, -0.05)};
    for (FlgModelPart& each : parts) each.thickness = 0.8f;
    const Skeleton skeleton = made(parts);
    EXPECT_EQ(skeleton.roots().size(), 1u);
    for (size_t p = 1; p < parts.size(); ++p) EXPECT_EQ(skeleton.part_parents[p], 0u) << parts[p].name;
    for (const Joint& joint : skeleton.joints) {
        const Joint* parent = joint.parent.empty() ? nullptr : skeleton.find(joint.parent);
        if (!parent || parent->part == joint.part) continue;
        const bool is_arm = joint.part == 2 || joint.part == 3, is_leg = joint.part >= 4;
        EXPECT_TRUE(!is_arm || joint.at[1] > 1.3) << "by the shoulder: " << joint.name;
        EXPECT_TRUE(!is_leg || joint.at[1] > -1.2) << "by the hip: " << joint.name;
    }
    parts.push_back(block("sun", 4, 4, 5, 5));
    EXPECT_EQ(made(parts).roots().size(), 2u);
}

// Hands that meet before the chest: both arms hang by their shoulders.
TEST_F(Hierarchy, ArmsThatPrayHangByTheirShoulders) {
    for (const double z : {0.0, 0.7}) {
        std::vector<FlgModelPart> parts = {
            part("torso", smooth({{-0.8, -0.8}, {0.8, -0.8}, {0.75, 1.2}, {0.95, 2.8}, {-0.95, 2.8}, {-0.75, 1.2}})),
            part("arm", smooth({{0.7, 2.85}, {1.05, 2.85}, {1.45, 1.3}, {1.2, 1.0}, {0, 2.05}, {0, 2.35}, {1.05, 1.6}}),
                 0, 0, z)};
        parts[1].mirrored = 1;
        const Skeleton skeleton = made(parts);
        for (const Joint& joint : skeleton.joints) {
            if (joint.part == 0) continue;
            const Joint* parent = nullptr;
            for (const Joint& other : skeleton.joints)
                if (other.name == joint.parent) parent = &other;
            if (!parent || parent->part != 0) continue;
            EXPECT_GT(std::abs(joint.at[0]), 0.5) << joint.name << " hangs on " << joint.parent << " " << z;
            EXPECT_GT(joint.at[1], 2.3);
        }
    }
}

TEST_F(Hierarchy, EqualLimbsGetEqualNumbersOfJoints) {
    const Skeleton skeleton = made(starfish());
    std::map<std::string, int> below;
    for (const Joint& joint : skeleton.joints) {
        const Joint* at = &joint;
        while (at && !at->parent.empty() && skeleton.find(at->parent)->parent != "") at = skeleton.find(at->parent);
        if (at && !at->parent.empty()) ++below[at->name];
    }
    ASSERT_EQ(below.size(), 5u);
    for (const auto& [limb, count] : below) EXPECT_EQ(count, below.begin()->second) << limb;
}

// ---- Roots and parents ---------------------------------------------------------------------------------------------

TEST_F(Hierarchy, ArmsHangOnTheTrunkWhateverWasDrawnFirst) {
    const FlgModelPart trunk = part("trunk", smooth(person_without_arms())), right = part("right", smooth(arm(1))),
                       left = part("left", smooth(arm(-1)));
    const std::vector<std::vector<FlgModelPart>> orders = {
        {trunk, right, left}, {right, left, trunk}, {right, trunk, left}};
    for (const auto& parts : orders) {
        const Skeleton skeleton = made(parts);
        ASSERT_EQ(skeleton.roots().size(), 1u);
        EXPECT_EQ(skeleton.roots()[0].rfind("trunk", 0), 0u) << skeleton.roots()[0];
        for (uint32_t p = 0; p < 3; ++p) {
            const bool is_trunk = parts[p].part.id == trunk.part.id;
            const uint32_t parent = skeleton.part_parents[p];
            if (is_trunk) {
                EXPECT_EQ(parent, FLG_NO_INDEX);
            } else {
                ASSERT_LT(parent, 3u);
                EXPECT_EQ(parts[parent].part.id, trunk.part.id);
            }
        }
        EXPECT_LE(skeleton.asymmetry(0), 1e-6);
    }
}

TEST_F(Hierarchy, AChairIsOneTree) {
    const std::vector<double> square = {-2, -2, 2, -2, 2, 2, -2, 2}, leg = {-.15, -3, .15, -3, .15, .05, -.15, .05};
    for (const bool legs_first : {false, true}) {
        std::vector<FlgModelPart> parts;
        FlgModelPart seat = part("seat", square);
        seat.thickness = 0.2f;
        const double lying[] = {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0};
        std::copy_n(lying, 12, seat.placement);
        if (!legs_first) parts.push_back(seat);
        parts.push_back(part("a", leg, 1.8, 0, 1.8));
        parts.push_back(part("b", leg, 1.8, 0, -1.8));
        parts.push_back(part("c", leg, -1.8, 0, 1.8));
        parts.push_back(part("d", leg, -1.8, 0, -1.8));
        if (legs_first) parts.push_back(seat);
        const Skeleton skeleton = made(parts);
        EXPECT_EQ(skeleton.roots().size(), 1u) << legs_first;
        EXPECT_EQ(skeleton.roots()[0].rfind("seat", 0), 0u);
        EXPECT_LE(skeleton.asymmetry(0), 1e-6);
        EXPECT_LE(skeleton.asymmetry(2), 1e-6);
    }
}

TEST_F(Hierarchy, ParentsAndRootsCanBeGiven) {
    std::vector<FlgModelPart> parts = {part("body", smooth(tube({{-3, 0, 1}, {0, 0, 1.2}, {3, 0, 1}}))),
                                       part("head", smooth(tube({{2.8, 0.5, 0.6}, {4, 1, 0.7}, {5, 1.2, 0.5}}))),
                                       part("bird", smooth(tube({{20, 9, 0.3}, {21, 9, 0.4}, {22, 9, 0.3}})))};
    EXPECT_EQ(made(parts).roots().size(), 2u);
    parts[2].parent = 1;  // far away
    Skeleton skeleton = made(parts);
    EXPECT_EQ(skeleton.roots().size(), 1u);
    EXPECT_EQ(skeleton.part_parents[2], 1u);
    const std::string last = [&] {
        std::string name;
        for (const Joint& joint : skeleton.joints)
            if (joint.part == 0 && joint.key.rfind("body_at", 0) != 0) name = joint.key;
        return name;
    }();
    parts[2].parent = 0;
    parts[2].parent_joint = last.c_str();
    skeleton = made(parts);
    EXPECT_EQ(skeleton.find("bird_0")->parent, last);
    parts[2].parent_joint = "body_77";  // is not there
    EXPECT_EQ(made(parts).part_parents[2], 0u);
    parts[2].parent_joint = nullptr;
    FlgModelDesc desc = desc_of(parts);
    desc.root = 1;
    skeleton = made(desc);
    EXPECT_EQ(skeleton.roots()[0].rfind("head", 0), 0u);
    EXPECT_EQ(skeleton.part_parents[0], 1u);
    desc.root = 0;
    desc.root_joint = last.c_str();
    EXPECT_EQ(made(desc).roots()[0], last);
    // Each part a tree of its own.
    parts[1].parent = 1;
    desc.root_joint = nullptr;
    EXPECT_EQ(made(desc).roots().size(), 2u);
}

TEST_F(Hierarchy, RefusesParentsThatMakeNoTree) {
    const std::vector<double> line = smooth(tube({{-3, 0, 1}, {0, 0, 1.2}, {3, 0, 1}}));
    std::vector<FlgModelPart> parts = {part("body", line), part("leg", line), part("foot", line)};
    parts[1].parent = 2;
    parts[2].parent = 1;
    EXPECT_NE(refused(desc_of(parts)).find("desc.parts[2].parent makes a cycle: foot would hang on itself"),
              std::string::npos)
        << flgErrorGetMessage();
    parts[2].parent = 9;
    EXPECT_NE(refused(desc_of(parts)).find("desc.parts[2].parent is 9"), std::string::npos);
    parts[2].parent = FLG_NO_INDEX;
    parts[2].parent_joint = "body_0";
    EXPECT_NE(refused(desc_of(parts)).find("desc.parts[2].parent_joint needs a parent"), std::string::npos);
    parts[2].parent_joint = nullptr;
    FlgModelDesc desc = desc_of(parts);
    desc.root = 3;
    EXPECT_NE(refused(desc).find("desc.root is 3"), std::string::npos);
    desc.root = 1;
    EXPECT_NE(refused(desc).find("desc.root is leg, which has a parent"), std::string::npos) << flgErrorGetMessage();
}

// ---- Joints that last ----------------------------------------------------------------------------------------------

TEST_F(Hierarchy, DraggingALegAndBackKeepsJointsByName) {
    constexpr int steps = 100;
    constexpr double step = 0.015;
    std::vector<FlgModelPart> parts = {
        part("body", smooth(tube({{-3, 0, 0.9}, {-1, 0.2, 1.1}, {1, 0.1, 1.0}, {3, 0.4, 0.9}}))),
        part("leg", smooth(tube({{0, 0.2, 0.5}, {0, -1.2, 0.4}, {0.05, -2.6, 0.28}})))};
    for (const bool with_previous : {false, true}) {
        FlgModel model{};
        Skeleton first, before;
        uint32_t changes = 0;
        double largest = 0;
        for (int i = 0; i <= 2 * steps; ++i) {
            parts[1].placement[3] = -0.75 + step * (i <= steps ? i : 2 * steps - i);
            FlgModelDesc desc = desc_of(parts);
            if (with_previous) desc.previous = model;
            const FlgModel old = model;
            const Skeleton now = made(desc, &model);
            if (old.id != 0) {
                EXPECT_EQ(flgModelRelease(host.context, old), FLG_OK);
            }
            if (i == 0) first = now;
            if (i > 0 && now.graph() != before.graph()) ++changes;
            if (i > 0 && now.graph() == before.graph()) {
                for (const Joint& joint : now.joints) {
                    const Joint* was = before.find(joint.key);
                    ASSERT_TRUE(was);
                    largest = std::max(largest, std::hypot(joint.at[0] - was->at[0], joint.at[1] - was->at[1],
                                                           joint.at[2] - was->at[2]));
                }
            }
            before = now;
        }
        EXPECT_EQ(before.graph(), first.graph());
        for (const Joint& joint : first.joints) {
            ASSERT_TRUE(before.find(joint.key)) << joint.key;
            for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(before.find(joint.key)->at[k], joint.at[k], 1e-6);
        }
        EXPECT_LE(largest, 2 * step);
        // At most one joint of the body is passed each way: the leg comes to it and leaves it.
        EXPECT_LE(changes, 4u);
    }
}

TEST_F(Hierarchy, ARedrawnPartKeepsItsJointsByPlace) {
    const auto limb = [](double bend) {
        return smooth(tube({{0, 0, 0.5}, {2, 0.1, 0.45}, {4, bend, 0.35}, {6, 0, 0.4}, {8, -bend, 0.3}}));
    };
    std::vector<FlgModelPart> parts = {part("limb", limb(1))};
    FlgModel model{};
    const Skeleton first = made(desc_of(parts), &model);
    parts[0] = part("limb", limb(1.1));
    FlgModelDesc desc = desc_of(parts);
    desc.previous = model;
    const Skeleton second = made(desc);
    uint32_t same = 0;
    for (const Joint& joint : second.joints) {
        const Joint* was = first.find(joint.key);
        if (!was) continue;
        ++same;
        EXPECT_LE(std::hypot(joint.at[0] - was->at[0], joint.at[1] - was->at[1]), 0.06 * first.size) << joint.key;
    }
    EXPECT_GE(same + 1, first.joints.size());
}

// What a file kept of a model does for keys what the model itself does.
TEST_F(Hierarchy, KeysLastThroughAFile) {
    const auto drawn = [&](double turn) {
        std::vector<double> arm = smooth({{-0.3, 0}, {0, 0.3}, {2.2, 0.25}, {4.3, 0.1}, {4.3, -0.1}, {2.2, -0.25}});
        for (size_t i = 0; i < arm.size(); i += 2)
            std::tie(arm[i], arm[i + 1]) = std::pair(std::cos(turn) * arm[i] - std::sin(turn) * arm[i + 1],
                                                     std::sin(turn) * arm[i] + std::cos(turn) * arm[i + 1]);
        return std::vector{part("trunk", smooth({{-1, -2}, {1, -2}, {1.2, 2}, {-1.2, 2}})), part("arm", arm, 0.9, 1)};
    };
    const std::vector<FlgModelPart> first = drawn(0), turned = drawn(0.5);
    FlgModel before{};
    const Skeleton plain = made(desc_of(first), &before);
    FlgModelView kept = flgModelViewDefaults();
    ASSERT_EQ(flgModelGetView(host.context, before, &kept), FLG_OK);
    FlgModelDesc desc = desc_of(turned);
    desc.previous = before;
    const Skeleton by_model = made(desc);
    desc.previous = {};
    desc.previous_view = &kept;
    const Skeleton by_file = made(desc);
    ASSERT_EQ(by_file.joints.size(), by_model.joints.size());
    for (size_t j = 0; j < by_file.joints.size(); ++j) {
        EXPECT_EQ(by_file.joints[j].key, by_model.joints[j].key);
        const std::string& key = by_file.joints[j].key;
        EXPECT_TRUE(!key.starts_with("arm_") || plain.find(key)) << key;
    }
    // The hand has gone up by half of the arm's length and is still the hand.
    std::string hand;
    double farthest = 0;
    for (const Joint& joint : plain.joints)
        if (joint.at[0] > farthest) farthest = joint.at[0], hand = joint.key;
    ASSERT_NE(by_file.find(hand), nullptr) << hand;
    EXPECT_NEAR(by_file.find(hand)->at[1] - plain.find(hand)->at[1], std::sin(0.5) * (farthest - 0.9), 0.2);
}

TEST_F(Hierarchy, RefusesKeptJointsThatCantBe) {
    const std::vector<FlgModelPart> parts = {part("trunk", smooth({{-1, -2}, {1, -2}, {1.2, 2}, {-1.2, 2}}))};
    FlgModel before{};
    made(desc_of(parts), &before);
    FlgModelDesc desc = desc_of(parts);
    const char* keys[] = {"trunk_0", "trunk_1"};
    double places[] = {0, 0, 0, 0, 1, 0};
    uint32_t parents[] = {FLG_NO_INDEX, 0};
    FlgModelView kept = flgModelViewDefaults();
    desc.previous_view = &kept;
    kept.joint_count = 2;
    kept.joint_keys = keys;
    kept.joint_places = places;
    EXPECT_NE(refused(desc).find("desc.previous_view.joint_parents is null"), std::string::npos)
        << flgErrorGetMessage();
    kept.joint_parents = parents;
    parents[1] = 1;
    EXPECT_NE(refused(desc).find("desc.previous_view.joint_parents[1] is 1"), std::string::npos)
        << flgErrorGetMessage();
    parents[1] = 0;
    places[4] = NAN;
    EXPECT_NE(refused(desc).find("desc.previous_view.joint_places[1]"), std::string::npos) << flgErrorGetMessage();
    places[4] = 1;
    keys[0] = "";
    EXPECT_NE(refused(desc).find("desc.previous_view.joint_keys[0]"), std::string::npos) << flgErrorGetMessage();
    keys[0] = nullptr;
    EXPECT_NE(refused(desc).find("desc.previous_view.joint_keys[0]"), std::string::npos) << flgErrorGetMessage();
    keys[0] = "trunk_4000000000";
    EXPECT_GT(made(desc).joints.size(), 0u);
    keys[0] = "trunk_0";
    desc.previous = before;
    EXPECT_NE(refused(desc).find("desc.previous and desc.previous_view are both set"), std::string::npos)
        << flgErrorGetMessage();
}

TEST_F(Hierarchy, WhatIsSetAboutJointsStaysSet) {
    std::vector<FlgModelPart> parts = {
        part("body", smooth(tube({{-3, 0, 0.9}, {-1, 0.2, 1.1}, {1, 0.1, 1.0}, {3, 0.4, 0.9}}))),
        part("leg", smooth(tube({{2, 0.2, 0.5}, {2, -1.2, 0.4}, {2.05, -4.6, 0.28}})))};
    const size_t before = made(parts).joints.size();
    std::vector<FlgJointEdit> edits(4, flgJointEditDefaults());
    edits[0].joint = "leg_1";
    edits[0].at[0] = 2.1, edits[0].at[1] = -2;
    edits[1].kind = FLG_JOINT_EDIT_KIND_RENAME;
    edits[1].joint = "leg_1";
    edits[1].name = "knee";
    edits[2].kind = FLG_JOINT_EDIT_KIND_SPLIT;
    edits[2].joint = "leg_1";
    edits[2].name = "thigh";
    edits[2].share = 0.25;
    edits[3].joint = "leg_55";  // is made
    edits[3].at[0] = 2, edits[3].at[1] = -4;
    for (const double x : {0.0, -1.0, -3.5}) {
        parts[1].placement[3] = x;
        FlgModelDesc desc = desc_of(parts);
        desc.joint_edits = edits.data();
        desc.joint_edit_count = 4;
        const Skeleton skeleton = made(desc);
        const Joint* knee = skeleton.find("leg_1");
        ASSERT_TRUE(knee);
        EXPECT_EQ(knee->name, "knee");
        EXPECT_TRUE(knee->is_pinned);
        EXPECT_NEAR(knee->at[0], 2.1 + x, 1e-6);
        EXPECT_NEAR(knee->at[1], -2, 1e-6);
        ASSERT_TRUE(skeleton.find("thigh"));
        EXPECT_EQ(knee->parent, "thigh");
        EXPECT_FALSE(skeleton.find("thigh")->is_pinned);
        ASSERT_TRUE(skeleton.find("leg_55"));
        EXPECT_NEAR(skeleton.find("leg_55")->at[1], -4, 1e-6);
        EXPECT_EQ(skeleton.roots().size(), 1u);
        if (x == 0) {
            EXPECT_EQ(skeleton.joints.size(), before + 2);
        }
    }
    // Redrawn, thinner and with other bends.
    parts[1].part = host.part(smooth(tube({{2, 0.2, 0.4}, {2.1, -1.8, 0.35}, {2, -3, 0.3}, {2.05, -4.6, 0.28}})));
    FlgModelDesc desc = desc_of(parts);
    desc.joint_edits = edits.data();
    desc.joint_edit_count = 4;
    EXPECT_EQ(made(desc).find("leg_1")->name, "knee");
    edits[0] = flgJointEditDefaults();
    edits[0].kind = FLG_JOINT_EDIT_KIND_MERGE;
    edits[0].joint = "leg_1";
    desc.joint_edit_count = 1;
    const Skeleton merged = made(desc);
    EXPECT_FALSE(merged.find("leg_1"));
}

TEST_F(Hierarchy, EditsOfAMirroredPartMeanBothOrOne) {
    std::vector<FlgModelPart> parts = {
        part("body", smooth(tube({{-3, 0, 0.9}, {0, 0.2, 1.1}, {3, 0.4, 0.9}}))),
        part("leg", smooth(tube({{2, 0.2, 0.5}, {2, -1.2, 0.4}, {2.05, -4.6, 0.28}})), 0, 0, 0.6)};
    parts[1].mirrored = 1;
    FlgModelDesc desc = desc_of(parts);
    desc.mirror[0] = 0;
    desc.mirror[2] = 1;
    FlgJointEdit edit = flgJointEditDefaults();
    edit.kind = FLG_JOINT_EDIT_KIND_RENAME;
    edit.joint = "leg_1";
    edit.name = "knee";
    desc.joint_edits = &edit;
    desc.joint_edit_count = 1;
    Skeleton skeleton = made(desc);
    EXPECT_EQ(skeleton.find("leg_1.L")->name, "knee.L");
    EXPECT_EQ(skeleton.find("leg_1.R")->name, "knee.R");
    edit.joint = "leg_1.R";
    skeleton = made(desc);
    EXPECT_EQ(skeleton.find("leg_1.L")->name, "leg_1.L");
    EXPECT_EQ(skeleton.find("leg_1.R")->name, "knee");
}

TEST_F(Hierarchy, RefusesDepthsAndPairsThatCantBe) {
    std::vector<FlgModelPart> parts = {
        part("body", smooth(tube({{-3, 0, 0.9}, {-1, 0.2, 1.1}, {1, 0.1, 1.0}, {3, 0.4, 0.9}})))};
    FlgModelDesc desc = desc_of(parts);
    const auto expect = [&](const std::string& words) {
        EXPECT_NE(refused(desc).find(words), std::string::npos) << flgErrorGetMessage();
    };
    desc.apart_pair_count = 1;
    expect("desc.apart_pairs is null");
    const uint32_t pair[] = {0, 1};
    desc.apart_pairs = pair;
    expect("desc.apart_pairs[1] is 1");
    desc.apart_pair_count = 65536;
    expect("desc.apart_pair_count is 65536");
    desc.apart_pair_count = 0;
    parts[0].depth = INFINITY;
    expect("desc.parts[0].depth is inf");
}

TEST_F(Hierarchy, RefusesEditsThatCantBeAndKeepsTheLastModel) {
    const std::vector<FlgModelPart> parts = {
        part("body", smooth(tube({{-3, 0, 0.9}, {-1, 0.2, 1.1}, {1, 0.1, 1.0}, {3, 0.4, 0.9}})))};
    FlgModel good{};
    const Skeleton first = made(desc_of(parts), &good);
    FlgModelDesc desc = desc_of(parts);
    desc.previous = good;
    FlgJointEdit edit = flgJointEditDefaults();
    desc.joint_edits = &edit;
    desc.joint_edit_count = 1;
    const auto expect = [&](const std::string& words) {
        EXPECT_NE(refused(desc).find(words), std::string::npos) << flgErrorGetMessage();
    };
    expect("desc.joint_edits[0].joint is null");
    edit.joint = "body_0";
    edit.at[1] = 9;
    expect("desc.joint_edits[0] pins body_0 at (0, 9, 0), which is outside of its part body");
    edit.at[1] = 0.1;
    edit.at[2] = 5;
    expect("outside of its part body");
    edit.at[2] = 0;
    edit.at[0] = NAN;
    expect("desc.joint_edits[0].at is nan");
    edit = flgJointEditDefaults();
    const std::string root = first.roots()[0];
    edit.joint = root.c_str();
    edit.kind = FLG_JOINT_EDIT_KIND_MERGE;
    expect("which is a root");
    edit.kind = FLG_JOINT_EDIT_KIND_SPLIT;
    expect("desc.joint_edits[0].name is null");
    edit.name = "new";
    expect("which is a root");
    edit.kind = FLG_JOINT_EDIT_KIND_RENAME;
    const std::string other = first.joints.back().name;
    edit.name = other.c_str();
    expect("desc.joint_edits[0].name is \"" + other + "\", as that of another joint");
    edit.kind = static_cast<FlgJointEditKind>(9);
    expect("desc.joint_edits[0].kind is 9");
    FlgModelView view = flgModelViewDefaults();
    EXPECT_EQ(flgModelGetView(host.context, good, &view), FLG_OK);
    EXPECT_EQ(view.joint_count, first.joints.size());
}

}  // namespace
}  // namespace flg::test
