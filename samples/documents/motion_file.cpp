// SPDX-License-Identifier: MIT
#include "documents/motion_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "documents/json_place.h"

namespace flg::cli {
namespace {

constexpr double largest = 1e30;
constexpr double length_tolerance = 1e-3;  // of quaternions

std::vector<double> read_numbers(const JsonPlace& list, size_t count) {
    std::vector<double> numbers;
    for (const JsonPlace& item : list.items()) numbers.push_back(item.real(-largest, largest));
    if (numbers.size() != count) list.fail("must be " + std::to_string(count) + " numbers");
    return numbers;
}

void append(std::vector<double>& to, const std::vector<double>& numbers) {
    to.insert(to.end(), numbers.begin(), numbers.end());
}

// The rows of the matrix of a quaternion, each with a coordinate of the position.
std::vector<double> pose_of(const JsonPlace& key) {
    const std::vector<double> at = read_numbers(key.at("position"), 3);
    std::vector<double> q = {0, 0, 0, 1};
    if (const auto place = key.find("rotation")) {
        q = read_numbers(*place, 4);
        const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(std::abs(length - 1) <= length_tolerance)) place->fail("must be a quaternion of length 1");
        for (double& value : q) value /= length;
    }
    const auto [x, y, z, w] = std::array<double, 4>{q[0], q[1], q[2], q[3]};
    return {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),     at[0],
            2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),     at[1],
            2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y), at[2]};
}

void read_keys(const JsonPlace& list, MotionFile& file) {
    bool eased = false;
    for (const JsonPlace& key : list.items()) {
        key.allow({"time", "pose", "position", "rotation", "ease_in", "ease_out"});
        if (file.desc.timing == FLG_MOTION_TIMING_GIVEN) file.times.push_back(key.at("time").real(-largest, largest));
        for (const char* name : {"ease_in", "ease_out"}) {
            const auto ease = key.find(name);
            file.eases.push_back(ease ? ease->real(0, 1) : 0);
            eased = eased || ease;
        }
        const auto pose = key.find("pose");
        if (pose && (key.find("position") || key.find("rotation")))
            key.fail("has a `pose` and another one in `position` and `rotation`");
        append(file.poses, pose ? read_numbers(*pose, 12) : pose_of(key));
    }
    if (!eased) file.eases.clear();
}

void read_limits(const JsonPlace& limits, FlgMotionDesc& desc) {
    limits.allow({"speed", "acceleration", "turn", "turn_acceleration"});
    if (const auto place = limits.find("speed")) desc.max_speed = place->real(0, largest);
    if (const auto place = limits.find("acceleration")) desc.max_acceleration = place->real(0, largest);
    if (const auto place = limits.find("turn")) desc.max_turn = place->real(0, largest);
    if (const auto place = limits.find("turn_acceleration")) desc.max_turn_acceleration = place->real(0, largest);
}

void read_look(const JsonPlace& look, MotionFile& file) {
    FlgMotionDesc& desc = file.desc;
    look.allow({"at", "points", "times", "path", "up", "bank", "bank_time"});
    const auto at = look.find("at"), points = look.find("points"), path = look.find("path"), times = look.find("times");
    if (int{at.has_value()} + int{points.has_value()} + int{path.has_value()} != 1)
        look.fail("needs one of `at`, `points` and `path`");
    desc.look = path ? FLG_MOTION_LOOK_PATH : FLG_MOTION_LOOK_TARGET;
    if (path && !path->flag()) path->fail("must be true");
    if (at) append(file.look_points, read_numbers(*at, 3));
    if (points) {
        for (const JsonPlace& point : points->items()) append(file.look_points, read_numbers(point, 3));
        if (file.look_points.empty()) points->fail("is empty");
    }
    if (times) {
        if (!points) times->fail("are those of `points`");
        for (const JsonPlace& time : times->items()) file.look_times.push_back(time.real(-largest, largest));
        if (3 * file.look_times.size() != file.look_points.size()) times->fail("must be as many as `points`");
    }
    if (const auto place = look.find("up")) {
        const std::vector<double> up = read_numbers(*place, 3);
        std::copy(up.begin(), up.end(), desc.look_up);
    }
    if (const auto place = look.find("bank")) desc.bank = place->real(0, 100);
    if (const auto place = look.find("bank_time")) desc.bank_time = place->real(0, 1e6);
}

