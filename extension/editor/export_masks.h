// SPDX-License-Identifier: MIT
// An export for a dedicated server strips pictures (*Strip Visuals*), and with them the masks of rules: grass would grow in other places
// than on the clients. So in such an export the rule itself stores the picture.
#pragma once

#include <godot_cpp/classes/editor_export_platform.hpp> // a virtual method takes one
#include <godot_cpp/classes/editor_export_plugin.hpp>
#include <godot_cpp/variant/dictionary.hpp>

namespace grass {

class ExportMasks : public godot::EditorExportPlugin {
	GDCLASS(ExportMasks, godot::EditorExportPlugin)

public:
	godot::String _get_name() const override { return "GrassField masks"; }
	bool _begin_customize_resources(
			const godot::Ref<godot::EditorExportPlatform> &p_platform, const godot::PackedStringArray &p_features) const override;
	godot::Ref<godot::Resource> _customize_resource(const godot::Ref<godot::Resource> &p_resource, const godot::String &p_path) override;
	uint64_t _get_customization_configuration_hash() const override;
	void _end_customize_resources() override { _kept.clear(); }

protected:
	static void _bind_methods() {}

private:
	godot::Dictionary _kept; // copies of rules that keep their mask, by original: users of one rule share its copy
};

} // namespace grass
