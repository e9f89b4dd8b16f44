//! What is seen of texts.

use crate::client::Server;
use loosepin::templates::find_template;
use serde_json::Value;

/// What lies between two UTF-16 offsets of a text.
fn stretch(text: &str, place: &Value) -> String {
    let units: Vec<u16> = text.encode_utf16().collect();
    let [from, to] = ["from", "to"].map(|end| place[end].as_u64().expect("an offset") as usize);
    String::from_utf16(&units[from..to]).unwrap()
}

#[test]
fn a_template_is_drawn_with_its_bands() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let template = find_template("four-bar").unwrap();
    let mut live = server.live();
    let seen = live.look(7, ("m/model.toml", template.model), Some(("m/study.toml", template.study)));
    assert_eq!(seen["seq"], 7);
    assert_eq!(seen["diagnostics"].as_array().unwrap().len(), 0, "{}", seen["diagnostics"]);
    let view = &seen["view"];
    assert_eq!(view["mobility"], "1 degree of freedom, 1 drive");
    // A body for each of the three moving links and the ground, at each of 73 positions.
    let motion = &view["drawing"]["motion"];
    assert_eq!(motion["bodies"].as_array().unwrap().len(), 4);
    assert_eq!(motion["angle_deg"].as_array().unwrap().len(), 73);
    let band = &view["bands"][0];
    assert!(band["figure"].as_str().unwrap().starts_with("<svg xmlns="));
    let shares: f64 = band["parts"].as_array().unwrap().iter().map(|part| part["share"].as_f64().unwrap()).sum();
    assert!((shares - 1.0).abs() < 1e-12, "{shares}");
    let joints = view["outline"]["joints"].as_array().unwrap();
    assert!(joints.iter().any(|joint| joint["play"].is_string()), "{joints:?}");
    // Each field replaces what it shows.
    let quantities = view["quantities"].as_array().unwrap();
    assert!(quantities.iter().any(|quantity| quantity["kind"] == "unknown"), "{quantities:?}");
    for quantity in quantities {
        let text = if quantity["document"] == "model" { template.model } else { template.study };
        assert_eq!(quantity["written"], stretch(text, quantity), "{quantity}");
    }
}

#[test]
fn a_model_without_masses_is_drawn_with_its_band() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    for (seq, name) in (1..).zip(["slider-crank", "four-bar", "toggle-press"]) {
        let text = find_template(name).unwrap().model;
        let only_runs_need = ["gravity ", "mass ", "inertia ", "centre_of_mass ", "contact = "];
        let is_kept = |line: &&str| !only_runs_need.iter().any(|key| line.starts_with(key));
        let light: String = text.lines().filter(is_kept).flat_map(|line| [line, "\n"]).collect();
        let seen = live.look(seq, ("model.toml", &light), None);
        let errors = seen["diagnostics"].as_array().unwrap().iter().filter(|said| said["severity"] == "error");
        assert_eq!(errors.count(), 0, "{name}: {}", seen["diagnostics"]);
        let view = &seen["view"];
        assert!(view["drawing"]["motion"]["bodies"].as_array().is_some_and(|bodies| bodies.len() > 2), "{name}");
        let [with, without] = [text, &light].map(|text| {
            let seen = live.look(seq + 100, ("model.toml", text), None);
            seen["view"]["bands"][0]["largest"].as_str().map(str::to_owned)
        });
        assert!(with.is_some() && with == without, "{name}: {with:?} {without:?}");
    }
}

#[test]
fn the_band_is_twice_as_wide_with_twice_the_play() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let model = find_template("slider-crank").unwrap().model;
    let line = model.lines().find(|line| line.starts_with("radial_clearance")).unwrap();
    let mut live = server.live();
    let mut widest = |seq, play: &str| {
        let text = model.replace(line, &format!("radial_clearance = \"{play}\""));
        let seen = live.look(seq, ("model.toml", &text), None);
        let words = seen["view"]["bands"][0]["largest"].as_str().expect("a band").to_owned();
        let number = words.split('±').nth(1).and_then(|rest| rest.split_whitespace().next()).unwrap();
        number.parse::<f64>().unwrap_or_else(|_| panic!("{words}"))
    };
    let [single, double] = [widest(1, "0.1 mm"), widest(2, "0.2 mm")];
    assert!((double / single - 2.0).abs() < 0.01, "{single} {double}");
}

#[test]
fn a_wrong_text_is_shown_at_its_place() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let template = find_template("four-bar").unwrap();
    // A letter of two UTF-16 units before the mistake.
    let model = format!("# 𝛼\n{}", template.model.replacen("9.81 m/s^2", "9.81 m/s^5", 1));
    let mut live = server.live();
    let seen = live.look(1, ("model.toml", &model), None);
    assert!(seen["view"].is_null());
    let diagnostic = &seen["diagnostics"][0];
    assert_eq!((&diagnostic["document"], &diagnostic["severity"]), (&Value::from("model"), &Value::from("error")));
    assert!(stretch(&model, diagnostic).contains("m/s^5"), "{diagnostic}");
    // A wrong study does not hide its model.
    let study = template.study.replacen("[random]", "[randum]", 1);
    assert_ne!(study, template.study);
    let seen = live.look(2, ("model.toml", template.model), Some(("study.toml", &study)));
    assert!(seen["view"]["drawing"]["svg"].is_string());
    assert_eq!(seen["diagnostics"][0]["document"], "study");
}

