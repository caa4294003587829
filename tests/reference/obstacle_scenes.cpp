// SPDX-License-Identifier: MIT
#include "reference/obstacle_scenes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"

namespace flg::reference {

namespace {

constexpr uint32_t looks = 64;  // an interval

double from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double square = along.squaredNorm(), t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
    return (p - (a + t * along)).norm();
}

double from_box(const Solid& box, uint32_t dimension, const Vec3& p) {
    double outside = 0, deepest = -HUGE_VAL;
    for (uint32_t k = 0; k < dimension; ++k) {
        const double over = std::abs((p - box.centre).dot(box.axes[k])) - box.half[k];
        outside += std::max(over, 0.0) * std::max(over, 0.0);
        deepest = std::max(deepest, over);
    }
    return outside > 0 ? std::sqrt(outside) : deepest;
}

double from_polygon(const Solid& solid, const Vec3& p) {
    const size_t count = solid.polygon.size() / 2;
    const auto vertex = [&](size_t i) { return Vec3(solid.polygon[2 * i], solid.polygon[2 * i + 1], 0); };
    double nearest = HUGE_VAL;
    bool inside = false;
    for (size_t i = 0; i < count; ++i) {
        const Vec3 a = vertex(i), b = vertex((i + 1) % count);
        nearest = std::min(nearest, from_segment(p, a, b));
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside ? -nearest : nearest;
}

double from_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    const bool above = normal.dot((b - a).cross(p - a)) >= 0 && normal.dot((c - b).cross(p - b)) >= 0 &&
                       normal.dot((a - c).cross(p - c)) >= 0;
    if (above) return std::abs(normal.dot(p - a)) / normal.norm();
    return std::min({from_segment(p, a, b), from_segment(p, b, c), from_segment(p, c, a)});
}

double from_prism(const Solid& solid, const Vec3& p) {
    const Vec3 to = p - solid.centre, flat(to.dot(solid.axes[0]), to.dot(solid.axes[1]), 0);
    const double beside = from_polygon(solid, flat), over = std::abs(to.dot(solid.axes[2])) - solid.half[2];
    return beside > 0 && over > 0 ? std::hypot(beside, over) : std::max(beside, over);
}

// The side by the solid angles of all triangles (van Oosterom, Strackee 1983).
double from_mesh(const Solid& solid, const Vec3& p) {
    double nearest = HUGE_VAL, angle = 0;
    const auto vertex = [&](uint32_t v) { return load_vec3(&solid.positions[size_t{3} * v]); };
    for (size_t t = 0; t < solid.triangles.size(); t += 3) {
        const Vec3 a = vertex(solid.triangles[t]), b = vertex(solid.triangles[t + 1]),
                   c = vertex(solid.triangles[t + 2]);
        nearest = std::min(nearest, from_triangle(p, a, b, c));
        const Vec3 x = a - p, y = b - p, z = c - p;
        const double xl = x.norm(), yl = y.norm(), zl = z.norm();
        angle += 2 * std::atan2(x.dot(y.cross(z)), xl * yl * zl + x.dot(y) * zl + y.dot(z) * xl + z.dot(x) * yl);
    }
    return std::abs(angle) > 2 * std::numbers::pi ? -nearest : nearest;
}

// Draws of one scene.
struct Draws {
    uint64_t seed;
    uint64_t next = 0;
    double operator()(double from, double to) { return from + (to - from) * random_unit(seed, 0, next++); }
    uint32_t below(uint32_t count) { return random_below(seed, 1, next++, count); }
    // Coordinates from -half to half, one after the other.
    Vec3 place(uint32_t dimension, double half) {
        Vec3 v(0, 0, 0);
        for (uint32_t c = 0; c < dimension; ++c) v[c] = (*this)(-half, half);
        return v;
    }
    Vec3 direction(uint32_t dimension) {
        for (;;) {
            const Vec3 v = place(dimension, 1);
            if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
        }
    }
};

void add_star_polygon(Draws& draw, Solid& solid, const Vec3& centre) {
    const uint32_t count = 3 + draw.below(8);
    for (uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + draw(0, 0.6)) / count, radius = draw(0.15, 0.7);
        solid.polygon.insert(solid.polygon.end(),
                             {centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle)});
    }
}

