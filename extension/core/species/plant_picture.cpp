// SPDX-License-Identifier: MIT
#include "core/species/plant_picture.h"

#include "core/species/picture_canvas.h"

#include <Eigen/Geometry>

#include <array>
#include <limits>
#include <numbers>

namespace grass {

Eigen::Vector4f texel_of(const PictureSurface &p_surface, const Eigen::Vector2f &p_uv) {
	if (p_surface.texture.empty()) {
		return Eigen::Vector4f::Ones();
	}
	const auto index = [](float p_at, int p_size) { return std::min(int((p_at - std::floor(p_at)) * float(p_size)), p_size - 1); };
	const int x = index(p_uv.x(), p_surface.texture_width), y = index(p_uv.y(), p_surface.texture_height);
	const uint8_t *texel = &p_surface.texture[size_t(4 * (y * p_surface.texture_width + x))];
	return { from_srgb(texel[0]), from_srgb(texel[1]), from_srgb(texel[2]), float(texel[3]) / 255.0f };
}

namespace {

constexpr float TURNED = 30.0f, FROM_ABOVE = 15.0f; // degrees: how the plant is seen
constexpr float FILLING = 0.94f; // share of the picture's side
constexpr float SLIM = 0.5f; // the picture of a plant that is slimmer than this shows so much of its height, from the top: its flower
constexpr float SHADE = 0.5f; // light of a face that is turned away from the sun
constexpr int STEPS = 2; // samples for each drawn texel along the side of a triangle: one might miss some
const Eigen::Vector3f SUN = Eigen::Vector3f(-0.4f, 0.75f, 0.5f).normalized(); // as seen: x to the right, y up, z to the eye

Eigen::Matrix3f view() {
	constexpr float RADIANS = std::numbers::pi_v<float> / 180.0f;
	return (Eigen::AngleAxisf(FROM_ABOVE * RADIANS, Eigen::Vector3f::UnitX()) *
			Eigen::AngleAxisf(TURNED * RADIANS, Eigen::Vector3f::UnitY()))
			.toRotationMatrix();
}

class PlantPainter {
public:
	PlantPainter(std::span<const PictureSurface> p_surfaces, int p_side) :
			_canvas(p_side), _depths(size_t(_canvas.get_side()) * size_t(_canvas.get_side()), -std::numeric_limits<float>::infinity()) {
		Eigen::AlignedBox3f box;
		for (const PictureSurface &surface : p_surfaces) {
			for (const Eigen::Vector3f &place : surface.places) {
				box.extend(Eigen::Vector3f(_view * place));
			}
		}
		const Eigen::Vector3f sizes = box.isEmpty() ? Eigen::Vector3f::Ones() : Eigen::Vector3f(box.sizes());
		_middle = box.isEmpty() ? Eigen::Vector3f::Zero() : Eigen::Vector3f(box.center());
		const float shown = sizes.x() < SLIM * sizes.y() ? SLIM * sizes.y() : sizes.head<2>().maxCoeff();
		_middle.y() += 0.5f * std::max(sizes.y() - shown, 0.0f);
		_scale = FILLING * float(_canvas.get_side()) / std::max(shown, 1e-6f);
	}

	void draw(const PictureSurface &p_surface) {
		for (size_t i = 0; i + 2 < p_surface.indices.size(); i += 3) {
			draw_face(p_surface, { size_t(p_surface.indices[i]), size_t(p_surface.indices[i + 1]), size_t(p_surface.indices[i + 2]) });
		}
	}

	std::vector<uint8_t> shrunk() const { return _canvas.shrunk(); }

private:
	// Texels on the canvas, y down; z: towards the eye.
	Eigen::Vector3f seen(const Eigen::Vector3f &p_place) const {
		const Eigen::Vector3f place = _scale * (_view * p_place - _middle);
		const float half = 0.5f * float(_canvas.get_side());
		return { half + place.x(), half - place.y(), place.z() };
	}

	void draw_face(const PictureSurface &p_surface, const std::array<size_t, 3> &p_corners) {
		const size_t a = p_corners[0], b = p_corners[1], c = p_corners[2];
		const Eigen::Vector3f &from = p_surface.places[a];
		const Eigen::Vector3f normal = (p_surface.places[b] - from).cross(p_surface.places[c] - from).normalized();
		const float light = SHADE + (1.0f - SHADE) * std::abs((_view * normal).dot(SUN)); // leaves are lit from both sides
		const Eigen::Vector3f first = seen(from), to_b = seen(p_surface.places[b]) - first, to_c = seen(p_surface.places[c]) - first;
		const float longest = std::max({ to_b.head<2>().norm(), to_c.head<2>().norm(), (to_c - to_b).head<2>().norm() });
		const int steps = std::max(1, int(std::ceil(float(STEPS) * longest)));
		for (int i = 0; i <= steps; i++) {
			for (int j = 0; i + j <= steps; j++) {
				const Eigen::Vector2f part = Eigen::Vector2f(float(i), float(j)) / float(steps);
				const auto mix = [&](const auto &p_values) {
					return ((1.0f - part.sum()) * p_values[a] + part.x() * p_values[b] + part.y() * p_values[c]).eval();
				};
				const Eigen::Vector4f texel = texel_of(p_surface, mix(p_surface.uvs));
				if (texel.w() >= p_surface.scissor) {
					const Eigen::Vector3f color = mix(p_surface.colors).cwiseProduct(texel.head<3>());
					put(first + part.x() * to_b + part.y() * to_c, light * color);
				}
			}
		}
	}

	void put(const Eigen::Vector3f &p_at, const Eigen::Vector3f &p_color) {
		const int side = _canvas.get_side();
		const int x = std::clamp(int(p_at.x()), 0, side - 1), y = int(p_at.y());
		if (p_at.y() < 0.0f || y >= side) {
			return;
		}
		float &depth = _depths[size_t(y) * size_t(side) + size_t(x)];
		if (p_at.z() >= depth) {
			depth = p_at.z();
			_canvas.put(x, y, p_color);
		}
	}

	const Eigen::Matrix3f _view = view();
	PictureCanvas _canvas;
	std::vector<float> _depths; // of what is drawn on the canvas
	Eigen::Vector3f _middle;
	float _scale;
};

} // namespace

std::vector<uint8_t> draw_plant(std::span<const PictureSurface> p_surfaces, int p_side) {
	PlantPainter painter(p_surfaces, p_side);
	for (const PictureSurface &surface : p_surfaces) {
		painter.draw(surface);
	}
	return painter.shrunk();
}

} // namespace grass
