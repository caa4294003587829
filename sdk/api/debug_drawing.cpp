// SPDX-License-Identifier: MIT
// Debug drawing: each object's parts as lines and points. A drawer says what to draw, once; it runs over a list that
// counts, then over one that writes.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "api/descriptors.h"
#include "api/host_buffers.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"
#include "api/tangle_change.h"
#include "bones/model.h"
#include "bones/outline.h"
#include "bones/part.h"
#include "bones/part_body.h"
#include "bones/skin.h"
#include "filigree/filigree_debug.h"
#include "skeletons/skeleton_jobs.h"
#include "splines/manifolds/manifold_product.h"
#include "splines/manifolds/oriented_samples.h"
#include "splines/motion/motion.h"
#include "splines/obstacles/distance_grid.h"
#include "splines/obstacles/obstacles.h"
#include "splines/spline.h"
#include "stylization/live_stroke.h"
#include "surfaces/field.h"

namespace flg {

namespace {

constexpr uint32_t all_parts = 2 * FLG_DEBUG_PART_CLEARANCE - 1;

constexpr uint32_t red = 0xff0000ff, green = 0xff00ff00, blue = 0xffff0000, grey = 0xff808080, yellow = 0xff00ffff,
                   orange = 0xff0080ff, magenta = 0xffff00ff;

// Colours of numbers: neighbouring ones are far apart, none is red.
uint32_t palette(uint32_t number) {
    constexpr uint32_t colors[] = {0xffffff00, orange, 0xffff0000, 0xff00ff80, magenta,   0xff80ff00,
                                   0xffff8000, yellow, 0xffff0080, green,      0xff8000ff};
    return colors[number % std::size(colors)];
}

// From blue at 0 over green to red at 1.
uint32_t ramp(double value) {
    const auto channel = [](double level) { return static_cast<uint32_t>(255 * std::clamp(level, 0.0, 1.0) + 0.5); };
    const double at = 4 * value;
    return channel(at - 2) | channel(std::min(at, 4 - at)) << 8 | channel(2 - at) << 16 | 0xff000000;
}

FlgDebugDrawDesc default_draw_desc() {
    auto desc = sized<FlgDebugDrawDesc>();
    desc.count = FLG_UNLIMITED;
    desc.every = 1;
    desc.size = 0.05f;
    desc.color = 0xffffffff;
    return desc;
}

FlgDebugDrawDesc read_draw_desc(const FlgDebugDrawDesc* desc, uint32_t usual) {
    FlgDebugDrawDesc read = read_struct(desc, default_draw_desc(), "desc");
    check_range((read.parts & ~all_parts) == 0, "desc.parts", read.parts, "0 or values of FlgDebugPart, combined");
    check_range(read.every >= 1, "desc.every", read.every, "at least 1");
    check_range(read.size > 0 && is_coordinate(read.size), "desc.size", read.size, "above 0 and at most 1e30");
    read_origin(read.origin, "desc.origin");
    if (read.parts == 0) read.parts = usual;
    return read;
}

// Counts lines and points; writes them where there are arrays.
class DrawList {
public:
    DrawList(const FlgDebugDrawDesc& desc, FlgDebugVertex* of_lines, FlgDebugVertex* of_points)
        : desc_(desc), lines_(of_lines), points_(of_points) {
        place(Origin{});
    }

    uint64_t line_count() const { return line_count_; }
    uint64_t point_count() const { return point_count_; }
    uint32_t color() const { return desc_.color; }
    bool wants(uint32_t number) const { return number % desc_.every == 0; }

    // What follows is relative to `origin`; 0 at first.
    void place(const Origin& origin) {
        shift_ = origin_shift(origin, {desc_.origin[0], desc_.origin[1], desc_.origin[2]});
    }

    // Runs `draw` with the numbers of the elements of a part that are in the range.
    template <class Draw>
    void each(uint32_t part, uint32_t total, Draw draw) const {
        if ((desc_.parts & part) == 0) return;
        const uint32_t rest = total - std::min(desc_.first, total);
        const uint32_t count = std::min(desc_.count, rest);
        for (uint32_t i = 0; i < count; ++i) draw(desc_.first + i);
    }

    void point(const Vec3& at, uint32_t color) {
        if (points_) write(points_[point_count_], at, color);
        ++point_count_;
    }
    void line(const Vec3& a, const Vec3& b, uint32_t color) {
        if (lines_) {
            write(lines_[2 * line_count_], a, color);
            write(lines_[2 * line_count_ + 1], b, color);
        }
        ++line_count_;
    }
    // As long as the axes of frames.
    void axis(const Vec3& at, const Vec3& direction, uint32_t color) { line(at, at + desc_.size * direction, color); }
    void frame(const Vec3& at, const Vec3& x, const Vec3& y, const Vec3& z) {
        axis(at, x, red);
        axis(at, y, green);
        axis(at, z, blue);
    }

private:
    void write(FlgDebugVertex& out, const Vec3& at, uint32_t color) const {
        store_vec3(at + shift_, out.position);
        out.color = color;
    }

