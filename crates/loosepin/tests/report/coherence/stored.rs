//! Numbers of `summary.json` and `bounds.csv`, with what they are.

use loosepin::report::{ResultTag, Tag, degree_group, percentile_group};
use loosepin::result::ContactBasis;
use loosepin::simulate::record::Trust;
use loosepin::study::result::*;
use loosepin::units::SiUnit;

use super::shown::Shown;

/// Keys of numbers that are held against what is shown.
const HELD: &str = "counts.runs counts.failed counts.outer counts.inner counts.rounds gaps.between_points gaps.between_runs gaps.axes settled_share further_turns nominal_trust.horizons[].until_s nominal_trust.horizons[].turns \
    nominal_trust.whole_m requirements[].probability[] \
    bounds[].lower.widened_si bounds[].upper.widened_si bounds[].lower.error.sampling_si bounds[].lower.error.optimisation_si \
    bounds[].lower.error.surrogate_si bounds[].upper.error.sampling_si bounds[].upper.error.optimisation_si \
    bounds[].upper.error.surrogate_si bounds[].lower.witness bounds[].upper.witness bounds[].lower.value_si bounds[].upper.value_si \
    requirements[].witness treatments[].bands[].lower_si treatments[].bands[].upper_si treatments[].bands[].coverage_minimum \
    treatments[].bands[].coverage_maximum treatments[].bands[].coverage_error treatments[].bands[].ends[].error \
    treatments[].bands[].ends[].widened_si treatments[].proven_without_dynamics_si[] energy.median energy.quantile_90 energy.quantile_99 energy.maximum impacts[].impacts_per_turn[] \
    impacts[].nominal_restitution[] impacts[].delivered_restitution[] impacts[].share_outside_validity \
    impacts[].largest_penetration_share impacts[].peak_force_n impacts[].laws[].basis.largest_valid_speed_m_s \
    impacts[].laws[].basis.largest_valid_penetration_m impacts[].floored_contacts curves[].centre curves[].numerical_error_si \
    curves[].confidence curves[].random curves[].mixed boxes[].numerical_error failures[].count contributors[] cuts[].bounds[] \
    percentiles[].bounds[] answers[]";
/// Keys of numbers that were given, that tell where another number stands, or that are drawn only.
const GIVEN: &str = "nominal_trust.horizons[].length_m nominal_trust.share nominal_trust.tolerance_m nominal_trust.evaluations \
    nominal_trust.time_s[] nominal_trust.difference_m[] format seed inputs[] correlations[] cycle counts.replicates counts.by_purpose[] requirements[].lower_si \
    requirements[].upper_si requirements[].probability_at_least requirements[].counted requirements[].at requirements[].failed_values \
    requirements[].promised bounds[].at bounds[].statistic bounds[].guarantee treatments[].promised_coverage treatments[].at \
    treatments[].bands[].coverage_at[] energy.histogram[] witness_commands[] display_units curves[].probabilities[] curves[].pose_rad[] \
    curves[].ideal_si[] curves[].nominal_si[] curves[].at_values[] curves[].simultaneous[] curves[].path boxes[] orbits[] drawing \
    failures[].example failures[] cuts[].alpha percentiles[].percentile repeat impacts[].laws[].basis.minimum_impact_speed_m_s \
    impacts[].laws[].basis.shape";
/// Keys of numbers that are not held against what is shown yet.
const LEFT: &str = "allowances[] together allocation rare[] promise surrogate accuracy";

