// SPDX-License-Identifier: MIT
#include "curves/simplify.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/failure.h"
#include "curves/sampling_job.h"
#include "runtime/each.h"
#include "runtime/fork.h"

namespace flg {

namespace {

constexpr uint32_t block_points = 1024;

// What a set has that is measured, from its first point on; null: nothing.
struct Measured {
    const float *positions, *radii, *colors, *tangents, *normals;
};

struct Simplification {
    const SimplifyInput& input;
    const CurveSet& in;
    CurveSet& out;
    Measured measured;
    Buffer<uint16_t> levels;  // a point's: bit l is set if level l keeps it
    Buffer<uint32_t> counts;  // of points, by curve of `out`
};

const float* values(const CurveSet& set, FlgAttribute attribute) {
    const Column* const column = set.find(attribute);
    return column ? column->values.data() : nullptr;
}

Measured measured_columns(const SimplifyInput& input) {
    const CurveSet& set = *input.curves;
    Measured measured{set.positions(), values(set, FLG_ATTRIBUTE_RADIUS), values(set, FLG_ATTRIBUTE_COLOR), nullptr,
                      nullptr};
    if (!input.ribbons) return measured;
    measured.tangents = values(set, FLG_ATTRIBUTE_TANGENT);
    measured.normals = values(set, FLG_ATTRIBUTE_NORMAL);
    if (!measured.tangents || !measured.normals || !measured.radii) {
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT,
            "desc.ribbons is set, but the curves lack a column of RADIUS, TANGENT and NORMAL, which say where "
            "a ribbon's rims are");
    }
    return measured;
}

// Up to block_points + 1 consecutive points of a curve, the last of a closed one being its first again.
class Block {
public:
    Block(const Simplification& job, uint32_t first, uint32_t count, uint32_t begin, uint32_t end)
        : job_(job), first_(first), count_(count), begin_(begin) {
        along_[0] = 0;
        for (uint32_t i = begin + 1; i <= end; ++i)
            along_[i - begin] = along_[i - begin - 1] + distance(vec3(job.measured.positions, row(i - 1)),
                                                                 vec3(job.measured.positions, row(i)));
    }

    uint32_t row(uint32_t i) const { return first_ + (i < count_ ? i : i - count_); }

    // The point between `begin` and `end` whose error at a level is largest, in units of what is allowed; `end` if all
    // are within it.
    uint32_t worst(uint32_t begin, uint32_t end, double tolerance) const {
        double most = 1;
        uint32_t found = end;
        for (uint32_t i = begin + 1; i < end; ++i) {
            const double error = error_at(i, begin, end, tolerance);
            if (error <= most) continue;
            most = error;
            found = i;
        }
        return found;
    }

private:
    using Vec = std::array<double, 3>;

    static Vec vec3(const float* values, uint32_t row) {
        const float* const v = values + size_t{3} * row;
        return {v[0], v[1], v[2]};
    }
    static double distance(const Vec& a, const Vec& b) {
        const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
        return std::sqrt(x * x + y * y + z * z);
    }
    // The radius along the second normal, where a ribbon's rim is.
    Vec arm(uint32_t row) const {
        const Vec t = vec3(job_.measured.tangents, row), n = vec3(job_.measured.normals, row);
        const double radius = job_.measured.radii[row];
        return {radius * (t[1] * n[2] - t[2] * n[1]), radius * (t[2] * n[0] - t[0] * n[2]),
                radius * (t[0] * n[1] - t[1] * n[0])};
    }

    double error_at(uint32_t i, uint32_t begin, uint32_t end, double tolerance) const {
        const double from = along_[begin - begin_], to = along_[end - begin_];
        const double t = to > from ? (along_[i - begin_] - from) / (to - from) : 0;
        const uint32_t a = row(begin), b = row(end), at = row(i);
        const auto off = [t](const Vec& start, const Vec& stop, const Vec& here) {
            Vec between;
            for (size_t k = 0; k < 3; ++k) between[k] = start[k] + t * (stop[k] - start[k]);
            return distance(between, here);
        };
        const Measured& m = job_.measured;
        double error = off(vec3(m.positions, a), vec3(m.positions, b), vec3(m.positions, at));
        if (m.normals) {
            error += off(arm(a), arm(b), arm(at));
        } else if (m.radii) {
            const double begins = m.radii[a], ends = m.radii[b];
            error += std::abs(begins + t * (ends - begins) - m.radii[at]);
        }
        error = error == 0 ? 0 : error / tolerance;
        if (!m.colors) return error;
        for (size_t k = 0; k < 4; ++k) {
            const double begins = m.colors[4 * size_t{a} + k], ends = m.colors[4 * size_t{b} + k];
            const double color = std::abs(begins + t * (ends - begins) - m.colors[4 * size_t{at} + k]);
            if (color > 0) error = std::max(error, color / job_.input.color_tolerance);
        }
        return error;
    }

