// SPDX-License-Identifier: MIT
// glTF moves vertices by morph targets first and by joints after that, by the mean of their matrices. So what was
// pulled in a pose is taken back through that mean, vertex by vertex. Key frames are chosen one after the other, each
// as late as the tolerance allows.
//
// A vertex of a level of detail moves as the surface does at the nearest vertex of its part that faces the same way, or
// in a triangle beside that: so limbs that touch keep to their own.
#include "pulled_skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "documents/failure.h"

namespace flg::cli {
namespace {

constexpr double farthest_share = 0.1;      // of the size: points so far from the surface are none of it
constexpr double still_share = 1e-5;        // of the size: what moves less does not move
constexpr double same_share = 1e-6;         // of the size: shapes that differ less are one
constexpr double least_determinant = 0.05;  // of a mean of matrices: below it, it has collapsed
constexpr uint32_t first_rounds = 4;        // times the rounds of the others: the first frame comes from nowhere
constexpr size_t most_floats = size_t{1} << 29;

using Point3 = std::array<double, 3>;
Point3 point(const float* p) {
    return {double{p[0]}, double{p[1]}, double{p[2]}};
}

Point3 minus(const Point3& a, const Point3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point3& a, const Point3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Shares of a triangle's corners in its point nearest to `p` (Ericson: Real-time collision detection, 2005, 5.1.5).
std::array<double, 3> nearest_shares(const Point3& p, const Point3& a, const Point3& b, const Point3& c) {
    const Point3 ab = minus(b, a), ac = minus(c, a), ap = minus(p, a), bp = minus(p, b), cp = minus(p, c);
    const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
                 d6 = dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - share, share};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

// Three rows of four: the mean of what joints do, by a vertex' weights.
std::array<double, 12> blended(const FlgSkinView& skin, const std::vector<float>& matrices, size_t vertex) {
    std::array<double, 12> sum{};
    for (size_t k = 0; k < 4; ++k) {
        const double weight = double{skin.vertex_weights[4 * vertex + k]};
        const float* m = &matrices[12 * size_t{skin.vertex_joints[4 * vertex + k]}];
        for (size_t i = 0; weight > 0 && i < sum.size(); ++i) sum[i] += weight * double{m[i]};
    }
    return sum;
}

double determinant(const std::array<double, 12>& m) {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
}

// What a map takes to p.
Point3 source_of(const std::array<double, 12>& m, const Point3& p) {
    const Point3 q = {p[0] - m[3], p[1] - m[7], p[2] - m[11]};
    const double scale = 1 / determinant(m);
    return {scale * ((m[5] * m[10] - m[6] * m[9]) * q[0] + (m[2] * m[9] - m[1] * m[10]) * q[1] +
                     (m[1] * m[6] - m[2] * m[5]) * q[2]),
            scale * ((m[6] * m[8] - m[4] * m[10]) * q[0] + (m[0] * m[10] - m[2] * m[8]) * q[1] +
                     (m[2] * m[4] - m[0] * m[6]) * q[2]),
            scale * ((m[4] * m[9] - m[5] * m[8]) * q[0] + (m[1] * m[8] - m[0] * m[9]) * q[1] +
                     (m[0] * m[5] - m[1] * m[4]) * q[2])};
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
    double largest = 0;
    for (size_t i = 0; i < a.size(); i += 3) {
        const Point3 d = minus(point(&a[i]), point(&b[i]));
        largest = std::max(largest, dot(d, d));
    }
    return std::sqrt(largest);
}

// Vertices by their places: halved along each axis in turn.
class VertexTree {
public:
    explicit VertexTree(const FlgSkinView& skin) : skin_(skin), order_(skin.vertex_count) {
        std::iota(order_.begin(), order_.end(), 0u);
        split(0, order_.size(), 0);
    }

    // FLG_NO_INDEX: none is accepted.
    template <class Accepts>
    uint32_t nearest(const Point3& p, const Accepts& accepts) const {
        Found found;
        search(p, accepts, 0, order_.size(), 0, found);
        return found.vertex;
    }

private:
    struct Found {
        uint32_t vertex = FLG_NO_INDEX;
        double square = HUGE_VAL;
    };
    Point3 at(uint32_t vertex) const { return point(skin_.positions + 3 * size_t{vertex}); }

    void split(size_t begin, size_t end, size_t axis) {
        if (end - begin < 2) return;
        const auto first = order_.begin(), middle = first + static_cast<std::ptrdiff_t>((begin + end) / 2);
        std::nth_element(first + static_cast<std::ptrdiff_t>(begin), middle, first + static_cast<std::ptrdiff_t>(end),
                         [&](uint32_t a, uint32_t b) { return std::pair(at(a)[axis], a) < std::pair(at(b)[axis], b); });
        split(begin, (begin + end) / 2, (axis + 1) % 3);
        split((begin + end) / 2 + 1, end, (axis + 1) % 3);
    }

    template <class Accepts>
    void search(const Point3& p, const Accepts& accepts, size_t begin, size_t end, size_t axis, Found& found) const {
        if (begin == end) return;
        const size_t middle = (begin + end) / 2;
        const Point3 off = minus(p, at(order_[middle]));
        const double square = dot(off, off);
        if (square < found.square && accepts(order_[middle])) found = {order_[middle], square};
        const bool is_below = off[axis] < 0;
        for (const bool below : {is_below, !is_below}) {
            if (below != is_below && off[axis] * off[axis] >= found.square) continue;
            search(p, accepts, below ? begin : middle + 1, below ? middle : end, (axis + 1) % 3, found);
        }
    }

    const FlgSkinView& skin_;
    std::vector<uint32_t> order_;
};

}  // namespace

PulledSkin::PulledSkin(Session& session, const PullScript& script, const FlgSkinView& skin,
                       const std::vector<FlgSkinAnimation>& animations, Report& report)
    : script_(script), skin_(skin) {
    Point3 low, high;
    low.fill(HUGE_VAL);
    high.fill(-HUGE_VAL);
    for (size_t i = 0; i < 3 * size_t{skin.vertex_count}; ++i) {
        low[i % 3] = std::min(low[i % 3], double{skin.positions[i]});
        high[i % 3] = std::max(high[i % 3], double{skin.positions[i]});
    }
    size_ = std::sqrt(dot(minus(high, low), minus(high, low)));
    const double seconds = script.end() - script.begin();
    const auto frames = static_cast<size_t>(std::ceil(seconds * script.rate - 1e-9)) + 1;
    if (frames > most_floats / (3 * size_t{skin.vertex_count})) {
        throw InputError(script.subject + ": " + std::to_string(frames) + " frames of " +
                         std::to_string(skin.vertex_count) + " vertices take more than 2 GiB; a lower `rate` helps");
    }
    for (size_t k = 0; k < frames; ++k)
        times_.push_back(std::min(script.begin() + static_cast<double>(k) / script.rate, script.end()));
    find_points();
    find_motion(animations);
    pull(session, report);
    choose_targets();
    describe(report);
}

PulledSkin::Point PulledSkin::nearest_point(const Point3& at, std::span<const uint32_t> triangles,
                                            double* distance) const {
    double best = HUGE_VAL;
    Point found{};
    for (const uint32_t t : triangles) {
        const uint32_t* c = skin_.triangles + 3 * size_t{t};
        const std::array<Point3, 3> corners = {point(skin_.positions + 3 * size_t{c[0]}),
                                               point(skin_.positions + 3 * size_t{c[1]}),
                                               point(skin_.positions + 3 * size_t{c[2]})};
        const std::array<double, 3> shares = nearest_shares(at, corners[0], corners[1], corners[2]);
        Point3 off = at;
        for (size_t k = 0; k < 3; ++k)
            for (size_t axis = 0; axis < 3; ++axis) off[axis] -= shares[k] * corners[k][axis];
        // Of triangles without area nothing is known.
        if (!(dot(off, off) < best)) continue;
        best = dot(off, off);
        for (size_t k = 0; k < 3; ++k) {
            found.vertices[k] = c[k];
            found.shares[k] = static_cast<float>(shares[k]);
        }
    }
    if (distance) *distance = std::sqrt(best);
    return found;
}

void PulledSkin::find_points() {
    std::vector<uint32_t> all(skin_.triangle_count);
    std::iota(all.begin(), all.end(), 0u);
    for (const PullScriptHandle& handle : script_.handles) {
        const Point3 at = {handle.at[0] - skin_.origin[0], handle.at[1] - skin_.origin[1],
                           handle.at[2] - skin_.origin[2]};
        double distance = 0;
        const Point found = nearest_point(at, all, &distance);
        if (!(distance <= farthest_share * size_)) {
            char text[200];
            std::snprintf(text, sizeof text,
                          ": (%.6g, %.6g, %.6g) is %.4g from the surface; at most %.4g, a tenth of the model's size",
                          handle.at[0], handle.at[1], handle.at[2], distance, farthest_share * size_);
            throw InputError(handle.place + text);
        }
        points_.push_back(found);
    }
}

// Sampled at the frames, over and over if it is shorter.
void PulledSkin::find_motion(const std::vector<FlgSkinAnimation>& animations) {
    if (script_.motion.empty()) return;
    const FlgSkinAnimation* found = nullptr;
    std::string known;
    for (const FlgSkinAnimation& animation : animations) {
        if (script_.motion == animation.name) found = &animation;
        known += (known.empty() ? "" : ", ") + std::string(animation.name);
    }
    if (!found)
        throw InputError(script_.subject + ".motion: the model has no motion '" + script_.motion + "'; it has " +
                         (known.empty() ? "none" : known));
    const double first = double{found->times[0]}, length = double{found->times[found->key_count - 1]} - first;
    const size_t joints = skin_.joint_count;
    motion_.rotations.resize(4 * joints * times_.size());
    motion_.translations.resize(3 * times_.size());
    for (size_t k = 0; k < times_.size(); ++k) {
        const double into = times_[k] - times_[0];
        const double time = first + (length > 0 ? into - length * std::floor(into / length) : 0);
        check(flgSkinAnimationSample(found, skin_.joint_count, static_cast<float>(time),
                                     &motion_.rotations[4 * joints * k], &motion_.translations[3 * k]),
              script_.subject);
        motion_.times.push_back(static_cast<float>(times_[k]));
    }
    bones_.key_count = static_cast<uint32_t>(times_.size());
    bones_.name = script_.name.c_str();
    bones_.times = motion_.times.data();
    bones_.rotations = motion_.rotations.data();
    bones_.translations = motion_.translations.data();
}

std::vector<float> PulledSkin::matrices_at(size_t frame) const {
    std::vector<float> matrices(12 * size_t{skin_.joint_count});
    check(flgSkinPose(&skin_, &motion_.rotations[4 * size_t{skin_.joint_count} * frame],
                      &motion_.translations[3 * frame], matrices.data(), nullptr),
          script_.subject);
    return matrices;
}

void PulledSkin::pull(Session& session, Report& report) {
    FlgMeshView mesh = flgMeshViewDefaults();
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, skin_.positions, 0, 0};
    mesh.vertex_count = skin_.vertex_count;
    mesh.triangle_count = skin_.triangle_count;
    mesh.triangles = skin_.triangles;
    mesh.columns = &column;
    mesh.column_count = 1;
    FlgPullDesc desc = flgPullDefaults();
    desc.mesh = &mesh;
    FlgPull pull = {};
    FlgJob job = {};
    check(flgPullCreate(session.context(), &desc, &pull, &job), script_.subject);
    session.finish({{{job, script_.subject}}}, report);

