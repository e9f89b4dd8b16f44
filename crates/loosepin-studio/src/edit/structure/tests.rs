//! Edits of the templates: what comes of them, read again by the library.

use std::collections::BTreeMap;

use loosepin::model::Model;
use loosepin::study::{InputFile, plan_runs};
use loosepin::templates::{TEMPLATES, Template, find_template};

use super::checked::facts;
use super::edit::{Axis, Edit, End, Joined, Named, Watched};
use super::{Restructured, restructured};
use crate::drawing::still::NamedPoses;
use crate::edit::set_uncertainty::set_uncertainty;
use crate::edit::tests::{applied, served, texts};
use crate::files::blank::{BLANK_MODEL, BLANK_STUDY};
use crate::files::folder::Folder;
use crate::network::refusal::Refusal;
use crate::view::texts::Texts;

/// Poses of a template at its start.
fn poses(texts: &Texts) -> NamedPoses {
    let file = texts.read().unwrap();
    let Ok(record) = file.ideal_motion(36, &[]) else { return NamedPoses::new() };
    let table = &record.drawing.poses;
    let pose = |(index, body): (usize, &loosepin::result::simulation::DrawnBody)| {
        let [x, y] = [&table.x_m, &table.y_m].map(|column| 1e3 * column[index][0]);
        (body.name.clone(), [x, y, table.angle_rad[index][0].to_degrees()])
    };
    record.drawing.bodies.iter().enumerate().map(pose).collect()
}

struct Desk {
    _desk: tempfile::TempDir,
    folder: Folder,
    texts: Texts,
    poses: NamedPoses,
}

impl Desk {
    fn of(model: &str, study: &str) -> Self {
        let (desk, folder) = served();
        let texts = texts(&folder, model, study);
        let poses = poses(&texts);
        Self { _desk: desk, folder, texts, poses }
    }

    fn template(template: &Template) -> Self {
        Self::of(template.model, template.study)
    }

    fn try_edit(&self, edit: &Edit) -> Result<Restructured, Refusal> {
        restructured(&self.folder, &self.texts, edit, &self.poses)
    }

    /// The texts after an edit.
    fn after(&self, done: &Restructured) -> Texts {
        applied(&self.folder, &self.texts, &done.changes)
    }

    fn edit(&mut self, edit: &Edit) -> Restructured {
        let done =
            self.try_edit(edit).unwrap_or_else(|refusal| panic!("{edit:?}: {} {:?}", refusal.message, refusal.hint));
        self.texts = self.after(&done);
        self.poses.extend(done.poses.clone());
        done
    }

    /// The same without asking whether it moves.
    fn edit_unasked(&mut self, edit: &Edit) {
        let (texts, new) = super::after(&self.folder, &self.texts, edit, &self.poses)
            .unwrap_or_else(|refusal| panic!("{edit:?}: {} {:?}", refusal.message, refusal.hint));
        self.texts = texts;
        self.poses.extend(new.poses);
    }

    fn model(&self) -> Model {
        Model::from_source(self.texts.model.clone())
            .unwrap_or_else(|found| panic!("{found}\n{}", self.texts.model.text()))
    }

    fn facts(&self) -> BTreeMap<String, String> {
        facts(&self.model())
    }

    fn study(&self) -> &str {
        self.texts.study.as_ref().unwrap().text()
    }
}

fn point(body: &str, point: &str) -> End {
    End::Point { body: body.into(), point: point.into() }
}

/// Lines of a text that another one has not, as often.
fn fresh<'t>(text: &'t str, other: &str) -> Vec<&'t str> {
    let mut left: Vec<&str> = other.split_inclusive('\n').collect();
    let is_fresh = |line: &&str| match left.iter().position(|one| one == line) {
        Some(place) => {
            left.remove(place);
            false
        }
        None => true,
    };
    text.split_inclusive('\n').filter(is_fresh).collect()
}

