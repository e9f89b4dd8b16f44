//! Names in a drawn mechanism: flags of outputs, names of drives and of joints with play, each where it hides least over all poses.

use maud::{Markup, html};

use crate::mechanism::shapes::{
    BLOCK_PINS, Frame, HATCH_DEPTH_PINS, RAIL_PINS, fixed_rails, has_rails, hull_mm, point_mm, support_points,
    transformed_mm,
};
use crate::mechanism::signs::{ARROW_PINS, drive_sign};
use loosepin_result::simulation::{Drawing, DrawnPin, PoseTable};

/// Poses at which places are compared.
const MAX_POSES: usize = 48;
/// Width of a letter and height of a line, as shares of the font's size: means of common fonts.
const LETTER: [f64; 2] = [0.56, 1.0];
/// Letters of a name in a picture; the whole name is its title.
const MAX_LETTERS: usize = 24;
/// A name that hides another one in more of the poses is left out.
const MAX_HIDDEN_SHARE: f64 = 0.1;
/// Heights of a flag, in pins.
const POLE_PINS: [f64; 2] = [7.0, 10.0];
/// Length and height of a pennant, in pins.
const PENNANT_PINS: [f64; 2] = [2.6, 1.9];
/// What a name costs where it hides a pin, leaves the frame, or hides another name; a hidden bar costs 1.
const COSTS: [f64; 3] = [3.0, 0.5, 100.0];

/// What a label names.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Output,
    Drive,
    Play,
}

/// A name that moves with a point of a body and stays upright.
pub(crate) struct Label {
    kind: Kind,
    text: String,
    /// The body, and the point in its frame, mm.
    pub body: usize,
    pub at_mm: (f64, f64),
    place: LabelPosition,
}

/// Position of a text beside its point: one end of its base line, and whether that is its right or left end or its middle.
#[derive(Clone, Copy)]
struct LabelPosition {
    x: f64,
    y: f64,
    anchor: &'static str,
    /// End of the pole of a flag.
    pole: f64,
}

/// A rectangle in the plane, y up.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Area {
    left: f64,
    right: f64,
    low: f64,
    high: f64,
}

impl Area {
    fn moved(self, (x, y): (f64, f64)) -> Self {
        Area { left: self.left + x, right: self.right + x, low: self.low + y, high: self.high + y }
    }

    fn meets(self, other: Self) -> bool {
        self.left < other.right && other.left < self.right && self.low < other.high && other.low < self.high
    }

    fn holds(self, (x, y): (f64, f64)) -> bool {
        self.left < x && x < self.right && self.low < y && y < self.high
    }

    /// Whether any of the line from `a` to `b` lies in it (Liang and Barsky's clipping).
    fn is_crossed(self, a: (f64, f64), b: (f64, f64)) -> bool {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let sides = [(b.0 - a.0, self.left - a.0, self.right - a.0), (b.1 - a.1, self.low - a.1, self.high - a.1)];
        for (change, near, far) in sides {
            if change == 0.0 {
                if near > 0.0 || far < 0.0 {
                    return false;
                }
                continue;
            }
            let (one, other) = (near / change, far / change);
            from = from.max(one.min(other));
            to = to.min(one.max(other));
        }
        from < to
    }

    fn of_frame(frame: &Frame) -> Self {
        Area { left: frame.left, right: frame.left + frame.width, low: -frame.top - frame.height, high: -frame.top }
    }
}

/// Sizes in which labels are set.
#[derive(Clone, Copy)]
pub(crate) struct Sizes {
    pub pin: f64,
    pub font_mm: f64,
}

