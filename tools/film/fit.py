#!/usr/bin/env python3
"""Makes the coefficients of the film of finite length: crates/loosepin/src/contact/film/finite_length_table.rs.

    python3 -m venv .venv && .venv/bin/pip install numpy && .venv/bin/python tools/film/fit.py

Solves the Reynolds equation of a journal bearing for a grid of eccentricity ratios, ratios L/D and directions of the velocity q,
drops negative pressure (half-Sommerfeld), and fits what is left over when the force of Ocvirk's film is divided by it.

The equation over the angle and ζ = 2z/L is (h³ p')' + h³ p_ζζ/(L/D)² = 2 ε̇ cos θ - w ε sin θ, in units of 6 μ R²/c². In Sommerfeld's
variable ψ, h = (1 - ε²)/(1 - ε cos ψ), everything is smooth; Fourier collocation in ψ, then modes of the generalised eigenvalue
problem, whose profile along the bearing is 1 - cosh(m ζ)/cosh(m) with m = μ L/D.
"""

import pathlib

import numpy as np

RATIOS = [0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.78, 0.85, 0.9, 0.94, 0.97, 0.985]
LENGTHS = [0.02, 0.06, 0.12, 0.2, 0.3, 0.4, 0.55, 0.75, 1.0, 1.4, 2.0, 3.0, 5.0, 10.0, 30.0, 200.0]
DIRECTIONS = np.radians(np.linspace(0.0, 180.0, 25))
DEGREE = 6
CROSSOVER = 0.5
# Where a force is below this share of the largest at the same ε and L/D, its error counts as if it were that large.
SMALLEST_SHARE = 0.03


def modes(ratio):
    """Roots of the eigenvalues, modes over ψ, and the parts of the right-hand sides of ε̇ = 1 and of w ε = 1 in them."""
    points = 65 if ratio < 0.75 else 129 if ratio < 0.92 else 257
    psi = 2 * np.pi * np.arange(points) / points
    below = 1 - ratio * np.cos(psi)
    film = (1 - ratio**2) / below
    wave = np.fft.fftfreq(points, 1 / points)
    slope = np.real(np.fft.ifft(1j * wave[:, None] * np.fft.fft(np.eye(points), axis=0), axis=0))
    operator = (1 - ratio**2) * slope @ (film[:, None] ** 2 * slope) / (film[:, None] * film[None, :]) ** 2
    cosine, sine = (np.cos(psi) - ratio) / below, np.sqrt(1 - ratio**2) * np.sin(psi) / below
    right = np.stack([2 * cosine * film, -sine * film], 1)
    values, vectors = np.linalg.eigh(-(operator + operator.T) / 2)
    parts = vectors.T @ (right / film[:, None] ** 2)
    return np.sqrt(np.maximum(values, 1e-12)), vectors / film[:, None] ** 2, parts


