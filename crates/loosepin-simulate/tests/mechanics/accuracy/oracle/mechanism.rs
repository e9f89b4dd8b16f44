//! Random mechanisms as lists of constraints between bodies, closed by plain Newton in the coordinates of all bodies.
//!
//! Every body has its frame along the axes of the ground at the start, so that all angles are zero there.

use super::random::Random;
use std::fmt::Write;

type Point = [f64; 2];

/// A joint between two bodies, by their indices; 0 is the ground. Points are in the frames of the bodies, m.
#[derive(Debug, Clone)]
pub(super) enum Joint {
    /// The journal of the second body in the bearing of the first, with a clearance.
    Pin { bodies: [usize; 2], points: [Point; 2], clearance_m: f64 },
    /// The point of the second body on a line of the first, turning with it; clearance, half-length and half-height of the block.
    Guide { bodies: [usize; 2], points: [Point; 2], angle_rad: f64, block_m: Option<[f64; 3]> },
    /// A pin of the second body in a slot of the first.
    Slot { bodies: [usize; 2], points: [Point; 2], angle_rad: f64, clearance_m: f64 },
    /// A pin of the second body in a slot along a circle about the point of the first.
    CircularSlot { bodies: [usize; 2], points: [Point; 2], radius_m: f64, clearance_m: f64 },
    /// External gears on bodies that turn about points of the ground, with radii and half of the backlash.
    Gears { bodies: [usize; 2], radii_m: [f64; 2], half_backlash_m: f64 },
}

/// What is read: a coordinate of a point of a body, or its angle.
#[derive(Debug, Clone, Copy)]
pub(super) enum Output {
    Coordinate { body: usize, point: Point, axis: usize },
    Angle { body: usize },
}

#[derive(Debug, Clone)]
pub(super) struct Rig {
    pub family: &'static str,
    /// Where the frames of the moving bodies are at the start.
    pub origins: Vec<Point>,
    pub joints: Vec<Joint>,
    pub output: Output,
}

impl Rig {
    /// A random mechanism of one of six families.
    pub fn random(seed: u64) -> Self {
        Self::of_family(["slider-crank", "four-bar", "six-bar", "slot", "gears", "guide"][seed as usize % 6], seed)
    }

