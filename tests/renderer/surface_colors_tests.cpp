// SPDX-License-Identifier: MIT
// Colours of surfaces: regions, columns, fields, isolines and borders.
#include <limits>

#include "meshes.h"

namespace flg::render::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float size_m = 1.6f;

class SurfaceColors : public RendererTest {
protected:
    void SetUp() override { without_ground(); }
    Image seen(Mesh& mesh, const SurfaceLook& look, const std::vector<float>& field = {}) {
        const SurfaceId id = renderer.upload(mesh.view(), look, field);
        const Image image = picture(target_);
        renderer.remove(id);
        return image;
    }
    // What a sheet of one colour looks like.
    Image plain(glm::vec3 color) {
        Mesh mesh = sheet(size_m, size_m, 1, 1);
        SurfaceLook look;
        look.material.color = color;
        return seen(mesh, look);
    }
    static int difference_at(const Image& a, const Image& b, float x, float y) {
        const glm::ivec2 p = pixel_of(x, y);
        return max_difference(a.at(p.x, p.y), b.at(p.x, p.y));
    }
    static int max_difference_of(const Image& a, const Image& b) {
        int most = 0;
        for (uint32_t y = 0; y < picture_size; ++y)
            for (uint32_t x = 0; x < picture_size; ++x) most = std::max(most, max_difference(a.at(x, y), b.at(x, y)));
        return most;
    }
    Target target_{renderer, picture_size, picture_size};
};

std::vector<float> field_of(const Mesh& mesh, float (*value)(glm::vec3)) {
    std::vector<float> field;
    for (const glm::vec3& p : mesh.positions) field.push_back(value(p));
    return field;
}

TEST_F(SurfaceColors, RegionsHaveTheirMaterials) {
    const glm::vec3 red(0.6f, 0.05f, 0.05f), blue(0.05f, 0.1f, 0.5f);
    Mesh mesh = sheet(size_m, size_m, 8, 8);
    for (size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const float x = mesh.positions[mesh.triangles[t]].x + mesh.positions[mesh.triangles[t + 1]].x;
        mesh.regions.push_back(x < 0 ? 0 : 1);
    }
    SurfaceLook look;
    look.regions = {{.color = red}, {.color = blue}};
    const Image image = seen(mesh, look), all_red = plain(red), all_blue = plain(blue);
    // The regions share vertices, but no pixel is between the two colours.
    for (uint32_t y = 0; y < picture_size; ++y)
        for (uint32_t x = 0; x < picture_size; ++x) {
            const Image& expected = x < picture_size / 2 ? all_red : all_blue;
            ASSERT_LE(max_difference(image.at(x, y), expected.at(x, y)), 1) << x << ", " << y;
        }
}

TEST_F(SurfaceColors, LabelsBeyondTheTableGoRoundInIt) {
    Mesh mesh = sheet(size_m, size_m, 6, 1);
    for (uint32_t t = 0; t < 12; ++t) mesh.regions.push_back(t);
    Mesh wrapped = mesh;
    for (uint32_t& label : wrapped.regions) label %= 3;
    SurfaceLook look;
    look.regions = {{.color = {0.5f, 0, 0}}, {.color = {0, 0.5f, 0}}, {.color = {0, 0, 0.5f}, .metallic = 1.0f}};
    EXPECT_EQ(differing_pixels(seen(mesh, look), seen(wrapped, look)), 0u);
    wrapped.regions.assign(12, 0);
    EXPECT_GT(differing_pixels(seen(mesh, look), seen(wrapped, look)), 10000u);
}

TEST_F(SurfaceColors, ColumnGivesTheColourUnlessRegionsDo) {
    const glm::vec3 green(0.1f, 0.4f, 0.1f);
    Mesh mesh = sheet(size_m, size_m, 2, 2);
    mesh.colors.assign(mesh.positions.size(), glm::vec4(green, 1));
    const Image expected = plain(green);
    EXPECT_LE(difference_at(seen(mesh, {}), expected, 0.1f, 0.3f), 1);
    SurfaceLook look;
    look.regions = {{.color = {0.5f, 0, 0}}};
    EXPECT_GT(differing_pixels(seen(mesh, look), expected), 10000u);
}

