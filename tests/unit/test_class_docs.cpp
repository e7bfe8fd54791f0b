// SPDX-License-Identifier: MIT
// The class reference says what the code does: every number is described, with the default that stands beside its code.
#include "class_docs.gen.h"
#include "core/field/quality.h"
#include "core/fill/fill_params.h"
#include "core/paint/brush_params.h"
#include "core/world/world_plan.h"
#include "field/field_params.h"
#include "resources/species_params.h"

#include <doctest/doctest.h>

#include <charconv>
#include <string>

using namespace grass;

namespace {

std::string_view docs_of(std::string_view p_class) {
	for (const std::string_view &text : CLASS_DOCS) {
		if (text.find("class name=\"" + std::string(p_class) + "\"") != std::string_view::npos) {
			return text;
		}
	}
	return {};
}

// Returns the member's element with its text, or nothing.
std::string_view member_of(std::string_view p_docs, std::string_view p_name) {
	const size_t begin = p_docs.find("<member name=\"" + std::string(p_name) + "\"");
	if (begin == std::string_view::npos) {
		return {};
	}
	return p_docs.substr(begin, p_docs.find("</member>", begin) - begin);
}

double default_of(std::string_view p_member) {
	const std::string_view key = "default=\"";
	const size_t begin = p_member.find(key);
	double value = std::nan("");
	if (begin != std::string_view::npos) {
		const char *first = p_member.data() + begin + key.size();
		std::from_chars(first, p_member.data() + p_member.size(), value);
	}
	return value;
}

void check(std::string_view p_docs, const Tunable &p_tunable) {
	INFO("property ", p_tunable.name);
	const std::string_view member = member_of(p_docs, p_tunable.name);
	CHECK(default_of(member) == doctest::Approx(p_tunable.initial));
	CHECK(member.size() > member.find('>') + 20); // words, not only the element
}

} // namespace

TEST_CASE("class docs: every number of a GrassField is described, with its default") {
	for (const FieldParam &param : FIELD_PARAMS) {
		check(docs_of("GrassField"), param.tunable);
	}
	for (const NamedColor &color : FIELD_COLORS) {
		INFO("colour ", color.name);
		CHECK_FALSE(member_of(docs_of("GrassField"), color.name).empty());
	}
}

TEST_CASE("class docs: every number of a GrassSpecies is described, with its default") {
	for (const Tunable &tunable : SPECIES_PARAMS) {
		check(docs_of("GrassSpecies"), tunable);
	}
	for (const NamedColor &color : SPECIES_COLORS) {
		INFO("colour ", color.name);
		CHECK_FALSE(member_of(docs_of("GrassSpecies"), color.name).empty());
	}
}

TEST_CASE("class docs: every number of a GrassPatch is described, with its default") {
	for (const Tunable &tunable : { LENGTH_MIN, LENGTH_MAX, WIDTH_MIN, WIDTH_MAX }) {
		check(docs_of("GrassPatch"), tunable);
	}
	for (const Tunable &tunable : TYPE_WEIGHTS) {
		check(docs_of("GrassPatch"), tunable);
	}
}

TEST_CASE("class docs: every factor of a GrassQuality is described, with its default") {
	for (const QualityFactor &factor : QUALITY_TABLE) {
		check(docs_of("GrassQuality"), factor.tunable);
	}
}

TEST_CASE("class docs: every number of a GrassBrush is described, with its default") {
	for (const Tunable &tunable : BRUSH_PARAMS) {
		check(docs_of("GrassBrush"), tunable);
	}
}

TEST_CASE("class docs: every number of a GrassFillRule is described, with its default") {
	for (const Tunable &tunable : FILL_PARAMS) {
		check(docs_of("GrassFillRule"), tunable);
	}
}

TEST_CASE("class docs: every number of a GrassWorld is described, with its default") {
	for (const Tunable &tunable : { WorldGrid::PLOT_SIZE, WORLD_CAMERA_RADIUS, WORLD_BODY_RADIUS, WORLD_MEMORY_BUDGET }) {
		check(docs_of("GrassWorld"), tunable);
	}
}
