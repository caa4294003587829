// SPDX-License-Identifier: MIT
#include "splines/cloud_samples.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t fewest_neighbours = 6, most_neighbours = 32;
// How far apart k + 1 points are that fill a disc evenly, as a share of its radius times the root of k + 1.
constexpr double even_spacing = 1.9046;
// A sample reaches no farther than this times what its neighbours reach: what lies alone does not cover the others.
constexpr double most_reach = 1.5;
// Points that may be looked at for neighbours: where so many lie in one place, the nearest ones elsewhere don't matter.
constexpr uint32_t most_visited = 4096;
// A plane is there if the neighbours' second width is this share of the first.
constexpr double least_width = 1e-6;
// Bends are held below this over the distance of points.
constexpr double most_bent = 0.7;
constexpr uint32_t measured_points = 2048;

}  // namespace

CloudSamplesKernel::CloudSamplesKernel(const CloudInput& input, Memory* memory)
    : input_(input),
      memory_(memory),
      per_point_(
          std::min(std::clamp(input.neighbours, fewest_neighbours, most_neighbours), std::max(input.count, 1u) - 1)) {
    if (input.count < 4) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a surface needs 4 points, and there are %u", input.count);
    }
    positions_ = GrowingBuffer<Position>(input.count, memory);
}

void CloudSamplesKernel::enter(Pass pass) {
    pass_ = pass;
    at_ = 0;
    switch (pass) {
        case Pass::order: order_.emplace(positions_, memory_); break;
        case Pass::place:
            places_ = Buffer<Position>(input_.count, memory_);
            normals_ = Buffer<Position>(input_.count, memory_);
            break;
        case Pass::tree:
            order_.reset();
            positions_ = {};
            tree_ = PointTree(input_.count, memory_);
            break;
        case Pass::neighbours:
            near_ = Buffer<uint32_t>(size_t{input_.count} * per_point_, memory_);
            reaches_ = Buffer<double>(input_.count, memory_);
            break;
        case Pass::orient:
            if (!input_.normals) orientation_.emplace(places_, near_, per_point_, normals_, memory_);
            break;
        case Pass::fit:
            if (orientation_) parts_ = orientation_->parts();
            orientation_.reset();
            samples_ = GrowingBuffer<OrientedSample>(input_.count, memory_);
            samples_.resize(0);
            break;
        case Pass::sort: sort_.emplace(std::move(samples_), memory_); break;
        case Pass::measure: surface_.emplace(sort_->take()); break;
        case Pass::done:
            if (deviation_.places > 0) deviation_.mean = deviations_ / deviation_.places;
            break;
        default: break;
    }
}

bool CloudSamplesKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        uint32_t end = input_.count;
        switch (pass_) {
            case Pass::copy: positions_[at_] = input_.points[at_]; break;
            case Pass::order:
                if (!order_->run(count)) return false;
                enter(Pass::place);
                continue;
            case Pass::place: place(); break;
            case Pass::tree: {
                const auto ball = [&](uint32_t i, double* centre, double& radius) {
                    for (size_t k = 0; k < 3; ++k) centre[k] = places_[i][k];
                    radius = 0;
                };
                if (!tree_.build((count + 7) / 8, ball)) return false;
                enter(Pass::neighbours);
                continue;
            }
            case Pass::neighbours: find_neighbours(); break;
            case Pass::orient:
                if (orientation_ && !orientation_->run(count)) return false;
                enter(Pass::fit);
                continue;
            case Pass::fit: fit(); break;
            case Pass::sort:
                if (!sort_->run(count)) return false;
                enter(Pass::measure);
                continue;
            case Pass::measure:
                measure();
                end = std::min(input_.count, measured_points);
                break;
            case Pass::done: break;
        }
        if (++at_ == end) enter(static_cast<Pass>(static_cast<int>(pass_) + 1));
    }
    return pass_ == Pass::done;
}

void CloudSamplesKernel::place() {
    const uint32_t from = order_->vertex_at(at_);
    places_[at_] = input_.points[from];
    normals_[at_] = {};
    if (input_.normals) store_vec3(load_vec3(input_.normals[from].data()).stableNormalized(), normals_[at_].data());
}

