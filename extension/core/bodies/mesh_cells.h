// SPDX-License-Identifier: MIT
// A mesh in a coarse grid: which cells its surface passes or encloses, and how convex a box of cells is.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace grass {

// A box of cells: low is inside it, high is not.
struct CellBox {
	Eigen::Vector3i low, high;
};

class MeshCells {
public:
	struct Shape {
		int count; // cells that the mesh passes or encloses
		double concavity; // share of the ways between these cells that lead outside the mesh
	};

	// Finds the cells of a mesh. p_corners: three for each face, finite; at least one face.
	explicit MeshCells(std::span<const Eigen::Vector3d> p_corners);

	CellBox get_box() const { return { Eigen::Vector3i::Zero(), _counts }; }
	Shape look_at(const CellBox &p_box) const;
	Eigen::Vector3d corner_of(const Eigen::Vector3i &p_cell) const { return _origin + _side * p_cell.cast<double>(); }
	// Returns the corners of a box that are inside the mesh and at a cut.
	std::vector<Eigen::Vector3d> enclosed_corners(const CellBox &p_box) const;

private:
	enum Kind : uint8_t { OUTSIDE, ENCLOSED, PASSED };

	int index_of(const Eigen::Vector3i &p_cell) const { return (p_cell.x() * _counts.y() + p_cell.y()) * _counts.z() + p_cell.z(); }
	Eigen::Vector3i cell_at(const Eigen::Vector3d &p_place) const;
	bool is_outside(const Eigen::Vector3d &p_place) const { return _kinds[size_t(index_of(cell_at(p_place)))] == OUTSIDE; }
	void mark_face(const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c);
	void flood();

	Eigen::Vector3d _origin;
	double _side; // of a cell, metres
	Eigen::Vector3i _counts;
	std::vector<Kind> _kinds;
	std::vector<Eigen::Vector3d> _places; // for each cell that is not outside, a place within the mesh
};

} // namespace grass
