// SPDX-License-Identifier: MIT
#include "skeletons/pull_record.h"

#include <algorithm>

namespace flg::studio {

std::vector<PullPin> PullRecord::at(float seconds) const {
    std::vector<PullPin> pins;
    if (keys.empty()) return pins;
    auto after = std::upper_bound(keys.begin(), keys.end(), seconds,
                                  [](float time, const Key& key) { return time < key.seconds; });
    const Key& from = after == keys.begin() ? keys.front() : *(after - 1);
    const Key& to = after == keys.end() ? keys.back() : *after;
    const float between = to.seconds - from.seconds;
    const float share = between > 0.0f ? std::clamp((seconds - from.seconds) / between, 0.0f, 1.0f) : 0.0f;
    for (const auto& [place, by] : from.by) {
        const auto next = to.by.find(place);
        pins.push_back({places[place], next == to.by.end() ? by : glm::mix(by, next->second, share)});
    }
    return pins;
}

void PullRecord::add(float seconds, const std::vector<PullPin>& pins) {
    Key& key = keys.emplace_back();
    key.seconds = seconds;
    for (const PullPin& pin : pins) {
        const auto found = std::find(places.begin(), places.end(), pin.place);
        key.by[static_cast<uint32_t>(found - places.begin())] = pin.by;
        if (found == places.end()) places.push_back(pin.place);
    }
}

}  // namespace flg::studio
