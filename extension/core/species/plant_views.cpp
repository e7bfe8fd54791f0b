// SPDX-License-Identifier: MIT
#include "core/species/plant_views.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace grass {

namespace {

constexpr int FINER = 3; // samples for each texel, along a side
constexpr float NOTHING = -std::numeric_limits<float>::infinity(); // depth where nothing is
// The picture from above lies high up. What is farther below is not in it: up there it would hide the flowers behind.
constexpr float LAYER = 0.5f;
// From the side the picture shows what an eye so much above the horizon sees of the plant, radians: mostly the upper sides of leaves, which
// are lighter, and of flowers that lie about as much as an eye beside them sees in the mean, since stems lean. Somebody upright sees plants
// 6 m away at this angle.
constexpr float RAISED = 0.26f;

// Encodes a colour as the engine decodes a texture of colours.
uint8_t encoded(float p_linear) {
	const float value = std::clamp(p_linear, 0.0f, 1.0f);
	return uint8_t(std::lround(255.0f * (value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f)));
}

// How a view sees the plant: vectors in the plant's axes, and what the picture shows of `right`, around 0, and of `up`, from `bottom` on.
struct ViewFrame {
	Eigen::Vector3f right, up, to_eye;
	float width, bottom, height;
};

ViewFrame frame_from_side(float p_angle, float p_reach) {
	const float x = std::cos(p_angle), z = std::sin(p_angle);
	const float raised = std::tan(RAISED);
	return { { z, 0, -x }, { -raised * x, 1, -raised * z }, Eigen::Vector3f(x, raised, z).normalized(), 2.0f * p_reach, 0.0f, 1.0f };
}

ViewFrame frame_from_above(float p_reach) {
	return { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 }, 2.0f * p_reach, p_reach, 2.0f * p_reach };
}

constexpr float ASLANT_SINE = 0.5f, ASLANT_COSINE = 0.8660254f; // of the height of an eye that sees both the plant's sides and its top

ViewFrame frame_aslant(float p_angle, float p_reach) {
	const Eigen::Vector3f level(std::cos(p_angle), 0, std::sin(p_angle)), up(0, 1, 0);
	return { { level.z(), 0, -level.x() }, ASLANT_COSINE * up - ASLANT_SINE * level, ASLANT_COSINE * level + ASLANT_SINE * up,
		2.0f * p_reach, ASLANT_SINE * p_reach, ASLANT_COSINE + 2.0f * ASLANT_SINE * p_reach };
}

// One view: samples with the nearest of what covers them.
class ViewPainter {
public:
	// p_least: depth, towards the eye, of what is drawn.
	ViewPainter(std::span<const PictureSurface> p_surfaces, const ViewFrame &p_frame, int p_texels, float p_least = NOTHING) :
			_frame(p_frame),
			_least(p_least),
			_side(FINER * p_texels),
			_scale(float(_side) / p_frame.width, float(_side) / p_frame.height),
			_samples(size_t(_side) * size_t(_side)) {
		for (const PictureSurface &surface : p_surfaces) {
			draw(surface);
		}
	}

	int get_side() const { return _side; }
	// Returns the place of a sample in the frame, y down.
	Eigen::Vector2f place_of(int p_x, int p_y) const {
		return { (float(p_x) + 0.5f) / _scale.x() - 0.5f * _frame.width, (float(_side - p_y) - 0.5f) / _scale.y() - _frame.bottom };
	}
	// Returns the luminance at a place in the frame, without light on it; less than 0 where nothing is.
	float luminance_at(const Eigen::Vector2f &p_place) const {
		const float x = (p_place.x() + 0.5f * _frame.width) * _scale.x(), y = float(_side) - (p_place.y() + _frame.bottom) * _scale.y();
		if (!(x >= 0.0f && y >= 0.0f && x < float(_side) && y < float(_side))) {
			return -1.0f;
		}
		const Sample &sample = _samples[size_t(y) * size_t(_side) + size_t(x)];
		return sample.share > 0.0f ? sample.color.dot(Eigen::Vector3f(0.2126f, 0.7152f, 0.0722f)) : -1.0f;
	}

	PlantView shrunk() const {
		std::vector<Level> levels{ smaller({ _samples, _side }, FINER) };
		while (levels.back().side > 1) {
			levels.push_back(smaller(levels.back(), 2));
		}
		for (size_t i = levels.size() - 1; i > 0; i--) {
			fill_gaps(levels[i - 1], levels[i]);
		}
		PlantView view;
		view.depth = find_depth();
		for (const Level &level : levels) {
			for (const Sample &texel : level.texels) {
				append(texel, view);
			}
		}
		return view;
	}

