"""Quantiles and fits that the tests of random variables and of fitted samples are held against (SciPy 1.17, mpmath-free)."""

import numpy as np
from scipy import optimize, stats

LEVELS = [1e-12, 1e-4, 0.3, 0.8]
FAMILIES = {
    "Weibull": stats.weibull_min(2.3, loc=0.4, scale=1.7),
    "Weibull, small shape": stats.weibull_min(0.6, loc=0.0, scale=2.5),
    "gamma": stats.gamma(3.7, loc=-0.5, scale=0.8),
    "gamma, small shape": stats.gamma(0.35, loc=0.0, scale=2.0),
    "gamma, large shape": stats.gamma(2500.0, loc=0.0, scale=0.02),
    "Gumbel": stats.gumbel_r(loc=3.0, scale=0.6),
    "exponential": stats.expon(loc=0.7, scale=1.6),
}
for name, family in FAMILIES.items():
    print(name, [float(family.ppf(p)) for p in LEVELS], float(family.isf(1e-12)), float(family.mean()), float(family.std()))

SAMPLE = np.array([0.21, 0.34, 0.29, 0.47, 0.38, 0.26, 0.55, 0.41, 0.33, 0.72, 0.30, 0.36])


def polished(negative_log_likelihood, start):
    found = optimize.minimize(negative_log_likelihood, start, method="Nelder-Mead", options={"xatol": 1e-13, "fatol": 1e-15, "maxiter": 20000})
    return [float(x) for x in found.x]


x = np.sort(SAMPLE)
n = len(x)
fits = {
    "normal": stats.norm(x.mean(), x.std(ddof=1)),
    "lognormal": stats.lognorm(np.log(x).std(ddof=1), scale=np.exp(np.log(x).mean())),
    "weibull": stats.weibull_min(*(lambda k, s: (k, 0, s))(*polished(lambda p: -stats.weibull_min(p[0], 0, p[1]).logpdf(x).sum(), [2.5, 0.4]))),
    "gamma": stats.gamma(*(lambda k, s: (k, 0, s))(*polished(lambda p: -stats.gamma(p[0], 0, p[1]).logpdf(x).sum(), [8, 0.05]))),
    "gumbel": stats.gumbel_r(*polished(lambda p: -stats.gumbel_r(p[0], p[1]).logpdf(x).sum(), [0.3, 0.1])),
    "exponential": stats.expon(0, x.mean()),
}
for name, fit in fits.items():
    i = np.arange(1, n + 1)
    a2 = -n - np.sum((2 * i - 1) * (fit.logcdf(x) + fit.logsf(x[::-1]))) / n
    print(name, fit.args, fit.kwds, "mean", float(fit.mean()), "std", float(fit.std()), "D", float(stats.kstest(x, fit.cdf).statistic), "A2", float(a2))
