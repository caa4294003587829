// SPDX-License-Identifier: MIT
#include "splines/mesh_distance.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double clearly_less = 1 - 1e-6;  // triangles that share the nearest point do not take turns
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double band = 1.5;  // cells around a triangle that get its distance at once
constexpr double border = 3;  // cells beyond the reach, where the spline's ends are felt
constexpr uint32_t splat_batch = 16, sweep_batch = 8, polish_batch = 2, batch = 64;
constexpr uint32_t polish_steps = 16;
constexpr uint32_t most_sweeps = 255;   // more than any mesh needs: a path of nearest triangles turns a few times
constexpr double longest_hop = 1.7321;  // of the spacing, to a neighbour

// Ericson: Real-time collision detection (2005), sec. 5.1.5, by Voronoi regions.
double square_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return ap.squaredNorm();
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return bp.squaredNorm();
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).squaredNorm();
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return cp.squaredNorm();
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).squaredNorm();
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b)).squaredNorm();
    }
    const double sum = va + vb + vc;
    return (ap - vb / sum * ab - vc / sum * ac).squaredNorm();
}

// How often the edge from a to b turns around p counter-clockwise, seen along an axis: 1, -1 or 0, by whether it passes
// the ray from p in direction u. The same bits for the edge from b to a but for the sign.
int winding_of_edge(double pu, double pv, double au, double av, double bu, double bv) {
    if ((av <= pv) == (bv <= pv)) return 0;
    const bool up = av <= pv;
    if (!up) {
        std::swap(au, bu);
        std::swap(av, bv);
    }
    const double side = (bu - au) * (pv - av) - (pu - au) * (bv - av);
    return side > 0 ? (up ? 1 : -1) : 0;
}

}  // namespace

MeshDistanceKernel::MeshDistanceKernel(const Mesh& mesh, double reach, uint32_t cells, bool has_sign,
                                       SampledDistance& out, Memory* memory)
    : mesh_(mesh), reach_(reach), cells_(cells), has_sign_(has_sign), out_(out), memory_(memory) {
    if (!(reach > 0) || !std::isfinite(reach)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "the reach of a mesh's distance is %g, it must be finite and positive", reach);
    }
    if (cells < least_cells || cells > most_cells) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "a mesh's distance has %u cells along its side, there must be %u to %u", cells, least_cells,
                      most_cells);
    }
    if (mesh.triangle_count() == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the mesh has no triangles");
}

bool MeshDistanceKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::box: measure(); break;
            case Pass::clear: clear(); break;
            case Pass::splat: splat(); break;
            case Pass::sweep: sweep(); break;
            case Pass::polish: polish(); break;
            case Pass::cross: cross(); break;
            case Pass::count: count_line(); break;
            case Pass::sign: sign(); break;
            case Pass::filter: filter(); break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

void MeshDistanceKernel::enter(Pass pass) {
    pass_ = pass;
    at_ = axis_ = 0;
    in_triangle_ = false;
}

void MeshDistanceKernel::measure() {
    for (uint32_t k = 0; k < batch && at_ < mesh_.vertex_count(); ++k, ++at_) {
        const Vec3 x = mesh_.position(at_);
        for (uint32_t i = 0; i < 3; ++i) {
            double &lower = out_.box.lower[i], &upper = out_.box.upper[i];
            const double v = x[static_cast<int>(i)];
            lower = at_ == 0 ? v : std::min(lower, v);
            upper = at_ == 0 ? v : std::max(upper, v);
        }
    }
    if (at_ == mesh_.vertex_count()) choose_grid();
}

