// SPDX-License-Identifier: MIT
#include "stylization/style_mix.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "core/moving_frame.h"
#include "runtime/each.h"
#include "stylization/finishing.h"

namespace flg {

namespace {

constexpr uint32_t units_at_once = 100;
constexpr size_t changes_max = 64;  // within a blend: each costs 10 ns a point

// One column of all results that is mixed.
struct MixedColumn {
    Column* out;
    std::array<const Column*, styles_max> in{};
    const StyleAttribute* attribute = nullptr;  // of the first style; null: of the target
};

struct Mix {
    Mix(const MixInput& mix_input, Memory* memory)
        : input(mix_input), base(mix_input.target.curve_count(), memory), columns(memory), carried(memory) {}

    const MixInput& input;
    Buffer<uint8_t> base;  // of each curve: the style whose points the result has
    std::pmr::vector<MixedColumn> columns;
    std::pmr::vector<MixedColumn> carried;  // copied from the base
    Column* style_index = nullptr;
    Column* angle = nullptr;
    size_t angle_column = 0;  // where among the columns that are mixed
    bool has_speed = false;

    const SamplingPlan& plan(uint32_t style, uint32_t curve) const {
        return input.styles[style].sampling->plans[curve];
    }
    uint32_t copies() const { return input.styles[0].sampling->copies; }
};

// Where the samples of one style lie between those of another, along one curve.
class SampleMap {
public:
    SampleMap() = default;
    SampleMap(const SamplingPlan& from, const SamplingPlan& to) : from_(&from), to_(&to) {
        if (!from.pieces.empty()) return;
        ratio_ = static_cast<double>(to.steps) / from.steps;
        if (from.exact_step > 0 && to.exact_step > 0) ratio_ = from.exact_step / to.exact_step;
    }

    // Samples of `from` come in order.
    double operator()(uint32_t sample) {
        const uint32_t last = to_->sample_count() - 1;
        if (from_->pieces.empty()) {
            const double at = sample * ratio_;
            return to_->curve.closed ? at : std::min<double>(at, last);
        }
        while (piece_ + 1 < from_->pieces.size() && sample >= from_->pieces[piece_].end_step) ++piece_;
        const uint32_t begin = piece_ > 0 ? from_->pieces[piece_ - 1].end_step : 0;
        const uint32_t to_begin = piece_ > 0 ? to_->pieces[piece_ - 1].end_step : 0;
        const double steps = from_->pieces[piece_].end_step - begin, to_steps = to_->pieces[piece_].end_step - to_begin;
        return to_begin + (sample - begin) * (to_steps / steps);
    }

private:
    const SamplingPlan* from_ = nullptr;
    const SamplingPlan* to_ = nullptr;
    double ratio_ = 1;
    size_t piece_ = 0;
};

// visit(arc length, style up to there) where the choice changes, and at the end. `chosen`: one a point of the curve.
template <class Visit>
Task<void> each_change(Pace& pace, CurveView curve, const float* chosen, uint32_t styles, Visit visit) {
    double s = 0;
    StyleChoice choice(styles);
    Slice slice(Cost::tens_of_ns);
    for (SegmentStream stream(curve); !stream.done();) {
        const SegmentStream::Range range = stream.take();
        for (uint32_t j = range.first; j < range.last; ++j) {
            const uint32_t index = stream.index_of(j);
            const double length = stream.block().lengths[j];
            choice.follow(chosen[index], chosen[curve.following(index)], s, length,
                          [&](double at, uint32_t style, uint32_t) { visit(at, style); });
            s += length;
        }
        if (slice.is_over(2 * (range.last - range.first) + 1)) co_await pace;
    }
    visit(s, choice.style());
}

Task<void> find_runs(Pace& pace, CurveView curve, const float* chosen, uint32_t styles,
                     std::pmr::vector<StyleRun>& runs) {
    size_t changes = 0;
    co_await each_change(pace, curve, chosen, styles, [&](double, uint32_t) { ++changes; });
    runs.reserve(changes);
    co_await each_change(pace, curve, chosen, styles, [&](double s, uint32_t style) {
        // At repeated points there are runs without length.
        if (runs.empty() || s > runs.back().end) runs.push_back({s, style});
    });
}

// No longer than has so many changes in it.
Task<double> bounded_blend(Pace& pace, std::span<const StyleRun> runs, double blend) {
    const size_t windows = runs.size() > changes_max ? runs.size() - changes_max : 0;
    co_await each(pace, windows, Cost::some_ns, [&](uint32_t k) {
        const double window = runs[k + changes_max].end - runs[k].end;
        if (window > 0) blend = std::min(blend, window);
    });
    co_return blend;
}

// One stroke along one curve.
class CurveMixer {
public:
    CurveMixer(const Mix& mix, uint32_t curve, uint32_t out_curve, StyleWeights& weights)
        : mix_(mix),
          curve_(curve),
          base_(mix.base[curve]),
          first_(mix.input.out.offsets()[out_curve]),
          weights_(weights),
          stream_(mix.plan(base_, curve).curve) {
        for (uint32_t i = 0; i < mix.input.count; ++i) {
            maps_[i] = SampleMap(mix.plan(base_, curve), mix.plan(i, curve));
            in_first_[i] = mix.input.styles[i].result->offsets()[out_curve];
        }
    }

