//! Why a drawing gives no model.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use loosepin_text::diagnostics::{Code, Problem};

/// Why a drawing gives no model. Places are coordinates of the drawing, with its unit.
#[derive(Debug, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum ImportError {
    #[error("the drawing cannot be read as DXF: {reason}")]
    NoDrawing { reason: String },
    #[error("the drawing does not say its unit: $INSUNITS is not set")]
    NoUnit,
    #[error("the drawing is in {unit}, which models do not know")]
    ForeignUnit { unit: String },
    #[error("'{text}' is no unit of length")]
    NotAUnit { text: String },
    #[error("{what} at {place} {why}")]
    NotPlanar { what: &'static str, place: String, why: &'static str },
    #[error("the drawing has no {what}")]
    Nothing { what: &'static str },
    #[error("the {what} at {place} has no {size}")]
    NoSize { what: &'static str, place: String, size: &'static str },
    #[error("two circles have their centre at {place}")]
    TwoCircles { place: String },
    #[error("no link meets the circle at {place}")]
    LooseCircle { place: String },
    #[error("the link from {place} meets no circle")]
    LooseLink { place: String },
    #[error("no circle on the layer 'ground' meets a link")]
    NoGround,
    #[error("{} is there already; it is not overwritten", path.display())]
    Exists { path: PathBuf },
    #[error("cannot write {}: {source}", path.display())]
    Write { path: PathBuf, source: io::Error },
}

impl Problem for ImportError {
    fn code(&self) -> Code {
        match self {
            Self::NoDrawing { .. } => Code::NotADrawing,
            Self::Exists { .. } => Code::FileExists,
            Self::Write { .. } => Code::FolderNotUsable,
            _ => Code::DrawingNotAMechanism,
        }
    }

    fn hint(&self) -> Option<String> {
        Some(match self {
            Self::NoDrawing { .. } => "save it from the drawing program as DXF".to_owned(),
            Self::NoUnit | Self::ForeignUnit { .. } => "give it with --unit, for example --unit mm".to_owned(),
            Self::NotAUnit { .. } => "for example mm, cm, m or in".to_owned(),
            Self::Nothing { .. } => "draw links as lines or polylines, joints as circles".to_owned(),
            Self::TwoCircles { .. } => "keep the circle of the pin; play is written in the model".to_owned(),
            Self::LooseCircle { .. } => {
                "draw links to its centre, or raise --tolerance where they end beside it".to_owned()
            }
            Self::LooseLink { .. } => {
                "draw a circle where it is joined, or put it on the layer 'ground' where it does not move".to_owned()
            }
            Self::NoGround => "put the circles that stand in the ground on a layer called ground".to_owned(),
            Self::Exists { .. } => {
                "give another folder, for example: loosepin import sketch.dxf my_mechanism".to_owned()
            }
            Self::NotPlanar { .. } | Self::NoSize { .. } | Self::Write { .. } => return None,
        })
    }
}
