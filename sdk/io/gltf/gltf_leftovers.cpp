// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_leftovers.h"

#include <algorithm>

namespace flg::io {

namespace {

// Extensions by whose members no accessor and no buffer view is used, but images' and views' own.
constexpr std::string_view known_extensions[] = {
    "KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_mesh_quantization", "KHR_animation_pointer", "KHR_node_",
    "KHR_xmp",        "EXT_texture_", "MSFT_lod",    "MSFT_texture_",         "EXT_meshopt_",          "VRM"};

bool are_all_known(const GltfDocument& document) {
    const Json* const names = gltf_array(document.root(), "extensionsUsed", "");
    for (size_t i = 0; names && i < names->size(); ++i) {
        const std::string_view name = (*names)[i].string_or("");
        if (std::none_of(std::begin(known_extensions), std::end(known_extensions),
                         [&](std::string_view known) { return name.starts_with(known); }))
            return false;
    }
    return true;
}

// Which elements are used by what stays, and by what goes.
struct Uses {
    explicit Uses(size_t count) : kept(count), gone(count) {}

    void add(const Json* index, bool is_gone) {
        if (!index || !index->is_count() || index->count() >= kept.size()) return;
        (is_gone ? gone : kept)[index->count()] = true;
    }
    void add_all(const Json& indices, bool is_gone) {
        for (const JsonMember& member : indices.members()) add(&member.value, is_gone);
    }
    Vector<size_t> left() const {
        Vector<size_t> left;
        for (size_t i = 0; i < kept.size(); ++i)
            if (gone[i] && !kept[i]) left.push_back(i);
        return left;
    }

    Vector<bool> kept, gone;
};

void add_primitive(const Json& primitive, bool is_gone, Uses& accessors) {
    accessors.add(primitive.find("indices"), is_gone);
    if (const Json* const attributes = primitive.find("attributes")) accessors.add_all(*attributes, is_gone);
    const Json* const targets = primitive.find("targets");
    for (size_t i = 0; targets && i < targets->size(); ++i) accessors.add_all((*targets)[i], is_gone);
}

// Of each element of a list of the document.
template <class Visit>
void visit_elements(const Json& of, const char* name, Visit visit) {
    const Json* const list = of.find(name);
    for (size_t i = 0; list && i < list->size(); ++i) visit((*list)[i], i);
}

}  // namespace

GltfLeftovers find_leftovers(const GltfDocument& document, const std::function<bool(uint64_t, uint64_t)>& is_gone) {
    if (!are_all_known(document)) return {};
    const Json& root = document.root();
    Uses accessors(document.size("accessors"));
    visit_elements(root, "meshes", [&](const Json& mesh, size_t m) {
        visit_elements(mesh, "primitives",
                       [&](const Json& primitive, size_t p) { add_primitive(primitive, is_gone(m, p), accessors); });
    });
    visit_elements(root, "skins",
                   [&](const Json& skin, size_t) { accessors.add(skin.find("inverseBindMatrices"), false); });
    visit_elements(root, "animations", [&](const Json& animation, size_t) {
        visit_elements(animation, "samplers", [&](const Json& sampler, size_t) {
            for (const char* const end : {"input", "output"}) accessors.add(sampler.find(end), false);
        });
    });
    GltfLeftovers left{.accessors = accessors.left(), .views = {}};
    Uses views(document.size("bufferViews"));
    visit_elements(root, "accessors", [&](const Json& accessor, size_t a) {
        const bool goes = std::binary_search(left.accessors.begin(), left.accessors.end(), a);
        views.add(accessor.find("bufferView"), goes);
        const Json* const sparse = accessor.find("sparse");
        for (const char* const part : {"indices", "values"}) {
            const Json* const found = sparse ? sparse->find(part) : nullptr;
            if (found) views.add(found->find("bufferView"), goes);
        }
    });
    visit_elements(root, "images", [&](const Json& image, size_t) { views.add(image.find("bufferView"), false); });
    left.views = views.left();
    return left;
}

}  // namespace flg::io
