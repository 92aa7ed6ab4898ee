#!/usr/bin/env python3
"""Write the golden tables: inputs that are exactly f32, expected values from arbitrary precision.

    python3 tests/golden/generate.py [--out DIR] [--check]

Needs Python 3 and mpmath, nothing else; nothing here calls the crate. One CSV per quantity goes to
DIR (default: the folder of this script). `--check` writes nothing, compares with the files in DIR
byte for byte and exits with 1 when one differs. Inputs are printed so that parsing them as f64
gives back the f32 exactly. Expected values are exact functions of the printed inputs, rounded to 20
digits: each is evaluated at 60 and 120 digits, and the precision doubles until two evaluations
agree to 25. A value too small for f64 is printed as it is.

Convention: tangent frame with n = +z, slope s = (-m_x/m_z, -m_y/m_z) of a normal m, roughness
matrix A (isotropic: alpha^2 I), q = (s - mean)^T A^-1 (s - mean).

Formulas, by table:
  *_p22               P22 = exp(-q) / (pi sqrt(det A)) for Beckmann, 1 / (pi sqrt(det A) (1 + q)^2)
                      for GGX: Heitz 2014, "Understanding the Masking-Shadowing Function"; mean
                      slope: Dupuy et al. 2013 (LEADR)
  *_d                 P22 / m_z^4
  *_projected_area    sigma(w) = integral of max(0, w.(-s, 1)) P22(s) ds, in closed form through c =
                      w.(-mean, 1) and a = sqrt(w_xy^T A w_xy)
  *_lambda            sigma/c - 1: Walter et al. 2007, Heitz 2014
  *_brdf              D(h) / (4 (sigma_o c_i + sigma_i c_o - c_o c_i)), h = normalize(wo + wi):
                      height-correlated Smith masking, F = 1, cosines c to the mean normal (LEADR);
                      0 where c_o <= 0 or c_i <= 0
  ggx_rectangle_mean  Kaplanyan et al. 2016, "Filtering Distributions of Normals for Shading
                      Antialiasing", Appendix A, over the full rectangle slope +- half;
                      beckmann_rectangle_mean: differences of erf along each axis
  ggx_parallelogram_mean
                      Lambert's polygon formula in whitened slopes, as GGX is a linearly transformed
                      cosine; where the area is zero, its limit: closed forms along a line
  ggx_gaussian_mean   GGX is the mixture integral e^-t P_beckmann(s; A/t) dt; convolution with N(0,
                      K) adds 2 K to each A/t; trapezoid rule in ln t
  ggx_proxy_rectangle_alpha
                      alpha of the GGX as high as GGX averaged over a square: Kaplanyan et al. 2016,
                      Eq. 20, re-derived from Eq. 18 and 19
  ggx_proxy_gaussian_alpha
                      alpha of the GGX as high as GGX under an isotropic Gaussian, through the
                      exponential integral
  jacobians           Tokuyoshi 2017, "Error Reduction and Simplification for Shading
                      Anti-Aliasing", Eqs. 5, 8, 25; the sphere's frame: along the meridian away
                      from n, then along n x h
  half_slope_jacobian Kaplanyan et al. 2016, Eq. 4
  chermain_m          Chermain et al. 2021, "Real-Time Geometric Glint Anti-Aliasing with Normal Map
                      Filtering", Eq. 18

Self-checks, made every time on rows of the tables themselves. In f64 and two dimensions, on
moderate rows, where direct integration converges; in arbitrary precision on rows of every kind:
  P22                 integrates to 1 over the plane
  D, BRDF             against the textbook forms in angles (isotropic, centered); the BRDF also by
                      its factors, Lambda by quadrature, and with wo and wi swapped
  sigma, Lambda       against two-dimensional quadrature of the defining integral; along the one
                      axis that matters
  rectangles          against two-dimensional quadrature of P22; GGX as a parallelogram, Beckmann by
                      quadrature per axis
  parallelograms      against two-dimensional quadrature of P22; line by line; those of no area
                      against very thin ones
  Gaussian mean       against quadrature of the convolution (all rows of singular K); against an
                      adaptive rule for the mixture; at the peak against the exponential integral
  proxies             the peak 1/(pi alpha'^2): of squares against the rectangle's formula (all
                      rows) and line by line, of Gaussians against the mixture and by quadrature
                      over the radius
  Jacobians           against numerical derivatives of the maps, all rows
  half-slope Jacobian against numerical derivatives over a curved surface, all rows
  Chermain's M        sigma_o^2 M M^T is the covariance, all rows
"""

import argparse
import math
import random
import struct
import sys
import time
from pathlib import Path

from mpmath import fp, mp, mpf  # fp: the same interface in f64

DIGITS = 20  # printed
AGREE = 25  # two evaluations must agree to so many digits
DPS = 60  # first working precision
TAU = 2 * math.pi

ROWS = 600
KEEP_ABOVE = 1e-30  # a Beckmann lobe's far tail says little: all but a few rows lie above
DRAWS = 200  # tries for a row that lies above; some special cases cannot

MATRIX = "a_xx a_xy a_yy"
MEAN = "mean_x mean_y"


# -------------------------------------------------------------------------------------------------
# Numbers


def f32(x):
    """The nearest f32, as a float; never -0."""
    return struct.unpack("<f", struct.pack("<f", x))[0] + 0.0


def f32s(*xs):
    return tuple(f32(x) for x in xs)


def stable(formula, inputs):
    """`formula` of the exact inputs, at a precision doubled until two evaluations agree to 25
    digits.

    An output that vanishes identically comes out as rounding noise, which never agrees: what lies
    50 digits below the largest output is zero."""
    dps, before = DPS, None
    while dps < 10000:
        with mp.workdps(dps):
            values = formula(*[mpf(x) for x in inputs])
            values = list(values) if isinstance(values, (list, tuple)) else [values]
            noise = max(abs(x) for x in values) * mpf(10) ** -50
            values = [x if abs(x) > noise else mpf(0) for x in values]
            if before and all(
                abs(x - y) <= mpf(10) ** -AGREE * abs(x) for x, y in zip(values, before)
            ):
                return values
        dps, before = 2 * dps, values
    raise ArithmeticError(f"no stable value for {formula} {inputs}")


def show(x):
    """20 digits in scientific notation, whatever the exponent."""
    return mp.nstr(x, DIGITS, min_fixed=0, max_fixed=0)


def rare(row):
    """The rows that may underflow or vanish, whatever they drew."""
    return row % 60 == 8


# -------------------------------------------------------------------------------------------------
# The two lobes: density from (q, sqrt(det A)), projected area and Lambda from (c, a); and where to
# sample them


class Beckmann:
    name = "beckmann"

    @staticmethod
    def slope_pdf(q, root_det):
        return mp.exp(-q) / (mp.pi * root_det)

    @staticmethod
    def projected_area(c, a):
        if a == 0:
            return max(c, mpf(0))
        # 1 + erf(c/a) written as erfc(-c/a) keeps the tail c < 0.
        return c * mp.erfc(-c / a) / 2 + a * mp.exp(-((c / a) ** 2)) / (2 * mp.sqrt(mp.pi))

    @staticmethod
    def masking(c, a):
        if a == 0:
            return mpf(0)
        v = c / a
        return mp.exp(-v * v) / (2 * v * mp.sqrt(mp.pi)) - mp.erfc(v) / 2

    @staticmethod
    def radius(rng):
        """Whitened distance from the center: mostly the body, partly the tail."""
        return rng.uniform(0, 3) if rng.random() < 0.7 else rng.uniform(3, 8)

    @staticmethod
    def ratio(rng):
        """c/a: sigma moves from exponentially small to c between -7 and 4."""
        return rng.uniform(-7, 4) if rng.random() < 0.7 else signed(rng, 1e-4, 1e2)

    @staticmethod
    def keep(expected, row):
        return expected > KEEP_ABOVE or rare(row)


class Ggx:
    name = "ggx"

    @staticmethod
    def slope_pdf(q, root_det):
        return 1 / (mp.pi * root_det * (1 + q) ** 2)

    @staticmethod
    def projected_area(c, a):
        return (c + mp.sqrt(c * c + a * a)) / 2

    @staticmethod
    def masking(c, a):
        return (mp.sqrt(1 + (a / c) ** 2) - 1) / 2

    @staticmethod
    def radius(rng):
        return rng.uniform(0, 3) if rng.random() < 0.7 else log_uniform(rng, 3, 1e3)

    @staticmethod
    def ratio(rng):
        return rng.uniform(-3, 3) if rng.random() < 0.5 else signed(rng, 1e-4, 1e4)

    @staticmethod
    def keep(expected, row):
        return True


def quadratic(x, y, xx, xy, yy):
    """(x, y) [[xx, xy], [xy, yy]] (x, y)^T"""
    return xx * x * x + 2 * xy * x * y + yy * y * y


def inverse_quadratic(x, y, xx, xy, yy):
    """(x, y) A^-1 (x, y)^T and sqrt(det A)"""
    det = xx * yy - xy * xy
    return quadratic(x, y, yy, -xy, xx) / det, mp.sqrt(det)


