// SPDX-License-Identifier: MIT
#include "solids/solid_grid.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>
#include <span>
#include <vector>

#include "runtime/each.h"
#include "solids/solid_steps.h"
#include "surfaces/mesh/mesh_measures.h"

namespace flg {

namespace {

constexpr double coarse_cells = 64;                 // along the diagonal, to look for a mirror plane with
constexpr double most_unlike = 0.03;                // of the area: has no mirror image within two coarse cells
constexpr double sample_spacing = 0.5;              // cells, between samples of a triangle
constexpr uint32_t longest_side = 256, margin = 3;  // cells
constexpr size_t least_piece = 1000;                // of the largest: smaller pieces have no bones
constexpr uint8_t is_inside = 1, is_touched = 2, is_thin = 4;
constexpr uint32_t nowhere = UINT32_MAX;

// Points all over a triangle, row by row.
struct TriangleSamples {
    Vec3 corner, along, across;
    uint32_t rows;

    TriangleSamples(const Mesh& mesh, uint32_t triangle, double spacing) {
        const Triple& t = mesh.triangles[triangle];
        corner = mesh.position(t[0]);
        along = mesh.position(t[1]) - corner;
        across = mesh.position(t[2]) - corner;
        const double longest = std::max({along.norm(), across.norm(), (along - across).norm()});
        rows = static_cast<uint32_t>(std::clamp(std::ceil(longest / spacing), 1.0, 4096.0));
    }
    uint32_t in_row(uint32_t row) const { return rows - row; }
    uint32_t count() const { return rows * (rows + 1) / 2; }
    Vec3 at(uint32_t row, uint32_t i) const {
        const double step = 1.0 / rows;
        return corner + (row + 1 / 3.0) * step * along + (i + 1 / 3.0) * step * across;
    }
};

// visit(point, weight) all over the mesh: the weights of a triangle's points are its area.
template <class Visit>
Task<void> sample_mesh(Pace& pace, const Mesh& mesh, double spacing, Visit visit) {
    Slice slice(Cost::tens_of_ns);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const TriangleSamples samples(mesh, t, spacing);
        const double weight = vector_area(mesh, t).norm() / samples.count();
        for (uint32_t row = 0; row < samples.rows; ++row) {
            for (uint32_t i = 0; i < samples.in_row(row); ++i) visit(samples.at(row, i), weight);
            if (slice.is_over(samples.in_row(row) + 2)) co_await pace;
        }
    }
}

// A coarse lattice along the given axes that knows which cells are near the surface.
struct NearSurface {
    Vec3 low;
    double cell;
    std::array<uint32_t, 3> size;
    Buffer<uint8_t> is_near;

