// SPDX-License-Identifier: MIT
// Light from everywhere but the sun: floor, horizon and sky, and soft lamps, which are spherical Gaussians. Mirrors
// renderer/src/environment.cpp, which makes the numbers.
//
// Diffuse: irradiance by nine spherical harmonics (Ramamoorthi and Hanrahan, An Efficient Representation for Irradiance
// Environment Maps, 2001). Specular: the microfacets' lobe is itself a spherical Gaussian about the mirrored direction,
// and the integral of two has a closed form (Wang and others, All-Frequency Rendering of Dynamic, Spatially-Varying
// Reflectance, 2009). The lobe is taken to be isotropic, theirs is warped at grazing angles. What reflects at which
// angle is Karis's fit (Physically Based Shading on Mobile, 2014).

const float horizon_share = 0.55;  // of what the backdrop shows there

// Of a white matte surface that faces `n`.
vec3 diffuse_environment(vec3 n) {
    vec3 light = view.irradiance[0].rgb;
    light += view.irradiance[1].rgb * n.y + view.irradiance[2].rgb * n.z + view.irradiance[3].rgb * n.x;
    light += view.irradiance[4].rgb * (n.x * n.y) + view.irradiance[5].rgb * (n.y * n.z);
    light += view.irradiance[6].rgb * (3.0 * n.z * n.z - 1.0) + view.irradiance[7].rgb * (n.x * n.z);
    light += view.irradiance[8].rgb * (n.x * n.x - n.y * n.y);
    return max(light, vec3(0.0));
}

// Floor, horizon and sky; blurred by 0 for none to 1 for all that a rough surface can.
vec3 surroundings(float height, float blur) {
    vec3 horizon = horizon_share * view.background_bottom.rgb;
    vec3 floor_and_horizon = mix(view.bounce_color.rgb, horizon, smoothstep(-0.1 - blur, 0.05 + 0.3 * blur, height));
    return mix(floor_and_horizon, view.sky_color.rgb, smoothstep(-0.2 * blur, 0.35 + 0.65 * blur, height));
}

// What a surface of that roughness sees about a mirrored direction.
vec3 mirrored_environment(vec3 direction, float roughness) {
    float alpha = roughness * roughness;
    vec3 light = surroundings(direction.y, roughness);
    float lobe = 0.5 / max(alpha * alpha, 1e-4);
    for (int i = 0; i < lamp_count; ++i) {
        float lamp = view.lamp_axis[i].w;
        float both = lobe / (lobe + lamp);
        light += view.lamp_color[i].rgb * (both * exp(both * lamp * (dot(direction, view.lamp_axis[i].xyz) - 1.0)));
    }
    return light;
}

// Share of the environment that a surface reflects which reflects `head_on` at a right angle.
vec3 reflected_share(vec3 head_on, float roughness, float facing_eye) {
    const vec4 slope = vec4(-1.0, -0.0275, -0.572, 0.022), offset = vec4(1.0, 0.0425, 1.04, -0.04);
    vec4 r = roughness * slope + offset;
    float scale = min(r.x * r.x, exp2(-9.28 * facing_eye)) * r.x + r.y;
    vec2 fit = vec2(-1.04, 1.04) * scale + r.zw;
    return head_on * fit.x + fit.y;
}
