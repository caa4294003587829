// SPDX-License-Identifier: MIT
// Rotations as a surface in R^9: against singular values, sums over feature points and the generic second form.
#include "splines/manifolds/rotation_manifold.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <limits>
#include <vector>

#include "splines/manifold_checks.h"
#include "splines/motion/body_inertia.h"

namespace flg::test {
namespace {

using Mat3 = Eigen::Matrix3d;

class Random {
public:
    double normal() { return normal_(engine_); }
    Mat3 rotation() {
        return Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized().toRotationMatrix();
    }
    Mat3 matrix() {
        Mat3 m;
        for (int i = 0; i < 9; ++i) m.data()[i] = normal();
        return m;
    }
    std::vector<double> points(size_t count, const Vec3& stretch) {
        const Mat3 turn = rotation();
        const Vec3 shift(normal(), normal(), normal());
        std::vector<double> out;
        for (size_t i = 0; i < count; ++i) {
            const Vec3 p = turn * Vec3(normal(), normal(), normal()).cwiseProduct(stretch) + shift;
            out.insert(out.end(), p.data(), p.data() + 3);
        }
        return out;
    }

private:
    std::mt19937 engine_{3};
    std::normal_distribution<double> normal_;
};

// The rotation nearest to a map in the metric of columns' weights (Belta, Kumar 2002).
Mat3 by_singular_values(const Mat3& m) {
    const Eigen::JacobiSVD<Mat3> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 signs(1, 1, svd.matrixU().determinant() * svd.matrixV().determinant());
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

double gap(const Mat3& m) {
    const Vec3 s = Eigen::JacobiSVD<Mat3>(m).singularValues();
    return (s[1] + (m.determinant() < 0 ? -s[2] : s[2])) / s[0];
}

const std::array<std::array<double, 3>, 5> bodies{{{1, 1, 1}, {3, 2, 1}, {2, 1, 0}, {0, 0.5, 2}, {1, 1e-2, 1e-2}}};

TEST(RotationManifold, IsConsistent) {
    Random random;
    for (const auto& f : bodies) {
        const RotationManifold manifold(f);
        std::vector<double> x(9);
        manifold.point_of(random.rotation(), x.data());
        for (double& value : x) value += 0.1 * random.normal();
        // The generic form's steps are large against the bends of a needle.
        expect_consistent(manifold, x, f[1] < 0.1 ? 1e-3 : 3e-5);
    }
}

TEST(RotationManifold, ProjectsToTheNearestRotation) {
    Random random;
    int negative = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto& f = bodies[i % bodies.size()];
        const RotationManifold manifold(f);
        std::vector<double> x(9);
        Mat3 m = i % 3 == 0 ? random.matrix() : Mat3(random.rotation() + 0.3 * random.matrix());
        negative += m.determinant() < 0;
        Mat3 weighted;
        for (int j = 0; j < 3; ++j) {
            Eigen::Map<Vec3>(x.data() + 3 * j) = std::sqrt(2.0) * f[j] * m.col(j);
            weighted.col(j) = 2 * f[j] * f[j] * m.col(j);
        }
        ASSERT_TRUE(manifold.project(x.data(), nullptr));
        const double room = gap(weighted);
        if (room < 1e-9) continue;
        EXPECT_LT((manifold.rotation_of(x.data()) - by_singular_values(weighted)).norm(), 1e-13 / room + 1e-13)
            << i << " gap " << room;
    }
    EXPECT_GT(negative, 500);
}

TEST(RotationManifold, ReflectionsAndFlatMapsHaveANearestRotation) {
    for (const Vec3& diagonal : {Vec3(-1, -1, -1), Vec3(1, 1, -1), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(-1, -1, 0)}) {
        const Mat3 m = diagonal.asDiagonal();
        Mat3 found;
        ASSERT_TRUE(nearest_rotation(m, Mat3::Identity(), found));
        EXPECT_LT((found * found.transpose() - Mat3::Identity()).norm(), 1e-14);
        EXPECT_NEAR(found.determinant(), 1, 1e-14);
        EXPECT_NEAR((found.transpose() * m).trace(), (by_singular_values(m).transpose() * m).trace(), 1e-14);
    }
}

// Half turns about each axis are where Newton's method from the wrong side stands still.
TEST(RotationManifold, AStartAtTheLeastValueDoesNotKeepIt) {
    const Mat3 m = Vec3(3, 2, 1).asDiagonal();
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        Mat3 found;
        const Mat3 half_turn = Eigen::AngleAxisd(3.14159265358979, axis).toRotationMatrix();
        ASSERT_TRUE(nearest_rotation(m, half_turn, found));
        EXPECT_LT((found - Mat3::Identity()).norm(), 1e-14);
    }
}

TEST(RotationManifold, RefusesTheOriginAndWhatIsNotFinite) {
    const RotationManifold manifold({3, 2, 1});
    for (const double value :
         {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        std::vector<double> x(9, value);
        EXPECT_FALSE(manifold.project(x.data(), nullptr));
        if (!std::isnan(value)) {
            EXPECT_EQ(x, std::vector<double>(9, value));
        }
    }
}

TEST(RotationManifold, ProjectionCommutesWithTurnsOfTheSpace) {
    Random random;
    const RotationManifold manifold({3, 2, 1});
    for (int i = 0; i < 100; ++i) {
        const Mat3 turn = random.rotation(), map = random.rotation() + 0.2 * random.matrix();
        Eigen::Matrix<double, 3, 3> x = map * Vec3(3, 2, 1).asDiagonal(), turned = turn * x;
        ASSERT_TRUE(manifold.project(x.data(), nullptr));
        ASSERT_TRUE(manifold.project(turned.data(), nullptr));
        EXPECT_LT((turned - turn * x).norm(), 1e-12);
    }
}

TEST(BodyInertia, MetricIsTheSumOverFeaturePoints) {
    Random random;
    for (const Vec3& stretch : {Vec3(1, 1, 1), Vec3(3, 2, 1), Vec3(2, 1, 0)}) {
        const std::vector<double> points = random.points(20, stretch);
        std::vector<double> masses;
        for (int i = 0; i < 20; ++i) masses.push_back(0.5 + std::abs(random.normal()));
        const BodyInertia body = inertia_of_points(points, masses);
        const RotationManifold manifold(body.f);
        EXPECT_NEAR(body.axes.determinant(), 1, 1e-12);
        const Mat3 a = random.rotation(), b = random.rotation();
        const Vec3 p(random.normal(), random.normal(), 0), q(0, random.normal(), random.normal());
        double sum = 0;
        for (size_t i = 0; i < masses.size(); ++i) {
            const Vec3 at(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
            sum += masses[i] * (p + a * at - q - b * at).squaredNorm();
        }
        Eigen::Matrix<double, 9, 1> x, y;
        manifold.point_of(a * body.axes, x.data());
        manifold.point_of(b * body.axes, y.data());
        const Vec3 between = p + a * body.barycentre - q - b * body.barycentre;
        EXPECT_NEAR((x - y).squaredNorm() + body.mass * between.squaredNorm(), sum, 1e-12 * sum);
    }
}

TEST(BodyInertia, SixPointsOfTheEllipsoidGiveItBack) {
    Random random;
    const Mat3 turn = random.rotation();
    const Vec3 middle(4, -5, 6), half(3, 2, 1);
    std::vector<double> points;
    for (int i = 0; i < 3; ++i) {
        for (const double sign : {1.0, -1.0}) {
            const Vec3 p = middle + sign * half[i] * turn.col(i);
            points.insert(points.end(), p.data(), p.data() + 3);
        }
    }
    const BodyInertia body = inertia_of_points(points, {});
    EXPECT_EQ(body.mass, 6);
    EXPECT_NEAR(body.radius, 3, 1e-14);
    EXPECT_LT((body.barycentre - middle).norm(), 1e-14);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(body.f[i], half[i], 1e-13);
        EXPECT_NEAR(std::abs(body.axes.col(i).dot(turn.col(i))), 1, 1e-13);
    }
}

TEST(BodyInertia, ABoxIsTheMiddlesOfItsFacesAndASolid) {
    const BodyInertia box = inertia_of_box(Vec3(-1, -2, -3), Vec3(3, 4, 5));
    const std::vector<double> middles{-1, 1, 1, 3, 1, 1, 1, -2, 1, 1, 4, 1, 1, 1, -3, 1, 1, 5};
    const BodyInertia points = inertia_of_points(middles, {});
    EXPECT_LT((box.barycentre - points.barycentre).norm(), 1e-14);
    EXPECT_NEAR(box.radius, std::sqrt(4 + 9 + 16), 1e-14);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(box.f[i], points.f[2 - i], 1e-13);
    // A solid as a grid of cells: second moments about the middle, cells' own left out, so up to the square of a cell's
    // share.
    std::vector<double> cells, masses;
    constexpr int count = 40;
    for (int i = 0; i < count * count * count; ++i) {
        const double share[] = {(i % count + 0.5) / count, (i / count % count + 0.5) / count,
                                (i / count / count + 0.5) / count};
        cells.insert(cells.end(), {-1 + 4 * share[0], -2 + 6 * share[1], -3 + 8 * share[2]});
        masses.push_back(box.mass / (count * count * count));
    }
    const BodyInertia solid = inertia_of_points(cells, masses);
    EXPECT_NEAR(solid.mass, box.mass, 1e-9);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(box.f[i], solid.f[2 - i], 5e-4 * box.f[i]);
}

TEST(BodyInertia, ThinBodies) {
    const std::vector<double> line{0, 0, 0, 1, 1, 0, 4, 4, 0}, plane{0, 0, 5, 3, 0, 5, 0, 1, 5, 3, 1, 5};
    const BodyInertia rod = inertia_of_points(line, {}), plate = inertia_of_points(plane, {});
    EXPECT_GT(rod.f[0], 0);
    EXPECT_DOUBLE_EQ(rod.f[1], 1e-2 * rod.f[0]);
    EXPECT_EQ(rod.f[2], 0);
    EXPECT_GT(plate.f[1], 0.1 * plate.f[0]);
    EXPECT_EQ(plate.f[2], 0);
    const std::vector<double> twice{1, 2, 3, 1, 2, 3};
    const BodyInertia point = inertia_of_points(twice, {});
    EXPECT_EQ(point.f, (std::array<double, 3>{1, 1, 1}));
    EXPECT_EQ(point.barycentre, Vec3(1, 2, 3));
    const BodyInertia needle = inertia_of_box(Vec3(0, -2, 0), Vec3(0, 2, 0));
    EXPECT_EQ(needle.f[1], 2);
    EXPECT_EQ(std::max(needle.f[0], needle.f[2]), 2e-2);
    EXPECT_EQ(inertia_of_box(Vec3::Ones(), Vec3::Ones()).f, (std::array<double, 3>{1, 1, 1}));
}

}  // namespace
}  // namespace flg::test
