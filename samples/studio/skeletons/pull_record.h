// SPDX-License-Identifier: MIT
// Points of a body that are held somewhere else than its bones have them, and how they were moved.
#pragma once

#include <map>
#include <optional>

#include "skeletons/weight_strokes.h"

namespace flg::studio {

struct PullPin {
    BodyPlace place;
    glm::vec3 by{0.0f};  // metres, from where it is at rest
    bool operator==(const PullPin&) const = default;
};

// Keys in the order of their times. Pins of a key by their place's index: those that are held at that time.
struct PullRecord {
    struct Key {
        float seconds = 0.0f;
        std::map<uint32_t, glm::vec3> by;
        bool operator==(const Key&) const = default;
    };
    std::vector<BodyPlace> places;
    std::vector<Key> keys;
    bool operator==(const PullRecord&) const = default;

    float length() const { return keys.empty() ? 0.0f : keys.back().seconds; }
    // The pins at a time, straight from key to key.
    std::vector<PullPin> at(float seconds) const;
    void add(float seconds, const std::vector<PullPin>& pins);
};

struct Pulls {
    std::vector<PullPin> pins;
    std::shared_ptr<const PullRecord> record;  // null: none
};

}  // namespace flg::studio
