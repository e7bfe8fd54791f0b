// SPDX-License-Identifier: MIT
// The engine's functions on builtin types, each looked up at its first call and then called straight.
#pragma once

#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

#include <atomic>

namespace godot::internal {

// One method of a builtin type.
struct BuiltinMethod {
	GDExtensionVariantType type;
	const char *name;
	int64_t hash;
	std::atomic<GDExtensionPtrBuiltInMethod> function = nullptr;

	void call(void *p_base, const GDExtensionConstTypePtr *p_arguments, void *r_result, int p_count) {
		GDExtensionPtrBuiltInMethod found = function.load(std::memory_order_acquire);
		(likely(found) ? found : find())(p_base, p_arguments, r_result, p_count);
	}
	GDExtensionPtrBuiltInMethod find();
};

// One operator between two builtin types.
struct BuiltinOperator {
	GDExtensionVariantOperator operation;
	GDExtensionVariantType left;
	GDExtensionVariantType right;
	std::atomic<GDExtensionPtrOperatorEvaluator> function = nullptr;

	void call(const void *p_left, const void *p_right, void *r_result) {
		GDExtensionPtrOperatorEvaluator found = function.load(std::memory_order_acquire);
		(likely(found) ? found : find())(p_left, p_right, r_result);
	}
	GDExtensionPtrOperatorEvaluator find();
};

// One global function.
struct UtilityFunction {
	const char *name;
	int64_t hash;
	std::atomic<GDExtensionPtrUtilityFunction> function = nullptr;

	void call(const GDExtensionConstTypePtr *p_arguments, void *r_result, int p_count) {
		GDExtensionPtrUtilityFunction found = function.load(std::memory_order_acquire);
		(likely(found) ? found : find())(r_result, p_arguments, p_count);
	}
	GDExtensionPtrUtilityFunction find();
};

// Constructors and the destructor of a builtin type with storage of its own; looked up by load_builtins().
constexpr int BUILTIN_CONSTRUCTORS = 13;
extern const int builtin_constructor_counts[GDEXTENSION_VARIANT_TYPE_VARIANT_MAX]; // generated
struct BuiltinType {
	GDExtensionPtrConstructor constructors[BUILTIN_CONSTRUCTORS];
	GDExtensionPtrDestructor destructor;
	GDExtensionVariantFromTypeConstructorFunc to_variant;
	GDExtensionTypeFromVariantConstructorFunc from_variant;
};
extern BuiltinType builtin_types[GDEXTENSION_VARIANT_TYPE_VARIANT_MAX];
void load_builtins();

// Storage of a builtin type, of WORDS pointers, that the engine makes, copies and destroys.
// An object's first constructors are always: 0 empty, 1 copy.
template <GDExtensionVariantType TYPE, int WORDS> class Opaque {
public:
	void *_native_ptr() const { return const_cast<void **>(_storage); }

protected:
	Opaque() { builtin_types[TYPE].constructors[0](_storage, nullptr); }
	Opaque(const Opaque &p_other) { construct(1, &p_other); }
	Opaque(Opaque &&p_other) noexcept : Opaque() { swap(p_other); }
	template <typename... Arguments> explicit Opaque(int p_constructor, const Arguments *...p_arguments) {
		construct(p_constructor, p_arguments...);
	}
	// Leaves the storage to be filled by whoever asks for it.
	enum Uninitialized { UNINITIALIZED };
	explicit Opaque(Uninitialized) {}
	~Opaque() { builtin_types[TYPE].destructor(_storage); }

	Opaque &operator=(const Opaque &p_other) {
		if (this != &p_other) {
			builtin_types[TYPE].destructor(_storage);
			construct(1, &p_other);
		}
		return *this;
	}
	Opaque &operator=(Opaque &&p_other) noexcept {
		swap(p_other);
		return *this;
	}

	void *_storage[WORDS] = {};

private:
	template <typename... Arguments> void construct(int p_constructor, const Arguments *...p_arguments) {
		const GDExtensionConstTypePtr arguments[] = { p_arguments... };
		builtin_types[TYPE].constructors[p_constructor](_storage, arguments);
	}
	void swap(Opaque &p_other) {
		for (int i = 0; i < WORDS; i++) {
			std::swap(_storage[i], p_other._storage[i]);
		}
	}
};

} // namespace godot::internal
