// SPDX-License-Identifier: MIT
// The loops of displaced_block.h, as curves/sample_block.inl has them.

inline uint32_t whole_registers(uint32_t count) {
    return (count + SampleBlock::lanes - 1) / SampleBlock::lanes * SampleBlock::lanes;
}

void displace(const SampleBlock& __restrict samples, DisplacedBlock& __restrict block) {
    const uint32_t count = whole_registers(samples.count);
    for (uint32_t k = 0; k < count; ++k) {
        const float tx = samples.tangent[0][k + 1], ty = samples.tangent[1][k + 1], tz = samples.tangent[2][k + 1];
        const float nx = samples.normal[0][k + 1], ny = samples.normal[1][k + 1], nz = samples.normal[2][k + 1];
        const float a = block.along[0][k + 1], b = block.along[1][k + 1], c = block.along[2][k + 1];
        const float x = a * tx + b * nx + c * (ty * nz - tz * ny);
        const float y = a * ty + b * ny + c * (tz * nx - tx * nz);
        const float z = a * tz + b * nz + c * (tx * ny - ty * nx);
        const float m = block.magnitude[k];
        block.displacement[0][k + 1] = x;
        block.displacement[1][k + 1] = y;
        block.displacement[2][k + 1] = z;
        block.position[0][k + 1] = samples.start[0][k + 1] + (samples.offset[0][k + 1] + m * x);
        block.position[1][k + 1] = samples.start[1][k + 1] + (samples.offset[1][k + 1] + m * y);
        block.position[2][k + 1] = samples.start[2][k + 1] + (samples.offset[2][k + 1] + m * z);
    }
}

// How many coordinates of the samples are larger than they may be, or no numbers.
uint32_t count_too_large(const DisplacedBlock& block, uint32_t count) {
    constexpr float coordinate_max = 1e30f;
    uint32_t found = 0;
    for (int c = 0; c < 3; ++c) {
        const float* position = block.position[c] + 1;
        for (uint32_t k = 0; k < count; ++k) found += !(__builtin_fabsf(position[k]) <= coordinate_max) ? 1u : 0u;
    }
    return found;
}

// Sine and cosine by their series, of what is left of the angle when quarters of a turn are taken off.
void turn(const DisplacedBlock& __restrict block, SampleBlock& __restrict samples) {
    constexpr double quarters_per_rad = 0.63661977236758134, quarter_rad = 1.5707963267948966;
    constexpr double to_whole = 6755399441055744.0;  // 1.5 * 2^52: what is added to it is rounded
    const uint32_t count = whole_registers(samples.count);
    for (uint32_t k = 0; k < count; ++k) {
        const double angle = block.turn_rad[k];
        const double quarters = (angle * quarters_per_rad + to_whole) - to_whole;
        const double turns = (0.25 * quarters + to_whole) - to_whole;
        const auto quadrant = static_cast<float>(quarters - 4.0 * turns);  // -2 to 2
        float r = static_cast<float>(angle - quarters * quarter_rad);
        r = r > -1.0f ? r : -1.0f;  // of angles without end, of which nothing is left
        r = r < 1.0f ? r : 1.0f;
        const float q = r * r;
        const float s = r * (1 + q * (-1.0f / 6 + q * (1.0f / 120 + q * (-1.0f / 5040 + q * (1.0f / 362880)))));
        const float c = 1 + q * (-1.0f / 2 + q * (1.0f / 24 + q * (-1.0f / 720 + q * (1.0f / 40320))));
        const float odd = quadrant * quadrant == 1.0f ? 1.0f : 0.0f;
        const float half = quadrant * quadrant == 4.0f ? -1.0f : 1.0f;
        const float sine = odd * quadrant * c + (1 - odd) * half * s;
        const float cosine = -odd * quadrant * s + (1 - odd) * half * c;
        const float tx = samples.tangent[0][k + 1], ty = samples.tangent[1][k + 1], tz = samples.tangent[2][k + 1];
        const float nx = samples.normal[0][k + 1], ny = samples.normal[1][k + 1], nz = samples.normal[2][k + 1];
        samples.normal[0][k + 1] = cosine * nx + sine * (ty * nz - tz * ny);
        samples.normal[1][k + 1] = cosine * ny + sine * (tz * nx - tx * nz);
        samples.normal[2][k + 1] = cosine * nz + sine * (tx * ny - ty * nx);
    }
}
