// SPDX-License-Identifier: MIT
#include "filigree_renderer/image.h"

#include <cstdlib>
#include <memory>
#include <system_error>

#include "core/saved_file.h"
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
    int size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> png(
        stbi_write_png_to_mem(image.pixels.data(), static_cast<int>(4 * image.width), static_cast<int>(image.width),
                              static_cast<int>(image.height), 4, &size),
        std::free);
    if (!png) fail("\"%s\" can't be written: there is no memory for its compression.", path.c_str());
    try {
        SavedFile file(path);
        file.write({reinterpret_cast<const char*>(png.get()), static_cast<size_t>(size)});
        file.save();
    } catch (const std::system_error& error) {
        fail("\"%s\" can't be written: %s.", path.c_str(), error.code().message().c_str());
    }
}

}  // namespace flg::render