void MeshDistanceKernel::choose_grid() {
    double longest = 0;
    for (uint32_t k = 0; k < 3; ++k) longest = std::max(longest, out_.box.upper[k] - out_.box.lower[k]);
    SweepGrid& grid = out_.grid;
    grid.dimension = 3;
    grid.spacing = (longest + 2 * reach_) / cells_;
    const double around = reach_ + border * grid.spacing;
    for (uint32_t k = 0; k < 3; ++k) {
        const double side = out_.box.upper[k] - out_.box.lower[k] + 2 * around;
        grid.counts[k] = static_cast<uint32_t>(std::ceil(side / grid.spacing - 1e-6)) + 1;
        const double middle = 0.5 * (out_.box.lower[k] + out_.box.upper[k]);
        grid.origin[k] = middle - 0.5 * grid.spacing * (grid.counts[k] - 1);
    }
    out_.reach = reach_;
    out_.shift = has_sign_ ? 0 : std::max(0.5 * reach_, grid.spacing);
    out_.deepest = 0;
    values_ = Buffer<float>(grid.size(), memory_);
    nearest_ = Buffer<uint32_t>(grid.size(), memory_);
    changed_ = Buffer<uint8_t>(grid.size(), memory_);
    for (Buffer<int16_t>& winding : windings_) winding = Buffer<int16_t>(has_sign_ ? grid.size() : 0, memory_);
    enter(Pass::clear);
}

void MeshDistanceKernel::clear() {
    for (uint32_t k = 0; k < batch && at_ < out_.grid.size(); ++k, ++at_) {
        values_[at_] = std::numeric_limits<float>::infinity();
        nearest_[at_] = no_index;
        changed_[at_] = 0;
        for (Buffer<int16_t>& winding : windings_) {
            if (has_sign_) winding[at_] = 0;
        }
    }
    if (at_ == out_.grid.size()) enter(Pass::splat);
}

// Of cell_.
Vec3 MeshDistanceKernel::place() const {
    const SweepGrid& grid = out_.grid;
    return {grid.origin[0] + grid.spacing * cell_[0], grid.origin[1] + grid.spacing * cell_[1],
            grid.origin[2] + grid.spacing * cell_[2]};
}

// Takes the triangle if it is nearer than the node's, and than `most`.
bool MeshDistanceKernel::try_triangle(uint32_t node, uint32_t triangle, const Vec3& x, double most) {
    const Triple& t = mesh_.triangles[triangle];
    const double away = std::sqrt(square_distance(x, mesh_.position(t[0]), mesh_.position(t[1]), mesh_.position(t[2])));
    if (!(away < clearly_less * double(values_[node])) || away > most) return false;
    values_[node] = static_cast<float>(away);
    nearest_[node] = triangle;
    return true;
}

// The nodes in the box of triangle at_, made wider by so many cells; false if there are none.
bool MeshDistanceKernel::begin_triangle(double wider) {
    const Triple& t = mesh_.triangles[at_];
    const SweepGrid& grid = out_.grid;
    for (uint32_t k = 0; k < 3; ++k) {
        const int i = static_cast<int>(k);
        const double a = mesh_.position(t[0])[i], b = mesh_.position(t[1])[i], c = mesh_.position(t[2])[i];
        const double low = std::ceil((std::min({a, b, c}) - grid.origin[k]) / grid.spacing - wider);
        const double high = std::floor((std::max({a, b, c}) - grid.origin[k]) / grid.spacing + wider);
        if (low > high) return false;
        first_[k] = static_cast<uint32_t>(std::clamp(low, 0.0, grid.counts[k] - 1.0));
        last_[k] = static_cast<uint32_t>(std::clamp(high, 0.0, grid.counts[k] - 1.0));
    }
    cell_ = first_;
    return true;
}

void MeshDistanceKernel::splat() {
    if (!in_triangle_) {
        if (at_ == mesh_.triangle_count()) {
            enter(Pass::sweep);
            sweep_ = last_change_ = 8;
            cell_ = {};
            return;
        }
        in_triangle_ = begin_triangle(band);
        if (!in_triangle_) ++at_;
        return;
    }
    const SweepGrid& grid = out_.grid;
    for (uint32_t k = 0; k < splat_batch && in_triangle_; ++k) {
        const uint32_t node = grid.node(cell_);
        if (try_triangle(node, at_, place(), band * grid.spacing)) changed_[node] = 7;
        if (++cell_[0] <= last_[0]) continue;
        cell_[0] = first_[0];
        if (++cell_[1] <= last_[1]) continue;
        cell_[1] = first_[1];
        if (++cell_[2] > last_[2]) in_triangle_ = false;
    }
    if (!in_triangle_) ++at_;
}

