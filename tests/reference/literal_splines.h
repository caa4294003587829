// SPDX-License-Identifier: MIT
// Energy-minimizing splines as the paper writes them (Hofer, Pottmann 2004, sec. 3): differences of differences,
// Algorithms 1 and 2 with dense matrices, and the plain projected gradient it improves on.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "splines/manifolds/manifold.h"

namespace flg::reference {

struct LiteralSpline {
    const Manifold* manifold = nullptr;
    bool closed = false;
    double bending = 1, tension = 0;  // weights of E2 and E1
    std::vector<double> steps;        // of parameters, one an interval
    std::vector<bool> fixed;          // one a node
    Eigen::MatrixXd points;           // n x nodes: the present curve
};

// The energies of sec. 3.2 as a quadratic function x^T Q x of the coordinates, node by node: first derivatives are
// differences of points over steps, second ones differences of these over the mean of the two steps, integrals are
// sums.
Eigen::MatrixXd energy_matrix(const LiteralSpline& spline);
double energy(const LiteralSpline& spline);

struct LiteralRun {
    uint32_t rounds = 0;
    double energy = 0;
};

// Algorithm 2, with the stepsizes of Algorithm 1 under Armijo's rule, until the tangential part of the gradient is
// below `tolerance` of all of it. `matrix`: of another energy; empty: energy_matrix().
LiteralRun minimize(LiteralSpline& spline, double tolerance, uint32_t max_rounds, Eigen::MatrixXd matrix = {});

// Steepest descent in the ordinary metric, projected, under Armijo's rule; each step begins with twice the last one.
LiteralRun minimize_by_gradient(LiteralSpline& spline, double tolerance, uint32_t max_rounds,
                                Eigen::MatrixXd matrix = {});

}  // namespace flg::reference