// A ball with waves, seen from its middle everywhere.
void add_star_mesh(Draws& draw, Solid& solid, const Vec3& centre) {
    constexpr uint32_t around = 16, rings = 8;
    const double radius = draw(0.5, 1.2), waves = draw(0, 0.35), turn = draw(0, 6), stretch = draw(0.5, 1.5);
    const auto add = [&](double up, double angle) {
        const double r = radius * (1 + waves * std::sin(3 * angle + turn) * std::cos(up) * std::cos(up));
        const Vec3 at =
            centre + r * Vec3(std::cos(up) * std::cos(angle), std::cos(up) * std::sin(angle), stretch * std::sin(up));
        for (uint32_t c = 0; c < 3; ++c) solid.positions.push_back(static_cast<float>(at[c]));
    };
    add(-0.5 * std::numbers::pi, 0);
    for (uint32_t i = 1; i < rings; ++i) {
        for (uint32_t j = 0; j < around; ++j)
            add(std::numbers::pi * (static_cast<double>(i) / rings - 0.5), 2 * std::numbers::pi * j / around);
    }
    add(0.5 * std::numbers::pi, 0);
    const auto at = [](uint32_t i, uint32_t j) {
        return i == 0 ? 0 : i == rings ? 1 + (rings - 1) * around : 1 + (i - 1) * around + j % around;
    };
    for (uint32_t i = 0; i < rings; ++i) {
        for (uint32_t j = 0; j < around; ++j) {
            const uint32_t a = at(i, j), b = at(i, j + 1), c = at(i + 1, j + 1), d = at(i + 1, j);
            if (a != b) solid.triangles.insert(solid.triangles.end(), {a, b, c});
            if (c != d) solid.triangles.insert(solid.triangles.end(), {a, c, d});
        }
    }
}

// A box, often a thin plate.
void add_box_mesh(Draws& draw, Solid& solid) {
    const double sides[3] = {draw(0.05, 1.2), draw(0.2, 1.2), draw(0.2, 1.2)};
    for (uint32_t corner = 0; corner < 8; ++corner) {
        Vec3 at = solid.centre;
        for (uint32_t k = 0; k < 3; ++k) at += ((corner >> k & 1) != 0 ? sides[k] : -sides[k]) * solid.axes[k];
        for (uint32_t c = 0; c < 3; ++c) solid.positions.push_back(static_cast<float>(at[c]));
    }
    solid.triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                       2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
}

bool is_flat(SceneKind kind) {
    return kind == SceneKind::plane || kind == SceneKind::walled_plane;
}
bool is_round(SceneKind kind) {
    return kind == SceneKind::sphere || kind == SceneKind::walled_sphere;
}
bool is_walled(SceneKind kind) {
    return kind >= SceneKind::walled_plane;
}

Solid random_solid(Draws& draw, SceneKind kind, const Vec3& centre) {
    const uint32_t dimension = is_flat(kind) ? 2 : 3;
    Solid solid;
    solid.centre = centre;
    const double grow = kind == SceneKind::space || kind == SceneKind::walled_space ? 1.6 : 1;
    solid.radius = grow * draw(0.15, 0.6);
    using Kind = Solid::Kind;
    const Kind last = is_flat(kind) || is_walled(kind) ? Kind::polygon : Kind::capsule;
    solid.kind =
        kind == SceneKind::meshes ? Kind::mesh : static_cast<Kind>(draw.below(static_cast<uint32_t>(last) + 1));
    const double length = draw(0.1, 1);
    solid.to = centre + length * draw.direction(dimension);
    if (solid.kind == Kind::capsule) solid.radius *= 0.5;
    for (double& half : solid.half) half = grow * draw(0.1, 0.6);
    const Vec3 first = draw.direction(dimension);
    const Vec3 second = dimension == 2 ? Vec3(-first.y(), first.x(), 0) : first.cross(draw.direction(3)).normalized();
    solid.axes[0] = first;
    solid.axes[1] = second;
    solid.axes[2] = first.cross(second);
    if (solid.kind == Kind::polygon) add_star_polygon(draw, solid, dimension == 2 ? centre : Vec3::Zero());
    if (solid.kind == Kind::mesh) draw.below(2) == 0 ? add_star_mesh(draw, solid, centre) : add_box_mesh(draw, solid);
    return solid;
}

