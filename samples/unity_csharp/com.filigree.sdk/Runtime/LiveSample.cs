// SPDX-License-Identifier: MIT
// What the hand did at one time. Samples are read in place.
namespace Filigree
{
    public unsafe struct LiveSample
    {
        public fixed float position[3];
        public fixed float orientation[4];
        public float pressure;
        public double time;

        /// <summary>A sample of a device that knows no orientation, such as a mouse or a pen.</summary>
        public LiveSample(float x, float y, float z, float pressure, double time) : this()
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
        public LiveSample Oriented(float x, float y, float z, float w)
        {
            LiveSample sample = this;
            sample.orientation[0] = x;
            sample.orientation[1] = y;
            sample.orientation[2] = z;
            sample.orientation[3] = w;
            return sample;
        }
    }
}
