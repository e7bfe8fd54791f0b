// SPDX-License-Identifier: MIT
#include "resources/channel_images.h"

#include "core/paint/channel_picture.h"
#include "core/paint/picture_header.h"
#include "resources/grass_map_file.h"
#include "resources/map_painting.h"
#include "resources/size_limits.h"
#include "shared/convert.h"
#include "shared/text.h"

#include <godot_cpp/classes/file_access.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

constexpr char EXR[] = "exr", PNG[] = "png";

PictureProblem refuse(const String &p_text, Error p_error = ERR_INVALID_PARAMETER) {
	return { p_error, p_text };
}

struct ImageFormat {
	Image::Format image;
	PixelFormat pixels;
};

// How pixels of an image are stored; half floats must be converted before. Of formats alike, the first is the one that pictures get.
constexpr ImageFormat FORMATS[] = {
	{ Image::FORMAT_L8, { 1, false, false } },
	{ Image::FORMAT_R8, { 1, false, false } },
	{ Image::FORMAT_LA8, { 1, true, false } },
	{ Image::FORMAT_RG8, { 2, false, false } },
	{ Image::FORMAT_RGB8, { 3, false, false } },
	{ Image::FORMAT_RGBA8, { 3, true, false } },
	{ Image::FORMAT_RF, { 1, false, true } },
	{ Image::FORMAT_RGF, { 2, false, true } },
	{ Image::FORMAT_RGBF, { 3, false, true } },
	{ Image::FORMAT_RGBAF, { 3, true, true } },
};

std::optional<PixelFormat> format_of(Image::Format p_format) {
	const ImageFormat *found = std::ranges::find(FORMATS, p_format, &ImageFormat::image);
	return found != std::end(FORMATS) ? std::optional(found->pixels) : std::nullopt;
}

// Returns the engine's format. p_format: a picture_format().
Image::Format image_format(const PixelFormat &p_format) {
	return std::ranges::find(FORMATS, p_format, &ImageFormat::pixels)->image;
}

// Returns the image with whole floats instead of half ones.
Ref<Image> with_whole_floats(const Ref<Image> &p_image) {
	const int format = p_image->get_format();
	if (format < Image::FORMAT_RH || format > Image::FORMAT_RGBAH) {
		return p_image;
	}
	Ref<Image> image = p_image->duplicate();
	image->convert(Image::Format(format - Image::FORMAT_RH + Image::FORMAT_RF));
	return image;
}

PictureProblem compare_size(const char *p_channel, const TexelRect &p_rect, int64_t p_width, int64_t p_height) {
	return p_width == p_rect.width && p_height == p_rect.depth
			? PictureProblem()
			: refuse(vformat("the picture has %d x %d pixels, but %s has %d x %d texels there. Scale the picture to that size, or give "
							 "the region that it covers.",
					  p_width, p_height, p_channel, p_rect.width, p_rect.depth));
}

// Finds the texels that a region of a channel's picture covers.
PictureProblem find_rect(const GrassMap &p_map, GrassMap::Channel p_channel, const Rect2 &p_region, TexelRect &r_rect) {
	if (p_channel < 0 || p_channel >= int64_t(MAP_CHANNELS)) {
		return refuse("no such channel. Use one of the CHANNEL_* constants.");
	}
	const MapChannel channel = MapChannel(p_channel);
	MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	if (p_region == Rect2()) {
		const std::optional<MapRegion> painted = find_painted(p_map.copy(), channel);
		if (!painted) {
			return refuse(vformat("%s was painted nowhere, so the picture needs a region.", info_of(channel).name));
		}
		region = *painted;
	} else if (const String problem = problem_of_region("a picture", p_region); !problem.is_empty()) {
		return refuse(problem);
	}
	r_rect = texels_in(channel, region);
	const ReadLimits limits = get_read_limits();
	const size_t bytes = r_rect.count() * std::max<size_t>(picture_format(channel, true).bytes(), 4);
	return bytes <= limits.map_bytes
			? PictureProblem()
			: refuse(vformat("a picture of %d x %d texels would take %s of memory, but it may take at most %s%s. Use smaller regions.",
							 r_rect.width, r_rect.depth, text_of(megabytes(bytes)), text_of(megabytes(limits.map_bytes)),
							 text_of(limits.map_hint)),
					  ERR_OUT_OF_MEMORY);
}