// The nearest points that lie elsewhere; and the direction across which they are narrowest.
void CloudSamplesKernel::find_neighbours() {
    const Vec3 place = load_vec3(places_[at_].data());
    double squares[most_neighbours], limit = std::numeric_limits<double>::infinity();
    uint32_t found[most_neighbours], count = 0, visited = 0;
    // Those beside it in the order are near, and the k-th neighbour is no farther than the farthest of k of them.
    const uint32_t begin = std::min(at_ - std::min(at_, per_point_ / 2), input_.count - 1 - per_point_);
    double farthest = 0, closest = limit;
    for (uint32_t i = begin; i <= begin + per_point_; ++i) {
        const double square = (load_vec3(places_[i].data()) - place).squaredNorm();
        farthest = std::max(farthest, square);
        if (i != at_) closest = std::min(closest, square);
    }
    if (closest > 0) limit = std::nextafter(farthest, limit);
    tree_.nearest(place.data(), limit, [&](uint32_t first, uint32_t end) {
        for (uint32_t i = first; i < end; ++i) {
            const double square = (load_vec3(places_[i].data()) - place).squaredNorm();
            if (!(square > 0) || !(square < limit)) continue;
            uint32_t slot = count < per_point_ ? count++ : per_point_ - 1;
            for (; slot > 0 && squares[slot - 1] > square; --slot) {
                squares[slot] = squares[slot - 1];
                found[slot] = found[slot - 1];
            }
            squares[slot] = square;
            found[slot] = i;
            if (count == per_point_) limit = squares[per_point_ - 1];
        }
        visited += end - first;
        if (visited > most_visited) limit = 0;
    });
    std::fill_n(&near_[size_t{at_} * per_point_], per_point_, no_index);
    std::copy_n(found, count, &near_[size_t{at_} * per_point_]);
    reaches_[at_] = count > 0 ? std::sqrt(squares[count - 1]) : 0;
    if (input_.normals || count < 2) return;

    Vec3 mean = place;
    for (uint32_t i = 0; i < count; ++i) mean += load_vec3(places_[found[i]].data());
    mean /= count + 1;
    Eigen::Matrix3d spread = (place - mean) * (place - mean).transpose();
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 d = load_vec3(places_[found[i]].data()) - mean;
        spread += d * d.transpose();
    }
    spread /= squares[count - 1];
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(spread);
    const Vec3 widths = solver.eigenvalues();
    if (!(widths[1] > least_width * widths[2])) return;
    const Vec3 normal = solver.eigenvectors().col(0);
    store_vec3(normal.normalized(), normals_[at_].data());
}

void CloudSamplesKernel::fit() {
    const Vec3 place = load_vec3(places_[at_].data()), normal = load_vec3(normals_[at_].data());
    const uint32_t* near = &near_[size_t{at_} * per_point_];
    double reach = reaches_[at_];
    if (!(reach > 0) || normal.isZero()) return;
    const double spacing = reach * even_spacing / std::sqrt(per_point_ + 1.0);
    QuadricFit quadric(place, normal.normalized(), spacing, false);
    for (uint32_t i = 0; i < per_point_ && near[i] != no_index; ++i) {
        const Vec3 other = load_vec3(places_[near[i]].data()), other_normal = load_vec3(normals_[near[i]].data());
        reach = std::min(reach, most_reach * reaches_[near[i]]);
        if (normal.dot(other_normal) < 0) continue;  // on the other side of a thin part
        quadric.add_point(other);
        if (input_.normals && !other_normal.isZero()) quadric.add_normal(other, other_normal.normalized());
    }
    BentNormal bent = quadric.solve();
    if (bent.curvature * spacing > most_bent) {
        for (double& b : bent.bend) b *= most_bent / (bent.curvature * spacing);
    }
    // Not farther than neighbours are: what lies off by more is no noise.
    const Vec3 on = place + std::clamp(bent.height, -spacing, spacing) * normal.normalized();
    const Vec3& n = bent.normal;
    samples_.push_back({{on.x(), on.y(), on.z()}, {n.x(), n.y(), n.z()}, bent.bend, reach});
}

void CloudSamplesKernel::measure() {
    const uint64_t index = uint64_t{at_} * input_.count / std::min(input_.count, measured_points);
    const Vec3 place = load_vec3(places_[index].data());
    SurfaceDeviation& deviation = deviation_;
    double away = 0;
    if (surface_->distance_estimate(place, &away)) {
        deviation.largest = std::max(deviation.largest, away);
        deviations_ += away;
        ++deviation.places;
    } else {
        ++deviation.uncovered;
    }
}

}  // namespace flg
