//! Arms without loops: the pose of their end in closed form, for very many samples.

mod error;
mod joint_turn;
mod open_chain;
mod sample;

pub use error::ChainError;
pub use joint_turn::ChainPose;
pub use open_chain::OpenChain;
pub use sample::ChainSample;
