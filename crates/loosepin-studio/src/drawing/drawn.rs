//! A mechanism that is drawn from nothing: pins and links become a model and a study of it.
//!
//! What a drawing does not say is a first guess, and is marked so in the text: masses of steel bars, the speed of the motor, a
//! tolerance of each length. A length is a parameter, so that it can be dragged, varied and asked about.

use std::fmt::Write as _;

use loosepin::diagnostics::Source;
use loosepin::report::motion_sentences;
use loosepin::study::{InputFile, Study, plan_runs};
use loosepin::units::format_number;
use serde::Deserialize;

use crate::network::refusal::Refusal;

/// Most pins and most links of a drawing.
const MOST: usize = 50;
/// Largest coordinate of a drawing, mm.
const FURTHEST_MM: f64 = 1e7;
/// Two pins nearer to each other are one, mm.
const NEAREST_MM: f64 = 1e-3;
/// Steel bar of 20 mm x 8 mm: 7850 kg/m^3 times its section.
const BAR_KG_PER_M: &str = "1.256 kg/m";
const BLOCK_KG: f64 = 0.2;
/// Inertia of a block, as of a body of a few centimetres.
const BLOCK_KG_M2: &str = "5e-5 kg m^2";
const TOLERANCE_MM: &str = "0.1";
const POSITIONS: usize = 73;

/// Support of a pin.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Hold {
    /// Links alone.
    Free,
    /// The ground.
    Ground,
    /// A block in a guide of the ground, at an angle from the horizontal.
    Slider {
        /// Degrees.
        angle_deg: f64,
    },
}

/// A pin.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct DrawnPin {
    /// To the right, mm.
    pub x: f64,
    /// Upwards, mm.
    pub y: f64,
    /// Its support.
    pub hold: Hold,
}

/// A drawing.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Drawn {
    /// Name of the mechanism.
    pub name: String,
    /// Its pins.
    pub pins: Vec<DrawnPin>,
    /// The pins of each link: two of a bar, more of a plate.
    pub links: Vec<Vec<usize>>,
    /// The pin on the ground at which the motor turns a link.
    pub motor: Option<usize>,
}

/// Both texts, and what the library says of them.
#[derive(Debug)]
pub struct DrawnTexts {
    /// Text of the model.
    pub model: String,
    /// Text of the study.
    pub study: String,
    /// Degrees of freedom, in words; or what is wrong, where it cannot move yet.
    pub says: Result<Vec<String>, Vec<String>>,
}

impl Drawn {
    /// The texts.
    ///
    /// # Errors
    /// The drawing is none, in words.
    pub fn texts(&self) -> Result<DrawnTexts, Refusal> {
        self.check()?;
        let (model, study) = (self.model(), self.study());
        let says = says(&model, &study);
        Ok(DrawnTexts { model, study, says })
    }

