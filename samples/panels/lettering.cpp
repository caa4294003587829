// SPDX-License-Identifier: MIT
#include "panels/lettering.h"

#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace flg::panels {
namespace {

// What is drawn of a line: how much of each pixel it covers, 0 to 1.
struct Coverage {
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<float> amounts;

    float at(int x, int y) const {
        return x < 0 || y < 0 || x >= width || y >= height ? 0.0f : amounts[static_cast<size_t>(y * width + x)];
    }
};

class Font {
public:
    Font() {
        std::ifstream file(FLG_PANELS_FONT, std::ios::binary);
        bytes_.assign(std::istreambuf_iterator<char>(file), {});
        if (bytes_.empty() || stbtt_InitFont(&info_, bytes_.data(), 0) == 0) {
            throw std::runtime_error("the font '" FLG_PANELS_FONT "' of the labels can't be read (fonts-dejavu-core)");
        }
    }
    const stbtt_fontinfo& info() const { return info_; }

private:
    std::vector<unsigned char> bytes_;
    stbtt_fontinfo info_{};
};

const stbtt_fontinfo& font() {
    static const Font kFont;
    return kFont.info();
}

// Calls `each(glyph, x)` for each character, and returns where the line ends.
template <class Each>
float for_each_glyph(std::string_view text, float scale, const Each& each) {
    float x = 0.0f;
    int before = 0;
    for (size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i]);
        const size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
        int code = length == 1 ? first : first & (0x7f >> length);
        for (size_t k = 1; k < length && i + k < text.size(); ++k) code = (code << 6) | (text[i + k] & 0x3f);
        i += length;
        const int glyph = stbtt_FindGlyphIndex(&font(), code);
        if (before != 0) x += scale * static_cast<float>(stbtt_GetGlyphKernAdvance(&font(), before, glyph));
        each(glyph, x);
        int advance = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(&font(), glyph, &advance, &bearing);
        x += scale * static_cast<float>(advance);
        before = glyph;
    }
    return x;
}

Coverage covered(std::string_view text, glm::vec2 baseline, float size, float scale) {
    const int margin = static_cast<int>(size);
    Coverage all;
    all.left = static_cast<int>(std::floor(baseline.x)) - margin;
    all.top = static_cast<int>(std::floor(baseline.y)) - 2 * margin;
    all.width = static_cast<int>(std::ceil(width_of(text, size))) + 2 * margin;
    all.height = 3 * margin;
    all.amounts.resize(static_cast<size_t>(all.width * all.height));
    std::vector<unsigned char> bitmap;
    for_each_glyph(text, scale, [&](int glyph, float x) {
        const float at = baseline.x + x, shift = at - std::floor(at);
        int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
        stbtt_GetGlyphBitmapBoxSubpixel(&font(), glyph, scale, scale, shift, 0.0f, &x0, &y0, &x1, &y1);
        const int width = x1 - x0, height = y1 - y0;
        if (width <= 0 || height <= 0) return;
        bitmap.assign(static_cast<size_t>(width * height), 0);
        stbtt_MakeGlyphBitmapSubpixel(&font(), bitmap.data(), width, height, width, scale, scale, shift, 0.0f, glyph);
        for (int i = 0; i < width * height; ++i) {
            const int column = static_cast<int>(std::floor(at)) + x0 + i % width - all.left,
                      row = static_cast<int>(std::round(baseline.y)) + y0 + i / width - all.top;
            if (column < 0 || row < 0 || column >= all.width || row >= all.height) continue;
            float& amount = all.amounts[static_cast<size_t>(row * all.width + column)];
            amount = std::max(amount, static_cast<float>(bitmap[static_cast<size_t>(i)]) / 255.0f);
        }
    });
    return all;
}

uint8_t encoded(float linear) {
    const float v = linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
    return static_cast<uint8_t>(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f)));
}

// Mixed as the pixels are stored, which makes light and dark words equally strong.
void blend(render::Image& image, int x, int y, glm::vec3 color, float amount) {
    if (x < 0 || y < 0 || x >= static_cast<int>(image.width) || y >= static_cast<int>(image.height)) return;
    uint8_t* const pixel = image.pixels.data() + 4 * (static_cast<size_t>(y) * image.width + static_cast<size_t>(x));
    for (int c = 0; c < 3; ++c) {
        const auto from = static_cast<float>(pixel[c]), to = static_cast<float>(encoded(color[c]));
        pixel[c] = static_cast<uint8_t>(std::lround(from + amount * (to - from)));
    }
}

}  // namespace

float width_of(std::string_view text, float size) {
    return for_each_glyph(text, stbtt_ScaleForMappingEmToPixels(&font(), size), [](int, float) {});
}

void write_words(render::Image& image, std::string_view text, glm::vec2 at, float size, glm::vec3 color, Align align) {
    constexpr float kCapitals = 0.73f;  // of the size
    constexpr glm::vec3 kPaper = glm::vec3(0.85f);
    constexpr int kRim = 2;  // pixels
    constexpr float kRimStrength = 0.75f;
    const float width = width_of(text, size);
    const float share = align == Align::left ? 0.0f : align == Align::center ? 0.5f : 1.0f;
    const glm::vec2 baseline(at.x - share * width, at.y + 0.5f * kCapitals * size);
    const Coverage words = covered(text, baseline, size, stbtt_ScaleForMappingEmToPixels(&font(), size));
    for (int y = 0; y < words.height; ++y) {
        for (int x = 0; x < words.width; ++x) {
            float near = 0.0f;
            for (int dy = -kRim; dy <= kRim; ++dy) {
                for (int dx = -kRim; dx <= kRim; ++dx) {
                    const float fade = 1.0f - std::hypot(static_cast<float>(dx), static_cast<float>(dy)) / (kRim + 1);
                    near = std::max(near, fade * words.at(x + dx, y + dy));
                }
            }
            if (near <= 0.0f) continue;
            blend(image, words.left + x, words.top + y, kPaper, kRimStrength * near);
            blend(image, words.left + x, words.top + y, color, words.at(x, y));
        }
    }
}

void draw_dot(render::Image& image, glm::vec2 center, float radius, glm::vec3 color) {
    const int reach = static_cast<int>(std::ceil(radius)) + 1;
    const auto cx = static_cast<int>(center.x), cy = static_cast<int>(center.y);
    for (int y = cy - reach; y <= cy + reach; ++y) {
        for (int x = cx - reach; x <= cx + reach; ++x) {
            const float distance = glm::distance(glm::vec2(x, y) + 0.5f, center);
            blend(image, x, y, color, std::clamp(radius - distance + 0.5f, 0.0f, 1.0f));
        }
    }
}

}  // namespace flg::panels
