// SPDX-License-Identifier: MIT
// What pictures of splines show, kept until they are taken: surfaces, curves through points, dots. And the shortest way
// from points to a spline. Metres; y up.
#pragma once

#include <deque>

#include "gallery/workshop.h"
#include "panels/panels.h"

namespace flg::gallery {

using namespace panels;

using Points = std::vector<glm::dvec3>;

// Linear RGB.
constexpr glm::vec3 kBlue = {0.012f, 0.085f, 0.42f}, kGreen = {0.045f, 0.27f, 0.035f}, kYellow = {0.90f, 0.60f, 0.03f},
                    kPearl = {0.80f, 0.77f, 0.70f}, kSlate = {0.115f, 0.165f, 0.215f}, kSand = {0.40f, 0.27f, 0.145f},
                    kClay = {0.36f, 0.135f, 0.085f};

class Stage {
public:
    Stage(Workshop& workshop, const glm::vec3& sight);

    // `flat`: each triangle by itself.
    void surface(filigree::Surface surface, const glm::vec3& color, bool flat = false);
    // One with values at its vertices, shown as colours with a line every so many metres.
    void surface(filigree::Surface surface, std::span<const float> field, float isoline_spacing);
    void curve(const Points& points, const glm::vec3& color, float radius, bool closed = false);
    void lines(const std::vector<Points>& lines, const glm::vec3& color, float radius);
    void dots(const Points& points, const glm::vec3& color, float radius);

    Panel panel;

private:
    void add(const std::vector<scenes::Curve>& curves, const render::CurveLook& look);

    Workshop& workshop_;
    std::deque<filigree::Surface> surfaces_;
    std::deque<filigree::CurveSet> curves_;
};

// Sets desc.points, of as many dimensions as the manifold has; waits.
filigree::Spline spline(Workshop& workshop, const Points& points, FlgSplineDesc desc);
// Its nodes, lifted off the surface by a height; of the plane with z = 0.
Points nodes_of(const filigree::Spline& spline, double height = 0);
// The places of the points that it was given, lifted as well.
Points given_of(const filigree::Spline& spline, double height = 0);
// x and y of the plane seen from above.
glm::dvec3 laid(const glm::dvec3& p);
Points laid(Points points);

filigree::Manifold manifold_of(Workshop& workshop, const filigree::Surface& surface);
filigree::Obstacles obstacles_of(Workshop& workshop, std::span<const FlgObstacle> list, uint32_t dimension,
                                 double clearance = 0);
filigree::Manifold space(Workshop& workshop, uint32_t dimension);

}  // namespace flg::gallery