    fn check(&self) -> Result<(), Refusal> {
        if self.pins.len() > MOST || self.links.len() > MOST {
            return Err(Refusal::bad(format!("a drawing has at most {MOST} pins and {MOST} links")));
        }
        let is_near = |value: f64| value.is_finite() && value.abs() <= FURTHEST_MM;
        let angle = |hold| if let Hold::Slider { angle_deg } = hold { angle_deg } else { 0.0 };
        if !self.pins.iter().all(|pin| is_near(pin.x) && is_near(pin.y) && is_near(angle(pin.hold))) {
            return Err(Refusal::bad("a pin is further away than 10 km"));
        }
        if self.links.is_empty() {
            return Err(Refusal::bad("there is no link yet").with_hint("click two places for the ends of a link"));
        }
        if self.name.chars().any(char::is_control) || self.name.trim().is_empty() {
            return Err(Refusal::bad("the name of a mechanism must be on one line"));
        }
        for (place, link) in self.links.iter().enumerate() {
            let is_other = |other: &Vec<usize>| other.iter().filter(|pin| link.contains(pin)).count() < 2;
            if !self.links[..place].iter().all(is_other) {
                return Err(Refusal::bad("two links share two pins: they are one rigid link")
                    .with_hint("delete one of them, or make a plate of both"));
            }
            let is_there = link.iter().all(|pin| *pin < self.pins.len());
            let is_once = (1..link.len()).all(|place| !link[..place].contains(&link[place]));
            if link.len() < 2 || !is_there || !is_once {
                return Err(Refusal::bad("a link has two pins or more, each once"));
            }
            let first = self.pins[link[0]];
            if link[1..].iter().any(|pin| (self.pins[*pin].x - first.x).hypot(self.pins[*pin].y - first.y) < NEAREST_MM)
            {
                return Err(
                    Refusal::bad("two pins of one link are at the same place").with_hint("drag one of them away")
                );
            }
        }
        let motor = self.motor.ok_or_else(|| {
            Refusal::bad("it has no motor yet").with_hint("choose Motor, and click a pin on the ground with one link")
        })?;
        let is_on_ground = self.pins.get(motor).is_some_and(|pin| pin.hold == Hold::Ground);
        if !is_on_ground || self.at(motor).count() != 1 {
            return Err(Refusal::bad("the motor is not at a pin on the ground with one link")
                .with_hint("choose Motor, and click such a pin"));
        }
        if self.outputs().is_empty() {
            return Err(Refusal::bad("the drawing has no output to study")
                .with_hint("draw a slider, a second link on the ground, or a pin with only one link"));
        }
        Ok(())
    }

    /// The links at a pin.
    fn at(&self, pin: usize) -> impl Iterator<Item = usize> {
        (0..self.links.len()).filter(move |link| self.links[*link].contains(&pin))
    }

    /// The pins of a link: first the one at its origin, on the ground where it has one.
    fn ordered(&self, link: usize) -> Vec<usize> {
        let mut pins = self.links[link].clone();
        if let Some(place) = pins.iter().position(|pin| self.pins[*pin].hold == Hold::Ground) {
            pins.swap(0, place);
        }
        pins
    }

    fn link_name(&self, link: usize) -> String {
        let has = |pin: usize| self.links[link].contains(&pin);
        if self.motor.is_some_and(has) { "crank".to_owned() } else { format!("link_{}", link + 1) }
    }

    fn pin_name(pin: usize) -> String {
        format!("p{}", pin + 1)
    }

    /// Length and direction of a link, from its first pin to its second: mm and degrees.
    fn direction(&self, link: usize) -> (f64, f64) {
        let pins = self.ordered(link);
        let [first, second] = [self.pins[pins[0]], self.pins[pins[1]]];
        let (x, y) = (second.x - first.x, second.y - first.y);
        (x.hypot(y), y.atan2(x).to_degrees())
    }

    /// Name, text in the model, and name in questions.
    fn outputs(&self) -> Vec<(String, String)> {
        let mut outputs = Vec::new();
        for (pin, drawn) in self.pins.iter().enumerate() {
            let name = Self::pin_name(pin);
            let links = self.at(pin).count();
            if let (Hold::Slider { angle_deg }, 1..) = (drawn.hold, links) {
                let axis = if angle_deg.to_radians().sin().abs() > std::f64::consts::FRAC_1_SQRT_2 { "y" } else { "x" };
                outputs.push((
                    format!("slider_{name}"),
                    format!("position_of = \"block_{name}.pin\"\nalong = \"{axis}\""),
                ));
            } else if drawn.hold == Hold::Free && links == 1 {
                let link = self.at(pin).map(|link| self.link_name(link)).collect::<String>();
                outputs.push((format!("path_{name}"), format!("position_of = \"{link}.{name}\"\nalong = \"x\"")));
            }
        }
        for link in 0..self.links.len() {
            let name = self.link_name(link);
            let on_ground = self.links[link].iter().any(|pin| self.pins[*pin].hold == Hold::Ground);
            if on_ground && name != "crank" {
                outputs.push((format!("angle_{name}"), format!("angle_of = \"{name}\"")));
            }
        }
        outputs
    }

