// SPDX-License-Identifier: MIT
#include "resources/size_limits.h"

#include "shared/params.h"

#include <godot_cpp/classes/project_settings.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

struct Setting {
	const char *path;
	int64_t initial;
};

constexpr int64_t LEAST = 1, MOST = 1 << 20; // MB
constexpr Setting MAP{ "grass_field/limits/map_megabytes", int64_t(ReadLimits::MAP_MEGABYTES) };
constexpr Setting CHANGES{ "grass_field/limits/changes_megabytes", int64_t(ReadLimits::CHANGES_MEGABYTES) };
constexpr Setting RECORD{ "grass_field/limits/record_megabytes", 64 }; // half an hour of ten bodies that never rest

size_t bytes_of(const Setting &p_setting) {
	const int64_t megabytes = ProjectSettings::get_singleton()->get_setting(p_setting.path, p_setting.initial);
	return size_t(std::clamp(megabytes, LEAST, MOST)) * ReadLimits::MEGABYTE;
}

std::string hint_of(const Setting &p_setting) {
	return std::string(" (the project setting ") + p_setting.path + ")";
}

} // namespace

void register_size_limits() {
	const String hint = vformat("%d,%d,1,or_greater,suffix:MB", LEAST, int64_t(16384));
	for (const Setting &setting : { MAP, CHANGES, RECORD }) {
		add_project_setting(setting.path, setting.initial, PROPERTY_HINT_RANGE, hint);
	}
}

ReadLimits get_read_limits() {
	ReadLimits limits;
	limits.map_bytes = bytes_of(MAP);
	limits.changes_bytes = bytes_of(CHANGES);
	limits.map_hint = hint_of(MAP);
	limits.changes_hint = hint_of(CHANGES);
	return limits;
}

size_t get_record_limit() {
	return bytes_of(RECORD);
}

} // namespace grass
