//! The mechanism of a motion as it is drawn, and what is said of it: the one place that knows whether it moves in a plane or in space.

use maud::Markup;

use crate::charts::figure::figures;
use crate::mechanism::figure::{MovingDrawing, mechanism_figure, mechanism_picture, moving_drawing};
use crate::medium::page::Section;
use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::spatial::figure::{SpaceDrawing, space_drawing, spatial_figure};
use crate::spatial::views::views_figure;
use crate::words::round_off;
use loosepin_result::motion::MotionRecord;
use loosepin_text::article::Fact;

use super::angles::turn_angle;
use super::lean::journals_lean;
use super::moved::has_clearance;
use super::play_effect::play_effect;
use super::searched::is_together;

/// Without play a picture in space shows the position at this fraction of the cycle (one over it) first: not a dead centre.
const FIRST_POSITION: usize = 6;

/// The mechanism with its controls.
pub(crate) fn motion_figure(record: &MotionRecord) -> Markup {
    match record.picture.is_empty() {
        true => mechanism_figure(&record.drawing, &record.drive),
        false => spatial_figure(record, first_position(record)),
    }
}

/// The mechanism in one position as an SVG file of its own in light colours; empty where the record has no positions.
pub fn motion_picture(record: &MotionRecord) -> String {
    if record.picture.is_empty() {
        return mechanism_picture(&record.drawing, &record.model);
    }
    let figure = spatial_figure(record, first_position(record));
    figures(&figure.into_string()).first().map(|figure| figure.to_svg(None)).unwrap_or_default()
}

/// The mechanism for a page that moves it by itself, in a plane or in space; `None` where the record has no positions.
pub fn motion_drawing(record: &MotionRecord) -> (Option<MovingDrawing>, Option<SpaceDrawing>) {
    (moving_drawing(&record.drawing, &record.drive), space_drawing(record, first_position(record)))
}

/// Front, side and top of a mechanism in space.
pub(super) fn views_section(record: &MotionRecord, writer: &NumberWriter) -> Option<Section> {
    let position = first_position(record);
    let angle_rad = *record.drive_angle_rad.get(position)?;
    let tag = Tag::Given("position of the views");
    let at = format!("{} {}", record.drive, turn_angle(record, angle_rad, 4, &writer.with_tag(&tag)));
    let views = views_figure(record, position, &at);
    (!views.0.is_empty()).then(|| Section::new("three-views", "Front, side and top", views))
}

/// The distance of the farthest point of a body from the origin of the body, which is the size of a mechanism.
pub(super) fn size_m(record: &MotionRecord) -> f64 {
    let points = record.picture.bodies.iter().flat_map(|body| &body.points);
    let sizes_m = points.map(|point| point.at_m.iter().fold(0.0, |size: f64, own| size.hypot(*own)));
    sizes_m.fold(round_off::size_m(&record.drawing), f64::max)
}

/// How its motion and the effect of play on it are computed.
pub(super) fn motion_method(record: &MotionRecord, positions: &str, writer: &NumberWriter) -> Vec<Fact> {
    let is_planar = record.picture.is_empty();
    let closed = match is_planar {
        true => format!("loops closed at position, velocity and acceleration level, {positions} positions"),
        false => format!("loops closed at {positions} positions; between them nothing is looked at"),
    };
    let mut facts = vec![Fact::new("Ideal motion", [closed])];
    if is_together(record) {
        let places = match journals_lean(record) {
            true => "journals in their bearings and sockets, offsets, leans and axial displacements at once",
            false => "journals in their bearings that let the loops close",
        };
        let first_order = format!(
            "the largest g·p over all places p of the {places}; g are the derivatives of the output in the ideal position"
        );
        facts.push(Fact::new("Effect of play", [first_order]));
        facts.push(Fact::new(
            "Found",
            ["in the position with the largest worst case: a search over all places of the journals with loops closed exactly. The values are \
              reached; that none is larger is not proven by them"],
        ));
        if record.picture.traces.iter().any(|trace| !trace.zones.is_empty()) {
            facts.push(Fact::new(
                "Zones",
                ["where play takes a point to first order: the hull of the displacements that go farthest in directions spread over the sphere"],
            ));
        }
    } else if is_planar && !record.outputs.iter().any(|output| output.clearance.is_forgotten()) {
        let [two, four] = [2, 4].map(|divisor| writer.with_tag(&Tag::Given("divisor")).count(divisor));
        let first_order = format!(
            "to first order an eccentricity e within |e| ≤ c moves the output by g·e, with g from the mechanism's own Jacobian: Σ c|g| at most; \
             variance Σ c²|g|²/{four} (anywhere in the disc), Σ c²|g|²/{two} (on the rim)"
        );
        facts.push(Fact::new("Effect of play", [first_order]));
    }
    facts
}

/// The position that pictures in space show first: that of the largest effect of play on the first output that it moves.
fn first_position(record: &MotionRecord) -> usize {
    let moved = record.outputs.iter().find(|output| has_clearance(output));
    let worst = moved.and_then(|output| record.position_at(play_effect(record, output).angle_rad));
    worst.unwrap_or(record.drive_angle_rad.len() / FIRST_POSITION)
}