# -------------------------------------------------------------------------------------------------
# Random inputs. uniform, randrange and choice give the same sequence for a seed in every Python
# since 3.2.


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def signed(rng, low, high):
    return math.copysign(log_uniform(rng, low, high), rng.random() - 0.5)


def circle(rng, radius):
    phi = rng.uniform(0, TAU)
    return radius * math.cos(phi), radius * math.sin(phi)


def correlation(rng):
    """Half of them ordinary, half close to +-1, up to 0.9999."""
    if rng.random() < 0.5:
        return rng.uniform(-0.95, 0.95)
    return math.copysign(1 - log_uniform(rng, 1e-4, 0.1), rng.random() - 0.5)


def covariance(x, y, rho):
    """[[x^2, rho x y], [rho x y, y^2]] in f32, or None where rounding has cost it its
    definiteness."""
    xx, xy, yy = f32s(x * x, rho * x * y, y * y)
    # Products of two f32 are exact in f64, hence so is the comparison.
    return (xx, xy, yy) if xx * yy > xy * xy else None


def roughness(rng, low=1e-4, high=30.0):
    """A third isotropic, a third axis-aligned, a third correlated."""
    kind = rng.randrange(3)
    x = log_uniform(rng, low, high)
    if kind == 0:
        return covariance(x, x, 0)
    y = (
        min(max(x * log_uniform(rng, 0.1, 10), low), high)
        if rng.random() < 0.5
        else log_uniform(rng, low, high)
    )
    return covariance(x, y, correlation(rng) if kind == 2 else 0) or roughness(rng, low, high)


def cholesky(xx, xy, yy):
    x = math.sqrt(xx)
    return x, xy / x, math.sqrt(yy - xy * xy / xx)


def unwhiten(point, a):
    l_xx, l_yx, l_yy = cholesky(*a)
    return l_xx * point[0], l_yx * point[0] + l_yy * point[1]


def unit(x, y, z):
    norm = math.sqrt(x * x + y * y + z * z)
    return f32s(x / norm, y / norm, z / norm)


def from_z(rng, z):
    return unit(*circle(rng, math.sqrt(1 - z * z)), z)


def from_tilt(rng, tilt):
    return unit(*circle(rng, tilt), math.sqrt(1 - tilt * tilt))


def direction(rng):
    """Upper hemisphere: uniform, towards grazing (z to 1e-6), or towards the normal (tilt to
    1e-6)."""
    kind = rng.randrange(3)
    if kind == 0:
        return from_z(rng, rng.uniform(1e-3, 1))
    return (
        from_z(rng, log_uniform(rng, 1e-6, 1))
        if kind == 1
        else from_tilt(rng, log_uniform(rng, 1e-6, 1))
    )


def slope_anywhere(rng):
    return f32s(signed(rng, 1e-6, 1e3), signed(rng, 1e-6, 1e3))


def mean_slope(rng, high=1e3):
    return (0.0, 0.0) if rng.random() < 0.4 else f32s(*circle(rng, log_uniform(rng, 1e-3, high)))


def near(rng, lobe, mean, a):
    """A slope of the lobe, mean + L w, of components to 1e3."""
    while True:
        x, y = unwhiten(circle(rng, lobe.radius(rng)), a)
        if max(abs(mean[0] + x), abs(mean[1] + y)) <= 1e3:
            return f32s(mean[0] + x, mean[1] + y)


