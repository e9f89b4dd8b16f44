//! The shelf of one's own work: pictures, verdicts that know their texts, copies, deletion with a way back, and whose save it was.

use std::fs;
use std::path::Path;
use std::time::{Duration, SystemTime};

use crate::client::{Live, Server};
use loosepin::templates::find_template;
use serde_json::{Value, json};

/// A study of the slider-crank that takes a second, in a folder.
fn written(root: &Path, name: &str) -> [String; 2] {
    let template = find_template("slider-crank").unwrap();
    let study = template.study.replace("outer = 16 ", "outer = 5 ").replace("at_least = 0.95 ", "at_least = 0.9 ");
    fs::create_dir_all(root.join(name)).unwrap();
    fs::write(root.join(name).join("model.toml"), template.model).unwrap();
    fs::write(root.join(name).join("study.toml"), study).unwrap();
    ["model.toml", "study.toml"].map(|file| format!("{name}/{file}"))
}

/// A finished result whose record is `summary`.
fn write_result(folder: &Path, name: &str, inputs: &str, summary: &Value) {
    fs::create_dir_all(folder).unwrap();
    let marker = json!({
        "kind": "study", "name": name, "inputs_blake3": inputs, "version": "0.1.0", "is_finished": true, "files": {}
    });
    fs::write(folder.join("loosepin.json"), marker.to_string()).unwrap();
    fs::write(folder.join("report.html"), "<p>report</p>").unwrap();
    fs::write(folder.join("summary.json"), summary.to_string()).unwrap();
}

/// The record of a result of texts, as far as a listing reads it.
fn record(model: &str, study: &str, tables: &[&str]) -> Value {
    let file = |name: &str, role: &str, text: &str| json!({"name": name, "role": role, "text": text});
    let mut files = vec![file("study.toml", "study", study), file("model.toml", "model", model)];
    files.extend(tables.iter().map(|text| file("rods.csv", "table", text)));
    let repeat = json!({"command": "loosepin study study.toml", "files": files});
    // serde_json keeps no order of keys: a record has its requirements first, which `a` and `z` are to show.
    json!({"a": 1, "repeat": repeat, "requirements": [{"verdict": "met"}]})
}

fn post(server: &Server, path: &str, body: &Value) -> (u16, Value) {
    server.ask("POST", path, &body.to_string())
}

fn trash(server: &Server, path: &str) -> (u16, Value) {
    post(server, "/api/trash", &json!({"path": path}))
}

fn listing(server: &Server) -> Value {
    let (status, listing) = server.ask("GET", "/api/folder", "");
    assert_eq!(status, 200, "{listing}");
    listing
}

fn file<'l>(listing: &'l Value, path: &str) -> &'l Value {
    listing["files"].as_array().unwrap().iter().find(|file| file["path"] == path).unwrap_or(&Value::Null)
}

fn wait_for(live: &mut Live, is_reached: impl Fn(&Value) -> bool) -> Value {
    loop {
        let job = live.next_of("job")["job"].clone();
        if is_reached(&job) {
            return job;
        }
    }
}

fn is_ended(job: &Value) -> bool {
    job["state"] != "waiting" && job["state"] != "running"
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_template_is_read_without_a_file_and_two_texts_become_a_folder() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let (status, texts) = server.ask("GET", "/api/template/four-bar", "");
    assert_eq!((status, texts["model"].as_str()), (200, find_template("four-bar").map(|template| template.model)));
    assert!(names(desk.path()).is_empty(), "nothing is written");
    assert_eq!(server.ask("GET", "/api/template/none", "").0, 404);
    let new = |body: Value| post(&server, "/api/new", &body);
    let changed = format!("{}# mine\n", texts["model"].as_str().unwrap());
    let both = json!({"folder": "four-bar", "model": changed, "study": texts["study"]});
    let (status, made) = new(both.clone());
    assert_eq!((status, &made["study"]), (200, &json!("four-bar/study.toml")), "{made}");
    assert_eq!(fs::read_to_string(desk.path().join("four-bar/model.toml")).unwrap(), changed);
    assert_eq!(new(both).0, 409, "nothing is overwritten");
    // The tags are those of a text that is opened.
    let (_, opened) = server.ask("GET", "/api/open?path=four-bar%2Fstudy.toml", "");
    assert_eq!((&opened["model"]["tag"], &opened["study"]["tag"]), (&made["model_tag"], &made["study_tag"]));
    for odd in [
        json!({"folder": "x", "model": "a"}),
        json!({"folder": "x", "template": "four-bar", "model": "a", "study": "b"}),
        json!({"folder": "x"}),
    ] {
        let (status, refused) = new(odd);
        let hint = "give either template, or model and study";
        assert_eq!((status, refused["hint"].as_str()), (400, Some(hint)), "{refused}");
    }
    for name in ["..", "a/b", "", ".trash"] {
        assert_eq!(new(json!({"folder": name, "model": "a", "study": "b"})).0, 400, "{name}");
    }
    assert_eq!(new(json!({"folder": "x", "model": "a".repeat((1 << 20) + 1), "study": "b"})).0, 413);
    assert_eq!(names(desk.path()), ["four-bar"]);
}