// Second derivatives at the nodes of the cubic spline through them.
Eigen::MatrixXd moments(std::span<const double> nodes, std::span<const double> parameters, uint32_t dimension,
                        bool closed) {
    const auto count = static_cast<Eigen::Index>(nodes.size() / dimension);
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(count, count), right = Eigen::MatrixXd::Zero(count, dimension);
    const auto step = [&](Eigen::Index i) { return parameters[size_t(i) + 1] - parameters[size_t(i)]; };
    const auto value = [&](Eigen::Index i, uint32_t c) { return nodes[size_t(i) * dimension + c]; };
    for (Eigen::Index i = closed ? 0 : 1; i < (closed ? count : count - 1); ++i) {
        const Eigen::Index before = (i + count - 1) % count, after = (i + 1) % count;
        const double h = step(before), k = step(i);
        system(i, i) = (h + k) / 3;
        system(i, before) += h / 6;
        system(i, after) += k / 6;
        for (uint32_t c = 0; c < dimension; ++c)
            right(i, c) = (value(after, c) - value(i, c)) / k - (value(i, c) - value(before, c)) / h;
    }
    return system.partialPivLu().solve(right);
}

}  // namespace

double exact_distance(const Solid& solid, uint32_t dimension, const Vec3& place) {
    switch (solid.kind) {
        case Solid::Kind::ball: return (place - solid.centre).norm() - solid.radius;
        case Solid::Kind::box: return from_box(solid, dimension, place);
        case Solid::Kind::capsule: return from_segment(place, solid.centre, solid.to) - solid.radius;
        case Solid::Kind::polygon: return dimension == 2 ? from_polygon(solid, place) : from_prism(solid, place);
        case Solid::Kind::half_space: return (place - solid.centre).dot(solid.to);
        default: return from_mesh(solid, place);
    }
}

ObstacleScene obstacle_scene(uint64_t seed, SceneKind kind) {
    Draws draw{.seed = mix64(seed) + static_cast<uint64_t>(kind)};
    ObstacleScene scene;
    scene.dimension = is_flat(kind) ? 2 : 3;
    scene.clearance = draw(0.01, 0.05);
    if (draw.below(2) == 0) scene.clearance = 0;
    const auto place = [&] {
        if (is_round(kind)) return Vec3(sphere_radius * draw.direction(3));
        return draw.place(scene.dimension, 0.5 * scene.size);
    };
    const uint32_t count = kind == SceneKind::meshes ? 2 + draw.below(4) : 3 + draw.below(12);
    for (uint32_t i = 0; i < count; ++i) scene.solids.push_back(random_solid(draw, kind, 0.8 * place()));
    if (is_round(kind)) {
        for (Solid& solid : scene.solids) {
            const Vec3 shift = solid.centre * (sphere_radius / solid.centre.norm() - 1);
            solid.centre += shift;
            solid.to += shift;
        }
    }
    for (uint32_t i = 0; i < 2 && is_walled(kind); ++i) {
        Solid& wall = scene.solids.emplace_back();
        wall.kind = Solid::Kind::half_space;
        wall.to = draw.direction(scene.dimension);
        wall.centre = -draw(0.2, 0.4) * scene.size * wall.to;
    }
    const uint32_t points = 2 + draw.below(4);
    while (scene.points.size() < size_t{points} * scene.dimension) {
        const Vec3 at = place();
        double nearest = HUGE_VAL;
        for (const Solid& solid : scene.solids) nearest = std::min(nearest, exact_distance(solid, scene.dimension, at));
        if (nearest < scene.clearance + 0.01 * scene.size) continue;
        for (uint32_t c = 0; c < scene.dimension; ++c) scene.points.push_back(at[c]);
    }
    return scene;
}

