// SPDX-License-Identifier: MIT
// A headset's two eyes: what either of them sees is chosen, as finely as the nearer one needs it.
#include "core/lod/view.h"

#include "core/field/field.h"
#include "core/lod/cull.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using namespace grass;

namespace {

constexpr double NEAR = 0.1, FAR = 50.0, PIXELS = 1000.0, APART = 0.064;

// As wide to one side as tangents say: OpenGL's clip space.
Eigen::Matrix4d make_projection(double p_left, double p_right, double p_height = 1.0, double p_far = FAR) {
	Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
	m(0, 0) = 2.0 / (p_right - p_left);
	m(0, 2) = (p_right + p_left) / (p_right - p_left);
	m(1, 1) = 1.0 / p_height;
	m(2, 2) = std::isinf(p_far) ? -1.0 : -(p_far + NEAR) / (p_far - NEAR);
	m(2, 3) = std::isinf(p_far) ? -2.0 * NEAR : -2.0 * p_far * NEAR / (p_far - NEAR);
	m(3, 2) = -1.0;
	return m;
}

bool sees(const Frustum &p_planes, const Eigen::Vector3f &p_point) {
	return grass_tile_visible(p_planes, p_point, Eigen::Vector3f::Zero(), 0.0f, Eigen::Vector3f::Zero());
}

// 1.5 m above the field's middle, looking along -z; each eye sees farther out on its own side, as headsets' do.
ViewCamera make_eye(bool p_is_right, double p_turned = 0.0) {
	const double outer = 1.3, inner = 0.8;
	Eigen::Affine3d pose = Eigen::Affine3d::Identity();
	pose.rotate(Eigen::AngleAxisd(p_turned, Eigen::Vector3d::UnitY()));
	pose.pretranslate(Eigen::Vector3d(0.0, 1.5, 0.0));
	pose.translate(Eigen::Vector3d(p_is_right ? 0.5 * APART : -0.5 * APART, 0.0, 0.0));
	return view_of_eye(p_is_right ? make_projection(-inner, outer) : make_projection(-outer, inner), pose, NEAR, PIXELS);
}

std::set<std::pair<int, int>> choose(const std::vector<ViewCamera> &p_cameras, int64_t *r_blades = nullptr) {
	const CullField field{ TileGrid::make(40.0, 40.0, 64.0), 0.25f, 0.5f, { 0.01f, 0.5f }, 7, { 4096, 4096 } };
	FieldView view;
	view.cameras = p_cameras;
	TileCull cull;
	cull.choose(field, view, nullptr, [](int) { return GRASS_NO_SLOT; });
	std::set<std::pair<int, int>> tiles;
	for (int level = 0; level < GRASS_LOD_LEVELS; level++) {
		const std::span<const float> all = cull.get_instances(level);
		for (size_t at = 0; at < all.size(); at += GRASS_INSTANCE_FLOATS) {
			tiles.insert({ int(all[at + INSTANCE_TILE]), int(all[at + INSTANCE_TILE + 1]) });
		}
	}
	if (r_blades != nullptr) {
		*r_blades = cull.get_blades()[0];
	}
	return tiles;
}

} // namespace

TEST_CASE("view: the planes of a projection hold what it maps into clip space, in metres") {
	const Frustum planes = frustum_of(make_projection(-0.5, 1.5));
	CHECK(sees(planes, { 0.0f, 0.0f, -1.0f }));
	CHECK(sees(planes, { -4.9f, 0.0f, -10.0f }));
	CHECK(!sees(planes, { -5.1f, 0.0f, -10.0f }));
	CHECK(sees(planes, { 14.9f, 0.0f, -10.0f }));
	CHECK(!sees(planes, { 15.1f, 0.0f, -10.0f }));
	CHECK(!sees(planes, { 0.0f, 10.1f, -10.0f }));
	CHECK(!sees(planes, { 0.0f, -10.1f, -10.0f }));
	CHECK(sees(planes, { 0.0f, 0.0f, -0.11f }));
	CHECK(!sees(planes, { 0.0f, 0.0f, -0.09f }));
	CHECK(sees(planes, { 0.0f, 0.0f, -49.9f }));
	CHECK(!sees(planes, { 0.0f, 0.0f, -50.1f }));
	for (const Eigen::Vector4f &plane : planes) {
		CHECK(plane.head<3>().norm() == doctest::Approx(1.0f)); // margins are metres
	}
}

TEST_CASE("view: a projection without a far end sees as far as there is grass") {
	const Frustum planes = frustum_of(make_projection(-1.0, 1.0, 1.0, HUGE_VAL));
	CHECK(sees(planes, { 0.0f, 0.0f, -1e6f }));
	CHECK(!sees(planes, { 0.0f, 0.0f, 1.0f }));
}

TEST_CASE("view: an eye has its own place and size of a pixel") {
	const ViewCamera right = make_eye(true);
	CHECK(right.eye.x() == doctest::Approx(0.032f));
	CHECK(right.eye.y() == doctest::Approx(1.5f));
	CHECK(right.pixel_at(10.0f) == doctest::Approx(0.02f)); // 20 m high at 10 m, of 1000 pixels
	CHECK(right.near == doctest::Approx(0.1f));
}

TEST_CASE("view: two eyes have the tiles of both, and those that only one sees are not few") {
	const auto left = choose({ make_eye(false) }), right = choose({ make_eye(true) }), both = choose({ make_eye(false), make_eye(true) });
	std::set<std::pair<int, int>> either = left;
	either.insert(right.begin(), right.end());
	CHECK(both == either);
	CHECK(both.size() > left.size() + 30); // the right eye's wedge
	CHECK(both.size() > right.size() + 30);
}

TEST_CASE("view: eyes that look the same way need as much of a tile as the nearer one") {
	int64_t far = 0, near = 0, both = 0;
	ViewCamera close = make_eye(false), away = close;
	away.eye.z() += 10.0f; // the same planes
	choose({ away }, &far);
	choose({ close }, &near);
	choose({ away, close }, &both);
	CHECK(far < near);
	CHECK(both >= near);
	CHECK(both <= near + far);
}
