// SPDX-License-Identifier: MIT
#include "inflation/four_joints.h"

#include <algorithm>
#include <bit>

#include "inflation/pivots.h"
#include "runtime/each.h"

namespace flg {
namespace {

constexpr uint32_t most = ManyJoints::limit;
constexpr double cut_off = 0.005;      // weights below it become 0, others are less by it
constexpr double alike_share = 0.1;    // of how far weights are spread: joints that are so near move a point alike
constexpr double choice_share = 4;     // of that too: how much the weight counts where joints are chosen
constexpr double least_taken = 0.001;  // the weight that any joint takes with
constexpr double loss_fading = 0.8;    // from vertex to vertex
constexpr uint32_t loss_rings = 8;
constexpr float loss_that_matters = 0.015f;
constexpr float hold = 0.005f;  // to what a vertex had, by what it lost: its neighbours together pull by 1
constexpr uint32_t sweeps = 48;

using Four = std::array<float, 4>;

struct Chosen {
    uint16_t places = 0;  // a bit for each of the vertex' many joints that stays
    float lost = 0;
};

// A vertex whose weights are spread again.
struct Spread {
    uint32_t vertex;
    float hold;
    Four had;
    std::array<Four, most> takes;  // how the four share the weight of each of the many
};

// Of one vertex: its many joints, without the small weights, and how far apart they move it.
class Candidates {
public:
    Candidates(const ManyJoints& many, double spread, const Vec3& position, const Pivots& pivots) : spread_(spread) {
        double sum = 0;
        for (; count_ < most; ++count_) {
            const double weight = static_cast<double>(many.weights[count_]) - cut_off;
            if (!(weight > 0)) break;
            sum += weights[count_] = weight;
        }
        if (count_ == 0) sum = weights[count_++] = 1;
        for (uint32_t k = 0; k < count_; ++k) weights[k] /= sum;
        if (count_ <= 4) return;
        for (uint32_t a = 0; a < count_; ++a)
            for (uint32_t b = 0; b < a; ++b)
                apart_[a][b] = apart_[b][a] = pivots.between(many.joints[a], many.joints[b], position).farthest;
    }

    uint32_t count() const { return count_; }

    Chosen choose() const {
        Chosen chosen{static_cast<uint16_t>((1u << count_) - 1), 0};
        std::array<double, most> left = weights;
        for (uint32_t stay = count_; stay > 4; --stay) {
            double least = HUGE_VAL;
            uint32_t goes = 0;
            for (uint32_t a = 0; a < count_; ++a) {
                if (!(chosen.places >> a & 1)) continue;
                double nearest = HUGE_VAL;
                for (uint32_t b = 0; b < count_; ++b)
                    if (b != a && chosen.places >> b & 1) nearest = std::min(nearest, apart_[a][b]);
                const double cost = left[a] * (choice_share * spread_ + nearest);
                if (!(cost < least)) continue;
                least = cost;
                goes = a;
            }
            chosen.places = static_cast<uint16_t>(chosen.places & ~(1u << goes));
            std::array<double, most> takes = share(goes, chosen.places, left);
            for (uint32_t b = 0; b < count_; ++b) left[b] += left[goes] * takes[b];
            chosen.lost += static_cast<float>(weights[goes]);
        }
        return chosen;
    }

    // How those that stay share the weight of one that does not.
    std::array<double, most> share(uint32_t of, uint32_t places, const std::array<double, most>& by) const {
        std::array<double, most> takes{};
        double sum = 0;
        for (uint32_t b = 0; b < count_; ++b) {
            if (!(places >> b & 1)) continue;
            const double apart = alike_share * spread_ + (count_ > 4 ? apart_[of][b] : 0);
            sum += takes[b] = (least_taken + by[b]) / (apart * apart);
        }
        for (double& part : takes) part /= sum;
        return takes;
    }

    std::array<double, most> weights{};

private:
    double spread_;
    uint32_t count_ = 0;
    std::array<std::array<double, most>, most> apart_{};
};

class FourJoints {
public:
    FourJoints(Pace& pace, const MergedMesh& mesh, const Groups& corners, const ManyWeights& many, const Pivots& pivots)
        : pace_(pace),
          mesh_(mesh),
          corners_(corners),
          many_(many),
          pivots_(pivots),
          chosen_(mesh.positions.size(), pace.memory()),
          weights_(mesh.positions.size(), pace.memory()),
          places_(mesh.positions.size(), pace.memory()) {}

