# SPDX-License-Identifier: MIT
## What the benchmark's pictures look like: the mean colours of their cells, red, green and blue, row by row, two digits each. As software
## Vulkan and OpenGL draw them (`cells` in a result file); Forward+ and Mobile look the same.
extends RefCounted

const CELLS := {
	rd =
	{
		bare_disc =
		(
			"fffffef6f7ecd3dbb4dbe2c2d9dfbecbd5a9e4e8ccfffff7fdfdf2b9bf887b8f37738b366d88356f8c359bad64f0f3dc"
			+ "d6dbb67b8d3e6f86336a83349fab7a688038708837b8c28e8b99546f8033728435687e32f2eddc94a26b697d32788c41"
			+ "6d80346c7b317282346c7c318a945475863e687b2f70833366782e6b7b316e80326b7b31718033697a2f6f7c336a7930"
		),
		pressed =
		(
			"fffffef6f7ecd3dbb4dbe2c2d9dfbecbd5a9e4e8ccfffff7fdfdf2b9bf887b8f37748b366c87346f8d369bad64f0f3dc"
			+ "d6dbb67a8d3e6e85335e762d617d31657f33708837b8c28e8b99546f803371833463792e5f792e627b2f697d32788c41"
			+ "6d80346c7b317282346d7e317080336a7e30687b2f70833366782e6b7b316e80326b7b317181336b7c306e7c336a7930"
		),
		daisies =
		(
			"fffffef9f9f4dee1cedee0cedfe0ccd5d9c3ecedddfefef5fffef5b0b4906d7b4774875270874d839561bcc39ef6f6e4"
			+ "d8d8c075855275854f7b915b85996971885298a777d2d3b4859463758550798655879664899b6a8c9b6d96a57682935e"
			+ "71864a707f49798855828f5d859361a3ad8199a474828e5c6d7e4a6775407b8c577f8c5c808e5c97a270a1a97e7a8a53"
		),
	},
	gl_compatibility =
	{
		bare_disc =
		(
			"fffffef5f7ecd1dab1d8e0bed8dfbdccd6aae6eacffffff7fdfef3b3bc827c8f36748c356d8834708e3498ab61f1f4dc"
			+ "cfd8af778c396f863269833398a871688036718936b3c0898395496f8132728434677d2fedebd6909f65687d30758a3c"
			+ "6d80326c7b307181336c7d3086924e74863a697b2f71843366782d6b7c306d7f316b7b2f7181326a7a2e6e7b326a792f"
		),
		pressed =
		(
			"fffffef5f7ecd1dab1d8e0bed8dfbdccd6aae6eacffffff7fdfef3b3bc827c8f36758c366d8833708e3598ab61f1f4dc"
			+ "cfd8af778c396e85325f772d617c30657f32718936b3c0898395496f813270833363792d5f7a2d637c2e687d30758a3c"
			+ "6d80326c7b307182326e7f317080336a7e30697b2f71843366782d6b7c306d7f316b7b2f7181326c7c2f6e7b326a792f"
		),
		daisies =
		(
			"fffffef6f7efd4d9c6d6dcc7d4d9c3d0d4bae8e9d7fffff6fdfef3a6ae8b6a774371844e6f8750819361b8c09cf4f5e4"
			+ "c9d0b273844f72834e7a8f5b80956470865297a574ced1b07f915c72824c788453859462899a6a8d9c6c94a3727d8f59"
			+ "708649717e4a788752828e5d83915ea1ab7d97a272838f5c6c7d486877437a8b567d8b59808e5b95a16e9ea67a778750"
		),
	},
}


## By the name of a picture, for the renderer in use.
static func cells() -> Dictionary:
	var method := RenderingServer.get_current_rendering_method()
	return CELLS.get(method, CELLS.rd)