    /// A random mechanism; body 1 is driven about the origin.
    pub fn of_family(family: &'static str, seed: u64) -> Self {
        let random = &mut Random::new(seed);
        let crank_pin = {
            let (radius, angle) = (random.between(0.02, 0.045), random.between(-3.1, 3.1));
            [radius * angle.cos(), radius * angle.sin()]
        };
        let mut rig = Self { family, origins: Vec::new(), joints: Vec::new(), output: Output::Angle { body: 1 } };
        let crank = rig.body([0.0, 0.0]);
        rig.pin(0, crank, [0.0, 0.0], 0.0);
        match family {
            "slot" => {
                let pivot = [random.between(-0.16, -0.09), random.between(-0.05, 0.05)];
                let arm = rig.body(pivot);
                rig.loose_pin(random, 0, arm, pivot);
                let way = (crank_pin[1] - pivot[1]).atan2(crank_pin[0] - pivot[0]);
                let angle_rad = way + random.between(-0.3, 0.3);
                let points = [rig.local(arm, crank_pin), rig.local(crank, crank_pin)];
                rig.joints.push(Joint::Slot {
                    bodies: [arm, crank],
                    points,
                    angle_rad,
                    clearance_m: clearance_m(random),
                });
            }
            "circular slot" => {
                let pivot = [random.between(-0.16, -0.09), random.between(-0.05, 0.05)];
                let arm = rig.body(pivot);
                rig.loose_pin(random, 0, arm, pivot);
                // The pin pushes the arm nearly across, and the slot is so wide that the crank turns fully.
                let way = (crank_pin[1] - pivot[1]).atan2(crank_pin[0] - pivot[0]);
                let (s, c) = (way + std::f64::consts::FRAC_PI_2 + random.between(-0.05, 0.05)).sin_cos();
                let radius_m = random.between(0.25, 0.35);
                let centre = [crank_pin[0] + radius_m * c, crank_pin[1] + radius_m * s];
                let points = [rig.local(arm, centre), rig.local(crank, crank_pin)];
                let clearance_m = clearance_m(random);
                rig.joints.push(Joint::CircularSlot { bodies: [arm, crank], points, radius_m, clearance_m });
            }
            "slider-crank" | "guide" => {
                let rod = rig.body(crank_pin);
                rig.loose_pin(random, crank, rod, crank_pin);
                let end = [random.between(0.11, 0.2), random.between(-0.03, 0.03)];
                let slider = rig.body(end);
                rig.loose_pin(random, rod, slider, end);
                let angle_rad = random.between(-0.25, 0.25);
                let points = [end, [0.0, 0.0]];
                let half_length = random.between(0.02, 0.05);
                let block_m = (family == "guide")
                    .then(|| [random.between(2e-5, 4e-4), half_length, half_length * random.between(0.2, 0.8)]);
                rig.joints.push(Joint::Guide { bodies: [0, slider], points, angle_rad, block_m });
            }
            _ => {
                let mut driving = crank;
                let mut start = crank_pin;
                if family == "gears" {
                    let radii_m = [random.between(0.015, 0.03), random.between(0.03, 0.05)];
                    let pivot = [-radii_m[0] - radii_m[1], 0.0];
                    driving = rig.body(pivot);
                    rig.pin(0, driving, pivot, 0.0);
                    let half_backlash_m = 0.5 * random.between(5e-5, 4e-4);
                    rig.joints.push(Joint::Gears { bodies: [crank, driving], radii_m, half_backlash_m });
                    start = [pivot[0] + crank_pin[0], pivot[1] + crank_pin[1]];
                }
                let coupler = rig.body(start);
                rig.loose_pin(random, driving, coupler, start);
                let top = [start[0] + random.between(0.08, 0.16), random.between(0.07, 0.14)];
                let foot = [top[0] + random.between(-0.01, 0.06), random.between(-0.04, 0.02)];
                let rocker = rig.body(foot);
                rig.loose_pin(random, coupler, rocker, top);
                rig.loose_pin(random, 0, rocker, foot);
                if family == "six-bar" {
                    let from = [top[0] + random.between(0.0, 0.03), top[1] + random.between(-0.05, 0.02)];
                    let link = rig.body(from);
                    rig.loose_pin(random, rocker, link, from);
                    let head = [from[0] + random.between(0.07, 0.14), random.between(0.07, 0.13)];
                    let pivot = [head[0] + random.between(-0.02, 0.05), random.between(-0.04, 0.02)];
                    let arm = rig.body(pivot);
                    rig.loose_pin(random, link, arm, head);
                    rig.loose_pin(random, 0, arm, pivot);
                }
            }
        }
        let last = rig.origins.len();
        let seen = last - random.index(2.min(last - 1));
        rig.output = match random.index(3) {
            axis @ (0 | 1) => {
                let point = [random.between(-0.03, 0.06), random.between(-0.04, 0.04)];
                Output::Coordinate { body: seen, point, axis }
            }
            _ => Output::Angle { body: if matches!(family, "slider-crank" | "guide") { last - 1 } else { seen } },
        };
        if rig.reaches().is_empty() {
            rig.loosen(1, 2.7e-4);
        }
        rig
    }

    fn loosen(&mut self, joint: usize, to_m: f64) {
        if let Joint::Pin { clearance_m, .. } = &mut self.joints[joint] {
            *clearance_m = to_m;
        }
    }

    fn body(&mut self, origin: Point) -> usize {
        self.origins.push(origin);
        self.origins.len()
    }

    fn local(&self, body: usize, at: Point) -> Point {
        let [x, y] = if body == 0 { [0.0; 2] } else { self.origins[body - 1] };
        [at[0] - x, at[1] - y]
    }

    fn pin(&mut self, first: usize, second: usize, at: Point, clearance_m: f64) {
        let points = [self.local(first, at), self.local(second, at)];
        self.joints.push(Joint::Pin { bodies: [first, second], points, clearance_m });
    }

    fn loose_pin(&mut self, random: &mut Random, first: usize, second: usize, at: Point) {
        let clearance_m = if random.between(0.0, 1.0) < 0.7 { clearance_m(random) } else { 0.0 };
        self.pin(first, second, at, clearance_m);
    }

