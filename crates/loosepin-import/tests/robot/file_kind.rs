//! What a file is that is imported: by its name, and by its content where the name says nothing.

use loosepin_import::{FileKind, KnownBy, import_robot};
use loosepin_text::diagnostics::Source;
use std::path::Path;

#[test]
fn the_extension_says_what_a_file_is_and_else_its_content() {
    use FileKind::{Drawing, Robot};
    use KnownBy::{Content, Name};
    for (name, content, kind, known_by) in [
        ("arm.urdf", "", Robot, Name),
        ("ARM.URDF", "0\nSECTION", Robot, Name),
        ("folder.dxf/arm.xml", "0", Robot, Name),
        ("arm.Mjcf", "<mujoco/>", Robot, Name),
        ("crank.DXF", "<robot/>", Drawing, Name),
        ("arm.txt", "\u{feff} \n<robot/>", Robot, Content),
        ("urdf", "<robot/>", Robot, Content),
        ("crank", "0\nSECTION", Drawing, Content),
        ("crank", "", Drawing, Content),
    ] {
        assert_eq!(FileKind::of(Path::new(name), content.as_bytes()), (kind, known_by), "{name}");
    }
}

#[test]
fn an_empty_robot_description_is_refused_as_one() {
    let refused = import_robot(&Source::new("arm.urdf", "")).expect_err("no description").to_string();
    assert!(refused.starts_with("arm.urdf:1:1: error[E1103]: the file is not XML"), "{refused}");
}