#[test]
fn a_picture_is_of_the_texts_or_says_their_first_error() {
    let desk = tempfile::tempdir().unwrap();
    let [model, study] = written(desk.path(), "mine");
    let server = Server::of(desk.path());
    let card = |path: &str| server.ask("GET", &format!("/api/card?path={path}"), "");
    for path in [&model, &study] {
        let (status, card) = card(path);
        assert!(status == 200 && card["drawing"]["svg"].is_string() && card["error"].is_null(), "{card}");
    }
    let text = fs::read_to_string(desk.path().join(&model)).unwrap();
    fs::write(desk.path().join(&model), text.replace("\"50 mm\"", "\"50 mn\"")).unwrap();
    let (status, broken) = card(&study);
    assert_eq!((status, &broken["drawing"]), (200, &Value::Null));
    let error = broken["error"].as_str().unwrap();
    assert!(error.starts_with("model.toml, line ") && error.ends_with("'mn' is not a known unit"), "{error}");
    // A study that is no TOML stands on the shelf too, with its model.
    let whole = fs::read_to_string(desk.path().join(&study)).unwrap();
    fs::write(desk.path().join(&study), format!("{whole}[ask\n")).unwrap();
    let found = listing(&server);
    let listed = file(&found, &study);
    assert_eq!((&listed["kind"], &listed["model"]), (&json!("study"), &json!(model)), "{found}");
    assert!(card(&study).1["error"].as_str().unwrap().starts_with("study.toml, line "));
    fs::write(desk.path().join(&study), whole).unwrap();
    fs::remove_file(desk.path().join(&model)).unwrap();
    assert!(card(&study).1["error"].as_str().unwrap().contains("mine/model.toml"));
    assert_eq!((card("../secret.toml").0, card("none.toml").0), (403, 404));
}

#[test]
fn a_verdict_belongs_to_its_texts_whatever_the_times_say() {
    let desk = tempfile::tempdir().unwrap();
    let [model, study] = written(desk.path(), "mine");
    let path = |name: &str| desk.path().join(name);
    let text = |name: &str| fs::read_to_string(path(name)).unwrap();
    let title = "slider-crank with a worn pin";
    let table = "rod\n120\n";
    fs::write(path("mine/rods.csv"), table).unwrap();
    fs::write(path(&model), format!("{}# \"rods.csv\"\n", text(&model))).unwrap();
    let first = [text(&model), text(&study)];
    let result = |name: &str, inputs: &str, texts: &[String; 2], tables: &[&str]| {
        write_result(&path("results").join(name), title, inputs, &record(&texts[0], &texts[1], tables));
    };
    result("first", "1", &first, &[table]);
    let server = Server::of(desk.path());
    let state = || file(&listing(&server), &study)["result"]["texts"].clone();
    assert!(first[1].contains(&format!("name = \"{title}")), "the title is that of the study");
    assert_eq!(state(), "same");
    // Written anew with the same bytes, later than the result: the texts are the same.
    fs::write(path(&model), &first[0]).unwrap();
    fs::File::options()
        .write(true)
        .open(path(&model))
        .unwrap()
        .set_modified(SystemTime::now() + Duration::from_secs(60))
        .unwrap();
    assert_eq!(state(), "same");
    for changed in [&model, &study] {
        let old = text(changed);
        fs::write(path(changed), format!("{old}# changed\n")).unwrap();
        assert_eq!(state(), "changed", "{changed}");
        fs::write(path(changed), old).unwrap();
        assert_eq!(state(), "same", "{changed}");
    }
    fs::write(path("mine/rods.csv"), "rod\n121\n").unwrap();
    assert_eq!(state(), "changed", "a table");
    fs::write(path("mine/rods.csv"), table).unwrap();
    // A newer result of other texts, and the old one of the texts as they are: that one counts.
    let second = [first[0].replace("\"50 mm\"", "\"55 mm\""), first[1].clone()];
    result("second", "2", &second, &[table]);
    let found = listing(&server);
    assert_eq!(file(&found, &study)["result"]["path"], "results/first");
    let texts: Vec<&Value> = found["results"].as_array().unwrap().iter().map(|result| &result["texts"]).collect();
    assert!(texts.contains(&&json!("same")) && texts.contains(&&json!("changed")), "{texts:?}");
    fs::write(path(&model), &second[0]).unwrap();
    assert_eq!(file(&listing(&server), &study)["result"]["path"], "results/second");
    // Two studies of one name: of which of them an older result was, nobody knows.
    fs::write(path(&model), format!("{}# third\n", first[0])).unwrap();
    assert_eq!(state(), "changed");
    written(desk.path(), "other");
    assert_eq!(state(), Value::Null);
    // A record without texts.
    fs::remove_dir_all(path("other")).unwrap();
    fs::remove_dir_all(path("results")).unwrap();
    write_result(&path("results/third"), title, "3", &json!({"requirements": [{"verdict": "met"}]}));
    assert_eq!(state(), "unknown");
}

