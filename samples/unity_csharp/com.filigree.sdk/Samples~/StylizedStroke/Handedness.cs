// SPDX-License-Identifier: MIT
// Unity is left-handed, the SDK right-handed; both have y up and measure in metres. The z axis is turned around.
using UnityEngine;

namespace Filigree.Samples
{
    /// <summary>Each of these is its own inverse.</summary>
    static class Handedness
    {
        internal static Vector3 Turn(Vector3 place)
        {
            return new Vector3(place.x, place.y, -place.z);
        }

        internal static Quaternion Turn(Quaternion rotation)
        {
            return new Quaternion(-rotation.x, -rotation.y, rotation.z, rotation.w);
        }

        internal static LiveSample Sample(Vector3 place, Quaternion rotation, float pressure, double time)
        {
            Vector3 p = Turn(place);
            Quaternion q = Turn(rotation);
            return new LiveSample(p.x, p.y, p.z, pressure, time).Oriented(q.x, q.y, q.z, q.w);
        }

        /// <summary>Points as the SDK takes them.</summary>
        internal static float[] Numbers(Vector3[] places)
        {
            var numbers = new float[3 * places.Length];
            for (int i = 0; i < places.Length; ++i)
            {
                Vector3 p = Turn(places[i]);
                numbers[3 * i] = p.x;
                numbers[3 * i + 1] = p.y;
                numbers[3 * i + 2] = p.z;
            }
            return numbers;
        }
    }
}
