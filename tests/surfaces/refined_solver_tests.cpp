// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/refined_solver.h"

#include <gtest/gtest.h>

#include "reference/literal_geodesics.h"
#include "surfaces/geodesics.h"

namespace flg::test {
namespace {

constexpr double pi = std::numbers::pi;

Soup both(Soup a, const Soup& b) {
    const uint32_t offset = static_cast<uint32_t>(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const Triple& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

Soup moved(Soup soup, const Eigen::Affine3d& motion) {
    for (Position& p : soup.positions) p = to_position(motion * load_vec3(p.data()));
    return soup;
}

// Flat meshes have no curvature to be wrong about: what remains is where no triangle lets the straight way through.
// Distances from a vertex on what is left of a soup once vertices without triangles are taken out.
std::vector<float> distances_of_used(const Soup& soup, uint32_t source) {
    std::vector<uint32_t> number(soup.positions.size(), no_index);
    Soup used;
    for (const Triple& triangle : soup.triangles) {
        Triple& moved = used.triangles.emplace_back();
        for (uint32_t k = 0; k < 3; ++k) {
            uint32_t& vertex = number[triangle[k]];
            if (vertex == no_index) {
                vertex = static_cast<uint32_t>(used.positions.size());
                used.positions.push_back(soup.positions[triangle[k]]);
            }
            moved[k] = vertex;
        }
    }
    const auto distances = Geodesics(make_mesh(used)).distances({{number[source], 0, 0}});
    std::vector<float> result(number.size(), unreachable);
    for (size_t v = 0; v < number.size(); ++v) {
        if (number[v] != no_index) result[v] = distances[number[v]];
    }
    return result;
}

literal::GeodesicGraph edges_alone(const Mesh& mesh) {
    literal::GeodesicGraph graph(mesh.vertex_count());
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            const auto length = static_cast<float>((mesh.position(a) - mesh.position(b)).norm());
            graph[a].push_back({b, length});
            graph[b].push_back({a, length});
        }
    }
    return graph;
}

TEST(RefinedSolver, FindsStraightLinesInThePlane) {
    const Mesh mesh = make_mesh(plane(100, 0.3));
    for (uint32_t source : {51u * 50u, 0u}) {
        const auto distances = Geodesics(mesh).distances({{source, 0, 0}});
        const auto expected = [&](uint32_t v) { return (mesh.position(v) - mesh.position(source)).norm(); };
        EXPECT_LT(rms_error(distances, expected), 0.0003);
    }
}

// The polyhedron's own distances are off by (edge / radius)^2 / 24, here 0.0015 %; the wave's curvature is carried on
// to the second order.
TEST(RefinedSolver, FindsGreatCirclesOnTheSphere) {
    const Mesh mesh = make_mesh(sphere(6));
    const auto distances = Geodesics(mesh).distances({{0, 0, 0}});
    const auto expected = [&](uint32_t v) {
        const Vec3 a = mesh.position(0), b = mesh.position(v);
        return std::atan2(a.cross(b).norm(), a.dot(b));
    };
    EXPECT_LT(rms_error(distances, expected), 0.0001);
}

// There the front closes in on a point: only as hollow a one tells how far it still is.
TEST(RefinedSolver, MeetsOppositeToTheSource) {
    const Mesh mesh = make_mesh(sphere(4));
    const auto distances = Geodesics(mesh).distances({{0, 0, 0}});
    for (uint32_t v = 1; v < mesh.vertex_count(); ++v) {
        const Vec3 a = mesh.position(0), b = mesh.position(v);
        EXPECT_NEAR(distances[v], std::atan2(a.cross(b).norm(), a.dot(b)), 0.004);
    }
}

// A line that leads through faces, aslant: its front is straight, and nearly exact on the plane.
TEST(RefinedSolver, KeepsStraightFrontsStraight) {
    const Mesh mesh = make_mesh(plane(60, 0.2));
    const Vec3 place(0.5, 0.503, 0), normal(-std::sin(0.3), std::cos(0.3), 0);
    const auto away = [&](uint32_t v) { return (mesh.position(v) - place).dot(normal); };
    const RegionSet everywhere(test_memory());
    const Geodesics geodesics(mesh);
    GeodesicSeeds seeds(mesh, mesh.positions, everywhere, test_memory(), &geodesics.blocks.flipped);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        std::vector<SurfacePoint> crossings;
        for (uint32_t k = 0; k < 3; ++k) {
            const double from = away(mesh.triangles[t][k]), to = away(mesh.triangles[t][(k + 1) % 3]);
            if (from * to >= 0) continue;
            std::array<float, 3> weights = {0, 0, 0};
            weights[(k + 1) % 3] = static_cast<float>(from / (from - to));
            weights[k] = 1 - weights[(k + 1) % 3];
            crossings.push_back({t, weights[1], weights[2]});
        }
        constexpr auto joint = GeodesicSeeds::End::joint;
        if (crossings.size() == 2) seeds.add_segment(crossings[0], crossings[1], {joint, joint}, 0);
    }
    const auto distances = geodesics.distances(merged(seeds));
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 p = mesh.position(v);
        // What is upright above one of the line's ends.
        if ((p - Vec3(0.5, 0.5, 0)).cwiseAbs().maxCoeff() > 0.3) continue;
        EXPECT_NEAR(distances[v], std::abs(away(v)), 0.1 / 60);
    }
}

