//! The tables that the command prints: plain text, aligned, with units, at most 100 columns, readable without colour.

use comfy_table::Table;

use super::article_text::as_shown;
use super::life_section::{life_sentences, life_table};
use super::measured_figures::at_words;
use super::number::{NumberWriter, Rounding};
use super::play_effect::{PlayEffect, Shown, play_effect};
use super::spectrum_section::{dominant_words, oscillations};
use super::tag::Tag;
use super::terminal_table::{push_table, table, wrapped};
use super::wear_words::{deepest_words, life_words, units_of_wear, wear_sentences, wear_units};
use super::wording::{count, counted, named_words, without_round_off};
use super::{motion_angles, motion_page, simulation_page, sweep_page};
use loosepin_result::motion::MotionRecord;
use loosepin_result::simulation::{ExtremePoint, SimulationRecord, StopReason, WearLifeRecord};
use loosepin_result::sweep::SweepRecord;
use loosepin_text::units::SiUnit;

/// Rows of a table; the others stand in the files.
const MOST_ROWS: usize = 24;

/// One run as text for a terminal: the answer, extremes, joints, counters.
pub fn simulation_text(record: &SimulationRecord) -> String {
    let writer = NumberWriter::for_terminal(&record.display_units);
    let mut text = format!("{}\n\n", record.model);
    if let StopReason::Failed { words, .. } = &record.stop {
        text.push_str(&format!("{}\n", wrapped(&format!("the run failed: {words}"), "")));
    }
    for sentence in simulation_page::headline_sentences(record, &writer) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "")));
    }
    let at = |tag: &Tag, point: &ExtremePoint| {
        let time = writer.about(&tag.part("time")).value(point.time_s, &SiUnit::TIME);
        // The phase of a cycle in which no drive turns tells nothing that the time does not.
        if record.settings.drive_speed_rad_s.is_none() {
            return time;
        }
        format!("{time}, {}", writer.about(&tag.part("angle")).angle_in_turn(point.drive_angle_rad, 4))
    };
    let value = |tag: &Tag, point: &ExtremePoint, unit: &SiUnit| {
        writer.about(tag).value(without_round_off(record, point.value_si, unit), unit)
    };
    let mut extremes = table(&["quantity", "smallest", "at", "largest", "at"], &[1, 3]);
    for extreme in &record.extremes {
        let [minimum, maximum] = ["minimum", "maximum"].map(|part| Tag::extreme(extreme, part));
        extremes.add_row([
            simulation_page::extreme_words(extreme),
            value(&minimum, &extreme.minimum, &extreme.unit),
            at(&minimum, &extreme.minimum),
            value(&maximum, &extreme.maximum, &extreme.unit),
            at(&maximum, &extreme.maximum),
        ]);
    }
    push_table(&mut text, &extremes);
    let mut oscillating = table(&["quantity", "rms", "peak", "largest orders (amplitude)"], &[1, 2]);
    let oscillations = oscillations(record);
    for own in &oscillations {
        oscillating.add_row([
            own.name.clone(),
            writer.about(&own.tag("root mean square")).value(own.spectrum.rms_si, &own.unit),
            writer.about(&own.tag("peak")).value(own.peak_si, &own.unit),
            dominant_words(record, own, &writer),
        ]);
    }
    push_table(&mut text, &oscillating);
    if !oscillations.is_empty() {
        text.push_str("largest orders: waves in a turn, of the samples; impacts between two samples do not show\n");
    }
    let mut joints = table(
        &["joint", "impacts", "contacts", "fastest", "peak force", "penetration", "clearance", "restitution"],
        &[1, 2, 3, 4, 5, 6, 7],
    );
    for joint in &record.joints {
        let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
        let share = |part: &str, value: Option<f64>| {
            let tag = tag("restitution", part);
            value.map_or("-".to_owned(), |value| writer.about(&tag).value_trimmed(value, &SiUnit::NONE))
        };
        joints.add_row([
            joint.joint.clone(),
            count(joint.impacts, &writer.about(&tag("impacts", "number"))),
            count(joint.contacts, &writer.about(&tag("contacts", "number"))),
            writer.about(&tag("impacts", "largest speed")).value(joint.largest_speed_m_s, &SiUnit::VELOCITY),
            writer.about(&tag("normal force", "largest")).value(joint.peak_force_n, &SiUnit::FORCE),
            writer.about(&tag("penetration", "largest")).value(joint.largest_penetration_m, &SiUnit::LENGTH),
            writer.about(&tag("clearance", "radial")).value_trimmed(joint.radial_clearance_m, &SiUnit::LENGTH),
            format!(
                "{} ({})",
                share("delivered", joint.delivered_restitution),
                share("stated", joint.nominal_restitution)
            ),
        ]);
    }
    push_table(&mut text, &joints);
    if !record.joints.is_empty() {
        text.push_str("restitution: of a free impact under the contact law (as stated in the file)\n");
    }
    push_table(&mut text, &contact_table(record, &writer));
    if record.joints.iter().any(|joint| joint.share_outside_validity.is_some()) {
        text.push_str("too fast: share of the impacts faster than the contact law is valid for\n");
    }
    push_wear(&mut text, record);
    let mut measured = table(&["measured", "values", "rms", "largest", "at"], &[1, 2, 3]);
    for curve in &record.measured {
        measured.add_row([
            curve.output.clone(),
            count(curve.at_si.len() as u64, &writer),
            writer.value(curve.rms_si, &curve.unit),
            writer.value(curve.largest_si, &curve.unit),
            at_words(curve, record, &writer),
        ]);
    }
    push_table(&mut text, &measured);
    if !record.measured.is_empty() {
        text.push_str("residual: measured minus computed\n");
    }
    let counters = &record.counters;
    let factorizations = match counters.factorizations {
        0 => String::new(),
        number => format!("{}, ", counted(number, "factorization", &writer.about(&Tag::Count("factorizations")))),
    };
    text.push_str(&format!(
        "\n{}, {} rejected, {}, {factorizations}{}\n",
        counted(counters.steps, "step", &writer.about(&Tag::Count("steps"))),
        count(counters.rejections, &writer.about(&Tag::Count("rejections"))),
        counted(counters.evaluations, "evaluation", &writer.about(&Tag::Count("evaluations"))),
        counted(counters.contact_changes, "contact change", &writer.about(&Tag::Count("contact changes")))
    ));
    as_shown(&text)
}

