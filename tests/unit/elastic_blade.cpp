// SPDX-License-Identifier: MIT
#include "elastic_blade.h"

namespace grass::test {

namespace {

void take(Blade<double> &r_blade, const GrassStep &p_step) {
	step_blade(r_blade, make_terms<double>(p_step, 0.0f, {}));
}

} // namespace

void ElasticBlade::step(double p_delta) {
	take(blade, clock.advance(params, p_delta));
}

void ElasticBlade::step_aloft(double p_delta) {
	GrassStep step = clock.advance(params, p_delta);
	step.contact.z = -100.0f;
	take(blade, step);
}

} // namespace grass::test