    bool knows(const Vec3& at) const {
        const Vec3 local = (at - low) / cell;
        for (int k = 0; k < 3; ++k)
            if (!(local[k] >= 0) || !(local[k] < size[k])) return false;
        return is_near[(static_cast<size_t>(local.z()) * size[1] + static_cast<size_t>(local.y())) * size[0] +
                       static_cast<size_t>(local.x())] != 0;
    }
};

Task<NearSurface> mark_near_surface(Pace& pace, const Mesh& mesh, const MeshExtent& extent) {
    NearSurface near;
    near.cell = (extent.upper - extent.lower).norm() / coarse_cells;
    near.low = extent.lower - Vec3::Constant(2 * near.cell);
    for (int k = 0; k < 3; ++k)
        near.size[k] = static_cast<uint32_t>((extent.upper[k] - extent.lower[k]) / near.cell) + 5;
    const size_t row = near.size[0], slab = row * near.size[1];
    near.is_near = Buffer<uint8_t>(slab * near.size[2], pace.memory());
    co_await each(pace, near.is_near.size(), Cost::some_ns, [&](uint32_t i) { near.is_near[i] = 0; });
    co_await sample_mesh(pace, mesh, sample_spacing * near.cell, [&](const Vec3& at, double) {
        const Vec3 local = (at - near.low) / near.cell;
        const size_t cell = static_cast<size_t>(local.z()) * slab + static_cast<size_t>(local.y()) * row +
                            static_cast<size_t>(local.x());
        if (near.is_near[cell] == 2) return;
        near.is_near[cell] = 2;
        for (const size_t z : {cell - slab, cell, cell + slab})
            for (const size_t y : {z - row, z, z + row})
                for (const size_t x : {y - 1, y, y + 1})
                    if (near.is_near[x] == 0) near.is_near[x] = 1;
    });
    co_return near;
}

Vec3 reflected(const Vec3& at, const Vec3& normal, const Vec3& through) {
    return at - 2 * normal.dot(at - through) * normal;
}

// A model that is seen from the front faces +z and one seen from the side +x: so its left is +x or -z.
Vec3 towards_left(const Vec3& normal) {
    const Vec3 left = std::abs(normal.x()) >= std::abs(normal.z()) ? Vec3::UnitX() : Vec3(-Vec3::UnitZ());
    const double along = normal.dot(left);
    return along < 0 || (along == 0 && normal.y() < 0) ? Vec3(-normal) : normal;
}

struct Moments {
    double area = 0;
    Vec3 middle = Vec3::Zero();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
};

Task<Moments> surface_moments(Pace& pace, const Mesh& mesh, Vec3 from) {
    Moments moments;
    Vec3 first = Vec3::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        const double area = vector_area(mesh, t).norm();
        Vec3 sum = Vec3::Zero();
        Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
        for (const uint32_t v : mesh.triangles[t]) {
            const Vec3 p = mesh.position(v) - from;
            sum += p;
            squares += p * p.transpose();
        }
        moments.area += area;
        first += area / 3 * sum;
        second += area / 12 * (squares + sum * sum.transpose());
    });
    if (!(moments.area > 0)) {
        moments.middle = from;
        co_return moments;
    }
    const Vec3 mean = first / moments.area;
    moments.middle = from + mean;
    moments.spread = second / moments.area - mean * mean.transpose();
    co_return moments;
}

// A box around the mesh along the axes, from `middle`.
struct Reach {
    Vec3 low, high;
};
Task<Reach> reach_along(Pace& pace, const Mesh& mesh, const SolidFrame& frame) {
    Reach reach{Vec3::Constant(HUGE_VAL), Vec3::Constant(-HUGE_VAL)};
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) {
        const Vec3 local = frame.axes.transpose() * (mesh.position(v) - frame.middle);
        reach.low = reach.low.cwiseMin(local);
        reach.high = reach.high.cwiseMax(local);
    });
    co_return reach;
}

// Which way each piece is wound: 1, or -1 where its normals look inwards.
Task<Buffer<int8_t>> find_windings(Pace& pace, const Mesh& mesh, const MeshComponents& pieces, Vec3 from) {
    Buffer<double> volumes(pieces.count, pace.memory());
    Buffer<int8_t> windings(pieces.count, pace.memory());
    co_await each(pace, pieces.count, Cost::some_ns, [&](uint32_t c) { volumes[c] = 0; });
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) {
        const Triple& corners = mesh.triangles[t];
        const Vec3 a = mesh.position(corners[0]) - from, b = mesh.position(corners[1]) - from,
                   c = mesh.position(corners[2]) - from;
        volumes[pieces.of_vertex[corners[0]]] += a.dot(b.cross(c));
    });
    co_await each(pace, pieces.count, Cost::some_ns, [&](uint32_t c) { windings[c] = volumes[c] < 0 ? -1 : 1; });
    co_return windings;
}

// Crossings of a triangle with lines along an axis through middles of cells.
class Crossings {
public:
    Crossings(SolidGrid& grid, Buffer<int32_t>& sums, uint32_t axis)
        : sums_(sums), axis_(axis), b_((axis + 1) % 3), c_((axis + 2) % 3), size_(grid.size) {
        const uint32_t strides[] = {1, size_[0], size_[0] * size_[1]};
        stride_ = strides[axis_];
        stride_b_ = strides[b_];
        stride_c_ = strides[c_];
    }

