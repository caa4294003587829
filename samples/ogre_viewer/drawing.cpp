// SPDX-License-Identifier: MIT
#include "drawing.h"

#include <OgreQuaternion.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace viewer {
namespace {

using Json = nlohmann::json;
using Pairs = std::vector<std::array<double, 2>>;

Ogre::Vector3 vector_of(const Json& item, const char* key) {
    const auto v = item.value(key, std::array<float, 3>{});
    return {v[0], v[1], v[2]};
}

// Of "#rrggbb", sRGB.
Ogre::ColourValue linear_colour(const std::string& text) {
    const auto hex = static_cast<uint32_t>(std::stoul(text.substr(1), nullptr, 16));
    const auto channel = [&](uint32_t shift) {
        return std::pow(static_cast<float>(hex >> shift & 255u) / 255.0f, 2.2f);
    };
    return Ogre::ColourValue(channel(16), channel(8), channel(0));
}

// A closed Catmull-Rom curve through the points.
std::vector<double> smooth(const Pairs& points) {
    constexpr int kSteps = 8;
    const size_t n = points.size();
    std::vector<double> curve;
    for (size_t i = 0; i < n; ++i) {
        const auto &a = points[(i + n - 1) % n], &b = points[i], &c = points[(i + 1) % n], &d = points[(i + 2) % n];
        for (int k = 0; k < kSteps; ++k) {
            const double t = static_cast<double>(k) / kSteps;
            for (size_t x = 0; x < 2; ++x) {
                const double cubic = 3 * (b[x] - c[x]) + d[x] - a[x], square = 2 * a[x] - 5 * b[x] + 4 * c[x] - d[x];
                curve.push_back(b[x] + 0.5 * t * (c[x] - a[x] + t * (square + t * cubic)));
            }
        }
    }
    return curve;
}

// Turned by degrees about x, then y, then z, then moved.
Ogre::Matrix4 placement_of(const Json& part) {
    const Ogre::Vector3 turn = vector_of(part, "turn");
    const Ogre::Quaternion x(Ogre::Degree(turn.x), Ogre::Vector3::UNIT_X),
        y(Ogre::Degree(turn.y), Ogre::Vector3::UNIT_Y), z(Ogre::Degree(turn.z), Ogre::Vector3::UNIT_Z);
    Ogre::Matrix4 placement;
    placement.makeTransform(vector_of(part, "at"), Ogre::Vector3::UNIT_SCALE, z * y * x);
    return placement;
}

}  // namespace

Drawing read_drawing(const std::string& text) {
    const Json json = Json::parse(text);
    const auto mirror = json.value("mirror", std::array<float, 4>{1, 0, 0, 0});
    Drawing drawing = {{mirror[0], mirror[1], mirror[2], mirror[3]},
                       json.at("simplify"),
                       json.at("merge"),
                       json.at("prune"),
                       json.at("collapse"),
                       {}};
    for (const Json& part : json.at("parts")) {
        drawing.parts.push_back({part.at("name"), smooth(part.at("curve").get<Pairs>()), placement_of(part),
                                 part.value("thickness", 1.0f), part.value("prune", drawing.prune),
                                 part.value("mirrored", false), linear_colour(part.at("color"))});
    }
    return drawing;
}

}  // namespace viewer
