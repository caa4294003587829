// SPDX-License-Identifier: MIT
// Every job of the ABI on inputs of any size: what a user brings, and what is hard on slices (a star, a fan, one long
// edge). A job's size is its number of points, nodes, vertices or triangles.
#pragma once

#include <span>

#include "slices/watched_host.h"

namespace flg::slices {

struct SizedJob {
    const char* name;
    void (*run)(WatchedHost&, uint32_t size);
    uint32_t largest = UINT32_MAX;  // beyond it the ABI refuses, or it takes minutes
};

std::span<const SizedJob> stroke_jobs();
std::span<const SizedJob> surface_jobs();
std::span<const SizedJob> tangle_jobs();
std::span<const SizedJob> spline_jobs();
std::span<const SizedJob> model_jobs();

}  // namespace flg::slices
