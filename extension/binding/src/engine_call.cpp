// SPDX-License-Identifier: MIT
#include <godot_cpp/core/engine_call.hpp>

#include <godot_cpp/classes/class_db_singleton.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/engine_class.hpp>

#include <cstdlib>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

namespace godot::internal {

namespace engine = gdextension_interface;

namespace {

// Which wrapper each engine class gets. Grows by the classes met that are not in classes.json.
struct Wrappers {
	std::mutex mutex;
	std::unordered_map<StringName, const GDExtensionInstanceBindingCallbacks *, StringNameHash> callbacks;
};
Wrappers *wrappers = nullptr;

// Returns whether a test wants the engine to lack a class, or "Class.method": GRASS_HIDDEN in the environment lists them, with commas.
bool is_hidden([[maybe_unused]] const std::string &p_name) {
#ifdef DEBUG_ENABLED
	static const char *const listed = std::getenv("GRASS_HIDDEN");
	static const std::string hidden = listed ? "," + std::string(listed) + "," : std::string();
	return hidden.find("," + p_name + ",") != std::string::npos;
#else
	return false;
#endif
}

std::mutex singletons_mutex;
std::vector<Singleton *> singletons;

const GDExtensionInstanceBindingCallbacks *find_callbacks(const StringName &p_class) {
	std::lock_guard lock(wrappers->mutex);
	auto found = wrappers->callbacks.find(p_class);
	return found == wrappers->callbacks.end() ? nullptr : found->second;
}

// Returns those of the class itself or of its nearest known ancestor.
const GDExtensionInstanceBindingCallbacks *nearest_callbacks(const StringName &p_class) {
	const GDExtensionInstanceBindingCallbacks *callbacks = find_callbacks(p_class);
	if (callbacks) {
		return callbacks;
	}
	StringName ancestor = p_class;
	while (!callbacks) {
		ancestor = ClassDBSingleton::get_singleton()->get_parent_class(ancestor);
		if (ancestor == StringName()) {
			return &engine_callbacks<Object>;
		}
		callbacks = find_callbacks(ancestor);
	}
	register_engine_class(p_class, callbacks);
	return callbacks;
}

} // namespace

void register_engine_class(const StringName &p_name, const GDExtensionInstanceBindingCallbacks *p_callbacks) {
	if (!wrappers) {
		wrappers = new Wrappers;
	}
	std::lock_guard lock(wrappers->mutex);
	wrappers->callbacks[p_name] = p_callbacks;
}

void forget_engine_classes() {
	delete wrappers;
	wrappers = nullptr;
}

Object *get_object_instance_binding(GodotObject *p_object) {
	if (!p_object) {
		return nullptr;
	}
	void *wrapper = engine::object_get_instance_binding(p_object, engine::token, nullptr);
	if (!wrapper) {
		StringName name;
		const GDExtensionInstanceBindingCallbacks *callbacks = &engine_callbacks<Object>;
		if (engine::object_get_class_name(p_object, engine::library, name._native_ptr())) {
			callbacks = nearest_callbacks(name);
		}
		wrapper = engine::object_get_instance_binding(p_object, engine::token, callbacks);
	}
	return static_cast<Object *>(wrapper);
}

GDExtensionMethodBindPtr EngineMethod::find() {
	const std::string whole = std::string(class_name) + "." + name;
	if (!is_hidden(class_name) && !is_hidden(whole)) {
		bind.store(engine::classdb_get_method_bind(StringName(class_name)._native_ptr(), StringName(name)._native_ptr(), hash),
				std::memory_order_release);
	}
	if (!bind.load() && !is_missed.exchange(true)) {
		ERR_PRINT(String("This engine has no ") + whole.c_str() + "(). Calls of it do nothing.");
	}
	return bind.load();
}

Variant EngineMethod::call_variants(GodotObject *p_owner, const Variant *const *p_arguments, int p_count) {
	Variant result;
	GDExtensionCallError error = { GDEXTENSION_CALL_OK, 0, 0 };
	if (const GDExtensionMethodBindPtr found = get()) {
		engine::object_method_bind_call(
				found, p_owner, reinterpret_cast<const GDExtensionConstVariantPtr *>(p_arguments), p_count, result._native_ptr(), &error);
	}
	return result;
}

Object *Singleton::find() {
	GodotObject *owner = is_hidden(name) ? nullptr : engine::global_get_singleton(StringName(name)._native_ptr());
	Object *found = get_object_instance_binding(owner);
	if (found) {
		std::lock_guard lock(singletons_mutex);
		if (!object.exchange(found)) {
			singletons.push_back(this);
		}
	}
	return found;
}

void forget_singleton(void *p_wrapper) {
	std::lock_guard lock(singletons_mutex);
	for (Singleton *singleton : singletons) {
		if (singleton->object.load() == static_cast<Object *>(p_wrapper)) {
			singleton->object.store(nullptr);
		}
	}
	std::erase_if(singletons, [](Singleton *p_singleton) { return !p_singleton->object.load(); });
}

// Frees the wrappers of the engine's singletons, which outlive the library.
void free_singletons() {
	std::vector<GodotObject *> owners;
	{
		std::lock_guard lock(singletons_mutex);
		for (Singleton *singleton : singletons) {
			owners.push_back(singleton->object.load()->_owner);
		}
	}
	for (GodotObject *owner : owners) {
		engine::object_free_instance_binding(owner, engine::token);
	}
}

Object *object_in_ref(const void *p_ref) {
	return get_object_instance_binding(engine::ref_get_object(p_ref));
}

void set_ref(void *r_ref, GodotObject *p_object) {
	if (p_object) {
		engine::ref_set_object(r_ref, p_object);
	}
}

} // namespace godot::internal
