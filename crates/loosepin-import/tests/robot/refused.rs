//! Files with mistakes: each has its message with line and column, and none a panic.

use crate::mjcf::{FOUR_BAR, PUMA as PUMA_XML};
use crate::urdf::PUMA;
use loosepin_import::import_robot;
use loosepin_text::diagnostics::Source;
use proptest::prelude::*;

/// Line, column and message of the first mistake.
pub fn refused(text: &str) -> (usize, usize, String) {
    let diagnostics = import_robot(&Source::new("robot.xml", text)).expect_err("a mistake");
    let first = diagnostics.sorted()[0];
    let (line, column) = first.place.as_ref().expect("a place").line_and_column();
    (line, column, first.message.clone())
}

/// The arm of two lines and a joint with something else in place of a text of it.
fn arm(from: &str, to: &str) -> (usize, usize, String) {
    let text = "<robot name='r'>\n <link name='b'/>\n <link name='l'/>\n <joint name='j' type='revolute'>\n  <origin xyz='0 0 1' rpy='0 0 0'/>\n  \
        <parent link='b'/>\n  <child link='l'/>\n  <axis xyz='0 0 1'/>\n  <limit lower='-1' upper='1'/>\n </joint>\n</robot>";
    assert!(text.contains(from) && import_robot(&Source::new("robot.xml", text)).is_ok());
    refused(&text.replacen(from, to, 1))
}

#[test]
fn mistakes_in_urdf_have_their_place() {
    for (from, to, line, column, message) in [
        ("<limit", "<mimic joint='k'/>\n  <limit", 9, 10, "<mimic> of joint 'j': there is no joint 'k'"),
        ("0 0 1'", "0 0 nan'", 5, 11, "<origin> of joint 'j': xyz is '0 0 nan'; must be 3 numbers"),
        ("0 0 1'", "0 0 inf'", 5, 11, "<origin> of joint 'j': xyz is '0 0 inf'; must be 3 numbers"),
        ("0 0 1'", "0 0 1e999'", 5, 11, "<origin> of joint 'j': xyz is '0 0 1e999'; must be 3 numbers"),
        ("0 0 1'", "0,0,1'", 5, 11, "<origin> of joint 'j': xyz is '0,0,1'; must be 3 numbers"),
        ("0 0 1'", "0 0'", 5, 11, "<origin> of joint 'j': xyz is '0 0'; must be 3 numbers"),
        ("rpy='0 0 0'", "rpy='0 0 0 0'", 5, 23, "<origin> of joint 'j': rpy is '0 0 0 0'; must be 3 numbers"),
        (
            "xyz='0 0 1'/>\n  <limit",
            "xyz='0 0 0'/>\n  <limit",
            8,
            9,
            "<axis> of joint 'j': axis has length zero, so it has no direction",
        ),
        ("lower='-1'", "lower='-1 rad'", 9, 10, "<limit> of joint 'j': lower is '-1 rad'; must be a number"),
        ("parent link='b'", "parent link='c'", 6, 11, "joint 'j': there is no link 'c'"),
        ("  <parent link='b'/>\n", "", 4, 2, "joint 'j' has no <parent>"),
        ("<parent link='b'/>", "<parent/>", 6, 3, "<parent> of joint 'j' has no attribute 'link'"),
        ("<child link='l'/>", "<child link='l'/><child link='b'/>", 7, 20, "joint 'j' has a second <child>"),
        ("child link='l'", "child link='b'", 4, 2, "joint 'j' has link 'b' as parent and as child"),
        ("link name='l'", "link name='b'", 3, 8, "a second link is called 'b'"),
        (
            "<link name='l'/>",
            "<link name='l'/><link name='c'/>",
            3,
            18,
            "link 'c' is the child of no joint, as is link 'b'; exactly one link is the root",
        ),
        (
            "type='revolute'",
            "type='floating'",
            4,
            18,
            "joint 'j' lets a body float freely; mechanisms stand on the ground",
        ),
        (
            "type='revolute'",
            "type='helical'",
            4,
            18,
            "joint 'j' is of type 'helical'; models in space know fixed, revolute, continuous, prismatic and planar joints",
        ),
        (" type='revolute'", "", 4, 2, "joint 'j' has no attribute 'type'"),
        (" name='r'", "", 1, 1, "<robot> has no attribute 'name'"),
        ("</joint>", "", 10, 3, "expected 'joint' tag, not 'robot'"),
        ("<robot name='r'>", "<robot name='r' name='s'>", 1, 17, "attribute 'name' is already defined"),
        (
            "<robot name='r'>",
            "<!DOCTYPE robot [<!ENTITY a 'b'>]>\n<robot name='r'>",
            1,
            1,
            "the file has a document type, which is not read",
        ),
        ("0 0 1'", "0 0 1e306'", 1, 1, "the model that the description gives is refused"),
    ] {
        let found = arm(from, to);
        assert!(found.2.contains(message), "{to}: {found:?}");
        if !message.contains("expected 'joint'") {
            assert_eq!((found.0, found.1), (line, column), "{to}: {}", found.2);
        }
    }
}

