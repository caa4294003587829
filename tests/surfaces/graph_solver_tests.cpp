// SPDX-License-Identifier: MIT
#include "surfaces/graph_solver.h"

#include <gtest/gtest.h>

#include "surfaces/graph_checks.h"

namespace flg::test {
namespace {

Soup joined(const Soup& a, const Soup& b) {
    Soup both = a;
    const uint32_t first = static_cast<uint32_t>(a.positions.size());
    both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
    for (const Triple& t : b.triangles) both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return both;
}

// Long and short edges side by side: what puts label correcting out of order.
Soup uneven(uint32_t cells) {
    return grid(cells, cells, [](double x, double y) { return Vec3(x * x * x * x, y * y, 0.3 * std::sin(9 * x * y)); });
}

TEST(GraphSolver, GivesTheBitsOfDijkstra) {
    for (const Soup& soup : {plane(30, 0.3), plane(30), sphere(4), torus(40, 20), uneven(40),
                             joined(sphere(2), tetrahedron()), cylinder(300, 2)}) {
        const Mesh mesh = make_mesh(soup);
        const GeodesicGraph graph = make_graph(mesh);
        const literal::GeodesicGraph arcs = literal_form(graph);
        for (uint32_t k = 0; k < 5; ++k) {
            std::vector<Seed> seeds;
            for (uint32_t i = 0; i <= k; ++i) {
                const uint32_t vertex = random_below(k, i, 0, mesh.vertex_count());
                seeds.push_back({vertex, k == 0 ? 0.0f : static_cast<float>(0.1 * random_unit(k, i, 1)), i});
            }
            EXPECT_EQ(solve_graph(mesh, graph, seeds).distances, literal::graph_distances(arcs, seeds));
        }
    }
}

TEST(GraphSolver, DoesNotDependOnSlices) {
    const Mesh mesh = make_mesh(uneven(12));
    const GeodesicGraph graph = make_graph(mesh);
    SolveLimits limits;
    limits.targets = {3, 40};
    for (const SolveLimits& asked : {SolveLimits{}, SolveLimits{0.4f, {}}, limits}) {
        const std::vector<Seed> seeds = {{80, 0, 0}, {120, 0.05f, 1}};
        const GraphField whole = solve_graph(mesh, graph, seeds, asked);
        const GraphField sliced = solve_graph(mesh, graph, seeds, asked, RegionSet(test_memory()), 1);
        EXPECT_EQ(whole.distances, sliced.distances);
        EXPECT_EQ(whole.labels, sliced.labels);
    }
}

TEST(GraphSolver, LabelsAreThoseOfTheNearestSourceAndTheLeastOfTies) {
    const Mesh mesh = make_mesh(plane(16));
    const GeodesicGraph graph = make_graph(mesh);
    const std::vector<Seed> seeds = {{0, 0, 7}, {16, 0, 3}, {16 * 17, 0, 5}};
    std::vector<GraphField> alone;
    for (const Seed& seed : seeds) alone.push_back(solve_graph(mesh, graph, {seed}));
    const GraphField field = solve_graph(mesh, graph, seeds);
    const std::vector<Seed> backwards(seeds.rbegin(), seeds.rend());
    EXPECT_EQ(solve_graph(mesh, graph, backwards).labels, field.labels);
    bool has_ties = false;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        std::pair<float, uint32_t> nearest{unreachable, no_index};
        for (size_t i = 0; i < seeds.size(); ++i) {
            const std::pair<float, uint32_t> other{alone[i].distances[v], seeds[i].label};
            has_ties |= other.first == nearest.first;
            nearest = std::min(nearest, other);
        }
        EXPECT_EQ(field.distances[v], nearest.first);
        EXPECT_EQ(field.labels[v], nearest.second);
    }
    EXPECT_TRUE(has_ties);
}

TEST(GraphSolver, IsNeverBelowTheExactDistanceAndSymmetric) {
    for (const Soup& soup : {sphere(3), torus(24, 12), uneven(20)}) {
        const Mesh mesh = make_mesh(soup);
        const GeodesicGraph graph = make_graph(mesh);
        const GraphField from = solve_graph(mesh, graph, {{11, 0, 0}});
        const std::vector<double> exact = literal::exact_distances(mesh, 11);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_GE(from.distances[v], exact[v] * (1 - 1e-6));
            // A step of the graph leaves out at most half the angle between two of its arcs: 45 degrees in worst triangles.
            EXPECT_LE(from.distances[v], exact[v] * 1.4);
        }
        for (uint32_t v : {0u, 30u, 77u}) {
            EXPECT_NEAR(solve_graph(mesh, graph, {{v, 0, 0}}).distances[11], from.distances[v],
                        1e-6 * from.distances[v]);
        }
    }
}

// Of a grid of squares cut in two along the same diagonal each: arcs lead along the axes, along both diagonals and like a
// knight's move across the long one, which leaves no direction further than 1 / cos(22.5 degrees) off.
TEST(GraphSolver, IsOffByTheAngleBetweenArcsAtMost) {
    const Mesh mesh = make_mesh(plane(24));
    const GraphField field = solve_graph(mesh, make_graph(mesh), {{12 * 25 + 12, 0, 0}});
    const double most = 1 / std::cos(std::numbers::pi / 8);
    double worst = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (v == 12 * 25 + 12) continue;
        const double ratio = field.distances[v] / (mesh.position(v) - mesh.position(12 * 25 + 12)).norm();
        EXPECT_LE(ratio, most + 1e-6);
        worst = std::max(worst, ratio);
    }
    EXPECT_GT(worst, 1.07);
}

