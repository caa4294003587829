// SPDX-License-Identifier: MIT
// Tubes and ribbons against the literal version and closed forms.
#include <Eigen/Geometry>

#include "brush/strokes.h"
#include "reference/literal_brush.h"

namespace flg::test {
namespace {

constexpr FlgBrushCap caps[] = {FLG_BRUSH_CAP_FLAT, FLG_BRUSH_CAP_ROUND, FLG_BRUSH_CAP_TAPERED};
constexpr FlgBrushJoin joins[] = {FLG_BRUSH_JOIN_MITER, FLG_BRUSH_JOIN_BEVEL, FLG_BRUSH_JOIN_ROUND,
                                  FLG_BRUSH_JOIN_NARROW};

// A regular polygon of `sides`, on a circle of radius 1.
double polygon_area(uint32_t sides) {
    return sides / 2.0 * std::sin(2 * pi / sides);
}

Stroke straight(double length = 3, double radius = 0.5) {
    Stroke stroke;
    for (const double t : {0.0, 0.25, 0.25, 0.7, 1.0})
        stroke.add(Vec3(1, 2, 3) + t * length * Vec3(2, 2, 1) / 3, radius);
    stroke.end();
    return stroke;
}

void expect_literal(const BrushMesh& mesh, const literal::BrushMesh& expected) {
    ASSERT_EQ(mesh.vertices.size(), expected.positions.size());
    for (uint32_t v = 0; v < mesh.vertices.size(); ++v)
        ASSERT_LT((mesh.position(v) - expected.positions[v]).norm(), 1e-6) << v;
    ASSERT_EQ(mesh.indices.size(), 3 * expected.triangles.size());
    for (size_t t = 0; t < expected.triangles.size(); ++t) {
        for (size_t k = 0; k < 3; ++k) ASSERT_EQ(mesh.indices[3 * t + k], expected.triangles[t][k]);
    }
}

struct Points {
    std::vector<Vec3> positions;
    std::vector<double> radii;
};
Points points_of(const Stroke& stroke) {
    Points points;
    for (size_t i = 0; i < stroke.size(); ++i) {
        points.positions.push_back(load_vec3(&stroke.positions[3 * i]));
        points.radii.push_back(double{stroke.radii[i]});
    }
    return points;
}

TEST(BrushShape, TubesAreTheLiteralOnes) {
    for (const uint32_t count : {2u, 3u, 20u, 300u}) {
        const Stroke stroke = bent_stroke(count);
        const Points points = points_of(stroke);
        for (const uint32_t sides : {3u, 8u, 64u}) {
            FlgBrushMeshDesc desc = desc_of(stroke);
            desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_NONE;
            desc.sides = sides;
            expect_literal(mesh_of(desc), literal::tube(points.positions, points.radii, sides));
        }
    }
}

TEST(BrushShape, RibbonsAreTheLiteralOnes) {
    for (const uint32_t count : {2u, 3u, 20u, 300u}) {
        const Stroke stroke = bent_stroke(count);
        const Points points = points_of(stroke);
        expect_literal(mesh_of(desc_of(stroke, FLG_BRUSH_SHAPE_RIBBON)),
                       literal::ribbon(points.positions, points.radii));
    }
}

TEST(BrushShape, StraightTubesHaveTheirVolume) {
    const Stroke stroke = straight();
    for (const uint32_t sides : {3u, 8u, 64u}) {
        FlgBrushMeshDesc desc = desc_of(stroke);
        desc.sides = sides;
        const double base = 0.25 * polygon_area(sides);
        EXPECT_NEAR(mesh_of(desc).volume(), 3 * base, 1e-5);
        desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_TAPERED;
        desc.cap_length = 4;
        EXPECT_NEAR(mesh_of(desc).volume(), 3 * base + 2 * base * 2 / 3, 1e-5);
    }
    FlgBrushMeshDesc round = desc_of(stroke);
    round.sides = 64;
    round.start_cap = round.end_cap = FLG_BRUSH_CAP_ROUND;
    const double exact = pi * 0.25 * 3 + 4.0 / 3 * pi * 0.125;
    EXPECT_LT(mesh_of(round).volume(), exact);
    EXPECT_GT(mesh_of(round).volume(), 0.995 * exact);
}

TEST(BrushShape, EveryCapAndJoinClosesATube) {
    const Stroke strokes[] = {straight(), bent_stroke(), [] {
                                  Stroke zigzag;
                                  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.3, 0.4, 0), Vec3(2, 1, 1),
                                                        Vec3(2, 0.9, 1), Vec3(3, 3, 3)})
                                      zigzag.add(p, 0.02);
                                  zigzag.end();
                                  return zigzag;
                              }()};
    for (const Stroke& stroke : strokes) {
        for (const FlgBrushCap cap : caps) {
            for (const FlgBrushJoin join : joins) {
                for (const uint32_t flags : {0u, 1u, 2u, 3u}) {
                    FlgBrushMeshDesc desc = desc_of(stroke);
                    desc.start_cap = desc.end_cap = cap;
                    desc.join = join;
                    desc.uv = flags & 1;
                    desc.hard_normals = flags & 2;
                    const BrushMesh mesh = mesh_of(desc);
                    EXPECT_TRUE(mesh.closed()) << cap << join << flags;
                    EXPECT_EQ(mesh.euler(), 2) << cap << join << flags;
                    EXPECT_GT(mesh.volume(), 0);
                }
            }
        }
    }
}

