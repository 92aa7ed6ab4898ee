#!/usr/bin/env python3
"""Fits the polynomials of src/scalar/{exp,ln,atan,erfc,quantile}.rs and of
src/filter/polygon/lanes.rs and the factors of src/filter/proxy.rs, and prints them.

Usage: python3 fit.py [name ...]      (all fits when no name is given)

Needs mpmath only. Each fit is a weighted Remez exchange on a fine Chebyshev
grid; the coefficients are then rounded to the target format one by one, from
the highest degree down, and the free ones are fitted again after each rounding.
The printed error is that of the rounded polynomial in exact arithmetic.
"""

import math
import sys

from mpmath import mp, mpf

mp.dps = 50

SINGLE, DOUBLE = 24, 53  # significand bits of f32 and f64


# --- references ------------------------------------------------------------


def series(x, start):
    """1 - (start) q + (start)(start+2) q^2 - ..., q = 1/(2 x^2): asymptotic, for x >= 60."""
    q = 1 / (2 * x * x)
    total, term, k = mpf(1), mpf(1), start
    while abs(term) > mp.eps:
        term *= -k * q
        total += term
        k += 2
    return total


def erfcx(x):
    """exp(x^2) erfc(x), x >= 0."""
    x = mpf(x)
    if x >= 60:
        return series(x, 1) / (x * mp.sqrt(mp.pi))
    with mp.extradps(10):
        return mp.exp(x * x) * mp.erfc(x)


def ierfcx(x):
    """1/sqrt(pi) - x erfcx(x), x >= 0, without cancellation."""
    x = mpf(x)
    if x >= 60:
        return series(x, 3) / (2 * x * x * mp.sqrt(mp.pi))
    with mp.extradps(15):
        return 1 / mp.sqrt(mp.pi) - x * erfcx(x)


# --- weighted minimax ------------------------------------------------------


def rounded(c, bits):
    with mp.workprec(bits):
        return +c


def horner(coefs, v):
    total = mpf(0)
    for c in reversed(coefs):
        total = total * v + c
    return total


def alternation(errors, need):
    """Indices of `need` extrema of alternating sign, the largest of them included."""
    peaks = []
    for j, e in enumerate(errors):
        if peaks and (e > 0) == (errors[peaks[-1]] > 0):
            if abs(e) > abs(errors[peaks[-1]]):
                peaks[-1] = j
        else:
            peaks.append(j)
    while len(peaks) > need:
        size = [abs(errors[j]) for j in peaks]
        if len(peaks) == need + 1:
            peaks.pop(0 if size[0] < size[-1] else -1)
        else:
            pair = min(range(len(peaks) - 1), key=lambda i: size[i] + size[i + 1])
            del peaks[pair : pair + 2]
    return peaks


