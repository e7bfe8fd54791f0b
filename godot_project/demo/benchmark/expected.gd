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
			"fffffefaf9f2dfe0cfe0e1d0ddddcbdadac6f3f1e3fffff6fffef4babc9f6f7b48768854758b5888996cc3c6a8faf8e9"
			+ "d9d8c17c895978875580946383986c768c5b9ba87bd8d6be8b97697686517e895b899768909f74919f7497a476849362"
			+ "74874c74824f7e8b58879263889464a8af849ba4798892636f7f4c6b79467e8d59869262828e5d99a270a3a981798853"
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
			"fffffef5f6edd3d9c4d5dbc5d3d8c1cbd0b4e9ead5fffff6fdfdf3a6af8968753f6f824b6d854d7c8f5aaeb78ef4f5e4"
			+ "c7cfb070814b70814a768c557a915e6d854f8e9e6ac8cca97c8e586f804874814f7e8f5b8395648696648a9a667a8d55"
			+ "7085476d7c4675854f7d8a577e8d5898a3718e9a687d8a56697a446776417787527a88567a88548d996397a07272834a"
		),
	},
}


## By the name of a picture, for the renderer in use.
static func cells() -> Dictionary:
	var method := RenderingServer.get_current_rendering_method()
	return CELLS.get(method, CELLS.rd)