    const Simplification& job_;
    uint32_t first_, count_, begin_;
    std::array<double, block_points + 1> along_;
};

struct Span {
    uint32_t begin, end;
};

// Which points each level keeps of one block; both its ends are kept already.
Task<void> choose_in_block(Pace& pace, Simplification& job, uint32_t curve, Span range, Slice& slice,
                           std::pmr::vector<Span>& spans) {
    const uint32_t first = job.in.offsets()[curve];
    const Block block(job, first, job.in.offsets()[curve + 1] - first, range.begin, range.end);
    for (uint32_t level = 0; level < job.input.level_count; ++level) {
        spans.assign(1, range);
        while (!spans.empty()) {
            const Span span = spans.back();
            spans.pop_back();
            const uint32_t worst = block.worst(span.begin, span.end, double{job.input.tolerances[level]});
            if (slice.is_over(span.end - span.begin)) co_await pace;
            if (worst == span.end) continue;
            job.levels[block.row(worst)] |= static_cast<uint16_t>(1u << level);
            spans.push_back({span.begin, worst});
            spans.push_back({worst, span.end});
        }
    }
}

Task<void> choose_in_batch(Pace& pace, Simplification& job, uint32_t batch) {
    const CurveRange range = curves_of_batch(job.in, batch);
    const auto all_levels = static_cast<uint16_t>((1u << job.input.level_count) - 1);
    std::pmr::vector<Span> spans(pace.memory());
    Slice slice(Cost::tens_of_ns);
    for (uint32_t c = range.first; c < range.last; ++c) {
        const uint32_t first = job.in.offsets()[c], count = job.in.offsets()[c + 1] - first;
        const uint32_t segments = job.in.closed(c) ? count : count - 1;
        const uint32_t step = job.in.closed(c) ? std::clamp(count / 3, 1u, block_points) : block_points;
        for (Portion part(slice, first, first + count); part.next();) {
            std::fill(job.levels.data() + part.begin, job.levels.data() + part.end, uint16_t{0});
            if (part.is_over()) co_await pace;
        }
        job.levels[first] = job.levels[first + (segments < count ? segments : 0)] = all_levels;
        for (uint32_t begin = 0, end; begin < segments; begin = end) {
            end = begin + std::min(step, segments - begin);
            if (end < count) job.levels[first + end] = all_levels;
            co_await choose_in_block(pace, job, c, {begin, end}, slice, spans);
        }
        for (uint32_t level = 0; level < job.input.level_count; ++level) {
            uint32_t kept = 0;
            for (Portion part(slice, first, first + count); part.next();) {
                for (uint32_t i = part.begin; i < part.end; ++i) kept += job.levels[i] >> level & 1u;
                if (part.is_over()) co_await pace;
            }
            job.counts[level * job.in.curve_count() + c] = kept;
        }
        pace.advance(count);
    }
}

Task<void> lay_out(Pace& pace, Simplification& job) {
    const uint64_t curves = uint64_t{job.in.curve_count()} * job.input.level_count;
    job.out.allocate_curves(static_cast<uint32_t>(curves));
    uint64_t points = 0;
    co_await each(pace, curves, Cost::some_ns, [&](uint32_t c) {
        job.out.offsets()[c] = static_cast<uint32_t>(points);
        job.out.begin_curve(c, job.in.flags()[c % job.in.curve_count()]);
        points += job.counts[c];
    });
    if (points > sampled_points_max) {
        throw Failure(FLG_ERROR_LIMIT, "the levels would have %llu points; the limit is 2^31",
                      static_cast<unsigned long long>(points));
    }
    job.out.offsets()[curves] = static_cast<uint32_t>(points);
    std::pmr::vector<CurveSet::ColumnLayout> layout(pace.memory());
    for (const Column& column : job.in.columns()) layout.push_back({column.attribute, column.components});
    job.out.allocate_columns(layout);
}

// Kept rows of one curve, those at `begin` to `end` - 1 of the set; returns where the next one goes.
uint32_t copy_rows(const Simplification& job, uint32_t level, uint32_t begin, uint32_t end, uint32_t to) {
    for (uint32_t row = begin; row < end; ++row) {
        if (!(job.levels[row] >> level & 1u)) continue;
        for (size_t c = 0; c < job.in.columns().size(); ++c) {
            const Column& from = job.in.columns()[c];
            const size_t width = from.components;
            std::memcpy(job.out.columns()[c].values.data() + width * to, from.values.data() + width * row,
                        width * sizeof(float));
        }
        ++to;
    }
    return to;
}

Task<void> copy_batch(Pace& pace, Simplification& job, uint32_t batch) {
    const CurveRange range = curves_of_batch(job.in, batch);
    Slice slice(Cost::tens_of_ns);
    for (uint32_t c = range.first; c < range.last; ++c) {
        for (uint32_t level = 0; level < job.input.level_count; ++level) {
            const uint32_t out_curve = level * job.in.curve_count() + c;
            uint32_t to = job.out.offsets()[out_curve];
            for (Portion part(slice, job.in.offsets()[c], job.in.offsets()[c + 1]); part.next();) {
                to = copy_rows(job, level, part.begin, part.end, to);
                if (part.is_over()) co_await pace;
            }
            job.out.complete_curve(out_curve);
        }
        pace.advance(job.in.offsets()[c + 1] - job.in.offsets()[c]);
    }
}

}  // namespace

Task<void> simplify_curves(Pace& pace, SimplifyInput input, std::shared_ptr<CurveSet> out) {
    const CurveSet& in = *input.curves;
    const uint64_t curves = uint64_t{in.curve_count()} * input.level_count;
    if (curves >= UINT32_MAX) {
        throw Failure(FLG_ERROR_LIMIT, "%u levels of %u curves are more curves than a set may have, 2^32 - 2",
                      input.level_count, in.curve_count());
    }
    Simplification job{input,
                       in,
                       *out,
                       measured_columns(input),
                       Buffer<uint16_t>(in.point_count(), pace.memory()),
                       Buffer<uint32_t>(curves, pace.memory())};
    pace.stage("choose");
    pace.expect(uint64_t{2} * in.point_count());
    co_await fork(pace, batch_count(in), &choose_in_batch, job);
    co_await lay_out(pace, job);
    pace.stage("copy");
    co_await fork(pace, batch_count(in), &copy_batch, job);
}

}  // namespace flg
