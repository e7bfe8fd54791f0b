# SPDX-License-Identifier: MIT
## What the benchmark's pictures look like: the mean colours of their cells, red, green and blue, row by row, two digits each. As software
## Vulkan and OpenGL draw them (`cells` in a result file); Forward+ and Mobile look the same.
extends RefCounted

const CELLS := {
	rd =
	{
		bare_disc =
		(
			"fffffef8f8efd7dcbadce2c4dce1c2d1d8b2eaecd5fffff7fefef4bcc18d7d9037758c367e924b6d8b339cad67f3f4df"
			+ "d8dcba7b8f3f708733a4af7dfdf8ea8e9d66708638bbc3948c99567081347385368c995cf9f4e4a4ae7d687d32798d43"
			+ "6e80356d7c327282346e7e3288925275863c6a7c3072853567792e6c7c326e80326c7c317281336a7b2f6f7c336b7930"
		),
		pressed =
		(
			"fffffef8f8efd7dcbadce2c4dce1c2d1d8b2eaecd5fffff7fefef4bcc18d7d9037768d376d8935708e369dad68f3f4df"
			+ "d8dcba7b8f3f6f863360772f627d32668034738a39bbc3948c9956708134718434647a2e607b2f647d30697d32798d43"
			+ "6e80356d7c327283346f80337281356b7f316a7c3072853567792e6c7c326e80326c7c317382346d7d306f7c336b7930"
		),
		daisies =
		(
			"fffffefbfaf4e1e2d1e1e3d1dfe0cedddecaf3f1e4fffff6fffef4bbbda1737f4e7a8c5a778e5b8e9e73cbcfb4f9f8e9"
			+ "dbdac47f8e5e7b8a5a839768889d72788e5ea3af85dddbc48e9b6f798855808c5e8d9c6e93a27996a47a9eab80879666"
			+ "75894f778452808d5b8a96688c9869abb48ca0aa808a956672824f6c7b4880905d8592638693649da777a4ac837c8b57"
		),
	},
	gl_compatibility =
	{
		bare_disc =
		(
			"fffffef5f7ecd1dab1d8e0bed8dfbdccd6aae6eacffffff7fdfef3b3bc827c8f36748b357b91466d8b3297ab60f1f4dc"
			+ "cfd8af778c396f86329fac77fcf8e8879a5c6e8535b3c0898395496f8132728434879755f6f2e09daa74687c30758a3c"
			+ "6d80326c7b307181336d7d30828f49728438697b2f71843366782d6b7c306d7f316b7b2f7181326a7a2e6e7b326a792f"
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
