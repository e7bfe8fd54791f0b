// SPDX-License-Identifier: MIT
#include "shared/watched_box.h"

using namespace godot;

namespace grass {

namespace {

// A box that moves farther at once is put somewhere, and may find neighbours there. One that moves less has an area of its own: each change
// of a shared one makes the server find all bodies in it anew. Metres.
constexpr real_t JUMP = 2.0f;

} // namespace

void WatchedBox::start(const RID &p_space, uint32_t p_mask, const Callable &p_changed, const Callable &p_area_changed) {
	stop();
	_kind = { p_space, p_mask, p_area_changed.is_valid() };
	_listener = { p_changed, p_area_changed };
}

void WatchedBox::stop() {
	leave(false);
	*this = WatchedBox();
}

void WatchedBox::join(const Ref<SharedArea> &p_area) {
	_area = p_area;
	_box = _area->add(_transform, _half_extents, _listener);
}

// Listeners hear that a body leaves only if the box joins another area, which reports the bodies in it anew.
void WatchedBox::leave(bool p_tells) {
	if (_area.is_valid()) {
		_area->remove(_box, p_tells);
		_area.unref();
	}
}

void WatchedBox::place(const Transform3D &p_transform, const Vector3 &p_half_extents) {
	if (!_kind.space.is_valid()) {
		return;
	}
	if (_half_extents != p_half_extents) {
		_half_extents = p_half_extents;
		if (_area.is_valid()) {
			_area->resize(_box, p_half_extents);
		}
	}
	if (_area.is_null()) {
		_transform = p_transform;
		join(SharedArea::find(_kind, _transform, _half_extents));
	} else if (_transform != p_transform) {
		const bool has_jumped = (p_transform.origin - _transform.origin).length() > JUMP;
		_transform = p_transform;
		if (has_jumped) {
			leave(true);
			join(SharedArea::find(_kind, _transform, _half_extents));
		} else if (_area->is_shared()) {
			leave(true);
			join(SharedArea::make(_kind, _transform));
			_area->move(_box, _transform);
		} else {
			_area->move(_box, _transform);
		}
	}
}

void WatchedBox::set_mask(uint32_t p_mask) {
	if (_kind.mask != p_mask && _kind.space.is_valid()) {
		_kind.mask = p_mask;
		if (_area.is_valid()) {
			leave(true);
			join(SharedArea::find(_kind, _transform, _half_extents));
		}
	}
}

} // namespace grass