    const FlgDebugDrawDesc& desc_;
    FlgDebugVertex *lines_, *points_;
    Vec3 shift_;
    uint64_t line_count_ = 0, point_count_ = 0;
};

void check_room(const void* array, uint64_t count, uint32_t capacity, const char* what) {
    if (!array || count <= capacity) return;
    throw Failure(FLG_ERROR_LIMIT, "drawing.%s_capacity is %u, but there are %llu; choose fewer by desc.count", what,
                  capacity, static_cast<unsigned long long>(count));
}

void check_apart(const FlgDebugDrawing& drawing) {
    constexpr uint64_t size = sizeof(FlgDebugVertex);
    Blocks blocks;
    if (drawing.lines) {
        check_aligned(drawing.lines, alignof(FlgDebugVertex), "drawing.lines");
        blocks.add_output({BlockName("drawing.lines"), drawing.lines, size, size, uint64_t{2} * drawing.line_count});
    }
    if (drawing.points) {
        check_aligned(drawing.points, alignof(FlgDebugVertex), "drawing.points");
        blocks.add_output({BlockName("drawing.points"), drawing.points, size, size, drawing.point_count});
    }
    blocks.check_apart();
}

template <class Object>
FlgResult visible_result_of(const Object& object) {
    return visible_result_now(object);
}
// What it has so far is always there.
FlgResult visible_result_of(const LiveStroke&) {
    return FLG_OK;
}

// The whole of an entry point: `find` gives the object, or throws; `paint` draws it.
template <class Find, class Paint>
FlgResult draw(const FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing, uint32_t usual, Find find, Paint paint) {
    return guarded([&]() -> FlgResult {
        FlgDebugDrawing out = read_struct(drawing, sized<FlgDebugDrawing>(), "drawing");
        out.line_count = out.point_count = 0;
        write_struct(drawing, out, "drawing");
        const FlgDebugDrawDesc read = read_draw_desc(desc, usual);
        const auto product = find();
        const FlgResult result = visible_result_of(*product);
        if (result != FLG_OK) return result;
        DrawList counted(read, nullptr, nullptr);
        paint(*product, counted);
        if (std::max(counted.line_count(), counted.point_count()) > UINT32_MAX)
            throw Failure(FLG_ERROR_LIMIT,
                          "the drawing has more than 2^32 - 1 lines or points; choose fewer by desc.count");
        out.line_count = static_cast<uint32_t>(counted.line_count());
        out.point_count = static_cast<uint32_t>(counted.point_count());
        write_struct(drawing, out, "drawing");
        check_room(out.lines, counted.line_count(), out.line_capacity, "line");
        check_room(out.points, counted.point_count(), out.point_capacity, "point");
        check_apart(out);
        if (out.lines || out.points) {
            DrawList written(read, out.lines, out.points);
            paint(*product, written);
        }
        return FLG_OK;
    });
}

Origin origin_of(const double (&origin)[3]) {
    return {origin[0], origin[1], origin[2]};
}

// ---- Curves ----

// Points `begin` to `end` of a curve; place(i) is point i.
template <class Place>
struct Chain {
    Place place;
    uint32_t begin, end;
    bool closed;

