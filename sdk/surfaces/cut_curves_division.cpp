// SPDX-License-Identifier: MIT
// How a triangle is divided along the stretches of curves in it, once its edges have their points.
#include <algorithm>

#include "core/failure.h"
#include "surfaces/cut_curves.h"

namespace flg {

namespace {

constexpr uint32_t small_chunk = 8;  // points or pieces, up to 1 us

}  // namespace

uint32_t CurveCutter::local_vertex(const CutTriangle& cut, const CutPlace& place) {
    if (place.kind == CutPlace::Kind::inside) return triangulation_.add(place.point);
    const uint32_t k = corner_in(mesh_, place, cut.triangle) % 3;
    if (place.kind == CutPlace::Kind::vertex) return k;
    const CutTriangle::Edge& edge = cut.edges[k];
    const uint32_t i = place.vertex - edge.first_vertex;
    return first_local_[k] + (edge.twin == no_index ? i : edge.points - 1 - i);
}

// The mesh's vertex for one of the triangulation.
uint32_t CurveCutter::vertex_of(const CutTriangle& cut, const Work& work, uint32_t local) const {
    if (local < 3) return mesh_.triangles[cut.triangle][local];
    for (uint32_t k = 0; k < 3; ++k) {
        const CutTriangle::Edge& edge = cut.edges[k];
        if (local >= first_local_[k] + edge.points) continue;
        const uint32_t i = local - first_local_[k];
        return edge.first_vertex + (edge.twin == no_index ? i : edge.points - 1 - i);
    }
    return work.first_inner + (local - first_local_[2] - cut.edges[2].points);
}

void CurveCutter::begin_division(const CutTriangle& cut, const Work& work) {
    const Triple& corners = mesh_.triangles[cut.triangle];
    const Vec3 origin = mesh_.position(corners[0]);
    triangulation_.reset(mesh_.position(corners[1]) - origin, mesh_.position(corners[2]) - origin);
    paths_.clear();
    stretch_ = work.first_stretch;
    edge_ = edge_point_ = 0;
    first_local_[0] = static_cast<uint32_t>(triangulation_.points().size());
}

// Some of the edges' points; true when all are there.
bool CurveCutter::add_borders(const CutTriangle& cut) {
    for (uint32_t count = 0; edge_ < 3 && count < small_chunk; ++count) {
        const CutTriangle::Edge& edge = cut.edges[edge_];
        if (edge_point_ == edge.points) {
            edge_point_ = 0;
            if (++edge_ < 3) first_local_[edge_] = static_cast<uint32_t>(triangulation_.points().size());
            continue;
        }
        const bool owner = edge.twin == no_index;
        const uint32_t first = edge.first_vertex - edit_.before().vertices;
        const int32_t along = along_[first + (owner ? edge_point_ : edge.points - 1 - edge_point_)];
        triangulation_.add_on_edge(edge_, owner ? along : CutTriangulation::scale - along);
        ++edge_point_;
    }
    return edge_ == 3;
}

// Points come before all segments, so that segments see each that they might pass.
void CurveCutter::add_ends(const CutTriangle& cut) {
    curve_ = static_cast<uint32_t>(std::upper_bound(curves_.offsets.begin(), curves_.offsets.end(), stretch_) -
                                   curves_.offsets.begin() - 1);
    const uint32_t from = local_vertex(cut, places_[stretch_]);
    const uint32_t to = local_vertex(cut, places_[end_of_stretch(stretch_)]);
    paths_.insert(paths_.end(), {from, to});
}

void CurveCutter::follow_way(const CutTriangle& cut, const Work& work) {
    const uint32_t size = paths_[path_];
    const uint32_t* path = paths_.data() + path_ + 1;
    Way& way = ways_[stretch_];
    way = {vertex_of(cut, work, path[0]), static_cast<uint32_t>(way_vertices_.size()), 0};
    for (uint32_t i = 0; i + 1 < size; ++i) {
        triangulation_.follow(path[i], path[i + 1], [&](uint32_t local) {
            way_vertices_.push_back(vertex_of(cut, work, local));
            ++way.count;
        });
    }
    path_ += 1 + size;
}

void CurveCutter::begin_pieces(const CutTriangle& cut, Work& work) {
    const auto& points = triangulation_.points();
    const uint32_t on_border = first_local_[2] + cut.edges[2].points;
    inner_.insert(inner_.end(), points.begin() + on_border, points.end());
    work.inner_count = static_cast<uint32_t>(points.size()) - on_border;
    vertices_ += work.inner_count;
    work.first_piece = static_cast<uint32_t>(pieces_.size());
    work.piece_count = static_cast<uint32_t>(triangulation_.triangles().size());
    piece_ = 0;
}

// Keeps some of the pieces; true when all are kept.
bool CurveCutter::add_pieces(const CutTriangle& cut, const Work& work) {
    const uint32_t end = std::min(work.piece_count, piece_ + small_chunk);
    for (; piece_ < end; ++piece_) {
        CutTriangulation::Triangle piece = triangulation_.triangles()[piece_];
        for (uint32_t& vertex : piece.vertices) vertex = vertex_of(cut, work, vertex);
        pieces_.push_back(piece);
    }
    return piece_ == work.piece_count;
}

void CurveCutter::end_division(CutTriangle& cut, const Work& work) {
    cut.first_added = static_cast<uint32_t>(triangles_);
    triangles_ += work.piece_count - 1;
    if (vertices_ >= no_index || triangles_ > no_index / 3) {
        throw Failure(FLG_ERROR_LIMIT, "the mesh would have more than 2^32 corners after a cut along %u curves",
                      curves_.curve_count());
    }
}

// Of the next step, in units.
uint32_t CurveCutter::division_cost() const {
    switch (stage_) {
        case Stage::points:
        case Stage::segments:
        case Stage::ways: return triangulation_.cost();
        case Stage::borders:
        case Stage::improve:
        case Stage::pieces: return small_chunk / 2;
        case Stage::begin:
        case Stage::end: break;
    }
    return 1;
}

// One step of the triangle's division; true when it is divided.
bool CurveCutter::divide(uint32_t slot) {
    CutTriangle& cut = slots_[slot];
    Work& work = works_[slot];
    const auto enter_stage = [&](Stage stage, size_t path) {
        stage_ = stage;
        stretch_ = work.first_stretch;
        path_ = path;
    };
    switch (stage_) {
        case Stage::begin:
            begin_division(cut, work);
            enter_stage(Stage::borders, 0);
            break;
        case Stage::borders:
            if (add_borders(cut)) enter_stage(Stage::points, 0);
            break;
        case Stage::points:
            if (stretch_ != no_index) {
                add_ends(cut);
                stretch_ = next_stretch_[stretch_];
            } else {
                work.first_inner = static_cast<uint32_t>(vertices_);
                ends_ = paths_.size();
                enter_stage(Stage::segments, 0);
                if (ends_ != 0) triangulation_.begin_segment(paths_[0], paths_[1]);
            }
            break;
        case Stage::segments:
            if (path_ == ends_) {
                triangulation_.begin_improvement();
                enter_stage(Stage::improve, ends_);
            } else if (triangulation_.step()) {
                const auto& path = triangulation_.path();
                paths_.push_back(static_cast<uint32_t>(path.size()));
                paths_.insert(paths_.end(), path.begin(), path.end());
                path_ += 2;
                if (path_ != ends_) triangulation_.begin_segment(paths_[path_], paths_[path_ + 1]);
            }
            break;
        case Stage::improve:
            if (triangulation_.improve()) enter_stage(Stage::ways, ends_);
            break;
        case Stage::ways:
            if (stretch_ != no_index) {
                follow_way(cut, work);
                stretch_ = next_stretch_[stretch_];
            } else {
                begin_pieces(cut, work);
                stage_ = Stage::pieces;
            }
            break;
        case Stage::pieces:
            if (add_pieces(cut, work)) stage_ = Stage::end;
            break;
        case Stage::end:
            end_division(cut, work);
            stage_ = Stage::begin;
            return true;
    }
    return false;
}

}  // namespace flg
