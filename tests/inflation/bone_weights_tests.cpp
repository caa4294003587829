// SPDX-License-Identifier: MIT
#include "inflation/bone_weights.h"

#include <gtest/gtest.h>

#include "core/failure.h"
#include "inflation/closed_mesh.h"
#include "inflation/models.h"
#include "reference/literal_bounded_biharmonic.h"

namespace flg::test {
namespace {

// A long capsule along x, with as many bones as asked for from -1.6 to 1.6.
Model bar(uint32_t bones) {
    Model model;
    model.add({capsule(-2, 0, 0.4, 2, 0, 0.4)}, placement({0, 0, 0}), 0.7071);
    std::vector<Vec3> points;
    for (uint32_t i = 0; i <= bones; ++i) points.emplace_back(-1.6 + 3.2 * i / bones, 0, 0);
    model.chain(points, 0.4);
    return model;
}

double weight_of(const BoneWeights& weights, size_t vertex, uint32_t joint) {
    double sum = 0;
    for (uint32_t k = 0; k < 4; ++k)
        if (weights.joints[vertex][k] == joint) sum += static_cast<double>(weights.weights[vertex][k]);
    return sum;
}

TEST(BoneWeights, WithinBoundsAndSumToOne) {
    const Model model = animal();
    const MergedMesh mesh = merged(model, {.vertices = 4000});
    for (const double reach : {0.05, 0.4, 2.0}) {
        const BoneWeights weights = weights_of(mesh, model, {.reach = reach});
        ASSERT_EQ(weights.weights.size(), mesh.positions.size());
        std::vector<double> most(model.bones.size());
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            double sum = 0;
            for (uint32_t k = 0; k < 4; ++k) {
                const double weight = static_cast<double>(weights.weights[i][k]);
                EXPECT_GE(weight, 0);
                EXPECT_LE(weight, 1);
                if (k > 0) {
                    EXPECT_LE(weight, static_cast<double>(weights.weights[i][k - 1]));
                }
                if (weight == 0) {
                    EXPECT_EQ(weights.joints[i][k], 0);
                }
                ASSERT_LT(weights.joints[i][k], model.bones.size());
                sum += weight;
                most[weights.joints[i][k]] = std::max(most[weights.joints[i][k]], weight);
            }
            EXPECT_NEAR(sum, 1, 1e-6);
        }
        if (reach <= 0.4) {
            for (const double weight : most) EXPECT_GT(weight, 0.5);
        }
    }
}

// Across the middle of a bar weights go from one bone to the other: steadily, and alike from both sides.
TEST(BoneWeights, BarOfTwoBones) {
    const Model model = bar(2);
    const MergedMesh mesh = merged(model, {.vertices = 3000});
    const BoneWeights weights = weights_of(mesh, model);
    constexpr int slices = 40;
    std::array<double, slices> sums{}, counts{};
    double spread = 0;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const double x = mesh.positions[i].x(), second = weight_of(weights, i, 1);
        const int slice = static_cast<int>((x + 2.4) / 4.8 * slices);
        sums[slice] += second;
        counts[slice] += 1;
        if (std::fabs(x) < 0.02) spread = std::max(spread, std::fabs(second - 0.5));
        if (x > 1.3) {
            EXPECT_EQ(second, 1);
        }
        if (x < -1.3) {
            EXPECT_EQ(second, 0);
        }
    }
    EXPECT_LT(spread, 0.06);
    for (int k = 0; k < slices; ++k) {
        const double mean = sums[k] / counts[k];
        EXPECT_NEAR(mean + sums[slices - 1 - k] / counts[slices - 1 - k], 1, 0.02);
        if (k > 0) {
            EXPECT_GE(mean, sums[k - 1] / counts[k - 1] - 1e-6);
        }
    }
}

TEST(BoneWeights, FarBonesHaveNone) {
    const Model model = bar(8);
    const MergedMesh mesh = merged(model, {.vertices = 3000});
    const BoneWeights weights = weights_of(mesh, model, {.reach = 0.15});
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        for (uint32_t joint = 0; joint < 8; ++joint) {
            const BoneSegment& bone = model.bones[joint];
            const double x = mesh.positions[i].x();
            const double away = std::max({bone.from.x() - x, x - bone.to.x(), 0.0});
            if (away > 0.6 && joint > 0 && joint < 7) {
                EXPECT_EQ(weight_of(weights, i, joint), 0) << x << " " << joint;
            }
        }
}

// Parts that are near each other in space and not along the surface keep to themselves.
TEST(BoneWeights, NeighboursInSpaceOnly) {
    Model model;
    model.add({capsule(-1, 0, 0.3, 1, 0, 0.3)}, placement({0, 0, 0}));
    model.chain({{-1, 0, 0}, {1, 0, 0}}, 0.3);
    model.repeat(0, placement({0, 0.75, 0}));
    model.chain({{-1, 0, 0}, {1, 0, 0}}, 0.3);
    const MergedMesh mesh = merged(model, {.vertices = 4000});
    const BoneWeights weights = weights_of(mesh, model);
    for (size_t i = 0; i < mesh.positions.size(); ++i) EXPECT_EQ(weight_of(weights, i, mesh.parts[i]), 1);
}