#[test]
fn names_of_files_are_only_ever_text() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let template = find_template("four-bar").unwrap();
    // A joint cannot be called so; what can is a title, which stands in pictures and diagnostics.
    let study = template.study.replacen("name = \"", "name = \"<script>alert(1)</script> ", 1);
    let mut live = server.live();
    let seen = live.look(1, ("model.toml", template.model), Some(("study.toml", &study)));
    assert!(seen["view"]["title"].as_str().unwrap().starts_with("<script>"));
    let drawn = seen["view"]["drawing"]["svg"].as_str().unwrap();
    assert!(!drawn.contains("<script"), "{drawn}");
    let model = template.model.replace("rocker_pin", "\"<script>\"");
    let seen = live.look(2, ("model.toml", &model), None);
    assert!(seen["view"].is_null());
    assert!(!seen["diagnostics"].as_array().unwrap().is_empty());
}

#[test]
fn each_fix_mends_its_diagnostic() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../loosepin/tests/bad/model");
    let mut fixes = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let Some(text) = std::fs::read_to_string(&path).ok().filter(|_| path.extension().is_some_and(|e| e == "toml"))
        else {
            continue;
        };
        // Under the limit on messages a second.
        live = if fixes % 50 == 0 { server.live() } else { live };
        let seen = live.look(1, ("model.toml", &text), None);
        for diagnostic in seen["diagnostics"].as_array().unwrap().iter().filter(|one| one["fix"].is_object()) {
            let fix = &diagnostic["fix"];
            let units: Vec<u16> = text.encode_utf16().collect();
            let [from, to] = ["from", "to"].map(|end| fix[end].as_u64().unwrap() as usize);
            let part = |range: &[u16]| String::from_utf16(range).unwrap();
            let mended = part(&units[..from]) + fix["insert"].as_str().unwrap() + &part(&units[to..]);
            let again = live.look(2, ("model.toml", &mended), None);
            let is_there = again["diagnostics"]
                .as_array()
                .unwrap()
                .iter()
                .any(|one| one["message"] == diagnostic["message"] && one["line"] == diagnostic["line"]);
            assert!(!is_there, "{}: {diagnostic}\n{mended}", path.display());
            fixes += 1;
        }
    }
    assert!(fixes >= 10, "{fixes} fixes");
}

/// So many four-bars in a row, each rocker the crank of the next one, with play in the first coupler.
fn chain(four_bars: usize) -> String {
    use std::fmt::Write;
    let (mut ground, mut bodies, mut joints, mut guesses) = (String::new(), String::new(), String::new(), Vec::new());
    let mut body = |name: &str, length: &str| {
        let head = format!(
            "[body.{name}]\nmass = \"0.3 kg\"\ninertia = \"1e-3 kg m^2\"\ncentre_of_mass = [\"{length} / 2\", \"0 mm\"]\n"
        );
        writeln!(bodies, "{head}points = {{ a = [\"0 mm\", \"0 mm\"], b = [\"{length}\", \"0 mm\"] }}").unwrap();
    };
    let mut joint = |name: &str, bearing: &str, journal: &str, more: &str| {
        write!(joints, "[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n{more}")
            .unwrap();
    };
    let play = "bearing_radius = \"8 mm\"\nradial_clearance = \"0.1 mm\"\ncontact = \"steel\"\n";
    body("crank", "crank_length");
    joint("pivot", "ground.g0", "crank.a", "");
    let mut before = "crank.b".to_owned();
    for number in 1..=four_bars {
        body(&format!("coupler{number}"), if number == 1 { "coupler_length" } else { "base_length" });
        body(&format!("rocker{number}"), "rocker_length");
        joint(&format!("pin{number}"), &before, &format!("coupler{number}.a"), if number == 1 { play } else { "" });
        joint(&format!("top{number}"), &format!("coupler{number}.b"), &format!("rocker{number}.b"), "");
        joint(&format!("foot{number}"), &format!("ground.g{number}"), &format!("rocker{number}.a"), "");
        guesses.push(format!(
            "coupler{number} = \"{} deg\", rocker{number} = \"94 deg\"",
            if number == 1 { 20 } else { 0 }
        ));
        before = format!("rocker{number}.b");
    }
    for number in 0..=four_bars {
        writeln!(ground, "g{number} = [\"{number} * base_length\", \"0 mm\"]").unwrap();
    }
    format!(
        "name = \"chain\"\ngravity = \"9.81 m/s^2\"\n[parameter]\ncrank_length = \"80 mm\"\ncoupler_length = \"260 mm\"\n\
         rocker_length = \"180 mm\"\nbase_length = \"300 mm\"\n[body.ground.points]\n{ground}{bodies}\
         [contact.steel]\nlaw = \"lankarani-nikravesh\"\nrestitution = 0.85\nyoungs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\n\
         {joints}[drive.crank]\njoint = \"pivot\"\nspeed = \"60 rpm\"\nstart_angle = \"34 deg\"\n\
         [assembly]\nguess = {{ {} }}\n[cycle]\ndrive = \"crank\"\ntransient_turns = 0\nrecorded_turns = 1\n\
         samples_per_turn = 180\n[output.last]\nangle_of = \"rocker{four_bars}\"\n",
        guesses.join(", ")
    )
}

