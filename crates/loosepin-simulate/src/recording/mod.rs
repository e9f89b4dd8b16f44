//! Recording of a run: histories, extremes, energy account, impacts, drawings, CSV files. Nothing here changes a run. What is reduced while
//! lanes run stands in `follow`.

pub(crate) mod balance;
pub(crate) mod bending;
pub(crate) mod column_reader;
pub(crate) mod contact_basis;
pub(crate) mod control_history;
pub(crate) mod controlled_drawing;
pub(crate) mod drawing;
pub(crate) mod extremes;
pub(crate) mod flight;
pub(crate) mod history;
pub(crate) mod motion_table;
pub(crate) mod report;
pub(crate) mod tables;
pub(crate) mod work;
