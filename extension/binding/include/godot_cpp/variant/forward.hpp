// SPDX-License-Identifier: MIT
// The names of all builtin types.
#pragma once

namespace godot {

class Variant;
class Object;
class ObjectID;
class String;
class StringName;
class NodePath;
class RID;
class Callable;
class Signal;
class Dictionary;
class Array;
class PackedByteArray;
class PackedInt32Array;
class PackedInt64Array;
class PackedFloat32Array;
class PackedFloat64Array;
class PackedStringArray;
class PackedVector2Array;
class PackedVector3Array;
class PackedColorArray;
class PackedVector4Array;
struct Vector2;
struct Vector2i;
struct Rect2;
struct Rect2i;
struct Vector3;
struct Vector4;
struct Plane;
struct Quaternion;
struct AABB;
struct Basis;
struct Transform3D;
struct Projection;
struct Color;

} // namespace godot
