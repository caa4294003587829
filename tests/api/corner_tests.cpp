// SPDX-License-Identifier: MIT
// Corners of targets: where they are, mitres, whole motifs from corner to corner.
#include "api/live_inputs.h"
#include "api/style_inputs.h"

namespace flg::test {
namespace {

using Polygon = std::vector<std::array<double, 2>>;

Curves closed_polygon(const Polygon& polygon, uint32_t points_a_side = 1) {
    Curves curves;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i];
        const auto& b = polygon[(i + 1) % polygon.size()];
        for (uint32_t k = 0; k < points_a_side; ++k) {
            const double t = static_cast<double>(k) / points_a_side;
            curves.add_point(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0);
        }
    }
    curves.end_curve(FLG_CURVE_CLOSED);
    return curves;
}

Curves open_polygon(const Polygon& polygon) {
    Curves curves;
    for (const auto& p : polygon) curves.add_point(p[0], p[1], 0);
    curves.end_curve();
    return curves;
}

Polygon regular(size_t corners, double radius, double inner_radius) {
    Polygon polygon;
    for (size_t i = 0; i < corners; ++i) {
        const double r = i % 2 == 0 ? radius : inner_radius, angle = 2 * M_PI * static_cast<double>(i) / corners;
        polygon.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return polygon;
}

const Polygon square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};

// A zigzag about the x axis that ends as it begins.
Curves zigzag() {
    Curves curves;
    for (int i = 0; i <= 40; ++i) curves.add_point(0.05 * i, i % 4 == 1 ? 0.1 : i % 4 == 3 ? -0.1 : 0.0, 0);
    curves.end_curve();
    return curves;
}

