// SPDX-License-Identifier: MIT
// What the user makes in the Splines workspace: curves through points, obstacles, motions through keys. Values only, so
// that a step of undo is a copy. Metres, seconds, linear RGB.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filigree/filigree_spline.h"

namespace flg::studio::splines {

// What points lie on.
struct SurfaceRef {
    std::string kind = "mesh";  // "mesh", "space" or the name of a shape (shapes.h)
    uint32_t mesh = 0;          // its id; 0: none
    bool operator==(const SurfaceRef&) const = default;
};

enum class Form { tube, ribbon, line };

struct CurveLook {
    Form form = Form::tube;
    glm::vec3 color{0.0f};
    float radius = 0.0f;
    bool operator==(const CurveLook&) const = default;
};

// A built-in style, laid along the curve in the surface's frame.
struct Ornament {
    bool on = false;
    bool flat = true;  // on the surface, else upright
    std::string style = "loops";
    float magnitude = 1.0f;
    float size = 0.0f;  // metres that the style swings away at magnitude 1
    bool operator==(const Ornament&) const = default;
};

struct Curve {
    uint32_t id = 0;
    std::string name;
    bool visible = true;
    SurfaceRef ground;
    std::vector<glm::dvec3> points;
    bool closed = false;
    FlgSplineEnergy energy = FLG_SPLINE_ENERGY_E2;
    double tension = 0.0;  // 1 / square metre
    double waves = 0.0;    // metres: shorter waves are smoothed away; 0: through the points
    int density = 32;      // nodes from point to point
    std::optional<glm::dvec3> begin_slope, end_slope;
    bool avoid = true;   // obstacles
    bool inside = true;  // an open mesh's borders
    CurveLook look;
    Ornament ornament;
    bool operator==(const Curve&) const = default;
};

struct Obstacle {
    uint32_t id = 0;
    std::string name;
    FlgObstacleKind kind = FLG_OBSTACLE_KIND_BALL;  // or box, or capsule
    glm::dvec3 centre{0.0};
    glm::dvec3 half{0.0};  // of a box
    glm::dvec3 to{0.0};    // of a capsule
    double radius = 0.0;
    bool operator==(const Obstacle&) const = default;
};

struct Key {
    double time = 0.0;
    glm::dvec3 place{0.0};
    glm::dquat turn{1.0, 0.0, 0.0, 0.0};
    bool operator==(const Key&) const = default;
};

enum class Inertia { body, ball, rod };

struct Motion {
    uint32_t id = 0;
    std::string name;
    bool visible = true;
    SurfaceRef ground;  // where keys are placed
    int body = 0;       // of body_names()
    double size = 0.0;
    std::vector<Key> keys;
    bool closed = false;
    FlgSplineEnergy energy = FLG_SPLINE_ENERGY_E2;
    double tension = 1.0;  // 1 / square second
    Inertia inertia = Inertia::body;
    bool avoid = true;
    int ghosts = 12;
    bool operator==(const Motion&) const = default;
};

// As many as a set of the SDK takes, with borders.
constexpr size_t kMaxObstacles = 255;

struct Document {
    std::vector<Curve> curves;
    std::vector<Obstacle> obstacles;
    std::vector<Motion> motions;
    uint32_t last_id = 0;
    bool operator==(const Document&) const = default;

    Curve* curve(uint32_t id);
    Obstacle* obstacle(uint32_t id);
    Motion* motion(uint32_t id);
    const Curve* curve(uint32_t id) const;
    const Obstacle* obstacle(uint32_t id) const;
    const Motion* motion(uint32_t id) const;
};

// A number and a word: "Curve 3".
std::string next_name(const char* word, uint32_t number);

// Meshes are named by their places in the scene's list, whose ids these are.
nlohmann::json to_json(const Document& document, const std::vector<uint32_t>& mesh_ids);
// Throws StudioError for what can't be, with a sentence.
Document from_json(const nlohmann::json& json, const std::vector<uint32_t>& mesh_ids);

}  // namespace flg::studio::splines