#[test]
fn links_that_are_no_tree_are_refused() {
    let robot = |joints: &[(&str, &str, &str)]| {
        let mut text = "<robot name='r'>\n".to_owned();
        for name in ["a", "b", "c", "d"] {
            text += &format!("<link name='{name}'/>\n");
        }
        for (name, parent, child) in joints {
            text += &format!(
                "<joint name='{name}' type='continuous'><parent link='{parent}'/><child link='{child}'/></joint>\n"
            );
        }
        refused(&(text + "</robot>"))
    };
    let circle = "hangs on itself: its parents make a circle";
    let found = robot(&[("1", "a", "b"), ("2", "b", "c"), ("3", "c", "d"), ("4", "d", "a")]);
    assert_eq!(found, (2, 1, format!("link 'a' {circle}")));
    let found = robot(&[("1", "a", "b"), ("2", "c", "d"), ("3", "d", "c")]);
    assert_eq!(found, (4, 1, format!("link 'c' {circle}")));
    let found = robot(&[("1", "a", "b"), ("2", "a", "c"), ("3", "b", "d"), ("4", "c", "d")]);
    assert_eq!(found, (9, 1, "link 'd' is the child of joint '3' already; links must be a tree".to_owned()));
    assert_eq!(refused("<robot name='r'/>").2, "the file has no link that moves");
    assert_eq!(refused("<robot name='r'><link name='a'/></robot>").2, "the file has no link that moves");
}

#[test]
fn files_that_are_too_much_are_refused() {
    let deep = format!("<robot name='r'>{}{}</robot>", "<a>".repeat(100_000), "</a>".repeat(100_000));
    assert_eq!(refused(&deep).2, "the file has more than 256 elements inside each other");
    let long = format!("<robot name='r'>{}</robot>", "<a/>".repeat(500_000));
    assert_eq!(refused(&long).2, "the file has more than 400000 elements");
    let many =
        format!("<robot name='r'>{}</robot>", (0..2000).map(|k| format!("<link name='l{k}'/>")).collect::<String>());
    assert_eq!(refused(&many).2, "the file has more than 1000 links");
    let links: String = (0..80).map(|k| format!("<link name='l{k}'/>")).collect();
    let joints: String = (1..80)
        .map(|k| format!("<joint name='j{k}' type='fixed'><parent link='l0'/><child link='l{k}'/></joint>"))
        .collect();
    let (_, _, message) = refused(&format!("<robot name='r'>{links}{joints}</robot>"));
    assert!(message.contains("79") && message.contains("60"), "{message}");
    let bomb = "<!DOCTYPE r [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;&a;&a;'>]>\n<robot name='&b;'/>";
    assert_eq!(refused(bomb), (1, 1, "the file has a document type, which is not read".to_owned()));
    assert_eq!(refused("<robot name='&a;'/>").2, "the file is not XML that can be read: unknown entity reference 'a'");
}

