//! Why a drawing gives no model.

use std::io;
use std::path::PathBuf;

use loosepin_files::io_error_words;
use loosepin_text::diagnostics::{Code, problems};

problems! {
    /// Why a drawing gives no model. Places are coordinates of the drawing, with its unit.
    #[derive(Debug)]
    pub enum ImportError {
        NoDrawing { reason: String } => Code::NotADrawing,
            says("the drawing cannot be read as DXF: {reason}"),
            hint("save it from the drawing program as DXF");
        NoUnit => Code::DrawingNotAMechanism,
            says("the drawing does not give its unit: $INSUNITS is not set"),
            hint("give it with --unit, for example --unit mm");
        ForeignUnit { unit: String } => Code::DrawingNotAMechanism,
            says("the drawing is in {unit}, a unit that models do not support"),
            hint("give it with --unit, for example --unit mm");
        NotAUnit { text: String } => Code::DrawingNotAMechanism,
            says("'{text}' is not a unit of length"),
            hint("for example mm, cm, m or in");
        NotPlanar { what: &'static str, place: String, why: &'static str } => Code::DrawingNotAMechanism,
            says("{what} at {place} {why}");
        Nothing { what: &'static str } => Code::DrawingNotAMechanism,
            says("the drawing has no {what}"),
            hint("draw links as lines or polylines, joints as circles");
        NoSize { what: &'static str, place: String, size: &'static str } => Code::DrawingNotAMechanism,
            says("the {what} at {place} has no {size}");
        TwoCircles { place: String } => Code::DrawingNotAMechanism,
            says("two circles have their centre at {place}"),
            hint("keep the circle of the pin; the model gives the play");
        LooseCircle { place: String } => Code::DrawingNotAMechanism,
            says("no link meets the circle at {place}"),
            hint("draw links to its centre, or use a larger --tolerance if they end close to it");
        LooseLink { place: String } => Code::DrawingNotAMechanism,
            says("the link from {place} meets no circle"),
            hint("draw a circle at its joint, or move the link to the layer 'ground' if it is fixed");
        NoGround => Code::DrawingNotAMechanism,
            says("no circle on the layer 'ground' meets a link"),
            hint("move the circles of fixed joints to a layer called ground");
        OptionOfDrawings { option: &'static str } => Code::WrongKindOfFile,
            says("{option} is for drawings; robot descriptions are in metres");
        Exists { path: PathBuf } => Code::FileExists,
            says("{} already exists; it is not overwritten", path.display()),
            hint("give another folder, for example: loosepin import sketch.dxf my_mechanism");
        Write { path: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot write {}: {}", path.display(), io_error_words(source));
    }
}
