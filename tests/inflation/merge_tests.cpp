// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/failure.h"
#include "core/random.h"
#include "inflation/closed_mesh.h"
#include "inflation/models.h"
#include "inflation/surface_extraction.h"

namespace flg::test {
namespace {

constexpr double pi = std::numbers::pi;

ClosedMesh checked(const MergedMesh& mesh) {
    return check_closed(mesh.positions, {mesh.triangles.data(), mesh.triangles.size()});
}

const Rings disc = {ellipse(0, 0, 1, 1, 400)};

TEST(Merge, OneBall) {
    Model model;
    model.add(disc, placement({1, 2, 3}, 0.5, 0.7, {1, 2, 3}));
    const MergedMesh mesh = merged(model);
    const ClosedMesh ball = checked(mesh);
    EXPECT_EQ(ball.fault, "");
    EXPECT_EQ(ball.euler, 2);
    EXPECT_NEAR(ball.volume, 4 * pi / 3 / 8, 0.002);
    EXPECT_GT(ball.min_angle, 15);
    EXPECT_GT(ball.mean_least_angle, 48);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 from = mesh.positions[i] - Vec3(1, 2, 3);
        EXPECT_NEAR(from.norm(), 0.5, 0.001);
        EXPECT_GT(mesh.normals[i].dot(from.normalized()), 0.999);
        EXPECT_NEAR(mesh.normals[i].norm(), 1, 1e-12);
    }
}

TEST(Merge, TwoBallsThatMeet) {
    Model model;
    model.add(disc, placement({-0.6, 0, 0}));
    model.add(disc, placement({0.6, 0, 0}, 1, 1.2));
    const ClosedMesh sharp = checked(merged(model, {.blend = 0})), round = checked(merged(model, {.blend = 0.4}));
    EXPECT_EQ(sharp.fault, "");
    EXPECT_EQ(sharp.euler, 2);
    EXPECT_EQ(sharp.components, 1u);
    const double d = 1.2, lens = pi * (4 + d) * (2 - d) * (2 - d) / 12;
    EXPECT_NEAR(sharp.volume, 8 * pi / 3 - lens, 0.01);
    EXPECT_EQ(round.fault, "");
    EXPECT_GT(round.volume, sharp.volume + 0.005);
    EXPECT_LT(round.volume, sharp.volume + 0.1);
}

// They overlap, and end half-way: two closed pieces with a gap in between.
TEST(Merge, PartsKeptApartTouchWithoutBecomingOne) {
    Model model;
    model.add(disc, placement({-0.6, 0, 0}));
    model.repeat(0, placement({0.6, 0, 0}));
    const uint32_t numbers[] = {0, 1};
    model.parts[0].apart_from = {numbers + 1, 1};
    model.parts[1].apart_from = {numbers, 1};
    const MergedMesh mesh = merged(model, {.vertices = 4000});
    const ClosedMesh both = checked(mesh);
    EXPECT_EQ(both.fault, "");
    EXPECT_EQ(both.euler, 4);
    EXPECT_EQ(both.components, 2u);
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        const double side = mesh.parts[i] == 0 ? -1 : 1;
        EXPECT_GT(side * mesh.positions[i].x(), 0.5 * mesh.spacing);
    }
}

// What they hang on holds them together, as a body does legs.
TEST(Merge, PartsKeptApartHangOnOthers) {
    Model model;
    model.add({ellipse(0, 0, 1.2, 0.7)}, placement({0, 0, 0}));
    model.add({capsule(0, 0, 0.3, 0, -1.5, 0.25)}, placement({0, -0.2, 0.2}), 0.75);
    model.repeat(1, placement({0, -0.2, -0.2}));
    const uint32_t numbers[] = {1, 2};
    model.parts[1].apart_from = {numbers + 1, 1};
    model.parts[2].apart_from = {numbers, 1};
    const MergedMesh mesh = merged(model, {.vertices = 6000});
    const ClosedMesh all = checked(mesh);
    EXPECT_EQ(all.fault, "");
    EXPECT_EQ(all.euler, 2) << "no leg is a handle";
    EXPECT_EQ(all.components, 1u);
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i].y() < -1) {
            EXPECT_GT(std::fabs(mesh.positions[i].z()), 0.5 * mesh.spacing);
        }
}

TEST(Merge, PartsApartAreAllKept) {
    Model model;
    model.add(disc, placement({-1.5, 0, 0}));
    model.add(disc, placement({1.5, 0, 0}));
    model.add(disc, placement({20, 5, 3}, 0.3));
    const MergedMesh mesh = merged(model);
    const ClosedMesh three = checked(mesh);
    EXPECT_EQ(three.fault, "");
    EXPECT_EQ(three.euler, 6);
    EXPECT_EQ(three.components, 3u);
    for (size_t i = 0; i < mesh.positions.size(); ++i)
        EXPECT_EQ(mesh.parts[i], mesh.positions[i].x() < 0 ? 0u : mesh.positions[i].x() < 5 ? 1u : 2u);
}

