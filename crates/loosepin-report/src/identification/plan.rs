//! Expected information in features of a motion.

use super::figures::shares;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::remark;
use loosepin_result::motion_identification::{MotionPlan, PlannedFeature};
use loosepin_text::article::{Column, Content, Medium, Section, Table};
use loosepin_text::units::listed;

/// Share of each unknown above which a feature counts as uninformative.
const TELLS_NOTHING: f64 = 0.95;

/// Remaining range of the unknowns by each feature.
pub(super) fn plan_section(plan: &MotionPlan, writer: &NumberWriter<'_>) -> Section {
    let mut section = Section::headed_on_page("next", "What to measure next");
    let head = format!(
        "Share of the box that each feature would leave: mean over simulated measurements at {} values of the unknowns, {} runs each.",
        plan.points, plan.runs_per_point
    );
    section.push_on(Medium::Terminal, Content::sentences([head]));
    push_figure(&mut section, writer, || shares(plan, "next.features".to_owned(), writer));
    section.push_on(Medium::Terminal, Content::Table(shares_table(plan, writer)));
    section.push(Content::points(plan_words(plan, writer).into_iter().map(remark)));
    section
}

fn shares_table(plan: &MotionPlan, writer: &NumberWriter<'_>) -> Table {
    let left = plan.unknowns.iter().map(|unknown| Column::numbers(format!("{} left", unknown.name)));
    let columns = [Column::words("feature"), Column::numbers("box left")].into_iter().chain(left).collect();
    let row = |feature: &PlannedFeature| {
        let shares = std::iter::once(&feature.share_of_box).chain(&feature.shares_of_width);
        let shares = shares.map(|share| writer.percent(*share, Rounding::Up));
        std::iter::once(feature.name.clone()).chain(shares).collect::<Vec<String>>()
    };
    Table::new(columns, plan.features.iter().chain([&plan.together]).map(row))
}

fn plan_words(plan: &MotionPlan, writer: &NumberWriter<'_>) -> Vec<String> {
    let tells = |feature: &PlannedFeature| feature.share_of_box < TELLS_NOTHING;
    let (telling, silent): (Vec<&PlannedFeature>, Vec<&PlannedFeature>) =
        plan.features.iter().partition(|feature| tells(feature));
    let mut words = Vec::new();
    match telling.first() {
        Some(first) => words.push(format!("most telling alone: {}", first.name)),
        None => words.push("no feature alone narrows the unknowns".to_owned()),
    }
    if !silent.is_empty() && !telling.is_empty() {
        let names: Vec<String> = silent.iter().map(|feature| feature.name.clone()).collect();
        words.push(format!("no information alone: {}", listed(&names, "and")));
    }
    for (place, unknown) in plan.unknowns.iter().enumerate() {
        let is_open = plan.together.shares_of_width[place] >= TELLS_NOTHING;
        if is_open && !unknown.is_list {
            words.push(format!("not distinguishable: values of {}, with all of these features", unknown.name));
        }
    }
    if plan.failed > 0 {
        words.push(format!(
            "{} of {} simulated measurements have no values, because their run failed; the means do not include them",
            plan.failed, plan.imagined
        ));
    }
    for alike in &plan.not_distinguishable {
        words.push(format!(
            "not distinguishable: if {} is {}, {} is rejected in {} of the measurements",
            plan.unknowns[alike.unknown].name,
            alike.members[0],
            alike.members[1],
            writer.percent(alike.told, Rounding::Up)
        ));
    }
    words
}
