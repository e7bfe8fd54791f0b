// SPDX-License-Identifier: MIT
// Asks Microsoft's validator whether DXIL files are valid: `validate_dxil LIBDXCOMPILER FILE...`. Prints `FILE<tab>valid` or what is
// wrong. Compiled against the headers that come with the library (lab/tools/driver_tools.py).
#include "WinAdapter.h"

#include "dxcapi.h"

#include <dlfcn.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace {

template <class Interface> Interface *make(DxcCreateInstanceProc p_create, REFCLSID p_class) {
	Interface *made = nullptr;
	return p_create(p_class, __uuidof(Interface), reinterpret_cast<void **>(&made)) >= 0 ? made : nullptr;
}

// Returns what is wrong with a container; "valid" if nothing is.
std::string judge(IDxcLibrary &p_library, IDxcValidator &p_validator, const std::string &p_bytes) {
	IDxcBlobEncoding *blob = nullptr;
	IDxcOperationResult *result = nullptr;
	HRESULT status = -1;
	if (p_library.CreateBlobWithEncodingFromPinned(p_bytes.data(), UINT32(p_bytes.size()), 0, &blob) < 0 ||
			p_validator.Validate(blob, DxcValidatorFlags_Default, &result) < 0 || result->GetStatus(&status) < 0) {
		return "the validator failed";
	}
	if (status >= 0) {
		return "valid";
	}
	IDxcBlobEncoding *errors = nullptr;
	const bool has_errors = result->GetErrorBuffer(&errors) >= 0 && errors;
	std::string text = has_errors ? std::string(static_cast<const char *>(errors->GetBufferPointer()), errors->GetBufferSize()) : "invalid";
	for (char &letter : text) {
		letter = letter == '\n' || letter == '\0' ? ' ' : letter;
	}
	return text;
}

} // namespace

int main(int argc, char **argv) {
	void *compiler = argc > 1 ? dlopen(argv[1], RTLD_NOW) : nullptr;
	const auto create = compiler ? reinterpret_cast<DxcCreateInstanceProc>(dlsym(compiler, "DxcCreateInstance")) : nullptr;
	auto *library = create ? make<IDxcLibrary>(create, CLSID_DxcLibrary) : nullptr;
	auto *validator = create ? make<IDxcValidator>(create, CLSID_DxcValidator) : nullptr;
	if (!library || !validator) {
		std::fprintf(stderr, "usage: validate_dxil LIBDXCOMPILER FILE...\n%s\n", compiler || argc < 2 ? "" : dlerror());
		return 2;
	}
	for (int i = 2; i < argc; i++) {
		std::ifstream file(argv[i], std::ios::binary);
		const std::string bytes{ std::istreambuf_iterator<char>(file), {} };
		std::printf("%s\t%s\n", argv[i], judge(*library, *validator, bytes).c_str());
	}
	return 0;
}
