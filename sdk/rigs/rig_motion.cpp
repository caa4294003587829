// SPDX-License-Identifier: MIT
#include "rigs/rig_motion.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/failure.h"
#include "rigs/joint_limits.h"

namespace flg {

namespace {

constexpr uint32_t none = FLG_NO_INDEX;
constexpr double turn = 2 * std::numbers::pi;

// Shares of the shortest leg's length.
constexpr double half_stride = 0.3, foot_lift = 0.15, hip_sway = 0.015, hip_bob = 0.015;
constexpr double lowest_hips = 0.15;       // hips are lowered no further: the stride becomes shorter
constexpr double nearly_straight = 0.998;  // share of its length that a leg in use may have
constexpr double shorter_stride = 0.85;    // the next one tried
constexpr int stride_tries = 16;
constexpr double reached = 1e-6;                                 // share of a leg's length that its foot may be off
constexpr double standing_of_two = 0.6, standing_of_more = 0.7;  // share of the cycle

// Radians.
constexpr double arm_swing = 0.35, elbow_bend = 0.3, arms_aside = 0.35, highest_lowered = 0.3, trunk_twist = 0.05,
                 head_turn = 0.06;
constexpr double tail_wag = 0.12, tail_later = 0.5;
constexpr double breath = 0.025, look = 0.12, arm_sway = 0.05;
constexpr double upper_arm_rise = 0.35, straight_arm_rise = 0.6;  // tangents
constexpr double forearm_bend = 1.3;
constexpr double wave_swing = 0.35, paw_lift = 0.7, paw_bend = 0.9, paw_swing = 0.25;

constexpr double waves = 3;       // in a cycle
constexpr double lifting = 0.25;  // share of the cycle that an arm takes up, and down

double smooth_step(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

constexpr double error_counts = 1e6;  // radians for an error as large as what is turned

// The turn by an angle between two about an axis at which `a cos + b sin` is `value`, or next to it: the one nearest to
// none.
double solve_turn(double a, double b, double value, double low, double high) {
    const double size = std::hypot(a, b);
    if (size == 0) return 0;
    const double middle = std::atan2(b, a), aside = std::acos(std::clamp(value / size, -1.0, 1.0));
    double best = 0, least = INFINITY;
    for (const double side : {-1, 1}) {
        const double found = std::remainder(middle + side * aside, turn), angle = std::clamp(found, low, high);
        const double error = std::abs(a * std::cos(angle) + b * std::sin(angle) - value);
        const double cost = error / size * error_counts + std::abs(angle);
        if (cost >= least) continue;
        least = cost;
        best = angle;
    }
    return best;
}

class PoseMaker {
public:
    PoseMaker(const Rig& rig, double phase, MotionPose& pose) : rig_(rig), phase_(phase), pose_(pose) {
        for (uint32_t first = 0; first < rig.count(); ++first) {
            if (!rig.begins(first, FLG_LIMB_LEG)) continue;
            pairs_ = std::max(pairs_, rig.joint(first).pair + 1);
            for (uint32_t j = first; j != none && !carries_legs_[j]; j = rig.parent(j)) carries_legs_[j] = true;
        }
    }

    void walk() {
        bool any = false;
        double shortest = INFINITY;
        each_leg([&](const Leg& leg) {
            any = true;
            shortest = std::min(shortest, (rig_.at(leg.end) - rig_.at(leg.upper)).norm());
        });
        if (!any) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no walk: it has no leg of two joints or more");
        rest();
        double stride = half_stride * shortest, lowered = 0;
        for (int i = 0; i < stride_tries; ++i, stride *= shorter_stride) {
            lowered = lowering(stride);
            if (lowered <= lowest_hips * shortest) break;
        }
        lowered = std::min(lowered, lowest_hips * shortest);  // where no stride is short enough
        const double standing = pairs_ == 1 ? standing_of_two : standing_of_more;
        pose_.travel = 2 * stride / standing * rig_.forward;
        const double cycle = turn * phase_;
        pose_.translation = -(lowered + hip_bob * shortest * (1 - std::cos(2 * cycle)) / 2) * rig_.up;
        if (pairs_ == 1) pose_.translation += hip_sway * shortest * std::sin(cycle) * rig_.left;
        if (!has_hinge_) pose_.translation = -pendulum_drop(stride, standing) * rig_.up;
        each_leg([&](const Leg& leg) {
            const Step step = step_at(phase_of(leg), standing);
            place_foot(leg, stride * step.along * rig_.forward + foot_lift * shortest * step.lift * rig_.up);
        });
        swing_arms(cycle);
        for (uint32_t j = 0; j < rig_.count(); ++j) {
            const FlgRigJoint& joint = rig_.joint(j);
            if (joint.limb == FLG_LIMB_TRUNK && !carries_legs_[j])
                set(j, turned(rig_.up, -trunk_twist * std::cos(cycle)));
            if (rig_.begins(j, FLG_LIMB_HEAD)) set(j, turned(rig_.left, head_turn * std::cos(2 * cycle)));
        }
        wag_tail(cycle, tail_wag);
    }

    void idle() {
        rest();
        const double cycle = turn * phase_;
        for (uint32_t j = 0; j < rig_.count(); ++j) {
            const FlgRigJoint& joint = rig_.joint(j);
            if (joint.limb == FLG_LIMB_TRUNK && rig_.parent(j) != none && !carries_legs_[j])
                set(j, turned(rig_.left, breath * std::sin(2 * cycle)));
            if (rig_.begins(j, FLG_LIMB_HEAD))
                set(j, turned(rig_.up, look * std::sin(cycle)) * turned(rig_.left, breath * std::sin(2 * cycle)));
        }
        each_arm([&](const Arm& arm) {
            set(arm.upper, turned(rig_.forward, arm_sway * arm.side * (1 - std::cos(cycle))) * lowered(arm));
        });
        wag_tail(cycle, 2 * tail_wag);
    }

    void wave() {
        const double raised = smooth_step(phase_ / lifting) * smooth_step((1 - phase_) / lifting);
        const double swing = raised * std::sin(turn * waves * phase_);
        std::optional<Arm> right;
        each_arm([&](const Arm& arm) {
            if (arm.side < 0) right = arm;
        });
        if (right) {
            rest();
            each_arm([&](const Arm& arm) { set(arm.upper, lowered(arm)); });
            return wave_arm(*right, raised, swing);
        }
        std::optional<Leg> paw;
        each_leg([&](const Leg& leg) {
            if (!paw && leg.pair == 0 && leg.side <= 0 && pairs_ > 1) paw = leg;
        });
        if (!paw) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no wave: it has neither arms nor front legs to lift");
        rest();
        wave_paw(*paw, raised, swing);
    }

private:
    struct Leg {
        uint32_t upper, middle, end;
        uint32_t pair;
        int32_t side;
    };

    void wave_paw(const Leg& leg, double raised, double swing) {
        const Vec3 way = rig_.direction(leg.upper, leg.end);
        // What hangs goes to the front, what lies beside the body up; then both swing aside.
        const bool hangs = std::abs(way.dot(rig_.up)) > std::abs(way.dot(rig_.left));
        const Vec3 &to = hangs ? rig_.forward : rig_.up, &about = hangs ? rig_.left : rig_.forward;
        const Vec3 lift = way.cross(to);
        const Vec3 axis = lift.norm() > 0 ? lift.normalized() : about;
        set(leg.upper, turned(axis, paw_lift * raised) * turned(to, paw_swing * swing));
        if (leg.middle != none) bend(leg.middle, paw_bend * raised);
    }

    template <class Visit>
    void each_leg(Visit visit) {
        for (uint32_t j = 0; j < rig_.count(); ++j) {
            if (!rig_.begins(j, FLG_LIMB_LEG)) continue;
            const Leg leg{rig_.find(j, FLG_LIMB_PLACE_UPPER), rig_.find(j, FLG_LIMB_PLACE_MIDDLE),
                          rig_.find(j, FLG_LIMB_PLACE_END), rig_.joint(j).pair, rig_.joint(j).side};
            if (leg.upper == none || leg.end == none) continue;
            has_hinge_ = has_hinge_ || leg.middle != none;
            visit(leg);
        }
    }

    void rest() {
        for (uint32_t j = 0; j < rig_.count(); ++j) set(j, Quaternion::Identity());
    }
    void set(uint32_t j, const Quaternion& rotation) {
        store_quaternion(within_limits(rig_.joint(j), rotation), pose_.rotations + 4 * j);
    }

    Vec3 hinge_axis(uint32_t j) const { return load_vec3(rig_.joint(j).limit_axis).normalized(); }
    // Bends a hinge from rest.
    void bend(uint32_t j, double angle) { set(j, turned(hinge_axis(j), angle)); }

    // How far hips must come down so that all feet are reached at both ends of a stride.
    double lowering(double stride) {
        double most = 0;
        each_leg([&](const Leg& leg) {
            if (leg.middle == none) {
                const Vec3 way = rig_.at(leg.end) - rig_.at(leg.upper);
                for (const double along : {-stride, stride})
                    if (swing_error(way, along) > reached * way.norm()) most = INFINITY;
                return;
            }
            const double length = nearly_straight * straight_length(leg);
            for (const double along : {-stride, 0.0, stride}) {
                const Vec3 way = rig_.at(leg.end) - rig_.at(leg.upper) + along * rig_.forward;
                const double over = way.squaredNorm() - length * length, down = -way.dot(rig_.up);
                if (over <= 0) continue;
                const double square = down * down - over;
                most = std::max(most, square >= 0 ? down - std::sqrt(square) : INFINITY);
            }
        });
        return most;
    }

    double straight_length(const Leg& leg) const {
        const Reach reach = reach_of(leg);
        const double best = std::clamp(std::atan2(reach.b, reach.a), reach.low, reach.high);
        return std::sqrt(reach.constant + 2 * (reach.a * std::cos(best) + reach.b * std::sin(best)));
    }

    // The square of the distance from hip to end, by the angle of the hinge: constant + 2 (a cos + b sin).
    struct Reach {
        Vec3 axis, upper, lower;  // the bones at rest
        double a, b, constant, low, high;
    };
    Reach reach_of(const Leg& leg) const {
        const Vec3 axis = hinge_axis(leg.middle), upper = rig_.at(leg.middle) - rig_.at(leg.upper),
                   lower = rig_.at(leg.end) - rig_.at(leg.middle);
        const double along = axis.dot(upper) * axis.dot(lower);
        const FlgRigJoint& joint = rig_.joint(leg.middle);
        return {axis,
                upper,
                lower,
                upper.dot(lower) - along,
                upper.dot(axis.cross(lower)),
                upper.squaredNorm() + lower.squaredNorm() + 2 * along,
                joint.limit_twist_min,
                joint.limit_twist_max};
    }

    double phase_of(const Leg& leg) const {
        const bool is_right = leg.side < 0;
        double later = leg.side == 0 ? 0.5 * (leg.pair % 2) : 0.5 * ((leg.pair + (is_right ? 1 : 0)) % 2);
        // Hind left, front left, hind right, front right.
        if (pairs_ == 2 && leg.side != 0) later = (leg.pair == 0 ? 0.75 : 0) + (is_right ? 0.5 : 0);
        return phase_ + later - std::floor(phase_ + later);
    }

    // Of a foot: 1 in front, -1 behind; its lift from 0 to 1.
    struct Step {
        double along, lift;
    };
    static Step step_at(double phase, double standing) {
        if (phase < standing) return {1 - 2 * phase / standing, 0};
        const double t = (phase - standing) / (1 - standing), slope = -2 * (1 - standing) / standing;
        // From -1 to 1, as fast at both ends as the ground.
        const double along = -1 + slope * t + (6 - 3 * slope) * t * t + (2 * slope - 4) * t * t * t;
        const double rise = std::sin(std::numbers::pi * t);
        return {along, rise * rise};
    }

    // How much lower the standing legs without hinges end than at rest, on average.
    double pendulum_drop(double stride, double standing) {
        double sum = 0, count = 0;
        each_leg([&](const Leg& leg) {
            const Step step = step_at(phase_of(leg), standing);
            if (step.lift > 0) return;
            const Vec3 way = rig_.at(leg.end) - rig_.at(leg.upper);
            sum += rig_.up.dot(swing_of(way, stride * step.along) * way - way);
            ++count;
        });
        return count > 0 ? sum / count : 0;
    }

    // The turn about the left that brings a leg's end so far to the front.
    Quaternion swing_of(const Vec3& way, double along) const {
        const double down = -way.dot(rig_.up), ahead = way.dot(rig_.forward);
        return turned(rig_.left, solve_turn(ahead, -down, ahead + along, -1.0, 1.0));
    }

    double swing_error(const Vec3& way, double along) const {
        return std::abs((swing_of(way, along) * way - way).dot(rig_.forward) - along);
    }

    void place_foot(const Leg& leg, const Vec3& from_rest) {
        const Vec3 hip = rig_.at(leg.upper), way = rig_.at(leg.end) - hip;
        if (leg.middle == none) {
            const Quaternion swing = swing_of(way, from_rest.dot(rig_.forward));
            set(leg.upper, swing);
            if (rig_.next(leg.end) != none) set(leg.end, swing.conjugate());
            return;
        }
        const Vec3 goal = way + from_rest - pose_.translation;
        const Reach reach = reach_of(leg);
        const double angle =
            solve_turn(reach.a, reach.b, (goal.squaredNorm() - reach.constant) / 2, reach.low, reach.high);
        const Quaternion knee = turned(reach.axis, angle);
        const Vec3 bent = reach.upper + knee * reach.lower;
        if (bent.norm() == 0 || goal.norm() == 0) return;
        const Quaternion at_hip = Quaternion::FromTwoVectors(bent, goal);
        set(leg.upper, at_hip);
        set(leg.middle, knee);
        // Feet stay level.
        if (rig_.next(leg.end) != none) set(leg.end, (at_hip * knee).conjugate());
    }

    struct Arm {
        uint32_t first, upper, end;
        int32_t side;
    };

    template <class Visit>
    void each_arm(Visit visit) {
        for (const int32_t side : {1, -1}) {
            const uint32_t first = rig_.first(FLG_LIMB_ARM, side);
            if (first == none) continue;
            const Arm arm{first, rig_.find(first, FLG_LIMB_PLACE_UPPER), rig_.find(first, FLG_LIMB_PLACE_END), side};
            if (arm.upper != none && arm.end != none) visit(arm);
        }
    }

    // Those who walk on two legs don't keep their arms level.
    Quaternion lowered(const Arm& arm) const {
        if (pairs_ != 1) return Quaternion::Identity();
        const Vec3 way = rig_.direction(arm.upper, arm.end);
        const Vec3 hanging = std::sin(arms_aside) * arm.side * rig_.left - std::cos(arms_aside) * rig_.up;
        const double rise = way.dot(rig_.up);
        const bool stays = rise <= -std::cos(arms_aside) || rise > highest_lowered;
        return stays ? Quaternion::Identity() : Quaternion::FromTwoVectors(way, hanging);
    }

    void swing_arms(double cycle) {
        each_arm([&](const Arm& arm) {
            const double swing = arm.side * arm_swing * std::cos(cycle);
            if (pairs_ != 1) {  // wings, claws
                set(arm.upper, turned(rig_.forward, arm.side * swing / 2));
                return;
            }
            set(arm.upper, turned(rig_.left, swing) * lowered(arm));
            const uint32_t middle = rig_.find(arm.first, FLG_LIMB_PLACE_MIDDLE);
            if (middle != none) bend(middle, elbow_bend);
        });
    }

    void wag_tail(double cycle, double by) {
        const uint32_t first = rig_.first(FLG_LIMB_TAIL, 0);
        for (uint32_t j = first; j != none; j = rig_.next(j))
            set(j, turned(rig_.up, by * std::sin(cycle - tail_later * rig_.joint(j).index)));
    }

    // The upper arm goes up and aside, and the shoulder turns so that the elbow can lift the forearm. Where it can't
    // turn as far the arm is straight and waves as a whole.
    void wave_arm(const Arm& arm, double raised, double swing) {
        const uint32_t upper = arm.upper, middle = rig_.find(arm.first, FLG_LIMB_PLACE_MIDDLE);
        const Quaternion down = lowered(arm);
        const auto aside = [&](double rise) { return (rise * rig_.up - rig_.left).normalized(); };
        if (middle != none) {
            const Vec3 bone = rig_.direction(upper, middle), axis = hinge_axis(middle), goal = aside(upper_arm_rise);
            const Vec3 hinge = (axis - axis.dot(bone) * bone).stableNormalized();
            const Quaternion lift = between(bone, hinge, goal, goal.cross(rig_.up).normalized());
            const FlgRigJoint& joint = rig_.joint(upper);
            const double about = lift.vec().dot(load_vec3(joint.limit_axis));
            const double twist = std::remainder(2 * std::atan2(about, lift.w()), turn);
            if (twist >= joint.limit_twist_min && twist <= joint.limit_twist_max) {
                set(upper, down.slerp(raised, lift));
                bend(middle, raised * (forearm_bend + joint_bend(middle)) + wave_swing * swing);
                return;
            }
            bend(middle, raised * joint_bend(middle));
        }
        const Quaternion lift = Quaternion::FromTwoVectors(rig_.direction(upper, middle == none ? arm.end : middle),
                                                           aside(straight_arm_rise));
        set(upper, turned(rig_.forward, wave_swing * swing) * down.slerp(raised, lift));
    }

    // What straightens a hinge, from rest.
    double joint_bend(uint32_t j) const { return rig_.joint(j).limit_twist_min; }

    // The rotation that takes two directions at right angles to two others.
    static Quaternion between(const Vec3& a, const Vec3& b, const Vec3& to_a, const Vec3& to_b) {
        Eigen::Matrix3d from, to;
        from << a, b, a.cross(b);
        to << to_a, to_b, to_a.cross(to_b);
        return Quaternion(Eigen::Matrix3d(to * from.transpose())).normalized();
    }

    const Rig& rig_;
    const double phase_;
    MotionPose& pose_;
    uint32_t pairs_ = 0;
    bool has_hinge_ = false;
    std::bitset<FLG_RIG_MAX_JOINTS> carries_legs_;
};

}  // namespace

void sample_motion(const Rig& rig, FlgRigMotion motion, double phase, MotionPose& pose) {
    PoseMaker maker(rig, phase, pose);
    switch (motion) {
        case FLG_RIG_MOTION_WALK: return maker.walk();
        case FLG_RIG_MOTION_IDLE: return maker.idle();
        default: return maker.wave();
    }
}

}  // namespace flg
