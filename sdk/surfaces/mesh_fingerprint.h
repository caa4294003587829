// SPDX-License-Identifier: MIT
// A number that tells meshes apart, to the bit: of their positions and triangles, in their order.
#pragma once

#include "surfaces/mesh.h"

namespace flg {

struct MeshFingerprint {
    uint64_t number = 0;
    Position lower{}, upper{};  // the bounding box, metres
};

class MeshFingerprintKernel {
public:
    // Outlives the kernel; with one vertex at least.
    explicit MeshFingerprintKernel(const Mesh& mesh);

    // A unit is a vertex or a triangle: about 3 ns.
    bool run(uint32_t count);

    // After run() returned true.
    const MeshFingerprint& fingerprint() const { return fingerprint_; }

private:
    void mix(const void* three_words);

    const Mesh& mesh_;
    MeshFingerprint fingerprint_;
    uint32_t vertices_ = 0, triangles_ = 0;
};

}  // namespace flg
