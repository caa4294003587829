// SPDX-License-Identifier: MIT
#include "documents/surface_spline.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "documents/failure.h"
#include "documents/space_lines.h"

namespace flg::cli {

FlgManifold create_manifold(Session& session, FlgSurface surface, const std::string& subject, Report& report) {
    FlgManifoldFromSurfaceDesc desc;
    flgManifoldFromSurfaceDescInit(&desc, sizeof desc);
    desc.surface = surface;
    FlgManifold manifold = {};
    FlgJob job = {};
    check(flgManifoldCreateFromSurface(session.context(), &desc, &manifold, &job), subject);
    session.finish({{{job, subject}}}, report);
    return manifold;
}

FlgCurveSet spline_through(Session& session, FlgManifold manifold, const FlgSurfaceView& surface,
                           std::span<const FlgSurfacePoint> points, bool closed, const std::string& subject,
                           Report& report) {
    std::vector<double> places;
    for (const FlgSurfacePoint& point : points) {
        const uint32_t* const corners = surface.mesh->triangles + size_t{3} * point.triangle;
        const Vector a = vertex_at(*surface.mesh, corners[0]), b = vertex_at(*surface.mesh, corners[1]);
        const Vector x = a + double{point.u} * (b - a) + double{point.v} * (vertex_at(*surface.mesh, corners[2]) - a);
        places.insert(places.end(), x.begin(), x.end());
    }
    FlgSplineDesc desc;
    flgSplineDescInit(&desc, sizeof desc);
    desc.manifold = manifold;
    desc.points = places.data();
    desc.point_count = static_cast<uint32_t>(points.size());
    desc.closed = closed ? 1 : 0;
    std::copy(std::begin(surface.mesh->origin), std::end(surface.mesh->origin), desc.origin);
    FlgSpline spline = {};
    FlgJob job = {};
    check(flgSplineCreate(session.context(), &desc, &spline, &job), subject);
    session.finish({{{job, subject}}}, report);
    FlgSplineSampleDesc copy;
    flgSplineSampleDescInit(&copy, sizeof copy);
    copy.spline = spline;
    FlgCurveSet set = {};
    check(flgSplineSample(session.context(), &copy, &set, &job), subject);
    session.finish({{{job, subject}}}, report);
    flgSplineRelease(session.context(), spline);
    return set;
}

}  // namespace flg::cli
