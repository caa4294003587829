// SPDX-License-Identifier: MIT
// filigree skeleton: the looks of its models. A picture as texture, levels of detail, sharp corners, vertex counts.
#include <cmath>
#include <cstring>
#include <memory>

#include "cli_test.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace flg::test {
namespace {

using Json = nlohmann::json;

// 60 by 60 pixels: a square from 10 to 50, its left half red, its right half blue, within a grey rim, on white.
constexpr uint8_t drawn[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x00,
    0x3c, 0x00, 0x00, 0x00, 0x3c, 0x08, 0x02, 0x00, 0x00, 0x00, 0xb5, 0x9e, 0x4e, 0x25, 0x00, 0x00, 0x00, 0x5b, 0x49,
    0x44, 0x41, 0x54, 0x78, 0xda, 0xed, 0xd9, 0x41, 0x0d, 0x00, 0x20, 0x0c, 0x04, 0xc1, 0x2a, 0xe9, 0x1b, 0x99, 0xc8,
    0xc3, 0x15, 0x78, 0x28, 0x09, 0x84, 0x30, 0x97, 0x15, 0x30, 0xff, 0x8b, 0xf9, 0xe0, 0x02, 0x1a, 0x1a, 0x1a, 0x1a,
    0x1a, 0xfa, 0x30, 0xba, 0x5f, 0xda, 0x2e, 0x7a, 0x64, 0xab, 0xd5, 0x72, 0xd4, 0x82, 0x86, 0x86, 0x86, 0x86, 0x86,
    0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86, 0x86,
    0x86, 0xfe, 0xe7, 0x92, 0xf3, 0xd8, 0x42, 0x43, 0x43, 0x43, 0x43, 0x7f, 0x82, 0x5e, 0x2a, 0xc3, 0x37, 0x4b, 0x15,
    0x0f, 0x37, 0xe8, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

constexpr const char* square = "1 1\n5 1\n5 5\n1 5\n";

struct Model {
    explicit Model(const std::string& glb) {
        uint32_t size = 0;
        std::memcpy(&size, glb.data() + 12, sizeof size);
        json = Json::parse(glb.substr(20, size));
        binary = glb.substr(28 + size);
    }
    template <class T>
    std::vector<T> values(const Json& accessor_index, size_t components) const {
        const Json& accessor = json.at("accessors").at(accessor_index.get<size_t>());
        const Json& view = json.at("bufferViews").at(accessor.at("bufferView").get<size_t>());
        std::vector<T> out(accessor.at("count").get<size_t>() * components);
        const size_t begin = view.at("byteOffset").get<size_t>() + accessor.value("byteOffset", size_t{0});
        std::memcpy(out.data(), binary.data() + begin, out.size() * sizeof(T));
        return out;
    }
    std::vector<float> attribute(size_t mesh, const char* name, size_t components) const {
        return values<float>(json.at("meshes").at(mesh).at("primitives").at(0).at("attributes").at(name), components);
    }

    Json json;
    std::string binary;
};

class SkeletonLooks : public Cli {
protected:
    void SetUp() override {
        folder.write("square.poly.txt", square);
        folder.write("drawn.png", std::string(reinterpret_cast<const char*>(drawn), sizeof drawn));
    }
    Model model(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"skeleton", "-o", "a.glb", "--report", "report.json", "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        done(arguments);
        return Model(folder.read("a.glb"));
    }
};

TEST_F(SkeletonLooks, APictureIsProjectedAndBled) {
    const Model made =
        model({"square.poly.txt", "--vertices", "1000", "--texture", "drawn.png", "--texture-box", "0,0,6,6"});
    const std::vector<float> at = made.attribute(0, "POSITION", 3), uv = made.attribute(0, "TEXCOORD_0", 2);
    ASSERT_EQ(at.size() / 3, uv.size() / 2);
    for (size_t v = 0; v < uv.size() / 2; ++v) {
        EXPECT_NEAR(uv[2 * v], at[3 * v] / 6, 1e-6);
        EXPECT_NEAR(uv[2 * v + 1], 1 - at[3 * v + 1] / 6, 1e-6);
    }
    const Json& image = made.json.at("images").at(0);
    EXPECT_EQ(image.at("mimeType"), "image/png");
    const Json& view = made.json.at("bufferViews").at(image.at("bufferView").get<size_t>());
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(
            reinterpret_cast<const stbi_uc*>(made.binary.data()) + view.at("byteOffset").get<size_t>(),
            view.at("byteLength").get<int>(), &width, &height, &channels, 3),
        stbi_image_free);
    ASSERT_TRUE(pixels);
    ASSERT_EQ(width, 60);
    ASSERT_EQ(height, 60);
    // Neither the white around nor the grey rim is left.
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) {
            const stbi_uc* pixel = pixels.get() + 3 * (60 * y + x);
            EXPECT_EQ(pixel[0], x < 30 ? 200 : 40) << x << " " << y;
            EXPECT_EQ(pixel[1], 30) << x << " " << y;
        }
}

