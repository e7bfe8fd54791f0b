// SPDX-License-Identifier: MIT
#include "core/paint/channel_picture.h"

#include "core/paint/changed_texels.h"
#include "core/paint/hand_paint.h"
#include "core/paint/lay_ground.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace grass {

namespace {

constexpr double FULL_BYTE = 255.0; // of a byte

double read_number(const uint8_t *p_pixel, int p_number, bool p_is_float) {
	if (!p_is_float) {
		return p_pixel[p_number];
	}
	float value;
	std::memcpy(&value, p_pixel + size_t(p_number) * 4, 4);
	return double(value);
}

// Returns which number of a pixel is a component of the channel.
int number_of(const MapChannelInfo &p_info, const PixelFormat &p_format, int p_component) {
	return p_component == 3 ? p_format.colors : (p_format.colors == 1 && p_info.components == 4 ? 0 : p_component);
}

// Returns the part of a chunk in the rectangle, in texels of the map.
TexelRect part_in(const TexelRect &p_rect, const MapKey &p_key, int p_side) {
	const int i = std::max(p_rect.i, p_key.x * p_side), j = std::max(p_rect.j, p_key.z * p_side);
	return { i, j, std::min(p_rect.i + p_rect.width, (p_key.x + 1) * p_side) - i,
		std::min(p_rect.j + p_rect.depth, (p_key.z + 1) * p_side) - j };
}

// Writes a picture into a map.
class PictureLayer {
public:
	PictureLayer(PaintMap &r_map, MapChannel p_channel, const TexelRect &p_rect, std::span<const uint8_t> p_pixels,
			const PixelFormat &p_format) :
			_map(r_map),
			_channel(p_channel),
			_info(info_of(p_channel)),
			_rect(p_rect),
			_pixels(p_pixels),
			_format(p_format),
			_changed(p_channel) {}

	LaidPicture run() {
		_result.reason = find_refusal();
		const MapKey first = key_of(_channel, _rect.i, _rect.j);
		const MapKey last = key_of(_channel, _rect.i + _rect.width - 1, _rect.j + _rect.depth - 1);
		for (MapKey key = first; key.x <= last.x; key.x++) {
			for (key.z = first.z; key.z <= last.z && _result.reason.empty(); key.z++) {
				lay_chunk(key);
			}
		}
		_changed.report(_result);
		return _result;
	}

private:
	// Returns why the format does not fit the channel, or "".
	std::string find_refusal() const {
		const std::string name = _info.name;
		if (_info.bytes > 1 && !_format.is_float) {
			return "has 8 bits a pixel, but " + name + " is in metres. Use floats (EXR).";
		}
		if (_info.components > 1 && _format.colors < std::min(_info.components, 3) && !(_info.components == 4 && _format.colors == 1)) {
			return "is grey, but " + name + " has " + std::to_string(_info.components) + " numbers a texel. Use a picture in colour.";
		}
		return {};
	}

	std::string refuse(const char *p_what, int p_i, int p_j, const char *p_advice) const {
		return std::string(p_what) + " at pixel (" + std::to_string(p_i - _rect.i) + ", " + std::to_string(p_j - _rect.j) + "), but " +
				_info.name + p_advice;
	}

	// Returns whether a pixel can be a texel. Otherwise says why not.
	bool fits(const uint8_t *p_pixel, int p_i, int p_j) {
		const size_t number = _format.is_float ? 4 : 1;
		if (_info.components < 4 && _format.has_alpha &&
				read_number(p_pixel, _format.colors, _format.is_float) < (_format.is_float ? 1.0 : FULL_BYTE)) {
			_result.reason = refuse("is transparent", p_i, p_j, " has no transparency. Flatten the picture.");
		} else if (_info.components == 1 && std::memcmp(p_pixel, p_pixel + number, number * size_t(_format.colors - 1)) != 0) {
			_result.reason = refuse("is in colour", p_i, p_j, " is one number a texel. Use a grey picture.");
		}
		return _result.reason.empty();
	}

