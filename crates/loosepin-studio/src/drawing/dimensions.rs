//! Dimensions on the drawing: lengths of links, and angles of the lines of guides and slots.

use std::cell::Cell;

use loosepin::model::{Line, Model, PointId, QuantityId, Values};
use loosepin::units::{Dimension, format_value};

use crate::drawing::centres::{Centres, SAME_CENTRE_M};
use crate::drawing::still::in_body_m;
use crate::edit::number_behind;
use crate::messages::{DimensionKind, DimensionView};

const MM_PER_M: f64 = 1e3;
/// Most numbers that are looked for behind lengths and angles: each is found by working out all expressions of the model. A drawing with
/// more dimensions is not readable; those beyond have no field.
const MAX_NUMBERS: usize = 200;

/// The dimensions of a model, in the order of its bodies, then of its joints.
pub fn dimensions(model: &Model) -> Vec<DimensionView> {
    let values = model.quantities.nominal();
    let mut held: Vec<Vec<PointId>> = vec![Vec::new(); model.bodies.len()];
    for point in model.joints.iter().flat_map(|joint| joint.kind.points()) {
        held[point.body.0].push(point);
    }
    let left = Cell::new(MAX_NUMBERS);
    let number = |id: QuantityId| {
        left.set(left.get().checked_sub(1)?);
        number_behind(model, id)
    };
    let lengths = (1..model.bodies.len()).flat_map(|body| lengths(model, &values, body, &held[body], &number));
    let angles = model.joints.iter().filter_map(|joint| {
        let Line { point, angle_rad: angle } = joint.kind.line()?;
        let [x, y] = in_body_m(model, &values, point).map(|m| m * MM_PER_M);
        let (sine, cosine) = values[angle].sin_cos();
        Some(DimensionView {
            kind: DimensionKind::Angle,
            of: joint.name.clone(),
            body: point.body.0,
            from: [x, y],
            to: [x + cosine, y + sine],
            written: format_value(values[angle], Dimension::ANGLE),
            path: number(angle),
        })
    });
    lengths.chain(angles).collect()
}

/// From the first centre of a body to its others; where joints hold fewer than two points of it, all points count.
fn lengths(
    model: &Model,
    values: &Values,
    body: usize,
    held: &[PointId],
    number: &dyn Fn(QuantityId) -> Option<String>,
) -> Vec<DimensionView> {
    let all = (0..model.bodies[body].points.len()).map(|point| PointId { body: loosepin::model::BodyId(body), point });
    let mut centres = apart(model, values, held.iter().copied());
    if centres.len() < 2 {
        centres = apart(model, values, centres.into_iter().chain(all));
    }
    // The centre at the origin of the frame is where lengths are measured from.
    centres.sort_by(|a, b| {
        let far = |point: &PointId| in_body_m(model, values, *point).map(f64::abs).iter().sum::<f64>();
        far(a).total_cmp(&far(b))
    });
    let Some((first, others)) = centres.split_first() else { return Vec::new() };
    let from_m = in_body_m(model, values, *first);
    let length = |point: &PointId| {
        let to_m = in_body_m(model, values, *point);
        let length_m = (to_m[0] - from_m[0]).hypot(to_m[1] - from_m[1]);
        DimensionView {
            kind: DimensionKind::Length,
            of: model.bodies[body].name.clone(),
            body,
            from: from_m.map(|m| m * MM_PER_M),
            to: to_m.map(|m| m * MM_PER_M),
            written: format_value(length_m, Dimension::LENGTH),
            path: along_axis(model, from_m, to_m, *point).and_then(|id| {
                // Only what is the length itself: half of it has another tolerance.
                let path = number(id)?;
                let id = model.quantities.id(&path)?;
                ((values[id] - length_m).abs() < SAME_CENTRE_M).then_some(path)
            }),
        }
    };
    others.iter().map(length).collect()
}

/// The coordinate that is the distance of a point from the origin of its frame, where it lies on an axis.
fn along_axis(model: &Model, from_m: [f64; 2], [x, y]: [f64; 2], point: PointId) -> Option<QuantityId> {
    let position = model.bodies[point.body.0].points[point.point].position_m;
    match (from_m, x, y) {
        ([0.0, 0.0], x, 0.0) if x > 0.0 => Some(position[0]),
        ([0.0, 0.0], 0.0, y) if y > 0.0 => Some(position[1]),
        _ => None,
    }
}

/// Points of a body that lie apart from each other.
fn apart(model: &Model, values: &Values, points: impl Iterator<Item = PointId>) -> Vec<PointId> {
    let mut centres = Centres::default();
    points.filter(|point| centres.is_new(point.body.0, in_body_m(model, values, *point))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin::templates::find_template;

    #[test]
    fn a_link_has_its_length_and_a_guide_its_angle() {
        let model = find_template("offset-slider-crank").unwrap().model;
        let model = Model::from_text("model.toml", model).unwrap();
        let found = dimensions(&model);
        let of = |name: &str| found.iter().find(|one| one.of == name).unwrap();
        let nominal = model.quantities.nominal();
        for body in ["crank", "rod"] {
            let path = format!("parameter.{body}_length");
            let length = of(body);
            assert_eq!((length.kind, length.path.as_deref()), (DimensionKind::Length, Some(path.as_str())));
            let length_m = nominal[model.quantities.id(&path).unwrap()];
            assert_eq!(length.written, format_value(length_m, Dimension::LENGTH));
        }
        let guide = model.joints.iter().find(|joint| joint.kind.line().is_some()).unwrap();
        assert_eq!(of(&guide.name).kind, DimensionKind::Angle);
    }
}
