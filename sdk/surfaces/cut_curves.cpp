// SPDX-License-Identifier: MIT
#include "surfaces/cut_curves.h"

#include <algorithm>

#include "core/failure.h"
#include "surfaces/cut_vertices.h"

namespace flg {

namespace {

constexpr int32_t tolerance = CutTriangulation::tolerance;
constexpr double unit = 1.0 / CutTriangulation::scale;

uint32_t border_points(const CutTriangle& cut) {
    return cut.edges[0].points + cut.edges[1].points + cut.edges[2].points;
}

}  // namespace

CurveCutter::CurveCutter(Mesh& mesh, MeshColumns& columns, const SurfaceCurves& curves, MeshEdit& edit,
                         EmbeddedCurves& out, Memory* memory)
    : mesh_(mesh),
      columns_(columns),
      curves_(curves),
      edit_(edit),
      out_(out),
      memory_(memory),
      touched_(mesh.triangle_count(), memory),
      places_(curves.points.size(), memory),
      next_(curves.points.size(), memory),
      next_stretch_(curves.points.size(), memory),
      ways_(curves.points.size(), memory),
      along_(memory),
      inner_(memory),
      pieces_(memory),
      way_vertices_(memory),
      writer_(mesh, edit, slots_),
      triangulation_(memory),
      writing_(memory),
      sorted_(memory),
      paths_(memory),
      vertices_(mesh.vertex_count()),
      triangles_(mesh.triangle_count()) {
    edit.begin(mesh);
}

// The point that the stretch which begins at `point` leads to; no_index for the last of an open curve. Points are asked
// for in rising order.
uint32_t CurveCutter::end_of_stretch(uint32_t point) {
    while (curves_.offsets[curve_ + 1] <= point) ++curve_;
    if (point + 1 < curves_.offsets[curve_ + 1]) return point + 1;
    return curves_.closed[curve_] ? curves_.offsets[curve_] : no_index;
}

void CurveCutter::mark(uint32_t point) {
    const SurfacePoint& given = curves_.points[point];
    constexpr float slack = 1e-6f;
    const bool inside = given.u >= -slack && given.v >= -slack && given.u + given.v <= 1 + slack;
    if (given.triangle >= mesh_.triangle_count() || !inside) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "point %u of the curves is at (%g, %g) of triangle %u of %u", point,
                      double{given.u}, double{given.v}, given.triangle, mesh_.triangle_count());
    }
    const CutPlace place = places_[point] = place_of(mesh_, given);
    touched_.insert(given.triangle);
    if (place.kind != CutPlace::Kind::edge) return;
    touched_.insert(triangle_of(place.where));
    const uint32_t across = mesh_.neighbour_at(place.where);
    if (across != no_index) touched_.insert(across);
}

void CurveCutter::collect(uint32_t word) {
    for (uint64_t bits = touched_.bits(word); bits != 0; bits &= bits - 1) {
        slots_[filled_].triangle = 64 * word + static_cast<uint32_t>(std::countr_zero(bits));
        works_[filled_++] = {};
    }
}

void CurveCutter::gather(uint32_t point) {
    const CutPlace& place = places_[point];
    if (place.kind == CutPlace::Kind::edge) {
        uint32_t& head = works_[touched_.slot_of(triangle_of(place.where))].edge_points[place.where % 3];
        next_[point] = std::exchange(head, point);
    }
    const uint32_t end = end_of_stretch(point), triangle = curves_.points[point].triangle;
    if (end == no_index) return;
    if (corner_in(mesh_, places_[end], triangle) == no_index) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "curve %u leads from point %u through triangle %u, but point %u is not in that triangle", curve_,
                      point, triangle, end);
    }
    uint32_t& head = works_[touched_.slot_of(triangle)].first_stretch;
    next_stretch_[point] = std::exchange(head, point);
}

// Gives the points of an edge their vertices, in the order along the edge; those close together share one.
void CurveCutter::number_edge(uint32_t first_point, CutTriangle::Edge& edge) {
    sorted_.clear();
    for (uint32_t point = first_point; point != no_index; point = next_[point]) sorted_.push_back(point);
    std::sort(sorted_.begin(), sorted_.end(), [&](uint32_t a, uint32_t b) {
        return places_[a].point.x != places_[b].point.x ? places_[a].point.x < places_[b].point.x : a < b;
    });
    edge.first_vertex = static_cast<uint32_t>(vertices_);
    for (uint32_t point : sorted_) {
        if (edge.points == 0 || places_[point].point.x - along_.back() > tolerance) {
            along_.push_back(places_[point].point.x);
            ++edge.points;
            ++vertices_;
        }
        places_[point].vertex = static_cast<uint32_t>(vertices_ - 1);
    }
}

void CurveCutter::number(uint32_t slot) {
    CutTriangle& cut = slots_[slot];
    for (uint32_t k = 0; k < 3; ++k) {
        CutTriangle::Edge& edge = cut.edges[k];
        edge = {0, 0, no_index, no_index};
        const Corner across = mesh_.opposite(3 * cut.triangle + k);
        const uint32_t other = across == no_index ? no_index : touched_.slot_of(triangle_of(across));
        if (other < slot) {
            edge = slots_[other].edges[across % 3];
            edge.twin = 3 * other + across % 3;
        } else {
            number_edge(works_[slot].edge_points[k], edge);
        }
    }
}