    void draw(DrawList& list, uint32_t color) const {
        for (uint32_t i = begin; i + 1 < end; ++i) list.line(place(i), place(i + 1), color);
        if (closed && end - begin > 1) list.line(place(end - 1), place(begin), color);
    }
    void draw_points(DrawList& list, uint32_t color) const {
        for (uint32_t i = begin; i < end; ++i) list.point(place(i), color);
    }
    // The direction between a point's neighbours; 0 if it has no length.
    Vec3 tangent(uint32_t i) const {
        const uint32_t before = i > begin ? i - 1 : closed ? end - 1 : i;
        const uint32_t after = i + 1 < end ? i + 1 : closed ? begin : i;
        return (place(after) - place(before)).normalized();
    }
};
template <class Place>
Chain(Place, uint32_t, uint32_t, bool) -> Chain<Place>;

// Three floats each.
auto places_in(const float* positions) {
    return [positions](uint32_t i) { return load_vec3(positions + size_t{3} * i); };
}

void paint_curves(const FlgCurveSetView& view, const Origin& origin, DrawList& list) {
    const auto column = [&](FlgAttribute attribute) -> const float* {
        const FlgColumn* found = flgCurveSetViewGetColumn(&view, attribute);
        return found ? found->data : nullptr;
    };
    const float *tangents = column(FLG_ATTRIBUTE_TANGENT), *normals = column(FLG_ATTRIBUTE_NORMAL),
                *indices = column(FLG_ATTRIBUTE_STYLE_INDEX);
    const auto place = places_in(column(FLG_ATTRIBUTE_POSITION));
    const auto chain = [&](uint32_t c) {
        const bool closed = (view.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
        return Chain{place, view.curve_offsets[c], view.curve_offsets[c + 1], closed};
    };
    list.place(origin);
    list.each(FLG_DEBUG_PART_LINES, view.curve_count, [&](uint32_t c) { chain(c).draw(list, list.color()); });
    list.each(FLG_DEBUG_PART_POINTS, view.curve_count, [&](uint32_t c) { chain(c).draw_points(list, list.color()); });
    list.each(FLG_DEBUG_PART_FRAMES, normals ? view.curve_count : 0, [&](uint32_t c) {
        const auto curve = chain(c);
        for (uint32_t i = curve.begin; i < curve.end; ++i) {
            if (!list.wants(i - curve.begin)) continue;
            const Vec3 tangent = tangents ? places_in(tangents)(i) : curve.tangent(i), normal = places_in(normals)(i);
            list.frame(place(i), tangent, normal, tangent.cross(normal));
        }
    });
    list.each(FLG_DEBUG_PART_SEAMS, indices ? view.curve_count : 0, [&](uint32_t c) {
        for (uint32_t i = view.curve_offsets[c] + 1; i < view.curve_offsets[c + 1]; ++i) {
            if (indices[i] != indices[i - 1] + 1) list.point(place(i), magenta);
        }
    });
}

void paint_curve_set(const CurveSet& set, DrawList& list) {
    paint_curves(set.view(), set.origin, list);
}

void paint_live_stroke(LiveStroke& stroke, DrawList& list) {
    paint_curves(stroke.view_from(0), stroke.origin, list);
}

void paint_style(const Style& style, DrawList& list) {
    const CurveSet& curves = *style.prepared.guide;
    const Displacement& moved = style.prepared.displacement;
    const auto place = places_in(curves.positions());
    const auto tangent = places_in(curves.find(FLG_ATTRIBUTE_TANGENT)->values.data());
    const auto normal = places_in(curves.find(FLG_ATTRIBUTE_NORMAL)->values.data());
    const auto example = [&](uint32_t i) -> Vec3 {
        return place(i) + moved.along_tangent[i] * tangent(i) + moved.along_normal[i] * normal(i) +
               moved.along_binormal[i] * tangent(i).cross(normal(i));
    };
    const auto at_points = [&](uint32_t c, auto act) {
        for (uint32_t i = curves.offsets()[c]; i < curves.offsets()[c + 1]; ++i) {
            if (list.wants(i - curves.offsets()[c])) act(i);
        }
    };
    const uint32_t count = curves.curve_count();
    list.place(curves.origin);
    list.each(FLG_DEBUG_PART_LINES, count, [&](uint32_t c) {
        Chain{example, curves.offsets()[c], curves.offsets()[c + 1], false}.draw(list, list.color());
    });
    list.each(FLG_DEBUG_PART_GUIDE, count, [&](uint32_t c) {
        Chain{place, curves.offsets()[c], curves.offsets()[c + 1], false}.draw(list, green);
    });
    list.each(FLG_DEBUG_PART_DISPLACEMENT, count,
              [&](uint32_t c) { at_points(c, [&](uint32_t i) { list.line(place(i), example(i), grey); }); });
    list.each(FLG_DEBUG_PART_FRAMES, count, [&](uint32_t c) {
        at_points(c, [&](uint32_t i) { list.frame(place(i), tangent(i), normal(i), tangent(i).cross(normal(i))); });
    });
}

// ---- Surfaces ----

// The edges of a triangle that no lower one has. color(n): of that to the neighbour n, no_index at a border; 0: none.
template <class Color>
void draw_edges(const Mesh& mesh, uint32_t triangle, DrawList& list, Color color) {
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t neighbour = mesh.neighbours[triangle][k];
        if (neighbour < triangle) continue;
        const uint32_t drawn = color(neighbour);
        const Triple& corners = mesh.triangles[triangle];
        if (drawn != 0) list.line(mesh.position(corners[k]), mesh.position(corners[(k + 1) % 3]), drawn);
    }
}

// Of a mesh without neighbours that is closed: every edge has two triangles, which name its ends in opposite order.
template <class Color>
void draw_closed_edges(const float* positions, const uint32_t* corners, DrawList& list, Color color) {
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t a = corners[k], b = corners[(k + 1) % 3];
        if (a < b) list.line(places_in(positions)(a), places_in(positions)(b), color(a));
    }
}

void paint_surface(const Surface& surface, DrawList& list) {
    const Mesh& mesh = surface.mesh();
    list.place(surface.origin);
    list.each(FLG_DEBUG_PART_EDGES, mesh.triangle_count(),
              [&](uint32_t t) { draw_edges(mesh, t, list, [&](uint32_t) { return palette(mesh.regions[t]); }); });
    list.each(FLG_DEBUG_PART_BORDERS, mesh.triangle_count(), [&](uint32_t t) {
        draw_edges(mesh, t, list, [&](uint32_t n) {
            if (n == no_index) return red;
            return mesh.regions[t] == mesh.regions[n] ? 0 : palette(std::max(mesh.regions[t], mesh.regions[n]));
        });
    });
    list.each(FLG_DEBUG_PART_POINTS, mesh.vertex_count(),
              [&](uint32_t v) { list.point(mesh.position(v), list.color()); });
}

void paint_field(const Field& field, DrawList& list) {
    const FlgFieldView& view = field.view();
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (uint32_t v = 0; v < view.vertex_count; ++v) {
        if (!std::isfinite(view.values[v])) continue;
        least = std::min<double>(least, view.values[v]);
        greatest = std::max<double>(greatest, view.values[v]);
    }
    list.place(field.surface->origin);
    list.each(FLG_DEBUG_PART_POINTS, view.vertex_count, [&](uint32_t v) {
        const double value = greatest > least ? (view.values[v] - least) / (greatest - least) : 0;
        list.point(field.surface->mesh().position(v), std::isfinite(view.values[v]) ? ramp(value) : grey);
    });
}

void paint_surface_curves(const TracedCurves& curves, DrawList& list) {
    const FlgSurfaceCurvesView& view = curves.view();
    const Mesh& mesh = curves.surface->mesh();
    const auto place = [&](uint32_t i) -> Vec3 {
        const FlgSurfacePoint& point = view.points[i];
        const Triple& corners = mesh.triangles[point.triangle];
        return (1.0 - point.u - point.v) * mesh.position(corners[0]) + point.u * mesh.position(corners[1]) +
               point.v * mesh.position(corners[2]);
    };
    const auto chain = [&](uint32_t c) {
        const bool closed = (view.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
        return Chain{place, view.curve_offsets[c], view.curve_offsets[c + 1], closed};
    };
    list.place(curves.surface->origin);
    list.each(FLG_DEBUG_PART_LINES, view.curve_count, [&](uint32_t c) { chain(c).draw(list, list.color()); });
    list.each(FLG_DEBUG_PART_POINTS, view.curve_count, [&](uint32_t c) { chain(c).draw_points(list, list.color()); });
}

void paint_tangle(const Tangle& tangle, DrawList& list) {
    const Mesh& mesh = tangle.surface->mesh();
    const auto look = [&](uint32_t t) { return tangle.tree[mesh.regions[t]].look; };
    list.place(tangle.surface->origin);
    list.each(FLG_DEBUG_PART_EDGES, mesh.triangle_count(),
              [&](uint32_t t) { draw_edges(mesh, t, list, [&](uint32_t) { return palette(mesh.regions[t]); }); });
    list.each(FLG_DEBUG_PART_BORDERS, mesh.triangle_count(), [&](uint32_t t) {
        draw_edges(mesh, t, list, [&](uint32_t n) {
            if (n == no_index) return red;
            if (mesh.regions[t] == mesh.regions[n]) return uint32_t{0};
            return look(t) == look(n) ? grey : palette(std::max(look(t), look(n)));
        });
    });
    list.each(FLG_DEBUG_PART_SEEDS, static_cast<uint32_t>(tangle.made), [&](uint32_t i) {
        const StepRecord& record = *tangle.steps[i]->record;
        for (const SeedAnchors* anchors : {&record.a, &record.b}) {
            for (const auto* places : {&anchors->points, &anchors->curve_points, &anchors->loops, &anchors->samples}) {
                for (const Position& place : *places) list.point(load_vec3(place.data()), palette(i));
            }
        }
    });
}

// ---- Drawings and what is made of them ----

// Three numbers each, the first two of which are a place.
auto places_of_nodes(const double* nodes) {
    return [nodes](uint32_t i) { return Vec3(nodes[size_t{3} * i], nodes[size_t{3} * i + 1], 0); };
}

// Two numbers each.
auto places_in_plane(const double* places) {
    return [places](uint32_t i) { return Vec3(places[size_t{2} * i], places[size_t{2} * i + 1], 0); };
}

void paint_straight_skeleton(const HeldStraightSkeleton& held, DrawList& list) {
    const FlgStraightSkeletonView& view = held.view();
    const auto place = places_of_nodes(view.nodes);
    double latest = 0;
    for (uint32_t n = 0; n < view.node_count; ++n) latest = std::max(latest, view.nodes[size_t{3} * n + 2]);
    const auto color = [&](uint32_t n) { return ramp(latest > 0 ? view.nodes[size_t{3} * n + 2] / latest : 0); };
    list.each(FLG_DEBUG_PART_BORDERS, view.contour_count, [&](uint32_t i) {
        const uint32_t* ends = view.face_nodes + view.face_offsets[i];
        list.line(place(ends[0]), place(ends[1]), list.color());
    });
    list.each(FLG_DEBUG_PART_LINES, view.arc_count, [&](uint32_t i) {
        const uint32_t* arc = view.arcs + size_t{4} * i;
        list.line(place(arc[0]), place(arc[1]), color(arc[1]));
    });
    list.each(FLG_DEBUG_PART_POINTS, view.node_count, [&](uint32_t n) {
        if (n >= view.contour_count) list.point(place(n), color(n));
    });
}

void paint_outline(const HeldOutline& held, DrawList& list) {
    const FlgOutlineView& view = held.view();
    const FlgContourView& contour = *view.contour;
    const auto place = [&](uint32_t i) {
        const Vec3 at = places_in_plane(contour.points)(i);
        const double* row = view.placement;
        return Vec3(row[0] * at[0] + row[1] * at[1] + row[3], row[4] * at[0] + row[5] * at[1] + row[7],
                    row[8] * at[0] + row[9] * at[1] + row[11]);
    };
    list.place(origin_of(view.origin));
    list.each(FLG_DEBUG_PART_BORDERS, contour.ring_count, [&](uint32_t r) {
        const uint32_t begin = contour.ring_offsets ? contour.ring_offsets[r] : 0;
        const uint32_t end = contour.ring_offsets ? contour.ring_offsets[r + 1] : contour.point_count;
        Chain{place, begin, end, true}.draw(list, list.color());
    });
}

void paint_part(const HeldPart& held, DrawList& list) {
    const FlgPartView& view = held.view();
    const auto place = places_of_nodes(view.nodes);
    list.each(FLG_DEBUG_PART_BORDERS, view.ring_count, [&](uint32_t r) {
        Chain{places_in_plane(view.outline), view.outline_rings[r], view.outline_rings[r + 1], true}.draw(list,
                                                                                                          list.color());
    });
    list.each(FLG_DEBUG_PART_LINES, view.node_count - 1, [&](uint32_t i) {
        list.line(place(view.arcs[size_t{2} * i]), place(view.arcs[size_t{2} * i + 1]), green);
    });
    list.each(FLG_DEBUG_PART_POINTS, view.node_count, [&](uint32_t n) { list.point(place(n), green); });
    list.each(FLG_DEBUG_PART_FRAMES, view.sample_count, [&](uint32_t i) {
        if (!list.wants(i)) return;
        const FlgAxisSample& sample = view.samples[i];
        const Vec3 at(sample.x, sample.y, 0), left(sample.left_x, sample.left_y, 0);
        list.line(at + sample.left * left, at - sample.right * left, grey);
    });
}

void paint_part_mesh(const HeldPartMesh& held, DrawList& list) {
    const FlgPartMeshView& view = held.view();
    list.each(FLG_DEBUG_PART_EDGES, view.triangle_count, [&](uint32_t t) {
        draw_closed_edges(view.positions, view.triangles + size_t{3} * t, list, [&](uint32_t) { return list.color(); });
    });
}

// An octahedron, widest near its beginning; nothing without length.
void draw_bone(const Vec3& from, const Vec3& to, uint32_t color, DrawList& list) {
    constexpr double widest_at = 0.2, half_width = 0.1;  // of its length
    const Vec3 along = to - from;
    if (along.squaredNorm() == 0) return;
    const Vec3 u = half_width * along.norm() * along.unitOrthogonal(), v = along.normalized().cross(u);
    const Vec3 ring[] = {from + widest_at * along + u, from + widest_at * along + v, from + widest_at * along - u,
                         from + widest_at * along - v};
    for (uint32_t k = 0; k < 4; ++k) {
        list.line(from, ring[k], color);
        list.line(ring[k], ring[(k + 1) % 4], color);
        list.line(ring[k], to, color);
    }
}

// Of a model or a skin; color(j): of a joint and the bone to it.
template <class View, class Color>
void draw_joints(const View& view, DrawList& list, Color color) {
    const auto place = places_in(view.joint_positions);
    list.place(origin_of(view.origin));
    list.each(FLG_DEBUG_PART_LINES, view.joint_count, [&](uint32_t j) {
        const uint32_t parent = view.joint_parents[j];
        if (parent != FLG_NO_INDEX) draw_bone(place(parent), place(j), color(j), list);
    });
    list.each(FLG_DEBUG_PART_POINTS, view.joint_count, [&](uint32_t j) { list.point(place(j), color(j)); });
}

void paint_model(const HeldModel& held, DrawList& list) {
    draw_joints(held.view(), list, [&](uint32_t j) { return palette(held.view().joint_parts[j]); });
}

void paint_skin(const HeldSkin& held, DrawList& list) {
    const FlgSkinView& view = held.view();
    draw_joints(view, list, [&](uint32_t) { return list.color(); });
    list.each(FLG_DEBUG_PART_EDGES, view.triangle_count, [&](uint32_t t) {
        draw_closed_edges(view.positions, view.triangles + size_t{3} * t, list,
                          [&](uint32_t vertex) { return palette(view.vertex_parts[vertex]); });
    });
}

// ---- Manifolds, splines, motions and obstacles ----

// Points of a surface in space with their outward normals; find(i, at, normal): those of element i, if it has any.
template <class Find>
void draw_places(uint32_t count, DrawList& list, Find find) {
    Vec3 at, normal;
    list.each(FLG_DEBUG_PART_POINTS, count, [&](uint32_t i) {
        if (find(i, at, normal)) list.point(at, list.color());
    });
    list.each(FLG_DEBUG_PART_LINES, count, [&](uint32_t i) {
        if (list.wants(i) && find(i, at, normal)) list.axis(at, normal, green);
    });
}

// A box in cells, for surfaces that no samples tell of.
struct Lattice {
    static constexpr uint32_t cells_along = 16, cells = cells_along * cells_along * cells_along;

    Vec3 low, cell;

    explicit Lattice(const Hypersurface& surface) {
        low = Vec3::Constant(-0.5 * surface.size());
        Vec3 extent = Vec3::Constant(surface.size());
        if (const auto* const grid = dynamic_cast<const DistanceGrid*>(&surface)) {
            for (uint32_t axis = 0; axis < 3; ++axis) {
                low[axis] = grid->low(axis);
                extent[axis] = grid->extent(axis);
            }
        }
        cell = extent / cells_along;
    }
    Vec3 middle(uint32_t i) const {
        const uint32_t x = i % cells_along, y = i / cells_along % cells_along, z = i / (cells_along * cells_along);
        return low + cell.cwiseProduct(Vec3(x + 0.5, y + 0.5, z + 0.5));
    }
    // The point next to a cell's middle, if it lies in the cell: in no other one then.
    bool find(const Hypersurface& surface, uint32_t i, Vec3& at, Vec3& normal) const {
        double hint[Manifold::max_hint], value = 0;
        std::fill_n(hint, surface.hint_size(), 0.0);
        at = middle(i);
        if (!surface.project(at.data(), hint)) return false;
        const Vec3 off = (at - middle(i)).cwiseQuotient(cell);
        if (!(off.minCoeff() >= -0.5 && off.maxCoeff() < 0.5)) return false;
        if (!surface.evaluate(at.data(), hint, &value, normal.data(), nullptr)) return false;
        normal.normalize();
        return true;
    }
};

void paint_manifold(const ManifoldProduct& held, DrawList& list) {
    if (held.base) return paint_manifold(*held.base, list);
    if (held.kind != ManifoldKind::hypersurface) return;
    const auto& surface = static_cast<const Hypersurface&>(*held.manifold);
    list.place(held.origin);
    if (const auto* const samples = dynamic_cast<const OrientedSamples*>(&surface)) {
        return draw_places(samples->sample_count(), list, [&](uint32_t i, Vec3& at, Vec3& normal) {
            at = Vec3(samples->sample(i).position.data());
            normal = Vec3(samples->sample(i).normal.data());
            return true;
        });
    }
    const Lattice lattice(surface);
    draw_places(Lattice::cells, list,
                [&](uint32_t i, Vec3& at, Vec3& normal) { return lattice.find(surface, i, at, normal); });
}

struct ObstacleWires final : Obstacle::Wires {
    ObstacleWires(DrawList& to, uint32_t of_color) : list(to), color(of_color) {}
    void line(const Obstacle::Place& a, const Obstacle::Place& b) override {
        list.line(Vec3(a.data()), Vec3(b.data()), color);
    }
    DrawList& list;
    uint32_t color;
};

void paint_obstacles(const Obstacles& obstacles, DrawList& list) {
    const auto mesh_of = [&](uint32_t i) -> const Obstacles::OfMesh* {
        for (const Obstacles::OfMesh& mesh : obstacles.meshes) {
            if (mesh.at == i) return &mesh;
        }
        return nullptr;
    };
    const auto count = static_cast<uint32_t>(obstacles.solids.size());
    list.each(FLG_DEBUG_PART_LINES, count, [&](uint32_t i) {
        const Obstacles::OfMesh* const of = mesh_of(i);
        if (of && !of->surface->order.is_changing()) {
            const Mesh& mesh = of->surface->mesh();
            list.place(of->surface->origin);
            for (uint32_t t = 0; t < mesh.triangle_count(); ++t)
                draw_edges(mesh, t, list, [&](uint32_t) { return list.color(); });
            return;
        }
        list.place(obstacles.origin);
        ObstacleWires wires(list, list.color());
        obstacles.solids[i]->draw(0, wires);
    });
    list.place(obstacles.origin);
    list.each(FLG_DEBUG_PART_CLEARANCE, obstacles.clearance > 0 ? count : 0, [&](uint32_t i) {
        ObstacleWires wires(list, grey);
        if (obstacles.solids[i]->bounded()) obstacles.solids[i]->draw(obstacles.clearance, wires);
    });
}

void paint_spline(const Spline& spline, DrawList& list) {
    const FlgSplineView& view = spline.view();
    const auto place = [&](uint32_t i) {
        Vec3 at = Vec3::Zero();
        for (uint32_t k = 0; k < std::min(view.ambient, 3u); ++k) at[k] = view.nodes[size_t{view.ambient} * i + k];
        return at;
    };
    const Chain chain{place, 0, view.node_count, view.closed != 0};
    const bool stopped = view.ending == FLG_SPLINE_ENDING_ROUNDS || view.ending == FLG_SPLINE_ENDING_STALLED;
    list.place(origin_of(view.origin));
    list.each(FLG_DEBUG_PART_LINES, view.closed ? view.node_count : view.node_count - 1, [&](uint32_t i) {
        list.line(place(i), place((i + 1) % view.node_count), stopped ? orange : list.color());
    });
    list.each(FLG_DEBUG_PART_POINTS, view.point_count,
              [&](uint32_t i) { list.point(place(view.point_nodes[i]), yellow); });
    list.each(FLG_DEBUG_PART_FRAMES, view.normals ? view.node_count : 0, [&](uint32_t i) {
        if (!list.wants(i)) return;
        const Vec3 tangent = chain.tangent(i), normal = places_in(view.normals)(i);
        list.frame(place(i), tangent, normal, tangent.cross(normal));
    });
}

void paint_motion(const Motion& motion, DrawList& list) {
    const FlgMotionView& view = motion.view();
    // Columns 0 to 2 are the body's axes, column 3 its position.
    const auto column = [&](uint32_t i, uint32_t c) {
        const double* pose = view.poses + size_t{12} * i;
        return Vec3(pose[c], pose[4 + c], pose[8 + c]);
    };
    const auto place = [&](uint32_t i) -> Vec3 {
        return view.barycentre[0] * column(i, 0) + view.barycentre[1] * column(i, 1) +
               view.barycentre[2] * column(i, 2) + column(i, 3);
    };
    list.place(origin_of(view.origin));
    list.each(FLG_DEBUG_PART_LINES, view.closed ? view.position_count : view.position_count - 1,
              [&](uint32_t i) { list.line(place(i), place((i + 1) % view.position_count), list.color()); });
    list.each(FLG_DEBUG_PART_FRAMES, view.position_count, [&](uint32_t i) {
        if (list.wants(i)) list.frame(place(i), column(i, 0), column(i, 1), column(i, 2));
    });
    list.each(FLG_DEBUG_PART_POINTS, view.key_count,
              [&](uint32_t k) { list.point(place(view.key_positions[k]), yellow); });
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgDebugDrawDescInit(FlgDebugDrawDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_draw_desc());
}

FlgResult flgDebugDrawingInit(FlgDebugDrawing* drawing, uint32_t struct_size) {
    return init(drawing, struct_size, sized<FlgDebugDrawing>(), "drawing");
}

FlgResult flgDebugDrawCurveSet(FlgContext context, FlgCurveSet set, const FlgDebugDrawDesc* desc,
                               FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).curve_sets.get(set.id, "set"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_FRAMES | FLG_DEBUG_PART_SEAMS, find,
                paint_curve_set);
}

FlgResult flgDebugDrawLiveStroke(FlgContext context, FlgLiveStroke stroke, const FlgDebugDrawDesc* desc,
                                 FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).live_strokes.get(stroke.id, "stroke"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_FRAMES | FLG_DEBUG_PART_SEAMS, find,
                paint_live_stroke);
}