TEST(GraphSolver, LeavesWhatIsBeyondTheLimitUnreachable) {
    const Mesh mesh = make_mesh(sphere(3));
    const GeodesicGraph graph = make_graph(mesh);
    const GraphField all = solve_graph(mesh, graph, {{0, 0, 4}});
    const GraphField near = solve_graph(mesh, graph, {{0, 0, 4}}, {0.7f, {}});
    uint32_t beyond = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const bool within = all.distances[v] <= 0.7f;
        EXPECT_EQ(near.distances[v], within ? all.distances[v] : unreachable);
        EXPECT_EQ(near.labels[v], within ? 4 : no_index);
        beyond += !within;
    }
    EXPECT_GT(beyond, 0u);
}

TEST(GraphSolver, StopsAtTheLastTarget) {
    const Mesh mesh = make_mesh(joined(sphere(3), tetrahedron()));
    const GeodesicGraph graph = make_graph(mesh);
    const GraphField all = solve_graph(mesh, graph, {{0, 0, 0}});
    SolveLimits limits;
    float furthest = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); v += 3) {
        if (all.distances[v] > 0.8f) continue;
        limits.targets.push_back(v);
        furthest = std::max(furthest, all.distances[v]);
    }
    const GraphField field = solve_graph(mesh, graph, {{0, 0, 0}}, limits);
    uint32_t left_out = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (all.distances[v] <= furthest) {
            EXPECT_EQ(field.distances[v], all.distances[v]);
        }
        left_out += field.distances[v] != all.distances[v];
    }
    EXPECT_GT(left_out, 100u);
    // One that no path leads to: all others are found.
    limits.targets = {7, mesh.vertex_count() - 1};
    EXPECT_EQ(solve_graph(mesh, graph, {{0, 0, 0}}, limits).distances, all.distances);
}

// The mesh of some triangles alone; `vertices`: which ones of the whole its vertices are.
Mesh part_of(const Mesh& mesh, const RegionSet& regions, std::vector<uint32_t>& vertices) {
    Soup soup;
    std::vector<uint32_t> place(mesh.vertex_count(), no_index);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (!regions.contains(mesh.regions[t])) continue;
        for (uint32_t v : mesh.triangles[t]) place[v] = 0;
    }
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (place[v] == no_index) continue;
        place[v] = static_cast<uint32_t>(vertices.size());
        vertices.push_back(v);
        soup.positions.push_back(mesh.positions[v]);
    }
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        if (!regions.contains(mesh.regions[t])) continue;
        const Triple& v = mesh.triangles[t];
        soup.triangles.push_back({place[v[0]], place[v[1]], place[v[2]]});
    }
    return make_mesh(soup);
}

TEST(GraphSolver, KeepsToTheRegions) {
    Mesh mesh = make_mesh(plane(20, 0.3));
    // A horseshoe of two regions and what lies between its ends.
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        Vec3 middle(0, 0, 0);
        for (uint32_t v : mesh.triangles[t]) middle += mesh.position(v) / 3;
        const double radius = std::hypot(middle.x() - 0.5, middle.y() - 0.5);
        const bool is_ring = radius > 0.2 && radius < 0.4 && (middle.y() < 0.55 || std::abs(middle.x() - 0.5) > 0.08);
        mesh.regions[t] = !is_ring ? 0 : middle.y() < 0.5 ? 5 : 70;
    }
    const uint32_t labels[] = {70, 5};
    const RegionSet regions(labels, 2, test_memory());
    std::vector<uint32_t> vertices;
    const Mesh part = part_of(mesh, regions, vertices);
    const GeodesicGraph graph = make_graph(mesh), part_graph = make_graph(part);
    for (uint32_t source : {0u, 40u}) {
        const GraphField alone = solve_graph(part, part_graph, {{source, 0, 2}});
        for (uint32_t slice : {1u, 1000u}) {
            const GraphField field = solve_graph(mesh, graph, {{vertices[source], 0, 2}}, {}, regions, slice);
            std::vector<float> inside;
            for (uint32_t v : vertices) inside.push_back(field.distances[v]);
            EXPECT_EQ(inside, alone.distances);
            const size_t reached =
                mesh.vertex_count() - std::count(field.distances.begin(), field.distances.end(), unreachable);
            EXPECT_EQ(reached, vertices.size());
        }
    }
    // A source outside reaches nothing.
    const uint32_t outside = 10 * 21 + 10;
    for (float distance : solve_graph(mesh, graph, {{outside, 0, 0}}, {}, regions).distances) {
        EXPECT_EQ(distance, unreachable);
    }
}

TEST(GraphSolver, ExtendsAFieldToThatOfAllSources) {
    const Mesh mesh = make_mesh(torus(30, 16));
    const GeodesicGraph graph = make_graph(mesh);
    const SolveLimits limits;
    const RegionSet regions(test_memory());
    GraphSolver solver(mesh, mesh.positions, graph, test_memory());
    std::vector<Seed> seeds;
    for (uint32_t i = 0; i < 6; ++i) {
        seeds.push_back({random_below(3, i, 0, mesh.vertex_count()), 0, i});
        const std::span<const Seed> added(&seeds.back(), 1);
        i == 0 ? solver.begin(added, limits, regions, true) : solver.extend(added, limits);
        while (!solver.run(7)) {}
        const GraphField field = read_field(solver, mesh, true), anew = solve_graph(mesh, graph, seeds);
        EXPECT_EQ(field.distances, anew.distances);
        EXPECT_EQ(field.labels, anew.labels);
    }
}

TEST(GraphSolver, WithoutSourcesReachesNothing) {
    const Mesh mesh = make_mesh(tetrahedron());
    for (float distance : solve_graph(mesh, make_graph(mesh), {}).distances) EXPECT_EQ(distance, unreachable);
}

}  // namespace
}  // namespace flg::test
