// SPDX-License-Identifier: MIT
#include "bones/part_joints.h"

#include <algorithm>
#include <cmath>

#include "bones/bounded_dp.h"
#include "bones/shared_trunks.h"
#include "runtime/each.h"

namespace flg {
namespace {

constexpr double window = 0.3;                          // of a piece: so far a joint may be from the even place
constexpr double evenness = 0.2;                        // of the radius: what an elbow is deeper by than the even place
constexpr double same_length = 1.25, same_width = 1.5;  // of equal limbs
constexpr double same_turn = 1.2;                       // likewise, in radians: by how much less one may bend
constexpr uint32_t most_pieces = 8;
constexpr double bends = 1;       // a limb's last bone that is as long for its width has a knee
constexpr double bends_late = 2;  // the same of a part of one bone, and beyond a shoulder
constexpr double straight = 0.6;  // of a limb's length: a last bone that long has no knee before it

using Samples = std::span<const AxisSample>;
using Joints = std::pmr::vector<uint32_t>;

double radius_of(const AxisSample& sample) {
    return 0.5 * (sample.left + sample.right);
}

struct Piece {
    uint32_t from, to;
};

double length_of(Samples samples, const Piece& piece) {
    return distance(samples[0].at, samples[1].at) * (piece.to - piece.from);
}

double sum_of_radii(Samples samples, uint32_t begin, uint32_t end) {
    double sum = 0;
    for (uint32_t i = begin; i < end; ++i) sum += radius_of(samples[i]);
    return sum;
}

// How much the outline narrows and the axis bends at a sample, against the bone.
double elbow_at(Samples samples, const Piece& bone, uint32_t i) {
    const AxisSample &a = samples[bone.from], &b = samples[bone.to];
    const double share = static_cast<double>(i - bone.from) / (bone.to - bone.from);
    const double narrowing = std::lerp(radius_of(a), radius_of(b), share) - radius_of(samples[i]);
    const double length = distance(a.at, b.at);
    const double across =
        (b.at.x - a.at.x) * (samples[i].at.y - a.at.y) - (b.at.y - a.at.y) * (samples[i].at.x - a.at.x);
    return std::max(0.0, narrowing) + (length > 0 ? std::abs(across) / length : 0);
}

struct Elbow {
    double rank = -1e300;
    uint32_t at = 0;
};

Elbow best_elbow(Samples samples, const Piece& bone, double even, double reach, double radius, uint32_t begin,
                 uint32_t end, Elbow best) {
    for (uint32_t i = begin; i < end; ++i) {
        const double off = std::abs(i - even) / reach;
        const double rank = elbow_at(samples, bone, i) - evenness * radius * off;
        // Of two as good as each other the earlier one, but for rounding: mirror images stay alike.
        if (rank > best.rank + 1e-9 * radius) best = {rank, i};
    }
    return best;
}

// Divides a bone in `pieces`, if that stays inside of the shape. Returns the joints between.
Task<Joints> divide(Pace& pace, const Contour& outline, Samples samples, Piece bone, uint32_t pieces, double radius) {
    Joints between(pace.memory());
    const double size = static_cast<double>(bone.to - bone.from) / pieces, reach = std::max(1.0, window * size);
    Slice slice(Cost::tens_of_ns);
    for (uint32_t k = 1; k < pieces; ++k) {
        const double even = bone.from + k * size;
        const auto begin = std::max(bone.from + 1, static_cast<uint32_t>(std::ceil(even - reach)));
        const auto end = std::min(bone.to, static_cast<uint32_t>(even + reach) + 1);
        Elbow best;
        for (Portion part(slice, begin, end); part.next();) {
            best = best_elbow(samples, bone, even, reach, radius, part.begin, part.end, best);
            if (part.is_over()) co_await pace;
        }
        if (begin < end && (between.empty() || best.at > between.back())) between.push_back(best.at);
    }
    uint32_t from = bone.from;
    for (size_t k = 0; k <= between.size(); ++k) {
        const uint32_t to = k < between.size() ? between[k] : bone.to;
        if (!co_await bone_is_inside(pace, outline, samples, from, to)) co_return Joints(pace.memory());
        from = to;
    }
    co_return between;
}

Task<double> mean_radius(Pace& pace, Samples samples, Piece bone) {
    double sum = 0;
    Slice slice(Cost::some_ns);
    for (Portion part(slice, bone.from, bone.to + 1); part.next();) {
        sum += sum_of_radii(samples, part.begin, part.end);
        if (part.is_over()) co_await pace;
    }
    co_return sum / (bone.to + 1 - bone.from);
}

// Which of the first and the last bone end freely.
struct FreeEnds {
    bool first, last;
};

// Whether a limb that begins in a trunk, with joints between where it leaves that and its end, bends nowhere.
bool is_straight(Samples samples, FreeEnds free, std::span<const uint32_t> joints) {
    if (free.first == free.last || joints.size() <= 3) return false;
    const size_t last = free.first ? 0 : joints.size() - 2;
    const double trunk = radius_of(free.first ? samples.back() : samples.front());
    const double limb = length_of(samples, {joints.front(), joints.back()}) - trunk;
    return length_of(samples, {joints[last], joints[last + 1]}) >= straight * limb;
}

// Bones that are long for their width in several. A limb without an elbow bends once more, and so does a part of one
// bone.
Task<void> divide_long(Pace& pace, const Contour& outline, Samples samples, FreeEnds free, double detail,
                       Joints& joints) {
    const bool has_no_elbow = free.first != free.last && joints.size() <= 3;
    const bool bends_late_if_long =
        is_straight(samples, free, joints) || (free.first && free.last && joints.size() == 2);
    Joints all(pace.memory());
    for (size_t i = 0; i + 1 < joints.size(); ++i) {
        const Piece bone{joints[i], joints[i + 1]};
        const double radius = co_await mean_radius(pace, samples, bone);
        const double length = length_of(samples, bone), width = 2 * radius;
        uint32_t pieces = pieces_of(length, width, detail);
        const bool is_free = (i == 0 && free.first) || (i + 2 == joints.size() && free.last);
        const double least = has_no_elbow ? bends : bends_late;
        if (is_free && (has_no_elbow || bends_late_if_long) && length * detail >= least * width)
            pieces = std::max(pieces, 2u);
        all.push_back(bone.from);
        if (pieces == 1) continue;
        const Joints between = co_await divide(pace, outline, samples, bone, pieces, radius);
        all.insert(all.end(), between.begin(), between.end());
    }
    all.push_back(joints.back());
    joints = std::move(all);
}

// A branch that ends freely.
struct Limb {
    uint32_t part, branch, number;  // number: of the list of joints
    double length, width;           // in the model's space
    double turn;                    // from bone to bone, all together
    uint32_t target;                // joints
};

double turn_of(Samples samples, std::span<const uint32_t> joints) {
    double sum = 0;
    for (size_t i = 1; i + 1 < joints.size(); ++i) {
        const Point2 &a = samples[joints[i - 1]].at, &b = samples[joints[i]].at, &c = samples[joints[i + 1]].at;
        const Point2 in{b.x - a.x, b.y - a.y}, out{c.x - b.x, c.y - b.y};
        sum += std::abs(std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y));
    }
    return sum;
}

class Chooser {
public:
    Chooser(Pace& pace, const HeldModel& model)
        : pace_(pace), model_(model), out_(pace.memory()), limbs_(pace.memory()) {}