/// Every number of a summary that its texts may show.
pub fn summary_numbers(result: &StudyResult) -> Vec<Shown> {
    let mut found = Found { result, shown: Vec::new() };
    let counts = &result.counts;
    found.add(Tag::Count("runs"), counts.runs as f64);
    found.add(Tag::Count("failed runs"), counts.failed as f64);
    found.add(Tag::Count("finished runs"), (counts.runs - counts.failed) as f64);
    found.add(Tag::Count("values of the unknown inputs"), counts.outer as f64);
    found.add(Tag::Count("random samples"), counts.inner as f64);
    found.add(Tag::Count("rounds"), counts.rounds as f64);
    if let Some(gaps) = result.gaps {
        found.add(Tag::Count("gap between points"), 100.0 * gaps.between_points);
        for (what, share) in
            [("side of a gap between points", gaps.between_points), ("side of a gap between runs", gaps.between_runs)]
        {
            if gaps.axes > 0 {
                found.add(Tag::Count(what), 100.0 * share.powf(1.0 / gaps.axes as f64));
            }
        }
    }
    if let Some(settled) = result.settled_share {
        found.add(Tag::whole("settled", ""), 100.0 * settled);
        found.add(Tag::whole("settled", "not"), 100.0 * (1.0 - settled));
    }
    for answer in &result.answers {
        for part in answer.sentences.iter().flatten() {
            match part {
                AnswerPart::Words(_) => {}
                AnswerPart::Count { of, count } => found.add(Tag::whole(&answer.question, of), *count as f64),
                AnswerPart::Quantity { of, value_si, unit } => {
                    found.value(Tag::whole(&answer.question, of), *value_si, unit);
                }
            }
        }
    }
    if let Some(further) = &result.further_turns {
        found.add(Tag::Count("continued runs"), further.runs as f64);
        for one in &further.outputs {
            let unit = result.outputs.iter().find(|output| output.name == one.output).map(|output| output.unit.clone());
            let unit = unit.unwrap_or(SiUnit::NONE);
            found.value(Tag::further_turns(one, "mean excess"), one.mean_excess_si, &unit);
            found.value(Tag::further_turns(one, "largest excess"), one.largest_excess_si, &unit);
        }
        for (requirement, broken) in result.requirements.iter().zip(&further.broken_later) {
            if let Some(broken) = broken {
                found.add(Tag::requirement(requirement, "broken later"), *broken as f64);
            }
        }
    }
    if let Trust::Measured(measured) = &result.nominal_trust {
        let tag = |statistic: &str, part: &str| Tag::whole(&format!("trust, {statistic}"), part);
        for horizon in &measured.horizons {
            let at = |part: &str| tag("horizon", part).at(&horizon.length_m.to_string());
            if let Some(until_s) = horizon.until_s {
                found.value(at("time"), until_s, &SiUnit::TIME);
            }
            if let Some(turns) = horizon.turns {
                found.add(at("turns"), turns);
            }
        }
        if let Some(whole_m) = measured.whole_m {
            found.value(tag("whole run", "length"), whole_m, &SiUnit::LENGTH);
        }
        if let Some(&last_s) = measured.time_s.last() {
            found.value(tag("second run", "end"), last_s, &SiUnit::TIME);
        }
    }
    for failure in &result.failures {
        found.add(Tag::whole("failed runs", &failure.code), failure.count as f64);
    }
    for requirement in &result.requirements {
        for (part, share) in [("share lower", requirement.probability[0]), ("share upper", requirement.probability[1])]
        {
            found.add(Tag::requirement(requirement, part), 100.0 * share);
        }
        found.witness(&Tag::requirement(requirement, "witness"), &requirement.witness);
    }
    found.bounds(&result.bounds, None);
    for cut in &result.cuts {
        found.bounds(&cut.bounds, Some(&degree_group(cut.alpha)));
    }
    for each in &result.percentiles {
        found.bounds(&each.bounds, Some(&percentile_group(each.percentile)));
    }
    for comparison in &result.treatments {
        if let Some([lower_si, upper_si]) = comparison.proven_without_dynamics_si {
            found.value(Tag::comparison(comparison, "proven lower"), lower_si, &comparison.unit);
            found.value(Tag::comparison(comparison, "proven upper"), upper_si, &comparison.unit);
        }
        for band in &comparison.bands {
            let tag = |part: &str| Tag::band(comparison, band, part);
            found.value(tag("lower"), band.lower_si, &comparison.unit);
            found.value(tag("upper"), band.upper_si, &comparison.unit);
            found.value(tag("width"), band.upper_si - band.lower_si, &comparison.unit);
            found.add(tag("share lower"), 100.0 * band.least_share());
            found.add(tag("share upper"), 100.0 * band.coverage_maximum);
            found.add(tag("counted share"), 100.0 * band.coverage_minimum);
            found.add(tag("error of the share"), 100.0 * band.coverage_error);
            if let Some([lower, upper]) = &band.ends {
                let error_si = lower.error.total_si().max(upper.error.total_si());
                found.value(tag("error"), error_si, &comparison.unit);
                found.value(
                    tag("error"),
                    (band.lower_si - lower.widened_si).max(upper.widened_si - band.upper_si),
                    &comparison.unit,
                );
            }
        }
    }
    found.curves();
    if let Some(energy) = &result.energy {
        for (part, value) in [
            ("median", energy.median),
            ("0.9", energy.quantile_90),
            ("0.99", energy.quantile_99),
            ("largest", energy.maximum),
        ] {
            found.add(Tag::whole("energy residual", part), value);
        }
    }
    for joint in &result.impacts {
        let tag = |statistic: &str, part: &str| Tag::joint(&joint.joint, statistic, part);
        for (part, value) in ["least", "median", "most"].into_iter().zip(joint.impacts_per_turn) {
            found.add(tag("impacts per turn", part), (value * 100.0).round() / 100.0);
        }
        for (part, ends) in [("stated", joint.nominal_restitution), ("delivered", joint.delivered_restitution)] {
            for (end, value) in ["least", "most"].into_iter().zip(ends.into_iter().flatten()) {
                found.add(tag("restitution", &format!("{part} {end}")), (value * 1e4).round() / 1e4);
            }
        }
        if let Some(share) = joint.share_outside_validity {
            found.add(tag("impacts", "outside validity"), 100.0 * share);
        }
        let least = |limit: fn(&ContactBasis) -> Option<f64>| {
            joint.laws.iter().filter_map(|own| limit(&own.basis)).min_by(f64::total_cmp)
        };
        if let Some(speed_m_s) = least(|basis| basis.largest_valid_speed_m_s) {
            found.value(tag("validity", "fastest"), speed_m_s, &SiUnit::VELOCITY);
        }
        if let Some(depth_m) = least(|basis| basis.largest_valid_penetration_m) {
            found.value(tag("validity", "deepest"), depth_m, &SiUnit::LENGTH);
        }
        found.add(tag("penetration", "largest share"), 100.0 * joint.largest_penetration_share);
        found.add(tag("impacts", "very slow"), joint.floored_contacts as f64);
        found.value(tag("normal force", "largest"), joint.peak_force_n, &SiUnit::FORCE);
    }
    for pbox in &result.boxes {
        found.add(Tag::distribution(pbox, "error"), 100.0 * pbox.numerical_error);
    }
    for (place, command) in result.witness_commands.iter().enumerate() {
        found.witness(&Tag::whole("command of a witness", &place.to_string()), &command.witness);
    }
    found.contributors();
    found.shown
}

