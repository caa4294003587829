// SPDX-License-Identifier: MIT
// filigree spline: a smooth curve through points, on a surface or among obstacles.
#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "choices.h"
#include "command.h"
#include "documents/failure.h"
#include "documents/space_lines.h"
#include "documents/text_file.h"
#include "path_curves.h"
#include "spline_beside.h"
#include "spline_cable.h"
#include "spline_manifold.h"
#include "spline_obstacles.h"
#include "spline_road.h"

namespace flg::cli {
namespace {

enum class Fit { none, bezier, hermite };

struct Options {
    std::string surface, points, output, obstacles, fit_output;
    Fit fit = Fit::none;
    double fit_tolerance = 1e-3;
    std::vector<uint32_t> corners;
    FlgSplineEnergy energy = FLG_SPLINE_ENERGY_E2;
    double tension = 1, smoothing = 0, smoothing_scale = 0, tolerance = 1e-6, feature = 0, layer = 0;
    float height = 0;
    uint32_t nodes = 0, rounds = 200;
    bool closed = false, inside = false, over_triangles = false, on_mesh = false;
    FlgSplineStart start = FLG_SPLINE_START_GEODESIC;
    uint64_t evaluations = flgSplineDefaults().max_evaluations;
    RoadOptions road;
    BesideOptions beside;
    CableOptions cable;
};

const std::map<std::string, FlgSplineEnergy>& energy_names() {
    static const std::map<std::string, FlgSplineEnergy> names = {
        {"e1", FLG_SPLINE_ENERGY_E1}, {"e2", FLG_SPLINE_ENERGY_E2}, {"et", FLG_SPLINE_ENERGY_ET}};
    return names;
}
const std::map<std::string, FlgSplineStart>& start_names() {
    static const std::map<std::string, FlgSplineStart> names = {{"geodesic", FLG_SPLINE_START_GEODESIC},
                                                                {"projected", FLG_SPLINE_START_PROJECTED}};
    return names;
}
const std::map<std::string, Fit>& fit_names() {
    static const std::map<std::string, Fit> names = {{"bezier", Fit::bezier}, {"hermite", Fit::hermite}};
    return names;
}
const char* ending_name(FlgSplineEnding ending) {
    return ending == FLG_SPLINE_ENDING_CONVERGED   ? "converged"
           : ending == FLG_SPLINE_ENDING_ROUNDING  ? "rounding"
           : ending == FLG_SPLINE_ENDING_STALLED   ? "stalling"
           : ending == FLG_SPLINE_ENDING_TRIANGLES ? "triangles"
                                                   : "rounds";
}

// One spline for each curve of the file.
struct Made {
    FlgSpline spline = {};
    FlgSplineView view = {};
    std::string subject;
};

Made make_one(Session& session, const Options& options, const SplineManifold& manifold,
              const SplineObstacles* obstacles, const SpaceLines& lines, uint32_t line, Report& report) {
    Made made;
    made.subject = options.points + (lines.count() > 1 ? ": curve " + std::to_string(line) : "");
    const uint32_t n = manifold.view.ambient;
    std::vector<double> points;
    for (uint32_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i) {
        // Only in space there are origins.
        for (uint32_t c = 0; c < n; ++c)
            points.push_back(lines.positions[size_t{3} * i + c] + (n == 3 ? 0 : lines.origin[c]));
    }
    FlgSplineDesc desc;
    flgSplineDescInit(&desc, sizeof desc);
    desc.manifold = manifold.handle;
    if (n == 3) std::copy(lines.origin.begin(), lines.origin.end(), desc.origin);
    desc.points = points.data();
    desc.point_count = static_cast<uint32_t>(points.size() / n);
    desc.closed = options.closed || (lines.flags[line] & FLG_CURVE_CLOSED) != 0;
    desc.energy = options.energy;
    desc.tension = options.tension;
    desc.smoothing = options.smoothing;
    desc.tolerance = options.tolerance;
    desc.node_count = options.nodes;
    desc.max_rounds = options.rounds;
    desc.start = options.start;
    std::vector<FlgSplineHandle> corners;
    for (const uint32_t point : options.corners) {
        corners.push_back(flgSplineHandleDefaults());
        corners.back().point = point;
    }
    desc.handles = corners.data();
    desc.handle_count = static_cast<uint32_t>(corners.size());
    if (options.fit != Fit::none) desc.key_tolerance = options.fit_tolerance;
    desc.on_triangles = options.over_triangles;
    desc.surface_points = options.on_mesh;
    if (obstacles) {
        desc.obstacles = obstacles->handle;
        desc.max_evaluations = options.evaluations;
        desc.sides = obstacles->sides.data();
        desc.side_count = static_cast<uint32_t>(obstacles->sides.size());
    }
    FlgJob job = {};
    check(flgSplineCreate(session.context(), &desc, &made.spline, &job), made.subject);
    session.finish({{{job, made.subject}}}, report);
    flgSplineViewInit(&made.view, sizeof made.view);
    check(flgSplineGetView(session.context(), made.spline, &made.view), made.subject);
    return made;
}

// Far from the world's origin to all its digits.
void append_number(std::string& text, double value, double origin) {
    char number[32];
    char* const end = number + sizeof number;
    text.append(number, origin == 0 ? std::to_chars(number, end, value, std::chars_format::general, 9).ptr
                                    : std::to_chars(number, end, value + origin).ptr);
}

// What is written of a spline.
struct Drawn {
    std::vector<Vector> places, normals;  // one a point; normals may be none
    bool closed = false;
    Vector origin = {};
};

Drawn nodes_of(const FlgSplineView& view) {
    Drawn out{.places = {}, .normals = {}, .closed = view.closed != 0};
    std::copy(std::begin(view.origin), std::end(view.origin), out.origin.begin());
    for (uint32_t i = 0; i < view.node_count; ++i) {
        Vector place = {};
        std::copy_n(view.nodes + size_t{view.ambient} * i, std::min(view.ambient, 3u), place.begin());
        out.places.push_back(place);
        const float* const n = view.normals + size_t{3} * i;
        if (view.normals) out.normals.push_back({n[0], n[1], n[2]});
    }
    return out;
}

// Over the triangles, wherever it passes from one to another; beside a curve there may be more than one.
std::vector<Drawn> trace_of(Session& session, const MeshSurface& mesh, const Made& made, double offset,
                            Report& report) {
    FlgSplineTraceDesc desc;
    flgSplineTraceDescInit(&desc, sizeof desc);
    desc.spline = made.spline;
    desc.offset = offset;
    FlgSurfaceCurves traced = {};
    FlgJob job = {};
    check(flgSplineTrace(session.context(), &desc, &traced, &job), made.subject);
    session.finish({{{job, made.subject}}}, report);
    const FlgSurfaceCurvesView view = view_of(session.context(), traced);
    const FlgSurfaceView surface = mesh.view();
    std::vector<Drawn> all;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        Drawn& out = all.emplace_back();
        out.closed = (view.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
        out.origin = origin_of(*surface.mesh);
        for (uint32_t i = view.curve_offsets[c]; i < view.curve_offsets[c + 1]; ++i) {
            const FlgSurfacePoint& point = view.points[i];
            const uint32_t* const corners = surface.mesh->triangles + size_t{3} * point.triangle;
            const double u = point.u, v = point.v;
            out.places.push_back((1 - u - v) * vertex_at(*surface.mesh, corners[0]) +
                                 u * vertex_at(*surface.mesh, corners[1]) + v * vertex_at(*surface.mesh, corners[2]));
            out.normals.push_back(unit(area_vector(*surface.mesh, point.triangle)));
        }
    }
    return all;
}

Drawn curve_of(const FlgCurveSetView& view) {
    Drawn out{.places = {}, .normals = {}, .closed = (view.curve_flags[0] & FLG_CURVE_CLOSED) != 0};
    std::copy(std::begin(view.origin), std::end(view.origin), out.origin.begin());
    const float* const places = flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_POSITION)->data;
    const float* const normals = flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_NORMAL)->data;
    for (size_t i = 0; i < view.curve_offsets[1]; ++i) {
        out.places.push_back({places[3 * i], places[3 * i + 1], places[3 * i + 2]});
        out.normals.push_back({normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]});
    }
    return out;
}

