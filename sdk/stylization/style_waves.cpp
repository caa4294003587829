// SPDX-License-Identifier: MIT
#include "stylization/style_waves.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "runtime/each.h"

namespace flg {

namespace {

// Tangents that the spectrum is made of: a power of two.
constexpr uint32_t min_cells = 64;
// Bends up to this degree of the tangent are no waves: arcs up to a circle, and an S.
constexpr uint32_t bend_degree = 4;

// The density of the spectrum over the logarithm of the waves' number, smoothed by a Gaussian of `blur` octaves.
constexpr int bins_per_octave = 8;
constexpr double first_bin = 0.5;  // waves
constexpr int bin_count = 128;     // up to 2^16 times the first
constexpr double blur = 0.3;
constexpr int blur_reach = 9;  // bins each way
// Fewer waves than this cannot be told from a bend, nor be learned; beyond one in this many cells is the noise of the
// sampling.
constexpr double min_waves = 1.5;
constexpr double min_cells_per_wave = 8.0;

// A density counts from here on: the least slope, squared, that is a wave, and what a bend of the energy 1 leaves to
// waves of the number 1.
constexpr double min_density = 0.004;
constexpr double left_by_bends = 0.6;
// Beside the strongest density, shorter waves count from this share on.
constexpr double min_share_of_shorter = 0.3;
// Below this share of the waves' own density over so many bins, what is longer is something else.
constexpr double silence = 0.1;
constexpr int silent_bins = bins_per_octave;
// The low edge of the waves: this share of their density.
constexpr double edge_share = 0.25;

struct Complex3 {
    Vec3 re, im;
};

using Bins = std::array<double, bin_count>;

double waves_of_bin(int bin) {
    return first_bin * std::exp2(static_cast<double>(bin) / bins_per_octave);
}

// Unit tangents over equal parts of the length, one a cell: means over the cell.
Task<void> sample_tangents(Pace& pace, std::span<const Vec3> style, Buffer<Vec3>& tangents) {
    const auto cells = static_cast<uint32_t>(tangents.size());
    const auto last = static_cast<uint32_t>(style.size()) - 1;
    double length = 0.0;
    co_await each(pace, last, Cost::some_ns,
                  [&length, style](uint32_t i) { length += (style[i + 1] - style[i]).norm(); });
    const double per_cell = length > 0.0 ? cells / length : 0.0;
    Vec3 before = style[0];
    co_await each(pace, cells, Cost::some_ns, [=, &before, out = tangents.data()](uint32_t j) {
        const double along = static_cast<double>(j + 1) * last / cells;
        const uint32_t i = std::min(static_cast<uint32_t>(along), last - 1);
        const Vec3 point = style[i] + (along - i) * (style[i + 1] - style[i]);
        out[j] = per_cell * (point - before);
        before = point;
    });
}

double legendre(uint32_t degree, double x) {
    double before = 1.0, value = degree == 0 ? 1.0 : x;
    for (uint32_t n = 1; n < degree; ++n) {
        const double next = ((2 * n + 1) * x * value - n * before) / (n + 1);
        before = value;
        value = next;
    }
    return value;
}

// Takes bends out of the tangents; returns their energy, the mean of the squares, without the constant's.
Task<double> remove_bends(Pace& pace, Buffer<Vec3>& tangents) {
    const auto cells = static_cast<uint32_t>(tangents.size());
    const auto place = [cells](uint32_t j) { return (2 * j + 1.0) / cells - 1.0; };
    std::array<Vec3, bend_degree + 1> parts;
    parts.fill(Vec3::Zero());
    co_await each(pace, cells, Cost::tens_of_ns, [&parts, place, in = tangents.data()](uint32_t j) {
        for (uint32_t n = 0; n <= bend_degree; ++n) parts[n] += legendre(n, place(j)) * in[j];
    });
    double energy = 0.0;
    for (uint32_t n = 0; n <= bend_degree; ++n) {
        parts[n] *= (2 * n + 1.0) / cells;
        if (n > 0) energy += parts[n].squaredNorm() / (2 * n + 1);
    }
    co_await each(pace, cells, Cost::tens_of_ns, [&parts, place, out = tangents.data()](uint32_t j) {
        for (uint32_t n = 0; n <= bend_degree; ++n) out[j] -= legendre(n, place(j)) * parts[n];
    });
    co_return energy;
}

struct Turn {
    double cos, sin;
};

// exp(-i pi k / (2 cells)) for k < 2 cells, each from two before it.
Task<void> make_turns(Pace& pace, uint32_t cells, Buffer<Turn>& turns) {
    turns[0] = {1.0, 0.0};
    for (uint32_t done = 1; done < 2 * cells; done *= 2) {
        const double angle = -std::numbers::pi * done / (2.0 * cells);
        const Turn by = {std::cos(angle), std::sin(angle)};
        co_await each(pace, done, Cost::some_ns, [=, out = turns.data()](uint32_t k) {
            out[done + k] = {out[k].cos * by.cos - out[k].sin * by.sin, out[k].cos * by.sin + out[k].sin * by.cos};
        });
    }
}

// In place, of values in the order of reversed bits.
Task<void> fourier(Pace& pace, Buffer<Complex3>& values, const Buffer<Turn>& turns) {
    const auto cells = static_cast<uint32_t>(values.size());
    for (uint32_t half = 1; half < cells; half *= 2) {
        const uint32_t turn_step = 2 * cells / half;  // of turns, which go on by pi / (2 cells)
        co_await each(pace, cells / 2, Cost::tens_of_ns, [=, out = values.data(), turn = turns.data()](uint32_t k) {
            const uint32_t within = k & (half - 1);
            Complex3& low = out[2 * k - within];
            Complex3& high = out[2 * k - within + half];
            const Turn by = turn[within * turn_step];
            const Vec3 re = by.cos * high.re - by.sin * high.im;
            const Vec3 im = by.cos * high.im + by.sin * high.re;
            high = {low.re - re, low.im - im};
            low = {low.re + re, low.im + im};
        });
    }
}

uint32_t reversed_bits(uint32_t value, int bits) {
    uint32_t out = 0;
    for (int b = 0; b < bits; ++b) out |= (value >> b & 1U) << (bits - 1 - b);
    return out;
}

// The power of the tangents' cosine transform in its bins: half waves k = 1, 2, ... that end as they began, so that the
// ends of the style make no waves of their own.
Task<void> add_powers(Pace& pace, const Buffer<Vec3>& tangents, Bins& bins) {
    const auto cells = static_cast<uint32_t>(tangents.size());
    const int bits = std::countr_zero(cells);
    Buffer<Complex3> values(cells, pace.memory());
    Buffer<Turn> turns(size_t{2} * cells, pace.memory());
    co_await make_turns(pace, cells, turns);
    // The even ones forwards, then the odd ones backwards: the transform of the row and its mirror image. Each may be
    // the first in its page.
    co_await each(pace, cells, Cost::hundreds_of_ns, [=, out = values.data(), in = tangents.data()](uint32_t j) {
        out[reversed_bits(j, bits)] = {2 * j < cells ? in[2 * j] : in[2 * (cells - j) - 1], Vec3::Zero()};
    });
    co_await fourier(pace, values, turns);
    const double scale = 2.0 / (static_cast<double>(cells) * cells);
    co_await each(pace, 1, cells / 2, Cost::tens_of_ns,
                  [&bins, scale, in = values.data(), turn = turns.data()](uint32_t k) {
                      const Vec3 part = turn[k].cos * in[k].re - turn[k].sin * in[k].im;
                      const double at = bins_per_octave * std::log2(0.5 * k / first_bin);
                      const auto bin = static_cast<int>(at);
                      const double power = scale * part.squaredNorm();
                      bins[bin] += power * (bin + 1 - at);
                      bins[bin + 1] += power * (at - bin);
                  });
    turns = {};
    co_await pace;
    values = {};
    co_await pace;
}

// With the Gaussian's greatest value 1: a pure wave has its power for a density.
Bins blurred(const Bins& bins) {
    std::array<double, blur_reach + 1> weights;
    for (int d = 0; d <= blur_reach; ++d) {
        const double x = d / (blur * bins_per_octave);
        weights[d] = std::exp(-0.5 * x * x);
    }
    Bins out{};
    for (int b = 0; b < bin_count; ++b) {
        for (int d = std::max(-blur_reach, -b); d <= std::min(blur_reach, bin_count - 1 - b); ++d) {
            out[b] += weights[std::abs(d)] * bins[b + d];
        }
    }
    return out;
}

// The bins that waves may be in, and how dense they must be there.
struct Candidates {
    bool counts(int bin) const {
        const double waves = waves_of_bin(bin);
        return density[bin] > min_density + left_by_bends * bend_energy / (waves * waves);
    }