    // Returns the rows that it may cross.
    std::array<uint32_t, 2> begin(const Vec3& p, const Vec3& q, const Vec3& r, int32_t winding) {
        corners_[0] = p, corners_[1] = q, corners_[2] = r;
        normal_ = (q - p).cross(r - p);
        step_ = normal_[axis_] < 0 ? winding : -winding;
        if (normal_[axis_] == 0) return {0, 0};
        return rows_between(std::min({p[c_], q[c_], r[c_]}), std::max({p[c_], q[c_], r[c_]}), size_[c_]);
    }
    // Returns how many lines it looked at.
    uint32_t cross_row(uint32_t row) {
        const double low = std::min({corners_[0][b_], corners_[1][b_], corners_[2][b_]}),
                     high = std::max({corners_[0][b_], corners_[1][b_], corners_[2][b_]});
        const auto [from, to] = rows_between(low, high, size_[b_]);
        for (uint32_t column = from; column < to; ++column) cross(column, row);
        return to - from;
    }

private:
    static std::array<uint32_t, 2> rows_between(double low, double high, uint32_t size) {
        const double from = std::max(0.0, std::ceil(low - 0.5)), to = std::floor(high - 0.5) + 1;
        if (!(from < to)) return {0, 0};
        return {static_cast<uint32_t>(from), static_cast<uint32_t>(std::min<double>(to, size))};
    }
    // Both triangles of an edge find the same number, with opposite signs; on the edge it is one of them that counts.
    bool is_left(const Vec3& from, const Vec3& to, double x, double y) const {
        const bool is_turned = to[b_] < from[b_] || (to[b_] == from[b_] && to[c_] < from[c_]);
        const Vec3 &a = is_turned ? to : from, &b = is_turned ? from : to;
        const double across = (b[b_] - a[b_]) * (y - a[c_]) - (b[c_] - a[c_]) * (x - a[b_]);
        return (across >= 0) != is_turned;
    }
    void cross(uint32_t column, uint32_t row) {
        const double x = column + 0.5, y = row + 0.5;
        const bool first = is_left(corners_[0], corners_[1], x, y);
        if (is_left(corners_[1], corners_[2], x, y) != first || is_left(corners_[2], corners_[0], x, y) != first)
            return;
        const double off = normal_[b_] * (x - corners_[0][b_]) + normal_[c_] * (y - corners_[0][c_]);
        const double at = corners_[0][axis_] - off / normal_[axis_];
        const auto cell = static_cast<uint32_t>(std::clamp(std::ceil(at - 0.5), 0.0, size_[axis_] - 1.0));
        sums_[cell * stride_ + column * stride_b_ + row * stride_c_] += step_;
    }

    Buffer<int32_t>& sums_;
    uint32_t axis_, b_, c_, stride_, stride_b_, stride_c_;
    std::array<uint32_t, 3> size_;
    Vec3 corners_[3], normal_;
    int32_t step_ = 0;
};

// Adds to each cell what the rays along an axis count, both ways.
Task<void> count_along(Pace& pace, const Mesh& mesh, SolidGrid& grid, const MeshComponents& pieces,
                       const Buffer<int8_t>& windings, uint32_t axis, Buffer<int16_t>& votes) {
    const auto count = static_cast<uint32_t>(grid.count());
    Buffer<int32_t> sums(count, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { sums[i] = 0; });
    Crossings crossings(grid, sums, axis);
    Slice slice(Cost::tens_of_ns);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Triple& corners = mesh.triangles[t];
        const auto [from, to] =
            crossings.begin(grid.local(mesh.position(corners[0])), grid.local(mesh.position(corners[1])),
                            grid.local(mesh.position(corners[2])), windings[pieces.of_vertex[corners[0]]]);
        if (slice.is_over(4)) co_await pace;
        for (uint32_t row = from; row < to; ++row)
            if (slice.is_over(1 + crossings.cross_row(row))) co_await pace;
    }
    const uint32_t strides[] = {1, grid.size[0], grid.size[0] * grid.size[1]};
    const uint32_t stride = strides[axis], length = grid.size[axis];
    co_await each_by_work(pace, count / length, Cost::some_ns, [&](uint32_t line) {
        const uint32_t first = line % stride + line / stride * stride * length;
        int32_t total = 0;
        for (uint32_t i = 0; i < length; ++i) total += sums[first + i * stride];
        int32_t below = 0;
        for (uint32_t i = 0; i < length; ++i) {
            below += sums[first + i * stride];
            votes[first + i * stride] =
                static_cast<int16_t>(std::clamp(votes[first + i * stride] + 2 * below - total, -30000, 30000));
        }
        return 2 * length;
    });
    sums = {};
    co_await pace;
}

