# SPDX-License-Identifier: MIT
"""The reference: an even rod in a plane that neither stretches nor shears, as theory has it, by a method that no compared program shares.

The rod's angle is a sum of few smooth functions of the place along it, so that its error falls faster than any power of their number.
Lengths are those of the rod, times are sqrt(density area length^4 / EI), loads density area g length^3 / EI.
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve


class Rod:
	"""Clamped at its start, along x; a load pulls it along y."""

	def __init__(self, functions, points=32):
		legendre = np.polynomial.legendre
		nodes, weights = legendre.leggauss(points)
		self.places, self.weights = (nodes + 1.0) / 2.0, weights / 2.0
		# Values at the places -> their integrals from the clamp to the places.
		to_series = np.linalg.inv(legendre.legvander(nodes, points - 1))
		self.integrals = legendre.legval(nodes, legendre.legint(to_series, lbnd=-1)).T / 2.0
		self.curvatures = np.eye(functions)  # Legendre's polynomials
		self.shapes = self.angles_at(self.places)
		self.stiffness = 1.0 / (2.0 * np.arange(functions) + 1.0)

	def angles_at(self, places):
		"""Returns the angle that each function has at `places`: [places, functions]."""
		legendre = np.polynomial.legendre
		return legendre.legval(2.0 * np.asarray(places) - 1.0, legendre.legint(self.curvatures, lbnd=-1)).T / 2.0

	def moved_by(self, strains):
		"""Returns (angle at the places, d x and d y of each by each strain)."""
		angle = self.shapes @ strains
		by_angle = np.stack([-np.sin(angle), np.cos(angle)])
		return angle, self.integrals @ (by_angle[:, :, None] * self.shapes)

	def tip(self, strains):
		angle = self.shapes @ strains
		return np.array([self.weights @ np.cos(angle), self.weights @ np.sin(angle)])

	def held(self, load):
		"""Returns the strains under a load that pulls along y, for ever; reached in steps."""
		strains = np.zeros(len(self.stiffness))
		for share in np.linspace(0.1, 1.0, 10):
			strains = fsolve(
				lambda found, now=share * load: self.stiffness * found - now * (self.weights @ self.moved_by(found)[1][1]),
				strains,
				xtol=1e-13,
			)
		return strains

	def released(self, strains, times):
		"""Returns the tip at `times`, let go at rest from `strains` without a load and without damping: [times, 2]."""
		count = len(strains)

		def rates(_, state):
			strains, speeds = state[:count], state[count:]
			angle, by_strain = self.moved_by(strains)
			turned = (self.shapes @ speeds) ** 2
			inward = self.integrals @ np.stack([-np.cos(angle) * turned, -np.sin(angle) * turned], axis=1)
			weighed = by_strain * self.weights[None, :, None]
			mass = np.einsum("cpi,cpj->ij", weighed, by_strain)
			force = -self.stiffness * strains - np.einsum("cpi,pc->i", weighed, inward)
			return np.concatenate([speeds, np.linalg.solve(mass, force)])

		start = np.concatenate([strains, np.zeros(count)])
		found = solve_ivp(rates, (0.0, times[-1]), start, method="DOP853", t_eval=times, rtol=1e-7, atol=1e-8)
		return np.array([self.tip(state[:count]) for state in found.y.T])
