// SPDX-License-Identifier: MIT
#include "tangles/voronoi_borders.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/random.h"
#include "tangles/passes.h"

namespace flg {

namespace {

constexpr size_t clear_step = 64;

// The distance at the apex of a triangle whose other corners, so far from it and from each other, are at distances db and
// dc from a source beyond them: unfolded, the straight line from the source, if it enters between the two.
double unfold(double db, double dc, double ab, double ac, double bc) {
    const double along_edges = std::min(db + ab, dc + ac);
    if (!(bc > 0)) return along_edges;
    // b at 0, c at bc on the first axis; the apex above it, the source below.
    const double apex_x = (ab * ab - ac * ac + bc * bc) / (2 * bc), apex_y2 = ab * ab - apex_x * apex_x;
    const double source_x = (db * db - dc * dc + bc * bc) / (2 * bc), source_y2 = db * db - source_x * source_x;
    if (apex_y2 < 0 || source_y2 < 0) return along_edges;
    const double apex_y = std::sqrt(apex_y2), source_y = std::sqrt(source_y2);
    const double height = apex_y + source_y;
    if (!(height > 0)) return along_edges;
    const double enters = source_x + (apex_x - source_x) * source_y / height;
    if (enters < 0 || enters > bc) return along_edges;
    return std::min(along_edges, std::hypot(apex_x - source_x, height));
}

}  // namespace

VoronoiBordersKernel::VoronoiBordersKernel(const Mesh& mesh, const RegionSet& regions, const DistanceField& cells,
                                           SurfaceCurves& curves, Memory* memory)
    : mesh_(mesh), cells_(cells), curves_(curves), memory_(memory), crossed_(memory), cursor_(mesh, regions) {}

void VoronoiBordersKernel::scan(uint32_t triangle) {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Buffer<uint32_t>& labels = cells_.labels;
    if (labels[a] == labels[b] && labels[b] == labels[c]) return;
    if (labels[a] == no_index || labels[b] == no_index || labels[c] == no_index) return;
    crossed_.push_back(triangle);
}

// The entry of a vertex and a label, or the empty one where it belongs.
VoronoiBordersKernel::Far& VoronoiBordersKernel::find(uint32_t vertex, uint32_t label) {
    const size_t mask = table_.size() - 1;
    size_t slot = mix64(uint64_t{vertex} << 32 | label) & mask;
    while (table_[slot].vertex != no_index && (table_[slot].vertex != vertex || table_[slot].label != label)) {
        slot = (slot + 1) & mask;
    }
    return table_[slot];
}

float VoronoiBordersKernel::distance(uint32_t vertex, uint32_t label) {
    return cells_.labels[vertex] == label ? cells_.distances[vertex] : find(vertex, label).distance;
}

void VoronoiBordersKernel::list(uint32_t triangle) {
    for (const uint32_t vertex : mesh_.triangles[triangle]) {
        for (const uint32_t other : mesh_.triangles[triangle]) {
            const uint32_t label = cells_.labels[other];
            if (label != cells_.labels[vertex]) find(vertex, label) = {vertex, label, unreachable};
        }
    }
}

void VoronoiBordersKernel::carry(uint32_t triangle) {
    const Triple& corners = mesh_.triangles[triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
        const Vec3 at = mesh_.position(a), to_b = mesh_.position(b) - at, to_c = mesh_.position(c) - at;
        for (const uint32_t label : {cells_.labels[b], cells_.labels[c]}) {
            if (label == cells_.labels[a]) continue;
            Far& far = find(a, label);
            const double found =
                unfold(distance(b, label), distance(c, label), to_b.norm(), to_c.norm(), (to_c - to_b).norm());
            far.distance = std::min(far.distance, static_cast<float>(found));
        }
    }
}

// Where along an edge two cells are equally near, from the lower vertex.
float VoronoiBordersKernel::place_on_edge(uint32_t from, uint32_t to) {
    const uint32_t here = cells_.labels[from], there = cells_.labels[to];
    const double at_from = double{distance(from, there)} - cells_.distances[from];
    const double at_to = double{distance(to, here)} - cells_.distances[to];
    const double sum = at_from + at_to;
    return round_on_edge(sum > 0 ? std::clamp(at_from / sum, 0.0, 1.0) : 0.5);
}

SurfacePoint VoronoiBordersKernel::crossing(Corner edge) {
    const uint32_t from = mesh_.vertex_at(edge), to = mesh_.vertex_at(next_corner(edge));
    return point_on_edge(edge, from < to ? place_on_edge(from, to) : 1 - place_on_edge(to, from));
}

void VoronoiBordersKernel::add_segment(const SurfacePoint& a, const SurfacePoint& b) {
    curves_.points.push_back(a);
    curves_.points.push_back(b);
    curves_.offsets.push_back(static_cast<uint32_t>(curves_.points.size()));
    curves_.closed.push_back(false);
    curves_.values.push_back(0);
}

void VoronoiBordersKernel::trace(uint32_t triangle) {
    const Triple& corners = mesh_.triangles[triangle];
    const std::array<uint32_t, 3> labels = {cells_.labels[corners[0]], cells_.labels[corners[1]],
                                            cells_.labels[corners[2]]};
    for (uint32_t k = 0; k < 3; ++k) {
        // Corner k of its own: the border crosses the edges that meet there.
        if (labels[(k + 1) % 3] != labels[(k + 2) % 3]) continue;
        return add_segment(crossing(3 * triangle + k), crossing(3 * triangle + (k + 2) % 3));
    }
    std::array<SurfacePoint, 3> ends;
    for (uint32_t k = 0; k < 3; ++k) ends[k] = crossing(3 * triangle + k);
    // Where three cells are equally near: linear as distances are, weights with sum w_i (d_0 - d_g)(i) = 0 for both g.
    std::array<std::array<double, 3>, 2> nearer;
    for (uint32_t i = 0; i < 3; ++i) {
        const double first = distance(corners[i], labels[0]);
        nearer[0][i] = first - distance(corners[i], labels[1]);
        nearer[1][i] = first - distance(corners[i], labels[2]);
    }
    std::array<double, 3> weights;
    double sum = 0;
    for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t j = (i + 1) % 3, k = (i + 2) % 3;
        weights[i] = nearer[0][j] * nearer[1][k] - nearer[0][k] * nearer[1][j];
        sum += weights[i];
    }
    SurfacePoint middle{triangle, (ends[0].u + ends[1].u + ends[2].u) / 3, (ends[0].v + ends[1].v + ends[2].v) / 3};
    constexpr double least = 0.02;  // nearer to an edge the middle of the crossings does better
    if (std::min({weights[0] / sum, weights[1] / sum, weights[2] / sum}) > least) {
        middle = {triangle, static_cast<float>(weights[1] / sum), static_cast<float>(weights[2] / sum)};
    }
    for (const SurfacePoint& end : ends) add_segment(middle, end);
}

// A unit; false at the end of a pass.
bool VoronoiBordersKernel::step() {
    const size_t end = crossed_.size();
    switch (pass_) {
        case Pass::scan: cursor_.next_64([this](uint32_t triangle) { scan(triangle); }); return !cursor_.at_end();
        case Pass::size:
            // At most 6 entries a triangle, each shared by two triangles or more but at borders.
            table_ = Buffer<Far>(std::bit_ceil(12 * crossed_.size() + 1), memory_);
            return false;
        case Pass::clear:
            for (const size_t stop = std::min(table_.size(), at_ + clear_step); at_ < stop; ++at_) {
                table_[at_].vertex = no_index;
            }
            return at_ < table_.size();
        case Pass::list:
            if (at_ < end) list(crossed_[at_++]);
            return at_ < end;
        case Pass::carry:
        case Pass::carry_again:
        case Pass::carry_on:
            if (at_ < end) carry(crossed_[at_++]);
            return at_ < end;
        case Pass::trace:
            if (at_ < end) trace(crossed_[at_++]);
            return at_ < end;
        case Pass::done: break;
    }
    return false;
}

bool VoronoiBordersKernel::run(uint32_t count) {
    return run_passes(count, pass_, at_, [this] { return step(); });
}

}  // namespace flg
