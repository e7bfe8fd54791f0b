// SPDX-License-Identifier: MIT
// Lists, and the methods and operators of builtin types.
#include "host.h"

namespace host {

namespace {

// Lists of text: a pointer to a vector that is never changed once it is made, then nothing.
using Texts = const std::vector<Text> *;

void split(GDExtensionTypePtr p_text, const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result, int32_t) {
	const std::string text = string_text(p_text), between = string_text(p_arguments[0]);
	auto *parts = new std::vector<Text>;
	size_t begin = 0;
	for (size_t end = text.find(between); end != std::string::npos; end = text.find(between, begin)) {
		parts->push_back(make_text(utf32(text.substr(begin, end - begin))));
		begin = end + between.size();
	}
	parts->push_back(make_text(utf32(text.substr(begin))));
	*static_cast<Texts *>(r_result) = parts;
}

template <class List> void count(GDExtensionTypePtr p_list, const GDExtensionConstTypePtr *, GDExtensionTypePtr r_result, int32_t) {
	const List list = *static_cast<const List *>(p_list);
	*static_cast<int64_t *>(r_result) = list ? int64_t(list->size()) : 0;
}

template <class List> void is_empty(GDExtensionTypePtr p_list, const GDExtensionConstTypePtr *, GDExtensionTypePtr r_result, int32_t) {
	const List list = *static_cast<const List *>(p_list);
	*static_cast<GDExtensionBool *>(r_result) = !list || list->empty();
}

GDExtensionStringPtr text_at(GDExtensionConstTypePtr p_texts, GDExtensionInt p_index) {
	return const_cast<Text *>(&(**static_cast<const Texts *>(p_texts))[size_t(p_index)]);
}

// Bytes: a pointer to them, made when there are any.
using Bytes = std::vector<uint8_t> *;

void resize_bytes(GDExtensionTypePtr p_bytes, const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result, int32_t) {
	Bytes &bytes = *static_cast<Bytes *>(p_bytes);
	bytes = bytes ? new std::vector<uint8_t>(*bytes) : new std::vector<uint8_t>;
	bytes->resize(size_t(*static_cast<const int64_t *>(p_arguments[0])));
	*static_cast<int64_t *>(r_result) = 0; // no error
}

uint8_t *byte_at(GDExtensionTypePtr p_bytes, GDExtensionInt p_index) {
	return &(**static_cast<Bytes *>(p_bytes))[size_t(p_index)];
}

void resize_vectors(GDExtensionTypePtr p_vectors, const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result, int32_t) {
	Vectors &vectors = *static_cast<Vectors *>(p_vectors);
	vectors = vectors ? new std::vector<Vector3>(*vectors) : new std::vector<Vector3>;
	vectors->resize(size_t(*static_cast<const int64_t *>(p_arguments[0])));
	*static_cast<int64_t *>(r_result) = 0; // no error
}

GDExtensionTypePtr vector_at(GDExtensionTypePtr p_vectors, GDExtensionInt p_index) {
	return &(**static_cast<Vectors *>(p_vectors))[size_t(p_index)];
}

GDExtensionTypePtr read_vector_at(GDExtensionConstTypePtr p_vectors, GDExtensionInt p_index) {
	return vector_at(const_cast<GDExtensionTypePtr>(p_vectors), p_index);
}

// An array: a pointer to its elements, made when it gets any; copies of it share them.
using Elements = std::vector<Variant> *;

void resize_array(GDExtensionTypePtr p_array, const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result, int32_t) {
	Elements &elements = *static_cast<Elements *>(p_array);
	elements = elements ? elements : new std::vector<Variant>;
	elements->resize(size_t(*static_cast<const int64_t *>(p_arguments[0])));
	*static_cast<int64_t *>(r_result) = 0; // no error
}

GDExtensionVariantPtr element_at(GDExtensionTypePtr p_array, GDExtensionInt p_index) {
	return &(**static_cast<Elements *>(p_array))[size_t(p_index)];
}

// Dictionaries keep nothing: what a library writes into one describes a setting to the editor.
GDExtensionVariantPtr forget(GDExtensionTypePtr, GDExtensionConstVariantPtr) {
	static Variant last;
	return &last;
}

// `text % values`: each %s, %d and so on becomes the value, however many digits it was to have.
void format(GDExtensionVariantOperator p_operator, GDExtensionConstVariantPtr p_text, GDExtensionConstVariantPtr p_values,
		GDExtensionUninitializedVariantPtr r_result, GDExtensionBool *r_valid) {
	const Variant &text = *static_cast<const Variant *>(p_text), &values = *static_cast<const Variant *>(p_values);
	if (p_operator != GDEXTENSION_VARIANT_OP_MODULE || text.type != GDEXTENSION_VARIANT_TYPE_STRING ||
			values.type != GDEXTENSION_VARIANT_TYPE_ARRAY) {
		lack("operator " + std::to_string(p_operator) + " of variants");
	}
	const std::string from = string_text(value_of(text));
	std::string made;
	int64_t next = 0;
	for (size_t i = 0; i < from.size(); i++) {
		if (from[i] != '%') {
			made += from[i];
		} else if (from[i + 1] == '%') {
			made += from[i++];
		} else {
			i = from.find_first_of("sdfcxov", i);
			const Variant &value = *static_cast<Variant *>(element_at(const_cast<void *>(value_of(values)), next++));
			made += value.type == GDEXTENSION_VARIANT_TYPE_STRING ? string_text(value_of(value)) : print(value);
		}
	}
	const Text result = make_text(utf32(made));
	set_value(*static_cast<Variant *>(r_result), GDEXTENSION_VARIANT_TYPE_STRING, &result);
	*r_valid = true;
}

// Methods of builtin types, as far as the library calls any before there is a scene.
GDExtensionPtrBuiltInMethod find_builtin(GDExtensionVariantType p_type, GDExtensionConstStringNamePtr p_name, GDExtensionInt) {
	static const std::map<std::string, GDExtensionPtrBuiltInMethod> methods{
		{ "String.is_empty", &is_empty<Text> },
		{ "String.split", &split },
		{ "Array.resize", &resize_array },
		{ "Array.size", &count<Elements> },
		{ "Array.is_empty", &is_empty<Elements> },
		{ "PackedByteArray.resize", &resize_bytes },
		{ "PackedByteArray.size", &count<Bytes> },
		{ "PackedByteArray.is_empty", &is_empty<Bytes> },
		{ "PackedVector3Array.resize", &resize_vectors },
		{ "PackedVector3Array.size", &count<Vectors> },
		{ "PackedVector3Array.is_empty", &is_empty<Vectors> },
		{ "PackedStringArray.size", &count<Texts> },
		{ "PackedStringArray.is_empty", &is_empty<Texts> },
	};
	const std::string name = std::string(TYPE_NAMES[p_type]) + "." + name_text(p_name);
	const auto found = methods.find(name);
	if (found == methods.end()) {
		lack("method " + name);
	}
	return found->second;
}

void add_texts(GDExtensionConstTypePtr p_a, GDExtensionConstTypePtr p_b, GDExtensionTypePtr r_result) {
	*static_cast<Text *>(r_result) = make_text(utf32(string_text(p_a) + string_text(p_b)));
}

void are_texts_equal(GDExtensionConstTypePtr p_a, GDExtensionConstTypePtr p_b, GDExtensionTypePtr r_result) {
	*static_cast<GDExtensionBool *>(r_result) = string_text(p_a) == string_text(p_b);
}

GDExtensionPtrOperatorEvaluator find_operator(
		GDExtensionVariantOperator p_operator, GDExtensionVariantType p_a, GDExtensionVariantType p_b) {
	const bool are_texts = p_a == GDEXTENSION_VARIANT_TYPE_STRING && p_b == p_a;
	if (are_texts && p_operator == GDEXTENSION_VARIANT_OP_ADD) {
		return &add_texts;
	}
	if (are_texts && p_operator == GDEXTENSION_VARIANT_OP_EQUAL) {
		return &are_texts_equal;
	}
	lack("operator " + std::to_string(p_operator) + " of " + TYPE_NAMES[p_a] + " and " + TYPE_NAMES[p_b]);
}

} // namespace

void offer_lists(Functions &r_functions) {
	offer(r_functions, "variant_get_ptr_builtin_method", &find_builtin);
	offer(r_functions, "variant_get_ptr_operator_evaluator", &find_operator);
	offer(r_functions, "variant_evaluate", &format);
	offer(r_functions, "packed_string_array_operator_index_const", &text_at);
	offer(
			r_functions, "array_set_typed",
			+[](GDExtensionTypePtr, GDExtensionVariantType, GDExtensionConstStringNamePtr, GDExtensionConstVariantPtr) {});
	offer(r_functions, "packed_byte_array_operator_index", &byte_at);
	offer(r_functions, "packed_vector3_array_operator_index", &vector_at);
	offer(r_functions, "packed_vector3_array_operator_index_const", &read_vector_at);
	offer(r_functions, "array_operator_index", &element_at);
	offer(r_functions, "dictionary_operator_index", &forget);
	offer(
			r_functions, "variant_get_ptr_utility_function",
			+[](GDExtensionConstStringNamePtr p_name, GDExtensionInt) -> GDExtensionPtrUtilityFunction {
				lack("function " + name_text(p_name));
			});
}

} // namespace host