    // All samples.
    static Task<void> mix(Pace& pace, CurveMixer& m) {
        const SamplingPlan& plan = m.mix_.plan(m.base_, m.curve_);
        if (plan.steps == 0) {
            m.weight_.fill(0);
            m.weight_[m.base_] = 1;
            m.write(0, Vec3::UnitX(), Vec3::UnitY());
            co_return;
        }
        FramedSampler sampler(plan);
        SampleBlock block;
        for (uint32_t done = 0; done < plan.sample_count();) {
            uint32_t units = units_at_once, looked = 0;
            const uint32_t count = sampler.next(block, units);
            for (uint32_t k = 0; k < count; ++k, ++done) {
                looked += m.weights_.at(m.arc_length(block.segment[k], block.t[k]), m.weight_);
                m.write(done, block.tangent_of(k), block.normal_of(k));
                if (looked < units_at_once) continue;
                looked = 0;
                co_await pace;
            }
            co_await pace;
        }
    }

private:
    double arc_length(uint32_t segment, float t) {
        while ((!begun_ || stream_.index() != segment) && !stream_.done()) {
            if (!stream_.advance()) continue;
            if (begun_) start_ += length_;
            begun_ = true;
            length_ = stream_.segment().length();
        }
        return start_ + double{t} * length_;
    }
    void write(uint32_t sample, const Vec3& tangent, const Vec3& normal);
    void take_turns(const MixedColumn& column, size_t index);
    double value(const MixedColumn& column, uint32_t style, uint32_t k) const;

    // Where a sample lies between two of a style's.
    struct Place {
        size_t at = 0, next = 0;  // rows
        double t = 0;
    };

