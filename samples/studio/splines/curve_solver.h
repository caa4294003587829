// SPDX-License-Identifier: MIT
// The spline of one curve, kept up to date while its points are dragged: one job at a time, which begins where the last
// one ended; what is wanted meanwhile is asked for when it is done, the latest alone. Rounds of a running job can be
// seen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "splines/model.h"
#include "splines/surface_lookup.h"

namespace flg::studio::splines {

// All that the curve depends on.
struct CurveProblem {
    std::vector<glm::dvec3> points;
    bool closed = false;
    FlgSplineEnergy energy = FLG_SPLINE_ENERGY_E2;
    double tension = 1.0, smoothing = 0.0;
    int density = 32;
    std::optional<glm::dvec3> begin_slope, end_slope;
    uint64_t manifold = 0;
    bool is_shape = false, is_inside_out = false;
    uint64_t border = 0;  // an open surface whose borders are kept within
    std::vector<Obstacle> obstacles;
    double clearance = 0.0;
    render::Placement placement{};  // of the mesh, among obstacles
    bool operator==(const CurveProblem&) const = default;
};

CurveProblem problem_of(const Curve& curve, const SurfaceLookup::Surface& surface,
                        const std::vector<Obstacle>& obstacles);

// A curve as it is known, in the space of what it lies on.
struct FoundCurve {
    std::vector<glm::vec3> nodes, normals;  // no normals: in space
    std::vector<uint32_t> point_nodes;      // a node a point
    bool closed = false;
    bool final = false;
    FlgSplineEnding ending = FLG_SPLINE_ENDING_RUNNING;
    uint32_t rounds = 0;
    double energy = 0.0, length = 0.0, largest_offset = 0.0;
    float busy_ms = 0.0f;
};

class CurveSolver {
public:
    explicit CurveSolver(AppContext& app);

    // What the curve is to be; `name` is for the user. None: there is nothing to be solved.
    void want(const std::optional<CurveProblem>& problem, const std::string& name);
    // After want(); once a frame. `ground` is what the curve lies on.
    void update(const SurfaceRef& ground, const SurfaceLookup& surfaces);
    bool busy() const;
    const FoundCurve& found() const { return found_; }
    // Counts what found() was.
    uint64_t version() const { return version_; }
    // Why what is wanted can't be; found() is what was before.
    const std::string& error() const { return error_; }

private:
    struct Ended;

    void submit();
    void take(const filigree::Spline& spline, bool final);
    void find_normals(const SurfaceRef& ground, const SurfaceLookup& surfaces);
    filigree::Obstacles obstacles_of(const CurveProblem& problem);

    AppContext& app_;
    std::optional<CurveProblem> wanted_, submitted_, solved_;
    std::string name_, error_;
    filigree::Spline running_, result_;
    std::shared_ptr<Ended> ended_;  // of the running job; null: none
    int frames_ = 0;                // since it was started
    FoundCurve found_;
    uint64_t version_ = 0;
};

// Solids in the coordinates of a shape, or of a mesh that is placed so, as the SDK takes them.
std::vector<FlgObstacle> solids_of(const std::vector<Obstacle>& obstacles, bool is_shape,
                                   const render::Placement& placement = {});

}  // namespace flg::studio::splines
