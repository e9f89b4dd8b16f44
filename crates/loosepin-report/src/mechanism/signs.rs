//! Signs beside the shapes of a drawn mechanism: arrows of drives, and the scale.

use maud::{Markup, html};

use crate::charts::ticks::{tick_text, ticks};
use crate::mechanism::shapes::{Frame, RAIL_PINS, point_mm, slider_travel_mm};
use loosepin_result::simulation::{Drawing, DrawnDrive, DriveSense, PoseTable};

/// Radius of the arrow around a driven pin, in pins: outside of bearings.
pub(crate) const ARROW_PINS: f64 = 5.0;
/// Ends of that arrow, degrees: over the pin, away from its support.
const ARROW_ENDS_DEG: [f64; 2] = [20.0, 160.0];
/// Half the length of a straight arrow, in pins.
const HALF_ARROW_PINS: f64 = 5.0;
/// A straight arrow lies so far from the middle of its guide, in pins: outside of the hatching.
pub(crate) const ARROW_OFFSET_PINS: f64 = RAIL_PINS + 2.6;
/// Length and half the width of an arrow's head, in pins.
const HEAD_PINS: [f64; 2] = [2.2, 1.1];
/// The bar of the scale is at least this share of the picture's width.
const BAR_SHARE: f64 = 0.12;

/// How the sign of a drive is drawn.
pub(crate) enum DriveSign {
    /// Around a pin: it moves with a point of a body, and does not turn.
    Curved { body: usize, at_mm: (f64, f64), sense: DriveSense },
    /// Along a guide: it moves with the body that carries the guide; its middle, and its direction.
    Straight { body: usize, at_mm: (f64, f64), angle_rad: f64, sense: DriveSense },
}

impl DriveSign {
    /// The body with which it moves, and the place of its name in that body.
    pub fn place(&self) -> (usize, (f64, f64)) {
        match self {
            Self::Curved { body, at_mm, .. } | Self::Straight { body, at_mm, .. } => (*body, *at_mm),
        }
    }

    /// The arrow, around or beside the origin.
    pub fn arrow(&self, pin: f64) -> Markup {
        let (path, ends) = match self {
            Self::Curved { .. } => {
                let radius = ARROW_PINS * pin;
                // The head ends the arc: the line stops within it.
                let at = |degrees: f64| {
                    let (sine, cosine) = degrees.to_radians().sin_cos();
                    (radius * cosine, radius * sine)
                };
                let [first, last] = ARROW_ENDS_DEG;
                let (from, to) = (at(first), at(last));
                let path =
                    format!("M{:.3} {:.3}A{radius:.3} {radius:.3} 0 0 1 {:.3} {:.3}", from.0, from.1, to.0, to.1);
                (path, [(from, first - 90.0), (to, last + 90.0)])
            }
            Self::Straight { angle_rad, .. } => {
                let (sine, cosine) = angle_rad.sin_cos();
                let half = HALF_ARROW_PINS * pin;
                let (from, to) = ((-half * cosine, -half * sine), (half * cosine, half * sine));
                let path = format!("M{:.3} {:.3}L{:.3} {:.3}", from.0, from.1, to.0, to.1);
                (path, [(from, angle_rad.to_degrees() + 180.0), (to, angle_rad.to_degrees())])
            }
        };
        let sense = match self {
            Self::Curved { sense, .. } | Self::Straight { sense, .. } => *sense,
        };
        let (is_backward, is_forward) = match sense {
            DriveSense::Forward => (false, true),
            DriveSense::Backward => (true, false),
            DriveSense::ToAndFro => (true, true),
            DriveSense::Still => return html! {},
        };
        html! {
            path.drive d=(path) {}
            @for (((x, y), degrees), is_shown) in ends.into_iter().zip([is_backward, is_forward]) {
                @if is_shown {
                    path.head d=(format!("M{:.3} 0L{:.3} {:.3}V{:.3}Z", 0.6 * HEAD_PINS[0] * pin, -0.4 * HEAD_PINS[0] * pin,
                        HEAD_PINS[1] * pin, -HEAD_PINS[1] * pin))
                        transform=(format!("translate({x:.3} {y:.3}) rotate({degrees:.2})")) {}
                }
            }
        }
    }
}