TEST_F(SkeletonLooks, ByDefaultThePictureFillsTheOutlinesBoxOrThePage) {
    const Model boxed = model({"square.poly.txt", "--vertices", "1000", "--texture", "drawn.png"});
    const std::vector<float> at = boxed.attribute(0, "POSITION", 3), uv = boxed.attribute(0, "TEXCOORD_0", 2);
    for (size_t v = 0; v < uv.size() / 2; ++v) EXPECT_NEAR(uv[2 * v], (at[3 * v] - 1) / 4, 1e-6);
    folder.write("square.svg",
                 "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-1 -2 10 20'><rect x='1' y='1' width='4' "
                 "height='4'/></svg>");
    const Model page = model({"square.svg", "--vertices", "1000", "--texture", "drawn.png"});
    const std::vector<float> on_page = page.attribute(0, "POSITION", 3), in_page = page.attribute(0, "TEXCOORD_0", 2);
    for (size_t v = 0; v < in_page.size() / 2; ++v) {
        EXPECT_NEAR(in_page[2 * v], (on_page[3 * v] + 1) / 10, 1e-6);
        EXPECT_NEAR(in_page[2 * v + 1], (2 - on_page[3 * v + 1]) / 20, 1e-6);
    }
}

TEST_F(SkeletonLooks, LevelsHaveTheCountsAskedFor) {
    const Model made = model({"square.poly.txt", "--vertices", "3000", "--lod", "1000,200"});
    EXPECT_EQ(report().at("counts").at("vertices"), 3000);
    EXPECT_EQ(report().at("counts").at("level_vertices"), Json::array({1000, 200}));
    ASSERT_EQ(made.json.at("meshes").size(), 3u);
    EXPECT_EQ(made.attribute(1, "POSITION", 3).size(), 3000u);
    EXPECT_EQ(made.attribute(2, "POSITION", 3).size(), 600u);
    EXPECT_TRUE(report().at("warnings").empty());
    expect_refused({"skeleton", "square.poly.txt", "-o", "a.glb", "--lod", "500,500"}, 2, {"--lod: 500"});
}

TEST_F(SkeletonLooks, VerticesThatAPartNeedsAreSaidSo) {
    // Twelve holes need more vertices than a hundred.
    std::string comb = "0 0\n26 0\n26 3\n0 3\n";
    for (int i = 0; i < 12; ++i) {
        const std::string x = std::to_string(2 * i + 1), right = std::to_string(2 * i + 2);
        comb += "\n" + x + " 1\n" + x + " 2\n" + right + " 2\n" + right + " 1\n";
    }
    folder.write("comb.poly.txt", comb);
    const Model made = model({"comb.poly.txt", "--vertices", "3000", "--lod", "20"});
    EXPECT_EQ(report().at("counts").at("vertices"), 3000);
    EXPECT_GT(report().at("counts").at("level_vertices").at(0), 20);
    EXPECT_NE(report().at("warnings").dump().find("vertices in place of 20"), std::string::npos);
}

TEST_F(SkeletonLooks, SharpCornersStay) {
    const auto off = [](const Model& made) {
        const std::vector<float> at = made.attribute(0, "POSITION", 3);
        double least = HUGE_VAL;
        for (size_t v = 0; v < at.size(); v += 3) least = std::min(least, std::hypot(at[v] - 5.0, at[v + 1] - 5.0));
        return least;
    };
    EXPECT_LT(off(model({"square.poly.txt", "--vertices", "1000", "--sharp"})), 1e-5);
    EXPECT_LT(off(model({"square.poly.txt", "--vertices", "1000", "--sharp=60"})), 1e-5);
    EXPECT_GT(off(model({"square.poly.txt", "--vertices", "1000", "--sharp=120"})), 0.02);
    EXPECT_GT(off(model({"square.poly.txt", "--vertices", "1000"})), 0.02);
}

// A box with colours, materials, a texture and corners that differ in their coordinates.
constexpr const char* painted_box =
    "mtllib box.mtl\nv 0 0 0 1 0 0\nv 4 0 0 0 1 0\nv 4 1 0 0 0 1\nv 0 1 0 1 1 1\nv 0 0 1 1 0 0\nv 4 0 1 0 1 0\n"
    "v 4 1 1 0 0 1\nv 0 1 1 1 1 1\nvt 0.2 0.2\nvt 0.8 0.2\nvt 0.8 0.8\nvt 0.2 0.8\n"
    "usemtl painted\nf 5/1 6/2 7/3 8/4\nf 2/1 1/2 4/3 3/4\nusemtl bare\nf 6/1 2/2 3/3 7/4\nf 1/1 5/2 8/3 4/4\n"
    "f 8/1 7/2 3/3 4/4\nf 1/1 2/2 6/3 5/4\n";

