// SPDX-License-Identifier: MIT
#include "surfaces/mesh_fingerprint.h"

#include <algorithm>
#include <cstring>

namespace flg {

namespace {

// Odd, with bits all over: 2^64 over the golden ratio, and the multiplier of splitmix64.
constexpr uint64_t golden = 0x9e3779b97f4a7c15, spread = 0xbf58476d1ce4e5b9;

}  // namespace

MeshFingerprintKernel::MeshFingerprintKernel(const Mesh& mesh) : mesh_(mesh) {
    fingerprint_.number = golden * (mesh.vertex_count() + uint64_t{1});
    fingerprint_.lower = fingerprint_.upper = mesh.positions[0];
}

void MeshFingerprintKernel::mix(const void* three_words) {
    uint32_t words[3];
    std::memcpy(words, three_words, sizeof words);
    uint64_t& number = fingerprint_.number;
    number = (number ^ (uint64_t{words[0]} << 32 | words[1])) * spread;
    number = (number ^ number >> 29 ^ words[2]) * golden;
    number ^= number >> 32;
}

bool MeshFingerprintKernel::run(uint32_t count) {
    for (; vertices_ < mesh_.vertex_count(); --count, ++vertices_) {
        if (count == 0) return false;
        const Position& position = mesh_.positions[vertices_];
        mix(position.data());
        for (size_t k = 0; k < 3; ++k) {
            fingerprint_.lower[k] = std::min(fingerprint_.lower[k], position[k]);
            fingerprint_.upper[k] = std::max(fingerprint_.upper[k], position[k]);
        }
    }
    for (; triangles_ < mesh_.triangle_count(); --count, ++triangles_) {
        if (count == 0) return false;
        mix(mesh_.triangles[triangles_].data());
    }
    return true;
}

}  // namespace flg