def by_kind(row, near_row, anywhere_row, special_rows):
    """60 % near the lobe, 30 % anywhere, 10 % special cases in turn."""
    kind = row % 10
    if kind < 6:
        return near_row()
    return anywhere_row() if kind < 9 else special_rows[row // 10 % len(special_rows)]()


# -------------------------------------------------------------------------------------------------
# P22 and D


def p22(lobe):
    def formula(s_x, s_y, mean_x, mean_y, *a):
        return lobe.slope_pdf(*inverse_quadratic(s_x - mean_x, s_y - mean_y, *a))

    return formula


def p22_inputs(lobe, rng, row):
    mean, a = mean_slope(rng), roughness(rng)
    far = f32s(*circle(rng, 1e3))
    ridge = covariance(0.3, 2.0, 0.9999)
    return by_kind(
        row,
        lambda: near(rng, lobe, mean, a) + mean + a,
        lambda: slope_anywhere(rng) + mean_slope(rng) + a,
        [
            lambda: mean + mean + a,
            lambda: (0.0, 0.0, 0.0, 0.0) + a,
            lambda: f32s(*circle(rng, 1e-6)) + (0.0, 0.0) + a,
            lambda: near(rng, lobe, far, a) + far + a,
            lambda: near(rng, lobe, (0, 0), ridge) + (0.0, 0.0) + ridge,
            lambda: near(rng, lobe, mean, covariance(1e-4, 1e-4, 0))
            + mean
            + covariance(1e-4, 1e-4, 0),
            lambda: near(rng, lobe, mean, covariance(30, 30, 0)) + mean + covariance(30, 30, 0),
        ],
    )


def ndf(lobe):
    def formula(m_x, m_y, m_z, *a):
        return p22(lobe)(-m_x / m_z, -m_y / m_z, 0, 0, *a) / m_z**4

    return formula


def ndf_inputs(lobe, rng, row):
    a = roughness(rng)

    def normal_of(slope):
        return unit(-slope[0], -slope[1], 1)

    return by_kind(
        row,
        lambda: normal_of(near(rng, lobe, (0, 0), a)) + a,
        lambda: direction(rng) + a,
        [
            lambda: (0.0, 0.0, 1.0) + a,
            lambda: from_tilt(rng, 1e-6) + a,
            lambda: from_z(rng, 1e-6) + a,
            lambda: f32s(0.6, 0, 0.8) + a,
            lambda: f32s(0, -0.8, 0.6) + a,
        ],
    )


# -------------------------------------------------------------------------------------------------
# Projected area, Lambda, BRDF


def stretch_squared(w_x, w_y, a):
    return quadratic(w_x, w_y, *a)


def area(lobe):
    def formula(w_x, w_y, w_z, mean_x, mean_y, *a):
        return lobe.projected_area(
            w_z - mean_x * w_x - mean_y * w_y, mp.sqrt(stretch_squared(w_x, w_y, a))
        )

    return formula


def direction_at(rng, lobe, mean, a, ratio):
    """The direction of a random azimuth with c/a = ratio."""
    x, y = circle(rng, 1)
    return unit(x, y, ratio * math.sqrt(stretch_squared(x, y, a)) + mean[0] * x + mean[1] * y)


def either_side(rng, w):
    return w if rng.random() < 0.6 else (w[0], w[1], -w[2])


def area_inputs(lobe, rng, row):
    mean, a = mean_slope(rng), roughness(rng)
    far = f32s(*circle(rng, 1e3))
    x, y = circle(rng, 1)
    return by_kind(
        row,
        lambda: direction_at(rng, lobe, mean, a, lobe.ratio(rng)) + mean + a,
        lambda: either_side(rng, direction(rng)) + mean + a,
        [
            lambda: (0.0, 0.0, 1.0) + mean + a,
            lambda: (0.0, 0.0, -1.0) + mean + a,
            lambda: f32s(x, y, 0) + mean + a,
            lambda: f32s(x, y, 0) + (0.0, 0.0) + a,
            lambda: from_tilt(rng, 1e-6) + mean + a,
            lambda: either_side(rng, from_z(rng, 1e-6)) + (0.0, 0.0) + a,
            lambda: direction_at(rng, lobe, far, a, lobe.ratio(rng)) + far + a,
        ],
    )


def masking(lobe):
    def formula(w_x, w_y, w_z, *a):
        return lobe.masking(w_z, mp.sqrt(stretch_squared(w_x, w_y, a)))

    return formula


def masking_inputs(lobe, rng, row):
    a = roughness(rng)

    def grazing_enough():
        while True:
            w = direction_at(rng, lobe, (0, 0), a, abs(lobe.ratio(rng)))
            if w[2] >= 1e-6:
                return w

    return by_kind(
        row,
        lambda: grazing_enough() + a,
        lambda: direction(rng) + a,
        [
            lambda: (0.0, 0.0, 1.0) + a,
            lambda: from_tilt(rng, 1e-6) + a,
            lambda: from_z(rng, 1e-6) + a,
            lambda: from_z(rng, 1e-3) + a,
        ],
    )


def brdf(lobe):
    def formula(o_x, o_y, o_z, i_x, i_y, i_z, mean_x, mean_y, *a):
        c_o = o_z - mean_x * o_x - mean_y * o_y
        c_i = i_z - mean_x * i_x - mean_y * i_y
        if c_o <= 0 or c_i <= 0:
            return mpf(0)
        sigma_o = area(lobe)(o_x, o_y, o_z, mean_x, mean_y, *a)
        sigma_i = area(lobe)(i_x, i_y, i_z, mean_x, mean_y, *a)
        g_x, g_y, g_z = o_x + i_x, o_y + i_y, o_z + i_z
        cosine = g_z / mp.sqrt(g_x**2 + g_y**2 + g_z**2)
        density = p22(lobe)(-g_x / g_z, -g_y / g_z, mean_x, mean_y, *a) / cosine**4
        return density / (4 * (sigma_o * c_i + sigma_i * c_o - c_o * c_i))

    return formula


def reflect(w, slope):
    """w mirrored by the micronormal of a slope."""
    h = (-slope[0], -slope[1], 1)
    scale = 2 * sum(x * y for x, y in zip(w, h)) / sum(x * x for x in h)
    return unit(*[scale * y - x for x, y in zip(w, h)])


def reflected_pair(rng, lobe, mean, a):
    """wo, and wi by a micronormal of the lobe, both above the horizon."""
    while True:
        w_o = direction(rng)
        w_i = reflect(w_o, near(rng, lobe, mean, a))
        if w_i[2] >= 1e-6:
            return w_o + w_i


def brdf_inputs(lobe, rng, row):
    mean, a = mean_slope(rng, 3), roughness(rng)
    normal, w, v = (0.0, 0.0, 1.0), direction(rng), direction(rng)
    return by_kind(
        row,
        lambda: reflected_pair(rng, lobe, mean, a) + mean + a,
        lambda: w + v + mean + a,
        [
            lambda: normal + normal + (0.0, 0.0) + a,
            lambda: normal + normal + mean + a,
            lambda: w + w + mean + a,
            lambda: w + (-w[0] + 0.0, -w[1] + 0.0, w[2]) + mean + a,
            lambda: from_tilt(rng, 1e-6) + from_tilt(rng, 1e-6) + (0.0, 0.0) + a,
            lambda: from_z(rng, 1e-6) + from_z(rng, 1e-6) + (0.0, 0.0) + a,
            lambda: from_z(rng, 1e-6) + v + (0.0, 0.0) + a,
            lambda: from_z(rng, 1e-4) + from_tilt(rng, 1e-4) + mean + a,
        ],
    )


# -------------------------------------------------------------------------------------------------
# Means over a rectangle


def ggx_box(x, y):
    """Mass of a unit GGX lobe over [0, x] x [0, y]."""
    r_x, r_y = mp.sqrt(1 + x * x), mp.sqrt(1 + y * y)
    return (x / r_x * mp.atan(y / r_x) + y / r_y * mp.atan(x / r_y)) / (2 * mp.pi)


def ggx_line(t, q):
    """Integral from 0 to t of 1/(pi (q + t^2)^2)."""
    root = mp.sqrt(q)
    return (t / (q + t * t) + mp.atan(t / root) / root) / (2 * mp.pi * q)


def ggx_line_twice(t, q):
    """The same, integrated once more (up to a constant)."""
    return t * mp.atan(t / mp.sqrt(q)) / (2 * mp.pi * q * mp.sqrt(q))


def ggx_segment(t, half, q):
    """Mean of 1/(pi (q + t^2)^2) over t +- half."""
    return (
        (ggx_line(t + half, q) - ggx_line(t - half, q)) / (2 * half)
        if half
        else 1 / (mp.pi * (q + t * t) ** 2)
    )


def ggx_rectangle(s_x, s_y, half_x, half_y, alpha_x, alpha_y):
    x, y, u, v = s_x / alpha_x, s_y / alpha_y, half_x / alpha_x, half_y / alpha_y
    if not u:
        mean = ggx_segment(y, v, 1 + x * x)
    elif not v:
        mean = ggx_segment(x, u, 1 + y * y)
    else:
        mass = (
            ggx_box(x + u, y + v)
            - ggx_box(x - u, y + v)
            - ggx_box(x + u, y - v)
            + ggx_box(x - u, y - v)
        )
        mean = mass / (4 * u * v)
    return mean / (alpha_x * alpha_y)


def beckmann_interval(x, half):
    """Mean of exp(-x^2)/sqrt(pi) over x +- half; erfc keeps the tails."""
    if not half:
        return mp.exp(-x * x) / mp.sqrt(mp.pi)
    low, high = abs(x) - half, abs(x) + half
    mass = mp.erfc(low) - mp.erfc(high) if low > 0 else mp.erf(high) - mp.erf(low)
    return mass / (4 * half)


def beckmann_rectangle(s_x, s_y, half_x, half_y, alpha_x, alpha_y):
    mean_x = beckmann_interval(s_x / alpha_x, half_x / alpha_x)
    return mean_x * beckmann_interval(s_y / alpha_y, half_y / alpha_y) / (alpha_x * alpha_y)


def rectangle_inputs(lobe, rng, row):
    alpha = f32s(log_uniform(rng, 1e-4, 30), log_uniform(rng, 1e-4, 30))
    half = f32s(log_uniform(rng, 1e-5, 1e2), log_uniform(rng, 1e-5, 1e2))

    def around(half=half, alpha=alpha):
        """The lobe's center within a few sizes and widths."""
        spread = min(lobe.radius(rng) / 2, 30)
        return f32s(
            *[
                rng.uniform(-1.5, 1.5) * h + rng.uniform(-1, 1) * spread * a
                for h, a in zip(half, alpha)
            ]
        )

    large, tiny, sharp, flat = (1e2, 1e2), f32s(1e-5, 1e-5), f32s(1e-4, 1e-4), (30.0, 30.0)
    return by_kind(
        row,
        lambda: around() + half + alpha,
        lambda: slope_anywhere(rng) + half + alpha,
        [
            lambda: (0.0, 0.0) + half + alpha,
            lambda: half + half + alpha,
            lambda: (half[0], f32(half[1] * rng.uniform(-1, 1))) + half + alpha,
            lambda: around((0, half[1])) + (0.0, half[1]) + alpha,
            lambda: around((half[0], 0)) + (half[0], 0.0) + alpha,
            lambda: around((0, 0)) + (0.0, 0.0) + alpha,
            lambda: around(large, sharp) + large + sharp,
            lambda: around(tiny, flat) + tiny + flat,
            lambda: around(tiny, sharp) + tiny + sharp,
            lambda: around((1e-5, 1e2)) + f32s(1e-5, 1e2) + alpha,
        ],
    )


# -------------------------------------------------------------------------------------------------
# Mean over a parallelogram


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1]


def along(p, s, u, t=0, v=(0, 0)):
    """p + s u + t v"""
    return p[0] + s * u[0] + t * v[0], p[1] + s * u[1] + t * v[1]


def whiten(point, xx, xy, yy):
    """L^-1 point, A = L L^T"""
    l_xx = mp.sqrt(xx)
    l_yx = xy / l_xx
    x = point[0] / l_xx
    return x, (point[1] - l_yx * x) / mp.sqrt(yy - l_yx * l_yx)


def edge_mass(start, end):
    """Lambert's formula for one edge: the mass between it and the origin, with sign."""
    difference = (end[0] - start[0], end[1] - start[1])
    length = mp.sqrt(dot(difference, difference))
    distance = cross(start, difference) / length
    q = 1 + distance**2
    t = dot(start, difference) / length
    return distance / mp.sqrt(q) * mp.atan2(length * mp.sqrt(q), q + t * (t + length)) / (2 * mp.pi)


def polygon_mean(p, u, v):
    """Mean of the unit GGX lobe over p +- u/2 +- v/2."""
    half = mpf(1) / 2
    corners = [along(p, s * half, u, t * half, v) for s, t in [(-1, -1), (1, -1), (1, 1), (-1, 1)]]
    return sum(edge_mass(corners[k - 1], corners[k]) for k in range(4)) / cross(u, v)


def zero_area_mean(p, u, v):
    """The limit of `polygon_mean` as v turns into u: uniform a u + b v, which along the line is a
    trapezoid."""
    longer = u if dot(u, u) >= dot(v, v) else v
    length = mp.sqrt(dot(longer, longer))
    if not length:
        return 1 / (mp.pi * (1 + dot(p, p)) ** 2)
    t, q = dot(p, longer) / length, 1 + (cross(p, longer) / length) ** 2
    h, k = abs(dot(u, longer)) / length / 2, abs(dot(v, longer)) / length / 2
    if not h or not k:
        return ggx_segment(t, h + k, q)
    ends = [(t + h + k, 1), (t + h - k, -1), (t - h + k, -1), (t - h - k, 1)]
    return sum(sign * ggx_line_twice(end, q) for end, sign in ends) / (4 * h * k)


def ggx_parallelogram(s_x, s_y, u_x, u_y, v_x, v_y, *a):
    p, u, v = [whiten(x, *a) for x in [(s_x, s_y), (u_x, u_y), (v_x, v_y)]]
    # Products of f32 are exact at this precision: the raw vectors tell a true zero from a small
    # area.
    mean = polygon_mean if cross((u_x, u_y), (v_x, v_y)) else zero_area_mean
    return mean(p, u, v) / mp.sqrt(a[0] * a[2] - a[1] ** 2)


def whitened_sides(rng):
    """Plain, thin or sheared, by whitened proportions (aspect to 1e7)."""
    kind, u = rng.randrange(4), circle(rng, log_uniform(rng, 1e-4, 1e6))
    size = math.hypot(*u)
    if kind == 0:
        return u, circle(rng, size * log_uniform(rng, 0.1, 1))
    if kind == 1:
        return u, circle(rng, size * log_uniform(rng, 1e-7, 0.1))
    # Sheared: v nearly a multiple of u.
    thickness, multiple = signed(rng, 1e-6, 0.1), signed(rng, 1e-2, 1)
    return u, along((0, 0), multiple, u, thickness, (-u[1], u[0]))


