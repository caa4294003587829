// SPDX-License-Identifier: MIT
// Cables: hung between points.
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "splines/cable.h"

namespace flg {

namespace {

constexpr uint32_t max_cable_points = 65536;
constexpr uint64_t max_cable_segments = 1u << 22;
constexpr double most_slack = 999, least_length = 1 - 1e-12;  // of the distance

FlgCableHangDesc default_cable_desc() {
    auto desc = sized<FlgCableHangDesc>();
    desc.segments = 64;
    desc.slack = 0.02;
    desc.gravity[2] = -1;
    return desc;
}

void read_cable_points(const FlgCableHangDesc& desc, CableRequest& request, Memory* memory) {
    check_range(desc.point_count >= 2 && desc.point_count <= max_cable_points, "desc.point_count", desc.point_count,
                "2 to 65536");
    require(desc.points, "desc.points");
    request.points = Buffer<double>(size_t{3} * desc.point_count, memory);
    for (size_t i = 0; i < request.points.size(); ++i) {
        request.points[i] = desc.points[i];
        if (std::abs(desc.points[i]) <= 1e30) continue;
        char name[64];
        std::snprintf(name, sizeof name, "desc.points[%zu]", i);
        check_range(false, name, desc.points[i], "finite and at most 1e30 in size");
    }
    if (!desc.cable_offsets) {
        check_range(desc.cable_count <= 1, "desc.cable_count", desc.cable_count, "0 or 1 without desc.cable_offsets");
        request.offsets = Buffer<uint32_t>(2, memory);
        request.offsets[0] = 0;
        request.offsets[1] = desc.point_count;
        return;
    }
    check_range(desc.cable_count >= 1 && desc.cable_count <= max_cable_points, "desc.cable_count", desc.cable_count,
                "1 to 65536");
    request.offsets = Buffer<uint32_t>(size_t{desc.cable_count} + 1, memory);
    for (uint32_t i = 0; i <= desc.cable_count; ++i) {
        const uint32_t offset = request.offsets[i] = desc.cable_offsets[i];
        const bool fits = i == 0 ? offset == 0 : offset <= desc.point_count && offset >= request.offsets[i - 1] + 2;
        if (!fits || (i == desc.cable_count && offset != desc.point_count))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.cable_offsets[%u] is %u: they go from 0 to desc.point_count, %u, and each cable has 2 "
                          "points at least",
                          i, offset, desc.point_count);
    }
}

void read_cable_lengths(const FlgCableHangDesc& desc, CableRequest& request, Memory* memory) {
    check_range(desc.slack >= 0 && desc.slack <= most_slack, "desc.slack", desc.slack, "0 to 999");
    const auto cables = static_cast<uint32_t>(request.offsets.size()) - 1;
    request.lengths = Buffer<double>(desc.point_count - cables, memory);
    uint32_t span = 0;
    for (uint32_t k = 0; k < cables; ++k) {
        for (uint32_t p = request.offsets[k]; p + 1 < request.offsets[k + 1]; ++p, ++span) {
            const Vec3 from(&request.points[size_t{3} * p]), to(&request.points[size_t{3} * (p + 1)]);
            const double straight = (to - from).norm();
            if (!(straight > 0))
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.points: points %u and %u are in one place", p, p + 1);
            const double length = desc.lengths ? desc.lengths[span] : straight * (1 + desc.slack);
            request.lengths[span] = std::max(length, straight);
            if (length >= straight * least_length && length <= straight * (1 + most_slack) * (1 + 1e-12)) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.lengths[%u] is %g, must be at least the distance of points %u and %u, %g, and at most "
                          "1000 times it",
                          span, length, p, p + 1, straight);
        }
    }
    check_range(desc.segments >= 4 && desc.segments <= 4096, "desc.segments", desc.segments, "4 to 4096");
    if (uint64_t{desc.segments} * span > max_cable_segments)
        throw Failure(FLG_ERROR_LIMIT, "desc.segments is %u, which makes more than the limit of 2^22 of %u spans",
                      desc.segments, span);
    request.segments = desc.segments;
}

Vec3 read_gravity(const double (&gravity)[3]) {
    for (const double g : gravity)
        check_range(std::abs(g) <= 1e30, "desc.gravity", g, "finite and at most 1e30 in size");
    Vec3 down(gravity);
    if (down.isZero(0)) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.gravity is 0, so it has no direction");
    down.stableNormalize();
    return down;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgCableHangDescInit(FlgCableHangDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_cable_desc());
}

FlgResult flgCableHang(FlgContext context, const FlgCableHangDesc* desc, FlgCurveSet* out_set, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_set, "out_set", out_job);
        Memory* const memory = self.memory[MemoryKind::curves];
        const FlgCableHangDesc read = read_struct(desc, default_cable_desc(), "desc");
        Submission submission(self, read.job);
        CableRequest request;
        read_cable_points(read, request, memory);
        read_cable_lengths(read, request, memory);
        request.down = read_gravity(read.gravity);
        if (read.obstacles.id != 0) {
            request.obstacles = self.obstacles.get(read.obstacles.id, "desc.obstacles");
            submission.read(*request.obstacles, "desc.obstacles");
            check_range(request.obstacles->dimension == 3, "the number of dimensions of desc.obstacles",
                        request.obstacles->dimension, "3");
        }
        const auto out = request.out = self.make(self.curve_sets);
        out->origin = read_origin(read.origin, "desc.origin");
        submission.job().strand.start(hang_cables(submission.pace(), std::move(request)));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
    });
}

}  // extern "C"