void read_body(const JsonPlace& body, MotionFile& file) {
    file.has_body = true;
    body.allow({"points", "masses", "box"});
    const auto points = body.find("points"), box = body.find("box"), masses = body.find("masses");
    if (points.has_value() == box.has_value()) body.fail("needs `points` or `box`, and not both");
    if (box) {
        if (masses) masses->fail("are those of `points`");
        size_t side = 0;
        if (box->items().size() != 3) box->fail("must be 3 numbers");
        for (const JsonPlace& item : box->items()) file.desc.body_box[side++] = item.real(0, largest);
        return;
    }
    for (const JsonPlace& point : points->items()) append(file.body_points, read_numbers(point, 3));
    if (file.body_points.empty()) points->fail("is empty");
    if (!masses) return;
    for (const JsonPlace& mass : masses->items()) file.body_masses.push_back(mass.real(0, largest));
    if (3 * file.body_masses.size() != file.body_points.size()) masses->fail("must be as many as `points`");
}

}  // namespace

FlgMotionDesc desc_of(const MotionFile& file) {
    FlgMotionDesc desc = file.desc;
    desc.key_count = static_cast<uint32_t>(file.poses.size() / 12);
    desc.times = file.times.empty() ? nullptr : file.times.data();
    desc.poses = file.poses.data();
    desc.body_points = file.body_points.empty() ? nullptr : file.body_points.data();
    desc.body_masses = file.body_masses.empty() ? nullptr : file.body_masses.data();
    desc.body_point_count = static_cast<uint32_t>(file.body_points.size() / 3);
    desc.eases = file.eases.empty() ? nullptr : file.eases.data();
    desc.look_points = file.look_points.empty() ? nullptr : file.look_points.data();
    desc.look_times = file.look_times.empty() ? nullptr : file.look_times.data();
    desc.look_count = static_cast<uint32_t>(file.look_points.size() / 3);
    return desc;
}

MotionFile read_motion_file(const std::string& path) {
    const nlohmann::json json = JsonPlace::read(path);
    const JsonPlace root(json, path + ": motion");
    root.allow({"closed", "end_time", "energy", "tension", "smoothing", "positions", "body", "keys", "timing", "pacing",
                "speed", "limits", "clearance", "look"});
    MotionFile file;
    FlgMotionDesc& desc = file.desc;
    if (const auto place = root.find("closed")) desc.closed = place->flag();
    if (const auto place = root.find("end_time")) {
        if (!desc.closed) place->fail("is for closed motions");
        desc.end_time = place->real(-largest, largest);
    }
    if (const auto place = root.find("energy"))
        desc.energy = static_cast<FlgSplineEnergy>(place->word({"e2", "e1", "et"}));
    if (const auto place = root.find("tension")) desc.tension = place->real(0, 1e12);
    if (const auto place = root.find("smoothing")) desc.smoothing = place->real(0, 1e9);
    if (const auto place = root.find("positions")) desc.position_count = place->count(2, FLG_MOTION_MAX_POSITIONS);
    if (const auto place = root.find("body")) read_body(*place, file);
    if (const auto place = root.find("timing"))
        desc.timing = static_cast<FlgMotionTiming>(place->word({"given", "chord", "centripetal"}));
    if (const auto place = root.find("pacing"))
        desc.pacing = static_cast<FlgMotionPacing>(place->word({"keys", "path", "body"}));
    if (const auto place = root.find("speed")) desc.speed = place->real(0, largest);
    if (const auto place = root.find("limits")) read_limits(*place, desc);
    if (const auto place = root.find("clearance")) desc.clearance = place->real(0, largest);
    if (const auto place = root.find("look")) read_look(*place, file);
    read_keys(root.at("keys"), file);
    return file;
}

}  // namespace flg::cli
