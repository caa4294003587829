// SPDX-License-Identifier: MIT
#include "stylization/junctions.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/moving_frame.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t none = UINT32_MAX;
constexpr uint32_t ends_max = 64;    // of a junction whose ends are paired
constexpr double turn_cosine = 0.5;  // of 60 degrees
constexpr uint32_t patches_max = 4;
constexpr uint32_t rigid_steps = 4;  // results with fewer do not bend
constexpr double opposite = 0.1;     // first steps whose difference is shorter have no direction in common

// End 2 c is where curve c starts, end 2 c + 1 where it ends.
struct End {
    uint32_t curve;
    bool last;

    explicit End(uint32_t end) : curve(end / 2), last(end % 2 != 0) {}
    uint32_t point(const CurveSet& set) const { return last ? set.offsets()[curve + 1] - 1 : set.offsets()[curve]; }
};

const float* target_position(const CurveSet& target, uint32_t end) {
    return target.positions() + size_t{3} * End(end).point(target);
}

bool meet(const float* a, const float* b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// Equal for positions that are.
uint32_t bucket_of(const float* position, uint32_t buckets) {
    uint64_t hash = 0;
    for (int c = 0; c < 3; ++c) {
        hash = (hash ^ std::bit_cast<uint32_t>(position[c] + 0.0f)) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
    }
    return static_cast<uint32_t>(hash % buckets);
}

// A stroke's result along one curve, as it is seen from one of its ends.
class EndView {
public:
    EndView(const JunctionInput& input, uint32_t end, uint32_t stroke) : at_(end), out_(&input.out) {
        const uint32_t curve = at_.curve * input.copies + stroke;
        first_ = out_->offsets()[curve];
        count_ = out_->offsets()[curve + 1] - first_;
    }

    uint32_t steps() const { return count_ - 1; }
    // Of the k-th point from the end on.
    size_t row(uint32_t k) const { return size_t{3} * (at_.last ? first_ + count_ - 1 - k : first_ + k); }
    Vec3 load(size_t column, uint32_t k) const { return load_vec3(out_->columns()[column].values.data() + row(k)); }
    Vec3 first_step() const { return load(0, 1) - load(0, 0); }
    // The target's, away from the end.
    Vec3 tangent() const { return at_.last ? Vec3(-load(1, 0)) : load(1, 0); }

private:
    End at_;
    const CurveSet* out_;
    uint32_t first_ = 0, count_ = 0;
};

struct Pairing {
    const JunctionInput& input;
    Buffer<uint32_t>& partner;

    Vec3 tangent(uint32_t end) const { return EndView(input, end, 0).tangent(); }
    void pair(std::span<const uint32_t> ends);
    // Of a bucket, junction by junction.
    void pair_bucket(std::span<const uint32_t> bucket);
};

// The least turn of all first, of equal ones that of the least ends.
void Pairing::pair(std::span<const uint32_t> ends) {
    std::array<Vec3, ends_max> tangents;
    std::array<uint32_t, ends_max> best;
    std::array<double, ends_max> cosine;
    std::array<bool, ends_max> taken{};
    const size_t count = ends.size();
    for (size_t i = 0; i < count; ++i) tangents[i] = tangent(ends[i]);
    const auto find_best = [&](size_t i) {
        best[i] = none;
        cosine[i] = turn_cosine;
        for (size_t j = 0; j < count; ++j) {
            const double goes_on = -tangents[i].dot(tangents[j]);
            if (j == i || taken[j] || !(goes_on > cosine[i])) continue;
            cosine[i] = goes_on;
            best[i] = static_cast<uint32_t>(j);
        }
    };
    for (size_t i = 0; i < count; ++i) find_best(i);
    for (;;) {
        size_t next = count;
        for (size_t i = 0; i < count; ++i) {
            if (!taken[i] && best[i] != none && (next == count || cosine[i] > cosine[next])) next = i;
        }
        if (next == count) return;
        const size_t other = best[next];
        partner[ends[next]] = ends[other];
        partner[ends[other]] = ends[next];
        taken[next] = taken[other] = true;
        for (size_t i = 0; i < count; ++i) {
            if (!taken[i] && (best[i] == next || best[i] == other)) find_best(i);
        }
    }
}

void Pairing::pair_bucket(std::span<const uint32_t> bucket) {
    constexpr size_t bucket_max = 4 * ends_max;
    if (bucket.size() < 2 || bucket.size() > bucket_max) return;
    std::array<bool, bucket_max> seen{};
    std::array<uint32_t, ends_max> ends;
    for (size_t i = 0; i < bucket.size(); ++i) {
        if (seen[i]) continue;
        size_t count = 0;
        for (size_t j = i; j < bucket.size(); ++j) {
            if (!meet(target_position(input.target, bucket[i]), target_position(input.target, bucket[j]))) continue;
            seen[j] = true;
            if (count < ends_max) ends[count] = bucket[j];
            ++count;
        }
        if (count > 1 && count <= ends_max) pair({ends.data(), count});
    }
}

// For each end the one that it goes on into, or none.
Task<Buffer<uint32_t>> pair_ends(Pace& pace, const JunctionInput& input) {
    const uint32_t ends = 2 * input.target.curve_count();
    const auto bends = [&](uint32_t end) {
        return !input.target.closed(end / 2) && EndView(input, end, 0).steps() > 0;
    };
    const Groups buckets = co_await group_by(pace, ends, ends, [&](uint32_t end) {
        return bends(end) ? bucket_of(target_position(input.target, end), ends) : no_key;
    });
    Buffer<uint32_t> partner(ends, pace.memory());
    co_await each(pace, ends, Cost::some_ns, [&](uint32_t end) { partner[end] = none; });
    Pairing pairing{input, partner};
    co_await each_by_work(pace, ends, Cost::tens_of_ns, [&](uint32_t b) {
        const std::span<const uint32_t> bucket = buckets.of(b);
        pairing.pair_bucket(bucket);
        return static_cast<uint32_t>(1 + bucket.size() * bucket.size());
    });
    co_return partner;
}

// Where the steps of both from the junction on lead.
struct Aim {
    Vec3 step = Vec3::Zero();     // unit; zero: stays
    Vec3 tangent = Vec3::Zero();  // likewise, of the target
};

Aim aim_of(const EndView& end, const EndView& other) {
    const Vec3 own = end.first_step(), others = other.first_step();
    Aim aim;
    if (!(own.norm() > 0 && others.norm() > 0)) return aim;
    const bool rigid = end.steps() < rigid_steps, other_rigid = other.steps() < rigid_steps;
    if (rigid) return aim;
    Vec3 both = own.normalized() - others.normalized();
    if (both.norm() < opposite) both = end.tangent() - other.tangent();
    aim.step = other_rigid ? Vec3(-others.normalized()) : Vec3(both.normalized());
    aim.tangent = other_rigid ? Vec3(-other.tangent()) : Vec3((end.tangent() - other.tangent()).normalized());
    return aim;
}

void add_at(Column* column, size_t row, const Vec3& value) {
    float* at = column->values.data() + row;
    store_vec3(load_vec3(at) + value, at);
}

Task<void> bend_end(Pace& pace, const JunctionInput& input, const EndView& end, double bend, Aim aim, Slice& slice) {
    const Vec3 step = end.first_step(), change = step.norm() * aim.step - step;
    const double needed = bend > 0 ? 4 * change.norm() / bend : 0;
    const uint32_t most = std::min(patches_max * input.patch, end.steps() / 2);
    const double wanted = std::clamp<double>(std::ceil(needed), input.patch, patches_max * input.patch);
    const uint32_t points = std::min(most, static_cast<uint32_t>(wanted));
    Column* const displacement = input.out.find(FLG_ATTRIBUTE_DISPLACEMENT);
    std::pmr::vector<Column>& columns = input.out.columns();
    const double first = (1.0 - 1.0 / points) * (1.0 - 1.0 / points);
    const Vec3 tangent = end.tangent();
    const Vec3 axis = tangent.cross(aim.tangent);
    const double turn = std::atan2(axis.norm(), tangent.dot(aim.tangent));
    const Vec3 about = axis.norm() > 0 ? Vec3(axis.normalized()) : Vec3::UnitX();
    const auto turned = [&](const Vec3& v, double angle) {
        const Vec3 along = v.dot(about) * about;
        return Vec3(along + turned_about(about, Vec3(v - along), angle));
    };
    for (Portion part(slice, 0, points); part.next();) {
        for (uint32_t k = part.begin; k < part.end; ++k) {
            const double left = 1.0 - static_cast<double>(k) / points;
            const Vec3 offset = (k * left * left / first) * change;
            if (k > 0) add_at(&columns[0], end.row(k), offset);
            if (k > 0 && displacement && input.magnitude != 0) {
                add_at(displacement, end.row(k), offset / input.magnitude);
            }
            if (turn == 0) continue;
            const double angle = turn * left * left * (3 - 2 * left);
            for (size_t c = 1; c <= 2; ++c) {
                store_vec3(turned(end.load(c, k), angle), columns[c].values.data() + end.row(k));
            }
        }
        if (part.is_over()) co_await pace;
    }
}

}  // namespace

Task<void> smooth_junctions(Pace& pace, JunctionInput input) {
    const Buffer<uint32_t> partner = co_await pair_ends(pace, input);
    const auto ends = static_cast<uint32_t>(partner.size());
    Buffer<Aim> aims(ends, pace.memory());
    Slice slice(Cost::tens_of_ns);
    for (uint32_t stroke = 0; stroke < input.copies; ++stroke) {
        co_await each(pace, ends, Cost::hundreds_of_ns, [&](uint32_t end) {
            const uint32_t other = partner[end];
            std::construct_at(
                &aims[end], other == none ? Aim{} : aim_of(EndView(input, end, stroke), EndView(input, other, stroke)));
        });
        for (uint32_t end = 0; end < ends; ++end) {
            if (aims[end].step == Vec3::Zero()) {
                if (slice.is_over()) co_await pace;
                continue;
            }
            const double scale = input.scales.empty() ? 1.0 : double{input.scales[end / 2]};
            const double bend = input.bend * scale * std::abs(input.magnitude);
            co_await bend_end(pace, input, EndView(input, end, stroke), bend, aims[end], slice);
            // A task keeps its place on the stack until the pace is awaited.
            co_await pace;
        }
    }
}

}  // namespace flg
