// SPDX-License-Identifier: MIT
#include "bench/curve_analogies.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace flg::bench {
namespace {

// The continuation is taken when its error is at most 1 + this times the best one's (kappa of the analogies papers).
constexpr double kCoherence = 1.0;
// Candidates whose covariances are made together: nine sums of two doubles fill the registers.
constexpr uint32_t kLanes = 2;

using Lanes = Eigen::Array<double, kLanes, 1>;

// Points of a curve by column, and sums of all before each: a window's sums are differences.
struct Columns {
    std::array<std::vector<double>, 3> of;
    std::array<std::vector<double>, 3> sum;
    std::vector<double> square_sum;

    Columns(const std::vector<Vec3>& points, const Vec3& origin) : square_sum(points.size() + 1) {
        for (int a = 0; a < 3; ++a) {
            of[a].resize(points.size() + kLanes);  // the last candidates are read in pairs too
            sum[a].resize(points.size() + 1);
        }
        for (size_t i = 0; i < points.size(); ++i) {
            const Vec3 p = points[i] - origin;
            for (int a = 0; a < 3; ++a) {
                of[a][i] = p[a];
                sum[a][i + 1] = sum[a][i] + p[a];
            }
            square_sum[i + 1] = square_sum[i] + p.squaredNorm();
        }
    }
};

// What the result so far and the target show around a point: target points of the offsets [-before, after], result
// points of the offsets [-made, -1], about their common mean.
struct Neighbourhood {
    std::vector<Vec3> target, made;
    uint32_t before = 0, after = 0;
    double square_sum = 0.0;

    double count() const { return static_cast<double>(target.size() + made.size()); }

    void take(const std::vector<Vec3>& curve, const std::vector<Vec3>& result, uint32_t reach) {
        const uint32_t t = static_cast<uint32_t>(result.size());
        before = std::min(reach, t);
        after = std::min(reach, static_cast<uint32_t>(curve.size()) - 1 - t);
        target.assign(curve.begin() + (t - before), curve.begin() + (t + after + 1));
        made.assign(result.end() - before, result.end());
        Vec3 mean = Vec3::Zero();
        for (const Vec3& p : target) mean += p;
        for (const Vec3& p : made) mean += p;
        mean /= count();
        square_sum = 0.0;
        for (std::vector<Vec3>* side : {&target, &made}) {
            for (Vec3& p : *side) square_sum += (p -= mean).squaredNorm();
        }
    }
};

// Sum of the singular values of a 3 x 3 matrix, the least one negative where the matrix mirrors: the trace of what the
// best rotation makes of it. From the eigenvalues of H^T H in closed form.
double best_trace(const Eigen::Matrix3d& h) {
    const Eigen::Matrix3d square = h.transpose() * h;
    const double mean = square.trace() / 3.0;
    const double xy = square(0, 1), yz = square(1, 2), zx = square(2, 0);
    const double x = square(0, 0) - mean, y = square(1, 1) - mean, z = square(2, 2) - mean;
    const double radius_sq = (x * x + y * y + z * z + 2.0 * (xy * xy + yz * yz + zx * zx)) / 6.0;
    if (radius_sq <= 0.0) return 3.0 * std::sqrt(std::max(mean, 0.0));  // a multiple of the identity
    const double radius = std::sqrt(radius_sq);
    const double half_det = 0.5 * (x * (y * z - yz * yz) - xy * (xy * z - yz * zx) + zx * (xy * yz - y * zx));
    const double angle = std::acos(std::clamp(half_det / (radius_sq * radius), -1.0, 1.0)) / 3.0;
    const double largest = mean + 2.0 * radius * std::cos(angle);
    const double least = mean + 2.0 * radius * std::cos(angle + 2.0 * std::numbers::pi / 3.0);
    const double middle = 3.0 * mean - largest - least;
    return std::sqrt(largest) + std::sqrt(std::max(middle, 0.0)) +
           std::copysign(std::sqrt(std::max(least, 0.0)), h.determinant());
}

class Synthesis {
public:
    Synthesis(const std::vector<Vec3>& guide, const std::vector<Vec3>& style, uint32_t reach)
        : count_(static_cast<uint32_t>(guide.size())),
          reach_(reach),
          guide_(guide, guide.front()),
          style_(style, guide.front()),
          errors_(guide.size() + kLanes) {}

