"""Contact, friction and film laws as docs/contact-laws.md and docs/lubrication.md state them; nothing of the library is used.

All functions take and give numpy arrays of one number a sample, in SI.
"""

import numpy as np

GAUSS = np.polynomial.legendre.leggauss(40)

# Factor χ of the energy loss by nominal restitution e.
CHI = {
    "hertz": lambda e: 0.0 * e,
    "hunt-crossley": lambda e: 1.5 * (1 - e),
    "herbert-mcwhannell": lambda e: 6 * (1 - e) / ((2 * e - 1) ** 2 + 3),
    "lee-wang": lambda e: 0.75 * (1 - e),
    "lankarani-nikravesh": lambda e: 0.75 * (1 - e * e),
    "gonthier": lambda e: (1 - e * e) / e,
    "zhiying-qishao": lambda e: 0.75 * (1 - e * e) * np.exp(2 * (1 - e)),
    "flores": lambda e: 8 * (1 - e) / (5 * e),
    "hu-guo": lambda e: 1.5 * (1 - e) / e,
    "carvalho-martins": lambda e: 1.5 * (1 - e) * (11 - e) / (1 + 9 * e),
    "exact-restitution": lambda e: bisect(lambda x: x * (1 + e) - np.log1p(x) + np.log1p(-x * e), 1e-12, (1 - 1e-15) / e),
}
LINEAR = ["kelvin-voigt", "anagnostopoulos", "exact-linear-restitution"]
LOGARITHMIC = ["johnson", "esdu-78035", "dubowsky-freudenstein", "radzimovsky"]
LINE = LOGARITHMIC + ["liu", "bai-zhao", "pereira"]


def bisect(function, low, high):
    """A root between `low` and `high`, where `function` changes its sign."""
    rises = function(low) < 0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if (function(middle) < 0) == rises:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def damping_ratio(law, restitution):
    """ξ of the linear laws that take a restitution."""
    loss = -np.log(restitution)
    if law == "anagnostopoulos":
        return loss / np.hypot(np.pi, loss)
    return bisect(lambda x: 2 * x * np.arccos(x) / np.sqrt(1 - x * x) - loss, 1e-12, 1 - 1e-12)


def elastic(play, depth):
    """F_el at a penetration of one joint with play, N."""
    depth = np.maximum(depth, 0.0)
    contact, c = play.contact, play.clearance
    if contact.law in CHI or contact.law in LINEAR:
        return play.stiffness * depth**contact.exponent
    modulus = 1 / contact.compliance  # E* = 1/Σ((1 - ν²)/E)
    length, r_i, r_j = play.length, play.radius, play.radius - c
    if contact.law == "liu":
        return 0.5 * np.pi * modulus * length * depth * np.sqrt(depth / (2 * (c + depth)))
    if contact.law == "bai-zhao":
        return np.pi * modulus * length / 8 * depth * np.sqrt(2 * depth * (3 * c + 2 * depth) ** 2 / (c + depth) ** 3)
    if contact.law == "pereira":
        c_mm = c * 1e3
        y = 1.51 * np.log(1000 * c_mm) ** -0.151 if c_mm <= 0.34954 else 0.0151 * c_mm + 1.151
        size = (0.965 * c_mm + 0.0965) * (length * 1e3) * (modulus * 1e-6) / c_mm
        return size * (depth * 1e3) ** (y * c_mm**-0.005)
    # δ = s ln(a/s) with s = F h/L, h = Σ((1 - ν²)/E)/π; with w = ln(a/s): δ/a = w exp(-w), w > 1.
    h = contact.compliance / np.pi
    a = {
        "johnson": 4 * c / np.e,
        "esdu-78035": 4 * c * np.e,
        "dubowsky-freudenstein": np.e * length**2 * c / (r_i * r_j),
        "radzimovsky": np.exp(2 / 3) * 16 * c / (2.2568**2 * np.pi),
    }[contact.law]
    share = np.maximum(depth / a, 1e-300)
    w = 1.0 - np.log(share)
    for _ in range(60):
        w = np.maximum(w - (np.log(w) - w - np.log(share)) / (1 / w - 1), 1 + 1e-12)
    return np.where(depth > 0, a * np.exp(-w) * length / h, 0.0)


def stored(play, depth):
    """∫ F_el dδ, J, by Gauss and Legendre's rule over δ = D t², which takes the root out of the force."""
    depth = np.maximum(np.asarray(depth, float), 0.0)
    nodes, weights = 0.5 * (GAUSS[0] + 1), 0.5 * GAUSS[1]
    return sum(w * 2 * t * depth * elastic(play, depth * t * t) for t, w in zip(nodes, weights))


def normal(play, depth, rate, impact_speed, effective_mass, share):
    """F_N and F_el, N; `share` is the stiffness at the place over that of the law."""
    contact = play.contact
    spring = elastic(play, depth) * share
    if contact.law in LINEAR:
        damper = contact.damping
        if contact.law != "kelvin-voigt":
            damper = 2 * damping_ratio(contact.law, contact.restitution) * np.sqrt(play.stiffness * effective_mass)
        # The spring of a slot's end is stiffer by its share, and so is the damper's force: the law as a whole is.
        return np.maximum(spring + share * damper * rate, 0.0), spring
    return np.maximum(spring * (1 + contact.chi * rate / impact_speed), 0.0), spring