// A ring whose frame does not close by itself.
Stroke knot(uint32_t count, double radius) {
    Stroke stroke;
    for (uint32_t i = 0; i < count; ++i) {
        const double a = 2 * pi * i / count, r = 2 + std::cos(3 * a);
        stroke.add(Vec3(r * std::cos(2 * a), r * std::sin(2 * a), std::sin(3 * a)), radius);
    }
    stroke.end(true);
    return stroke;
}

TEST(BrushShape, ClosedCurvesAreTori) {
    Stroke circle;
    for (int i = 0; i < 200; ++i)
        circle.add(Vec3(2 * std::cos(2 * pi * i / 200), 0, 2 * std::sin(2 * pi * i / 200)), 0.5);
    circle.add(Vec3(2, 0, 0), 0.5);  // its first point once more
    circle.end(true);
    for (const uint32_t uv : {0u, 1u}) {
        FlgBrushMeshDesc desc = desc_of(circle);
        desc.uv = uv;
        desc.sides = 32;
        const BrushMesh torus = mesh_of(desc);
        EXPECT_TRUE(torus.closed());
        EXPECT_EQ(torus.euler(), 0);
        const double exact = 2 * pi * 2 * pi * 0.25;
        EXPECT_NEAR(torus.volume(), exact, 0.01 * exact);
    }
}

TEST(BrushShape, TheTwistOfClosedCurvesIsSpread) {
    const Stroke stroke = knot(400, 0.1);
    FlgBrushMeshDesc desc = desc_of(stroke);
    const BrushMesh mesh = mesh_of(desc);
    EXPECT_TRUE(mesh.closed());
    EXPECT_EQ(mesh.euler(), 0);
    // Over the seam a ring turns as little as elsewhere.
    double most = 0;
    for (uint32_t i = 0; i < 400; ++i) {
        const uint32_t next = (i + 1) % 400;
        most = std::max(most, (mesh.position(8 * next) - mesh.position(8 * i)).norm());
    }
    const double step = (mesh.position(0) - mesh.position(8 * 399)).norm();
    EXPECT_LE(step, most);
    EXPECT_LT(most, 0.15);
}

TEST(BrushShape, MiteredTubesKeepTheirRadius) {
    Stroke corner;
    for (const Vec3& p : {Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0)}) corner.add(p, 0.1);
    corner.end();
    FlgBrushMeshDesc desc = desc_of(corner);
    desc.sides = 64;
    const double base = 0.01 * polygon_area(64);
    // Two prisms that meet in the plane that halves the turn.
    EXPECT_NEAR(mesh_of(desc).volume(), 2 * base, 1e-7);
    desc.join = FLG_BRUSH_JOIN_NARROW;
    EXPECT_LT(mesh_of(desc).volume(), 1.9 * base);
}

