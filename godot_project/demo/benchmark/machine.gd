# SPDX-License-Identifier: MIT
## What a result must say about the machine. Nothing that names its owner.
extends RefCounted

const KINDS := ["other", "integrated", "discrete", "virtual", "software"]  # RenderingDevice.DeviceType


static func describe() -> Dictionary:
	var driver := OS.get_video_adapter_driver_info()
	var window := DisplayServer.window_get_size()
	return {
		device = RenderingServer.get_video_adapter_name(),
		vendor = RenderingServer.get_video_adapter_vendor(),
		kind = KINDS[RenderingServer.get_video_adapter_type()] if is_drawn() else "none",
		driver = " ".join(driver),
		api = RenderingServer.get_video_adapter_api_version(),
		renderer = RenderingServer.get_current_rendering_method(),
		rendering_driver = RenderingServer.get_current_rendering_driver_name(),
		processor = "%s, %d threads" % [OS.get_processor_name(), OS.get_processor_count()],
		system = "%s %s" % [OS.get_name(), OS.get_version()],
		engine = Engine.get_version_info().string,
		build = "debug" if OS.is_debug_build() else "release",
		window = "%d x %d" % [window.x, window.y],
	}


static func is_drawn() -> bool:
	return DisplayServer.get_name() != "headless"


## Returns whether the processor draws: the benchmark is then smaller.
static func is_software() -> bool:
	return not is_drawn() or RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU or _is_llvmpipe()


static func _is_llvmpipe() -> bool:  # OpenGL does not say what kind of device it has
	return RenderingServer.get_video_adapter_name().containsn("llvmpipe")
