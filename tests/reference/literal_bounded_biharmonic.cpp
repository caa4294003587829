// SPDX-License-Identifier: MIT
#include "reference/literal_bounded_biharmonic.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>

namespace flg::reference {

Eigen::MatrixXd biharmonic_energy(const BiharmonicMesh& mesh) {
    const auto n = static_cast<Eigen::Index>(mesh.positions.size());
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(n);
    for (const auto& t : mesh.triangles) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t c = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
            const Eigen::Vector3d u = mesh.positions[a] - mesh.positions[c], v = mesh.positions[b] - mesh.positions[c];
            const double twice = u.cross(v).norm(), weight = u.dot(v) / twice / 2;
            laplacian(a, b) -= weight;
            laplacian(b, a) -= weight;
            laplacian(a, a) += weight;
            laplacian(b, b) += weight;
            mass(c) += twice / 6;
        }
    }
    return laplacian * mass.cwiseInverse().asDiagonal() * laplacian;
}

// Projected Newton steps (Bertsekas 1982): what is at a bound and pressed against it stays, the rest is solved for.
Eigen::MatrixXd literal_bounded_biharmonic(const BiharmonicMesh& mesh, const std::vector<int>& handle_of_vertex,
                                           int handles) {
    const Eigen::MatrixXd energy = biharmonic_energy(mesh);
    const auto n = energy.rows();
    Eigen::MatrixXd all(n, handles);
    for (int handle = 0; handle < handles; ++handle) {
        Eigen::VectorXd w = Eigen::VectorXd::Zero(n);
        for (Eigen::Index i = 0; i < n; ++i)
            if (handle_of_vertex[static_cast<size_t>(i)] == handle) w(i) = 1;
        for (int step = 0; step < 200; ++step) {
            const Eigen::VectorXd slope = energy * w;
            std::vector<Eigen::Index> free;
            for (Eigen::Index i = 0; i < n; ++i) {
                if (handle_of_vertex[static_cast<size_t>(i)] >= 0) continue;
                if ((w(i) <= 0 && slope(i) > 0) || (w(i) >= 1 && slope(i) < 0)) continue;
                free.push_back(i);
            }
            const Eigen::VectorXd move = energy(free, free).ldlt().solve(-slope(free));
            const double before = w.dot(slope);
            Eigen::VectorXd next = w;
            for (double share = 1; share > 1e-6; share /= 2) {
                next = w;
                next(free) = (w(free) + share * move).cwiseMax(0).cwiseMin(1);
                if (next.dot(energy * next) < before) break;
            }
            const double moved = (next - w).cwiseAbs().maxCoeff();
            if (next.dot(energy * next) >= before) break;
            w = next;
            if (moved < 1e-9) break;
        }
        all.col(handle) = w;
    }
    for (Eigen::Index i = 0; i < n; ++i) all.row(i) /= all.row(i).sum();
    return all;
}

}  // namespace flg::reference
