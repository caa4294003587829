// SPDX-License-Identifier: MIT
#include "surfaces/sampling/poisson_sampling.h"

#include <gtest/gtest.h>

#include "reference/literal_geodesics.h"
#include "surfaces/geodesics.h"

namespace flg::test {
namespace {

// Dijkstra's algorithm on the paper's graph, so that what is expected is exact.
class GraphSolver {
public:
    GraphSolver(const Mesh& mesh, const std::vector<Seed>& seeds, const RegionSet& regions)
        : graph_(literal::geodesic_graph(mesh, regions)), field_(graph_, seeds) {}
    void extend(std::span<const Seed> seeds) { field_.extend(graph_, seeds); }
    float distance(uint32_t vertex) const { return field_.distances[vertex]; }
    uint32_t label(uint32_t vertex) const { return field_.labels[vertex]; }
    const literal::GraphField& field() const { return field_; }

private:
    literal::GeodesicGraph graph_;
    literal::GraphField field_;
};

Task<void> extend_distances(Pace&, GraphSolver& solver, std::span<const Seed> seeds, const SolveLimits&) {
    solver.extend(seeds);
    co_return;
}

struct Sampling {
    std::vector<uint32_t> samples;
    literal::GraphField field;
};

struct Question {
    float radius = 0.2f;
    uint32_t max_count = no_index;
    uint64_t seed = 1;
    std::vector<Seed> away_from = {};
    RegionSet regions{test_memory()};
    bool haltingly = false;
};

Sampling sample(const Mesh& mesh, const Question& question) {
    GraphSolver solver(mesh, question.away_from, question.regions);
    const Buffer<uint32_t> samples = run_now(
        test_memory(),
        [&](Pace& pace) {
            return sample_poisson(pace, mesh, question.regions, solver, question.radius, question.max_count,
                                  question.seed);
        },
        question.haltingly);
    return {{samples.begin(), samples.end()}, solver.field()};
}

// Sums of lengths along a path and its reverse are rounded differently.
constexpr float rounding = 1e-5f;

void expect_apart(const Mesh& mesh, const Sampling& sampling, const Question& question) {
    const literal::GeodesicGraph graph = literal::geodesic_graph(mesh, question.regions);
    for (size_t i = 0; i < sampling.samples.size(); ++i) {
        const literal::GraphField from(graph, {{sampling.samples[i], 0, 0}});
        for (size_t j = 0; j < sampling.samples.size(); ++j) {
            if (i == j) continue;
            EXPECT_GE(from.distances[sampling.samples[j]], question.radius * (1 - rounding));
        }
    }
}

TEST(PoissonSampling, PointsAreApartAndCoverAll) {
    for (const Soup& soup : {sphere(3), torus(40, 20), plane(20, 0.3)}) {
        const Mesh mesh = make_mesh(soup);
        const Question question;
        const Sampling sampling = sample(mesh, question);
        expect_apart(mesh, sampling, question);
        for (float distance : sampling.field.distances) EXPECT_LT(distance, question.radius);
    }
}

// The graph's distances are up to 1 / cos(22.5 degrees) too long. Discs of half the radius do not overlap, those of the
// whole one cover the sphere; a disc of radius r has the area 2 pi (1 - cos r).
TEST(PoissonSampling, HasAsManyPointsAsThereIsAreaFor) {
    const Mesh mesh = make_mesh(sphere(4));
    for (float radius : {0.15f, 0.3f, 0.6f}) {
        const Sampling sampling = sample(mesh, {.radius = radius});
        const double apart = radius * std::cos(std::numbers::pi / 8);
        EXPECT_LE(sampling.samples.size(), 2 / (1 - std::cos(apart / 2)));
        EXPECT_GE(sampling.samples.size(), 2 / (1 - std::cos(radius)));
    }
}

TEST(PoissonSampling, LabelsAreTheCellsOfTheNearestPoints) {
    const Mesh mesh = make_mesh(torus(40, 20));
    const Sampling sampling = sample(mesh, {});
    std::vector<Seed> seeds;
    for (uint32_t i = 0; i < sampling.samples.size(); ++i) seeds.push_back({sampling.samples[i], 0, i});
    const literal::GraphField anew(literal::geodesic_graph(mesh), seeds);
    EXPECT_EQ(sampling.field.distances, anew.distances);
    EXPECT_EQ(sampling.field.labels, anew.labels);
}

// Each point is the furthest from those before it, among all vertices.
TEST(PoissonSampling, TakesTheFurthestVertex) {
    const Mesh mesh = make_mesh(plane(24, 0.3));
    const literal::GeodesicGraph graph = literal::geodesic_graph(mesh);
    const Sampling sampling = sample(mesh, {.max_count = 20});
    ASSERT_EQ(sampling.samples.size(), 20u);
    std::vector<Seed> seeds;
    for (uint32_t i = 0; i < 20; ++i) {
        const std::vector<float> distances = literal::GraphField(graph, seeds).distances;
        EXPECT_EQ(distances[sampling.samples[i]], *std::max_element(distances.begin(), distances.end()));
        seeds.push_back({sampling.samples[i], 0, i});
    }
}

// A sphere of 40962 vertices: enough for the first points to be chosen in space.
TEST(PoissonSampling, OnLargeMeshesPointsAreApartAndAsManyAsWanted) {
    const Mesh mesh = make_mesh(sphere(6));
    const auto angle = [&](uint32_t a, uint32_t b) {
        return std::acos(std::clamp(mesh.position(a).dot(mesh.position(b)), -1.0, 1.0));
    };
    for (const Question& question : {Question{.radius = 1e-3f, .max_count = 100}, Question{.radius = 0.3f}}) {
        const Sampling sampling = sample(mesh, question);
        double nearest = 4;
        for (size_t i = 0; i < sampling.samples.size(); ++i) {
            for (size_t j = 0; j < i; ++j) {
                nearest = std::min(nearest, angle(sampling.samples[i], sampling.samples[j]));
            }
        }
        const double furthest = *std::max_element(sampling.field.distances.begin(), sampling.field.distances.end());
        // Each of the last points was the furthest vertex, by the graph's distances, which are up to 1 / cos(22.5
        // degrees) too long; the first ones are at least as far apart as in the lattice.
        EXPECT_GE(nearest, 0.99 * furthest * std::cos(std::numbers::pi / 8));
        if (question.max_count == no_index) {
            EXPECT_LT(furthest, question.radius);
            EXPECT_GE(nearest, question.radius * std::cos(std::numbers::pi / 8));
        } else {
            EXPECT_EQ(sampling.samples.size(), question.max_count);
            // Discs of this radius cover the sphere, whose area is 4 pi: 2 (1 - cos r) n >= 4; and no worse than twice
            // that.
            EXPECT_LE(furthest, 2 * std::acos(1 - 2.0 / question.max_count));
        }
        std::vector<Seed> seeds;
        for (uint32_t i = 0; i < sampling.samples.size(); ++i) seeds.push_back({sampling.samples[i], 0, i});
        std::sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) { return a.vertex < b.vertex; });
        const literal::GraphField anew(literal::geodesic_graph(mesh), seeds);
        EXPECT_EQ(sampling.field.distances, anew.distances) << "the field is that of all points together";
        EXPECT_EQ(
            sampling.samples,
            sample(mesh, {.radius = question.radius, .max_count = question.max_count, .haltingly = true}).samples);
    }
}

