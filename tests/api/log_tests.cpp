// SPDX-License-Identifier: MIT
// Input that was repaired, or lost something, is named in the host's log: one sentence an object, with the counts,
// inside the tick that publishes it. Clean input is not worth a word.
#include <thread>

#include "api/live_inputs.h"
#include "api/part_inputs.h"
#include "api/surface_inputs.h"
#include "filigree/filigree_project.h"
#include "filigree/filigree_skeleton.h"

namespace flg::test {
namespace {

// What was written, each with its level.
struct Log {
    std::vector<std::string> lines;
    std::thread::id thread = std::this_thread::get_id();
    FlgLog hook{
        sizeof(FlgLog), this, [](void* self, FlgLogLevel level, const char* message) {
            auto& log = *static_cast<Log*>(self);
            EXPECT_EQ(std::this_thread::get_id(), log.thread);
            log.lines.push_back((level == FLG_LOG_LEVEL_WARNING ? "warning: " : "other: ") + std::string(message));
        }};

    FlgContextDesc desc(uint32_t workers = 1) const {
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = workers;
        desc.log = &hook;
        return desc;
    }
    void expect(const std::vector<std::string>& expected) {
        EXPECT_EQ(lines, expected);
        lines.clear();
    }
};

std::string named(const char* object, uint64_t handle, const char* rest) {
    char line[512];
    std::snprintf(line, sizeof line, "warning: %s (0x%llx) %s", object, static_cast<unsigned long long>(handle), rest);
    return line;
}

TEST(Log, NamesAStyleThatHasNothingToLearn) {
    Log log;
    const FlgContextDesc context = log.desc();
    const Host host(context);
    FlgStyleDesc desc = flgStyleDefaults();
    Curves line;
    for (const double x : {0.0, 1.0, 2.5}) line.add_point(x, 0, 0);
    line.end_curve();
    for (const bool straight : {true, false}) {
        desc.style = host.create(straight ? line : coil());
        FlgStyle style{};
        ASSERT_EQ(flgStyleCreate(host.context, &desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        log.expect(straight ? std::vector{named("style", style.id,
                                                "has nothing to learn: its example is its own guide, straight or "
                                                "without waves")}
                            : std::vector<std::string>{});
    }
}

TEST(Log, NamesWhatWasRepairedOfASurface) {
    Log log;
    const SurfaceHost host(log.desc());
    MeshArrays mesh = plane(2);
    mesh.add_vertex(9, 9, 9);                         // unused
    mesh.add_triangle(0, 0, 1);                       // degenerate
    mesh.add_triangle(0, 1, 4);                       // there already
    std::swap(mesh.triangles[3], mesh.triangles[4]);  // the other way around
    const FlgSurface surface = host.start_surface(mesh);
    log.expect({});  // not before it is published
    host.finish();
    log.expect({named("surface", surface.id,
                      "was repaired: 1 unused vertices dropped, 1 degenerate triangles dropped, 1 duplicate triangles "
                      "dropped, 1 triangles flipped")});
    FlgSurfaceReport report = flgSurfaceReportDefaults();
    ASSERT_EQ(flgSurfaceGetReport(host.context, surface, &report), FLG_OK);
    EXPECT_EQ(report.flipped_triangles, 1u);
    host.finish();
    log.expect({});  // once
}

TEST(Log, NamesWeldedVertices) {
    Log log;
    const SurfaceHost host(log.desc(0));
    const FlgSurface surface = host.start_surface(cube(1));
    host.finish();
    log.expect({named("surface", surface.id, "was repaired: 16 vertices welded")});
}

TEST(Log, SaysNothingOfCleanInput) {
    Log log;
    const SurfaceHost host(log.desc());
    const FlgSurface surface = host.start_surface(plane(3));
    FlgSurfaceRefineDesc refine = flgSurfaceRefineDefaults();
    refine.surface = surface;
    FlgSurface fine{};
    ASSERT_EQ(flgSurfaceRefine(host.context, &refine, &fine, nullptr), FLG_OK) << flgErrorGetMessage();
    host.start_distances(surface, 0);
    host.finish();
    log.expect({});
}

// A job that fails is an error, and no warning beside it.
TEST(Log, HasOneLineForWhatFailed) {
    Log log;
    const SurfaceHost host(log.desc());
    MeshArrays mesh = plane(1);
    mesh.triangles[0] = 77;
    host.start_surface(mesh);
    host.finish();
    ASSERT_EQ(log.lines.size(), 1u);
    EXPECT_EQ(log.lines[0].find("other: job "), 0u) << log.lines[0];
}

FlgStraightSkeleton skeleton_of(const Host& host, const std::vector<double>& points, bool repair) {
    FlgContourView contour = flgContourViewDefaults();
    contour.points = points.data();
    contour.point_count = static_cast<uint32_t>(points.size() / 2);
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.contour = &contour;
    desc.repair = repair;
    FlgStraightSkeleton skeleton{};
    EXPECT_EQ(flgStraightSkeletonCreate(host.context, &desc, &skeleton, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    return skeleton;
}

TEST(Log, NamesContoursThatWereCleanedOrRepaired) {
    Log log;
    const Host host(log.desc());
    const std::vector<double> square = {0, 0, 4, 0, 4, 4, 0, 4};
    skeleton_of(host, square, false);
    skeleton_of(host, square, true);
    log.expect({});
    // The first point is there again at the end, and one in between.
    const FlgStraightSkeleton closed = skeleton_of(host, {0, 0, 4, 0, 4, 0, 4, 4, 0, 4, 0, 0}, false);
    log.expect({named("straight skeleton", closed.id, "has another contour than was given: 2 points dropped")});
    // A bow whose larger half stays: two points of it, and where its edges cross.
    const FlgStraightSkeleton bow = skeleton_of(host, {0, 0, 6, 4, 6, 0, 0, 2}, true);
    log.expect({named("straight skeleton", bow.id,
                      "has another contour than was given: 2 points dropped, 1 points added where edges cross, 1 "
                      "smaller pieces left out")});
}

TEST(Log, NamesPartsWhoseContourChanged) {
    Log log;
    const PartHost host(log.desc());
    std::vector<double> ellipse;
    for (int i = 0; i < 60; ++i) {
        ellipse.push_back(3 * std::cos(2 * M_PI * i / 60));
        ellipse.push_back(std::sin(2 * M_PI * i / 60));
    }
    host.part(ellipse);
    host.finish();
    log.expect({});
    ellipse.insert(ellipse.end(), {ellipse[0], ellipse[1]});
    const FlgPart part = host.part(ellipse);
    host.finish();
    log.expect({named("part", part.id, "has another contour than was given: 1 points dropped")});
}

TEST(Log, NamesPiecesThatAnOutlineLacks) {
    Log log;
    const SurfaceHost host(log.desc());
    const auto outline = [&](MeshArrays mesh) {
        FlgOutlineDesc desc = flgOutlineDefaults();
        desc.surface = host.start_surface(std::move(mesh));
        FlgOutline out{};
        EXPECT_EQ(flgOutlineCreate(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        return out;
    };
    outline(plane(3));
    log.expect({});
    const FlgOutline largest = outline(loose_triangles(3));
    log.expect({named("outline", largest.id, "is not all that is seen: 2 smaller pieces left out")});
}

TEST(Log, NamesProjectedCurvesThatCameToAPoint) {
    Log log;
    const SurfaceHost host(log.desc());
    const FlgSurface surface = host.start_surface(plane(4));
    const auto project = [&](double length) {
        Curves curves;
        for (const double metres : {0.5, length}) {
            curves.add_point(0.2, 0.4, 0.1);
            curves.add_point(0.2 + metres, 0.4, 0.1);
            curves.end_curve();
        }
        FlgCurveSetProjectDesc desc = flgCurveSetProjectDefaults();
        desc.surface = surface;
        desc.curves = host.create(curves);
        FlgSurfaceCurves out{};
        EXPECT_EQ(flgCurveSetProject(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
        return out;
    };
    project(0.3);
    log.expect({});
    const FlgSurfaceCurves out = project(0);
    log.expect({named("surface curves", out.id, "are not all: 1 curves left out that came to a single point")});
}

TEST(Log, NamesStrokesThatWereCut) {
    Log log;
    LiveHost host(1, nullptr, nullptr, &log.hook);
    const Samples samples = drawn(60);
    const auto end = [&](uint32_t max_points) {
        host.live.max_points = max_points;
        const FlgLiveStroke stroke = host.begin();
        host.push_in_bursts(stroke, Samples(samples.begin(), samples.end() - 1), {1});
        EXPECT_EQ(push_samples(host.context, stroke, &samples.back(), 1, nullptr), FLG_OK) << flgErrorGetMessage();
        const LiveHost::Ended ended = host.end(stroke);
        host.finish();
        return std::pair(stroke, host.view_of(ended.stylized).curve_offsets[1]);
    };
    const auto [whole, points] = end(8192);
    log.expect({});
    const auto [cut, fewer] = end(points - 1);
    const std::string rest =
        "was cut at " + std::to_string(points - 1) + " points: its samples need more than max_points";
    log.expect({named("live stroke", cut.id, rest.c_str())});
    EXPECT_EQ(fewer, points - 1);
}

}  // namespace
}  // namespace flg::test