ObstacleScene obstacle_maze(uint64_t seed) {
    Draws draw{.seed = mix64(seed) + 100};
    ObstacleScene scene;
    scene.dimension = 2;
    scene.clearance = 0.01;
    // Columns of two, in turn to both sides of the middle and on it.
    for (uint32_t i = 0; i < 14; ++i) {
        const uint32_t column = i / 2;
        const double beside = column % 2 == 0   ? (i % 2 == 0 ? -0.42 : 0.42)
                              : i % 2 == 0      ? 0
                              : column % 4 == 1 ? -0.85
                                                : 0.85;
        Solid& solid = scene.solids.emplace_back();
        solid.kind = draw.below(2) == 0 ? Solid::Kind::box : Solid::Kind::ball;
        solid.axes[0] = draw.direction(2);
        solid.axes[1] = Vec3(-solid.axes[0].y(), solid.axes[0].x(), 0);
        solid.radius = draw(0.2, 0.31);
        solid.half[0] = solid.half[1] = 0.7 * solid.radius;
        solid.centre = {0.62 * column - 1.86, beside, 0};
    }
    scene.points = {-2.4, draw(-0.1, 0.1), 2.4, draw(-0.1, 0.1)};
    return scene;
}

Approach closest_approach(const ObstacleScene& scene, std::span<const double> nodes, std::span<const double> parameters,
                          bool closed) {
    const uint32_t d = scene.dimension;
    const auto count = static_cast<uint32_t>(nodes.size() / d);
    const Eigen::MatrixXd second = moments(nodes, parameters, d, closed);
    const auto node = [&](uint32_t i) {
        Vec3 out;
        for (uint32_t c = 0; c < d; ++c) out[c] = nodes[size_t{i} * d + c];
        return out;
    };
    const auto moment = [&](uint32_t i) {
        Vec3 out;
        for (uint32_t c = 0; c < d; ++c) out[c] = second(i, c);
        return out;
    };
    Approach least{HUGE_VAL, 0, 0};
    // A solid at least as far as its middle and its size say is not looked at.
    std::vector<std::pair<Vec3, double>> bounds;
    for (const Solid& solid : scene.solids) {
        Vec3 centre = solid.kind == Solid::Kind::capsule ? Vec3(0.5 * (solid.centre + solid.to)) : solid.centre;
        double reach = solid.radius;
        if (solid.kind == Solid::Kind::capsule) reach += 0.5 * (solid.to - solid.centre).norm();
        if (solid.kind == Solid::Kind::box) reach = Vec3(solid.half[0], solid.half[1], solid.half[2]).norm();
        for (size_t i = 0; i + 1 < solid.polygon.size(); i += 2)
            reach = std::max(
                reach, (Vec3(solid.polygon[i], solid.polygon[i + 1], 0) - (d == 2 ? centre : Vec3(0, 0, 0))).norm());
        if (d == 3 && !solid.polygon.empty()) reach = std::hypot(reach, solid.half[2]);
        if (solid.kind == Solid::Kind::half_space) reach = HUGE_VAL;
        for (size_t i = 0; i + 2 < solid.positions.size(); i += 3)
            reach = std::max(reach, (load_vec3(&solid.positions[i]) - centre).norm());
        bounds.emplace_back(centre, reach);
    }
    const auto look = [&](const Vec3& at, uint32_t i) {
        for (uint32_t s = 0; s < scene.solids.size(); ++s) {
            if ((at - bounds[s].first).norm() - bounds[s].second - scene.clearance >= least.clearance) continue;
            const double away = exact_distance(scene.solids[s], d, at) - scene.clearance;
            if (away < least.clearance) least = {away, i, s};
        }
    };
    for (uint32_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const uint32_t after = (i + 1) % count;
        const double h = parameters[i + 1] - parameters[i];
        const Vec3 a = node(i), b = node(after), m = moment(i), n = moment(after);
        for (uint32_t l = 0; l <= looks; ++l) {
            const double t = static_cast<double>(l) / looks, s = 1 - t;
            const Vec3 chord = s * a + t * b;
            look(chord, i);
            look(chord + h * h / 6 * ((s * s * s - s) * m + (t * t * t - t) * n), i);
        }
    }
    return least;
}

}  // namespace flg::reference