// In the plane and on the sphere the distance from some points is the least of those from each. What is left of the
// error is within two edges of where fronts meet: both ends of an edge rarely tell both fronts.
double front_error(Geodesics& geodesics, const std::vector<Seed>& seeds) {
    std::vector<float> least(geodesics.blocks.vertex_count(), unreachable);
    for (const Seed& seed : seeds) {
        const auto alone = geodesics.distances({seed});
        for (size_t v = 0; v < least.size(); ++v) least[v] = std::min(least[v], alone[v]);
    }
    return rms_error(geodesics.distances(seeds), [&](uint32_t v) { return least[v]; });
}

// Unfolded together, without a look at whose fronts the ends of an edge have, the errors would be 0.0011, 0.005, 0.008
// and 0.012.
TEST(RefinedSolver, KeepsFrontsApartWhereTheyMeet) {
    const auto some = [](uint32_t vertex_count, uint32_t count) {
        std::vector<Seed> seeds;
        for (uint32_t i = 0; i < count; ++i) seeds.push_back({random_below(77, i, 0, vertex_count), 0, i});
        return seeds;
    };
    Geodesics even(make_mesh(plane(60))), uneven(make_mesh(plane(60, 0.3))), round(make_mesh(sphere(4)));
    EXPECT_LT(front_error(even, {{61 * 20 + 15, 0, 0}, {61 * 40 + 45, 0, 1}}), 0.0002);
    EXPECT_LT(front_error(even, some(even.blocks.vertex_count(), 9)), 0.001);
    EXPECT_LT(front_error(uneven, some(uneven.blocks.vertex_count(), 9)), 0.002);
    EXPECT_LT(front_error(round, some(round.blocks.vertex_count(), 60)), 0.0025);
}

// A prism of 200 sides unrolls to a plane whose width is 200 chords.
TEST(RefinedSolver, FindsHelicesOnTheCylinder) {
    const uint32_t around = 200, up = 60;
    const Mesh mesh = make_mesh(cylinder(around, up));
    const uint32_t source = around * (up / 2);
    const auto distances = Geodesics(mesh).distances({{source, 0, 0}});
    const double chord = 2 * std::sin(pi / around);
    const auto expected = [&](uint32_t v) {
        const uint32_t column = v % around, steps = std::min(column, around - column);
        return std::hypot(chord * steps, mesh.position(v).z() - mesh.position(source).z());
    };
    EXPECT_LT(rms_error(distances, expected), 0.0005);
}

// A bumpy torus has saddles, caps and shadows behind them.
TEST(RefinedSolver, ComesNearToExactDistances) {
    Soup soup = torus(70, 40);
    for (Position& p : soup.positions) {
        const Vec3 v = load_vec3(p.data());
        p = to_position(v * (1 + 0.05 * std::sin(5 * v.x()) * std::sin(4 * v.y() + 1) + 0.05 * std::sin(6 * v.z())));
    }
    const Mesh mesh = make_mesh(soup);
    for (uint32_t source : {0u, 1111u}) {
        const auto exact = literal::exact_distances(mesh, source);
        const auto distances = Geodesics(mesh).distances({{source, 0, 0}});
        EXPECT_LT(rms_error(distances, [&](uint32_t v) { return exact[v]; }), 0.005);
    }
}

