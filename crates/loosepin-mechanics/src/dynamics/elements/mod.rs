//! Forces on bodies besides contacts: springs, loads, actuators, friction in ideal joints, flexible links. Each adds its forces to the
//! equations of motion. Contacts stand in `play`.

pub(in crate::dynamics) mod beam;
pub(in crate::dynamics) mod beam_workspace;
pub(in crate::dynamics) mod control;
pub(in crate::dynamics) mod effort;
pub(in crate::dynamics) mod element_force;
pub(in crate::dynamics) mod joint_friction;
pub(in crate::dynamics) mod linear_spring;
pub(in crate::dynamics) mod load;
pub(in crate::dynamics) mod nodal_beam;
pub(in crate::dynamics) mod nodal_workspace;
pub(in crate::dynamics) mod spring;
pub(in crate::dynamics) mod torsional_spring;
pub(in crate::dynamics) mod without_value;
