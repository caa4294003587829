// SPDX-License-Identifier: MIT
#include "bench/bench.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace flg::bench {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

}  // namespace

std::string Row::bar_text() const {
    const std::string suffix = unit.empty() ? "" : " " + unit;
    if (low == -kInfinity) return "< " + number(high) + suffix;
    if (high == kInfinity) return ">= " + number(low) + suffix;
    return number(low) + " to " + number(high) + suffix;
}

Row below(std::string name, double figure, std::string unit, double bar, std::string note) {
    return {std::move(name), figure, std::move(unit), -kInfinity, bar, std::move(note)};
}

Row at_least(std::string name, double figure, std::string unit, double bar, std::string note) {
    return {std::move(name), figure, std::move(unit), bar, kInfinity, std::move(note)};
}

Row within(std::string name, double figure, std::string unit, double middle, double tolerance, std::string note) {
    return {std::move(name), figure, std::move(unit), middle - tolerance, middle + tolerance, std::move(note)};
}

double thread_ms() {
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double time_ms(const std::function<void()>& call) {
    const double start_ms = thread_ms();
    call();
    return thread_ms() - start_ms;
}

double median_ms(int runs, const std::function<double()>& work) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) times.push_back(work());
    return median(std::move(times));
}

double growth_exponent(const std::vector<double>& x, const std::vector<double>& y) {
    double mean_x = 0.0, mean_y = 0.0;
    const double n = static_cast<double>(x.size());
    for (size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / n;
        mean_y += std::log(y[i]) / n;
    }
    double covariance = 0.0, variance = 0.0;
    for (size_t i = 0; i < x.size(); ++i) {
        covariance += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
        variance += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    }
    return covariance / variance;
}

}  // namespace flg::bench
