// SPDX-License-Identifier: MIT
#include "splines/spline_ribbon.h"

#include <algorithm>
#include <cmath>

#include "splines/spline_rows.h"
#include "splines/surface_trace.h"
#include "surfaces/surface_jobs.h"

namespace flg {

namespace {

constexpr double least_across = 1e-6;  // of a direction across: less is none
constexpr double least_apart = 0.05;   // of their distance: so far apart neighbouring rows end
constexpr double most_diagonals = 2;   // of a mesh: so wide is a ribbon on it at most
constexpr uint32_t max_ribbon_vertices = 1u << 26;

// A row: where it is, and how far it reaches.
struct RibbonRow {
    Vec3 place, way, left, up;  // unit vectors
    double bend;                // 1 / metre, to the left
    double reach[2];            // metres, to the left and to the right
};

struct Ribbon {
    explicit Ribbon(Memory* memory) : rows(memory) {}
    std::pmr::vector<RibbonRow> rows;
    bool closed = false;  // the last row is the first again
};

// Upwards and to the left. Where the curve rises straight up it stays as before.
void frame_row(const Vec3& up, const RibbonRow* before, RibbonRow& row) {
    Vec3 left = up.cross(row.way);
    if (left.norm() < least_across) left = before != nullptr ? before->left : row.way.unitOrthogonal();
    row.left = (left - left.dot(row.way) * row.way).normalized();
    row.up = row.way.cross(row.left);
}

// Smoothed over a length, forwards and backwards; round and round where the ribbon is closed.
Task<void> smooth_bends(Pace& pace, const SplineRows& rows, double length, Ribbon& ribbon) {
    const auto last = static_cast<uint32_t>(ribbon.rows.size()) - 1;
    for (const bool back : {false, true}) {
        double value = ribbon.rows[back ? last : 0].bend;
        for (uint32_t turn = 0; turn < (ribbon.closed ? 2u : 1u); ++turn) {
            co_await each(pace, last, Cost::tens_of_ns, [&](uint32_t i) {
                const uint32_t from = back ? last - i : i, to = back ? from - 1 : from + 1;
                const double step = std::abs(rows.rows[to].length - rows.rows[from].length);
                value += (ribbon.rows[to].bend - value) * (1 - std::exp(-step / length));
                ribbon.rows[to].bend = value;
            });
            if (ribbon.closed) ribbon.rows[back ? last : 0].bend = value;
        }
    }
}

// Before they cross, rows end; and no row is longer than its neighbour by more than they are apart.
Task<void> limit_reach(Pace& pace, const SplineRows& rows, Ribbon& ribbon) {
    const auto last = static_cast<uint32_t>(ribbon.rows.size()) - 1;
    co_await each(pace, last, Cost::tens_of_ns, [&](uint32_t i) {
        RibbonRow &a = ribbon.rows[i], &b = ribbon.rows[i + 1];
        const Vec3 way = (a.way + b.way).normalized(), step = b.place - a.place;
        for (uint32_t side = 0; side < 2; ++side) {
            const double sign = side == 0 ? 1 : -1;
            // How fast the rows' ends come nearer to each other as they go out.
            const double closing = -sign * (b.left - a.left).dot(way);
            if (!(closing > 0)) continue;
            const double most = (1 - least_apart) * step.dot(way) / closing;
            a.reach[side] = std::min(a.reach[side], std::max(most, 0.0));
            b.reach[side] = std::min(b.reach[side], std::max(most, 0.0));
        }
    });
    for (uint32_t turn = 0; turn < (ribbon.closed ? 2u : 1u); ++turn) {
        for (const bool back : {false, true}) {
            co_await each(pace, last, Cost::tens_of_ns, [&, back](uint32_t i) {
                const uint32_t from = back ? last - i : i, to = back ? from - 1 : from + 1;
                const double step = std::abs(rows.rows[to].length - rows.rows[from].length);
                for (uint32_t side = 0; side < 2; ++side)
                    ribbon.rows[to].reach[side] =
                        std::min(ribbon.rows[to].reach[side], ribbon.rows[from].reach[side] + step);
            });
        }
        if (!ribbon.closed) continue;
        for (uint32_t side = 0; side < 2; ++side) {
            double &first = ribbon.rows[0].reach[side], &end = ribbon.rows[last].reach[side];
            first = end = std::min(first, end);
        }
    }
}

Task<Ribbon> frame_rows(Pace& pace, const SplineRows& rows, const RibbonShape& shape, bool closed) {
    Ribbon ribbon(pace.memory());
    ribbon.closed = closed;
    const auto count = static_cast<uint32_t>(rows.rows.size());
    ribbon.rows.reserve(count);
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const SplineRow& from = rows.rows[i];
        RibbonRow row{from.place, from.way, {}, {}, 0, {0.5 * shape.width, 0.5 * shape.width}};
        const bool has_up = !shape.up.isZero(0);
        frame_row(has_up ? shape.up : from.normal, i > 0 ? &ribbon.rows[i - 1] : nullptr, row);
        ribbon.rows.push_back(row);
    });
    const uint32_t last = count - 1;
    if (closed) ribbon.rows[last] = ribbon.rows[0];
    co_await limit_reach(pace, rows, ribbon);
    if (shape.bank == 0) co_return ribbon;
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t before = i > 0 ? i - 1 : closed ? last - 1 : 0, after = i < last ? i + 1 : closed ? 1 : last;
        const double length = rows.rows[after].length - rows.rows[before].length + (before < after ? 0 : rows.length);
        ribbon.rows[i].bend = (rows.rows[after].way - rows.rows[before].way).dot(ribbon.rows[i].left) / length;
    });
    co_await smooth_bends(pace, rows, shape.width, ribbon);
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        RibbonRow& row = ribbon.rows[i];
        const double lean = std::atan(shape.bank * row.bend), c = std::cos(lean), s = std::sin(lean);
        const Vec3 left = row.left;
        row.left = c * left - s * row.up;
        row.up = c * row.up + s * left;
    });
    co_return ribbon;
}

