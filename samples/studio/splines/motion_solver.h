// SPDX-License-Identifier: MIT
// The motion through a list of keys, kept up to date while they are dragged: one job at a time, the latest wish wins.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shell/workspace.h"
#include "splines/model.h"

namespace flg::studio::splines {

struct MotionProblem {
    std::vector<Key> keys;
    bool closed = false;
    FlgSplineEnergy energy = FLG_SPLINE_ENERGY_E2;
    double tension = 1.0;
    Inertia inertia = Inertia::body;
    int body = 0;
    double size = 1.0;
    std::vector<Obstacle> obstacles;
    bool operator==(const MotionProblem&) const = default;
};

MotionProblem problem_of(const Motion& motion, const std::vector<Obstacle>& obstacles);

struct Pose {
    glm::dvec3 place{0.0};
    glm::dquat turn{1.0, 0.0, 0.0, 0.0};
};

// Rows as FlgMotionView has them, of a body that is so many times as large.
std::array<double, 12> rows_of(const Pose& pose, double size = 1.0);

struct FoundMotion {
    std::vector<double> times;  // one more than poses where it is closed
    std::vector<Pose> poses;
    std::vector<double> rows;  // 12 a pose, as given
    bool closed = false;
    FlgSplineEnding ending = FLG_SPLINE_ENDING_RUNNING;
    uint32_t rounds = 0;
    double energy = 0.0;
    float busy_ms = 0.0f;

    double begin() const { return times.empty() ? 0.0 : times.front(); }
    double end() const { return times.empty() ? 0.0 : times.back(); }
    // Between positions places go straight and turns evenly. There must be one.
    Pose at(double seconds) const;
};

class MotionSolver {
public:
    explicit MotionSolver(AppContext& app) : app_(app) {}

    void want(const std::optional<MotionProblem>& problem, const std::string& name);
    void update();
    bool busy() const { return ended_ != nullptr || (wanted_ && wanted_ != submitted_); }
    const FoundMotion& found() const { return found_; }
    uint64_t version() const { return version_; }
    const std::string& error() const { return error_; }

private:
    struct Ended;

    void submit();
    void take();

    AppContext& app_;
    std::optional<MotionProblem> wanted_, submitted_;
    std::string name_, error_;
    filigree::Motion running_;
    std::shared_ptr<Ended> ended_;
    FoundMotion found_;
    uint64_t version_ = 0;
};

}  // namespace flg::studio::splines