    /// Residuals at the coordinates (x, y, angle) of all moving bodies, their derivatives, and where joints are displaced.
    fn constraints(&self, q: &[f64], crank_rad: f64, displacements: &[Point]) -> (Vec<f64>, Vec<f64>) {
        let columns = q.len();
        let (mut residuals, mut jacobian): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        let mut next = displacements.iter();
        let mut row = |residual: f64, parts: &[(usize, f64)]| {
            residuals.push(residual);
            let at = jacobian.len();
            jacobian.resize(at + columns, 0.0);
            for (column, value) in parts {
                jacobian[at + column] += value;
            }
        };
        let angle = |body: usize| if body == 0 { 0.0 } else { q[3 * body - 1] };
        // Place of a point, and its derivative with respect to the angle of its body.
        let place = |body: usize, [x, y]: Point| {
            let (s, c) = angle(body).sin_cos();
            let [ox, oy] = if body == 0 { [0.0; 2] } else { [q[3 * body - 3], q[3 * body - 2]] };
            ([ox + c * x - s * y, oy + s * x + c * y], [-s * x - c * y, c * x - s * y])
        };
        // Derivative of n·(place of a point).
        let along = |parts: &mut Vec<(usize, f64)>, body: usize, n: Point, turn: Point, sign: f64| {
            if body > 0 {
                let first = 3 * body - 3;
                parts.push((first, sign * n[0]));
                parts.push((first + 1, sign * n[1]));
                parts.push((first + 2, sign * (n[0] * turn[0] + n[1] * turn[1])));
            }
        };
        for joint in &self.joints {
            match *joint {
                Joint::Pin { bodies: [i, j], points, clearance_m } => {
                    let e = if clearance_m > 0.0 { *next.next().expect("one for each") } else { [0.0; 2] };
                    let [(a, turn_a), (b, turn_b)] = [place(i, points[0]), place(j, points[1])];
                    for axis in 0..2 {
                        let n = [f64::from(axis == 0), f64::from(axis == 1)];
                        let mut parts = Vec::new();
                        along(&mut parts, i, n, turn_a, -1.0);
                        along(&mut parts, j, n, turn_b, 1.0);
                        row(b[axis] - a[axis] - e[axis], &parts);
                    }
                }
                Joint::Guide { bodies: [i, j], points, angle_rad, .. }
                | Joint::Slot { bodies: [i, j], points, angle_rad, .. } => {
                    let is_loose =
                        !matches!(joint, Joint::Guide { block_m: None, .. } | Joint::Slot { clearance_m: 0.0, .. });
                    let [ordinate, tilt] = if is_loose { *next.next().expect("one for each") } else { [0.0; 2] };
                    let [(a, turn_a), (b, turn_b)] = [place(i, points[0]), place(j, points[1])];
                    let (s, c) = (angle(i) + angle_rad).sin_cos();
                    let (normal, gap) = ([-s, c], [b[0] - a[0], b[1] - a[1]]);
                    let mut parts = Vec::new();
                    along(&mut parts, i, normal, turn_a, -1.0);
                    along(&mut parts, j, normal, turn_b, 1.0);
                    if i > 0 {
                        parts.push((3 * i - 1, -c * gap[0] - s * gap[1]));
                    }
                    row(normal[0] * gap[0] + normal[1] * gap[1] - ordinate, &parts);
                    if matches!(joint, Joint::Guide { .. }) {
                        let parts: Vec<_> = [(i, -1.0), (j, 1.0)]
                            .into_iter()
                            .filter(|p| p.0 > 0)
                            .map(|(b, s)| (3 * b - 1, s))
                            .collect();
                        row(angle(j) - angle(i) - tilt, &parts);
                    }
                }
                Joint::CircularSlot { bodies: [i, j], points, radius_m, .. } => {
                    let [outwards_m, _] = *next.next().expect("one for each");
                    let [(a, turn_a), (b, turn_b)] = [place(i, points[0]), place(j, points[1])];
                    let gap = [b[0] - a[0], b[1] - a[1]];
                    let distance_m = gap[0].hypot(gap[1]);
                    let normal = gap.map(|component| component / distance_m);
                    let mut parts = Vec::new();
                    along(&mut parts, i, normal, turn_a, -1.0);
                    along(&mut parts, j, normal, turn_b, 1.0);
                    row(distance_m - radius_m - outwards_m, &parts);
                }
                Joint::Gears { bodies: [i, j], radii_m: [first, second], .. } => {
                    let [length, _] = *next.next().expect("one for each");
                    row(
                        angle(j) + first / second * angle(i) - length / second,
                        &[(3 * j - 1, 1.0), (3 * i - 1, first / second)],
                    );
                }
            }
        }
        row(angle(1) - crank_rad, &[(2, 1.0)]);
        (residuals, jacobian)
    }

