// SPDX-License-Identifier: MIT
#include "gpu/shader_cache.h"

#include "core/base/shader_file.h"
#include "gpu/device.h"
#include "shared/text.h"
#include "version.gen.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <utility>

using namespace godot;

namespace grass {

namespace {

constexpr char OUR_FOLDER[] = "/grass_field";

std::string to_text(const String &p_text) {
	return p_text.utf8().get_data();
}

// Returns the folder of the engine's own cache, so that emptying it empties ours too. The editor's folder is in the project, and no game
// has it.
std::string find_folder() {
	const ProjectSettings *settings = ProjectSettings::get_singleton();
	if (!bool(settings->get_setting("rendering/shader_compiler/shader_cache/enabled", true))) {
		return {};
	}
	const bool is_hidden = settings->get_setting("application/config/use_hidden_project_data_directory", true);
	return std::string(!Engine::get_singleton()->is_editor_hint() ? "user://"
						   : is_hidden                            ? "res://.godot/"
																  : "res://godot/") +
			"shader_cache";
}

// Identifies what the translation to DXIL depends on: the engine and the device's capabilities. The device's UUID changes with each start
// of Windows, since it includes the adapter's LUID (rendering_device_driver_d3d12.cpp).
std::string find_driver() {
	const RenderingServer *server = RenderingServer::get_singleton();
	const RenderingDevice *device = main_device();
	const String name = server->get_current_rendering_driver_name();
	const String uuid = name == String("d3d12") ? String() : device->get_device_pipeline_cache_uuid();
	return to_text(vformat("%s %s\n%s\n%s\n%s", name, server->get_video_adapter_api_version(), device->get_device_vendor_name(),
			device->get_device_name(), uuid));
}

std::string find_versions() {
	const Dictionary engine = Engine::get_singleton()->get_version_info();
	return to_text(vformat("Godot %s %s\nGrassField %s", engine["string"], engine["hash"], VERSION));
}

PackedByteArray read_file(const String &p_path, const std::string &p_key) {
	const Ref<FileAccess> file = FileAccess::open(p_path, FileAccess::READ);
	if (file.is_null() || file->get_length() > shader_file_bytes_most(p_key)) {
		return PackedByteArray();
	}
	const PackedByteArray bytes = file->get_buffer(int64_t(file->get_length()));
	return to_bytes(read_shader_file(p_key, { bytes.ptr(), size_t(bytes.size()) }));
}

// Writes under another name first, so that a reader finds the complete file, or the earlier one.
bool write_file(const String &p_path, const std::vector<uint8_t> &p_bytes) {
	const String unfinished = vformat("%s.%d.tmp", p_path, OS::get_singleton()->get_process_id());
	const Ref<FileAccess> file = FileAccess::open(unfinished, FileAccess::WRITE);
	if (file.is_null()) {
		return false;
	}
	const bool is_stored = file->store_buffer(to_bytes(std::span(p_bytes))) && file->get_error() == OK;
	file->close();
	if (is_stored && DirAccess::rename_absolute(unfinished, p_path) == OK) {
		return true;
	}
	DirAccess::remove_absolute(unfinished);
	return false;
}

} // namespace

bool ShaderCache::is_on() {
	if (!std::exchange(_has_looked, true)) {
		_folder = find_folder();
		_driver = find_driver();
		_versions = find_versions();
	}
	return !_folder.empty();
}

std::string ShaderCache::key_of(std::span<const uint32_t> p_spirv) const {
	return shader_key({ _driver, _versions }, p_spirv);
}

PackedByteArray ShaderCache::read(std::span<const uint32_t> p_spirv) {
	if (!is_on()) {
		return PackedByteArray();
	}
	const std::string key = key_of(p_spirv);
	return read_file(text_of(_folder + OUR_FOLDER + "/" + shader_file_name(key)), key);
}

void ShaderCache::write(std::span<const uint32_t> p_spirv, const PackedByteArray &p_shader) {
	if (!is_on()) {
		return;
	}
	const std::string key = key_of(p_spirv);
	const std::vector<uint8_t> bytes = write_shader_file(key, { p_shader.ptr(), size_t(p_shader.size()) });
	const String path = text_of(_folder + OUR_FOLDER + "/" + shader_file_name(key));
	if (!bytes.empty() && make_folder() && write_file(path, bytes)) {
		remove_surplus();
	}
}

// Creates one level at a time, since make_dir_recursive() reports an error for a folder that cannot be made.
bool ShaderCache::make_folder() const {
	for (const std::string &folder : { _folder, _folder + OUR_FOLDER }) {
		const String path = text_of(folder);
		if (!DirAccess::dir_exists_absolute(path) && DirAccess::make_dir_absolute(path) != OK && !DirAccess::dir_exists_absolute(path)) {
			return false;
		}
	}
	return true;
}

void ShaderCache::remove_surplus() const {
	const String folder = text_of(_folder + OUR_FOLDER + "/");
	std::vector<KeptFile> files;
	for (const String &name : DirAccess::get_files_at(folder)) {
		if (is_shader_file_name(to_text(name))) {
			files.push_back({ to_text(name), FileAccess::get_modified_time(folder + name) });
		}
	}
	for (const std::string &name : surplus_files(std::move(files), SHADER_FILES_MOST)) {
		DirAccess::remove_absolute(folder + text_of(name));
	}
}

} // namespace grass
