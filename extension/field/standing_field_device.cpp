// SPDX-License-Identifier: MIT
// Which device runs the field, why it is not the graphics device, and what it cannot do.
#include "cpu/cpu_backend.h"
#include "field/standing_field.h"
#include "gpu/device.h"
#include "gpu/gpu_backend.h"
#include "gpu/obstacles.h"

using namespace godot;

namespace grass {

void StandingField::begin_passes() const {
	if (!_properties.is_on_cpu) {
		grass::begin_passes({ { !_properties.species.is_plain(), _properties.method }, _properties.species.has_plant_meshes(),
				_properties.map.is_valid() });
	}
}

void StandingField::make_backend() {
	_part = Part::NOTHING;
	_backend.reset();
	const FieldSetup &setup = _field.get_setup();
	if (setup.patch->is_empty()) {
		return;
	}
	if (wants_device() && find_obstacle(setup).is_empty()) {
		_backend = std::make_unique<GpuBackend>(setup);
	} else {
		_backend = std::make_unique<CpuBackend>(setup);
	}
	_part = Part::LOOK;
	update_measuring();
	_builds++;
}

void StandingField::leave_device() {
	drop_backend();
	_part = Part::BACKEND;
	_rows_shown = 0;
}

bool StandingField::wants_device() const {
	return !_properties.is_on_cpu && main_device() != nullptr;
}

String StandingField::refusal_warning() const {
	const FieldSetup &setup = _field.get_setup();
	const bool is_refused = wants_device() && needs_refused_pass(setup);
	return is_refused ? obstacle_warning() : String();
}

String StandingField::obstacle_warning() const {
	const String obstacle = find_obstacle(_field.get_setup());
	return obstacle.is_empty() ? obstacle : vformat("The CPU simulates and draws this field, which takes more time. %s", obstacle);
}

void StandingField::warn_of_device(PackedStringArray &r_warnings) const {
	const FieldSetup &setup = _field.get_setup();
	if (!wants_device() || !setup.patch) {
		return;
	}
	if (const String warning = obstacle_warning(); !warning.is_empty()) {
		r_warnings.push_back(warning);
		return;
	}
	FieldSetup wanted = setup;
	wanted.pool_size = int(_properties.pool_tiles);
	wanted.drawn_tiles_max = int(_properties.param(PARAM_DRAWN_TILES_MAX));
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
				vformat("`drawn_tiles_max` is %d, but the graphics device has room for %d: storage buffers of %d MiB. Lower it to %d.",
						wanted.drawn_tiles_max, fit.drawn_tiles_max, limits.buffer_bytes >> 20, fit.drawn_tiles_max));
	}
}

String StandingField::crowded_warning() const {
	return vformat(
			"More tiles are in view than there is room for: %d, and %d that cast shadows. Some far ones are left out (see `left_out_tiles` "
			"in get_statistics()). Raise `drawn_tiles_max`, lower `density` for fewer, larger tiles, or bring the camera's far plane "
			"nearer.",
			_field.get_setup().instance_capacity(), _field.get_setup().shadow_capacity());
}

String StandingField::blind_warning() {
	return "`simulation_budget` has no effect: this device measures no times, so every drawn blade is simulated. Lower `pool_tiles`, or "
		   "raise `pixels_min`, to make the simulation cheaper.";
}

} // namespace grass
