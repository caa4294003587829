// SPDX-License-Identifier: MIT
#include "pulling/pulling.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t width = 4;         // numbers a point
constexpr uint32_t most_turns = 6;    // of a rotation, before it is found the long way
constexpr double still = 1e-6;        // squared radians: the last turn, which leaves its square of an error
constexpr double farthest = 0.5;      // squared radians: no turn is farther
constexpr double flattest = 1e-9;     // of the cubed trace: the Hessian's determinant
constexpr double rigid = 1e-9;        // of how far handles are apart: they move as one body
constexpr double in_a_line = 1e-4;    // likewise: handles that leave a rotation open
constexpr double soft_pivot = 1e-12;  // of the largest: handles that hold nearly the same share their force
constexpr double usual_share = 0.04;  // of the mesh's size: the radius of a patch
constexpr double least_edges = 2;     // of those beside a handle: what such a radius is at least
using Matrix = Eigen::Matrix3d;
using Rotation = Eigen::Quaterniond;

Eigen::Map<Vec3> point(Buffer<double>& values, uint32_t i) {
    return Eigen::Map<Vec3>(values.data() + size_t{width} * i);
}
using Row = Eigen::Vector4d;
Eigen::Map<Row, Eigen::Aligned32> row(Buffer<double>& values, uint32_t i) {
    return Eigen::Map<Row, Eigen::Aligned32>(values.data() + size_t{width} * i);
}
Eigen::Map<const Row, Eigen::Aligned32> row(const Buffer<double>& values, uint32_t i) {
    return Eigen::Map<const Row, Eigen::Aligned32>(values.data() + size_t{width} * i);
}
Rotation rotation_at(const Buffer<double>& rotations, uint32_t i) {
    const double* q = rotations.data() + size_t{width} * i;
    return Rotation(q[3], q[0], q[1], q[2]);
}

