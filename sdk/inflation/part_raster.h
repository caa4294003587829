// SPDX-License-Identifier: MIT
// Fills the raster of an inflated part. Inside, from the triangulation: on each triangle a quadratic whose values between two
// vertices follow from slopes there, recovered as means of the triangles around; on the border the slope is what balances the
// equation (the residual of the linear elements; Carey: Derivative calculation from finite element solutions, 1982). Outside,
// from the nearest edge of the border, found by passing edges on from value to value (Danielsson: Euclidean
// distance mapping, 1980).
#pragma once

#include <vector>

#include "inflation/inflated_part.h"

namespace flg {

class PartRasterKernel {
public:
    // Of a part with heights. Both outlive the kernel. At most 512 values a side; 12 bytes a value while it runs.
    PartRasterKernel(InflatedPart& part, Memory* memory);

    // A unit is about 0.3 us.
    bool run(uint32_t count);

private:
    enum class Pass { clear, gather, slopes, empty, inside, edges, sweep, finish, done };
    struct Edge {
        uint32_t a, b;  // vertices
    };

    void step();
    void gather(uint32_t triangle);
    void begin_values();
    void begin_inside();
    void inside();
    void add_near_edge(uint32_t edge);
    void offer(size_t place, uint32_t edge);
    void pass_on(uint32_t place);
    void finish(uint32_t place);
    double distance_to(uint32_t edge, const Point2& p, double* share) const;
    Point2 place_of(uint32_t place) const;

    InflatedPart& part_;
    PartRaster& raster_;
    Memory* memory_;
    Buffer<Point2> slopes_;     // of g at vertices
    Buffer<double> weights_;    // inside: twice the area around; on the border: half the length of the edges at it
    Buffer<double> residuals_;  // at border vertices; later how steep it is there
    std::pmr::vector<Edge> edges_;
    Buffer<uint32_t> nearest_;  // edge, by value; or a mark that it is inside
    Buffer<float> distance_;    // to it
    Point2 low_{}, high_{};
    uint32_t row_ = 0, end_row_ = 0;  // of the triangle that is drawn
    uint32_t sweep_ = 0;
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
};

}  // namespace flg