    /// Closes all constraints from `q`; false where that fails. `side` is the sign of the determinant that must stay.
    pub fn close(&self, q: &mut [f64], crank_rad: f64, displacements: &[Point], side: &mut f64) -> bool {
        for _ in 0..25 {
            let (mut residuals, mut jacobian) = self.constraints(q, crank_rad, displacements);
            let worst = residuals.iter().fold(0.0_f64, |worst, value| worst.max(value.abs()));
            let sign = solve(&mut jacobian, &mut residuals);
            if !worst.is_finite() || sign == 0.0 {
                return false;
            }
            q.iter_mut().zip(&residuals).for_each(|(q, step)| *q -= step);
            if worst < 1e-15 || (worst < 1e-12 && residuals.iter().all(|step| step.abs() < 1e-13)) {
                if *side == 0.0 {
                    *side = sign;
                }
                return *side == sign;
            }
        }
        false
    }

    pub fn start(&self) -> Vec<f64> {
        self.origins.iter().flat_map(|[x, y]| [*x, *y, 0.0]).collect()
    }

    pub fn value(&self, q: &[f64]) -> f64 {
        match self.output {
            Output::Angle { body } => q[3 * body - 1],
            Output::Coordinate { body, point: [x, y], axis } => {
                let (s, c) = q[3 * body - 1].sin_cos();
                q[3 * body - 3 + axis] + [c * x - s * y, s * x + c * y][axis]
            }
        }
    }

    /// What joints with play may do, in their order.
    pub fn reaches(&self) -> Vec<Reach> {
        self.joints
            .iter()
            .filter_map(|joint| match *joint {
                Joint::Pin { clearance_m, .. } => (clearance_m > 0.0).then_some(Reach::Disc(clearance_m)),
                Joint::Guide { block_m, .. } => block_m.map(Reach::Block),
                Joint::Slot { clearance_m, .. } | Joint::CircularSlot { clearance_m, .. } => {
                    (clearance_m > 0.0).then_some(Reach::Line(clearance_m))
                }
                Joint::Gears { half_backlash_m, .. } => Some(Reach::Line(half_backlash_m)),
            })
            .collect()
    }

