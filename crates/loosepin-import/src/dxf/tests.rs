//! Files of other programs, files with mistakes, and files that are damaged.

use proptest::prelude::*;

use super::*;

const MILLIMETRES: i64 = 4;

/// A file of `drawings`, which `draw.py` there wrote with ezdxf.
macro_rules! drawn {
    ($name:literal) => {
        ($name, include_bytes!(concat!("../../drawings/four_bar_", $name, ".dxf")).as_slice())
    };
}

const TEXTS: [(&str, &[u8]); 3] = [drawn!("R12"), drawn!("R2000"), drawn!("R2018")];
const BINARIES: [(&str, &[u8]); 3] = [drawn!("R12_binary"), drawn!("R2000_binary"), drawn!("R2018_binary")];

fn read(bytes: &[u8]) -> Drawing {
    Drawing::read(bytes).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(bytes: &[u8]) -> String {
    Drawing::read(bytes).expect_err("a mistake").to_string()
}

/// Lines, polylines and circles in words, and the number of other things.
fn described(drawing: &Drawing) -> (Vec<String>, usize) {
    let describe = |entity: &Entity| {
        let layer = &entity.layer;
        match &entity.shape {
            Shape::Line(ends) => Some(format!("{layer}: line {ends:?}")),
            Shape::Polyline { vertices, is_closed, .. } | Shape::FlatPolyline { vertices, is_closed } => {
                Some(format!("{layer}: polyline {vertices:?} {is_closed}"))
            }
            Shape::Circle { centre, radius } => Some(format!("{layer}: circle {centre:?} {radius:?}")),
            Shape::Other => None,
        }
    };
    let words: Vec<String> = drawing.entities.iter().filter_map(describe).collect();
    let others = drawing.entities.len() - words.len();
    (words, others)
}

#[test]
fn peer_drawings_of_every_version_hold_what_ezdxf_drew() {
    // As draw.py states it.
    let expected = [
        "0: line [[3.5, -2.25, 0.0], [23.5, 32.391, 0.0]]",
        "0: polyline [[23.5, 32.391, 0.0], [103.5, 92.75, 0.0], [63.5, 107.75, 0.0]] true",
        "0: line [[123.5, 7.75, 0.0], [115.0, 50.0, 0.0]]",
        "0: line [[115.0, 50.0, 0.0], [103.5, 92.75, 0.0]]",
        "Ground: circle [3.5, -2.25, 0.0] 5.0",
        "0: circle [23.5, 32.391, 0.0] 4.0",
        "0: circle [103.5, 92.75, 0.0] 4.5",
        "ground: circle [123.5, 7.75, 0.0] 6.0",
        "0: circle [63.5, 107.75, 0.0] 1.5",
    ];
    for (name, bytes) in TEXTS.into_iter().chain(BINARIES) {
        let drawing = read(bytes);
        // Two blocks, a text, an arc, a point; since R13 a paragraph, a spline, an ellipse and a hatch. R12 has no unit.
        let (unit, others) = if name.starts_with("R12") { (0, 5) } else { (MILLIMETRES, 9) };
        assert_eq!(described(&drawing), (expected.map(str::to_owned).to_vec(), others), "{name}");
        assert_eq!(drawing.insertion_unit, unit, "{name}");
    }
}

const LINE: &str = "  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n  8\nground\n 10\n1.5\n 20\n-2.0\n 11\n 7.25\n 21\n3e1\n  0\nENDSEC\n  0\nEOF\n";
const LINE_READ: &str = "ground: line [[1.5, -2.0, 0.0], [7.25, 30.0, 0.0]]";

#[test]
fn a_line_is_read_however_the_text_is_written() {
    let inserted = |before: &str, text: &str| LINE.replacen(before, &format!("{text}{before}"), 1);
    for text in [
        LINE.to_owned(),
        LINE.replace('\n', "\r\n"),
        format!("\u{feff}{LINE}"),
        format!("999\nwritten by hand\n{LINE}"),
        format!("{LINE}\n\n"),
        // Files that end without their end, and without the end of their last line.
        LINE.replace("  0\nEOF\n", ""),
        LINE.trim_end().to_owned(),
        inserted(" 11\n", "999\na comment\n"),
        inserted(" 11\n", "102\n{SOMEBODY\n 10\n99.0\n  8\nelsewhere\n102\n}\n"),
        inserted("  0\nENDSEC", "1001\nSOMEBODY\n1010\n99.0\n1070\n7\n"),
        // Of R10.
        LINE.replace("LINE\n  8", "3DLINE\n  8"),
    ] {
        assert_eq!(described(&read(text.as_bytes())), (vec![LINE_READ.to_owned()], 0), "{text}");
    }
    let without_layer = described(&read(LINE.replace("  8\nground\n", "").as_bytes())).0;
    assert_eq!(without_layer, [LINE_READ.replace("ground", "0")]);
    assert!(read(b"").entities.is_empty() && read(b"\r\n").entities.is_empty());
    // Layers in an old code page.
    let windows = LINE.as_bytes().iter().map(|byte| if *byte == b'g' { 0xe9 } else { *byte }).collect::<Vec<u8>>();
    assert_eq!(described(&read(&windows)).0, [LINE_READ.replace('g', "\u{fffd}")]);
}

#[test]
fn vertices_belong_to_their_polyline_until_it_ends() {
    let entities = |inside: &str| {
        let text = format!("0\nSECTION\n2\nENTITIES\n{inside}0\nENDSEC\n0\nEOF\n");
        described(&read(text.as_bytes()))
    };
    let vertex = |x: f64| format!("0\nVERTEX\n8\nother\n10\n{x}\n20\n2.5\n30\n0.5\n70\n1\n42\n0.4\n");
    let polyline = "0\nPOLYLINE\n8\nground\n66\n1\n10\n0\n20\n0\n30\n7\n70\n8\n";
    let text = format!("{polyline}{}{}0\nSEQEND\n8\nother\n0\nARC\n10\n1\n", vertex(1.5), vertex(3.0));
    assert_eq!(entities(&text), (vec!["ground: polyline [[1.5, 2.5, 0.5], [3.0, 2.5, 0.5]] false".to_owned()], 1));
    // A vertex of nothing is a thing like any other.
    assert_eq!(entities(&vertex(1.5)), (Vec::new(), 1));
}

#[test]
fn published_mirrored_entities_are_written_with_x_turned_round() {
    // DXF Reference, "Arbitrary Axis Algorithm": Nx and Ny are small, so that Ax = Wy x N = (0, 1, 0) x (0, 0, -1) = (-1, 0, 0).
    let vertex = [3.5, -2.25, 0.5];
    let entity = |name: &str, [nx, ny, nz]: Vertex| {
        let normal = format!("210\n{nx:e}\n220\n{ny:e}\n230\n{nz:e}\n");
        let text = format!("0\nSECTION\n2\nENTITIES\n0\n{name}\n{normal}0\nENDSEC\n0\nEOF\n");
        read(text.as_bytes()).entities.remove(0)
    };
    for name in ["CIRCLE", "LWPOLYLINE", "POLYLINE"] {
        assert_eq!(entity(name, [0.0, 0.0, -1.0]).in_drawing(vertex), Some([-3.5, -2.25, -0.5]), "{name}");
        assert_eq!(entity(name, [1e-12, 0.0, 1.0]).in_drawing(vertex), Some(vertex), "{name}");
        assert_eq!(entity(name, [0.6, 0.0, 0.8]).in_drawing(vertex), None, "{name}");
    }
    // Written in the frame of the drawing, whatever their extrusion.
    for name in ["LINE", "POLYLINE\n70\n8"] {
        assert_eq!(entity(name, [0.0, 0.0, -1.0]).in_drawing(vertex), Some(vertex), "{name}");
    }
}

#[test]
fn mistakes_are_told_with_their_line_or_byte() {
    let broken = |from: &str, to: &str| refused(LINE.replacen(from, to, 1).as_bytes());
    assert_eq!(broken("1.5", "1,5"), "line 10: '1,5' is not a number; the value of a group 10 is");
    assert_eq!(broken(" 11\n", ""), "line 13: '7.25' is not a group code; a group code is a whole number");
    assert_eq!(broken(" 11\n", "-11\n"), "line 13: there is no group code -11");
    assert_eq!(broken("  0\nENDSEC\n  0\nEOF\n", ""), "line 17: the file ends within the section ENTITIES");
    assert_eq!(broken("\n3e1\n  0\nENDSEC\n  0\nEOF\n", ""), "line 15: the file ends within a group");
    assert_eq!(broken("  0\nLINE\n", ""), "line 6: a group 8 stands before the first entity");
    assert_eq!(broken("  0\nSECTION\n", "  5\nSECTION\n"), "line 2: a group 5 stands outside of every section");
    assert_eq!(broken("  2\nENTITIES\n", ""), "line 2: the section has no name");
    assert_eq!(
        broken("LINE", "LWPOLYLINE\n 20\n1"),
        "line 8: a group 20 stands before the first vertex of its polyline"
    );
    assert_eq!(
        refused(b"AC1032\0\x01\x02 a drawing of AutoCAD\n"),
        "line 1: 'AC1032\\0\\u{1}\\u{2} a drawing of A…' is not a group code; a group code is a whole number"
    );
    let (_, binary) = BINARIES[1];
    assert_eq!(refused(&binary[..binary.len() / 2]), "byte 7673: the file ends within a group");
    let mut unknown = binary.to_owned();
    unknown[22..24].copy_from_slice(&[0, 0]);
    unknown[32..34].copy_from_slice(&[0x50, 0]);
    assert_eq!(refused(&unknown), "byte 34: there is no group code 80");
}

/// Lines that mean something in a file.
const LINES: [&str; 20] = [
    "",
    "-1",
    "0",
    "8",
    "10",
    "20",
    "70",
    "102",
    "310",
    "1004",
    "SECTION",
    "ENDSEC",
    "ENTITIES",
    "LINE",
    "POLYLINE",
    "VERTEX",
    "LWPOLYLINE",
    "{X",
    "nan",
    "99999999999999999999",
];

proptest! {
    #[test]
    fn no_text_makes_the_reader_panic(
        file in 0..TEXTS.len(),
        changes in proptest::collection::vec((any::<prop::sample::Index>(), 0..LINES.len(), 0..3_usize), 1..6),
        end in any::<prop::sample::Index>(),
    ) {
        let text = String::from_utf8_lossy(TEXTS[file].1);
        // The header is long and says little.
        let entities = text.find("ENTITIES").expect("the section");
        let mut lines: Vec<&str> = text[entities - "  0\nSECTION\n  2\n".len()..].lines().collect();
        for (place, line, change) in changes {
            let place = place.index(lines.len());
            match change {
                0 => lines[place] = LINES[line],
                1 => lines.insert(place, LINES[line]),
                _ => drop(lines.remove(place)),
            }
        }
        lines.truncate(end.index(2 * lines.len()));
        let _ = Drawing::read(lines.join("\n").as_bytes());
    }

    #[test]
    fn no_binary_file_makes_the_reader_panic(
        file in 0..BINARIES.len(),
        changes in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        end in any::<prop::sample::Index>(),
    ) {
        let mut bytes = BINARIES[file].1.to_owned();
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        bytes.truncate(end.index(2 * bytes.len()));
        let _ = Drawing::read(&bytes);
    }

    #[test]
    fn no_bytes_make_the_reader_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200), is_binary: bool) {
        let sentinel = if is_binary { binary::SENTINEL } else { b"" };
        let _ = Drawing::read(&[sentinel, &bytes].concat());
    }
}
