// SPDX-License-Identifier: MIT
// GrassWorld: grass on more ground than memory can hold. Keeps a GrassField for each plot near the cameras and the moving bodies.
#pragma once

#include "shared/bind_part.h"
#include "shared/label.h"
#include "shared/property_value.h"
#include "world/world_place.h"
#include "world/world_report.h"
#include "world/world_work.h"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace grass {

class GrassWorld : public godot::Node3D, public CalledByParts<GrassWorld> {
	GDCLASS(GrassWorld, godot::Node3D)

public:
	void set_size(const godot::Vector2 &p_size); // metres along x and z
	godot::Vector2 get_size() const { return _properties.size; }
	void set_plot_size(double p_size);
	double get_plot_size() const { return _properties.plot_size; }
	void set_plot_scene(const godot::Ref<godot::PackedScene> &p_scene); // its root is a GrassField
	godot::Ref<godot::PackedScene> get_plot_scene() const { return value_of(_properties.scene); }
	void set_camera_radius(double p_radius);
	double get_camera_radius() const { return _properties.camera_radius; }
	void set_body_radius(double p_radius);
	double get_body_radius() const { return _properties.body_radius; }
	void set_memory_budget(double p_megabytes);
	double get_memory_budget() const { return _properties.memory_budget; }
	void set_folder(const godot::String &p_folder);
	godot::String get_folder() const { return value_of(_properties.folder); }
	void set_save_folder(const godot::String &p_folder);
	godot::String get_save_folder() const { return value_of(_properties.save_folder); }

	godot::Vector2i get_plot_at(const godot::Vector3 &p_global_position) const;
	godot::String get_plot_path(const godot::Vector2i &p_plot) const; // the file of its map
	GrassField *get_field(const godot::Vector2i &p_plot) const; // null: not in memory
	GrassField *get_field_at(const godot::Vector3 &p_global_position) const;
	godot::TypedArray<GrassField> get_fields() const;
	void shift_origin(const godot::Vector3 &p_offset);
	int64_t save(); // returns how many plots changed; a thread writes them
	// Move the unwritten changes to the current folders, or discard them. Both return the number of plots.
	int64_t carry_unsaved();
	int64_t discard_unsaved();
	void wait_for_files(); // until everything is written
	// Sets a plot to p_snapshot wherever that differs from p_from: a step of an undo history.
	void restore_plot(
			const godot::Vector2i &p_plot, const godot::Ref<GrassMapSnapshot> &p_snapshot, const godot::Ref<GrassMapSnapshot> &p_from);
	godot::Dictionary get_statistics() const { return _report.get_statistics(); }

	// For the editor.
	static inline void (*scene_saved)(GrassWorld &r_world) = nullptr; // called after its scene was saved
	static inline void (*places_changed)(GrassWorld &r_world) = nullptr; // `folder` or `plot_size` did, and plots are kept for the old one
	godot::Transform3D world_transform() const { return transform_of(*this); } // global, without scale
	godot::String label() const { return label_of(*this); }
	bool has_unsaved() const;
	int64_t count_kept_elsewhere() const { return _plots.get_files().get_statistics().kept_elsewhere; }
	void discard_kept_elsewhere();
	godot::String find_folder_problem() const { return _plots.get_files().find_problem(); }

	godot::PackedStringArray _get_configuration_warnings() const override { return _report.get_warnings(); }

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	void enter();
	void leave();
	void restart();
	void _frame(); // called from the message queue, where the engine lets a node die: shared/script_call.h
	void ask_about_kept();
	bool is_here(const char *p_method) const; // false, with an error, outside the tree
	WorldFolders find_folders() const;
	void tell(const char *p_signal, const PlotKey &p_key, GrassField *p_field);
	void _body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape);

	WorldProperties _properties;
	WorldEyes _eyes;
	WorldPlots _plots{ *this, [this](const char *p_signal, const PlotKey &p_key, GrassField *p_field) { tell(p_signal, p_key, p_field); } };
	WorldWork _work{ *this, _plots };
	WorldReport _report{ *this, _properties, _plots, _eyes };
};

} // namespace grass
