#![allow(missing_docs)]
use loosepin::contact::point_law;
use loosepin::mechanism::*;
use loosepin::model::*;
use loosepin::simulate::*;
struct B(Vec<f64>);
impl B {
    fn q(&mut self, v: f64) -> QuantityId {
        self.0.push(v);
        QuantityId(self.0.len() - 1)
    }
    fn p(&mut self, x: f64, y: f64) -> [QuantityId; 2] {
        [self.q(x), self.q(y)]
    }
}
fn body(b: &mut B, name: &str, m: f64, i: f64, c: (f64, f64), pts: &[(&str, f64, f64)]) -> Body {
    Body {
        name: name.into(),
        mass_kg: Some(b.q(m)),
        inertia_kg_m2: Some(b.q(i)),
        centre_of_mass_m: Some(b.p(c.0, c.1)),
        points: pts.iter().map(|(n, x, y)| Point { name: (*n).into(), position_m: b.p(*x, *y) }).collect(),
    }
}
fn pid(b: usize, p: usize) -> PointId {
    PointId { body: BodyId(b), point: p }
}
struct Print {
    t: f64,
    last: u64,
}
impl Observer for Print {
    fn step(&mut self, _s: &mut Step<'_, '_>) {
        self.last += 1;
    }
    fn contact_begins(&mut self, o: &Onset) {
        if self.t < 4.0 {
            println!("onset {:.6e} v {:.6}", o.time_s, o.speed_m_s);
        }
        self.t += 1.0;
    }
}
struct Cmp {
    slot: usize,
    rows: Vec<Vec<f64>>,
    next: usize,
    dx: f64,
    dv: f64,
    half: f64,
}
impl Observer for Cmp {
    fn step(&mut self, s: &mut Step<'_, '_>) {
        while self.next < self.rows.len() && self.rows[self.next][0] <= s.end_s {
            let r = &self.rows[self.next];
            let d = s.set_state(r[0]);
            let n = r.len();
            let _ = n;
            let p = d.kinematics.poses[self.slot].position_m.x;
            let v = d.kinematics.twists[self.slot].linear.x;
            let e = (p - r[7]).abs();
            self.dx = self.dx.max(e);
            if self.next < self.rows.len() / 2 {
                self.half = self.half.max(e);
            }
            self.dv = self.dv.max((v - r[16]).abs());
            self.next += 1;
        }
    }
}
fn main() {
    let mut b = B(vec![]);
    let g = b.q(9.81);
    let ground = Body {
        name: "ground".into(),
        mass_kg: None,
        inertia_kg_m2: None,
        centre_of_mass_m: None,
        points: vec![Point { name: "o".into(), position_m: b.p(0., 0.) }],
    };
    let crank = body(&mut b, "crank", 0.3, 1e-4, (0.025, 0.), &[("main", 0., 0.), ("pin", 0.05, 0.)]);
    let rod = body(&mut b, "rod", 0.21, 2.5e-4, (0.06, 0.), &[("big", 0., 0.), ("small", 0.12, 0.)]);
    let slider = body(&mut b, "slider", 0.14, 1e-4, (0., 0.), &[("pin", 0., 0.)]);
    let fr = std::env::args().any(|a| a == "friction");
    let contact = Contact {
        name: "steel".into(),
        law: point_law("lankarani-nikravesh").unwrap(),
        restitution: b.q(0.9),
        stiffness: Stiffness::Material { youngs_modulus_pa: b.p(207e9, 207e9), poisson_ratio: b.p(0.3, 0.3) },
        minimum_impact_speed_m_s: b.q(1e-3),
        density_kg_m3: None,
        friction: if fr {
            Some(Friction {
                law: FrictionLaw::Ambrosio,
                coefficient: b.q(0.03),
                lower_speed_m_s: b.q(1e-4),
                upper_speed_m_s: b.q(1e-3),
                sliding_velocity: SlidingVelocity::Material,
            })
        } else {
            None
        },
    };
    let joints = vec![
        Joint {
            name: "main".into(),
            kind: JointKind::Revolute { bearing: pid(0, 0), journal: pid(1, 0), clearance: None },
        },
        Joint {
            name: "crankpin".into(),
            kind: JointKind::Revolute { bearing: pid(1, 1), journal: pid(2, 0), clearance: None },
        },
        Joint {
            name: "gudgeon".into(),
            kind: JointKind::Revolute {
                bearing: pid(2, 1),
                journal: pid(3, 0),
                clearance: Some(Clearance {
                    bearing_radius_m: b.q(0.01),
                    radial_clearance_m: b.q(0.0005),
                    contact: ContactId(0),
                }),
            },
        },
        Joint {
            name: "guide".into(),
            kind: JointKind::Prismatic {
                guide: pid(0, 0),
                guide_angle_rad: b.q(0.),
                slider: pid(3, 0),
                slider_angle_rad: b.q(0.),
            },
        },
    ];
    let w = 5000.0 * std::f64::consts::TAU / 60.0;
    let drives = vec![Drive { name: "crank".into(), joint: JointId(0), speed: b.q(w), start: b.q(0.) }];
    let model = Model {
        name: "sc".into(),
        quantities: QuantityTable::default(),
        gravity_m_s2: g,
        bodies: vec![ground, crank, rod, slider],
        contacts: vec![contact],
        joints,
        drives,
        guesses: vec![],
        cycle: Cycle { drive: DriveId(0), transient_turns: 0., recorded_turns: 2., samples_per_turn: 500 },
        outputs: vec![],
    };
    let values = Values(b.0.clone());
    let m = Mechanism::new(&model, &values).unwrap();
    println!(
        "dof {} redundant {:?} other {:?} size {}",
        m.degrees_of_freedom, m.redundant, m.other_assemblies_rad, m.size_m
    );
    let s = Sample::<f64>::new(&m, &values).unwrap();
    let mut set = Settings::for_simulation();
    let r = run(&m, &s, &Window { start_s: 0., end_s: 0.024 }, &set, &mut Print { t: 0., last: 0 }).unwrap();
    println!("{r:?} rel {:e}", r.energy.unwrap().relative_residual());
    let text = std::fs::read_to_string("/work/shared/reference/slider_crank_5000.csv").unwrap();
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|l| l.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    for tol in [1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11] {
        for method in [&loosepin::integrate::DOP853, &loosepin::integrate::DORMAND_PRINCE_5] {
            set.tolerance_m = tol;
            set.method = method;
            let mut c = Cmp { slot: m.real.slot_of_body[3], rows: rows.clone(), next: 0, dx: 0., dv: 0., half: 0. };
            let r = run(&m, &s, &Window { start_s: 0., end_s: 0.012 }, &set, &mut c);
            let t0 = std::time::Instant::now();
            let reps = 50;
            let mut ev = 0;
            for _ in 0..reps {
                let r =
                    run(&m, &s, &Window { start_s: 0.012, end_s: 0.012 }, &set, &mut Print { t: 9., last: 0 }).unwrap();
                ev = r.counters.evaluations;
            }
            let dt = t0.elapsed().as_secs_f64() / reps as f64;
            match r {
                Ok(r) => println!(
                    "{} tol {tol:e} n {} dx {:e} half {:e} dv {:e} evals {} rej {} steps {} ev {} res {:e} | {:.3} ms {:.1} ns/rhs ({ev})",
                    method.name,
                    c.next,
                    c.dx,
                    c.half,
                    c.dv,
                    r.counters.evaluations,
                    r.counters.rejections,
                    r.counters.steps,
                    r.counters.events,
                    r.energy.unwrap().relative_residual(),
                    dt * 1e3,
                    dt * 1e9 / ev as f64
                ),
                Err(e) => println!("{e}"),
            }
        }
    }
}
