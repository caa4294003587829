// SPDX-License-Identifier: MIT
#include "surfaces/cut_isolines.h"

#include <cmath>

#include "core/failure.h"
#include "surfaces/cut_vertices.h"

namespace flg {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

}  // namespace

IsolineCutter::IsolineCutter(Mesh& mesh, MeshColumns& columns, uint32_t field, const CutLevels& levels, MeshEdit& edit,
                             Memory* memory)
    : mesh_(mesh),
      columns_(columns),
      field_(columns[field].values),
      field_column_(field),
      levels_(levels),
      edit_(edit),
      memory_(memory),
      crossed_(mesh.triangle_count(), memory),
      snaps_(memory),
      writer_(mesh, edit, slots_),
      strip_(memory),
      pieces_(memory),
      low_(-infinite),
      high_(levels.count() == 0 ? infinite : levels[0]),
      vertices_(mesh.vertex_count()),
      triangles_(mesh.triangle_count()) {
    edit.begin(mesh);
}

// Of 64 triangles labels those of the regions that no level touches, marks the others.
void IsolineCutter::scan(uint32_t word) {
    const uint32_t first = 64 * word, end = std::min(first + 64, mesh_.triangle_count());
    uint32_t others = 0;  // labels
    for (uint32_t triangle = first; triangle < end; ++triangle) others |= mesh_.regions[triangle] ^ region_;
    if (others == 0 && listed_ == nullptr) return;
    for (uint32_t triangle = first; triangle < end; ++triangle) {
        const uint32_t region = mesh_.regions[triangle];
        if (region != region_) {
            region_ = region;
            listed_ = levels_.find(region);
        }
        if (listed_ == nullptr) continue;
        const Triple& vertices = mesh_.triangles[triangle];
        const float a = value(vertices[0]), b = value(vertices[1]), c = value(vertices[2]);
        const bool inside = (a > low_) & (a < high_) & (b > low_) & (b < high_) & (c > low_) & (c < high_);
        if (!inside && scan_doubtful(triangle)) {
            insert_crossed(triangle);
        } else {
            edit_.set_region(mesh_, triangle, listed_->label_above(interval_));
        }
    }
}

// With those across its split edges, whatever their region: they stay joined to it.
void IsolineCutter::insert_crossed(uint32_t triangle) {
    crossed_.insert(triangle);
    const Triple& vertices = mesh_.triangles[triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t beside = mesh_.neighbours[triangle][k];
        if (beside == no_index) continue;
        if (levels_.between(value(vertices[k]), value(vertices[(k + 1) % 3])).count > 0) crossed_.insert(beside);
    }
}

// True if a level passes; otherwise the triangle's interval is the current one from now on.
bool IsolineCutter::scan_doubtful(uint32_t triangle) {
    float low = infinite, high = -infinite;
    bool finite = true;
    for (uint32_t vertex : mesh_.triangles[triangle]) {
        const float at = value(vertex);
        if (!std::isfinite(at)) {
            finite = false;
            continue;
        }
        low = std::min(low, at);
        high = std::max(high, at);
    }
    if (low <= high && levels_.below(low) != levels_.up_to(high)) return true;
    interval_ = finite ? levels_.up_to(low) : levels_.count();
    low_ = interval_ == 0 ? -infinite : levels_[interval_ - 1];
    high_ = interval_ == levels_.count() ? infinite : levels_[interval_];
    return false;
}

void IsolineCutter::collect(uint32_t word) {
    for (uint64_t bits = crossed_.bits(word); bits != 0; bits &= bits - 1) {
        slots_[filled_++].triangle = 64 * word + static_cast<uint32_t>(std::countr_zero(bits));
    }
}

bool IsolineCutter::may_cut(uint32_t triangle) const {
    for (uint32_t vertex : mesh_.triangles[triangle]) {
        if (!std::isfinite(value(vertex))) return false;
    }
    return levels_.find(mesh_.regions[triangle]) != nullptr;
}

void IsolineCutter::find_snaps(uint32_t triangle) {
    if (!may_cut(triangle)) return;
    const Triple& vertices = mesh_.triangles[triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        const float at = value(vertices[k]);
        const uint32_t above = levels_.up_to(at);
        const double up = above < levels_.count() ? double{levels_[above]} - at : infinite;
        const double down = above > 0 ? double{at} - levels_[above - 1] : infinite;
        if (down == 0) continue;
        const double steepest = std::max(std::abs(double{value(vertices[(k + 1) % 3])} - at),
                                         std::abs(double{value(vertices[(k + 2) % 3])} - at));
        if (std::min(up, down) > cut_tolerance * steepest) continue;
        snaps_.push_back({vertices[k], down <= up ? levels_[above - 1] : levels_[above]});
    }
}

