// SPDX-License-Identifier: MIT
// Nearest points, where they are known; and numbers that tell meshes apart.
#include "surfaces/mesh/nearest_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

std::vector<Position> random_places(double least, double most) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> draw(least, most);
    std::vector<Position> places(300);
    for (Position& place : places) {
        for (float& coordinate : place) coordinate = static_cast<float>(draw(random));
    }
    return places;
}

SurfacePoint find(NearestPoints& nearest, const Position& place, uint32_t slice) {
    nearest.begin(place);
    while (!nearest.find(slice)) {}
    return nearest.found();
}

TEST(NearestPoints, OfASquareAreTheClampedOnes) {
    const Mesh mesh = make_mesh(plane(9, 0.3));
    for (const uint32_t slice : {1u, 1000u}) {
        NearestPoints nearest(mesh);
        run_now(
            test_memory(), [&](Pace& pace) { return build(pace, nearest); }, slice == 1);
        for (const Position& place : random_places(-1, 2)) {
            const SurfacePoint found = find(nearest, place, slice);
            const Vec3 at = position_of(mesh, found);
            EXPECT_NEAR(at.x(), std::clamp(place[0], 0.0f, 1.0f), 1e-6);
            EXPECT_NEAR(at.y(), std::clamp(place[1], 0.0f, 1.0f), 1e-6);
            EXPECT_NEAR(at.z(), 0, 1e-6);
            EXPECT_GE(found.u, 0);
            EXPECT_GE(found.v, 0);
            EXPECT_LE(found.u + found.v, 1);
        }
    }
}

// No vertex and no middle of an edge or a triangle is nearer, whichever triangle it is of; and the way to the point is
// upright on its triangle, where it lies inside.
TEST(NearestPoints, OfASphereAreNearerThanAllOthers) {
    const Mesh mesh = make_mesh(sphere(3));
    NearestPoints nearest(mesh);
    run_now(test_memory(), [&](Pace& pace) { return build(pace, nearest); });
    for (const Position& place : random_places(-1.5, 1.5)) {
        const SurfacePoint found = find(nearest, place, 64);
        const Vec3 from = load_vec3(place.data()), at = position_of(mesh, found);
        const double distance = (at - from).norm();
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            for (const auto& [u, v] : {std::pair{0.0f, 0.0f}, {0.5f, 0.0f}, {0.0f, 0.5f}, {0.5f, 0.5f}, {0.3f, 0.3f}}) {
                EXPECT_LE(distance, (position_of(mesh, {t, u, v}) - from).norm() + 1e-6);
            }
        }
        const double inside = std::min({found.u, found.v, 1 - found.u - found.v});
        if (inside < 1e-3) continue;
        const Vec3 a = position_of(mesh, {found.triangle, 0, 0});
        EXPECT_NEAR((at - from).dot(position_of(mesh, {found.triangle, 1, 0}) - a), 0, 1e-6);
        EXPECT_NEAR((at - from).dot(position_of(mesh, {found.triangle, 0, 1}) - a), 0, 1e-6);
    }
}

TEST(NearestPoints, OfTrianglesThatReachFarAndOfSomeWithoutArea) {
    // A long triangle whose middle is far from most of it, and one that is a line.
    const Mesh mesh = make_mesh(
        {{{-100, 0, 0}, {100, 0, 0}, {100, 1, 0}, {-99, 5, 0}, {-99, 6, 0}, {-99, 7, 0}}, {{0, 1, 2}, {3, 4, 5}}});
    NearestPoints nearest(mesh);
    run_now(test_memory(), [&](Pace& pace) { return build(pace, nearest); });
    EXPECT_EQ(find(nearest, {-99, 1, 0}, 10).triangle, 0u);
    const SurfacePoint on_line = find(nearest, {-98, 6.5f, 0}, 10);
    EXPECT_EQ(on_line.triangle, 1u);
    EXPECT_NEAR(position_of(mesh, on_line).y(), 6.5, 1e-5);
    EXPECT_EQ(find(nearest, {1e30f, -1e30f, 1e30f}, 10).triangle, 0u);
}

MeshFingerprint fingerprint_of(const Mesh& mesh, bool haltingly = false) {
    return run_now(
        test_memory(), [&](Pace& pace) { return take_fingerprint(pace, mesh); }, haltingly);
}

TEST(MeshFingerprint, TellsMeshesApartToTheBit) {
    Mesh mesh = make_mesh(sphere(2));
    const MeshFingerprint first = fingerprint_of(mesh);
    EXPECT_EQ(fingerprint_of(mesh, true).number, first.number);
    EXPECT_EQ(fingerprint_of(make_mesh(sphere(2))).number, first.number);
    std::set<uint64_t> numbers = {first.number};
    for (const uint32_t vertex : {0u, 1u, mesh.vertex_count() - 1}) {
        const Position before = mesh.positions[vertex];
        mesh.positions[vertex][2] = std::nextafter(before[2], 2.0f);
        EXPECT_TRUE(numbers.insert(fingerprint_of(mesh).number).second);
        mesh.positions[vertex] = before;
    }
    std::swap(mesh.triangles[3], mesh.triangles[4]);
    EXPECT_TRUE(numbers.insert(fingerprint_of(mesh).number).second);
    std::swap(mesh.triangles[3], mesh.triangles[4]);
    EXPECT_EQ(fingerprint_of(mesh).number, first.number);
}

TEST(MeshFingerprint, HasTheBox) {
    const MeshFingerprint fingerprint = fingerprint_of(make_mesh(plane(4)));
    EXPECT_EQ(fingerprint.lower, (Position{0, 0, 0}));
    EXPECT_EQ(fingerprint.upper, (Position{1, 1, 0}));
}

}  // namespace
}  // namespace flg::test
