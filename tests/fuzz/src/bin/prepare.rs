//! Writes what the fuzzer starts from: `prepare FOLDER` makes `FOLDER/TARGET/seeds/*` and `FOLDER/TARGET/dictionary` for each
//! target, from the files of the repository, the schemas of both files and the store that the library writes.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use loosepin::model::model_schema;
use loosepin::store::{InputsKey, StoredRun, RunStore, STORE_COMPANIONS, STORE_FILE};
use loosepin::study::study_schema;
use loosepin_fuzz::files::TABLE;
use loosepin_fuzz::store::{identity, lock};
use serde_json::Value;

/// Words of expressions, units and values that no schema holds.
const WORDS: &[&str] = &[
    "mm",
    "um",
    "km",
    "deg",
    "rad",
    "rpm",
    "Hz",
    "kg",
    "GPa",
    "Pa s",
    "N/m",
    "kN",
    "ms",
    "min",
    "°",
    "µ",
    "±",
    "²",
    "^2",
    "^-1.5",
    "pi",
    "sqrt(",
    "sin(",
    "atan2(",
    "min(",
    "abs(",
    "1e300",
    "1e-300",
    "1e308",
    "nan",
    "inf",
    "-0.0",
    "9223372036854775807",
    "18446744073709551616",
    "[[",
    "]]",
    "\"\"\"",
    "'''",
    "\\u0000",
    "H7/g6",
    "?",
];
/// Rows of a seed of a store.
const ROWS: u64 = 9;

fn main() {
    let out = PathBuf::from(std::env::args().nth(1).expect("usage: prepare FOLDER"));
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let (model, study) = (model_schema(), study_schema());
    for (target, schemas) in
        [("model", vec![&model]), ("study", vec![&study]), ("plan", vec![&model, &study]), ("store", Vec::new()), ("runs", Vec::new())]
    {
        let seeds = match target {
            "store" => stores(&out),
            "runs" => runs(&repository.join("crates/loosepin-study/tests/runs")),
            "plan" => [texts(&repository, "model"), texts(&repository, "study")].concat(),
            kind => texts(&repository, kind),
        };
        let folder = out.join(target).join("seeds");
        fs::create_dir_all(&folder).expect("a folder for the seeds");
        for (name, bytes) in &seeds {
            fs::write(folder.join(name), bytes).expect("a seed is written");
        }
        let dictionary = if schemas.is_empty() { String::new() } else { dictionary(&schemas) };
        fs::write(out.join(target).join("dictionary"), &dictionary).expect("the dictionary is written");
        println!("{target}: {} seeds, {} words", seeds.len(), dictionary.lines().count());
    }
}

/// The files of a kind, each with the tables that it names.
fn texts(repository: &Path, kind: &str) -> Vec<(String, Vec<u8>)> {
    let library = repository.join("crates/loosepin");
    let mut seeds = Vec::new();
    for folder in [
        "cases",
        "crates/loosepin-import/templates",
        "crates/loosepin-simulate/tests/files",
        "crates/loosepin/tests/files",
        "crates/loosepin/tests/bad",
    ] {
        for path in files_below(&repository.join(folder)) {
            let name = path.strip_prefix(repository).unwrap_or(&path).display().to_string().replace(['/', '\\'], "-");
            let is_study = name.contains("study");
            if path.extension().is_none_or(|extension| extension != "toml")
                || name.ends_with("expected.toml")
                || is_study != (kind == "study")
            {
                continue;
            }
            let mut text = fs::read_to_string(&path).expect("a seed is read");
            let above = path.parent().unwrap_or(&path);
            let template = above.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            text = text.replace("model = \"model.toml\"", &format!("model = \"{template}\""));
            text = text.replace("model = \"every_table.toml\"", "model = \"every-table\"");
            let quoted: BTreeSet<String> =
                text.split('"').filter(|word| word.ends_with(".csv")).map(str::to_owned).collect();
            for table in quoted {
                let found = [above, &library].into_iter().find_map(|from| fs::read_to_string(from.join(&table)).ok());
                if let Some(found) = found {
                    text.push_str(&format!("\n{TABLE}{table}\n{found}"));
                }
            }
            seeds.push((name, text.into_bytes()));
        }
    }
    seeds
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).expect("a folder of seeds").map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    entries.into_iter().flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

