// SPDX-License-Identifier: MIT
// Descriptors that were right before something in them was changed: sentences name the argument and the value, outputs
// are null.
#pragma once

#include "api/surface_inputs.h"

namespace flg::test {

inline constexpr float inf = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();

template <class Desc, class Out>
using Entry = FlgResult (*)(FlgContext, const Desc*, Out*, FlgJob*);

// Calls an entry point with a descriptor that was right before `change`.
template <class Desc, class Out>
struct Refusal {
    const SurfaceHost& host;
    Entry<Desc, Out> entry;
    Desc good;

    void operator()(const std::function<void(Desc&)>& change, const char* words,
                    FlgResult expected = FLG_ERROR_INVALID_ARGUMENT) const {
        Desc desc = good;
        change(desc);
        Out out{7};
        FlgJob job{7};
        expect_failure(entry(host.context, &desc, &out, &job), expected, words);
        EXPECT_EQ(out.id, 0u) << words;
        EXPECT_EQ(job.id, 0u) << words;
    }
    // What every entry point refuses; the good descriptor is taken.
    void common() const {
        Out out{7};
        FlgJob job{7};
        expect_failure(entry({}, &good, &out, &job), FLG_ERROR_INVALID_HANDLE, "context is null");
        EXPECT_EQ(out.id, 0u);
        EXPECT_EQ(job.id, 0u);
        expect_failure(entry(host.context, nullptr, &out, &job), FLG_ERROR_INVALID_ARGUMENT, "desc is null");
        (*this)([](Desc& d) { d.struct_size = 0; }, "desc: struct_size is 0");
        (*this)([](Desc& d) { d.struct_size += 8; }, "desc: struct_size is");
        FlgJobOptions options = flgJobOptionsDefaults();
        const auto use = [&](Desc& d) { d.job = &options; };
        options.dependency_count = 1;
        (*this)(use, "job.dependencies is null, but dependency_count is 1");
        const FlgJob stale{12345};
        options.dependencies = &stale;
        (*this)(use, "a handle in job.dependencies (0x3039) is not a living job", FLG_ERROR_INVALID_HANDLE);
        EXPECT_EQ(entry(host.context, &good, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        EXPECT_NE(out.id, 0u);
        host.finish();
    }
};
template <class Desc, class Out>
Refusal(const SurfaceHost&, Entry<Desc, Out>, Desc) -> Refusal<Desc, Out>;

// A surface of 9 vertices with two fields and a curve, another surface, and what is stale.
struct Things {
    SurfaceHost host;
    FlgSurface surface = host.surface(plane(2)), other = host.surface(plane(2));
    FlgField field = host.field(surface, [](const Point& p) { return p[0]; });
    FlgField of_other = host.field(other, [](const Point& p) { return p[0]; });
    FlgSurfaceCurves curves = host.isolines(field, {0.3f});
    FlgSurfaceCurves curves_of_other = host.isolines(of_other, {0.3f});
    FlgSurface stale = host.surface(plane(1));
    FlgField stale_field = host.field(stale, [](const Point& p) { return p[0]; });
    FlgSurfaceCurves stale_curves = host.isolines(stale_field, {0.3f});

    Things() {
        flgSurfaceRelease(host.context, stale);
        flgFieldRelease(host.context, stale_field);
        flgSurfaceCurvesRelease(host.context, stale_curves);
    }
    void cut() const {
        FlgSurfaceCutIsolinesDesc desc = flgSurfaceCutIsolinesDefaults();
        desc.field = field;
        desc.level_first = 0.4f;
        desc.level_every = 9;
        EXPECT_EQ(flgSurfaceCutIsolines(host.context, &desc, nullptr, nullptr), FLG_OK) << flgErrorGetMessage();
        host.finish();
    }
};

}  // namespace flg::test