TEST_F(SurfaceColors, MaterialsLookDifferent) {
    Mesh mesh = sphere(0.8f, 40);
    SurfaceLook look;
    const Image matte = seen(mesh, look);
    look.material.roughness = 0.1f;
    const Image polished = seen(mesh, look);
    look.material.metallic = 1.0f;
    EXPECT_GT(differing_pixels(matte, polished), 5000u);
    EXPECT_GT(differing_pixels(polished, seen(mesh, look)), 5000u);
}

// The field is x: the colour at a point is the map's for it, as a surface of that colour would have it there.
TEST_F(SurfaceColors, FieldShowsTheMapsColours) {
    Mesh mesh = sheet(size_m, size_m, 4, 4);
    const std::vector<float> field = field_of(mesh, [](glm::vec3 p) { return 10.0f + p.x; });
    const Image found = seen(mesh, {}, field);
    SurfaceLook given;
    given.field_low = 10.0f;
    given.field_high = 10.4f;
    const Image ranged = seen(mesh, given, field);
    for (const float x : {-0.75f, -0.4f, 0.02f, 0.3f, 0.7f}) {
        EXPECT_LE(difference_at(found, plain(field_color(x / size_m + 0.5f)), x, 0.2f), 3) << x;
        EXPECT_LE(difference_at(ranged, plain(field_color(x / 0.4f)), x, 0.2f), 3) << x << ", range given";
    }
    SurfaceLook hidden;
    hidden.show_field = false;
    EXPECT_LE(max_difference_of(seen(mesh, hidden, field), plain(hidden.material.color)), 1) << "but for rounding";
}

TEST_F(SurfaceColors, InfiniteValuesAreGrey) {
    Mesh mesh = sheet(size_m, size_m, 4, 4);
    std::vector<float> field = field_of(mesh, [](glm::vec3 p) {
        return p.x > 0.1f ? infinity : p.x < -0.7f ? -infinity : p.x;
    });
    SurfaceLook look;
    look.isoline_spacing = 0.1f;
    const Image image = seen(mesh, look, field);
    for (const float x : {-0.75f, -0.45f, 0.1f, 0.5f}) {
        const glm::ivec2 p = pixel_of(x, 0.1f);
        const uint8_t* pixel = image.at(p.x, p.y);
        EXPECT_LT(std::abs(pixel[0] - pixel[2]), 25) << x;
    }
    field.assign(field.size(), infinity);
    EXPECT_NO_THROW(seen(mesh, look, field));
    field.assign(field.size(), 3.0f);
    const Image constant = seen(mesh, {}, field);
    EXPECT_LE(difference_at(constant, plain(field_color(0)), 0.2f, 0.2f), 1);
}

// The field is x, a line every 0.2 m: 7 lines within 1.6 m, but for the edges of the sheet.
TEST_F(SurfaceColors, IsolinesAreWhereTheFieldIsAMultiple) {
    Mesh mesh = sheet(size_m, size_m, 3, 3);
    SurfaceLook look;
    look.show_field = false;
    const std::vector<float> field = field_of(mesh, [](glm::vec3 p) { return p.x; });
    const Image without = seen(mesh, look, field);
    look.isoline_spacing = 0.2f;
    look.isoline_width_px = 2.0f;
    const Image with = seen(mesh, look, field);
    const int y = pixel_of(0, 0.13f).y;
    for (int line = -3; line <= 3; ++line) {
        const float x = 0.2f * static_cast<float>(line);
        const int at = pixel_of(x, 0).x;
        EXPECT_LT(brightness(with.at(at, y)) + 150, brightness(without.at(at, y))) << line;
        EXPECT_LE(difference_at(with, without, x + 0.1f, 0.13f), 0) << line;
    }
    // Two pixels' worth of ink a line, whatever the field's steepness across the picture.
    float ink = 0;
    const int from = pixel_of(-0.7f, 0).x, to = pixel_of(0.7f, 0).x;
    const glm::ivec2 on = pixel_of(0.1f, 0.13f);
    const auto bright = static_cast<float>(brightness(without.at(on.x, on.y)));
    int darkest = 1000;
    for (int x = from; x < to; ++x) darkest = std::min(darkest, brightness(with.at(x, y)));
    for (int x = from; x < to; ++x)
        ink += (bright - static_cast<float>(brightness(with.at(x, y)))) / (bright - static_cast<float>(darkest));
    EXPECT_NEAR(ink, 14.0f, 3.0f);
}

