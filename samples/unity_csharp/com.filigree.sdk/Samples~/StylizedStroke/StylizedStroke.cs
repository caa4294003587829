// SPDX-License-Identifier: MIT
// A stroke that a hand draws, stylized while it is drawn. Set Drawing while the trigger is held. No frame makes
// garbage: not the one that pushes a sample, nor the one that shows its points.
using UnityEngine;

namespace Filigree.Samples
{
    [RequireComponent(typeof(MeshFilter), typeof(MeshRenderer))]
    public sealed class StylizedStroke : MonoBehaviour
    {
        public FiligreeRunner runner;

        [Tooltip("What draws: a controller, or an object that the mouse moves.")]
        public Transform hand;

        [Tooltip("The example: one stroke in the style that is wanted, at its real size, in metres.")]
        public Vector3[] example;

        [Tooltip("0 copies long runs of the example, 1 a dozen points at a time, 10 hardly any two in a row.")]
        public float temperature;

        public float magnitude = 1;
        public float radiusMin = 0.001f;
        public float radiusMax = 0.005f;
        public int maxPoints = 16384;
        public int sides = 8;

        /// <summary>True while the stroke goes on. Setting it again begins another, in place of this one.</summary>
        public bool Drawing { get; set; }

        /// <summary>Of the trigger, 0 to 1.</summary>
        public float Pressure { get; set; } = 1;

        /// <summary>The stroke, once it is over: to keep, to stylize again. Null before.</summary>
        public CurveSet Finished { get; private set; }

        Style style;
        LiveStroke stroke;
        CurveSet ending;
        StrokeMesh mesh;
        float warmTemperature;

        void Awake()
        {
            mesh = new StrokeMesh(maxPoints, sides);
            GetComponent<MeshFilter>().sharedMesh = mesh.Mesh;
            using (CurveSet strokes = CurveSet.Create(runner.Context, Handedness.Numbers(example)))
            {
                style = Style.Create(strokes);
            }
            Warm();
        }

        void Update()
        {
            if (ending != null) ShowEnd();
            else if (Drawing) Draw();
            else if (stroke != null) End();
        }

        void OnDestroy()
        {
            Forget();
            if (style != null) style.Dispose();
            if (mesh != null) Destroy(mesh.Mesh);
        }

        void Draw()
        {
            if (stroke == null && !Begin()) return; // the style is still being prepared
            Vector3 place = transform.InverseTransformPoint(hand.position);
            Quaternion rotation = Quaternion.Inverse(transform.rotation) * hand.rotation;
            try
            {
                mesh.Append(stroke.Push(Handedness.Sample(place, rotation, Pressure, Time.timeAsDouble)), 0);
            }
            catch (FiligreeException failure) when (failure.Result == FlgResult.ErrorLimit)
            {
                Drawing = false; // the hand jumped, or the stroke is as long as it may become: it ends here
            }
        }

        bool Begin()
        {
            Forget();
            FlgLiveStrokeDesc desc = Native.flgLiveStrokeDefaults();
            desc.temperature = temperature;
            desc.magnitude = magnitude;
            desc.min_radius = radiusMin;
            desc.max_radius = radiusMax;
            desc.max_points = (uint)maxPoints;
            stroke = LiveStroke.TryBegin(style, desc);
            if (stroke == null)
            {
                if (temperature != warmTemperature) Warm(); // it was changed since
                return false;
            }
            mesh.Clear();
            return true;
        }

        void Warm()
        {
            style.Warm(temperature);
            warmTemperature = temperature;
        }

        // A stroke without a sample, begun and let go before it could be drawn, can't be ended.
        void End()
        {
            if (stroke.Info.sample_count > 0) ending = stroke.End();
            else Forget();
        }

        // The last points come with the job's result: where the curve ends is known only now.
        void ShowEnd()
        {
            if (!ending.IsReady) return;
            mesh.Append(ending.View, mesh.PointCount);
            Finished = ending;
            ending = null;
            stroke.Dispose();
            stroke = null;
        }

        void Forget()
        {
            if (stroke != null) stroke.Dispose();
            if (ending != null) ending.Dispose();
            if (Finished != null) Finished.Dispose();
            stroke = null;
            ending = null;
            Finished = null;
        }
    }
}