// Angles of a rough mesh lack much of a full turn here and have too much of it there. Without a bound for what they
// make of the wave the error would be 0.0048; without curvature, 0.0044.
TEST(RefinedSolver, IsNotLedAstrayByRoughness) {
    Soup soup = plane(40, 0.45);
    for (uint32_t v = 0; v < soup.positions.size(); ++v) {
        for (uint32_t axis = 0; axis < 3; ++axis) {
            soup.positions[v][axis] += static_cast<float>(0.01 * (random_unit(5, v, axis) - 0.5));
        }
    }
    const Mesh mesh = make_mesh(soup);
    const auto exact = literal::exact_distances(mesh, 0);
    const auto distances = Geodesics(mesh).distances({{0, 0, 0}});
    EXPECT_LT(rms_error(distances, [&](uint32_t v) { return exact[v]; }), 0.0035);
}

// Behind bumps of a few edges fronts close in, and other ways are soon shorter. If fronts went on as hollow as either
// end of an edge tells, the error would be 0.0029.
TEST(RefinedSolver, IsNotLedAstrayBehindBumps) {
    Soup soup = plane(50);
    for (Position& p : soup.positions) {
        p[2] = static_cast<float>(0.8 / 60 * std::sin(60.0 * p[0]) * std::sin(60.0 * p[1]));
    }
    const Mesh mesh = make_mesh(soup);
    const auto exact = literal::exact_distances(mesh, 0);
    const auto distances = Geodesics(mesh).distances({{0, 0, 0}});
    EXPECT_LT(rms_error(distances, [&](uint32_t v) { return exact[v]; }), 0.0027);
}

TEST(RefinedSolver, DoesNotDependOnSlicesOrRegisters) {
    const Mesh mesh = make_mesh(torus(60, 40));
    Geodesics geodesics(mesh), sliced(mesh, true);
    const auto whole = geodesics.distances({{7, 0, 0}});
    EXPECT_EQ(sliced.distances({{7, 0, 0}}, {}, true), whole);

    std::vector<WaveStepFunction> others = {choose_wave_step()};
#ifdef FLG_WAVE_STEP_DISPATCH
    if (__builtin_cpu_supports("avx2")) others.push_back(wave_step_avx2);
#endif
    std::vector<WaveState> states(geodesics.blocks.rank_count());
    for (uint32_t rank = 1; rank < states.size(); ++rank) {
        states[rank] = {whole[geodesics.blocks.vertex_of_rank[rank]] * (rank % 3 == 0 ? 1.5f : 1.0f), 0.1f};
    }
    states[0] = {-unreachable, 0};
    const auto vertex = [&](uint32_t rank) { return WaveVertex{&geodesics.blocks.blocks[rank], states[rank]}; };
    for (uint32_t rank = 1; rank + wave_step_vertices <= states.size(); ++rank) {
        WaveStep expected;
        const WaveVertex alone = vertex(rank);
        wave_step_portable(&alone, 1, states.data(), 10, true, expected);
        for (const WaveStepFunction other : others) {
            for (uint32_t count = 1; count <= wave_step_vertices; ++count) {
                // Whichever vertices it is taken with, and as whichever of them.
                const uint32_t place = rank % count;
                std::vector<WaveVertex> some;
                for (uint32_t i = 0; i < count; ++i) some.push_back(vertex(i == place ? rank : 1 + i));
                WaveStep step;
                other(some.data(), count, states.data(), 10, true, step);
                const auto bits = [&](uint32_t mask) { return mask >> place * lane_count & 0xff; };
                ASSERT_EQ(bits(step.improved), expected.improved);
                ASSERT_EQ(uint64_t{step.improved} >> count * lane_count, 0u);
                ASSERT_EQ(bits(step.across_next) & expected.improved, expected.across_next & expected.improved);
                ASSERT_EQ(bits(step.across_previous) & expected.improved, expected.across_previous & expected.improved);
                for (uint32_t lane = 0; lane < lane_count; ++lane) {
                    if (some[place].block->rank(lane) == nowhere) continue;
                    const uint32_t at = place * lane_count + lane;
                    ASSERT_EQ(step.distances[at], expected.distances[lane]);
                    ASSERT_EQ(step.fronts[at], expected.fronts[lane]);
                    ASSERT_EQ(step.sides[at], expected.sides[lane]);
                }
            }
        }
    }
}

