// SPDX-License-Identifier: MIT
#include "reference/literal_splines.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace flg::reference {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

uint32_t nodes_of(const LiteralSpline& spline) {
    return static_cast<uint32_t>(spline.points.cols());
}

VectorXd coordinates(const LiteralSpline& spline) {
    return Eigen::Map<const VectorXd>(spline.points.data(), spline.points.size());
}

// The derivative of the curve by its parameter on an interval, as rows that coordinates are multiplied with.
MatrixXd difference(const LiteralSpline& spline, uint32_t interval) {
    const uint32_t n = spline.manifold->ambient(), nodes = nodes_of(spline), next = (interval + 1) % nodes;
    MatrixXd rows = MatrixXd::Zero(n, n * nodes);
    rows.block(0, n * interval, n, n) -= MatrixXd::Identity(n, n) / spline.steps[interval];
    rows.block(0, n * next, n, n) += MatrixXd::Identity(n, n) / spline.steps[interval];
    return rows;
}

// Whether all points could be projected.
bool project(const LiteralSpline& spline, MatrixXd& points) {
    for (uint32_t i = 0; i < nodes_of(spline); ++i) {
        std::vector<double> hint(spline.manifold->hint_size(), 0.0);
        if (!spline.fixed[i] && !spline.manifold->project(points.col(i).data(), hint.data())) return false;
    }
    return true;
}

// Columns: a basis of the constraint manifold's tangent space, node by node.
MatrixXd tangents(const LiteralSpline& spline) {
    const uint32_t n = spline.manifold->ambient(), k = spline.manifold->dimension(), nodes = nodes_of(spline);
    MatrixXd columns(n * nodes, 0);
    for (uint32_t i = 0; i < nodes; ++i) {
        if (spline.fixed[i]) continue;
        std::vector<double> hint(spline.manifold->hint_size(), 0.0);
        VectorXd x = spline.points.col(i);
        spline.manifold->project(x.data(), hint.data());
        MatrixXd basis(n, k);
        spline.manifold->tangent_basis(x.data(), hint.data(), basis.data());
        columns.conservativeResize(Eigen::NoChange, columns.cols() + k);
        columns.rightCols(k).setZero();
        columns.block(n * i, columns.cols() - k, n, k) = basis;
    }
    return columns;
}

// The gradient at nodes that may move, and its tangential part over it.
double residual(const LiteralSpline& spline, const MatrixXd& basis, const VectorXd& gradient) {
    VectorXd free = gradient;
    const uint32_t n = spline.manifold->ambient();
    for (uint32_t i = 0; i < nodes_of(spline); ++i) {
        if (spline.fixed[i]) free.segment(n * i, n).setZero();
    }
    return free.norm() > 0 ? (basis.transpose() * gradient).norm() / free.norm() : 0;
}

// Goes to x + s t, halving s until Armijo's rule holds; the stepsize, or 0.
double go(LiteralSpline& spline, const MatrixXd& q, const VectorXd& gradient, const VectorXd& t, double s) {
    const VectorXd x = coordinates(spline);
    const double before = x.dot(q * x), slope = 2 * gradient.dot(t);
    for (int shrink = 0; shrink < 60; ++shrink, s *= 0.5) {
        const VectorXd moved = x + s * t;
        MatrixXd points = Eigen::Map<const MatrixXd>(moved.data(), spline.points.rows(), spline.points.cols());
        for (uint32_t i = 0; i < nodes_of(spline); ++i) {
            if (spline.fixed[i]) points.col(i) = spline.points.col(i);
        }
        if (!project(spline, points)) continue;
        const VectorXd y = Eigen::Map<const VectorXd>(points.data(), points.size());
        if (y.dot(q * y) > before + 1e-4 * s * slope) continue;
        spline.points = points;
        return s;
    }
    return 0;
}

}  // namespace

