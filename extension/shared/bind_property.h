// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/class_db.hpp>

// Binds a property with its setter and getter in _bind_methods() of m_class; scripts may also call both by name.
#define GRASS_BIND_PROPERTY(m_class, m_info, m_setter, m_getter) GRASS_BIND_PROPERTY_AS(m_class, m_info, m_setter, m_getter, "value")
// m_argument: the name of the setter's argument.
#define GRASS_BIND_PROPERTY_AS(m_class, m_info, m_setter, m_getter, m_argument)                                                            \
	ClassDB::bind_method(D_METHOD(#m_setter, m_argument), &m_class::m_setter);                                                             \
	ClassDB::bind_method(D_METHOD(#m_getter), &m_class::m_getter);                                                                         \
	ADD_PROPERTY(m_info, #m_setter, #m_getter)
