// SPDX-License-Identifier: MIT
#include "io/gltf/gltf_rig.h"

#include "io/base/json_text.h"

namespace flg::io {

namespace {

const char* limb_name(FlgLimb limb) {
    switch (limb) {
        case FLG_LIMB_TRUNK: return "trunk";
        case FLG_LIMB_NECK: return "neck";
        case FLG_LIMB_HEAD: return "head";
        case FLG_LIMB_ARM: return "arm";
        case FLG_LIMB_LEG: return "leg";
        case FLG_LIMB_TAIL: return "tail";
        default: return "other";
    }
}

const char* place_name(FlgLimbPlace place) {
    switch (place) {
        case FLG_LIMB_PLACE_UPPER: return "upper";
        case FLG_LIMB_PLACE_MIDDLE: return "middle";
        case FLG_LIMB_PLACE_END: return "end";
        default: return nullptr;
    }
}

String json_place(const float* place, const float* from) {
    const auto number = [&](size_t k) { return double{static_cast<float>(double{place[k]} - from[k])}; };
    return json_triple(number(0), number(1), number(2));
}

}  // namespace

String json_rig_joint(const FlgRigJoint& joint, const float* position) {
    String json = "{\"filigree\":{\"limb\":\"" + String(limb_name(joint.limb)) + "\"";
    if (const char* place = place_name(joint.place)) json += ",\"place\":\"" + String(place) + "\"";
    if (joint.side != 0) json += String(",\"side\":\"") + (joint.side > 0 ? "left" : "right") + "\"";
    if (joint.limb == FLG_LIMB_LEG) json += ",\"pair\":" + to_text(joint.pair);
    json += ",\"index\":" + to_text(joint.index);
    if (joint.capsule_radius > 0)
        json += ",\"capsule\":{\"start\":" + json_place(joint.capsule_start, position) +
                ",\"end\":" + json_place(joint.capsule_end, position) +
                ",\"radius\":" + json_number(joint.capsule_radius) + "}";
    const float* axis = joint.limit_axis;
    json += ",\"limit\":{\"axis\":" + json_triple(double{axis[0]}, double{axis[1]}, double{axis[2]}) +
            ",\"swing\":" + json_number(joint.limit_swing) + ",\"twist\":[" + json_number(joint.limit_twist_min) + "," +
            json_number(joint.limit_twist_max) + "]}";
    return json + "}}";
}

String json_vrm(const FlgVrm& vrm, const String& model_name, size_t joint_count, size_t first_node) {
    String authors, bones;
    const auto add_item = [](String& list, const String& item) { list += (list.empty() ? "" : ",") + item; };
    for (uint32_t i = 0; i < vrm.author_count; ++i) add_item(authors, json_text(vrm.authors[i]));
    for (size_t j = 0; j < joint_count; ++j)
        if (vrm.bones[j]) add_item(bones, json_text(vrm.bones[j]) + ":{\"node\":" + to_text(first_node + j) + "}");
    const char* license = vrm.license_url ? vrm.license_url : "https://vrm.dev/licenses/1.0/";
    return "\"extensions\":{\"VRMC_vrm\":{\"specVersion\":\"1.0\",\"meta\":{"
           "\"name\":" +
           json_text(vrm.name ? std::string_view(vrm.name) : std::string_view(model_name)) + ",\"authors\":[" +
           authors + "],\"licenseUrl\":" + json_text(license) + "},\"humanoid\":{\"humanBones\":{" + bones + "}}}}";
}

}  // namespace flg::io