TEST(RefinedSolver, IsNearlySymmetricAndKeepsTheTriangleInequality) {
    const Mesh mesh = make_mesh(torus(60, 40));
    Geodesics geodesics(mesh);
    const std::vector<uint32_t> points = {3, 500, 1200, 2300, 777};
    std::vector<std::vector<float>> fields;
    for (uint32_t point : points) fields.push_back(geodesics.distances({{point, 0, 0}}));
    const double tolerance = 0.002;  // the solver's error on this mesh
    for (size_t a = 0; a < points.size(); ++a) {
        for (size_t b = 0; b < points.size(); ++b) {
            EXPECT_NEAR(fields[a][points[b]], fields[b][points[a]], tolerance * fields[a][points[b]]);
            for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
                EXPECT_LE(fields[a][v], (fields[a][points[b]] + fields[b][v]) * (1 + tolerance));
            }
        }
    }
}

TEST(RefinedSolver, ScalesAndTurnsWithTheMesh) {
    const Soup soup = torus(60, 40);
    const auto distances = Geodesics(make_mesh(soup)).distances({{7, 0, 0}});
    // Powers of two change no digit.
    const Eigen::Affine3d scale(Eigen::Scaling(1024.0));
    const auto scaled = Geodesics(make_mesh(moved(soup, scale))).distances({{7, 0, 0}});
    const Eigen::Affine3d turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
    const auto turned = Geodesics(make_mesh(moved(soup, turn))).distances({{7, 0, 0}});
    for (size_t v = 0; v < distances.size(); ++v) {
        EXPECT_EQ(scaled[v], 1024 * distances[v]);
        EXPECT_NEAR(turned[v], distances[v], 1e-3 * distances[v]);
    }
}

TEST(RefinedSolver, StopsEarlyWithTheSameDistances) {
    const Mesh mesh = make_mesh(torus(60, 40));
    Geodesics geodesics(mesh);
    const auto whole = geodesics.distances({{7, 0, 0}});
    SolveLimits near;
    near.distance = 0.5f;
    const auto within = geodesics.distances({{7, 0, 0}}, near);
    for (size_t v = 0; v < whole.size(); ++v) EXPECT_EQ(within[v], whole[v] <= 0.5f ? whole[v] : unreachable);

    SolveLimits to_targets;
    to_targets.targets = {100, 400};
    const auto targets = geodesics.distances({{7, 0, 0}}, to_targets);
    const float furthest = std::max(whole[100], whole[400]);
    uint32_t left = 0;
    for (size_t v = 0; v < whole.size(); ++v) {
        if (whole[v] <= furthest) {
            EXPECT_EQ(targets[v], whole[v]);
        }
        left += targets[v] == unreachable;
    }
    EXPECT_GT(left, whole.size() / 4);
}

TEST(RefinedSolver, LabelsTheNearestSource) {
    const Mesh mesh = make_mesh(sphere(4));
    Geodesics geodesics(mesh);
    const std::vector<Seed> seeds = {{5, 0, 50}, {300, 0, 60}, {2000, 0, 70}};
    RefinedSolver solver(geodesics.blocks, test_memory());
    const SolveLimits limits;
    solve(solver, seeds, limits, true);
    std::vector<std::vector<float>> alone;
    for (const Seed& seed : seeds) alone.push_back(geodesics.distances({seed}));
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        for (size_t other = 0; other < seeds.size(); ++other) {
            // Where two are as near as the mesh can tell either is right.
            const size_t label = (solver.label(v) - 50) / 10;
            ASSERT_LT(label, seeds.size());
            EXPECT_LT(alone[label][v], alone[other][v] + 0.08f);
        }
    }
}

TEST(RefinedSolver, ExtendsAFieldBySources) {
    const Mesh mesh = make_mesh(torus(60, 40));
    Geodesics geodesics(mesh);
    RefinedSolver solver(geodesics.blocks, test_memory());
    const SolveLimits limits;
    const std::vector<Seed> first = {{7, 0, 0}}, second = {{1300, 0, 1}};
    solve(solver, first, limits);
    run_now(test_memory(), [&](Pace& pace) { return extend_distances(pace, solver, second, limits); });
    const auto together = geodesics.distances({{7, 0, 0}, {1300, 0, 1}});
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) EXPECT_NEAR(solver.distance(v), together[v], 0.01);
}

