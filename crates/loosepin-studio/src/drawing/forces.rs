//! Springs and loads, with their places in the drawing.

use std::collections::HashMap;

use loosepin::model::{ActsOn, BodyId, Model, PointId, Values};

use crate::drawing::still::in_body_m;
use crate::messages::{ForceTable, ForceView, PinView};

const MM_PER_M: f64 = 1e3;

/// The springs of a model, then its loads.
pub fn forces(model: &Model) -> Vec<ForceView> {
    let values = model.quantities.nominal();
    let pin = |point: PointId| pin(model, &values, point);
    let held = Held::of(model);
    let springs = model.springs.iter().map(|spring| {
        let (kind, ends) = match spring.kind.points() {
            Some(points) => ("spring", points.map(pin).to_vec()),
            None => {
                let [first, second] = spring.kind.bodies();
                ("torsion spring", held.between(first, second).map(pin).into_iter().collect())
            }
        };
        ForceView {
            table: ForceTable::Spring,
            name: spring.name.clone(),
            kind,
            ends,
            direction_deg: None,
            turns: false,
        }
    });
    let loads = model.loads.iter().map(|load| {
        let ends = match load.kind.acts_on() {
            ActsOn::Point(point) => vec![pin(point)],
            ActsOn::Body(body) => held.of_body.get(&body).copied().map(pin).into_iter().collect(),
        };
        let direction = load.kind.direction();
        ForceView {
            table: ForceTable::Load,
            name: load.name.clone(),
            kind: load.kind.word(),
            ends,
            direction_deg: direction.map(|direction| values[direction.angle_rad].to_degrees()),
            turns: direction.is_some_and(|direction| direction.follows_body),
        }
    });
    springs.chain(loads).collect()
}

fn pin(model: &Model, values: &Values, point: PointId) -> PinView {
    let [x, y] = in_body_m(model, values, point).map(|m| m * MM_PER_M);
    PinView { body: point.body.0, x, y }
}

/// Points at which joints hold bodies, of the first joint each.
#[derive(Default)]
struct Held {
    of_body: HashMap<BodyId, PointId>,
    /// The point of the first body at a joint with the second.
    of_pair: HashMap<[BodyId; 2], PointId>,
}

impl Held {
    fn of(model: &Model) -> Self {
        let mut held = Self::default();
        for [one, other] in model.joints.iter().map(|joint| joint.kind.points()) {
            for (own, next) in [(one, other), (other, one)] {
                held.of_body.entry(own.body).or_insert(own);
                held.of_pair.entry([own.body, next.body]).or_insert(own);
            }
        }
        held
    }

    fn between(&self, first: BodyId, second: BodyId) -> Option<PointId> {
        self.of_pair.get(&[first, second]).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin::templates::find_template;

    #[test]
    fn a_load_stands_at_its_point_and_a_spring_between_two() {
        let text = find_template("toggle-press").unwrap().model.to_owned()
            + "[spring.back]\nkind = \"linear\"\nfirst = \"ground.top\"\nsecond = \"ram.pin\"\n\
               stiffness = \"1 N/mm\"\nfree_length = \"300 mm\"\n";
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|found| panic!("{found}"));
        let found = forces(&model);
        let [spring, load] = &found[..] else { panic!("{found:?}") };
        assert_eq!((spring.table, spring.kind, spring.ends.len()), (ForceTable::Spring, "spring", 2));
        assert_eq!((load.table, load.kind, load.name.as_str()), (ForceTable::Load, "force", "work"));
        // Upwards, at the pin of the ram.
        assert!((load.direction_deg.unwrap() - 90.0).abs() < 1e-12 && !load.turns);
        assert_eq!(load.ends, [spring.ends[1]]);
    }
}