    Bins density;
    double bend_energy;
    int first, last;
};

// The strongest bin of the waves, and the last one that is looked at; -1: there are no waves.
int shortest_waves(const Candidates& candidates) {
    const Bins& density = candidates.density;
    int strongest = -1;
    for (int b = candidates.first; b <= candidates.last; ++b) {
        if (candidates.counts(b) && (strongest < 0 || density[b] > density[strongest])) strongest = b;
    }
    if (strongest < 0) return -1;
    for (int b = candidates.last; b > strongest; --b) {
        const bool peak = density[b] >= density[b - 1] && density[b] >= density[b + 1];
        if (peak && candidates.counts(b) && density[b] >= min_share_of_shorter * density[strongest]) return b;
    }
    return strongest;
}

double low_edge(const Candidates& candidates) {
    const Bins& density = candidates.density;
    const int top = shortest_waves(candidates);
    if (top < 0) return 0.0;
    double strongest = density[top];
    int low = top;
    for (int b = top, silent = 0; b >= candidates.first && silent < silent_bins; --b) {
        const bool heard = candidates.counts(b) && density[b] >= silence * strongest;
        silent = heard ? 0 : silent + 1;
        if (!heard) continue;
        low = b;
        strongest = std::max(strongest, density[b]);
    }
    while (!(candidates.counts(low) && density[low] >= edge_share * strongest)) ++low;
    // Between the bins, so that the edge moves evenly with what it is the edge of.
    const double wanted = edge_share * strongest, above = density[low], below = density[low - 1];
    if (!(below < wanted)) return waves_of_bin(low);
    const double back = std::clamp((above - wanted) / (above - below), 0.0, 1.0);
    return waves_of_bin(low) * std::exp2(-back / bins_per_octave);
}

}  // namespace

Task<double> count_waves(Pace& pace, std::span<const Vec3> style) {
    const uint32_t cells = std::max(std::bit_ceil(static_cast<uint32_t>(style.size()) - 1), min_cells);
    Buffer<Vec3> tangents(cells, pace.memory());
    co_await sample_tangents(pace, style, tangents);
    const double bend_energy = co_await remove_bends(pace, tangents);
    Bins bins{};
    co_await add_powers(pace, tangents, bins);
    const auto bin_of = [](double waves) { return static_cast<int>(bins_per_octave * std::log2(waves / first_bin)); };
    const Candidates candidates{blurred(bins), bend_energy, bin_of(min_waves), bin_of(cells / min_cells_per_wave)};
    co_return low_edge(candidates);
}

}  // namespace flg