/// All names of the picture that have room.
pub(crate) fn labels(drawing: &Drawing, poses: &PoseTable, frame: &Frame, sizes: Sizes) -> Vec<Label> {
    let scene = Scene::new(drawing, poses, frame, sizes);
    let mut wanted: Vec<Label> = Vec::new();
    let blank = LabelPosition { x: 0.0, y: 0.0, anchor: "start", pole: 0.0 };
    for output in &drawing.output_points {
        let Some(at_mm) = point_mm(drawing, output.point) else { continue };
        let body = output.point.body;
        // Both coordinates of a point have one flag.
        if let Some(label) = wanted.iter_mut().find(|label| label.body == body && label.at_mm == at_mm) {
            label.text = format!("{}, {}", label.text, output.name);
        } else {
            wanted.push(Label { kind: Kind::Output, text: output.name.clone(), body, at_mm, place: blank });
        }
    }
    for drive in &drawing.drives {
        let Some(sign) = drive_sign(drawing, drive, poses, sizes.pin) else { continue };
        let (body, at_mm) = sign.place();
        if body < drawing.bodies.len() {
            wanted.push(Label { kind: Kind::Drive, text: drive.name.clone(), body, at_mm, place: blank });
        }
    }
    for joint in drawing.joints.iter().filter(|joint| joint.kind.pin() == Some(DrawnPin::InBearing)) {
        if let Some(at_mm) = point_mm(drawing, joint.first) {
            let body = joint.first.body;
            wanted.push(Label { kind: Kind::Play, text: joint.name.clone(), body, at_mm, place: blank });
        }
    }
    let mut placed: Vec<Label> = Vec::new();
    for mut label in wanted {
        let costs = label.places(sizes).into_iter().map(|place| (scene.cost(&label, place, &placed), place));
        let Some(((_, hidden), place)) = costs.min_by(|a, b| a.0.0.total_cmp(&b.0.0)) else { continue };
        if hidden <= MAX_HIDDEN_SHARE * scene.poses.len() as f64 {
            label.place = place;
            placed.push(label);
        }
    }
    placed
}

/// The frame, as large as the labels need it in all poses; `points` has where the point of a label is at each of them.
pub(crate) fn frame_with(
    labels: &[Label],
    points: impl Fn(&Label) -> Vec<(f64, f64)>,
    frame: &Frame,
    sizes: Sizes,
) -> Frame {
    let mut all = Area::of_frame(frame);
    for label in labels {
        let area = label.area(label.place, sizes);
        for point in points(label) {
            let area = area.moved(point);
            all.left = all.left.min(area.left - 0.5 * sizes.font_mm);
            all.right = all.right.max(area.right + 0.5 * sizes.font_mm);
            all.low = all.low.min(area.low - 0.3 * sizes.font_mm);
            all.high = all.high.max(area.high + 0.3 * sizes.font_mm);
        }
    }
    Frame { left: all.left, top: -all.high, width: all.right - all.left, height: all.high - all.low }
}

impl Label {
    /// Whether it is the flag of an output.
    pub fn is_output(&self) -> bool {
        self.kind == Kind::Output
    }

    fn places(&self, sizes: Sizes) -> Vec<LabelPosition> {
        let Sizes { pin, font_mm } = sizes;
        let place = |x: f64, y: f64, anchor| LabelPosition { x, y, anchor, pole: 0.0 };
        let around = |distance: f64| {
            let (middle, corner) = (-0.35 * font_mm, 0.75 * distance);
            [
                place(0.0, distance + 0.2 * font_mm, "middle"),
                place(corner, corner, "start"),
                place(-corner, corner, "end"),
                place(distance, middle, "start"),
                place(-distance, middle, "end"),
                place(0.0, -distance - 0.8 * font_mm, "middle"),
                place(corner, -corner - 0.8 * font_mm, "start"),
                place(-corner, -corner - 0.8 * font_mm, "end"),
            ]
        };
        match self.kind {
            Kind::Output => {
                let mut places = Vec::new();
                for height in POLE_PINS {
                    for (side, anchor) in [(1.0, "start"), (-1.0, "end")] {
                        for up in [1.0, -1.0] {
                            let pole = up * height * pin;
                            let y = pole - up * 0.5 * PENNANT_PINS[1] * pin - 0.35 * font_mm;
                            places.push(LabelPosition { x: side * (PENNANT_PINS[0] + 0.6) * pin, y, anchor, pole });
                        }
                    }
                }
                places
            }
            Kind::Drive => around((ARROW_PINS + 1.0) * pin).to_vec(),
            Kind::Play => {
                [around((BLOCK_PINS[1] + 0.8) * pin), around((RAIL_PINS + HATCH_DEPTH_PINS + 0.8) * pin)].concat()
            }
        }
    }

