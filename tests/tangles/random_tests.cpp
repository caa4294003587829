// SPDX-License-Identifier: MIT
// Hundreds of random steps in a row keep every invariant of a tangle.
#include "tangles/random_session.h"

namespace flg::test {
namespace {

// The curves that are borders are the edges where looks differ.
void expect_borders(const TangleHost& host, FlgSurface surface, FlgTangle tangle) {
    const FlgSurfaceView view = host.view(surface);
    std::map<uint32_t, uint32_t> look_of;
    for (uint32_t leaf : host.leaves(tangle)) look_of[leaf] = host.region(tangle, leaf).look;
    uint32_t edges = 0;
    double length = 0;
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t other = view.neighbours[3 * t + k];
            if (other == FLG_NO_INDEX || other < t) continue;
            if (look_of[view.mesh->regions[t]] == look_of[view.mesh->regions[other]]) continue;
            ++edges;
            length += distance(vertex_at(view, view.mesh->triangles[3 * t + k]),
                               vertex_at(view, view.mesh->triangles[3 * t + (k + 1) % 3]));
        }
    }
    FlgSurfaceCurves borders{};
    ASSERT_EQ(flgTangleTraceBorders(host.context, tangle, nullptr, &borders, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    const FlgSurfaceCurvesView curves = host.view(borders);
    uint32_t stretches = 0;
    double traced = 0;
    for (uint32_t c = 0; c < curves.curve_count; ++c) {
        const bool closed = (curves.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
        stretches += curves.curve_offsets[c + 1] - curves.curve_offsets[c] - (closed ? 0 : 1);
        traced += double{curves.curve_values[c]};
    }
    EXPECT_EQ(stretches, edges);
    EXPECT_NEAR(traced, length, 1e-5 * (1 + length));
    EXPECT_EQ(flgSurfaceCurvesRelease(host.context, borders), FLG_OK);
}

struct State {
    size_t mesh, tree;

    bool operator==(const State&) const = default;
};

void run_session(const MeshArrays& mesh, uint64_t seed, uint32_t steps) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    constexpr uint32_t max_triangles = 3000;
    const TangleHost host;
    const FlgSurface surface = host.surface(mesh);
    const FlgTangle tangle = host.tangle(surface);
    RandomSession session(host, surface, tangle, seed);
    const std::hash<std::string> hash;
    const auto state = [&] { return State{hash(bits(host.view(surface))), hash(host.tree_bits(tangle))}; };
    std::vector<State> states = {state()};
    uint32_t made = 0, refused = 0, max_made = 0;
    for (uint32_t i = 0; i < steps; ++i) {
        SCOPED_TRACE("step " + std::to_string(i));
        const double area = whole_area(host.view(surface));
        const FlgResult result = session.step();
        SCOPED_TRACE(session.last);
        if (result != FLG_OK) {
            ASSERT_EQ(result, FLG_ERROR_INVALID_ARGUMENT);
            ASSERT_EQ(state(), states[made]) << "what failed changed nothing";
            ++refused;
        } else {
            states.resize(++made);
            states.push_back(state());
            max_made = std::max(max_made, made);
            const bool moved = session.last.starts_with("displacement");
            expect_valid(host, surface, tangle, moved ? whole_area(host.view(surface)) : area);
            expect_borders(host, surface, tangle);
        }
        ASSERT_FALSE(testing::Test::HasFailure());
        // Back to where there is room for more, and now and then some of the way again.
        while (host.view(surface).mesh->triangle_count > max_triangles) {
            for (uint32_t back = 1 + session.draw(5); back > 0 && made > 0; --back) {
                ASSERT_EQ(host.undo(tangle), FLG_OK);
                ASSERT_EQ(state(), states[--made]) << "taken back";
            }
        }
        if (session.draw(10) == 0 && host.info(tangle).redo_count > 0) {
            ASSERT_EQ(host.redo(tangle), FLG_OK);
            ASSERT_EQ(state(), states[++made]) << "made again";
        }
    }
    EXPECT_LT(refused, steps / 3);
    EXPECT_GT(max_made, 20u);
    EXPECT_EQ(host.info(tangle).undo_count, made);
    const uint32_t end = made;
    while (made > 0) {
        ASSERT_EQ(host.undo(tangle), FLG_OK);
        ASSERT_EQ(state(), states[--made]) << "back to step " << made;
    }
    while (made < end) {
        ASSERT_EQ(host.redo(tangle), FLG_OK);
        ASSERT_EQ(state(), states[++made]) << "again to step " << made;
    }
    // All of it again from the history.
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    ASSERT_EQ(flgTangleGetHistory(host.context, tangle, &history), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(history.made_count, made);
    const TangleHost other(1);
    const FlgSurface copy = other.surface(mesh);
    const FlgTangle again = other.tangle(copy);
    FlgJob job{};
    ASSERT_EQ(flgTangleReplay(other.context, again, &history, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    other.finish();
    ASSERT_EQ(other.result_of(job), FLG_OK) << other.status_of(job).error;
    EXPECT_TRUE(bits(other.view(copy)) == bits(host.view(surface)));
    EXPECT_TRUE(other.tree_bits(again) == host.tree_bits(tangle));
}

TEST(TangleSessions, FiveHundredRandomStepsOnAClosedSurface) {
    run_session(sphere(6), 11, 500);
}

TEST(TangleSessions, FiveHundredRandomStepsOnASurfaceWithBorders) {
    run_session(cylinder(24, 8), 12, 500);
}

}  // namespace
}  // namespace flg::test