    Task<PartJoints> choose() {
        for (uint32_t p = 0; p < model_.parts.size(); ++p) co_await choose_of(p);
        co_await make_limbs_equal();
        co_return std::move(out_);
    }

    // Coroutines that are members take their frames from here.
    operator Pace&() const { return pace_; }

private:
    Samples samples_of(uint32_t p, size_t b) const {
        const PartSkeleton& skeleton = model_.parts[p].part->skeleton;
        const AxisBranch& branch = skeleton.branches[b];
        return {skeleton.samples.data() + branch.begin, branch.end - branch.begin};
    }

    Task<void> choose_of(uint32_t p) {
        const ModelPart& placed = model_.parts[p];
        const PartSkeleton& skeleton = placed.part->skeleton;
        out_.first_branch.push_back(static_cast<uint32_t>(out_.samples.size()));
        if (!placed.branch_simplify.empty() && placed.branch_simplify.size() != skeleton.branches.size())
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.parts[%u].branch_count is %zu; the part has %zu branches",
                          placed.source, placed.branch_simplify.size(), skeleton.branches.size());
        const Buffer<uint32_t> branches_at = co_await count_branches(p);
        for (uint32_t b = 0; b < skeleton.branches.size(); ++b) {
            const AxisBranch& branch = skeleton.branches[b];
            const FreeEnds free{branches_at[branch.from] == 1, branches_at[branch.to] == 1};
            co_await choose_along(p, b, free);
        }
    }

