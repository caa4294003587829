// SPDX-License-Identifier: MIT
#include "rigs/limb_roles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace flg {

namespace {

constexpr uint32_t nothing = FLG_NO_INDEX;

// Shares of the model's height.
constexpr double foot_height = 0.2;  // feet end so near to the ground
constexpr double low_height = 0.35;  // and the legs of what has more than two
// Shares of the model's size, the diagonal of its joints' box.
constexpr double flat = 0.05;          // nothing is farther from the middle: seen from the side
constexpr double beside = 0.01;        // of what lies to a side
constexpr double foot_size = 0.1;      // toes branch apart not farther from their ends
constexpr double mirror_error = 0.15;  // between a tip and the mirror image of another
constexpr double alike_error = 0.07;   // the same, where four legs look alike to both ends
constexpr double shortest_arm = 0.15, nearest_arm = 0.1, shortest_head = 0.06, shortest_tail = 0.12;
constexpr double arm_width = 0.08;     // an arm's distance from the middle, where it is farthest
constexpr double straight_on = 0.02;   // to the side, from joint to joint of a head
constexpr double arm_begins = 0.05;    // share of that
constexpr double middle_width = 0.12;  // of limbs in the middle, on average
// What hangs falls by this share of its length; what is level, by no more.
constexpr double hanging = 0.5;
constexpr double thick = 0.6;           // share of the root's radius that bones of a trunk have
constexpr double symmetric = 0.6;       // share of tips with a mirror image: all but two of five
constexpr double ends_there = 0.5;      // how much two limbs count as arms beyond which there is no head
constexpr double alike = 0.75;          // a limb by a longer one that it is the pair of, however they point
constexpr double head_thickness = 0.8;  // share of its largest radius that the head's last joint has
constexpr double height_counts = 0.3;   // of a head against its thickness

class LimbFinder {
public:
    LimbFinder(const RigSkeleton& skeleton, std::span<FlgRigJoint> joints, Memory* memory)
        : count_(static_cast<uint32_t>(skeleton.at.size())),
          skeleton_(skeleton),
          joints_(joints),
          first_child_(count_, nothing, memory),
          sibling_(count_, nothing, memory),
          root_of_(count_, 0, memory),
          feet_(count_, 0, memory),
          tips_(memory),
          reach_(count_, 0, memory),
          foot_depth_(count_, 0, memory),
          bulk_(count_, 0, memory),
          lateral_(count_, 0, memory),
          along_(count_, 0, memory),
          height_(count_, 0, memory),
          is_trunk_(count_, 0, memory),
          is_taken_(count_, 0, memory),
          is_within_(count_, 0, memory) {}

    RigFrame find(const Vec3& up, const Vec3& left) {
        link();
        frame_.up = up;
        find_ground();
        set_frame(up, left);
        for (uint32_t j = 0; j < count_; ++j) {
            joints_[j] = {};
            joints_[j].limb = FLG_LIMB_OTHER;
            joints_[j].next = longest_child(j);
        }
        find_feet();
        is_trunk_[root_] = 1;
        for (uint32_t j = 0; j < count_; ++j)
            if (feet_[j] >= 2) mark_trunk(j);
        if (is_flat_) lengthen_trunk();
        find_legs();
        find_arms();
        find_head();
        find_tail();
        name_trunk();
        name_sides();
        return frame_;
    }

private:
    double bone(uint32_t j) const { return (skeleton_.at[j] - skeleton_.at[skeleton_.parents[j]]).norm(); }
    bool is_tip(uint32_t j) const { return first_child_[j] == nothing; }
    template <class Visit>
    void visit_children(uint32_t j, Visit visit) const {
        for (uint32_t c = first_child_[j]; c != nothing; c = sibling_[c]) visit(c);
    }

