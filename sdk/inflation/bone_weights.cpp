// SPDX-License-Identifier: MIT
#include "inflation/bone_weights.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t batch = 16;
constexpr uint32_t bones_a_unit = 16;
constexpr uint32_t width = CholeskySolve::width;
constexpr uint32_t no_column = UINT32_MAX, joint_limit = 65536;
constexpr double least_edge_weight = 1e-3;
constexpr double soft =
    0.25;  // of the radius: bones that are so much farther than the nearest have no weight to begin with
constexpr double least_radius = 0.5;  // of the lattice's spacing: bones without one
constexpr double cut_off =
    0.005;  // weights below it become 0, all others are less by it before they are made to sum to 1

}  // namespace

BoneWeightsKernel::BoneWeightsKernel(const MergedMesh& mesh, std::span<const BoneSegment> bones,
                                     const BoneWeightOptions& options, BoneWeights& out, Memory* memory)
    : mesh_(mesh), bones_(bones), options_(options), out_(out), memory_(memory), joint_of_column_(memory) {
    if (bones.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "weights: there are no bones");
    if (!(options.reach >= 0.05 && options.reach <= 2))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "weights: reach is %g; it is within 0.05 and 2", options.reach);
    const size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
    cotangents_ = Buffer<std::array<double, 3>>(triangles, memory);
    area_ = Buffer<double>(vertices, memory);
    spread_ = Buffer<double>(vertices, memory);
    first_columns_ = Buffer<std::array<uint32_t, 4>>(vertices, memory);
    first_weights_ = Buffer<std::array<float, 4>>(vertices, memory);
    column_of_joint_ = Buffer<uint32_t>(joint_limit, memory);
    largest_ = Buffer<std::array<float, kept>>(vertices, memory);
    largest_joints_ = Buffer<std::array<uint16_t, kept>>(vertices, memory);
}

