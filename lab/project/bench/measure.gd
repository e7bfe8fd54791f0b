# SPDX-License-Identifier: MIT
## Functions that all parts of the bench use. It loads none of them: scripts that load each other in a ring are never freed.
extends RefCounted


static func is_software() -> bool:
	return RenderingServer.get_rendering_device() == null or RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU


## Returns the median; 0 without values.
static func median(p_values: Array[float]) -> float:
	var sorted := p_values.duplicate()
	sorted.sort()
	return sorted[sorted.size() >> 1] if sorted else 0.0
