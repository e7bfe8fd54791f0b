// SPDX-License-Identifier: MIT
#include "world/world_work.h"

#include "field/work_limits.h"
#include "resources/map_painting.h"
#include "shared/label.h"
#include "world/world_place.h"

using namespace godot;

namespace grass {

template <typename F> void WorldWork::in_plots(F &&p_work) {
	for (const PlotKey &key : _plots.get_standing()) {
		GrassField *field = _plots.find(key);
		if (field != nullptr && !outlives(_world, [&] { p_work(key, field->get_parts().work); })) {
			return; // a listener of the map freed the world
		}
	}
}

CutResult WorldWork::cut(const Ref<Shape3D> &p_shape, const Transform3D &p_transform) {
	CutResult sum;
	ERR_FAIL_COND_V_MSG(!p_transform.is_finite(), sum, vformat("%s: cut() needs a finite transform.", label_of(_world)));
	double area = 0.0;
	in_plots([&](const PlotKey &, const FieldWork &p_work) { area += p_work.find_area(p_shape, p_transform); });
	ERR_FAIL_COND_V_MSG(area > double(AREA_MAX), sum,
			vformat("%s: cut() would act on %.0f square metres, and acts on %d at most (AREA_MAX). Call it with several smaller shapes, in "
					"as many frames.",
					label_of(_world), area, AREA_MAX));
	in_plots([&](const PlotKey &, FieldWork &r_work) {
		const CutResult cut = r_work.cut(p_shape, p_transform);
		sum.area += cut.area;
		sum.volume += cut.volume;
		sum.blades += cut.blades;
	});
	return sum;
}

double WorldWork::paint(const Ref<GrassBrush> &p_brush, const Vector3 &p_from, const Vector3 &p_to) {
	ERR_FAIL_COND_V_MSG(!_world.is_inside_tree(), 0.0, vformat("%s: paint() needs the world in the tree. Add it first.", label_of(_world)));
	const String problem = problem_of_stroke(p_brush, Vector2(p_from.x, p_from.z), Vector2(p_to.x, p_to.z));
	ERR_FAIL_COND_V_MSG(!problem.is_empty() || !p_from.is_finite() || !p_to.is_finite(), 0.0,
			vformat("%s: paint(): %s", label_of(_world),
					problem.is_empty() ? String("the ends of a stroke must be finite numbers.") : problem));
	const Eigen::Vector2d from = place_in(_world, p_from), to = place_in(_world, p_to);
	const double reach = p_brush->get_reach() + MapLayers::CHANGE_MARGIN; // a neighbour's edge is blended with this one's
	const WorldGrid grid = _plots.get_grid();
	double sum = 0.0;
	in_plots([&](const PlotKey &p_key, FieldWork &r_work) {
		sum += grid.distance(p_key, from, to) <= reach ? r_work.paint(p_brush, p_from, p_to) : 0.0;
	});
	return sum;
}

} // namespace grass
