// SPDX-License-Identifier: MIT
// Loads and saves GrassMaps as separate files, NAME.grassmap, so that `load`, `ResourceSaver.save` and the inspector treat them as any
// resource. core/map/map_file.h describes the format; the engine's Zstandard compresses it.
#pragma once

#include "core/map/map_file.h"

#include <godot_cpp/classes/resource_format_loader.hpp>
#include <godot_cpp/classes/resource_format_saver.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace grass {

const MapCodec &engine_codec();
// Writes a new file beside the old one and replaces the old one once the new one is complete, so that a whole file exists at any time. May
// be called on any thread.
godot::Error write_map_file(
		const godot::PackedByteArray &p_data, const godot::String &p_path, const godot::String &p_what = "the grass map");
// Returns the map in a file, whatever its extension, or null after a message that names the file: never half a map.
godot::Ref<class GrassMap> load_map_file(const godot::String &p_path);
int64_t save_map_file(const GrassMap &p_map, const godot::String &p_path); // whatever its extension; returns an Error

class GrassMapLoader : public godot::ResourceFormatLoader {
	GDCLASS(GrassMapLoader, godot::ResourceFormatLoader)

public:
	godot::PackedStringArray _get_recognized_extensions() const override;
	bool _handles_type(const godot::StringName &p_type) const override;
	godot::String _get_resource_type(const godot::String &p_path) const override;
	// Returns the map, or an error code after a message that names the file: never half a map.
	godot::Variant _load(
			const godot::String &p_path, const godot::String &p_original_path, bool p_use_sub_threads, int32_t p_cache_mode) const override;

protected:
	static void _bind_methods() {}
};

class GrassMapSaver : public godot::ResourceFormatSaver {
	GDCLASS(GrassMapSaver, godot::ResourceFormatSaver)

public:
	bool _recognize(const godot::Ref<godot::Resource> &p_resource) const override;
	godot::PackedStringArray _get_recognized_extensions(const godot::Ref<godot::Resource> &p_resource) const override;
	godot::Error _save(const godot::Ref<godot::Resource> &p_resource, const godot::String &p_path, uint32_t p_flags) override;

protected:
	static void _bind_methods() {}
};

// Register loader and saver with the engine, and unregister them.
void register_map_files();
void unregister_map_files();

} // namespace grass
