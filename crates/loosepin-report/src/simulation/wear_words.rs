//! Wear of the joints of a run in words: for pages and terminals alike.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::counted;
use loosepin_result::simulation::{JointWearRecord, SimulationRecord, SurfaceWear};
use loosepin_text::units::{DisplayUnit, DisplayUnits, SiUnit};

/// Sectors over which the widest patch of pressure is to lie, at least.
const MIN_SECTORS: f64 = 4.0;
/// Half-width of the patch over the radius from which the surfaces are no half-spaces any more: the arc is 1.5 % longer than its chord.
const WIDE_PATCH: f64 = 0.3;
/// Depth over clearance from which the unworn geometry counts as an estimate only.
const MUCH_WORN: f64 = 0.1;

/// The units of numbers of wear: depths in µm, volumes in mm³.
pub(super) fn wear_units(units: &DisplayUnits) -> DisplayUnits {
    let mut own = units.clone();
    for (si, symbol, per_si) in [("m", "µm", 1e6), ("m^3", "mm³", 1e9), ("m^2/N", "m²/N", 1.0)] {
        own.0.insert(si.to_owned(), DisplayUnit { symbol: symbol.to_owned(), per_si });
    }
    own
}

/// The units of a surface's numbers: coefficient, volume.
pub(super) fn units_of_wear() -> [SiUnit; 2] {
    ["m^2/N", "m^3"].map(SiUnit::from_symbol)
}

/// For how long wear is stated.
pub(super) fn life_words(record: &SimulationRecord, wear: &JointWearRecord, writer: &NumberWriter) -> String {
    let cycles = writer.value_trimmed(wear.cycles, &SiUnit::NONE);
    let word = if wear.cycles == 1.0 { "cycle" } else { "cycles" };
    let turns = record.settings.recorded_turns;
    let turn = if turns == 1.0 { "turn" } else { "turns" };
    let turns = writer.value_trimmed(turns, &SiUnit::NONE);
    let geometry = if record.life.is_some() { "the worn shape acts back" } else { "with the unworn geometry" };
    format!("Wear after {cycles} {word} of {turns} {turn}, {geometry}.")
}

/// Sector of the greatest wear of a surface, as angles from the x axis of the body; `None` if it is not worn.
pub(super) fn deepest_words(surface: &SurfaceWear, writer: &NumberWriter) -> Option<String> {
    if !(surface.greatest_depth_m > 0.0) {
        return None;
    }
    let [from, to] = surface.deepest_rad().map(|angle_rad| writer.value_trimmed(angle_rad, &SiUnit::ANGLE));
    Some(format!("{from} to {to}"))
}

/// The checks of a run's wear, and notes on its numbers; `writer` has the units of [`wear_units`].
///
/// With the worn shape (`is_worn`) nothing is said of Hertz's pressure, nor that the shape is unworn.
pub(super) fn wear_sentences(wear: &JointWearRecord, is_worn: bool, writer: &NumberWriter) -> Vec<String> {
    let (joint, checks) = (&wear.joint, &wear.checks);
    let share = |share: f64| writer.rounded(share.abs(), &SiUnit::NONE, 2, Rounding::Up);
    let mut sentences = Vec::new();
    let of_sectors = wear.surfaces.iter().map(|surface| surface.sum_of_sectors_error.abs()).fold(0.0, f64::max);
    let sectors = wear.surfaces.first().map_or(0, |surface| surface.depth_m.len());
    sentences.push(match checks.path_error {
        Some(error) => format!(
            "{joint}: the friction path integrated with the motion and that of the {} differ by {} of it; the depths add up \
             to theirs within {}.",
            counted(sectors as u64, "sector", writer),
            share(error),
            share(of_sectors)
        ),
        None => format!(
            "{joint}: the depths of the {} add up to the volume within {} of it.",
            counted(sectors as u64, "sector", writer),
            share(of_sectors)
        ),
    });
    for surface in wear.surfaces.iter().filter(|_| !is_worn) {
        if let Some(coarse_m) = surface.coarse_greatest_depth_m.filter(|_| surface.greatest_depth_m > 0.0) {
            let less = writer.percent(1.0 - coarse_m / surface.greatest_depth_m, Rounding::Nearest);
            let word = surface.surface.word();
            sentences.push(format!("{joint}, {word}: half as many sectors give a greatest depth {less} smaller."));
        }
    }
    if checks.widest_patch_sectors > 0.0 && checks.widest_patch_sectors < MIN_SECTORS {
        let width = writer.rounded(checks.widest_patch_sectors, &SiUnit::NONE, 2, Rounding::Nearest);
        sentences.push(format!(
            "{joint}: the widest contact lies over {width} sectors. {}: use more sectors.",
            if is_worn { "That is too coarse for forces" } else { "Greatest depths are means over a sector" }
        ));
    }
    let half_width = std::f64::consts::PI * checks.widest_patch_sectors / sectors.max(1) as f64;
    if half_width > WIDE_PATCH && !is_worn {
        let wide = writer.rounded(half_width, &SiUnit::NONE, 2, Rounding::Nearest);
        sentences.push(format!(
            "{joint}: the widest contact has a half-width of {wide} radii. Hertzian pressure is valid below {WIDE_PATCH}: the depths are approximate there, the volumes are not affected."
        ));
    }
    if checks.capped_share > 0.0 {
        let capped = writer.percent(checks.capped_share, Rounding::Nearest);
        sentences.push(format!(
            "{joint}: for {capped} of the friction path, the Hertzian contact would be wider than half the hole. There, the wear is spread over half the hole."
        ));
    }
    if !is_worn && checks.depth_over_clearance.is_finite() && checks.depth_over_clearance > MUCH_WORN {
        let worn = writer.percent(checks.depth_over_clearance, Rounding::Nearest);
        sentences.push(format!(
            "{joint}: the depths are {worn} of the radial clearance. The worn shape changes forces and pressure; this is a \
             first estimate."
        ));
    }
    sentences
}
