// SPDX-License-Identifier: MIT
// Binds methods of a node's parts under the names that scripts call. Every such method is guarded: on another thread, while the node is in
// the tree, it reports an error and returns an empty result.
#pragma once

#include "shared/main_thread.h"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace grass {

// A name as the argument of a template.
template <size_t N> struct MethodName {
	consteval MethodName(const char (&p_text)[N]) { std::ranges::copy(p_text, text); }
	// Returns the name as messages show it: setters of numbered properties begin with a `_`.
	constexpr const char *shown() const { return text + (text[0] == '_' ? 1 : 0); }

	char text[N] = {};
};

// Converts what a part returns to what a script gets. A type that no script knows needs a function of this name beside it.
template <typename T> T to_script(const T &p_result) {
	return p_result;
}
template <typename R> struct ScriptResult { using Type = decltype(to_script(std::declval<const std::remove_cvref_t<R> &>())); };
template <> struct ScriptResult<void> { using Type = void; };

// One method of a part. PATH: members that lead from the node to the part.
template <MethodName NAME, auto METHOD, auto... PATH> struct PartMethod {
	template <typename Node, typename... A> static auto call(Node &r_node, A &...r_arguments) {
		using R = decltype(((r_node.*....*PATH).*METHOD)(r_arguments...));
		if constexpr (std::is_void_v<R>) {
			((r_node.*....*PATH).*METHOD)(r_arguments...);
		} else {
			return to_script(((r_node.*....*PATH).*METHOD)(r_arguments...));
		}
	}
};

// The base of a node with parts. Node needs label(). The engine binds only methods of the node's own class, so each bound method of a part
// gets one of these.
template <typename Node> class CalledByParts {
public:
	template <typename Method, MethodName NAME, typename R, typename... A> R call_part(A... p_arguments) {
		return may_call(NAME.shown()) ? Method::call(static_cast<Node &>(*this), p_arguments...) : R();
	}
	template <typename Method, MethodName NAME, typename R, typename... A> R call_part(A... p_arguments) const {
		return may_call(NAME.shown()) ? Method::call(static_cast<const Node &>(*this), p_arguments...) : R();
	}
	// Calls a getter of a property, on any thread.
	template <typename Method, typename R, typename... A> R read_part(A... p_arguments) const {
		return Method::call(static_cast<const Node &>(*this), p_arguments...);
	}

private:
	bool may_call(const char *p_name) const {
		const Node &node = static_cast<const Node &>(*this);
		ERR_FAIL_COND_V_MSG(node.is_inside_tree() && !is_main_thread(), false, thread_message(node.label(), call_of(p_name)));
		return true;
	}
};

// The methods that the node gets for a method of type F of a part.
template <typename Node, MethodName NAME, typename Method, typename F> struct PartCall;
template <typename Node, MethodName NAME, typename Method, typename Part, typename R, typename... A>
struct PartCall<Node, NAME, Method, R (Part::*)(A...)> {
	using Result = typename ScriptResult<R>::Type;
	static constexpr Result (Node::*CALL)(A...) = &CalledByParts<Node>::template call_part<Method, NAME, Result, A...>;
};
template <typename Node, MethodName NAME, typename Method, typename Part, typename R, typename... A>
struct PartCall<Node, NAME, Method, R (Part::*)(A...) const> {
	using Result = typename ScriptResult<R>::Type;
	static constexpr Result (Node::*CALL)(A...) const = &CalledByParts<Node>::template call_part<Method, NAME, Result, A...>;
	static constexpr Result (Node::*READ)(A...) const = &CalledByParts<Node>::template read_part<Method, Result, A...>;
};

// Binds methods of the part of Node that is at the end of PATH.
template <typename Node, auto... PATH> struct PartBinder {
	template <MethodName NAME, auto METHOD> using Call = PartCall<Node, NAME, PartMethod<NAME, METHOD, PATH...>, decltype(METHOD)>;

	// Binds a method. p_arguments: their names. p_defaults: of the last of them.
	template <MethodName NAME, auto METHOD, size_t N, typename... Defaults>
	void bind(const char *const (&p_arguments)[N], const Defaults &...p_defaults) const {
		bind_named<NAME, METHOD>(p_arguments, std::make_index_sequence<N>(), p_defaults...);
	}
	template <MethodName NAME, auto METHOD> void bind() const {
		godot::ClassDB::bind_method(godot::D_METHOD(NAME.text), Call<NAME, METHOD>::CALL);
	}
	// Bind the getter of a property. p_index: the name of its argument, in numbered properties.
	template <MethodName NAME, auto METHOD> void bind_reader() const {
		godot::ClassDB::bind_method(godot::D_METHOD(NAME.text), Call<NAME, METHOD>::READ);
	}
	template <MethodName NAME, auto METHOD> void bind_reader(const char *p_index) const {
		godot::ClassDB::bind_method(godot::D_METHOD(NAME.text, p_index), Call<NAME, METHOD>::READ);
	}
	// Binds a property with its setter and getter, which scripts may call by name too.
	template <MethodName SETTER, auto SET, MethodName GETTER, auto GET> void bind_property(const godot::PropertyInfo &p_info) const {
		bind<SETTER, SET>({ "value" });
		bind_reader<GETTER, GET>();
		godot::ClassDB::add_property(Node::get_class_static(), p_info, SETTER.text, GETTER.text);
	}

private:
	template <MethodName NAME, auto METHOD, size_t N, size_t... I, typename... Defaults>
	static void bind_named(const char *const (&p_arguments)[N], std::index_sequence<I...>, const Defaults &...p_defaults) {
		godot::ClassDB::bind_method(godot::D_METHOD(NAME.text, p_arguments[I]...), Call<NAME, METHOD>::CALL, p_defaults...);
	}
};

} // namespace grass