#[test]
fn a_link_becomes_a_dyad_and_moves_as_its_geometry_says() {
    let mut desk = Desk::template(find_template("four-bar").unwrap());
    let before = desk.texts.model.text().to_owned();
    let open = desk.edit(&Edit::AddLink { from: point("coupler", "tracer"), to: End::Free { x: 300.0, y: 300.0 } });
    assert_eq!(open.name.as_deref(), Some("link_1"));
    assert!(!open.is_complete && open.says[0].starts_with("1 degree of freedom too many: 'link_1'"), "{:?}", open.says);
    // All that was there is there, letter for letter.
    assert_eq!(fresh(&before, desk.texts.model.text()), ["guess = { rocker = \"94 deg\" }\n"]);
    let closed = desk.edit(&Edit::AddLink {
        from: point("link_1", "b"),
        to: End::On { body: "ground".into(), x: 450.0, y: 0.0, is_own: false },
    });
    assert!(closed.is_complete && closed.says[0].starts_with("1 degree of freedom, 1 drive"), "{:?}", closed.says);
    // At the start the new pin lies where it was drawn: by the ideal motion of the library.
    let record = desk.texts.read().unwrap().ideal_motion(36, &[]).unwrap();
    let table = &record.drawing.poses;
    let body = record.drawing.bodies.iter().position(|body| body.name == "link_2").unwrap();
    let found = [1e3 * table.x_m[body][0], 1e3 * table.y_m[body][0]];
    assert!((found[0] - 300.0).abs() < 0.005 && (found[1] - 300.0).abs() < 0.005, "{found:?}");
    // Its length is the distance from (300, 300) to (450, 0), to a thousandth of a millimetre.
    let length_mm = 150.0_f64.hypot(300.0);
    assert!(
        desk.texts.model.text().contains(&format!("link_2_length = \"{:.2} mm\"", length_mm)),
        "{}",
        desk.texts.model.text()
    );
}

/// A four-bar of 30, 120, 90 on a base of 110 mm with a point on its coupler, drawn on an empty sheet.
fn drawn_four_bar() -> Desk {
    let mut desk = Desk::of(BLANK_MODEL, BLANK_STUDY);
    let ground = |x: f64, y: f64| End::On { body: "ground".into(), x, y, is_own: false };
    let free = |x: f64, y: f64| End::Free { x, y };
    desk.edit(&Edit::AddLink { from: ground(0.0, 0.0), to: free(15.0, 26.0) });
    desk.edit(&Edit::AddLink { from: point("link_1", "b"), to: free(120.0, 90.0) });
    desk.edit(&Edit::AddLink { from: point("link_2", "b"), to: ground(110.0, 0.0) });
    desk.edit(&Edit::AddPoint { body: "link_2".into(), to: free(60.0, 110.0) });
    desk
}

#[test]
fn a_four_bar_is_drawn_on_an_empty_sheet() {
    let mut desk = drawn_four_bar();
    let record = desk.texts.read().unwrap().ideal_motion(73, &[]).unwrap();
    assert_eq!(record.mobility, "1 degree of freedom, 1 drive");
    // The crank turns from where it was drawn, and the cycle counts its turns.
    let model = desk.texts.model.text();
    assert!(model.contains("start_angle = \"60.0184 deg\""), "{model}");
    assert!(model.contains("drive = \"motor\"\ntransient_turns = 1") && !model.contains("duration"), "{model}");
    assert!(!model.contains("link_1 = \"60"), "the motor says how the crank lies: {model}");
    let table = &record.drawing.poses;
    let body = record.drawing.bodies.iter().position(|body| body.name == "link_3").unwrap();
    let found = [1e3 * table.x_m[body][0], 1e3 * table.y_m[body][0]];
    assert!((found[0] - 120.0).abs() < 0.005 && (found[1] - 90.0).abs() < 0.005, "{found:?}");
    // A play that is typed, and a study that asks: it runs.
    assert!(desk.texts.read_to_run().is_err(), "nothing is uncertain, and nothing is asked");
    desk.edit(&Edit::Watch { what: Watched::Path { body: "link_2".into(), point: "p1".into() } });
    let changes = set_uncertainty(&desk.folder, &desk.texts, "joint.link_2_a.radial_clearance", "0.05..0.2").unwrap();
    desk.texts = applied(&desk.folder, &desk.texts, &changes);
    let file = desk.texts.read_to_run().unwrap_or_else(|found| panic!("{found}\n{}", desk.study()));
    let record = file.ideal_motion(73, &[]).unwrap();
    let [path] = &record.paths[..] else { panic!("one path") };
    let widest_m = path.play_reach_m.iter().copied().fold(0.0, f64::max);
    assert!(widest_m > 0.05e-3, "the play of 0.05 to 0.2 mm moves the point: {widest_m}");
}