    /// What it covers, from its point.
    fn area(&self, place: LabelPosition, sizes: Sizes) -> Area {
        let width = LETTER[0] * sizes.font_mm * self.shown().chars().count() as f64;
        let left = match place.anchor {
            "start" => place.x,
            "end" => place.x - width,
            _ => place.x - 0.5 * width,
        };
        let low = place.y - 0.25 * LETTER[1] * sizes.font_mm;
        let text = Area { left, right: left + width, low, high: low + LETTER[1] * sizes.font_mm };
        // A flag covers its pennant too.
        if place.pole == 0.0 { text } else { Area { left: text.left.min(0.0), right: text.right.max(0.0), ..text } }
    }

    /// Its text, and its pole where it has one, from its point.
    fn areas(&self, sizes: Sizes) -> [Area; 2] {
        let text = self.area(self.place, sizes);
        let half = 0.5 * sizes.pin;
        let pole = Area { left: -half, right: half, low: self.place.pole.min(0.0), high: self.place.pole.max(0.0) };
        [text, if self.place.pole == 0.0 { text } else { pole }]
    }

    fn shown(&self) -> String {
        if self.text.chars().count() <= MAX_LETTERS {
            return self.text.clone();
        }
        let kept: String = self.text.chars().take(MAX_LETTERS - 1).collect();
        format!("{kept}…")
    }

    /// The label around its point, y up.
    pub fn drawn(&self, sizes: Sizes) -> Markup {
        let LabelPosition { x, y, anchor, pole } = self.place;
        let class = match self.kind {
            Kind::Output => "output",
            Kind::Drive => "of-drive",
            Kind::Play => "play-of",
        };
        let [length, height] = PENNANT_PINS.map(|pins| pins * sizes.pin);
        html! {
            g class=(class) {
                title { (self.words()) }
                @if self.kind == Kind::Output {
                    path.pole d=(format!("M0 0V{pole:.3}")) {}
                    path.pennant d=(format!(
                        "M0 {pole:.3}L{:.3} {:.3}L0 {:.3}Z",
                        length.copysign(x), pole - (0.5 * height).copysign(pole), pole - height.copysign(pole)
                    )) {}
                }
                text transform="scale(1 -1)" x=(format!("{x:.3}")) y=(format!("{:.3}", -y)) text-anchor=(anchor) { (self.shown()) }
            }
        }
    }

    fn words(&self) -> String {
        let what = match self.kind {
            Kind::Output => "output",
            Kind::Drive => "drive",
            Kind::Play => "play of",
        };
        format!("{what} {}", self.text)
    }
}

/// What a label may hide.
struct Scene<'a> {
    table: &'a PoseTable,
    poses: Vec<usize>,
    sizes: Sizes,
    frame: Area,
    supports: Vec<Area>,
    rails: Vec<[(f64, f64); 2]>,
    /// Bars and pins by pose.
    bars: Vec<Vec<[(f64, f64); 2]>>,
    pins: Vec<Vec<(f64, f64)>>,
}