// In double precision, not through a curve set's floats.
std::string xyz_text(const std::vector<Drawn>& all) {
    std::string text;
    for (const Drawn& drawn : all) {
        if (!text.empty()) text += '\n';
        if (drawn.closed) text += "# closed\n";
        for (const Vector& place : drawn.places) {
            for (size_t c = 0; c < 3; ++c) {
                append_number(text, place[c], drawn.origin[c]);
                text += c == 2 ? '\n' : ' ';
            }
        }
    }
    return text;
}

void write_output(Session& session, std::vector<Drawn> all, const Options& options) {
    for (Drawn& drawn : all) {
        for (size_t i = 0; i < drawn.normals.size(); ++i)
            drawn.places[i] = drawn.places[i] + double{options.height} * drawn.normals[i];
    }
    if (options.output.ends_with(".xyz")) return write_text_file(options.output, xyz_text(all));
    SpaceLines lines;
    for (const Drawn& drawn : all) {
        lines.origin = drawn.origin;
        for (size_t i = 0; i < drawn.places.size(); ++i) {
            if (drawn.normals.empty()) {
                lines.add(drawn.places[i]);
            } else {
                lines.add(drawn.places[i], drawn.normals[i]);
            }
        }
        lines.end_line(drawn.closed);
    }
    write_curves(session.context(), create_set(session.context(), lines, options.output), options.output);
}