/// The parser compares each attribute with all others of its element, and the namespaces around an element with each other.
#[test]
fn elements_of_very_many_attributes_are_refused_before_they_are_parsed() {
    let with = |attributes: String| refused(&format!("<robot name='r'>\n <link {attributes}/></robot>"));
    let many = |name: &str, count: usize| (0..count).map(|k| format!(" {name}{k} = '='")).collect::<String>();
    assert_eq!(with(many("a", 80_000)), (2, 2, "<link> has 80000 attributes; must have at most 100".to_owned()));
    assert_eq!(with(many("xmlns:a", 80_000)).2, "<link> has 80000 attributes; must have at most 100");
    let few = with(many("a", 100));
    assert_eq!(few.2, "<link> has no attribute 'name'");
    let spread: String = (0..101).map(|k| format!("<link xmlns:a{k}=\"u\" name='>'/>\n")).collect();
    let found = refused(&format!("<robot name='r'>\n{spread}</robot>"));
    assert_eq!(found, (102, 1, "the file has more than 100 declarations of namespaces".to_owned()));
    // What only looks like attributes is none.
    let text = format!("{0} <!--<a {1}>--><![CDATA[<a {1}>]]><?a {1}?> {0}", many("a", 500), many("b", 500));
    assert_eq!(refused(&format!("<robot name='r'>{text}<link/></robot>")).2, "<link> has no attribute 'name'");
}

#[test]
fn other_files_are_named() {
    assert_eq!(refused("<sdf/>").2, "the root element is <sdf>; must be <robot> (URDF) or <mujoco> (MJCF)");
    assert_eq!(refused("").2, "the file is not XML that can be read: the document does not have a root node");
    let macros =
        "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n  <xacro:property name='a' value='1'/></robot>";
    let (line, column, message) = refused(macros);
    assert_eq!((line, column), (2, 3));
    assert_eq!(message, "the file has elements of xacro, which are not expanded");
}

/// The four-bar with something else in place of a text of it.
fn four_bar(from: &str, to: &str) -> (usize, usize, String) {
    assert!(FOUR_BAR.contains(from), "{from}");
    refused(&FOUR_BAR.replacen(from, to, 1))
}