bool BoneWeightsKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void BoneWeightsKernel::step() {
    const auto vertices = static_cast<uint32_t>(mesh_.positions.size());
    const auto enter = [this](Pass pass) {
        at_ = 0;
        pass_ = pass;
    };
    // Does something with the next few of `end`; true when that was the last.
    const auto each = [this](uint32_t end, uint32_t few, const auto& action) {
        for (const uint32_t stop = std::min(end, at_ + few); at_ < stop; ++at_) action(at_);
        return at_ == end;
    };
    switch (pass_) {
        case Pass::clear_joints:
            if (each(joint_limit, 64, [&](uint32_t i) { column_of_joint_[i] = no_column; })) enter(Pass::mark_joints);
            break;
        case Pass::mark_joints:
            if (each(static_cast<uint32_t>(bones_.size()), batch, [&](uint32_t i) { mark_joint(bones_[i], i); }))
                enter(Pass::number_joints);
            break;
        case Pass::number_joints:
            if (each(joint_limit, 64, [&](uint32_t i) {
                    if (column_of_joint_[i] == no_column) return;
                    column_of_joint_[i] = static_cast<uint32_t>(joint_of_column_.size());
                    joint_of_column_.push_back(static_cast<uint16_t>(i));
                }))
                enter(Pass::clear);
            break;
        case Pass::clear:
            if (each(vertices, batch, [&](uint32_t i) {
                    area_[i] = 0;
                    largest_[i].fill(0);
                    largest_joints_[i].fill(0);
                }))
                enter(Pass::measure);
            break;
        case Pass::measure:
            if (each(static_cast<uint32_t>(mesh_.triangles.size()), batch / 4, [&](uint32_t i) { measure(i); }))
                enter(Pass::nearest);
            break;
        case Pass::nearest:
            if (at_ < vertices) {
                nearest();
                break;
            }
            laplacian_.emplace(LaplacianInput{.triangles = {mesh_.triangles.data(), mesh_.triangles.size()},
                                              .cotangents = {cotangents_.data(), cotangents_.size()},
                                              .row_count = vertices,
                                              .mass = {area_.data(), area_.size()},
                                              .scale = {spread_.data(), spread_.size()},
                                              .least_weight = least_edge_weight},
                               matrix_, memory_);
            enter(Pass::assemble);
            break;
        case Pass::assemble:
            if (!laplacian_->run(1)) break;
            laplacian_.reset();
            order_.emplace(matrix_, std::span<const Vec3>(mesh_.positions.data(), vertices), memory_);
            enter(Pass::order);
            break;
        case Pass::order:
            if (!order_->run(1)) break;
            cholesky_.emplace(matrix_, order_->take_order(), memory_);
            order_.reset();
            enter(Pass::factor);
            break;
        case Pass::factor:
            if (!cholesky_->run(1)) break;
            values_ = Buffer<double>(size_t{width} * vertices, memory_);
            enter(Pass::load);
            break;
        case Pass::load:
            if (each(vertices, batch / 2, [&](uint32_t i) { load(i); })) {
                solve_.emplace(*cholesky_, std::span<double>(values_.data(), values_.size()), memory_);
                enter(Pass::solve);
            }
            break;
        case Pass::solve:
        case Pass::solve_again:
            if (solve_->run(1)) enter(pass_ == Pass::solve ? Pass::load_again : Pass::collect);
            break;
        case Pass::load_again:
            if (each(vertices, batch / 2, [&](uint32_t i) {
                    for (uint32_t k = 0; k < width; ++k) values_[size_t{width} * i + k] *= area_[i];
                })) {
                solve_.emplace(*cholesky_, std::span<double>(values_.data(), values_.size()), memory_);
                enter(Pass::solve_again);
            }
            break;
        case Pass::collect:
            if (!each(vertices, batch / 4, [&](uint32_t i) { collect(i); })) break;
            column_ += width;
            enter(column_ < joint_of_column_.size() ? Pass::load : Pass::finish);
            if (pass_ == Pass::finish) {
                out_.joints = Buffer<std::array<uint16_t, 4>>(vertices, memory_);
                out_.weights = Buffer<std::array<float, 4>>(vertices, memory_);
            }
            break;
        case Pass::finish:
            if (each(vertices, batch, [&](uint32_t i) { finish(i); })) pass_ = Pass::done;
            break;
        case Pass::done: break;
    }
}

void BoneWeightsKernel::mark_joint(const BoneSegment& bone, uint32_t number) {
    if (bone.joint >= joint_limit)
        throw Failure(FLG_ERROR_LIMIT, "weights: bone %u belongs to joint %u; there are at most %u", number, bone.joint,
                      joint_limit);
    if (!bone.from.allFinite() || !bone.to.allFinite() || !(bone.from_radius >= 0) || !(bone.to_radius >= 0) ||
        !std::isfinite(bone.from_radius + bone.to_radius))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "weights: bone %u has an end or a radius that is not finite, or below 0", number);
    column_of_joint_[bone.joint] = 0;
}

void BoneWeightsKernel::measure(uint32_t triangle) {
    const TriangleVertices& t = mesh_.triangles[triangle];
    const Vec3 p[3] = {mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]};
    // Of a triangle without area the cotangents are of one with a little: what it joins stays joined.
    const double twice = std::max((p[1] - p[0]).cross(p[2] - p[0]).norm(),
                                  1e-6 * ((p[1] - p[0]).squaredNorm() + (p[2] - p[0]).squaredNorm()));
    for (uint32_t k = 0; k < 3; ++k) {
        cotangents_[triangle][k] = 0.5 * (p[(k + 1) % 3] - p[k]).dot(p[(k + 2) % 3] - p[k]) / twice;
        area_[t[k]] += twice / 6;
    }
}

// Some bones for the vertex that is looked at.
void BoneWeightsKernel::nearest() {
    const auto count = static_cast<uint32_t>(bones_.size());
    for (const uint32_t stop = std::min(count, bone_ + bones_a_unit); bone_ < stop; ++bone_)
        if (any_part_ || bones_[bone_].part == mesh_.parts[at_]) offer(bones_[bone_]);
    if (bone_ < count) return;
    bone_ = 0;
    if (near_count_ == 0) {
        any_part_ = true;
        return;
    }
    end_nearest(at_);
    near_count_ = 0;
    any_part_ = false;
    ++at_;
}