PictureProblem make_picture(
		const GrassMap &p_map, GrassMap::Channel p_channel, const Rect2 &p_region, bool p_is_float, Ref<Image> &r_image) {
	TexelRect rect;
	if (PictureProblem problem = find_rect(p_map, p_channel, p_region, rect); problem.error != OK) {
		return problem;
	}
	const Pixels pixels = read_pixels(p_map.copy(), MapChannel(p_channel), rect, p_is_float);
	r_image = Image::create_from_data(
			rect.width, rect.depth, false, image_format(picture_format(MapChannel(p_channel), p_is_float)), to_bytes(std::span(pixels)));
	return r_image.is_valid() && !r_image->is_empty() ? PictureProblem()
													  : refuse("the engine cannot make so large an image. Use smaller regions.");
}

PictureProblem lay_image(GrassMap &r_map, GrassMap::Channel p_channel, const Ref<Image> &p_image, const Rect2 &p_region) {
	TexelRect rect;
	if (PictureProblem problem = find_rect(r_map, p_channel, p_region, rect); problem.error != OK) {
		return problem;
	}
	if (p_image.is_null() || p_image->is_empty()) {
		return refuse("there is no image.");
	}
	const MapChannelInfo &info = info_of(MapChannel(p_channel));
	if (PictureProblem problem = compare_size(info.name, rect, p_image->get_width(), p_image->get_height()); problem.error != OK) {
		return problem;
	}
	const Ref<Image> image = with_whole_floats(p_image);
	const std::optional<PixelFormat> format = format_of(image->get_format());
	if (!format) {
		return refuse("the image has a format that is not read. Decompress it, and convert() it to FORMAT_L8, FORMAT_RGBA8 or FORMAT_RF.");
	}
	const PackedByteArray bytes = image->get_data();
	const ReadLimits limits = get_read_limits();
	const String label = r_map.label(); // a listener may free the map
	LaidPicture laid;
	std::string reason;
	const auto lay = [&](PaintMap &r_changed) {
		PaintMap now = r_changed;
		LaidPicture result = lay_picture(now, MapChannel(p_channel), rect, std::span(bytes.ptr(), size_t(bytes.size())), *format);
		reason = result.reason;
		if (const size_t size = now.get_memory_usage(); size > limits.map_bytes && size > r_changed.get_memory_usage()) {
			reason = "would make the map take " + megabytes(size) + " of memory, but it may take at most " + megabytes(limits.map_bytes) +
					limits.map_hint + ".";
		}
		if (!reason.empty()) {
			return LaidPicture();
		}
		r_changed = std::move(now);
		return result;
	};
	const String refusal = r_map.try_change(lay, laid);
	if (!refusal.is_empty() || !reason.empty()) {
		return refuse(refusal.is_empty() ? vformat("the picture %s", text_of(reason)) : refusal, ERR_INVALID_DATA);
	}
	if (laid.clamped > 0) {
		WARN_PRINT(vformat("%s: %d pixels had values outside of what %s can be, %s to %s. They were clamped.", label, int64_t(laid.clamped),
				info.name, info.value(info.lowest), info.value(info.highest)));
	}
	return {};
}

} // namespace

Ref<Image> get_channel_image(const GrassMap &p_map, GrassMap::Channel p_channel, const Rect2 &p_region, bool p_is_float) {
	Ref<Image> image;
	const PictureProblem problem = make_picture(p_map, p_channel, p_region, p_is_float, image);
	ERR_FAIL_COND_V_MSG(problem.error != OK, Ref<Image>(), vformat("%s: get_channel_image(): %s", p_map.label(), problem.text));
	return image;
}

bool set_channel_image(GrassMap &r_map, GrassMap::Channel p_channel, const Ref<Image> &p_image, const Rect2 &p_region) {
	const PictureProblem problem = lay_image(r_map, p_channel, p_image, p_region);
	ERR_FAIL_COND_V_MSG(problem.error != OK, false, vformat("%s: set_channel_image(): %s", r_map.label(), problem.text));
	return true;
}