#[test]
fn a_look_that_takes_longer_than_two_seconds_is_cut_off_and_says_so() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    // 81 bodies at 720 positions: ten seconds and more.
    let model = chain(40);
    let look = |seq: u64, model: &str, positions: usize| {
        let text = serde_json::json!({"path": "model.toml", "text": model});
        serde_json::json!({"kind": "look", "seq": seq, "model": text, "study": null, "positions": positions, "grip": null})
    };
    live.send(&look(1, &model, 720));
    let seen = live.next_of("look_answer");
    assert_eq!((&seen["seq"], &seen["is_cut"]), (&Value::from(1), &Value::from(true)), "{}", seen["diagnostics"]);
    assert_eq!((&seen["view"], &seen["cost_ms"]), (&Value::Null, &Value::from(2000.0)));
    // What comes next is answered as ever: nothing goes on computing in its way, and no answer to the first one follows.
    live.send(&look(2, &chain(1), 36));
    let seen = live.next_of("look_answer");
    assert_eq!((&seen["seq"], &seen["is_cut"]), (&Value::from(2), &Value::from(false)));
    assert!(seen["view"]["drawing"]["svg"].is_string(), "{}", seen["diagnostics"]);
}

#[test]
fn of_thousands_of_diagnostics_the_first_are_shown_and_the_others_counted() {
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let mut live = server.live();
    let text: String = (0..3000).map(|number| format!("line {number}\n")).collect();
    let seen = live.look(1, ("model.toml", &text), None);
    let diagnostics = seen["diagnostics"].as_array().unwrap();
    assert_eq!(diagnostics.len(), 201);
    assert_eq!(diagnostics[199]["line"], 200);
    assert_eq!(diagnostics[200]["message"], "and 2800 more");
    assert_eq!(diagnostics[200]["severity"], "error");
}

/// Threads of this process, and its memory, KiB.
#[cfg(target_os = "linux")]
fn threads_and_memory() -> [u64; 2] {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    ["Threads:", "VmRSS:"].map(|key| {
        let line = status.lines().find(|line| line.starts_with(key)).unwrap();
        line.split_whitespace().nth(1).unwrap().parse().unwrap()
    })
}

/// A campaign of a minute: eight pages at once, each with looks at an arm in space that are cut, 200 of them.
#[test]
#[cfg(target_os = "linux")]
#[ignore = "a minute"]
fn two_hundred_looks_that_were_cut_leave_nothing_at_work() {
    const PAGES: u64 = 8;
    const ROUNDS: u64 = 25;
    const MAX_GROWTH_KIB: u64 = 32 << 10;
    let desk = tempfile::tempdir().unwrap();
    let server = Server::of(desk.path());
    let template = find_template("six-axis-arm").unwrap();
    // The most positions and nearly the longest way that there are.
    let model = template.model.replace("duration = \"1 s\"", "duration = \"4000 s\"");
    let model = model.replace("samples_per_turn = 50", "samples_per_turn = 10000");
    let text = serde_json::json!({"path": "model.toml", "text": model});
    let mut pages: Vec<_> = (0..PAGES).map(|_| server.live()).collect();
    let mut after_first = [0; 2];
    for round in 1..=ROUNDS {
        for page in &mut pages {
            page.send(
                &serde_json::json!({"kind": "look", "seq": round, "model": text, "study": null, "positions": 36}),
            );
        }
        for page in &mut pages {
            let seen = page.next_of("look_answer");
            assert_eq!(
                (&seen["seq"], &seen["is_cut"]),
                (&Value::from(round), &Value::from(true)),
                "{}",
                seen["diagnostics"]
            );
        }
        if round == 1 {
            after_first = threads_and_memory();
        }
    }
    // Each page answers at once: nothing goes on in its way.
    for page in &mut pages {
        let seen = page.look(ROUNDS + 1, ("model.toml", template.model), None);
        assert_eq!(seen["is_cut"], false);
    }
    let [threads, memory_kib] = threads_and_memory();
    println!("after one round {after_first:?}, after {ROUNDS} {:?}", [threads, memory_kib]);
    assert!(threads <= after_first[0], "{threads} threads, {} before", after_first[0]);
    assert!(memory_kib <= after_first[1] + MAX_GROWTH_KIB, "{memory_kib} KiB, {} before", after_first[1]);
}