    void link() {
        std::pmr::vector<double> length(count_, 0, reach_.get_allocator());
        for (uint32_t j = count_; j-- > 0;) {
            const uint32_t parent = skeleton_.parents[j];
            bulk_[j] += std::pow(skeleton_.radii[j], 3);
            if (parent == nothing) continue;
            sibling_[j] = first_child_[parent];
            first_child_[parent] = j;
            reach_[parent] = std::max(reach_[parent], reach_[j] + bone(j));
            bulk_[parent] += bulk_[j];
        }
        for (uint32_t j = 0; j < count_; ++j) {
            const uint32_t parent = skeleton_.parents[j];
            root_of_[j] = parent == nothing ? j : root_of_[parent];
            if (parent != nothing) length[root_of_[j]] += bone(j);
        }
        root_ = static_cast<uint32_t>(std::max_element(length.begin(), length.end()) - length.begin());
        for (uint32_t j = 0; j < count_; ++j)
            if (is_ours(j) && is_tip(j)) tips_.push_back(j);
        Vec3 low = skeleton_.at[root_], high = low;
        for (uint32_t j = 0; j < count_; ++j) {
            if (!is_ours(j)) continue;
            low = low.cwiseMin(skeleton_.at[j]);
            high = high.cwiseMax(skeleton_.at[j]);
        }
        size_ = (high - low).norm();
    }
    bool is_ours(uint32_t j) const { return root_of_[j] == root_; }

    void set_frame(const Vec3& up, const Vec3& left) {
        const Vec3 level = left - left.dot(up) * up;
        left_is_known_ = level.norm() > 0;
        if (left_is_known_) {
            set_left(level.normalized());
        } else {
            const Vec3 x = Vec3::UnitX() - up.x() * up;
            set_left((x.norm() > 0.5 ? x : Vec3(Vec3::UnitY() - up.y() * up)).normalized());
            if (!looks_ahead()) set_left(-frame_.left.cross(up));
        }
        double widest = 0;
        for (uint32_t j = 0; j < count_; ++j)
            if (is_ours(j)) widest = std::max(widest, std::abs(lateral_[j]));
        is_flat_ = widest <= flat * size_;
    }

    void find_ground() {
        double low = INFINITY, high = -double{INFINITY};
        for (uint32_t j = 0; j < count_; ++j) {
            if (!is_ours(j)) continue;
            low = std::min(low, frame_.up.dot(skeleton_.at[j]) - skeleton_.radii[j]);
            high = std::max(high, frame_.up.dot(skeleton_.at[j]) + skeleton_.radii[j]);
        }
        frame_.ground = low;
        tallness_ = high - low;
    }

    // Whether the middle, as it is assumed, is one: most tips have an image. From the side four legs look alike to both
    // ends; so there more than half of the other tips must have an image as well, with where they branch off.
    bool looks_ahead() const {
        uint32_t mirrored = 0, low = 0, high_alike = 0;
        for (const uint32_t tip : tips_) {
            bool is_mirrored = false, is_alike = false;
            for (const uint32_t other : tips_) {
                if (!are_mirrored(tip, other)) continue;
                is_mirrored = true;
                is_alike = is_alike || are_alike(tip, other);
            }
            mirrored += is_mirrored;
            const bool is_low = height_[tip] <= frame_.ground + low_height * tallness_;
            low += is_low;
            high_alike += !is_low && is_alike;
        }
        const auto tips = static_cast<uint32_t>(tips_.size());
        return mirrored >= symmetric * tips && (low < 4 || low == tips || 2 * high_alike > tips - low);
    }

    void set_left(const Vec3& left) {
        frame_.left = left;
        frame_.forward = left.cross(frame_.up);
        for (uint32_t j = 0; j < count_; ++j) {
            const Vec3 from_root = skeleton_.at[j] - skeleton_.at[root_];
            lateral_[j] = frame_.left.dot(from_root);
            along_[j] = frame_.forward.dot(from_root);
            height_[j] = frame_.up.dot(skeleton_.at[j]);
        }
    }

    double mirror_distance(uint32_t a, uint32_t b) const {
        return std::hypot(lateral_[a] + lateral_[b], along_[a] - along_[b], height_[a] - height_[b]);
    }
    // Tips and where they branch off.
    bool are_alike(uint32_t a, uint32_t b) const {
        return std::max(mirror_distance(a, b), mirror_distance(end_of(a).base, end_of(b).base)) <= alike_error * size_;
    }
    bool are_mirrored(uint32_t a, uint32_t b) const { return mirror_distance(a, b) <= mirror_error * size_; }

