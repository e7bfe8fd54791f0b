# SPDX-License-Identifier: MIT
## What the sun of a landscape has besides its light: shadows that reach as far as the groves, and a disc with a glow in the sky.
extends RefCounted

const REACH := 260.0  # metres, of shadows: as far as groves are seen one tree from another
const SPLITS: Array[float] = [7.0, 16.0, 62.0]  # metres: near shadows are as fine as with a short reach
const DISC := 0.4  # degrees, half of its width
const BRIGHTNESS := 4.0  # of the disc, over the light's energy
const GLOW := 30.0  # degrees from its middle up to which it lights the sky
const GLOW_CURVE := 0.04  # the less, the more of the glow is near the disc


## Completes the sun of a scene whose sky is a ProceduralSkyMaterial.
static func complete(sun: DirectionalLight3D, sky: ProceduralSkyMaterial) -> void:
	_reach_far(sun)
	sky.sun_angle_max = GLOW
	sky.sun_curve = GLOW_CURVE
	var disc := DirectionalLight3D.new()  # a light of its own: one with a size would blur shadows, which takes time
	disc.name = "Disc"
	disc.sky_mode = DirectionalLight3D.SKY_MODE_SKY_ONLY
	disc.light_angular_distance = DISC
	sun.sky_mode = DirectionalLight3D.SKY_MODE_LIGHT_ONLY
	sun.add_child(disc)
	follow(sun)


## Gives the disc the light that the sun has now.
static func follow(sun: DirectionalLight3D) -> void:
	var disc: DirectionalLight3D = sun.get_node(^"Disc")
	disc.light_color = sun.light_color
	disc.light_energy = BRIGHTNESS * sun.light_energy


## In software, where scenes have one cascade, shadows reach as far as before.
static func _reach_far(sun: DirectionalLight3D) -> void:
	if RenderingServer.get_video_adapter_type() == RenderingDevice.DEVICE_TYPE_CPU:
		return
	sun.directional_shadow_max_distance = REACH
	sun.directional_shadow_split_1 = SPLITS[0] / REACH
	sun.directional_shadow_split_2 = SPLITS[1] / REACH
	sun.directional_shadow_split_3 = SPLITS[2] / REACH