MatrixXd energy_matrix(const LiteralSpline& spline) {
    const uint32_t n = spline.manifold->ambient(), nodes = nodes_of(spline);
    const uint32_t intervals = spline.closed ? nodes : nodes - 1;
    MatrixXd q = MatrixXd::Zero(n * nodes, n * nodes);
    for (uint32_t i = 0; i < intervals; ++i) {
        const MatrixXd first = difference(spline, i);
        q += spline.tension * spline.steps[i] * first.transpose() * first;
        if (!spline.closed && i + 1 == intervals) continue;
        const uint32_t after = (i + 1) % intervals;
        const double step = 0.5 * (spline.steps[i] + spline.steps[after]);
        const MatrixXd second = (difference(spline, after) - first) / step;
        q += spline.bending * step * second.transpose() * second;
    }
    return q;
}

double energy(const LiteralSpline& spline) {
    const VectorXd x = coordinates(spline);
    return x.dot(energy_matrix(spline) * x);
}

LiteralRun minimize(LiteralSpline& spline, double tolerance, uint32_t max_rounds, MatrixXd q) {
    if (q.size() == 0) q = energy_matrix(spline);
    const uint32_t n = spline.manifold->ambient(), nodes = nodes_of(spline);
    // The unconstrained minimizer p, given points held.
    MatrixXd free = MatrixXd::Zero(n * nodes, 0);
    for (uint32_t i = 0; i < n * nodes; ++i) {
        if (spline.fixed[i / n]) continue;
        free.conservativeResize(Eigen::NoChange, free.cols() + 1);
        free.rightCols(1).setZero();
        free(i, free.cols() - 1) = 1;
    }
    const VectorXd start = coordinates(spline);
    const VectorXd p = start - free * (free.transpose() * q * free).ldlt().solve(free.transpose() * (q * start));
    const auto norm = [&](const VectorXd& v) { return std::sqrt(std::max(0.0, v.dot(q * v))); };
    LiteralRun run;
    VectorXd last;
    double curvature_step = 1;
    for (; run.rounds < max_rounds; ++run.rounds) {
        const VectorXd x = coordinates(spline), gradient = q * x;
        const MatrixXd basis = tangents(spline);
        if (residual(spline, basis, gradient) <= tolerance) break;
        const VectorXd t = basis * (basis.transpose() * q * basis).ldlt().solve(basis.transpose() * (q * (p - x)));
        if (last.size() > 0) {
            // Algorithm 1: p, x_c and p_T in the plane, x_c in the origin and p_T on the xi-axis; x_- on one side or
            // the other of p.
            const VectorXd p_t = x + t;
            const double base = norm(t), height = norm(p_t - p), far = std::hypot(base, height);
            const double to_p = norm(last - p), to_x = norm(last - x), to_t = norm(last - p_t);
            if (to_x > 1e-7 * far) {
                const double along = (to_x * to_x + far * far - to_p * to_p) / (2 * far);
                const double across = std::sqrt(std::max(0.0, to_x * to_x - along * along));
                double best = HUGE_VAL, xi = 0, eta = 0;
                for (const double side : {across, -across}) {
                    const double a = along * base / far - side * height / far,
                                 b = along * height / far + side * base / far;
                    const double error = std::abs(std::hypot(a - base, b) - to_t);
                    if (error < best) {
                        best = error;
                        xi = a;
                        eta = b;
                    }
                }
                const double rho = (xi * xi + eta * eta) / (2 * eta);  // the paper's denominator is 2 xi: a misprint
                curvature_step = std::abs(rho) / std::hypot(base, height - rho);
            }
        }
        last = x;
        if (go(spline, q, gradient, t, curvature_step) == 0) break;
    }
    const VectorXd x = coordinates(spline);
    run.energy = x.dot(q * x);
    return run;
}

LiteralRun minimize_by_gradient(LiteralSpline& spline, double tolerance, uint32_t max_rounds, MatrixXd q) {
    if (q.size() == 0) q = energy_matrix(spline);
    LiteralRun run;
    double step = 1 / q.norm();
    for (; run.rounds < max_rounds; ++run.rounds) {
        const VectorXd gradient = q * coordinates(spline);
        const MatrixXd basis = tangents(spline);
        if (residual(spline, basis, gradient) <= tolerance) break;
        const VectorXd t = -(basis * (basis.transpose() * gradient));
        step = go(spline, q, gradient, t, 2 * step);
        if (step == 0) break;
    }
    const VectorXd x = coordinates(spline);
    run.energy = x.dot(q * x);
    return run;
}

}  // namespace flg::reference