    fn model(&self) -> String {
        let mut text = String::new();
        let quoted = serde_json::to_string(self.name.trim()).unwrap_or_default();
        let mm = |value: f64| format_number((value * 1e3).round() / 1e3 + 0.0);
        // Writing into a text does not fail.
        let _ = write!(
            text,
            "# Drawn in the studio. What the drawing does not say is marked as a first guess.\nname = {quoted}\n"
        );
        text.push_str("gravity = \"9.81 m/s^2\"  # along -y; \"0 m/s^2\" for none\n\n[parameter]\n");
        for link in 0..self.links.len() {
            let _ = writeln!(text, "{}_length = \"{} mm\"", self.link_name(link), mm(self.direction(link).0));
        }
        text.push_str("\n[body.ground.points]\n");
        for (pin, drawn) in self.pins.iter().enumerate().filter(|(_, pin)| pin.hold != Hold::Free) {
            let _ = writeln!(text, "{} = [\"{} mm\", \"{} mm\"]", Self::pin_name(pin), mm(drawn.x), mm(drawn.y));
        }
        for link in 0..self.links.len() {
            let (name, pins) = (self.link_name(link), self.ordered(link));
            let (_, angle_deg) = self.direction(link);
            let _ = write!(
                text,
                "\n[body.{name}]  # first guess: a steel bar of 20 mm x 8 mm\nmass = \"{BAR_KG_PER_M} * {name}_length\"\n\
                 inertia = \"{BAR_KG_PER_M} * {name}_length^3 / 12\"\ncentre_of_mass = [\"{name}_length / 2\", \"0 mm\"]\n\
                 [body.{name}.points]\n"
            );
            let (sine, cosine) = angle_deg.to_radians().sin_cos();
            let origin = self.pins[pins[0]];
            for (place, pin) in pins.iter().enumerate() {
                let (x, y) = (self.pins[*pin].x - origin.x, self.pins[*pin].y - origin.y);
                let (along, aside) = (cosine * x + sine * y, cosine * y - sine * x);
                let position = match place {
                    0 => "[\"0 mm\", \"0 mm\"]".to_owned(),
                    1 => format!("[\"{name}_length\", \"0 mm\"]"),
                    _ => format!("[\"{} mm\", \"{} mm\"]", mm(along), mm(aside)),
                };
                let _ = writeln!(text, "{} = {position}", Self::pin_name(*pin));
            }
        }
        for (pin, _) in self.pins.iter().enumerate().filter(|(_, pin)| matches!(pin.hold, Hold::Slider { .. })) {
            let _ = write!(
                text,
                "\n[body.block_{}]  # first guess\nmass = \"{BLOCK_KG} kg\"\ninertia = \"{BLOCK_KG_M2}\"\n\
                 centre_of_mass = [\"0 mm\", \"0 mm\"]\npoints = {{ pin = [\"0 mm\", \"0 mm\"] }}\n",
                Self::pin_name(pin)
            );
        }
        self.joints(&mut text);
        let start_deg =
            (0..self.links.len()).find(|link| self.link_name(*link) == "crank").map(|link| self.direction(link).1);
        let motor = self.motor.map(Self::pin_name).unwrap_or_default();
        let _ = write!(
            text,
            "\n[drive.motor]\njoint = \"{motor}\"\nspeed = \"60 rpm\"  # first guess\nstart_angle = \"{} deg\"\n\n\
             [assembly]  # as it was drawn\nguess = {{ {} }}\n\n[cycle]\ndrive = \"motor\"\ntransient_turns = 1\nrecorded_turns = 1\n\
             samples_per_turn = 180\n",
            degrees(start_deg.unwrap_or(0.0)),
            (0..self.links.len())
                .filter(|link| self.link_name(*link) != "crank")
                .map(|link| format!("{} = \"{} deg\"", self.link_name(link), degrees(self.direction(link).1)))
                .collect::<Vec<_>>()
                .join(", ")
        );
        for (name, lines) in self.outputs() {
            let _ = write!(text, "\n[output.{name}]\n{lines}\n");
        }
        text
    }

