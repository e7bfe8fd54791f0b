# SPDX-License-Identifier: MIT
"""What every program solves: a straight rod clamped at one end, its sag under an even load across it, and its release without damping."""

import math

import numpy as np
import spectral

LENGTH, FREQUENCY, DENSITY = 0.5, 1.2, 1000.0  # metres, Hz of the first swing, kg/m^3: a blade by default
RADIUS = LENGTH / 100  # a blade is some ten times thinner; explicit programs would then take steps ten times as short
FIRST_SWING = 3.5160152685  # of a cantilever, in radians of its own time
OWN_TIME = FIRST_SWING / (2.0 * math.pi * FREQUENCY)  # sqrt(density area length^4 / EI), seconds
YOUNGS_MODULUS = DENSITY * LENGTH**4 / OWN_TIME**2 * 4.0 / RADIUS**2
SAGS = (1.0, 5.0)  # density area g length^3 / EI
SAG_SECONDS = 2.0  # until it hangs still, critically damped
RELEASED_FROM = 5.0
FRAMES_A_SECOND = 60
FRAMES = round(2.1 / FREQUENCY * FRAMES_A_SECOND)  # two swings and a little
SECONDS = FRAMES / FRAMES_A_SECOND
FUNCTIONS = 7  # of the reference


def gravity(load):
	"""m/s^2 of a load."""
	return load * LENGTH / OWN_TIME**2


class Reference:
	"""The theory's answers."""

	def __init__(self, functions=FUNCTIONS):
		rod = spectral.Rod(functions)
		self.sags = {load: rod.tip(rod.held(load))[1] for load in SAGS}
		self.held = rod.held(RELEASED_FROM)
		self.rod = rod
		times = np.arange(FRAMES + 1) / FRAMES_A_SECOND / OWN_TIME
		self.tips = rod.released(self.held, times)[1:]

	def angles(self, places):
		return self.rod.angles_at(places) @ self.held

	def shape(self, elements):
		"""Returns the held rod in `elements` equal pieces, each as steep as the rod in its middle; the first lies as it is clamped."""
		angles = self.angles((np.arange(elements) + 0.5) / elements)
		angles[0] = 0.0
		steps = np.stack([np.cos(angles), np.sin(angles), np.zeros(elements)], axis=1) / elements
		return np.vstack([np.zeros(3), np.cumsum(steps, axis=0)])


def crossings(side):
	"""Returns the frames, and parts of them, at which the tip passes its rest place."""
	found = [i for i in range(len(side) - 1) if (side[i] > 0.0) != (side[i + 1] > 0.0)]
	return [i + side[i] / (side[i] - side[i + 1]) for i in found]


def swing(tips):
	"""Returns (frames of a swing: the mean of two that overlap, how far the tip comes back in the end)."""
	side = tips[:, 1]
	at = crossings(side)
	if len(at) < 4:
		return math.nan, math.nan
	return (at[2] - at[0] + at[3] - at[1]) / 2.0, float(side[math.ceil(at[3]) :].max())


def errors_of_release(tips, reference):
	"""Shares by which a swing takes longer and comes back lower, and how far the tip is from the reference's, lengths (RMS)."""
	(ours, back), (right, right_back) = swing(tips), swing(reference.tips)
	way = float(np.sqrt(((tips - reference.tips) ** 2).sum(axis=1).mean()))
	return {"period": ours / right - 1.0, "amplitude_lost": 1.0 - back / right_back, "way": way}
