// SPDX-License-Identifier: MIT
#include "studio/pictures.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <vector>

namespace flg::test {
namespace {

constexpr int kBlock = 16, kChannels = 3;

struct Picture {
    int width = 0, height = 0;
    std::vector<double> values;
};

Picture read(const std::filesystem::path& path, int down) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&std::free)> pixels(
        stbi_load(path.c_str(), &width, &height, &channels, kChannels), std::free);
    if (pixels == nullptr) throw std::runtime_error(path.string() + " can't be read");
    Picture picture{width / down, height / down, {}};
    picture.values.assign(static_cast<size_t>(picture.width * picture.height * kChannels), 0.0);
    for (int y = 0; y < picture.height * down; ++y)
        for (int x = 0; x < picture.width * down; ++x)
            for (int c = 0; c < kChannels; ++c)
                picture.values[static_cast<size_t>(((y / down) * picture.width + x / down) * kChannels + c)] +=
                    pixels.get()[(y * width + x) * kChannels + c] / static_cast<double>(down * down);
    return picture;
}

}  // namespace

Difference compare_pictures(const std::filesystem::path& a_path, const std::filesystem::path& b_path, int down_a,
                            int down_b) {
    const Picture a = read(a_path, down_a), b = read(b_path, down_b);
    if (a.width != b.width || a.height != b.height) throw std::runtime_error("the pictures have different sizes");
    Difference difference{};
    for (size_t i = 0; i < a.values.size(); ++i)
        difference.mean += std::abs(a.values[i] - b.values[i]) / static_cast<double>(a.values.size());
    for (int y = 0; y + kBlock <= a.height; y += kBlock) {
        for (int x = 0; x + kBlock <= a.width; x += kBlock) {
            for (int c = 0; c < kChannels; ++c) {
                double sum = 0.0;
                for (int dy = 0; dy < kBlock; ++dy)
                    for (int dx = 0; dx < kBlock; ++dx) {
                        const auto i = static_cast<size_t>(((y + dy) * a.width + x + dx) * kChannels + c);
                        sum += a.values[i] - b.values[i];
                    }
                difference.block = std::max(difference.block, std::abs(sum) / (kBlock * kBlock));
            }
        }
    }
    return difference;
}

}  // namespace flg::test