def friction(law, v):
    """-μ(|v|) sign v of a law without memory; of LuGre's, what it settles to."""
    speed, sign, n = np.abs(v), np.sign(v), law.numbers
    mu = n["coefficient"]
    if law.name == "ambrosio":
        size = mu * np.clip((speed - n["lower_speed"]) / (n["upper_speed"] - n["lower_speed"]), 0, 1)
    elif law.name == "threlfall":
        size = mu * (1 - np.exp(-3 * np.minimum(speed / n["transition_speed"], 1)))
    elif law.name == "stribeck":
        peak = (n["static_coefficient"] - mu) * np.exp(-((speed / n["stribeck_speed"]) ** 2))
        size = (mu + peak) * np.tanh(4 * speed / n["transition_speed"]) + n["viscous"] * speed
    elif law.name == "brown-mcphee":
        x = speed / n["transition_speed"]
        size = mu * np.tanh(4 * x) + (n["static_coefficient"] - mu) * x / (x * x / 4 + 0.75) ** 2 + n["viscous"] * speed
    elif law.name == "bengisu-akay":
        s, va = n["static_coefficient"], n["transition_speed"]
        size = np.where(speed < va, s - s / va**2 * (speed - va) ** 2,
                        mu + (s - mu) * np.exp(-n["decay"] * np.maximum(speed - va, 0)))
    elif law.name == "lugre":
        size = settled(law, v) + n["viscous"] * speed
    else:
        raise ValueError(law.name)
    return -size * sign


def settled(law, v):
    """g(v) of LuGre."""
    n = law.numbers
    peak = (n["static_coefficient"] - n["coefficient"]) * np.exp(-((v / n["stribeck_speed"]) ** 2))
    return np.maximum(n["coefficient"] + peak, 1e-4)


def film_force(film, play, ratio, squeeze, wedge):
    """Force on the journal along n and t, N; ratio below the cap. None for the law whose sums are not repeated here."""
    r, c, length = play.radius, play.clearance, play.length
    unit = film.viscosity * length * r**3 / c**2  # μ L R³/c²
    s = 1 - ratio**2
    if film.law == "ocvirk":
        # Pressure (4/3 of its middle, over the length) where it is positive, by quadrature over θ.
        short = (length / (2 * r)) ** 2
        begin = np.arctan2(2 * squeeze, wedge)
        nodes, weights = np.polynomial.legendre.leggauss(400)
        radial = np.zeros_like(ratio)
        tangential = np.zeros_like(ratio)
        # Sommerfeld's variable spreads the thin side out: cos θ = (cos g - ε)/(1 - ε cos g).
        def to_g(theta):
            return 2 * np.arctan2(np.sqrt(1 - ratio) * np.sin(theta / 2), np.sqrt(1 + ratio) * np.cos(theta / 2))
        for turn in (-2 * np.pi, 0.0, 2 * np.pi):
            low, high = np.clip(begin + turn, -np.pi, np.pi), np.clip(begin + np.pi + turn, -np.pi, np.pi)
            g_low, g_high = to_g(low), to_g(high)
            for x, w in zip(nodes, weights):
                g = 0.5 * (g_high + g_low) + 0.5 * (g_high - g_low) * x
                cos, sin = (np.cos(g) - ratio) / (1 - ratio * np.cos(g)), np.sqrt(s) * np.sin(g) / (1 - ratio * np.cos(g))
                stretch = np.sqrt(s) / (1 - ratio * np.cos(g)) * 0.5 * (g_high - g_low) * w
                pressure = -(2 / 3) * short * (2 * squeeze * cos - wedge * sin) / (1 + ratio * cos) ** 3 * stretch
                radial, tangential = radial + pressure * cos, tangential + pressure * sin
        return 3 * unit * radial, 3 * unit * tangential
    if film.law == "ocvirk-printed":
        unit = film.viscosity * length**3 * r / c**2
        sign = np.clip(wedge / np.maximum(0.05 * np.abs(squeeze), 1e-300), -1, 1)
        radial = -(np.abs(wedge) * ratio / s**2 + np.pi * squeeze * (1 + 2 * ratio**2) / (2 * s**2.5))
        tangential = wedge * np.pi / (4 * s**1.5) + sign * 2 * ratio * squeeze / s**2
        return unit * radial, unit * tangential
    if film.law == "pinkus-sternlicht":
        size = np.maximum(np.abs(squeeze), 1e-300)
        k = np.sqrt(s * ((wedge / ratio / (2 * size)) ** 2 + 1 / ratio**2))
        g = np.where(squeeze > 0, (k + 3) / (k + 1.5), k / (k + 1.5))
        bend = 2 + ratio**2
        radial = -6 * size * (4 * k * ratio**2 + np.sign(squeeze) * bend * np.pi) / (bend * s**1.5) * g
        return unit * radial, unit * 6 * np.pi * wedge / (bend * np.sqrt(s)) * g
    return None