TEST(BrushShape, CornersAreBevelledOrRound) {
    Stroke corner;
    for (const Vec3& p : {Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0)}) corner.add(p, 0.1);
    corner.end();
    FlgBrushMeshDesc desc = desc_of(corner, FLG_BRUSH_SHAPE_RIBBON);
    desc.sides = 16;
    desc.join = FLG_BRUSH_JOIN_BEVEL;
    EXPECT_EQ(mesh_of(desc).vertices.size(), 2u * 4);
    desc.join = FLG_BRUSH_JOIN_ROUND;
    // A quarter of 16 sides.
    const BrushMesh round = mesh_of(desc);
    EXPECT_EQ(round.vertices.size(), 2u * (2 + 5));
    for (uint32_t v = 2; v + 2 < round.vertices.size(); ++v) EXPECT_NEAR(round.position(v).norm(), 0.1, 1e-6);
    desc.corner_angle = 1.6f;
    EXPECT_EQ(mesh_of(desc).vertices.size(), 2u * 3);
}

TEST(BrushShape, NormalsPointOutwards) {
    for (const FlgBrushCap cap : caps) {
        const Stroke stroke = bent_stroke(300);
        FlgBrushMeshDesc desc = desc_of(stroke);
        desc.start_cap = desc.end_cap = cap;
        for (const uint32_t hard : {0u, 1u}) {
            desc.hard_normals = hard;
            const BrushMesh mesh = mesh_of(desc);
            for (size_t i = 0; i < mesh.indices.size(); i += 3) {
                const Vec3 face = (mesh.corner(i + 1) - mesh.corner(i)).cross(mesh.corner(i + 2) - mesh.corner(i));
                if (face.norm() < 1e-9) continue;
                for (size_t k = 0; k < 3; ++k)
                    ASSERT_GT(face.normalized().dot(mesh.normal(mesh.indices[i + k])), 0.3) << cap << hard << " " << i;
            }
        }
    }
}

TEST(BrushShape, HardSidesAreFlat) {
    const Stroke stroke = straight();
    FlgBrushMeshDesc desc = desc_of(stroke);
    desc.sides = 4;
    desc.hard_normals = 1;
    const BrushMesh mesh = mesh_of(desc);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 face = (mesh.corner(i + 1) - mesh.corner(i)).cross(mesh.corner(i + 2) - mesh.corner(i)).normalized();
        for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(face.dot(mesh.normal(mesh.indices[i + k])), 1, 1e-5);
    }
}