/// The wear of the joints of a run as text for a terminal.
pub fn wear_text(record: &SimulationRecord) -> String {
    let mut text = format!("{}\n", record.model);
    push_wear(&mut text, record);
    as_shown(&text)
}

/// Adds the wear of joints, where any wear.
fn push_wear(text: &mut String, record: &SimulationRecord) {
    let Some(first) = record.wear.first() else { return };
    let units = wear_units(&record.display_units);
    let writer = NumberWriter::for_terminal(&units);
    let [of_coefficient, of_volume] = units_of_wear();
    let heads = ["surface", "coefficient", "friction path", "volume", "greatest depth", "in the sector from"];
    let mut worn = table(&heads, &[1, 2, 3, 4, 5]);
    for (wear, surface) in record.wear.iter().flat_map(|wear| wear.surfaces.iter().map(move |own| (wear, own))) {
        worn.add_row([
            format!("{}, {}", wear.joint, surface.surface.word()),
            writer.value_trimmed(surface.coefficient_m2_n, &of_coefficient),
            writer.value(wear.friction_path_j, &SiUnit::ENERGY),
            writer.value(surface.volume_m3, &of_volume),
            writer.value(surface.greatest_depth_m, &SiUnit::LENGTH),
            deepest_words(surface, &writer),
        ]);
    }
    text.push_str(&format!("\n{}\n", wrapped(&life_words(record, first, &writer), "")));
    push_table(text, &worn);
    text.push_str("friction path: of a cycle; sectors: from the x axis of the body with the surface\n");
    for sentence in record.wear.iter().flat_map(|wear| wear_sentences(wear, record.life.is_some(), &writer)) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "")));
    }
    if let Some(life) = &record.life {
        push_life(text, life, &writer);
    }
}