    Analogy run(const std::vector<Vec3>& target) {
        Analogy result;
        result.points.reserve(target.size());
        result.matches.reserve(target.size());
        uint32_t last_match = count_;
        for (const Vec3& point : target) {
            seen_.take(target, result.points, reach_);
            const uint32_t first = seen_.before, end = count_ - seen_.after;
            for (uint32_t s = first; s < end; s += kLanes) compare(s);
            const auto least = std::min_element(errors_.begin() + first, errors_.begin() + end);
            uint32_t match = static_cast<uint32_t>(least - errors_.begin());
            const uint32_t next = last_match + 1;
            if (next >= first && next < end && errors_[next] <= (1.0 + kCoherence) * *least) match = next;
            result.points.push_back(point + rotation(match) * offset(match));
            result.matches.push_back(match);
            last_match = match;
        }
        return result;
    }

private:
    Vec3 offset(uint32_t s) const {
        return Vec3(style_.of[0][s] - guide_.of[0][s], style_.of[1][s] - guide_.of[1][s],
                    style_.of[2][s] - guide_.of[2][s]);
    }

    // Adds points of the curve from `at` on, transposed, times those of the neighbourhood.
    static void correlate(const std::vector<Vec3>& points, const Columns& curve, uint32_t at, Lanes (&sums)[3][3]) {
        const double* const x = curve.of[0].data() + at;
        const double* const y = curve.of[1].data() + at;
        const double* const z = curve.of[2].data() + at;
        for (size_t i = 0; i < points.size(); ++i) {
            const Lanes q[] = {Eigen::Map<const Lanes>(x + i), Eigen::Map<const Lanes>(y + i),
                               Eigen::Map<const Lanes>(z + i)};
            for (int a = 0; a < 3; ++a) {
                for (int b = 0; b < 3; ++b) sums[a][b] += points[i][a] * q[b];
            }
        }
    }

    // Sums of p q^T for the candidates s and s + 1.
    void covariances(uint32_t s, Lanes (&sums)[3][3]) const {
        for (auto& row : sums) {
            for (Lanes& sum : row) sum.setZero();
        }
        correlate(seen_.target, guide_, s - seen_.before, sums);
        correlate(seen_.made, style_, s - seen_.before, sums);
    }

    void compare(uint32_t s) {
        Lanes sums[3][3];
        covariances(s, sums);
        for (uint32_t lane = 0; lane < kLanes && s + lane < count_ - seen_.after; ++lane) {
            Eigen::Matrix3d h;
            for (int a = 0; a < 3; ++a) {
                for (int b = 0; b < 3; ++b) h(a, b) = sums[a][b][lane];
            }
            const uint32_t from = s + lane - seen_.before, middle = s + lane, to = middle + seen_.after + 1;
            double square_sum =
                guide_.square_sum[to] - guide_.square_sum[from] + style_.square_sum[middle] - style_.square_sum[from];
            for (int a = 0; a < 3; ++a) {
                const double sum =
                    guide_.sum[a][to] - guide_.sum[a][from] + style_.sum[a][middle] - style_.sum[a][from];
                square_sum -= sum * sum / seen_.count();
            }
            errors_[s + lane] = std::max(seen_.square_sum + square_sum - 2.0 * best_trace(h), 0.0);
        }
    }

    // From exemplar to target, Kabsch.
    Eigen::Matrix3d rotation(uint32_t s) const {
        Lanes sums[3][3];
        covariances(s, sums);
        Eigen::Matrix3d h;
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) h(a, b) = sums[a][b][0];
        }
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(h, Eigen::ComputeFullU | Eigen::ComputeFullV);
        const double mirror = (svd.matrixU() * svd.matrixV().transpose()).determinant();
        return svd.matrixU() * Vec3(1.0, 1.0, std::copysign(1.0, mirror)).asDiagonal() * svd.matrixV().transpose();
    }

    uint32_t count_, reach_;
    Columns guide_, style_;
    std::vector<double> errors_;  // by candidate
    Neighbourhood seen_;
};

}  // namespace

Analogy curve_analogies(const std::vector<Vec3>& guide, const std::vector<Vec3>& style, const std::vector<Vec3>& target,
                        uint32_t neighbourhood) {
    return Synthesis(guide, style, neighbourhood).run(target);
}

}  // namespace flg::bench
