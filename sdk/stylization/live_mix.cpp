// SPDX-License-Identifier: MIT
#include "stylization/live_mix.h"

#include <cmath>

namespace flg {

LiveMixStates::LiveMixStates(uint32_t styles, size_t count, Memory* memory) {
    if (styles < 2) return;
    styles_ = styles;
    choices_ = Buffer<LiveChoice>(count, memory);
    weights_ = Buffer<StyleShares>(count, memory);
    followers_ = Buffer<MixedFollower>(count * styles, memory);
}

LiveMixState LiveMixStates::operator[](size_t i) {
    if (styles_ == 0) return {};
    return {&choices_[i], &weights_[i], {&followers_[i * styles_], styles_}};
}

LiveMix::LiveMix(const LiveSettings& settings, const LiveMixState& state)
    : state_(state), count_(settings.style_count > 1 ? settings.style_count : 0), blend_(settings.style_blend) {
    uint32_t nodes = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        const LiveStyle& style = settings.styles[i];
        followers_[i] = LiveFollower(settings, style);
        ratios_[i] = settings.spacing() / style.spacing();
        first_nodes_[i] = nodes;
        nodes += style.style->point_count();
        point_counts_[i] = style.point_count;
        const auto& attributes = settings.styles[0].style->attributes;
        for (size_t a = 0; a < attributes.size(); ++a) {
            const auto& own = style.style->attributes;
            const auto found = std::find_if(own.begin(), own.end(), [&](const StyleAttribute& other) {
                return other.attribute == attributes[a].attribute;
            });
            attributes_[i][a] = static_cast<uint8_t>(found - own.begin());
        }
    }
    if (state_.followers.empty()) return;
    std::construct_at(state_.choice, count_, blend_);
    std::construct_at(state_.weights);
    for (MixedFollower& follower : state_.followers) std::construct_at(&follower);
}

void LiveMix::begin() {
    state_.weights->fill(0);
    for (uint32_t i = 0; i < count_; ++i) {
        state_.followers[i].at = followers_[i].begin();
        state_.followers[i].sample = 0;
        state_.followers[i].turns = {};
    }
}

// The sample that a style stands at becomes the one before.
void LiveMix::keep_sample(uint32_t style) {
    MixedFollower& own = state_.followers[style];
    own.node_before = own.at.walk.node();
    own.offset_before = own.at.blend.offset();
    const auto& attributes = followers_[style].style().attributes;
    for (size_t a = 0; a < attributes.size(); ++a) {
        for (uint32_t k = 0; k < attributes[a].components; ++k) {
            own.values_before[a * attribute_components_max + k] =
                static_cast<float>(own.at.blend.value(a, k, own.node_before));
        }
    }
}

LiveMix::Place LiveMix::follow(uint32_t style, uint32_t point, const Steered& steered) {
    MixedFollower& own = state_.followers[style];
    double at = point * ratios_[style];
    if (point_counts_[style] > 1) at = std::min(at, point_counts_[style] - 1.0);
    const double last = std::ceil(at);
    while (own.sample < last) {
        keep_sample(style);
        followers_[style].advance(own.at, ++own.sample, steered);
    }
    return last == at ? Place{} : Place{true, at - std::floor(at)};
}

// Before a style's length, and with its turns.
double LiveMix::value(uint32_t style, size_t attribute, uint32_t component) const {
    const MixedFollower& own = state_.followers[style];
    const size_t a = attributes_[style][attribute];
    const StyleAttribute& described = followers_[style].style().attributes[a];
    double value = own.at.blend.value(a, component, own.at.walk.node());
    if (places_[style].between) {
        const double before = own.values_before[a * attribute_components_max + component];
        value = before + places_[style].t * (value - before);
    }
    return component >= described.first_angle() ? value + own.turns[attribute] : value;
}

// Of styles that come in here: they are turned to where they are nearest.
void LiveMix::take_turns(size_t attribute, const StyleShares& weights) {
    const StyleAttribute& described = followers_[0].style().attributes[attribute];
    const uint32_t angle = described.first_angle();
    if (angle == described.components) return;
    const double period = described.period(angle);
    const StyleShares& before = *state_.weights;
    double sum = 0, weight = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        if (weights[i] == 0 || before[i] == 0) continue;
        sum += weights[i] * value(i, attribute, angle);
        weight += weights[i];
    }
    for (uint32_t i = 0; i < count_; ++i) {
        if (weights[i] == 0 || before[i] > 0) continue;
        double& turns = state_.followers[i].turns[attribute];
        turns = 0;
        if (weight > 0) turns = period * std::round((sum / weight - value(i, attribute, angle)) / period);
    }
}

void LiveMix::mix_attributes(const StyleShares& weights, const Steered& steered) {
    const auto& attributes = followers_[0].style().attributes;
    for (size_t a = 0; a < attributes.size(); ++a) {
        take_turns(a, weights);
        const uint32_t lengths = attributes[a].length_count();
        const bool radius = attributes[a].attribute == FLG_ATTRIBUTE_RADIUS;
        for (uint32_t k = 0; k < attributes[a].components; ++k) {
            double sum = 0;
            for (uint32_t i = 0; i < count_; ++i) {
                if (weights[i] == 0) continue;
                const double size = k < lengths ? followers_[i].scale() * steered.scale : 1.0;
                const double own = value(i, a, k);
                sum += weights[i] * (radius ? own / followers_[i].radius_unit() : size * own);
            }
            values_[a * attribute_components_max + k] = sum;
        }
    }
}

void LiveMix::go_to(uint32_t point, float t, const Steered& steered) {
    StyleShares weights;
    state_.choice->weigh(t, weights);
    displacement_ = Vec3::Zero();
    double most = 0;
    for (uint32_t i = 0; i < count_; ++i) {
        const Place& place = places_[i] = follow(i, point, steered);
        if (weights[i] == 0) continue;
        const MixedFollower& own = state_.followers[i];
        Vec3 own_displacement = followers_[i].displacement(own.at);
        if (place.between) {
            const Vec3 before = followers_[i].displacement_of(own.node_before) + own.offset_before;
            own_displacement = before + place.t * (own_displacement - before);
        }
        displacement_ += weights[i] * own_displacement;
        if (weights[i] <= most) continue;
        most = weights[i];
        node_ = first_nodes_[i] + (place.between ? own.node_before : own.at.walk.node());
    }
    mix_attributes(weights, steered);
    *state_.weights = weights;
}

}  // namespace flg
