// SPDX-License-Identifier: MIT
// The parts of a GrassField. A part refers to those above it that it uses, and to the node as its host.
#pragma once

#include "field/field_forces.h"
#include "field/field_host.h"
#include "field/field_life.h"
#include "field/field_properties.h"
#include "field/field_queries.h"
#include "field/field_settings.h"
#include "field/field_work.h"
#include "field/plant_nodes.h"
#include "field/standing_field.h"
#include "ground/field_sources.h"
#include "physics/field_bodies.h"

namespace grass {

struct FieldParts {
	explicit FieldParts(FieldHost &p_host) : host(p_host) {}

	godot::GeometryInstance3D &node() const { return host.node(); }

	FieldHost &host;
	FieldProperties properties;
	StandingField standing{ properties };
	FieldLife life{ host, properties, standing };
	FieldBodies bodies;
	FieldForces forces{ host };
	PlantNodes plants{ host };
	FieldSettings settings{ host, properties, life, standing, bodies.get_tracker() };
	FieldSources sources{ host, properties, standing, settings };
	FieldWork work{ host, standing, properties };
	FieldQueries queries{ host, life, standing, properties, bodies };
};

} // namespace grass