    // The lowest joint between a tip and where it branches off.
    struct End {
        uint32_t lowest, base;
    };
    End end_of(uint32_t tip) const {
        End end{tip, tip};
        while (end.base != root_ && (end.base == tip || sole_child(end.base))) {
            if (height_[end.base] < height_[end.lowest]) end.lowest = end.base;
            end.base = skeleton_.parents[end.base];
        }
        return end;
    }
    bool sole_child(uint32_t j) const { return first_child_[j] != nothing && sibling_[first_child_[j]] == nothing; }

    uint32_t mark_feet(double share) {
        std::fill(feet_.begin(), feet_.end(), 0u);
        for (const uint32_t tip : tips_) {
            const End end = end_of(tip);
            const Vec3 way = skeleton_.at[end.lowest] - skeleton_.at[end.base];
            const bool hangs = -frame_.up.dot(way) >= hanging * way.norm() && tip != root_;
            const bool lies_beside = std::abs(lateral_[end.lowest]) > beside * size_;
            if (height_[end.lowest] > frame_.ground + share * tallness_ || (is_flat_ ? !hangs : !lies_beside)) continue;
            feet_[tip] = 1;
        }
        std::fill(foot_depth_.begin(), foot_depth_.end(), 0.0);
        for (uint32_t j = count_; j-- > 0;) {
            visit_children(j, [&](uint32_t c) {
                if (feet_[c] == 0) return;
                feet_[j] += feet_[c];
                foot_depth_[j] = std::max(foot_depth_[j], foot_depth_[c] + bone(c));
            });
            if (foot_depth_[j] < foot_size * size_) feet_[j] = std::min(feet_[j], 1u);
        }
        return feet_[root_];
    }

    void find_feet() {
        if (mark_feet(foot_height) >= 4 && !is_flat_) mark_feet(low_height);
    }

    void mark_trunk(uint32_t j) {
        for (; !is_trunk_[j]; j = skeleton_.parents[j]) is_trunk_[j] = 1;
    }

    void lengthen_trunk() {
        for (uint32_t j = 0; j < count_; ++j) {
            const uint32_t parent = skeleton_.parents[j];
            if (!is_ours(j) || is_trunk_[j] || j == root_ || !is_trunk_[parent] || feet_[j] == 0 || is_tip(j)) continue;
            const bool is_level = std::abs(height_[j] - height_[parent]) <= hanging * bone(j);
            if (is_level && skeleton_.radii[j] >= thick * skeleton_.radii[root_]) is_trunk_[j] = 1;
        }
    }

    // Names a limb's joints from its first one to its tip, and keeps what branches off from being another limb.
    template <class Next>
    void name_limb(FlgLimb limb, uint32_t first, int32_t side, uint32_t pair, Next next) {
        uint32_t index = 0;
        for (uint32_t j = first; j != nothing;) {
            const uint32_t after = next(j);
            joints_[j].limb = limb;
            joints_[j].side = side;
            joints_[j].pair = pair;
            joints_[j].index = index++;
            joints_[j].next = after;
            j = after;
        }
        take(first);
    }
    void take(uint32_t first) {
        is_taken_[first] = 1;
        for (uint32_t j = first + 1; j < count_; ++j)
            if (skeleton_.parents[j] != nothing && is_taken_[skeleton_.parents[j]]) is_taken_[j] = 1;
    }

    // Of the children with the most of something.
    template <class Measure>
    uint32_t best_child(uint32_t j, Measure measure) const {
        uint32_t best = nothing;
        visit_children(j, [&](uint32_t c) {
            if (best == nothing || measure(c) > measure(best)) best = c;
        });
        return best;
    }
    uint32_t longest_child(uint32_t j) const {
        return best_child(j, [&](uint32_t c) { return reach_[c] + bone(c); });
    }

    struct Leg {
        uint32_t first, foot, twin = nothing;
        double along;
    };

    uint32_t next_to_foot(uint32_t j) const {
        const uint32_t next = best_child(j, [&](uint32_t c) { return feet_[c] ? foot_depth_[c] + bone(c) : -1.0; });
        return next != nothing && feet_[next] == 0 ? nothing : next;
    }

