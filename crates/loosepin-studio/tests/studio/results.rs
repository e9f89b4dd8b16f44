//! Finished results: two compared, a witness run by itself, values taken into the texts, and what is no result.

use std::fs;
use std::path::Path;

use crate::client::{Live, Server};
use loosepin::templates::find_template;
use serde_json::{Value, json};

/// A short study of the slider-crank in a folder, with pieces of both texts replaced.
fn written(root: &Path, name: &str, replaced: &[(&str, &str)]) -> String {
    let template = find_template("slider-crank").unwrap();
    // So few runs show a share of 90 %, and not of 95 %.
    let short = [("outer = 16 ", "outer = 5 "), ("at_least = 0.95 ", "at_least = 0.9 ")];
    let mut texts = [template.model.to_owned(), template.study.to_owned()];
    for (old, new) in short.iter().chain(replaced) {
        assert!(texts.iter().any(|text| text.contains(old)), "{old}");
        texts = texts.map(|text| text.replace(old, new));
    }
    fs::create_dir_all(root.join(name)).unwrap();
    fs::write(root.join(name).join("model.toml"), &texts[0]).unwrap();
    fs::write(root.join(name).join("study.toml"), &texts[1]).unwrap();
    format!("{name}/study.toml")
}

fn ended(live: &mut Live) -> Value {
    loop {
        let job = live.next_of("job")["job"].clone();
        if job["state"] != "waiting" && job["state"] != "running" {
            return job;
        }
    }
}

/// Runs a study, and gives the path of its result.
fn run(live: &mut Live, study: &str) -> String {
    live.send(&json!({"kind": "run", "study": study}));
    let job = ended(live);
    assert_eq!(job["state"], "done", "{job}");
    job["result"].as_str().unwrap().to_owned()
}

fn compared(server: &Server, before: &str, after: &str) -> (u16, Value) {
    server.ask("POST", "/api/compare", &json!({"before": before, "after": after}).to_string())
}

fn texts_of(root: &Path, name: &str) -> [Value; 2] {
    ["model.toml", "study.toml"].map(|file| {
        let text = fs::read_to_string(root.join(name).join(file)).unwrap();
        json!({"path": format!("{name}/{file}"), "text": text})
    })
}

#[test]
fn two_studies_are_compared_and_odd_pairs_say_why_not() {
    let desk = tempfile::tempdir().unwrap();
    let root = desk.path();
    let worn = written(root, "worn", &[]);
    let measured = written(root, "measured", &[("[\"0.1 mm\", \"0.5 mm\"]", "[\"0.1 mm\", \"0.15 mm\"]")]);
    let other = written(
        root,
        "other",
        &[
            ("name = \"slider-crank with", "name = \"another"),
            ("output = \"slider\"", "output = \"slider_2\""),
            ("[output.slider]", "[output.slider_2]"),
        ],
    );
    let server = Server::of(root);
    let mut live = server.live();
    let [before, after, unlike] = [&worn, &measured, &other].map(|study| run(&mut live, study));
    let (status, found) = compared(&server, &before, &after);
    assert_eq!(status, 200, "{found}");
    // Play up to a third of what it was: the band is narrower, but five values of the play do not show that beyond the errors of both
    // bands. The share of mechanisms within the limits does.
    let headline = found["headline"].as_str().unwrap();
    assert!(
        headline.starts_with("Deviation of slider over the whole cycle: not met in A, met in B. Required: "),
        "{headline}"
    );
    assert!(headline.contains("; they differ by more than their errors. "), "{headline}");
    assert!(headline.contains(" This difference may be numerical: the errors are "), "{headline}");
    let inputs = found["inputs"].as_array().unwrap();
    assert_eq!(inputs.len(), 1, "{inputs:?}");
    assert_eq!(inputs[0]["path"], "joint.gudgeon.radial_clearance");
    assert_eq!(inputs[0]["before"], "somewhere between 0.1 mm and 0.5 mm");
    assert_eq!(inputs[0]["after"], "somewhere between 0.1 mm and 0.15 mm");
    let figure = found["bands"][0]["figure"].as_str().unwrap();
    assert!(
        figure.starts_with("<svg xmlns=") && figure.matches("class=\"fill ").count() == 4,
        "two bands and two signs"
    );
    assert_eq!(found["sides"][0]["verdict"], "not_met");
    assert!(!found["statistics"].as_array().unwrap().is_empty());
    // Other outputs: nothing is compared, and that is said.
    let (status, found) = compared(&server, &before, &unlike);
    assert_eq!(
        (status, found["statistics"].as_array().unwrap().len(), found["bands"].as_array().unwrap().len()),
        (200, 0, 0)
    );
    let left_out = found["left_out"].to_string();
    assert!(left_out.contains("'slider' is only in A") && left_out.contains("'slider_2' is only in B"), "{left_out}");
    assert_eq!(found["headline"], "The two studies have no answer in common.");
    // The same one twice, also by another way to it.
    let (status, refused) = compared(&server, &before, &format!("{before}/"));
    assert_eq!((status, refused["message"].as_str()), (400, Some("both are the same result")));
    assert_eq!(compared(&server, &before, "results/nothing").0, 404);
    assert_eq!(compared(&server, &before, "worn").0, 404, "a folder without a result");
    assert_eq!(compared(&server, "", &before).0, 403);
    // A summary that is cut off, one of another layout, and none.
    let summary = root.join(&after).join("summary.json");
    let whole = fs::read_to_string(&summary).unwrap();
    for (broken, words) in [
        (whole[..whole.len() / 2].to_owned(), "does not have the format of this version"),
        (whole.replacen("\"format\": 2", "\"format\": 99", 1), "has format 99"),
        ("[1, 2".to_owned(), "does not have the format of this version"),
    ] {
        assert_ne!(broken, whole);
        fs::write(&summary, broken).unwrap();
        let (status, refused) = compared(&server, &before, &after);
        assert!(status == 400 && refused["message"].as_str().unwrap().contains(words), "{refused}");
        assert!(refused["hint"].as_str().unwrap().contains("run the study again"), "{refused}");
    }
    fs::remove_file(&summary).unwrap();
    assert_eq!(compared(&server, &before, &after).0, 404);
}

