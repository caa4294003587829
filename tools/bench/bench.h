// SPDX-License-Identifier: MIT
// The table of bars: what Filigree promises to reach, measured. One file a group; groups.cpp lists them. Figures are
// medians of several runs in one process, on one core, in processor time; ticks and chunks in wall time, as a host sees
// them.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace flg::bench {

struct Row {
    std::string name;
    double figure;
    std::string unit;
    double low = 0.0, high = 0.0;  // the bar: figure must be within
    std::string note = {};

    bool held() const { return figure >= low && figure <= high; }
    std::string bar_text() const;
};

// A row whose figure must stay below `bar`, reach `bar`, or be `middle` give or take.
Row below(std::string name, double figure, std::string unit, double bar, std::string note = {});
Row at_least(std::string name, double figure, std::string unit, double bar, std::string note = {});
Row within(std::string name, double figure, std::string unit, double middle, double tolerance, std::string note = {});

struct Group {
    std::string ability;  // what its bars are about; groups of the same follow one another
    std::string name;
    std::vector<Row> (*run)();
};

const std::vector<Group>& groups();

double median(std::vector<double> values);

// Runs `work`, which returns the milliseconds that count, several times; the median.
double median_ms(int runs, const std::function<double()>& work);

// Milliseconds of processor time that this thread has had: what a call costs on one core, whatever else the machine
// does.
double thread_ms();

// Milliseconds of it that a call takes.
double time_ms(const std::function<void()>& call);

// Slope of log y over log x by least squares.
double growth_exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace flg::bench