// Cells that are not on the lattice's faces.
bool is_within(const SolidGrid& grid, uint32_t number) {
    const auto place = grid.place(number);
    for (int k = 0; k < 3; ++k)
        if (place[k] == 0 || place[k] + 1 == grid.size[k]) return false;
    return true;
}

// Where the mesh is thinner than a cell what it passes through is inside, with what joins that to the rest.
Task<void> keep_thin(Pace& pace, const Mesh& mesh, SolidGrid& grid) {
    co_await sample_mesh(pace, mesh, sample_spacing * grid.cell, [&](const Vec3& at, double) {
        const Vec3 local = grid.local(at);
        grid.inside[grid.number(static_cast<uint32_t>(local.x()), static_cast<uint32_t>(local.y()),
                                static_cast<uint32_t>(local.z()))] |= is_touched;
    });
    const SolidSteps steps(grid);
    const auto any_around = [&](uint32_t i, uint8_t what) {
        return std::any_of(steps.cells.begin(), steps.cells.end(),
                           [&](int32_t step) { return (grid.inside[i + step] & what) != 0; });
    };
    const auto count = static_cast<uint32_t>(grid.count());
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        if (grid.inside[i] == is_touched && is_within(grid, i) && !any_around(i, is_inside)) grid.inside[i] |= is_thin;
    });
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const bool joins = grid.inside[i] == is_touched && is_within(grid, i) && any_around(i, is_thin);
        if (joins) grid.inside[i] |= is_inside;
    });
    co_await each(pace, count, Cost::some_ns,
                  [&](uint32_t i) { grid.inside[i] = (grid.inside[i] & (is_inside | is_thin)) != 0; });
}

// One line of squared distances to the nearest zero, in place.
class LineTransform {
public:
    LineTransform(uint32_t longest, Memory* memory)
        : values_(longest, memory), borders_(longest + size_t{1}, memory), tops_(longest, memory) {}

    void run(float* line, uint32_t stride, uint32_t length) {
        for (uint32_t i = 0; i < length; ++i) values_[i] = line[size_t{i} * stride];
        uint32_t last = 0;
        tops_[0] = 0;
        borders_[0] = -HUGE_VALF;
        borders_[1] = HUGE_VALF;
        const auto meet = [&](uint32_t a, uint32_t b) {
            const auto x = static_cast<float>(a), y = static_cast<float>(b);
            return ((values_[b] + y * y) - (values_[a] + x * x)) / (2 * (y - x));
        };
        for (uint32_t i = 1; i < length; ++i) {
            float border = meet(tops_[last], i);
            while (border <= borders_[last]) border = meet(tops_[--last], i);
            tops_[++last] = i;
            borders_[last] = border;
            borders_[last + 1] = HUGE_VALF;
        }
        uint32_t top = 0;
        for (uint32_t i = 0; i < length; ++i) {
            while (borders_[top + 1] < static_cast<float>(i)) ++top;
            const float off = static_cast<float>(i) - static_cast<float>(tops_[top]);
            line[size_t{i} * stride] = off * off + values_[tops_[top]];
        }
    }

private:
    Buffer<float> values_, borders_;
    Buffer<uint32_t> tops_;
};

}  // namespace

