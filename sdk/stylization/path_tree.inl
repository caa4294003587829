// SPDX-License-Identifier: MIT
// The loop of path_tree.h, as curves/sample_block.inl has its own.

// `count` is a multiple of lanes.
inline int32_t least_of(const int32_t* keys, uint32_t count) {
    int32_t least = infinite;
    for (uint32_t k = 0; k < count; ++k) least = keys[k] < least ? keys[k] : least;
    return least;
}

inline uint32_t first_of(const int32_t* keys, uint32_t count, int32_t key) {
    auto first = static_cast<int32_t>(count);
    for (int32_t k = 0; k < static_cast<int32_t>(count); ++k) {
        const int32_t here = keys[k] == key ? k : static_cast<int32_t>(count);
        first = here < first ? here : first;
    }
    return static_cast<uint32_t>(first);
}

bool settle(const TreeInMaking& tree, uint32_t& units) {
    for (;;) {
        const int32_t key = least_of(tree.least, tree.group_count);
        if (key == infinite) return true;
        if (units == 0) return false;
        --units;
        const uint32_t group = first_of(tree.least, tree.group_count, key);
        int32_t* members = tree.waiting + size_t{group} * group_size;
        const uint32_t member = first_of(members, group_size, key);
        // Before the member goes: loads of registers would wait for what was stored to a part of them just now.
        int32_t least = infinite;
        for (uint32_t k = 0; k < group_size; ++k) {
            const int32_t here = k == member ? infinite : members[k];
            least = here < least ? here : least;
        }
        tree.least[group] = least;
        members[member] = infinite;
        const uint32_t node = group * group_size + member;
        const float distance = __builtin_bit_cast(float, key);
        const auto reach = [&](uint32_t source, float through) {
            const auto bits = __builtin_bit_cast(int32_t, through);
            int32_t& group_least = tree.least[source / group_size];
            tree.distance[source] = through;
            tree.next_hop[source] = static_cast<uint16_t>(node);
            tree.waiting[source] = bits;
            group_least = bits < group_least ? bits : group_least;
        };
        if (node > 0 && tree.curve_end[node - 1] != node) {
            const uint32_t before = node - 1;
            const float through = tree.temperature + distance;
            if (through < tree.distance[before]) {
                reach(before, through);
            } else if (through == tree.distance[before] && tree.waiting[before] != infinite) {
                tree.next_hop[before] = static_cast<uint16_t>(node);
            }
        }
        const uint32_t end = tree.in_begin[node + 1];
        for (uint32_t k = tree.in_begin[node]; k < end; ++k) {
            const uint32_t source = tree.in_source[k];
            const float through = tree.in_cost[k] + distance;
            if (through < tree.distance[source]) reach(source, through);
        }
    }
}