Matrix nearest_rotation(const Matrix& spread) {
    const Eigen::JacobiSVD<Matrix> svd(spread, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix turn = svd.matrixU() * svd.matrixV().transpose();
    if (turn.determinant() > 0) return turn;
    return turn - 2 * svd.matrixU().col(2) * svd.matrixV().col(2).transpose();
}

// The rotation nearest to a matrix, from one that is near as a rule: Newton's method for the largest trace of R' S. Its
// Hessian is that of a flat neighbourhood too, which methods that divide by the trace find slowly.
Rotation turn_to(const Matrix& spread, const Rotation& from) {
    Rotation rotation = from;
    for (uint32_t i = 0; i < most_turns; ++i) {
        const Matrix turned = spread * rotation.toRotationMatrix().transpose();
        const Vec3 torque(turned(2, 1) - turned(1, 2), turned(0, 2) - turned(2, 0), turned(1, 0) - turned(0, 1));
        const double xx = turned(1, 1) + turned(2, 2), yy = turned(0, 0) + turned(2, 2),
                     zz = turned(0, 0) + turned(1, 1), xy = -0.5 * (turned(0, 1) + turned(1, 0)),
                     xz = -0.5 * (turned(0, 2) + turned(2, 0)), yz = -0.5 * (turned(1, 2) + turned(2, 1));
        const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
        const double determinant = xx * a + xy * b + xz * c, trace = xx + yy + zz;
        // A largest trace is where the Hessian is definite.
        if (!(xx > 0 && xx * yy > xy * xy && determinant > flattest * trace * trace * trace)) break;
        const double d = xx * zz - xz * xz, e = xy * xz - xx * yz, f = xx * yy - xy * xy;
        const Vec3 turn =
            Vec3(a * torque.x() + b * torque.y() + c * torque.z(), b * torque.x() + d * torque.y() + e * torque.z(),
                 c * torque.x() + e * torque.y() + f * torque.z()) /
            determinant;
        const double squared = turn.squaredNorm();
        if (squared > farthest) break;
        rotation = (Rotation(1, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()) * rotation).normalized();
        if (squared < still) return rotation;
    }
    return Rotation(nearest_rotation(spread));
}

class Puller {
public:
    Puller(Pace& pace, const PullSystem& system, std::span<const PullHandle> handles, PulledState& out)
        : pace_(pace),
          system_(system),
          handles_(handles),
          out_(out),
          rest_(size_t{width} * system.count(), pace.memory()),
          at_(size_t{width} * system.count(), pace.memory()),
          next_(size_t{width} * system.count(), pace.memory()),
          radii_(pace.memory()),
          response_(pace.memory()) {}

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

    Task<void> run(std::span<const float> rest, const PulledState* previous, uint32_t rounds) {
        const uint32_t count = system_.count();
        out_.moved = Buffer<double>(size_t{width} * count, pace_.memory());
        out_.rotations = Buffer<double>(size_t{width} * count, pace_.memory());
        co_await each(pace_, count, Cost::tens_of_ns, [&](uint32_t v) {
            const uint32_t i = system_.place_of[v];
            for (uint32_t k = 0; k < 3; ++k)
                rest_[size_t{width} * i + k] = static_cast<double>(rest[size_t{3} * v + k]);
            rest_[size_t{width} * i + 3] = 0;
        });
        const bool goes_on = previous && !handles_.empty();
        if (goes_on) {
            co_await each(pace_, count, Cost::tens_of_ns, [&](uint32_t i) {
                row(at_, i) = row(std::as_const(rest_), i) + row(previous->moved, i);
                row(out_.rotations, i) = row(previous->rotations, i);
            });
        } else {
            co_await each(pace_, count, Cost::tens_of_ns, [&](uint32_t i) {
                row(at_, i) = row(std::as_const(rest_), i);
                row(out_.rotations, i) = Row::UnitW();
            });
        }
        if (!handles_.empty()) {
            co_await find_responses(previous);
            if (co_await move_as_one()) rounds = 0;
            for (uint32_t round = 0; round < rounds; ++round) {
                co_await turn();
                co_await place();
            }
        }
        co_await each(pace_, count, Cost::some_ns,
                      [&](uint32_t i) { row(out_.moved, i) = row(at_, i) - row(rest_, i); });
    }

private:
    Vec3 held(const Buffer<double>& values, const PullHandle& handle) const {
        Vec3 sum = Vec3::Zero();
        for (uint32_t c = 0; c < 3; ++c) {
            const double* const at = values.data() + size_t{width} * system_.place_of[handle.vertices[c]];
            sum += handle.shares[c] * Vec3(at[0], at[1], at[2]);
        }
        return sum;
    }

    // Handles that move rigidly move all so: that has no energy (Kabsch).
    Task<bool> move_as_one() {
        const auto size = static_cast<double>(handles_.size());
        if (size < 3) co_return false;
        Vec3 from = Vec3::Zero(), to = Vec3::Zero();
        co_await each(pace_, handles_.size(), Cost::tens_of_ns, [&](uint32_t h) {
            from += held(rest_, handles_[h]) / size;
            to += handles_[h].at / size;
        });
        Matrix both = Matrix::Zero();
        double apart = 0;
        co_await each(pace_, handles_.size(), Cost::tens_of_ns, [&](uint32_t h) {
            const Vec3 own = held(rest_, handles_[h]) - from;
            both += (handles_[h].at - to) * own.transpose();
            apart += own.squaredNorm();
        });
        const Eigen::JacobiSVD<Matrix> svd(both);
        if (!(svd.singularValues()[1] > in_a_line * apart)) co_return false;
        const Matrix turn = nearest_rotation(both);
        double off = 0;
        co_await each(pace_, handles_.size(), Cost::tens_of_ns, [&](uint32_t h) {
            off += (turn * (held(rest_, handles_[h]) - from) - (handles_[h].at - to)).squaredNorm();
        });
        if (!(off <= rigid * rigid * apart)) co_return false;
        const Rotation rotation(turn);
        co_await each(pace_, system_.count(), Cost::tens_of_ns, [&](uint32_t i) {
            point(at_, i) = turn * (point(rest_, i) - from) + to;
            double* const q = out_.rotations.data() + size_t{width} * i;
            q[0] = rotation.x(), q[1] = rotation.y(), q[2] = rotation.z(), q[3] = rotation.w();
        });
        co_return true;
    }

    Vec3 point_at_rest(const PullHandle& handle) const {
        Vec3 sum = Vec3::Zero();
        for (uint32_t c = 0; c < 3; ++c) sum += handle.shares[c] * system_.rest[system_.place_of[handle.vertices[c]]];
        return sum;
    }

    uint32_t valence(const PullHandle& handle) const {
        uint32_t edges = 0;
        for (uint32_t c = 0; c < 3; ++c) {
            const uint32_t place = system_.place_of[handle.vertices[c]];
            if (handle.shares[c] != 0) edges += system_.offsets[place + 1] - system_.offsets[place];
        }
        return edges;
    }

    // Patches end half way to the next handle: two that overlap would need huge forces to part.
    Task<void> find_radii() {
        const size_t size = handles_.size();
        std::pmr::vector<Vec3> points(pace_.memory());
        co_await each(pace_, size, Cost::tens_of_ns, [&](uint32_t h) { points.push_back(point_at_rest(handles_[h])); });
        radii_.resize(size);
        co_await each_by_work(pace_, size, Cost::some_ns, [&](uint32_t h) {
            const double asked = handles_[h].radius;
            double radius = asked < 0 ? usual_radius(system_, handles_[h]) : asked;
            for (uint32_t k = 0; k < size; ++k)
                if (k != h) radius = std::min(radius, 0.5 * (points[k] - points[h]).norm());
            radii_[h] = radius;
            return static_cast<uint32_t>(20 + size) + (asked < 0 ? valence(handles_[h]) : 0);
        });
    }

    // The force of a handle on its patch: to number `k` of each row of next_, which are 0.
    Task<void> spread_force(uint32_t h, size_t k) {
        const PullHandle& handle = handles_[h];
        const auto force = [&](uint32_t place) -> double& { return next_[size_t{width} * place + k]; };
        const Vec3 point = point_at_rest(handle);
        const double square = radii_[h] * radii_[h];
        Buffer<uint32_t> patch(square > 0 ? system_.count() : 0, pace_.memory());
        uint32_t count = 0;  // in it, each once
        double sum = 0;
        const auto reach = [&](uint32_t place) {
            const double left = 1 - (system_.rest[place] - point).squaredNorm() / square;
            if (!(left > 0) || force(place) > 0) return;
            const double own = system_.mass(place) * left * left;
            if (!(own > 0)) return;
            force(place) = own;
            sum += own;
            patch[count++] = place;
        };
        for (uint32_t c = 0; square > 0 && c < 3; ++c)
            if (handle.shares[c] > 0) reach(system_.place_of[handle.vertices[c]]);
        Slice slice(Cost::tens_of_ns);
        const auto reach_all = [&](uint32_t begin, uint32_t end) {
            for (uint32_t e = begin; e < end; ++e) reach(system_.neighbours[e]);
        };
        for (uint32_t i = 0; i < count; ++i) {
            for (Portion part(slice, system_.offsets[patch[i]], system_.offsets[patch[i] + 1]); part.next();) {
                reach_all(part.begin, part.end);
                if (part.is_over()) co_await pace_;
            }
            if (slice.is_over()) co_await pace_;
        }
        co_await each(pace_, count, Cost::some_ns, [&](uint32_t i) { force(patch[i]) /= sum; });
        for (uint32_t c = 0; count == 0 && c < 3; ++c) force(system_.place_of[handle.vertices[c]]) += handle.shares[c];
    }

    // What handles do to the surface; those of the frame before are kept.
    Task<void> find_responses(const PulledState* previous) {
        const uint32_t count = system_.count();
        co_await find_radii();
        std::pmr::vector<uint32_t> missing(pace_.memory());
        out_.responses.resize(handles_.size());
        Slice slice(Cost::some_ns);
        for (uint32_t h = 0; h < handles_.size(); ++h) {
            if (slice.is_over(1 + static_cast<uint32_t>(previous ? previous->responses.size() : 0))) co_await pace_;
            if (previous) {
                for (const auto& known : previous->responses)
                    if (known->handle.holds_as(handles_[h]) && known->handle.radius == radii_[h])
                        out_.responses[h] = known;
            }
            if (!out_.responses[h]) missing.push_back(h);
        }
        for (size_t first = 0; first < missing.size(); first += width) {
            co_await each(pace_, next_.size(), Cost::some_ns, [&](uint32_t i) { next_[i] = 0; });
            const size_t some = std::min<size_t>(width, missing.size() - first);
            for (size_t k = 0; k < some; ++k) co_await spread_force(missing[first + k], k);
            co_await solve_points(pace_, system_.factor, {next_.data(), next_.size()});
            for (size_t k = 0; k < some; ++k) {
                auto made =
                    std::allocate_shared<PullResponse>(std::pmr::polymorphic_allocator<PullResponse>(pace_.memory()));
                made->handle = handles_[missing[first + k]];
                made->handle.radius = radii_[missing[first + k]];
                made->values = Buffer<double>(count, pace_.memory());
                co_await each(pace_, count, Cost::some_ns,
                              [&](uint32_t i) { made->values[i] = next_[size_t{width} * i + k]; });
                out_.responses[missing[first + k]] = std::move(made);
            }
        }
        co_await factorize_responses();
    }

    double answer(uint32_t handle, uint32_t force) const {
        double sum = 0;
        for (uint32_t c = 0; c < 3; ++c)
            sum += handles_[handle].shares[c] *
                   out_.responses[force]->values[system_.place_of[handles_[handle].vertices[c]]];
        return sum;
    }

    // L U of the handles' own matrix, dense, row by row; the diagonal of L is 1. No pivot is sought: what answers most
    // to a force is what it acts on.
    Task<void> factorize_responses() {
        const auto size = static_cast<uint32_t>(handles_.size());
        response_.resize(size_t{size} * size);
        double largest = 0;
        Slice slice(Cost::some_ns);
        for (uint32_t h = 0; h < size; ++h) {
            for (uint32_t k = 0; k < size; ++k) {
                double value = answer(h, k) + (h == k ? handles_[h].compliance : 0);
                if (h == k) largest = std::max(largest, value);
                for (uint32_t m = 0; m < std::min(h, k); ++m) value -= at(h, m) * at(m, k);
                at(h, k) = k < h ? value / at(k, k) : k > h ? value : std::max(value, soft_pivot * largest);
                if (slice.is_over(8 + std::min(h, k))) co_await pace_;
            }
        }
    }
    double& at(uint32_t row, uint32_t column) { return response_[row * handles_.size() + column]; }

    // The local step, and with each rotation what it gives to the right-hand sides of the global one.
    Task<void> turn() {
        co_await each(pace_, system_.count(), Cost::some_ns,
                      [&](uint32_t i) { row(next_, i) = system_.mass(i) * row(at_, i); });
        double energy = 0;
        co_await each(pace_, system_.count(), Cost::hundreds_of_ns, [&](uint32_t i) { energy += turn_one(i); });
        out_.energy = std::max(energy, 0.0);
    }
    // With four numbers a point, of which the last are 0: two registers.
    double turn_one(uint32_t i) {
        const uint32_t begin = system_.offsets[i], end = system_.offsets[i + 1];
        const Row own_now = row(at_, i), own_rest = row(rest_, i);
        Eigen::Matrix<double, 4, 3> spread = Eigen::Matrix<double, 4, 3>::Zero();
        Row lengths = Row::Zero();
        for (uint32_t e = begin; e < end; ++e) {
            const uint32_t j = system_.neighbours[e];
            const Row now = own_now - row(at_, j), before = own_rest - row(rest_, j);
            const Row weighed = static_cast<double>(system_.weights[e]) * now;
            for (int k = 0; k < 3; ++k) spread.col(k) += before[k] * weighed;
            lengths +=
                weighed.cwiseProduct(now) + static_cast<double>(system_.weights[e]) * before.cwiseProduct(before);
        }
        const Matrix moved = spread.topRows<3>();
        const Rotation found = turn_to(moved, rotation_at(out_.rotations, i));
        double* const q = out_.rotations.data() + size_t{width} * i;
        q[0] = found.x(), q[1] = found.y(), q[2] = found.z(), q[3] = found.w();
        Eigen::Matrix<double, 4, 3> turn;
        turn << 0.5 * found.toRotationMatrix(), Eigen::RowVector3d::Zero();
        Row sum = Row::Zero();
        for (uint32_t e = begin; e < end; ++e) {
            const uint32_t j = system_.neighbours[e];
            const Row before = static_cast<double>(system_.weights[e]) * (own_rest - row(rest_, j));
            const Row half = before[0] * turn.col(0) + before[1] * turn.col(1) + before[2] * turn.col(2);
            sum += half;
            row(next_, j) -= half;
        }
        row(next_, i) += sum;
        return lengths.sum() - 4 * turn.cwiseProduct(spread).sum();
    }

    // The global step.
    Task<void> place() {
        co_await solve_points(pace_, system_.factor, {next_.data(), next_.size()});
        co_await meet_handles();
        std::swap(at_, next_);
    }

    // The forces at handles that bring these where they are to be.
    Task<void> meet_handles() {
        const auto size = static_cast<uint32_t>(handles_.size());
        std::pmr::vector<Vec3> forces(size, Vec3::Zero(), pace_.memory());
        Slice slice(Cost::some_ns);
        for (uint32_t h = 0; h < size; ++h) {
            Vec3 off = handles_[h].at - held(next_, handles_[h]);
            for (uint32_t m = 0; m < h; ++m) off -= at(h, m) * forces[m];
            forces[h] = off;
            if (slice.is_over(8 + h)) co_await pace_;
        }
        for (uint32_t h = size; h-- > 0;) {
            for (uint32_t m = h + 1; m < size; ++m) forces[h] -= at(h, m) * forces[m];
            forces[h] /= at(h, h);
            if (slice.is_over(8 + size - h)) co_await pace_;
        }
        std::pmr::vector<const double*> responses(pace_.memory());
        for (const auto& response : out_.responses) responses.push_back(response->values.data());
        co_await each_by_work(pace_, system_.count(), Cost::some_ns, [&](uint32_t i) {
            Vec3 sum = Vec3::Zero();
            for (uint32_t h = 0; h < size; ++h) sum += responses[h][i] * forces[h];
            point(next_, i) += sum;
            return 2 + size;
        });
    }

    Pace& pace_;
    const PullSystem& system_;
    std::span<const PullHandle> handles_;
    PulledState& out_;
    Buffer<double> rest_, at_, next_;
    std::pmr::vector<double> radii_;     // of patches, by handle
    std::pmr::vector<double> response_;  // its factors
};

}  // namespace

double usual_radius(const PullSystem& system, const PullHandle& handle) {
    double sum = 0;
    uint32_t edges = 0;
    for (uint32_t c = 0; c < 3; ++c) {
        if (handle.shares[c] == 0) continue;
        const uint32_t place = system.place_of[handle.vertices[c]];
        for (uint32_t e = system.offsets[place]; e < system.offsets[place + 1]; ++e, ++edges)
            sum += (system.rest[system.neighbours[e]] - system.rest[place]).norm();
    }
    return std::max(usual_share * system.size, edges > 0 ? least_edges * sum / edges : 0);
}

Task<void> pull(Pace& pace, const PullSystem& system, std::span<const float> rest, std::span<const PullHandle> handles,
                const PulledState* previous, uint32_t rounds, PulledState& out) {
    Puller puller(pace, system, handles, out);
    co_await puller.run(rest, previous, rounds);
}

}  // namespace flg