TEST(RefinedSolver, IsAsGoodAsNewAfterAnotherField) {
    const Mesh mesh = make_mesh(torus(60, 40));
    Geodesics geodesics(mesh);
    RefinedSolver solver(geodesics.blocks, test_memory());
    const SolveLimits unlimited;
    SolveLimits near;
    near.distance = 0.3f;
    const auto again = [&](const std::vector<Seed>& seeds, const SolveLimits& limits) {
        solve(solver, seeds, limits);
        const auto fresh = geodesics.distances(seeds, limits);
        EXPECT_EQ(read(solver), fresh);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(solver.distance(v), fresh[v]);
    };
    again({{7, 0, 0}}, near);
    again({{1300, 0, 0}}, unlimited);
    again({{7, 0, 0}, {900, 0, 0}}, near);
    again({}, unlimited);
}

TEST(RefinedSolver, CostsWhatItTouches) {
    const Mesh mesh = make_mesh(plane(300));
    Geodesics geodesics(mesh);
    RefinedSolver solver(geodesics.blocks, test_memory());
    SolveLimits near;
    near.distance = 0.02f;
    const std::vector<Seed> seeds = {{mesh.vertex_count() / 3, 0, 0}};
    // A slice is 100 vertices, or 256 pages of which hardly any was touched.
    uint32_t slices = 0;
    for (int round = 0; round < 2; ++round) {
        slices = 0;
        run_haltingly(
            test_memory(), [&](Pace& pace) { return solve_distances(pace, solver, seeds, near, false); },
            [&](const auto& slice) {
                slice();
                ++slices;
            });
    }
    uint32_t pages = 0;
    for (uint32_t p = 0; p < solver.page_count(); ++p) {
        uint32_t reached = 0;
        solver.visit_page(p, [&](uint32_t vertex, float distance, uint32_t) {
            EXPECT_EQ(distance, solver.distance(vertex));
            ++reached;
        });
        pages += reached > 0;
    }
    EXPECT_GT(pages, 0u);
    EXPECT_LT(pages, 20u);
    EXPECT_LT(100 * slices, mesh.vertex_count() / 20);
}

TEST(RefinedSolver, DoesNotReachOtherComponents) {
    const Eigen::Affine3d away(Eigen::Translation3d(10, 0, 0));
    const Mesh mesh = make_mesh(both(sphere(2), moved(sphere(2), away)));
    const auto distances = Geodesics(mesh).distances({{3, 0, 0}});
    for (uint32_t v = 0; v < distances.size(); ++v) {
        EXPECT_EQ(distances[v] == unreachable, v >= distances.size() / 2);
    }
}

TEST(RefinedSolver, StaysWithinRegions) {
    // A slit in the plane, but for its upper end.
    Mesh mesh = make_mesh(plane(40));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 middle = (mesh.position(mesh.triangles[t][0]) + mesh.position(mesh.triangles[t][1]) +
                             mesh.position(mesh.triangles[t][2])) /
                            3;
        mesh.regions[t] = std::abs(middle.x() - 0.5) < 0.05 && middle.y() < 0.8 ? 1 : 0;
    }
    Geodesics geodesics(mesh);
    const uint32_t inside[] = {0};
    const RegionSet within(inside, 1, test_memory());
    const GeodesicRegion region = run_haltingly(
        test_memory(), [&](Pace& pace) { return bound_region(pace, mesh, mesh.positions, geodesics.blocks, within); });
    const auto distances = geodesics.distances({{0, 0, 0}}, {}, true, &region);
    for (uint32_t v = 0; v < distances.size(); ++v) {
        const Vec3 p = mesh.position(v);
        if (std::abs(p.x() - 0.5) < 0.049 && p.y() < 0.799) {
            EXPECT_EQ(distances[v], unreachable);
        }
    }
    // Around the slit's corner at (0.45, 0.8), then to the other one at (0.55, 0.8), and down.
    const double expected = std::hypot(0.45, 0.8) + 0.1 + std::hypot(0.45, 0.8);
    EXPECT_NEAR(distances[40], expected, 0.02 * expected);
}

// What an affine map makes of a plane is a plane.
TEST(RefinedSolver, FindsStraightLinesInStretchedPlanes) {
    for (const double stretch : {5.0, 20.0, 100.0}) {
        const Mesh mesh = make_mesh(stretched(plane(40, 0.2), {1, stretch, 1}));
        const auto distances = Geodesics(mesh).distances({{820, 0, 0}});
        const auto straight = [&](uint32_t v) { return (mesh.position(v) - mesh.position(820)).norm(); };
        EXPECT_LT(rms_error(distances, straight), 2e-3) << stretch;
        // Edges beside the source that are not flipped.
        for (uint32_t v = 0; v < distances.size(); ++v) EXPECT_NEAR(distances[v], straight(v), 0.02 * straight(v));
    }
}

