// SPDX-License-Identifier: MIT
// The backend without a RenderingDevice: simulates on the engine's worker threads, chooses the tiles to draw on the CPU, and draws one
// MultiMesh for each level of detail. Headless it only simulates: no frame is ever drawn.
#pragma once

#include "core/field/pool_texels.h"
#include "core/lod/field_levels.h"
#include "core/solver/simulate.h"
#include "draw/backend.h"
#include "draw/blade_materials.h"
#include "draw/field_instance.h"
#include "draw/patch_texture.h"
#include "draw/plants.h"

#include <godot_cpp/classes/image_texture.hpp>

#include <unordered_map>

namespace grass {

class CpuBackend : public Backend {
public:
	explicit CpuBackend(const FieldSetup &p_setup);

	bool prepare(const FieldSetup &p_setup) override {
		(void)p_setup; // it has no passes
		return true;
	}
	bool set_field(const FieldSetup &p_setup) override;
	void step(const StepInput &p_input) override;
	StepTime read_step_time() override { return { uint64_t(_statistics.timed_steps), _statistics.simulate_ms }; }
	void join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) override;
	void resize_pool(int p_slots, std::span<const SlotMove> p_moves) override;
	void draw(const FieldView &p_view) override;
	void show_between(bool p_is_between, float p_share) override {
		_texels.set_between(p_is_between);
		_share = p_share;
	}
	void follow(godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform) override;
	void set_plants(const std::vector<DrawnPlant> &p_plants, const PlantCull::PlantsOf &p_plants_of) override;
	void set_uniform(const godot::StringName &p_name, const godot::Variant &p_value) override;
	void set_look(const Look &p_look) override;
	void set_cover(const std::shared_ptr<const TileCover> &p_cover, const TileRange &p_changed) override;
	void set_measure_time(bool p_measure) override { _measure = p_measure; }

	std::vector<SimulatedKnots> find_knots(std::span<const WantedBlade> p_blades) override;
	std::vector<SimulatedKnots> wait_for_knots(std::span<const WantedBlade> p_blades) override { return find_knots(p_blades); }
	EnergyReport read_energy() override { return { _step_number > 0 ? _step_number - 1 : 0, _pool.get_energy(), _pool.get_bends() }; }
	uint64_t hash_blades() const override { return _pool.hash(); }
	BackendStatistics get_statistics() override;
	BackendMemory get_memory() const override;
	const char *get_name() const override { return "CPU"; }

private:
	void choose_tiles(const FieldView &p_view);
	void make_level(int p_level);
	LevelSet find_made_levels() const;
	int find_slot(int p_tile) const; // of a tile in the pool, or GRASS_NO_SLOT
	void choose_plants(const FieldView &p_view);
	void update_pool_texture();

	FieldSetup _setup;
	CpuPool _pool;
	bool _measure = false;
	uint64_t _step_number = 0; // of the last step
	BackendStatistics _statistics;
	FieldView _view; // for which the tiles in _levels were chosen
	bool _tiles_changed = true; // since then
	bool _is_drawn = false; // by a frame so far
	std::unordered_map<int, int> _slot_of_tile; // of awake tiles; only looked up, so its order does not matter

	std::shared_ptr<const TileCover> _cover; // null: no map
	godot::Ref<godot::ImageTexture> _patch_texture, _pool_texture; // outlive the materials that read them
	BladeMaterials _materials;
	int _pool_rows = 0; // of the pool texture
	PoolTexels _texels; // of the pool texture; uploaded before the next frame, which may never come (headless)
	float _share = 1.0f; // of the last step, in this frame
	uint64_t _followed = 0; // instance id of the node; 0: none yet
	godot::Transform3D _transform; // of follow()
	std::array<FieldInstance, GRASS_ALL_LEVELS> _levels; // each is made when a tile has it
	TileCull _cull;
	Plants _plants;
	PlantCull _plant_cull;
	PlantCull::PlantsOf _plants_of;
};

} // namespace grass