TEST(BrushShape, TurningTheCurveTurnsTheMesh) {
    // The first normal depends on the axes: it is given, for ribbons, and a turn of a quarter keeps it for tubes.
    const Eigen::Matrix3d quarter = Eigen::AngleAxisd(pi / 2, Vec3::UnitY()).toRotationMatrix();
    for (const FlgBrushJoin join : joins) {
        Stroke stroke = bent_stroke(), turned;
        for (uint32_t i = 0; i < stroke.size(); ++i)
            turned.add(quarter * load_vec3(&stroke.positions[3 * i]), double{stroke.radii[i]});
        turned.end();
        FlgBrushMeshDesc desc = desc_of(stroke), turned_desc = desc_of(turned);
        desc.join = turned_desc.join = join;
        desc.start_cap = turned_desc.start_cap = FLG_BRUSH_CAP_ROUND;
        const BrushMesh a = mesh_of(desc), b = mesh_of(turned_desc);
        ASSERT_EQ(a.indices, b.indices);
        // By the places of each ring, as the first normal may be another: the volume and the area stay.
        EXPECT_NEAR(a.volume(), b.volume(), 1e-6);
        EXPECT_NEAR(a.area(), b.area(), 2e-5 * a.area());
    }
    const Eigen::Matrix3d any = Eigen::AngleAxisd(1.234, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();
    Stroke stroke = bent_stroke(), turned;
    for (uint32_t i = 0; i < stroke.size(); ++i) {
        const Vec3 normal = Vec3(std::sin(0.1 * i), std::cos(0.1 * i), 0.3);
        const Vec3 turned_normal = any * normal;
        for (int k = 0; k < 3; ++k) stroke.normals.push_back(static_cast<float>(normal[k]));
        for (int k = 0; k < 3; ++k) turned.normals.push_back(static_cast<float>(turned_normal[k]));
        turned.add(any * load_vec3(&stroke.positions[3 * i]), double{stroke.radii[i]});
    }
    Stroke with_normals = stroke;
    with_normals.offsets = {0};
    with_normals.flags.clear();
    with_normals.end();
    turned.end();
    const BrushMesh a = mesh_of(desc_of(with_normals, FLG_BRUSH_SHAPE_RIBBON));
    const BrushMesh b = mesh_of(desc_of(turned, FLG_BRUSH_SHAPE_RIBBON));
    ASSERT_EQ(a.indices, b.indices);
    for (uint32_t v = 0; v < a.vertices.size(); ++v) {
        ASSERT_LT((any * a.position(v) - b.position(v)).norm(), 2e-6);
        ASSERT_LT((any * a.normal(v) - b.normal(v)).norm(), 1e-4);
    }
}

TEST(BrushShape, RibbonsFollowNormalsFromTheFirstThatSaysSomething) {
    Stroke stroke;
    for (int i = 0; i < 6; ++i) {
        stroke.add(Vec3(i, 0, 0), 0.1);
        // Nothing, along the curve, then a normal, then its opposite.
        const Vec3 normal = i == 0 ? Vec3(0, 0, 0) : i == 1 ? Vec3(1, 0, 0) : i == 2 ? Vec3(0, 3, 4) : Vec3(0, -3, -4);
        for (int k = 0; k < 3; ++k) stroke.normals.push_back(static_cast<float>(normal[k]));
    }
    stroke.end();
    const BrushMesh mesh = mesh_of(desc_of(stroke, FLG_BRUSH_SHAPE_RIBBON));
    for (uint32_t v = 0; v < mesh.vertices.size(); ++v)
        EXPECT_LT((mesh.normal(v) - Vec3(0, 0.6, 0.8)).norm(), 1e-6) << v;
}

TEST(BrushShape, RibbonsHaveRoundAndTaperedEnds) {
    const Stroke stroke = straight(3, 0.5);
    FlgBrushMeshDesc desc = desc_of(stroke, FLG_BRUSH_SHAPE_RIBBON);
    EXPECT_NEAR(mesh_of(desc).area(), 3, 1e-5);
    desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_TAPERED;
    EXPECT_NEAR(mesh_of(desc).area(), 3 + 2 * 0.5, 1e-5);
    desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_ROUND;
    desc.sides = 64;
    EXPECT_NEAR(mesh_of(desc).area(), 3 + pi * 0.25, 2e-3);
    const BrushMesh mesh = mesh_of(desc);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 face = (mesh.corner(i + 1) - mesh.corner(i)).cross(mesh.corner(i + 2) - mesh.corner(i));
        EXPECT_GT(face.dot(mesh.normal(mesh.indices[i])), 0);
    }
}

TEST(BrushShape, TextureCoordinates) {
    const Stroke stroke = straight(3, 0.5);
    FlgBrushMeshDesc desc = desc_of(stroke);
    desc.uv = 1;
    desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_NONE;
    BrushMesh mesh = mesh_of(desc);
    ASSERT_EQ(mesh.vertices.size(), 4u * 9);
    for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        const double along = (mesh.position(v) - Vec3(1, 2, 3)).dot(Vec3(2, 2, 1) / 3);
        EXPECT_NEAR(mesh.vertices[v].uv[0], along, 1e-5);
        EXPECT_NEAR(mesh.vertices[v].uv[1], (v % 9) / 8.0, 1e-6);
    }
    desc.uv_along = FLG_BRUSH_UV_UNIT;
    desc.uv_around = FLG_BRUSH_UV_METRES;
    mesh = mesh_of(desc);
    EXPECT_EQ(mesh.vertices.back().uv[0], 1);
    EXPECT_NEAR(mesh.vertices.back().uv[1], 2 * pi * 0.5, 1e-5);
    desc.shape = FLG_BRUSH_SHAPE_RIBBON;
    EXPECT_NEAR(mesh_of(desc).vertices.back().uv[1], 1, 1e-6);
}