struct Found<'r> {
    result: &'r StudyResult,
    shown: Vec<Shown>,
}

impl Found<'_> {
    fn add(&mut self, tag: Tag, value: f64) {
        if !value.is_nan() {
            self.shown.push(Shown::exact("summary.json", tag, value));
        }
    }

    fn value(&mut self, tag: Tag, value_si: f64, unit: &SiUnit) {
        self.add(tag, self.result.display_units.of(unit).from_si(value_si));
    }

    fn of_bound(&mut self, tag: Tag, value_si: f64, bound: &BoundRecord) {
        if bound.statistic.is_probability() {
            self.add(tag, 100.0 * value_si)
        } else {
            self.value(tag, value_si, &bound.unit)
        }
    }

    fn witness(&mut self, tag: &Tag, witness: &Witness) {
        for (path, value) in witness {
            let input = self.result.inputs.iter().find(|input| input.path == *path);
            if let (WitnessValue::Number(value_si), Some(input)) = (value, input) {
                self.value(tag.at(path), *value_si, &input.unit);
            }
        }
    }

    fn bounds(&mut self, bounds: &[BoundRecord], among: Option<&Tag>) {
        for bound in bounds {
            let tag = |part: &str| Tag::bound(bound, part).within(among);
            let [lower, upper] = [&bound.lower, &bound.upper];
            let [of_lower, of_upper] = [lower.error.total_si(), upper.error.total_si()];
            self.of_bound(tag("lower"), lower.widened_si, bound);
            self.of_bound(tag("upper"), upper.widened_si, bound);
            self.of_bound(tag("finished lower"), lower.value_si - of_lower, bound);
            self.of_bound(tag("finished upper"), upper.value_si + of_upper, bound);
            self.of_bound(tag("upper error"), of_upper, bound);
            self.of_bound(tag("error"), of_lower.max(of_upper), bound);
            // An end is its value, moved outwards by its error; a small difference of large numbers has few digits.
            let is_told = of_upper > 1e-6 * upper.widened_si.abs();
            if among.is_none() && is_told && upper.value_si.is_finite() && upper.widened_si.is_finite() {
                self.of_bound(tag("upper error"), upper.widened_si - upper.value_si, bound);
            }
            let error = if of_upper >= of_lower { upper.error } else { lower.error };
            let parts =
                [("sampling", error.sampling_si), ("search", error.optimisation_si), ("surrogate", error.surrogate_si)];
            for (part, error_si) in parts {
                self.of_bound(tag(&format!("error {part}")), error_si, bound);
            }
            for (end, error) in [("lower", lower.error), ("upper", upper.error)] {
                self.of_bound(tag(&format!("{end} error sampling")), error.sampling_si, bound);
                self.of_bound(tag(&format!("{end} error search")), error.optimisation_si, bound);
            }
            self.witness(&tag("lower witness"), &lower.witness);
            self.witness(&tag("upper witness"), &upper.witness);
        }
    }

    fn curves(&mut self) {
        for curve in &self.result.curves {
            let tag = |part: &str| Tag::curve(curve, part);
            self.value(tag("error"), curve.numerical_error_si, &curve.unit);
            if let Some(confidence) = curve.confidence {
                self.add(tag("confidence"), 100.0 * confidence);
            }
            self.witness(&tag("centre"), &curve.centre);
            for (part, range) in [("random", &curve.random), ("mixed", &curve.mixed)] {
                let lowest = range.lower_si.iter().copied().fold(f64::INFINITY, f64::min);
                let highest = range.upper_si.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                if lowest.is_finite() && highest.is_finite() {
                    self.value(tag(&format!("{part} lowest")), lowest, &curve.unit);
                    self.value(tag(&format!("{part} highest")), highest, &curve.unit);
                    self.value(tag(&format!("{part} reach")), lowest.abs().max(highest.abs()), &curve.unit);
                }
            }
            // The band is made of quantiles of the points of the curve.
            for bound in &self.result.bounds {
                let (ResponsePoint::Curve { pose_rad }, Statistic::Quantile(probability)) = (bound.at, bound.statistic)
                else {
                    continue;
                };
                let is_own = (&bound.output, bound.of) == (&curve.output, curve.of)
                    && bound.treatment == Treatment::Mixed
                    && bound.reading == self.result.bounds[0].reading;
                let Some(pose) = curve.pose_rad.iter().position(|pose| *pose == pose_rad).filter(|_| is_own) else {
                    continue;
                };
                if probability == curve.probabilities[0] {
                    self.value(Tag::bound(bound, "lower"), curve.mixed.lower_si[pose], &curve.unit);
                }
                if probability == curve.probabilities[1] {
                    self.value(Tag::bound(bound, "upper"), curve.mixed.upper_si[pose], &curve.unit);
                }
            }
        }
    }

    fn contributors(&mut self) {
        let hundredth = |share: f64| 100.0 * ((100.0 * share).round() / 100.0);
        for one in &self.result.contributors {
            let tag = |part: &str, paths: &str| Tag::contributors(one, part, paths);
            self.value(tag("band width", ""), one.band_width_si, &one.unit);
            self.add(tag("error", ""), 100.0 * one.epistemic.iter().map(|input| input.error).fold(0.0, f64::max));
            for input in &one.random {
                let paths = input.paths.join(" ");
                self.add(tag("band most", &paths), hundredth(input.band_share));
                for (part, range) in [("first", &input.first), ("total", &input.total)] {
                    self.add(tag(&format!("{part} lower"), &paths), 100.0 * range.lower);
                    self.add(tag(&format!("{part} upper"), &paths), 100.0 * range.upper);
                }
                if let Some(share) = input.quasi_static_share {
                    self.add(tag("quasi-static", &paths), 100.0 * share);
                }
            }
            for input in &one.epistemic {
                self.add(tag("band least", &input.path), hundredth(input.band_share[0]));
                self.add(tag("band most", &input.path), hundredth(input.band_share[1]));
                if let Some(share) = input.quasi_static_share {
                    self.add(tag("quasi-static", &input.path), 100.0 * share);
                }
            }
        }
    }
}

