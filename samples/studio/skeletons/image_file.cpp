// SPDX-License-Identifier: MIT
#include "skeletons/image_file.h"

#include <memory>

#include "shell/studio_error.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace flg::studio {
namespace {

constexpr uint32_t kMost = 4096;

render::Image halved(const render::Image& image) {
    render::Image out;
    out.width = image.width / 2;
    out.height = image.height / 2;
    out.pixels.resize(size_t{4} * out.width * out.height);
    for (uint32_t y = 0; y < out.height; ++y) {
        for (uint32_t x = 0; x < out.width; ++x) {
            const uint8_t* rows[] = {image.at(2 * x, 2 * y), image.at(2 * x, 2 * y + 1)};
            for (size_t c = 0; c < 4; ++c)
                out.pixels[4 * (size_t{y} * out.width + x) + c] =
                    static_cast<uint8_t>((rows[0][c] + rows[0][c + 4] + rows[1][c] + rows[1][c + 4] + 2) / 4);
        }
    }
    return out;
}

}  // namespace

ImageSize image_size(const std::string& path) {
    int width = 0, height = 0, channels = 0;
    if (stbi_info(path.c_str(), &width, &height, &channels) == 0)
        throw StudioError("The picture " + path + " cannot be read: " + stbi_failure_reason() + ".");
    return {static_cast<uint32_t>(width), static_cast<uint32_t>(height)};
}

render::Image read_image(const std::string& path) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load(path.c_str(), &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) throw StudioError("The picture " + path + " cannot be read: " + stbi_failure_reason() + ".");
    render::Image image;
    image.width = static_cast<uint32_t>(width);
    image.height = static_cast<uint32_t>(height);
    image.pixels.assign(pixels.get(), pixels.get() + size_t{4} * image.width * image.height);
    while (image.width > kMost || image.height > kMost) {
        if (image.width < 2 || image.height < 2) throw StudioError("The picture " + path + " is too long and thin.");
        image = halved(image);
    }
    return image;
}

}  // namespace flg::studio
