//! Tsitouras' pair of order 5(4), for loose tolerances.

use super::tableau::{ErrorEstimate, Tableau};

/// Tsitouras' method of order 5 (4), six stages, with its dense output of order 4: Ch. Tsitouras, "Runge-Kutta pairs of order
/// 5(4) satisfying only the first column simplifying assumption", Computers and Mathematics with Applications 62 (2011)
/// 770-775, table 1; the dense output in the form of Hairer, Nørsett and Wanner, whose row holds the leading coefficients of
/// the paper's b(θ).
pub static TSITOURAS_5: Tableau = Tableau {
    name: "Tsitouras 5(4)",
    order: 5,
    nodes: &[0.0, 0.161, 0.327, 0.9, 0.9800255409045097, 1.0],
    stages: &[
        &[],
        &[(0, 0.161)],
        &[(0, -0.008480655492356989), (1, 0.335480655492357)],
        &[(0, 2.8971530571054935), (1, -6.359448489975075), (2, 4.3622954328695815)],
        &[(0, 5.325864828439257), (1, -11.748883564062828), (2, 7.4955393428898365), (3, -0.09249506636175525)],
        &[
            (0, 5.86145544294642),
            (1, -12.92096931784711),
            (2, 8.159367898576159),
            (3, -0.071584973281401),
            (4, -0.028269050394068383),
        ],
    ],
    weights: &[
        (0, 0.09646076681806523),
        (1, 0.01),
        (2, 0.4798896504144996),
        (3, 1.379008574103742),
        (4, -3.290069515436081),
        (5, 2.324710524099774),
    ],
    error: ErrorEstimate::Single(&[
        (0, 0.0017800110522257714),
        (1, 0.0008164344596567469),
        (2, -0.007880878010261995),
        (3, 0.1447110071732629),
        (4, -0.5823571654525552),
        (5, 0.45808210592918697),
        (6, -1.0 / 66.0),
    ]),
    dense_stages: &[],
    dense: &[&[
        (0, -1.0530884977290216),
        (1, 0.1017),
        (2, 2.490627285651253),
        (3, -16.548102889244902),
        (4, 47.37952196281928),
        (5, -34.87065786149661),
        (6, 2.5),
    ]],
};
