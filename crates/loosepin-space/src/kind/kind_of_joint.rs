//! What every kind of joint says of itself.

use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// A kind of ideal joint between a marker on body i and one on body j.
pub trait KindOfJoint {
    /// Its name.
    fn word(&self) -> &'static str;
    /// The rows that hold the journal's marker to the bearing's.
    fn rows(&self) -> Vec<Row>;
    /// Whether the angle φ = atan2(y_i·x_j, x_i·x_j) about z is a coordinate of it.
    fn turns(&self) -> bool;
    /// Whether the place z_i·d along z is a coordinate of it.
    fn slides(&self) -> bool;
    /// Keys of a model file that give it play; none where it has none.
    fn play_keys(&self) -> &'static [&'static str] {
        &[]
    }
    /// What is drawn of it.
    fn sign(&self) -> JointSign;
}