    Task<BoneWeights> run() {
        const size_t vertices = mesh_.positions.size();
        co_await each(pace_, vertices, Cost::microseconds, [&](uint32_t v) { choose(v); });
        co_await spread_loss();
        uint32_t count = 0;
        co_await each(pace_, vertices, Cost::some_ns,
                      [&](uint32_t v) { count += chosen_[v].lost > loss_that_matters ? 1 : 0; });
        spreads_ = Buffer<Spread>(count, pace_.memory());
        count = 0;
        co_await each(pace_, vertices, Cost::tens_of_ns, [&](uint32_t v) {
            if (chosen_[v].lost > loss_that_matters) spreads_[count++].vertex = v;
        });
        co_await each(pace_, count, Cost::microseconds, [&](uint32_t i) { begin(spreads_[i]); });
        co_await find_neighbours();
        for (uint32_t sweep = 0; sweep < sweeps; ++sweep)
            co_await each(pace_, count, Cost::hundreds_of_ns,
                          [&](uint32_t i) { smooth(sweep % 2 == 0 ? i : count - 1 - i); });
        BoneWeights out{Buffer<VertexJoints>(vertices, pace_.memory()),
                        Buffer<VertexWeights>(vertices, pace_.memory())};
        co_await each(pace_, vertices, Cost::tens_of_ns, [&](uint32_t v) { finish(v, out); });
        spreads_ = {};
        co_await pace_;
        neighbours_ = {};
        co_await pace_;
        co_return out;
    }

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

private:
    // A neighbour of a vertex that is spread again: where each of its four is among the vertex' many joints.
    struct Neighbour {
        uint32_t vertex;
        float pull;
        std::array<uint8_t, 4> places;
    };

    Candidates candidates(uint32_t v) const {
        return {many_.of_vertex[v], std::sqrt(many_.spread[v]), mesh_.positions[v], pivots_};
    }

    void choose(uint32_t v) {
        const Candidates all = candidates(v);
        chosen_[v] = all.choose();
        keep(v, all);
    }

    // The weights of those that stay, with what they take.
    void keep(uint32_t v, const Candidates& all) {
        std::array<double, most> sums = all.weights;
        for (uint32_t k = 0; k < all.count(); ++k) {
            if (chosen_[v].places >> k & 1) continue;
            const std::array<double, most> takes = all.share(k, chosen_[v].places, all.weights);
            for (uint32_t m = 0; m < all.count(); ++m) sums[m] += all.weights[k] * takes[m];
        }
        weights_[v].fill(0);
        places_[v].fill(0);
        uint32_t place = 0;
        for (uint32_t k = 0; k < all.count(); ++k) {
            if (!(chosen_[v].places >> k & 1)) continue;
            weights_[v][place] = static_cast<float>(sums[k]);
            places_[v][place++] = static_cast<uint8_t>(k);
        }
    }

    Task<void> spread_loss() {
        const size_t vertices = mesh_.positions.size();
        Buffer<float> before(vertices, pace_.memory());
        for (uint32_t ring = 0; ring < loss_rings; ++ring) {
            co_await each(pace_, vertices, Cost::some_ns, [&](uint32_t v) { before[v] = chosen_[v].lost; });
            co_await each(pace_, mesh_.triangles.size(), Cost::tens_of_ns, [&](uint32_t t) {
                const TriangleVertices& c = mesh_.triangles[t];
                const float most_lost = std::max({before[c[0]], before[c[1]], before[c[2]]});
                for (const uint32_t v : c)
                    chosen_[v].lost = std::max(chosen_[v].lost, static_cast<float>(loss_fading) * most_lost);
            });
        }
    }

    void begin(Spread& spread) {
        const uint32_t v = spread.vertex;
        const Candidates all = candidates(v);
        spread.hold = hold / chosen_[v].lost;
        spread.had = weights_[v];
        for (uint32_t k = 0; k < most; ++k) {
            spread.takes[k].fill(0);
            if (k >= all.count()) continue;
            if (chosen_[v].places >> k & 1) {
                for (uint32_t m = 0; m < 4; ++m)
                    if (places_[v][m] == k && weights_[v][m] > 0) spread.takes[k][m] = 1;
                continue;
            }
            const std::array<double, most> takes = all.share(k, chosen_[v].places, all.weights);
            for (uint32_t m = 0; m < 4; ++m) spread.takes[k][m] = static_cast<float>(takes[places_[v][m]]);
        }
    }