def sides(rng):
    """A footprint with its roughness. The longer side keeps within 1e-5..1e2."""
    while True:
        a = roughness(rng)
        if rng.random() < 0.25:
            u, v = [f32s(*circle(rng, log_uniform(rng, 1e-5, 1e2))) for _ in range(2)]
        else:
            u, v = [f32s(*unwhiten(x, a)) for x in whitened_sides(rng)]
        if 1e-5 <= max(math.hypot(*u), math.hypot(*v)) <= 1e2:
            return (u, v, a) if rng.random() < 0.5 else (v, u, a)


def dyadic(rng):
    """A vector of small integers times a power of two: halves, sums and eighths of it are exact in
    f32."""
    scale = 2.0 ** rng.randrange(-20, -4)
    x, y = rng.randrange(1, 2048), rng.randrange(-2047, 2048)
    return scale * x, scale * y


def pair(rng):
    """Two such vectors on one scale, not parallel."""
    u, turn = dyadic(rng), rng.choice([-1, 1])
    return u, (-turn * u[1] / 4 + u[0] / 8, turn * u[0] / 4 + u[1] / 8)


def special_parallelogram(rng, which):
    u, v, a = sides(rng)
    d, e = pair(rng)
    n, zero = rng.randrange(-7, 8) / 8, (0.0, 0.0)
    point = near(rng, Ggx, (0, 0), a)
    multiple = rng.choice([-2, -1, -0.5, 0.25, 1, 4])
    parallel = (multiple * d[0], multiple * d[1])
    big, sharp = (f32s(*circle(rng, 1e2)), f32s(*circle(rng, 1e2))), covariance(1e-4, 1e-4, 0)
    p, u, v, a = [
        lambda: (zero, u, v, a),
        lambda: (along(zero, 0.5, d, 0.5, e), d, e, a),  # the lobe's center on a corner,
        lambda: (along(zero, 0.5, d, n / 2, e), d, e, a),  # on an edge
        lambda: (along(zero, 0.5, d, n, e), d, e, a),  # and on an edge's line
        lambda: (point, d, parallel, a),  # no area
        lambda: (f32s(*along(point, n, d, n, parallel)), d, parallel, a),
        lambda: (along(zero, n, d), d, parallel, a),
        lambda: (point, zero, v, a),
        lambda: (f32s(*along(point, n, u)), u, zero, a),
        lambda: (point, zero, zero, a),
        lambda: (point, u, f32s(*along(zero, multiple, u)), a),  # all but no area
        lambda: (point, u, f32s(*along(zero, rng.uniform(-1, 1), u)), a),
        lambda: (f32s(*along(zero, n / 2, big[0], n / 2, big[1])), *big, sharp),
        lambda: (point, f32s(*circle(rng, 1e-5)), f32s(*circle(rng, 1e-5)), a),
    ][which % 14]()
    return f32s(*p, *u, *v) + a


