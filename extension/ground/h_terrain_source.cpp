// SPDX-License-Identifier: MIT
#include "ground/h_terrain_source.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

using namespace godot;

namespace grass {

namespace {

// HTerrain: a node whose data counts in cells and in heights without the node's scale. Its colour map's alpha cuts holes, its splat maps
// weigh four textures each.
class HTerrainSource : public TerrainSource {
public:
	static constexpr const char *TRANSFORM = "get_internal_transform", *HEIGHT = "get_interpolated_height_at";
	static constexpr int64_t SPLAT = 2, COLOR = 3, ALBEDO = 5, INDEX = 6,
							 WEIGHT = 7; // its numbers of maps; ALBEDO is baked from the others
	static constexpr const char *SHADER_TYPE = "get_shader_type";
	static constexpr const char *CHANGED = "region_changed";
	static constexpr float HOLE = 0.5f; // where the alpha is below this, it draws nothing

	HTerrainSource(Node *p_node, Object *p_data) :
			TerrainSource(p_node, p_data), _has_images(p_data->has_method("get_image")), _has_counts(p_data->has_method("get_map_count")) {}

	bool has_textures() const override { return _has_images; }
	bool has_colors() const override { return _has_images; }

	size_t get_places_at_once() const override { return PLACES_AT_ONCE; } // each read asks for its pictures

	void read(std::span<const Vector3> p_places, std::span<TerrainSample> r_samples) override {
		Object *data = get_data();
		const Transform3D to_world = get_transform(), to_cells = to_world.affine_inverse();
		const double last = to_number(ask(data, "get_resolution"), "get_resolution") - 1.0;
		const Ref<Image> color = _has_images ? find_image(data, COLOR, 0) : Ref<Image>();
		const Ref<Image> albedo = _has_images && _has_counts && count_maps(data, ALBEDO) > 0 ? find_image(data, ALBEDO, 0) : Ref<Image>();
		const bool is_array = has_array(data);
		const Ref<Image> indices = is_array ? find_image(data, INDEX, 0) : Ref<Image>();
		const Ref<Image> weights = is_array ? find_image(data, WEIGHT, 0) : Ref<Image>();
		std::vector<Ref<Image>> splats;
		for (int64_t n = 0; _has_images && !is_array && n < (_has_counts ? count_maps(data, SPLAT) : 1); n++) {
			splats.push_back(find_image(data, SPLAT, n));
		}
		for (size_t i = 0; i < p_places.size(); i++) {
			const Vector3 cell = to_cells.xform(p_places[i]);
			if (!(cell.x >= 0.0f && cell.z >= 0.0f && double(cell.x) <= last && double(cell.z) <= last) || is_hole(color, cell)) {
				r_samples[i].height = NO_GROUND; // beyond its border it would repeat the last height
				continue;
			}
			const double height = to_number(ask(data, _height, cell), HEIGHT);
			r_samples[i].height = to_world.xform(Vector3(cell.x, real_t(height), cell.z)).y;
			r_samples[i].texture = is_array ? find_array_texture(indices, weights, cell) : find_texture(splats, cell);
			r_samples[i].color = find_color(color, albedo, cell, last);
		}
	}

	Transform3D get_transform() const override {
		Node *node = get_node();
		return node == nullptr ? Transform3D() : Transform3D(node->call(TRANSFORM));
	}

	std::optional<GroundGrid> find_grid(const Transform3D &p_field) override { return grid_of(p_field, get_transform()); }

	std::vector<Notice> get_notices(const Handlers &p_handlers) const override {
		return { { CHANGED, find_handler(p_handlers) }, { "resolution_changed", p_handlers.anywhere } };
	}

	AABB to_area(const Vector2 &p_first_cell, const Vector2 &p_cells) const override {
		return moved(get_transform(), AABB(Vector3(p_first_cell.x, 0, p_first_cell.y), Vector3(p_cells.x, 0, p_cells.y)));
	}

private:
	Ref<Image> find_image(Object *p_data, int64_t p_map, int64_t p_number) {
		const Ref<Image> image = ask(p_data, "get_image", p_map, p_number);
		return image.is_valid() && !image->is_empty() && !image->is_compressed() ? image : Ref<Image>();
	}

	// Its shader of a texture array keeps the numbers of three textures and two weights. Maps of another shader may be left beside those
	// of the one in use.
	bool has_array(Object *p_data) {
		if (!_has_images || !_has_counts || count_maps(p_data, INDEX) == 0 || count_maps(p_data, WEIGHT) == 0) {
			return false;
		}
		const Node *node = get_node();
		if (node == nullptr || !node->has_method(SHADER_TYPE)) {
			return true;
		}
		const String type = ask_node(SHADER_TYPE);
		return type == "Array" || (type == "Custom" && count_maps(p_data, SPLAT) == 0);
	}

	int64_t count_maps(Object *p_data, int64_t p_map) { return int64_t(ask(p_data, "get_map_count", p_map)); }