#[test]
fn mistakes_in_mjcf_have_their_place() {
    for (from, to, line, column, message) in [
        ("pos='0.4 0 0'", "pos='0.4 0'", 4, 25, "body 'rocker': pos is '0.4 0'; must be 3 numbers"),
        ("pos='0.4 0 0'", "quat='0 0 0 0'", 4, 25, "body 'rocker': quat has length zero, so it has no direction"),
        (
            "pos='0.4 0 0'",
            "quat='1 0 0 0' euler='0 0 nan'",
            4,
            40,
            "body 'rocker': 'quat' and 'euler' cannot be used together",
        ),
        ("pos='0.4 0 0'", "euler='0 0 nan'", 4, 25, "body 'rocker': euler is '0 0 nan'; must be 3 numbers"),
        (
            "pos='0.4 0 0'",
            "xyaxes='1 0 0 2 0 0'",
            4,
            25,
            "body 'rocker': xyaxes has length zero, so it has no direction",
        ),
        ("pos='0.4 0 0'", "childclass='c'", 4, 25, "body 'rocker': there is no class 'c'"),
        (
            "name='pivot' axis='0 -1 0'",
            "name='pivot' axis='0 0 0'",
            4,
            59,
            "joint 'pivot': axis has length zero, so it has no direction",
        ),
        ("name='pivot'", "name='pin'", 4, 46, "a second joint is called 'pin'"),
        (
            "name='pivot'",
            "name='pivot' type='screw'",
            4,
            59,
            "joint 'pivot': type is 'screw'; must be hinge, slide, ball or free",
        ),
        (
            "name='pivot'",
            "name='pivot' type='free'",
            4,
            39,
            "joint 'pivot' lets a body float freely; mechanisms stand on the ground",
        ),
        (
            "<joint name='pivot' axis='0 -1 0'/>",
            "<freejoint/>",
            4,
            39,
            "the joint of body 'rocker' lets a body float freely; mechanisms stand on the ground",
        ),
        ("name='rocker' pos", "name='crank' pos", 4, 11, "a second body is called 'crank'"),
        ("<body name='rocker'", "<joint/><body name='rocker'", 4, 5, "<joint> is not read: the world does not move"),
        (
            "<body name='rocker'",
            "<bdoy/><body name='rocker'",
            4,
            5,
            "<bdoy> is not read: no such element belongs to a body",
        ),
        (
            "<body name='rocker'",
            "<replicate count='3'/><body name='rocker'",
            4,
            5,
            "<replicate> is not read: it makes further bodies",
        ),
        ("body2='rocker'", "body2='rokcer'", 6, 50, "connect 'ball': there is no body 'rokcer'"),
        ("body2='rocker'", "body2='coupler'", 6, 13, "connect 'ball' connects body 'coupler' with itself"),
        ("body1='coupler'", "", 6, 13, "connect 'ball' has no attribute 'body1'"),
        (" anchor='0.3 0 0.22'", "", 6, 13, "connect 'ball' has no attribute 'anchor'"),
        ("name='ball'", "name='ball' active='no'", 6, 34, "connect 'ball': active is 'no'; must be true or false"),
        (
            "<worldbody>",
            "<include file='a.xml'/><worldbody>",
            1,
            26,
            "<include> is not read: other files are not opened",
        ),
        (
            "<worldbody>",
            "<compiler angle='grad'/><worldbody>",
            1,
            36,
            "<compiler>: angle is 'grad'; must be degree or radian",
        ),
        (
            "<worldbody>",
            "<compiler eulerseq='xyw'/><worldbody>",
            1,
            36,
            "<compiler>: eulerseq is 'xyw'; must be three letters",
        ),
        (
            "<worldbody>",
            "<compiler coordinate='global'/><worldbody>",
            1,
            36,
            "<compiler>: coordinate is 'global'; must be local",
        ),
        (
            "<worldbody>",
            "<default><default class='a'/><default class='a'/></default><worldbody>",
            1,
            64,
            "a second class is called 'a'",
        ),
        ("<worldbody>", "<default><default/></default><worldbody>", 1, 35, "<default> has no attribute 'class'"),
        ("<worldbody>", "<default><joint axis='0 1'/></default><worldbody>", 1, 1, ""),
        (
            "<joint name='pivot' axis='0 -1 0'/>",
            "<joint/><geom size='0'/>",
            4,
            53,
            "<geom> of body 'rocker': size is '0'; must be above zero",
        ),
        (
            "<joint name='pivot' axis='0 -1 0'/>",
            "<joint/><geom type='box' size='1'/>",
            4,
            64,
            "<geom> of body 'rocker': size is '1'; must be 3 to 3 numbers",
        ),
        (
            "<joint name='pivot' axis='0 -1 0'/>",
            "<joint/><geom/>",
            4,
            47,
            "<geom> of body 'rocker' has no attribute 'size'",
        ),
        (
            "<joint name='pivot' axis='0 -1 0'/>",
            "<inertial pos='0 0 0' mass='1'/>",
            4,
            39,
            "<inertial> of body 'rocker' has no attribute 'diaginertia' or 'fullinertia'",
        ),
    ] {
        // An attribute of a class that nothing takes is not read.
        if message.is_empty() {
            assert!(import_robot(&Source::new("robot.xml", FOUR_BAR.replacen(from, to, 1))).is_ok());
            continue;
        }
        let found = four_bar(from, to);
        assert!(found.2.starts_with(message), "{to}: {found:?}");
        assert_eq!((found.0, found.1), (line, column), "{to}: {}", found.2);
    }
    assert_eq!(refused("<mujoco/>").2, "the file has no link that moves");
}

/// What a text may be replaced by.
const PIECES: [&str; 14] = [
    "",
    "'",
    "<",
    ">",
    "/>",
    "&amp;",
    "&#0;",
    "nan",
    "-1e308",
    "é",
    "<link name='link2'/>",
    "name=''",
    "link1",
    "</robot>",
];

pub fn changed(text: &str, changes: &[(prop::sample::Index, usize, usize)]) -> String {
    let mut text = text.to_owned();
    for (place, piece, cut) in changes {
        let ends: Vec<usize> = text.char_indices().map(|(byte, _)| byte).chain([text.len()]).collect();
        let start = place.index(ends.len());
        let end = (start + cut).min(ends.len() - 1);
        text.replace_range(ends[start]..ends[end], PIECES[*piece]);
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn no_change_of_a_file_makes_the_reader_panic(
        changes in proptest::collection::vec((any::<prop::sample::Index>(), 0..PIECES.len(), 0..12_usize), 1..4),
    ) {
        for text in [PUMA, PUMA_XML, FOUR_BAR] {
            let _ = import_robot(&Source::new("robot.xml", changed(text, &changes)));
        }
    }
}
