// SPDX-License-Identifier: MIT
// GrassQuality: the factors of an options menu, and the level that all fields of the game have.
#pragma once

#include "core/field/quality.h"
#include "shared/label.h"

#include <godot_cpp/classes/resource.hpp>

namespace grass {

class GrassQuality : public godot::Resource {
	GDCLASS(GrassQuality, godot::Resource)

public:
	enum Level : int64_t {
		LEVEL_LOW = int(QualityLevel::LOW),
		LEVEL_MEDIUM = int(QualityLevel::MEDIUM),
		LEVEL_HIGH = int(QualityLevel::HIGH),
		LEVEL_ULTRA = int(QualityLevel::ULTRA),
		LEVEL_CUSTOM = int(QualityLevel::CUSTOM),
	};

	void set_param(int64_t p_param, double p_value);
	double get_param(int64_t p_param) const;
	const Quality &get_quality() const { return _quality; }

	static void set_level(Level p_level);
	static Level get_level();
	static void set_custom(const godot::Ref<GrassQuality> &p_quality); // and LEVEL_CUSTOM
	static godot::Ref<GrassQuality> get_custom(); // null: none was set
	// Returns the factors in force: always the same object, which emits `changed`.
	static godot::Ref<GrassQuality> get_current();
	static godot::Ref<GrassQuality> from_level(Level p_level); // a new one
	static void reset_level(); // to the project's

protected:
	static void _bind_methods();

private:
	godot::String label() const { return label_of(*this); } // for messages
	static void take(Level p_level, godot::Ref<GrassQuality> p_custom);
	void listen_to(const godot::Ref<GrassQuality> &p_before, const godot::Ref<GrassQuality> &p_now);
	void _show();

	Quality _quality;
	bool _is_current = false; // it is get_current()
};

// Returns the factors that all fields have now. Fields compare them once in each frame, so they need no notification. Main thread.
const Quality &current_quality();
void register_quality(); // the project settings
void free_quality();

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassQuality::Level);