#[test]
fn a_witness_is_run_by_itself_and_is_no_study() {
    let desk = tempfile::tempdir().unwrap();
    let study = written(desk.path(), "worn", &[]);
    let server = Server::of(desk.path());
    let mut live = server.live();
    let result = run(&mut live, &study);
    let (status, doings) = server.ask("POST", "/api/result", &json!({"path": result}).to_string());
    assert_eq!(status, 200, "{doings}");
    assert_eq!(doings["studies"], json!([study]));
    let witness = &doings["witnesses"][0];
    // The requirement is kept least with most play.
    assert_eq!(witness["values"][0], "gudgeon radial clearance 0.5\u{a0}mm", "{witness}");
    assert!(
        witness["attains"][0].as_str().unwrap().starts_with("fewest mechanisms stay within the limit"),
        "{witness}"
    );
    live.send(&json!({"kind": "simulate", "result": result, "witness": 0}));
    let job = ended(&mut live);
    assert_eq!((&job["state"], &job["kind"]), (&json!("done"), &json!("run")), "{job}");
    let run = job["result"].as_str().unwrap();
    let summary: Value =
        serde_json::from_slice(&fs::read(desk.path().join(run).join("summary.json")).unwrap()).unwrap();
    let set = summary["overrides"].as_array().unwrap();
    assert!(
        set.iter().any(|set| set["path"] == "joint.gudgeon.radial_clearance" && set["written"] == "0.0005 m"),
        "{set:?}"
    );
    // The command that the study tells is that which makes this run again: settings, cycle, tolerance.
    let command = summary["repeat"]["command"].as_str().unwrap();
    let told = witness["command"].as_str().unwrap();
    for part in ["joint.gudgeon.radial_clearance=0.0005 m", "contact.steel_pin.restitution=0.9", "simulate model.toml"]
    {
        assert!(command.contains(part) && told.contains(part), "{command}\n{told}");
    }
    // Once more: it is found, not run.
    live.send(&json!({"kind": "simulate", "result": result, "witness": 0}));
    assert_eq!(ended(&mut live)["result"], run);
    live.send(&json!({"kind": "simulate", "result": result, "witness": 999}));
    let job = ended(&mut live);
    assert!(job["state"] == "failed" && job["diagnostics"][0].as_str().unwrap().contains("no witness 999"), "{job}");
    let (status, refused) = compared(&server, &result, run);
    assert!(status == 400 && refused["message"].as_str().unwrap().contains("contains a simulation"), "{refused}");
    let (status, nothing) = server.ask("POST", "/api/result", &json!({"path": run}).to_string());
    assert_eq!((status, &nothing["is_study"], &nothing["witnesses"]), (200, &json!(false), &json!([])));
}