    const Mix& mix_;
    uint32_t curve_, base_;
    uint32_t first_;
    StyleWeights& weights_;
    SegmentStream stream_;
    bool begun_ = false;
    double start_ = 0, length_ = 0;
    std::array<SampleMap, styles_max> maps_;
    std::array<uint32_t, styles_max> in_first_{};
    StyleShares weight_{};
    StyleShares last_weight_{};
    std::array<Place, styles_max> places_;
    // Whole turns that are added to a style's angles, by column.
    std::array<std::array<double, styles_max>, style_attributes_max + 4> turns_{};
};

double CurveMixer::value(const MixedColumn& column, uint32_t style, uint32_t k) const {
    const uint32_t width = column.out->components;
    const Place& place = places_[style];
    const float* values = column.in[style]->values.data();
    const double a = values[place.at * width + k];
    if (place.t == 0) return a;
    double change = values[place.next * width + k] - a;
    const double period = column.attribute ? column.attribute->period(k) : 0;
    // Around a closed curve angles have whole turns more or less.
    if (period > 0) change = std::remainder(change, period);
    return a + place.t * change;
}

// Of styles that come in here.
void CurveMixer::take_turns(const MixedColumn& column, size_t index) {
    const uint32_t k = column.attribute->first_angle();
    const double period = column.attribute->period(k);
    double sum = 0, weight = 0;
    for (uint32_t i = 0; i < mix_.input.count; ++i) {
        if (weight_[i] == 0 || last_weight_[i] == 0) continue;
        sum += weight_[i] * (value(column, i, k) + turns_[index][i]);
        weight += weight_[i];
    }
    for (uint32_t i = 0; i < mix_.input.count; ++i) {
        if (weight_[i] == 0 || last_weight_[i] > 0) continue;
        const double own = value(column, i, k);
        turns_[index][i] = weight > 0 ? period * std::round((sum / weight - own) / period) : 0;
    }
}

void CurveMixer::write(uint32_t sample, const Vec3& tangent, const Vec3& normal) {
    const MixInput& input = mix_.input;
    const size_t row = first_ + size_t{sample};
    double most = 0;
    uint32_t main = base_, alone = 0, nodes = 0, first_node = 0;
    for (uint32_t i = 0; i < input.count; ++i) {
        const double at = maps_[i](sample);
        const SamplingPlan& plan = mix_.plan(i, curve_);
        const uint32_t count = plan.sample_count(), floor = std::min(static_cast<uint32_t>(at), count - 1);
        const uint32_t next = floor + 1 < count ? floor + 1 : (plan.curve.closed ? 0 : floor);
        places_[i] = {in_first_[i] + size_t{floor}, in_first_[i] + size_t{next}, at - floor};
        if (weight_[i] > most) {
            most = weight_[i];
            main = i;
            first_node = nodes;
        }
        alone += weight_[i] > 0 ? 1 : 0;
        nodes += input.styles[i].style->point_count();
    }
    for (size_t c = 0; c < mix_.columns.size(); ++c) {
        const MixedColumn& column = mix_.columns[c];
        const uint32_t width = column.out->components;
        const uint32_t angle = column.attribute ? column.attribute->first_angle() : width;
        if (angle < width) take_turns(column, c);
        float* out = column.out->values.data() + row * width;
        for (uint32_t k = 0; k < width; ++k) {
            double sum = 0;
            for (uint32_t i = 0; i < input.count; ++i) {
                if (weight_[i] == 0) continue;
                const double own = value(column, i, k) + (k >= angle ? turns_[c][i] : 0.0);
                sum = alone == 1 ? own : sum + weight_[i] * own;
            }
            out[k] = static_cast<float>(sum);
        }
    }
    for (const MixedColumn& column : mix_.carried) {
        const uint32_t width = column.out->components;
        std::copy_n(column.in[base_]->values.data() + places_[base_].at * width, width,
                    column.out->values.data() + row * width);
    }
    if (mix_.angle && (alone > 1 || main != base_ || turns_[mix_.angle_column][base_] != 0)) {
        const Vec3 turned = turned_about(tangent, normal, mix_.angle->values[row]);
        store_vec3(turned, input.out.columns()[2].values.data() + 3 * row);
    }
    const Column* index = input.styles[main].result->find(FLG_ATTRIBUTE_STYLE_INDEX);
    mix_.style_index->values[row] = static_cast<float>(first_node) + index->values[places_[main].at];
    last_weight_ = weight_;
}

double longest_default_blend(const Mix& mix, uint32_t curve) {
    double longest = 0;
    for (uint32_t i = 0; i < mix.input.count; ++i) {
        const MixedStyle& style = mix.input.styles[i];
        longest = std::max(longest, default_blend(*style.style, style.sampling->spacing_of(curve)));
    }
    return longest;
}

Task<void> mix_batch(Pace& pace, const Mix& mix, uint32_t batch) {
    const MixInput& input = mix.input;
    const CurveRange range = curves_of_batch(input.target, batch / mix.copies());
    const uint32_t stroke = batch % mix.copies();
    for (uint32_t c = range.first; c < range.last; ++c) {
        const uint32_t out_curve = c * mix.copies() + stroke;
        std::pmr::vector<StyleRun> runs(pace.memory());
        const float* chosen = input.chosen.data() + input.target.offsets()[c];
        co_await find_runs(pace, curve_view(input.target, c), chosen, input.count, runs);
        const double blend = input.blend > 0 ? input.blend : longest_default_blend(mix, c);
        const std::span<const StyleRun> all(runs.data(), runs.size());
        StyleWeights weights(all, input.target.closed(c), co_await bounded_blend(pace, all, blend));
        CurveMixer mixer(mix, c, out_curve, weights);
        co_await CurveMixer::mix(pace, mixer);
        if (mix.has_speed) co_await time_motion(pace, input.target, c, input.out, out_curve);
        if (!input.unfinished) input.out.complete_curve(out_curve);
        pace.advance(input.out.offsets()[out_curve + 1] - input.out.offsets()[out_curve]);
        co_await pace;
    }
}

// Whose samples are closer together. Exact steps may be as many where they are not as long.
bool is_closer(const SamplingPlan& a, const SamplingPlan& b) {
    return a.exact_step > 0 && b.exact_step > 0 ? a.exact_step < b.exact_step : a.steps > b.steps;
}

// The structure of the result.
Task<void> lay_out(Pace& pace, Mix& mix) {
    const MixInput& input = mix.input;
    CurveSet& out = input.out;
    const uint32_t copies = mix.copies(), curves = input.target.curve_count();
    out.allocate_curves(curves * copies);
    uint64_t points = 0;
    Slice slice(Cost::tens_of_ns);
    for (uint32_t c = 0; c < curves; ++c) {
        mix.base[c] = 0;
        for (uint32_t i = 1; i < input.count; ++i) {
            if (is_closer(mix.plan(i, c), mix.plan(mix.base[c], c))) mix.base[c] = static_cast<uint8_t>(i);
        }
        for (uint32_t k = 0; k < copies; ++k) {
            out.offsets()[c * copies + k] = static_cast<uint32_t>(points);
            out.begin_curve(c * copies + k, input.target.flags()[c]);
            points += mix.plan(mix.base[c], c).sample_count();
            if (points > sampled_points_max) {
                throw Failure(FLG_ERROR_LIMIT, "the result would have more points than it may; the limit is 2^31");
            }
            if (slice.is_over()) co_await pace;
        }
    }
    out.offsets()[curves * copies] = static_cast<uint32_t>(points);
    std::pmr::vector<CurveSet::ColumnLayout> layout(pace.memory());
    for (const Column& column : input.styles[0].result->columns()) {
        layout.push_back({column.attribute, column.components});
    }
    out.allocate_columns(layout);
    pace.expect(points);
}

// A column of all results, and what becomes of it.
void sort_column(Mix& mix, Column& out) {
    const MixInput& input = mix.input;
    MixedColumn column{.out = &out};
    for (uint32_t i = 0; i < input.count; ++i) column.in[i] = input.styles[i].result->find(out.attribute);
    for (const StyleAttribute& attribute : input.styles[0].style->attributes) {
        if (attribute.attribute == out.attribute) column.attribute = &attribute;
    }
    switch (out.attribute) {
        case FLG_ATTRIBUTE_STYLE_INDEX: mix.style_index = &out; return;
        case FLG_ATTRIBUTE_ANGLE:
            mix.angle = column.attribute ? &out : nullptr;
            mix.angle_column = mix.columns.size();
            break;
        case FLG_ATTRIBUTE_SPEED: mix.has_speed = column.attribute != nullptr; break;
        default: break;
    }
    const bool mixed = column.attribute || out.attribute == FLG_ATTRIBUTE_POSITION ||
                       out.attribute == FLG_ATTRIBUTE_DISPLACEMENT || out.attribute == FLG_ATTRIBUTE_RADIUS;
    (mixed ? mix.columns : mix.carried).push_back(column);
}

}  // namespace

void check_same_attributes(const PreparedStyle& first, const PreparedStyle& other, uint32_t index) {
    const auto has_all = [](const PreparedStyle& a, const PreparedStyle& b) {
        return std::all_of(b.attributes.begin(), b.attributes.end(), [&](const StyleAttribute& wanted) {
            return std::any_of(a.attributes.begin(), a.attributes.end(), [&](const StyleAttribute& own) {
                return own.attribute == wanted.attribute && own.components == wanted.components;
            });
        });
    };
    if (has_all(first, other) && has_all(other, first)) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.further_styles[%u] transfers other attributes than desc.style",
                  index);
}

Task<void> mix_styles(Pace& pace, const MixInput& input) {
    pace.stage("mixing");
    Mix mix(input, pace.memory());
    co_await lay_out(pace, mix);
    for (Column& column : input.out.columns()) sort_column(mix, column);
    co_await fork(pace, batch_count(input.target) * mix.copies(), &mix_batch, std::as_const(mix));
}

}  // namespace flg
