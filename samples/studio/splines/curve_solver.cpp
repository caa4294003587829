// SPDX-License-Identifier: MIT
#include "splines/curve_solver.h"

#include <algorithm>
#include <cmath>

#include "splines/sentences.h"

namespace flg::studio::splines {
namespace {

// Jobs that were longer are listed.
constexpr float kListedMs = 60.0f;
// Rounds of a job that is done within so many frames are not shown.
constexpr int kPatience = 6;

void copy(const glm::dvec3& v, double* out) {
    for (glm::length_t c = 0; c < 3; ++c) out[c] = v[c];
}

// Waves shorter than six times (smoothing * the points' distance)^(1/4) vanish.
double smoothing_of(const Curve& curve) {
    if (!(curve.waves > 0.0) || curve.points.size() < 2) return 0.0;
    double length = 0.0;
    for (size_t i = 1; i < curve.points.size(); ++i) length += glm::distance(curve.points[i - 1], curve.points[i]);
    const double apart = length / static_cast<double>(curve.points.size() - 1);
    return apart > 0.0 ? std::min(std::pow(curve.waves / 6.0, 4) / apart, 1e9) : 0.0;
}

}  // namespace

std::vector<FlgObstacle> solids_of(const std::vector<Obstacle>& obstacles, bool is_shape,
                                   const render::Placement& placement) {
    const glm::dquat back = glm::conjugate(glm::dquat(placement.turn));
    const double size = 1.0 / static_cast<double>(placement.scale);
    const bool is_placed = !placement.is_identity();
    const auto turned = [&](const glm::dvec3& world) {
        return is_shape ? to_shape(world) : is_placed ? back * world : world;
    };
    const auto moved = [&](const glm::dvec3& world) { return size * turned(world - glm::dvec3(placement.at)); };
    std::vector<FlgObstacle> solids;
    for (const Obstacle& obstacle : obstacles) {
        FlgObstacle& solid = solids.emplace_back(flgObstacleDefaults());
        solid.kind = obstacle.kind;
        solid.radius = size * obstacle.radius;
        copy(moved(obstacle.centre), solid.centre);
        copy(moved(obstacle.to), solid.to);
        copy(size * obstacle.half, solid.half);
        for (glm::length_t c = 0; c < 3; ++c) {
            glm::dvec3 axis(0.0);
            axis[c] = 1.0;
            copy(turned(axis), solid.axes + 3 * c);
        }
    }
    return solids;
}

CurveProblem problem_of(const Curve& curve, const SurfaceLookup::Surface& surface,
                        const std::vector<Obstacle>& obstacles) {
    CurveProblem problem;
    problem.points = curve.points;
    problem.closed = curve.closed && curve.points.size() > 2;
    problem.energy = curve.energy;
    if (curve.energy == FLG_SPLINE_ENERGY_ET) problem.tension = curve.tension;
    problem.smoothing = smoothing_of(curve);
    problem.density = curve.density;
    if (!problem.closed) {
        problem.begin_slope = curve.begin_slope;
        problem.end_slope = curve.end_slope;
    }
    problem.manifold = surface.manifold.id;
    problem.is_shape = surface.is_shape;
    problem.is_inside_out = surface.is_inside_out;
    if (curve.inside) problem.border = surface.mesh.id;
    if (curve.avoid) problem.obstacles = obstacles;
    // Nothing else asks for it, and then a thicker curve is no other one.
    if (!problem.obstacles.empty()) problem.placement = surface.placement;
    if (!problem.obstacles.empty() && curve.look.form != Form::line)
        problem.clearance = static_cast<double>(curve.look.radius);
    return problem;
}

struct CurveSolver::Ended {
    bool done = false;
    FlgResult result = FLG_OK;
    std::string error;
    float busy_ms = 0.0f;
};

CurveSolver::CurveSolver(AppContext& app) : app_(app) {}

bool CurveSolver::busy() const {
    return ended_ != nullptr || (wanted_ && wanted_ != submitted_);
}

void CurveSolver::want(const std::optional<CurveProblem>& problem, const std::string& name) {
    if (wanted_ != problem) wanted_ = problem;
    name_ = name;
}

filigree::Obstacles CurveSolver::obstacles_of(const CurveProblem& problem) {
    std::vector<FlgObstacle> solids = solids_of(problem.obstacles, problem.is_shape, problem.placement);
    if (problem.border != 0) {
        FlgObstacle& border = solids.emplace_back(flgObstacleDefaults());
        border.kind = FLG_OBSTACLE_KIND_BORDER;
        border.surface.id = problem.border;
    }
    if (solids.empty()) return {};
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.obstacles = solids.data();
    desc.obstacle_count = static_cast<uint32_t>(solids.size());
    desc.clearance = problem.clearance;
    return app_.context.obstacles(desc);
}

void CurveSolver::submit() {
    submitted_ = wanted_;
    const CurveProblem& problem = *submitted_;
    error_.clear();
    std::vector<glm::dvec3> points = problem.points;
    FlgSplineDesc desc = flgSplineDefaults();
    glm::dvec3 begin(0.0), end(0.0);
    if (problem.begin_slope) begin = *problem.begin_slope, desc.begin_slope = &begin.x;
    if (problem.end_slope) end = *problem.end_slope, desc.end_slope = &end.x;
    if (problem.is_shape) {
        for (glm::dvec3& p : points) p = to_shape(p);
        begin = to_shape(begin), end = to_shape(end);
    }
    desc.manifold.id = problem.manifold;
    desc.points = &points[0].x;
    desc.point_count = static_cast<uint32_t>(points.size());
    desc.closed = problem.closed ? 1 : 0;
    desc.energy = problem.energy;
    desc.tension = problem.tension;
    desc.smoothing = problem.smoothing;
    const auto spans = desc.point_count - (problem.closed ? 0 : 1);
    desc.node_count = spans * static_cast<uint32_t>(problem.density) + (problem.closed ? 0 : 1);
    FlgJobOptions watched = flgJobOptionsDefaults();
    watched.partial_results = 1;
    watched.priority = FLG_PRIORITY_HIGH;
    desc.job = &watched;
    if (result_ && solved_ && solved_->manifold == problem.manifold && solved_->closed == problem.closed &&
        solved_->points.size() == points.size())
        desc.warm_start = result_.get();
    try {
        const filigree::Obstacles obstacles = obstacles_of(problem);
        desc.obstacles = obstacles.get();
        filigree::Job job;
        running_ = app_.context.spline(desc, &job);
        frames_ = 0;
        ended_ = std::make_shared<Ended>();
        app_.jobs.add(
            name_, std::move(job),
            [ended = std::weak_ptr(ended_)](const FlgJobStatus& status) {
                const auto mine = ended.lock();
                if (!mine) return;
                mine->done = true;
                mine->result = status.result;
                mine->error = status.error;
                mine->busy_ms = 1e-3f * status.busy_us;
            },
            found_.busy_ms > kListedMs ? Jobs::Shown::listed : Jobs::Shown::quiet, Jobs::Failure::told_by_caller);
    } catch (const filigree::Error& failed) {
        error_ = in_words(failed.what(), problem.obstacles);
        app_.notices.add(Weight::error, name_ + ": " + error_ + ".");
    }
}

void CurveSolver::take(const filigree::Spline& spline, bool final) {
    FlgSplineView view = flgSplineViewDefaults();
    if (flgSplineGetView(app_.context.get(), spline.get(), &view) != FLG_OK) return;
    if (!final && !found_.final && view.rounds == found_.rounds && found_.nodes.size() == view.node_count) return;
    const bool is_shape = submitted_->is_shape;
    const float sign = submitted_->is_inside_out ? -1.0f : 1.0f;
    found_.nodes.resize(view.node_count);
    found_.normals.resize(view.normals != nullptr ? view.node_count : 0);
    for (uint32_t i = 0; i < view.node_count; ++i) {
        const double* const p = view.nodes + size_t{3} * i;
        const glm::dvec3 own(p[0], p[1], p[2]);
        found_.nodes[i] = is_shape ? to_world(own) : own;
        if (view.normals == nullptr) continue;
        const float* const n = view.normals + size_t{3} * i;
        found_.normals[i] = sign * (is_shape ? glm::vec3(n[0], n[2], -n[1]) : glm::vec3(n[0], n[1], n[2]));
    }
    found_.point_nodes.assign(view.point_nodes, view.point_nodes + view.point_count);
    found_.closed = view.closed != 0;
    found_.final = final;
    found_.ending = view.ending;
    found_.rounds = view.rounds;
    found_.energy = view.energy;
    found_.length = view.length;
    found_.largest_offset = view.largest_offset;
    ++version_;
}

// Rounds and curves among obstacles come without: then they are the drawn surface's, evened out along the curve.
void CurveSolver::find_normals(const SurfaceRef& ground, const SurfaceLookup& surfaces) {
    constexpr int kReach = 3;
    const auto count = static_cast<int>(found_.nodes.size());
    std::vector<glm::vec3> raw;
    const render::Placement back = surfaces.placement(ground).inverse();
    for (const glm::vec3& node : found_.nodes)
        raw.emplace_back(back.direction(glm::vec3(surfaces.normal(ground, surfaces.to_world(ground, node)))));
    for (int i = 0; i < count; ++i) {
        glm::vec3 sum(0.0f);
        for (int j = std::max(i - kReach, 0); j <= std::min(i + kReach, count - 1); ++j)
            sum += raw[static_cast<size_t>(j)];
        const float length = glm::length(sum);
        found_.normals.push_back(length > 1e-3f ? sum / length : raw[static_cast<size_t>(i)]);
    }
}

void CurveSolver::update(const SurfaceRef& ground, const SurfaceLookup& surfaces) {
    const uint64_t before = version_;
    if (ended_ && ended_->done) {
        if (ended_->result == FLG_OK) {
            found_.busy_ms = ended_->busy_ms;
            take(running_, true);
            result_ = std::move(running_);
            running_.reset();
            solved_ = submitted_;
        } else {
            // Cancelled: it stays as it was until something else is wanted.
            error_ = "cancelled";
            if (ended_->result != FLG_ERROR_CANCELLED) {
                error_ = in_words(ended_->error, submitted_->obstacles);
                // While it is dragged the next wish may be a better one.
                if (wanted_ == submitted_) app_.notices.add(Weight::error, name_ + ": " + error_ + ".");
            }
            running_.reset();
        }
        ended_.reset();
    } else if (ended_ && ++frames_ > kPatience) {
        take(running_, false);
    }
    if (version_ != before && found_.normals.empty() && ground.kind != "space") find_normals(ground, surfaces);
    if (!wanted_) {
        if (!found_.nodes.empty()) found_ = {}, ++version_;
        submitted_.reset();
        if (!ended_) running_.reset();
        return;
    }
    if (!ended_ && wanted_ != submitted_) submit();
}

}  // namespace flg::studio::splines
