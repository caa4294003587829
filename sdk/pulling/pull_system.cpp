// SPDX-License-Identifier: MIT
#include "pulling/pull_system.h"

#include <algorithm>
#include <cmath>

#include "inflation/mesh_laplacian.h"
#include "linear/dissection_order.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr double least_weight = 1e-3;
constexpr double drawn_back = 1e-9;  // of what an even mesh has on its diagonal
constexpr double even_diagonal = 3.5;
constexpr double least_height = 1e-6;  // of a triangle's sides: what it has at least
constexpr uint32_t width = 4, most_columns = 4;

// Columns that follow each other and have the same rows below (as sparse_cholesky.h has them) are taken up to four at
// once: each row is loaded once for all of them.
class PointSolver {
public:
    PointSolver(const CholeskyFactor& factor, double* values)
        : offsets_(factor.offsets.data()),
          rows_(factor.rows.data()),
          entries_(factor.values.data()),
          inverses_(factor.inverses.data()),
          size_(factor.size()),
          values_(values) {}

    // From a column on, so many entries or a few more. Returns the column that comes next.
    [[gnu::noinline]] uint32_t forward_from(uint32_t column, uint32_t entries) const {
        for (uint32_t done = 0; column < size_ && done < entries;) done += take_forward(column);
        return column;
    }
    // Likewise before a column.
    [[gnu::noinline]] uint32_t backward_from(uint32_t column, uint32_t entries) const {
        for (uint32_t done = 0; column > 0 && done < entries;) done += take_backward(column);
        return column;
    }

private:
    // Moves a column behind those that were taken; returns how many entries these have.
    uint32_t take_forward(uint32_t& column) const {
        const uint32_t first = column;
        while (++column < size_ && column < first + most_columns && goes_on(column)) {}
        switch (column - first) {
            case 1: forward<1>(first); break;
            case 2: forward<2>(first); break;
            case 3: forward<3>(first); break;
            default: forward<4>(first); break;
        }
        return static_cast<uint32_t>(offsets_[column] - offsets_[first]);
    }
    // Moves it to the first of those that were taken.
    uint32_t take_backward(uint32_t& column) const {
        const uint32_t end = column;
        while (--column > 0 && end - column < most_columns && goes_on(column)) {}
        switch (end - column) {
            case 1: backward<1>(column); break;
            case 2: backward<2>(column); break;
            case 3: backward<3>(column); break;
            default: backward<4>(column); break;
        }
        return static_cast<uint32_t>(offsets_[end] - offsets_[column]);
    }

    using Pair = double __attribute__((vector_size(16), may_alias));
    struct Point {
        Pair low, high;
        Point& operator-=(const Point& other) {
            low -= other.low;
            high -= other.high;
            return *this;
        }
        Point operator*(double scale) const { return {low * scale, high * scale}; }
        Point operator+(const Point& other) const { return {low + other.low, high + other.high}; }
    };
    Point load(uint32_t row) const {
        const auto* const from = reinterpret_cast<const Pair*>(values_ + size_t{width} * row);
        return {from[0], from[1]};
    }
    void store(uint32_t row, const Point& point) const {
        auto* const to = reinterpret_cast<Pair*>(values_ + size_t{width} * row);
        to[0] = point.low;
        to[1] = point.high;
    }

    // Whether a column has the rows of the one before, but for that one's own.
    bool goes_on(uint32_t column) const {
        const size_t before = offsets_[column] - offsets_[column - 1];
        return before == offsets_[column + 1] - offsets_[column] + 1 && rows_[offsets_[column - 1] + 1] == column;
    }
    // In column `first + of` the entry of row `first + row`.
    double within(uint32_t first, uint32_t row, uint32_t of) const {
        return entries_[offsets_[first + of] + (row - of)];
    }

    template <uint32_t count>
    void forward(uint32_t first) const {
        Point own[count];
        const double* below[count];
        for (uint32_t m = 0; m < count; ++m) {
            own[m] = load(first + m);
            for (uint32_t k = 0; k < m; ++k) own[m] -= own[k] * within(first, m, k);
            own[m] = own[m] * inverses_[first + m];
            store(first + m, own[m]);
            below[m] = entries_ + offsets_[first + m] + (count - m);
        }
        const uint32_t last = first + count - 1;
        const uint32_t* const rows = rows_ + offsets_[last] + 1;
        const size_t left = offsets_[last + 1] - offsets_[last] - 1;
        for (size_t p = 0; p < left; ++p) {
            Point sum = own[0] * below[0][p];
            for (uint32_t m = 1; m < count; ++m) sum = sum + own[m] * below[m][p];
            Point to = load(rows[p]);
            to -= sum;
            store(rows[p], to);
        }
    }