// Over the triangles: the row's places, from left to right.
Task<void> lay_row(Pace& pace, const Mesh& mesh, NearestPoints& nearest, RibbonRow& row, uint32_t columns,
                   Vec3* places) {
    const SurfacePoint middle = co_await nearest_point(pace, nearest, row.place);
    SurfacePath paths[2] = {SurfacePath(pace.memory()), SurfacePath(pace.memory())};
    for (uint32_t side = 0; side < 2; ++side) {
        co_await walk_aside(pace, mesh, middle, row.way, side == 0 ? row.reach[0] : -row.reach[1], paths[side]);
        row.reach[side] = std::min(row.reach[side], paths[side].length());
    }
    for (uint32_t j = 0; j <= columns; ++j) {
        const double share = static_cast<double>(j) / columns,
                     to_right = share * (row.reach[0] + row.reach[1]) - row.reach[0];
        const SurfacePoint point = point_at(mesh, paths[to_right > 0], std::abs(to_right));
        places[j] = position_of(mesh, point);
    }
}

Task<void> place_rows(Pace& pace, const Spline& spline, const RibbonShape& shape, Ribbon& ribbon,
                      Buffer<Vec3>& places) {
    const uint32_t across = shape.columns + 1;
    if (!shape.conforms) {
        co_await each(pace, places.size(), Cost::some_ns, [&](uint32_t v) {
            const RibbonRow& row = ribbon.rows[v / across];
            const double share = static_cast<double>(v % across) / shape.columns;
            places[v] = row.place + ((1 - share) * row.reach[0] - share * row.reach[1]) * row.left;
        });
        co_return;
    }
    const Mesh& mesh = spline.manifold->surface->mesh();
    NearestPoints nearest = co_await nearest_on(pace, *spline.manifold);
    const auto count = static_cast<uint32_t>(ribbon.rows.size());
    for (uint32_t i = 0; i < count; ++i) {
        Vec3* const row = &places[size_t{i} * across];
        if (ribbon.closed && i + 1 == count) {
            std::copy_n(places.begin(), across, row);
            std::copy_n(ribbon.rows[0].reach, 2, ribbon.rows[i].reach);
        } else {
            co_await lay_row(pace, mesh, nearest, ribbon.rows[i], shape.columns, row);
        }
        co_await pace;
    }
}

// Of the mesh of rows: what differences along and across say; where they say nothing, the row's.
Vec3 normal_at(const Ribbon& ribbon, const Buffer<Vec3>& places, uint32_t across, uint32_t v) {
    const uint32_t i = v / across, j = v % across, last = static_cast<uint32_t>(ribbon.rows.size()) - 1;
    const uint32_t before = i > 0           ? i - 1
                            : ribbon.closed ? last - 1
                                            : 0,
                   after = i < last        ? i + 1
                           : ribbon.closed ? 1
                                           : last;
    const Vec3 along = places[size_t{after} * across + j] - places[size_t{before} * across + j],
               left = places[v - (j > 0 ? 1 : 0)] - places[v + (j + 1 < across ? 1 : 0)], normal = along.cross(left);
    const double length = normal.norm();
    return length > least_across * along.norm() * left.norm() && length > 0 ? Vec3(normal / length) : ribbon.rows[i].up;
}