TEST_F(SurfaceColors, DenseIsolinesAreATint) {
    Mesh mesh = sheet(size_m, size_m, 1, 1);
    SurfaceLook look;
    look.show_field = false;
    look.isoline_spacing = 1e-3f;
    const Image image = seen(mesh, look, field_of(mesh, [](glm::vec3 p) { return p.x; }));
    const Image without = seen(mesh, {.show_field = false});
    int low = 1000, high = 0;
    for (int x = pixel_of(-0.5f, 0).x; x < pixel_of(0.5f, 0).x; ++x) {
        const int here = brightness(image.at(x, pixel_of(0, 0.1f).y));
        low = std::min(low, here);
        high = std::max(high, here);
    }
    EXPECT_LE(high - low, 12);
    const glm::ivec2 middle = pixel_of(0, 0.1f);
    EXPECT_LT(high + 30, brightness(without.at(middle.x, middle.y)));
}

TEST_F(SurfaceColors, BordersAreLinesOfTheirWidth) {
    Mesh mesh = sheet(size_m, size_m, 8, 8);
    for (uint32_t t = 0; t < mesh.triangles.size() / 3; ++t) mesh.regions.push_back(t / 2 % 8 < 3 ? 7 : 2);
    const Image without = seen(mesh, {});
    EXPECT_LE(max_difference_of(without, plain(SurfaceLook{}.material.color)), 1) << "but for rounding";
    for (const float width : {2.0f, 5.0f}) {
        SurfaceLook look;
        look.border_width_px = width;
        const Image with = seen(mesh, look);
        const float length_px = size_m * pixels_per_metre();
        EXPECT_NEAR(differing_pixels(with, without), width * length_px, 0.05f * width * length_px);
        const glm::ivec2 on = pixel_of(-0.2f, 0.33f);
        EXPECT_LT(brightness(with.at(on.x, on.y)), 150);
    }
    mesh.regions.assign(mesh.regions.size(), 5);
    SurfaceLook look;
    look.border_width_px = 2.0f;
    EXPECT_EQ(differing_pixels(seen(mesh, look), without), 0u) << "no borders in a single region";
}

// Between two regions the line is that of the higher label, and the look's where its material has none.
TEST_F(SurfaceColors, BordersAreThoseOfTheHigherLabel) {
    Mesh mesh = sheet(size_m, size_m, 9, 1);
    for (uint32_t t = 0; t < mesh.triangles.size() / 3; ++t) mesh.regions.push_back(2 - t / 6);
    SurfaceLook look;
    look.regions.resize(3);
    look.regions[1].border_width_px = 4.0f;
    look.regions[1].border_color = {1, 0, 0};
    const auto lines = [&](float look_width) {
        look.border_width_px = look_width;
        look.border_color = {0, 0, 1};
        return seen(mesh, look);
    };
    const float length_px = size_m * pixels_per_metre();
    const Image without = plain(SurfaceLook{}.material.color), one = lines(0.0f), both = lines(2.0f);
    EXPECT_NEAR(differing_pixels(one, without), 4.0f * length_px, 0.2f * length_px);
    EXPECT_NEAR(differing_pixels(both, without), 6.0f * length_px, 0.3f * length_px);
    const glm::ivec2 high = pixel_of(-size_m / 6, 0), low = pixel_of(size_m / 6, 0);
    EXPECT_GT(both.at(low.x, low.y)[0], both.at(low.x, low.y)[2] + 60) << "red, between 0 and 1";
    EXPECT_GT(both.at(high.x, high.y)[2], both.at(high.x, high.y)[0] + 60) << "blue, between 1 and 2";
}