// A thin tail along a body, a gap away: most of the body's upper side is nearer to the tail's bones in space.
TEST(BoneWeights, GapsOfAContourAreWaysAround) {
    Model model;
    model.add({{{0, 0}, {10, 0}, {10, 4}, {1, 4}, {1, 4.4}, {12, 4.4}, {12, 5}, {0.5, 5}, {0, 4.5}}},
              placement({0, 0, 0}), 0.7);
    model.chain({{8, 2, 0}, {2, 2, 0}, {0.6, 4.2, 0}, {3, 4.7, 0}, {7, 4.7, 0}, {11.8, 4.7, 0}}, 0.3);
    const MergedMesh mesh = merged(model, {.vertices = 8000});
    const BoneWeights weights = weights_of(mesh, model);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3& at = mesh.positions[i];
        double tail = 0;
        for (const uint32_t joint : {2u, 3u, 4u}) tail += weight_of(weights, i, joint);
        if (at.x() > 6 && at.y() < 4.2) {
            EXPECT_LT(tail, 0.02) << at.transpose();
        }
        if (at.x() > 6 && at.y() > 4.2) {
            EXPECT_GT(tail, 0.98) << at.transpose();
        }
    }
}

TEST(BoneWeights, PartsWithoutBonesTakeTheNearest) {
    Model model = bar(2);
    model.add({ellipse(0, 0, 0.5, 0.5)}, placement({-2, 0.4, 0}));
    const MergedMesh mesh = merged(model, {.vertices = 2000});
    const BoneWeights weights = weights_of(mesh, model);
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.parts[i] == 1) {
            EXPECT_EQ(weight_of(weights, i, 0), 1);
        }
}

TEST(BoneWeights, MirroredModelsHaveMirroredWeights) {
    Model model;
    model.add({ellipse(0, 0, 1.2, 0.6)}, placement({0, 0, 0}));
    model.chain({{0, 0, 0}, {-0.8, 0, 0}}, 0.5);
    model.chain({{0, 0, 0}, {0.8, 0, 0}}, 0.5);
    const Rings leg = {capsule(0, 0, 0.2, 0.1, -1, 0.14)};
    const std::vector<Vec3> points = {{0, 0, 0}, {0.05, -0.5, 0}, {0.1, -1, 0}};
    model.add(leg, placement({0.7, -0.3, 0}));
    model.chain(points, 0.17);
    model.repeat(1, placement({-0.7, -0.3, 0}, 1, 0, Vec3::UnitY(), true));
    model.chain(points, 0.17);
    model.joint_parents.clear();  // a tree would begin on one side
    const uint32_t twin[] = {1, 0, 4, 5, 2, 3};
    const MergedMesh mesh = merged(model, {.vertices = 3000});
    const BoneWeights weights = weights_of(mesh, model);
    double furthest = 0, largest = 0, sum = 0;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 image(-mesh.positions[i].x(), mesh.positions[i].y(), mesh.positions[i].z());
        size_t nearest = 0;
        for (size_t j = 0; j < mesh.positions.size(); ++j)
            if ((mesh.positions[j] - image).squaredNorm() < (mesh.positions[nearest] - image).squaredNorm())
                nearest = j;
        furthest = std::max(furthest, (mesh.positions[nearest] - image).norm());
        for (uint32_t joint = 0; joint < 6; ++joint) {
            const double difference =
                std::fabs(weight_of(weights, i, joint) - weight_of(weights, nearest, twin[joint]));
            largest = std::max(largest, difference);
            sum += difference;
        }
    }
    // Vertices are not mirrored one by one.
    EXPECT_LT(furthest, mesh.spacing);
    EXPECT_LT(largest, 0.15);
    EXPECT_LT(sum / static_cast<double>(mesh.positions.size()), 0.01);
}

struct Compared {
    double ours = 0, biharmonic = 0, nearest = 0;  // energies, all bones
    double difference = 0;                         // largest, between the first two
    double at_handles = 0;                         // how much ours differ from 0 or 1 there, at most
};

