// SPDX-License-Identifier: MIT
// Things uploaded, by their numbers. What is replaced or removed stays until the device is done with it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "vk.h"

namespace flg::render {

template <class Item>
class DeviceStore {
public:
    // `noun` for sentences: "curves".
    explicit DeviceStore(const char* noun) : noun_(noun) {}

    uint64_t add(std::unique_ptr<Item> item) {
        items_[++last_id_] = std::move(item);
        return last_id_;
    }
    // Throws Error if there is none with this number.
    Item& at(uint64_t id) const {
        const auto found = items_.find(id);
        if (found == items_.end())
            fail("There are no %s with the id %llu.", noun_, static_cast<unsigned long long>(id));
        return *found->second;
    }
    // `frame`: the next to be submitted.
    void replace(uint64_t id, std::unique_ptr<Item> item, uint64_t frame) {
        at(id);
        std::swap(items_[id], item);
        retired_.push_back({frame, std::move(item)});
    }
    void remove(uint64_t id, uint64_t frame) {
        at(id);
        retired_.push_back({frame, std::move(items_[id])});
        items_.erase(id);
    }
    void remove_all(uint64_t frame) {
        for (auto& [id, item] : items_) retired_.push_back({frame, std::move(item)});
        items_.clear();
    }
    void recycle(uint64_t finished_frame) {
        std::erase_if(retired_, [=](const Retired& retired) { return retired.frame <= finished_frame; });
    }

    const std::map<uint64_t, std::unique_ptr<Item>>& items() const { return items_; }

private:
    struct Retired {
        uint64_t frame;
        std::unique_ptr<Item> item;
    };
    const char* noun_;
    std::map<uint64_t, std::unique_ptr<Item>> items_;
    std::vector<Retired> retired_;
    uint64_t last_id_ = 0;
};

}  // namespace flg::render