def forces(ratio, length, solved, fine=1536, stations=24):
    """F_r + i F_t in units of μ L R³ |q|/c³ for all directions of q."""
    roots, vectors, parts = solved
    places, weights = np.polynomial.legendre.leggauss(stations)
    places, weights = (places + 1) / 2, weights / 2
    power = 3 if length > 4 else 1  # stations crowd at the ends of a long bearing, where its pressure falls
    along = 1 - (1 - places) ** power
    weights = weights * power * (1 - places) ** (power - 1)
    rate = roots * length
    profile = 1 - (np.exp(-rate * (1 - along[:, None])) + np.exp(-rate * (1 + along[:, None]))) / (1 + np.exp(-2 * rate))
    pressure = np.einsum("ik,zka->zia", vectors, -profile[:, :, None] * (parts / roots[:, None] ** 2)[None])
    points = pressure.shape[1]
    spectrum = np.zeros((stations, fine // 2 + 1, 2), complex)
    spectrum[:, : points // 2 + 1] = np.fft.rfft(pressure, axis=1)
    pressure = np.fft.irfft(spectrum, fine, axis=1) * fine / points
    psi = 2 * np.pi * np.arange(fine) / fine
    below, root = 1 - ratio * np.cos(psi), np.sqrt(1 - ratio**2)
    direction = ((np.cos(psi) - ratio) + 1j * root * np.sin(psi)) / below * (root / below * 2 * np.pi / fine)
    found = []
    for angle in DIRECTIONS:
        cut = np.maximum(pressure[:, :, 0] * np.cos(angle) - 2 * np.sin(angle) * pressure[:, :, 1], 0)
        found.append(6 * np.sum((weights @ cut) * direction))
    return np.array(found)


def ocvirk(ratio, angle):
    """F_r + i F_t of the infinitely short film in units of μ R L³ |q|/c³ (ocvirk.rs)."""
    sine, cosine, gap = np.cos(angle), -np.sin(angle), 1 - ratio**2
    product = 1 - (ratio * cosine) ** 2
    turn = (np.pi + 2 * np.arctan(ratio * sine / np.sqrt(gap))) / np.sqrt(gap)
    a = turn * (1 + 2 * ratio**2) / (2 * gap**2) + ratio * sine * (3 / gap + 2 * cosine**2 / product) / (product * gap)
    b = turn / (2 * gap) + ratio * sine * (1 - 2 * cosine**2 + (ratio * cosine) ** 2) / (product**2 * gap)
    c = -2 * ratio * cosine**3 / product**2
    return c * cosine - a * sine + 1j * (b * cosine - c * sine)


def chebyshev(degree, x):
    return np.cos(degree * np.arccos(np.clip(x, -1, 1)))


def main():
    force = np.array([[forces(ratio, length, solved) for length in LENGTHS] for ratio in RATIOS for solved in [modes(ratio)]])
    ratio, length, angle = np.meshgrid(RATIOS, LENGTHS, DIRECTIONS, indexing="ij")
    short = ocvirk(ratio, angle) * 4 * length**2
    share = abs(force) / abs(force).max(axis=2, keepdims=True)
    x, y = ratio * short.real / abs(short), ratio * short.imag / abs(short)
    scale = (1 + x) / (1 + x + CROSSOVER * length**2)
    target = short / force * scale
    tau = length / (length + np.sqrt((1 + x) / CROSSOVER))
    eta = (1 - ratio**2) / (1 + x)
    degrees = [
        (i, j, k) for i in range(DEGREE + 1) for j in range(DEGREE + 1 - i) for k in range(DEGREE + 1 - i - j)
    ]
    basis = np.array(
        [(tau * chebyshev(i, x) * chebyshev(j, eta - 1) * chebyshev(k, 2 * tau - 1)).ravel() for i, j, k in degrees]
    ).T
    weight = (np.maximum(share, SMALLEST_SHARE) / abs(target)).ravel()
    real = np.linalg.lstsq(basis * weight[:, None], (target.real.ravel() - 1) * weight, rcond=1e-12)[0]
    tilted = basis * y.ravel()[:, None]
    imaginary = np.linalg.lstsq(tilted * weight[:, None], target.imag.ravel() * weight, rcond=1e-12)[0]
    fitted = (1 + basis @ real + 1j * (tilted @ imaginary)).reshape(target.shape)
    error = abs(target / fitted - 1)
    print(f"of the largest force at the same ε and L/D: {(error * share).max():.4f}")
    print(f"of the force: {error.max():.4f}; towards the film and across: {error[:, :, :13].max():.4f}")
    print(f"the same up to ε = 0.9: {error[:11].max():.4f}; {error[:11, :, :13].max():.4f}")
    table = pathlib.Path(__file__).parents[2] / "crates/loosepin/src/contact/film/finite_length_table.rs"
    with table.open("w", encoding="utf-8") as file:
        file.write("//! Coefficients of the film of finite length, made by `tools/film/fit.py`.\n\n")
        file.write("/// The largest degree i + j + k.\n")
        file.write(f"pub(super) const DEGREE: usize = {DEGREE};\n\n")
        file.write("/// a_ijk and b_ijk; i outermost, k innermost, i + j + k up to [`DEGREE`].\n")
        file.write(f"pub(super) const COEFFICIENTS: [[f64; 2]; {len(degrees)}] = [\n")
        for pair in zip(real, imaginary):
            file.write("    [" + ", ".join(f"{value:.9e}" for value in pair) + "],\n")
        file.write("];\n")


main()
