// SPDX-License-Identifier: MIT
#include "reference/literal_patch_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg::literal {

namespace {

// The curve of a point, if it is the centre of a patch; otherwise -1.
int patch_curve(const std::vector<int>& boundaries, int patch, int i) {
    for (size_t b = 0; b + 1 < boundaries.size(); ++b) {
        if (i - patch >= boundaries[b] && i + patch < boundaries[b + 1]) return static_cast<int>(b);
    }
    return -1;
}

}  // namespace

std::vector<double> patch_distances_sq(const std::vector<Vec3>& displacement, const std::vector<int>& boundaries,
                                       int patch) {
    const int n = static_cast<int>(displacement.size());
    std::vector<double> distances(static_cast<size_t>(n) * n, std::numeric_limits<double>::infinity());
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < n; ++c) {
            if (patch_curve(boundaries, patch, i) < 0 || patch_curve(boundaries, patch, c) < 0) continue;
            double sum = 0;
            for (int k = -patch; k <= patch; ++k) sum += (displacement[i + k] - displacement[c + k]).squaredNorm();
            distances[static_cast<size_t>(i) * n + c] = sum;
        }
    }
    return distances;
}

std::vector<double> patch_costs_sq(const std::vector<Vec3>& displacement, const std::vector<int>& boundaries,
                                   const std::vector<PatchSize>& sizes, const std::vector<Channel>& channels) {
    const int n = static_cast<int>(displacement.size());
    int largest = 0;
    for (const PatchSize& size : sizes) largest = std::max(largest, size.patch);
    const auto attribute_distance = [](const Channel& channel, int a, int b) {
        const double way = std::abs(channel.values[a] - channel.values[b]);
        if (channel.period == 0) return channel.weight * way;
        const double around = std::fmod(way, channel.period);
        return channel.weight * std::min(around, channel.period - around);
    };
    std::vector<double> costs(static_cast<size_t>(n) * n, std::numeric_limits<double>::infinity());
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < n; ++c) {
            if (patch_curve(boundaries, largest, i) < 0 || patch_curve(boundaries, largest, c) < 0) continue;
            double cost = 0;
            for (const PatchSize& size : sizes) {
                double sum = 0;
                for (int k = -size.patch; k <= size.patch; ++k) {
                    sum += (displacement[i + k] - displacement[c + k]).squaredNorm();
                    for (const Channel& channel : channels) {
                        const double distance = attribute_distance(channel, i + k, c + k);
                        sum += distance * distance;
                    }
                }
                cost += size.weight * std::sqrt(sum);
            }
            costs[static_cast<size_t>(i) * n + c] = cost * cost;
        }
    }
    return costs;
}

Graph dense_graph(const std::vector<double>& distances_sq, const std::vector<int>& boundaries, double tau) {
    const int n = boundaries.back();
    Graph graph(n);
    for (int i = 0; i < n; ++i) {
        for (int j = 1; j < n; ++j) {
            const bool consecutive = j == i + 1;
            const double distance_sq = distances_sq[static_cast<size_t>(i) * n + j - 1];
            if (consecutive) {
                if (std::find(boundaries.begin(), boundaries.end(), j) != boundaries.end()) continue;
                graph[i].push_back({j, static_cast<float>(tau)});
            } else if (distance_sq < std::numeric_limits<double>::infinity()) {
                graph[i].push_back({j, static_cast<float>(std::sqrt(distance_sq))});
            }
        }
    }
    return graph;
}

Graph sparse_jumps(const std::vector<double>& distances_sq, const std::vector<int>& boundaries, int patch, int kept) {
    const int n = boundaries.back();
    const double infinity = std::numeric_limits<double>::infinity();
    Graph graph(n);
    for (int i = 0; i < n; ++i) {
        const int curve = patch_curve(boundaries, patch, i);
        if (curve < 0) continue;
        const bool last_row = patch_curve(boundaries, patch, i + 1) != curve;
        const auto value = [&](int c) {
            return c < 0 || c >= n ? infinity : distances_sq[static_cast<size_t>(i) * n + c];
        };
        std::vector<std::pair<double, int>> jumps;
        for (int c = 0; c < n; ++c) {
            const int target_curve = patch_curve(boundaries, patch, c);
            if (c == i || target_curve < 0 || patch_curve(boundaries, patch, c + 1) != target_curve) continue;
            const bool minimum = value(c) < value(c - 1) && value(c) <= value(c + 1);
            if (last_row || minimum) jumps.emplace_back(value(c), c + 1);
        }
        if (!last_row) {
            std::sort(jumps.begin(), jumps.end());
            if (static_cast<int>(jumps.size()) > kept) jumps.resize(kept);
        }
        for (const auto& [distance_sq, target] : jumps) {
            graph[i].push_back({target, static_cast<float>(std::sqrt(distance_sq))});
        }
    }
    return graph;
}

}  // namespace flg::literal