    Task<void> find_neighbours() {
        const size_t count = spreads_.size();
        first_ = Buffer<uint32_t>(count + 1, pace_.memory());
        first_[0] = 0;
        co_await each(pace_, count, Cost::some_ns, [&](uint32_t i) {
            first_[i + 1] = first_[i] + static_cast<uint32_t>(corners_.of(spreads_[i].vertex).size());
        });
        neighbours_ = Buffer<Neighbour>(first_[count], pace_.memory());
        co_await each(pace_, count, Cost::microseconds, [&](uint32_t i) {
            const uint32_t v = spreads_[i].vertex;
            const ManyJoints& own = many_.of_vertex[v];
            double sum = 0;
            uint32_t at = first_[i];
            for (const uint32_t corner : corners_.of(v)) {
                const uint32_t w = mesh_.triangles[corner / 3][(corner + 1) % 3];
                Neighbour& neighbour = neighbours_[at++];
                const double pull = 1 / (mesh_.positions[w] - mesh_.positions[v]).norm();
                sum += pull;
                neighbour = {w, static_cast<float>(pull), {}};
                for (uint32_t m = 0; m < 4; ++m) {
                    const uint16_t joint = many_.of_vertex[w].joints[places_[w][m]];
                    const auto found = std::find(own.joints.begin(), own.joints.end(), joint);
                    neighbour.places[m] = static_cast<uint8_t>(found - own.joints.begin());
                }
            }
            for (uint32_t k = first_[i]; k < at; ++k) neighbours_[k].pull /= static_cast<float>(sum);
            // Where edges are short, as beside a border, a vertex stands for less of the surface.
            const double length = (at - first_[i]) / (sum * mesh_.spacing);
            spreads_[i].hold *= static_cast<float>(std::min(1.0, length * length));
        });
    }

    void smooth(uint32_t i) {
        const Spread& spread = spreads_[i];
        Four sums;
        for (uint32_t m = 0; m < 4; ++m) sums[m] = spread.hold * spread.had[m];
        for (uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
            const Neighbour& neighbour = neighbours_[k];
            const Four& theirs = weights_[neighbour.vertex];
            for (uint32_t n = 0; n < 4; ++n) {
                if (neighbour.places[n] >= most) continue;
                const Four& takes = spread.takes[neighbour.places[n]];
                const float pull = neighbour.pull * theirs[n];
                for (uint32_t m = 0; m < 4; ++m) sums[m] += pull * takes[m];
            }
        }
        const float sum = sums[0] + sums[1] + sums[2] + sums[3];
        if (!(sum > 0)) return;
        for (uint32_t m = 0; m < 4; ++m) weights_[spread.vertex][m] = sums[m] / sum;
    }

    void finish(uint32_t v, BoneWeights& out) const {
        const Four& weights = weights_[v];
        const float sum = weights[0] + weights[1] + weights[2] + weights[3];
        std::array<uint32_t, 4> order = {0, 1, 2, 3};
        std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
            return weights[a] > weights[b] || (weights[a] == weights[b] && a < b);
        });
        for (uint32_t k = 0; k < 4; ++k) {
            const float weight = weights[order[k]] / sum;
            out.weights[v][k] = weight;
            out.joints[v][k] = weight > 0 ? many_.of_vertex[v].joints[places_[v][order[k]]] : uint16_t{0};
        }
    }

    Pace& pace_;
    const MergedMesh& mesh_;
    const Groups& corners_;
    const ManyWeights& many_;
    const Pivots& pivots_;
    Buffer<Chosen> chosen_;
    Buffer<Four> weights_;
    Buffer<std::array<uint8_t, 4>> places_;  // of a vertex' four among its many
    Buffer<Spread> spreads_;
    Buffer<uint32_t> first_;  // neighbour of each that is spread again
    Buffer<Neighbour> neighbours_;
};

}  // namespace

Task<BoneWeights> keep_four_joints(Pace& pace, const MergedMesh& mesh, const ManyWeights& many, BoneRig rig) {
    const Groups corners = co_await group_by(pace, 3 * mesh.triangles.size(), mesh.positions.size(),
                                             [&](uint32_t i) { return mesh.triangles[i / 3][i % 3]; });
    const Pivots pivots = co_await Pivots::make(pace, rig);
    FourJoints four(pace, mesh, corners, many, pivots);
    co_return co_await four.run();
}

}  // namespace flg