    /// The model file.
    pub fn text(&self) -> String {
        let mut text = String::from("name = \"random\"\ngravity = \"9.81 m/s^2\"\n\n");
        let name = |body: usize| if body == 0 { "ground".to_owned() } else { format!("b{body}") };
        let mut points: Vec<Vec<Point>> = vec![Vec::new(); self.origins.len() + 1];
        let mut joints = String::new();
        for (index, joint) in self.joints.iter().enumerate() {
            let (bodies, places) = match joint {
                Joint::Pin { bodies, points, .. }
                | Joint::Guide { bodies, points, .. }
                | Joint::Slot { bodies, points, .. }
                | Joint::CircularSlot { bodies, points, .. } => (bodies, points),
                Joint::Gears { radii_m, half_backlash_m, .. } => {
                    let _ = write!(
                        joints,
                        "[coupling.mesh]\nkind = \"gears\"\nmesh = \"external\"\nfirst = \"j0\"\nsecond = \"j1\"\nradii = [\"{} m\", \"{} m\"]\nbacklash = \"{} m\"\ncontact = \"steel\"\n\n",
                        radii_m[0],
                        radii_m[1],
                        2.0 * half_backlash_m
                    );
                    continue;
                }
            };
            let [first, second] = [0, 1].map(|side| {
                let own = &mut points[bodies[side]];
                own.push(places[side]);
                format!("{}.p{}", name(bodies[side]), own.len() - 1)
            });
            let _ = writeln!(joints, "[joint.j{index}]");
            let _ = match *joint {
                Joint::Pin { clearance_m, .. } => {
                    let play = if clearance_m > 0.0 {
                        format!(
                            "bearing_radius = \"10 mm\"\nradial_clearance = \"{clearance_m} m\"\ncontact = \"steel\"\n"
                        )
                    } else {
                        String::new()
                    };
                    writeln!(joints, "kind = \"revolute\"\nbearing = \"{first}\"\njournal = \"{second}\"\n{play}")
                }
                Joint::Guide { angle_rad, block_m, .. } => {
                    let play = block_m.map_or(String::new(), |[c, a, b]| {
                        format!("half_length = \"{a} m\"\nhalf_height = \"{b} m\"\nclearance = \"{c} m\"\ncontact = \"steel\"\n")
                    });
                    writeln!(
                        joints,
                        "kind = \"prismatic\"\nguide = {{ point = \"{first}\", angle = \"{angle_rad} rad\" }}\nslider = {{ point = \"{second}\", angle = \"{angle_rad} rad\" }}\n{play}"
                    )
                }
                Joint::Slot { angle_rad, clearance_m, .. } => writeln!(
                    joints,
                    "kind = \"slot\"\nslot = {{ point = \"{first}\", angle = \"{angle_rad} rad\" }}\npin = \"{second}\"\nhalf_length = \"300 mm\"\nend_radius = \"9 mm\"\nclearance = \"{clearance_m} m\"\ncontact = \"steel\"\n"
                ),
                Joint::CircularSlot { radius_m, clearance_m, .. } => writeln!(
                    joints,
                    "kind = \"circular-slot\"\nslot = {{ point = \"{first}\", radius = \"{radius_m} m\" }}\npin = \"{second}\"\nhalf_width = \"9 mm\"\nclearance = \"{clearance_m} m\"\ncontact = \"steel\"\n"
                ),
                Joint::Gears { .. } => Ok(()),
            };
        }
        let output = match self.output {
            Output::Angle { body } => format!("angle_of = \"{}\"", name(body)),
            Output::Coordinate { body, point, axis } => {
                points[body].push(point);
                let axis = ["x", "y"][axis];
                format!("position_of = \"{}.p{}\"\nalong = \"{axis}\"", name(body), points[body].len() - 1)
            }
        };
        for (body, points) in points.iter().enumerate() {
            let named: Vec<String> =
                points.iter().enumerate().map(|(k, [x, y])| format!("p{k} = [\"{x} m\", \"{y} m\"]")).collect();
            let mass = if body == 0 {
                ""
            } else {
                "mass = \"0.3 kg\"\ninertia = \"1e-4 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n"
            };
            let _ = writeln!(text, "[body.{}]\n{mass}points = {{ {} }}\n", name(body), named.join(", "));
        }
        let guesses: Vec<String> = (2..=self.origins.len()).map(|body| format!("b{body} = \"0 rad\"")).collect();
        text + "[contact.steel]\nlaw = \"flores\"\nrestitution = 0.6\nstiffness = \"9e9 N/m^1.5\"\nexponent = 1.5\n\n"
            + &joints
            + "[drive.crank]\njoint = \"j0\"\nspeed = \"60 rpm\"\nstart_angle = \"0 rad\"\n\n"
            + &format!("[assembly]\nguess = {{ {} }}\n\n", guesses.join(", "))
            + "[cycle]\ndrive = \"crank\"\ntransient_turns = 0\nrecorded_turns = 1\nsamples_per_turn = 36\n\n"
            + &format!("[output.out]\n{output}\n")
    }
}

/// What a joint with play may do.
#[derive(Debug, Clone, Copy)]
pub(super) enum Reach {
    /// |e| <= c.
    Disc(f64),
    /// |x| <= c.
    Line(f64),
    /// No corner of a block beyond the faces: clearance, half-length and half-height.
    Block([f64; 3]),
}

fn clearance_m(random: &mut Random) -> f64 {
    // From 0.02 to 0.6 mm, evenly over the logarithm.
    2e-5 * 30f64.powf(random.between(0.0, 1.0))
}

/// Solves in place and gives the sign of the determinant, 0 where it is singular.
fn solve(matrix: &mut [f64], right: &mut [f64]) -> f64 {
    let n = right.len();
    let mut sign = 1.0;
    for j in 0..n {
        let best = (j..n).max_by(|a, b| matrix[a * n + j].abs().total_cmp(&matrix[b * n + j].abs())).unwrap_or(j);
        if !(matrix[best * n + j].abs() > 1e-12) {
            return 0.0;
        }
        if best != j {
            (0..n).for_each(|k| matrix.swap(j * n + k, best * n + k));
            right.swap(j, best);
            sign = -sign;
        }
        sign *= matrix[j * n + j].signum();
        for i in j + 1..n {
            let factor = matrix[i * n + j] / matrix[j * n + j];
            if factor != 0.0 {
                (j..n).for_each(|k| matrix[i * n + k] -= factor * matrix[j * n + k]);
                right[i] -= factor * right[j];
            }
        }
    }
    for i in (0..n).rev() {
        for k in i + 1..n {
            right[i] -= matrix[i * n + k] * right[k];
        }
        right[i] /= matrix[i * n + i];
    }
    sign
}