TEST(Merge, RingsKeepTheirHoles) {
    Model model;
    model.add({ellipse(0, 0, 1, 1), ellipse(0, 0, 0.5, 0.5)}, placement({0, 0, 0}, 1, 0.3, {1, 1, 0}));
    EXPECT_EQ(checked(merged(model)).fault, "");
    EXPECT_EQ(checked(merged(model)).euler, 0);
    model.add({ellipse(0, 0, 0.8, 0.8), ellipse(0, 0, 0.45, 0.45)}, placement({1.4, 0, 0}, 1, 1.5, {1, 0.2, 0}));
    const ClosedMesh two = checked(merged(model));
    EXPECT_EQ(two.fault, "");
}

TEST(Merge, PartsWithinPartsVanish) {
    Model model;
    model.add(disc, placement({0, 0, 0}));
    model.add(disc, placement({0.2, 0.1, 0}, 0.4));
    const MergedMesh mesh = merged(model);
    const ClosedMesh one = checked(mesh);
    EXPECT_EQ(one.fault, "");
    EXPECT_EQ(one.euler, 2);
    EXPECT_EQ(one.components, 1u);
    EXPECT_NEAR(one.volume, 4 * pi / 3, 0.02);
    for (const uint32_t part : mesh.parts) EXPECT_EQ(part, 0u);
}

TEST(Merge, CopiesInOnePlaceAreOne) {
    Model one, three;
    one.add({capsule(0, 0, 0.5, 2, 0.3, 0.3)}, placement({0, 0, 0}));
    three.add({capsule(0, 0, 0.5, 2, 0.3, 0.3)}, placement({0, 0, 0}));
    three.repeat(0, placement({0, 0, 0}));
    three.repeat(0, placement({0, 0, 0}));
    const MergedMesh a = merged(one), b = merged(three);
    EXPECT_EQ(checked(b).fault, "");
    EXPECT_EQ(checked(b).components, 1u);
    EXPECT_NEAR(checked(a).volume, checked(b).volume, 1e-3 * checked(a).volume);
}

TEST(Merge, MirroredPartsTurnOutwards) {
    Model model;
    model.add({capsule(0, 0, 0.5, 2, 0.3, 0.3)}, placement({0, 0, 0}, 1, 0, Vec3::UnitY(), true));
    const ClosedMesh mesh = checked(merged(model));
    EXPECT_EQ(mesh.fault, "");
    EXPECT_GT(mesh.volume, 1);
}

TEST(Merge, ThinPartsAreKept) {
    Model model;
    model.add(disc, placement({0, 0, 0}));
    model.add({{{-3, -0.03}, {3, -0.03}, {3, 0.03}, {-3, 0.03}}}, placement({0, 0.2, 0}));
    const MergedMesh mesh = merged(model);
    const ClosedMesh one = checked(mesh);
    EXPECT_EQ(one.fault, "");
    EXPECT_EQ(one.components, 1u);
    EXPECT_GT(mesh.positions.size(), 15000u);
    double reach = 0;
    for (const Vec3& p : mesh.positions) reach = std::max(reach, p.x());
    EXPECT_NEAR(reach, 3, 0.1);
    try {
        merged(model, {.max_vertices = 12000});
        FAIL();
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.result(), FLG_ERROR_LIMIT);
        EXPECT_EQ(std::string(failure.what()).substr(0, 29), "merge: part 1 is so thin, 0.0");
    }
}

TEST(Merge, AsManyVerticesAsAskedFor) {
    const Model model = animal();
    for (const uint32_t wanted : {5000u, 10000u, 30000u}) {
        const MergedMesh mesh = merged(model, {.vertices = wanted});
        const ClosedMesh closed = checked(mesh);
        EXPECT_EQ(closed.fault, "");
        EXPECT_EQ(closed.components, 1u);
        EXPECT_EQ(closed.euler, 2);
        EXPECT_NEAR(static_cast<double>(mesh.positions.size()), wanted, 0.15 * wanted);
        EXPECT_GT(closed.mean_least_angle, 47);
        std::vector<uint32_t> counts(model.parts.size());
        for (const uint32_t part : mesh.parts) ++counts[part];
        for (const uint32_t count : counts) EXPECT_GT(count, wanted / 200);
    }
}

