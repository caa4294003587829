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
            EXPECT_EQ(result, FLG_OK) << flgLastError();
            between();
        };
        surface = host.start_surface(sphere(7));
        between();
        fields.push_back(host.start_distances(surface, 11));
        between();

        FlgGeodesicDesc geodesic = flgGeodesicDefaults();
        geodesic.surface = surface;
        geodesic.curves = host.start_isolines(fields[0], {0.4f, 0.8f});
        geodesic.labels = 1;
        curves.push_back(geodesic.curves);
        between();
        fields.push_back({});
        step(flgGeodesic(host.context, &geodesic, &fields.back(), nullptr));

        FlgCutIsolinesDesc bands = flgCutIsolinesDefaults();
        bands.field = fields[0];
        bands.levels.first = 0.5f;
        bands.levels.every = 0.7f;
        bands.first_label = 5;
        fields.push_back({});
        step(flgCutIsolines(host.context, &bands, &fields.back(), nullptr));

        const FlgSurfacePoint stops[] = {{3, 0.2f, 0.3f}, {250, 0.5f, 0.1f}, {400, 0.1f, 0.1f}};
        const uint32_t offsets[] = {0, 3};
        FlgPathsDesc path = flgPathsDefaults();
        path.surface = surface;
        path.points = stops;
        path.path_offsets = offsets;
        path.path_count = 1;
        path.closed = 1;
        curves.push_back({});
        step(flgTracePaths(host.context, &path, &curves.back(), nullptr));

        FlgCutCurvesDesc along = flgCutCurvesDefaults();
        along.curves = curves.back();
        along.first_label = 100;
        step(flgCutCurves(host.context, &along, nullptr));

        const uint32_t regions[] = {6, 7, 100, 101, 102, 103};
        FlgSamplingDesc sampling = flgSamplingDefaults();
        sampling.surface = surface;
        sampling.radius = 0.3f;
        sampling.regions = regions;
        sampling.region_count = 6;
        fields.push_back({});
        step(flgSurfaceSample(host.context, &sampling, &fields.back(), nullptr));
        fields.push_back(host.start_distances(surface, 0));
        between();

        FlgBorderSamplingDesc border = flgBorderSamplingDefaults();
        border.surface = surface;
        border.region = 5;
        border.spacing = 0.2f;
        curves.push_back({});
        step(flgBorderSample(host.context, &border, &curves.back(), nullptr));

        FlgStreamsDesc streams = flgStreamsDefaults();
        streams.field = fields.back();
        streams.border_samples = curves.back();
        streams.downhill = 1;
        curves.push_back({});
        step(flgTraceStreams(host.context, &streams, &curves.back(), nullptr));

        along.curves = curves.back();
        step(flgCutCurves(host.context, &along, nullptr));
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
