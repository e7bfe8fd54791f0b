// SPDX-License-Identifier: MIT
// One bound method of the extension: everything the engine asks about it, and the two ways it calls it.
#pragma once

#include <godot_cpp/core/object.hpp>

#include <vector>

namespace godot::internal {

class MethodBind {
public:
	virtual ~MethodBind() = default;

	StringName name;
	StringName class_name;
	uint32_t flags = GDEXTENSION_METHOD_FLAGS_DEFAULT;
	bool has_result = false;
	PropertyInfo result;
	GDExtensionClassMethodArgumentMetadata result_metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	std::vector<PropertyInfo> arguments;
	std::vector<GDExtensionClassMethodArgumentMetadata> argument_metadata;
	std::vector<Variant> defaults; // of the last arguments

	// With Variants, of which the last may be left to their defaults.
	void call(void *p_instance, const Variant *const *p_arguments, int64_t p_count, Variant &r_result, GDExtensionCallError &r_error) const;
	virtual void call_complete(
			void *p_instance, const Variant *const *p_arguments, Variant &r_result, GDExtensionCallError &r_error) const = 0;
	virtual void call_pointers(void *p_instance, const GDExtensionConstTypePtr *p_arguments, void *r_result) const = 0;

	static constexpr int MAX_ARGUMENTS = 16;

protected:
	template <typename T> void add_argument() {
		arguments.push_back(GetTypeInfo<T>::get_class_info());
		argument_metadata.push_back(GetTypeInfo<T>::METADATA);
	}
};

// T: the class it is bound for, which may inherit the method.
template <typename T, typename F> class MethodBindOf : public MethodBind {
	using Traits = FunctionTraits<F>;
	using Indices = std::make_index_sequence<parameter_count<F>>;
	static_assert(parameter_count<F> <= MAX_ARGUMENTS);

public:
	explicit MethodBindOf(F p_function) : _function(p_function) {
		describe(Indices{});
		if constexpr (!std::is_void_v<typename Traits::Result>) {
			has_result = true;
			result = GetTypeInfo<typename Traits::Result>::get_class_info();
			result_metadata = GetTypeInfo<typename Traits::Result>::METADATA;
		}
		if (Traits::CONST) {
			flags |= GDEXTENSION_METHOD_FLAG_CONST;
		}
		if (std::is_void_v<typename Traits::Class>) {
			flags = GDEXTENSION_METHOD_FLAG_STATIC;
		}
	}

	void call_complete(
			void *p_instance, const Variant *const *p_arguments, Variant &r_result, GDExtensionCallError &r_error) const override {
		call_with_variants(instance(p_instance), _function, p_arguments, r_result, r_error, Indices{});
	}
	void call_pointers(void *p_instance, const GDExtensionConstTypePtr *p_arguments, void *r_result) const override {
		call_with_pointers(instance(p_instance), _function, p_arguments, r_result, Indices{});
	}

private:
	F _function;

	template <size_t... I> void describe(std::index_sequence<I...>) { (add_argument<Parameter<F, I>>(), ...); }
	static typename Traits::Class *instance(void *p_instance) { return reinterpret_cast<typename Traits::Class *>(p_instance); }
};

} // namespace godot::internal
