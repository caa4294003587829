// SPDX-License-Identifier: MIT
#include "inflation/merge_parts.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t batch = 16, blocks_a_unit = 4;
// A plane that is turned anyhow goes through 1.5 cells an area of one face, in the mean.
constexpr double cells_by_area = 1.5;
constexpr double surface_by_shape = 3;  // of a part, by the area of its contour, about
constexpr double coarser = 2;           // the lattice that the surface is measured on
// Of the radius of the thinnest part: lattice points are so near to each other that none falls between them.
constexpr double most_spacing = 0.8;
constexpr uint32_t least_vertices = 100;

}  // namespace

MergeParts::MergeParts(std::span<const PlacedPart> parts, const MergeOptions& options, MergedMesh& out, Memory* memory)
    : options_(options),
      out_(out),
      memory_(memory),
      parts_(parts, options.blend, memory),
      positions_(memory),
      triangles_(memory) {
    if (parts.empty()) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "merge: there are no parts");
    if (options_.vertices < least_vertices)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "merge: %u vertices asked for; a surface has %u or more",
                      options_.vertices, least_vertices);
}

bool MergeParts::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void MergeParts::step() {
    switch (pass_) {
        case Pass::prepare:
            if (parts_.run(1)) begin_measure();
            break;
        case Pass::measure:
            if (grid_->run(1)) {
                counted_ = std::max(grid_->vertex_count(), 1u);
                pass_ = Pass::begin;
            }
            break;
        case Pass::begin:
            if (grid_->release(blocks_a_unit)) begin_grid();
            break;
        case Pass::grid:
            if (!grid_->run(1)) break;
            extraction_.emplace(*grid_, positions_, triangles_, memory_);
            pass_ = Pass::extract;
            break;
        case Pass::extract:
            if (!extraction_->run(1)) break;
            extraction_.reset();
            pass_ = Pass::release;
            break;
        case Pass::release:
            if (!grid_->release(blocks_a_unit)) break;
            grid_.reset();
            improvement_.emplace(parts_, spacing_, positions_, triangles_, memory_);
            pass_ = Pass::improve;
            break;
        case Pass::improve:
            if (!improvement_->run(1)) break;
            out_.positions = Buffer<Vec3>(positions_.size(), memory_);
            out_.normals = Buffer<Vec3>(positions_.size(), memory_);
            out_.parts = Buffer<uint32_t>(positions_.size(), memory_);
            out_.triangles = Buffer<TriangleVertices>(triangles_.size(), memory_);
            out_.spacing = spacing_;
            pass_ = Pass::write;
            break;
        case Pass::write: write(); break;
        case Pass::done: break;
    }
}

void MergeParts::begin_measure() {
    double area = 0;
    for (const ImplicitPart& part : parts_.parts())
        area += surface_by_shape * part.part().area * part.scale() * part.scale();
    spacing_ = coarser * std::sqrt(cells_by_area * area / options_.vertices);
    grid_.emplace(parts_, spacing_, memory_);
    pass_ = Pass::measure;
}

// From how many vertices the coarse lattice gives: the spacing that gives as many as asked for, or what the thinnest part needs.
void MergeParts::begin_grid() {
    const double wanted = spacing_ * std::sqrt(counted_ / options_.vertices);
    uint32_t thinnest = 0;
    for (uint32_t i = 1; i < parts_.parts().size(); ++i)
        if (parts_.parts()[i].radius() < parts_.parts()[thinnest].radius()) thinnest = i;
    const double needed = most_spacing * parts_.parts()[thinnest].radius();
    const double vertices = counted_ * (spacing_ / needed) * (spacing_ / needed);
    if (needed < wanted && !(vertices <= options_.most_vertices))
        throw Failure(
            FLG_ERROR_LIMIT,
            "merge: part %u is so thin, %.3g, that the surface would need about %.3g vertices; the limit is %u",
            thinnest, parts_.parts()[thinnest].radius(), vertices, options_.most_vertices);
    spacing_ = std::min(wanted, needed);
    grid_.emplace(parts_, spacing_, memory_);
    pass_ = Pass::grid;
}

void MergeParts::write() {
    const auto vertices = static_cast<uint32_t>(positions_.size());
    const uint32_t all = vertices + static_cast<uint32_t>(triangles_.size());
    for (const uint32_t stop = std::min(all, at_ + batch); at_ < stop; ++at_) {
        if (at_ >= vertices) {
            out_.triangles[at_ - vertices] = triangles_[at_ - vertices];
            continue;
        }
        const PartUnion::Sample& sample = improvement_->samples()[at_];
        const double steep = sample.gradient.norm();
        std::construct_at(&out_.positions[at_], positions_[at_]);
        std::construct_at(&out_.normals[at_], steep > 0 ? Vec3(-sample.gradient / steep) : Vec3(Vec3::UnitZ()));
        out_.parts[at_] = sample.part;
    }
    if (at_ == all) {
        improvement_.reset();
        pass_ = Pass::done;
    }
}

}  // namespace flg