void add_ribbon_column(MeshInput& input, FlgAttribute attribute, uint32_t components, Memory* memory) {
    input.values.emplace_back(size_t{input.view.vertex_count} * components, memory);
    input.columns.push_back(FlgColumn{attribute, components, input.values.back().data(), 0, 0});
}

}  // namespace

Task<void> make_ribbon(Pace& pace, std::shared_ptr<const Spline> spline, RibbonShape shape,
                       std::shared_ptr<Surface> out) {
    pace.stage("rows");
    co_await check_precision(pace, spline->chain.nodes);
    if (shape.conforms) {
        const MeshExtent& extent = spline->manifold->surface->extent;
        shape.width = std::min(shape.width, most_diagonals * (extent.upper - extent.lower).norm());
    }
    SplineRows rows = co_await rows_along(pace, *spline, shape.spacing);
    const uint32_t across = shape.columns + 1, count = static_cast<uint32_t>(rows.rows.size());
    if (uint64_t{count} * across > max_ribbon_vertices)
        throw Failure(FLG_ERROR_LIMIT, "a ribbon of %u rows with %u columns has more than the limit of 2^26 vertices",
                      count, shape.columns);
    Ribbon ribbon = co_await frame_rows(pace, rows, shape, spline->closed);
    Buffer<Vec3> places(size_t{count} * across, pace.memory());
    co_await place_rows(pace, *spline, shape, ribbon, places);

    pace.stage("mesh");
    auto input =
        std::allocate_shared<MeshInput>(std::pmr::polymorphic_allocator<MeshInput>(pace.memory()), pace.memory());
    input->view.struct_size = sizeof input->view;
    input->view.vertex_count = count * across;
    input->view.triangle_count = 2 * (count - 1) * shape.columns;
    input->values.reserve(4);
    for (const auto& [attribute, components] : {std::pair{FLG_ATTRIBUTE_POSITION, 3u},
                                                {FLG_ATTRIBUTE_NORMAL, 3u},
                                                {FLG_ATTRIBUTE_UV, 2u},
                                                {FLG_ATTRIBUTE_WIDTH, 1u}})
        add_ribbon_column(*input, attribute, components, pace.memory());
    float *const positions = input->values[0].data(), *const normals = input->values[1].data(),
                 *const uvs = input->values[2].data(), *const widths = input->values[3].data();
    // Around a closed ribbon a texture fits a whole number of times.
    double per_metre = 1 / (shape.texture_length > 0 ? shape.texture_length : shape.width);
    if (spline->closed && rows.length > 0) per_metre = std::max(std::round(rows.length * per_metre), 1.0) / rows.length;
    co_await each(pace, places.size(), Cost::tens_of_ns, [&](uint32_t v) {
        const uint32_t i = v / across, j = v % across;
        const Vec3 normal = normal_at(ribbon, places, across, v);
        store_vec3(places[v] + shape.height * normal, positions + size_t{3} * v);
        store_vec3(normal, normals + size_t{3} * v);
        uvs[size_t{2} * v] = static_cast<float>(j) / static_cast<float>(shape.columns);
        uvs[size_t{2} * v + 1] = static_cast<float>(rows.rows[i].length * per_metre);
        widths[v] = static_cast<float>(ribbon.rows[i].reach[0] + ribbon.rows[i].reach[1]);
    });
    input->triangles = Buffer<uint32_t>(size_t{3} * input->view.triangle_count, pace.memory());
    co_await each(pace, (count - 1) * shape.columns, Cost::some_ns, [&](uint32_t quad) {
        const uint32_t a = quad / shape.columns * across + quad % shape.columns, b = a + 1, c = b + across,
                       d = a + across;
        const uint32_t corners[] = {a, b, c, a, c, d};
        std::copy_n(corners, 6, &input->triangles[size_t{6} * quad]);
    });
    input->view.columns = input->columns.data();
    input->view.column_count = static_cast<uint32_t>(input->columns.size());
    input->view.triangles = input->triangles.data();
    // One at a time.
    rows.rows = std::pmr::vector<SplineRow>(pace.memory());
    co_await pace;
    ribbon.rows = std::pmr::vector<RibbonRow>(pace.memory());
    co_await pace;
    places = Buffer<Vec3>();
    co_await pace;
    co_await make_surface(pace, std::move(out), std::move(input), -1, false);
}

}  // namespace flg