#[test]
fn a_study_is_deleted_with_its_model_and_comes_back() {
    let desk = tempfile::tempdir().unwrap();
    let [model, study] = written(desk.path(), "mine");
    let text = |name: &str| fs::read_to_string(desk.path().join(name)).unwrap();
    let before = [text(&model), text(&study)];
    let server = Server::of(desk.path());
    let (status, trashed) = trash(&server, &study);
    assert_eq!((status, &trashed["paths"]), (200, &json!([study, model])), "{trashed}");
    // Each has its path in the trash; the folder that is empty now is gone, so that its name is free.
    let entry = trashed["entry"].as_str().unwrap();
    assert_eq!(names(desk.path()), [".trash"]);
    assert_eq!(text(&format!(".trash/{entry}/{study}")), before[1]);
    assert_eq!(listing(&server)["files"], json!([]), "the trash is not listed");
    let restore = |entry: &str, paths: &Value| post(&server, "/api/restore", &json!({"entry": entry, "paths": paths}));
    // Something has the name again: nothing is replaced, and nothing moved.
    fs::create_dir(desk.path().join("mine")).unwrap();
    fs::write(desk.path().join(&model), "other").unwrap();
    let (status, refused) = restore(entry, &trashed["paths"]);
    assert_eq!(
        (status, refused["message"].as_str()),
        (409, Some("'mine/model.toml' is there again; nothing was moved back"))
    );
    assert_eq!((text(&model).as_str(), names(&desk.path().join("mine"))), ("other", vec!["model.toml".to_owned()]));
    fs::remove_file(desk.path().join(&model)).unwrap();
    assert_eq!(restore(entry, &trashed["paths"]), (200, json!({"restored": 2})));
    assert_eq!([text(&model), text(&study)], before);
    assert_eq!(names(desk.path()), ["mine"], "an empty trash is gone");
    assert_eq!(restore(entry, &trashed["paths"]).0, 409);
    // A model that another study uses stays.
    fs::copy(desk.path().join(&study), desk.path().join("mine/second.toml")).unwrap();
    let (status, refused) = trash(&server, &model);
    assert_eq!(
        (status, refused["hint"].as_str()),
        (409, Some("delete the study: its model goes with it")),
        "{refused}"
    );
    let (_, first) = trash(&server, &study);
    assert_eq!(first["paths"], json!([study]));
    // A second deletion of the same name has an entry of its own.
    fs::write(desk.path().join(&study), &before[1]).unwrap();
    let (_, second) = trash(&server, &study);
    assert_ne!(first["entry"], second["entry"]);
    let (_, last) = trash(&server, "mine/second.toml");
    assert_eq!(last["paths"], json!(["mine/second.toml", model]));
    // What was deleted cannot be deleted again, nor changed or copied, nor taken from elsewhere.
    let deleted = format!(".trash/{}/{study}", second["entry"].as_str().unwrap());
    let (status, refused) = trash(&server, &deleted);
    assert_eq!((status, refused["hint"].as_str()), (400, Some("empty the folder .trash by hand")));
    for path in [deleted.as_str(), &format!("./{deleted}"), ".trash/new.toml"] {
        let save = json!({"path": path, "text": "name = \"changed\"\n", "tag": null}).to_string();
        let (status, refused) = server.ask("PUT", "/api/file", &save);
        let words = format!("'{path}' is in the trash: nothing is saved there");
        assert_eq!((status, refused["message"].as_str()), (400, Some(words.as_str())), "{refused}");
    }
    assert_eq!(post(&server, "/api/duplicate", &json!({"path": deleted})).0, 400);
    assert_eq!(text(&deleted), before[1]);
    assert_eq!(names(&desk.path().join(".trash")).len(), 3);
    for (entry, paths, status) in [
        ("..", json!(["mine/study.toml"]), 400),
        ("a/b", json!(["x.toml"]), 400),
        ("", json!(["x.toml"]), 400),
        ("none", json!([]), 400),
        ("none", json!(["../x.toml"]), 403),
        ("none", json!(["/etc/passwd"]), 403),
        ("none", json!(["x.toml"]), 404),
    ] {
        assert_eq!(restore(entry, &paths).0, status, "{entry} {paths}");
    }
}

