// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "inflation/closed_mesh.h"
#include "inflation/shapes.h"

namespace flg::test {
namespace {

ClosedMesh checked(const PartSurface& surface) {
    return check_closed(surface.positions, {surface.triangles.data(), surface.triangles.size()});
}

TEST(TwoSidedMesh, IsClosedAndTurnsOutwards) {
    const ClosedMesh ball = checked(surface_of(heights_of({ellipse(2, 3, 1, 1, 400)}, {.spacing = 0.04})));
    EXPECT_EQ(ball.fault, "");
    EXPECT_EQ(ball.euler, 2);
    EXPECT_NEAR(ball.volume, 4 * std::numbers::pi / 3, 0.04);
}

TEST(TwoSidedMesh, HolesGiveGenus) {
    const ClosedMesh ring =
        checked(surface_of(heights_of({ellipse(0, 0, 2, 2), ellipse(0.6, 0, 0.7, 0.7), ellipse(-1, 0.5, 0.4, 0.4)})));
    EXPECT_EQ(ring.fault, "");
    EXPECT_EQ(ring.euler, -2);
}

TEST(TwoSidedMesh, CornersAndNeedlesAreClosedToo) {
    for (const Rings& rings : {Rings{{{0, 0}, {1, 0}, {0, 1}}},
                               Rings{{{0, 0}, {10, 0}, {10, 0.01}, {5, 0.01}, {5, 5}, {4, 5}, {4, 0.01}, {0, 0.01}}}}) {
        const ClosedMesh mesh = checked(surface_of(heights_of(rings)));
        EXPECT_EQ(mesh.fault, "");
        EXPECT_EQ(mesh.euler, 2);
        EXPECT_GT(mesh.volume, 0);
    }
}

TEST(PartRaster, BallInsideAndOutside) {
    const InflatedPart part = part_of({ellipse(5, -3, 1, 1, 800)}, {.spacing = 0.08});
    double inside = 0, outside = 0;
    for (uint32_t y = 0; y < part.raster.height; ++y)
        for (uint32_t x = 0; x < part.raster.width; ++x) {
            const double u = part.raster.origin.x + x * part.raster.spacing - 5,
                         v = part.raster.origin.y + y * part.raster.spacing + 3;
            const double error = std::fabs(part.raster.at(x, y) - (1 - u * u - v * v));
            if (u * u + v * v < 1) inside = std::max(inside, error);
            if (std::hypot(u, v) < 1.2) outside = std::max(outside, error);
        }
    EXPECT_LT(inside, 0.003);
    EXPECT_LT(outside, 0.015);
}

// The sign is that of the side of the contour, and what is outside is as far as it should be.
TEST(PartRaster, SignsAndDistances) {
    const Rings rings = {ellipse(0, 0, 3, 1, 300), ellipse(1, 0, 0.5, 0.3, 60)};
    const InflatedPart part = part_of(rings);
    const Contour& contour = part.contour;
    for (uint32_t y = 0; y < part.raster.height; ++y)
        for (uint32_t x = 0; x < part.raster.width; ++x) {
            const Point2 p = {part.raster.origin.x + x * part.raster.spacing,
                              part.raster.origin.y + y * part.raster.spacing};
            bool inside = false;
            double nearest = 1e9;
            for (uint32_t i = 0; i < contour.size(); ++i) {
                const Point2 &a = contour.points[i], &b = contour.points[contour.next(i)];
                const double ex = b.x - a.x, ey = b.y - a.y;
                const double share = std::clamp(((p.x - a.x) * ex + (p.y - a.y) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
                nearest = std::min(nearest, std::hypot(p.x - a.x - share * ex, p.y - a.y - share * ey));
                if ((a.y < p.y) != (b.y < p.y) && p.x < a.x + ex * (p.y - a.y) / ey) inside = !inside;
            }
            const double value = part.raster.at(x, y);
            if (nearest > 0.02) {
                EXPECT_EQ(value > 0, inside) << p.x << " " << p.y;
            }
            if (!inside && nearest > 0.02) {
                EXPECT_LE(value, -0.9 * nearest * nearest);
                EXPECT_GE(value, -1.1 * nearest * (nearest + 6));
            }
        }
}

TEST(PartRaster, SameBitsWithPauses) {
    const Rings rings = {ellipse(0, 0, 3, 1, 300), ellipse(1, 0, 0.5, 0.3, 60)};
    const InflatedPart a = part_of(rings), b = part_of(rings, {}, true);
    EXPECT_TRUE(
        std::equal(a.raster.values.begin(), a.raster.values.end(), b.raster.values.begin(), b.raster.values.end()));
    const PartSurface one = surface_of(a), other = surface_of(b, true);
    EXPECT_TRUE(std::equal(one.positions.begin(), one.positions.end(), other.positions.begin(), other.positions.end()));
}

}  // namespace
}  // namespace flg::test
