// SPDX-License-Identifier: MIT
#include "splines/motion/look_at.h"

#include <cmath>
#include <optional>

#include "core/failure.h"
#include "splines/optimizer/natural_cubic.h"

namespace flg {

namespace {

using Mat3 = Eigen::Matrix3d;

constexpr double gravity = 9.80665;   // m/s^2
constexpr double same_place = 1e-12;  // of the coordinates
constexpr double along_up = 1e-6;     // sine of the angle between the two

Vec3 vector_at(std::span<const double> values, size_t i) {
    return Vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
}

// Times of the target, and its spline through them.
class Target {
public:
    static Task<Target> make(Pace& pace, const Look& how, const LookNodes& nodes) {
        const size_t count = how.points.size() / 3;
        Target target(count + (nodes.closed ? 1 : 0), pace.memory());
        target.first_ = vector_at(how.points, 0);
        if (count == 1) co_return target;
        const bool even = how.times.empty(), cycle = even && nodes.closed;
        co_await each(pace, count + (cycle ? 1 : 0), Cost::some_ns, [&](uint32_t i) {
            const double share = static_cast<double>(i) / static_cast<double>(cycle ? count : count - 1);
            const double time = even ? nodes.begin + share * (nodes.end - nodes.begin) : how.times[i];
            if (i > 0 && !(time > target.times_[i - 1])) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "look_times[%u] is %.9g after %.9g; times must rise", i, time,
                              target.times_[i - 1]);
            }
            target.times_[i] = time;
        });
        const CubicData data{.knots = {target.times_.data(), count + (cycle ? 1 : 0)},
                             .values = how.points,
                             .ends = cycle ? CubicEnds::periodic : CubicEnds::natural};
        target.end_ = data.knots.back();
        target.spline_.emplace(co_await natural_cubic(pace, data));
        co_return target;
    }

    Vec3 at(double time) const {
        if (!spline_) return first_;
        Vec3 place;
        spline_->evaluate(std::clamp(time, times_[0], end_), 0, place.data());
        return place;
    }

private:
    Target(size_t times, Memory* memory) : times_(times, memory) {}
    Vec3 first_;
    double end_ = 0;
    Buffer<double> times_;
    std::optional<NaturalCubic> spline_;
};

// Of the path at a node: from the place before it to the one after it.
Vec3 ahead(const LookNodes& nodes, size_t node) {
    const size_t count = nodes.parameters.size();
    const size_t before = node > 0 ? node - 1 : nodes.closed ? count - 1 : 0;
    const size_t after = node + 1 < count ? node + 1 : nodes.closed ? 0 : node;
    return vector_at(nodes.places, after) - vector_at(nodes.places, before);
}

Mat3 rotation_towards(const Vec3& direction, const Vec3& up, const Vec3& right_before) {
    const Vec3 back = -direction;
    Vec3 right = direction.cross(up);
    if (right.norm() <= along_up) right = right_before - right_before.dot(direction) * direction;
    if (right.norm() <= along_up) right = direction.unitOrthogonal();
    right.normalize();
    Mat3 rotation;
    rotation << right, back.cross(right), back;
    return rotation;
}

}  // namespace

Task<void> look(Pace& pace, const Look& how, LookNodes nodes, double* rotations) {
    const bool at_target = how.kind == LookKind::target;
    std::optional<Target> target;
    if (at_target) target.emplace(co_await Target::make(pace, how, nodes));
    const auto direction_at = [&](uint32_t i, Vec3& direction) {
        const Vec3 eye = vector_at(nodes.places, i);
        const Vec3 way = at_target ? Vec3(target->at(nodes.parameters[i]) - eye) : ahead(nodes, i);
        const double length = way.norm();
        if (!(length > same_place * eye.cwiseAbs().maxCoeff()) || length == 0) return false;
        direction = way / length;
        return true;
    };
    Vec3 direction = -Vec3::UnitZ(), right = Vec3::Zero();
    const Vec3 up = how.up.normalized();
    // What it looks at first, if not at its begin.
    uint32_t first = 0;
    const auto count = static_cast<uint32_t>(nodes.parameters.size());
    co_await repeat(pace, Cost::hundreds_of_ns,
                    [&] { return first < count && !direction_at(first, direction) && ++first < count; });
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) {
        direction_at(i, direction);
        const Mat3 rotation = rotation_towards(direction, up, right);
        right = rotation.col(0);
        Eigen::Map<Mat3>(rotations + size_t{9} * i) = rotation;
    });
}

Task<double> bank(Pace& pace, const Look& how, std::span<const double> times, LookNodes nodes, double* rotations) {
    const auto count = static_cast<uint32_t>(nodes.parameters.size());
    const uint32_t steps = nodes.closed ? count : count - 1;
    Buffer<double> lateral(count, pace.memory());
    const auto slope = [&](uint32_t step) -> Vec3 {
        return (vector_at(nodes.places, (step + 1) % count) - vector_at(nodes.places, step)) /
               (times[step + 1] - times[step]);
    };
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) {
        lateral[i] = 0;
        if (steps < 2) return;
        // At an end that of the node beside it.
        const uint32_t middle = nodes.closed ? i : std::clamp(i, 1u, count - 2);
        const uint32_t before = (middle + steps - 1) % steps;
        const double h = times[before + 1] - times[before], k = times[middle + 1] - times[middle];
        const Vec3 acceleration = 2 / (h + k) * (slope(middle) - slope(before));
        lateral[i] = acceleration.dot(Eigen::Map<const Vec3>(rotations + size_t{9} * i));
    });
    const uint32_t rounds = nodes.closed ? 2 : 1;
    const auto follow = [&](uint32_t from, uint32_t to, double step) {
        lateral[to] = lateral[from] - std::expm1(-step / how.bank_time) * (lateral[to] - lateral[from]);
    };
    if (how.bank_time > 0) {
        Buffer<double> unfiltered(nodes.closed ? count : 0, pace.memory());
        for (const bool forwards : {true, false}) {
            co_await each(pace, unfiltered.size(), Cost::some_ns, [&](uint32_t i) { unfiltered[i] = lateral[i]; });
            co_await each(pace, size_t{rounds} * steps, Cost::tens_of_ns, [&](uint32_t step) {
                const uint32_t i = forwards ? step % steps : steps - 1 - step % steps;
                const uint32_t from = forwards ? i : (i + 1) % count, to = forwards ? (i + 1) % count : i;
                if (step >= steps) lateral[to] = unfiltered[to];
                follow(from, to, times[i + 1] - times[i]);
            });
        }
    }
    double greatest = 0;
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) {
        const double angle = std::atan(how.bank * lateral[i] / gravity);
        greatest = std::max(greatest, std::abs(angle));
        Eigen::Map<Mat3> rotation(rotations + size_t{9} * i);
        rotation = Mat3(rotation * Eigen::AngleAxisd(-angle, Vec3::UnitZ()).toRotationMatrix());
    });
    co_return greatest;
}

}  // namespace flg