/// Adds the wear over the cycles.
fn push_life(text: &mut String, life: &WearLifeRecord, writer: &NumberWriter) {
    // A terminal has room for one: that of the limit, or the first. The page has all of them.
    let limited = life.limit.as_ref().and_then(|limit| life.outputs.iter().position(|own| own.name == limit.output));
    let shown = limited.unwrap_or(0);
    let (heads, rows) = life_table(life, life.outputs.get(shown..=shown).unwrap_or_default(), writer);
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut table = table(&heads, &(0..heads.len()).collect::<Vec<_>>());
    rows.into_iter().for_each(|row| {
        table.add_row(row);
    });
    push_table(text, &table);
    for sentence in life_sentences(life, writer) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "")));
    }
}

/// The ideal motion and the quasi-static answer as text for a terminal.
pub fn motion_text(record: &MotionRecord) -> String {
    let writer = NumberWriter::for_terminal(&record.display_units);
    let mut text = format!("{}\n{}\n\n", record.model, record.mobility);
    for sentence in motion_page::headline_sentences(record, &writer) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "")));
    }
    let mut ranges = table(
        &["output", "smallest", "largest", "most play", "at", "proven", "standard deviation"],
        &[1, 2, 3, 4, 5, 6],
    );
    for output in &record.outputs {
        let PlayEffect { angle_rad, largest_si: worst_si, shown } = play_effect(record, output);
        let proven = match shown {
            Shown::UpTo(proven_si) => format!("±{}", writer.rounded(proven_si, &output.unit, 4, Rounding::Up)),
            Shown::FirstOrder | Shown::Found => "not proven".to_owned(),
        };
        let (_, rim_si) = motion_angles::largest(record, &output.clearance.rim_standard_deviation_si);
        let smallest = output.value_si.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = output.value_si.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let where_known = |text: String| if worst_si.is_finite() { text } else { "-".to_owned() };
        ranges.add_row([
            named_words(&output.name, &output.words),
            // The ideal motion has no error.
            if output.value_si.is_empty() { "-".to_owned() } else { writer.value(smallest, &output.unit) },
            if output.value_si.is_empty() { "-".to_owned() } else { writer.value(largest, &output.unit) },
            where_known(format!("±{}", writer.rounded(worst_si, &output.unit, 4, Rounding::Up))),
            where_known(motion_angles::turn_angle(record, angle_rad, 4, &writer)),
            where_known(proven),
            where_known(writer.rounded(rim_si, &output.unit, 4, Rounding::Up)),
        ]);
    }
    push_table(&mut text, &ranges);
    push_table(&mut text, &effort_table(record, &writer));
    let mut contributors = table(&["output", "joint", "clearance", "effect, first order", "share"], &[2, 3, 4]);
    for output in &record.outputs {
        let (angle_rad, worst_si) = motion_angles::largest(record, &output.clearance.first_order_si);
        let pose = record.drive_angle_rad.iter().position(|angle| *angle == angle_rad).unwrap_or(0);
        // Where play moves nothing there is nothing to share.
        for joint in output.clearance.contributors.iter().filter(|_| worst_si > 0.0) {
            let part_si = joint.first_order_si.get(pose).copied().unwrap_or(f64::NAN);
            contributors.add_row([
                output.name.clone(),
                joint.joint.clone(),
                writer.value_trimmed(joint.radial_clearance_m, &SiUnit::LENGTH),
                writer.value(part_si, &output.unit),
                writer.percent(part_si / worst_si, Rounding::Nearest),
            ]);
        }
    }
    push_table(&mut text, &contributors);
    push_table(&mut text, &scatter_table(record, &writer));
    as_shown(&text)
}

/// A sweep as text for a terminal: the answer, and what kind of motion there is where.
pub fn sweep_text(record: &SweepRecord) -> String {
    let writer = NumberWriter::for_terminal(&record.display_units);
    let mut text = format!("{}\n\n", record.model);
    for sentence in sweep_page::headline_sentences(record, &writer) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "")));
    }
    let stretches = sweep_page::stretches(record);
    let mut kinds = table(&["from", "to", "values", "motion"], &[0, 1, 2]);
    for stretch in stretches.iter().take(MOST_ROWS) {
        let [first, last] = stretch.range;
        kinds.add_row([
            writer.value_trimmed(record.points[first].value_si, &record.unit),
            writer.value_trimmed(record.points[last].value_si, &record.unit),
            count((last - first + 1) as u64, &writer),
            sweep_page::period_words(stretch.period),
        ]);
    }
    push_table(&mut text, &kinds);
    if stretches.len() > MOST_ROWS {
        text.push_str(&format!("\n{} more in sweep.csv\n", stretches.len() - MOST_ROWS));
    }
    as_shown(&text)
}

