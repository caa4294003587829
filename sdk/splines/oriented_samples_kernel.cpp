// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/failure.h"
#include "splines/oriented_samples.h"

namespace flg {

namespace {

constexpr uint32_t fewest_samples = 4;
// A sample is another one again if it is nearer to it than this share of both radii, and turned by less than 18
// degrees.
constexpr double same_share = 0.15, parallel_cosine = 0.95;
constexpr uint32_t looked_back = 8;

}  // namespace

OrientedSamplesKernel::OrientedSamplesKernel(GrowingBuffer<OrientedSample> samples, Memory* memory)
    : memory_(memory), samples_(std::move(samples)) {
    const size_t count = samples_.size();
    if (count < fewest_samples) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a surface needs %u samples that have a normal, and there are %u",
                      fewest_samples, static_cast<uint32_t>(count));
    }
    positions_ = GrowingBuffer<Position>(count, memory);
    sorted_ = Buffer<OrientedSample>(count, memory);
}

bool OrientedSamplesKernel::run(uint32_t count) {
    const uint32_t samples = static_cast<uint32_t>(samples_.size());
    switch (pass_) {
        case Pass::positions:
            for (; count > 0 && at_ < samples; --count, ++at_) {
                const Vec3 p(samples_[at_].position.data());
                store_vec3(p, positions_[at_].data());
                lower_ = at_ == 0 ? p : lower_.cwiseMin(p);
                upper_ = at_ == 0 ? p : upper_.cwiseMax(p);
            }
            if (at_ < samples) return false;
            order_.emplace(positions_, memory_);
            break;
        case Pass::order:
            if (!order_->run(count)) return false;
            break;
        case Pass::sort:
            for (; count > 0 && at_ < samples; --count, ++at_) keep(samples_[order_->vertex_at(at_)]);
            if (at_ < samples) return false;
            order_.reset();
            positions_ = {};
            tree_ = PointTree(kept_, memory_);
            break;
        case Pass::tree: {
            const auto ball = [&](uint32_t i, double* centre, double& radius) {
                for (size_t k = 0; k < 3; ++k) centre[k] = sorted_[i].position[k];
                radius = sorted_[i].radius;
            };
            if (!tree_.build((count + 7) / 8, ball)) return false;
            break;
        }
        case Pass::done: return true;
    }
    at_ = 0;
    pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    return pass_ == Pass::done;
}

// Unless it is all but another one: of those that came last, since what is near in space is near in the order.
void OrientedSamplesKernel::keep(const OrientedSample& sample) {
    const Vec3 place(sample.position.data()), normal(sample.normal.data());
    for (uint32_t back = 1; back <= std::min(kept_, looked_back); ++back) {
        const OrientedSample& other = sorted_[kept_ - back];
        const double apart = (Vec3(other.position.data()) - place).norm();
        const bool parallel = normal.dot(Vec3(other.normal.data())) > parallel_cosine;
        if (parallel && apart < same_share * std::min(other.radius, sample.radius)) return;
    }
    OrientedSample& kept = sorted_[kept_++];
    kept = sample;
    kept.sharpness = 1 / (sample.radius * sample.radius);
    radii_ += sample.radius;
}

OrientedSamples OrientedSamplesKernel::take() {
    return OrientedSamples(std::move(sorted_), std::move(tree_), (upper_ - lower_).norm(), radii_ / kept_);
}

}  // namespace flg