impl<'a> Scene<'a> {
    fn new(drawing: &Drawing, table: &'a PoseTable, frame: &Frame, sizes: Sizes) -> Self {
        let count = table.drive_angle_rad.len();
        let poses: Vec<usize> = (0..count).step_by(count.div_ceil(MAX_POSES).max(1)).collect();
        let pin = sizes.pin;
        let supports = support_points(drawing)
            .map(|(x, y)| Area {
                left: x - 3.2 * pin,
                right: x + 3.2 * pin,
                low: y - (3.4 + HATCH_DEPTH_PINS) * pin,
                high: y + pin,
            })
            .collect();
        let rails = drawing
            .joints
            .iter()
            .filter(|joint| has_rails(joint))
            .flat_map(|joint| {
                [RAIL_PINS, RAIL_PINS + HATCH_DEPTH_PINS]
                    .into_iter()
                    .flat_map(|side| fixed_rails(drawing, joint, table, frame, side * pin))
                    .collect::<Vec<_>>()
            })
            .collect();
        let (mut bars, mut pins) = (Vec::new(), Vec::new());
        for &pose in &poses {
            let (mut lines, mut points) = (Vec::new(), Vec::new());
            for (index, body) in drawing.bodies.iter().enumerate() {
                let at = |point: (f64, f64)| transformed_mm(table, index, pose, point);
                points.extend((0..body.points.len()).filter_map(|point| {
                    point_mm(drawing, loosepin_result::simulation::PointReference { body: index, point }).map(at)
                }));
                let hull: Vec<(f64, f64)> = if body.is_ground { Vec::new() } else { hull_mm(body) };
                lines.extend((1..hull.len()).map(|corner| [at(hull[corner - 1]), at(hull[corner])]));
                if let (3.., Some(first), Some(last)) = (hull.len(), hull.first(), hull.last()) {
                    lines.push([at(*last), at(*first)]);
                }
            }
            bars.push(lines);
            pins.push(points);
        }
        Self { table, poses, sizes, frame: Area::of_frame(frame), supports, rails, bars, pins }
    }

    /// What a label at a place costs over all poses, and at how many of them it hides another one.
    fn cost(&self, label: &Label, place: LabelPosition, placed: &[Label]) -> (f64, f64) {
        let own = label.area(place, self.sizes);
        let (mut cost, mut hidden) = (0.0, 0.0);
        for (index, &pose) in self.poses.iter().enumerate() {
            let area = own.moved(transformed_mm(self.table, label.body, pose, label.at_mm));
            let crossed =
                |lines: &[[(f64, f64); 2]]| lines.iter().filter(|[a, b]| area.is_crossed(*a, *b)).count() as f64;
            cost += crossed(&self.bars[index]) + crossed(&self.rails);
            cost += self.supports.iter().filter(|support| support.meets(area)).count() as f64;
            cost += COSTS[0] * self.pins[index].iter().filter(|point| area.holds(**point)).count() as f64;
            let is_inside = area.left >= self.frame.left
                && area.right <= self.frame.right
                && area.low >= self.frame.low
                && area.high <= self.frame.high;
            cost += if is_inside { 0.0 } else { COSTS[1] };
            let is_over = placed.iter().any(|other| {
                let at = transformed_mm(self.table, other.body, pose, other.at_mm);
                other.areas(self.sizes).into_iter().any(|covered| covered.moved(at).meets(area))
            });
            if is_over {
                cost += COSTS[2];
                hidden += 1.0;
            }
        }
        (cost, hidden)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_lines_through_beside_and_within_an_area() {
        let area = Area { left: 1.0, right: 3.0, low: 2.0, high: 5.0 };
        assert!(area.is_crossed((0.0, 3.0), (4.0, 4.0)));
        assert!(area.is_crossed((2.0, 3.0), (2.5, 3.1)), "one that lies within");
        assert!(area.is_crossed((2.0, 0.0), (2.0, 9.0)), "an upright one");
        assert!(!area.is_crossed((0.0, 0.0), (0.9, 9.0)));
        assert!(!area.is_crossed((0.0, 6.0), (1.5, 9.0)));
        assert!(!area.is_crossed((0.0, 5.5), (9.0, 5.5)));
    }

    #[test]
    fn analytic_a_flag_covers_its_pennant_and_a_long_name_is_cut() {
        let place = LabelPosition { x: 3.2, y: 5.0, anchor: "start", pole: 7.0 };
        let label = Label { kind: Kind::Output, text: "abcd".to_owned(), body: 0, at_mm: (0.0, 0.0), place };
        let sizes = Sizes { pin: 1.0, font_mm: 2.0 };
        let area = label.area(place, sizes);
        assert_eq!((area.left, area.low, area.high), (0.0, 4.5, 6.5));
        assert!((area.right - (3.2 + 4.0 * 0.56 * 2.0)).abs() < 1e-12, "{area:?}");
        let long = Label { text: "x".repeat(30), ..label };
        assert_eq!(long.shown().chars().count(), MAX_LETTERS);
        assert!(long.drawn(sizes).into_string().contains(&"x".repeat(30)), "the title has it all");
    }
}
