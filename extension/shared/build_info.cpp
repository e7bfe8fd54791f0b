// SPDX-License-Identifier: MIT
#include "shared/build_info.h"

#include "shared/text.h"

#include "version.gen.h"

#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <string>

using namespace godot;

namespace grass {

namespace {

std::string read_driver() {
	if (get_device().is_empty()) {
		return {};
	}
	const PackedStringArray driver = OS::get_singleton()->get_video_adapter_driver_info(); // runs system programs
	const String found = driver.size() > 1 ? driver[0] + String(" ") + driver[1] : String();
	const String shown = found.is_empty() ? RenderingServer::get_singleton()->get_video_adapter_api_version() : found;
	return shown.utf8().get_data();
}

} // namespace

String get_version() {
	return VERSION;
}

String get_device() {
	return RenderingServer::get_singleton()->get_video_adapter_name();
}

String get_driver() {
	static const std::string driver = read_driver(); // not a String, since the engine's memory must not outlive the engine
	return text_of(driver);
}

} // namespace grass