// A number list for each point of a row.
nlohmann::ordered_json rows_of(const std::vector<double>& numbers, uint32_t width) {
    auto rows = nlohmann::ordered_json::array();
    for (size_t i = 0; i < numbers.size(); i += width)
        rows.push_back(std::vector<double>(numbers.begin() + static_cast<std::ptrdiff_t>(i),
                                           numbers.begin() + static_cast<std::ptrdiff_t>(i + width)));
    return rows;
}

// A curve's keys, or the control points of its Bezier pieces, each piece beginning with the last point of the one
// before.
nlohmann::ordered_json fitted(const FlgSplineView& view, Fit fit) {
    const uint32_t n = view.ambient;
    const size_t count = size_t{n} * view.key_count;
    std::vector<double> points(view.key_points, view.key_points + count);
    for (size_t i = 0; i < count && n == 3; ++i) points[i] += view.origin[i % 3];
    nlohmann::ordered_json json = {
        {"closed", view.closed != 0},
        {"largest_error", view.largest_key_error},
        {"parameters", std::vector<double>(view.key_parameters, view.key_parameters + view.key_count)}};
    if (fit == Fit::hermite) {
        json["points"] = rows_of(points, n);
        json["arriving"] = rows_of({view.key_arriving, view.key_arriving + count}, n);
        json["leaving"] = rows_of({view.key_leaving, view.key_leaving + count}, n);
        return json;
    }
    std::vector<double> control(points.begin(), points.begin() + n);
    for (uint32_t k = 0; k + 1 < view.key_count; ++k) {
        const double third = (view.key_parameters[k + 1] - view.key_parameters[k]) / 3;
        const size_t at = size_t{n} * k, next = at + n;
        for (uint32_t c = 0; c < n; ++c) control.push_back(points[at + c] + third * view.key_leaving[at + c]);
        for (uint32_t c = 0; c < n; ++c) control.push_back(points[next + c] - third * view.key_arriving[next + c]);
        for (uint32_t c = 0; c < n; ++c) control.push_back(points[next + c]);
    }
    json["control_points"] = rows_of(control, n);
    return json;
}