	// Writes a pixel's codes. NaN: leaves them.
	void lay_texel(const uint8_t *p_pixel, uint8_t *r_texel) {
		bool is_clamped = false;
		for (int component = 0; component < _info.components; component++) {
			const int number = number_of(_info, _format, component);
			const bool is_opaque = component == 3 && !_format.has_alpha;
			double value = is_opaque ? _info.value(_info.highest) : read_number(p_pixel, number, _format.is_float);
			if (std::isnan(value)) {
				continue;
			}
			if (!_format.is_float && !is_opaque) {
				value = _info.value(int32_t(std::round(value * _info.highest / FULL_BYTE)));
			}
			const int32_t code = _info.code(value);
			is_clamped = is_clamped || std::abs(value - _info.value(code)) > 1.5 * _info.unit; // more than rounding
			std::memcpy(r_texel + size_t(component * _info.bytes), &code, size_t(_info.bytes)); // little-endian, as texels are
		}
		_result.clamped += is_clamped ? 1 : 0;
	}

	MapTexels texels_of(const MapKey &p_key, MapChannel p_channel) const {
		const MapChunk *chunk = _map.find(p_key);
		return chunk != nullptr && chunk->channels[size_t(p_channel)] ? *chunk->channels[size_t(p_channel)]
																	  : _map.initial_texels(p_channel);
	}

	void lay_chunk(const MapKey &p_key) {
		const TexelRect part = part_in(_rect, p_key, _info.side);
		const MapTexels before = texels_of(p_key, _channel);
		MapTexels after = before;
		const size_t texel_bytes = size_t(_info.components * _info.bytes);
		for (int j = part.j; j < part.j + part.depth; j++) {
			for (int i = part.i; i < part.i + part.width; i++) {
				const uint8_t *pixel = &_pixels[(size_t(j - _rect.j) * size_t(_rect.width) + size_t(i - _rect.i)) * _format.bytes()];
				if (!fits(pixel, i, j)) {
					return;
				}
				const size_t texel = size_t((j - p_key.z * _info.side) * _info.side + i - p_key.x * _info.side) * texel_bytes;
				lay_texel(pixel, &after[texel]);
				if (std::memcmp(&before[texel], &after[texel], texel_bytes) != 0) {
					_changed.add(i, j);
				}
			}
		}
		if (after == before) {
			return; // an empty chunk stays empty
		}
		if (_channel == MAP_DENSITY) {
			keep(p_key, MAP_PAINT, painted(p_key, before, after));
		}
		keep(p_key, _channel, std::move(after));
	}

	// Returns the chunk's paint, with the densities that changed painted by hand.
	MapTexels painted(const MapKey &p_key, const MapTexels &p_before, const MapTexels &p_after) const {
		static_assert(info_of(MAP_PAINT).side == info_of(MAP_DENSITY).side);
		MapTexels paint = texels_of(p_key, MAP_PAINT);
		for (size_t n = 0; n < p_after.size(); n++) {
			if (p_after[n] != p_before[n]) {
				paint[2 * n] = p_after[n];
				paint[2 * n + 1] = uint8_t(HandPaint::FULL);
			}
		}
		return paint;
	}

	void keep(const MapKey &p_key, MapChannel p_channel, MapTexels &&p_texels) {
		const bool is_initial = p_texels == _map.initial_texels(p_channel);
		if (!_map.set_texels(p_key, p_channel, is_initial ? nullptr : std::make_shared<const MapTexels>(std::move(p_texels)))) {
			_result.reason = "has no room: a map holds at most " + std::to_string(PaintMap::MAX_CHUNKS) + " painted chunks.";
		}
	}

