// SPDX-License-Identifier: MIT
// Drawings that are hard to bind: silhouettes with limbs beside each other, and parts that cross or lie in front of
// others.
#pragma once

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace flg::test {

using Json = nlohmann::json;
using Outline = std::vector<std::array<double, 2>>;
using Way = std::vector<std::array<double, 3>>;  // x, y and half the width

// Around a way, with round ends.
inline Outline limb(const Way& way) {
    constexpr uint32_t steps = 6, cap = 5;
    const size_t n = way.size();
    const auto at = [&](size_t piece, double t) {
        std::array<double, 3> p{};
        const auto &a = way[piece == 0 ? 0 : piece - 1], &b = way[piece], &c = way[piece + 1],
                   &d = way[std::min(piece + 2, n - 1)];
        for (size_t i = 0; i < 3; ++i)
            p[i] = b[i] + 0.5 * t *
                              (c[i] - a[i] +
                               t * (2 * a[i] - 5 * b[i] + 4 * c[i] - d[i] + t * (3 * (b[i] - c[i]) + d[i] - a[i])));
        return p;
    };
    Way fine;
    for (size_t piece = 0; piece + 1 < n; ++piece)
        for (uint32_t k = 0; k < steps; ++k) fine.push_back(at(piece, static_cast<double>(k) / steps));
    fine.push_back(way.back());
    const auto direction = [&](size_t i) {
        const auto &a = fine[i == 0 ? 0 : i - 1], &b = fine[std::min(i + 1, fine.size() - 1)];
        return std::atan2(b[1] - a[1], b[0] - a[0]);
    };
    Outline out;
    const auto add = [&](size_t i, double angle) {
        out.push_back({fine[i][0] + fine[i][2] * std::cos(angle), fine[i][1] + fine[i][2] * std::sin(angle)});
    };
    for (size_t i = 0; i < fine.size(); ++i) add(i, direction(i) - M_PI / 2);
    for (uint32_t k = 1; k < cap; ++k) add(fine.size() - 1, direction(fine.size() - 1) - M_PI / 2 + M_PI * k / cap);
    for (size_t i = fine.size(); i-- > 0;) add(i, direction(i) + M_PI / 2);
    for (uint32_t k = 1; k < cap; ++k) add(0, direction(0) + M_PI / 2 + M_PI * k / cap);
    return out;
}

inline Outline oval(double x, double y, double rx, double ry) {
    Outline out;
    for (uint32_t i = 0; i < 40; ++i)
        out.push_back({x + rx * std::cos(2 * M_PI * i / 40), y + ry * std::sin(2 * M_PI * i / 40)});
    return out;
}

// A drawing under construction: parts in the plane z = 0, or beside it.
class Drawing {
public:
    Drawing& add(const std::string& name, const Outline& contour, double z = 0, bool mirrored = false) {
        Json part = {{"name", name}, {"contour", contour}, {"thickness", 0.8}, {"at", {0, 0, z}}};
        if (mirrored) part["mirrored"] = true;
        json_["parts"].push_back(part);
        return *this;
    }
    Drawing& mirror_at(const std::array<double, 4>& plane) {
        json_["mirror"] = plane;
        return *this;
    }
    operator Json() const { return json_; }

private:
    Json json_ = {{"parts", Json::array()}};
};

struct NamedDrawing {
    std::string name;
    Json json;
};

// One contour each.
inline std::vector<NamedDrawing> silhouettes() {
    // A body, and beside it a thin tail that begins at one end.
    const Outline notch = {{0, 0}, {10, 0}, {10, 4}, {1, 4}, {1, 4.4}, {12, 4.4}, {12, 5}, {0.5, 5}, {0, 4.5}};
    const Outline cow = {{0, 4},      {1, 5.5},   {2.4, 5.8}, {2.8, 5}, {9, 5},     {10, 4.6},   {10.4, 2},
                         {10.2, 1.9}, {9.7, 3.8}, {9.6, 0},   {8.9, 0}, {8.8, 2.2}, {8.7, 2.2},  {8.6, 0},
                         {7.9, 0},    {7.6, 2.4}, {4.6, 2.2}, {4.5, 0}, {3.9, 0},   {3.85, 2.0}, {3.7, 2.0},
                         {3.6, 0},    {3, 0},     {2.8, 3},   {2, 4.2}, {1.2, 3.6}, {0.3, 3.4}};
    Outline comb = {{0, 0}, {6, 0}};
    for (int finger = 4; finger >= 0; --finger) {
        const double x = 1.2 * finger;
        comb.insert(comb.end(), {{x + 1.15, 3}, {x + 1.05, 7}, {x + 0.1, 7}, {x + 0.05, 3}});
    }
    Outline star;
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 == 0 ? 4 : 1.1, angle = M_PI * i / 5 + 0.3;
        star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    Way snake;
    for (int i = 0; i <= 32; ++i) {
        const double s = i / 32.0;
        snake.push_back({8 * s, 1.5 * std::sin(3 * M_PI * s), 0.4 - 0.2 * s});
    }
    // Fingers that part in points.
    const Outline hand = {{0, -2.88},    {0.54, -2.65}, {0.8, -0.76},  {1.09, -0.15}, {1.1, 1.07},   {1.25, 1.31},
                          {1.71, 3.2},   {1.54, 3.44},  {1.25, 3.36},  {0.7, 1.85},   {0.77, 3.78},  {0.5, 3.98},
                          {0.25, 3.81},  {0.03, 2.1},   {-0.18, 3.84}, {-0.44, 4.03}, {-0.69, 3.84}, {-0.67, 1.99},
                          {-1.16, 3.55}, {-1.43, 3.66}, {-1.63, 3.46}, {-1.2, 1.31},  {-1.11, 0.51}, {-1.66, 0.84},
                          {-2.18, 1.45}, {-2.44, 1.44}, {-2.58, 1.19}, {-2.14, 0.38}, {-0.8, -0.76}, {-0.67, -2.4}};
    const Outline hook = limb({{0, 0, 0.8}, {4, 0, 0.8}, {5.2, 0.9, 0.5}, {4, 1.7, 0.3}, {0, 1.4, 0.15}});
    std::vector<NamedDrawing> all;
    const auto add = [&](const std::string& name, const Outline& contour) {
        all.push_back({name, Drawing().add(name, contour)});
    };
    add("notch", notch);
    add("cow", cow);
    add("comb", comb);
    add("starfish", star);
    add("snake", limb(snake));
    add("hook", hook);
    add("hand", hand);
    return all;
}

// Limbs that cross each other or what they do not hang on.
inline std::vector<NamedDrawing> crossings() {
    std::vector<NamedDrawing> all;
    const auto keep = [&](const std::string& name, const Drawing& drawing) { all.push_back({name, drawing}); };
    keep("giraffe", Drawing()
                        .add("body", oval(0, 0, 2.2, 1))
                        .add("neck", limb({{1.5, 0.3, 0.6}, {2.4, 2, 0.35}, {2.9, 4, 0.3}}))
                        .add("head", limb({{2.7, 4, 0.35}, {3.9, 3.8, 0.22}}))
                        .add("front", limb({{1.3, -0.3, 0.4}, {1.0, -2, 0.22}, {0.5, -4, 0.18}}))
                        .add("other", limb({{0.9, -0.3, 0.4}, {1.1, -2, 0.22}, {1.6, -4, 0.18}}))
                        .add("hind", limb({{-1.5, -0.2, 0.45}, {-1.2, -2, 0.22}, {-0.7, -4, 0.18}}))
                        .add("last", limb({{-1.1, -0.2, 0.45}, {-1.2, -2, 0.22}, {-1.8, -4, 0.18}})));
    Drawing octopus;
    octopus.add("head", oval(0, 1, 1.2, 1.5));
    for (int i = 0; i < 8; ++i) {
        const double x = (i - 3.5) * 0.28, to = (i % 2 == 0 ? 1.2 : -1.2) + 1.8 * x;
        octopus.add("arm" + std::to_string(i), limb({{x, 0.4, 0.24}, {1.3 * x, -1.4, 0.2}, {to, -3.6, 0.1}}));
    }
    keep("octopus", octopus);
    Drawing spider;
    spider.add("body", oval(0, 0, 1, 0.7))
        .add("abdomen", oval(-1.6, 0.3, 1.2, 0.9))
        .add("head", oval(1.1, 0, 0.5, 0.4));
    for (int i = 0; i < 8; ++i) {
        const double side = i % 2 == 0 ? 1 : -1, from = 0.6 - 0.2 * (i / 2), to = side * (3.2 - 0.5 * (i / 2));
        spider.add("leg" + std::to_string(i),
                   limb({{from, -0.1, 0.16}, {from + 0.8 * side, 1.0, 0.12}, {to, -1.2, 0.06}}));
    }
    keep("spider", spider);
    keep("chair", Drawing()
                      .add("seat", limb({{-1.5, 0, 0.3}, {1.5, 0, 0.3}}))
                      .add("back", limb({{-1.4, 0, 0.25}, {-1.6, 3, 0.2}}))
                      .add("left", limb({{-1.2, 0, 0.2}, {1.2, -3, 0.18}}))
                      .add("right", limb({{1.2, 0, 0.2}, {-1.2, -3, 0.18}}))
                      .add("strut", limb({{-1.3, 0, 0.15}, {-1.3, -3, 0.15}})));
    const auto person = [] {
        Drawing drawing;
        drawing.add("torso", limb({{0, 0, 0.8}, {0, 1.2, 0.75}, {0, 2.2, 0.95}})).add("head", oval(0, 4, 0.6, 0.75));
        return drawing.add("neck", limb({{0, 2.8, 0.3}, {0, 3.6, 0.3}}));
    };
    const Outline left_leg = limb({{0.4, -0.3, 0.42}, {0.5, -2, 0.3}, {0.5, -4, 0.2}}),
                  right_leg = limb({{-0.4, -0.3, 0.42}, {-0.5, -2, 0.3}, {-0.5, -4, 0.2}});
    keep("crossed_arms",
         person()
             .add("left_leg", left_leg)
             .add("right_leg", right_leg)
             .add("left_arm", limb({{0.8, 2.6, 0.3}, {1.6, 1.2, 0.24}, {0, 1.0, 0.2}, {-1.2, 1.5, 0.16}}))
             .add("right_arm", limb({{-0.8, 2.6, 0.3}, {-1.6, 1.2, 0.24}, {0, 1.0, 0.2}, {1.2, 1.5, 0.16}})));
    keep("arms_on_chest",
         person()
             .add("left_leg", left_leg)
             .add("right_leg", right_leg)
             .add("left_arm", limb({{0.8, 2.6, 0.3}, {0.9, 1.6, 0.26}, {0.1, 0.9, 0.2}, {-0.3, 0.9, 0.18}}))
             .add("right_arm", limb({{-0.8, 2.6, 0.3}, {-1.2, 1.2, 0.24}, {-0.3, 0.4, 0.2}, {0.4, 0.5, 0.16}})));
    keep("arms_across", person()
                            .add("left_leg", left_leg)
                            .add("right_leg", right_leg)
                            .add("left_arm", limb({{0.85, 2.6, 0.3}, {0.2, 1.9, 0.24}, {-0.6, 1.1, 0.16}}))
                            .add("right_arm", limb({{-0.85, 2.6, 0.3}, {-0.2, 1.9, 0.24}, {0.6, 1.1, 0.16}})));
    keep("crossed_legs", person()
                             .add("left_leg", limb({{0.4, -0.3, 0.42}, {0, -2, 0.3}, {-0.8, -4, 0.2}}))
                             .add("right_leg", limb({{-0.4, -0.3, 0.42}, {0, -2, 0.3}, {0.8, -4, 0.2}}))
                             .add("left_arm", limb({{0.8, 2.6, 0.3}, {1.5, 1.2, 0.22}, {1.7, -0.4, 0.16}}))
                             .add("right_arm", limb({{-0.8, 2.6, 0.3}, {-1.5, 1.2, 0.22}, {-1.7, -0.4, 0.16}})));
    keep("trex",
         Drawing()
             .mirror_at({0, 0, 1, 0})
             .add("body", limb({{-1, 0, 0.9}, {0.6, 0.6, 1.0}, {1.6, 1.8, 0.7}}))
             .add("tail", limb({{-1, 0, 0.8}, {-3, -0.3, 0.4}, {-5, 0, 0.12}}))
             .add("head", limb({{1.5, 2.3, 0.6}, {2.6, 2.9, 0.6}, {3.6, 2.7, 0.35}}))
             .add("leg", limb({{-0.4, -0.2, 0.6}, {0.2, -1.5, 0.35}, {-0.5, -2.7, 0.22}, {0.6, -3.3, 0.15}}), 0.3, true)
             .add("arm", limb({{1.2, 1.1, 0.22}, {1.7, 0.5, 0.15}, {2.1, 0.6, 0.1}}), 0.25, true));
    keep("scissors", Drawing()
                         .add("joint", oval(0, 0, 0.5, 0.5))
                         .add("one", limb({{0, 0, 0.3}, {1.5, 1.2, 0.25}, {3, 0, 0.22}, {4.5, -1.4, 0.1}}))
                         .add("two", limb({{0, 0, 0.3}, {1.5, -1.2, 0.25}, {3, 0, 0.22}, {4.5, 1.4, 0.1}})));
    keep("dog", Drawing()
                    .mirror_at({0, 0, 1, 0})
                    .add("body", oval(0, 0, 2, 0.9))
                    .add("head", oval(2.2, 1, 0.8, 0.6))
                    .add("front", limb({{1.3, -0.2, 0.4}, {1.3, -1.5, 0.28}, {1.5, -2.6, 0.22}}), 0.15, true)
                    .add("hind", limb({{-1.3, -0.2, 0.5}, {-1.6, -1.5, 0.28}, {-1.3, -2.6, 0.22}}), 0.15, true)
                    .add("tail", limb({{-1.8, 0.2, 0.2}, {-2.6, 1, 0.15}, {-2.4, 2, 0.08}})));
    keep("folded_wings", Drawing()
                             .mirror_at({0, 0, 1, 0})
                             .add("body", oval(0, 0, 2, 1.1))
                             .add("head", oval(2, 1, 0.7, 0.6))
                             .add("wing", limb({{1, 0.5, 0.5}, {-0.5, 0.3, 0.6}, {-2.6, -0.4, 0.15}}), 0.8, true)
                             .add("leg", limb({{0, -0.6, 0.25}, {0.1, -2, 0.12}}), 0.3, true));
    keep("braid",
         Drawing()
             .add("stump", oval(0, 0, 1, 0.6))
             .add("first",
                  limb({{-0.5, 0, 0.25}, {-0.5, 1.2, 0.22}, {0.5, 2.2, 0.2}, {-0.5, 3.4, 0.17}, {0.5, 4.6, 0.12}}))
             .add("second",
                  limb({{0.5, 0, 0.25}, {0.5, 1.2, 0.22}, {-0.5, 2.2, 0.2}, {0.5, 3.4, 0.17}, {-0.5, 4.6, 0.12}})));
    keep("tree", Drawing()
                     .add("trunk", limb({{0, 0, 0.5}, {0.1, 2, 0.4}, {0, 4, 0.3}}))
                     .add("low", limb({{0, 1.6, 0.22}, {1.2, 2.6, 0.18}, {1.4, 4.6, 0.1}}))
                     .add("mid", limb({{0, 2.4, 0.22}, {1.2, 2.9, 0.17}, {2.6, 2.8, 0.1}}))
                     .add("high", limb({{0, 3.2, 0.22}, {1.0, 4.2, 0.16}, {2.6, 4.0, 0.1}}))
                     .add("left", limb({{0, 2.2, 0.22}, {-1.2, 3.2, 0.16}, {-1.6, 4.6, 0.1}}))
                     .add("upper", limb({{0, 3.4, 0.22}, {-1.0, 3.6, 0.16}, {-2.6, 4.0, 0.1}})));
    keep("robot", person()
                      .add("left_leg", left_leg)
                      .add("right_leg", right_leg)
                      .add("left_arm", limb({{0.8, 2.6, 0.26}, {1.1, 1.4, 0.2}, {0.6, 0.2, 0.16}}))
                      .add("right_arm", limb({{-0.8, 2.6, 0.26}, {-1.1, 1.4, 0.2}, {-0.6, 0.2, 0.16}})));
    keep("crab", Drawing()
                     .add("shell", oval(0, 0, 2, 1.2))
                     .add("left", limb({{-1.4, 0.5, 0.3}, {-1.6, 2, 0.25}, {0.2, 2.6, 0.3}, {1.4, 2.9, 0.1}}))
                     .add("right", limb({{1.4, 0.5, 0.3}, {1.6, 2, 0.25}, {-0.2, 2.6, 0.3}, {-1.4, 2.9, 0.1}}))
                     .add("leg0", limb({{-1.2, -0.6, 0.2}, {-2.6, -1.2, 0.14}, {-1.4, -2.4, 0.08}}))
                     .add("leg1", limb({{-0.6, -0.8, 0.2}, {-1.4, -1.6, 0.14}, {-2.6, -2.4, 0.08}}))
                     .add("leg2", limb({{1.2, -0.6, 0.2}, {2.6, -1.2, 0.14}, {1.4, -2.4, 0.08}}))
                     .add("leg3", limb({{0.6, -0.8, 0.2}, {1.4, -1.6, 0.14}, {2.6, -2.4, 0.08}})));
    keep("tail_over_leg",
         Drawing()
             .add("body", oval(0, 0, 2, 0.9))
             .add("front", limb({{1.3, -0.2, 0.4}, {1.3, -2.6, 0.22}}))
             .add("hind", limb({{-1.3, -0.2, 0.5}, {-1.6, -1.5, 0.28}, {-1.3, -2.8, 0.22}}))
             .add("tail", limb({{-1.7, 0.2, 0.22}, {-2.6, -0.6, 0.18}, {-1.8, -1.8, 0.14}, {-0.4, -1.6, 0.08}})));
    return all;
}

}  // namespace flg::test
