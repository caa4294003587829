// SPDX-License-Identifier: MIT
// When each triangle of a wavefront changes next, the earliest first: a binary heap with one place a triangle, so
// that events that no longer hold leave nothing behind. Memory is taken once.
#pragma once

#include <cstdint>

#include "core/memory.h"

namespace flg {

struct WaveEvent {
    enum class Kind : uint8_t {
        edge,      // a wavefront edge shrinks to a point
        diagonal,  // two ends of a side between triangles meet
        flat,      // the triangle's corners come to be on one line
        last       // to be done after all else at its time
    };
    double time;
    Kind kind;
    uint8_t side;
};

class EventQueue {
public:
    static constexpr uint32_t none = ~0u;

    EventQueue(size_t triangles, Memory* memory)
        : events_(triangles, memory), heap_(triangles, memory), place_(triangles, memory) {}

    void begin_triangle(uint32_t triangle) { place_[triangle] = none; }
    bool empty() const { return size_ == 0; }
    uint32_t first() const { return heap_[0]; }
    const WaveEvent& event(uint32_t triangle) const { return events_[triangle]; }

    void set(uint32_t triangle, const WaveEvent& event) {
        events_[triangle] = event;
        if (place_[triangle] == none) {
            place_[triangle] = static_cast<uint32_t>(size_);
            heap_[size_++] = triangle;
        }
        sink(place_[triangle]);
        rise(place_[triangle]);
    }
    void remove(uint32_t triangle) {
        const uint32_t at = place_[triangle];
        if (at == none) return;
        place_[triangle] = none;
        const uint32_t moved = heap_[--size_];
        if (moved == triangle) return;
        put(at, moved);
        sink(at);
        rise(place_[moved]);
    }

private:
    // Ties are decided by number, for the same bits everywhere.
    bool is_before(uint32_t a, uint32_t b) const {
        const WaveEvent &x = events_[a], &y = events_[b];
        if (x.time != y.time) return x.time < y.time;
        const bool x_last = x.kind == WaveEvent::Kind::last, y_last = y.kind == WaveEvent::Kind::last;
        return x_last != y_last ? y_last : a < b;
    }
    void put(uint32_t at, uint32_t triangle) {
        heap_[at] = triangle;
        place_[triangle] = at;
    }
    void rise(uint32_t at) {
        const uint32_t triangle = heap_[at];
        for (; at > 0 && is_before(triangle, heap_[(at - 1) / 2]); at = (at - 1) / 2) put(at, heap_[(at - 1) / 2]);
        put(at, triangle);
    }
    void sink(uint32_t at) {
        const uint32_t triangle = heap_[at];
        for (uint32_t child = 2 * at + 1; child < size_; child = 2 * at + 1) {
            if (child + 1 < size_ && is_before(heap_[child + 1], heap_[child])) ++child;
            if (!is_before(heap_[child], triangle)) break;
            put(at, heap_[child]);
            at = child;
        }
        put(at, triangle);
    }

    Buffer<WaveEvent> events_;
    Buffer<uint32_t> heap_, place_;
    size_t size_ = 0;
};

}  // namespace flg
