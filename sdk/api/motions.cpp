// SPDX-License-Identifier: MIT
// Motions of rigid bodies: made, shown, released.
#include "splines/motion/motion.h"

#include <algorithm>

#include "api/descriptors.h"
#include "api/inputs.h"

namespace flg {

namespace {

constexpr uint32_t default_intervals = 32;  // from key to key
constexpr uint32_t max_body_points = 1u << 20;
constexpr uint32_t max_rounds = 10000;
constexpr double largest = 1e30;  // coordinate, m
constexpr double largest_weight = 1e12;
constexpr double largest_smoothing = 1e9;  // rounding hides the pull of the keys beyond
constexpr double largest_bank = 100, largest_bank_time = 1e6;

FlgMotionDesc default_motion_desc() {
    auto desc = sized<FlgMotionDesc>();
    desc.energy = FLG_SPLINE_ENERGY_E2;
    desc.tension = 1;
    desc.max_rounds = 200;
    desc.tolerance = 1e-6;
    desc.obstacle_radius = 1e-3;
    std::fill_n(desc.body_box, 3, 2.0);
    desc.look_up[1] = 1;
    desc.bank_time = 0.25;
    return desc;
}

BodyInertia read_body(const FlgMotionDesc& desc) {
    if (!desc.body_points) {
        check_range(desc.body_point_count == 0, "desc.body_point_count", desc.body_point_count,
                    "0 without body_points");
        for (const double side : desc.body_box)
            check_range(side >= 0 && side <= largest, "desc.body_box", side, "from 0 to 1e30");
        const Vec3 half = 0.5 * Vec3(desc.body_box[0], desc.body_box[1], desc.body_box[2]);
        return inertia_of_box(-half, half);
    }
    const uint32_t count = desc.body_point_count;
    check_range(count >= 1 && count <= max_body_points, "desc.body_point_count", count, "1 to 2^20");
    for (size_t i = 0; i < size_t{3} * count; ++i) {
        const double value = desc.body_points[i];
        check_range(std::abs(value) <= largest, "desc.body_points", value, "finite and at most 1e30 in size");
    }
    if (!desc.body_masses) return inertia_of_points({desc.body_points, size_t{3} * count}, {});
    double sum = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const double mass = desc.body_masses[i];
        check_range(mass >= 0 && mass <= largest, "desc.body_masses", mass, "from 0 to 1e30");
        sum += mass;
    }
    check_range(sum > 0, "the sum of desc.body_masses", sum, "above 0");
    return inertia_of_points({desc.body_points, size_t{3} * count}, {desc.body_masses, count});
}

void check_weights(const FlgMotionDesc& desc) {
    check_enum(desc.energy, FLG_SPLINE_ENERGY_E2, FLG_SPLINE_ENERGY_ET, "desc.energy", "FLG_SPLINE_");
    if (desc.energy == FLG_SPLINE_ENERGY_ET) {
        check_range(desc.tension > 0 && desc.tension <= largest_weight, "desc.tension", desc.tension,
                    "above 0, to 1e12");
    }
    check_range(desc.smoothing >= 0 && desc.smoothing <= largest_smoothing, "desc.smoothing", desc.smoothing,
                "from 0 to 1e9");
    check_range(desc.max_rounds >= 1 && desc.max_rounds <= max_rounds, "desc.max_rounds", desc.max_rounds,
                "1 to 10000");
    check_range(desc.tolerance >= 1e-12 && desc.tolerance <= 1, "desc.tolerance", desc.tolerance, "1e-12 to 1");
}

void read_times(const FlgMotionDesc& desc, MotionInput& input) {
    const uint32_t keys = desc.key_count;
    check_enum(desc.timing, FLG_MOTION_TIMING_GIVEN, FLG_MOTION_TIMING_CENTRIPETAL, "desc.timing",
               "FLG_MOTION_TIMING_");
    check_enum(desc.pacing, FLG_MOTION_PACING_KEYS, FLG_MOTION_PACING_BODY, "desc.pacing", "FLG_MOTION_PACING_");
    check_range(desc.speed >= 0 && desc.speed <= largest, "desc.speed", desc.speed, "from 0 to 1e30");
    const bool given = desc.timing == FLG_MOTION_TIMING_GIVEN;
    if (given) {
        require(desc.times, "desc.times");
        input.times.assign(desc.times, desc.times + keys);
    }
    if (desc.eases) input.eases.assign(desc.eases, desc.eases + size_t{2} * keys);
    if (desc.closed != 0 && given) {
        const double mean = (input.times.back() - input.times.front()) / (keys - 1);
        if (desc.end_time == 0) input.desc.end_time = input.times.back() + mean;
    } else {
        check_range(desc.end_time == 0, "desc.end_time", desc.end_time,
                    given ? "0 for motions that are not closed" : "0 where times are found");
    }
    const auto limit = [](double value, const char* name) {
        check_range(value >= 0 && value <= largest, name, value, "from 0 to 1e30");
    };
    limit(desc.max_speed, "desc.max_speed");
    limit(desc.max_acceleration, "desc.max_acceleration");
    limit(desc.max_turn, "desc.max_turn");
    limit(desc.max_turn_acceleration, "desc.max_turn_acceleration");
}

void read_look(const FlgMotionDesc& desc, Look& look) {
    check_enum(desc.look, FLG_MOTION_LOOK_KEYS, FLG_MOTION_LOOK_PATH, "desc.look", "FLG_MOTION_LOOK_");
    check_range(desc.bank >= 0 && desc.bank <= largest_bank, "desc.bank", desc.bank, "from 0 to 100");
    check_range(desc.bank_time >= 0 && desc.bank_time <= largest_bank_time, "desc.bank_time", desc.bank_time,
                "from 0 to 1e6");
    look.kind = static_cast<LookKind>(desc.look);
    look.bank = desc.bank;
    look.bank_time = desc.bank_time;
    if (desc.look == FLG_MOTION_LOOK_KEYS) return;
    look.up = Vec3(desc.look_up[0], desc.look_up[1], desc.look_up[2]);
    for (const double up : desc.look_up)
        check_range(std::abs(up) <= largest, "desc.look_up", up, "finite and at most 1e30 in size");
    check_range(look.up.norm() > 0, "desc.look_up", 0, "not 0");
    if (desc.look == FLG_MOTION_LOOK_PATH) return;
    const uint32_t count = desc.look_count;
    check_range(count >= 1 && count <= FLG_MOTION_MAX_KEYS, "desc.look_count", count, "1 to 65536");
    require(desc.look_points, "desc.look_points");
    const auto check = [](const double* values, size_t size, const char* name) {
        for (size_t i = 0; i < size; ++i)
            check_range(std::abs(values[i]) <= largest, name, values[i], "finite and at most 1e30 in size");
    };
    check(desc.look_points, size_t{3} * count, "desc.look_points");
    look.points.assign(desc.look_points, desc.look_points + size_t{3} * count);
    if (!desc.look_times) return;
    check(desc.look_times, count, "desc.look_times");
    look.times.assign(desc.look_times, desc.look_times + count);
}

MotionInput read_input(const FlgMotionDesc& desc, Memory* memory) {
    MotionInput input(memory);
    input.desc = desc;
    const uint32_t keys = desc.key_count;
    check_range(keys >= 2 && keys <= FLG_MOTION_MAX_KEYS, "desc.key_count", keys, "2 to 65536");
    require(desc.poses, "desc.poses");
    read_times(desc, input);
    read_look(desc, input.look);
    input.origin = read_origin(desc.origin, "desc.origin");
    input.poses.assign(desc.poses, desc.poses + MotionKeys::pose_size * keys);
    input.body = read_body(desc);
    check_weights(desc);
    const uint64_t intervals = uint64_t{default_intervals} * (desc.closed ? keys : keys - 1);
    const uint64_t usual = std::min<uint64_t>(intervals + (desc.closed ? 0 : 1), FLG_MOTION_MAX_POSITIONS);
    uint32_t& positions = input.desc.position_count;
    if (positions == 0) positions = static_cast<uint32_t>(usual);
    // The optimizer's cycles have three nodes at least.
    const uint32_t least = std::max(keys, desc.closed ? 3u : 2u);
    check_range(positions >= least && positions <= FLG_MOTION_MAX_POSITIONS, "desc.position_count", positions,
                "key_count to 2^20, closed 3 at least");
    return input;
}

void read_obstacles(Context& context, const FlgMotionDesc& desc, MotionInput& input, Submission& submission) {
    check_range(desc.clearance >= 0 && desc.clearance <= largest, "desc.clearance", desc.clearance, "from 0 to 1e30");
    if (desc.obstacles.id == 0) return;
    input.obstacles = context.obstacles.get(desc.obstacles.id, "desc.obstacles");
    submission.read(*input.obstacles, "desc.obstacles");
    const uint32_t dimension = input.obstacles->dimension;
    check_range(dimension == 3, "desc.obstacles' dimension", dimension, "3");
    check_range(desc.smoothing == 0, "desc.smoothing", desc.smoothing, "0 with obstacles");
    const double radius = desc.obstacle_radius;
    check_range(radius >= 1e-5 && radius <= 0.1, "desc.obstacle_radius", radius, "1e-5 to 0.1");
    check_range(desc.side_count <= ObstacleSet::max_count, "desc.side_count", desc.side_count, "at most 256");
    if (desc.side_count > 0) require(desc.sides, "desc.sides");
    for (uint32_t i = 0; i < desc.side_count; ++i) {
        const FlgObstacleSide& side = desc.sides[i];
        input.sides.push_back({side.obstacle, {side.direction[0], side.direction[1], side.direction[2]}});
    }
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgMotionDescInit(FlgMotionDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_motion_desc());
}

FlgResult flgMotionCreate(FlgContext context, const FlgMotionDesc* desc, FlgMotion* out_motion, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_motion, "out_motion", out_job);
        Memory* const memory = self.memory[MemoryKind::curves];
        const FlgMotionDesc read = read_struct(desc, default_motion_desc(), "desc");
        Submission submission(self, read.job);
        MotionInput input = read_input(read, memory);
        read_obstacles(self, read, input, submission);
        const auto out = self.make(self.motions, std::move(input));
        submission.job().strand.start(make_motion(submission.pace(), out));
        *out_motion = {submission.commit(self.motions, out, out_job)};
    });
}

FlgResult flgMotionViewInit(FlgMotionView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgMotionGetView(FlgContext context, FlgMotion motion, FlgMotionView* out_view) {
    return get_view(out_view, [&] { return get_context(context).motions.get(motion.id, "motion"); });
}

FlgResult flgMotionRelease(FlgContext context, FlgMotion motion) {
    return release(context, &Context::motions, motion, "motion");
}

}  // extern "C"