    void find_legs() {
        std::pmr::vector<Leg> legs(tips_.get_allocator());
        for (uint32_t j = 0; j < count_; ++j) {
            if (!is_ours(j) || is_trunk_[j] || feet_[j] == 0 || !is_trunk_[skeleton_.parents[j]]) continue;
            uint32_t foot = j;
            while (next_to_foot(foot) != nothing) foot = next_to_foot(foot);
            legs.push_back({j, foot, nothing, along_[j] + along_[foot]});
        }
        leg_count_ = static_cast<uint32_t>(legs.size());
        for (uint32_t a = 0; a < legs.size(); ++a) pair_leg(legs, a);
        // Both of a pair stand side by side, the pairs from the front to the back.
        for (Leg& leg : legs)
            if (leg.twin != nothing) leg.along = (leg.along + legs[leg.twin].along) / 2;
        std::pmr::vector<uint32_t> firsts(tips_.get_allocator());
        for (uint32_t a = 0; a < legs.size(); ++a)
            if (legs[a].twin == nothing || a < legs[a].twin) firsts.push_back(a);
        std::sort(firsts.begin(), firsts.end(), [&](uint32_t a, uint32_t b) {
            return legs[a].along != legs[b].along ? legs[a].along > legs[b].along : a < b;
        });
        for (uint32_t pair = 0; pair < firsts.size(); ++pair) {
            const Leg& leg = legs[firsts[pair]];
            const auto next = [&](uint32_t j) { return next_to_foot(j); };
            name_limb(FLG_LIMB_LEG, leg.first, leg.twin == nothing ? 0 : side_of(leg.foot), pair, next);
            if (leg.twin != nothing)
                name_limb(FLG_LIMB_LEG, legs[leg.twin].first, side_of(legs[leg.twin].foot), pair, next);
        }
    }

    void pair_leg(std::pmr::vector<Leg>& legs, uint32_t a) const {
        if (legs[a].twin != nothing || is_flat_) return;
        const auto error = [&](uint32_t b) {
            return mirror_distance(legs[a].foot, legs[b].foot) + mirror_distance(legs[a].first, legs[b].first);
        };
        uint32_t best = nothing;
        for (uint32_t b = 0; b < legs.size(); ++b) {
            if (b == a || legs[b].twin != nothing || side_of(legs[b].foot) == side_of(legs[a].foot)) continue;
            if (error(b) <= 2 * mirror_error * size_ && (best == nothing || error(b) < error(best))) best = b;
        }
        if (best == nothing) return;
        legs[a].twin = best;
        legs[best].twin = a;
    }
    int32_t side_of(uint32_t j) const { return lateral_[j] > 0 ? 1 : -1; }

    // Where the ways of two joints to the root meet, and how long they are.
    struct Meeting {
        uint32_t joint;
        double shorter, longer, above_trunk;
    };
    Meeting meet(uint32_t a, uint32_t b) const {
        double length_a = 0, length_b = 0, above = 0;
        while (a != b) {
            if (a > b) {
                length_a += bone(a);
                a = skeleton_.parents[a];
            } else {
                length_b += bone(b);
                b = skeleton_.parents[b];
            }
        }
        for (uint32_t j = a; !is_trunk_[j]; j = skeleton_.parents[j]) above += bone(j);
        return {a, std::min(length_a, length_b), std::max(length_a, length_b), above};
    }

    void find_arms() {
        // Arms that point to different places are found where none are mirrored.
        if (!find_hands(true) && leg_count_ <= 2) find_hands(false);
        if (chest_ == nothing) return;
        hip_is_chest_ = is_trunk_[chest_] && (feet_[chest_] >= 2 || chest_ == root_);
        mark_trunk(chest_);
    }

    bool find_hands(bool mirrored) {
        double best = 0;
        for (const uint32_t l : tips_) {
            if (is_taken_[l] || lateral_[elbow_of(l)] < arm_width * size_) continue;
            for (const uint32_t r : tips_) {
                if (is_taken_[r] || lateral_[elbow_of(r)] > -arm_width * size_) continue;
                if (mirrored && !are_mirrored(l, r)) continue;
                const Meeting meeting = meet(l, r);
                if (meeting.shorter < shortest_arm * size_) continue;
                if (!mirrored && meeting.shorter < alike * meeting.longer) continue;
                if (leg_count_ > 2 && meeting.above_trunk > nearest_arm * size_) continue;
                // Ears may be longer, but end it: on arms hangs a head.
                const double score =
                    (meeting.shorter - meeting.above_trunk / 2) * (goes_on(meeting.joint) ? 1 : ends_there);
                if (score <= best) continue;
                best = score;
                hands_[0] = l;
                hands_[1] = r;
                chest_ = meeting.joint;
            }
        }
        return chest_ != nothing;
    }