	// Returns the handler for the signal: up to 1.8 it has x, y, width, height and channel, later a rectangle and one or two numbers.
	Callable find_handler(const Handlers &p_handlers) const {
		constexpr int64_t NUMBERS = 5;
		const TypedArray<Dictionary> signals = get_data()->get_signal_list();
		for (int64_t i = 0; i < signals.size(); i++) {
			const Dictionary signal = signals[i];
			const int64_t count = Array(signal["args"]).size();
			if (String(signal["name"]) == CHANGED && count > 0 && count < NUMBERS) {
				return count > 1 ? p_handlers.in_rectangle.unbind(count - 1) : p_handlers.in_rectangle;
			}
		}
		return p_handlers.in_cells;
	}

	// Returns the colour at a place: without a baked picture of the ground, the one that was painted. p_last: cell.
	static TerrainColor find_color(const Ref<Image> &p_color, const Ref<Image> &p_albedo, const Vector3 &p_cell, double p_last) {
		if (p_albedo.is_valid()) {
			const Color baked = pixel_of(p_albedo, p_cell * real_t((p_albedo->get_width() - 1) / std::max(p_last, 1.0)));
			return TerrainColor::of(baked.r, baked.g, baked.b, 1.0);
		}
		if (p_color.is_null()) {
			return {};
		}
		const Color painted = pixel_of(p_color, p_cell);
		return unless_white(TerrainColor::of(painted.r, painted.g, painted.b, 1.0));
	}

	static Color pixel_of(const Ref<Image> &p_image, const Vector3 &p_cell) {
		const auto clip = [](real_t p_place, int64_t p_size) { return std::clamp<int64_t>(int64_t(std::lround(p_place)), 0, p_size - 1); };
		return p_image->get_pixel(int32_t(clip(p_cell.x, p_image->get_width())), int32_t(clip(p_cell.z, p_image->get_height())));
	}

	// Returns whether a place is in a hole. Halfway between a pixel that cuts a hole and one that does not there is no ground either, and
	// the field may read exactly there.
	static bool is_hole(const Ref<Image> &p_color, const Vector3 &p_cell) {
		constexpr real_t BESIDE = real_t(0.01); // cells
		if (p_color.is_null()) {
			return false;
		}
		const Vector3 beside(BESIDE, 0, BESIDE), across(BESIDE, 0, -BESIDE);
		return pixel_of(p_color, p_cell - beside).a < HOLE || pixel_of(p_color, p_cell + beside).a < HOLE ||
				pixel_of(p_color, p_cell - across).a < HOLE || pixel_of(p_color, p_cell + across).a < HOLE;
	}

	// Returns the two that weigh most of three; the third one's weight is what the others leave.
	static TerrainTexel find_array_texture(const Ref<Image> &p_indices, const Ref<Image> &p_weights, const Vector3 &p_cell) {
		if (p_indices.is_null() || p_weights.is_null()) {
			return TerrainTexel::of(0, 0, 0.0);
		}
		const Color numbers = pixel_of(p_indices, p_cell), weights = pixel_of(p_weights, p_cell);
		const auto number = [](float p_component) { return int(std::lround(p_component * 255.0f)); };
		std::array<std::pair<double, int>, 3> three = { { { double(weights.r), number(numbers.r) },
				{ double(weights.g), number(numbers.g) },
				{ std::max(0.0, 1.0 - double(weights.r) - double(weights.g)), number(numbers.b) } } };
		for (size_t n = 1; n < 3; n++) { // the same texture may be there twice
			if (three[n].second == three[0].second) {
				three[0].first += std::exchange(three[n].first, 0.0);
			}
		}
		std::ranges::sort(three, std::greater());
		const double sum = three[0].first + three[1].first;
		return TerrainTexel::of(three[0].second, three[1].second, sum > 0.0 ? three[1].first / sum : 0.0);
	}

	// Returns the two that weigh most.
	static TerrainTexel find_texture(const std::vector<Ref<Image>> &p_splats, const Vector3 &p_cell) {
		std::array<std::pair<double, int>, 2> most{};
		for (size_t n = 0; n < p_splats.size(); n++) {
			const Color weights = p_splats[n].is_valid() ? pixel_of(p_splats[n], p_cell) : Color(0, 0, 0, 0);
			for (const auto &[weight, component] : { std::pair(weights.r, 0), { weights.g, 1 }, { weights.b, 2 }, { weights.a, 3 } }) {
				const std::pair one(double(weight), int(n) * 4 + component);
				if (one.first > most[0].first) {
					most[1] = std::exchange(most[0], one);
				} else if (one.first > most[1].first) {
					most[1] = one;
				}
			}
		}
		const double sum = most[0].first + most[1].first;
		return TerrainTexel::of(most[0].second, most[1].second, sum > 0.0 ? most[1].first / sum : 0.0);
	}

	const StringName _height = HEIGHT;
	bool _has_images, _has_counts;
};

} // namespace

std::unique_ptr<TerrainSource> make_h_terrain_source(Node *p_node, Object *p_data) {
	const bool is_one = p_data->has_method(HTerrainSource::HEIGHT) && p_node->has_method(HTerrainSource::TRANSFORM);
	return is_one ? std::make_unique<HTerrainSource>(p_node, p_data) : nullptr;
}

} // namespace grass
