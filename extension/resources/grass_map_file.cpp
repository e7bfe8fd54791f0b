// SPDX-License-Identifier: MIT
#include "resources/grass_map_file.h"

#include "resources/grass_map.h"
#include "resources/size_limits.h"
#include "shared/convert.h"
#include "shared/text.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/resource_saver.hpp>

#include <algorithm>
#include <mutex>

using namespace godot;

namespace grass {

namespace {

constexpr char EXTENSION[] = "grassmap";
constexpr int MOST_LINKS = 32; // from one file to the next; as many as systems follow

Ref<GrassMapLoader> loader;
Ref<GrassMapSaver> saver;

MapBytes pack(std::span<const uint8_t> p_bytes) {
	const PackedByteArray packed = to_bytes(p_bytes).compress(FileAccess::COMPRESSION_ZSTD);
	return MapBytes(packed.ptr(), packed.ptr() + packed.size());
}

bool unpack(std::span<const uint8_t> p_packed, std::span<uint8_t> r_bytes) {
	const PackedByteArray bytes = to_bytes(p_packed).decompress(int64_t(r_bytes.size()), FileAccess::COMPRESSION_ZSTD);
	if (size_t(bytes.size()) != r_bytes.size()) {
		return false;
	}
	std::copy_n(bytes.ptr(), r_bytes.size(), r_bytes.begin());
	return true;
}

Error fail(Error p_error, const String &p_message) {
	ERR_PRINT(p_message);
	return p_error;
}

// Returns the file that links lead to, which is to be replaced, not the link. Empty: they lead round in a circle.
String behind_links(const String &p_path) {
	String path = p_path;
	for (int i = 0; i < MOST_LINKS; i++) {
		const String folder = path.get_base_dir();
		const Ref<DirAccess> directory = DirAccess::open(folder);
		if (directory.is_null() || !directory->is_link(path.get_file())) {
			return path;
		}
		const String target = directory->read_link(path.get_file());
		if (target.is_empty() || target == path) { // what Windows shows like a link: a file that a cloud holds
			return path;
		}
		path = target.is_absolute_path() ? target : folder.path_join(target);
	}
	return String();
}

} // namespace

const MapCodec &engine_codec() {
	static const MapCodec codec{ pack, unpack };
	return codec;
}

Ref<GrassMap> load_map_file(const String &p_path) {
	const Ref<FileAccess> file = FileAccess::open(p_path, FileAccess::READ);
	ERR_FAIL_COND_V_MSG(file.is_null(), Ref<GrassMap>(),
			vformat("Cannot open the grass map '%s'. Check that the file exists and can be read.", p_path));
	Ref<GrassMap> map;
	map.instantiate();
	const String reason = map->read(file->get_buffer(int64_t(file->get_length())));
	ERR_FAIL_COND_V_MSG(!reason.is_empty(), Ref<GrassMap>(), vformat("Cannot load the grass map '%s': the file %s.", p_path, reason));
	return map;
}

PackedStringArray GrassMapLoader::_get_recognized_extensions() const {
	PackedStringArray extensions;
	extensions.push_back(EXTENSION);
	return extensions;
}

bool GrassMapLoader::_handles_type(const StringName &p_type) const {
	return p_type == StringName("GrassMap") || p_type == StringName("Resource");
}

String GrassMapLoader::_get_resource_type(const String &p_path) const {
	return p_path.get_extension().to_lower() == EXTENSION ? "GrassMap" : "";
}

Variant GrassMapLoader::_load(const String &p_path, const String &p_original_path, bool p_use_sub_threads, int32_t p_cache_mode) const {
	(void)p_original_path; // maps are not imported
	(void)p_use_sub_threads;
	(void)p_cache_mode; // handled by the engine
	const Ref<GrassMap> map = load_map_file(p_path);
	return map.is_valid() ? Variant(map) : Variant(FileAccess::file_exists(p_path) ? ERR_FILE_CORRUPT : ERR_FILE_CANT_OPEN);
}

bool GrassMapSaver::_recognize(const Ref<Resource> &p_resource) const {
	return Object::cast_to<GrassMap>(p_resource.ptr()) != nullptr;
}

PackedStringArray GrassMapSaver::_get_recognized_extensions(const Ref<Resource> &p_resource) const {
	PackedStringArray extensions;
	if (_recognize(p_resource)) {
		extensions.push_back(EXTENSION);
	}
	return extensions;
}

Error GrassMapSaver::_save(const Ref<Resource> &p_resource, const String &p_path, uint32_t p_flags) {
	(void)p_flags; // a map refers to no other resource
	const GrassMap *map = Object::cast_to<GrassMap>(p_resource.ptr());
	ERR_FAIL_NULL_V(map, ERR_INVALID_PARAMETER);
	return Error(save_map_file(*map, p_path));
}

int64_t save_map_file(const GrassMap &p_map, const String &p_path) {
	const ReadLimits limits = get_read_limits();
	const size_t bytes = size_t(p_map.get_memory_usage());
	if (bytes > limits.map_bytes) {
		WARN_PRINT(vformat("The grass map '%s' takes %s of memory, but a map that is read may take at most %s. It is saved, but it cannot "
						   "be loaded until that limit is raised%s.",
				p_path, text_of(megabytes(bytes)), text_of(megabytes(limits.map_bytes)), text_of(limits.map_hint)));
	}
	return write_map_file(p_map.get_data(), p_path);
}

Error write_map_file(const PackedByteArray &p_data, const String &p_path, const String &p_what) {
	static std::mutex mutex; // two threads may write the same file
	std::lock_guard lock(mutex);
	const String path = behind_links(p_path);
	if (path.is_empty()) {
		return fail(ERR_FILE_BAD_PATH,
				vformat("Cannot save %s '%s': its links lead to each other, not to a file. Remove them.", p_what, p_path));
	}
	const String unfinished = path + String(".tmp");
	const Ref<FileAccess> file = FileAccess::open(unfinished, FileAccess::WRITE);
	if (file.is_null()) {
		return fail(FileAccess::get_open_error(),
				vformat("Cannot save %s '%s': '%s' cannot be written. Check that the folder exists and can be written to.", p_what, p_path,
						unfinished));
	}
	const bool stored = file->store_buffer(p_data) && file->get_error() == OK;
	file->close();
	if (!stored || FileAccess::get_file_as_bytes(unfinished) != p_data) {
		DirAccess::remove_absolute(unfinished);
		return fail(ERR_FILE_CANT_WRITE,
				vformat("Cannot save %s '%s': writing failed. Check whether the disk is full. The old file is unchanged.", p_what, p_path));
	}
	const Error renamed = DirAccess::rename_absolute(unfinished, path);
	if (renamed != OK) {
		DirAccess::remove_absolute(unfinished);
		return fail(renamed, vformat("Cannot save %s '%s': the old file cannot be replaced. It is unchanged.", p_what, p_path));
	}
	return OK;
}

void register_map_files() {
	loader.instantiate();
	saver.instantiate();
	ResourceLoader::get_singleton()->add_resource_format_loader(loader, true);
	ResourceSaver::get_singleton()->add_resource_format_saver(saver, true);
}

void unregister_map_files() {
	ResourceLoader::get_singleton()->remove_resource_format_loader(loader);
	ResourceSaver::get_singleton()->remove_resource_format_saver(saver);
	loader.unref();
	saver.unref();
}

} // namespace grass