FlgResult flgDebugDrawStyle(FlgContext context, FlgStyle style, const FlgDebugDrawDesc* desc,
                            FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).styles.get(style.id, "style"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_GUIDE | FLG_DEBUG_PART_DISPLACEMENT, find,
                paint_style);
}

FlgResult flgDebugDrawSurface(FlgContext context, FlgSurface surface, const FlgDebugDrawDesc* desc,
                              FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).surfaces.get(surface.id, "surface"); };
    return draw(desc, drawing, FLG_DEBUG_PART_BORDERS, find, paint_surface);
}

FlgResult flgDebugDrawField(FlgContext context, FlgField field, const FlgDebugDrawDesc* desc,
                            FlgDebugDrawing* drawing) {
    const auto find = [&] {
        auto found = get_context(context).fields.get(field.id, "field");
        check_revision(*found, "field");
        return found;
    };
    return draw(desc, drawing, FLG_DEBUG_PART_POINTS, find, paint_field);
}

FlgResult flgDebugDrawSurfaceCurves(FlgContext context, FlgSurfaceCurves curves, const FlgDebugDrawDesc* desc,
                                    FlgDebugDrawing* drawing) {
    const auto find = [&] {
        auto found = get_context(context).surface_curves.get(curves.id, "curves");
        check_revision(*found, "curves");
        return found;
    };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES, find, paint_surface_curves);
}