/// Impacts and losses of contact per turn, time without contact, impacts faster than the law is valid for, relative penetration.
fn contact_table(record: &SimulationRecord, writer: &NumberWriter) -> Table {
    let [impacts, losses] = ["impacts", "losses"]
        .map(|what| format!("{what} a {}", super::answer::turn_word(record.settings.drive_speed_rad_s)));
    let head = ["joint", &impacts, &losses, "out of contact", "too fast", "penetration/clearance"];
    let mut contacts = table(&head, &[1, 2, 3, 4, 5]);
    for joint in &record.joints {
        let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
        let tenths = |statistic: &str, value: f64| {
            writer.about(&tag(statistic, "per turn")).shortest((value * 10.0).round() / 10.0, &SiUnit::NONE)
        };
        contacts.add_row([
            joint.joint.clone(),
            joint.impacts_per_turn.map_or("-".to_owned(), |value| tenths("impacts", value)),
            tenths("losses", joint.losses_per_turn),
            writer.about(&tag("flight", "share")).percent(joint.flight_share, Rounding::Nearest),
            joint.share_outside_validity.map_or("-".to_owned(), |share| {
                writer.about(&tag("impacts", "outside validity")).percent(share, Rounding::Up)
            }),
            if joint.radial_clearance_m > 0.0 {
                writer
                    .about(&tag("penetration", "largest share"))
                    .percent(joint.largest_penetration_m / joint.radial_clearance_m, Rounding::Up)
            } else {
                "-".to_owned()
            },
        ]);
    }
    contacts
}

/// What the drives must do to make the ideal motion, and where they must do least and most.
fn effort_table(record: &MotionRecord, writer: &NumberWriter) -> Table {
    let mut efforts = table(&["output", "smallest", "at", "largest", "at"], &[1, 2, 3, 4]);
    for effort in &record.efforts {
        let turned: Vec<f64> = effort.value_si.iter().map(|value| -value).collect();
        let (low_rad, low_si) = motion_angles::largest(record, &turned);
        let (high_rad, high_si) = motion_angles::largest(record, &effort.value_si);
        let angle = |angle_rad: f64| motion_angles::turn_angle(record, angle_rad, 4, writer);
        efforts.add_row([
            named_words(&effort.name, &effort.words),
            writer.value(-low_si, &effort.unit),
            angle(low_rad),
            writer.value(high_si, &effort.unit),
            angle(high_rad),
        ]);
    }
    efforts
}

/// The scatter of the dimensions where it moves each output most: their root of the sum of squares, and their parts.
fn scatter_table(record: &MotionRecord, writer: &NumberWriter) -> Table {
    let mut scatter = table(&["output", "input", "standard deviation", "at", "share of variance"], &[2, 3, 4]);
    for output in &record.outputs {
        if output.dimensional_standard_deviation_si.is_empty() {
            continue;
        }
        let (angle_rad, total_si) = motion_angles::largest(record, &output.dimensional_standard_deviation_si);
        let pose = record.drive_angle_rad.iter().position(|angle| *angle == angle_rad).unwrap_or(0);
        let mut row = |name: &str, part_si: f64| {
            scatter.add_row([
                output.name.clone(),
                name.to_owned(),
                writer.rounded(part_si, &output.unit, 4, Rounding::Up),
                motion_angles::turn_angle(record, angle_rad, 4, writer),
                writer.percent((part_si / total_si).powi(2), Rounding::Nearest),
            ]);
        };
        row("all (root sum of squares)", total_si);
        for dimension in &output.dimensional_contributors {
            row(&dimension.path, dimension.standard_deviation_si.get(pose).copied().unwrap_or(f64::NAN));
        }
    }
    scatter
}
