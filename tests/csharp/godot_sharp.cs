// SPDX-License-Identifier: MIT
// The part of GodotSharp that the wrappers use, with the signatures that Godot 4.6 gives it, over objects that only remember what they were
// asked: GodotSharp itself is in no package source that the tests reach. Engine classes that stand in the class reference are added by
// tools/test/csharp_tests.py.
namespace Godot
{
    using System;
    using System.Collections.Generic;
    using System.Linq;

    public struct Vector2 { public float X, Y; public Vector2(float x, float y) { X = x; Y = y; } }
    public struct Vector2I { public int X, Y; public Vector2I(int x, int y) { X = x; Y = y; } }
    public struct Vector3 { public float X, Y, Z; public static Vector3 Zero => default(Vector3); public Vector3(float x, float y, float z) { X = x; Y = y; Z = z; } }
    public struct Rect2 { public Vector2 Position, Size; }
    public struct Aabb { public Vector3 Position, Size; }
    public struct Color { public float R, G, B, A; }
    public struct Transform3D { public bool IsIdentity; public static Transform3D Identity => new Transform3D { IsIdentity = true }; }

    public sealed class StringName
    {
        private readonly string _text;
        public StringName(string text) { _text = text; }
        public static implicit operator StringName(string text) => new StringName(text);
        public static implicit operator string(StringName name) => name?.ToString();
        public override string ToString() => _text;
    }

    public sealed class NodePath
    {
        private readonly string _text;
        public NodePath(string text) { _text = text; }
        public static implicit operator NodePath(string text) => new NodePath(text);
        public static implicit operator string(NodePath path) => path?.ToString();
        public override string ToString() => _text;
    }

    // Equal only to itself, as a lambda's is.
    public struct Callable
    {
        internal Action<Variant[]> Run;
        public static Callable From(Action action) => new Callable { Run = _ => action() };
        public static Callable From<T0>(Action<T0> action) => new Callable { Run = a => action(a[0].As<T0>()) };
        public static Callable From<T0, T1>(Action<T0, T1> action) => new Callable { Run = a => action(a[0].As<T0>(), a[1].As<T1>()) };
        public static Callable From<T0, T1, T2>(Action<T0, T1, T2> action) =>
            new Callable { Run = a => action(a[0].As<T0>(), a[1].As<T1>(), a[2].As<T2>()) };
    }

    public struct Variant
    {
        internal object Value;
        private static Variant Of(object value) => new Variant { Value = value };
        public T As<T>() => Value == null ? default(T) : (T)Value;
        public bool AsBool() => As<bool>();
        public int AsInt32() => (int)AsInt64();
        public uint AsUInt32() => (uint)AsInt64();
        public long AsInt64() => Convert.ToInt64(Value);
        public float AsSingle() => Convert.ToSingle(Value);
        public string AsString() => As<string>();
        public StringName AsStringName() => As<StringName>();
        public NodePath AsNodePath() => As<NodePath>();
        public Vector2 AsVector2() => As<Vector2>();
        public Vector2I AsVector2I() => As<Vector2I>();
        public Vector3 AsVector3() => As<Vector3>();
        public Rect2 AsRect2() => As<Rect2>();
        public Aabb AsAabb() => As<Aabb>();
        public Transform3D AsTransform3D() => As<Transform3D>();
        public Color AsColor() => As<Color>();
        public Callable AsCallable() => As<Callable>();
        public GodotObject AsGodotObject() => As<GodotObject>();
        public Collections.Dictionary AsGodotDictionary() => As<Collections.Dictionary>();
        public Collections.Array AsGodotArray() => As<Collections.Array>() ?? new Collections.Array();
        public Collections.Array<T> AsGodotArray<T>() => As<Collections.Array<T>>();
        public byte[] AsByteArray() => As<byte[]>();
        public int[] AsInt32Array() => As<int[]>();
        public long[] AsInt64Array() => As<long[]>();
        public float[] AsFloat32Array() => As<float[]>();
        public string[] AsStringArray() => As<string[]>();
        public Vector2[] AsVector2Array() => As<Vector2[]>();
        public Vector3[] AsVector3Array() => As<Vector3[]>();
        public Color[] AsColorArray() => As<Color[]>();
        public static implicit operator Variant(bool from) => Of(from);
        public static implicit operator Variant(int from) => Of((long)from);
        public static implicit operator Variant(uint from) => Of((long)from);
        public static implicit operator Variant(long from) => Of(from);
        public static implicit operator Variant(float from) => Of(from);
        public static implicit operator Variant(double from) => Of(from);
        public static implicit operator Variant(string from) => Of(from);
        public static implicit operator Variant(StringName from) => Of(from);
        public static implicit operator Variant(NodePath from) => Of(from);
        public static implicit operator Variant(Vector2 from) => Of(from);
        public static implicit operator Variant(Vector2I from) => Of(from);
        public static implicit operator Variant(Vector3 from) => Of(from);
        public static implicit operator Variant(Rect2 from) => Of(from);
        public static implicit operator Variant(Aabb from) => Of(from);
        public static implicit operator Variant(Transform3D from) => Of(from);
        public static implicit operator Variant(Color from) => Of(from);
        public static implicit operator Variant(Callable from) => Of(from);
        public static implicit operator Variant(GodotObject from) => Of(from);
        public static implicit operator Variant(Collections.Dictionary from) => Of(from);
        public static implicit operator Variant(Collections.Array from) => Of(from);
        public static implicit operator Variant(byte[] from) => Of(from);
        public static implicit operator Variant(int[] from) => Of(from);
        public static implicit operator Variant(long[] from) => Of(from);
        public static implicit operator Variant(float[] from) => Of(from);
        public static implicit operator Variant(string[] from) => Of(from);
        public static implicit operator Variant(Vector2[] from) => Of(from);
        public static implicit operator Variant(Vector3[] from) => Of(from);
        public static implicit operator Variant(Color[] from) => Of(from);
    }

