// SPDX-License-Identifier: MIT
#include "core/failure.h"
#include "splines/oriented_samples.h"

namespace flg {

namespace {

constexpr uint32_t fewest_samples = 4;

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
    tree_ = PointTree(static_cast<uint32_t>(count), memory);
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
            for (; count > 0 && at_ < samples; --count, ++at_) {
                OrientedSample& sample = sorted_[at_];
                sample = samples_[order_->vertex_at(at_)];
                sample.sharpness = 1 / (sample.radius * sample.radius);
                radii_ += sample.radius;
            }
            if (at_ < samples) return false;
            order_.reset();
            positions_ = {};
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

OrientedSamples OrientedSamplesKernel::take() {
    return OrientedSamples(std::move(sorted_), std::move(tree_), (upper_ - lower_).norm(),
                           radii_ / static_cast<double>(samples_.size()));
}

}  // namespace flg
