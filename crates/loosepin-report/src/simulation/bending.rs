//! How flexible bodies start and bend, in sentences, and what to do where their formulation does not fit that.

use crate::medium::short_answer::{Said, Weight};
use crate::numbers::number::NumberWriter;
use loosepin_result::simulation::{BendingRecord, OtherFormulation};
use loosepin_text::units::SiUnit;

/// What there is to say on all flexible bodies of a run.
pub(super) fn bending_said(bending: &[BendingRecord], writer: &NumberWriter) -> Vec<Said> {
    let start = bending.iter().map(|own| Said::detail(start_sentence(own)));
    let condensed = bending.iter().filter_map(|own| Some(Said::detail(condensed_sentence(own, writer)?)));
    let far = bending.iter().filter_map(|own| {
        let weight = if own.is_nodal { Weight::Detail } else { Weight::Caveat };
        Some(Said { weight, words: bending_sentence(own, writer)? })
    });
    start.chain(condensed).chain(far).collect()
}

/// How a flexible body starts.
fn start_sentence(BendingRecord { body, starts_settled, .. }: &BendingRecord) -> String {
    match starts_settled {
        true => format!("The {body} starts settled: in equilibrium with inertia forces, weight and loads."),
        false => format!("The {body} starts undeformed, and then vibrates."),
    }
}

/// Which shapes of a flexible body are condensed.
fn condensed_sentence(BendingRecord { body, condensed, .. }: &BendingRecord, writer: &NumberWriter) -> Option<String> {
    let condensed = condensed.filter(|condensed| condensed.shapes > 0)?;
    let shapes = if condensed.shapes == 1 { "shape is" } else { "shapes are" };
    Some(format!(
        "Of the {body} {} {shapes} condensed: static flexibility is kept, vibrations above {} Hz are not.",
        condensed.shapes,
        writer.value_trimmed(condensed.above_hz, &SiUnit::NONE),
    ))
}

/// That a body bends further than its floating frame is meant for, with what to do that can be done; or so little that absolute nodal
/// coordinates may not be needed.
fn bending_sentence(bending: &BendingRecord, writer: &NumberWriter) -> Option<String> {
    /// Angle at which foreshortening to second order is off by half a percent, rad.
    const MAX_RAD: f64 = 0.1;
    let BendingRecord { body, largest_angle_rad, is_nodal, other_formulation, .. } = bending;
    let most = writer.value_trimmed(MAX_RAD, &SiUnit::ANGLE);
    if *is_nodal {
        let keys = other_formulation.floating_frame().filter(|_| *largest_angle_rad < MAX_RAD)?;
        return Some(format!(
            "The {body} turns by at most {} from the line through its ends. {keys} is valid up to {most}, with fewer coordinates, if the loads stretch it by less than 1 % and compress it by less than half of its buckling load (loosepin check).",
            writer.value(*largest_angle_rad, &SiUnit::ANGLE),
        ));
    }
    let way_out = match other_formulation {
        OtherFormulation::RetardationTime => {
            "Use formulation = \"absolute-nodal\", with retardation_time instead of damping_ratio."
        }
        OtherFormulation::EndsAlone => {
            "Use a stiffer section, or formulation = \"absolute-nodal\", without lumps, points between the ends and damping_ratio."
        }
        OtherFormulation::AsItIs | OtherFormulation::TangentFrame | OtherFormulation::FreeAtTo => {
            "Use formulation = \"absolute-nodal\"."
        }
    };
    // Not a number is no small angle.
    (!(*largest_angle_rad <= MAX_RAD)).then(|| {
        format!(
            "The {body} bends too far for its model: its sections turn by up to {}, and above {most}, the error of lengths exceeds 0.5 % of the shortening by bending. {way_out}",
            writer.value(*largest_angle_rad, &SiUnit::ANGLE),
        )
    })
}

#[cfg(test)]
mod tests {
    use super::bending_sentence;
    use crate::numbers::number::NumberWriter;
    use loosepin_result::simulation::{BendingRecord, OtherFormulation};
    use loosepin_text::units::DisplayUnits;

    fn said(largest_angle_rad: f64, is_nodal: bool, other_formulation: OtherFormulation) -> Option<String> {
        let bending = BendingRecord {
            body: "rod".to_owned(),
            largest_angle_rad,
            starts_settled: false,
            is_nodal,
            other_formulation,
            condensed: None,
        };
        bending_sentence(&bending, &NumberWriter::for_page(&DisplayUnits::default()))
    }

    #[test]
    fn a_floating_frame_that_bends_too_far_is_told_what_can_be_done() {
        assert_eq!(said(0.099, false, OtherFormulation::AsItIs), None);
        for (other, way_out) in [
            (OtherFormulation::AsItIs, " Use formulation = \"absolute-nodal\"."),
            (
                OtherFormulation::RetardationTime,
                " Use formulation = \"absolute-nodal\", with retardation_time instead of damping_ratio.",
            ),
            (
                OtherFormulation::EndsAlone,
                " Use a stiffer section, or formulation = \"absolute-nodal\", without lumps, points between the ends and damping_ratio.",
            ),
        ] {
            for angle_rad in [0.101, f64::NAN] {
                let said = said(angle_rad, false, other).expect("it bends too far");
                assert!(said.starts_with("The rod bends too far for its model: ") && said.ends_with(way_out), "{said}");
            }
        }
    }

    #[test]
    fn absolute_nodal_coordinates_are_advised_to_nobody_who_has_them() {
        for angle_rad in [0.101, 2.0, f64::NAN] {
            assert_eq!(said(angle_rad, true, OtherFormulation::AsItIs), None);
        }
        let small = said(0.02, true, OtherFormulation::AsItIs).expect("a floating frame may do");
        assert!(
            small.contains("formulation = \"floating-frame\" is valid up to") && !small.contains("absolute"),
            "{small}"
        );
        let held = said(0.02, true, OtherFormulation::TangentFrame).expect("a tangent frame may do");
        assert!(held.contains("formulation = \"floating-frame\" with frame = \"tangent\" is valid up to"), "{held}");
        // Held at `to` it has no floating frame.
        assert_eq!(said(0.02, true, OtherFormulation::FreeAtTo), None);
    }
}