// Bounded biharmonic weights with the middle of each bone as its handle.
Compared compare(const Model& model, double reach) {
    const MergedMesh mesh = merged(model, {.vertices = 400});
    reference::BiharmonicMesh same;
    same.positions.assign(mesh.positions.begin(), mesh.positions.end());
    same.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
    const auto n = static_cast<Eigen::Index>(mesh.positions.size());
    const auto bones = static_cast<int>(model.bones.size());
    const BoneWeights weights = weights_of(mesh, model, {.reach = reach});
    std::vector<int> handle(mesh.positions.size(), -1);
    Eigen::MatrixXd ours(n, bones), nearest = Eigen::MatrixXd::Zero(n, bones);
    for (Eigen::Index i = 0; i < n; ++i) {
        double least = 1e9;
        int own = 0;
        for (int k = 0; k < bones; ++k) {
            ours(i, k) = weight_of(weights, static_cast<size_t>(i), static_cast<uint32_t>(k));
            const BoneSegment& bone = model.bones[static_cast<size_t>(k)];
            if (bone.part != mesh.parts[static_cast<size_t>(i)]) continue;
            const Vec3 along = bone.to - bone.from, from = mesh.positions[static_cast<size_t>(i)] - bone.from;
            const double share = from.dot(along) / along.squaredNorm();
            if (std::fabs(share - 0.5) < 0.1) handle[static_cast<size_t>(i)] = k;
            const double distance = (from - std::clamp(share, 0.0, 1.0) * along).norm();
            if (distance < least) {
                least = distance;
                own = k;
            }
        }
        nearest(i, own) = 1;
    }
    const Eigen::MatrixXd biharmonic = reference::literal_bounded_biharmonic(same, handle, bones);
    const Eigen::MatrixXd energy = reference::biharmonic_energy(same);
    double at_handles = 0;
    for (Eigen::Index i = 0; i < n; ++i)
        if (handle[static_cast<size_t>(i)] >= 0)
            at_handles = std::max(at_handles, 1 - ours(i, handle[static_cast<size_t>(i)]));
    const auto of = [&](const Eigen::MatrixXd& w) { return (w.transpose() * energy * w).trace(); };
    return {of(ours), of(biharmonic), of(nearest), (ours - biharmonic).cwiseAbs().maxCoeff(), at_handles};
}

// Where they are as steep, they are as smooth, and nearly the same.
TEST(BoneWeights, AboutAsSmoothAsBoundedBiharmonicOnes) {
    const Compared two = compare(bar(2), 0.35);
    EXPECT_GT(two.biharmonic, 0);
    EXPECT_LT(two.ours, 1.3 * two.biharmonic);
    EXPECT_LT(100 * two.ours, two.nearest);
    EXPECT_LT(two.difference, 0.06);
    EXPECT_LT(two.at_handles, 0.04);
}

TEST(BoneWeights, AsSmoothAcrossParts) {
    Model model;
    model.add({ellipse(0, 0, 1.2, 0.6)}, placement({0, 0, 0}));
    model.chain({{-0.9, 0, 0}, {0.9, 0, 0}}, 0.6);
    model.add({capsule(0, 0, 0.3, 0, -1.3, 0.25)}, placement({0.4, -0.2, 0}));
    model.chain({{0, 0, 0}, {0, -1.3, 0}}, 0.3);
    const Compared two = compare(model, 0.4);
    EXPECT_LT(two.ours, 2 * two.biharmonic);
    EXPECT_LT(20 * two.ours, two.nearest);
}

TEST(BoneWeights, SameBitsWithPauses) {
    const Model model = animal();
    const MergedMesh mesh = merged(model, {.vertices = 2000});
    const BoneWeights a = weights_of(mesh, model), b = weights_of(mesh, model, {}, true);
    EXPECT_TRUE(std::equal(a.weights.begin(), a.weights.end(), b.weights.begin(), b.weights.end()));
    EXPECT_TRUE(std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end()));
}

std::string refusal(const MergedMesh& mesh, const Model& model, const std::vector<BoneSegment>& bones,
                    const BoneWeightOptions& options = {}) {
    try {
        made([&](Pace& pace) { return bone_weights(pace, mesh, model.parts, {bones}, options); }, false);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "none";
}

TEST(BoneWeights, BadInputIsRefused) {
    const Model model = bar(2);
    const MergedMesh mesh = merged(model, {.vertices = 200});
    EXPECT_EQ(refusal(mesh, model, {}), "weights: there are no bones");
    EXPECT_EQ(refusal(mesh, model, model.bones, {.reach = 3}), "weights: reach is 3; it is within 0.05 and 2");
    auto bones = model.bones;
    bones[1].joint = 65536;
    EXPECT_EQ(refusal(mesh, model, bones), "weights: bone 1 belongs to joint 65536; there are at most 65536");
    bones = model.bones;
    bones[0].to.y() = std::nan("");
    EXPECT_EQ(refusal(mesh, model, bones), "weights: bone 0 has an end or a radius that is not finite, or below 0");
    bones = model.bones;
    bones[1].to_radius = -1;
    EXPECT_EQ(refusal(mesh, model, bones), "weights: bone 1 has an end or a radius that is not finite, or below 0");
}

}  // namespace
}  // namespace flg::test
