// SPDX-License-Identifier: MIT
// Files as another reader sees them.
#pragma once

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cstring>
#include <string>
#include <vector>

namespace flg::test {

inline tinygltf::Model load_model(const std::string& path) {
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string errors, warnings;
    EXPECT_TRUE(loader.LoadBinaryFromFile(&model, &errors, &warnings, path)) << errors;
    EXPECT_EQ(errors + warnings, "");
    return model;
}

template <class T>
std::vector<T> values_of(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<size_t>(index));
    const tinygltf::BufferView& view = model.bufferViews.at(static_cast<size_t>(accessor.bufferView));
    const auto components = static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type)));
    EXPECT_EQ(static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType))),
              sizeof(T));
    const size_t size = components * sizeof(T);
    const size_t stride = view.byteStride ? view.byteStride : size;
    EXPECT_EQ(stride, size);
    std::vector<T> values(accessor.count * components);
    const size_t start = view.byteOffset + accessor.byteOffset;
    EXPECT_LE(accessor.byteOffset + values.size() * sizeof(T), view.byteLength);
    EXPECT_EQ(start % 4, 0u);
    std::memcpy(values.data(), model.buffers[0].data.data() + start, values.size() * sizeof(T));
    return values;
}

}  // namespace flg::test
