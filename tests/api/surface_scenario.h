// SPDX-License-Identifier: MIT
// A chain of jobs on one surface that measures, traces, samples and cuts, and all that it leaves behind.
#pragma once

#include "api/surface_inputs.h"

namespace flg::test {

// Each step is started by itself; `between` is called after each.
struct SurfaceScenario {
    const SurfaceHost& host;
    FlgSurface surface{};
    std::vector<FlgField> fields;
    std::vector<FlgSurfaceCurves> curves;

    explicit SurfaceScenario(const SurfaceHost& on) : host(on) {}

    template <class Between>
    void start(Between between) {
        const auto step = [&](FlgResult result) {
            EXPECT_EQ(result, FLG_OK) << flgErrorGetMessage();
            between();
        };
        surface = host.start_surface(sphere(7));
        between();
        fields.push_back(host.start_distances(surface, 11));
        between();

        FlgFieldGeodesicDesc geodesic = flgFieldGeodesicDefaults();
        geodesic.surface = surface;
        geodesic.curves = host.start_isolines(fields[0], {0.4f, 0.8f});
        geodesic.labels = 1;
        curves.push_back(geodesic.curves);
        between();
        fields.push_back({});
        step(flgFieldCreateGeodesic(host.context, &geodesic, &fields.back(), nullptr));

        FlgSurfaceCutIsolinesDesc bands = flgSurfaceCutIsolinesDefaults();
        bands.field = fields[0];
        bands.level_first = 0.5f;
        bands.level_every = 0.7f;
        bands.first_label = 5;
        fields.push_back({});
        step(flgSurfaceCutIsolines(host.context, &bands, &fields.back(), nullptr));

        const FlgSurfacePoint stops[] = {{3, 0.2f, 0.3f}, {250, 0.5f, 0.1f}, {400, 0.1f, 0.1f}};
        const uint32_t offsets[] = {0, 3};
        FlgFieldTracePathsDesc path = flgFieldTracePathsDefaults();
        path.surface = surface;
        path.points = stops;
        path.path_offsets = offsets;
        path.path_count = 1;
        path.closed = 1;
        curves.push_back({});
        step(flgFieldTracePaths(host.context, &path, &curves.back(), nullptr));

        FlgSurfaceCutCurvesDesc along = flgSurfaceCutCurvesDefaults();
        along.curves = curves.back();
        along.first_label = 100;
        step(flgSurfaceCutCurves(host.context, &along, nullptr));

        const uint32_t regions[] = {6, 7, 100, 101, 102, 103};
        FlgSurfaceSampleDesc sampling = flgSurfaceSampleDefaults();
        sampling.surface = surface;
        sampling.radius = 0.3f;
        sampling.regions = regions;
        sampling.region_count = 6;
        fields.push_back({});
        step(flgSurfaceSample(host.context, &sampling, &fields.back(), nullptr));
        fields.push_back(host.start_distances(surface, 0));
        between();

        FlgSurfaceSampleBordersDesc border = flgSurfaceSampleBordersDefaults();
        border.surface = surface;
        border.region = 5;
        border.spacing = 0.2f;
        curves.push_back({});
        step(flgSurfaceSampleBorders(host.context, &border, &curves.back(), nullptr));

        FlgFieldTraceStreamsDesc streams = flgFieldTraceStreamsDefaults();
        streams.field = fields.back();
        streams.border_samples = curves.back();
        streams.downhill = 1;
        curves.push_back({});
        step(flgFieldTraceStreams(host.context, &streams, &curves.back(), nullptr));

        along.curves = curves.back();
        step(flgSurfaceCutCurves(host.context, &along, nullptr));
        fields.push_back(host.start_distances(surface, 0));
        between();
    }
    std::string all_bits() const {
        std::string all = bits(host.view(surface));
        for (FlgField field : fields) all += bits(host.view(field));
        for (FlgSurfaceCurves curve : curves) all += bits(host.view(curve));
        return all;
    }
};

}  // namespace flg::test