    template <uint32_t count>
    void backward(uint32_t first) const {
        Point own[count];
        const double* below[count];
        for (uint32_t m = 0; m < count; ++m) {
            own[m] = load(first + m);
            below[m] = entries_ + offsets_[first + m] + (count - m);
        }
        const uint32_t last = first + count - 1;
        const uint32_t* const rows = rows_ + offsets_[last] + 1;
        const size_t left = offsets_[last + 1] - offsets_[last] - 1;
        for (size_t p = 0; p < left; ++p) {
            const Point from = load(rows[p]);
            for (uint32_t m = 0; m < count; ++m) own[m] -= from * below[m][p];
        }
        for (uint32_t m = count; m-- > 0;) {
            for (uint32_t k = m + 1; k < count; ++k) own[m] -= own[k] * within(first, k, m);
            own[m] = own[m] * inverses_[first + m];
            store(first + m, own[m]);
        }
    }

    const size_t* offsets_;
    const uint32_t* rows_;
    const double *entries_, *inverses_;
    uint32_t size_;
    double* values_;
};

}  // namespace

Task<PullSystem> make_pull_system(Pace& pace, const Mesh& mesh) {
    pace.stage("factor");
    Memory* const memory = pace.memory();
    const uint32_t vertices = mesh.vertex_count(), triangles = mesh.triangle_count();
    Buffer<std::array<double, 3>> cotangents(triangles, memory);
    Buffer<double> masses(vertices, memory);
    Buffer<Vec3> places(vertices, memory);
    Vec3 low = Vec3::Constant(HUGE_VAL), high = -low;
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
        masses[v] = 0;
        std::construct_at(&places[v], mesh.position(v));
        low = low.cwiseMin(places[v]);
        high = high.cwiseMax(places[v]);
    });
    double area = 0;
    co_await each(pace, triangles, Cost::tens_of_ns, [&](uint32_t t) {
        const Triple& corners = mesh.triangles[t];
        const Vec3 p[3] = {places[corners[0]], places[corners[1]], places[corners[2]]};
        const Vec3 a = p[1] - p[0], b = p[2] - p[0];
        const double twice = std::max(a.cross(b).norm(), least_height * (a.squaredNorm() + b.squaredNorm()));
        area += twice;
        for (uint32_t k = 0; k < 3; ++k) {
            const double dot = (p[(k + 1) % 3] - p[k]).dot(p[(k + 2) % 3] - p[k]);
            cotangents[t][k] = twice > 0 ? 0.5 * dot / twice : 0;
            masses[corners[k]] += twice;
        }
    });
    const double scale = area > 0 ? drawn_back * even_diagonal * vertices / (3 * area) : 1;
    co_await each(pace, vertices, Cost::some_ns,
                  [&](uint32_t v) { masses[v] = std::max(masses[v] * scale, 1e-3 * drawn_back * even_diagonal); });
    const LaplacianInput input{.triangles = {mesh.triangles.data(), triangles},
                               .cotangents = {cotangents.data(), triangles},
                               .row_count = vertices,
                               .mass = {masses.data(), vertices},
                               .min_weight = least_weight};
    SymmetricMatrix matrix = co_await mesh_laplacian(pace, input);
    Buffer<uint32_t> order = co_await dissection_order(pace, matrix, {places.data(), vertices});
    PullSystem system;
    system.place_of = Buffer<uint32_t>(vertices, memory);
    system.masses = Buffer<double>(vertices, memory);
    system.rest = Buffer<Vec3>(vertices, memory);
    system.size = vertices > 0 ? (high - low).norm() : 0;
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t i) {
        std::construct_at(&system.rest[i], places[order[i]]);
        system.place_of[order[i]] = i;
        system.masses[i] = masses[order[i]];
    });
    const uint32_t entries = matrix.offsets[vertices];
    system.offsets = Buffer<uint32_t>(vertices + size_t{1}, memory);
    system.neighbours = Buffer<uint32_t>(entries, memory);
    system.weights = Buffer<float>(entries, memory);
    uint32_t written = 0;
    system.offsets[0] = 0;
    co_await each_by_work(pace, vertices, Cost::some_ns, [&](uint32_t i) {
        const uint32_t begin = matrix.offsets[order[i]], end = matrix.offsets[order[i] + 1];
        for (uint32_t e = begin; e < end; ++e, ++written) {
            system.neighbours[written] = system.place_of[matrix.columns[e]];
            system.weights[written] = static_cast<float>(-matrix.values[e]);
        }
        system.offsets[i + 1] = written;
        return 1 + end - begin;
    });
    system.factor = co_await factorize(pace, matrix, std::move(order));
    matrix.values = {};
    co_await pace;
    co_return system;
}

Task<void> solve_points(Pace& pace, const CholeskyFactor& factor, std::span<double> values) {
    const uint32_t size = factor.size();
    const PointSolver solver(factor, values.data());
    constexpr auto slice = static_cast<uint32_t>(Cost::some_ns);  // entries
    // L y = b
    for (uint32_t column = 0; column < size;) {
        column = solver.forward_from(column, slice);
        co_await pace;
    }
    // L' x = y
    for (uint32_t column = size; column > 0;) {
        column = solver.backward_from(column, slice);
        co_await pace;
    }
}

}  // namespace flg