    public partial class GodotObject
    {
        internal string Native; // the class of the object in the engine, which C# may not know
        internal readonly List<string> Called = new List<string>();
        internal readonly Dictionary<string, Variant> Values = new Dictionary<string, Variant>(); // properties, and what methods answer
        internal readonly List<KeyValuePair<string, Callable>> Connected = new List<KeyValuePair<string, Callable>>();
        internal Variant[] Arguments = { };
        internal bool IsFreed;
        public static bool IsInstanceValid(GodotObject instance) => instance != null && !instance.IsFreed;
        public string GetClass() => Native ?? GetType().Name;
        public bool IsClass(string @class) => GetClass() == @class;
        public Variant Get(StringName property) => Values.TryGetValue(property, out Variant value) ? value : default(Variant);
        public void Set(StringName property, Variant value) => Values[property] = value;
        public Variant Call(StringName method, params Variant[] args)
        {
            Called.Add(method);
            Arguments = args;
            return Get(method);
        }
        public void Connect(StringName signal, Callable callable, uint flags = 0) =>
            Connected.Add(new KeyValuePair<string, Callable>(signal, callable));
        public void Disconnect(StringName signal, Callable callable)
        {
            if (Connected.RemoveAll(one => one.Key == signal && one.Value.Run == callable.Run) != 1)
            {
                throw new InvalidOperationException("Disconnecting what is not connected");
            }
        }
        internal void Emit(string signal, params Variant[] args)
        {
            foreach (KeyValuePair<string, Callable> one in Connected.Where(one => one.Key == signal).ToList())
            {
                one.Value.Run(args);
            }
        }
    }

    public partial class Node
    {
        internal readonly List<Node> Children = new List<Node>();
        internal static readonly Dictionary<string, Node> Paths = new Dictionary<string, Node>();
        public enum InternalMode { Disabled }
        public void AddChild(Node node, bool forceReadableName = false, InternalMode @internal = InternalMode.Disabled) => Children.Add(node);
        public T GetNode<T>(NodePath path) where T : class => (T)(object)Paths[path];
        public virtual void _Ready() { }
    }

    public static class GD
    {
        internal static readonly List<string> Printed = new List<string>();
        public static T Load<T>(string path) where T : class, new() => new T();
        public static void Print(params object[] what) => Printed.Add(string.Concat(what));
    }

    public static class ClassDB
    {
        internal static Func<string, GodotObject> Maker; // null for a class that is not there
        internal static readonly List<string> Called = new List<string>();
        public static bool ClassExists(StringName @class) => Maker(@class) != null;
        public static Variant Instantiate(StringName @class) => Maker(@class);
        public static Variant ClassCallStatic(StringName @class, StringName method, params Variant[] args)
        {
            Called.Add(@class + "." + method);
            return "static";
        }
    }
}

namespace Godot.Collections
{
    using System.Collections.Generic;

    public class Dictionary : Dictionary<Variant, Variant> { }
    public class Array : List<Variant> { }
    public class Array<T> : List<T>
    {
        public static implicit operator Variant(Array<T> from) => new Variant { Value = from };
    }
}
