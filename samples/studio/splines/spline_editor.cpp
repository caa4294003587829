// SPDX-License-Identifier: MIT
#include "splines/spline_editor.h"

#include <algorithm>
#include <cmath>

namespace flg::studio::splines {
namespace {

// Linear RGB; new curves take the next one.
constexpr glm::vec3 kColors[] = {{0.66f, 0.035f, 0.020f}, {0.85f, 0.36f, 0.03f},   {0.012f, 0.085f, 0.42f},
                                 {0.010f, 0.20f, 0.19f},  {0.045f, 0.27f, 0.035f}, {0.33f, 0.03f, 0.26f}};

// Of the scene's size.
constexpr double kTube = 0.010, kOrnament = 0.03, kSolid = 0.13, kBody = 0.2;
constexpr double kTurns = 6.0;  // tension begins at the square of this over the size
constexpr double kSecond = 1.0;

template <class Live>
void forget(std::map<uint32_t, std::unique_ptr<Live>>& live, const auto& items) {
    std::erase_if(live, [&](const auto& entry) {
        return std::none_of(items.begin(), items.end(), [&](const auto& item) { return item.id == entry.first; });
    });
}

}  // namespace

glm::dquat upright(const glm::dvec3& up, const glm::dvec3& heading) {
    const glm::dvec3 y = glm::normalize(up);
    glm::dvec3 x = heading - glm::dot(heading, y) * y;
    if (!(glm::length(x) > 1e-6)) x = glm::cross(y, std::abs(y.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0));
    x = glm::normalize(x);
    return glm::normalize(glm::quat_cast(glm::dmat3(x, y, glm::cross(x, y))));
}

SplineEditor::SplineEditor(AppContext& app_) : app(app_) {}

const LiveCurve* SplineEditor::live_curve(uint32_t id) const {
    const auto found = live_curves_.find(id);
    return found == live_curves_.end() ? nullptr : found->second.get();
}

const LiveMotion* SplineEditor::live_motion(uint32_t id) const {
    const auto found = live_motions_.find(id);
    return found == live_motions_.end() ? nullptr : found->second.get();
}

SurfaceRef SplineEditor::ground_now() const {
    if (ground.kind != "mesh") return ground;
    const SceneMesh* const active = app.scene.active();
    return active != nullptr ? SurfaceRef{"mesh", active->id} : SurfaceRef{"space", 0};
}

// ---- Curves

Curve& SplineEditor::add_curve(const SurfaceRef& on) {
    end_drawing();
    begins_new = false;
    Curve added;
    added.id = ++document.last_id;
    const auto number = static_cast<uint32_t>(document.curves.size());
    added.name = next_name("Curve", number + 1);
    added.ground = on;
    const double size = this->size() / static_cast<double>(surfaces.placement(on).scale);
    added.tension = std::pow(kTurns / size, 2);
    added.look.color = kColors[number % std::size(kColors)];
    added.look.radius = static_cast<float>(kTube * size);
    added.ornament.size = static_cast<float>(kOrnament * size);
    // The look that the user gave to the last one is liked.
    if (const Curve* const like = chosen_curve()) {
        const glm::vec3 color = added.look.color;
        added.look = like->look;
        added.look.color = color;
        added.ornament = like->ornament;
    }
    curve = drawing = added.id;
    point = -1;
    return document.curves.emplace_back(std::move(added));
}

void SplineEditor::end_drawing() {
    drawing = 0;
    // A point alone is no curve.
    std::erase_if(document.curves, [](const Curve& c) { return c.points.size() < 2; });
}

void SplineEditor::begin_new() {
    end_drawing();
    point = -1;
    begins_new = true;
}

void SplineEditor::choose_curve(uint32_t id) {
    begins_new = false;
    if (id != curve) end_drawing();
    curve = id;
    point = -1;
}

void SplineEditor::remove_curve(uint32_t id) {
    if (drawing == id) drawing = 0;
    std::erase_if(document.curves, [&](const Curve& c) { return c.id == id; });
}

void SplineEditor::remove_point(Curve& of, int index) {
    if (index < 0 || static_cast<size_t>(index) >= of.points.size()) return;
    of.points.erase(of.points.begin() + index);
    point = -1;
    // While it is drawn it may go on from its first point; else a point alone is no curve.
    if (of.points.empty() || (of.points.size() < 2 && drawing != of.id)) remove_curve(of.id);
}

// ---- Obstacles

Obstacle& SplineEditor::add_obstacle(FlgObstacleKind of, const glm::dvec3& at) {
    if (document.obstacles.size() >= kMaxObstacles)
        throw StudioError("There are " + std::to_string(kMaxObstacles) + " obstacles already, the most there can be.");
    const double r = kSolid * size();
    const char* const word = of == FLG_OBSTACLE_KIND_BALL ? "Ball" : of == FLG_OBSTACLE_KIND_BOX ? "Box" : "Capsule";
    Obstacle added;
    added.id = ++document.last_id;
    added.name = next_name(word, static_cast<uint32_t>(document.obstacles.size()) + 1);
    added.kind = of;
    added.centre = at;
    added.half = glm::dvec3(0.8 * r);
    added.radius = of == FLG_OBSTACLE_KIND_CAPSULE ? 0.5 * r : r;
    added.to = at + glm::dvec3(0.0, 2.0 * r, 0.0);
    obstacle = added.id;
    return document.obstacles.emplace_back(std::move(added));
}

void SplineEditor::remove_obstacle(uint32_t id) {
    std::erase_if(document.obstacles, [&](const Obstacle& o) { return o.id == id; });
}

// ---- Motions

Motion& SplineEditor::add_motion(const SurfaceRef& on) {
    Motion added;
    added.id = ++document.last_id;
    added.name = next_name("Motion", static_cast<uint32_t>(document.motions.size()) + 1);
    added.ground = on;
    added.size = kBody * size();
    motion = added.id;
    key = -1;
    play(false);
    seconds = 0.0;
    return document.motions.emplace_back(std::move(added));
}

Key& SplineEditor::add_key(Motion& of, const glm::dvec3& at, const glm::dvec3& normal, const glm::dvec3& heading) {
    Key added;
    added.time = of.keys.empty() ? 0.0 : of.keys.back().time + kSecond;
    added.place = at;
    added.turn = upright(normal, heading);
    of.keys.push_back(added);
    key = static_cast<int>(of.keys.size()) - 1;
    return of.keys.back();
}

void SplineEditor::remove_motion(uint32_t id) {
    std::erase_if(document.motions, [&](const Motion& m) { return m.id == id; });
}

void SplineEditor::remove_key(Motion& of, int index) {
    if (index < 0 || static_cast<size_t>(index) >= of.keys.size()) return;
    of.keys.erase(of.keys.begin() + index);
    key = -1;
    if (of.keys.empty()) remove_motion(of.id);
}

void SplineEditor::play(bool on) {
    const LiveMotion* const live = live_motion(motion);
    playing = on && live != nullptr && live->found().poses.size() > 1;
    if (!playing) return;
    const FoundMotion& found = live->found();
    if (!(seconds >= found.begin() && seconds < found.end())) seconds = found.begin();
}

void SplineEditor::advance(double elapsed) {
    const LiveMotion* const live = live_motion(motion);
    if (live == nullptr || live->found().poses.empty()) {
        playing = false;
        return;
    }
    const FoundMotion& found = live->found();
    if (playing) seconds += elapsed;
    if (playing && seconds >= found.end()) {
        const double whole = found.end() - found.begin();
        seconds = found.closed && whole > 0.0 ? found.begin() + std::fmod(seconds - found.begin(), whole) : found.end();
        playing = found.closed;
    }
    // A key that was put just now is not among them yet.
    if (!live->busy()) seconds = std::clamp(seconds, found.begin(), found.end());
}

// ---- History

bool SplineEditor::give_up() {
    dragging = false;
    const bool moved = history.revert();
    settle_choice();
    return moved;
}

void SplineEditor::settle() {
    if (dragging || editing || !history.settle()) return;
    ++app.changes;
    if (did) did();
}

void SplineEditor::undo() {
    history.undo();
    ++app.changes;
    settle_choice();
}

void SplineEditor::redo() {
    history.redo();
    ++app.changes;
    settle_choice();
}

void SplineEditor::replace(Document other) {
    document = std::move(other);
    history.reset();
    curve = obstacle = motion = drawing = 0;
    point = key = -1;
    dragging = playing = begins_new = false;
    seconds = 0.0;
    if (!document.curves.empty()) curve = document.curves.back().id;
    if (!document.motions.empty()) motion = document.motions.back().id;
}

void SplineEditor::settle_choice() {
    // What was drawn and is gone may come back with redo.
    if (chosen_curve() == nullptr) curve = 0;
    if (curve == 0 && !document.curves.empty()) curve = document.curves.back().id;
    if (chosen_obstacle() == nullptr) obstacle = 0;
    if (chosen_motion() == nullptr) motion = document.motions.empty() ? 0 : document.motions.back().id;
    const Curve* const c = chosen_curve();
    if (c == nullptr || point >= static_cast<int>(c->points.size())) point = -1;
    const Motion* const m = chosen_motion();
    if (m == nullptr || key >= static_cast<int>(m->keys.size())) key = -1;
}

void SplineEditor::update() {
    settle();
    settle_choice();
    const double elapsed = last_seconds_ < 0.0 ? 0.0 : app.seconds - last_seconds_;
    last_seconds_ = app.seconds;

    std::vector<std::string> kinds;
    if (in_front) kinds.push_back(ground.kind);
    for (const Curve& c : document.curves) kinds.push_back(c.ground.kind);
    for (const Motion& m : document.motions) kinds.push_back(m.ground.kind);
    if (!app.scene.in_sight()) kinds.clear();
    surfaces.show(kinds);

    forget(live_curves_, document.curves);
    forget(live_motions_, document.motions);
    for (const Curve& c : document.curves) {
        auto& live = live_curves_[c.id];
        if (!live) live = std::make_unique<LiveCurve>(app, style_cache_);
        // While other workspaces cut its mesh a curve stays as it is.
        const bool asks = in_front || live->found().nodes.empty();
        live->update(c, asks ? surfaces.surface(c.ground) : std::nullopt, document.obstacles, surfaces);
    }
    for (const Motion& m : document.motions) {
        auto& live = live_motions_[m.id];
        if (!live) live = std::make_unique<LiveMotion>(app);
        live->update(m, document.obstacles, m.id == motion ? seconds : live->found().begin());
    }
    advance(elapsed);
    solids_.update(app.scene.in_sight() ? document.obstacles : std::vector<Obstacle>(), in_front ? obstacle : 0);
}

bool SplineEditor::busy() const {
    return std::any_of(live_curves_.begin(), live_curves_.end(),
                       [](const auto& live) { return live.second->busy(); }) ||
           std::any_of(live_motions_.begin(), live_motions_.end(),
                       [](const auto& live) { return live.second->busy(); });
}

void SplineEditor::device_lost() {
    for (auto& [id, live] : live_curves_) live->device_lost();
    for (auto& [id, live] : live_motions_) live->device_lost();
    solids_.device_lost();
    surfaces.device_lost();
}

}  // namespace flg::studio::splines
