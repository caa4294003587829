// SPDX-License-Identifier: MIT
// Mirrors renderer/src/field_color.cpp, which says why.

vec3 linear_of_oklab(vec3 lab) {
    float l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
    float m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
    float s = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
    vec3 cone = vec3(l * l * l, m * m * m, s * s * s);
    return vec3(4.0767416621 * cone.x - 3.3077115913 * cone.y + 0.2309699292 * cone.z,
                -1.2684380046 * cone.x + 2.6097574011 * cone.y - 0.3413193965 * cone.z,
                -0.0041960863 * cone.x - 0.7034186147 * cone.y + 1.7076147010 * cone.z);
}

vec3 field_color(float t) {
    float at = clamp(t, 0.0, 1.0);
    float lightness = mix(0.38, 0.93, at);
    float hue = mix(5.10, 1.78, at);
    float ends = 2.0 * at - 1.0;
    float chroma = mix(0.095, 0.145, ends * ends);
    return clamp(linear_of_oklab(vec3(lightness, chroma * cos(hue), chroma * sin(hue))), 0.0, 1.0);
}