    // Whether two other branches leave where two limbs meet.
    bool goes_on(uint32_t meeting) const {
        uint32_t branches = meeting == root_ ? 0 : 1;
        visit_children(meeting, [&](uint32_t) { ++branches; });
        return branches >= 4;
    }

    // Where an arm is farthest from the middle: hands may lie on the hips, or across the chest.
    uint32_t elbow_of(uint32_t hand) const {
        uint32_t elbow = hand;
        for (uint32_t j = hand; j != nothing && !is_trunk_[j]; j = skeleton_.parents[j])
            if (std::abs(lateral_[j]) > std::abs(lateral_[elbow])) elbow = j;
        return elbow;
    }

    bool is_on_arm(uint32_t j) const {
        for (const uint32_t hand : hands_)
            for (uint32_t k = hand; k != nothing && !is_trunk_[k]; k = skeleton_.parents[k])
                if (k == j) return true;
        return false;
    }

    struct Sums {
        double lateral = 0, along = 0, height = 0, count = 0;
    };
    Sums mean_of(uint32_t first) {
        Sums sums;
        std::fill(is_within_.begin(), is_within_.end(), uint8_t{0});
        for (uint32_t j = first; j < count_; ++j) {
            if (j != first && (skeleton_.parents[j] == nothing || !is_within_[skeleton_.parents[j]])) continue;
            is_within_[j] = 1;
            sums.lateral += lateral_[j];
            sums.along += along_[j];
            sums.height += height_[j];
            sums.count += 1;
        }
        sums.lateral /= sums.count;
        sums.along /= sums.count;
        sums.height /= sums.count;
        return sums;
    }

    // What begins a limb that has no name yet.
    bool may_begin(uint32_t j) const {
        return is_ours(j) && j != root_ && !is_trunk_[j] && !is_taken_[j] && !is_on_arm(j);
    }

    void find_head() {
        uint32_t head = nothing;
        double best = 0;
        Sums at;
        for (uint32_t j = 0; j < count_; ++j) {
            if (!may_begin(j)) continue;
            const uint32_t parent = skeleton_.parents[j];
            if ((!is_trunk_[parent] && !is_on_arm(parent)) || reach_[j] + bone(j) < shortest_head * size_) continue;
            const Sums mean = mean_of(j);
            if (std::abs(mean.lateral) > middle_width * size_) continue;
            const double ahead = left_is_known_ ? height_counts * mean.along : 0;
            const double score = std::cbrt(bulk_[j]) + height_counts * (mean.height - height_[parent]) + ahead;
            if (score <= best) continue;
            best = score;
            head = j;
            at = mean;
        }
        if (head == nothing) return name_arms();
        mark_trunk(skeleton_.parents[head]);
        name_arms();
        if (is_flat_ && !left_is_known_ && at.along < 0) turn_around();
        name_head(head);
    }

    void turn_around() {
        set_left(-frame_.left);
        uint32_t pairs = 0;
        for (const FlgRigJoint& joint : joints_)
            if (joint.limb == FLG_LIMB_LEG) pairs = std::max(pairs, joint.pair + 1);
        for (FlgRigJoint& joint : joints_)
            if (joint.limb == FLG_LIMB_LEG) joint.pair = pairs - 1 - joint.pair;
    }

    void name_arms() {
        if (chest_ == nothing) return;
        for (const uint32_t hand : hands_) {
            const uint32_t elbow = elbow_of(hand);
            // What is not on the arm's side yet leads to it.
            for (uint32_t j = skeleton_.parents[elbow]; !is_trunk_[j]; j = skeleton_.parents[j])
                if (lateral_[j] * side_of(elbow) < arm_begins * std::abs(lateral_[elbow])) mark_trunk(j);
            uint32_t next = nothing;
            for (uint32_t j = hand; !is_trunk_[j]; j = skeleton_.parents[j]) {
                joints_[j].next = j == hand ? joints_[j].next : next;
                next = j;
            }
            name_limb(FLG_LIMB_ARM, next, side_of(elbow), 0,
                      [&](uint32_t j) { return j == hand ? nothing : joints_[j].next; });
        }
    }