FlgResult flgDebugDrawTangle(FlgContext context, FlgTangle tangle, const FlgDebugDrawDesc* desc,
                             FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).tangles.get(tangle.id, "tangle"); };
    return draw(desc, drawing, FLG_DEBUG_PART_BORDERS | FLG_DEBUG_PART_SEEDS, find, paint_tangle);
}

FlgResult flgDebugDrawStraightSkeleton(FlgContext context, FlgStraightSkeleton skeleton, const FlgDebugDrawDesc* desc,
                                       FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).straight_skeletons.get(skeleton.id, "skeleton"); };
    return draw(desc, drawing, FLG_DEBUG_PART_BORDERS | FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS, find,
                paint_straight_skeleton);
}

FlgResult flgDebugDrawOutline(FlgContext context, FlgOutline outline, const FlgDebugDrawDesc* desc,
                              FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).outlines.get(outline.id, "outline"); };
    return draw(desc, drawing, FLG_DEBUG_PART_BORDERS, find, paint_outline);
}

FlgResult flgDebugDrawPart(FlgContext context, FlgPart part, const FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).parts.get(part.id, "part"); };
    return draw(desc, drawing, FLG_DEBUG_PART_BORDERS | FLG_DEBUG_PART_LINES, find, paint_part);
}

FlgResult flgDebugDrawPartMesh(FlgContext context, FlgPartMesh mesh, const FlgDebugDrawDesc* desc,
                               FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).part_meshes.get(mesh.id, "mesh"); };
    return draw(desc, drawing, FLG_DEBUG_PART_EDGES, find, paint_part_mesh);
}