void write_fit(const std::vector<Made>& all, const Options& options, Report& report) {
    auto curves = nlohmann::ordered_json::array();
    uint32_t keys = 0;
    double error = 0;
    for (const Made& made : all) {
        curves.push_back(fitted(made.view, options.fit));
        keys += made.view.key_count;
        error = std::max(error, made.view.largest_key_error);
    }
    report.counts["keys"] = keys;
    report.quality["largest_fit_error"] = error;
    const nlohmann::ordered_json file = {{"fit", name_of(fit_names(), options.fit)}, {"curves", std::move(curves)}};
    write_text_file(options.fit_output, file.dump(1) + "\n");
}

void describe(const Options& options, Report& report) {
    report.parameters["surface"] = options.surface;
    report.parameters["points"] = options.points;
    report.parameters["energy"] = name_of(energy_names(), options.energy);
    if (options.energy == FLG_SPLINE_ENERGY_ET) report.parameters["tension"] = options.tension;
    report.parameters["smoothing"] = options.smoothing;
    if (options.smoothing_scale > 0) report.parameters["smoothing_scale"] = options.smoothing_scale;
    report.parameters["tolerance"] = options.tolerance;
    if (options.feature > 0) report.parameters["feature"] = options.feature;
    if (options.layer > 0) report.parameters["layer"] = options.layer;
    if (!options.obstacles.empty()) report.parameters["obstacles"] = options.obstacles;
}

// The curve itself, one beside it, or one over the triangles.
std::vector<Drawn> drawn_of(Session& session, const Options& options, const SplineManifold& manifold, const Made& made,
                            Report& report) {
    if (options.on_mesh) return trace_of(session, *manifold.mesh, made, options.beside.left, report);
    if (!options.beside.is_wanted()) return {nodes_of(made.view)};
    return {curve_of(curve_beside(session, options.beside, made.spline, made.subject, report))};
}

void run_cables(Session& session, const Options& options, const SpaceLines& lines, FlgObstacles obstacles,
                Report& report) {
    report.parameters["slack"] = options.cable.slack;
    const FlgCurveSet set = hang_cables(session, options.cable, lines, obstacles, options.points, report);
    write_curves(session.context(), set, options.output);
    report.write();
}

