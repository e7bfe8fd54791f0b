// SPDX-License-Identifier: MIT
// The backend of Forward+ and Mobile: simulates in compute passes, and draws one MultiMesh for the picture and one for shadows, whose
// instances and counts a compute pass writes. This side lives on the main thread; gpu_field.h is the other side.
#pragma once

#include "core/lod/field_levels.h"
#include "draw/backend.h"
#include "draw/blade_materials.h"
#include "draw/field_instance.h"
#include "draw/plants.h"
#include "gpu/field_jobs.h"
#include "gpu/field_passes.h"
#include "gpu/knot_queries.h"
#include "gpu/next_room.h"
#include "gpu/obstacles.h"
#include "gpu/plant_passes.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/texture2drd.hpp>

#include <utility>

namespace grass {

struct FieldMultiMeshes;
struct GpuReport;

class GpuBackend : public Backend {
public:
	explicit GpuBackend(const FieldSetup &p_setup);
	~GpuBackend() override;

	bool prepare(const FieldSetup &p_setup) override;
	bool set_field(const FieldSetup &p_setup) override;
	bool is_refused() const override { return needs_refused_pass(_setup); }
	bool can_simulate() override { return grass::can_simulate(kind_of(_setup)); }
	bool is_complete() const override;
	void step(const StepInput &p_input) override;
	StepTime read_step_time() override;
	bool can_join() override { return grass::can_join(kind_of(_setup)); }
	void join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) override;
	void resize_pool(int p_slots, std::span<const SlotMove> p_moves) override;
	int get_slots_at_once() const override { return SLOTS_AT_ONCE; }
	bool prepare_pool(int p_slots) override;
	void draw(const FieldView &p_view) override;
	void show_between(bool p_is_between, float p_share) override;
	void show_motion(bool p_is_read, bool p_has_blown) override;
	void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform) override;
	void set_plants(const std::vector<DrawnPlant> &p_plants, const PlantCull::PlantsOf &p_plants_of) override;
	void set_map(const MapBinding &p_map) override;
	void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value) override;
	void set_look(const Look &p_look) override;
	void set_cover(const std::shared_ptr<const TileCover> &p_cover, const TileRange &p_changed) override;
	void set_measure_time(bool p_measure) override { _measure = p_measure; }

	std::vector<SimulatedKnots> find_knots(std::span<const WantedBlade> p_blades) override { return _knots.find_knots(p_blades); }
	std::vector<SimulatedKnots> wait_for_knots(std::span<const WantedBlade> p_blades) override { return _knots.wait_for_knots(p_blades); }
	void read_asked(const SlotOf &p_slot_of) override { _knots.read_asked(p_slot_of, _steps); }
	EnergyReport read_energy() override;
	BackendStatistics get_statistics() override;
	BackendMemory get_memory() const override;
	const char *get_name() const override { return "GPU"; }

private:
	// 8.6 MB. More: a driver takes longer to make them than a frame has to spare. Fewer: tiles wait for a tick or two more often.
	static constexpr int SLOTS_AT_ONCE = 256;

	FieldMultiMeshes multimeshes() const;
	bool prepare_patch(const std::shared_ptr<const Patch> &p_patch);
	void set_bounds(const godot::AABB &p_bounds);
	SharedMesh find_mesh(LevelSet p_all) const;
	void fit_meshes(const FieldView &p_view);

	FieldSetup _setup;
	bool _measure = false;
	godot::Ref<godot::ImageTexture> _patch_texture; // outlives the materials that read it
	std::shared_ptr<const Patch> _next_patch; // of the next field, once its texture is made
	godot::Ref<godot::ImageTexture> _next_patch_texture;
	godot::Ref<godot::Texture2DRD> _pool_texture, _pool_before_texture; // the second for motion vectors
	godot::Ref<godot::Texture2DRD> _drawn_texture; // GRASS_CULL_DRAWN
	BladeMaterials _materials;
	FieldInstance _picture, _shadows;
	// Of the last frame: the view; the levels that tiles may have in it; those that the meshes have, of picture and shadows at least one.
	FieldView _view;
	bool _is_fitted = false; // to that view
	int64_t _drawn_jobs = -1; // posted up to that frame; -1: it is to be drawn again
	uint64_t _frames = 0; // drawn
	LevelSet _levels = 0, _surfaces = LevelSet(1) << (GRASS_LOD_LEVELS - 1) | LevelSet(1) << (GRASS_ALL_LEVELS - 1);
	TileCover::Tile _ground = TileCover::FULL; // see find_levels()
	Plants _plants;
	PaintedSpecies _painted; // for the pass that chooses plants, if there are any
	godot::AABB _bounds; // of the blades
	bool _has_motion = false; // something reads motion vectors
	bool _is_flipped = false; // whether the picture's instance is, see show_motion()
	bool _has_stepped = false; // since the last frame
	bool _is_between = false; // frames show a mix of two steps
	float _share = 1.0f; // of the last step, in the last frame
	std::shared_ptr<GpuReport> _report;
	uint64_t _energy_step = 0; // the step after which `_energy` and `_bends` were read
	std::vector<float> _energy;
	std::vector<Eigen::Vector3f> _bends;
	uint64_t _steps = 0; // passed to the device so far
	FieldJobs _jobs;
	KnotQueries _knots;
	NextRoom _next_room;
};

} // namespace grass