    void name_head(uint32_t first) {
        // Ears and horns are none of it.
        const auto next = [&](uint32_t j) {
            const auto goes_on = [&](uint32_t c) { return std::abs(lateral_[c] - lateral_[j]) <= straight_on * size_; };
            const uint32_t best = best_child(j, [&](uint32_t c) { return goes_on(c) ? bulk_[c] : -1.0; });
            return best != nothing && goes_on(best) ? best : nothing;
        };
        double largest = 0;
        for (uint32_t j = first; j != nothing; j = next(j)) largest = std::max(largest, skeleton_.radii[j]);
        uint32_t head = first;
        for (uint32_t j = first; j != nothing; j = next(j))
            if (skeleton_.radii[j] >= head_thickness * largest) head = j;
        name_limb(FLG_LIMB_NECK, first, 0, 0, next);
        uint32_t index = 0;
        for (uint32_t j = head; j != nothing; j = joints_[j].next) {
            joints_[j].limb = FLG_LIMB_HEAD;
            joints_[j].index = index++;
        }
    }

    void find_tail() {
        uint32_t tail = nothing;
        double longest = shortest_tail * size_;
        for (uint32_t j = 0; j < count_; ++j) {
            if (!may_begin(j) || !is_trunk_[skeleton_.parents[j]]) continue;
            if (skeleton_.parents[j] == chest_ && !hip_is_chest_) continue;
            const Sums mean = mean_of(j);
            if (std::abs(mean.lateral) > middle_width * size_ || reach_[j] + bone(j) <= longest) continue;
            if (mean.along > beside * size_) continue;
            longest = reach_[j] + bone(j);
            tail = j;
        }
        if (tail != nothing) name_limb(FLG_LIMB_TAIL, tail, 0, 0, [&](uint32_t j) { return longest_child(j); });
    }

    void name_trunk() {
        for (uint32_t j = 0; j < count_; ++j) {
            if (!is_trunk_[j]) continue;
            FlgRigJoint& joint = joints_[j];
            joint.limb = FLG_LIMB_TRUNK;
            joint.index = j == root_ ? 0 : joints_[skeleton_.parents[j]].index + 1;
            // Where it goes on: to the head, else along most of it.
            joint.next = best_child(j, [&](uint32_t c) {
                const bool leads = joints_[c].limb == FLG_LIMB_NECK || joints_[c].limb == FLG_LIMB_HEAD;
                return bulk_[c] + (is_trunk_[c] ? 2 : leads ? 1 : 0) * bulk_[root_];
            });
        }
    }

    void name_sides() {
        for (uint32_t j = 0; j < count_; ++j)
            if (joints_[j].limb == FLG_LIMB_OTHER && std::abs(lateral_[j]) > beside * size_)
                joints_[j].side = side_of(j);
    }

    const uint32_t count_;
    const RigSkeleton& skeleton_;
    std::span<FlgRigJoint> joints_;
    std::pmr::vector<uint32_t> first_child_, sibling_, root_of_, feet_, tips_;
    std::pmr::vector<double> reach_, foot_depth_, bulk_;  // below a joint: longest way, to a foot, sum of cubed radii
    std::pmr::vector<double> lateral_, along_, height_;
    std::pmr::vector<uint8_t> is_trunk_, is_taken_, is_within_;
    RigFrame frame_{};
    uint32_t root_ = 0, leg_count_ = 0, chest_ = nothing;
    uint32_t hands_[2] = {nothing, nothing};
    double size_ = 0, tallness_ = 0;
    bool is_flat_ = false, left_is_known_ = false, hip_is_chest_ = false;
};

}  // namespace

RigFrame find_limbs(const RigSkeleton& skeleton, const Vec3& up, const Vec3& left, std::span<FlgRigJoint> joints,
                    Memory* memory) {
    return LimbFinder(skeleton, joints, memory).find(up, left);
}

}  // namespace flg
