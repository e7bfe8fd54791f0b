// SPDX-License-Identifier: MIT
#include "resources/grass_quality.h"

#include "shared/main_thread.h"
#include "shared/params.h"
#include "shared/watch_resource.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <utility>

using namespace godot;

namespace grass {

namespace {

constexpr const char *LEVEL_SETTING = "grass_field/quality/level", *CUSTOM_SETTING = "grass_field/quality/custom";
constexpr const char *LEVEL_ON_WEB_SETTING = "grass_field/quality/level.web"; // the engine takes it where there is the feature `web`
constexpr const char *LEVEL_NAMES = "Low,Medium,High,Ultra,Custom";
constexpr const char *NOT_A_LEVEL = "GrassQuality: the level must be one of the LEVEL_* constants.";

// The level of the whole game. is_known: it was read from the project, or set by a script.
struct Current {
	bool is_known = false;
	GrassQuality::Level level = GrassQuality::LEVEL_HIGH;
	Ref<GrassQuality> custom;
	Ref<GrassQuality> shown; // get_current(); null: nobody has called it
	GrassQuality::Level shown_level = GrassQuality::LEVEL_HIGH; // the last one that it was set to
};

Current &current() {
	static Current current;
	return current;
}

bool is_level(int64_t p_level) {
	return p_level >= 0 && p_level <= GrassQuality::LEVEL_CUSTOM;
}

struct Start {
	GrassQuality::Level level = GrassQuality::LEVEL_HIGH;
	Ref<GrassQuality> custom;
};

// Reads the project's level. The editor shows grass as it was designed.
Start read_project() {
	if (Engine::get_singleton()->is_editor_hint()) {
		return {};
	}
	const ProjectSettings *settings = ProjectSettings::get_singleton();
	const int64_t level = settings->get_setting_with_override(LEVEL_SETTING);
	ERR_FAIL_COND_V_MSG(!is_level(level), {},
			vformat("The project setting %s is %d, but must be 0 (Low) to 4 (Custom). Grass is drawn as designed (High).", LEVEL_SETTING,
					level));
	if (level != GrassQuality::LEVEL_CUSTOM) {
		return { GrassQuality::Level(level), {} };
	}
	const String path = settings->get_setting_with_override(CUSTOM_SETTING);
	const Ref<GrassQuality> custom = path.is_empty() ? Ref<Resource>() : ResourceLoader::get_singleton()->load(path);
	ERR_FAIL_COND_V_MSG(custom.is_null(), {},
			vformat("The project setting %s is Custom, but %s ('%s') is not the file of a GrassQuality. Grass is drawn as designed (High).",
					LEVEL_SETTING, CUSTOM_SETTING, path));
	return { GrassQuality::LEVEL_CUSTOM, custom };
}

Current &known() {
	Current &now = current();
	if (!now.is_known) {
		now.is_known = true;
		const Start start = read_project();
		now.level = start.level;
		now.custom = start.custom;
	}
	return now;
}

} // namespace

void register_quality() {
	add_project_setting(LEVEL_SETTING, int64_t(GrassQuality::LEVEL_HIGH), PROPERTY_HINT_ENUM, LEVEL_NAMES);
	// In a browser one processor simulates and draws, which no author sees who tries his game on the desktop.
	add_project_setting(LEVEL_ON_WEB_SETTING, int64_t(GrassQuality::LEVEL_LOW), PROPERTY_HINT_ENUM, LEVEL_NAMES);
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

// Changes the factors in force, and emits `changed` of get_current().
// NOLINTNEXTLINE(performance-unnecessary-value-param): it may be the reference that is in force
void GrassQuality::take(Level p_level, Ref<GrassQuality> p_custom) {
	Current &now = known();
	now.level = p_level;
	const Ref<GrassQuality> before = std::exchange(now.custom, p_custom);
	if (now.shown.is_null()) {
		return;
	}
	if (before != p_custom) {
		now.shown->listen_to(before, p_custom);
	}
	now.shown->_show();
}

void GrassQuality::listen_to(const Ref<GrassQuality> &p_before, const Ref<GrassQuality> &p_now) {
	const Callable show = callable_mp(this, &GrassQuality::_show);
	if (p_before.is_valid() && p_before->is_connected("changed", show)) {
		p_before.ptr()->disconnect("changed", show);
	}
	if (p_now.is_valid()) {
		p_now.ptr()->connect("changed", show);
	}
}

void GrassQuality::_show() {
	GRASS_LATER_ON_MAIN_THREAD(&GrassQuality::_show); // another thread changed a factor
	Current &now = known();
	const Quality &quality = current_quality();
	if (std::exchange(now.shown_level, now.level) != now.level || _quality != quality) {
		_quality = quality;
		emit_changed();
	}
}

Ref<GrassQuality> GrassQuality::get_current() {
	ERR_FAIL_COND_V_MSG(!is_main_thread(), Ref<GrassQuality>(), thread_message("GrassQuality", call_of(__func__)));
	Current &now = known();
	if (now.shown.is_null()) {
		now.shown.instantiate();
		now.shown->_is_current = true;
		now.shown->_quality = current_quality();
		now.shown->listen_to({}, now.custom);
		now.shown_level = now.level;
	}
	return now.shown;
}

void GrassQuality::set_level(Level p_level) {
	ERR_FAIL_COND_MSG(!is_main_thread(), thread_message("GrassQuality", call_of(__func__)));
	ERR_FAIL_COND_MSG(!is_level(int64_t(p_level)), NOT_A_LEVEL);
	ERR_FAIL_COND_MSG(p_level == LEVEL_CUSTOM && known().custom.is_null(),
			"GrassQuality: LEVEL_CUSTOM needs factors. Call set_custom() with a GrassQuality instead.");
	take(p_level, known().custom);
}

GrassQuality::Level GrassQuality::get_level() {
	ERR_FAIL_COND_V_MSG(!is_main_thread(), LEVEL_HIGH, thread_message("GrassQuality", call_of(__func__)));
	return known().level;
}

void GrassQuality::set_custom(const Ref<GrassQuality> &p_quality) {
	ERR_FAIL_COND_MSG(!is_main_thread(), thread_message("GrassQuality", call_of(__func__)));
	ERR_FAIL_COND_MSG(p_quality.is_null(), "GrassQuality: set_custom() needs a GrassQuality. To leave LEVEL_CUSTOM, call set_level().");
	ERR_FAIL_COND_MSG(p_quality->_is_current, "GrassQuality: set_custom() needs a GrassQuality of your own, not that of get_current().");
	take(LEVEL_CUSTOM, p_quality);
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
	const Start start = read_project();
	take(start.level, start.custom);
}

void GrassQuality::set_param(int64_t p_param, double p_value) {
	ERR_FAIL_INDEX(p_param, int64_t(QUALITY_FACTORS));
	ERR_FAIL_COND_MSG(
			_is_current, label() + String(": get_current() shows the factors in force. To set them, pass others to set_custom()."));
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
	ClassDB::bind_static_method("GrassQuality", D_METHOD("get_current"), &GrassQuality::get_current);
	ClassDB::bind_static_method("GrassQuality", D_METHOD("from_level", "level"), &GrassQuality::from_level);
	ClassDB::bind_static_method("GrassQuality", D_METHOD("reset_level"), &GrassQuality::reset_level);
	BIND_ENUM_CONSTANT(LEVEL_LOW);
	BIND_ENUM_CONSTANT(LEVEL_MEDIUM);
	BIND_ENUM_CONSTANT(LEVEL_HIGH);
	BIND_ENUM_CONSTANT(LEVEL_ULTRA);
	BIND_ENUM_CONSTANT(LEVEL_CUSTOM);
}

} // namespace grass
