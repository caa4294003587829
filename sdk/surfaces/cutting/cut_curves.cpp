// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_curves.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/cutting/cut_triangulation.h"

namespace flg {

namespace {

constexpr int32_t scale = CutTriangulation::scale, tolerance = CutTriangulation::tolerance;
constexpr double unit = 1.0 / scale;

// Where a point of a curve goes when it is cut into the mesh: a vertex that is near, else a point of an edge that is
// near, else inside its triangle. The same for all triangles that share the place.
struct CutPlace {
    enum class Kind : uint32_t { vertex, edge, inside };

    Kind kind;
    uint32_t where;                 // the vertex; the edge, as its corner in the triangle of lower index; the triangle
    CutTriangulation::Point point;  // inside: weights; on an edge: x is the weight of its end
    uint32_t vertex = no_index;     // of the mesh, once that is known
};

CutPlace place_of(const Mesh& mesh, const SurfacePoint& point) {
    const auto x = std::clamp(static_cast<int32_t>(std::lround(double{point.u} * scale)), 0, scale);
    const auto y = std::clamp(static_cast<int32_t>(std::lround(double{point.v} * scale)), 0, scale - x);
    const std::array<int32_t, 3> weights = {scale - x - y, x, y};
    const Triple& vertices = mesh.triangles[point.triangle];
    const auto at_vertex = [&](size_t k) {
        return CutPlace{CutPlace::Kind::vertex, vertices[k % 3], {}, vertices[k % 3]};
    };
    const auto largest = static_cast<size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
    if (weights[largest] >= scale - tolerance) return at_vertex(largest);
    const auto least = static_cast<size_t>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    if (weights[least] > tolerance) return {CutPlace::Kind::inside, point.triangle, {x, y}, no_index};

    const size_t k = (least + 1) % 3;
    const double end = weights[(k + 1) % 3], both = end + weights[k];
    auto along = static_cast<int32_t>(std::lround(scale * (end / both)));
    if (along <= tolerance) return at_vertex(k);
    if (along >= scale - tolerance) return at_vertex(k + 1);
    Corner edge = 3 * point.triangle + static_cast<uint32_t>(k);
    const Corner across = mesh.opposite(edge);
    if (across < edge) {
        edge = across;
        along = scale - along;
    }
    return {CutPlace::Kind::edge, edge, {along, 0}, no_index};
}

// The corner of the triangle at the vertex, or that begins the edge; no_index if the place is not of the triangle; of a
// place inside any corner of its triangle.
Corner corner_in(const Mesh& mesh, const CutPlace& place, uint32_t triangle) {
    switch (place.kind) {
        case CutPlace::Kind::vertex:
            for (uint32_t k = 0; k < 3; ++k) {
                if (mesh.triangles[triangle][k] == place.where) return 3 * triangle + k;
            }
            return no_index;
        case CutPlace::Kind::edge: {
            if (triangle_of(place.where) == triangle) return place.where;
            const Corner across = mesh.opposite(place.where);
            return across != no_index && triangle_of(across) == triangle ? across : no_index;
        }
        case CutPlace::Kind::inside: return place.where == triangle ? 3 * triangle : no_index;
    }
    return no_index;
}

uint32_t border_points(const CutTriangle& cut) {
    return cut.edges[0].points + cut.edges[1].points + cut.edges[2].points;
}

class CurveCutter {
public:
    CurveCutter(Mesh& mesh, MeshColumns& columns, const SurfaceCurves& curves, MeshEdit& edit, EmbeddedCurves& out,
                Memory* memory);

    // Finds how triangles are divided, and changes nothing.
    friend Task<void> plan(Pace& pace, CurveCutter& cutter);
    // Divides them.
    friend Task<void> carry_out(Pace& pace, CurveCutter& cutter);

private:
    friend Task<void> divide(Pace& pace, CurveCutter& cutter);
    // What else a triangle to divide has. Its points and stretches are lists threaded through the points.
    struct Work {
        uint32_t first_stretch = no_index;
        std::array<uint32_t, 3> edge_points = {no_index, no_index, no_index};
        uint32_t first_inner = 0, inner_count = 0;  // vertices inside
        uint32_t first_piece = 0, piece_count = 0;
    };
    // Where a stretch leads along: its first vertex, then `count` more.
    struct Way {
        uint32_t start, first, count;
    };