void CurveCutter::place(uint32_t slot) {
    const CutTriangle& cut = slots_[slot];
    const Work& work = works_[slot];
    const Triple& corners = mesh_.triangles[cut.triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        const CutTriangle::Edge& edge = cut.edges[k];
        if (edge.twin != no_index) continue;
        for (uint32_t i = 0; i < edge.points; ++i) {
            const uint32_t vertex = edge.first_vertex + i;
            const double t = along_[vertex - edit_.before().vertices] * unit;
            place_vertex(mesh_, columns_, vertex, {corners[k], corners[(k + 1) % 3], corners[k]}, {1 - t, t, 0});
        }
    }
    const uint32_t first_inner = edit_.before().vertices + static_cast<uint32_t>(along_.size());
    for (uint32_t vertex = work.first_inner; vertex < work.first_inner + work.inner_count; ++vertex) {
        const CutTriangulation::Point& point = inner_[vertex - first_inner];
        const double u = point.x * unit, v = point.y * unit;
        place_vertex(mesh_, columns_, vertex, corners, {1 - u - v, u, v});
    }
}

void CurveCutter::write(uint32_t slot) {
    CutTriangle& cut = slots_[slot];
    const Work& work = works_[slot];
    writing_.clear();
    for (uint32_t i = 0; i < work.piece_count; ++i) {
        const CutTriangulation::Triangle& piece = pieces_[work.first_piece + i];
        const uint32_t triangle = i == 0 ? cut.triangle : cut.first_added + i - 1;
        writing_.add(piece.vertices, piece.neighbours, mesh_.regions[cut.triangle]);
        for (uint32_t k = 0; k < 3; ++k) {
            if (piece.is_segment[k]) out_.edges.push_back(3 * triangle + k);
            if (piece.vertices[k] - work.first_inner < work.inner_count) {
                mesh_.corner_of_vertex[piece.vertices[k]] = 3 * triangle + k;
            }
        }
    }
    if (work.piece_count > 1) writer_.write(cut, writing_);
}

void CurveCutter::chain(uint32_t point) {
    const uint32_t end = end_of_stretch(point), first = out_.offsets.back();
    const auto append = [&](uint32_t vertex) {
        if (out_.vertices.size() == first || out_.vertices.back() != vertex) out_.vertices.push_back(vertex);
    };
    if (end != no_index) {
        const Way& way = ways_[point];
        append(way.start);
        for (uint32_t i = 0; i < way.count; ++i) append(way_vertices_[way.first + i]);
    }
    if (point + 1 < curves_.offsets[curve_ + 1]) return;
    if (curves_.closed[curve_] && out_.vertices.size() > first + 1 && out_.vertices.back() == out_.vertices[first]) {
        out_.vertices.pop_back();
    }
    out_.offsets.push_back(static_cast<uint32_t>(out_.vertices.size()));
}

uint32_t CurveCutter::size_of(Pass pass) const {
    switch (pass) {
        case Pass::clear:
        case Pass::sum:
        case Pass::collect: return touched_.word_count();
        case Pass::mark:
        case Pass::gather:
        case Pass::chain: return static_cast<uint32_t>(places_.size());
        default: return static_cast<uint32_t>(slots_.size());
    }
}

void CurveCutter::enter(Pass pass) {
    pass_ = pass;
    at_ = 0;
    curve_ = 0;
    const auto vertices = static_cast<uint32_t>(vertices_), triangles = static_cast<uint32_t>(triangles_);
    if (pass == Pass::collect) {
        slots_ = Buffer<CutTriangle>(touched_.size(), memory_);
        works_ = Buffer<Work>(touched_.size(), memory_);
    }
    if (pass == Pass::grow) growth_.emplace(mesh_, columns_, vertices, triangles);
    if (pass == Pass::place) resize_mesh(mesh_, columns_, vertices, triangles);
    if (pass == Pass::done) edit_.end(mesh_);
}

bool CurveCutter::run(uint32_t count) {
    while (count > 0 && pass_ != Pass::done) {
        if (pass_ == Pass::grow) {
            // Copying is quick: a unit moves many elements.
            if (growth_->run(64 * count)) enter(Pass::place);
            break;
        }
        if (pass_ == Pass::divide) {
            while (count > 0 && at_ < slots_.size()) {
                count -= std::min(count, division_cost());
                at_ += divide(at_);
            }
            if (at_ < slots_.size()) break;
            // Nothing was changed so far: the caller may stop here.
            enter(Pass::grow);
            return false;
        }
        for (const uint32_t end = size_of(pass_); count > 0 && at_ < end; ++at_) {
            uint32_t spent = 1;
            switch (pass_) {
                case Pass::clear: touched_.clear_word(at_); break;
                case Pass::mark: mark(at_); break;
                case Pass::sum: touched_.sum_word(at_); break;
                case Pass::collect: collect(at_); break;
                case Pass::gather: gather(at_); break;
                case Pass::number:
                    number(at_);
                    spent += border_points(slots_[at_]) / 4;
                    break;
                case Pass::place:
                    place(at_);
                    spent += (border_points(slots_[at_]) + works_[at_].inner_count) / 4;
                    break;
                case Pass::write:
                    write(at_);
                    spent += works_[at_].piece_count / 4;
                    break;
                case Pass::chain: chain(at_); break;
                case Pass::divide:
                case Pass::grow:
                case Pass::done: break;
            }
            count -= std::min(count, spent);
        }
        if (at_ == size_of(pass_)) enter(static_cast<Pass>(static_cast<int>(pass_) + 1));
    }
    return pass_ == Pass::done;
}

}  // namespace flg
