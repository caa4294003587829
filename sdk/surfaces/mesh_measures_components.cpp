// SPDX-License-Identifier: MIT
#include "surfaces/mesh_measures_components.h"

namespace flg {

ComponentsKernel::ComponentsKernel(const Mesh& mesh, Memory* memory)
    : mesh_(mesh), labels_(mesh.vertex_count(), memory) {}

uint32_t ComponentsKernel::root_of(uint32_t vertex) {
    while (labels_[vertex] != vertex) {
        labels_[vertex] = labels_[labels_[vertex]];
        vertex = labels_[vertex];
    }
    return vertex;
}

void ComponentsKernel::join(uint32_t a, uint32_t b) {
    const uint32_t root_a = root_of(a), root_b = root_of(b);
    labels_[std::max(root_a, root_b)] = std::min(root_a, root_b);
}

// In rising order: a lesser vertex has its label already.
void ComponentsKernel::label(uint32_t vertex) {
    labels_[vertex] = labels_[vertex] == vertex ? component_count_++ : labels_[labels_[vertex]];
}

bool ComponentsKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        const uint32_t i = at_++;
        switch (pass_) {
            case Pass::single: labels_[i] = i; break;
            case Pass::join:
                join(mesh_.triangles[i][0], mesh_.triangles[i][1]);
                join(mesh_.triangles[i][1], mesh_.triangles[i][2]);
                break;
            default: label(i); break;
        }
        if (at_ == (pass_ == Pass::join ? mesh_.triangle_count() : mesh_.vertex_count())) {
            at_ = 0;
            pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
