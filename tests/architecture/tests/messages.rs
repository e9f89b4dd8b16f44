//! The types of the studio's messages in TypeScript are those of the Rust sources. `just studio-messages` rewrites them.

#![allow(clippy::disallowed_methods, reason = "writes a source file")]

use std::path::{Path, PathBuf};

use architecture::sources::{Source, read, sources_below};
use architecture::typescript::Types;

/// Set by `just studio-messages`.
const REWRITE: &str = "LOOSEPIN_REWRITE_PAGES";
/// The studio first: what it says and hears are the messages. The others declare what these hold.
const PACKAGES: [&str; 5] =
    ["loosepin-studio", "loosepin-report", "loosepin-result", "loosepin-store", "loosepin-text"];
/// Types of the studio that are read from files alone.
const OF_FILES: [&str; 1] = ["Requirement"];
const HEAD: &str = "// What the studio and its server say to each other, from the types of the server in Rust.\n\
    // Not written by hand: `just studio-messages` writes it, and a test of the architecture compares it.\n";

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn the_page_knows_the_messages_of_the_server() {
    let packages = PACKAGES.map(|package| sources_below(&repository().join("crates").join(package).join("src")));
    let types = Types::of(&packages).unwrap_or_else(|error| panic!("{error}"));
    let text = format!("{HEAD}{}", types.typescript(&OF_FILES).unwrap_or_else(|error| panic!("{error}")));
    let path = repository().join("crates/loosepin-studio/front/src/messages.ts");
    if std::env::var_os(REWRITE).is_some() {
        std::fs::write(&path, &text).expect("the types are written");
    }
    assert!(
        read(&path) == text,
        "front/src/messages.ts is not what the Rust types say: run `just studio-messages`, and look at the change"
    );
}

fn written(text: &str) -> Result<String, String> {
    let source = Source { path: "lib.rs".to_owned(), text: text.to_owned() };
    Types::of(&[vec![source]])?.typescript(&[])
}

#[test]
fn types_are_written_as_serde_writes_their_values() {
    let text = "/// Two\n/// lines.\n#[derive(serde::Serialize)] struct A<'a> { /** One. */ one: Option<&'a str>, two: Vec<Option<f64>>, three: [String; 2],\n\
        #[serde(skip_serializing_if = \"Vec::is_empty\")] four: Vec<B>, #[serde(flatten)] c: Option<C> }\n\
        #[derive(Deserialize)] #[serde(tag = \"kind\", rename_all = \"snake_case\")] enum B { NotMet, \
        Of { x: Named, #[serde(default)] y: bool, z: Option<u8> }, In(Box<C>) }\n\
        #[derive(Serialize)] struct C { r#type: D } #[derive(Serialize)] enum D { X, #[serde(rename = \"why not\")] Y }\n\
        type Named = BTreeMap<String, [f64; 3]>; struct Other { a: Unknown } #[cfg(test)] mod tests { #[derive(Serialize)] struct E {} }";
    let due = "\n/** Two lines. */\nexport interface A extends Partial<C> {\n  /** One. */\n  one: string | null;\n  two: (number | null)[];\n  \
        three: [string, string];\n  four?: B[];\n}\n\
        \nexport type B =\n  | { kind: 'not_met' }\n  | {\n      kind: 'of';\n      x: Named;\n      y?: boolean;\n      z?: number | null;\n    }\n  \
        | ({ kind: 'in' } & C);\n\
        \nexport interface C {\n  type: D;\n}\n\
        \nexport type D =\n  | 'X'\n  | 'why not';\n\
        \nexport type Named = Record<string, [number, number, number]>;\n";
    let found = written(text).unwrap();
    // Each stands there once, in whatever order.
    let sorted = |text: &str| {
        let mut parts: Vec<String> = text.split("\n\n").map(|part| part.trim().to_owned()).collect();
        parts.sort();
        parts
    };
    assert_eq!(sorted(&found), sorted(due), "{found}");
}

#[test]
fn what_is_not_known_is_an_error() {
    for (text, reason) in [
        ("#[derive(Serialize)] struct A { b: B }", "no type B is found"),
        ("#[derive(Serialize)] struct A { b: Mutex<u8> }", "the type Mutex is not known"),
        ("#[derive(Serialize)] struct A { #[serde(with = \"hex\")] b: u8 }", "serde(with) is not known"),
        ("#[derive(Serialize)] #[serde(rename_all = \"camelCase\")] struct A { b: u8 }", "is not known"),
        ("#[derive(Serialize)] enum A { B(u8) }", "needs serde(tag)"),
        ("#[derive(Serialize)] struct A { b: (u8, u8) }", "of this form"),
        ("mod a { #[derive(Serialize)] struct A {} } mod b { #[derive(Serialize)] struct A {} }", "both declare A"),
    ] {
        let error = written(text).expect_err(text);
        assert!(error.contains(reason), "{text}: {error}");
    }
}
