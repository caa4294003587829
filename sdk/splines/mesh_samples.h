// SPDX-License-Identifier: MIT
// The smooth surface of a triangle mesh: samples at its vertices, with normals and curvatures fitted to the neighbours,
// and more samples along edges and in triangles where they are long compared to how the surface bends, or beside sharp
// edges. Creases are rounded, by about the distance of samples there: a 24th of the mesh's size, or what its edges are
// long if that is less. Open borders go on a little, about half an edge.
#pragma once

#include <optional>

#include "splines/mesh_creases.h"
#include "splines/mesh_sectors.h"
#include "splines/oriented_samples.h"
#include "splines/quadric_fit.h"

namespace flg {

// How far the smooth surface is from the mesh: at vertices and middles of triangles, of so many triangles.
struct SurfaceDeviation {
    double largest = 0, mean = 0;  // metres
    uint32_t places = 0;           // where it was measured
    uint32_t uncovered = 0;        // those of them that no sample reaches, which the others leave out
};

class MeshSamplesKernel {
public:
    // Outlives the kernel; with one triangle at least.
    MeshSamplesKernel(const Mesh& mesh, Memory* memory);
    // A unit is a corner, a triangle or a sample in one of about 20 passes: 5 to 400 ns, 80 ns in the mean. A Failure
    // says if there are not samples enough.
    bool run(uint32_t count);

    // After run() returned true, once.
    OrientedSamples take() { return std::move(*surface_); }
    const SurfaceDeviation& deviation() const { return deviation_; }
    uint32_t extra_count() const { return extra_count_; }  // samples that are not at vertices

private:
    enum class Pass { sectors, fit, reach, count, vertices, extras, sort, measure, done };
    struct Fitted {
        OrientedSample sample;
        double spacing;  // how far samples may be apart here
    };
    // Where samples come next, beside those at vertices: along the edges 0, 1 and 2 of a triangle, then in rows across
    // it.
    struct Place {
        uint32_t stage = 0, row = 0, column = 0;
    };

    void enter(Pass pass);
    void fit_corner();
    void finish_fit();
    double spacing(uint32_t triangle) const;
    void spread_reach();
    double divide(Corner edge, uint32_t& parts) const;
    bool next_extra(OrientedSample* sample);
    bool along_edge(OrientedSample* sample);
    bool across_rows(OrientedSample* sample);
    bool between(const double* weights, double radius, OrientedSample* sample) const;
    void emit_vertex();
    bool convex(Corner edge) const;
    bool on_crease(Corner edge, double share, double radius, OrientedSample& sample) const;
    void measure();

    const Mesh& mesh_;
    Memory* memory_;
    MeshSectorsKernel sectors_;
    Buffer<Fitted> fitted_;
    Buffer<float> spacing_, longest_;  // metres, of triangles: how far samples may be apart, and the longest edge
    std::optional<QuadricFit> fit_;
    std::optional<CreaseRounding> crease_;  // of the vertex whose sectors come
    uint32_t group_ = 0;                    // its first sector
    GrowingBuffer<OrientedSample> samples_;
    std::optional<OrientedSamplesKernel> sort_;
    std::optional<OrientedSamples> surface_;
    SurfaceDeviation deviation_;
    Pass pass_ = Pass::sectors;
    uint32_t at_ = 0;
    Corner corner_ = 0;  // of the sector at_
    uint32_t corners_done_ = 0;
    Place place_;
    double coarseness_ = 1;  // of the spacing, where there would be too many samples
    uint32_t extra_count_ = 0;
    double size_ = 0, deviations_ = 0;
};

}  // namespace flg
