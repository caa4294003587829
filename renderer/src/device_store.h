// SPDX-License-Identifier: MIT
// Things uploaded, by their numbers. What is replaced or removed stays until the device is done with it; what of it has
// not been uploaded yet never is.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "upload_ring.h"

namespace flg::render {

template <class Item>
class DeviceStore {
public:
    // `noun` for sentences: "curves".
    DeviceStore(const char* noun, UploadRing& ring) : ring_(ring), noun_(noun) {}

    uint64_t add(std::unique_ptr<Item> item) {
        items_[++last_id_] = std::move(item);
        return last_id_;
    }
    // Numbers begin after those that another has given out.
    void follow(const DeviceStore& other) { last_id_ = other.last_id_; }
    // Throws Error if there is none with this number.
    Item& at(uint64_t id) const {
        const auto found = items_.find(id);
        if (found == items_.end())
            fail("There are no %s with the id %llu.", noun_, static_cast<unsigned long long>(id));
        return *found->second;
    }
    // `frame`: the last submitted.
    void replace(uint64_t id, std::unique_ptr<Item> item, uint64_t frame) {
        at(id);
        std::swap(items_[id], item);
        retire(std::move(item), frame);
    }
    void remove(uint64_t id, uint64_t frame) {
        at(id);
        retire(std::move(items_[id]), frame);
        items_.erase(id);
    }
    void remove_all(uint64_t frame) {
        UploadTargets targets;
        for (auto& [id, item] : items_) {
            item->add_targets(targets);
            retired_.push_back({frame, std::move(item)});
        }
        items_.clear();
        ring_.cancel(std::move(targets));
    }
    void recycle(uint64_t finished_frame) {
        std::erase_if(retired_, [=](const Retired& retired) { return retired.frame <= finished_frame; });
    }

    const std::map<uint64_t, std::unique_ptr<Item>>& items() const { return items_; }

protected:
    UploadRing& ring_;

private:
    struct Retired {
        uint64_t frame;
        std::unique_ptr<Item> item;
    };
    void retire(std::unique_ptr<Item> item, uint64_t frame) {
        UploadTargets targets;
        item->add_targets(targets);
        ring_.cancel(std::move(targets));
        retired_.push_back({frame, std::move(item)});
    }

    const char* noun_;
    std::map<uint64_t, std::unique_ptr<Item>> items_;
    std::vector<Retired> retired_;
    uint64_t last_id_ = 0;
};

}  // namespace flg::render