	PaintMap &_map;
	MapChannel _channel;
	const MapChannelInfo &_info;
	TexelRect _rect;
	std::span<const uint8_t> _pixels;
	PixelFormat _format;
	ChangedTexels _changed;
	LaidPicture _result;
};

// Computes normals and ledges from the map's heights where these changed. A hole stays one.
BrushResult follow_heights(PaintMap &r_map, const LaidPicture &p_changed) {
	const PaintMap map = r_map;
	const auto height = [&map](const Eigen::Vector2d &p_place) {
		const Eigen::Array2i texel = ((p_place - map.get_ground_grid().offset()).array() / GROUND_TEXEL).floor().cast<int>();
		return map.get_code(MAP_HOLE, 0, texel.x(), texel.y()) != 0
				? std::nan("")
				: info_of(MAP_GROUND).value(map.get_code(MAP_GROUND, 0, texel.x(), texel.y()));
	};
	return lay_ground(r_map, MapRegion{ p_changed.min, p_changed.max }.grown(GROUND_TEXEL), height);
}

} // namespace

PixelFormat picture_format(MapChannel p_channel, bool p_is_float) {
	const MapChannelInfo &info = info_of(p_channel);
	return { info.components == 1 ? 1 : 3, info.components == 4, p_is_float || info.bytes > 1 };
}

TexelRect texels_in(MapChannel p_channel, const MapRegion &p_region) {
	constexpr double ROUNDING = 1e-3; // texels; regions of scripts have single precision
	const double texel = info_of(p_channel).texel_size();
	const Eigen::Array2i first = (p_region.min.array() / texel + ROUNDING).floor().cast<int>();
	const Eigen::Array2i last = (p_region.max.array() / texel - ROUNDING).ceil().cast<int>();
	return { first.x(), first.y(), std::max(last.x() - first.x(), 0), std::max(last.y() - first.y(), 0) };
}

std::optional<MapRegion> find_painted(const PaintMap &p_map, MapChannel p_channel) {
	std::optional<MapRegion> region;
	for (const auto &[key, chunk] : p_map.get_chunks()) {
		if (chunk.channels[size_t(p_channel)]) {
			region = region ? region->joined(MapRegion::of_chunk(key)) : MapRegion::of_chunk(key);
		}
	}
	return region;
}

Pixels read_pixels(const PaintMap &p_map, MapChannel p_channel, const TexelRect &p_rect, bool p_is_float) {
	const MapChannelInfo &info = info_of(p_channel);
	const PixelFormat format = picture_format(p_channel, p_is_float);
	Pixels pixels(p_rect.count() * format.bytes()); // the blue of a channel of two components stays 0
	MapReader reader(p_map, p_channel);
	uint8_t *pixel = pixels.data();
	for (int j = p_rect.j; j < p_rect.j + p_rect.depth; j++) {
		for (int i = p_rect.i; i < p_rect.i + p_rect.width; i++, pixel += format.bytes()) {
			for (int component = 0; component < info.components; component++) {
				const int32_t code = reader.code(component, i, j);
				if (format.is_float) {
					const float value = float(info.value(code));
					std::memcpy(pixel + size_t(component) * 4, &value, 4);
				} else {
					pixel[component] = uint8_t(std::round(code * FULL_BYTE / info.highest));
				}
			}
		}
	}
	return pixels;
}

LaidPicture lay_picture(
		PaintMap &r_map, MapChannel p_channel, const TexelRect &p_rect, std::span<const uint8_t> p_pixels, const PixelFormat &p_format) {
	PaintMap map = r_map;
	LaidPicture result = PictureLayer(map, p_channel, p_rect, p_pixels, p_format).run();
	if (!result.reason.empty()) {
		return { {}, result.reason, 0 };
	}
	if (p_channel == MAP_GROUND && !result.changed.empty()) {
		const BrushResult followed = follow_heights(map, result);
		std::vector<MapKey> changed;
		std::set_union(result.changed.begin(), result.changed.end(), followed.changed.begin(), followed.changed.end(),
				std::back_inserter(changed));
		if (!followed.changed.empty()) {
			result.min = result.min.cwiseMin(followed.min);
			result.max = result.max.cwiseMax(followed.max);
		}
		result.changed = std::move(changed);
	}
	r_map = std::move(map);
	return result;
}

} // namespace grass
