// SPDX-License-Identifier: MIT
// From ten drawn parts to one skinned surface of 10,000 vertices, step by step, and its Cholesky factorization against
// Eigen's.
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <deque>
#include <numbers>

#include "bench/groups.h"
#include "bench/pool.h"
#include "inflation/bone_weights.h"
#include "inflation/inflate_part.h"
#include "inflation/merge_parts.h"
#include "linear/dissection_order.h"
#include "linear/sparse_cholesky.h"
#include "runtime/run_now.h"

namespace flg::bench {
namespace {

constexpr int kInflationRuns = 7;
constexpr double kInflateMs = 40, kMergeMs = 120, kWeightsMs = 100, kAllMs = 500, kChunkUs = 100;

using Ring = std::vector<Point2>;

Memory* memory() {
    static Pool pool;
    static HostMemory memory(pool.hooks());
    return &memory;
}

// A drawn line around a way with radii, of `n` points, a little off.
Ring around(double length, double from, double to, double bend, uint32_t n) {
    Ring ring;
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n,
                     wave = 1 + 0.03 * std::sin(5 * angle) + 0.01 * std::sin(17 * angle);
        const double along = length / 2 * std::cos(angle), share = 0.5 + 0.5 * std::cos(angle);
        const double across =
            (from + share * (to - from)) * std::sin(angle) / std::max(0.6, std::sqrt(std::fabs(std::sin(angle))));
        ring.push_back({wave * along, wave * across + bend * along * along});
    }
    return ring;
}

std::array<double, 12> placed(double x, double y, double z, double turn, double lean, bool mirrored) {
    Eigen::Matrix3d m =
        (Eigen::AngleAxisd(lean, Vec3::UnitX()) * Eigen::AngleAxisd(turn, Vec3::UnitZ())).toRotationMatrix();
    if (mirrored) m.col(2) *= -1;
    return {m(0, 0), m(0, 1), m(0, 2), x, m(1, 0), m(1, 1), m(1, 2), y, m(2, 0), m(2, 1), m(2, 2), z};
}

struct Animal {
    std::vector<Contour> contours;
    std::deque<InflatedPart> shapes;
    std::vector<PlacedPart> parts;
    std::vector<BoneSegment> bones;

    void add(const Ring& ring, const std::array<double, 12>& place, double thickness, double length, uint32_t count,
             double radius) {
        const uint32_t offsets[] = {0, static_cast<uint32_t>(ring.size())};
        contours.push_back(clean_contour(ring, offsets, memory()));
        shapes.emplace_back(memory()).contour = contours.back();
        const auto part = static_cast<uint32_t>(parts.size());
        parts.push_back({&shapes.back(), place, thickness});
        const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> m(place.data());
        for (uint32_t i = 0; i < count; ++i) {
            const auto at = [&](uint32_t k) -> Vec3 {
                return m * Vec3(length * (0.9 * k / count - 0.45), 0, 0).homogeneous();
            };
            bones.push_back({at(i), at(i + 1), radius, radius, static_cast<uint32_t>(bones.size()), part});
        }
    }
};

// Body, neck, head, snout, ear, four legs, tail.
Animal animal() {
    constexpr double down = -std::numbers::pi / 2;
    Animal all;
    all.add(around(3.2, 0.75, 0.65, 0, 300), placed(0, 0, 0, 0, 0, false), 0.9, 3.2, 4, 0.7);
    all.add(around(1.4, 0.4, 0.3, 0, 250), placed(1.7, 0.6, 0, 0.8, 0, false), 0.8, 1.4, 2, 0.35);
    all.add(around(1.1, 0.5, 0.45, 0, 260), placed(2.4, 1.2, 0, 0.2, 0, false), 0.95, 1.1, 2, 0.45);
    all.add(around(0.7, 0.25, 0.2, 0, 160), placed(3.0, 1.25, 0, 0, 0, false), 0.8, 0.7, 1, 0.2);
    all.add(around(0.7, 0.16, 0.06, 0.1, 140), placed(2.2, 1.9, 0.15, 1.8, 0.3, false), 0.7, 0.7, 2, 0.1);
    for (const double x : {1.0, -1.1})
        for (const double z : {0.35, -0.35})
            all.add(around(1.8, 0.3, 0.18, 0.03, 255), placed(x, -0.9, z, down, z > 0 ? -0.1 : 0.1, z < 0), 0.75, 1.8,
                    4, 0.22);
    all.add(around(2.0, 0.15, 0.08, 0.15, 220), placed(-2.2, 0.6, 0, 2.5, 0, false), 0.71, 2.0, 6, 0.11);
    return all;
}

// The duration of each slice, the shortest of several runs, in which slices are the same: what the machine does
// meanwhile falls out.
class Slices {
public:
    template <class Make>
    auto run(const Make& make) {
        using Clock = std::chrono::steady_clock;
        return run_haltingly(memory(), make, [this](const auto& slice) {
            const auto begin = Clock::now();
            slice();
            const double us = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
            if (at_ == shortest_.size()) shortest_.push_back(us);
            shortest_[at_] = std::min(shortest_[at_], us);
            ++at_;
        });
    }
    void begin_run() { at_ = 0; }
    double max_us() const { return *std::max_element(shortest_.begin(), shortest_.end()); }

private:
    std::vector<double> shortest_;
    size_t at_ = 0;
};

void inflate(Animal& all, Slices& slices) {
    for (size_t i = 0; i < all.shapes.size(); ++i) {
        InflatedPart& part = all.shapes[i] = InflatedPart(memory());
        part.contour = all.contours[i];
        slices.run([&](Pace& pace) { return inflate_part(pace, {}, part); });
    }
}

struct Times {
    double ours, eigen;
};

// The matrix that weights are solved with, of the surface without areas and reach: its pattern is what counts.
std::vector<Row> cholesky_rows(const MergedMesh& mesh) {
    const auto n = static_cast<uint32_t>(mesh.positions.size());
    std::vector<std::array<double, 3>> cotangents(mesh.triangles.size(), {0.29, 0.29, 0.29});
    std::vector<double> mass(n, 0.05);
    const LaplacianInput input{.triangles = {mesh.triangles.data(), mesh.triangles.size()},
                               .cotangents = cotangents,
                               .row_count = n,
                               .mass = mass};
    const SymmetricMatrix matrix = run_now(memory(), [&](Pace& pace) { return mesh_laplacian(pace, input); });
    std::vector<Eigen::Triplet<double>> entries;
    for (uint32_t i = 0; i < n; ++i) {
        entries.emplace_back(i, i, matrix.diagonal[i]);
        for (uint32_t e = matrix.offsets[i]; e < matrix.offsets[i + 1]; ++e)
            entries.emplace_back(i, matrix.columns[e], matrix.values[e]);
    }
    Eigen::SparseMatrix<double> sparse(n, n);
    sparse.setFromTriplets(entries.begin(), entries.end());
    std::vector<double> factor_ratios, solve_ratios, factor_ms;
    size_t ours_entries = 0;
    Eigen::Index eigen_entries = 0;
    for (int k = 0; k < kInflationRuns; ++k) {
        CholeskyFactor ours;
        std::optional<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>> eigen;
        const double ours_ms = time_ms([&] {
            Buffer<uint32_t> order = run_now(memory(), [&](Pace& pace) {
                return dissection_order(pace, matrix, {mesh.positions.data(), n});
            });
            ours = run_now(memory(), [&](Pace& pace) { return factorize(pace, matrix, std::move(order)); });
        });
        factor_ms.push_back(ours_ms);
        factor_ratios.push_back(time_ms([&] { eigen.emplace(sparse); }) / ours_ms);
        std::vector<double> values(size_t{solve_width} * n, 1.0);
        const double solve_ms =
            time_ms([&] { run_now(memory(), [&](Pace& pace) { return solve(pace, ours, values); }); });
        Eigen::MatrixXd right = Eigen::MatrixXd::Ones(n, solve_width);
        solve_ratios.push_back(time_ms([&] { right = eigen->solve(right).eval(); }) / solve_ms);
        ours_entries = ours.entries();
        eigen_entries = eigen->matrixL().nestedExpression().nonZeros();
    }
    char note[120];
    std::snprintf(note, sizeof note, "order and factor %.1f ms; %zu entries, theirs %td", median(factor_ms),
                  ours_entries, eigen_entries);
    return {at_least("cholesky of 10,000 vertices, times as fast as Eigen's SimplicialLLT", median(factor_ratios), "x",
                     1, note),
            at_least("solving for eight sides, times as fast as Eigen's", median(solve_ratios), "x", 1)};
}

}  // namespace

