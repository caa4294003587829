// SPDX-License-Identifier: MIT
#include "baking/texel_padding.h"

#include <cstdlib>

#include "runtime/fork.h"

namespace flg {

namespace {

constexpr int16_t none = INT16_MAX;  // no row of a chart within the padding

// Rows of a band, and for each texel how many rows up (below 0) or down the nearest covered one of its column is.
class BandPadding {
public:
    BandPadding(const Canvas& canvas, uint32_t first_row, uint32_t end_row, Memory* memory)
        : canvas_(canvas),
          request_(canvas.request),
          size_(canvas.request.size),
          padding_(static_cast<int32_t>(canvas.request.padding)),
          first_row_(first_row),
          end_row_(end_row),
          rows_(size_t{end_row - first_row} * size_, memory),
          run_(size_, memory) {}

    // Sweeps of the columns [begin, end) of one row: downwards from the row above the band by as much as the padding,
    // then upwards likewise. `is_first` of a sweep.
    uint32_t sweep_rows() const { return end_row_ - first_row_ + request_.padding; }
    void sweep_down(uint32_t step, uint32_t begin, uint32_t end) {
        const int64_t y = int64_t{first_row_} - padding_ + step;
        sweep(y, step == 0, -1, begin, end);
    }
    void sweep_up(uint32_t step, uint32_t begin, uint32_t end) {
        const int64_t y = int64_t{end_row_} - 1 + padding_ - step;
        sweep(y, step == 0, 1, begin, end);
    }

    // Returns what it looked at.
    uint32_t pad(uint32_t texel) {
        const uint32_t x = texel % size_, y = first_row_ + texel / size_;
        if (canvas_.is_covered(x, y)) return 1;
        const int16_t* const row = rows_.data() + size_t{y - first_row_} * size_;
        int32_t least = padding_ * padding_ + 1, from_x = 0, from_y = 0;
        int32_t off = 0;
        for (; off * off < least && off <= padding_; ++off) {
            for (const int32_t column : {static_cast<int32_t>(x) - off, static_cast<int32_t>(x) + off}) {
                if (column < 0 || column >= static_cast<int32_t>(size_) || row[column] == none) continue;
                const int32_t distance = off * off + row[column] * row[column];
                if (distance >= least) continue;
                least = distance;
                from_x = column;
                from_y = static_cast<int32_t>(y) + row[column];
            }
        }
        if (least <= padding_ * padding_)
            copy(size_t{y} * size_ + x, static_cast<size_t>(from_y) * size_ + static_cast<size_t>(from_x));
        return 1 + static_cast<uint32_t>(off) / 4;
    }

private:
    void sweep(int64_t y, bool is_first, int16_t towards, uint32_t begin, uint32_t end) {
        const bool in_map = y >= 0 && y < int64_t{size_}, in_band = y >= first_row_ && y < end_row_;
        int16_t* const row = in_band ? rows_.data() + static_cast<size_t>(y - first_row_) * size_ : nullptr;
        for (uint32_t x = begin; x < end; ++x) {
            if (is_first) run_[x] = none;
            int16_t& distance = run_[x];
            if (in_map && canvas_.is_covered(x, static_cast<uint32_t>(y))) {
                distance = 0;
            } else if (distance != none && ++distance > padding_) {
                distance = none;
            }
            if (!row) continue;
            if (towards < 0 || row[x] == none || distance < -row[x])
                row[x] = distance == none ? none : static_cast<int16_t>(towards * distance);
        }
    }
    void copy(size_t to, size_t from) {
        const BakedMaps& maps = request_.maps;
        if (maps.ids) maps.ids[to] = maps.ids[from];
        if (maps.distances) maps.distances[to] = maps.distances[from];
        if (maps.borders) maps.borders[to] = maps.borders[from];
        if (maps.heights) maps.heights[to] = maps.heights[from];
        if (maps.normals) std::copy_n(maps.normals + 3 * from, 3, maps.normals + 3 * to);
        const size_t count = request_.component_count;
        if (maps.blends) std::copy_n(maps.blends + count * from, count, maps.blends + count * to);
    }

    const Canvas& canvas_;
    const BakeRequest& request_;
    uint32_t size_;
    int32_t padding_;
    uint32_t first_row_, end_row_;
    Buffer<int16_t> rows_, run_;
};

// Bands are at least as high as the padding, as the sweeps begin that far off.
uint32_t padding_height(const Canvas& canvas) {
    return std::max(canvas.bands.height, canvas.request.padding);
}

Task<void> pad_band(Pace& pace, const Canvas& canvas, uint32_t band) {
    const uint32_t size = canvas.request.size, height = padding_height(canvas);
    const auto words = static_cast<uint32_t>(canvas.words());
    const uint32_t rows = std::min(size, (band + 1) * height) - band * height;
    bool is_covered = true;
    co_await each(pace, band * height * words, (band * height + rows) * words, Cost::some_ns, [&](uint32_t word) {
        const uint32_t bits = std::min(64u, size - word % words * 64);
        is_covered &= canvas.covered[word] == UINT64_MAX >> (64 - bits);
    });
    if (is_covered) co_return;
    BandPadding padding(canvas, band * height, band * height + rows, pace.memory());
    Slice slice(Cost::some_ns);
    for (const bool down : {true, false}) {
        for (uint32_t step = 0; step < padding.sweep_rows(); ++step) {
            for (Portion part(slice, 0, size); part.next();) {
                down ? padding.sweep_down(step, part.begin, part.end) : padding.sweep_up(step, part.begin, part.end);
                if (part.is_over()) co_await pace;
            }
        }
    }
    co_await each_by_work(pace, size_t{rows} * size, Cost::some_ns, [&](uint32_t texel) { return padding.pad(texel); });
}

}  // namespace

Task<void> pad_charts(Pace& pace, const Canvas& canvas) {
    if (canvas.request.padding == 0) co_return;
    const uint32_t height = padding_height(canvas);
    co_await fork(pace, (canvas.request.size + height - 1) / height, &pad_band, canvas);
}

}  // namespace flg
