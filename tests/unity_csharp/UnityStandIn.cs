// SPDX-License-Identifier: MIT
// As much of Unity's API, with its signatures of 2021.3, as the sample uses, so that its sources compile and run here
// as they are. A Mesh keeps what was uploaded to it.
using System;

namespace AOT
{
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        public MonoPInvokeCallbackAttribute(Type type) { }
    }
}

namespace UnityEngine
{
    [AttributeUsage(AttributeTargets.Class)]
    public sealed class RequireComponent : Attribute
    {
        public RequireComponent(Type first, Type second) { }
    }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class DefaultExecutionOrder : Attribute
    {
        public DefaultExecutionOrder(int order) { }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class TooltipAttribute : Attribute
    {
        public TooltipAttribute(string tooltip) { }
    }

    public struct Vector3
    {
        public float x, y, z;

        public Vector3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);
        public static Vector3 operator *(Vector3 a, float b) => new Vector3(a.x * b, a.y * b, a.z * b);
        public static float Dot(Vector3 a, Vector3 b) => a.x * b.x + a.y * b.y + a.z * b.z;

        public static Vector3 Cross(Vector3 a, Vector3 b)
        {
            return new Vector3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
        }
    }

    public struct Quaternion
    {
        public float x, y, z, w;

        public Quaternion(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        public static Quaternion identity => new Quaternion(0, 0, 0, 1);
        public static Quaternion Inverse(Quaternion q) => new Quaternion(-q.x, -q.y, -q.z, q.w);

        public static Quaternion operator *(Quaternion a, Quaternion b)
        {
            return new Quaternion(
                a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
                a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z);
        }

        public static Vector3 operator *(Quaternion q, Vector3 v)
        {
            var axis = new Vector3(q.x, q.y, q.z);
            Vector3 t = Vector3.Cross(axis, v) * 2;
            return v + t * q.w + Vector3.Cross(axis, t);
        }
    }

    public struct Bounds
    {
        public Vector3 min, max;

        public Bounds(Vector3 center, Vector3 size)
        {
            min = center - size * 0.5f;
            max = center + size * 0.5f;
        }

        public void Encapsulate(Bounds other)
        {
            min = new Vector3(Math.Min(min.x, other.min.x), Math.Min(min.y, other.min.y), Math.Min(min.z, other.min.z));
            max = new Vector3(Math.Max(max.x, other.max.x), Math.Max(max.y, other.max.y), Math.Max(max.z, other.max.z));
        }
    }

    public static class Time
    {
        public static double timeAsDouble { get; set; }
    }

    public static class Debug
    {
        public static void Log(object message) { }
        public static void LogWarning(object message) { }
        public static void LogError(object message) { }
    }

    public class Object
    {
        public string name { get; set; }
        public bool Destroyed { get; private set; }
        public static void Destroy(Object it) { it.Destroyed = true; }
    }

    public class Transform : Object
    {
        public Vector3 position { get; set; }
        public Quaternion rotation { get; set; } = Quaternion.identity;

        /// <summary>Of transforms that are not scaled.</summary>
        public Vector3 InverseTransformPoint(Vector3 place) => Quaternion.Inverse(rotation) * (place - position);
    }

    public class MonoBehaviour : Object
    {
        readonly MeshFilter filter = new MeshFilter();
        public Transform transform { get; } = new Transform();
        public T GetComponent<T>() where T : class => filter as T;
    }

    public class MeshFilter : Object
    {
        public Mesh sharedMesh { get; set; }
    }

    public class MeshRenderer : Object { }
}
