// SPDX-License-Identifier: MIT
#include "documents/pull_script.h"

#include <algorithm>
#include <cstdio>

#include "documents/json_place.h"
#include "filigree/filigree_pull.h"

namespace flg::cli {
namespace {

constexpr double largest = 1e30, latest = 1e4;  // metres; seconds

std::array<double, 3> read_point(const JsonPlace& list) {
    const std::vector<JsonPlace> items = list.items();
    if (items.size() != 3) list.fail("must be 3 numbers, not " + std::to_string(items.size()));
    std::array<double, 3> point;
    for (size_t k = 0; k < 3; ++k) point[k] = items[k].real(-largest, largest);
    return point;
}

void read_key(const JsonPlace& key, PullScriptHandle& handle) {
    key.allow({"time", "position", "move"});
    const JsonPlace time = key.at("time");
    const double seconds = time.real(0, latest);
    if (!handle.times.empty() && !(seconds > handle.times.back())) {
        char text[96];
        std::snprintf(text, sizeof text, "is %.9g after %.9g; times of a handle must rise", seconds,
                      handle.times.back());
        time.fail(text);
    }
    const auto position = key.find("position"), move = key.find("move");
    if (position.has_value() == move.has_value()) key.fail("needs `position` or `move`, and not both");
    if (!handle.times.empty() && handle.moves != move.has_value())
        key.fail("all keys of a handle must be positions, or all moves");
    handle.moves = move.has_value();
    handle.times.push_back(seconds);
    const std::array<double, 3> point = read_point(move ? *move : *position);
    handle.positions.insert(handle.positions.end(), point.begin(), point.end());
}

// `radius`: unless it has its own.
PullScriptHandle read_handle(const JsonPlace& place, double radius) {
    place.allow({"at", "compliance", "radius", "keys"});
    PullScriptHandle handle;
    const JsonPlace at = place.at("at");
    handle.place = at.path();
    handle.at = read_point(at);
    if (const auto compliance = place.find("compliance")) handle.compliance = compliance->real(0, largest);
    if (const auto own = place.find("radius")) radius = own->real(0, largest);
    handle.radius = radius;
    const JsonPlace keys = place.at("keys");
    for (const JsonPlace& key : keys.items()) read_key(key, handle);
    if (handle.times.empty()) keys.fail("is empty: a handle needs at least one key");
    return handle;
}

}  // namespace

double PullScript::begin() const {
    double first = latest;
    for (const PullScriptHandle& handle : handles) first = std::min(first, handle.times.front());
    return first;
}

double PullScript::end() const {
    double last = 0;
    for (const PullScriptHandle& handle : handles) last = std::max(last, handle.times.back());
    return last;
}

PullScript read_pull_script(const std::string& path) {
    const nlohmann::json json = JsonPlace::read(path);
    const JsonPlace root(json, path);
    root.allow({"name", "motion", "rate", "rounds", "tolerance", "radius", "pins", "handles"});
    PullScript script;
    script.subject = path;
    if (const auto place = root.find("name")) script.name = place->text();
    if (script.name.empty()) root.at("name").fail("is empty");
    if (const auto place = root.find("motion")) script.motion = place->text();
    if (const auto place = root.find("rate")) script.rate = place->real(1, 240);
    if (const auto place = root.find("rounds")) script.rounds = place->count(1, 1000);
    if (const auto place = root.find("tolerance")) script.tolerance = place->real(0, 1);
    double radius = -1;
    if (const auto place = root.find("radius")) radius = place->real(0, largest);
    const JsonPlace handles = root.at("handles");
    for (const JsonPlace& place : handles.items()) script.handles.push_back(read_handle(place, radius));
    if (script.handles.empty()) handles.fail("is empty: nothing is pulled");
    const double begin = script.begin();
    if (const auto pins = root.find("pins")) {
        for (const JsonPlace& place : pins->items()) {
            PullScriptHandle pin;
            pin.place = place.path();
            pin.at = read_point(place);
            pin.moves = true;
            pin.radius = radius;
            pin.times = {begin};
            pin.positions = {0, 0, 0};
            script.handles.push_back(std::move(pin));
        }
    }
    if (script.handles.size() > FLG_PULL_MAX_HANDLES)
        handles.fail("and the pins are " + std::to_string(script.handles.size()) + ", at most " +
                     std::to_string(FLG_PULL_MAX_HANDLES) + " are pulled at");
    return script;
}

}  // namespace flg::cli