std::vector<Row> run_inflation() {
    Animal all = animal();
    Slices inflating, merging, weighing;
    std::vector<double> inflate_ms, merge_ms, weights_ms, sum_ms;
    std::optional<MergedMesh> kept;
    size_t plane_vertices = 0;
    for (int k = 0; k < kInflationRuns; ++k) {
        for (Slices* slices : {&inflating, &merging, &weighing}) slices->begin_run();
        MergedMesh& mesh = kept.emplace();
        BoneWeights weights;
        inflate_ms.push_back(time_ms([&] { inflate(all, inflating); }));
        merge_ms.push_back(
            time_ms([&] { mesh = merging.run([&](Pace& pace) { return merge_parts(pace, all.parts, {}); }); }));
        weights_ms.push_back(time_ms([&] {
            weights = weighing.run([&](Pace& pace) { return bone_weights(pace, mesh, all.parts, {all.bones}, {}); });
        }));
        sum_ms.push_back(inflate_ms.back() + merge_ms.back() + weights_ms.back());
    }
    for (const InflatedPart& part : all.shapes) plane_vertices += part.points.size();
    char inflated[80], merged[80], weighed[80];
    std::snprintf(inflated, sizeof inflated, "%zu vertices in their planes; longest slice %.0f us", plane_vertices,
                  inflating.max_us());
    std::snprintf(merged, sizeof merged, "%zu vertices; longest slice %.0f us", kept->positions.size(),
                  merging.max_us());
    std::snprintf(weighed, sizeof weighed, "%zu joints; longest slice %.0f us", all.bones.size(), weighing.max_us());
    const double longest = std::max({inflating.max_us(), merging.max_us(), weighing.max_us()});
    std::vector<Row> rows = {
        below("inflate: ten drawn parts", median(inflate_ms), "ms", kInflateMs, inflated),
        below("merge: them to one surface", median(merge_ms), "ms", kMergeMs, merged),
        below("weights: for its joints", median(weights_ms), "ms", kWeightsMs, weighed),
        below("drawn parts to a skinned surface, in all", median(sum_ms), "ms", kAllMs),
        below("the longest slice of these", longest, "us", kChunkUs, "each the shortest of seven runs")};
    for (Row& row : cholesky_rows(*kept)) rows.push_back(std::move(row));
    return rows;
}

}  // namespace flg::bench