#[cfg(unix)]
#[test]
fn nothing_is_deleted_through_a_link_nor_outside_of_the_folder() {
    use std::os::unix::fs::symlink;
    let desk = tempfile::tempdir().unwrap();
    let served = desk.path().join("served");
    let outside = desk.path().join("outside");
    fs::create_dir(&served).unwrap();
    written(desk.path(), "outside");
    write_result(&outside.join("result"), "outside", "1", &json!({}));
    let [_, study] = written(&served, "mine");
    symlink("../outside", served.join("link")).unwrap();
    symlink("../outside/study.toml", served.join("study.toml")).unwrap();
    symlink("../outside/result", served.join("result")).unwrap();
    let server = Server::of(&served);
    let kept = names(&outside);
    for path in [
        "link/study.toml",
        "study.toml",
        "result",
        "link/result",
        "../outside/study.toml",
        "/etc",
        "a/../../outside/result",
        "",
        ".",
    ] {
        let (status, refused) = trash(&server, path);
        assert_eq!(status, 403, "{path}: {refused}");
        assert_eq!(post(&server, "/api/duplicate", &json!({"path": path})).0, 403, "{path}");
    }
    for path in ["mine", "results", "none", "none.toml"] {
        assert_eq!(trash(&server, path).0, 404, "{path}: no result is there");
    }
    // The trash itself leads out.
    symlink("../outside", served.join(".trash")).unwrap();
    let (status, refused) = trash(&server, &study);
    assert_eq!(status, 403, "{refused}");
    assert!(served.join(&study).exists());
    assert_eq!(names(&outside), kept);
    assert_eq!(names(&served), [".trash", "link", "mine", "result", "study.toml"]);
}

#[test]
fn nothing_that_a_run_reads_or_writes_is_deleted() {
    let desk = tempfile::tempdir().unwrap();
    let [_, study] = written(desk.path(), "mine");
    let server = Server::of(desk.path());
    let mut live = server.live();
    let long = fs::read_to_string(desk.path().join(&study)).unwrap().replace("outer = 5 ", "outer = 64 ");
    fs::write(desk.path().join(&study), &long).unwrap();
    live.send(&json!({"kind": "run", "study": study}));
    let running = wait_for(&mut live, |job| job["finished"].as_u64().unwrap_or(0) > 0 || is_ended(job));
    assert_eq!(running["state"], "running", "{running}");
    let (status, refused) = trash(&server, &study);
    assert_eq!((status, refused["hint"].as_str()), (409, Some("stop the run, or wait for its end")), "{refused}");
    let folder = |below: &Path| names(below).into_iter().next().unwrap();
    let results = desk.path().join("results");
    let result = format!("results/{0}/{1}", folder(&results), folder(&results.join(folder(&results))));
    let (status, refused) = trash(&server, &result);
    assert_eq!((status, refused["message"].as_str()), (409, Some(&*format!("'{result}' is not a finished result"))));
    live.send(&json!({"kind": "stop", "id": running["id"]}));
    wait_for(&mut live, is_ended);
    assert_eq!(trash(&server, &study).0, 200, "after its end");
    // A finished result whose folder somebody writes in again, as with --force.
    let other = desk.path().join("results/other");
    write_result(&other, "other", "1", &json!({}));
    let opened = loosepin::files::Folder::open(&other).unwrap();
    let lock = loosepin::files::lock_result(&opened).unwrap();
    let (status, refused) = trash(&server, "results/other");
    let words = "'results/other' is being written by a run; nothing was deleted";
    assert_eq!((status, refused["message"].as_str()), (409, Some(words)));
    drop(lock);
    assert!(other.join("summary.json").exists());
    let (status, trashed) = trash(&server, "results/other/");
    assert_eq!(status, 200, "{trashed}");
    let entry = trashed["entry"].as_str().unwrap();
    let moved = desk.path().join(".trash").join(entry).join("results/other");
    assert_eq!(names(&moved), ["loosepin.json", "report.html", "summary.json"], "whole, and without a lock");
    assert_eq!(post(&server, "/api/restore", &json!({"entry": entry, "paths": trashed["paths"]})).0, 200);
    assert_eq!(names(&other), ["loosepin.json", "report.html", "summary.json"]);
}