    fn joints(&self, text: &mut String) {
        for (pin, drawn) in self.pins.iter().enumerate() {
            let name = Self::pin_name(pin);
            let mut ends: Vec<String> = self.at(pin).map(|link| format!("{}.{name}", self.link_name(link))).collect();
            match drawn.hold {
                Hold::Free => {}
                Hold::Ground => ends.insert(0, format!("ground.{name}")),
                Hold::Slider { angle_deg } => {
                    let _ = write!(
                        text,
                        "\n[joint.guide_{name}]\nkind = \"prismatic\"\nguide = {{ point = \"ground.{name}\", angle = \"{} deg\" }}\n\
                         slider = \"block_{name}.pin\"\n",
                        degrees(angle_deg)
                    );
                    ends.push(format!("block_{name}.pin"));
                }
            }
            let Some((bearing, journals)) = ends.split_first() else { continue };
            for (place, journal) in journals.iter().enumerate() {
                let number = if journals.len() > 1 { format!("_{}", place + 1) } else { String::new() };
                let _ = write!(
                    text,
                    "\n[joint.{name}{number}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n"
                );
            }
        }
    }

    fn study(&self) -> String {
        let quoted = serde_json::to_string(self.name.trim()).unwrap_or_default();
        let mut text = format!(
            "# How far does it stray when its lengths scatter? Click a pin in the studio to give it play.\nname = {quoted}\n\
             model = \"model.toml\"\nseed = 1\n\n[sampling]\nouter = 16\ninner = 256\n\n\
             [random]  # first guesses\n"
        );
        for link in 0..self.links.len() {
            let mm = format_number((self.direction(link).0 * 1e3).round() / 1e3);
            let _ = writeln!(
                text,
                "\"parameter.{}_length\" = {{ tolerance = \"{mm} ± {TOLERANCE_MM} mm\" }}",
                self.link_name(link)
            );
        }
        for (name, _) in self.outputs() {
            let _ = write!(
                text,
                "\n[[ask]]\noutput = \"{name}\"\nof = \"total\"\nat = \"cycle\"\n\
                 statistics = [\"mean\", {{ quantile = 0.025 }}, {{ quantile = 0.975 }}]\n"
            );
        }
        text
    }
}

/// Tenths of a millidegree are finer than any drawing.
fn degrees(angle: f64) -> String {
    format_number((angle * 1e4).round() / 1e4 + 0.0)
}

