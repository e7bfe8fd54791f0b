// SPDX-License-Identifier: MIT
#include "field/field_device.h"

#include "cpu/cpu_backend.h"
#include "gpu/device.h"
#include "gpu/gpu_backend.h"
#include "gpu/obstacles.h"

using namespace godot;

namespace grass {

namespace {

bool wants_device(const FieldProperties &p_properties) {
	return !p_properties.is_on_cpu && main_device() != nullptr;
}

String obstacle_warning(const FieldSetup &p_setup) {
	const String obstacle = find_obstacle(p_setup);
	return obstacle.is_empty() ? obstacle : vformat("The CPU simulates and draws this field, which takes more time. %s", obstacle);
}

} // namespace

void begin_passes(const FieldProperties &p_properties) {
	if (!p_properties.is_on_cpu) {
		begin_passes({ { !p_properties.species.is_plain(), p_properties.method }, p_properties.species.has_plant_meshes(),
				p_properties.map.is_valid() });
	}
}

std::unique_ptr<Backend> make_backend(const FieldProperties &p_properties, const FieldSetup &p_setup) {
	if (p_setup.patch->is_empty()) {
		return nullptr;
	}
	if (wants_device(p_properties) && find_obstacle(p_setup).is_empty()) {
		return std::make_unique<GpuBackend>(p_setup);
	}
	return std::make_unique<CpuBackend>(p_setup);
}

String refusal_warning(const FieldProperties &p_properties, const FieldSetup &p_setup) {
	return wants_device(p_properties) && needs_refused_pass(p_setup) ? obstacle_warning(p_setup) : String();
}

void warn_of_device(const FieldProperties &p_properties, const FieldSetup &p_setup, PackedStringArray &r_warnings) {
	if (!wants_device(p_properties) || !p_setup.patch) {
		return;
	}
	if (const String warning = obstacle_warning(p_setup); !warning.is_empty()) {
		r_warnings.push_back(warning);
		return;
	}
	FieldSetup wanted = p_setup;
	wanted.pool_size = int(p_properties.pool_tiles);
	wanted.drawn_tiles_max = int(p_properties.param(PARAM_DRAWN_TILES_MAX));
	const DeviceLimits &limits = device_limits();
	const DeviceFit fit = fit_device(limits, wanted);
	if (wanted.pool_size > fit.pool_size) {
		r_warnings.push_back(
				vformat("`pool_tiles` is %d, but the graphics device has room for %d: storage buffers of %d MiB, textures of %d rows. "
						"Lower it to %d.",
						wanted.pool_size, fit.pool_size, limits.buffer_bytes >> 20, limits.texture_side, fit.pool_size));
	}
	if (wanted.drawn_tiles_max > fit.drawn_tiles_max) {
		r_warnings.push_back(
				vformat("`drawn_tiles_max` is %d, but the graphics device has room for %d: storage buffers of %d MiB, textures of %d rows. "
						"Lower it to %d.",
						wanted.drawn_tiles_max, fit.drawn_tiles_max, limits.buffer_bytes >> 20, limits.texture_side, fit.drawn_tiles_max));
	}
}

String crowded_warning(const FieldSetup &p_setup) {
	return vformat(
			"More tiles are in view than there is room for: %d, and %d that cast shadows. Some far ones are left out (see `left_out_tiles` "
			"in get_statistics()). Raise `drawn_tiles_max`, lower `density` for fewer, larger tiles, or bring the camera's far plane "
			"nearer.",
			p_setup.instance_capacity(), p_setup.shadow_capacity());
}

String blind_warning() {
	return "`simulation_budget` has no effect: this device measures no times, so every drawn blade is simulated. Lower `pool_tiles`, or "
		   "raise `pixels_min`, to make the simulation cheaper.";
}

} // namespace grass