TEST(BrushShape, TangentsRunWithTheTextureCoordinates) {
    const Stroke stroke = bent_stroke(200);
    for (const FlgBrushShape shape : {FLG_BRUSH_SHAPE_TUBE, FLG_BRUSH_SHAPE_RIBBON}) {
        for (const uint32_t left_handed : {0u, 1u}) {
            FlgBrushMeshDesc desc = desc_of(stroke, shape);
            desc.uv = 1;
            desc.left_handed = left_handed;
            desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_NONE;
            const BrushMesh mesh = mesh_of(desc);
            for (size_t i = 0; i < mesh.indices.size(); i += 3) {
                // The directions in which the coordinates grow on the triangle.
                const Vertex *a = &mesh.vertices[mesh.indices[i]], *b = &mesh.vertices[mesh.indices[i + 1]],
                             *c = &mesh.vertices[mesh.indices[i + 2]];
                const Vec3 e1 = mesh.corner(i + 1) - mesh.corner(i), e2 = mesh.corner(i + 2) - mesh.corner(i);
                const double u1 = b->uv[0] - a->uv[0], v1 = b->uv[1] - a->uv[1], u2 = c->uv[0] - a->uv[0],
                             v2 = c->uv[1] - a->uv[1];
                const double det = u1 * v2 - u2 * v1;
                ASSERT_NE(det, 0);
                const Vec3 du = (v2 * e1 - v1 * e2) / det, dv = (u1 * e2 - u2 * e1) / det;
                const Vec3 t = load_vec3(a->tangent), bitangent = a->tangent[3] * load_vec3(a->normal).cross(t);
                ASSERT_GT(t.dot(du.normalized()), 0.9);
                ASSERT_GT(bitangent.dot(dv.normalized()), 0.8);
            }
        }
    }
}

TEST(BrushShape, LeftHandedMeshesAreMirrored) {
    const Stroke stroke = bent_stroke();
    FlgBrushMeshDesc desc = desc_of(stroke);
    desc.start_cap = FLG_BRUSH_CAP_ROUND;
    desc.end_cap = FLG_BRUSH_CAP_TAPERED;
    const BrushMesh right = mesh_of(desc);
    desc.left_handed = 1;
    const BrushMesh left = mesh_of(desc);
    EXPECT_NEAR(left.volume(), right.volume(), 1e-7);  // mirrored, and turned inside out again
    EXPECT_TRUE(left.closed());
    for (uint32_t v = 0; v < right.vertices.size(); ++v) {
        EXPECT_EQ(left.vertices[v].position[2], -right.vertices[v].position[2]);
        EXPECT_EQ(left.vertices[v].normal[2], -right.vertices[v].normal[2]);
        EXPECT_EQ(left.vertices[v].position[0], right.vertices[v].position[0]);
    }
}

TEST(BrushShape, ToleranceTakesFewerSides) {
    const Stroke stroke = straight(3, 0.5);
    FlgBrushMeshDesc desc = desc_of(stroke);
    desc.sides = 64;
    desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_NONE;
    size_t before = mesh_of(desc).vertices.size();
    EXPECT_EQ(before, 4u * 64);
    for (const float tolerance : {0.001f, 0.01f, 0.1f}) {
        desc.tolerance = tolerance;
        const BrushMesh mesh = mesh_of(desc);
        EXPECT_LT(mesh.vertices.size(), before);
        before = mesh.vertices.size();
        const double sides = static_cast<double>(before) / 4;
        EXPECT_LE(0.5 * (1 - std::cos(pi / sides)), tolerance);
    }
    desc.tolerance = 100;
    EXPECT_EQ(mesh_of(desc).vertices.size(), 4u * 3);
}