TEST(RefinedSolver, ComesNearToExactDistancesOnStretchedTriangles) {
    for (const Vec3& stretch : {Vec3(1, 20, 1), Vec3(10, 1, 0.2), Vec3(1, 1, 0.05)}) {
        for (const Soup& soup : {torus(60, 40), sphere(4)}) {
            const Mesh mesh = make_mesh(stretched(soup, stretch));
            const uint32_t source = mesh.vertex_count() / 3;
            const auto distances = Geodesics(mesh).distances({{source, 0, 0}});
            const auto exact = literal::exact_distances(mesh, source);
            EXPECT_LT(rms_error(distances, [&](uint32_t v) { return exact[v]; }), 0.01) << stretch.transpose();
            const literal::GraphField along_edges(edges_alone(mesh), {{source, 0, 0}});
            for (uint32_t v = 0; v < distances.size(); ++v) {
                EXPECT_LE(distances[v], along_edges.distances[v] * (1 + 3e-5f));
                EXPECT_GE(distances[v], exact[v] * 0.85);
            }
        }
    }
}

// The slit of StaysWithinRegions, the whole twenty times as high.
TEST(RefinedSolver, StaysWithinRegionsOfStretchedTriangles) {
    Mesh mesh = make_mesh(stretched(plane(40, 0.2), {1, 20, 1}));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 middle = (mesh.position(mesh.triangles[t][0]) + mesh.position(mesh.triangles[t][1]) +
                             mesh.position(mesh.triangles[t][2])) /
                            3;
        mesh.regions[t] = std::abs(middle.x() - 0.5) < 0.05 && middle.y() < 16 ? 1 : 0;
    }
    Geodesics geodesics(mesh);
    ASSERT_FALSE(geodesics.blocks.flipped.empty());
    const uint32_t inside[] = {0};
    const RegionSet within(inside, 1, test_memory());
    const GeodesicRegion region = run_haltingly(
        test_memory(), [&](Pace& pace) { return bound_region(pace, mesh, mesh.positions, geodesics.blocks, within); });
    const auto distances = geodesics.distances({{0, 0, 0}}, {}, true, &region);
    for (uint32_t v = 0; v < distances.size(); ++v) {
        const Vec3 p = mesh.position(v);
        if (std::abs(p.x() - 0.5) < 0.03 && p.y() < 15) {
            EXPECT_EQ(distances[v], unreachable);
        }
    }
    const double expected = std::hypot(0.45, 16) + 0.1 + std::hypot(0.45, 16);
    EXPECT_NEAR(distances[40], expected, 0.02 * expected);
    // The same as on a surface that ends there.
    Soup cut;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) cut.positions.push_back(mesh.positions[v]);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (mesh.regions[t] == 0) cut.triangles.push_back(mesh.triangles[t]);
    }
    const auto alone = distances_of_used(cut, 0);
    for (uint32_t v = 0; v < distances.size(); ++v) {
        if (alone[v] == unreachable) continue;
        EXPECT_NEAR(distances[v], alone[v], 0.01 * alone[v] + 1e-6) << v;
    }
}

