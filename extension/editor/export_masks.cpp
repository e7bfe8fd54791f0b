// SPDX-License-Identifier: MIT
#include "editor/export_masks.h"

#include "resources/grass_fill_rule.h"

#include <godot_cpp/classes/time.hpp>

using namespace godot;

namespace grass {

bool ExportMasks::_begin_customize_resources(const Ref<EditorExportPlatform> &p_platform, const PackedStringArray &p_features) const {
	(void)p_platform;
	return p_features.has("dedicated_server");
}

// Null: it stays as it is.
Ref<Resource> ExportMasks::_customize_resource(const Ref<Resource> &p_resource, const String &p_path) {
	const GrassFillRule *rule = Object::cast_to<GrassFillRule>(p_resource.ptr());
	if (rule == nullptr || rule->get_kept_mask().is_valid() || rule->get_mask_state() == GrassFillRule::MASK_NONE) {
		return {};
	}
	const Ref<GrassFillRule> kept = rule->with_kept_mask();
	if (kept.is_null()) {
		get_export_platform()->add_message(EditorExportPlatform::EXPORT_MESSAGE_WARNING, "GrassField",
				vformat("The picture of the mask of a GrassFillRule (%s) is not there while the export runs, so on the server nothing "
						"grows "
						"by it. Choose *Keep* for the picture in the preset's tab *Resources*; a NoiseTexture2D's, save as a file.",
						p_path.is_empty() ? String("in a scene") : p_path));
	}
	return kept;
}

// The engine keeps customized resources until their file or this number changes. The picture of a mask is another file.
uint64_t ExportMasks::_get_customization_configuration_hash() const {
	return Time::get_singleton()->get_ticks_usec();
}

} // namespace grass