TEST(BrushShape, DegenerateCurvesLeaveNothingOrAClosedMesh) {
    const auto stroke_of = [](std::initializer_list<Vec3> points, double radius, bool closed = false) {
        Stroke stroke;
        for (const Vec3& p : points) stroke.add(p, radius);
        stroke.end(closed);
        return stroke;
    };
    const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
    for (const bool closed : {false, true}) {
        EXPECT_EQ(mesh_of(desc_of(stroke_of({o}, 0.1, closed))).vertices.size(), 0u);
        EXPECT_EQ(mesh_of(desc_of(stroke_of({x, x, x}, 0.1, closed))).vertices.size(), 0u);
    }
    for (const FlgBrushJoin join : joins) {
        for (const FlgBrushCap cap : caps) {
            const auto check = [&](const Stroke& stroke, int euler) {
                FlgBrushMeshDesc desc = desc_of(stroke);
                desc.join = join;
                desc.start_cap = desc.end_cap = cap;
                const BrushMesh mesh = mesh_of(desc);
                EXPECT_TRUE(mesh.closed()) << join << cap;
                if (euler >= 0) {
                    EXPECT_EQ(mesh.euler(), euler) << join << cap;
                }
                desc.shape = FLG_BRUSH_SHAPE_RIBBON;
                mesh_of(desc);
            };
            check(stroke_of({o, o, x, x, x, y, y}, 0.1), 2);
            check(stroke_of({o, x, o}, 0.1), -1);  // a turn of 180 degrees
            check(stroke_of({o, x, y}, 0.1, true), 0);
            check(stroke_of({o, x}, 0.1, true), -1);
        }
    }
    const BrushMesh thin = mesh_of(desc_of(stroke_of({o, x, y}, 0)));
    EXPECT_EQ(thin.vertices.size(), 3u * 8);  // no caps
    EXPECT_EQ(thin.volume(), 0);
}

TEST(BrushShape, RepeatedPointsCountOnce) {
    Stroke once, often;
    for (int i = 0; i < 10; ++i) {
        once.add(bent(0.1 * i), 0.1);
        for (int k = 0; k < 1 + i % 3; ++k) often.add(bent(0.1 * i), k == 0 ? 0.1 : 7);
    }
    once.end();
    often.end();
    const BrushMesh a = mesh_of(desc_of(once)), b = mesh_of(desc_of(often));
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    EXPECT_EQ(std::memcmp(a.vertices.data(), b.vertices.data(), 15 * sizeof(float)), 0);
    EXPECT_EQ(a.indices, b.indices);
    for (uint32_t v = 0; v < a.vertices.size(); ++v) EXPECT_EQ(a.place(v), b.place(v));
}

TEST(BrushShape, SeveralCurvesAreTheirMeshesInARow) {
    Stroke all, alone[3];
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < 10 + c; ++i) {
            const Vec3 p = bent(0.1 * i) + Vec3(c, 0, 0);
            all.add(p, 0.1);
            alone[c].add(p, 0.1);
        }
        all.end(c == 1);
        alone[c].end(c == 1);
    }
    const BrushMesh whole = mesh_of(desc_of(all));
    size_t v = 0, i = 0;
    for (uint32_t c = 0; c < 3; ++c) {
        FlgBrushMeshDesc desc = desc_of(all);
        desc.first_curve = c;
        desc.curve_count = 1;
        desc.base_vertex = static_cast<uint32_t>(v);
        // Indices count from the base: checked against the whole's, not by mesh_of.
        FlgBrushMeshDesc plain = desc;
        plain.base_vertex = 0;
        const BrushMesh part = mesh_of(plain), own = mesh_of(desc_of(alone[c]));
        ASSERT_EQ(part.indices, own.indices);
        for (uint32_t k = 0; k < part.vertices.size(); ++k) {
            ASSERT_EQ(std::memcmp(&part.vertices[k], &own.vertices[k], 14 * sizeof(float)), 0);
            ASSERT_EQ(std::memcmp(&part.vertices[k], &whole.vertices[v + k], 14 * sizeof(float)), 0);
        }
        for (size_t k = 0; k < part.indices.size(); ++k) ASSERT_EQ(part.indices[k] + v, whole.indices[i + k]);
        v += part.vertices.size();
        i += part.indices.size();
    }
    EXPECT_EQ(v, whole.vertices.size());
    EXPECT_EQ(i, whole.indices.size());
}

}  // namespace
}  // namespace flg::test
