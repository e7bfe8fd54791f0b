// SPDX-License-Identifier: MIT
#include <godot_cpp/variant/variant.hpp>

#include <godot_cpp/core/object.hpp>

namespace godot {

namespace engine = gdextension_interface;

namespace {

// Converts to a Variant. The engine's conversion functions take no const, though they change nothing.
void to_variant(GDExtensionVariantType p_type, void *r_variant, const void *p_value) {
	internal::builtin_types[p_type].to_variant(r_variant, const_cast<void *>(p_value));
}

void from_variant(GDExtensionVariantType p_type, void *r_value, const Variant *p_variant) {
	internal::builtin_types[p_type].from_variant(r_value, p_variant->_native_ptr());
}

} // namespace

const Variant *internal::variant_at(const Variant *p_values, size_t p_index) {
	return p_values + p_index;
}

Variant::Variant() {
	engine::variant_new_nil(_storage);
}
Variant::Variant(const Variant &p_other) {
	engine::variant_new_copy(_storage, p_other._storage);
}
Variant::Variant(Variant &&p_other) noexcept : Variant() {
	std::swap(_storage, p_other._storage);
}
Variant::~Variant() {
	engine::variant_destroy(_storage);
}

Variant &Variant::operator=(const Variant &p_other) {
	if (this != &p_other) {
		engine::variant_destroy(_storage);
		engine::variant_new_copy(_storage, p_other._storage);
	}
	return *this;
}
Variant &Variant::operator=(Variant &&p_other) noexcept {
	std::swap(_storage, p_other._storage);
	return *this;
}

Variant::Variant(bool p_value) {
	const GDExtensionBool value = p_value;
	to_variant(GDEXTENSION_VARIANT_TYPE_BOOL, _storage, &value);
}
Variant::Variant(int64_t p_value) {
	to_variant(GDEXTENSION_VARIANT_TYPE_INT, _storage, &p_value);
}
Variant::Variant(double p_value) {
	to_variant(GDEXTENSION_VARIANT_TYPE_FLOAT, _storage, &p_value);
}
Variant::Variant(const Object *p_value) {
	GodotObject *const owner = p_value ? p_value->_owner : nullptr;
	to_variant(GDEXTENSION_VARIANT_TYPE_OBJECT, _storage, &owner);
}

Variant::operator bool() const {
	return booleanize();
}
Variant::operator int64_t() const {
	int64_t value = 0;
	from_variant(GDEXTENSION_VARIANT_TYPE_INT, &value, this);
	return value;
}
Variant::operator double() const {
	double value = 0;
	from_variant(GDEXTENSION_VARIANT_TYPE_FLOAT, &value, this);
	return value;
}
Variant::operator ObjectID() const {
	return get_type() == INT ? ObjectID(operator uint64_t()) : ObjectID(uint64_t(engine::variant_get_object_instance_id(_storage)));
}

// The conversion writes to raw storage: a value that was made before is destroyed without being told, which is
// harmless only for those that own nothing; so it goes to bytes and is moved from there.
#define GODOT_VARIANT_BUILTIN(m_type)                                                                                                      \
	Variant::Variant(const m_type &p_value) {                                                                                              \
		to_variant(internal::type_code<m_type>, _storage, &p_value);                                                                       \
	}                                                                                                                                      \
	Variant::operator m_type() const {                                                                                                     \
		alignas(m_type) unsigned char bytes[sizeof(m_type)];                                                                               \
		from_variant(internal::type_code<m_type>, bytes, this);                                                                            \
		m_type *const made = reinterpret_cast<m_type *>(bytes);                                                                            \
		m_type value = std::move(*made);                                                                                                   \
		std::destroy_at(made);                                                                                                             \
		return value;                                                                                                                      \
	}
#include <godot_cpp/variant/variant_builtins.inc>
#undef GODOT_VARIANT_BUILTIN

Object *Variant::get_validated_object() const {
	return get_type() == OBJECT ? ObjectDB::get_instance(engine::variant_get_object_instance_id(_storage)) : nullptr;
}

Variant::Type Variant::get_type() const {
	return static_cast<Type>(engine::variant_get_type(_storage));
}
String Variant::get_type_name(Type p_type) {
	String name;
	internal::builtin_types[STRING].destructor(name._native_ptr());
	engine::variant_get_type_name(static_cast<GDExtensionVariantType>(p_type), name._native_ptr());
	return name;
}

bool Variant::operator==(const Variant &p_other) const {
	Variant result;
	bool valid = false;
	evaluate(OP_EQUAL, *this, p_other, result, valid);
	return valid && result.booleanize();
}
bool Variant::operator<(const Variant &p_other) const {
	Variant result;
	bool valid = false;
	evaluate(OP_LESS, *this, p_other, result, valid);
	return valid && result.booleanize();
}
void Variant::evaluate(const Operator &p_operator, const Variant &p_a, const Variant &p_b, Variant &r_result, bool &r_valid) {
	GDExtensionBool valid = false;
	r_result.clear();
	engine::variant_evaluate(static_cast<GDExtensionVariantOperator>(p_operator), p_a._storage, p_b._storage, r_result._storage, &valid);
	r_valid = valid;
}

void Variant::callp(
		const StringName &p_method, const Variant **p_arguments, int p_count, Variant &r_result, GDExtensionCallError &r_error) {
	r_result.clear();
	engine::variant_call(_storage, p_method._native_ptr(), reinterpret_cast<const GDExtensionConstVariantPtr *>(p_arguments), p_count,
			r_result._storage, &r_error);
}

void Variant::set(const Variant &p_key, const Variant &p_value, bool *r_valid) {
	GDExtensionBool valid = false;
	engine::variant_set(_storage, p_key._storage, p_value._storage, &valid);
	if (r_valid) {
		*r_valid = valid;
	}
}
Variant Variant::get(const Variant &p_key, bool *r_valid) const {
	Variant result;
	GDExtensionBool valid = false;
	engine::variant_get(_storage, p_key._storage, result._storage, &valid);
	if (r_valid) {
		*r_valid = valid;
	}
	return result;
}
bool Variant::has_method(const StringName &p_method) const {
	return engine::variant_has_method(_storage, p_method._native_ptr());
}

uint32_t Variant::hash() const {
	return static_cast<uint32_t>(engine::variant_hash(_storage));
}
bool Variant::booleanize() const {
	return engine::variant_booleanize(_storage);
}
String Variant::stringify() const {
	String text;
	engine::variant_stringify(_storage, text._native_ptr());
	return text;
}
Variant Variant::duplicate(bool p_deep) const {
	Variant copy;
	engine::variant_duplicate(_storage, copy._storage, p_deep);
	return copy;
}
void Variant::clear() {
	engine::variant_destroy(_storage);
	engine::variant_new_nil(_storage);
}

#define GODOT_TEXT(m_type)                                                                                                                 \
	m_type::operator String() const {                                                                                                      \
		return Variant(*this).stringify();                                                                                                 \
	}
GODOT_TEXT(Vector2)
GODOT_TEXT(Vector2i)
GODOT_TEXT(Rect2)
GODOT_TEXT(Rect2i)
GODOT_TEXT(Vector3)
GODOT_TEXT(Vector4)
GODOT_TEXT(Plane)
GODOT_TEXT(Quaternion)
GODOT_TEXT(AABB)
GODOT_TEXT(Basis)
GODOT_TEXT(Transform3D)
GODOT_TEXT(Projection)
GODOT_TEXT(Color)
#undef GODOT_TEXT

// Converts by the curve that the engine's renderer takes for that of sRGB.
Color Color::srgb_to_linear() const {
	const auto linear = [](float p_x) {
		return p_x < 0.04045f ? p_x * (1.0f / 12.92f) : std::pow(static_cast<float>((p_x + 0.055) * (1.0 / 1.055)), 2.4f);
	};
	return Color(linear(r), linear(g), linear(b), a);
}

Color Color::linear_to_srgb() const {
	const auto curved = [](float p_x) {
		return p_x < 0.0031308f ? 12.92f * p_x : static_cast<float>(1.0 + 0.055) * std::pow(p_x, 1.0f / 2.4f) - 0.055f;
	};
	return Color(curved(r), curved(g), curved(b), a);
}

String Color::to_html(bool p_alpha) const {
	const auto byte = [](float p_x) { return static_cast<int64_t>(std::round(CLAMP(p_x, 0.0f, 1.0f) * 255.0f)); };
	const String text = vformat("%02x%02x%02x", byte(r), byte(g), byte(b));
	return p_alpha ? text + vformat("%02x", byte(a)) : text;
}

} // namespace godot
