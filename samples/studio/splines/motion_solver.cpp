// SPDX-License-Identifier: MIT
#include "splines/motion_solver.h"

#include <algorithm>

#include "splines/bodies.h"
#include "splines/curve_solver.h"
#include "splines/sentences.h"

namespace flg::studio::splines {
namespace {

// A rod's thickness, of its length.
constexpr double kRodThickness = 0.02;

}  // namespace

MotionProblem problem_of(const Motion& motion, const std::vector<Obstacle>& obstacles) {
    MotionProblem problem;
    problem.keys = motion.keys;
    problem.closed = motion.closed && motion.keys.size() > 2;
    problem.energy = motion.energy;
    if (motion.energy == FLG_SPLINE_ENERGY_ET) problem.tension = motion.tension;
    problem.inertia = motion.inertia;
    problem.body = motion.body;
    problem.size = motion.size;
    if (motion.avoid) problem.obstacles = obstacles;
    return problem;
}

std::array<double, 12> rows_of(const Pose& pose, double size) {
    const glm::dmat3 m = size * glm::mat3_cast(pose.turn);  // by columns
    const glm::dvec3& p = pose.place;
    return {m[0][0], m[1][0], m[2][0], p.x, m[0][1], m[1][1], m[2][1], p.y, m[0][2], m[1][2], m[2][2], p.z};
}

Pose FoundMotion::at(double seconds) const {
    const auto after = std::upper_bound(times.begin(), times.end(), seconds);
    const auto i = static_cast<size_t>(std::max<std::ptrdiff_t>(after - times.begin() - 1, 0));
    if (i + 1 >= times.size()) return closed ? poses.front() : poses.back();
    const double share = std::clamp((seconds - times[i]) / (times[i + 1] - times[i]), 0.0, 1.0);
    const Pose &from = poses[i], &to = poses[(i + 1) % poses.size()];
    return {glm::mix(from.place, to.place, share), glm::slerp(from.turn, to.turn, share)};
}

struct MotionSolver::Ended {
    bool done = false;
    FlgResult result = FLG_OK;
    std::string error;
    float busy_ms = 0.0f;
};

void MotionSolver::want(const std::optional<MotionProblem>& problem, const std::string& name) {
    if (wanted_ != problem) wanted_ = problem;
    name_ = name;
}

void MotionSolver::submit() {
    submitted_ = wanted_;
    const MotionProblem& problem = *submitted_;
    error_.clear();
    std::vector<double> times, poses;
    for (const Key& key : problem.keys) {
        times.push_back(key.time);
        const std::array<double, 12> rows = rows_of({key.place, key.turn});
        poses.insert(poses.end(), rows.begin(), rows.end());
    }
    FlgMotionDesc desc = flgMotionDefaults();
    desc.key_count = static_cast<uint32_t>(times.size());
    desc.times = times.data();
    desc.poses = poses.data();
    desc.closed = problem.closed ? 1 : 0;
    desc.energy = problem.energy;
    desc.tension = problem.tension;
    const samples::Body& body = unit_body(problem.body);
    std::vector<glm::dvec3> points;
    double radius = 0.5 * problem.size;
    if (problem.inertia == Inertia::body) {
        for (const glm::dvec3& p : body.positions) points.push_back(problem.size * p);
        desc.body_points = &points[0].x;
        desc.body_point_count = static_cast<uint32_t>(points.size());
        radius = problem.size * body.radius();
    } else {
        const double across = problem.inertia == Inertia::ball ? 1.0 : kRodThickness;
        desc.body_box[0] = problem.size;
        desc.body_box[1] = desc.body_box[2] = across * problem.size;
    }
    FlgJobOptions urgent = flgJobOptionsDefaults();
    urgent.priority = FLG_PRIORITY_HIGH;
    desc.job = &urgent;
    try {
        filigree::Obstacles obstacles;
        if (!problem.obstacles.empty()) {
            const std::vector<FlgObstacle> solids = solids_of(problem.obstacles, false);
            FlgObstaclesDesc solid = flgObstaclesDefaults();
            solid.obstacles = solids.data();
            solid.obstacle_count = static_cast<uint32_t>(solids.size());
            solid.clearance = radius;
            obstacles = app_.context.obstacles(solid);
            desc.obstacles = obstacles.get();
        }
        filigree::Job job;
        running_ = app_.context.motion(desc, &job);
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
            problem.obstacles.empty() ? Jobs::Shown::quiet : Jobs::Shown::listed, Jobs::Failure::told_by_caller);
    } catch (const filigree::Error& failed) {
        error_ = in_words(failed.what(), problem.obstacles);
        app_.notices.add(Weight::error, name_ + ": " + error_ + ".");
    }
}

void MotionSolver::take() {
    const FlgMotionView view = running_.view();
    found_ = {};
    found_.closed = view.closed != 0;
    found_.times.assign(view.times, view.times + view.position_count + (found_.closed ? 1 : 0));
    found_.rows.assign(view.poses, view.poses + size_t{12} * view.position_count);
    for (uint32_t i = 0; i < view.position_count; ++i) {
        const double* const p = view.poses + size_t{12} * i;
        const double* const q = view.quaternions + size_t{4} * i;
        found_.poses.push_back({{p[3], p[7], p[11]}, {q[3], q[0], q[1], q[2]}});
    }
    found_.ending = view.ending;
    found_.rounds = view.rounds;
    found_.energy = view.energy;
    found_.busy_ms = ended_->busy_ms;
    ++version_;
}

void MotionSolver::update() {
    if (ended_ && ended_->done) {
        if (ended_->result == FLG_OK) {
            take();
        } else if (ended_->result == FLG_ERROR_CANCELLED) {
            error_ = "cancelled";
        } else {
            error_ = in_words(ended_->error, submitted_->obstacles);
            if (wanted_ == submitted_) app_.notices.add(Weight::error, name_ + ": " + error_ + ".");
        }
        running_.reset();
        ended_.reset();
    }
    if (!wanted_) {
        if (!found_.poses.empty()) found_ = {}, ++version_;
        submitted_.reset();
        return;
    }
    if (!ended_ && wanted_ != submitted_) submit();
}

}  // namespace flg::studio::splines