/// Files of runs of this version and of an earlier one.
fn runs(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().into_owned();
    files_below(folder).iter().map(|path| (name(path), fs::read(path).expect("a file of runs is read"))).collect()
}

/// Stores as the library writes them, whole and killed, and rows for `rows.rs`.
fn stores(out: &Path) -> Vec<(String, Vec<u8>)> {
    let folder = out.join("store/made");
    let path = folder.join(STORE_FILE);
    let lock = lock(&folder);
    loosepin::store::remove_store(&lock).expect("the store of last time goes");
    // Small pages make small inputs.
    let small = rusqlite::Connection::open(&path).expect("a database");
    small.execute_batch("PRAGMA page_size = 512; VACUUM").expect("small pages");
    drop(small);
    let fill = |rows: std::ops::Range<u64>| {
        let store = RunStore::open(&lock, &identity()).expect("a store");
        for place in rows {
            let outcome = if place % 3 == 1 { Err(place as u16) } else { Ok(vec![place as f64 / 3.7; 9]) };
            store.keep((place % 2) as u32, place, StoredRun { inputs: InputsKey::of(&place.to_le_bytes()), outcome });
        }
        store.flush().expect("rows are written");
        store
    };
    let read = |path: &Path| fs::read(path).expect("a store is read");
    drop(fill(0..ROWS));
    let whole = read(&path);
    // Read while it is open: what a killed process leaves.
    let open = fill(ROWS..2 * ROWS);
    let (left, log) = (read(&path), read(&path.with_file_name(STORE_COMPANIONS[0])));
    drop(open);
    let units = u16::try_from(left.len() / 64).expect("a small store").to_le_bytes();
    let killed = |kind: u8| [&[kind][..], &units, &left, &log].concat();
    let mut seeds = vec![
        ("whole".to_owned(), [b"F", whole.as_slice()].concat()),
        ("killed".to_owned(), killed(b'L')),
        ("killed-log-looked-at".to_owned(), killed(b'K')),
        ("nothing".to_owned(), b"F".to_vec()),
    ];
    for tables in 0..9_u8 {
        // Lists, places, keys, reasons, numbers and checksums of right kinds in two rows, then of wrong ones.
        let key = [7_u8; 16];
        let right = [&[1, 0, 1, 3, 6][..], &key, &[0, 7, 16], &[0x3f; 16], &[5]].concat();
        let failed = [&[1, 1, 1, 4, 6][..], &key, &[1, 9, 7, 0, 5]].concat();
        let wrong =
            [&[2][..], &i64::MIN.to_le_bytes(), &[3], &0.3_f64.to_le_bytes(), &[4, 2, b'a', b'b', 7, 3, 1, 2, 3, 0, 6]]
                .concat();
        seeds.push((format!("rows-{tables}"), [&[b'R', tables, 0][..], &right, &failed, &wrong].concat()));
    }
    seeds
}

/// The words of schemas and [`WORDS`], as AFL++ reads them.
fn dictionary(schemas: &[&Value]) -> String {
    let mut words: BTreeSet<String> = WORDS.iter().map(|word| (*word).to_owned()).collect();
    schemas.iter().for_each(|schema| collect(schema, &mut words));
    let written = |byte: u8| match byte {
        b'"' | b'\\' => format!("\\{}", char::from(byte)),
        b' '..=b'~' => char::from(byte).to_string(),
        _ => format!("\\x{byte:02x}"),
    };
    words.iter().map(|word| format!("\"{}\"\n", word.bytes().map(written).collect::<String>())).collect()
}

/// Keys and choices.
fn collect(schema: &Value, words: &mut BTreeSet<String>) {
    match schema {
        Value::Object(object) => {
            for (key, below) in object {
                match (key.as_str(), below) {
                    ("properties", Value::Object(properties)) => words.extend(properties.keys().cloned()),
                    ("enum", Value::Array(choices)) => {
                        words.extend(choices.iter().filter_map(Value::as_str).map(str::to_owned));
                    }
                    ("const", Value::String(word)) => _ = words.insert(word.clone()),
                    _ => {}
                }
                collect(below, words);
            }
        }
        Value::Array(list) => list.iter().for_each(|below| collect(below, words)),
        _ => {}
    }
}