/// Freedom in words, or what is wrong.
fn says(model: &str, study: &str) -> Result<Vec<String>, Vec<String>> {
    let words = |diagnostics: loosepin::diagnostics::Diagnostics| {
        diagnostics
            .sorted()
            .into_iter()
            .map(|diagnostic| {
                let hint = diagnostic.hint.as_ref().map(|hint| format!(": {hint}")).unwrap_or_default();
                format!("{}{hint}", diagnostic.message)
            })
            .collect::<Vec<_>>()
    };
    let model = loosepin::model::Model::from_source(Source::new("model.toml", model)).map_err(words)?;
    let source = Source::new("study.toml", study);
    let study = Study::of_model(&source, model, std::path::Path::new("model.toml")).map_err(words)?;
    let planned = plan_runs(&study).map_err(|error| error.diagnostic(&study));
    let record = InputFile::Study(Box::new(study)).ideal_motion(POSITIONS, &[]).map_err(words)?;
    let refused = planned.err().map(|diagnostic| format!("The study cannot run yet: {}", diagnostic.message));
    Ok(std::iter::once(record.mobility.clone()).chain(refused).chain(motion_sentences(&record)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pin(x: f64, y: f64, hold: Hold) -> DrawnPin {
        DrawnPin { x, y, hold }
    }

    fn four_bar() -> Drawn {
        let pins = vec![
            pin(0.0, 0.0, Hold::Ground),
            pin(30.0, 70.0, Hold::Free),
            pin(240.0, 150.0, Hold::Free),
            pin(300.0, 0.0, Hold::Ground),
        ];
        Drawn { name: "drawn".into(), pins, links: vec![vec![0, 1], vec![1, 2], vec![2, 3]], motor: Some(0) }
    }

    #[test]
    fn a_drawn_four_bar_moves_and_passes_through_its_drawing() {
        let texts = four_bar().texts().unwrap();
        let says = texts.says.as_ref().unwrap_or_else(|wrong| panic!("{wrong:?}\n{}", texts.model));
        assert!(says[0].contains("1 degree of freedom"), "{says:?}");
        let model = loosepin::model::Model::from_text("model.toml", &texts.model).unwrap();
        let record = InputFile::Model(Box::new(model)).ideal_motion(361, &[]).unwrap();
        // The first pose is the drawn one: the pin between coupler and rocker.
        let table = &record.drawing.poses;
        let body = record.drawing.bodies.iter().position(|body| body.name == "link_3").unwrap();
        let (sine, cosine) = table.angle_rad[body][0].sin_cos();
        let length_m = 1e-3 * 60.0_f64.hypot(150.0);
        let found = [table.x_m[body][0] + cosine * length_m, table.y_m[body][0] + sine * length_m];
        assert!((found[0] - 0.240).abs() < 2e-6 && (found[1] - 0.150).abs() < 2e-6, "{found:?}");
    }

    #[test]
    fn sliders_plates_and_shared_pins_are_drawn() {
        let slider = Drawn {
            name: "slider \"crank\"".into(),
            pins: vec![
                pin(0.0, 0.0, Hold::Ground),
                pin(30.0, 40.0, Hold::Free),
                pin(180.0, 0.0, Hold::Slider { angle_deg: 0.0 }),
                pin(90.0, 60.0, Hold::Free),
            ],
            links: vec![vec![0, 1], vec![1, 2, 3]],
            motor: Some(0),
        };
        let texts = slider.texts().unwrap();
        let says = texts.says.as_ref().unwrap_or_else(|wrong| panic!("{wrong:?}\n{}", texts.model));
        assert!(says[0].contains("1 degree of freedom"), "{says:?}");
        for output in ["[output.slider_p3]", "[output.path_p4]"] {
            assert!(texts.model.contains(output), "{}", texts.model);
        }
        // Two couplers at the crank's pin: two joints there.
        let mut two = four_bar();
        two.pins.extend([pin(200.0, -120.0, Hold::Free), pin(330.0, -200.0, Hold::Ground)]);
        two.links.extend([vec![1, 4], vec![4, 5]]);
        let texts = two.texts().unwrap();
        assert!(texts.says.is_ok(), "{:?}\n{}", texts.says, texts.model);
        assert!(texts.model.contains("[joint.p2_1]") && texts.model.contains("[joint.p2_2]"));
    }

    #[test]
    fn an_unfinished_drawing_says_what_is_missing() {
        let wrong = |change: fn(&mut Drawn)| {
            let mut drawn = four_bar();
            change(&mut drawn);
            match drawn.texts() {
                Err(refusal) => refusal.message,
                Ok(texts) => texts.says.expect_err("it cannot move").join(" "),
            }
        };
        assert!(wrong(|drawn| drawn.motor = None).contains("it has no motor yet"));
        assert!(wrong(|drawn| drawn.motor = Some(1)).contains("not at a pin on the ground"));
        assert!(wrong(|drawn| drawn.links.clear()).contains("no link yet"));
        assert!(wrong(|drawn| drawn.links[0] = vec![0, 0]).contains("each once"));
        assert!(wrong(|drawn| drawn.links.push(vec![2, 1])).contains("share two pins"));
        assert!(wrong(|drawn| drawn.name = "a\u{7f}".into()).contains("must be on one line"));
        assert!(wrong(|drawn| drawn.links[0] = vec![0, 9]).contains("two pins or more"));
        assert!(wrong(|drawn| drawn.pins[1].x = f64::INFINITY).contains("further away"));
        assert!(wrong(|drawn| drawn.pins[1] = drawn.pins[0]).contains("at the same place"));
        // A loop too many or too few.
        assert!(wrong(|drawn| drawn.links.push(vec![0, 2])).len() > 20);
        assert!(wrong(|drawn| drawn.pins[3].hold = Hold::Free).len() > 20);
    }
}