def parallelogram_inputs(rng, row):
    """A few lobe widths and polygon sizes away (specials included: 70 %), many, or anywhere."""
    kind = row % 10
    if kind == 9:
        return special_parallelogram(rng, row // 10)
    u, v, a = sides(rng)
    lengths, reach = (1, 3) if kind < 6 else (log_uniform(rng, 1, 1e3), log_uniform(rng, 3, 1e5))
    x, y = unwhiten(circle(rng, rng.uniform(0, reach)), a)
    slope = along((x, y), lengths * rng.uniform(-1, 1), u, lengths * rng.uniform(-1, 1), v)
    if kind == 8 or max(map(abs, slope)) > 1e3:
        return slope_anywhere(rng) + u + v + a
    return f32s(*slope) + u + v + a


# -------------------------------------------------------------------------------------------------
# GGX convolved with a Gaussian


def mixture(s_x, s_y, k_xx, k_xy, k_yy, a_xx, a_xy, a_yy):
    """t -> e^-t P_beckmann(s; A/t + 2 K), with det(A + 2 t K) and the adjugate as polynomials in
    t."""
    det_a, det_k = a_xx * a_yy - a_xy**2, k_xx * k_yy - k_xy**2
    mixed = a_xx * k_yy + a_yy * k_xx - 2 * a_xy * k_xy
    of_a, of_k = quadratic(s_x, s_y, a_yy, -a_xy, a_xx), quadratic(s_x, s_y, k_yy, -k_xy, k_xx)

    def integrand(t):
        det = det_a + 2 * t * (mixed + 2 * t * det_k)
        return t * mp.exp(-t - t * (of_a + 2 * t * of_k) / det) / (mp.pi * mp.sqrt(det))

    return integrand, of_a / det_a


def ggx_gaussian(*inputs):
    """Trapezoid rule in ln t.

    The integrand is analytic for |arg t| < pi/2, so step h errs by exp(-pi^2/h), 1e-68 for 1/16. On
    the left it falls like t^2 below 1/(1 + q), on the right like e^-t. Every other node alone makes
    the rule of step 1/8, good to 1e-34: the check."""
    integrand, q = mixture(*inputs)
    low = mp.floor(-mp.log(1 + q)) - 75
    t, factor, sums = mp.exp(low), mp.exp(mpf(1) / 16), [mpf(0), mpf(0)]
    for node in range(16 * (6 - int(low))):
        sums[node % 2] += t * integrand(t)
        t *= factor
    fine, coarse = (sums[0] + sums[1]) / 16, sums[0] / 8
    if abs(fine - coarse) > mpf(10) ** -AGREE * fine:
        raise ArithmeticError(f"mixture integral not stable: {inputs}")
    return fine


def short(x):
    """Rounded to 12 bits, so that products of two are f32."""
    fraction, exponent = math.frexp(x)
    return math.ldexp(round(fraction * 4096), exponent - 12)


def rank_one(rng):
    x, y = short(signed(rng, 1e-5, 1e2)), short(signed(rng, 1e-5, 1e2))
    return (x * x, x * y, y * y)


def kernel(rng):
    x = log_uniform(rng, 1e-5, 1e2)
    k = None
    while k is None:
        y = min(x * log_uniform(rng, 0.1, 10), 1e2)
        k = covariance(x, y, correlation(rng) if rng.random() < 0.6 else 0)
    return k


def gaussian_inputs(rng, row):
    a, k = roughness(rng), kernel(rng)

    def around(k):
        x, y = near(rng, Ggx, (0, 0), a)
        size = rng.uniform(0, 4)
        return f32s(
            x + signed(rng, 0.1, 1) * size * math.sqrt(k[0]),
            y + signed(rng, 0.1, 1) * size * math.sqrt(k[2]),
        )

    axis, line = (short(log_uniform(rng, 1e-4, 1e2)) ** 2, 0.0, 0.0), rank_one(rng)
    none = (0.0, 0.0, 0.0)
    return by_kind(
        row,
        lambda: around(k) + k + a,
        lambda: slope_anywhere(rng) + (k if row % 10 < 8 else line) + a,
        [
            lambda: around(line) + line + a,
            lambda: (0.0, 0.0) + k + a,
            lambda: around(axis) + axis + a,
            lambda: around(none) + none + a,
            lambda: (0.0, 0.0) + line + a,
        ],
    )


# -------------------------------------------------------------------------------------------------
# Proxies: the alpha of a GGX that is as high at its center as the filtered one


def proxy_rectangle(alpha, width):
    """1/(pi alpha'^2) is the mean of GGX over the square of this width around its center."""
    if not width:
        return alpha
    diagonal = mp.sqrt(4 * alpha**2 + width**2)
    return mp.sqrt(width * diagonal / (4 * mp.atan(width / diagonal)))


def proxy_gaussian(alpha, sigma):
    """1/(pi alpha'^2) is GGX under N(0, sigma^2 I) at its center."""
    if not sigma or not alpha:
        return mp.sqrt(2) * sigma if sigma else alpha
    k = 2 * sigma**2
    x = alpha**2 / k
    return mp.sqrt(k / (1 - x * mp.exp(x) * mp.e1(x)))


def proxy_inputs(rng, row):
    """Sizes of 1e-4 to 1e4 alphas; ends of both ranges, equal ones, none, and mirrors."""
    alpha, ratio = f32(log_uniform(rng, 1e-4, 30)), log_uniform(rng, 1e-4, 1e4)
    if row % 10 < 9:
        return alpha, f32(alpha * ratio)
    size = f32(log_uniform(rng, 1e-8, 3e5))
    return [
        (alpha, 0.0),
        (alpha, alpha),
        f32s(1e-4, 1e-8),
        f32s(1e-4, 1),
        f32s(30, 3e-3),
        f32s(30, 3e5),
        (0.0, size),
        (alpha, f32(2 * alpha)),
        (0.0, 0.0),
    ][row // 10 % 9]


# -------------------------------------------------------------------------------------------------
# Jacobians


def jacobians(x, y):
    z, s = mp.sqrt(1 - x * x - y * y), mp.sqrt(x * x + y * y)
    to_slope = [-e / (z * z * s) for e in (x, -y * z, y, x * z)]
    to_disk = [e / s for e in (x * z, -y, y * z, x)]
    disk_to_slope = [-e / z**3 for e in (1 - y * y, x * y, x * y, 1 - x * x)]
    return to_slope + to_disk + disk_to_slope


def jacobian_inputs(rng, row):
    # Below h_z of about 1e-3 the f32 steps of h_x and h_y leave it no digit to aim at.
    while True:
        h = by_kind(
            row,
            lambda: from_z(rng, rng.uniform(0.05, 1))[:2],
            lambda: (
                circle(rng, log_uniform(rng, 1e-6, 1))
                if row % 2
                else from_z(rng, log_uniform(rng, 1e-3, 1))[:2]
            ),
            [
                lambda: circle(rng, 1e-6),
                lambda: from_z(rng, log_uniform(rng, 1e-3, 1e-2))[:2],
                lambda: (log_uniform(rng, 1e-6, 0.999), 0.0),
                lambda: (0.0, -log_uniform(rng, 1e-6, 0.999)),
                lambda: from_z(rng, 1e-3)[:2],
            ],
        )
        h = f32s(*h)
        if 2.5e-7 < 1 - h[0] ** 2 - h[1] ** 2 and h != (0.0, 0.0):
            return h


def half_slope(e_x, e_y, e_z, l_x, l_y, l_z, b_11, b_12, b_22):
    eye, light, b = (e_x, e_y, e_z), (l_x, l_y, l_z), ((b_11, b_12), (b_12, b_22))
    ends = []
    for point in (eye, light):
        distance = mp.sqrt(sum(x * x for x in point))
        ends.append((distance, [x / distance for x in point]))
    g = [x + y for x, y in zip(ends[0][1], ends[1][1])]
    p = g[0] / g[2], g[1] / g[2]
    columns = []
    for axis in (0, 1):
        # dg = -sum (I - w w^T) v / r for v a unit tangent vector, and dn = B v.
        dg = [-sum(((k == axis) - w[k] * w[axis]) / r for r, w in ends) for k in range(3)]
        dn = b[0][axis], b[1][axis]
        turn = dg[2] / g[2] + dot(p, dn)
        columns.append([dg[k] / g[2] - dn[k] - p[k] * turn for k in (0, 1)])
    return columns[0][0], columns[1][0], columns[0][1], columns[1][1]


def half_slope_inputs(rng, row):
    def point(low, high):
        w = from_z(rng, rng.uniform(0.02, 1)) if rng.random() < 0.8 else direction(rng)
        distance = log_uniform(rng, low, high)
        return f32s(*[distance * x for x in w])

    def grazing():
        return f32s(*[log_uniform(rng, 0.1, 1e3) * x for x in from_z(rng, 1e-3)])

    def curvature(low=1e-3, high=1e2):
        return f32s(signed(rng, low, high), signed(rng, low, high), signed(rng, low, high))

    flat, ball, eye = (0.0, 0.0, 0.0), f32(signed(rng, 1e-3, 1e2)), point(0.1, 1e2)
    return by_kind(
        row,
        lambda: point(0.1, 10) + point(0.1, 100) + curvature(1e-2, 10),
        lambda: point(1e-2, 1e6) + point(1e-2, 1e6) + curvature(),
        [
            lambda: point(1e6, 1.01e6) + point(1e6, 1.01e6) + curvature(),
            lambda: eye + point(1e6, 1.01e6) + flat,
            lambda: eye + eye + curvature(),
            lambda: eye + (-eye[0], -eye[1], eye[2]) + curvature(),
            lambda: point(1e-3, 1e-2) + point(1e-3, 1e-2) + flat,
            lambda: (0.0, 0.0, f32(log_uniform(rng, 0.1, 1e6)))
            + point(0.1, 1e6)
            + (ball, 0.0, ball),
            lambda: grazing() + point(0.1, 1e2) + curvature(1e-2, 1),
            lambda: grazing() + grazing() + curvature(1e-2, 1),
        ],
    )


def chermain(sigma_x, sigma_y, rho, sigma_o):
    zero = mpf(0)
    return [x / sigma_o for x in (sigma_x * mp.sqrt(1 - rho * rho), rho * sigma_x, zero, sigma_y)]


def chermain_inputs(rng, row):
    rho = 0.0 if row % 10 == 9 else f32(correlation(rng))
    return f32s(
        log_uniform(rng, 1e-4, 30), log_uniform(rng, 1e-4, 30), rho, log_uniform(rng, 1e-3, 10)
    )


# -------------------------------------------------------------------------------------------------
# The tables


class Table:
    """A quantity: its columns, how to draw the inputs of a row, and its formula."""

    def __init__(self, columns, draw, formula, outputs="expected", rows=ROWS, keep=None):
        self.inputs, self.outputs, self.rows = columns.split(), outputs.split(), rows
        self.draw, self.formula = draw, formula
        self.keep = keep or (lambda expected, row: True)

    def generate(self, stem):
        """All rows as (inputs, outputs). Seeded by the stem: no table depends on another.

        A special case that never meets `keep` is taken as it comes.
        """
        rng, result = random.Random(f"lobe {stem}"), []
        for row in range(self.rows):
            for _ in range(DRAWS):
                inputs = self.draw(rng, row)
                outputs = self.value(inputs)
                if self.keep(outputs[0], row):
                    break
            result.append((inputs, outputs))
        return result

    def value(self, inputs):
        return stable(self.formula, inputs)

    def csv(self, rows):
        lines = [",".join(self.inputs + self.outputs)]
        lines += [
            ",".join([repr(x) for x in inputs] + [show(x) for x in outputs])
            for inputs, outputs in rows
        ]
        return "\n".join(lines) + "\n"


class Integral(Table):
    """Checks its own convergence, so one evaluation is enough."""

    def value(self, inputs):
        with mp.workdps(DPS + 10):
            return [self.formula(*[mpf(x) for x in inputs])]


def matrix_entries(name):
    return " ".join(f"{name}_{k}" for k in ("11", "12", "21", "22"))


def lobe_tables(lobe):
    def bound(draw):
        return lambda rng, row: draw(lobe, rng, row)

    rectangle = {Beckmann: beckmann_rectangle, Ggx: ggx_rectangle}[lobe]
    tables = {
        "p22": Table(
            f"slope_x slope_y {MEAN} {MATRIX}", bound(p22_inputs), p22(lobe), keep=lobe.keep
        ),
        "d": Table(f"m_x m_y m_z {MATRIX}", bound(ndf_inputs), ndf(lobe), keep=lobe.keep),
        "projected_area": Table(
            f"w_x w_y w_z {MEAN} {MATRIX}", bound(area_inputs), area(lobe), keep=lobe.keep
        ),
        "lambda": Table(
            f"w_x w_y w_z {MATRIX}", bound(masking_inputs), masking(lobe), keep=lobe.keep
        ),
        "brdf": Table(
            f"wo_x wo_y wo_z wi_x wi_y wi_z {MEAN} {MATRIX}",
            bound(brdf_inputs),
            brdf(lobe),
            keep=lambda expected, row: lobe.keep(expected, row) and (expected > 0 or rare(row)),
        ),
        "rectangle_mean": Table(
            "slope_x slope_y half_x half_y alpha_x alpha_y",
            bound(rectangle_inputs),
            rectangle,
            keep=lobe.keep,
        ),
    }
    return {f"{lobe.name}_{stem}": table for stem, table in tables.items()}


TABLES = {
    **lobe_tables(Beckmann),
    **lobe_tables(Ggx),
    "ggx_parallelogram_mean": Table(
        f"slope_x slope_y u_x u_y v_x v_y {MATRIX}", parallelogram_inputs, ggx_parallelogram
    ),
    "ggx_gaussian_mean": Integral(
        f"slope_x slope_y k_xx k_xy k_yy {MATRIX}", gaussian_inputs, ggx_gaussian, rows=200
    ),
    "ggx_proxy_rectangle_alpha": Table("alpha width", proxy_inputs, proxy_rectangle, rows=300),
    "ggx_proxy_gaussian_alpha": Table("alpha sigma", proxy_inputs, proxy_gaussian, rows=300),
    "jacobians": Table(
        "h_x h_y",
        jacobian_inputs,
        jacobians,
        outputs=" ".join(
            matrix_entries(n)
            for n in ("sphere_to_slope", "sphere_to_projected", "projected_to_slope")
        ),
        rows=200,
    ),
    "half_slope_jacobian": Table(
        "e_x e_y e_z l_x l_y l_z b_11 b_12 b_22",
        half_slope_inputs,
        half_slope,
        outputs=matrix_entries("m"),
        rows=200,
    ),
    "chermain_m": Table(
        "sigma_x sigma_y rho sigma_o",
        chermain_inputs,
        chermain,
        outputs=matrix_entries("m"),
        rows=100,
    ),
}


# -------------------------------------------------------------------------------------------------
# Self-checks. The quadratures run in f64 (mpmath.fp) on densities written down again, in floats.


def density(lobe, x, y, a):
    """P22 of a centered lobe."""
    det = a[0] * a[2] - a[1] * a[1]
    q = quadratic(x, y, a[2], -a[1], a[0]) / det
    body = math.exp(-q) if lobe is Beckmann else 1 / (1 + q) ** 2
    return body / (math.pi * math.sqrt(det))


def moderate(xx, xy, yy, high=5):
    """Roughness of order 1: a fixed quadrature rule sees the whole lobe."""
    return 1 / high < min(xx, yy) and max(xx, yy) < high and xy * xy < 0.7 * xx * yy


def short_of(limit, *xs):
    return all(abs(x) < limit for x in xs)


def error(x, y):
    with mp.workdps(40):
        return float(abs(mpf(x) / mpf(y) - 1) if y else abs(mpf(x)))


def pick(rows, fits, count=4):
    return [row for row in rows if fits(*row[0])][:count]


def worst(errors):
    errors = list(errors)
    assert errors, "no row fits this check"
    return max(errors), len(errors)


def plane(f, split_x=0, split_y=0):
    return fp.quad(f, [-fp.inf, split_x, fp.inf], [-fp.inf, split_y, fp.inf])


def check_p22(lobe, tables):
    rows = pick(
        tables[f"{lobe.name}_p22"], lambda x, y, mx, my, *a: moderate(*a) and short_of(5, mx, my), 2
    )

    def mass(mean, a):
        # The table's formula itself, at f64.
        with mp.workdps(15):
            f = p22(lobe)
            return plane(lambda x, y: float(f(x, y, *mean, *a)), *mean)

    return worst(error(mass(row[2:4], row[4:]), 1) for row, _ in rows)


def smith(lobe, cosine, alpha):
    """Lambda of Walter et al. 2007 and Heitz 2014, isotropic, by the angle."""
    if cosine == 1:
        return mpf(0)
    nu = cosine / (alpha * mp.sqrt(1 - cosine**2))
    if lobe is Beckmann:
        return (mp.erf(nu) - 1) / 2 + mp.exp(-nu * nu) / (2 * nu * mp.sqrt(mp.pi))
    return (mp.sqrt(1 + 1 / nu**2) - 1) / 2


def textbook_d(lobe, cosine, alpha):
    """D of Walter et al. 2007, isotropic, by the angle."""
    tangent = mp.sqrt(1 - cosine**2) / cosine
    if lobe is Beckmann:
        return mp.exp(-((tangent / alpha) ** 2)) / (mp.pi * alpha**2 * cosine**4)
    return alpha**2 / (mp.pi * cosine**4 * (alpha**2 + tangent**2) ** 2)


def isotropic(a_xx, a_xy, a_yy):
    return a_xx == a_yy and a_xy == 0 and a_xx > 1e-2


def normalized(v):
    norm = mp.sqrt(sum(mpf(x) ** 2 for x in v))
    return [x / norm for x in v]


def check_d(lobe, tables):
    """Angles assume unit vectors, so both sides take the row's directions normalized."""

    def at(m, a):
        m = normalized(m)
        return error(ndf(lobe)(*m, *map(mpf, a)), textbook_d(lobe, m[2], mp.sqrt(a[0])))

    rows = pick(tables[f"{lobe.name}_d"], lambda x, y, z, *a: isotropic(*a) and z > 0.1, 20)
    return worst(at(row[:3], row[3:]) for row, _ in rows)


def check_brdf(lobe, tables):
    def centered(*row):
        return isotropic(*row[8:]) and row[6] == row[7] == 0 and min(row[2], row[5]) > 0.1

    def at(o, i, a):
        o, i, alpha = normalized(o), normalized(i), mp.sqrt(a[0])
        h = normalized([x + y for x, y in zip(o, i)])
        g2 = 1 / (1 + smith(lobe, o[2], alpha) + smith(lobe, i[2], alpha))
        textbook = textbook_d(lobe, h[2], alpha) * g2 / (4 * o[2] * i[2])
        return error(brdf(lobe)(*o, *i, 0, 0, *map(mpf, a)), textbook)

    rows = pick(tables[f"{lobe.name}_brdf"], centered, 20)
    return worst(at(row[:3], row[3:6], row[8:]) for row, _ in rows)


def back_faces(lobe, v):
    """Integral of (x - v) times the lobe's density along one whitened axis, over x > v.

    In units of the tail's own width and height, as mp.quad stops at an absolute error.
    """
    v = abs(v)
    if lobe is Beckmann:
        width = 1 / (1 + v)
        body = mp.quad(
            lambda y: y * mp.exp(-(width * y) * (2 * v + width * y)), [0, 1, 5, 20, mp.inf]
        )
        return mp.exp(-v * v) * width**2 * body / mp.sqrt(mp.pi)
    width = 1 + v
    return (
        mp.quad(
            lambda y: y / (2 * (width**-2 + (v / width + y) ** 2) ** mpf(1.5)), [0, 1, 10, mp.inf]
        )
        / width
    )


def sigma_by_parts(lobe, w, mean, a):
    """c + a times the back faces, or a times the front faces where c < 0; and c."""
    w, a = list(map(mpf, w)), list(map(mpf, a))
    c, stretch = w[2] - dot(mean, w), mp.sqrt(stretch_squared(w[0], w[1], a))
    return max(c, 0) + (stretch * back_faces(lobe, c / stretch) if stretch else 0), c


def check_area_axis(lobe, tables):
    rows = tables[f"{lobe.name}_projected_area"][::9]
    with mp.workdps(40):
        return worst(
            error(sigma_by_parts(lobe, r[:3], r[3:5], r[5:])[0], out[0]) for r, out in rows
        )


def check_lambda_axis(lobe, tables):
    def shadowed(row):
        stretch = mp.sqrt(stretch_squared(*map(mpf, row[:2]), row[3:]))
        return stretch / row[2] * back_faces(lobe, row[2] / stretch) if stretch else 0

    rows = tables[f"{lobe.name}_lambda"][::9]
    with mp.workdps(40):
        return worst(error(shadowed(row), out[0]) for row, out in rows)


def check_brdf_parts(lobe, tables):
    """D G2 / (4 c_o c_i) with G2 = 1/(1 + Lambda_o + Lambda_i), Lambda by quadrature, D by whitened
    slopes."""

    def product(row):
        o, i, mean, a = list(map(mpf, row[:3])), list(map(mpf, row[3:6])), row[6:8], row[8:]
        (sigma_o, c_o), (sigma_i, c_i) = sigma_by_parts(lobe, o, mean, a), sigma_by_parts(
            lobe, i, mean, a
        )
        h = normalized([x + y for x, y in zip(o, i)])
        w = whiten((-h[0] / h[2] - mean[0], -h[1] / h[2] - mean[1]), *map(mpf, a))
        d = lobe.slope_pdf(dot(w, w), mp.sqrt(mpf(a[0]) * a[2] - mpf(a[1]) ** 2)) / h[2] ** 4
        return d / (sigma_o / c_o + sigma_i / c_i - 1) / (4 * c_o * c_i)

    rows = [row for row in tables[f"{lobe.name}_brdf"][::19] if row[1][0]]
    with mp.workdps(40):
        return worst(error(product(row), out[0]) for row, out in rows)


def check_reciprocity(lobe, tables):
    def swapped(row):
        return stable(brdf(lobe), row[3:6] + row[:3] + row[6:])[0]

    return worst(error(swapped(row), out[0]) for row, out in tables[f"{lobe.name}_brdf"][::19])


def projected(lobe, w, mean, a, sign):
    """Integral of max(0, sign w.(-s, 1)) P22(s) over s = x u + y v, u along w_xy: the kink is a
    line of constant x."""
    length = math.hypot(w[0], w[1])
    u = w[0] / length, w[1] / length
    kink, center = w[2] / length, (dot(u, mean), cross(u, mean))

    def integrand(x, tau):
        # In the tail of GGX the integrand widens with x: y in units of that width.
        width = math.hypot(1, x - center[0])
        y = center[1] + width * tau
        s = x * u[0] - y * u[1] - mean[0], x * u[1] + y * u[0] - mean[1]
        return width * abs(w[2] - length * x) * density(lobe, *s, a)

    limits = [-fp.inf, kink] if sign > 0 else [kink, fp.inf]
    return fp.quad(integrand, limits, [-fp.inf, 0, fp.inf])


def check_area(lobe, tables):
    def fits(w_x, w_y, w_z, mean_x, mean_y, *a):
        return moderate(*a) and short_of(2, mean_x, mean_y) and math.hypot(w_x, w_y) > 0.3

    rows = pick(tables[f"{lobe.name}_projected_area"], fits)
    return worst(error(projected(lobe, row[:3], row[3:5], row[5:], 1), out[0]) for row, out in rows)


def check_lambda(lobe, tables):
    """Lambda c is the projected area of the back faces."""
    rows = pick(tables[f"{lobe.name}_lambda"], lambda x, y, z, *a: moderate(*a) and 0.02 < z < 0.9)
    return worst(
        error(projected(lobe, row[:3], (0, 0), row[3:], -1) / row[2], out[0]) for row, out in rows
    )


def box_mean(lobe, s, u, v, a):
    """P22 averaged over s + x u + y v, x and y within +-1/2."""
    half = [-0.5, 0, 0.5]
    return fp.quad(lambda x, y: density(lobe, *along(s, x, u, y, v), a), half, half)


def check_rectangle(lobe, tables):
    def fits(s_x, s_y, h_x, h_y, a_x, a_y):
        return (
            moderate(a_x**2, 0, a_y**2, high=50)
            and short_of(3, h_x, h_y)
            and short_of(10, s_x, s_y)
        )

    rows = pick(tables[f"{lobe.name}_rectangle_mean"], fits, 6)
    means = [
        box_mean(lobe, r[:2], (2 * r[2], 0), (0, 2 * r[3]), (r[4] ** 2, 0, r[5] ** 2))
        for r, _ in rows
    ]
    return worst(error(mean, out[0]) for mean, (_, out) in zip(means, rows))


def check_rectangle_exact(lobe, tables):
    """By another way: GGX (all rows) as a parallelogram, Beckmann by quadrature along each axis."""

    def tail(start, end):
        """Integral of exp(-y^2), 0 <= start < end, in units of its height and width at the
        start."""
        width = 1 / (1 + start)
        points = [k * width for k in (0, 1, 5, 20) if k * width < end - start] + [end - start]
        return mp.exp(-start * start) * mp.quad(lambda y: mp.exp(-y * (2 * start + y)), points)

    def interval(x, half):
        low, high = abs(x) - half, abs(x) + half
        if not half:
            return mp.exp(-x * x)
        return (tail(low, high) if low >= 0 else tail(0, high) + tail(0, -low)) / (2 * half)

    def other(s_x, s_y, h_x, h_y, a_x, a_y):
        if lobe is Ggx:
            return stable(
                ggx_parallelogram,
                (s_x, s_y, 2 * h_x, 0, 0, 2 * h_y, mpf(a_x) ** 2, 0, mpf(a_y) ** 2),
            )[0]
        means = [interval(mpf(s) / a, mpf(h) / a) for s, h, a in ((s_x, h_x, a_x), (s_y, h_y, a_y))]
        return means[0] * means[1] / (mp.pi * a_x * a_y)

    rows = tables[f"{lobe.name}_rectangle_mean"][:: 1 if lobe is Ggx else 7]
    with mp.workdps(40):
        return worst(error(other(*row), out[0]) for row, out in rows)


def check_parallelogram(_, tables):
    def small(row):
        return moderate(*row[6:], high=50) and short_of(3, *row[2:6]) and short_of(10, *row[:2])

    rows = tables["ggx_parallelogram_mean"]
    with_area = pick(rows, lambda *row: small(row) and cross(row[2:4], row[4:6]) != 0, 6)
    without = pick(rows, lambda *row: small(row) and cross(row[2:4], row[4:6]) == 0, 6)
    return worst(
        error(box_mean(Ggx, r[:2], r[2:4], r[4:6], r[6:]), out[0]) for r, out in with_area + without
    )


def check_parallelogram_lines(_, tables):
    """Rows of every shape: exact means along the longer side, quadrature across."""

    def mean(row):
        a = list(map(mpf, row[6:]))
        p, u, v = [whiten((mpf(row[k]), mpf(row[k + 1])), *a) for k in (0, 2, 4)]
        if dot(u, u) < dot(v, v):
            u, v = v, u
        length = mp.sqrt(dot(u, u))
        e = u[0] / length, u[1] / length

        def line(y):
            x = along(p, y, v)
            return ggx_segment(dot(x, e), length / 2, 1 + cross(x, e) ** 2)

        # The integrand bends where a line passes the center or an end comes close to it, over a
        # whitened length of 1.
        half = mpf(1) / 2
        ends = [along(p, s, u) for s in (-half, half)]
        places = [-dot(x, v) / dot(v, v) for x in ends] + [-cross(p, e) / (cross(v, e) or 1)]
        widths = [1 / mp.sqrt(dot(v, v))] * 2 + [1 / (abs(cross(v, e)) or 1)]
        steps = (-100, -10, -3, -1, 0, 1, 3, 10, 100)
        cuts = sorted(
            x + k * w for x, w in zip(places, widths) for k in steps if abs(x + k * w) < half
        )
        return mp.quad(line, [-half, *cuts, half]) / mp.sqrt(a[0] * a[2] - a[1] ** 2)

    rows = [row for row in tables["ggx_parallelogram_mean"][::7] if cross(row[0][2:4], row[0][4:6])]
    with mp.workdps(40):
        return worst(error(mean(row), out[0]) for row, out in rows)


def check_zero_area(_, tables):
    """The closed form along a line is the limit of the polygon: v turned by 1e-15."""
    rows = pick(tables["ggx_parallelogram_mean"], lambda *row: cross(row[2:4], row[4:6]) == 0, 60)

    def turned(row):
        s, u, v = row[:2], list(row[2:4]), list(row[4:6])
        eps = mpf(10) ** -15
        scale = max(map(abs, u + v)) or mpf(row[6]) ** 0.5 * eps
        u = u if any(u) else [eps * scale, 0] if abs(v[1]) >= abs(v[0]) else [0, eps * scale]
        v = [v[0] - eps * u[1], v[1] + eps * u[0]] if any(v) else [-eps * u[1], eps * u[0]]
        return (*s, *u, *v, *row[6:])

    return worst(error(stable(ggx_parallelogram, turned(row))[0], out[0]) for row, out in rows)


def check_gaussian(_, tables):
    """Average of P22(s - y) over the Gaussian y = R z, R R^T = K, for regular K."""

    def fits(s_x, s_y, k_xx, k_xy, k_yy, *a):
        return (
            moderate(*a, high=20)
            and short_of(20, s_x, s_y)
            and k_xx * k_yy > k_xy * k_xy
            and max(k_xx, k_yy) < 2
        )

    def convolution(s_x, s_y, k_xx, k_xy, k_yy, *a):
        r_xx, r_yx, r_yy = cholesky(k_xx, k_xy, k_yy)

        def integrand(x, y):
            weight = math.exp(-(x * x + y * y) / 2) / TAU
            return weight * density(Ggx, s_x - r_xx * x, s_y - r_yx * x - r_yy * y, a)

        span = [-9, -4, 0, 4, 9]
        return fp.quad(integrand, span, span)

    return worst(
        error(convolution(*row), out[0]) for row, out in pick(tables["ggx_gaussian_mean"], fits, 6)
    )


def check_gaussian_line(_, tables):
    """All rows of singular K = d d^T: the Gaussian runs along the line s - z d."""

    def convolution(row):
        s, a = row[:2], row[5:]
        d = (mp.sqrt(row[2]), row[3] / mp.sqrt(row[2]) if row[2] else mp.sqrt(row[4]))
        p, e = whiten(s, *a), whiten(d, *a)
        norm = mp.sqrt(dot(e, e)) or mpf(1)
        closest, width = dot(p, e) / norm**2, mp.sqrt(1 + (cross(p, e) / norm) ** 2) / norm
        if not any(d):
            return p22(Ggx)(*s, 0, 0, *a)

        def integrand(z):
            x = along(p, -z, e)
            return mp.npdf(z) * Ggx.slope_pdf(dot(x, x), mp.sqrt(a[0] * a[2] - a[1] ** 2))

        cuts = [closest + sign * width * k for k in (0, 1, 4, 20, 100, 1e4) for sign in (-1, 1)]
        return mp.quad(
            integrand,
            sorted({mpf(x) for x in [-20, -8, 0, 8, 20] + [x for x in cuts if abs(x) < 20]}),
        )

    rows = pick(tables["ggx_gaussian_mean"], lambda *row: row[2] * row[4] == row[3] ** 2, 200)
    with mp.workdps(40):
        return worst(error(convolution(list(map(mpf, row))), out[0]) for row, out in rows)


def check_mixture(_, tables):
    def adaptive(row, expected):
        with mp.workdps(25):
            integrand, q = mixture(*[mpf(x) for x in row])
            ends = sorted(
                [
                    0,
                    *[k / (1 + q) for k in (1, 10, 100)],
                    *[mpf(10) ** k for k in (-3, -2, -1, 0, 1, 2)],
                ]
            )
            # In units of the result, as mp.quad stops at an absolute error.
            return mp.quad(lambda t: integrand(t) / expected, ends)

    return worst(error(adaptive(row, out[0]), 1) for row, out in tables["ggx_gaussian_mean"][::9])


def check_peak(_, tables):
    """At the center, lobe and kernel isotropic: (1 - x e^x E1(x)) / (pi k), k = 2 sigma^2, x =
    alpha^2/k."""

    def peak(a, k):
        x = mpf(a) / k
        return (1 - x * mp.exp(x) * mp.e1(x)) / (mp.pi * k)

    cases = [(1.0, 0.5), (0.25, 8.0), (16.0, 0.125), (2.0**-20, 4.0)]
    return worst(
        error(ggx_gaussian(*map(mpf, (0, 0, k / 2, 0, k / 2, a, 0, a))), peak(a, k))
        for a, k in cases
    )


def proxy_peaks(tables, stem, mean, step):
    """The peak of every `step`-th proxy that is no mirror, against `mean` of the same row."""
    rows = [(list(map(mpf, row)), out[0]) for row, out in tables[stem][::step] if row[0]]
    with mp.workdps(40):
        return worst(error(mean(*row), 1 / (mp.pi * alpha**2)) for row, alpha in rows)


def check_proxy_rectangle(_, tables):
    def mean(alpha, width):
        # Doubles its precision until small squares, whose terms cancel, agree.
        return stable(ggx_rectangle, (0, 0, width / 2, width / 2, alpha, alpha))[0]

    return proxy_peaks(tables, "ggx_proxy_rectangle_alpha", mean, 1)


def check_proxy_lines(_, tables):
    """Exact along one side of the square, quadrature across."""

    def mean(alpha, width):
        half = width / (2 * alpha)
        if not half:
            return 1 / (mp.pi * alpha**2)
        cuts = [mpf(10) ** k for k in range(-1, 4) if mpf(10) ** k < half]
        line = mp.quad(lambda y: ggx_segment(0, half, 1 + y * y) * half, [0, *cuts, half])
        return line / (half * alpha) ** 2

    return proxy_peaks(tables, "ggx_proxy_rectangle_alpha", mean, 3)


def check_proxy_mixture(_, tables):
    def mean(alpha, sigma):
        return ggx_gaussian(0, 0, sigma**2, 0, sigma**2, alpha**2, 0, alpha**2)

    return proxy_peaks(tables, "ggx_proxy_gaussian_alpha", mean, 5)


def check_proxy_radius(_, tables):
    """Over u = r^2/(2 sigma^2), which the Gaussian weighs with e^-u."""

    def mean(alpha, sigma):
        ratio = 2 * (sigma / alpha) ** 2
        width = 1 / (1 + ratio)
        cuts = sorted({*[width * mpf(10) ** k for k in range(-2, 10)], mpf(1), mpf(5), mpf(20)})
        body = mp.quad(
            lambda u: mp.exp(-u) / (1 + ratio * u) ** 2 / width,
            [0, *[x for x in cuts if x < 90], 90],
        )
        return body * width / (mp.pi * alpha**2)

    return proxy_peaks(tables, "ggx_proxy_gaussian_alpha", mean, 3)


def matrix_error(numeric, exact):
    return float(max(abs(x - y) for x, y in zip(numeric, exact)) / max(abs(y) for y in exact))


def jacobians_numeric(x, y):
    """Derivatives of the maps themselves, the sphere by exponential map along its two frame
    vectors."""
    z, s = mp.sqrt(1 - x * x - y * y), mp.sqrt(x * x + y * y)
    frame = [(x * z / s, y * z / s, -s), (-y / s, x / s, mpf(0))]

    def on_sphere(axis, k):
        return lambda e: mp.cos(e) * (x, y, z)[k] + mp.sin(e) * frame[axis][k]

    def slope_on_sphere(axis, k):
        return lambda e: -on_sphere(axis, k)(e) / on_sphere(axis, 2)(e)

    def slope_on_disk(axis, k):
        def slope(e):
            p = (x + e, y) if axis == 0 else (x, y + e)
            return -p[k] / mp.sqrt(1 - dot(p, p))

        return slope

    maps = (slope_on_sphere, on_sphere, slope_on_disk)
    return [mp.diff(f(axis, k), 0) for f in maps for k in (0, 1) for axis in (0, 1)]


def half_slope_numeric(e_x, e_y, e_z, l_x, l_y, l_z, b_11, b_12, b_22):
    """The plane point of h over the surface z = -v.(B v)/2, in its frame: normal n(v) and tangents
    k - (B v)_k n."""

    def plane_point(axis, k):
        def coordinate(e):
            v = (e, mpf(0)) if axis == 0 else (mpf(0), e)
            dn = b_11 * v[0] + b_12 * v[1], b_12 * v[0] + b_22 * v[1]
            x = (*v, -dot(v, dn) / 2)
            g = [mpf(0)] * 3
            for end in ((e_x, e_y, e_z), (l_x, l_y, l_z)):
                d = [p - q for p, q in zip(end, x)]
                norm = mp.sqrt(sum(q * q for q in d))
                g = [p + q / norm for p, q in zip(g, d)]
            normal = normalized([dn[0], dn[1], mpf(1)])
            tangent = [mpf(j == k) - dn[k] * mpf(j == 2) for j in range(3)]
            return sum(p * q for p, q in zip(g, tangent)) / sum(p * q for p, q in zip(g, normal))

        return coordinate

    return [mp.diff(plane_point(axis, k), 0) for k in (0, 1) for axis in (0, 1)]


def check_numeric(stem, numeric):
    def check(_, tables):
        return worst(matrix_error(numeric(*map(mpf, row)), out) for row, out in tables[stem])

    return check


def check_chermain(_, tables):
    def residual(row, m):
        s_x, s_y, rho, s_o = map(mpf, row)
        product = [m[0] ** 2 + m[1] ** 2, m[0] * m[2] + m[1] * m[3], m[2] ** 2 + m[3] ** 2]
        return matrix_error([s_o**2 * x for x in product], [s_x**2, rho * s_x * s_y, s_y**2])

    return worst(residual(row, out) for row, out in tables["chermain_m"])


# Name, check, lobes, the error it must stay below: what its quadrature is good for.
BOTH, GGX = (Beckmann, Ggx), (Ggx,)
CHECKS = [
    ("P22 integrates to 1", check_p22, BOTH, 1e-9),
    ("D against angles", check_d, BOTH, 1e-15),
    ("projected area against quadrature", check_area, BOTH, 1e-8),
    ("projected area along an axis", check_area_axis, BOTH, 1e-15),
    ("Lambda against quadrature", check_lambda, BOTH, 1e-9),
    ("Lambda along an axis", check_lambda_axis, BOTH, 1e-15),
    ("BRDF against angles", check_brdf, BOTH, 1e-15),
    ("BRDF by its factors", check_brdf_parts, BOTH, 1e-15),
    ("BRDF reciprocal", check_reciprocity, BOTH, 1e-15),
    ("rectangle against quadrature", check_rectangle, BOTH, 1e-9),
    ("rectangle by another formula", check_rectangle_exact, BOTH, 1e-15),
    ("parallelogram against quadrature", check_parallelogram, GGX, 1e-9),
    ("parallelogram line by line", check_parallelogram_lines, GGX, 1e-12),
    ("zero area against thin polygons", check_zero_area, GGX, 1e-9),
    ("Gaussian mean against convolution", check_gaussian, GGX, 1e-9),
    ("Gaussian mean along a line", check_gaussian_line, GGX, 1e-12),
    ("Gaussian mean against adaptive rule", check_mixture, GGX, 1e-15),
    ("Gaussian peak against E1", check_peak, GGX, 1e-15),
    ("square's proxy against the rectangle", check_proxy_rectangle, GGX, 1e-15),
    ("square's proxy line by line", check_proxy_lines, GGX, 1e-15),
    ("Gaussian's proxy against the mixture", check_proxy_mixture, GGX, 1e-15),
    ("Gaussian's proxy over the radius", check_proxy_radius, GGX, 1e-15),
    ("Jacobians against derivatives", check_numeric("jacobians", jacobians_numeric), GGX, 1e-15),
    (
        "half-slope Jacobian against derivatives",
        check_numeric("half_slope_jacobian", half_slope_numeric),
        GGX,
        1e-15,
    ),
    ("Chermain's M against the covariance", check_chermain, GGX, 1e-15),
]


def self_check(tables):
    failures = 0
    for name, check, lobes, budget in CHECKS:
        for lobe in lobes:
            start = time.perf_counter()
            with mp.workdps(DPS):
                found, count = check(lobe, tables)
            failures += found > budget
            title = f"{name}, {lobe.name}" if len(lobes) > 1 else name
            seconds, verdict = time.perf_counter() - start, "FAIL" if found > budget else "ok"
            print(
                f"{verdict:4} {title:50} {count:4} rows  "
                f"{found:.1e} <= {budget:.0e}  {seconds:5.1f} s"
            )
    return failures


def main():
    parser = argparse.ArgumentParser(description="Write the golden tables.")
    parser.add_argument(
        "--out", type=Path, default=Path(__file__).parent, help="folder of the tables"
    )
    parser.add_argument(
        "--check", action="store_true", help="compare with the files there instead of writing"
    )
    arguments = parser.parse_args()
    tables, failures = {}, 0
    for stem, table in TABLES.items():
        start = time.perf_counter()
        tables[stem] = table.generate(stem)
        print(f"     {stem:50} {len(tables[stem]):4} rows  {time.perf_counter() - start:.1f} s")
        path, text = arguments.out / f"{stem}.csv", table.csv(tables[stem]).encode()
        if not arguments.check:
            arguments.out.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text)
        elif not path.exists() or path.read_bytes() != text:
            failures += 1
            print(f"FAIL {path} differs")
    failures += self_check(tables)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