	// Returns where most of the nearer parts are, towards the eye.
	float find_depth() const {
		constexpr double NEARER = 0.8; // share of what is seen that may be farther away: a flower is nearer than the leaves below it
		std::vector<float> depths;
		for (const Sample &sample : _samples) {
			if (sample.share > 0.0f) {
				depths.push_back(sample.depth);
			}
		}
		if (depths.empty()) {
			return 0.0f;
		}
		const auto at = depths.begin() + std::ptrdiff_t(NEARER * double(depths.size() - 1));
		std::nth_element(depths.begin(), at, depths.end());
		return *at;
	}

private:
	struct Sample {
		Eigen::Vector3f color = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero(); // linear; in the plant's axes
		float depth = NOTHING;
		float share = 0.0f; // 1: covered
	};
	struct Level {
		std::vector<Sample> texels;
		int side;
	};

	void draw(const PictureSurface &p_surface) {
		for (size_t i = 0; i + 2 < p_surface.indices.size(); i += 3) {
			draw_face(p_surface, { size_t(p_surface.indices[i]), size_t(p_surface.indices[i + 1]), size_t(p_surface.indices[i + 2]) });
		}
	}

	// Samples, y down.
	Eigen::Vector2f seen(const Eigen::Vector3f &p_place) const {
		return { 0.5f * float(_side) + p_place.dot(_frame.right) * _scale.x(),
			float(_side) - (p_place.dot(_frame.up) + _frame.bottom) * _scale.y() };
	}

	void draw_face(const PictureSurface &p_surface, const std::array<size_t, 3> &p_corners) {
		const Eigen::Vector2f a = seen(p_surface.places[p_corners[0]]), b = seen(p_surface.places[p_corners[1]]),
							  c = seen(p_surface.places[p_corners[2]]);
		const auto turn = [](const Eigen::Vector2f &p_from, const Eigen::Vector2f &p_to, const Eigen::Vector2f &p_at) {
			return (p_to.x() - p_from.x()) * (p_at.y() - p_from.y()) - (p_to.y() - p_from.y()) * (p_at.x() - p_from.x());
		};
		const float area = turn(a, b, c);
		const Eigen::Array2f low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
		if (!(std::abs(area) > 1e-6f) || !low.allFinite() || !high.allFinite()) {
			return;
		}
		const Eigen::Array2i first = (low - 0.5f).ceil().max(0.0f).min(float(_side)).cast<int>(),
							 last = (high - 0.5f).floor().max(-1.0f).min(float(_side - 1)).cast<int>();
		for (int y = first.y(); y <= last.y(); y++) {
			for (int x = first.x(); x <= last.x(); x++) {
				const Eigen::Vector2f at(float(x) + 0.5f, float(y) + 0.5f);
				const Eigen::Vector3f part(turn(b, c, at) / area, turn(c, a, at) / area, turn(a, b, at) / area);
				if (part.minCoeff() >= 0.0f) {
					put(_samples[size_t(y) * size_t(_side) + size_t(x)], p_surface, p_corners, part);
				}
			}
		}
	}

	void put(Sample &r_sample, const PictureSurface &p_surface, const std::array<size_t, 3> &p_corners,
			const Eigen::Vector3f &p_part) const {
		const auto mix = [&](const auto &p_values) {
			return (p_part[0] * p_values[p_corners[0]] + p_part[1] * p_values[p_corners[1]] + p_part[2] * p_values[p_corners[2]]).eval();
		};
		const float depth = mix(p_surface.places).dot(_frame.to_eye);
		if (depth < std::max(r_sample.depth, _least)) {
			return;
		}
		const Eigen::Vector4f texel = texel_of(p_surface, mix(p_surface.uvs));
		if (texel.w() < p_surface.scissor) {
			return;
		}
		Eigen::Vector3f normal = mix(p_surface.normals);
		normal *= normal.dot(_frame.to_eye) < 0.0f ? -1.0f : 1.0f; // leaves are lit from both sides
		r_sample = { mix(p_surface.colors).cwiseProduct(texel.head<3>()), normal.normalized(), depth, 1.0f };
	}

	// Returns the mean of the samples that are covered.
	static Sample mean_of(const std::vector<Sample> &p_samples, int p_side, int p_x, int p_y, int p_count) {
		Sample sum;
		for (int y = p_y; y < p_y + p_count; y++) {
			for (int x = p_x; x < p_x + p_count; x++) {
				const Sample &sample = p_samples[size_t(y) * size_t(p_side) + size_t(x)];
				sum.color += sample.share * sample.color;
				sum.normal += sample.share * sample.normal;
				sum.share += sample.share;
			}
		}
		const float count = std::max(sum.share, 1e-6f);
		sum.color /= count;
		sum.normal /= count;
		sum.share /= float(p_count * p_count);
		return sum;
	}