#[test]
fn values_of_a_result_become_those_of_the_model() {
    let desk = tempfile::tempdir().unwrap();
    let study = written(desk.path(), "worn", &[]);
    let server = Server::of(desk.path());
    let mut live = server.live();
    let result = run(&mut live, &study);
    let (_, doings) = server.ask("POST", "/api/result", &json!({"path": result}).to_string());
    let known = doings["known"].as_array().unwrap();
    assert!(known.len() > 1, "{doings}");
    let [model, old_study] = texts_of(desk.path(), "worn");
    let adopt = |model: &Value, study: &Value, place: usize| {
        let body = json!({"model": model, "study": study, "path": result, "place": place});
        server.ask("POST", "/api/adopt", &body.to_string())
    };
    let (status, said) = adopt(&model, &old_study, known.len() - 1);
    assert_eq!(status, 200, "{said}");
    let adopted = &said["adopted"];
    assert_eq!(adopted["has_changed"], false);
    // Both values stand in the model now, with its comments, and no longer in the study.
    let (new_model, new_study) = (adopted["model"].as_str().unwrap(), adopted["study"].as_str().unwrap());
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<String>>();
    let (before, after) = (lines(model["text"].as_str().unwrap()), lines(new_model));
    assert_eq!(before.len(), after.len());
    let changed: Vec<(&String, &String)> = before.iter().zip(&after).filter(|(old, new)| old != new).collect();
    assert_eq!(changed.len(), 2, "{changed:?}");
    for (old, new) in &changed {
        let comment = |line: &str| line.split_once('#').map(|(_, comment)| comment.to_owned());
        assert_eq!(comment(old), comment(new));
    }
    assert!(!new_study.contains("joint.gudgeon") && !new_study.contains("restitution"), "{new_study}");
    assert!(
        new_study.contains("\"parameter.rod_length\"") && new_study.contains("# known only as intervals"),
        "{new_study}"
    );
    // The values are those of the result, to the digits that are written.
    let summary: Value =
        serde_json::from_slice(&fs::read(desk.path().join(&result).join("summary.json")).unwrap()).unwrap();
    let at = &summary["curves"][0]["at_values"].as_array().unwrap().last().unwrap()["at"];
    let due_mm = 1e3 * at["joint.gudgeon.radial_clearance"].as_f64().unwrap();
    let line = after.iter().find(|line| line.starts_with("radial_clearance")).unwrap();
    let written_mm: f64 = line.split('"').nth(1).unwrap().trim_end_matches(" mm").parse().unwrap();
    assert!((written_mm - due_mm).abs() < 1e-6 * due_mm, "{line} {due_mm}");
    let seen = live.look(1, ("worn/model.toml", new_model), Some(("worn/study.toml", new_study)));
    assert_eq!(seen["diagnostics"], json!([]));
    // Texts that have gone on, and texts that do not take it.
    let changed = json!({"path": "worn/model.toml", "text": format!("{}# more\n", model["text"].as_str().unwrap())});
    assert_eq!(adopt(&changed, &old_study, 0).1["adopted"]["has_changed"], true);
    let broken = json!({"path": "worn/model.toml", "text": "name = \"x\"\n"});
    let (status, said) = adopt(&broken, &old_study, 0);
    assert!(status == 200 && said["refusal"]["message"].is_string() && said["adopted"].is_null(), "{said}");
    let (status, said) = adopt(&model, &old_study, 999);
    assert!(status == 200 && said["refusal"]["message"].as_str().unwrap().contains("no such value"), "{said}");
}

#[cfg(unix)]
#[test]
fn results_that_lead_out_of_the_folder_are_not_read() {
    let desk = tempfile::tempdir().unwrap();
    let served = desk.path().join("served");
    fs::create_dir(&served).unwrap();
    let study = written(&served, "worn", &[]);
    let server = Server::of(&served);
    let mut live = server.live();
    let result = run(&mut live, &study);
    // A whole result outside, and one inside whose record is a link to that outside.
    let outside = desk.path().join("outside");
    fs::create_dir(&outside).unwrap();
    for entry in fs::read_dir(served.join(&result)).unwrap() {
        let entry = entry.unwrap();
        fs::copy(entry.path(), outside.join(entry.file_name())).unwrap();
    }
    std::os::unix::fs::symlink("../outside", served.join("link")).unwrap();
    fs::create_dir(served.join("half")).unwrap();
    fs::copy(outside.join("loosepin.json"), served.join("half/loosepin.json")).unwrap();
    std::os::unix::fs::symlink("../../outside/summary.json", served.join("half/summary.json")).unwrap();
    for path in ["link", "half", "../outside", "worn/../../outside", "/etc", "link/"] {
        for (target, body) in [
            ("compare", json!({"before": result, "after": path})),
            ("compare", json!({"before": path, "after": result})),
            ("result", json!({"path": path})),
        ] {
            let (status, refused) = server.ask("POST", &format!("/api/{target}"), &body.to_string());
            assert_eq!(status, 403, "{target} {path}: {refused}");
        }
        live.send(&json!({"kind": "simulate", "result": path, "witness": 0}));
        let job = ended(&mut live);
        assert_eq!(job["state"], "failed", "{job}");
    }
}
