// SPDX-License-Identifier: MIT
#include "surfaces/mesh_refine_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg {

namespace {

// Of each neighbour of an inner vertex of so many: Loop, 1987.
double loop_weight(uint32_t valence) {
    const double root = 3.0 / 8 + std::cos(2 * std::numbers::pi / valence) / 4;
    return (5.0 / 8 - root * root) / valence;
}

}  // namespace

RefineValuesKernel::RefineValuesKernel(const Mesh& coarse, const MeshColumns& columns, RefineRule rule, Mesh& fine,
                                       MeshColumns& fine_columns, Memory* memory)
    : coarse_(coarse), rule_(rule), fine_(fine), channels_(memory), sums_(memory) {
    channels_.push_back({3, coarse.positions.data()->data(), fine.positions.data()->data()});
    size_t components = 3;
    fine_columns.reserve(columns.size());
    for (const MeshColumn& column : columns) {
        fine_columns.push_back(
            {column.components, GrowingBuffer<float>(column.components * fine.positions.size(), memory)});
        channels_.push_back({column.components, column.values.data(), fine_columns.back().values.data()});
        components += column.components;
    }
    sums_.resize(components);
}

void RefineValuesKernel::clear() {
    std::fill(sums_.begin(), sums_.end(), 0.0);
}

void RefineValuesKernel::add(uint32_t vertex, double weight) {
    double* sum = sums_.data();
    for (const Channel& channel : channels_) {
        const float* values = channel.in + size_t{channel.components} * vertex;
        for (uint32_t k = 0; k < channel.components; ++k) *sum++ += weight * double{values[k]};
    }
}

void RefineValuesKernel::store(uint32_t vertex) {
    const double* sum = sums_.data();
    for (const Channel& channel : channels_) {
        float* values = channel.out + size_t{channel.components} * vertex;
        for (uint32_t k = 0; k < channel.components; ++k) values[k] = static_cast<float>(*sum++);
    }
}

void RefineValuesKernel::place_edge(Corner corner) {
    const Corner other = coarse_.opposite(corner);
    const double end_weight = rule_ == RefineRule::loop && other != no_index ? 3.0 / 8 : 1.0 / 2;
    clear();
    add(coarse_.vertex_at(corner), end_weight);
    add(coarse_.vertex_at(next_corner(corner)), end_weight);
    if (end_weight != 1.0 / 2) {
        add(coarse_.vertex_at(previous_corner(corner)), 1.0 / 8);
        add(coarse_.vertex_at(previous_corner(other)), 1.0 / 8);
    }
    store(fine_.triangles[4 * triangle_of(corner) + 3][corner % 3]);
}

void RefineValuesKernel::keep_vertex() {
    clear();
    add(vertex_, 1);
    store(vertex_++);
}

// One corner of the vertex's fan: its neighbours are summed up.
void RefineValuesKernel::step_vertex() {
    const Corner first = coarse_.corner_of_vertex[vertex_];
    if (corner_ == no_index) {
        clear();
        valence_ = 0;
        corner_ = first;
    }
    add(coarse_.vertex_at(next_corner(corner_)), 1);
    ++valence_;
    const Corner next = coarse_.turn(corner_);
    if (next == first || next == no_index) {
        end_vertex(corner_);
    } else {
        corner_ = next;
    }
}

void RefineValuesKernel::end_vertex(Corner last) {
    double own_weight;
    if (coarse_.turn(last) == no_index) {
        // At a border only the neighbours along it count.
        clear();
        add(coarse_.vertex_at(next_corner(coarse_.corner_of_vertex[vertex_])), 1.0 / 8);
        add(coarse_.vertex_at(previous_corner(last)), 1.0 / 8);
        own_weight = 3.0 / 4;
    } else {
        const double weight = loop_weight(valence_);
        for (double& sum : sums_) sum *= weight;
        own_weight = 1 - weight * valence_;
    }
    add(vertex_, own_weight);
    store(vertex_++);
    corner_ = no_index;
}

bool RefineValuesKernel::run(uint32_t count) {
    for (; vertex_ < coarse_.vertex_count(); --count) {
        if (count == 0) return false;
        if (rule_ == RefineRule::loop) {
            step_vertex();
        } else {
            keep_vertex();
        }
    }
    for (; edge_ < 3 * coarse_.triangle_count(); ++edge_, --count) {
        if (count == 0) return false;
        if (is_edge_owner(coarse_, edge_)) place_edge(edge_);
    }
    return true;
}

}  // namespace flg
