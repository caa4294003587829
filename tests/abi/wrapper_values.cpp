// SPDX-License-Identifier: MIT
// filigree.hpp in C++17 without exceptions and RTTI: calls return their value or what failed.
#include <cstdio>
#include <cstring>

#include "filigree/filigree.hpp"

#if defined(__cpp_exceptions) || defined(__cpp_rtti) || !defined(FILIGREE_NO_EXCEPTIONS)
#error "to be compiled with -fno-exceptions -fno-rtti"
#endif

namespace {

bool failed(int line) {
    std::fprintf(stderr, "wrapper_values.cpp:%d: %s\n", line, filigree::error_message());
    return false;
}

bool lines_get_a_style(filigree::Context& context) {
    filigree::Result<filigree::CurveSet> zigzag = context.curve_set_from_points({0, 0, 0, 1, 1, 0, 2, -1, 0, 3, 0, 0});
    filigree::Result<filigree::CurveSet> line = context.curve_set_from_points({0, 0, 0, 30, 0, 0});
    if (!zigzag || !line) return failed(__LINE__);
    filigree::Result<filigree::Style> style = context.style({*zigzag});
    if (!style) return failed(__LINE__);
    const filigree::CurveSet result = *context.stylize({*style, *line});

    // Asked too early: no failure, and nothing to see.
    filigree::Result<filigree::CurveSetView> early = result.view();
    if (early || early.failed() || early.result() != FLG_NOT_READY || *early.message()) return failed(__LINE__);
    if (early->curve_count != 0 || !early->columns.empty() || result.ready()) return failed(__LINE__);
    while (!result.ready())
        if (context.tick(2000).failed() || context.wait(1000).failed()) return failed(__LINE__);
    const filigree::CurveSetView view = result.view().value();
    return view.rows<3>(FLG_ATTRIBUTE_POSITION).size() == view.curve_offsets[1] && view.curve_offsets[1] > 100 &&
           view.rows<4>(FLG_ATTRIBUTE_POSITION).empty() && view.rows<4>(FLG_ATTRIBUTE_COLOR).empty();
}

// Rows of a column that is a member of structs.
bool rows_may_be_apart() {
    const float numbers[] = {0, 1, 2, -1, 3, 4, 5, -1, 6, 7, 8, -1};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, numbers, 4 * sizeof(float), 0};
    float next = 0;
    for (const auto& row : filigree::Rows<3>(&column, 3))
        for (const float number : row)
            if (number != next++) return failed(__LINE__);
    return next == 9 && filigree::Rows<2>(&column, 3).empty() && filigree::Rows<3>(nullptr, 3).empty();
}

bool failures_are_values(filigree::Context& context) {
    filigree::Result<filigree::CurveSet> refused = context.curve_set_from_points({0, 0, 0}, 7);
    if (refused || !refused.failed() || refused.result() != FLG_ERROR_INVALID_ARGUMENT) return failed(__LINE__);
    if (!std::strstr(refused.message(), "flags")) return failed(__LINE__);
    const filigree::CurveSet none;
    const filigree::Result<bool> ready = none.ready();
    return !ready && ready.failed() && ready.result() == FLG_ERROR_INVALID_HANDLE;
}

// A job whose input is refused once it runs.
bool jobs_fail_as_values(filigree::Context& context) {
    filigree::Result<filigree::CurveSet> dot = context.curve_set_from_points({1, 1, 1});
    filigree::Job job;
    filigree::Result<filigree::Style> style = context.style({*dot}, &job);
    if (style) {
        const filigree::Result<bool> ran = context.run({job});
        if (ran || !ran.failed() || *job.status()->error == 0) return failed(__LINE__);
        return style->ready().failed();
    }
    return style.failed() && !*&job;
}

}  // namespace

int main() {
    filigree::ContextDesc desc;
    desc.worker_count = 0;
    filigree::Result<filigree::Context> context = filigree::Context::create(desc);
    if (!context) return failed(__LINE__), 1;
    desc.version = 1;
    if (!filigree::Context::create(desc).failed()) return failed(__LINE__), 1;
    return lines_get_a_style(*context) && rows_may_be_apart() && failures_are_values(*context) &&
                   jobs_fail_as_values(*context)
               ? 0
               : 1;
}
