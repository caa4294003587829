// SPDX-License-Identifier: MIT
#include "solids/solid_grid.h"

#include <gtest/gtest.h>

#include "solids/solid_meshes.h"

namespace flg::test {
namespace {

SolidFrame frame_of(const Mesh& mesh) {
    return run_now(test_memory(), [&](Pace& pace) { return find_solid_frame(pace, mesh); });
}

SolidGrid grid_of(const Mesh& mesh, uint32_t cells, bool haltingly = false) {
    return run_now(
        test_memory(), [&](Pace& pace) { return fill_solid(pace, mesh, frame_of(mesh), cells); }, haltingly);
}

double volume_of(const SolidGrid& grid) {
    double cells = 0;
    for (const uint8_t inside : grid.inside) cells += inside;
    return cells * grid.cell * grid.cell * grid.cell;
}

constexpr double ball_volume = 4.0 / 3 * std::numbers::pi;

TEST(SolidGrid, Ball) {
    Triangles ball;
    ball.add_ball({1, 2, 3}, 1);
    const RepairedTriangles mesh(ball);
    const SolidGrid grid = grid_of(mesh.mesh(), 200000);
    EXPECT_NEAR(volume_of(grid), ball_volume, 0.03 * ball_volume);
    for (uint32_t i = 0; i < grid.count(); ++i) {
        const double off = (grid.middle_of(i) - Vec3(1, 2, 3)).norm();
        if (off < 0.97) {
            EXPECT_TRUE(grid.inside[i]);
        }
        if (off > 1.03) {
            EXPECT_FALSE(grid.inside[i]);
        }
    }
}

TEST(SolidGrid, PiecesThatOverlapOrAreWoundInwardsAreInside) {
    Triangles balls;
    balls.add_ball({0, 0, 0}, 1);
    const size_t first = balls.corners.size();
    balls.add_ball({0.2, 0, 0}, 0.9);
    for (size_t i = first; i < balls.corners.size(); i += 3) std::swap(balls.corners[i], balls.corners[i + 1]);
    const RepairedTriangles mesh(balls);
    EXPECT_NEAR(volume_of(grid_of(mesh.mesh(), 200000)), ball_volume, 0.05 * ball_volume);
}

TEST(SolidGrid, HolesAreClosed) {
    Triangles ball;
    ball.add_ball({0, 0, 0}, 1);
    std::vector<uint32_t> kept;
    for (size_t i = 0; i < ball.corners.size(); i += 3)
        if (ball.at(ball.corners[i]).y() < 0.9) kept.insert(kept.end(), &ball.corners[i], &ball.corners[i] + 3);
    ASSERT_LT(kept.size(), ball.corners.size());
    ball.corners = kept;
    const RepairedTriangles mesh(ball);
    EXPECT_NEAR(volume_of(grid_of(mesh.mesh(), 100000)), ball_volume, 0.08 * ball_volume);
}

TEST(SolidGrid, SheetsAreInside) {
    Triangles sheet;
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) sheet.add(Vec3(x, y, 0));
    sheet.corners = {0, 1, 2, 0, 2, 3};
    const RepairedTriangles mesh(sheet);
    const SolidGrid grid = grid_of(mesh.mesh(), 10000);
    EXPECT_GT(volume_of(grid), 0.5 * grid.cell);
}

TEST(SolidGrid, DepthsAreDistancesToTheNearestCellOutside) {
    const RepairedTriangles mesh(solid_person());
    const SolidGrid grid = grid_of(mesh.mesh(), 6000);
    const Buffer<float> depths = run_now(test_memory(), [&](Pace& pace) { return solid_depths(pace, grid); });
    for (uint32_t i = 0; i < grid.count(); ++i) {
        if (!grid.inside[i]) {
            EXPECT_EQ(depths[i], 0);
            continue;
        }
        double least = HUGE_VAL;
        for (uint32_t k = 0; k < grid.count(); ++k)
            if (!grid.inside[k]) least = std::min(least, (grid.middle_of(i) - grid.middle_of(k)).norm() / grid.cell);
        EXPECT_NEAR(depths[i], least - 0.5, 1e-3);
    }
}

TEST(SolidGrid, MirrorPlanes) {
    const SolidFrame front = frame_of(RepairedTriangles(solid_person()).mesh());
    EXPECT_TRUE(front.is_mirrored);
    EXPECT_NEAR(front.axes.col(0).x(), 1, 1e-6);
    EXPECT_NEAR(front.middle.x(), 0, 1e-6);
    Triangles odd = solid_person();
    odd.add_tube({0.4, 0.2, 0.4}, 0.1, {0.9, 0.9, 0.6}, 0.2);
    EXPECT_FALSE(frame_of(RepairedTriangles(odd).mesh()).is_mirrored);
}

TEST(SolidGrid, TurnsWithTheMesh) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 0.5).normalized()).toRotationMatrix();
    const SolidFrame own = frame_of(RepairedTriangles(solid_person()).mesh()),
                     turned = frame_of(RepairedTriangles(solid_person().turned(turn)).mesh());
    EXPECT_TRUE(turned.is_mirrored);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(std::abs((turn * own.axes.col(k)).dot(turned.axes.col(k))), 1, 1e-5) << k;
    EXPECT_LT((turn * own.middle - turned.middle).norm(), 1e-5);
}

TEST(SolidGrid, PiecesAreJoinedAndCrumbsDropped) {
    Triangles pieces;
    pieces.add_ball({0, 0, 0}, 0.4);
    pieces.add_ball({1.2, 0, 0}, 0.3);
    pieces.add_ball({0, 1, 0}, 0.02);
    const RepairedTriangles mesh(pieces);
    SolidGrid grid = grid_of(mesh.mesh(), 100000);
    run_now(test_memory(), [&](Pace& pace) { return join_solid_pieces(pace, grid); });
    const auto inside_at = [&](const Vec3& at) {
        const Vec3 local = grid.local(at);
        return grid.inside[grid.number(static_cast<uint32_t>(local.x()), static_cast<uint32_t>(local.y()),
                                       static_cast<uint32_t>(local.z()))] != 0;
    };
    EXPECT_FALSE(inside_at({0, 1, 0}));
    bool joined = true;
    for (double x = 0; x < 1.2; x += grid.cell) {
        bool any = false;
        for (int i = -2; i <= 2; ++i)
            for (int k = -2; k <= 2; ++k) any = any || inside_at({x, i * grid.cell, k * grid.cell});
        joined = joined && any;
    }
    EXPECT_TRUE(joined);
}

TEST(SolidGrid, SameBitsWhereverItPauses) {
    const RepairedTriangles mesh(solid_animal());
    const SolidGrid whole = grid_of(mesh.mesh(), 20000), halting = grid_of(mesh.mesh(), 20000, true);
    ASSERT_EQ(whole.count(), halting.count());
    EXPECT_TRUE(std::equal(whole.inside.begin(), whole.inside.end(), halting.inside.begin()));
}

}  // namespace
}  // namespace flg::test
