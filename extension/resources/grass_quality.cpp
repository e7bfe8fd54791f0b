// SPDX-License-Identifier: MIT
#include "resources/grass_quality.h"

#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/watch_resource.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr const char *LEVEL_SETTING = "grass_field/quality/level", *CUSTOM_SETTING = "grass_field/quality/custom";
constexpr const char *LEVEL_NAMES = "Low,Medium,High,Ultra,Custom";
constexpr const char *NOT_A_LEVEL = "GrassQuality: the level must be one of the LEVEL_* constants.";

// The level of the whole game. is_known: it was read from the project, or set by a script.
struct Current {
	bool is_known = false;
	GrassQuality::Level level = GrassQuality::LEVEL_HIGH;
	Ref<GrassQuality> custom;
};

Current &current() {
	static Current current;
	return current;
}

bool is_level(int64_t p_level) {
	return p_level >= 0 && p_level <= GrassQuality::LEVEL_CUSTOM;
}

// The editor shows grass as it was designed.
void read_project() {
	Current &now = current();
	now = { true, GrassQuality::LEVEL_HIGH, {} };
	if (Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	const ProjectSettings *settings = ProjectSettings::get_singleton();
	const int64_t level = settings->get_setting_with_override(LEVEL_SETTING);
	ERR_FAIL_COND_MSG(!is_level(level),
			vformat("The project setting %s is %d, but must be 0 (Low) to 4 (Custom). Grass is drawn as designed (High).", LEVEL_SETTING,
					level));
	if (level != GrassQuality::LEVEL_CUSTOM) {
		now.level = GrassQuality::Level(level);
		return;
	}
	const String path = settings->get_setting_with_override(CUSTOM_SETTING);
	const Ref<GrassQuality> custom = path.is_empty() ? Ref<Resource>() : ResourceLoader::get_singleton()->load(path);
	ERR_FAIL_COND_MSG(custom.is_null(),
			vformat("The project setting %s is Custom, but %s ('%s') is not the file of a GrassQuality. Grass is drawn as designed (High).",
					LEVEL_SETTING, CUSTOM_SETTING, path));
	now.custom = custom;
	now.level = GrassQuality::LEVEL_CUSTOM;
}

Current &known() {
	if (!current().is_known) {
		read_project();
	}
	return current();
}

} // namespace

void register_quality() {
	add_project_setting(LEVEL_SETTING, int64_t(GrassQuality::LEVEL_HIGH), PROPERTY_HINT_ENUM, LEVEL_NAMES);
	add_project_setting(CUSTOM_SETTING, String(), PROPERTY_HINT_FILE, "*.tres,*.res");
}

void free_quality() {
	current() = {};
}

const Quality &current_quality() {
	static Quality quality;
	const Current &now = known();
	quality = now.level == GrassQuality::LEVEL_CUSTOM ? now.custom->get_quality() : Quality{ Quality::of_level(QualityLevel(now.level)) };
	return quality;
}

void GrassQuality::set_level(Level p_level) {
	ERR_FAIL_COND_MSG(!is_main_thread(), thread_message("GrassQuality", call_of(__func__)));
	ERR_FAIL_COND_MSG(!is_level(int64_t(p_level)), NOT_A_LEVEL);
	ERR_FAIL_COND_MSG(p_level == LEVEL_CUSTOM && known().custom.is_null(),
			"GrassQuality: LEVEL_CUSTOM needs factors. Call set_custom() with a GrassQuality instead.");
	known().level = p_level;
}

GrassQuality::Level GrassQuality::get_level() {
	ERR_FAIL_COND_V_MSG(!is_main_thread(), LEVEL_HIGH, thread_message("GrassQuality", call_of(__func__)));
	return known().level;
}

void GrassQuality::set_custom(const Ref<GrassQuality> &p_quality) {
	ERR_FAIL_COND_MSG(!is_main_thread(), thread_message("GrassQuality", call_of(__func__)));
	ERR_FAIL_COND_MSG(p_quality.is_null(), "GrassQuality: set_custom() needs a GrassQuality. To leave LEVEL_CUSTOM, call set_level().");
	known().custom = p_quality;
	known().level = LEVEL_CUSTOM;
}

Ref<GrassQuality> GrassQuality::get_custom() {
	ERR_FAIL_COND_V_MSG(!is_main_thread(), Ref<GrassQuality>(), thread_message("GrassQuality", call_of(__func__)));
	return known().custom;
}

Ref<GrassQuality> GrassQuality::from_level(Level p_level) {
	ERR_FAIL_COND_V_MSG(!is_level(int64_t(p_level)), Ref<GrassQuality>(), NOT_A_LEVEL);
	Ref<GrassQuality> quality;
	quality.instantiate();
	const bool is_custom = p_level == LEVEL_CUSTOM && is_main_thread() && known().custom.is_valid();
	quality->_quality = is_custom ? known().custom->get_quality() : Quality{ Quality::of_level(QualityLevel(p_level)) };
	return quality;
}

void GrassQuality::reset_level() {
	ERR_FAIL_COND_MSG(!is_main_thread(), thread_message("GrassQuality", call_of(__func__)));
	read_project();
}

void GrassQuality::set_param(int64_t p_param, double p_value) {
	ERR_FAIL_INDEX(p_param, int64_t(QUALITY_FACTORS));
	replace_in(*this, _quality.factors[size_t(p_param)], checked(QUALITY_TABLE[size_t(p_param)].tunable, p_value, label()));
}

double GrassQuality::get_param(int64_t p_param) const {
	ERR_FAIL_INDEX_V(p_param, int64_t(QUALITY_FACTORS), 0.0);
	return _quality.factors[size_t(p_param)];
}

void GrassQuality::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_set_param", "param", "value"), &GrassQuality::set_param);
	ClassDB::bind_method(D_METHOD("_get_param", "param"), &GrassQuality::get_param);
	for (const QualityFactor &factor : QUALITY_TABLE) {
		ClassDB::add_property("GrassQuality", property_of(factor.tunable), "_set_param", "_get_param", factor.id);
	}
	ClassDB::bind_static_method("GrassQuality", D_METHOD("set_level", "level"), &GrassQuality::set_level);
	ClassDB::bind_static_method("GrassQuality", D_METHOD("get_level"), &GrassQuality::get_level);
	ClassDB::bind_static_method("GrassQuality", D_METHOD("set_custom", "quality"), &GrassQuality::set_custom);
	ClassDB::bind_static_method("GrassQuality", D_METHOD("get_custom"), &GrassQuality::get_custom);
	ClassDB::bind_static_method("GrassQuality", D_METHOD("from_level", "level"), &GrassQuality::from_level);
	ClassDB::bind_static_method("GrassQuality", D_METHOD("reset_level"), &GrassQuality::reset_level);
	BIND_ENUM_CONSTANT(LEVEL_LOW);
	BIND_ENUM_CONSTANT(LEVEL_MEDIUM);
	BIND_ENUM_CONSTANT(LEVEL_HIGH);
	BIND_ENUM_CONSTANT(LEVEL_ULTRA);
	BIND_ENUM_CONSTANT(LEVEL_CUSTOM);
}

} // namespace grass