// Gives new points and pieces their places. A split edge is numbered by its owner; points rise with the field.
void IsolineCutter::number(uint32_t slot) {
    CutTriangle& cut = slots_[slot];
    const bool cuts = may_cut(cut.triangle);
    uint32_t points = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        CutTriangle::Edge& edge = cut.edges[k];
        edge = {0, 0, no_index, no_index};
        const Corner corner = 3 * cut.triangle + k, across = mesh_.opposite(corner);
        const uint32_t other = across == no_index ? no_index : crossed_.slot_of(triangle_of(across));
        if (other < slot) {
            edge = slots_[other].edges[across % 3];
            edge.twin = 3 * other + across % 3;
        } else if (cuts || (other != no_index && may_cut(triangle_of(across)))) {
            const float a = value(mesh_.vertex_at(corner)), b = value(mesh_.vertex_at(next_corner(corner)));
            edge.points = levels_.between(a, b).count;
            edge.first_vertex = static_cast<uint32_t>(vertices_);
            vertices_ += edge.points;
        }
        points += edge.points;
    }
    cut.first_added = static_cast<uint32_t>(triangles_);
    triangles_ += points;
    if (vertices_ >= no_index || triangles_ > no_index / 3) {
        throw Failure(FLG_ERROR_LIMIT, "the mesh would have more than 2^32 corners after a cut at %u levels",
                      levels_.count());
    }
}

void IsolineCutter::place(const CutTriangle& slot) {
    for (uint32_t k = 0; k < 3; ++k) {
        const CutTriangle::Edge& edge = slot.edges[k];
        if (edge.points == 0 || edge.twin != no_index) continue;
        uint32_t a = mesh_.triangles[slot.triangle][k], b = mesh_.triangles[slot.triangle][(k + 1) % 3];
        if (value(a) > value(b)) std::swap(a, b);
        const uint32_t first = levels_.between(value(a), value(b)).first;
        for (uint32_t i = 0; i < edge.points; ++i) {
            const uint32_t vertex = edge.first_vertex + i;
            const float level = levels_[first + i];
            const double t = (double{level} - value(a)) / (double{value(b)} - value(a));
            place_vertex(mesh_, columns_, vertex, {a, b, b}, {1 - t, t, 0});
            field_[vertex] = level;
        }
    }
}

uint32_t IsolineCutter::size_of(Pass pass) const {
    switch (pass) {
        case Pass::clear:
        case Pass::scan:
        case Pass::sum:
        case Pass::collect: return crossed_.word_count();
        case Pass::move: return static_cast<uint32_t>(snaps_.size());
        default: return static_cast<uint32_t>(slots_.size());
    }
}

void IsolineCutter::enter(Pass pass) {
    pass_ = pass;
    at_ = 0;
    const auto vertices = static_cast<uint32_t>(vertices_), triangles = static_cast<uint32_t>(triangles_);
    if (pass == Pass::collect) slots_ = Buffer<CutTriangle>(crossed_.size(), memory_);
    if (pass == Pass::grow) growth_.emplace(mesh_, columns_, vertices, triangles);
    if (pass == Pass::place) resize_mesh(mesh_, columns_, vertices, triangles);
    if (pass == Pass::done) edit_.end(mesh_);
}

bool IsolineCutter::run(uint32_t count) {
    while (count > 0 && pass_ != Pass::done) {
        if (pass_ == Pass::grow) {
            // Copying is quick: a unit moves many elements.
            if (growth_->run(64 * count)) enter(Pass::place);
            break;
        }
        const uint32_t end = static_cast<uint32_t>(std::min<uint64_t>(size_of(pass_), uint64_t{at_} + count));
        count -= end - at_;
        for (; at_ < end; ++at_) {
            switch (pass_) {
                case Pass::clear: crossed_.clear_word(at_); break;
                case Pass::scan: scan(at_); break;
                case Pass::sum: crossed_.sum_word(at_); break;
                case Pass::collect: collect(at_); break;
                case Pass::snap: find_snaps(slots_[at_].triangle); break;
                case Pass::move:
                    if (value(snaps_[at_].vertex) != snaps_[at_].level) {
                        edit_.set_value(columns_, field_column_, snaps_[at_].vertex, snaps_[at_].level);
                    }
                    break;
                case Pass::number: number(at_); break;
                case Pass::place: place(slots_[at_]); break;
                case Pass::split: split(slots_[at_]); break;
                case Pass::grow:
                case Pass::done: break;
            }
        }
        if (at_ == size_of(pass_)) enter(static_cast<Pass>(static_cast<int>(pass_) + 1));
    }
    return pass_ == Pass::done;
}

}  // namespace flg
