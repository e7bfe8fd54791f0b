// SPDX-License-Identifier: MIT
#include "gpu/obstacles.h"

#include "gpu/device.h"
#include "gpu/field_passes.h"
#include "shared/text.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

constexpr const char *ADVICE = "Update the graphics driver. On Windows, `rendering/rendering_device/driver.windows` in the project "
							   "settings selects another one: vulkan or d3d12.";

// The engine does not expose the limit of storage buffers. These are assumed limits of Vulkan drivers for the cards of these makers, not
// read from the drivers. All others get only the 128 MiB that Vulkan guarantees.
struct Maker {
	const char *name;
	int64_t buffer_bytes;
	bool has_quick_arrays;
};
constexpr Maker MAKERS[] = { { "NVIDIA", UINT32_MAX, true }, { "AMD", UINT32_MAX, false }, { "Intel", int64_t(1) << 30, false } };

DeviceLimits read_limits(RenderingDevice *p_device) {
	DeviceLimits limits;
	if (p_device == nullptr) {
		return limits;
	}
	const auto read = [&](RenderingDevice::Limit p_limit, int64_t &r_value) {
		const uint64_t value = p_device->limit_get(p_limit);
		if (value > 0) { // otherwise the driver does not report it
			r_value = int64_t(std::min<uint64_t>(value, INT64_MAX));
		}
	};
	read(RenderingDevice::LIMIT_MAX_TEXTURE_SIZE_2D, limits.texture_side);
	read(RenderingDevice::LIMIT_MAX_STORAGE_BUFFERS_PER_SHADER_STAGE, limits.buffers);
	read(RenderingDevice::LIMIT_MAX_COMPUTE_SHARED_MEMORY_SIZE, limits.shared_bytes);
	read(RenderingDevice::LIMIT_MAX_PUSH_CONSTANT_SIZE, limits.constant_bytes);
	const bool is_vulkan = RenderingServer::get_singleton()->get_current_rendering_driver_name() == String("vulkan");
	const String vendor = p_device->get_device_vendor_name();
	for (const Maker &maker : MAKERS) {
		if (vendor == String(maker.name)) {
			limits.buffer_bytes = is_vulkan ? maker.buffer_bytes : limits.buffer_bytes;
			limits.has_quick_arrays = maker.has_quick_arrays;
		}
	}
	return limits;
}

String device_words() {
	RenderingServer *server = RenderingServer::get_singleton();
	return vformat("%s, %s %s", server->get_video_adapter_name(), server->get_current_rendering_driver_name(),
			server->get_video_adapter_api_version());
}

} // namespace

const DeviceLimits &device_limits() {
	static const DeviceLimits limits = read_limits(main_device());
	return limits;
}

bool needs_refused_pass(const FieldSetup &p_setup) {
	return CompileQueue::get().has_refused() && find_refused(passes_of(p_setup)) != nullptr;
}

String find_obstacle(const FieldSetup &p_setup) {
	if (const std::string lack = fit_device(device_limits(), p_setup).lack; !lack.empty()) {
		return text_of(lack);
	}
	const char *pass = find_refused(passes_of(p_setup));
	return pass == nullptr ? String() : vformat("The graphics driver refused the compute pass '%s' (%s). %s", pass, device_words(), ADVICE);
}

void report_refusals() {
	if (!CompileQueue::get().has_refused()) {
		return;
	}
	for (const PassCode &code : CompileQueue::get().take_refused()) {
		const auto say = [&](const char *p_instead) {
			return vformat("GrassField: the graphics driver refused the compute pass '%s' (%s). %s %s", code.name, device_words(),
					p_instead, ADVICE);
		};
		if (code.has_stand_in) {
			WARN_PRINT(
					say("The pass for all kinds of tiles replaces it. It is slower, and blades meet sharp edges with their knots only."));
		} else {
			ERR_PRINT(say("Fields that need it are simulated and drawn by the CPU from now on, which takes more time."));
		}
	}
}

} // namespace grass
