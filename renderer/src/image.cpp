// SPDX-License-Identifier: MIT
#include "filigree_renderer/image.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "vk.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace flg::render {

void write_png(const Image& image, const std::string& path) {
    if (image.width == 0 || image.height == 0 || image.pixels.size() != size_t{4} * image.width * image.height)
        fail("The image to write to \"%s\" has no pixels, or not as many as its size says.", path.c_str());
    // Renaming over a symbolic link would replace the link.
    constexpr int max_links = 40;  // as the kernel has it
    std::filesystem::path real = path;
    std::error_code ignored;
    for (int i = 0; i < max_links && std::filesystem::is_symlink(real, ignored); ++i)
        real = real.parent_path() / std::filesystem::read_symlink(real, ignored);
    const std::string temporary = real.string() + ".part";
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file) fail("\"%s\" can't be written: %s.", path.c_str(), std::strerror(errno));
    const auto write = [](void* context, void* data, int size) {
        std::fwrite(data, 1, static_cast<size_t>(size), static_cast<std::FILE*>(context));
    };
    const int row_bytes = static_cast<int>(4 * image.width);
    const bool encoded = stbi_write_png_to_func(write, file, static_cast<int>(image.width),
                                                static_cast<int>(image.height), 4, image.pixels.data(), row_bytes) != 0;
    const bool failed = std::ferror(file) != 0;
    const bool closed = std::fclose(file) == 0;
    std::error_code error;
    if (encoded && !failed && closed) std::filesystem::rename(temporary, real, error);
    if (!encoded || failed || !closed || error) {
        std::filesystem::remove(temporary, ignored);
        fail("\"%s\" can't be written%s%s.", path.c_str(), error ? ": " : "", error ? error.message().c_str() : "");
    }
}

}  // namespace flg::render
