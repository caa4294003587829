// SPDX-License-Identifier: MIT
// Where the triangles of an ornamented surface lie on the mesh that it was made of: two ways of carrying a column
// agree, and the triangles cover each of the input's, once.
#include "tangles/random_session.h"

namespace flg::test {
namespace {

// With a column of numbers that are no function of the place, whose values are the same wherever vertices are
// welded.
MeshArrays with_column(MeshArrays mesh, std::vector<float>& values) {
    std::map<Point, float> at;
    std::mt19937 random(5);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const auto [found, is_new] = at.try_emplace(mesh.vertex(v));
        if (is_new) found->second = static_cast<float>(random() % 1000) / 1000;
        values.push_back(found->second);
    }
    mesh.further_columns = {{FLG_ATTRIBUTE_USER, 1, values.data(), 0, 0}};
    return mesh;
}

FlgSurface with_provenance(const TangleHost& host, MeshArrays& mesh) {
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    const FlgMeshView input = mesh.view();
    desc.mesh = &input;
    desc.provenance = 1;
    FlgSurface surface{};
    EXPECT_EQ(flgSurfaceCreate(host.context, &desc, &surface, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return surface;
}

FlgSurfaceProvenanceView provenance_of(const TangleHost& host, FlgSurface surface) {
    FlgSurfaceProvenanceView view = flgSurfaceProvenanceViewDefaults();
    EXPECT_EQ(flgSurfaceGetProvenance(host.context, surface, &view), FLG_OK) << flgErrorGetMessage();
    return view;
}

// `kept`: of the input's triangles.
void expect_provenance(const TangleHost& host, FlgSurface surface, const MeshArrays& input, uint32_t kept) {
    const FlgSurfaceView shown = host.view(surface);
    const FlgMeshView& mesh = *shown.mesh;
    const FlgSurfaceProvenanceView lies = provenance_of(host, surface);
    ASSERT_EQ(lies.revision, shown.revision);
    ASSERT_EQ(lies.vertex_count, mesh.vertex_count);
    ASSERT_EQ(lies.triangle_count, mesh.triangle_count);
    ASSERT_EQ(lies.input_triangle_count, input.triangle_count());
    const FlgColumn* const column = flgMeshViewGetColumn(&mesh, FLG_ATTRIBUTE_USER);
    ASSERT_TRUE(column);
    std::map<uint32_t, double> covered;  // share of each triangle of the input
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
        std::array<FlgSurfacePoint, 3> points{};
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t vertex = mesh.triangles[3 * t + k];
            ASSERT_EQ(flgSurfaceProvenanceViewGetPoint(&lies, t, vertex, &points[k]), FLG_OK) << flgErrorGetMessage();
            ASSERT_EQ(points[k].triangle, lies.triangles[t]);
            const double weights[] = {1.0 - points[k].u - points[k].v, points[k].u, points[k].v};
            double mixed = 0;
            for (uint32_t j = 0; j < 3; ++j) {
                const uint32_t corner = input.triangles[3 * size_t{points[k].triangle} + j];
                mixed += weights[j] * input.further_columns[0].data[corner];
            }
            ASSERT_NEAR(column->data[vertex], mixed, 2e-6) << "triangle " << t << ", corner " << k;
            for (const double weight : weights) ASSERT_GE(weight, -1e-6);
        }
        const double area = (points[1].u - points[0].u) * (points[2].v - points[0].v) -
                            (points[2].u - points[0].u) * (points[1].v - points[0].v);
        covered[lies.triangles[t]] += std::abs(area);
    }
    EXPECT_EQ(covered.size(), kept);
    for (const auto& [triangle, share] : covered) ASSERT_NEAR(share, 1, 1e-4) << "triangle " << triangle;
}

std::string bits_of(const FlgSurfaceProvenanceView& view) {
    std::string all;
    append(all, view.triangles, view.triangle_count);
    append(all, view.weights, view.vertex_count);
    return all;
}

TEST(Provenance, OfASurfaceThatNobodyCutIsItsInput) {
    const TangleHost host;
    std::vector<float> values;
    MeshArrays mesh = with_column(sphere(3), values);
    const uint32_t whole = mesh.triangle_count();
    // One turned over, one that names a vertex twice, one that is there already.
    std::swap(mesh.triangles[30], mesh.triangles[31]);
    mesh.add_triangle(4, 4, 5);
    mesh.add_triangle(mesh.triangles[0], mesh.triangles[1], mesh.triangles[2]);
    const FlgSurface surface = with_provenance(host, mesh);
    EXPECT_EQ(host.report(surface).flipped_triangles, 1u);
    expect_provenance(host, surface, mesh, whole);
    const FlgSurfaceProvenanceView lies = provenance_of(host, surface);
    for (uint32_t v = 0; v < lies.vertex_count; ++v) {
        EXPECT_EQ(lies.weights[v].vertices[1], FLG_NO_INDEX);
        EXPECT_EQ(vertex_at(host.view(surface), v), mesh.vertex(lies.weights[v].vertices[0]));
    }
}

TEST(Provenance, ComesThroughRefinement) {
    for (const FlgSubdivision scheme : {FLG_SUBDIVISION_MIDPOINT, FLG_SUBDIVISION_LOOP}) {
        const TangleHost host;
        std::vector<float> values;
        MeshArrays mesh = with_column(cylinder(9, 3), values);
        FlgSurfaceRefineDesc desc = flgSurfaceRefineDefaults();
        desc.surface = with_provenance(host, mesh);
        desc.scheme = scheme;
        desc.levels = 3;
        FlgSurface fine{};
        ASSERT_EQ(flgSurfaceRefine(host.context, &desc, &fine, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        const FlgSurfaceProvenanceView lies = provenance_of(host, fine);
        EXPECT_EQ(lies.triangle_count, 64 * mesh.triangle_count());
        // Loop's scheme moves the column's values, not the places.
        if (scheme == FLG_SUBDIVISION_MIDPOINT) expect_provenance(host, fine, mesh, mesh.triangle_count());
        for (uint32_t t = 0; t < lies.triangle_count; ++t) ASSERT_EQ(lies.triangles[t], t / 64);
    }
}

void run(MeshArrays mesh, uint64_t seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TangleHost host;
    std::vector<float> values;
    mesh = with_column(std::move(mesh), values);
    const FlgSurface surface = with_provenance(host, mesh), plain = host.surface(mesh);
    const FlgTangle tangle = host.tangle(surface), of_plain = host.tangle(plain);
    RandomSession session(host, surface, tangle, seed), same(host, plain, of_plain, seed);
    std::vector<std::string> states = {bits_of(provenance_of(host, surface))};
    for (uint32_t i = 0; i < 60 && host.view(surface).mesh->triangle_count < 6000; ++i) {
        SCOPED_TRACE("step " + std::to_string(i) + ", " + session.last);
        const FlgResult result = session.step();
        ASSERT_EQ(same.step(), result);
        expect_provenance(host, surface, mesh, mesh.triangle_count());
        ASSERT_FALSE(testing::Test::HasFailure());
        if (result == FLG_OK) states.push_back(bits_of(provenance_of(host, surface)));
        ASSERT_TRUE(bits(host.view(surface)) == bits(host.view(plain))) << "it changes nothing";
    }
    const size_t last = states.size() - 1;
    ASSERT_GT(last, 10u);
    for (size_t i = last; i-- > 0;) {
        ASSERT_EQ(host.undo(tangle), FLG_OK);
        ASSERT_TRUE(bits_of(provenance_of(host, surface)) == states[i]);
    }
    for (size_t i = 1; i <= last; ++i) {
        ASSERT_EQ(host.redo(tangle), FLG_OK);
        ASSERT_TRUE(bits_of(provenance_of(host, surface)) == states[i]);
    }
    // An early step is left out: those behind it are moved over or computed again.
    FlgJob job{};
    ASSERT_EQ(flgTangleMuteStep(host.context, tangle, 2, 1, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    ASSERT_EQ(host.result_of(job), FLG_OK);
    expect_provenance(host, surface, mesh, mesh.triangle_count());
    ASSERT_EQ(host.undo(tangle), FLG_OK);
    EXPECT_TRUE(bits_of(provenance_of(host, surface)) == states[last]);
}

TEST(Provenance, StaysTrueThroughRandomStepsTakenBackAndEdited) {
    run(sphere(6), 3);
    run(cylinder(24, 8), 4);
}

TEST(Provenance, IsRefusedWhereNobodyAskedForIt) {
    const TangleHost host;
    const FlgSurface plain = host.surface(plane(3));
    FlgSurfaceProvenanceView view = flgSurfaceProvenanceViewDefaults();
    EXPECT_EQ(flgSurfaceGetProvenance(host.context, plain, &view), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("set FlgSurfaceDesc.provenance"), std::string::npos);
    EXPECT_EQ(view.triangle_count, 0u);
    MeshArrays mesh = plane(3);
    const FlgSurface surface = with_provenance(host, mesh);
    view = provenance_of(host, surface);
    FlgSurfacePoint point{};
    const auto expect_refused = [&](uint32_t triangle, uint32_t vertex, const char* words) {
        EXPECT_EQ(flgSurfaceProvenanceViewGetPoint(&view, triangle, vertex, &point), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgErrorGetMessage()).find(words), std::string::npos) << flgErrorGetMessage();
        EXPECT_EQ(point.triangle, FLG_NO_INDEX);
    };
    expect_refused(18, 0, "triangle");
    expect_refused(0, 16, "vertex");
    expect_refused(0, 15, "vertex is 15, which is none of triangle 0");
}

}  // namespace
}  // namespace flg::test