// A node tries the triangles of the seven neighbours that the sweep has passed: those that are new within eight sweeps,
// in which it comes past each neighbour, and that may be nearer, as they are as near to the neighbour.
void MeshDistanceKernel::sweep() {
    const SweepGrid& grid = out_.grid;
    const auto backwards = [&](uint32_t axis) { return (sweep_ >> axis & 1) != 0; };
    for (uint32_t k = 0; k < sweep_batch && at_ < grid.size(); ++k, ++at_) {
        const uint32_t node = grid.node(cell_);
        for (uint32_t subset = 1; subset < 8; ++subset) {
            std::array<uint32_t, 3> from = cell_;
            bool inside = true;
            for (uint32_t axis = 0; axis < 3; ++axis) {
                if ((subset >> axis & 1) == 0) continue;
                from[axis] += backwards(axis) ? 1u : -1u;
                inside = inside && from[axis] < grid.counts[axis];
            }
            if (!inside) continue;
            const uint32_t other = grid.node(from);
            if (changed_[other] + 8u < sweep_ || nearest_[other] == no_index || nearest_[other] == nearest_[node])
                continue;
            if (values_[other] - values_[node] > longest_hop * grid.spacing) continue;
            if (!try_triangle(node, nearest_[other], place(), infinite)) continue;
            changed_[node] = static_cast<uint8_t>(sweep_);
            last_change_ = sweep_;
        }
        for (uint32_t axis = 0; axis < 3; ++axis) {
            if (cell_[axis] != (backwards(axis) ? 0 : grid.counts[axis] - 1)) {
                cell_[axis] += backwards(axis) ? -1u : 1u;
                break;
            }
            cell_[axis] = backwards(axis) ? grid.counts[axis] - 1 : 0;
        }
    }
    if (at_ < grid.size()) return;
    at_ = 0;
    ++sweep_;
    for (uint32_t axis = 0; axis < 3; ++axis) cell_[axis] = backwards(axis) ? grid.counts[axis] - 1 : 0;
    if (sweep_ > last_change_ + 8 || sweep_ == most_sweeps) enter(Pass::polish);
}

// From the triangle to those across its edges and on, as long as they are nearer.
void MeshDistanceKernel::polish() {
    for (uint32_t k = 0; k < polish_batch && at_ < out_.grid.size(); ++k, ++at_) {
        const Obstacle::Place place = out_.grid.place(at_);
        const Vec3 x(place[0], place[1], place[2]);
        for (uint32_t from = no_index, step = 0; from != nearest_[at_] && step < polish_steps; ++step) {
            from = nearest_[at_];
            for (const uint32_t side : mesh_.neighbours[from]) {
                if (side == no_index) continue;
                for (const uint32_t triangle :
                     {side, mesh_.neighbours[side][0], mesh_.neighbours[side][1], mesh_.neighbours[side][2]}) {
                    if (triangle == no_index || triangle == from) continue;
                    try_triangle(at_, triangle, x, infinite);
                }
            }
        }
    }
    if (at_ == out_.grid.size()) enter(has_sign_ ? Pass::cross : Pass::sign);
}

