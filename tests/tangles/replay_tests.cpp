// SPDX-License-Identifier: MIT
// Histories made again: to the bit on the same mesh, in the same places on finer ones; and those that are refused.
#include <functional>

#include "tangles/random_session.h"

namespace flg::test {
namespace {

const Regions root = {0};

FlgTangleHistory history_of(const TangleHost& host, FlgTangle tangle) {
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    EXPECT_EQ(flgTangleGetHistory(host.context, tangle, &history), FLG_OK) << flgErrorGetMessage();
    return history;
}

struct Outcome {
    FlgResult result;
    std::string sentence;
};

// By the call or by its job.
Outcome replay(const TangleHost& host, FlgTangle tangle, const FlgTangleHistory& history) {
    FlgJob job{};
    const FlgResult started = flgTangleReplay(host.context, tangle, &history, nullptr, &job);
    if (started != FLG_OK) return {started, flgErrorGetMessage()};
    host.finish(host.budget_us);
    const FlgJobStatus status = host.status_of(job);
    return {status.result, status.error};
}

std::string state(const TangleHost& host, FlgSurface surface, FlgTangle tangle) {
    return bits(host.view(surface)) + host.tree_bits(tangle);
}

// Runs a step that is started by `start`.
template <class Start>
void make(const TangleHost& host, Start start) {
    FlgJob job{};
    ASSERT_EQ(start(&job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    ASSERT_EQ(host.result_of(job), FLG_OK) << host.status_of(job).error;
}

// All operators, seeds and kinds of steps once; the last two are taken back.
void decorate(const TangleHost& host, FlgSurface surface, FlgTangle tangle) {
    FlgTangleDivideDesc desc = contour(tangle, root, samples(0.8f), 0.25f, 2);
    desc.perturbation = 0.02f;
    desc.frequency = 3;
    desc.grouping = FLG_TANGLE_GROUPING_CYCLE;
    desc.cycle = 5;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    const Regions bands = host.leaves(tangle);
    FlgTangleApplyMacroDesc macro = flgTangleApplyMacroDefaults();
    macro.tangle = tangle;
    macro.kind = FLG_TANGLE_MACRO_OUTLINE;
    macro.regions = bands.data();
    macro.region_count = 2;
    macro.size = 0.03f;
    make(host, [&](FlgJob* job) { return flgTangleApplyMacro(host.context, &macro, job); });
    const std::array<FlgSurfacePoint, 3> points = {{{3, 0.25f, 0.5f}, {200, 0.3f, 0.3f}, {410, 0.1f, 0.2f}}};
    FlgTangleSeeds at_points = flgTangleSeedsDefaults();
    at_points.points = points.data();
    at_points.point_count = 3;
    desc = contour(tangle, root, at_points, 0.1f, 1);
    desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
    desc.closed = 1;
    desc.scaffold = 1;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    // Lines: the isolines of the height.
    const FlgField heights = host.field(surface, [](const Point& p) { return p[2]; });
    const FlgSurfaceCurves lines = host.isolines(heights, {0.1f});
    FlgTangleSeeds at_lines = flgTangleSeedsDefaults();
    at_lines.curves = lines;
    desc = contour(tangle, root, at_lines, 0.1f, 1);
    desc.kind = FLG_TANGLE_OPERATOR_STREAM;
    desc.delta = 0.5f;
    desc.seed = uint64_t{1} << 60;
    ASSERT_EQ(host.divide(desc), FLG_OK);
    EXPECT_EQ(flgSurfaceCurvesRelease(host.context, lines), FLG_OK) << "the history keeps them";
    const Regions first = {host.leaves(tangle)[0]};
    FlgTangleDisplaceDesc displace = flgTangleDisplaceDefaults();
    displace.tangle = tangle;
    displace.regions = first.data();
    displace.region_count = 1;
    displace.amount = 0.02f;
    displace.gain = 0.7f;
    make(host, [&](FlgJob* job) { return flgTangleDisplace(host.context, &displace, job); });
    make(host, [&](FlgJob* job) { return flgTangleGroup(host.context, tangle, bands.data(), 2, nullptr, job); });
    const uint32_t group = host.region(tangle, bands[0]).group;
    make(host, [&](FlgJob* job) { return flgTangleUngroup(host.context, tangle, group, nullptr, job); });
    desc = contour(tangle, first, borders(FLG_TANGLE_BORDERS_OUTER), 0.02f, 1);
    ASSERT_EQ(host.divide(desc), FLG_OK);
    make(host, [&](FlgJob* job) { return flgTangleJoin(host.context, tangle, first.data(), 1, nullptr, job); });
    ASSERT_EQ(host.divide(contour(tangle, first, samples(0.1f), 0.02f, 1)), FLG_OK);
    ASSERT_EQ(host.undo(tangle), FLG_OK);
    ASSERT_EQ(host.undo(tangle), FLG_OK);
}

TEST(TangleReplay, TheSameMeshGivesTheSameBitsWithAnyWorkersAndBudget) {
    const TangleHost host;
    const FlgSurface surface = host.surface(sphere(10));
    const FlgTangle tangle = host.tangle(surface);
    decorate(host, surface, tangle);
    ASSERT_FALSE(HasFailure());
    const FlgTangleInfo info = host.info(tangle);
    EXPECT_EQ(info.redo_count, 2u);
    const std::string expected = state(host, surface, tangle);
    const FlgTangleHistory history = history_of(host, tangle);
    EXPECT_EQ(history.step_count, info.undo_count + 2);
    EXPECT_EQ(history.made_count, info.undo_count);
    for (const auto& [workers, budget] : {std::pair{0u, FLG_UNLIMITED}, {0u, 100u}, {1u, FLG_UNLIMITED}, {2u, 50u}}) {
        const TangleHost other(workers, budget);
        const FlgSurface again = other.surface(sphere(10));
        const FlgTangle made = other.tangle(again);
        const Outcome outcome = replay(other, made, history);
        ASSERT_EQ(outcome.result, FLG_OK) << outcome.sentence;
        EXPECT_TRUE(state(other, again, made) == expected) << workers << " workers, " << budget << " us";
        // It has the history as its own: what was taken back can be made, and all be taken back.
        ASSERT_EQ(host.redo(tangle), FLG_OK);
        ASSERT_EQ(other.redo(made), FLG_OK);
        EXPECT_TRUE(state(other, again, made) == state(host, surface, tangle));
        ASSERT_EQ(host.undo(tangle), FLG_OK);
        for (uint32_t i = 0; i < info.undo_count + 1; ++i) ASSERT_EQ(other.undo(made), FLG_OK);
        EXPECT_EQ(other.info(made).leaf_count, 1u);
        EXPECT_EQ(history_of(other, made).step_count, history.step_count);
    }
}

TEST(TangleReplay, RandomSessionsComeToTheSameBits) {
    for (const uint64_t seed : {21u, 22u, 23u}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const TangleHost host, other;
        const FlgSurface surface = host.surface(cylinder(16, 6)), again = other.surface(cylinder(16, 6));
        const FlgTangle tangle = host.tangle(surface), made = other.tangle(again);
        RandomSession session(host, surface, tangle, seed);
        for (uint32_t i = 0; i < 30; ++i) {
            session.step();
            const bool back = session.draw(6) == 0 && host.info(tangle).undo_count > 0;
            if (back) host.undo(tangle);
        }
        const Outcome outcome = replay(other, made, history_of(host, tangle));
        ASSERT_EQ(outcome.result, FLG_OK) << outcome.sentence;
        EXPECT_TRUE(state(other, again, made) == state(host, surface, tangle));
        EXPECT_EQ(other.info(made).redo_count, host.info(tangle).redo_count);
        EXPECT_EQ(other.info(made).group_count, host.info(tangle).group_count);
    }
}

// ---- Other meshes

FlgSurface refined(const TangleHost& host, const MeshArrays& mesh) {
    FlgSurfaceRefineDesc desc = flgSurfaceRefineDefaults();
    desc.surface = host.start_surface(mesh);
    FlgSurface fine{};
    EXPECT_EQ(flgSurfaceRefine(host.context, &desc, &fine, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return fine;
}

// The areas of the leaves, rising.
std::vector<double> leaf_areas(const TangleHost& host, FlgSurface surface) {
    std::vector<double> list;
    for (const auto& [label, area] : areas(host.view(surface))) list.push_back(area);
    std::sort(list.begin(), list.end());
    return list;
}

// What was made on a mesh, made again on one with four times the triangles: as many regions, of about the same areas.
void expect_alike_when_refined(const MeshArrays& mesh, double tolerance,
                               const std::function<void(const TangleHost&, FlgSurface, FlgTangle)>& make_it) {
    const TangleHost host, other;
    const FlgSurface surface = host.surface(mesh), fine = refined(other, mesh);
    const FlgTangle tangle = host.tangle(surface), again = other.tangle(fine);
    const uint32_t before = other.view(fine).mesh->triangle_count;
    make_it(host, surface, tangle);
    ASSERT_FALSE(testing::Test::HasFailure());
    ASSERT_GT(host.info(tangle).leaf_count, 3u);
    const Outcome outcome = replay(other, again, history_of(host, tangle));
    ASSERT_EQ(outcome.result, FLG_OK) << outcome.sentence;
    EXPECT_GT(other.view(fine).mesh->triangle_count, before);
    const FlgTangleInfo expected = host.info(tangle), got = other.info(again);
    EXPECT_EQ(got.region_count, expected.region_count);
    EXPECT_EQ(got.leaf_count, expected.leaf_count);
    EXPECT_EQ(got.group_count, expected.group_count);
    EXPECT_EQ(got.depth, expected.depth);
    EXPECT_EQ(got.undo_count, expected.undo_count);
    EXPECT_EQ(got.redo_count, expected.redo_count);
    const std::vector<double> old_areas = leaf_areas(host, surface), new_areas = leaf_areas(other, fine);
    ASSERT_EQ(old_areas.size(), new_areas.size());
    const double whole = whole_area(host.view(surface));
    for (size_t i = 0; i < old_areas.size(); ++i) EXPECT_NEAR(new_areas[i], old_areas[i], tolerance * whole) << i;
    expect_valid(other, fine, again, whole_area(other.view(fine)));
    // What came of it is a history of the finer mesh, to the bit.
    const FlgTangleHistory history = history_of(other, again);
    const TangleHost third;
    const FlgSurface copy = refined(third, mesh);
    const FlgTangle made = third.tangle(copy);
    const Outcome same = replay(third, made, history);
    ASSERT_EQ(same.result, FLG_OK) << same.sentence;
    EXPECT_TRUE(state(third, copy, made) == state(other, fine, again));
}

TEST(TangleReplay, SamplesAndCellsAreWhereTheyWere) {
    expect_alike_when_refined(sphere(12), 2e-3, [](const TangleHost& host, FlgSurface, FlgTangle tangle) {
        FlgTangleDivideDesc cells = contour(tangle, root, samples(0.9f), 0.1f, 1);
        cells.kind = FLG_TANGLE_OPERATOR_VORONOI;
        cells.grouping = FLG_TANGLE_GROUPING_EACH;
        ASSERT_EQ(host.divide(cells), FLG_OK);
        // Of the cells, by their names: each second one is raised, two that touch a third are one with it.
        const Regions all = host.leaves(tangle);
        for (size_t i = 0; i < all.size(); i += 2) {
            const Regions one = {all[i]};
            ASSERT_EQ(host.divide(contour(tangle, one, borders(FLG_TANGLE_BORDERS_EACH), 0.08f, 1)), FLG_OK);
        }
        ASSERT_EQ(flgTangleUngroup(host.context, tangle, host.region(tangle, all[1]).group, nullptr, nullptr), FLG_OK);
        const Regions first = {all[0]};
        ASSERT_EQ(flgTangleJoin(host.context, tangle, first.data(), 1, nullptr, nullptr), FLG_OK);
        host.finish();
        ASSERT_EQ(host.undo(tangle), FLG_OK);
    });
}

TEST(TangleReplay, BordersBeginWhereTheyDid) {
    expect_alike_when_refined(cylinder(60, 20), 3e-3, [](const TangleHost& host, FlgSurface, FlgTangle tangle) {
        FlgTangleApplyMacroDesc grid = flgTangleApplyMacroDefaults();
        grid.tangle = tangle;
        grid.kind = FLG_TANGLE_MACRO_GRID;
        grid.regions = root.data();
        grid.region_count = 1;
        grid.count = 2;
        grid.size = 1.1f;
        make(host, [&](FlgJob* job) { return flgTangleApplyMacro(host.context, &grid, job); });
        const Regions cells = host.leaves(tangle);
        // Strips from a part of a cell's border.
        const FlgBorderStretch stretch = {0, 0.1f, 0.6f};
        FlgTangleSeeds seeds = flgTangleSeedsDefaults();
        seeds.stretches = &stretch;
        seeds.stretch_count = 1;
        const Regions last = {cells.back()};
        ASSERT_EQ(host.divide(contour(tangle, last, seeds, 0.15f, 1)), FLG_OK);
        FlgTangleSeeds spaced = flgTangleSeedsDefaults();
        spaced.border_spacing = 0.5f;
        const Regions first = {cells[0]};
        ASSERT_EQ(host.divide(contour(tangle, first, spaced, 0.1f, 1)), FLG_OK);
    });
}

TEST(TangleReplay, PointsAndLinesAreWhereTheyWere) {
    expect_alike_when_refined(sphere(12), 2e-3, [](const TangleHost& host, FlgSurface surface, FlgTangle tangle) {
        const std::array<FlgSurfacePoint, 3> points = {{{3, 0.25f, 0.5f}, {200, 0.3f, 0.3f}, {410, 0.1f, 0.2f}}};
        FlgTangleSeeds at_points = flgTangleSeedsDefaults();
        at_points.points = points.data();
        at_points.point_count = 3;
        FlgTangleDivideDesc desc = contour(tangle, root, at_points, 0.1f, 1);
        desc.kind = FLG_TANGLE_OPERATOR_POLYLINE;
        desc.closed = 1;
        ASSERT_EQ(host.divide(desc), FLG_OK);
        const FlgField heights = host.field(surface, [](const Point& p) { return p[2]; });
        FlgTangleSeeds at_lines = flgTangleSeedsDefaults();
        at_lines.curves = host.isolines(heights, {0.31f});
        ASSERT_EQ(host.divide(contour(tangle, root, at_lines, 0.15f, 1)), FLG_OK);
        FlgTangleDisplaceDesc displace = flgTangleDisplaceDefaults();
        displace.tangle = tangle;
        displace.regions = root.data();
        displace.region_count = 1;
        displace.amount = 0.02f;
        make(host, [&](FlgJob* job) { return flgTangleDisplace(host.context, &displace, job); });
    });
}

// ---- What is refused

class TangleReplayRefusals : public testing::Test {
protected:
    void SetUp() override {
        decorate(host, surface, tangle);
        history = history_of(host, tangle);
        for (uint32_t i = 0; i < history.step_count; ++i) steps.push_back(*history.steps[i]);
        for (const FlgTangleStep& step : steps) shown_steps.push_back(&step);
        history.steps = shown_steps.data();
    }
    void expect_refused(const std::string& part) {
        const std::string before = state(other, again, fresh);
        const Outcome outcome = replay(other, fresh, history);
        EXPECT_EQ(outcome.result, FLG_ERROR_INVALID_ARGUMENT) << part;
        EXPECT_NE(outcome.sentence.find(part), std::string::npos) << outcome.sentence;
        EXPECT_TRUE(state(other, again, fresh) == before) << part << ": nothing is changed";
        EXPECT_EQ(other.info(fresh).undo_count, 0u);
        EXPECT_EQ(other.info(fresh).redo_count, 0u);
    }
    FlgTangleStep& find(FlgTangleStepKind kind) {
        return *std::find_if(steps.begin(), steps.end(), [&](const FlgTangleStep& step) { return step.kind == kind; });
    }

    const TangleHost host, other;
    const FlgSurface surface = host.surface(sphere(10)), again = other.surface(sphere(10));
    const FlgTangle tangle = host.tangle(surface), fresh = other.tangle(again);
    FlgTangleHistory history{};
    std::vector<FlgTangleStep> steps;
    std::vector<const FlgTangleStep*> shown_steps;
};

TEST_F(TangleReplayRefusals, StructsThatCantBe) {
    const FlgTangleHistory good = history;
    history.struct_size = 4;
    expect_refused("history: struct_size is 4");
    history = good;
    history.made_count = history.step_count + 1;
    expect_refused("history.made_count");
    history = good;
    history.steps = nullptr;
    expect_refused("history.steps is null");
    history = good;
    history.box_min[1] = NAN;
    expect_refused("history.box_min");
    history = good;
    steps[1].struct_size = 0;
    expect_refused("history.steps[1]: step: struct_size is 0");
    steps[1].struct_size = sizeof(FlgTangleStep);
    steps[1].kind = static_cast<FlgTangleStepKind>(6);
    expect_refused("history.steps[1]: kind is 6");
    EXPECT_EQ(flgTangleReplay(other.context, fresh, nullptr, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
}

TEST_F(TangleReplayRefusals, StepsThatComeToSomethingElse) {
    FlgTangleStep& divide = find(FLG_TANGLE_STEP_KIND_DIVIDE);
    const FlgTangleStep good = divide;
    ASSERT_GT(good.made_count, 1u);
    --divide.made_count;
    expect_refused("history.steps[0]: the tangle has");
    divide = good;
    ++divide.first_region;
    expect_refused("made by another version");
}

TEST_F(TangleReplayRefusals, StepsThatCantBeMade) {
    FlgTangleStep& divide = find(FLG_TANGLE_STEP_KIND_DIVIDE);
    const FlgTangleStep good = divide;
    FlgTangleDivideDesc desc = *divide.divide;
    divide.divide = nullptr;
    expect_refused("history.steps[0]: divide is null");
    divide.divide = &desc;
    desc.delta = NAN;
    expect_refused("history.steps[0]: desc.delta");
    desc = *good.divide;
    const uint32_t none[] = {77};
    desc.regions = none;
    expect_refused("history.steps[0]: desc.regions[0] is 77");
    divide = good;
    // The last step made fails: all before it are taken back.
    FlgTangleStep& join = find(FLG_TANGLE_STEP_KIND_JOIN);
    const FlgTangleStep good_join = join;
    const uint32_t beyond[] = {1'000'000};
    join.regions = beyond;
    expect_refused("regions[0] is 1000000");
    join = good_join;
    join.region_count = 0;
    expect_refused("region_count");
    join = good_join;
    FlgTangleStep& ungroup = find(FLG_TANGLE_STEP_KIND_UNGROUP);
    ungroup.group = 1'000'000;
    expect_refused("group is 1000000");
}

TEST_F(TangleReplayRefusals, PlacesThatCantBe) {
    FlgTangleStep& divide = find(FLG_TANGLE_STEP_KIND_DIVIDE);
    const FlgTangleStep good = divide;
    divide.place_count = 0;
    divide.placed = 1;
    expect_refused("place_count is 0, but the step is placed");
    divide = good;
    divide.place_count = 1;
    expect_refused("place_count is 1, must be 0 or 2");
    divide = good;
    FlgTangleSeedPlaces places[] = {*divide.places[0], *divide.places[1]};
    const FlgTangleSeedPlaces* const shown[] = {&places[0], &places[1]};
    divide.places = shown;
    places[0].point_count = 3;
    expect_refused("places.point_count is 3, but the seeds have 0 points");
    places[0] = *good.places[0];
    const float bad[] = {0, NAN, 0};
    places[0].loops = bad;
    places[0].loop_count = 1;
    expect_refused("places.loops[1] is nan");
    places[0] = *good.places[0];
    divide.made = bad;
    divide.made_count = 1;
    expect_refused("made[1] is nan");
    divide = good;
    // Lines: the stream has them.
    const auto lines = std::find_if(steps.begin(), steps.end(), [](const FlgTangleStep& step) {
        return step.place_count > 0 && step.places[0]->curves != nullptr;
    });
    ASSERT_NE(lines, steps.end());
    FlgTangleSeedPlaces of_lines[] = {*lines->places[0], *lines->places[1]};
    const FlgTangleSeedPlaces* const shown_lines[] = {&of_lines[0], &of_lines[1]};
    lines->places = shown_lines;
    const FlgSurfaceCurvesView view = *of_lines[0].curves;
    FlgSurfaceCurvesView changed = view;
    of_lines[0].curves = &changed;
    const std::vector<uint32_t> offsets(view.curve_offsets, view.curve_offsets + view.curve_count + 1);
    std::vector<uint32_t> falling = offsets;
    falling[1] = 1;
    changed.curve_offsets = falling.data();
    expect_refused("curves.curve_offsets[1] is 1 after 0");
    changed = view;
    std::vector<FlgSurfacePoint> points(view.points, view.points + offsets.back());
    changed.points = points.data();
    points[2].triangle = 10'000'000;
    expect_refused("curves.points[2] is in triangle 10000000");
    points[2] = {0, 2, 0};
    expect_refused("curves.points[2] has the weights");
}

TEST_F(TangleReplayRefusals, AnotherShape) {
    history.base ^= 1;
    history.box_max[0] += 1;
    expect_refused("another shape");
}

TEST_F(TangleReplayRefusals, NamesThatNoStepMadeOnAnotherMesh) {
    history.base ^= 1;
    const uint32_t beyond[] = {1'000'000};
    FlgTangleStep& group = find(FLG_TANGLE_STEP_KIND_GROUP);
    const FlgTangleStep good = group;
    group.regions = beyond;
    group.region_count = 1;
    expect_refused("regions[0] is 1000000, the history has made");
    group = good;
    steps[0].first_region = 5;
    expect_refused("first_region is 5, but 1 regions come before it");
}

TEST_F(TangleReplayRefusals, ATangleThatHasSteps) {
    ASSERT_EQ(other.divide(contour(fresh, root, samples(0.9f), 0.1f, 1)), FLG_OK);
    const Outcome outcome = replay(other, fresh, history);
    EXPECT_EQ(outcome.result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(outcome.sentence.find("has steps already"), std::string::npos) << outcome.sentence;
    EXPECT_EQ(other.info(fresh).undo_count, 1u);
}

TEST(TangleReplay, HistoriesAreNotReadyWhileTheTangleChanges) {
    const TangleHost host;
    const FlgSurface surface = host.surface(plane(6));
    const FlgTangle tangle = host.tangle(surface);
    const FlgTangleDivideDesc desc = contour(tangle, root, borders(FLG_TANGLE_BORDERS_OUTER), 0.1f, 1);
    ASSERT_EQ(flgTangleDivide(host.context, &desc, nullptr), FLG_OK);
    FlgTangleHistory history{};
    EXPECT_EQ(flgTangleGetHistory(host.context, tangle, &history), FLG_ERROR_INVALID_ARGUMENT) << "no struct_size";
    history.struct_size = sizeof history;
    EXPECT_EQ(flgTangleGetHistory(host.context, tangle, &history), FLG_NOT_READY);
    EXPECT_EQ(history.step_count, 0u);
    host.finish();
    EXPECT_EQ(flgTangleGetHistory(host.context, tangle, &history), FLG_OK);
    EXPECT_EQ(history.step_count, 1u);
}

// Each allocation fails once, of showing the history and of making it again: tangles stay whole, nothing is lost.
TEST(TangleReplay, WithoutMemoryNothingIsChanged) {
    const TangleHost source;
    const FlgSurface model = source.surface(cylinder(8, 3));
    const FlgTangle tangle = source.tangle(model);
    ASSERT_EQ(source.divide(contour(tangle, root, borders(FLG_TANGLE_BORDERS_OUTER), 0.2f, 1)), FLG_OK);
    ASSERT_EQ(source.divide(contour(tangle, root, samples(0.6f), 0.1f, 1)), FLG_OK);
    ASSERT_EQ(source.undo(tangle), FLG_OK);
    const FlgTangleHistory original = history_of(source, tangle);
    for (const bool same : {true, false}) {
        FlgTangleHistory history = original;
        if (!same) history.base ^= 1;
        int64_t calls = 1;
        for (int64_t fail_at = -1; fail_at < calls; fail_at += fail_at < 0 ? 1 : 1 + calls / 150) {
            TangleHost host;
            const FlgSurface surface = host.surface(cylinder(8, 3));
            const FlgTangle fresh = host.tangle(surface);
            const std::string before = state(host, surface, fresh);
            host.allocator.calls = 0;
            host.allocator.fail_at = fail_at;
            const Outcome outcome = replay(host, fresh, history);
            FlgTangleHistory shown{};
            shown.struct_size = sizeof shown;
            const FlgResult showing = flgTangleGetHistory(host.context, fresh, &shown);
            host.allocator.fail_at = -1;
            if (fail_at < 0) calls = host.allocator.calls;
            EXPECT_TRUE(outcome.result == FLG_OK || (fail_at >= 0 && outcome.result == FLG_ERROR_OUT_OF_MEMORY))
                << fail_at << ": " << outcome.sentence;
            EXPECT_TRUE(showing == FLG_OK || (fail_at >= 0 && showing == FLG_ERROR_OUT_OF_MEMORY)) << fail_at;
            if (outcome.result == FLG_OK) {
                EXPECT_EQ(host.info(fresh).redo_count, 1u);
            } else {
                EXPECT_TRUE(state(host, surface, fresh) == before) << fail_at;
                EXPECT_EQ(host.info(fresh).undo_count + host.info(fresh).redo_count, 0u);
                const Outcome second = replay(host, fresh, history);
                EXPECT_EQ(second.result, FLG_OK) << second.sentence;
            }
            EXPECT_EQ(host.redo(fresh), FLG_OK);
            expect_valid(host, surface, fresh, whole_area(host.view(surface)));
            if (HasFailure()) return;
        }
    }
}

}  // namespace
}  // namespace flg::test
