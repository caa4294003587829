// SPDX-License-Identifier: MIT
// The smooth surface of a point cloud: a sample at each point, with the normal and the curvature of a quadric through
// its neighbours. Noise is smoothed over the distance of the neighbours: samples lie on the quadrics, not at the
// points. Normals that the host has not given are those of the neighbours' best planes, turned to one side
// (cloud_orientation.h).
#pragma once

#include <optional>

#include "splines/cloud_orientation.h"
#include "splines/mesh_samples.h"
#include "splines/oriented_samples.h"
#include "splines/quadric_fit.h"

namespace flg {

struct CloudInput {
    const Position* points = nullptr;   // metres, finite
    const Position* normals = nullptr;  // outwards, of any length; may be null
    uint32_t count = 0;
    // Of each point, 6 to 32: more of them smooth more. A sample reaches as far as the last of them.
    uint32_t neighbours = 16;
};

class CloudSamplesKernel {
public:
    // The arrays outlive the kernel. A Failure says so if there are fewer than 4 points. Memory: 300 bytes a point.
    CloudSamplesKernel(const CloudInput& input, Memory* memory);
    // A unit is a point in one of about 15 passes: 5 ns to 4 us, 400 ns in the mean.
    bool run(uint32_t count);

    // After run() returned true, once. Points in whose neighbourhood there is no plane have no sample; a Failure says
    // so if fewer than 4 have one.
    OrientedSamples take() { return std::move(*surface_); }
    // At points of the cloud: what they lie off the surface, which is their noise.
    const SurfaceDeviation& deviation() const { return deviation_; }
    // That were not joined by neighbours, and may be turned against each other. 0 where normals were given.
    uint32_t parts() const { return parts_; }

private:
    enum class Pass { copy, order, place, tree, neighbours, orient, fit, sort, measure, done };

    void enter(Pass pass);
    void place();
    void find_neighbours();
    void fit();
    void measure();

    const CloudInput input_;
    Memory* memory_;
    const uint32_t per_point_;
    GrowingBuffer<Position> positions_;
    std::optional<SpatialOrderKernel> order_;
    Buffer<Position> places_, normals_;  // in the order of the tree
    PointTree tree_;
    Buffer<uint32_t> near_;   // per_point of each point, nearest first
    Buffer<double> reaches_;  // metres, to the last of them
    std::optional<CloudOrientationKernel> orientation_;
    GrowingBuffer<OrientedSample> samples_;
    std::optional<OrientedSamplesKernel> sort_;
    std::optional<OrientedSamples> surface_;
    SurfaceDeviation deviation_;
    double deviations_ = 0;
    uint32_t parts_ = 0, at_ = 0;
    Pass pass_ = Pass::copy;
};

}  // namespace flg
