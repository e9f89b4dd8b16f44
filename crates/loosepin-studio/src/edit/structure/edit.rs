//! Requested changes of a mechanism.

use serde::Deserialize;

/// Something with a name: `joint.gudgeon`, `body.rod`, or the point `body.rod.points.small_end`.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
pub struct Named {
    /// The table that it stands in: `body`, `joint`, `output`, ...
    pub table: String,
    /// Its name there.
    pub name: String,
    /// A point of this body.
    #[serde(default)]
    pub point: Option<String>,
}

impl Named {
    /// An entry of a table.
    pub fn new(table: &str, name: &str) -> Self {
        Self { table: table.to_owned(), name: name.to_owned(), point: None }
    }

    /// A point of a body.
    pub fn point(body: &str, point: &str) -> Self {
        Self { point: Some(point.to_owned()), ..Self::new("body", body) }
    }

    /// In words: `joint 'gudgeon'`.
    pub fn words(&self) -> String {
        match &self.point {
            Some(point) => format!("point '{}.{point}'", self.name),
            None => format!("{} '{}'", self.table, self.name),
        }
    }
}

/// An end of a new part.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "at", rename_all = "snake_case")]
pub enum End {
    /// A point of the model.
    Point {
        /// The body; `ground` too.
        body: String,
        /// The point.
        point: String,
    },
    /// A new point of a body.
    On {
        /// The body; `ground` too.
        body: String,
        /// To the right, mm.
        x: f64,
        /// Upwards, mm.
        y: f64,
        /// In the frame of the body, not in that of the ground.
        #[serde(default)]
        is_own: bool,
    },
    /// A place that nothing holds.
    Free {
        /// To the right, mm.
        x: f64,
        /// Upwards, mm.
        y: f64,
    },
}

/// How two points are joined.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "as", rename_all = "snake_case")]
pub enum Joined {
    /// A pin; ideal, or with play as people write it.
    Pin {
        /// `0.1 mm`, `0.1..0.5 mm`; ideal where nothing is written.
        #[serde(default)]
        play: Option<String>,
    },
    /// The second body slides along a line through the first point, and does not turn against it.
    Slider {
        /// Direction of the line from the x axis of the ground, degrees.
        angle_deg: f64,
    },
    /// The second point slides along a line through the first point, and turns there.
    Slot {
        /// Direction of the line from the x axis of the ground, degrees.
        angle_deg: f64,
    },
    /// One body of both.
    Rigid,
}

/// An axis of the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// To the right.
    X,
    /// Upwards.
    Y,
}

impl Axis {
    /// As the model writes it.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
        }
    }
}

/// The recorded quantity of an output.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(tag = "of", rename_all = "snake_case")]
pub enum Watched {
    /// The path of a point.
    Path {
        /// Its body.
        body: String,
        /// The point.
        point: String,
    },
    /// A coordinate of a point.
    Position {
        /// Its body.
        body: String,
        /// The point.
        point: String,
        /// Which coordinate.
        along: Axis,
    },
    /// The angle of a body.
    Angle {
        /// The body.
        body: String,
    },
    /// The angular velocity of a body.
    AngularVelocity {
        /// The body.
        body: String,
    },
    /// The magnitude of the force in a joint.
    Force {
        /// The joint.
        joint: String,
    },
}

/// A change of a mechanism.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Edit {
    /// A link between two places.
    AddLink {
        /// Its beginning.
        from: End,
        /// Its end.
        to: End,
    },
    /// A further point of a body; where it is one of another body, both are joined by a pin.
    AddPoint {
        /// The body.
        body: String,
        /// The place.
        to: End,
    },
    /// A joint of two points.
    Join {
        /// Bearing, or guide.
        first: End,
        /// Journal, or slider.
        second: End,
        /// Kind of joint.
        by: Joined,
    },
    /// A block in a guide of the ground, with a pin to what is at its place.
    AddBlock {
        /// The pin.
        on: End,
        /// Direction of the guide, degrees.
        angle_deg: f64,
    },
    /// The one drive turns or pushes this joint.
    Drive {
        /// The joint.
        joint: String,
    },
    /// An output records something from now on.
    Watch {
        /// It.
        what: Watched,
    },
    /// Something goes, with all that names it.
    Remove {
        /// It.
        what: Named,
    },
    /// Another name, wherever the old one stands.
    Rename {
        /// It.
        what: Named,
        /// The new name.
        to: String,
    },
    /// Whether dragging may change a number.
    Lock {
        /// Path of the number.
        path: String,
        /// It may not.
        is_locked: bool,
    },
}
