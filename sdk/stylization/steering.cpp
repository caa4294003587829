// SPDX-License-Identifier: MIT
#include "stylization/steering.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "core/random.h"
#include "core/vec.h"
#include "runtime/each.h"

namespace flg {

namespace {

// Tells the draws of temperatures from those of destinations.
constexpr uint64_t heat_seed = 0x68656174;

bool makes_speeds(const CurveSet& target, const StyleDrives& drives) {
    return drives.drive_by(FLG_ATTRIBUTE_SPEED) && !target.find(FLG_ATTRIBUTE_SPEED);
}

// Fills in the speeds of one curve's points.
Task<void> find_speeds(Pace& pace, const CurveSet& target, uint32_t curve, Buffer<float>& speeds) {
    const float* times = target.find(FLG_ATTRIBUTE_TIME)->values.data();
    const uint32_t first = target.offsets()[curve], end = target.offsets()[curve + 1];
    uint32_t resting = first;  // points before the first way
    co_await each(pace, first, end, Cost::tens_of_ns, [&](uint32_t i) {
        speeds[i] = i > first ? speeds[i - 1] : 0;
        if (i == first) return;
        const Vec3 from = load_vec3(target.positions() + size_t{3} * (i - 1));
        const Vec3 to = load_vec3(target.positions() + size_t{3} * i);
        if (from == to) return;
        speeds[i] = speed_between(from, to, double{times[i]} - double{times[i - 1]});
        if (resting == first) resting = i;
    });
    const auto fill = [&speeds, resting](uint32_t i) { speeds[i] = speeds[resting]; };
    co_await each(pace, first, resting, Cost::some_ns, fill);
}

}  // namespace

bool Steered::is_hot(uint64_t seed, uint64_t item, uint32_t index) const {
    return heat > 0 && (heat >= 1 || random_unit(seed ^ heat_seed, item, index) < heat);
}

StyleDrives::StyleDrives(std::span<const FlgStyleDrive> drives) : count_(static_cast<uint32_t>(drives.size())) {
    std::copy(drives.begin(), drives.end(), drives_.begin());
}

bool StyleDrives::drive(FlgStyleDriven driven) const {
    return std::any_of(list().begin(), list().end(), [=](const auto& drive) { return drive.driven == driven; });
}

bool StyleDrives::drive_by(FlgAttribute attribute) const {
    return std::any_of(list().begin(), list().end(), [=](const auto& drive) { return drive.attribute == attribute; });
}

std::array<float, 2> StyleDrives::temperatures(float otherwise) const {
    for (const FlgStyleDrive& drive : list()) {
        if (drive.driven == FLG_STYLE_DRIVEN_TEMPERATURE) return {drive.at_from, drive.at_to};
    }
    return {otherwise, otherwise};
}

double StyleDrives::largest(FlgStyleDriven driven) const {
    double largest = 1;
    for (const FlgStyleDrive& drive : list()) {
        if (drive.driven != driven) continue;
        largest *= std::max(std::abs(double{drive.at_from}), std::abs(double{drive.at_to}));
    }
    return largest;
}

StyleDrives StyleDrives::without(FlgStyleDriven driven) const {
    StyleDrives others;
    for (const FlgStyleDrive& drive : list()) {
        if (drive.driven != driven) others.drives_[others.count_++] = drive;
    }
    return others;
}

// A value that is no number counts as `from`.
double StyleDrives::share(const FlgStyleDrive& drive, float value) {
    const double way = (double{value} - double{drive.from}) / (double{drive.to} - double{drive.from});
    return way > 0 ? std::min(way, 1.0) : 0.0;
}

float StyleDrives::driven_value(const FlgStyleDrive& drive, double share) {
    return static_cast<float>((1 - share) * double{drive.at_from} + share * double{drive.at_to});
}

void StyleDrives::drive(const FlgStyleDrive& drive, float value, Steered& steered) {
    const double way = share(drive, value);
    const float driven = driven_value(drive, way);
    switch (drive.driven) {
        case FLG_STYLE_DRIVEN_MAGNITUDE: steered.magnitude *= driven; break;
        case FLG_STYLE_DRIVEN_SCALE: steered.scale *= driven; break;
        case FLG_STYLE_DRIVEN_RADIUS: steered.radius *= driven; break;
        case FLG_STYLE_DRIVEN_TEMPERATURE: steered.heat = static_cast<float>(way); break;
        default: break;
    }
}

void check_drive_columns(const CurveSet& target, const StyleDrives& drives) {
    for (uint32_t k = 0; k < drives.list().size(); ++k) {
        const FlgAttribute attribute = drives.list()[k].attribute;
        const Column* column = target.find(attribute);
        if (column ? column->components == 1
                   : attribute == FLG_ATTRIBUTE_SPEED && target.find(FLG_ATTRIBUTE_TIME) != nullptr) {
            continue;
        }
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.drives[%u].attribute is %d, of which desc.target has no column of one float", k,
                      static_cast<int>(attribute));
    }
}

float speed_between(const Vec3& from, const Vec3& to, double seconds) {
    const double x = to.x() - from.x(), y = to.y() - from.y(), z = to.z() - from.z();
    return static_cast<float>(std::sqrt(x * x + y * y + z * z) / seconds);
}

Task<Steering> steer(Pace& pace, const CurveSet& target, const StyleDrives& drives) {
    Steering steering;
    if (drives.empty()) co_return steering;
    check_drive_columns(target, drives);
    Buffer<float> speeds;
    if (makes_speeds(target, drives)) {
        speeds = Buffer<float>(target.point_count(), pace.memory());
        for (uint32_t c = 0; c < target.curve_count(); ++c) co_await find_speeds(pace, target, c, speeds);
    }
    std::array<const float*, style_drives_max> values{};
    for (uint32_t k = 0; k < drives.list().size(); ++k) {
        const Column* column = target.find(drives.list()[k].attribute);
        values[k] = column ? column->values.data() : speeds.data();
    }
    steering.points = Buffer<Steered>(target.point_count(), pace.memory());
    if (drives.drive(FLG_STYLE_DRIVEN_SCALE)) {
        steering.scales = Buffer<float>(target.point_count(), pace.memory());
    }
    if (drives.drive(FLG_STYLE_DRIVEN_STYLE)) {
        steering.styles = Buffer<float>(target.point_count(), pace.memory());
        co_await each(pace, target.point_count(), Cost::tens_of_ns,
                      [&](uint32_t i) { steering.styles[i] = drives.style([&](uint32_t k) { return values[k][i]; }); });
    }
    co_await each(pace, target.point_count(), Cost::tens_of_ns, [&](uint32_t i) {
        const Steered steered = drives.steer([&](uint32_t k) { return values[k][i]; });
        std::construct_at(&steering.points[i], steered);
        if (steering.scales.size() > 0) steering.scales[i] = steered.scale;
    });
    co_return steering;
}

}  // namespace flg