FlgResult flgDebugDrawModel(FlgContext context, FlgModel model, const FlgDebugDrawDesc* desc,
                            FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).models.get(model.id, "model"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS, find, paint_model);
}

FlgResult flgDebugDrawSkin(FlgContext context, FlgSkin skin, const FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).skins.get(skin.id, "skin"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS, find, paint_skin);
}

FlgResult flgDebugDrawObstacles(FlgContext context, FlgObstacles obstacles, const FlgDebugDrawDesc* desc,
                                FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).obstacles.get(obstacles.id, "obstacles"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_CLEARANCE, find, paint_obstacles);
}

FlgResult flgDebugDrawManifold(FlgContext context, FlgManifold manifold, const FlgDebugDrawDesc* desc,
                               FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).manifolds.get(manifold.id, "manifold"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS, find, paint_manifold);
}

FlgResult flgDebugDrawSpline(FlgContext context, FlgSpline spline, const FlgDebugDrawDesc* desc,
                             FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).splines.get(spline.id, "spline"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_POINTS, find, paint_spline);
}

FlgResult flgDebugDrawMotion(FlgContext context, FlgMotion motion, const FlgDebugDrawDesc* desc,
                             FlgDebugDrawing* drawing) {
    const auto find = [&] { return get_context(context).motions.get(motion.id, "motion"); };
    return draw(desc, drawing, FLG_DEBUG_PART_LINES | FLG_DEBUG_PART_FRAMES | FLG_DEBUG_PART_POINTS, find,
                paint_motion);
}

}  // extern "C"
