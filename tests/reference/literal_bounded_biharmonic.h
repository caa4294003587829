// SPDX-License-Identifier: MIT
// Bounded biharmonic weights (Jacobson, Baran, Popovic, Sorkine: Bounded biharmonic weights for real-time deformation,
// 2011, Eq. 2 to 6), on the surface and with dense matrices: for each handle the weights of least energy w' L M^-1 L w
// that are 1 on it, 0 on the other handles, and within [0, 1]; then all are scaled to sum to 1 (sec. 3 there).
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace flg::reference {

struct BiharmonicMesh {
    std::vector<Eigen::Vector3d> positions;
    std::vector<std::array<uint32_t, 3>> triangles;
};

// L M^-1 L, dense: twice the energy of w is w' E w.
Eigen::MatrixXd biharmonic_energy(const BiharmonicMesh& mesh);

// A column a handle. handle_of_vertex[i] is the handle that a vertex belongs to, or -1.
Eigen::MatrixXd literal_bounded_biharmonic(const BiharmonicMesh& mesh, const std::vector<int>& handle_of_vertex,
                                           int handles);

}  // namespace flg::reference
