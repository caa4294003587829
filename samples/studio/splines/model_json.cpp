// SPDX-License-Identifier: MIT
// The workspace's part of a document. Numbers are checked for what the SDK could not take.
#include <algorithm>
#include <cmath>

#include "documents/failure.h"
#include "documents/json_place.h"
#include "shell/studio_error.h"
#include "splines/bodies.h"
#include "splines/model.h"
#include "splines/ornaments.h"
#include "splines/shapes.h"

namespace flg::studio::splines {
namespace {

using nlohmann::json;

constexpr const char* kEnergies[] = {"e2", "e1", "et"};
constexpr const char* kForms[] = {"tube", "ribbon", "line"};
constexpr const char* kKinds[] = {"ball", "box", "capsule"};
constexpr const char* kInertias[] = {"body", "ball", "rod"};
constexpr double kFarthest = 1e6;
constexpr size_t kMaxItems = 4096, kMaxPoints = 4096;

json from_vector(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

// ---- Reading

using cli::JsonPlace;

glm::dvec3 vector(const JsonPlace& place, double low = -kFarthest) {
    const std::vector<JsonPlace> items = place.items();
    if (items.size() != 3) place.fail("must be 3 numbers");
    return {items[0].real(low, kFarthest), items[1].real(low, kFarthest), items[2].real(low, kFarthest)};
}

std::vector<JsonPlace> list(const JsonPlace& place, size_t most) {
    std::vector<JsonPlace> items = place.items();
    if (items.size() > most) place.fail("has more than " + std::to_string(most) + " items");
    return items;
}

template <class Words>
int word(const JsonPlace& place, const Words& words) {
    const std::string value = place.text();
    const auto found = std::find(std::begin(words), std::end(words), value);
    if (found == std::end(words)) place.fail("can't be " + value);
    return static_cast<int>(found - std::begin(words));
}

// ---- Both ways

json from_ground(const SurfaceRef& ground, const std::vector<uint32_t>& ids) {
    if (ground.kind != "mesh") return ground.kind;
    const auto found = std::find(ids.begin(), ids.end(), ground.mesh);
    return found == ids.end() ? json(-1) : json(found - ids.begin());
}

SurfaceRef to_ground(const JsonPlace& place, const std::vector<uint32_t>& ids) {
    if (place.is_string()) {
        const std::string kind = place.text();
        if (kind != "space" && find_shape(kind) == nullptr) place.fail("there is no surface " + kind);
        return {kind, 0};
    }
    const double index = place.real(-1.0, kFarthest);
    return {"mesh", index >= 0.0 && index < static_cast<double>(ids.size()) ? ids[static_cast<size_t>(index)] : 0};
}

// What is on a mesh that was taken out goes with it.
bool is_there(const SurfaceRef& ground, const std::vector<uint32_t>& ids) {
    return ground.kind != "mesh" || ground.mesh == 0 || std::find(ids.begin(), ids.end(), ground.mesh) != ids.end();
}

json from_curve(const Curve& c, const std::vector<uint32_t>& ids) {
    json points = json::array();
    for (const glm::dvec3& p : c.points) points.push_back(from_vector(p));
    json out = {{"name", c.name},
                {"visible", c.visible},
                {"on", from_ground(c.ground, ids)},
                {"points", points},
                {"closed", c.closed},
                {"energy", kEnergies[c.energy]},
                {"tension", c.tension},
                {"waves", c.waves},
                {"density", c.density},
                {"avoid", c.avoid},
                {"inside", c.inside},
                {"form", kForms[static_cast<int>(c.look.form)]},
                {"color", from_vector(c.look.color)},
                {"radius", c.look.radius},
                {"ornament", c.ornament.on},
                {"flat", c.ornament.flat},
                {"style", c.ornament.style},
                {"magnitude", c.ornament.magnitude},
                {"style_size", c.ornament.size}};
    if (c.begin_slope) out["begin_slope"] = from_vector(*c.begin_slope);
    if (c.end_slope) out["end_slope"] = from_vector(*c.end_slope);
    return out;
}

Curve to_curve(const JsonPlace& j, const std::vector<uint32_t>& ids) {
    Curve c;
    c.name = j.at("name").text();
    c.visible = j.at("visible").flag();
    c.ground = to_ground(j.at("on"), ids);
    for (const JsonPlace& p : list(j.at("points"), kMaxPoints)) c.points.push_back(vector(p));
    c.closed = j.at("closed").flag();
    c.energy = static_cast<FlgSplineEnergy>(word(j.at("energy"), kEnergies));
    c.tension = j.at("tension").real(1e-12, 1e12);
    c.waves = j.at("waves").real(0.0, kFarthest);
    c.density = static_cast<int>(j.at("density").count(2, 256));
    c.avoid = j.at("avoid").flag();
    c.inside = j.at("inside").flag();
    c.look.form = static_cast<Form>(word(j.at("form"), kForms));
    c.look.color = glm::min(glm::vec3(vector(j.at("color"), 0.0)), 1.0f);
    c.look.radius = j.at("radius").number(1e-9f, kFarthest);
    c.ornament.on = j.at("ornament").flag();
    c.ornament.flat = j.at("flat").flag();
    c.ornament.style = style_names()[static_cast<size_t>(word(j.at("style"), style_names()))];
    c.ornament.magnitude = j.at("magnitude").number(0.0f, 100.0f);
    c.ornament.size = j.at("style_size").number(1e-9f, kFarthest);
    if (const auto slope = j.find("begin_slope")) c.begin_slope = vector(*slope);
    if (const auto slope = j.find("end_slope")) c.end_slope = vector(*slope);
    return c;
}

json from_obstacle(const Obstacle& o) {
    return {{"name", o.name},
            {"kind", kKinds[o.kind]},
            {"centre", from_vector(o.centre)},
            {"half", from_vector(o.half)},
            {"to", from_vector(o.to)},
            {"radius", o.radius}};
}

Obstacle to_obstacle(const JsonPlace& j) {
    Obstacle o;
    o.name = j.at("name").text();
    o.kind = static_cast<FlgObstacleKind>(word(j.at("kind"), kKinds));
    o.centre = vector(j.at("centre"));
    o.half = vector(j.at("half"), 1e-9);
    o.to = vector(j.at("to"));
    o.radius = j.at("radius").real(1e-9, kFarthest);
    return o;
}

json from_motion(const Motion& m, const std::vector<uint32_t>& ids) {
    json keys = json::array();
    for (const Key& k : m.keys) {
        keys.push_back({{"time", k.time},
                        {"position", from_vector(k.place)},
                        {"rotation", {k.turn.x, k.turn.y, k.turn.z, k.turn.w}}});
    }
    return {{"name", m.name},
            {"visible", m.visible},
            {"on", from_ground(m.ground, ids)},
            {"body", body_names()[static_cast<size_t>(m.body)]},
            {"size", m.size},
            {"keys", keys},
            {"closed", m.closed},
            {"energy", kEnergies[m.energy]},
            {"tension", m.tension},
            {"inertia", kInertias[static_cast<int>(m.inertia)]},
            {"avoid", m.avoid},
            {"ghosts", m.ghosts}};
}

Motion to_motion(const JsonPlace& j, const std::vector<uint32_t>& ids) {
    Motion m;
    m.name = j.at("name").text();
    m.visible = j.at("visible").flag();
    m.ground = to_ground(j.at("on"), ids);
    m.body = word(j.at("body"), body_names());
    m.size = j.at("size").real(1e-9, kFarthest);
    for (const JsonPlace& k : list(j.at("keys"), kMaxPoints)) {
        Key key;
        key.time = k.at("time").real(-kFarthest, kFarthest);
        if (!m.keys.empty() && !(key.time > m.keys.back().time)) k.fail("is no later than the key before");
        key.place = vector(k.at("position"));
        const std::vector<JsonPlace> q = list(k.at("rotation"), 4);
        if (q.size() != 4) k.fail("`rotation` must be 4 numbers");
        const glm::dquat turn(q[3].real(-1.1, 1.1), q[0].real(-1.1, 1.1), q[1].real(-1.1, 1.1), q[2].real(-1.1, 1.1));
        if (!(std::abs(glm::length(turn) - 1.0) <= 1e-3)) k.fail("`rotation` is no quaternion of length 1");
        key.turn = glm::normalize(turn);
        m.keys.push_back(key);
    }
    m.closed = j.at("closed").flag();
    m.energy = static_cast<FlgSplineEnergy>(word(j.at("energy"), kEnergies));
    m.tension = j.at("tension").real(1e-12, 1e12);
    m.inertia = static_cast<Inertia>(word(j.at("inertia"), kInertias));
    m.avoid = j.at("avoid").flag();
    m.ghosts = static_cast<int>(j.at("ghosts").count(0, 60));
    return m;
}

}  // namespace

json to_json(const Document& document, const std::vector<uint32_t>& ids) {
    json curves = json::array(), obstacles = json::array(), motions = json::array();
    for (const Curve& c : document.curves)
        if (is_there(c.ground, ids)) curves.push_back(from_curve(c, ids));
    for (const Obstacle& o : document.obstacles) obstacles.push_back(from_obstacle(o));
    for (const Motion& m : document.motions) motions.push_back(from_motion(m, ids));
    return {{"curves", curves}, {"obstacles", obstacles}, {"motions", motions}};
}

Document from_json(const json& part, const std::vector<uint32_t>& ids) {
    Document document;
    if (part.is_null() || (part.is_object() && part.empty())) return document;
    try {
        const JsonPlace j(part, "splines");
        for (const JsonPlace& c : list(j.at("curves"), kMaxItems)) document.curves.push_back(to_curve(c, ids));
        for (const JsonPlace& o : list(j.at("obstacles"), kMaxObstacles)) document.obstacles.push_back(to_obstacle(o));
        for (const JsonPlace& m : list(j.at("motions"), kMaxItems)) document.motions.push_back(to_motion(m, ids));
    } catch (const cli::InputError& error) {
        throw StudioError(error.what());
    }
    for (Curve& c : document.curves) c.id = ++document.last_id;
    for (Obstacle& o : document.obstacles) o.id = ++document.last_id;
    for (Motion& m : document.motions) m.id = ++document.last_id;
    return document;
}

}  // namespace flg::studio::splines