    uint32_t end_of_stretch(uint32_t point);
    void mark(uint32_t point);
    uint32_t collect(uint32_t group);
    void gather(uint32_t point);
    uint32_t number(uint32_t slot);
    void number_edge(uint32_t first_point, CutTriangle::Edge& edge);
    void begin_division(const CutTriangle& cut);
    void add_border_point(const CutTriangle& cut, uint32_t edge, uint32_t point);
    void add_ends(const CutTriangle& cut, uint32_t stretch);
    size_t follow_way(const CutTriangle& cut, const Work& work, uint32_t stretch, size_t path);
    void begin_pieces(const CutTriangle& cut, Work& work);
    void add_piece(const CutTriangle& cut, const Work& work, uint32_t piece);
    void end_division(CutTriangle& cut, const Work& work);
    uint32_t local_vertex(const CutTriangle& cut, const CutPlace& place);
    uint32_t vertex_of(const CutTriangle& cut, const Work& work, uint32_t local) const;
    uint32_t place(uint32_t slot);
    uint32_t write(uint32_t slot);
    uint32_t chain(uint32_t point);

    Mesh& mesh_;
    MeshColumns& columns_;
    const SurfaceCurves& curves_;
    MeshEdit& edit_;
    EmbeddedCurves& out_;
    TriangleSet touched_;
    Buffer<CutTriangle> slots_;
    Buffer<Work> works_;
    Buffer<CutPlace> places_;        // of the points
    Buffer<uint32_t> next_;          // on the same edge
    Buffer<uint32_t> next_stretch_;  // in the same triangle
    Buffer<Way> ways_;
    std::pmr::deque<int32_t> along_;                      // of the new vertices on edges
    std::pmr::deque<CutTriangulation::Point> inner_;      // the new vertices inside
    std::pmr::deque<CutTriangulation::Triangle> pieces_;  // vertices of the mesh
    std::pmr::deque<uint32_t> way_vertices_;
    PieceWriter writer_;
    CutTriangulation triangulation_;
    Pieces writing_;
    std::pmr::vector<uint32_t> sorted_;  // points of an edge
    std::pmr::vector<uint32_t> paths_;  // of the stretches of a triangle: their ends; then how many vertices, and these
    std::array<uint32_t, 3> first_local_{};  // of the triangle being divided: vertex of each edge's points
    uint32_t filled_ = 0;                    // slots
    uint64_t vertices_, triangles_;          // numbered so far
    uint32_t curve_ = 0;                     // of the point that was asked for last
};

CurveCutter::CurveCutter(Mesh& mesh, MeshColumns& columns, const SurfaceCurves& curves, MeshEdit& edit,
                         EmbeddedCurves& out, Memory* memory)
    : mesh_(mesh),
      columns_(columns),
      curves_(curves),
      edit_(edit),
      out_(out),
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

// Returns what it cost.
uint32_t CurveCutter::collect(uint32_t group) {
    const uint32_t before = filled_;
    touched_.visit(group, [this](uint32_t triangle) {
        slots_[filled_].triangle = triangle;
        works_[filled_++] = {};
    });
    return 1 + 2 * (filled_ - before);
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

uint32_t CurveCutter::number(uint32_t slot) {
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
    return 1 + border_points(cut) / 4;
}

uint32_t CurveCutter::place(uint32_t slot) {
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
    return 1 + (border_points(cut) + work.inner_count) / 4;
}

uint32_t CurveCutter::write(uint32_t slot) {
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
    return 1 + work.piece_count / 4;
}

uint32_t CurveCutter::chain(uint32_t point) {
    const uint32_t end = end_of_stretch(point), first = out_.offsets.back();
    uint32_t cost = 1;
    const auto append = [&](uint32_t vertex) {
        if (out_.vertices.size() == first || out_.vertices.back() != vertex) out_.vertices.push_back(vertex);
    };
    if (end != no_index) {
        const Way& way = ways_[point];
        append(way.start);
        for (uint32_t i = 0; i < way.count; ++i) append(way_vertices_[way.first + i]);
        cost += way.count / 8;
    }
    if (point + 1 < curves_.offsets[curve_ + 1]) return cost;
    if (curves_.closed[curve_] && out_.vertices.size() > first + 1 && out_.vertices.back() == out_.vertices[first]) {
        out_.vertices.pop_back();
    }
    out_.offsets.push_back(static_cast<uint32_t>(out_.vertices.size()));
    return cost;
}

// ---- How a triangle is divided along the stretches of curves in it, once its edges have their points

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

void CurveCutter::begin_division(const CutTriangle& cut) {
    const Triple& corners = mesh_.triangles[cut.triangle];
    const Vec3 origin = mesh_.position(corners[0]);
    triangulation_.reset(mesh_.position(corners[1]) - origin, mesh_.position(corners[2]) - origin);
    paths_.clear();
}

void CurveCutter::add_border_point(const CutTriangle& cut, uint32_t edge, uint32_t point) {
    const CutTriangle::Edge& of = cut.edges[edge];
    const bool owner = of.twin == no_index;
    const uint32_t first = of.first_vertex - edit_.before().vertices;
    const int32_t along = along_[first + (owner ? point : of.points - 1 - point)];
    triangulation_.add_on_edge(edge, owner ? along : CutTriangulation::scale - along);
}

// Points come before all segments, so that segments see each that they might pass.
void CurveCutter::add_ends(const CutTriangle& cut, uint32_t stretch) {
    curve_ = static_cast<uint32_t>(std::upper_bound(curves_.offsets.begin(), curves_.offsets.end(), stretch) -
                                   curves_.offsets.begin() - 1);
    const uint32_t from = local_vertex(cut, places_[stretch]);
    const uint32_t to = local_vertex(cut, places_[end_of_stretch(stretch)]);
    paths_.insert(paths_.end(), {from, to});
}

// `at`: where the stretch's path is in paths_; returns where the next one's is.
size_t CurveCutter::follow_way(const CutTriangle& cut, const Work& work, uint32_t stretch, size_t at) {
    const uint32_t size = paths_[at];
    const uint32_t* path = paths_.data() + at + 1;
    Way& way = ways_[stretch];
    way = {vertex_of(cut, work, path[0]), static_cast<uint32_t>(way_vertices_.size()), 0};
    for (uint32_t i = 0; i + 1 < size; ++i) {
        triangulation_.follow(path[i], path[i + 1], [&](uint32_t local) {
            way_vertices_.push_back(vertex_of(cut, work, local));
            ++way.count;
        });
    }
    return at + 1 + size;
}

void CurveCutter::begin_pieces(const CutTriangle& cut, Work& work) {
    const auto& points = triangulation_.points();
    const uint32_t on_border = first_local_[2] + cut.edges[2].points;
    inner_.insert(inner_.end(), points.begin() + on_border, points.end());
    work.inner_count = static_cast<uint32_t>(points.size()) - on_border;
    vertices_ += work.inner_count;
    work.first_piece = static_cast<uint32_t>(pieces_.size());
    work.piece_count = static_cast<uint32_t>(triangulation_.triangles().size());
}

void CurveCutter::add_piece(const CutTriangle& cut, const Work& work, uint32_t index) {
    CutTriangulation::Triangle piece = triangulation_.triangles()[index];
    for (uint32_t& vertex : piece.vertices) vertex = vertex_of(cut, work, vertex);
    pieces_.push_back(piece);
}

void CurveCutter::end_division(CutTriangle& cut, const Work& work) {
    cut.first_added = static_cast<uint32_t>(triangles_);
    triangles_ += work.piece_count - 1;
    if (vertices_ >= no_index || triangles_ > no_index / 3) {
        throw Failure(FLG_ERROR_LIMIT, "the mesh would have more than 2^32 corners after a cut along %u curves",
                      curves_.curve_count());
    }
}

// Of all triangles: segments within one may be hundreds, and take longer the more there are.
Task<void> divide(Pace& pace, CurveCutter& cutter) {
    Slice slice(Cost::hundreds_of_ns);
    CutTriangulation& triangulation = cutter.triangulation_;
    std::pmr::vector<uint32_t>& paths = cutter.paths_;
    for (uint32_t slot = 0; slot < cutter.slots_.size(); ++slot) {
        CutTriangle& cut = cutter.slots_[slot];
        CurveCutter::Work& work = cutter.works_[slot];
        cutter.begin_division(cut);
        for (uint32_t k = 0; k < 3; ++k) {
            cutter.first_local_[k] = static_cast<uint32_t>(triangulation.points().size());
            for (uint32_t i = 0; i < cut.edges[k].points; ++i) {
                cutter.add_border_point(cut, k, i);
                if (slice.is_over()) co_await pace;
            }
        }
        for (uint32_t s = work.first_stretch; s != no_index; s = cutter.next_stretch_[s]) {
            cutter.add_ends(cut, s);
            if (slice.is_over(triangulation.cost())) co_await pace;
        }
        work.first_inner = static_cast<uint32_t>(cutter.vertices_);
        const size_t ends = paths.size();
        for (size_t at = 0; at < ends; at += 2) {
            triangulation.begin_segment(paths[at], paths[at + 1]);
            while (!triangulation.step())
                if (slice.is_over(triangulation.cost())) co_await pace;
            const auto& path = triangulation.path();
            paths.push_back(static_cast<uint32_t>(path.size()));
            paths.insert(paths.end(), path.begin(), path.end());
            if (slice.is_over(triangulation.cost())) co_await pace;
        }
        triangulation.begin_improvement();
        while (!triangulation.improve())
            if (slice.is_over(4)) co_await pace;
        size_t at = ends;
        for (uint32_t s = work.first_stretch; s != no_index; s = cutter.next_stretch_[s]) {
            at = cutter.follow_way(cut, work, s, at);
            if (slice.is_over(triangulation.cost())) co_await pace;
        }
        cutter.begin_pieces(cut, work);
        for (uint32_t i = 0; i < work.piece_count; ++i) {
            cutter.add_piece(cut, work, i);
            if (slice.is_over()) co_await pace;
        }
        cutter.end_division(cut, work);
        if (slice.is_over(4)) co_await pace;
    }
}

Task<void> plan(Pace& pace, CurveCutter& cutter) {
    TriangleSet& touched = cutter.touched_;
    const size_t points = cutter.places_.size();
    co_await each(pace, touched.group_count(), Cost::some_ns, [&](uint32_t group) { touched.clear_group(group); });
    co_await each(pace, points, Cost::hundreds_of_ns, [&](uint32_t point) { cutter.mark(point); });
    co_await each(pace, touched.group_count(), Cost::hundreds_of_ns, [&](uint32_t group) { touched.sum_group(group); });
    cutter.slots_ = Buffer<CutTriangle>(touched.size(), pace.memory());
    cutter.works_ = Buffer<CurveCutter::Work>(touched.size(), pace.memory());
    co_await each_by_work(pace, touched.group_count(), Cost::some_ns,
                          [&](uint32_t group) { return cutter.collect(group); });
    cutter.curve_ = 0;
    co_await each(pace, points, Cost::hundreds_of_ns, [&](uint32_t point) { cutter.gather(point); });
    co_await each_by_work(pace, cutter.slots_.size(), Cost::hundreds_of_ns,
                          [&](uint32_t slot) { return cutter.number(slot); });
    co_await divide(pace, cutter);
}

Task<void> carry_out(Pace& pace, CurveCutter& cutter) {
    constexpr uint32_t grown = 3200;  // elements, about 10 us
    const auto vertices = static_cast<uint32_t>(cutter.vertices_);
    const auto triangles = static_cast<uint32_t>(cutter.triangles_);
    MeshGrowth growth(cutter.mesh_, cutter.columns_, vertices, triangles);
    while (!growth.run(grown)) co_await pace;
    resize_mesh(cutter.mesh_, cutter.columns_, vertices, triangles);
    co_await each_by_work(pace, cutter.slots_.size(), Cost::hundreds_of_ns,
                          [&](uint32_t slot) { return cutter.place(slot); });
    co_await each_by_work(pace, cutter.slots_.size(), Cost::hundreds_of_ns,
                          [&](uint32_t slot) { return cutter.write(slot); });
    cutter.curve_ = 0;
    co_await each_by_work(pace, cutter.places_.size(), Cost::hundreds_of_ns,
                          [&](uint32_t point) { return cutter.chain(point); });
    cutter.edit_.end(cutter.mesh_);
}

}  // namespace

Task<void> embed_curves(Pace& pace, Mesh& mesh, MeshColumns& columns, const SurfaceCurves& curves, MeshEdit& edit,
                        EmbeddedCurves& out) {
    CurveCutter cutter(mesh, columns, curves, edit, out, pace.memory());
    co_await plan(pace, cutter);
    pace.commit();
    co_await carry_out(pace, cutter);
}

}  // namespace flg
