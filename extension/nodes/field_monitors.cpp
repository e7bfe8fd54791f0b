// SPDX-License-Identifier: MIT
#include "nodes/field_monitors.h"

#include "nodes/grass_field.h"

#include <godot_cpp/classes/performance.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <utility>

using namespace godot;

namespace grass {

namespace {

struct MonitorInfo {
	const char *name; // "category/name", as the debugger shows it
	Performance::MonitorType type;
};

// In the order of FieldMonitor.
constexpr std::array<MonitorInfo, MONITOR_COUNT> MONITORS = { {
		{ "grass_field/awake_tiles", Performance::MONITOR_TYPE_QUANTITY },
		{ "grass_field/simulated_blades", Performance::MONITOR_TYPE_QUANTITY },
		{ "grass_field/drawn_blades", Performance::MONITOR_TYPE_QUANTITY },
		{ "grass_field/drawn_triangles", Performance::MONITOR_TYPE_QUANTITY },
		{ "grass_field/management", Performance::MONITOR_TYPE_TIME },
		{ "grass_field/simulate", Performance::MONITOR_TYPE_TIME },
		{ "grass_field/cull", Performance::MONITOR_TYPE_TIME },
		{ "grass_field/memory", Performance::MONITOR_TYPE_MEMORY },
} };

} // namespace

FieldMonitors *FieldMonitors::_singleton = nullptr;

void FieldMonitors::add(GrassField *p_field) {
	if (_singleton == nullptr) {
		_singleton = memnew(FieldMonitors);
	}
	if (_singleton->_fields.empty()) {
		_singleton->show();
	}
	_singleton->_fields.push_back(p_field);
}

void FieldMonitors::remove(GrassField *p_field) {
	if (_singleton != nullptr && std::erase(_singleton->_fields, p_field) > 0 && _singleton->_fields.empty()) {
		_singleton->hide();
	}
}

std::vector<GrassField *> FieldMonitors::get_fields() {
	return _singleton == nullptr ? std::vector<GrassField *>() : _singleton->_fields;
}

void FieldMonitors::free_singleton() {
	if (_singleton != nullptr) {
		memdelete(_singleton);
		_singleton = nullptr;
	}
}

void FieldMonitors::show() {
	for (int monitor = 0; monitor < MONITOR_COUNT; monitor++) {
		const MonitorInfo &info = MONITORS[size_t(monitor)];
		if (Performance::get_singleton()->has_custom_monitor(info.name)) {
			continue; // a script has its own monitor of this name
		}
		_is_shown[size_t(monitor)] = true;
		Array arguments;
		arguments.push_back(monitor);
		Performance::get_singleton()->add_custom_monitor(info.name, callable_mp(this, &FieldMonitors::_read), arguments, info.type);
	}
}

void FieldMonitors::hide() {
	for (size_t monitor = 0; monitor < MONITORS.size(); monitor++) {
		const char *name = MONITORS[monitor].name;
		if (std::exchange(_is_shown[monitor], false) && Performance::get_singleton()->has_custom_monitor(name)) {
			Performance::get_singleton()->remove_custom_monitor(name);
		}
	}
}

double FieldMonitors::_read(int64_t p_monitor) {
	double sum = 0.0;
	for (GrassField *field : _fields) {
		sum += field->get_report().find_monitor(FieldMonitor(p_monitor));
	}
	return sum;
}

} // namespace grass