    // By node the branches, but for those to ends that refinement prunes: a foot's corners are no limbs.
    Task<Buffer<uint32_t>> count_branches(uint32_t p) {
        const PartSkeleton& skeleton = model_.parts[p].part->skeleton;
        const FlgBoneThresholds& thresholds = model_.parts[p].thresholds;
        const double unit = model_.size / model_.parts[p].scale;
        const double prune = thresholds.detail > 0 ? thresholds.prune * unit / thresholds.detail : 0;
        Buffer<uint32_t> all(skeleton.graph.nodes.size(), pace_.memory());
        co_await each(pace_, all.size(), Cost::some_ns, [&](uint32_t n) { all[n] = 0; });
        co_await each(pace_, skeleton.branches.size(), Cost::some_ns, [&](uint32_t b) {
            ++all[skeleton.branches[b].from];
            ++all[skeleton.branches[b].to];
        });
        Buffer<uint32_t> counted(all.size(), pace_.memory());
        co_await each(pace_, all.size(), Cost::some_ns, [&](uint32_t n) { counted[n] = all[n]; });
        co_await each(pace_, skeleton.branches.size(), Cost::some_ns, [&](uint32_t b) {
            const AxisBranch& branch = skeleton.branches[b];
            if (length_of(samples_of(p, b), {0, branch.end - branch.begin - 1}) >= prune) return;
            if (all[branch.to] == 1 && all[branch.from] > 1) --counted[branch.from];
            if (all[branch.from] == 1 && all[branch.to] > 1) --counted[branch.to];
        });
        co_return counted;
    }

    Task<void> choose_along(uint32_t p, uint32_t b, FreeEnds free) {
        const ModelPart& placed = model_.parts[p];
        const PartSkeleton& skeleton = placed.part->skeleton;
        const auto number = static_cast<uint32_t>(out_.samples.size());
        const Samples samples = samples_of(p, b);
        const Piece whole{0, static_cast<uint32_t>(samples.size()) - 1};
        const bool is_own = !placed.branch_simplify.empty() && placed.branch_simplify[b] >= 0;
        const double detail = placed.thresholds.detail;
        Joints joints(pace_.memory());
        if (placed.is_mirrored) {
            joints = out_.samples[out_.first_branch[placed.twin] + b];
        } else if (!skeleton.twins.empty() && skeleton.twins[b] < b) {
            joints = out_.samples[out_.first_branch[p] + skeleton.twins[b]];
        } else {
            double share = is_own ? placed.branch_simplify[b] : placed.thresholds.simplify;
            if (detail > 0 && !is_own) share /= detail;
            joints = co_await bounded_dp(pace_, placed.part->outline, samples, share * model_.size / placed.scale,
                                         model_.shape_weight);
            if (detail > 0 && !is_own) co_await divide_long(pace_, placed.part->outline, samples, free, detail, joints);
        }
        // Where it begins it is as wide as what it begins in.
        const Piece middle{whole.to / 4, whole.to - whole.to / 4};
        if (detail > 0 && !is_own && (free.first || free.last) && joints.size() <= most_pieces)
            limbs_.push_back({p, b, number, length_of(samples, whole) * placed.scale,
                              co_await mean_radius(pace_, samples, middle) * placed.scale, turn_of(samples, joints),
                              static_cast<uint32_t>(joints.size())});
        out_.samples.push_back(std::move(joints));
    }

    Task<void> make_limbs_equal() {
        std::sort(limbs_.begin(), limbs_.end(), [](const Limb& a, const Limb& b) {
            return a.length != b.length ? a.length < b.length : a.number < b.number;
        });
        // Those of about the same length are neighbours.
        Slice slice(Cost::tens_of_ns);
        for (size_t i = 0; i < limbs_.size(); ++i) {
            for (size_t k = i + 1; k < limbs_.size() && limbs_[k].length <= same_length * limbs_[i].length; ++k) {
                Limb &a = limbs_[i], &b = limbs_[k];
                if (slice.is_over()) co_await pace_;
                if (std::max(a.width, b.width) > same_width * std::min(a.width, b.width)) continue;
                if (std::abs(a.turn - b.turn) > same_turn) continue;
                a.target = b.target = std::max(a.target, b.target);
            }
        }
        for (const Limb& limb : limbs_) {
            Joints& joints = out_.samples[limb.number];
            bool goes_on = true;
            while (goes_on && joints.size() < limb.target) goes_on = co_await divide_longest(limb, joints);
        }
    }

    Task<bool> divide_longest(const Limb& limb, Joints& joints) {
        size_t longest = 0;
        for (size_t i = 1; i + 1 < joints.size(); ++i)
            if (joints[i + 1] - joints[i] > joints[longest + 1] - joints[longest]) longest = i;
        const Piece bone{joints[longest], joints[longest + 1]};
        if (bone.to - bone.from < 2) co_return false;
        const Samples samples = samples_of(limb.part, limb.branch);
        const double radius = co_await mean_radius(pace_, samples, bone);
        const Joints between = co_await divide(pace_, model_.parts[limb.part].part->outline, samples, bone, 2, radius);
        joints.insert(joints.begin() + static_cast<ptrdiff_t>(longest) + 1, between.begin(), between.end());
        co_return !between.empty();
    }

    Pace& pace_;
    const HeldModel& model_;
    PartJoints out_;
    std::pmr::vector<Limb> limbs_;
};

}  // namespace

Task<PartJoints> choose_joints(Pace& pace, const HeldModel& model) {
    Chooser chooser(pace, model);
    co_return co_await chooser.choose();
}

}  // namespace flg
