// SPDX-License-Identifier: MIT
#include "stylization/apply_style.h"

#include "curves/sampling_job.h"
#include "stylization/synthesis.h"

namespace flg {

namespace {

constexpr uint32_t synthesis_chunk = 250;  // units, about 20 us

struct Application {
    Sampling sampling;
    SynthesisInput input;
};

StylizedColumns stylized_columns(const Sampling& sampling, uint32_t curve) {
    float* indices = sampling.out.columns()[3].values.data() + sampling.out.offsets()[curve];
    return {frame_columns(sampling, curve), indices};
}

Task<void> stylize_batch(Pace& pace, Application& application, uint32_t batch) {
    const Sampling& sampling = application.sampling;
    const CurveRange range = curves_of_batch(sampling.in, batch);
    std::pmr::vector<ColumnPair> pairs(pace.memory());
    SynthesisKernel kernel(application.input, pace.memory());
    for (uint32_t c = range.first; c < range.last; ++c) {
        column_pairs(sampling, c, pairs);
        kernel.begin(sampling.plans[c], c, stylized_columns(sampling, c), pairs);
        uint32_t written = 0;
        while (!kernel.run(synthesis_chunk)) {
            pace.advance(kernel.written() - written);
            written = kernel.written();
            co_await pace;
        }
        pace.advance(kernel.written() - written);
        sampling.out.complete_curve(c);
        co_await pace;
    }
}

}  // namespace

Task<void> apply_style(Pace& pace, StylizeRequest request) {
    const PreparedStyle& prepared = request.style->prepared;
    Application application{.sampling = {*request.target,
                                         *request.out,
                                         prepared.spacing() * request.scale,
                                         request.frame,
                                         true,
                                         {},
                                         std::pmr::vector<Sampling::Carried>(pace.memory())},
                            .input = {}};
    std::pmr::vector<FlgAttribute> added(pace.memory());
    added.push_back(FLG_ATTRIBUTE_STYLE_INDEX);
    co_await plan_sampling(pace, application.sampling, std::move(added));

    pace.stage("synthesis");
    const auto temperature = static_cast<float>(request.temperature * prepared.graph.temperature_unit);
    const std::shared_ptr<PathTrees> trees = request.style->trees(temperature);
    const bool lone = request.target->curve_count() == 1;
    const bool from_start = request.start == FLG_START_STYLE || (request.start == FLG_START_AUTO && lone);
    application.input = {.displacement = &prepared.displacement,
                         .trees = trees.get(),
                         .magnitude = request.magnitude,
                         .scale = request.scale,
                         .from_start = from_start,
                         .seed = request.seed};
    co_await fork(pace, batch_count(*request.target), &stylize_batch, application);
}

}  // namespace flg