Task<SolidFrame> find_solid_frame(Pace& pace, const Mesh& mesh) {
    pace.stage("symmetry");
    const MeshExtent extent = co_await measure_extent(pace, mesh);
    const Moments moments = co_await surface_moments(pace, mesh, 0.5 * (extent.lower + extent.upper));
    SolidFrame frame;
    frame.middle = moments.middle;
    if (!(moments.area > 0)) co_return frame;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(moments.spread);
    frame.axes = principal.eigenvectors();
    frame.axes.col(2) = frame.axes.col(0).cross(frame.axes.col(1));

    const NearSurface near = co_await mark_near_surface(pace, mesh, extent);
    std::array<Vec3, 6> normals = {Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()};
    for (int k = 0; k < 3; ++k) normals[k + 3] = frame.axes.col(k);
    std::array<double, 6> unlike{};
    co_await sample_mesh(pace, mesh, near.cell, [&](const Vec3& at, double weight) {
        for (size_t k = 0; k < normals.size(); ++k)
            if (!near.knows(reflected(at, normals[k], moments.middle))) unlike[k] += weight;
    });
    size_t best = 0;
    for (size_t k = 1; k < normals.size(); ++k)
        if (unlike[k] < unlike[best]) best = k;
    if (unlike[best] <= most_unlike * moments.area) {
        const Vec3 normal = towards_left(normals[best]);
        const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity() - normal * normal.transpose();
        principal.compute(flat * moments.spread * flat);
        frame.is_mirrored = true;
        frame.axes.col(0) = normal;
        frame.axes.col(1) = (flat * principal.eigenvectors().col(2)).normalized();
        frame.axes.col(2) = normal.cross(frame.axes.col(1));
    }
    const Reach reach = co_await reach_along(pace, mesh, frame);
    Vec3 shift = 0.5 * (reach.low + reach.high);
    if (frame.is_mirrored) shift.x() = 0;
    frame.middle += frame.axes * shift;
    co_return frame;
}

Task<SolidGrid> fill_solid(Pace& pace, const Mesh& mesh, SolidFrame frame, uint32_t cells) {
    pace.stage("solid");
    const Reach reach = co_await reach_along(pace, mesh, frame);
    const Vec3 extent = 2 * reach.high.cwiseAbs().cwiseMax(reach.low.cwiseAbs());
    SolidGrid grid;
    grid.frame = frame;
    grid.cell = std::max(std::cbrt(extent.prod() / cells), extent.maxCoeff() / longest_side);
    if (!(grid.cell > 0)) grid.cell = 1;
    for (int k = 0; k < 3; ++k)
        grid.size[k] = 2 * (static_cast<uint32_t>(std::ceil(0.5 * extent[k] / grid.cell)) + margin);
    const size_t count = size_t{grid.size[0]} * grid.size[1] * grid.size[2];
    grid.inside = Buffer<uint8_t>(count, pace.memory());
    const MeshComponents pieces = co_await find_components(pace, mesh);
    const Buffer<int8_t> windings = co_await find_windings(pace, mesh, pieces, frame.middle);
    Buffer<int16_t> votes(count, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { votes[i] = 0; });
    for (uint32_t axis = 0; axis < 3; ++axis) co_await count_along(pace, mesh, grid, pieces, windings, axis, votes);
    constexpr int16_t half_of_six = 3;
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { grid.inside[i] = votes[i] >= half_of_six; });
    votes = {};
    co_await pace;
    co_await keep_thin(pace, mesh, grid);
    if (frame.is_mirrored) {
        co_await each(pace, size_t{grid.size[1]} * grid.size[2], Cost::tens_of_ns, [&](uint32_t line) {
            uint8_t* const row = grid.inside.data() + size_t{line} * grid.size[0];
            for (uint32_t i = 0, k = grid.size[0] - 1; i < k; ++i, --k) row[i] = row[k] = row[i] | row[k];
        });
    }
    co_return grid;
}

Task<Buffer<float>> solid_depths(Pace& pace, const SolidGrid& grid) {
    pace.stage("depth");
    constexpr float far = 1e12f;
    Buffer<float> depths(grid.count(), pace.memory());
    co_await each(pace, grid.count(), Cost::some_ns, [&](uint32_t i) { depths[i] = grid.inside[i] ? far : 0; });
    LineTransform transform(*std::max_element(grid.size.begin(), grid.size.end()), pace.memory());
    const uint32_t strides[] = {1, grid.size[0], grid.size[0] * grid.size[1]};
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const uint32_t stride = strides[axis], length = grid.size[axis];
        co_await each(pace, grid.count() / length, Cost::microseconds, [&](uint32_t line) {
            transform.run(depths.data() + line % stride + size_t{line / stride} * stride * length, stride, length);
        });
    }
    co_await each(pace, grid.count(), Cost::some_ns,
                  [&](uint32_t i) { depths[i] = std::max(0.0f, std::sqrt(depths[i]) - 0.5f); });
    co_return depths;
}

