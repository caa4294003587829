// SPDX-License-Identifier: MIT
// Turning one joint moves a vertex by s (R - 1)(x - c): c is where the joint is, s the sum of the weights of all joints
// that turn with it.
#include "documents/rig_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace flg::cli {
namespace {

constexpr uint32_t joints_a_vertex = 4;
const double turn = std::acos(-1.0) / 6;

using Point = std::array<double, 3>;

class Rig {
public:
    explicit Rig(const FlgSkinView& skin) : skin_(skin), children_(skin.joint_count), vertices_(skin.joint_count) {
        for (uint32_t j = 0; j < skin.joint_count; ++j)
            if (skin.joint_parents[j] != FLG_NO_INDEX) children_[skin.joint_parents[j]].push_back(j);
        for (uint32_t v = 0; v < skin.vertex_count; ++v)
            for (uint32_t k = 0; k < joints_a_vertex; ++k)
                if (weight(v, k) > 0) vertices_[joint(v, k)].push_back(v);
        neighbours_.resize(skin.vertex_count);
        for (uint32_t i = 0; i < 3 * skin.triangle_count; ++i) {
            const uint32_t next = i % 3 == 2 ? i - 2 : i + 1;
            neighbours_[skin.triangles[i]].push_back(skin.triangles[next]);
        }
    }

    void turn_joint(uint32_t turned, RigQuality& out) {
        // What turns with it, and how much of each vertex.
        std::vector<uint32_t> below = {turned}, moved;
        std::vector<double> share(skin_.vertex_count, 0);
        for (size_t i = 0; i < below.size(); ++i) {
            for (const uint32_t v : vertices_[below[i]])
                for (uint32_t k = 0; k < joints_a_vertex; ++k) {
                    if (weight(v, k) == 0 || joint(v, k) != below[i]) continue;
                    if (share[v] == 0) moved.push_back(v);
                    share[v] += weight(v, k);
                }
            below.insert(below.end(), children_[below[i]].begin(), children_[below[i]].end());
        }
        for (uint32_t axis = 0; axis < 3; ++axis)
            for (const double angle : {-turn, turn}) {
                const auto at = [&](uint32_t v) {
                    const uint32_t a = (axis + 1) % 3, b = (axis + 2) % 3;
                    Point p{};
                    for (uint32_t i = 0; i < 3; ++i) p[i] = static_cast<double>(skin_.positions[3 * v + i]);
                    const double x = p[a] - static_cast<double>(skin_.joint_positions[3 * turned + a]),
                                 y = p[b] - static_cast<double>(skin_.joint_positions[3 * turned + b]);
                    p[a] += share[v] * ((std::cos(angle) - 1) * x - std::sin(angle) * y);
                    p[b] += share[v] * (std::sin(angle) * x + (std::cos(angle) - 1) * y);
                    return p;
                };
                for (const uint32_t v : moved)
                    for (const uint32_t w : neighbours_[v]) {
                        if (share[v] == share[w] && share[v] >= 1) continue;
                        const double stretch = length(at(v), at(w)) / rest_length(v, w);
                        if (stretch > out.largest_stretch) {
                            out.largest_stretch = stretch;
                            out.stretch_joint = turned;
                            out.stretch_vertex = v;
                        }
                    }
            }
    }

    void look_at_jumps(RigQuality& out) const {
        const auto of = [&](uint32_t v, uint32_t j) {
            double sum = 0;
            for (uint32_t k = 0; k < joints_a_vertex; ++k)
                if (joint(v, k) == j) sum += weight(v, k);
            return sum;
        };
        for (uint32_t v = 0; v < skin_.vertex_count; ++v)
            for (const uint32_t w : neighbours_[v])
                for (uint32_t k = 0; k < joints_a_vertex; ++k) {
                    const double jump = weight(v, k) - of(w, joint(v, k));
                    if (jump <= out.largest_jump) continue;
                    out.largest_jump = jump;
                    out.jump_joint = joint(v, k);
                    out.jump_vertex = v;
                }
    }

private:
    double weight(uint32_t v, uint32_t k) const {
        return static_cast<double>(skin_.vertex_weights[joints_a_vertex * v + k]);
    }
    uint32_t joint(uint32_t v, uint32_t k) const { return skin_.vertex_joints[joints_a_vertex * v + k]; }
    static double length(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }
    double rest_length(uint32_t v, uint32_t w) const {
        double sum = 0;
        for (uint32_t i = 0; i < 3; ++i) {
            const double d =
                static_cast<double>(skin_.positions[3 * v + i]) - static_cast<double>(skin_.positions[3 * w + i]);
            sum += d * d;
        }
        return std::sqrt(sum);
    }

    const FlgSkinView& skin_;
    std::vector<std::vector<uint32_t>> children_, vertices_, neighbours_;
};

}  // namespace

RigQuality measure_rig(const FlgSkinView& skin) {
    RigQuality out;
    Rig rig(skin);
    for (uint32_t j = 0; j < skin.joint_count; ++j) rig.turn_joint(j, out);
    rig.look_at_jumps(out);
    return out;
}

uint32_t count_pieces(const FlgSkinView& skin) {
    std::vector<uint32_t> of(skin.vertex_count);
    std::iota(of.begin(), of.end(), 0);
    const auto find = [&](uint32_t v) {
        for (; of[v] != v; v = of[v]) of[v] = of[of[v]];
        return v;
    };
    std::vector<bool> is_used(skin.vertex_count);
    for (size_t t = 0; t < skin.triangle_count; ++t) {
        const uint32_t* c = skin.triangles + 3 * t;
        for (size_t k = 0; k < 3; ++k) {
            is_used[c[k]] = true;
            of[find(c[k])] = find(c[0]);
        }
    }
    uint32_t pieces = 0;
    for (uint32_t v = 0; v < of.size(); ++v) pieces += is_used[v] && of[v] == v;
    return pieces;
}

}  // namespace flg::cli
