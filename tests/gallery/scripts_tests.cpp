// SPDX-License-Identifier: MIT
// The gallery's scripts: each runs, and makes the picture that is kept beside them.
#include <gtest/gtest.h>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "tools/program.h"

namespace flg::test {
namespace {

namespace fs = std::filesystem;

struct Picture {
    int width = 0, height = 0;
    std::unique_ptr<stbi_uc, void (*)(void*)> pixels{nullptr, stbi_image_free};  // RGB
    size_t size() const { return size_t{3} * static_cast<size_t>(width) * static_cast<size_t>(height); }
};

Picture read(const fs::path& file) {
    Picture picture;
    int channels = 0;
    picture.pixels.reset(stbi_load(file.c_str(), &picture.width, &picture.height, &channels, 3));
    return picture;
}

// Mean difference of channels, 0 to 255.
double difference(const Picture& a, const Picture& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(a.pixels.get()[i] - b.pixels.get()[i]);
    return sum / static_cast<double>(a.size());
}

// Of the picture with a flat one of its mean colour.
double contrast(const Picture& picture) {
    double mean[3] = {}, sum = 0.0;
    for (size_t i = 0; i < picture.size(); ++i) mean[i % 3] += picture.pixels.get()[i];
    for (double& channel : mean) channel /= static_cast<double>(picture.size()) / 3.0;
    for (size_t i = 0; i < picture.size(); ++i) sum += std::abs(picture.pixels.get()[i] - mean[i % 3]);
    return sum / static_cast<double>(picture.size());
}

std::vector<std::string> scripts() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(FLG_GALLERY) / "scripts"))
        names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    return names;
}

class GalleryScript : public ::testing::TestWithParam<std::string> {};

TEST_P(GalleryScript, MakesThePictureThatIsKept) {
    const std::string name = GetParam(), path = std::getenv("PATH");
    ASSERT_EQ(setenv("PATH", (fs::path(FLG_CLI_PROGRAM).parent_path().string() + ":" + path).c_str(), 1), 0);
    const Folder folder;
    const Outcome outcome = run_program("/bin/bash", {FLG_GALLERY "/make", ".", name}, folder.path());
    setenv("PATH", path.c_str(), 1);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Picture made = read(folder / (name + ".png")),
                  kept = read(fs::path(FLG_GALLERY) / "pictures" / (name + ".png"));
    ASSERT_TRUE(made.pixels && kept.pixels);
    ASSERT_EQ(std::make_pair(made.width, made.height), std::make_pair(kept.width, kept.height));
    // Devices shade a little differently; a shape that is missing is a large part of the contrast.
    EXPECT_GT(contrast(made), 2.0);
    EXPECT_LT(difference(made, kept), 0.1 * contrast(kept));
}

INSTANTIATE_TEST_SUITE_P(All, GalleryScript, ::testing::ValuesIn(scripts()),
                         [](const auto& script) { return script.param; });

}  // namespace
}  // namespace flg::test