#[test]
fn a_study_that_asks_nothing_asks_about_the_first_output() {
    let named = |name: &str| name.to_owned();
    let of_point = |along| Watched::Position { body: named("link_2"), point: named("p1"), along };
    for what in [
        Watched::Path { body: named("link_2"), point: named("p1") },
        of_point(Axis::X),
        of_point(Axis::Y),
        Watched::Angle { body: named("link_3") },
        Watched::AngularVelocity { body: named("link_3") },
        Watched::Force { joint: named("link_2_a") },
    ] {
        let mut desk = drawn_four_bar();
        let changes =
            set_uncertainty(&desk.folder, &desk.texts, "joint.link_2_a.radial_clearance", "0.1..0.2").unwrap();
        desk.texts = applied(&desk.folder, &desk.texts, &changes);
        desk.edit(&Edit::Watch { what: what.clone() });
        let file = desk.texts.read_to_run().unwrap_or_else(|found| panic!("{what:?}\n{found}\n{}", desk.study()));
        plan_runs(&file.into_study().unwrap()).unwrap_or_else(|error| panic!("{what:?}: {error}"));
        let before = desk.study().to_owned();
        desk.edit(&Edit::Watch { what });
        assert_eq!(desk.study(), before, "what is asked already is left");
    }
}

#[test]
fn whatever_goes_takes_what_names_it_along() {
    let mut desk = Desk::template(find_template("four-bar").unwrap());
    let done = desk.edit(&Edit::Remove { what: Named::new("body", "rocker") });
    let due = [
        "body 'rocker'",
        "joint 'rocker_pin'",
        "joint 'rocker_pivot'",
        "output 'pin_force'",
        "output 'rocker'",
        "output 'rocker_speed'",
    ];
    assert!(due.iter().all(|one| done.gone.iter().any(|gone| gone == one)), "{:?}", done.gone);
    for entry in [
        "parameter 'rocker_length'",
        "parameter 'rocker_mass'",
        "the distribution of parameter 'rocker_length' in the study",
        "the unknown range of joint 'rocker_pin': radial clearance in the study",
        "question 1 of the study",
        "question 2 of the study",
        "requirement 1 of the study",
    ] {
        assert!(done.gone.iter().any(|gone| gone == entry), "{entry}: {:?}", done.gone);
    }
    assert!(
        !done.is_complete && done.says.iter().any(|words| words.contains("the study asks no question")),
        "{:?}",
        done.says
    );
    assert!(!desk.texts.model.text().contains("rocker =") && !desk.study().contains("\"rocker\""), "{}", desk.study());
    assert!(desk.texts.model.text().contains("# The bearing is the hole, the journal is the pin."));
}

/// A first link is taken out again, with its motor: the sheet is empty, and what is drawn next is turned again.
#[test]
fn the_first_link_goes_with_its_motor_and_another_is_drawn() {
    let mut desk = Desk::of(BLANK_MODEL, BLANK_STUDY);
    let link = Edit::AddLink {
        from: End::On { body: "ground".into(), x: 0.0, y: 0.0, is_own: false },
        to: End::Free { x: 15.0, y: 26.0 },
    };
    for _ in 0..2 {
        desk.edit(&link);
        assert!(desk.texts.model.text().contains("drive = \"motor\"") && !desk.texts.model.text().contains("duration"));
        let done = desk.edit(&Edit::Remove { what: Named::new("body", "link_1") });
        assert!(done.gone.iter().any(|gone| gone == "drive 'motor'"), "{:?}", done.gone);
        let model = desk.model();
        assert!(model.drives.is_empty() && model.joints.is_empty() && model.bodies.len() == 1);
        assert!(desk.texts.model.text().contains("duration = \"1 s\""), "{}", desk.texts.model.text());
    }
    // The motor alone.
    desk.edit(&link);
    desk.edit(&Edit::Remove { what: Named::new("drive", "motor") });
    assert_eq!((desk.model().drives.len(), desk.model().bodies.len()), (0, 2));
}

/// The cycle of a mechanism with two drives counts the turns of one: it does not begin to count those of the other unasked.
#[test]
fn a_counted_drive_stays_where_another_one_is() {
    let two = TEMPLATES.iter().map(Desk::template).find(|desk| desk.model().drives.len() > 1).unwrap();
    let text = two.texts.model.text();
    let counted =
        two.model().drives.into_iter().find(|drive| text.contains(&format!("\ndrive = \"{}\"", drive.name))).unwrap();
    let refusal = two.try_edit(&Edit::Remove { what: Named::new("drive", &counted.name) }).unwrap_err();
    assert!(
        refusal.message.contains(&format!("the cycle counts the turns of drive '{}'", counted.name)),
        "{}",
        refusal.message
    );
}