	static Level smaller(const Level &p_level, int p_times) {
		Level made{ {}, p_level.side / p_times };
		for (int n = 0; n < made.side * made.side; n++) {
			made.texels.push_back(mean_of(p_level.texels, p_level.side, n % made.side * p_times, n / made.side * p_times, p_times));
		}
		return made;
	}

	// Gives transparent texels the colour around them, with which a sampler mixes that of their neighbours: with another one, all that is
	// thin would change its colour.
	static void fill_gaps(Level &r_level, const Level &p_half) {
		for (int n = 0; n < r_level.side * r_level.side; n++) {
			Sample &texel = r_level.texels[size_t(n)];
			if (texel.share == 0.0f) {
				texel = p_half.texels[size_t(n / r_level.side / 2 * p_half.side + n % r_level.side / 2)];
				texel.share = 0.0f;
			}
		}
	}

	void append(const Sample &p_texel, PlantView &r_view) const {
		const Eigen::Vector3f normal = p_texel.normal.norm() > 1e-6f ? Eigen::Vector3f(p_texel.normal.normalized()) : _frame.to_eye;
		for (int c = 0; c < 3; c++) {
			r_view.colors.push_back(encoded(p_texel.color[c]));
			r_view.normals.push_back(uint8_t(std::lround(127.5f + 127.5f * normal[c])));
		}
		r_view.colors.push_back(uint8_t(std::lround(255.0f * p_texel.share)));
		r_view.normals.push_back(255);
	}

	ViewFrame _frame;
	float _least;
	int _side;
	Eigen::Vector2f _scale; // samples for each unit of the mesh
	std::vector<Sample> _samples;
};

// What an eye aslant sees: of the plant; of the picture from the side; and of that from above beside it. Luminances.
struct SeenAslant {
	double plant = 0.0, beside = 0.0, above = 0.0;

	// Adds the light of a plant. p_depth: height of the card with the picture from above.
	void add(const ViewPainter &p_plant, const ViewPainter &p_beside, const ViewPainter &p_above, float p_depth, float p_angle) {
		const float x = std::cos(p_angle), z = std::sin(p_angle);
		for (int n = 0; n < p_plant.get_side() * p_plant.get_side(); n++) {
			const Eigen::Vector2f place = p_plant.place_of(n % p_plant.get_side(), n / p_plant.get_side());
			plant += double(std::max(p_plant.luminance_at(place), 0.0f));
			const float side = p_beside.luminance_at({ place.x(), place.y() / ASLANT_COSINE });
			if (side >= 0.0f) {
				beside += double(side);
				continue;
			}
			const float nearer = (ASLANT_COSINE * p_depth - place.y()) / ASLANT_SINE; // to the eye than the stem, on the card that lies
			above += double(std::max(p_above.luminance_at({ z * place.x() + x * nearer, x * place.x() - z * nearer }), 0.0f));
		}
	}
};

float angle_of(int p_side, int p_sides) {
	return 2.0f * std::numbers::pi_v<float> * float(p_side) / float(p_sides);
}

} // namespace

PlantViews draw_views(
		std::span<const PictureSurface> p_surfaces, float p_reach, int p_sides, int p_texels, const std::atomic<bool> *p_is_stopped) {
	PlantViews views;
	const float high = ViewPainter(p_surfaces, frame_from_above(p_reach), p_texels).find_depth();
	const ViewPainter above(p_surfaces, frame_from_above(p_reach), p_texels, high - LAYER);
	PlantView top = above.shrunk();
	top.depth = high;
	SeenAslant seen;
	for (int k = 0; k < p_sides && !(p_is_stopped && *p_is_stopped); k++) {
		const float angle = angle_of(k, p_sides);
		const ViewPainter beside(p_surfaces, frame_from_side(angle, p_reach), p_texels);
		views.views.push_back(beside.shrunk());
		if (k % 2 == 0) {
			seen.add(ViewPainter(p_surfaces, frame_aslant(angle, p_reach), p_texels / 2), beside, above, top.depth, angle);
		}
	}
	views.views.push_back(top);
	views.aslant = float(std::clamp((seen.plant - seen.beside) / std::max(seen.above, 1e-9), 0.0, 1.0));
	return views;
}

} // namespace grass