void BoneWeightsKernel::offer(const BoneSegment& bone) {
    const Vec3 along = bone.to - bone.from, from = mesh_.positions[at_] - bone.from;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
    const Near near{column_of_joint_[bone.joint], (from - share * along).norm(),
                    bone.from_radius + share * (bone.to_radius - bone.from_radius)};
    const auto before = [](const Near& a, const Near& b) {
        return a.distance < b.distance || (a.distance == b.distance && a.column < b.column);
    };
    // A joint's nearest bone counts.
    uint32_t place = 0;
    while (place < near_count_ && near_[place].column != near.column) ++place;
    if (place < near_count_) {
        if (!before(near, near_[place])) return;
    } else if (near_count_ < near_.size()) {
        place = near_count_++;
    } else if (before(near, near_.back())) {
        place = near_count_ - 1;
    } else {
        return;
    }
    near_[place] = near;
    for (; place > 0 && before(near_[place], near_[place - 1]); --place) std::swap(near_[place], near_[place - 1]);
}

void BoneWeightsKernel::end_nearest(uint32_t vertex) {
    const double radius = std::max(near_[0].radius, least_radius * mesh_.spacing);
    spread_[vertex] = options_.reach * options_.reach * radius * radius;
    double weights[4] = {}, sum = 0;
    for (uint32_t k = 0; k < near_count_; ++k) {
        const double left = std::max(0.0, 1 - (near_[k].distance - near_[0].distance) / (soft * radius));
        sum += weights[k] = left * left;
    }
    for (uint32_t k = 0; k < 4; ++k) {
        first_columns_[vertex][k] = k < near_count_ ? near_[k].column : no_column;
        first_weights_[vertex][k] = static_cast<float>(weights[k] / sum);
    }
}

// Eight columns of a row: the areas times the weights that it begins with.
void BoneWeightsKernel::load(uint32_t vertex) {
    double* row = &values_[size_t{width} * vertex];
    std::fill_n(row, width, 0);
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t column = first_columns_[vertex][k];
        if (column != no_column && column >= column_ && column < column_ + width)
            row[column - column_] = area_[vertex] * static_cast<double>(first_weights_[vertex][k]);
    }
}

void BoneWeightsKernel::collect(uint32_t vertex) {
    auto& largest = largest_[vertex];
    auto& joints = largest_joints_[vertex];
    for (uint32_t k = 0; k < width && column_ + k < joint_of_column_.size(); ++k) {
        const auto weight = static_cast<float>(values_[size_t{width} * vertex + k]);
        if (weight <= largest[kept - 1]) continue;
        uint32_t place = kept - 1;
        for (; place > 0 && largest[place - 1] < weight; --place) {
            largest[place] = largest[place - 1];
            joints[place] = joints[place - 1];
        }
        largest[place] = weight;
        joints[place] = joint_of_column_[column_ + k];
    }
}

// All weights are less by the fifth, so that those that come in or go out do so at 0.
void BoneWeightsKernel::finish(uint32_t vertex) {
    const auto& largest = largest_[vertex];
    const double least = std::max(cut_off, static_cast<double>(largest[kept - 1]));
    double weights[4], sum = 0;
    for (uint32_t k = 0; k < 4; ++k) sum += weights[k] = std::max(0.0, largest[k] - least);
    if (!(sum > 1e-6)) {
        // Five or more joints move it alike.
        sum = 4;
        std::fill_n(weights, 4, 1.0);
    }
    for (uint32_t k = 0; k < 4; ++k) {
        const auto weight = static_cast<float>(weights[k] / sum);
        out_.weights[vertex][k] = weight;
        out_.joints[vertex][k] = weight > 0 ? largest_joints_[vertex][k] : uint16_t{0};
    }
}

}  // namespace flg