TEST(PoissonSampling, DependsOnItsSeedAndNotOnSlices) {
    const Mesh mesh = make_mesh(torus(30, 16));
    const Sampling first = sample(mesh, {.seed = 1}), again = sample(mesh, {.seed = 1, .haltingly = true}),
                   other = sample(mesh, {.seed = 2});
    EXPECT_EQ(first.samples, again.samples);
    EXPECT_EQ(first.field.labels, again.field.labels);
    EXPECT_NE(first.samples[0], other.samples[0]);
}

TEST(PoissonSampling, ReachesEveryComponent) {
    Soup soup = sphere(2);
    const uint32_t first = static_cast<uint32_t>(soup.positions.size());
    for (const Position& p : tetrahedron().positions) soup.positions.push_back(p);
    for (const Triple& t : tetrahedron().triangles)
        soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const Sampling sampling = sample(make_mesh(soup), {.radius = 100});
    ASSERT_EQ(sampling.samples.size(), 2u);
    EXPECT_NE(sampling.samples[0] < first, sampling.samples[1] < first);
}

TEST(PoissonSampling, KeepsToTheRegionsAndAwayFromTheirBorders) {
    Mesh mesh = make_mesh(plane(30));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t)
        mesh.regions[t] = mesh.position(mesh.triangles[t][0]).x() < 0.5 ? 1 : 2;
    const uint32_t label = 1;
    Question question{.radius = 0.15f, .regions = RegionSet(&label, 1, test_memory())};
    const auto distance_to_border = [](const Vec3& p) { return std::min({p.x(), 0.5 - p.x(), p.y(), 1 - p.y()}); };
    const auto is_inside = [](const Vec3& p) { return p.x() < 0.5 + 1e-6; };
    const Sampling sampling = sample(mesh, question);
    expect_apart(mesh, sampling, question);
    for (uint32_t v : sampling.samples) EXPECT_TRUE(is_inside(mesh.position(v)));
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_EQ(sampling.field.distances[v] < question.radius, is_inside(mesh.position(v)));
    }
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 p = mesh.position(v);
        if (is_inside(p) && distance_to_border(p) < 1e-6)
            question.away_from.push_back({v, question.radius / 2, no_index});
    }
    const Sampling away = sample(mesh, question);
    ASSERT_GT(away.samples.size(), 3u);
    for (uint32_t v : away.samples) {
        EXPECT_GE(distance_to_border(mesh.position(v)), question.radius / 2 * std::cos(std::numbers::pi / 8) - 1e-6);
    }
}

// By great circles: within a tenth of an edge (0.07) where cells meet.
TEST(PoissonSampling, IsAsGoodAsItsSolver) {
    const Mesh mesh = make_mesh(sphere(4));
    const Geodesics geodesics(mesh);
    RefinedSolver solver(geodesics.blocks, test_memory());
    solve(solver, {}, {}, true);
    constexpr float radius = 0.3f;
    const RegionSet regions(test_memory());
    const Buffer<uint32_t> samples = run_now(
        test_memory(), [&](Pace& pace) { return sample_poisson(pace, mesh, regions, solver, radius, no_index, 1); });
    const auto angle = [&](uint32_t a, uint32_t b) {
        return std::acos(std::clamp(mesh.position(a).dot(mesh.position(b)), -1.0, 1.0));
    };
    for (size_t i = 0; i < samples.size(); ++i) {
        for (size_t j = 0; j < i; ++j) EXPECT_GE(angle(samples[i], samples[j]), 0.98 * radius);
    }
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_LT(solver.distance(v), radius);
        EXPECT_NEAR(solver.distance(v), angle(v, samples[solver.label(v)]), 0.02 * radius);
    }
}

TEST(PoissonSampling, OfNothingIsEmpty) {
    const uint32_t label = 5;
    const Mesh mesh = make_mesh(tetrahedron());
    EXPECT_TRUE(sample(mesh, {.regions = RegionSet(&label, 1, test_memory())}).samples.empty());
    EXPECT_TRUE(sample(mesh, {.max_count = 0}).samples.empty());
}

}  // namespace
}  // namespace flg::test