struct Position3 {
    double x, y, z;
};
Position3 operator-(const Position3& a, const Position3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double norm(const Position3& p) {
    return std::hypot(p.x, p.y, p.z);
}

class Corners : public testing::Test {
protected:
    Corners() {
        learn(0, 0);
        desc.keep_displacement = 1;
    }
    void learn(float start_cap, float end_cap) {
        FlgStyleDesc style = flgStyleDefaults();
        style.style = host.create(zigzag());
        Curves axis;
        axis.add_point(0, 0, 0);
        axis.add_point(2, 0, 0);
        axis.end_curve();
        style.guide = host.create(axis);
        style.start_cap = start_cap;
        style.end_cap = end_cap;
        desc.style = prepare(host, style);
    }
    Heard along(const Curves& target) {
        desc.target = host.create(target);
        return heard_of(host.view_of(stylize(host, desc)));
    }
    static Position3 position(const Heard& heard, size_t i) {
        const auto& p = heard.of(FLG_ATTRIBUTE_POSITION);
        return {p[3 * i], p[3 * i + 1], p[3 * i + 2]};
    }
    Position3 target(const Heard& heard, size_t i) const {
        const auto& d = heard.of(FLG_ATTRIBUTE_DISPLACEMENT);
        const double m = desc.magnitude;
        return position(heard, i) - Position3{m * d[3 * i], m * d[3 * i + 1], m * d[3 * i + 2]};
    }
    // Sample by sample, on which side of the polygon it is; every corner has one.
    std::vector<size_t> sides(const Heard& heard, const Polygon& polygon, bool closed = true) const {
        std::vector<size_t> side;
        size_t now = 0;
        const size_t count = closed ? polygon.size() : polygon.size() - 1;
        for (size_t i = 0; i < heard.points(); ++i) {
            const auto& next = polygon[(now + 1) % polygon.size()];
            if (now + 1 < count && norm(target(heard, i) - Position3{next[0], next[1], 0}) < 1e-4) ++now;
            side.push_back(now);
        }
        EXPECT_EQ(now + 1, count);
        return side;
    }
    // Near its corners, as far as the sides have room for the style, each side stays between their planes.
    size_t expect_mitred(const Heard& heard, const Polygon& polygon, bool closed) const {
        const size_t count = polygon.size();
        const std::vector<size_t> side = sides(heard, polygon, closed);
        const auto plane = [&](size_t corner, const Position3& p) {
            const auto &a = polygon[(corner + count - 1) % count], &c = polygon[corner],
                       &b = polygon[(corner + 1) % count];
            const double in = std::hypot(c[0] - a[0], c[1] - a[1]), out = std::hypot(b[0] - c[0], b[1] - c[1]);
            const double nx = (c[0] - a[0]) / in + (b[0] - c[0]) / out, ny = (c[1] - a[1]) / in + (b[1] - c[1]) / out;
            return (nx * (p.x - c[0]) + ny * (p.y - c[1])) / std::hypot(nx, ny);
        };
        const double size = 1.5 * std::abs(desc.magnitude) * style_info(host, desc.style).displacement_rms;
        const auto half_side = [&](size_t corner) {
            const auto &a = polygon[corner % count], &b = polygon[(corner + 1) % count];
            return 0.5 * std::hypot(b[0] - a[0], b[1] - a[1]);
        };
        const auto is_near = [&](size_t corner, size_t i) {
            const double room = std::min(half_side(corner), half_side(corner + count - 1));
            const Position3 c{polygon[corner][0], polygon[corner][1], 0};
            return room >= size && norm(target(heard, i) - c) < std::min(size, 0.5 * room);
        };
        size_t near_points = 0;
        for (size_t i = 0; i < heard.points(); ++i) {
            const Position3 p = position(heard, i);
            const bool is_corner = i > 0 ? side[i] != side[i - 1] : closed;
            const size_t end = (side[i] + 1) % count;
            if ((closed || side[i] > 0) && is_near(side[i], i)) {
                ++near_points;
                EXPECT_GE(plane(side[i], p), -1e-5) << i;
                if (is_corner) {
                    EXPECT_NEAR(plane(side[i], p), 0, 1e-5) << i;
                }
            }
            if ((closed || side[i] + 2 < count) && is_near(end, i)) {
                EXPECT_LE(plane(end, p), 1e-5) << i;
            }
        }
        return near_points;
    }

    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
};

TEST_F(Corners, MitresStayOnTheirSideOfThePlanes) {
    desc.corners = FLG_STYLE_CORNERS_MITRE;
    const Polygon star = regular(10, 3, 1.2), triangle = regular(3, 2, 2), flat = {{0, 0}, {3, 0.2}, {0, 0.4}};
    for (const float magnitude : {0.5f, 1.0f, -3.0f, 20.0f}) {
        desc.magnitude = magnitude;
        for (const Polygon& polygon : {square, star, triangle, flat}) {
            SCOPED_TRACE(testing::Message() << polygon.size() << " corners, magnitude " << magnitude);
            const size_t near_points = expect_mitred(along(closed_polygon(polygon)), polygon, true);
            if (magnitude <= 1 && magnitude > 0) {
                EXPECT_GT(near_points, polygon.size());
            }
        }
    }
    desc.magnitude = 1;
    const Polygon letter = {{0, 0}, {0, 3}, {2, 0}, {2, 3}};
    EXPECT_GT(expect_mitred(along(open_polygon(letter)), letter, false), letter.size());
}

// As hands draw: tremor, corners that are sharp or round, short strokes between them, tips of stars.
class Sketch {
public:
    Curves lines;

    // From corner to corner in steps of 5 mm, each corner an arc of some radius, each point half a millimetre off.
    void draw(const Polygon& polygon, double radius, bool closed, uint32_t seed) {
        const size_t count = polygon.size();
        for (size_t k = 0; k < count; ++k) {
            const auto &a = polygon[k], &b = polygon[(k + 1) % count], &c = polygon[(k + 2) % count];
            if (!closed && k + 1 == count) break;
            const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
            const double first = k > 0 || closed ? radius : 0, last = length - radius;
            for (double s = first; s < last; s += 0.005) {
                add(a[0] + (b[0] - a[0]) * s / length, a[1] + (b[1] - a[1]) * s / length, seed);
            }
            if (!closed && k + 2 == count) {
                add(b[0], b[1], seed);
                continue;
            }
            const double out = std::hypot(c[0] - b[0], c[1] - b[1]);
            const int bend = std::max(1, static_cast<int>(2 * radius / 0.005));
            for (int j = 0; j <= bend; ++j) {
                const double t = static_cast<double>(j) / bend, in = radius * (1 - t) * (1 - t), on = radius * t * t;
                add(b[0] - in * (b[0] - a[0]) / length + on * (c[0] - b[0]) / out,
                    b[1] - in * (b[1] - a[1]) / length + on * (c[1] - b[1]) / out, seed);
            }
        }
        lines.end_curve(closed ? FLG_CURVE_CLOSED : 0);
    }

private:
    void add(double x, double y, uint32_t seed) {
        const auto off = [&] {
            state_ = state_ * 6364136223846793005u + 1442695040888963407u + seed;
            return 0.001 * (static_cast<double>(state_ >> 40) / (1 << 24) - 0.5);
        };
        const double dx = off(), dy = off(), dz = off();
        lines.add_point(x + dx, y + dy, dz);
    }
    uint64_t state_ = 1;
};

Curves hand_drawn() {
    Sketch sketch;
    for (const double radius : {0.0, 0.004, 0.02, 0.04}) {
        for (uint32_t seed = 0; seed < 4; ++seed) {
            sketch.draw({{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}, radius, true, seed);
            if (radius > 0.01) continue;
            sketch.draw(regular(10, 0.2, 0.06), radius, true, seed);
            sketch.draw({{0, 0}, {0.1, 0}, {0.11, 0.01}, {0.12, 0}, {0.2, 0.05}, {0.05, 0.06}, {0.3, 0.1}}, radius,
                        false, seed);
        }
    }
    // Coarse scribbles.
    sketch.lines.positions.reserve(4000);
    for (int c = 0; c < 10; ++c) {
        for (int i = 0; i < 60; ++i) {
            const double u = 0.37 * i + c;
            sketch.lines.add_point(0.01 * i + 0.02 * std::sin(7 * u), 0.02 * std::sin(2.1 * u), 0.01 * std::sin(5 * u));
        }
        sketch.lines.end_curve();
    }
    return sketch.lines;
}

TEST_F(Corners, SketchesStayNearTheirTargets) {
    FlgStyleDesc style = flgStyleDefaults();
    style.style = host.create(coil());
    desc.style = prepare(host, style);
    const double wanted = 0.008, rms = style_info(host, desc.style).displacement_rms;
    desc.scale = static_cast<float>(wanted / rms);
    const auto longest = [](const Heard& heard) {
        const auto& d = heard.of(FLG_ATTRIBUTE_DISPLACEMENT);
        double most = 0;
        for (size_t i = 0; i < heard.points(); ++i) {
            most = std::max<double>(most, std::hypot(d[3 * i], d[3 * i + 1], d[3 * i + 2]));
        }
        return most;
    };
    // The longest piece that goes on by less than a degree from step to step.
    const auto straightest = [](const Heard& heard) {
        double most = 0, run = 0;
        for (size_t i = 2; i < heard.points(); ++i) {
            const Position3 a = position(heard, i - 1) - position(heard, i - 2),
                            b = position(heard, i) - position(heard, i - 1);
            const double lengths = norm(a) * norm(b), along = a.x * b.x + a.y * b.y + a.z * b.z;
            run = lengths > 0 && std::abs(along) > 0.99985 * lengths ? run + norm(b) : 0;
            most = std::max(most, run);
        }
        return most;
    };
    for (const auto corners : {FLG_STYLE_CORNERS_MITRE, FLG_STYLE_CORNERS_MOTIFS}) {
        desc.corners = corners;
        const Heard heard = along(hand_drawn());
        EXPECT_LT(longest(heard), 2.5 * wanted) << corners;
        EXPECT_LT(straightest(heard), 2 * wanted) << corners;
    }
}

// Where a corner is seen wrong, as in a tremor, nothing far from it changes.
TEST_F(Corners, PlanesActNearTheirCornersOnly) {
    const Polygon polygon = {{0, 0}, {3, 0}, {3, 2}, {0, 2}};
    const double size = 1.5 * style_info(host, desc.style).displacement_rms;
    desc.corners = FLG_STYLE_CORNERS_MITRE;
    const Heard mitred = along(closed_polygon(polygon));
    const auto& d = mitred.of(FLG_ATTRIBUTE_DISPLACEMENT);
    const std::vector<size_t> side = sides(mitred, polygon);
    for (size_t i = 0; i < mitred.points(); ++i) {
        double nearest = HUGE_VAL;
        for (const auto& c : polygon) nearest = std::min(nearest, norm(target(mitred, i) - Position3{c[0], c[1], 0}));
        if (nearest < 2 * size) continue;
        // Along the target there is next to nothing of this style.
        const bool upright = side[i] % 2 == 1;
        EXPECT_LT(std::abs(upright ? d[3 * i + 1] : d[3 * i]), 0.02) << i;
    }
}

// The line doesn't run out along the plane and back.
TEST_F(Corners, TipsOfStarsHaveNoWhiskers) {
    FlgStyleDesc style = flgStyleDefaults();
    style.style = host.create(coil());
    desc.style = prepare(host, style);
    desc.scale = static_cast<float>(0.1 / style_info(host, desc.style).displacement_rms);
    Polygon pentagram;
    for (size_t k = 0; k < 5; ++k) {
        pentagram.push_back(
            {2 * std::cos(4 * M_PI * static_cast<double>(k) / 5), 2 * std::sin(4 * M_PI * static_cast<double>(k) / 5)});
    }
    desc.corners = FLG_STYLE_CORNERS_MITRE;
    for (const Polygon& star : {pentagram, regular(10, 3, 1.2)}) {
        const Heard heard = along(closed_polygon(star, 40));
        size_t reversals = 0;
        for (size_t i = 2; i < heard.points(); ++i) {
            const Position3 a = position(heard, i - 1) - position(heard, i - 2),
                            b = position(heard, i) - position(heard, i - 1);
            reversals += a.x * b.x + a.y * b.y + a.z * b.z < -0.9 * norm(a) * norm(b);
        }
        // The target itself turns nearly back at a tip.
        EXPECT_LE(reversals, star.size());
    }
}

// Both sides of a corner meet: no step is longer than elsewhere.
TEST_F(Corners, MitresLeaveNoGap) {
    const auto longest_step = [](const Heard& heard) {
        double longest = norm(position(heard, 0) - position(heard, heard.points() - 1));
        for (size_t i = 1; i < heard.points(); ++i) {
            longest = std::max(longest, norm(position(heard, i) - position(heard, i - 1)));
        }
        return longest;
    };
    Curves line;
    line.add_point(0, 0, 0);
    line.add_point(16, 0, 0);
    line.end_curve();
    const double elsewhere = longest_step(along(line));
    desc.corners = FLG_STYLE_CORNERS_MITRE;
    EXPECT_LT(longest_step(along(closed_polygon(square))), 1.5 * elsewhere);
}

TEST_F(Corners, ASquareOfMotifsHasFourEqualSides) {
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    for (const uint32_t points : {1u, 7u}) {
        const Heard heard = along(closed_polygon(square, points));
        ASSERT_EQ(heard.points() % 4, 0u);
        const size_t side = heard.points() / 4;
        for (size_t i = 0; i < heard.points(); ++i) {
            const Position3 p = position(heard, i), next = position(heard, (i + side) % heard.points());
            EXPECT_NEAR(next.x, 4 - p.y, 1e-5) << i;
            EXPECT_NEAR(next.y, p.x, 1e-5) << i;
            const auto& index = heard.of(FLG_ATTRIBUTE_STYLE_INDEX);
            EXPECT_EQ(index[i], index[(i + side) % heard.points()]) << i;
        }
        expect_mitred(heard, square, true);
    }
}

TEST_F(Corners, EverySideHasTheSamePhaseHoweverLong) {
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    const Polygon rectangle = {{0, 0}, {7.3, 0}, {7.3, 2.9}, {0, 2.9}};
    for (const float fit : {0.0f, 0.01f, 1.0f}) {
        desc.fit = fit;
        const Heard heard = along(closed_polygon(rectangle));
        const auto& index = heard.of(FLG_ATTRIBUTE_STYLE_INDEX);
        const std::vector<size_t> side = sides(heard, rectangle);
        for (size_t i = 0; i < heard.points(); ++i) {
            if (i == 0 || side[i] != side[i - 1]) {
                EXPECT_EQ(index[i], 0) << i;
            }
        }
    }
}

// As a hand draws it: each corner is an arc of some points.
TEST_F(Corners, OfASquareDrawnRoundAreFourToo) {
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    for (const uint32_t arc_points : {2u, 3u, 5u, 9u}) {
        const double spacing = 0.12 / arc_points, radius = spacing * (arc_points - 1) / (M_PI / 2);
        Curves drawn;
        std::vector<Position3> middles;
        for (int side = 0; side < 4; ++side) {
            const double a = side * M_PI / 2;
            // From the middle of a side, about the square's centre.
            const auto add = [&](double along, double out) {
                drawn.add_point(2 + along * -std::sin(a) + out * std::cos(a),
                                2 + along * std::cos(a) + out * std::sin(a), 0);
            };
            for (double along = -2 + radius + spacing / 2; along < 2 - radius; along += spacing) add(along, 2);
            for (uint32_t k = 0; k < arc_points; ++k) {
                const double turned = M_PI / 2 * k / (arc_points - 1);
                add(2 - radius + radius * std::sin(turned), 2 - radius + radius * std::cos(turned));
            }
            const double middle = 2 - radius + radius * std::sqrt(0.5);
            middles.push_back({2 + middle * (std::cos(a) - std::sin(a)), 2 + middle * (std::cos(a) + std::sin(a)), 0});
        }
        drawn.end_curve(FLG_CURVE_CLOSED);
        const Heard heard = along(drawn);
        const auto& index = heard.of(FLG_ATTRIBUTE_STYLE_INDEX);
        for (const Position3& middle : middles) {
            // A motif begins there.
            double nearest = HUGE_VAL;
            for (size_t i = 0; i < heard.points(); ++i) {
                if (index[i] == 0) nearest = std::min(nearest, norm(target(heard, i) - middle));
            }
            EXPECT_LT(nearest, 0.6 * spacing) << arc_points;
        }
    }
}

TEST_F(Corners, SidesTooShortForAMotifGetASmallOne) {
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    const Polygon step = {{0, 0}, {4, 0}, {4, 0.05}, {8, 0.05}};
    const Heard heard = along(open_polygon(step));
    const std::vector<size_t> side = sides(heard, step, false);
    const auto& d = heard.of(FLG_ATTRIBUTE_DISPLACEMENT);
    for (size_t i = 0; i < heard.points(); ++i) {
        if (side[i] == 1) {
            // As much smaller as the side is shorter than one wave of the zigzag.
            EXPECT_LT(std::hypot(d[3 * i], d[3 * i + 1], d[3 * i + 2]), 0.1 * 0.05 / 0.2 * 1.01) << i;
        }
    }
}

TEST_F(Corners, CapsComeAtCornersIfWanted) {
    learn(0.2f, 0.2f);
    const FlgStyleInfo info = style_info(host, desc.style);
    ASSERT_GT(info.end_cap_points, 3u);
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    desc.corner_caps = 1;
    const Heard capped = along(closed_polygon(square));
    const auto& index = capped.of(FLG_ATTRIBUTE_STYLE_INDEX);
    const size_t side = capped.points() / 4;
    for (size_t corner = 0; corner < 4; ++corner) {
        for (uint32_t i = 0; i < info.start_cap_points; ++i) EXPECT_EQ(index[corner * side + i], i);
        for (uint32_t i = 1; i < info.end_cap_points; ++i) {
            EXPECT_EQ(index[(corner + 1) * side - i], info.point_count - 1 - i);
        }
    }
    desc.corner_caps = 0;
    const Heard bare = along(closed_polygon(square));
    for (const float i : bare.of(FLG_ATTRIBUTE_STYLE_INDEX)) {
        EXPECT_GE(i, info.start_cap_points);
        EXPECT_LT(i, info.point_count - info.end_cap_points);
    }
}

// Smooth curves have none, however coarse; nor has anything at an angle that nothing turns by.
TEST_F(Corners, SmoothCurvesHaveNone) {
    for (const size_t points : {8u, 12u, 100u}) {
        const Curves circle = closed_polygon(regular(points, 2, 2));
        desc.corners = FLG_STYLE_CORNERS_THROUGH;
        const Heard plain = along(circle);
        for (const auto corners : {FLG_STYLE_CORNERS_MITRE, FLG_STYLE_CORNERS_MOTIFS}) {
            desc.corners = corners;
            EXPECT_TRUE(along(circle) == plain) << points;
        }
    }
    desc.corner_angle = 1.6f;
    desc.corners = FLG_STYLE_CORNERS_MITRE;
    const Heard mitred = along(closed_polygon(square));
    desc.corners = FLG_STYLE_CORNERS_THROUGH;
    EXPECT_TRUE(mitred == along(closed_polygon(square)));
}

// The first point is in the middle of a side: the result begins at the corner behind it.
TEST_F(Corners, ClosedResultsBeginAtACorner) {
    desc.corners = FLG_STYLE_CORNERS_MITRE;
    const Heard turned = along(closed_polygon({{2, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}}));
    EXPECT_TRUE(turned == along(closed_polygon({{0, 4}, {0, 0}, {4, 0}, {4, 4}, {2, 4}})));
    const Position3 first = target(turned, 0);
    EXPECT_NEAR(first.x, 0, 1e-5);
    EXPECT_NEAR(first.y, 4, 1e-5);
}

// As fast as the style says, along the result as it is.
TEST_F(Corners, MotionsAreTimedAlongWhatWasCut) {
    const double speed = 2;
    FlgStyleDesc style = flgStyleDefaults();
    Columns example{zigzag()};
    style.style = example.with(FLG_ATTRIBUTE_SPEED, 1, [=](uint32_t, uint32_t) { return speed; }).create(host);
    const FlgStyleAttribute attribute{FLG_ATTRIBUTE_SPEED, FLG_METRIC_AUTO, 0, 0};
    style.attributes = &attribute;
    style.attribute_count = 1;
    desc.style = prepare(host, style);
    desc.corners = FLG_STYLE_CORNERS_MITRE;
    const Heard heard = along(closed_polygon(square));
    const auto& time = heard.of(FLG_ATTRIBUTE_TIME);
    for (size_t i = 1; i < heard.points(); ++i) {
        EXPECT_NEAR(time[i] - time[i - 1], norm(position(heard, i) - position(heard, i - 1)) / speed, 1e-5) << i;
    }
}

TEST_F(Corners, OtherOptionsGoOnWorking) {
    const FlgStyleDrive thinner{FLG_ATTRIBUTE_RADIUS, FLG_STYLE_DRIVEN_SCALE, 0, 1, 1, 0.5f};
    Columns columns{closed_polygon(square, 5)};
    columns.with(FLG_ATTRIBUTE_RADIUS, 1, [](uint32_t i, uint32_t) { return 0.05 * i; });
    desc.target = columns.create(host);
    desc.drives = &thinner;
    desc.drive_count = 1;
    desc.strokes = 2;
    desc.pin_ends = 1;
    for (const auto corners : {FLG_STYLE_CORNERS_MITRE, FLG_STYLE_CORNERS_MOTIFS}) {
        desc.corners = corners;
        for (const auto frame : {FLG_FRAME_METHOD_ROTATION_MINIMIZING, FLG_FRAME_METHOD_FRENET}) {
            desc.frame = frame;
            const FlgCurveSetView view = host.view_of(stylize(host, desc));
            ASSERT_EQ(view.curve_count, 2u);
            const float* p = flgCurveSetViewGetColumn(&view, FLG_ATTRIBUTE_POSITION)->data;
            for (uint32_t i = 0; i < 3 * view.curve_offsets[2]; ++i) ASSERT_TRUE(std::abs(p[i]) < 6) << i;
        }
    }
}

TEST_F(Corners, SameBitsUnderAnyWorkersAndBudgets) {
    expect_same_bits([&](const Host& other) {
        FlgStyleDesc style = flgStyleDefaults();
        style.style = other.create(zigzag());
        FlgCurveSetStylizeDesc wanted = flgCurveSetStylizeDefaults();
        EXPECT_EQ(flgStyleCreate(other.context, &style, &wanted.style, nullptr), FLG_OK);
        Curves targets;
        for (int c = 0; c < 60; ++c) {
            for (int i = 0; i < 200; ++i) targets.add_point(0.3 * i, c + (i % 5 == 0 ? 0.5 : 0.0), 0.1 * (i % 3));
            targets.end_curve(c % 2 == 0 ? FLG_CURVE_CLOSED : 0);
        }
        wanted.target = other.create(targets);
        wanted.corners = FLG_STYLE_CORNERS_MITRE;
        FlgCurveSet out{};
        EXPECT_EQ(flgCurveSetStylize(other.context, &wanted, &out, nullptr), FLG_OK) << flgErrorGetMessage();
        return out;
    });
}

TEST_F(Corners, Refusals) {
    desc.target = host.create(closed_polygon(square));
    FlgCurveSet out{};
    const auto expect_refused = [&](const char* words) {
        expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT, words);
    };
    desc.corners = static_cast<FlgStyleCorners>(3);
    expect_refused("desc.corners");
    desc.corners = FLG_STYLE_CORNERS_MITRE;
    for (const float angle : {0.0f, 3.2f, NAN}) {
        desc.corner_angle = angle;
        expect_refused("desc.corner_angle");
    }
    desc.corner_angle = 1;
    desc.corner_caps = 1;
    expect_refused("desc.corner_caps");
    desc.corner_caps = 0;
    desc.exact_spacing = 1;
    expect_refused("exact steps do not come to corners");
}

}  // namespace
}  // namespace flg::test