/// Every link of every template.
#[test]
fn what_is_added_and_taken_out_leaves_the_model_as_it_was() {
    let mut count = 0;
    for template in TEMPLATES {
        let first = Desk::template(template);
        let model = first.model();
        let places: Vec<(String, String)> = model
            .bodies
            .iter()
            .flat_map(|body| body.points.iter().map(|point| (body.name.clone(), point.name.clone())))
            .collect();
        let before = first.facts();
        let pairs = (1..4).flat_map(|step| places.iter().zip(places.iter().skip(step)));
        for (from, to) in pairs {
            let mut desk = Desk::template(template);
            let edit = Edit::AddLink { from: point(&from.0, &from.1), to: point(&to.0, &to.1) };
            match super::after(&desk.folder, &desk.texts, &edit, &desk.poses) {
                Ok((texts, _)) => desk.texts = texts,
                Err(refusal) => {
                    let is_expected =
                        refusal.message.contains("no length") || refusal.message.contains("on the same body");
                    assert!(is_expected, "{}: {}", template.name, refusal.message);
                    continue;
                }
            }
            let name = "link_1".to_owned();
            // Nothing of the old text is lost, but for the line of the guesses that has one more now.
            let lost = fresh(template.model, desk.texts.model.text());
            assert!(lost.iter().all(|line| line.contains("guess = {")), "{}: {lost:?}", template.name);
            assert_eq!(desk.study(), template.study);
            desk.edit_unasked(&Edit::Remove { what: Named::new("body", &name) });
            assert_eq!(desk.facts(), before, "{} {edit:?}", template.name);
            assert_eq!(desk.study(), template.study);
            count += 1;
        }
        // The same with a block, a point and a joint.
        let (body, own) = places.iter().find(|(body, _)| body != "ground").unwrap();
        let mut desk = Desk::template(template);
        let block = desk.edit(&Edit::AddBlock { on: point(body, own), angle_deg: 30.0 }).name.unwrap();
        assert_eq!(desk.model().joints.len(), model.joints.len() + 2);
        desk.edit(&Edit::Remove { what: Named::new("body", &block) });
        let ground =
            desk.facts().keys().find(|path| path.starts_with("body.ground") && !before.contains_key(*path)).cloned();
        let ground = ground.unwrap();
        let name = ground.split('.').nth(3).unwrap();
        desk.edit(&Edit::Remove { what: Named::point("ground", name) });
        assert_eq!(desk.facts(), before, "{}", template.name);
        let on = End::On { body: body.clone(), x: 12.5, y: -7.25, is_own: true };
        let new = desk.edit(&Edit::AddPoint { body: body.clone(), to: on }).name.unwrap();
        let new = new.split_once('.').unwrap().1.to_owned();
        let x: f64 = desk.facts()[&format!("body.{body}.points.{new}.x")].parse().unwrap();
        assert!((x - 0.0125).abs() < 1e-15);
        desk.edit(&Edit::Remove { what: Named::point(body, &new) });
        assert_eq!(desk.facts(), before, "{}", template.name);
    }
    assert!(count > 60, "{count} links");
}

#[test]
fn everything_of_every_template_is_taken_out_or_refused_with_words() {
    let mut taken = 0;
    for template in TEMPLATES {
        let desk = Desk::template(template);
        let model = desk.model();
        let names = model.bodies.iter().skip(1).map(|one| Named::new("body", &one.name));
        let names = names.chain(model.joints.iter().map(|one| Named::new("joint", &one.name)));
        let names = names.chain(model.outputs.iter().map(|one| Named::new("output", &one.name)));
        let names = names.chain(model.controls.iter().map(|one| Named::new("control", &one.name)));
        for what in names {
            match desk.try_edit(&Edit::Remove { what: what.clone() }) {
                Ok(done) => {
                    let after = desk.after(&done);
                    taken += 1;
                    assert!(fresh(after.model.text(), template.model).len() <= 1, "{} {what:?}", template.name);
                    let found = facts(&Model::from_source(after.model.clone()).unwrap());
                    assert!(!found.contains_key(&format!("{}.{}", what.table, what.name)));
                    // Comments on lines of their own stay.
                    let own = |text: &str| text.lines().filter(|line| line.starts_with('#')).count();
                    assert_eq!(own(after.model.text()), own(template.model), "{} {what:?}", template.name);
                }
                Err(refusal) => {
                    let is_counted = refusal.message.contains("the cycle counts") && model.drives.len() > 1;
                    assert!(is_counted, "{} {what:?}: {}", template.name, refusal.message)
                }
            }
        }
    }
    assert!(taken > 150, "{taken}");
}