/// Keys of numbers of a summary that stand in none of the lists.
pub fn unknown_keys(summary: &str) -> Vec<String> {
    let known: Vec<&str> = [HELD, GIVEN, LEFT].into_iter().flat_map(str::split_whitespace).collect();
    let mut keys = Vec::new();
    walk(&serde_json::from_str(summary).unwrap(), String::new(), &mut keys);
    keys.sort();
    keys.dedup();
    let is_below = |key: &str, whole: &str| {
        key.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    };
    keys.retain(|key| !known.iter().any(|whole| is_below(key, whole)));
    keys.into_iter().map(|key| format!("summary.json: nothing says what '{key}' is")).collect()
}

fn walk(value: &serde_json::Value, key: String, keys: &mut Vec<String>) {
    match value {
        serde_json::Value::Number(_) => keys.push(key),
        serde_json::Value::Array(items) => items.iter().for_each(|item| walk(item, format!("{key}[]"), keys)),
        serde_json::Value::Object(entries) => entries.iter().for_each(|(name, value)| {
            walk(value, if key.is_empty() { name.clone() } else { format!("{key}.{name}") }, keys);
        }),
        _ => {}
    }
}

/// Numbers of `bounds.csv`, and its columns that nothing is known of.
pub fn table_numbers(table: &str, result: &StudyResult) -> (Vec<Shown>, Vec<String>) {
    const OF_A_ROW: [&str; 12] = [
        "output",
        "of",
        "at",
        "pose_rad",
        "reduction",
        "statistic",
        "parameter",
        "treatment",
        "reading",
        "unit",
        "guarantee",
        "alpha",
    ];
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let head: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let (mut shown, mut faults) = (Vec::new(), Vec::new());
    for row in reader.records() {
        let row = row.unwrap();
        let cell = |name: &str| head.iter().position(|own| own == name).map_or("", |place| &row[place]);
        let place = match cell("at") {
            "pose" | "curve" => format!("{} {}", cell("at"), cell("pose_rad").parse::<f64>().unwrap()),
            "reduced" => cell("reduction").to_owned(),
            whole => whole.to_owned(),
        };
        let parameter = cell("parameter").parse::<f64>().map_or_else(|_| String::new(), |number| format!(" {number}"));
        let among = match (cell("alpha").parse::<f64>(), cell("percentile").parse::<f64>()) {
            (Ok(alpha), _) => format!("degree {alpha} "),
            (_, Ok(percentile)) => format!("percentile {percentile} "),
            _ => String::new(),
        };
        let tag = |part: &str, path: &str| {
            Tag::Result(Box::new(ResultTag {
                output: format!("{} {} {place}", cell("output"), cell("of")),
                statistic: format!("{}{parameter}", cell("statistic")),
                part: part.to_owned(),
                treatment: format!("{} {}", cell("treatment"), cell("reading")),
                inputs: if path.is_empty() { among.clone() } else { format!("{among}{path}") },
            }))
        };
        let unit = result.outputs.iter().find(|output| output.name == cell("output")).map(|output| &output.unit);
        let is_probability = cell("statistic").starts_with("probability");
        let shown_as = |value: f64| match unit {
            _ if is_probability => 100.0 * value,
            Some(unit) => result.display_units.of(unit).from_si(value),
            None => value,
        };
        let number = |name: &str| cell(name).parse::<f64>().unwrap_or(f64::NAN);
        let total = |end: &str| {
            let parts = ["sampling", "optimisation", "surrogate"];
            parts.iter().map(|part| number(&format!("{end}_error_{part}"))).sum::<f64>()
        };
        let mut add = |tag: Tag, value: f64| {
            if !value.is_nan() {
                shown.push(Shown::exact("bounds.csv", tag, value));
            }
        };
        add(tag("lower", ""), shown_as(number("lower_widened")));
        add(tag("upper", ""), shown_as(number("upper_widened")));
        add(tag("upper error", ""), shown_as(total("upper")));
        add(tag("error", ""), shown_as(total("lower").max(total("upper"))));
        for end in ["lower", "upper"] {
            for (path, value) in cell(&format!("{end}_witness")).split(';').filter_map(|part| part.split_once('=')) {
                let input = result.inputs.iter().find(|input| input.path == path);
                if let (Some(input), Ok(value)) = (input, value.parse::<f64>()) {
                    add(tag(&format!("{end} witness"), path), result.display_units.of(&input.unit).from_si(value));
                }
            }
        }
    }
    for name in head {
        let is_end = ["lower", "upper"].iter().any(|end| {
            let parts = ["", "_widened", "_error_sampling", "_error_optimisation", "_error_surrogate", "_witness"];
            parts.iter().any(|part| name == format!("{end}{part}"))
        });
        if !is_end && name != "percentile" && !OF_A_ROW.contains(&name.as_str()) {
            faults.push(format!("bounds.csv: nothing says what '{name}' is"));
        }
    }
    (shown, faults)
}