Task<void> join_solid_pieces(Pace& pace, SolidGrid& grid) {
    const SolidSteps steps(grid);
    const auto count = static_cast<uint32_t>(grid.count());
    Buffer<uint32_t> piece_of(count, pace.memory()), cells(count, pace.memory());  // cells: piece by piece
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { piece_of[i] = nowhere; });
    std::pmr::vector<uint32_t> begins(pace.memory());
    Slice slice(Cost::some_ns);
    uint32_t found = 0;
    for (uint32_t i = 0; i < count; ++i) {
        if (slice.is_over()) co_await pace;
        if (!grid.inside[i] || piece_of[i] != nowhere) continue;
        const auto number = static_cast<uint32_t>(begins.size());
        begins.push_back(found);
        piece_of[i] = number;
        cells[found] = i;
        uint32_t next = found++;
        for (; next < found; ++next) {
            const uint32_t from = cells[next];
            for (const int32_t step : steps.cells) {
                const uint32_t to = from + step;
                if (!grid.inside[to] || piece_of[to] != nowhere) continue;
                piece_of[to] = number;
                cells[found++] = to;
            }
            if (slice.is_over(26)) co_await pace;
        }
    }
    if (begins.size() < 2) {
        cells = {};
        co_await pace;
        co_return;
    }
    begins.push_back(found);
    const auto cells_of = [&](size_t piece) {
        return std::span<const uint32_t>(cells.data() + begins[piece], begins[piece + 1] - begins[piece]);
    };
    const size_t piece_count = begins.size() - 1;
    // From the largest piece outwards; what is reached is joined and goes on outwards (Prim).
    struct Entry {
        float way;
        uint32_t cell;
        bool operator<(const Entry& other) const { return way != other.way ? way > other.way : cell > other.cell; }
    };
    std::priority_queue<Entry, std::pmr::deque<Entry>> queue(std::less<Entry>(), std::pmr::deque<Entry>(pace.memory()));
    Buffer<float> ways(count, pace.memory());
    Buffer<uint32_t> from_cell(count, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { ways[i] = HUGE_VALF; });
    std::pmr::vector<bool> is_joined(piece_count, false, pace.memory());
    size_t left = 0, largest = 0;
    for (size_t p = 1; p < piece_count; ++p)
        if (cells_of(p).size() > cells_of(largest).size()) largest = p;
    for (size_t p = 0; p < piece_count; ++p) {
        if (cells_of(p).size() * least_piece >= cells_of(largest).size()) {
            ++left;
            continue;
        }
        for (const uint32_t cell : cells_of(p)) {
            grid.inside[cell] = 0;
            piece_of[cell] = nowhere;
            if (slice.is_over()) co_await pace;
        }
    }
    for (size_t joining = largest; joining != nowhere;) {
        is_joined[joining] = true;
        --left;
        for (const uint32_t cell : cells_of(joining)) {
            ways[cell] = 0;
            from_cell[cell] = nowhere;
            queue.push({0, cell});
            if (slice.is_over(32)) co_await pace;
        }
        joining = nowhere;
        while (left > 0 && joining == nowhere && !queue.empty()) {
            const Entry entry = queue.top();
            queue.pop();
            if (slice.is_over(64)) co_await pace;
            if (entry.way > ways[entry.cell]) continue;
            if (piece_of[entry.cell] != nowhere && !is_joined[piece_of[entry.cell]]) {
                joining = piece_of[entry.cell];
                for (uint32_t c = from_cell[entry.cell]; c != nowhere; c = from_cell[c]) grid.inside[c] = 1;
                continue;
            }
            if (!is_within(grid, entry.cell)) continue;
            for (size_t k = 0; k < steps.cells.size(); ++k) {
                const uint32_t to = entry.cell + steps.cells[k];
                const float way = entry.way + steps.lengths[k];
                if (way >= ways[to]) continue;
                ways[to] = way;
                from_cell[to] = entry.cell;
                queue.push({way, to});
            }
        }
    }
    // Large arrays are given back one by one.
    ways = {};
    co_await pace;
    from_cell = {};
    co_await pace;
    cells = {};
    co_await pace;
}

}  // namespace flg