#[test]
fn another_name_stands_wherever_the_old_one_did() {
    for template in TEMPLATES {
        let mut desk = Desk::template(template);
        let model = desk.model();
        let before = desk.facts();
        let names = model.bodies.iter().skip(1).map(|one| Named::new("body", &one.name));
        let points =
            model.bodies.iter().flat_map(|body| body.points.iter().map(|one| Named::point(&body.name, &one.name)));
        let names = names.chain(model.joints.iter().map(|one| Named::new("joint", &one.name)));
        let names = names.chain(model.drives.iter().map(|one| Named::new("drive", &one.name)));
        let names = names.chain(model.controls.iter().map(|one| Named::new("control", &one.name)));
        let names = names.chain(model.contacts.iter().map(|one| Named::new("contact", &one.name)));
        let names = names.chain(model.outputs.iter().map(|one| Named::new("output", &one.name)));
        let mut known = std::collections::BTreeSet::new();
        for what in points.chain(names) {
            // Letters that need quotes for the first of each.
            let tos: &[&str] =
                if known.insert(what.table.clone()) { &["renamed-1", "größe"] } else { &["renamed-1"] };
            for to in tos.iter().copied() {
                let renamed = match &what.point {
                    Some(_) => Named::point(&what.name, to),
                    None => Named::new(&what.table, to),
                };
                let back = what.point.clone().unwrap_or_else(|| what.name.clone());
                desk.edit_unasked(&Edit::Rename { what: what.clone(), to: to.into() });
                assert_ne!(desk.facts(), before, "{} {what:?}", template.name);
                desk.texts.read().unwrap_or_else(|found| panic!("{} {what:?}: {found}", template.name));
                desk.edit_unasked(&Edit::Rename { what: renamed, to: back });
                assert_eq!(desk.facts(), before, "{} {what:?}", template.name);
                if to.is_ascii() {
                    assert_eq!(desk.texts.model.text(), template.model, "{} {what:?}", template.name);
                    assert_eq!(desk.study(), template.study, "{} {what:?}", template.name);
                } else {
                    // Quotes that a name needs stay, and are as good.
                    desk.texts = texts(&desk.folder, template.model, template.study);
                }
            }
        }
        let first = &model.joints[0].name;
        for to in [first.as_str(), "", "1a", "a b", "a.b", "a\"b", &"x".repeat(65)] {
            let what = Named::new("joint", &model.joints[1].name);
            assert!(desk.try_edit(&Edit::Rename { what, to: to.into() }).is_err(), "{to}");
        }
    }
}

#[test]
fn two_points_are_joined_as_a_pin_with_play_a_slider_or_a_slot() {
    let mut desk = Desk::template(find_template("four-bar").unwrap());
    desk.edit(&Edit::AddLink { from: point("coupler", "tracer"), to: End::Free { x: 300.0, y: 300.0 } });
    let ground = || End::On { body: "ground".into(), x: 300.0, y: 300.0, is_own: false };
    for (by, line) in [
        (Joined::Pin { play: None }, "kind = \"revolute\""),
        (Joined::Pin { play: Some("0.1..0.3 mm".into()) }, "radial_clearance = \"0.1 mm\""),
        (Joined::Slider { angle_deg: 90.0 }, "kind = \"prismatic\""),
        (Joined::Slot { angle_deg: -45.0 }, "slot = { point = \"ground.p1\", angle = \"-45 deg\" }"),
        (Joined::Rigid, "kind = \"rigid\""),
    ] {
        let done = desk.try_edit(&Edit::Join { first: ground(), second: point("link_1", "b"), by: by.clone() });
        let done = done.unwrap_or_else(|refusal| panic!("{by:?}: {}", refusal.message));
        let after = desk.after(&done);
        assert!(after.model.text().contains(line), "{}", after.model.text());
        // A slot leaves the link its turn: one degree of freedom, as before the link came; a pin takes one more away.
        let due = match by {
            Joined::Slot { .. } => "1 degree of freedom, 1 drive",
            Joined::Pin { .. } | Joined::Slider { .. } | Joined::Rigid => "block one another",
        };
        assert!(done.says[0].contains(due), "{by:?} {:?}", done.says);
        assert_eq!(done.is_complete, matches!(by, Joined::Slot { .. }), "{by:?}");
        if let Joined::Pin { play: Some(_) } = by {
            assert!(
                after
                    .study
                    .as_ref()
                    .unwrap()
                    .text()
                    .contains("radial_clearance\" = { interval = [\"0.1 mm\", \"0.3 mm\"] }")
            );
        }
    }
    let again = desk.try_edit(&Edit::Join {
        first: point("link_1", "a"),
        second: point("coupler", "tracer"),
        by: Joined::Pin { play: None },
    });
    assert!(again.unwrap_err().message.contains("already joins these points"));
}