// Of a few fans where the regions end edges are flipped outside alone: the same as on a surface that ends there.
TEST(RefinedSolver, StaysWithinJaggedRegionsOfUnevenTriangles) {
    const uint32_t cells = 40, squares = 8;
    const Soup flat = plane(cells);
    for (uint64_t seed = 0; seed < 20; ++seed) {
        Mesh mesh = make_mesh(plane(cells, 0.45));
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            Vec3 low = Vec3::Constant(1);
            for (const uint32_t v : mesh.triangles[t]) low = low.cwiseMin(load_vec3(flat.positions[v].data()));
            // A skyline: no two of its corners touch.
            const auto square = [=](double at) { return static_cast<uint32_t>(squares * (at + 0.5 / cells)); };
            mesh.regions[t] = square(low.y()) > random_below(seed, square(low.x()), 0, squares);
        }
        Geodesics geodesics(mesh);
        ASSERT_FALSE(geodesics.blocks.flipped.empty());
        const uint32_t inside[] = {0};
        const RegionSet within(inside, 1, test_memory());
        const GeodesicRegion region = run_haltingly(test_memory(), [&](Pace& pace) {
            return bound_region(pace, mesh, mesh.positions, geodesics.blocks, within);
        });
        Soup cut;
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) cut.positions.push_back(mesh.positions[v]);
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            if (mesh.regions[t] == 0) cut.triangles.push_back(mesh.triangles[t]);
        }
        const uint32_t source = cut.triangles[cut.triangles.size() / 2][0];
        const auto distances = geodesics.distances({{source, 0, 0}}, {}, true, &region);
        const auto alone = distances_of_used(cut, source);
        for (uint32_t v = 0; v < distances.size(); ++v) {
            ASSERT_EQ(distances[v] == unreachable, alone[v] == unreachable) << seed << ", " << v;
            if (alone[v] == unreachable) continue;
            EXPECT_NEAR(distances[v], alone[v], 0.03 * alone[v] + 1e-6) << seed << ", " << v;
        }
    }
}

// Triangles that were flipped lie here and there, some of them beyond a region's border alone.
TEST(RefinedSolver, StaysWithinRegionsBesideFlips) {
    Soup soup = plane(40);
    for (uint32_t v = 0; v < soup.positions.size(); ++v) {
        for (uint32_t k = 0; k < 3; ++k)
            soup.positions[v][k] += static_cast<float>(0.022 * (random_unit(1, v, k) - 0.5));
    }
    Mesh mesh = make_mesh(soup);
    Geodesics geodesics(mesh);
    ASSERT_FALSE(geodesics.blocks.flipped.empty());
    for (uint32_t size = 3; size < 12; ++size) {
        std::vector<uint8_t> inside(mesh.vertex_count(), 0);
        uint32_t source = no_index;
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            const Vec3 corner = mesh.position(mesh.triangles[t][0]);
            const auto row = static_cast<int>(std::floor(40 * corner.x() / size)),
                       column = static_cast<int>(std::floor(40 * corner.y() / size));
            mesh.regions[t] = row == 1 && column == 1 ? 1 : 0;
            if (mesh.regions[t] == 0) continue;
            for (const uint32_t v : mesh.triangles[t]) inside[v] = 1;
            source = mesh.triangles[t][0];
        }
        const uint32_t label[] = {1};
        const RegionSet within(label, 1, test_memory());
        const GeodesicRegion region = run_haltingly(test_memory(), [&](Pace& pace) {
            return bound_region(pace, mesh, mesh.positions, geodesics.blocks, within);
        });
        const auto distances = geodesics.distances({{source, 0, 0}}, {}, true, &region);
        for (uint32_t v = 0; v < distances.size(); ++v) {
            if (inside[v] == 0) {
                EXPECT_EQ(distances[v], unreachable) << size << ", " << v;
            }
        }
    }
}

TEST(RefinedSolver, TakesDegenerateTrianglesAndFansOfAThousand) {
    // A cone of many slivers, one of its triangles without area, and two vertices in one place.
    Soup soup;
    const uint32_t around = 1000;
    soup.positions.push_back({0, 0, 1});
    for (uint32_t i = 0; i < around; ++i) {
        const double angle = 2 * pi * (i == 1 ? 0 : i) / around;
        soup.positions.push_back(to_position({std::cos(angle), std::sin(angle), 0}));
    }
    for (uint32_t i = 0; i < around; ++i) soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % around});
    const Mesh mesh = make_mesh(soup);
    const auto distances = Geodesics(mesh).distances({{0, 0, 0}});
    for (uint32_t v = 1; v <= around; ++v) EXPECT_NEAR(distances[v], std::sqrt(2.0), 1e-5);
    const auto from_side = Geodesics(mesh).distances({{1, 0, 0}});
    for (float distance : from_side) EXPECT_TRUE(std::isfinite(distance));
    EXPECT_EQ(from_side[2], 0);

    Soup flat = plane(4);
    for (Position& p : flat.positions) p = {p[0], 0, 0};
    for (float distance : Geodesics(make_mesh(flat)).distances({{0, 0, 0}})) EXPECT_LE(distance, 1.001f);
    for (Position& p : flat.positions) p = {};
    for (float distance : Geodesics(make_mesh(flat)).distances({{0, 0, 0}})) EXPECT_EQ(distance, 0);
}

}  // namespace
}  // namespace flg::test
