// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/class_db.hpp>

// In _bind_methods() of m_class: a property with its setter and getter, which scripts may call by their names.
#define GRASS_BIND_PROPERTY(m_class, m_info, m_setter, m_getter)                                                                           \
	ClassDB::bind_method(D_METHOD(#m_setter, "value"), &m_class::m_setter);                                                                \
	ClassDB::bind_method(D_METHOD(#m_getter), &m_class::m_getter);                                                                         \
	ADD_PROPERTY(m_info, #m_setter, #m_getter)
