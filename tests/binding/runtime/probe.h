// SPDX-License-Identifier: MIT
// A class of our own with a bit of all that a class can have.
#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>

class Probe : public godot::Resource {
	GDCLASS(Probe, godot::Resource)

public:
	enum Kind { KIND_SMALL, KIND_LARGE = 7 };

	static int living; // objects

	Probe() { living++; }
	~Probe() { living--; }

	void set_number(int p_number);
	int get_number() const { return _number; }
	void set_kind(Kind p_kind) { _kind = p_kind; }
	Kind get_kind() const { return _kind; }
	double scaled(double p_factor, double p_offset) const { return _number * p_factor + p_offset; }
	godot::Ref<Probe> make_copy() const;
	static godot::String get_motto() { return "probe"; }

	int created = 0; // notifications

protected:
	static void _bind_methods();
	void _notification(int p_what);
	bool _set(const godot::StringName &p_name, const godot::Variant &p_value);
	bool _get(const godot::StringName &p_name, godot::Variant &r_value) const;
	void _get_property_list(godot::List<godot::PropertyInfo> *r_list) const;
	void _validate_property(godot::PropertyInfo &p_property) const;

private:
	int _number = 3;
	Kind _kind = KIND_SMALL;
	godot::Variant _extra;
};

VARIANT_ENUM_CAST(Probe::Kind);