#[test]
fn the_motor_turns_another_pin_and_the_first_crank_can_go() {
    let mut desk = Desk::template(find_template("four-bar").unwrap());
    let done = desk.edit(&Edit::Drive { joint: "rocker_pivot".into() });
    // The rocker stands at about 94 degrees at the start; the links let it go neither much further nor all the way round.
    assert!(desk.texts.model.text().contains("joint = \"rocker_pivot\""));
    assert!(done.says.iter().any(|words| words.contains("dead point")), "{:?}", done.says);
    let text = desk.texts.model.text();
    let start = text.lines().find(|line| line.starts_with("start_angle")).unwrap();
    let start: f64 = start.split('"').nth(1).unwrap().trim_end_matches(" deg").parse().unwrap();
    assert!((start - 93.65).abs() < 0.1, "{start}");
    desk.edit(&Edit::Remove { what: Named::new("body", "crank") });
    assert_eq!(desk.model().bodies.len(), 3);
    assert!(desk.try_edit(&Edit::Drive { joint: "rocker_pin".into() }).unwrap_err().message.contains("has play"));
}

#[test]
fn a_locked_number_is_left_by_drags_and_unlocks_without_a_trace() {
    for template in TEMPLATES {
        let mut desk = Desk::template(template);
        let before = desk.facts();
        let paths: Vec<String> = desk
            .model()
            .quantities
            .iter()
            .filter(|(_, quantity)| quantity.span.is_some() && quantity.origin == loosepin::model::Origin::Literal)
            .map(|(_, quantity)| quantity.path.clone())
            .collect();
        for path in paths {
            let was = desk.texts.model.text().to_owned();
            desk.edit_unasked(&Edit::Lock { path: path.clone(), is_locked: true });
            assert_eq!(desk.facts(), before, "{} {path}", template.name);
            let locks = super::Locks::of(desk.texts.model.text());
            let model = desk.model();
            let span = model.quantities[model.quantities.id(&path).unwrap()].span.unwrap();
            assert!(locks.hold(span.start), "{} {path}", template.name);
            desk.edit_unasked(&Edit::Lock { path: path.clone(), is_locked: false });
            assert_eq!(desk.texts.model.text(), was, "{} {path}", template.name);
        }
    }
}

/// The four-bar written in other ways.
fn odd_models() -> Vec<(&'static str, String)> {
    let plain = find_template("four-bar").unwrap().model;
    let dotted = plain
        .replace("[body.ground]\npoints = { crank_pivot = ", "[body.ground]\npoints.crank_pivot = ")
        .replace(
            "[\"0 mm\", \"0 mm\"], rocker_pivot = [\"base_length\", \"0 mm\"] }",
            "[\"0 mm\", \"0 mm\"]\npoints.rocker_pivot = [\"base_length\", \"0 mm\"]",
        )
        .replace("guess = { rocker = \"94 deg\" }", "guess.rocker = \"94 deg\"");
    let headers = plain
        .replace("points = { pivot = [\"0 mm\", \"0 mm\"], pin = [\"rocker_length\", \"0 mm\"] }",
            "[body.rocker.points]\n  # the pin on the ground\n  pivot = [\"0 mm\", \"0 mm\"]\n  'pin' = [ \"rocker_length\", # long\n    \"0 mm\" ]")
        .replace("[joint.rocker_pin] ", "[ joint . \"rocker_pin\" ] ");
    let inline = plain.replace(
        "[output.rocker]\nangle_of = \"rocker\"\n\n[output.rocker_speed]\nangular_velocity_of = \"rocker\"\n",
        "[output]\nrocker = { angle_of = \"rocker\" } # one\nrocker_speed.angular_velocity_of = 'rocker'\n",
    );
    let dos = plain.replace('\n', "\r\n");
    vec![("plain", plain.to_owned()), ("dotted", dotted), ("headers", headers), ("inline", inline), ("dos", dos)]
}

