// SPDX-License-Identifier: MIT
// Pictures of GrassSpecies resources in the inspector and in the file dock.
#pragma once

#include "resources/grass_species.h"

#include <godot_cpp/classes/editor_resource_preview_generator.hpp>
#include <godot_cpp/classes/image.hpp>

namespace grass {

// Draws p_plant, the species' mesh, or if it is null its blades with p_look, on a transparent ground.
godot::Ref<godot::Image> draw_picture(
		const GrassSpecies &p_species, const SpeciesLook &p_look, const std::shared_ptr<const PlantModel> &p_plant, int p_side);

class SpeciesPreview : public godot::EditorResourcePreviewGenerator {
	GDCLASS(SpeciesPreview, godot::EditorResourcePreviewGenerator)

public:
	bool _handles(const godot::String &p_type) const override;
	bool _generate_small_preview_automatically() const override { return true; }
	// Runs on one of the editor's threads.
	godot::Ref<godot::Texture2D> _generate(const godot::Ref<godot::Resource> &p_resource, const godot::Vector2i &p_size,
			const godot::Dictionary &p_metadata) const override;

protected:
	static void _bind_methods() {}
};

} // namespace grass