void run_spline(const Options& options, const CommonOptions& common) {
    require_curve_output(options.output);
    require_writable(common.report);
    if ((options.fit != Fit::none) != !options.fit_output.empty())
        throw UsageError("--fit and --fit-output go together");
    if (options.fit != Fit::none) require_writable(options.fit_output);
    check_road_options(options.road);
    check_beside_options(options.beside, options.on_mesh);
    if (options.cable.is_wanted && options.surface != "space")
        throw UsageError("--cable: SURFACE must be space, not " + options.surface);
    Report report("spline", common);
    describe(options, report);
    Session session(common);
    const SpaceLines lines = read_lines(options.points, report);
    const bool among = !options.obstacles.empty();
    const SplineManifold manifold = make_spline_manifold(
        session, options.surface,
        {.among_obstacles = among, .feature = options.feature, .smoothing_scale = options.smoothing_scale}, report);
    std::optional<FlgObstacle> border;
    if (options.inside || options.layer > 0) border = border_of(manifold, options.layer);
    std::optional<SplineObstacles> obstacles;
    if (among || border)
        obstacles =
            read_obstacles(session, options.obstacles, manifold.view.ambient, report, border ? &*border : nullptr);
    if (options.on_mesh && !manifold.mesh)
        throw UsageError("--on-mesh: SURFACE must be a mesh, not " + options.surface);
    if (options.cable.is_wanted)
        return run_cables(session, options, lines, obstacles ? obstacles->handle : FlgObstacles{}, report);
    std::vector<Made> all;
    std::vector<Drawn> drawn;
    uint32_t rounds = 0, nodes = 0, held = 0;
    double energy = 0, residual = 0, offset = 0, length = 0, moved = 0;
    for (uint32_t line = 0; line < lines.count(); ++line) {
        all.push_back(make_one(session, options, manifold, obstacles ? &*obstacles : nullptr, lines, line, report));
        const FlgSplineView& view = all.back().view;
        rounds += view.rounds;
        for (Drawn& one : drawn_of(session, options, manifold, all.back(), report)) {
            nodes += static_cast<uint32_t>(one.places.size());
            drawn.push_back(std::move(one));
        }
        moved = std::max(moved, view.largest_moved);
        held += view.held_count;
        energy += view.energy;
        length += view.length;
        residual = std::max(residual, view.residual);
        offset = std::max(offset, view.largest_offset);
        if (view.largest_offset > 0.5 * manifold.view.size) {
            report.warn(all.back().subject + ": a point is " + std::to_string(view.largest_offset) +
                        " m off the surface, which is about " + std::to_string(manifold.view.size) + " m large");
        }
        if (view.held_count > 0) {
            const double* const at = view.nodes + size_t{view.ambient} * view.held_nodes[0];
            std::string place;
            for (uint32_t c = 0; c < 3; ++c) {
                if (c > 0) place += ' ';
                append_number(place, at[c], view.origin[c]);
            }
            report.warn(all.back().subject + ": " + std::to_string(view.held_count) +
                        (view.held_count == 1 ? " point is" : " points are") +
                        " held where the surface has a sharp edge, the first at " + place +
                        "; --smoothing-scale rounds edges off");
        }
        if (view.ending == FLG_SPLINE_ENDING_EVALUATIONS) {
            report.warn(all.back().subject + ": --evaluations were used up, so the curve keeps clear, but may be " +
                        "farther from the obstacles than it has to");
        } else if (view.ending == FLG_SPLINE_ENDING_TRIANGLES) {
            if (options.over_triangles) continue;
            report.warn(all.back().subject +
                        ": the smooth surface can't be reached, so this is the curve over the triangles; "
                        "--smoothing-scale may help");
        } else if (view.ending != FLG_SPLINE_ENDING_CONVERGED) {
            report.warn(all.back().subject + ": ended by " + ending_name(view.ending) + ", with a residual of " +
                        std::to_string(view.residual));
        }
    }
    report.counts["points"] = lines.offsets.back();
    report.counts["curves"] = lines.count();
    report.counts["curve_points"] = nodes;
    if (held > 0) report.counts["held_points"] = held;
    report.quality["iterations"] = rounds;
    report.quality["energy"] = energy;
    report.quality["residual"] = residual;
    report.quality["length"] = length;
    report.quality["largest_offset"] = offset;
    if (options.on_mesh) report.quality["largest_moved"] = moved;
    if (options.fit != Fit::none) write_fit(all, options, report);
    if (options.road.is_wanted()) {
        std::vector<FlgSpline> splines;
        for (const Made& made : all) splines.push_back(made.spline);
        write_roads(session, options.road, manifold.mesh != nullptr, splines, report);
    }
    write_output(session, std::move(drawn), options);
    report.write();
}

}  // namespace

