// SPDX-License-Identifier: MIT
#include "splines/mesh_sectors.h"

#include <cmath>

#include "surfaces/mesh_measures_normals.h"

namespace flg {

MeshSectorsKernel::MeshSectorsKernel(const Mesh& mesh, Memory* memory)
    : mesh_(mesh),
      memory_(memory),
      face_normals_(mesh.triangle_count(), memory),
      sector_of_(size_t{3} * mesh.triangle_count(), memory) {}

bool MeshSectorsKernel::sharp(Corner edge) const {
    const uint32_t across = mesh_.neighbour_at(edge);
    if (across == no_index) return false;
    const Vec3 a = load_vec3(face_normals_[edge / 3].data()), b = load_vec3(face_normals_[across].data());
    if (a.isZero() || b.isZero()) return false;
    return a.dot(b) < sharp_cosine;
}

bool MeshSectorsKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::faces:
                store_vec3(triangle_normal(mesh_, at_), face_normals_[at_].data());
                for (const uint32_t vertex : mesh_.triangles[at_]) {
                    const Vec3 p = mesh_.position(vertex);
                    lower_ = at_ == 0 ? p : lower_.cwiseMin(p);
                    upper_ = at_ == 0 ? p : upper_.cwiseMax(p);
                }
                if (++at_ < mesh_.triangle_count()) continue;
                break;
            case Pass::edges:
                if (sharp(at_)) ++sharp_edges_;
                if (++at_ < 3 * mesh_.triangle_count()) continue;
                // A sharp edge is seen from both sides: it adds a sector at each end.
                sectors_ = GrowingBuffer<MeshSector>(size_t{mesh_.vertex_count()} + sharp_edges_, memory_);
                sectors_.resize(0);
                break;
            case Pass::sectors:
                step();
                if (at_ < mesh_.vertex_count()) continue;
                break;
            case Pass::done: break;
        }
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    return pass_ == Pass::done;
}

void MeshSectorsKernel::begin_sector() {
    sector_ = {{}, 0, corner_, 0, 0, 0, false, false};
    normals_ = Vec3::Zero();
    lengths_ = 0;
    edges_ = 0;
}

void MeshSectorsKernel::finish_sector(bool closed) {
    sector_.closed = closed;
    store_vec3(normals_.stableNormalized(), sector_.normal.data());
    sector_.mean = static_cast<float>(lengths_ / edges_);
    sectors_.push_back(sector_);
}

// Crossing the edge before the corner leads on counter-clockwise, crossing the one after it leads back.
void MeshSectorsKernel::step() {
    if (corner_ == no_index) {
        corner_ = start_ = mesh_.corner_of_vertex[at_];
        searching_ = true;
    }
    if (searching_) {
        const bool begins = mesh_.opposite(corner_) == no_index || sharp(corner_);
        const Corner next = begins ? corner_ : mesh_.turn(corner_);
        searching_ = next != corner_ && next != start_;
        corner_ = next;
        if (searching_) return;
        start_ = corner_;
        begin_sector();
        return;
    }
    collect();
    const Corner next = mesh_.turn(corner_), edge = previous_corner(corner_);
    const bool creased = sharp(edge), last = next == no_index || next == start_;
    sector_.creased = sector_.creased || creased;
    corner_ = next;
    if (last) {
        finish_sector(next == start_ && !creased);
        corner_ = no_index;
        ++at_;
    } else if (creased) {
        finish_sector(false);
        begin_sector();
    }
}

void MeshSectorsKernel::collect() {
    sector_of_[corner_] = static_cast<uint32_t>(sectors_.size());
    const Vec3 origin = mesh_.position(mesh_.vertex_at(corner_));
    const Vec3 a = mesh_.position(mesh_.vertex_at(next_corner(corner_))) - origin;
    const Vec3 b = mesh_.position(mesh_.vertex_at(previous_corner(corner_))) - origin;
    const Vec3 across = a.cross(b);
    const double size = across.norm();
    if (size > 0) normals_ += across * (std::atan2(size, a.dot(b)) / size);
    for (const double length : {a.norm(), b.norm()}) {
        const auto rounded = static_cast<float>(length);
        sector_.shortest = edges_ == 0 ? rounded : std::min(sector_.shortest, rounded);
        sector_.longest = std::max(sector_.longest, rounded);
        lengths_ += length;
        ++edges_;
    }
    if (sector_.corners++ == 0 && sharp(corner_)) sector_.creased = true;
}

}  // namespace flg