TEST_F(SkeletonLooks, MeshesKeepTheirColumnsMaterialsAndTextures) {
    folder.write("box.obj", painted_box);
    folder.write("box.mtl", "newmtl painted\nKd 1 1 1\nmap_Kd drawn.png\nnewmtl bare\nKd 0 0.5 0\n");
    const Model made = model({"--mesh", "box.obj"});
    const std::vector<float> at = made.attribute(0, "POSITION", 3), uv = made.attribute(0, "TEXCOORD_0", 2),
                             colors = made.attribute(0, "COLOR_0", 4);
    // The file's vertices first, in their order.
    ASSERT_GT(at.size(), 24u);
    for (size_t v = 0; v < 8; ++v) {
        EXPECT_EQ(at[3 * v], (v % 4 == 1 || v % 4 == 2) ? 4 : 0);
        EXPECT_EQ(at[3 * v + 1], v % 4 >= 2 ? 1 : 0);
        EXPECT_EQ(at[3 * v + 2], v >= 4 ? 1 : 0);
        EXPECT_EQ(colors[4 * v], v % 4 == 0 || v % 4 == 3 ? 1 : 0);
    }
    const Json& primitives = made.json.at("meshes").at(0).at("primitives");
    ASSERT_EQ(primitives.size(), 2u);
    // Triangles in their order, each corner with its texture coordinates.
    const std::vector<uint32_t> front = made.values<uint32_t>(primitives[0].at("indices"), 1);
    ASSERT_EQ(front.size(), 12u);
    const float expected[6][2] = {{0.2f, 0.8f}, {0.8f, 0.8f}, {0.8f, 0.2f}, {0.2f, 0.8f}, {0.8f, 0.2f}, {0.2f, 0.2f}};
    const float places[6][2] = {{0, 0}, {4, 0}, {4, 1}, {0, 0}, {4, 1}, {0, 1}};
    for (size_t c = 0; c < 6; ++c) {
        for (size_t k = 0; k < 2; ++k) {
            EXPECT_NEAR(uv[2 * front[c] + k], expected[c][k], 1e-6f);
            EXPECT_EQ(at[3 * front[c] + k], places[c][k]);
        }
    }
    const Json& painted = made.json.at("materials").at(primitives[0].at("material").get<size_t>());
    EXPECT_EQ(painted.at("name"), "painted");
    EXPECT_EQ(painted.at("pbrMetallicRoughness").at("baseColorTexture").at("index"), 0);
    const Json& bare = made.json.at("materials").at(primitives[1].at("material").get<size_t>());
    EXPECT_EQ(bare.at("pbrMetallicRoughness").at("baseColorFactor"), Json::array({0, 0.5, 0, 1}));
    EXPECT_FALSE(bare.at("pbrMetallicRoughness").contains("baseColorTexture"));
    EXPECT_TRUE(report().at("warnings").empty()) << report().at("warnings");
}

TEST_F(SkeletonLooks, WhatAMeshCannotKeepIsNamed) {
    folder.write("box.obj", painted_box);
    model({"--mesh", "box.obj"});
    EXPECT_NE(report().at("warnings").dump().find("the materials of 'box.mtl' can't be read"), std::string::npos);
}

#if defined(FLG_WITH_RENDERER)
// The colour of a pixel of a picture, by shares of its width and height.
std::array<int, 3> pixel_of(const std::string& png, double x, double y) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), static_cast<int>(png.size()), &width,
                              &height, &channels, 3),
        stbi_image_free);
    EXPECT_TRUE(pixels);
    if (!pixels) return {};
    const stbi_uc* p = pixels.get() + 3 * (static_cast<size_t>(y * height) * static_cast<size_t>(width) +
                                           static_cast<size_t>(x * width));
    return {p[0], p[1], p[2]};
}

TEST_F(SkeletonLooks, TexturesAreDrawnOnMeshesAndSkins) {
    folder.write("box.obj", painted_box);
    folder.write("box.mtl", "newmtl painted\nKd 1 1 1\nmap_Kd drawn.png\nnewmtl bare\nKd 0 0.5 0\n");
    model({"--mesh", "box.obj"});
    for (const char* file : {"box.obj", "a.glb"}) {
        done({"render", file, "-o", "box.png", "--size", "300x150", "--camera", "0,0", "--quiet"});
        const std::array<int, 3> left = pixel_of(folder.read("box.png"), 0.3, 0.5),
                                 right = pixel_of(folder.read("box.png"), 0.7, 0.5);
        EXPECT_GT(left[0], 2 * left[2]) << file;
        EXPECT_GT(right[2], 2 * right[0]) << file;
    }
    folder.write("drawn.png", "\x89PNG no picture");
    expect_refused({"render", "box.obj", "-o", "box.png"}, 1, {"box.obj", "a texture can't be decoded"});
}
#endif

}  // namespace
}  // namespace flg::test