Command add_spline(CLI::App& program, const CommonOptions& common) {
    CLI::App* app =
        program.add_subcommand("spline", "Lays a smooth curve through points, on a surface or around obstacles");
    const auto o = std::make_shared<Options>();
    app->add_option("SURFACE", o->surface,
                    "Where it stays: a mesh (.ply, .obj, .off, .glb), a cloud of points (.xyz), sphere:R, torus:R,r, "
                    "plane (z = 0), "
                    "implicit:NAME, or space")
        ->required();
    app->add_option("POINTS", o->points,
                    "The points (metres), a curve for each block of the file: .xyz, .obj or .glb. Those off the "
                    "surface are projected")
        ->required();
    app->add_option("-o,--output", o->output, "Result: .xyz, .obj or .glb")->required()->type_name("CURVE");
    add_choice(*app, "--energy", o->energy, energy_names(),
               "What is least: e2 bends least, e1 is shortest, et is between");
    app->add_option("--tension", o->tension, "Weight of e1 in et (1 / square metre)")
        ->check(above_zero())
        ->capture_default_str();
    app->add_option("--smoothing", o->smoothing,
                    "Lets the curve leave the points: the energy plus their squared distances over this is least; 0 "
                    "goes through")
        ->check(at_least_zero())
        ->capture_default_str();
    app->add_option(
           "--smoothing-scale", o->smoothing_scale,
           "Of a mesh or a cloud: sees it through this scale (metres), so that smaller noise, relief and creases "
           "are rounded off; 0: as it is")
        ->check(at_least_zero())
        ->capture_default_str();
    app->add_flag("--closed", o->closed, "From the last point back to the first");
    app->add_option("--points", o->nodes,
                    "Points of the result, given ones included; 0: 32 intervals from one to the next")
        ->check(CLI::Range(0u, FLG_SPLINE_MAX_NODES))
        ->capture_default_str();
    app->add_option("--height", o->height, "Lifts the result off a surface, along its normals (metres)")
        ->check(finite())
        ->capture_default_str();
    app->add_option("--feature", o->feature, "Weight of the normals (metres): keeps the curve off creases; 0: none")
        ->check(at_least_zero())
        ->capture_default_str();
    app->add_option("--corners", o->corners, "Points, counted from 0, where the curve may have a corner: 2,5")
        ->delimiter(',')
        ->type_name("N,...");
    add_choice(*app, "--fit", o->fit, fit_names(),
               "Also writes the curve as few cubic pieces: Bezier's control points, or keys with derivatives as glTF's "
               "CUBICSPLINE has them");
    app->add_option("--fit-tolerance", o->fit_tolerance, "How far these may be from the curve (metres)")
        ->check(above_zero())
        ->capture_default_str();
    app->add_option("--fit-output", o->fit_output, "Where they are written")->type_name("FILE.json");
    app->add_flag("--over-triangles", o->over_triangles,
                  "Of a mesh: a curve over its triangles, made at once, in place of the one of least energy");
    app->add_flag(
        "--on-mesh", o->on_mesh,
        "Of a mesh: lays the result onto its triangles, so that it can be cut in; the report says how far its "
        "points moved");
    add_beside_options(*app, o->beside);
    app->add_flag("--inside", o->inside, "Of an open mesh: keeps the curve between its borders");
    app->add_option("--layer", o->layer,
                    "The same by a layer around the mesh, so thick to either side (metres), as in the paper; 0: none")
        ->check(at_least_zero())
        ->capture_default_str();
    app->add_option("--obstacles", o->obstacles, "Solids to keep out of (sdk/splines/README.md)")
        ->type_name("FILE.json");
    app->add_option("--evaluations", o->evaluations,
                    "With --obstacles: places that are tried for points of the curve at most, which bounds the time; "
                    "0: no bound; the default stands for 800 a point of the curve where that is less, but 600000")
        ->capture_default_str();
    add_road_options(*app, o->road);
    add_cable_options(*app, o->cable);
    app->add_option("--tolerance", o->tolerance, "Residual at which the optimizer stops")
        ->check(CLI::Range(1e-12, 1.0))
        ->capture_default_str();
    app->add_option("--rounds", o->rounds, "Maximum rounds of the optimizer")
        ->check(CLI::Range(1u, 10000u))
        ->capture_default_str();
    add_choice(*app, "--start", o->start, start_names(),
               "Where to begin: about geodesics, or the free spline projected");
    // For scripts from when there was a choice.
    const auto check_method = [](const std::string& word) {
        if (word == "cone") {
            throw CLI::ValidationError("--method", "the footpoint cone has left the product, newton is the one method");
        }
        if (word != "newton") throw CLI::ValidationError("--method", "'" + word + "' is not newton");
    };
    app->add_option_function<std::string>("--method", check_method, "How a round steps: by Newton's method")
        ->type_name("newton")
        ->default_str("newton");
    return {app, [o, &common] { run_spline(*o, common); }};
}

}  // namespace flg::cli