// Turned and scaled, the surface is the same up to what the lattice does to it.
TEST(Merge, FollowsTheModel) {
    const Model model = animal();
    Model turned = animal();
    const Eigen::Matrix3d turn = 3 * Eigen::AngleAxisd(0.8, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
    const Vec3 shift(10, -4, 2);
    for (PlacedPart& part : turned.parts) {
        Eigen::Map<Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> m(part.placement.data());
        m = (turn * m).eval();
        m.col(3) += shift;
    }
    const MergedMesh a = merged(model), b = merged(turned);
    EXPECT_NEAR(checked(b).volume / checked(a).volume, 27, 0.03);
    EXPECT_NEAR(checked(b).area / checked(a).area, 9, 0.02);
    const PartUnion original =
        run_now(test_memory(), [&](Pace& pace) { return PartUnion::make(pace, model.parts, -1); });
    for (const Vec3& p : b.positions)
        EXPECT_LT(std::fabs(original.sample(turn.inverse() * (p - shift)).value), 0.05 * a.spacing);
}

// Small balls at the limit of the lattice, near each other everywhere: all cases of cells, and pairs of them.
TEST(Merge, ClosedWhateverTheParts) {
    for (uint64_t seed = 0; seed < 6; ++seed) {
        Model model;
        model.add({ellipse(0, 0, 1, 1, 24)}, placement({0, 0, 0}));
        for (uint32_t i = 1; i < 150; ++i)
            model.repeat(
                0, placement({10 * random_unit(seed, i, 0), 10 * random_unit(seed, i, 1), 10 * random_unit(seed, i, 2)},
                             1 + 0.3 * random_unit(seed, i, 3)));
        const MergedMesh mesh = merged(model, {.vertices = 100, .blend = seed % 2 == 0 ? 0.0 : -1.0});
        EXPECT_EQ(checked(mesh).fault, "") << seed;
        EXPECT_GT(checked(mesh).volume, 100);
    }
}

// A lattice that is far too coarse: faces that two sheets cross, also those where both belong to one sheet on either
// side.
TEST(SurfaceExtraction, ClosedOnAnyLattice) {
    Model model;
    model.add({ellipse(0, 0, 1, 1, 24)}, placement({0, 0, 0}));
    for (uint32_t i = 1; i < 400; ++i)
        model.repeat(0, placement({12 * random_unit(1, i, 0), 12 * random_unit(1, i, 1), 12 * random_unit(1, i, 2)}));
    const PartUnion parts = run_now(test_memory(), [&](Pace& pace) { return PartUnion::make(pace, model.parts, 0); });
    for (const double spacing : {0.8, 1.3, 1.9}) {
        const SurfaceGrid grid =
            run_now(test_memory(), [&](Pace& pace) { return SurfaceGrid::make(pace, parts, spacing); });
        const DualSurface surface = run_now(test_memory(), [&](Pace& pace) { return extract_surface(pace, grid); });
        EXPECT_EQ(check_closed(surface.positions, surface.triangles).fault, "") << spacing;
        EXPECT_GT(surface.positions.size(), grid.vertex_count() + 10) << "no doubled faces";
    }
}

// Thousands of parts, most of them apart, cost as much as their surface.
TEST(Merge, ManyParts) {
    Model model;
    model.add({ellipse(0, 0, 1, 1, 24)}, placement({0, 0, 0}));
    for (uint32_t i = 1; i < 2000; ++i) model.repeat(0, placement({1.6 * (i % 40), 4.0 * (i / 40), 0}));
    const MergedMesh mesh = merged(model, {.vertices = 60000});
    const ClosedMesh closed = checked(mesh);
    EXPECT_EQ(closed.fault, "");
    EXPECT_EQ(closed.components, 50u);
    EXPECT_EQ(closed.euler, 100);
}

TEST(Merge, SameBitsWithPauses) {
    const Model model = animal();
    const MergedMesh a = merged(model, {.vertices = 3000}), b = merged(model, {.vertices = 3000}, true);
    EXPECT_TRUE(std::equal(a.positions.begin(), a.positions.end(), b.positions.begin(), b.positions.end()));
    EXPECT_TRUE(std::equal(a.normals.begin(), a.normals.end(), b.normals.begin(), b.normals.end()));
    EXPECT_TRUE(std::equal(a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end()));
    EXPECT_TRUE(std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end()));
}

std::string refusal(const Model& model, const MergeOptions& options = {}) {
    try {
        merged(model, options);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "none";
}

TEST(Merge, BadInputIsRefused) {
    Model model;
    EXPECT_EQ(refusal(model), "merge: there are no parts");
    model.add(disc, placement({0, 0, 0}));
    EXPECT_EQ(refusal(model, {.vertices = 10}), "merge: 10 vertices asked for; a surface has 100 or more");
    model.repeat(0, placement({0, 0, 0}));
    const std::string sentence = "part 1: its placement is not a rotation, one scale above 0 and a translation";
    for (const auto& [entry, value] : {std::pair{0, 2.0}, {1, 0.5}, {3, std::nan("")}, {5, HUGE_VAL}}) {
        model.parts[1].placement = placement({0, 0, 0});
        model.parts[1].placement[entry] = value;
        EXPECT_EQ(refusal(model), sentence);
    }
    model.parts[1].placement = {};
    EXPECT_EQ(refusal(model), sentence);
    model.parts[1].placement = placement({0, 0, 0});
    model.parts[1].thickness = 0;
    EXPECT_EQ(refusal(model), "part 1: its thickness is 0, not above 0");
    model.parts[1].thickness = 1;
    model.parts[1].placement = placement({1e6, 0, 0});
    EXPECT_EQ(refusal(model).substr(0, 20), "parts: triangles of ");
}

}  // namespace
}  // namespace flg::test
