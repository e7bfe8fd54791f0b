// SPDX-License-Identifier: MIT
// The passes that simulate a step, one for each kind of tile, and the buffer in which their threads work. Render thread.
#pragma once

#include "gpu/device.h"
#include "gpu/step_records.h"

#include <array>
#include <functional>
#include <memory>

namespace grass {

class StepPasses {
public:
	// Begins without passes. p_bind: binds what every pass reads of the field, except for the buffers of a step.
	explicit StepPasses(std::function<void(GpuPass &)> p_bind) : _bind(std::move(p_bind)) {}

	// Makes the passes of a field of this kind. Those for crowds and for many tiles are made when they are first needed.
	void create(const PassKind &p_kind);
	void free();
	// Binds again what every pass reads.
	void bind();
	bool is_ready() { return own(SlotPass::PLAIN).is_ready(); } // any step can be simulated
	// Returns the number of tiles in p_records that such a pass simulates, and no other one in its place.
	int64_t count_tiles(const StepRecords &p_records, SlotPass p_pass);

	// The buffers of a step's records.
	struct Uploaded {
		godot::RID slots, forces, colliders, collider_list, planes, sections;
	};
	// Makes room for the threads of a step. Must be called before dispatch().
	void make_room(const StepRecords &p_records);
	void dispatch(const StepRecords &p_records, const Uploaded &p_uploaded);
	void free_room() { _work.reset(); }

private:
	GpuPass &own(SlotPass p_pass, bool p_many = false) { return _passes[size_t(p_pass)][p_many ? 1 : 0]; }
	// Returns the pass that simulates workgroups of a kind: their own, or another one until that is compiled.
	GpuPass &find(SlotPass p_pass, bool p_many);

	std::function<void(GpuPass &)> _bind;
	PassKind _kind;
	std::array<std::array<GpuPass, 2>, SLOT_PASSES> _passes; // by SlotPass: with one tile in a workgroup, and with many
	// Lives for one dispatch, read and written by simulate: what its threads keep of their blades' joints, unless each has an array for it.
	std::shared_ptr<GpuBuffer> _work; // shared by all fields
};

} // namespace grass
