// SPDX-License-Identifier: MIT
// Posts jobs from the main thread to the render thread, which alone may use a GpuField.
#pragma once

#include "gpu/render_queue.h"

#include <memory>
#include <utility>

namespace grass {

class GpuField;

class FieldJobs {
public:
	explicit FieldJobs(std::shared_ptr<GpuField> p_field) : _field(std::move(p_field)) {}

	// Runs p_job(field) on the render thread. What it captures must be a copy.
	template <typename F> void post(F &&p_job) {
		_posted++;
		RenderQueue::get_singleton()->post([field = _field, job = std::forward<F>(p_job)]() mutable { job(*field); });
	}
	int64_t get_posted() const { return _posted; } // so far

private:
	std::shared_ptr<GpuField> _field;
	int64_t _posted = 0;
};

} // namespace grass