    FlgPulledDesc frame = flgPulledDefaults();
    frame.pull = pull;
    std::vector<FlgPullHandle> handles(points_.size(), flgPullHandleDefaults());
    frame.handles = handles.data();
    frame.handle_count = static_cast<uint32_t>(handles.size());
    const size_t floats = 3 * size_t{skin_.vertex_count};
    std::vector<float> posed;
    for (size_t k = 0; k < times_.size(); ++k) {
        if (!motion_.rotations.empty()) {
            posed.resize(floats);
            check(flgSkinDeform(&skin_, FLG_SKINNING_LINEAR, matrices_at(k).data(), posed.data(), nullptr),
                  script_.subject);
            frame.positions = posed.data();
        }
        const float* pose = posed.empty() ? skin_.positions : posed.data();
        for (size_t h = 0; h < handles.size(); ++h) {
            const PullScriptHandle& from = script_.handles[h];
            const uint32_t offsets[] = {0, static_cast<uint32_t>(from.times.size())};
            std::vector<float> places;
            for (size_t i = 0; i < from.positions.size(); ++i)
                places.push_back(static_cast<float>(from.positions[i] - (from.moves ? 0 : skin_.origin[i % 3])));
            FlgPullKeys keys = flgPullKeysDefaults();
            keys.handle_count = 1;
            keys.offsets = offsets;
            keys.times = from.times.data();
            keys.positions = places.data();
            check(flgPullKeysSample(&keys, times_[k], handles[h].position), from.place);
            std::copy(points_[h].vertices.begin(), points_[h].vertices.end(), handles[h].vertices);
            std::copy(points_[h].shares.begin(), points_[h].shares.end(), handles[h].shares);
            handles[h].compliance = static_cast<float>(from.compliance);
            handles[h].radius = static_cast<float>(from.radius);
            for (size_t i = 0; from.moves && i < 9; ++i)
                handles[h].position[i % 3] +=
                    points_[h].shares[i / 3] * pose[3 * size_t{points_[h].vertices[i / 3]} + i % 3];
        }
        frame.rounds = k == 0 ? std::min(first_rounds * script_.rounds, 1000u) : script_.rounds;
        FlgPulled pulled = {};
        check(flgPulledCreate(session.context(), &frame, &pulled, &job), script_.subject);
        session.finish({{{job, script_.subject}}}, report);
        FlgPulledView view = flgPulledViewDefaults();
        check(flgPulledGetView(session.context(), pulled, &view), script_.subject);
        move_to_rest(k, view.positions);
        if (frame.previous.id != 0) check(flgPulledRelease(session.context(), frame.previous), script_.subject);
        frame.previous = pulled;
    }
    check(flgPulledRelease(session.context(), frame.previous), script_.subject);
    check(flgPullRelease(session.context(), pull), script_.subject);
}

void PulledSkin::move_to_rest(size_t frame, const float* positions) {
    std::vector<float>& moves = moves_.emplace_back(3 * size_t{skin_.vertex_count});
    const std::vector<float> matrices = motion_.rotations.empty() ? std::vector<float>() : matrices_at(frame);
    for (size_t v = 0; v < skin_.vertex_count; ++v) {
        Point3 at = point(positions + 3 * v);
        if (!matrices.empty()) {
            std::array<double, 12> map = blended(skin_, matrices, v);
            if (determinant(map) < least_determinant) {
                const float* first = &matrices[12 * size_t{skin_.vertex_joints[4 * v]}];
                std::copy_n(first, map.size(), map.begin());
            }
            at = source_of(map, at);
        }
        const Point3 move = minus(at, point(skin_.positions + 3 * v));
        if (dot(move, move) <= still_share * size_ * still_share * size_) continue;
        for (size_t k = 0; k < 3; ++k) moves[3 * v + k] = static_cast<float>(move[k]);
    }
}

double PulledSkin::error_between(size_t from, size_t to, size_t frame) const {
    const double share = (times_[frame] - times_[from]) / (times_[to] - times_[from]);
    double largest = 0;
    for (size_t i = 0; i < moves_[frame].size(); i += 3) {
        double square = 0;
        for (size_t k = i; k < i + 3; ++k) {
            const double off = double{moves_[from][k]} + share * (double{moves_[to][k]} - double{moves_[from][k]}) -
                               double{moves_[frame][k]};
            square += off * off;
        }
        largest = std::max(largest, square);
    }
    return std::sqrt(largest);
}

void PulledSkin::choose_targets() {
    const double tolerance = script_.tolerance * size_;
    const auto fits = [&](size_t from, size_t to) {
        for (size_t frame = from + 1; frame < to; ++frame)
            if (error_between(from, to, frame) > tolerance) return false;
        return true;
    };
    keys_ = {0};
    while (keys_.back() + 1 < times_.size()) {
        size_t next = keys_.back() + 1;
        while (next + 1 < times_.size() && fits(keys_.back(), next + 1)) ++next;
        keys_.push_back(next);
    }
    const std::vector<float> rest(3 * size_t{skin_.vertex_count});
    for (const size_t key : keys_) {
        uint32_t target = FLG_NO_INDEX;
        if (largest_difference(moves_[key], rest) > same_share * size_) {
            const auto same = std::find_if(targets_.begin(), targets_.end(), [&](size_t frame) {
                return largest_difference(moves_[key], moves_[frame]) <= same_share * size_;
            });
            target = static_cast<uint32_t>(same - targets_.begin());
            if (same == targets_.end()) targets_.push_back(key);
        }
        target_of_key_.push_back(target);
    }
    for (size_t k = 0; k + 1 < keys_.size(); ++k) {
        for (size_t frame = keys_[k] + 1; frame < keys_[k + 1]; ++frame) {
            const double error = error_between(keys_[k], keys_[k + 1], frame);
            if (error <= largest_error_) continue;
            largest_error_ = error;
            error_time_ = times_[frame];
        }
    }
    // A mesh that nothing moves has a shape nevertheless: its animation needs one.
    if (targets_.empty()) targets_.push_back(0);
    for (const size_t frame : targets_) {
        char text[64];
        std::snprintf(text, sizeof text, " %.3f s", times_[frame]);
        names_.push_back(script_.name + text);
    }
    weights_.assign(keys_.size() * targets_.size(), 0);
    for (size_t k = 0; k < keys_.size(); ++k) {
        key_times_.push_back(static_cast<float>(times_[keys_[k]]));
        if (target_of_key_[k] != FLG_NO_INDEX) weights_[k * targets_.size() + target_of_key_[k]] = 1;
    }
}

void PulledSkin::describe(Report& report) const {
    report.counts["pull_handles"] = points_.size();
    report.counts["pull_frames"] = times_.size();
    report.counts["pull_keys"] = keys_.size();
    report.counts["morph_targets"] = targets_.size();
    double farthest = 0;
    const std::vector<float> rest(3 * size_t{skin_.vertex_count});
    for (const size_t frame : targets_) farthest = std::max(farthest, largest_difference(moves_[frame], rest));
    report.quality["pull_largest_move"] = farthest;
    report.quality["pull_largest_error"] = largest_error_;
    report.quality["pull_largest_error_time"] = error_time_;
}

std::vector<FlgMorphTarget> PulledSkin::targets() const {
    std::vector<FlgMorphTarget> targets(targets_.size(), flgMorphTargetDefaults());
    for (size_t i = 0; i < targets.size(); ++i) {
        targets[i].name = names_[i].c_str();
        targets[i].moves = moves_[targets_[i]].data();
    }
    return targets;
}

std::vector<FlgMorphTarget> PulledSkin::targets_of(const std::vector<FlgSkinView>& levels) {
    level_moves_.clear();
    if (levels.empty()) return {};
    const VertexTree tree(skin_);
    std::vector<std::vector<uint32_t>> triangles_at(skin_.vertex_count);
    for (size_t corner = 0; corner < 3 * size_t{skin_.triangle_count}; ++corner)
        triangles_at[skin_.triangles[corner]].push_back(static_cast<uint32_t>(corner / 3));
    for (const FlgSkinView& level : levels) {
        const size_t first = level_moves_.size();
        level_moves_.resize(first + targets_.size(), std::vector<float>(3 * size_t{level.vertex_count}));
        for (size_t v = 0; v < level.vertex_count; ++v) {
            const Point3 place = point(level.positions + 3 * v), normal = point(level.normals + 3 * v);
            const auto is_alike = [&](uint32_t other) {
                return dot(point(skin_.normals + 3 * size_t{other}), normal) > 0 &&
                       (!skin_.vertex_parts || skin_.vertex_parts[other] == level.vertex_parts[v]);
            };
            uint32_t nearest = tree.nearest(place, is_alike);
            if (nearest == FLG_NO_INDEX) nearest = tree.nearest(place, [](uint32_t) { return true; });
            const Point at = nearest_point(place, triangles_at[nearest]);
            for (size_t target = 0; target < targets_.size(); ++target)
                for (size_t i = 0; i < 9; ++i)
                    level_moves_[first + target][3 * v + i % 3] +=
                        at.shares[i / 3] * moves_[targets_[target]][3 * size_t{at.vertices[i / 3]} + i % 3];
        }
    }
    std::vector<FlgMorphTarget> targets(level_moves_.size(), flgMorphTargetDefaults());
    for (size_t i = 0; i < targets.size(); ++i) targets[i].moves = level_moves_[i].data();
    return targets;
}

FlgMorphAnimation PulledSkin::animation(uint32_t index) const {
    FlgMorphAnimation animation = flgMorphAnimationDefaults();
    animation.key_count = static_cast<uint32_t>(keys_.size());
    animation.name = script_.name.c_str();
    animation.times = key_times_.data();
    animation.weights = weights_.data();
    if (bones()) animation.animation = index;
    return animation;
}

std::vector<float> PulledSkin::positions_at(double time) const {
    if (!(time >= times_.front() && time <= times_.back())) {
        char text[128];
        std::snprintf(text, sizeof text, ": --pulled-at: %g is not within %g to %g", time, times_.front(),
                      times_.back());
        throw InputError(script_.subject + text);
    }
    size_t frame = 0;
    while (frame + 1 < times_.size() && std::abs(times_[frame + 1] - time) <= std::abs(times_[frame] - time)) ++frame;
    std::vector<float> positions(skin_.positions, skin_.positions + 3 * size_t{skin_.vertex_count});
    for (size_t i = 0; i < positions.size(); ++i) positions[i] += moves_[frame][i];
    if (motion_.rotations.empty()) return positions;
    FlgSkinView moved = skin_;
    moved.positions = positions.data();
    std::vector<float> posed(positions.size());
    check(flgSkinDeform(&moved, FLG_SKINNING_LINEAR, matrices_at(frame).data(), posed.data(), nullptr),
          script_.subject);
    return posed;
}

}  // namespace flg::cli