class Fit:
    """Minimizes max |weight (f - p)| over [lo, hi], p a polynomial of the given degree."""

    def __init__(self, f, weight, lo, hi, degree):
        self.degree = degree
        count = 40 * (degree + 2)
        mid, half = (mpf(hi) + lo) / 2, (mpf(hi) - lo) / 2
        # An even count keeps the midpoint, where a weight may vanish, off the grid.
        self.v = [mid - half * mp.cos(mp.pi * i / (count - 1)) for i in range(count)]
        self.f = [f(v) for v in self.v]
        self.w = [weight(v) for v in self.v]

    def errors(self, coefs):
        return [w * (f - horner(coefs, v)) for v, f, w in zip(self.v, self.f, self.w)]

    def remez(self, fixed=()):
        """The best coefficients, the highest of them being `fixed`."""
        free = self.degree + 1 - len(fixed)
        base = [mpf(0)] * free + list(fixed)
        need = free + 1
        last = len(self.v) - 1
        rest = self.errors(base)
        points = [(2 * i + 1) * last // (2 * need) for i in range(need)]
        best, kept = mp.inf, base
        for _ in range(15):
            rows = mp.matrix(need, need)
            right = mp.matrix(need, 1)
            for i, j in enumerate(points):
                for k in range(free):
                    rows[i, k] = self.w[j] * self.v[j] ** k
                rows[i, free] = (-1) ** i
                right[i] = rest[j]
            solution = mp.lu_solve(rows, right)
            coefs = [solution[k] for k in range(free)] + list(fixed)
            level = abs(solution[free])
            errors = self.errors(coefs)
            worst = max(abs(e) for e in errors)
            if worst < best:
                best, kept = worst, coefs
            points = alternation(errors, need)
            if len(points) < need or best <= level * mpf("1.01"):
                break
        return kept

    def run(self, bits):
        """Rounded coefficients, their largest error and the abscissa where it is attained."""
        fixed = []
        for k in range(self.degree, -1, -1):
            fixed.insert(0, rounded(self.remez(fixed)[k], bits))
        errors = [abs(e) for e in self.errors(fixed)]
        worst = max(errors)
        return fixed, worst, self.v[errors.index(worst)]


# --- printing --------------------------------------------------------------


def literal(c, bits):
    """The shortest decimal that reads back as c, digits grouped as clippy likes them."""
    for digits in range(1, 18):
        text = mp.nstr(c, digits, min_fixed=-3, max_fixed=3, strip_zeros=True)
        if rounded(mpf(text), bits) == c:
            break
    mantissa, _, exponent = text.partition("e")
    whole, _, part = mantissa.partition(".")
    part = "_".join(part[i : i + 3] for i in range(0, len(part), 3)) or "0"
    return f"{whole}.{part}" + (f"e{exponent}" if exponent else "")


def report(name, fit, bits, where=lambda v: v):
    coefs, worst, at = fit.run(bits)
    kind = "f32" if bits == SINGLE else "f64"
    print(
        f"// {name}: degree {fit.degree}, error {mp.nstr(worst, 3)} "
        f"(2^{mp.nstr(mp.log(worst, 2), 4)}) at {mp.nstr(where(at), 4)}"
    )
    print(f"const {name.upper()}: [{kind}; {len(coefs)}] = [")
    for c in coefs:
        print(f"    {literal(c, bits)},")
    print("];", flush=True)
    return coefs


# --- the fits --------------------------------------------------------------


def fit_exp(name, bits, degree):
    """(exp(r) - 1 - r)/r^2 on |r| <= 0.3475 (just over ln(2)/2), error relative to exp(r)."""

    def core(r):
        with mp.extradps(20):
            return (mp.expm1(r) - r) / (r * r)

    half = mpf("0.3475")
    fit = Fit(core, lambda r: r * r * mp.exp(-r), -half, half, degree)
    report(name, fit, bits)


def fit_exp2(name, bits, degree):
    """(2^r - 1)/r on |r| <= 1/2, error relative to 2^r."""

    def core(r):
        with mp.extradps(20):
            return mp.expm1(r * mp.ln(2)) / r

    half = mpf(1) / 2
    report(name, Fit(core, lambda r: abs(r) * mp.power(2, -r), -half, half, degree), bits)


def fit_atan(name, bits, degree):
    """(atan(t)/t - 1)/s, s = t^2, on 0 <= s <= 1, error relative to atan(t)."""

    def core(s):
        t = mp.sqrt(s)
        with mp.extradps(20):
            return (mp.atan(t) / t - 1) / s if s else mpf(-1) / 3

    def weight(s):
        t = mp.sqrt(s)
        return s * t / mp.atan(t) if s else mpf(0)

    report(name, Fit(core, weight, 0, 1, degree), bits)


def fit_atan_joined(name, bits, degree):
    """As fit_atan, but with atan(1) = pi/4 exactly: the ranges of an angle join without a step.

    P(s) = P(1) + (s - 1) Q(s), Q fitted. All coefficients but the lowest are rounded; that takes
    up what is missing at 1, and is rounded last.
    """
    end = mp.pi / 4 - 1

    def core(s):
        t = mp.sqrt(s)
        with mp.extradps(20):
            return (mp.atan(t) / t - 1) / s if s else mpf(-1) / 3

    def quotient(s):
        s = min(s, 1 - mpf(10) ** -20)
        return (core(s) - end) / (s - 1)

    def weight(s):
        t = mp.sqrt(s)
        return s * t / mp.atan(t) if s else mpf(0)

    q = Fit(quotient, lambda s: (1 - s) * weight(s), 0, 1, degree - 1).remez()
    high = [rounded(a - b, bits) for a, b in zip(q, q[1:] + [mpf(0)])]
    coefs = [rounded(end - sum(high), bits)] + high
    grid = [mpf(n) / 4000 for n in range(1, 4001)]
    worst, at = max((abs(weight(s) * (core(s) - horner(coefs, s))), s) for s in grid)
    kind = "f32" if bits == SINGLE else "f64"
    step = abs(1 + sum(coefs) - mp.pi / 4)
    print(
        f"// {name}: degree {degree}, error {mp.nstr(worst, 3)} (2^{mp.nstr(mp.log(worst, 2), 4)}) "
        f"at {mp.nstr(at, 4)}, step at 1 {mp.nstr(2 * step, 2)}"
    )
    print(f"const {name.upper()}: [{kind}; {len(coefs)}] = [")
    for c in coefs:
        print(f"    {literal(c, bits)},")
    print("];", flush=True)


def fit_atan_excess(name, bits, degree):
    """(atan(x) - x/(1 + x^2))/x^3 in s = x^2, 0 <= s <= 1, relative."""

    def core(s):
        x = mp.sqrt(s)
        with mp.extradps(40):
            return (mp.atan(x) - x / (1 + s)) / (x * s) if s else mpf(2) / 3

    report(name, Fit(core, lambda s: 1 / core(s), 0, 1, degree), bits)


def fit_ln(name, bits, degree):
    """(ln((1 + s)/(1 - s)) - 2 s)/s^3 in z = s^2, 0 <= s <= 3 - 2 sqrt(2), error relative to the
    logarithm."""

    def whole(z):
        s = mp.sqrt(z)
        with mp.extradps(30):
            return mp.log((1 + s) / (1 - s))

    def core(z):
        s = mp.sqrt(z)
        with mp.extradps(30):
            return (whole(z) - 2 * s) / (s * z) if z else mpf(2) / 3

    def weight(z):
        return z * mp.sqrt(z) / whole(z) if z else mpf(0)

    report(name, Fit(core, weight, 0, mpf("0.02944"), degree), bits)


def fit_half_line(name, bits, degree, pole, reference, factor, limit):
    """reference(x) factor(x) in u = t - 3/8, t = pole/(pole + x), 0 <= x <= infinity, relative.

    The factor makes it nearly constant, so that the rounding of t hardly matters; centered at
    3/8 the terms hardly cancel. At infinity the product is limit/sqrt(pi).
    """
    center = mpf(3) / 8

    def argument(u):
        t = u + center
        return pole * (1 - t) / t if t else mp.inf

    def core(u):
        x = argument(u)
        return reference(x) * factor(x) if x < 1e25 else limit / mp.sqrt(mp.pi)

    fit = Fit(core, lambda u: 1 / core(u), -center, 1 - center, degree)
    report(name, fit, bits, argument)


def fit_erfcx(name, bits, degree, pole):
    """erfcx(x) (1 + x)."""
    fit_half_line(name, bits, degree, pole, erfcx, lambda x: 1 + x, mpf(1))


def fit_ierfcx(name, bits, degree, pole):
    """ierfcx(x) (1/2 + 7/8 x + x^2)."""
    fit_half_line(name, bits, degree, pole, ierfcx, lambda x: x * (x + 0.875) + 0.5, mpf(1) / 2)


def fit_ierfc_excess(name, bits, degree, cut):
    """g(w)^(1/4) in w, 0 <= w <= cut, with g(v^2) = (v + ierfc(v))^2 - v^2.

    The error counts in sqrt(w + g), which masking asks for. From the cut on g keeps its value: the
    last line says what that errs by.
    """

    def whole(w):
        v = mp.sqrt(w)
        with mp.extradps(10):
            i = mp.exp(-w) * ierfcx(v)
            return i * (2 * v + i)

    def root(w):
        return mp.sqrt(mp.sqrt(whole(w)))

    weight = lambda w: 2 * root(w) ** 3 / (w + whole(w))
    coefs = report(name, Fit(root, weight, 0, cut, degree), bits)
    wrong = lambda w: abs(horner(coefs, min(w, cut)) ** 4 - whole(w)) / (2 * (w + whole(w)))
    at = max((cut * mpf(i) / 1000 for i in range(2001)), key=wrong)
    print(f"// of sqrt(w + g): {mp.nstr(wrong(at), 3)} at w = {mp.nstr(at, 4)}", flush=True)


def fit_half_turn(name, bits, degree):
    """tan(pi u/4)/u in v = u^2, 0 <= v <= 1: relative."""

    def core(v):
        u = mp.sqrt(v)
        return mp.tan(mp.pi / 4 * u) / u if v else mp.pi / 4

    report(name, Fit(core, lambda v: 1 / core(v), 0, 1, degree), bits)


def fit_quantile(name, bits, degree):
    """z/(1 - 2v) in t = w/(w + 8) - 3/8, w = -ln(4v(1 - v)), for v from 2^-34 to 1/2: relative;
    P(Z > z) = v."""

    def argument(t):
        r = t + mpf(3) / 8
        return 8 * r / (1 - r)

    def core(t):
        w = argument(t)
        if w < mpf("1e-12"):
            return mp.sqrt(mp.pi / 2)
        e = mp.exp(-w)
        x = mp.sqrt(1 - e)
        v = e / (2 * (1 + x))
        log = lambda z: mp.log(mp.erfc(z / mp.sqrt(2)) / 2) - mp.log(v)
        return mp.findroot(log, mp.sqrt(2 * w) if w > 1 else mp.sqrt(mp.pi / 2) * x) / x

    w = 34 * mp.ln(2) - mp.ln(4)
    fit = Fit(core, lambda t: 1 / core(t), -mpf(3) / 8, w / (w + 8) - mpf(3) / 8, degree)
    report(
        name,
        fit,
        bits,
        lambda t: mp.exp(-argument(t)) / (2 * (1 + mp.sqrt(1 - mp.exp(-argument(t))))),
    )


def split(name, value, bits, head):
    """value in two parts, the first rounded to `head` bits, the second to the format."""
    first = rounded(value, head)
    second = rounded(value - first, bits)
    kind = "f32" if bits == SINGLE else "f64"
    left = mp.nstr(abs(value - first - second), 3)
    print(f"// {name}: {head} bits and the rest, which leaves {left}")
    print(f"const {name.upper()}: [{kind}; 2] = [{literal(first, bits)}, {literal(second, bits)}];")


# --- the peak of GGX under a Gaussian: src/filter/proxy.rs -------------------


def simplex(f, x, steps=1500):
    """Nelder & Mead 1965, from x: the parameters with the smallest f found, all positive."""
    points = [[abs(v) for v in x]] + [
        [abs(v) * (1.3 if i == k else 1) for i, v in enumerate(x)] for k in range(len(x))
    ]
    values = [f(p) for p in points]
    for _ in range(steps):
        order = sorted(range(len(points)), key=values.__getitem__)
        points, values = [points[i] for i in order], [values[i] for i in order]
        middle = [sum(c) / len(x) for c in zip(*points[:-1])]

        def at(t):
            p = [abs(m + t * (m - w)) for m, w in zip(middle, points[-1])]
            return p, f(p)

        trial = at(1)
        if trial[1] < values[0]:
            trial = min(trial, at(2), key=lambda t: t[1])
        elif trial[1] >= values[-2]:
            trial = at(-0.5)
            if trial[1] >= values[-1]:
                points[1:] = [[0.5 * (a + b) for a, b in zip(points[0], p)] for p in points[1:]]
                values[1:] = [f(p) for p in points[1:]]
                continue
        points[-1], values[-1] = trial
    return points[0], values[0]


def round_factor(p, kappa):
    s = math.sqrt(kappa)
    return 1 + (1 + p[0] * s) / (1 + p[1] * s + p[2] * kappa + p[3] * kappa * s)


def peak(major, minor):
    """pi times the peak of the unit GGX under a Gaussian with K = diag(major, minor): trapezoid in
    ln t."""
    total, step = 0.0, 0.05
    for n in range(-900, 84):
        t = math.exp(n * step)
        total += t * t * math.exp(-t) / math.sqrt((1 + major * t) * (1 + minor * t)) * step
    return total


def fit_peak_round(name):
    """The factor t of A + tK for isotropic A and K = kappa A, kappa 1e-4 to 1e4: error of
    alpha'^2."""
    kappas = [10 ** (-4 + 8 * n / 200) for n in range(201)]
    factors = [float(1 / (1 - x * mp.exp(x) * mp.e1(x)) - x) for x in (1 / mpf(k) for k in kappas)]

    def error(p):
        pairs = zip(kappas, factors)
        return max(abs(k * (round_factor(p, k) - t) / (1 + k * t)) for k, t in pairs)

    found = min(
        (simplex(error, [0.5 * c, c, 0.5 * c, 0.1 * c]) for c in (1, 1.4, 2, 3)), key=lambda r: r[1]
    )
    print(f"// {name}: {[float(f'{v:.5g}') for v in found[0]]}, error of alpha'^2 {found[1]:.2g}")


def fit_peak_long(name):
    """What kernels long against the lobe add to it, major axis 1e-3 to 1e5: error of the peak."""
    shapes = [
        (10 ** (-3 + 8 * n / 24), r)
        for n in range(25)
        for r in (0, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 0.03, 0.1, 0.2, 0.4, 0.7, 1)
    ]
    rows = [(a, a * r, peak(a, a * r)) for a, r in shapes]

    def error(p):
        worst = 0.0
        for major, minor, exact in rows:
            kappa, det = 0.5 * (major + minor), major * minor
            line = max(0.0, 1 - det / kappa**2)
            long = p[0] * kappa / (1 + p[1] * math.sqrt(kappa) + p[0] * kappa)
            t = round_factor((1.5226, 1.5377, 2.508, 0.22979), kappa)
            t += (4 / math.pi - 1) * line * long / (1 + p[2] * 0.5 * det / kappa)
            worst = max(worst, abs(1 / math.sqrt((1 + t * major) * (1 + t * minor)) / exact - 1))
        return worst

    found = min(
        (simplex(error, [0.5 * c, 0.5 * c, c], 400) for c in (0.3, 0.7, 1.1)), key=lambda r: r[1]
    )
    print(f"// {name}: {[float(f'{v:.4g}') for v in found[0]]}, error of the peak {found[1]:.3g}")


FITS = {
    "peak_round": fit_peak_round,
    "peak_long": fit_peak_long,
    "ln_two_f32": lambda n: split(n, mp.ln(2), SINGLE, 15),
    "ln_two_f64": lambda n: split(n, mp.ln(2), DOUBLE, 32),
    "half_pi_f32": lambda n: split(n, mp.pi / 2, SINGLE, SINGLE),
    "half_pi_f64": lambda n: split(n, mp.pi / 2, DOUBLE, DOUBLE),
    "pi_f32": lambda n: split(n, +mp.pi, SINGLE, SINGLE),
    "pi_f64": lambda n: split(n, +mp.pi, DOUBLE, DOUBLE),
    "exp_f32": lambda n: fit_exp(n, SINGLE, 4),
    "exp2_f32": lambda n: fit_exp2(n, SINGLE, 4),
    "exp_f64": lambda n: fit_exp(n, DOUBLE, 10),
    "ln_f32": lambda n: fit_ln(n, SINGLE, 2),
    "ln_f64": lambda n: fit_ln(n, DOUBLE, 6),
    "atan_f32": lambda n: fit_atan(n, SINGLE, 8),
    "atan_f64": lambda n: fit_atan(n, DOUBLE, 20),
    "atan_joined_f32": lambda n: fit_atan_joined(n, SINGLE, 5),
    "atan_joined_f64": lambda n: fit_atan_joined(n, DOUBLE, 12),
    "atan_excess_f32": lambda n: fit_atan_excess(n, SINGLE, 10),
    "atan_excess_f64": lambda n: fit_atan_excess(n, DOUBLE, 22),
    "erfcx_f32": lambda n: fit_erfcx(n, SINGLE, 10, mpf(83) / 32),
    "ierfcx_f32": lambda n: fit_ierfcx(n, SINGLE, 12, mpf(83) / 32),
    "erfcx_f64": lambda n: fit_erfcx(n, DOUBLE, 24, 4),
    "quantile": lambda n: fit_quantile(n, SINGLE, 9),
    "half_turn": lambda n: fit_half_turn(n, SINGLE, 4),
    "ierfcx_f64": lambda n: fit_ierfcx(n, DOUBLE, 26, 4),
    "ierfc_excess_f32": lambda n: fit_ierfc_excess(n, SINGLE, 7, mpf(23) / 2),
    "ierfc_excess_f64": lambda n: fit_ierfc_excess(n, DOUBLE, 26, mpf(31)),
}

if __name__ == "__main__":
    for chosen in sys.argv[1:] or FITS:
        FITS[chosen](chosen)
