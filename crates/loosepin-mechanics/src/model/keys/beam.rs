//! The keys of flexible links.

use loosepin_text::document::{Key, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

/// Elements at most: their mass matrix is kept whole.
const MOST_ELEMENTS: u64 = 64;
/// Shapes of one kind, at most: 35 kHz of a rod of 0.3 m need four.
const MOST_SHAPES: u64 = 8;

const fn length(name: &'static str, example: &'static str, doc: &'static str) -> Key {
    optional(name, quantity(D::LENGTH, Rule::Positive), example, doc)
}

pub(in crate::model) static SECTION_KEYS: Keys = Keys::new(
    "the section of a beam: width and height, diameter, outer and inner diameter, or area and second moment",
    &[
        length("width", "\"8 mm\"", "width across the plane of motion"),
        length("height", "\"8 mm\"", "height in the plane of motion"),
        length("diameter", "\"8 mm\"", "diameter of a round rod"),
        length("outer_diameter", "\"10 mm\"", "outer diameter of a tube"),
        length("inner_diameter", "\"7 mm\"", "inner diameter of a tube"),
        optional("area", quantity(D::AREA, Rule::Positive), "\"64 mm^2\"", "area A"),
        optional(
            "second_moment",
            quantity(D::SECOND_MOMENT, Rule::Positive),
            "\"341 mm^4\"",
            "second moment of area I about the axis across the plane of motion",
        ),
    ],
)
.with_exactly_one(&[
    &["width", "diameter", "outer_diameter", "area"],
    &["height", "diameter", "inner_diameter", "second_moment"],
]);

pub(in crate::model) static LUMP_KEYS: Keys = Keys::new(
    "a mass at a point of a flexible body",
    &[
        required(
            "at",
            Kind::Text,
            "\"small_end\"",
            "point of the body at which its centre of mass lies; it turns with the section there",
        ),
        required("mass", quantity(D::MASS, Rule::NonNegative), "\"50 g\"", "its mass"),
        optional(
            "inertia",
            quantity(D::INERTIA, Rule::NonNegative),
            "\"2e-6 kg m^2\"",
            "its moment of inertia about its centre of mass; none if left out",
        ),
    ],
);

pub(in crate::model) static BEAM_KEYS: Keys = Keys::new(
    "a straight uniform beam between two points of the body, in place of mass, inertia and centre of mass",
    &[
        required("from", Kind::Text, "\"big_end\"", "point of the body at which the beam begins"),
        required("to", Kind::Text, "\"small_end\"", "point of the body at which it ends"),
        required(
            "section",
            Kind::Table(&SECTION_KEYS),
            "{ width = \"8 mm\", height = \"8 mm\" }",
            "its section; the height lies in the plane of motion",
        ),
        required("youngs_modulus", quantity(D::PRESSURE, Rule::Positive), "\"207 GPa\"", "Young's modulus E"),
        required("density", quantity(D::DENSITY, Rule::Positive), "\"7800 kg/m^3\"", "density"),
        optional(
            "lumps",
            Kind::Tables { keys: &LUMP_KEYS, except: &[] },
            "",
            "floating frame: masses at points of the body beside its own, each under [body.NAME.beam.lumps.NAME]",
        ),
        optional(
            "formulation",
            Kind::Choice(&["floating-frame", "absolute-nodal"]),
            "\"floating-frame\"",
            "floating-frame, if left out: few shapes in a frame that moves with the body, for sections that turn by less than 0.1 rad from \
             it; absolute-nodal: elements whose nodes hold position and slope, for beams that bend far",
        ),
        optional(
            "damping_ratio",
            quantity(D::NUMBER, Rule::NonNegative),
            "0.005",
            "floating frame: damping ratio of every shape; none if left out",
        ),
        optional(
            "elements",
            Kind::Count { least: 1, most: MOST_ELEMENTS },
            "16",
            "absolute nodal coordinates: number of elements; 8 if left out",
        ),
        optional(
            "integration",
            Kind::Choice(&["full", "reduced"]),
            "\"full\"",
            "absolute nodal coordinates: points of integration in each element for stretch and bending; full, if left out: 5 and 3; \
             reduced: 3 and 2, so that few elements are less stiff",
        ),
        optional(
            "retardation_time",
            quantity(D::TIME, Rule::NonNegative),
            "\"1 us\"",
            "absolute nodal coordinates: retardation time of the material, damping ratio ωτ/2 at ω; no damping if left out",
        ),
        optional(
            "frame",
            Kind::Choice(&["secant", "tangent"]),
            "\"secant\"",
            "floating frame: secant, if left out: its x axis goes through both ends; tangent: it turns with the section at from, which a drive or a \
             rigid joint holds",
        ),
        optional(
            "lateral_shapes",
            Kind::Count { least: 0, most: MOST_SHAPES },
            "2",
            "floating frame: number of shapes in which it bends; 2 if left out",
        ),
        optional(
            "axial_shapes",
            Kind::Count { least: 0, most: MOST_SHAPES },
            "2",
            "floating frame: number of shapes in which it stretches, 0 for none; 2 if left out",
        ),
        optional(
            "static_shapes",
            Kind::Choice(&["at-points", "none"]),
            "\"at-points\"",
            "floating frame: at-points, if left out: one more shape of each kind for every point inside on which a joint, a spring, a load or a lump acts; none: the \
             shapes of the beam without such points",
        ),
        optional(
            "condense_above",
            quantity(D::FREQUENCY, Rule::Positive),
            "\"50 kHz\"",
            "floating frame: frequency above which a shape is condensed: it keeps its static flexibility, and its inertia is raised until it has this \
             frequency, so that it needs no shorter steps; no shape is, if left out",
        ),
        optional(
            "foreshortening",
            Kind::Choice(&["second-order", "none"]),
            "\"second-order\"",
            "floating frame: second-order, if left out: a beam that bends becomes shorter, so that it stiffens where it turns and may buckle; none: the \
             linear form",
        ),
        optional(
            "start",
            Kind::Choice(&["undeformed", "settled"]),
            "\"undeformed\"",
            "undeformed, if left out: straight and at rest in its frame, so that it rings; settled: bent and stretched as inertia, weight \
             and loads hold it at the start",
        ),
    ],
);
