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
            says("the drawing does not say its unit: $INSUNITS is not set"),
            hint("give it with --unit, for example --unit mm");
        ForeignUnit { unit: String } => Code::DrawingNotAMechanism,
            says("the drawing is in {unit}, which models do not know"),
            hint("give it with --unit, for example --unit mm");
        NotAUnit { text: String } => Code::DrawingNotAMechanism,
            says("'{text}' is no unit of length"),
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
            hint("keep the circle of the pin; play is written in the model");
        LooseCircle { place: String } => Code::DrawingNotAMechanism,
            says("no link meets the circle at {place}"),
            hint("draw links to its centre, or raise --tolerance where they end beside it");
        LooseLink { place: String } => Code::DrawingNotAMechanism,
            says("the link from {place} meets no circle"),
            hint("draw a circle where it is joined, or put it on the layer 'ground' where it does not move");
        NoGround => Code::DrawingNotAMechanism,
            says("no circle on the layer 'ground' meets a link"),
            hint("put the circles that stand in the ground on a layer called ground");
        Exists { path: PathBuf } => Code::FileExists,
            says("{} is there already; it is not overwritten", path.display()),
            hint("give another folder, for example: loosepin import sketch.dxf my_mechanism");
        Write { path: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot write {}: {}", path.display(), io_error_words(source));
    }
}
