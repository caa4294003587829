// SPDX-License-Identifier: MIT
#include "surfaces/refined_solver.h"

#include <gtest/gtest.h>

#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

struct Geodesics {
    explicit Geodesics(const Mesh& mesh) : blocks(test_memory()), vertex_count(mesh.vertex_count()) {
        GeodesicBlocksKernel kernel(mesh, blocks, test_memory());
        while (!kernel.run(1000)) {}
    }
    std::vector<float> distances(const std::vector<Seed>& seeds, uint32_t slice = 1000) {
        RefinedSolver solver(blocks, test_memory());
        const SolveLimits limits;
        solver.begin(seeds, limits, false);
        while (!solver.run(slice)) {}
        DistanceField field;
        DistanceFieldKernel copy(solver, vertex_count, false, field, test_memory());
        while (!copy.run(slice)) {}
        return {field.distances.begin(), field.distances.end()};
    }

    GeodesicBlocks blocks;
    uint32_t vertex_count;
};

double rms_error(const std::vector<float>& distances, const std::function<double(uint32_t)>& expected) {
    double sum = 0;
    uint32_t count = 0;
    for (uint32_t v = 0; v < distances.size(); ++v) {
        const double distance = expected(v);
        if (distance == 0) continue;
        const double error = distances[v] / distance - 1;
        sum += error * error;
        ++count;
    }
    return std::sqrt(sum / count);
}

TEST(RefinedSolver, FindsStraightLinesInThePlane) {
    const Mesh mesh = make_mesh(plane(100, 0.3));
    Geodesics geodesics(mesh);
    const uint32_t source = 51 * 50;
    const auto distances = geodesics.distances({{source, 0, 0}});
    const double error =
        rms_error(distances, [&](uint32_t v) { return (mesh.position(v) - mesh.position(source)).norm(); });
    EXPECT_LT(error, 0.002);
}

TEST(RefinedSolver, FindsGreatCirclesOnTheSphere) {
    const Mesh mesh = make_mesh(sphere(6));
    Geodesics geodesics(mesh);
    const auto distances = geodesics.distances({{0, 0, 0}});
    const double error = rms_error(distances, [&](uint32_t v) {
        return std::acos(std::clamp(mesh.position(v).normalized().dot(mesh.position(0).normalized()), -1.0, 1.0));
    });
    EXPECT_LT(error, 0.0005);
}

TEST(RefinedSolver, DoesNotDependOnSlices) {
    const Mesh mesh = make_mesh(torus(60, 40));
    Geodesics geodesics(mesh);
    EXPECT_EQ(geodesics.distances({{7, 0, 0}}, 1), geodesics.distances({{7, 0, 0}}, 1000));
}

}  // namespace
}  // namespace flg::test
