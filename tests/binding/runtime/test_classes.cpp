// SPDX-License-Identifier: MIT
// Classes of the extension as the engine sees them: every call here goes through the engine by name.
#include "tests.h"

#include "probe.h"

#include <godot_cpp/variant/builtin_types.hpp>

using namespace godot;

int Probe::living = 0;

void Probe::set_number(int p_number) {
	_number = p_number;
	emit_signal("number_changed", p_number);
}

Ref<Probe> Probe::make_copy() const {
	Ref<Probe> copy;
	copy.instantiate();
	copy->_number = _number;
	return copy;
}

void Probe::_notification(int p_what) {
	created += p_what == NOTIFICATION_POSTINITIALIZE;
}

bool Probe::_set(const StringName &p_name, const Variant &p_value) {
	if (p_name == StringName("extra")) {
		_extra = p_value;
		return true;
	}
	return false;
}

bool Probe::_get(const StringName &p_name, Variant &r_value) const {
	if (p_name == StringName("extra")) {
		r_value = _extra;
		return true;
	}
	return false;
}

void Probe::_get_property_list(List<PropertyInfo> *r_list) const {
	r_list->push_back(PropertyInfo(Variant::STRING, "extra"));
}

void Probe::_validate_property(PropertyInfo &p_property) const {
	if (p_property.name == StringName("kind") && _number == 0) {
		p_property.usage = PROPERTY_USAGE_NONE;
	}
}

void Probe::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_number", "number"), &Probe::set_number);
	ClassDB::bind_method(D_METHOD("get_number"), &Probe::get_number);
	ClassDB::bind_method(D_METHOD("set_kind", "kind"), &Probe::set_kind);
	ClassDB::bind_method(D_METHOD("get_kind"), &Probe::get_kind);
	ClassDB::bind_method(D_METHOD("scaled", "factor", "offset"), &Probe::scaled, DEFVAL(0.5));
	ClassDB::bind_method(D_METHOD("make_copy"), &Probe::make_copy);
	ClassDB::bind_static_method("Probe", D_METHOD("get_motto"), &Probe::get_motto);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "number"), "set_number", "get_number");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "kind", PROPERTY_HINT_ENUM, "Small,Large:7"), "set_kind", "get_kind");
	ADD_SIGNAL(MethodInfo("number_changed", PropertyInfo(Variant::INT, "number")));
	BIND_ENUM_CONSTANT(KIND_SMALL);
	BIND_ENUM_CONSTANT(KIND_LARGE);
}

namespace {

// Returns the entry of a property in an object's list, or an empty one.
Dictionary find_property(const Object &p_object, const String &p_name) {
	const TypedArray<Dictionary> list = p_object.get_property_list();
	for (int64_t i = 0; i < list.size(); i++) {
		const Dictionary entry = list[i];
		if (String(entry["name"]) == p_name) {
			return entry;
		}
	}
	return Dictionary();
}

} // namespace

TEST_CASE("a class is made by its name, notified once, and freed with its last reference") {
	const int before = Probe::living;
	{
		const Variant made = ClassDBSingleton::get_singleton()->instantiate("Probe");
		Probe *probe = Object::cast_to<Probe>(made.get_validated_object());
		CHECK((probe != nullptr));
		CHECK((probe && probe->created == 1));
		CHECK((Probe::living == before + 1));
	}
	CHECK((Probe::living == before));
}

TEST_CASE("properties are set and read by name, and signals carry their argument") {
	Ref<Probe> probe;
	probe.instantiate();
	Ref<Probe> listener;
	listener.instantiate();
	probe->connect("number_changed", Callable(listener.ptr(), "set_number"));
	probe->set("number", 12);
	CHECK((int(probe->get("number")) == 12));
	CHECK((listener->get_number() == 12));
	probe->set("kind", Probe::KIND_LARGE);
	CHECK((probe->get_kind() == Probe::KIND_LARGE));
}

TEST_CASE("methods get their arguments, defaults and results across the engine") {
	Ref<Probe> probe;
	probe.instantiate();
	CHECK((double(probe->call("scaled", 2.0, 1.0)) == 7.0));
	CHECK((double(probe->call("scaled", 2.0)) == 6.5));
	const Ref<Probe> copy = probe->call("make_copy");
	CHECK((copy.is_valid() && copy != probe && copy->get_number() == 3));
	CHECK((String(ClassDBSingleton::get_singleton()->class_call_static("Probe", "get_motto")) == "probe"));
}

TEST_CASE("enum constants belong to their enum") {
	ClassDBSingleton *classes = ClassDBSingleton::get_singleton();
	CHECK((classes->class_get_integer_constant("Probe", "KIND_LARGE") == 7));
	CHECK((classes->class_get_enum_constants("Probe", "Kind").size() == 2));
}

TEST_CASE("properties that the class makes up are listed, set and read") {
	Ref<Probe> probe;
	probe.instantiate();
	CHECK((!find_property(*probe.ptr(), "extra").is_empty()));
	probe->set("extra", "more");
	CHECK((String(probe->get("extra")) == "more"));
}

TEST_CASE("a class may change how its properties are listed") {
	Ref<Probe> probe;
	probe.instantiate();
	const int64_t shown = find_property(*probe.ptr(), "kind")["usage"];
	CHECK((shown != PROPERTY_USAGE_NONE));
	probe->set_number(0);
	const int64_t hidden = find_property(*probe.ptr(), "kind")["usage"];
	CHECK((hidden == PROPERTY_USAGE_NONE));
}