#[test]
fn a_copy_stands_beside_with_names_that_are_free() {
    let desk = tempfile::tempdir().unwrap();
    let [model, study] = written(desk.path(), "mine");
    let text = |name: &str| fs::read_to_string(desk.path().join(name)).unwrap();
    let server = Server::of(desk.path());
    let duplicate = |path: &str| post(&server, "/api/duplicate", &json!({"path": path}));
    fs::write(desk.path().join("mine/model-2.toml"), "of the user").unwrap();
    let (status, copy) = duplicate(&study);
    assert_eq!((status, &copy), (200, &json!({"model": "mine/model-3.toml", "study": "mine/study-3.toml"})));
    assert_eq!(text("mine/model-2.toml"), "of the user");
    // Every line but those of the names and of the model.
    for (old, new) in [(&model, "mine/model-3.toml"), (&study, "mine/study-3.toml")] {
        let (old, new) = (text(old), text(new));
        let changed: Vec<(&str, &str)> = old.split('\n').zip(new.split('\n')).filter(|(old, new)| old != new).collect();
        assert_eq!(old.split('\n').count(), new.split('\n').count());
        assert!(changed.iter().all(|(old, _)| old.starts_with("name") || old.starts_with("model")), "{changed:?}");
    }
    let (status, card) = server.ask("GET", "/api/card?path=mine%2Fstudy-3.toml", "");
    assert!(status == 200 && card["error"].is_null() && card["drawing"]["svg"].is_string(), "{card}");
    let found = listing(&server);
    let titles = [&study, "mine/study-3.toml"].map(|path| file(&found, path)["title"].as_str().unwrap().to_owned());
    assert_eq!(titles[1], format!("{} 3", titles[0]));
    assert_eq!(file(&found, "mine/study-3.toml")["model"], "mine/model-3.toml");
    let (status, copy) = duplicate("mine/model-3.toml");
    assert_eq!((status, &copy["study"], &copy["model"]), (200, &Value::Null, &json!("mine/model-3-2.toml")));
    assert_eq!(duplicate("none.toml").0, 404);
}

#[test]
fn a_save_of_this_server_is_told_from_one_of_another_program() {
    let desk = tempfile::tempdir().unwrap();
    let [model, _] = written(desk.path(), "mine");
    let servers = [Server::of(desk.path()), Server::of(desk.path())];
    let opened = |server: &Server| server.ask("GET", "/api/open?path=mine%2Fmodel.toml", "").1["model"].clone();
    assert_eq!(opened(&servers[0])["is_saved_here"], false);
    let tag = opened(&servers[0])["tag"].clone();
    let save = |text: &str, tag: &Value| {
        servers[0].ask("PUT", "/api/file", &json!({"path": model, "text": text, "tag": tag}).to_string())
    };
    let text = opened(&servers[0])["text"].as_str().unwrap().to_owned();
    assert_eq!(save(&format!("{text}# a\n"), &tag).0, 200);
    assert_eq!(servers.each_ref().map(|server| opened(server)["is_saved_here"].clone()), [true, false]);
    // The words of a save that comes too late.
    let (status, refused) = save(&text, &tag);
    let message = |by: &str| format!("'{model}' was {by} after it was read");
    assert_eq!((status, refused["message"].as_str()), (409, Some(&*message("saved in another tab of the studio"))));
    fs::write(desk.path().join(&model), format!("{text}# b\n")).unwrap();
    assert_eq!(opened(&servers[0])["is_saved_here"], false);
    assert_eq!(save(&text, &tag).1["message"].as_str(), Some(&*message("changed by another program")));
}