/// The sign of a drive; `None` if the record names no such joint.
pub(crate) fn drive_sign(drawing: &Drawing, drive: &DrawnDrive, poses: &PoseTable, pin: f64) -> Option<DriveSign> {
    let joint = drawing.joints.get(drive.joint)?;
    let is_ground = |body: usize| drawing.bodies.get(body).is_some_and(|body| body.is_ground);
    // What is seen to move is the other body where the second one is the ground.
    let sense = match (drive.sense, is_ground(joint.second.body)) {
        (DriveSense::Forward, true) => DriveSense::Backward,
        (DriveSense::Backward, true) => DriveSense::Forward,
        (sense, _) => sense,
    };
    if joint.kind.turns() {
        let end = if is_ground(joint.second.body) { joint.second } else { joint.first };
        return Some(DriveSign::Curved { body: end.body, at_mm: point_mm(drawing, end)?, sense });
    }
    if !joint.kind.has_line() {
        return None;
    }
    let (from, to) = slider_travel_mm(drawing, joint, poses)?;
    let (x, y) = point_mm(drawing, joint.first)?;
    let (sine, cosine) = joint.guide_angle_rad.sin_cos();
    let (along, aside) = (0.5 * (from + to), ARROW_OFFSET_PINS * pin);
    let at_mm = (x + along * cosine - aside * sine, y + along * sine + aside * cosine);
    Some(DriveSign::Straight { body: joint.first.body, at_mm, angle_rad: joint.guide_angle_rad, sense })
}

/// A bar of a round length at the lower left, and at the lower right by how much play is magnified, where there is any. y points
/// down here.
pub(crate) fn scale(view: &Frame, font_mm: f64, magnification: Option<f64>) -> Markup {
    let (_, length_mm) = ticks(0.0, view.width, BAR_SHARE * view.width, false);
    let (x, y) = (view.left + 0.8 * font_mm, view.top + view.height - 1.0 * font_mm);
    let tick = 0.3 * font_mm;
    html! {
        g.scale {
            path d=(format!("M{x:.3} {:.3}v{:.3}M{x:.3} {y:.3}h{length_mm:.3}m0 {:.3}v{:.3}", y - tick, 2.0 * tick, -tick, 2.0 * tick)) {}
            text x=(format!("{:.3}", x + length_mm + 0.5 * font_mm)) y=(format!("{:.3}", y + 0.35 * font_mm)) {
                (tick_text(length_mm, length_mm)) "\u{a0}mm"
            }
            @if let Some(magnification) = magnification {
                text.magnified x=(format!("{:.3}", view.left + view.width - 0.8 * font_mm)) y=(format!("{:.3}", y + 0.35 * font_mm))
                    text-anchor="end" {
                    (magnified_words(magnification))
                }
            }
        }
    }
}

/// Width of the scale's bar and words together: a picture is at least as wide.
pub(crate) fn scale_width_mm(width_mm: f64, font_mm: f64) -> f64 {
    let (_, length_mm) = ticks(0.0, width_mm, BAR_SHARE * width_mm, false);
    length_mm + 15.0 * font_mm
}

/// Words for the magnification of play; `scripts/mechanism.ts` has the same.
fn magnified_words(magnification: f64) -> String {
    if magnification == 1.0 { "play true to scale".to_owned() } else { format!("play × {magnification}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_an_arrow_has_its_head_where_the_motion_goes() {
        let arrow = |sense| DriveSign::Curved { body: 0, at_mm: (0.0, 0.0), sense }.arrow(1.0).into_string();
        // Anticlockwise over the pin ends on the left.
        assert!(arrow(DriveSense::Forward).contains("translate(-4.698 1.710)"), "{}", arrow(DriveSense::Forward));
        assert!(arrow(DriveSense::Backward).contains("translate(4.698 1.710)"));
        assert_eq!(arrow(DriveSense::ToAndFro).matches("class=\"head\"").count(), 2);
        assert!(arrow(DriveSense::Still).is_empty());
    }

    #[test]
    fn the_scale_says_a_round_length_and_the_magnification() {
        let view = Frame { left: 0.0, top: 0.0, width: 230.0, height: 100.0 };
        let text = scale(&view, 6.0, Some(20.0)).into_string();
        assert!(text.contains("h50.000") && text.contains("50\u{a0}mm") && text.contains("play × 20"), "{text}");
        assert!(scale(&view, 6.0, Some(1.0)).into_string().contains("play true to scale"));
        assert!(!scale(&view, 6.0, None).into_string().contains("play"));
    }
}
