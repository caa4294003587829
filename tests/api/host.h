// SPDX-License-Identifier: MIT
// A host for the tests of the C ABI: counts its memory, makes curves, runs jobs to their end.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "filigree/filigree.h"

namespace flg::test {

// Not by operator new: tests/hardening counts what passes the host by that way.
#ifdef _WIN32
inline void* allocate_aligned(size_t size, size_t alignment) {
    return _aligned_malloc(size, alignment);
}
inline void free_aligned(void* memory) {
    _aligned_free(memory);
}
#else
inline void* allocate_aligned(size_t size, size_t alignment) {
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
inline void free_aligned(void* memory) {
    std::free(memory);
}
#endif

// The host's allocator: counts what lives, fails at a chosen call.
struct HostAllocator {
    std::atomic<int64_t> live_bytes{0};
    std::atomic<int64_t> calls{0};
    std::atomic<int64_t> fail_at{-1};

    const FlgAllocator* hook() const { return &hook_; }

    const FlgAllocator hook_{sizeof(FlgAllocator), this,
                             [](void* self, size_t size, size_t alignment) -> void* {
                                 auto& a = *static_cast<HostAllocator*>(self);
                                 if (a.calls.fetch_add(1) == a.fail_at.load()) return nullptr;
                                 a.live_bytes += static_cast<int64_t>(size);
                                 return allocate_aligned(size, alignment);
                             },
                             [](void* self, void* memory, size_t size, size_t) {
                                 static_cast<HostAllocator*>(self)->live_bytes -= static_cast<int64_t>(size);
                                 free_aligned(memory);
                             }};
};

// Points and radii of some curves, and the view of them.
struct Curves {
    std::vector<float> positions;
    std::vector<float> radii;
    std::vector<uint32_t> offsets{0};
    std::vector<uint8_t> flags;
    std::vector<FlgColumn> columns;

    void add_point(double x, double y, double z) {
        for (double v : {x, y, z}) positions.push_back(static_cast<float>(v));
    }
    void end_curve(uint8_t flag = 0) {
        offsets.push_back(static_cast<uint32_t>(positions.size() / 3));
        flags.push_back(flag);
    }
    FlgCurveSetView view() {
        FlgCurveSetView view = flgCurveSetViewDefaults();
        columns = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0}};
        if (!radii.empty()) columns.push_back({FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0});
        view.curve_count = static_cast<uint32_t>(offsets.size()) - 1;
        view.curve_offsets = offsets.data();
        view.curve_flags = flags.data();
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
        return view;
    }
};

// A coil around the x axis: the example of a style.
inline Curves coil(uint32_t count = 400, double turns = 12, double length = 6, double radius = 0.25) {
    Curves curves;
    for (uint32_t i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / (count - 1);
        const double angle = 2 * M_PI * turns * u + 0.3 * std::sin(9 * u);
        const double r = radius * (1 + 0.2 * std::sin(17 * u));
        curves.add_point(length * u, r * std::cos(angle), r * std::sin(angle));
    }
    curves.end_curve();
    return curves;
}

// Gently bent curves of some length, `count` of them.
inline Curves arcs(uint32_t count, uint32_t points = 60, double length = 20) {
    Curves curves;
    for (uint32_t c = 0; c < count; ++c) {
        for (uint32_t i = 0; i < points; ++i) {
            const double s = length * i / (points - 1);
            curves.add_point(s, 2 * std::sin(0.2 * s + c), 0.5 * c + 0.01 * s * s);
            curves.radii.push_back(0.01f + 0.001f * static_cast<float>(i));
        }
        curves.end_curve();
    }
    return curves;
}

// A context for the time of a test; its memory must come back whole.
class Host {
public:
    explicit Host(uint32_t workers = 0)
        : Host([&] {
              FlgContextDesc desc = flgContextDefaults();
              desc.worker_count = workers;
              return desc;
          }()) {}
    explicit Host(FlgContextDesc desc) {
        desc.allocator = allocator.hook();
        EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK) << flgErrorGetMessage();
    }
    ~Host() {
        while (flgContextDestroy(context) == FLG_NOT_READY) {}
        EXPECT_EQ(allocator.live_bytes, 0);
    }
    FlgCurveSet create(Curves curves) const {
        const FlgCurveSetView view = curves.view();
        FlgCurveSet set{};
        EXPECT_EQ(flgCurveSetCreate(context, &view, &set), FLG_OK) << flgErrorGetMessage();
        return set;
    }
    void finish(uint32_t budget_us = FLG_UNLIMITED) const {
        FlgFrameReport report{};
        report.struct_size = sizeof report;
        do {
            ASSERT_EQ(flgContextTick(context, budget_us, &report), FLG_OK) << flgErrorGetMessage();
            flgContextWait(context, 1000);
        } while (report.jobs_pending > 0);
    }
    FlgResult result_of(FlgJob job) const { return status_of(job).result; }
    FlgJobStatus status_of(FlgJob job) const {
        FlgJobStatus status{};
        status.struct_size = sizeof status;
        EXPECT_EQ(flgJobGetStatus(context, job, &status), FLG_OK) << flgErrorGetMessage();
        return status;
    }
    FlgCurveSetView view_of(FlgCurveSet set) const {
        FlgCurveSetView view = flgCurveSetViewDefaults();
        EXPECT_EQ(flgCurveSetGetView(context, set, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }

    HostAllocator allocator;
    FlgContext context{};
};

inline const FlgColumn* find_column(const FlgCurveSetView& view, FlgAttribute attribute) {
    for (uint32_t i = 0; i < view.column_count; ++i) {
        if (view.columns[i].attribute == attribute) return &view.columns[i];
    }
    return nullptr;
}

// All bits of a curve set, to compare.
inline std::string bits(const FlgCurveSetView& view) {
    std::string all(reinterpret_cast<const char*>(view.curve_offsets), (view.curve_count + 1) * sizeof(uint32_t));
    for (uint32_t i = 0; i < view.column_count; ++i) {
        const size_t floats = size_t{view.curve_offsets[view.curve_count]} * view.columns[i].components;
        all.append(reinterpret_cast<const char*>(view.columns[i].data), floats * sizeof(float));
    }
    return all;
}

// The set that make(host) returns has the same bits under any workers and budgets.
template <class Make>
void expect_same_bits(const Make& make) {
    std::string expected;
    for (const uint32_t workers : {0u, 3u}) {
        for (const uint32_t budget_us : {FLG_UNLIMITED, 300u}) {
            const Host host(workers);
            const FlgCurveSet set = make(host);
            host.finish(budget_us);
            const std::string now = bits(host.view_of(set));
            if (expected.empty()) expected = now;
            EXPECT_TRUE(now == expected) << workers << " workers, budget " << budget_us;
        }
    }
}

// Expects a failure whose sentence contains `words`.
inline void expect_failure(FlgResult result, FlgResult expected, const char* words) {
    EXPECT_EQ(result, expected) << flgResultGetName(result);
    EXPECT_NE(std::strstr(flgErrorGetMessage(), words), nullptr) << "the sentence is: " << flgErrorGetMessage();
}

}  // namespace flg::test
