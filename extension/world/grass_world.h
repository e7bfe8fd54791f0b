// SPDX-License-Identifier: MIT
// GrassWorld: grass on more ground than memory can hold. Keeps a GrassField for each plot near the cameras and the moving bodies.
#pragma once

#include "shared/property_value.h"
#include "world/world_eyes.h"
#include "world/world_plots.h"

#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace grass {

class GrassWorld : public godot::Node3D {
	GDCLASS(GrassWorld, godot::Node3D)

public:
	void set_size(const godot::Vector2 &p_size); // metres along x and z
	godot::Vector2 get_size() const { return _size; }
	void set_plot_size(double p_size);
	double get_plot_size() const { return _plot_size; }
	void set_plot_scene(const godot::Ref<godot::PackedScene> &p_scene); // its root is a GrassField
	godot::Ref<godot::PackedScene> get_plot_scene() const { return value_of(_scene); }
	void set_camera_radius(double p_radius);
	double get_camera_radius() const { return _camera_radius; }
	void set_body_radius(double p_radius);
	double get_body_radius() const { return _body_radius; }
	void set_memory_budget(double p_megabytes);
	double get_memory_budget() const { return _memory_budget; }
	void set_folder(const godot::String &p_folder);
	godot::String get_folder() const { return value_of(_folder); }
	void set_save_folder(const godot::String &p_folder);
	godot::String get_save_folder() const { return value_of(_save_folder); }

	godot::Vector2i get_plot_at(const godot::Vector3 &p_global_position) const;
	godot::String get_plot_path(const godot::Vector2i &p_plot) const; // the file of its map
	GrassField *get_field(const godot::Vector2i &p_plot) const; // null: not in memory
	GrassField *get_field_at(const godot::Vector3 &p_global_position) const;
	godot::TypedArray<GrassField> get_fields() const;
	godot::Dictionary cut(const godot::Ref<godot::Shape3D> &p_shape, const godot::Transform3D &p_transform);
	double paint(const godot::Ref<GrassBrush> &p_brush, const godot::Vector3 &p_from, const godot::Vector3 &p_to);
	void shift_origin(const godot::Vector3 &p_offset);
	int64_t save(); // returns how many plots changed; a thread writes them
	// These move the unwritten changes to the current folders, or discard them. Both return the number of plots.
	int64_t carry_unsaved();
	int64_t discard_unsaved();
	void wait_for_files(); // until everything is written
	// A step of an undo history: sets a plot to p_snapshot wherever that differs from p_from.
	void restore_plot(
			const godot::Vector2i &p_plot, const godot::Ref<GrassMapSnapshot> &p_snapshot, const godot::Ref<GrassMapSnapshot> &p_from);
	godot::Dictionary get_statistics() const;

	// For the editor.
	static inline void (*scene_saved)(GrassWorld &r_world) = nullptr; // called after its scene was saved
	static inline void (*places_changed)(GrassWorld &r_world) = nullptr; // `folder` or `plot_size` did, and plots are kept for the old one
	godot::Transform3D world_transform() const; // global, without scale
	bool has_unsaved() const;
	int64_t count_kept_elsewhere() const { return _plots.get_files().get_statistics().kept_elsewhere; }
	void discard_kept_elsewhere();
	godot::String find_folder_problem() const { return _plots.get_files().find_problem(); }

	godot::PackedStringArray _get_configuration_warnings() const override;

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	void enter();
	void leave();
	void restart();
	void _frame(); // called from the message queue, where the engine lets a node die: shared/script_call.h
	void report();
	void ask_about_kept();
	void report_loss();
	godot::PackedStringArray find_warnings() const; // all but the shortage
	godot::String find_shortage() const; // "": the budget holds everything
	bool is_here(const char *p_method) const; // false, with an error, outside the tree
	WorldGrid grid() const { return { to_metres(_size), _plot_size }; }
	static Eigen::Vector2d to_metres(const godot::Vector2 &p_size) { return { p_size.x, p_size.y }; }
	static size_t to_bytes_of(double p_megabytes) { return size_t(p_megabytes * 1e6); }
	WorldFolders find_folders() const;
	Eigen::Vector2d place_of(const godot::Vector3 &p_global_position) const;
	void tell(const char *p_signal, const PlotKey &p_key, GrassField *p_field);
	void _body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id, int64_t p_body_shape, int64_t p_area_shape);
	godot::String label() const;

	godot::Vector2 _size{ godot::real_t(WorldGrid::SIZE.initial), godot::real_t(WorldGrid::SIZE.initial) };
	double _plot_size = WorldGrid::PLOT_SIZE.initial, _camera_radius = WORLD_CAMERA_RADIUS.initial,
		   _body_radius = WORLD_BODY_RADIUS.initial, _memory_budget = WORLD_MEMORY_BUDGET.initial;
	godot::Ref<godot::PackedScene> _scene;
	godot::String _folder, _save_folder;
	WorldEyes _eyes;
	WorldPlots _plots{ *this, [this](const char *p_signal, const PlotKey &p_key, GrassField *p_field) { tell(p_signal, p_key, p_field); } };
	godot::PackedStringArray _warned_of; // printed in the console
	double _frame_ms = 0.0, _most_frame_ms = 0.0;
	// The last warning that the budget is too small.
	struct Shortage {
		bool is_short = false;
		double reach = 0.0; // metres
		size_t missing = 0; // bytes
		bool is_worse_than(const Shortage &p_other) const;
	};
	Shortage _shortage;
	bool _has_reported = false; // whether all other warnings were printed since restart()
};

} // namespace grass