// Triangle at_ seen along axis_: for each line of nodes that crosses it, the first node behind it gets its sense.
void MeshDistanceKernel::cross() {
    const SweepGrid& grid = out_.grid;
    const uint32_t u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    if (!in_triangle_) {
        if (at_ == mesh_.triangle_count()) {
            at_ = 0;
            if (++axis_ == 3) enter(Pass::count);
            return;
        }
        in_triangle_ = begin_triangle(1);
        if (!in_triangle_) ++at_;
        return;
    }
    Vec3 p[3];
    for (uint32_t k = 0; k < 3; ++k) p[k] = mesh_.position(mesh_.triangles[at_][k]);
    const int iu = static_cast<int>(u), iv = static_cast<int>(v), ia = static_cast<int>(axis_);
    for (uint32_t k = 0; k < batch && in_triangle_; ++k) {
        const double pu = grid.origin[u] + grid.spacing * cell_[u], pv = grid.origin[v] + grid.spacing * cell_[v];
        int turns = 0;
        for (uint32_t e = 0; e < 3; ++e) {
            const Vec3 &a = p[e], &b = p[(e + 1) % 3];
            turns += winding_of_edge(pu, pv, a[iu], a[iv], b[iu], b[iv]);
        }
        if (turns != 0) {
            const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
            double at = p[0][ia];
            if (normal[ia] != 0) at -= (normal[iu] * (pu - p[0][iu]) + normal[iv] * (pv - p[0][iv])) / normal[ia];
            at = std::clamp(at, std::min({p[0][ia], p[1][ia], p[2][ia]}), std::max({p[0][ia], p[1][ia], p[2][ia]}));
            std::array<uint32_t, 3> cell = cell_;
            cell[axis_] = static_cast<uint32_t>(std::floor((at - grid.origin[axis_]) / grid.spacing)) + 1;
            windings_[axis_][grid.node(cell)] = static_cast<int16_t>(windings_[axis_][grid.node(cell)] - turns);
        }
        if (++cell_[u] <= last_[u]) continue;
        cell_[u] = first_[u];
        if (++cell_[v] > last_[v]) in_triangle_ = false;
    }
    if (!in_triangle_) ++at_;
}

// The first node of line at_ along axis_.
uint32_t MeshDistanceKernel::line_start() const {
    const std::array<uint32_t, 3>& n = out_.grid.counts;
    if (axis_ == 0) return at_ * n[0];
    if (axis_ == 1) return at_ / n[0] * n[0] * n[1] + at_ % n[0];
    return at_;
}

void MeshDistanceKernel::count_line() {
    int16_t* line = windings_[axis_].data() + line_start();
    const uint32_t stride = out_.grid.stride(axis_);
    for (uint32_t k = 1; k < out_.grid.counts[axis_]; ++k) {
        line[k * stride] = static_cast<int16_t>(line[k * stride] + line[(k - 1) * stride]);
    }
    if (++at_ < line_count()) return;
    at_ = 0;
    if (++axis_ == 3) enter(Pass::sign);
}

// A distance without sign gets values of both signs: it is less than the shift next to the mesh and more at the grid's
// sides.
void MeshDistanceKernel::sign() {
    for (uint32_t k = 0; k < batch && at_ < out_.grid.size(); ++k, ++at_) {
        int votes = 0;
        for (const Buffer<int16_t>& winding : windings_) votes += has_sign_ && winding[at_] != 0;
        const double away = values_[at_];
        values_[at_] = static_cast<float>((votes >= 2 ? -away : away) - out_.shift);
        out_.deepest = std::max(out_.deepest, votes >= 2 ? away : 0.0);
    }
    if (at_ < out_.grid.size()) return;
    if (has_sign_ && !(out_.deepest > 0)) {
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT,
            "a mesh that is to be a solid holds no node of a grid with a spacing of %g: it is open or too thin",
            out_.grid.spacing);
    }
    enter(Pass::filter);
    const SweepGrid& grid = out_.grid;
    filter_.emplace(GridInput{grid.counts, grid.origin, grid.spacing, values_.data()}, memory_);
}

void MeshDistanceKernel::filter() {
    if (!filter_->run(8)) return;
    out_.spline.emplace(filter_->take());
    pass_ = Pass::done;
}

}  // namespace flg
