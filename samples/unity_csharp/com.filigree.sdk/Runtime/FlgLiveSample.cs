// SPDX-License-Identifier: MIT
// Samples by value: fixed buffers have no initializers.
namespace Filigree
{
    public unsafe partial struct FlgLiveSample
    {
        /// <summary>A sample of a device that knows no orientation, such as a mouse or a pen.</summary>
        public FlgLiveSample(float x, float y, float z, float pressure, double time) : this()
        {
            fixed (float* to = position)
            {
                to[0] = x;
                to[1] = y;
                to[2] = z;
            }
            this.pressure = pressure;
            this.time = time;
        }

        /// <summary>The same sample with the controller's orientation: a quaternion of any length.</summary>
        public FlgLiveSample Oriented(float x, float y, float z, float w)
        {
            FlgLiveSample sample = this;
            sample.orientation[0] = x;
            sample.orientation[1] = y;
            sample.orientation[2] = z;
            sample.orientation[3] = w;
            return sample;
        }
    }
}