// A roof, seen from above, whose sides are regions of one colour.
TEST_F(SurfaceColors, CreasesBetweenRegionsAreSharpAndGentleBendsAreNot) {
    const auto roof = [](float slope) {
        Mesh mesh = sheet(size_m, size_m, 2, 8);
        for (glm::vec3& p : mesh.positions) p.z = -slope * std::abs(p.x);
        for (size_t t = 0; t < mesh.triangles.size(); t += 3) {
            const float x = mesh.positions[mesh.triangles[t]].x + mesh.positions[mesh.triangles[t + 1]].x +
                            mesh.positions[mesh.triangles[t + 2]].x;
            mesh.regions.push_back(x < 0 ? 0 : 1);
        }
        return mesh;
    };
    const auto drawn = [&](float slope, bool smooth, bool regions) {
        Mesh mesh = roof(slope);
        SurfaceLook look;
        look.smooth = smooth;
        look.casts_shadow = false;
        if (regions) look.regions.resize(2);
        return seen(mesh, look);
    };
    constexpr float steep = 0.8f, gentle = 0.08f;
    EXPECT_GT(max_difference_of(drawn(steep, true, false), drawn(steep, false, false)), 20) << "one region is smooth";
    EXPECT_LE(max_difference_of(drawn(steep, true, true), drawn(steep, false, true)), 2) << "each side is flat";
    EXPECT_EQ(max_difference_of(drawn(gentle, true, true), drawn(gentle, true, false)), 0) << "the border isn't seen";
}

// On the side of a ball, seen at a grazing angle, the surface does not swallow half of the line.
TEST_F(SurfaceColors, BordersStayWholeOnSlopes) {
    Mesh mesh = sphere(0.9f, 48);
    for (size_t t = 0; t < mesh.triangles.size(); t += 3) {
        const float x = mesh.positions[mesh.triangles[t]].x + mesh.positions[mesh.triangles[t + 1]].x +
                        mesh.positions[mesh.triangles[t + 2]].x;
        mesh.regions.push_back(x < 2.1f ? 0 : 1);  // a circle near the right edge
    }
    SurfaceLook look;
    const Image without = seen(mesh, look);
    look.border_width_px = 3.0f;
    const Image with = seen(mesh, look);
    for (uint32_t y = 176; y <= 336; y += 10) {
        uint32_t dark = 0;
        for (uint32_t x = picture_size / 2; x < picture_size; ++x)
            dark += max_difference(with.at(x, y), without.at(x, y)) > 40;
        EXPECT_GE(dark, 3u) << y;
    }
}

// Equal steps in lightness, and nothing outside of what a screen can show.
TEST(FieldColor, LightnessRisesEvenly) {
    const auto lightness = [](glm::vec3 c) {
        const float l = std::cbrt(0.4122214708f * c.x + 0.5363325363f * c.y + 0.0514459929f * c.z);
        const float m = std::cbrt(0.2119034982f * c.x + 0.6806995451f * c.y + 0.1073969566f * c.z);
        const float s = std::cbrt(0.0883024619f * c.x + 0.2817188376f * c.y + 0.6299787005f * c.z);
        return 0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s;
    };
    const float first = lightness(field_color(0)), last = lightness(field_color(1));
    EXPECT_LT(first + 0.5f, last);
    for (int i = 0; i <= 32; ++i) {
        const float t = static_cast<float>(i) / 32;
        EXPECT_NEAR(lightness(field_color(t)), first + t * (last - first), 2e-3f) << t;
        for (int k = 0; k < 3; ++k) {
            EXPECT_GT(field_color(t)[k], 0.0f) << t;
            EXPECT_LT(field_color(t)[k], 1.0f) << t;
        }
    }
    EXPECT_EQ(field_color(-1), field_color(0));
    EXPECT_EQ(field_color(2), field_color(1));
}

}  // namespace
}  // namespace flg::render::test
