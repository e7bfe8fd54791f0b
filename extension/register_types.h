// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/class_db.hpp>

void initialize_grass_field(godot::ModuleInitializationLevel p_level);
void uninitialize_grass_field(godot::ModuleInitializationLevel p_level);