#[test]
fn models_that_are_written_otherwise_are_edited_too() {
    let study = find_template("four-bar").unwrap().study;
    let due = facts(&Model::from_text("model.toml", find_template("four-bar").unwrap().model).unwrap());
    for (name, model) in odd_models() {
        let mut desk = Desk::of(&model, study);
        let before = desk.facts();
        assert_eq!(before, due, "{name}");
        let link = desk.edit(&Edit::AddLink {
            from: point("coupler", "tracer"),
            to: End::On { body: "ground".into(), x: 100.0, y: 250.0, is_own: false },
        });
        let link = link.name.unwrap();
        for what in [Named::new("body", "rocker"), Named::point("rocker", "pin"), Named::new("joint", "rocker_pin")] {
            let to = "other";
            desk.edit(&Edit::Rename { what: what.clone(), to: to.into() });
            let renamed = match &what.point {
                Some(_) => Named::point(&what.name, to),
                None => Named::new(&what.table, to),
            };
            let back = what.point.clone().unwrap_or_else(|| what.name.clone());
            desk.edit(&Edit::Rename { what: renamed, to: back });
        }
        desk.edit(&Edit::Remove { what: Named::new("body", &link) });
        desk.edit(&Edit::Remove { what: Named::point("ground", "p1") });
        assert_eq!(desk.facts(), before, "{name}\n{}", desk.texts.model.text());
        let ends = |text: &str| (text.matches('\n').count(), text.matches("\r\n").count());
        let (all, dos) = ends(desk.texts.model.text());
        assert_eq!(dos, if name == "dos" { all } else { 0 }, "{name}");
        desk.edit(&Edit::Remove { what: Named::new("body", "rocker") });
        assert!(!desk.facts().keys().any(|path| path.starts_with("body.rocker")), "{name}");
    }
}

#[test]
fn random_edits_never_panic_and_never_leave_what_is_no_model() {
    let (taken, refused) = random_sequences(60, 11);
    assert!(taken > 300 && refused > 100, "{taken} taken, {refused} refused");
}

#[test]
#[ignore = "minutes; just campaign studio-edits"]
fn campaign_thousands_of_random_sequences() {
    let sequences = std::env::var("SEQUENCES").ok().and_then(|count| count.parse().ok()).unwrap_or(3000);
    let (taken, refused) = random_sequences(sequences, 2026);
    eprintln!("{taken} edits taken, {refused} refused");
}

/// Sequences of edits of templates and of models that are written otherwise: how many were taken, and how many refused.
fn random_sequences(sequences: usize, seed: u64) -> (usize, usize) {
    let mut state = seed;
    let mut below = |count: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % count.max(1)
    };
    let odd: Vec<String> = odd_models().into_iter().map(|(_, model)| model).collect();
    let (mut taken, mut refused) = (0, 0);
    for round in 0..sequences {
        let mut desk = match round % 3 {
            0 => Desk::of(&odd[below(odd.len())], find_template("four-bar").unwrap().study),
            _ => Desk::template(&TEMPLATES[below(TEMPLATES.len())]),
        };
        for step in 0..10 {
            let model = desk.model();
            let body = model.bodies[below(model.bodies.len())].clone();
            let other = &model.bodies[below(model.bodies.len())];
            let place = || [-1e300, f64::NAN, 0.0, 33.0, -140.5, 1e8];
            let mut end = |body: &loosepin::model::Body| {
                let named = body.points.get(below(body.points.len() + 1)).map_or("<none>", |point| &point.name);
                let furthest = if below(8) == 0 { 6 } else { 5 };
                let [x, y] = [0, 1].map(|_| place()[below(furthest).max(2)]);
                match below(4) {
                    0 => End::Free { x, y },
                    1 => End::On { body: body.name.clone(), x, y, is_own: x > 0.0 },
                    _ => point(&body.name, named),
                }
            };
            let (from, to) = (end(&body), end(other));
            let any = |list: Vec<String>, at: usize| list.get(at % list.len().max(1)).cloned().unwrap_or("none".into());
            let joint = any(model.joints.iter().map(|one| one.name.clone()).collect(), below(100));
            let output = any(model.outputs.iter().map(|one| one.name.clone()).collect(), below(100));
            let named = [Named::new("body", &body.name), Named::new("joint", &joint), Named::new("output", &output)];
            let what = named[below(3)].clone();
            let angle_deg = [0.0, 90.0, f64::INFINITY, -31.7][below(4)];
            let (first_body, first_point) =
                (body.name.clone(), body.points.first().map(|one| one.name.clone()).unwrap_or_default());
            let edit = match below(10) {
                0 | 1 => Edit::AddLink { from, to },
                2 => Edit::AddPoint { body: body.name.clone(), to },
                3 => Edit::Join {
                    first: from,
                    second: to,
                    by: [
                        Joined::Pin { play: None },
                        Joined::Pin { play: Some(["0.1 mm", "x", "0.1..0.2", "]"][below(4)].into()) },
                        Joined::Slider { angle_deg },
                        Joined::Slot { angle_deg },
                        Joined::Rigid,
                    ][below(5)]
                    .clone(),
                },
                4 => Edit::AddBlock { on: from, angle_deg },
                5 => Edit::Drive { joint },
                6 => Edit::Remove { what },
                8 => Edit::Watch {
                    what: [
                        Watched::Path { body: first_body.clone(), point: first_point.clone() },
                        Watched::Position { body: first_body.clone(), point: first_point, along: Axis::Y },
                        Watched::Angle { body: first_body.clone() },
                        Watched::AngularVelocity { body: first_body },
                        Watched::Force { joint },
                    ][below(5)]
                    .clone(),
                },
                7 => Edit::Rename { what, to: ["a", "b-1", "ü", "]", "x.y", "\"", ""][below(7)].into() },
                _ => {
                    let (_, quantity) = model.quantities.iter().nth(below(model.quantities.len())).unwrap();
                    Edit::Lock { path: quantity.path.clone(), is_locked: below(2) == 0 }
                }
            };
            // The last one with all that the page is told.
            let done = if step == 9 {
                desk.try_edit(&edit).map(|done| (desk.after(&done), done.poses))
            } else {
                super::after(&desk.folder, &desk.texts, &edit, &desk.poses).map(|(texts, new)| (texts, new.poses))
            };
            match done {
                Ok((after, poses)) => {
                    taken += 1;
                    Model::from_source(after.model.clone())
                        .unwrap_or_else(|found| panic!("{edit:?}: {found}\n{}", after.model.text()));
                    let study = after.study.as_ref().unwrap();
                    assert!(loosepin::document::parse_toml(study).is_ok(), "{edit:?}\n{}", study.text());
                    desk.poses.extend(poses);
                    desk.texts = after;
                }
                Err(refusal) => {
                    refused += 1;
                    assert!(refusal.message.len() > 10, "{edit:?}: {}", refusal.message);
                }
            }
        }
    }
    (taken, refused)
}