PictureProblem write_picture(const GrassMap &p_map, GrassMap::Channel p_channel, const String &p_path, const Rect2 &p_region) {
	const bool is_exr = p_path.get_extension().to_lower() == EXR;
	if (!is_exr && p_path.get_extension().to_lower() != PNG) {
		return refuse("a picture is saved as .png (8 bit) or .exr (floats).", ERR_FILE_UNRECOGNIZED);
	}
	Ref<Image> image;
	if (PictureProblem problem = make_picture(p_map, p_channel, p_region, is_exr, image); problem.error != OK) {
		return problem;
	}
	const MapChannelInfo &info = info_of(MapChannel(p_channel));
	if (!is_exr && info.bytes > 1) {
		return refuse(vformat("%s is in metres, for which the 8 bits of a PNG are too coarse. Save it as .exr.", info.name));
	}
	const PackedByteArray bytes = is_exr ? image->save_exr_to_buffer(info.components == 1) : image->save_png_to_buffer();
	if (bytes.is_empty()) {
		return refuse(
				"the engine cannot write this picture: EXR needs the editor's engine, exported games have PNG alone.", ERR_UNAVAILABLE);
	}
	const Error error = write_map_file(bytes, p_path, "the picture");
	return error == OK ? PictureProblem() : refuse("the file cannot be written. Check that the folder exists.", error);
}

PictureProblem read_picture(GrassMap &r_map, GrassMap::Channel p_channel, const String &p_path, const Rect2 &p_region) {
	TexelRect rect;
	if (PictureProblem problem = find_rect(r_map, p_channel, p_region, rect); problem.error != OK) {
		return problem;
	}
	const PackedByteArray bytes = FileAccess::get_file_as_bytes(p_path);
	if (bytes.is_empty()) {
		return refuse("the file cannot be opened, or is empty. Check that it exists and can be read.", ERR_FILE_CANT_OPEN);
	}
	const PictureHeader header = read_picture_header(std::span(bytes.ptr(), size_t(bytes.size())));
	if (header.kind == PictureHeader::UNKNOWN) {
		return refuse("the file is neither a PNG nor an EXR. Save the picture as one of them.", ERR_FILE_UNRECOGNIZED);
	}
	if (!header.reason.empty()) {
		return refuse(vformat("the picture %s", text_of(header.reason)), ERR_INVALID_DATA);
	}
	if (header.width > 0) { // nothing larger is unpacked
		PictureProblem problem = compare_size(info_of(MapChannel(p_channel)).name, rect, header.width, header.height);
		if (problem.error != OK) {
			return problem;
		}
	}
	Ref<Image> image;
	image.instantiate();
	const Error error = header.width <= 0       ? ERR_FILE_CORRUPT
			: header.kind == PictureHeader::EXR ? image->load_exr_from_buffer(bytes)
												: image->load_png_from_buffer(bytes);
	if (error == ERR_UNAVAILABLE) {
		return refuse("EXR needs the editor's engine, exported games read PNG alone.", error);
	}
	if (error != OK) {
		return refuse(
				"the file is damaged, cut off, or of a kind that the engine does not read. Save the picture again.", ERR_FILE_CORRUPT);
	}
	return lay_image(r_map, p_channel, image, p_region);
}

int64_t save_channel_image(const GrassMap &p_map, GrassMap::Channel p_channel, const String &p_path, const Rect2 &p_region) {
	const PictureProblem problem = write_picture(p_map, p_channel, p_path, p_region);
	ERR_FAIL_COND_V_MSG(problem.error != OK, problem.error, vformat("%s: cannot save '%s': %s", p_map.label(), p_path, problem.text));
	return OK;
}

int64_t load_channel_image(GrassMap &r_map, GrassMap::Channel p_channel, const String &p_path, const Rect2 &p_region) {
	const PictureProblem problem = read_picture(r_map, p_channel, p_path, p_region);
	ERR_FAIL_COND_V_MSG(problem.error != OK, problem.error, vformat("%s: cannot load '%s': %s", r_map.label(), p_path, problem.text));
	return OK;
}

} // namespace grass