#[test]
fn an_output_is_added_under_a_name_that_is_free_and_taken_out_again() {
    let mut desk = Desk::template(find_template("four-bar").unwrap());
    let before = desk.texts.model.text().to_owned();
    let (body, point) = ("coupler".to_owned(), "tracer".to_owned());
    let wishes = [
        (Watched::Path { body: body.clone(), point: point.clone() }, "tracer_1", "path_of = \"coupler.tracer\"\n"),
        (
            Watched::Position { body: body.clone(), point, along: Axis::Y },
            "coupler_y",
            "position_of = \"coupler.tracer\"\nalong = \"y\"\n",
        ),
        (Watched::Angle { body: body.clone() }, "coupler_angle", "angle_of = \"coupler\"\n"),
        (Watched::AngularVelocity { body }, "coupler_speed", "angular_velocity_of = \"coupler\"\n"),
        (
            Watched::Force { joint: "crank_pin".into() },
            "crank_pin_force",
            "force_in = \"joint.crank_pin\"\ncomponent = \"magnitude\"\n",
        ),
    ];
    for (what, name, entries) in wishes {
        let done = desk.edit(&Edit::Watch { what });
        assert_eq!(done.name.as_deref(), Some(name));
        assert!(
            desk.texts.model.text().contains(&format!("[output.{name}]\n{entries}")),
            "{}",
            desk.texts.model.text()
        );
        assert!(desk.model().outputs.iter().any(|one| one.name == name));
        desk.edit(&Edit::Remove { what: Named::new("output", name) });
        assert_eq!(desk.texts.model.text().trim_end(), before.trim_end());
    }
    let refusal = desk.try_edit(&Edit::Watch { what: Watched::Angle { body: "nobody".into() } });
    assert!(refusal.is_err_and(|refusal| refusal.message.contains("nobody")));
}

#[test]
fn an_open_mechanism_is_drawn_where_it_was_put_together() {
    let mut desk = Desk::template(find_template("slider-crank").unwrap());
    desk.edit(&Edit::AddLink { from: point("rod", "big_end"), to: End::Free { x: 90.0, y: 80.0 } });
    let model = crate::messages::SentText { path: "model.toml".into(), text: desk.texts.model.text().into() };
    let look = crate::messages::Look { poses: Some(desk.poses.clone()), ..crate::messages::Look::of(model, None, 37) };
    let view = crate::view::look::look(&desk.folder, &look).view.expect("a picture");
    assert!(view.incomplete.is_some_and(|words| words.starts_with("1 degree of freedom too many: 'link_1'")));
    assert!(view.drawing.is_some() && view.bands.is_empty());
    let InputFile::Study(_) = desk.texts.read().unwrap() else { panic!("a study") };
}
