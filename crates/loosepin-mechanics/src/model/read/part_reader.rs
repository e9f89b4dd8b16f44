//! The reader of the model, as far as all kinds of parts know it.

use super::reader::ModelReader;
use crate::model::ids::{BodyId, JointId, PointId};
use crate::model::part_reader::PartReader;
use loosepin_text::document::{Entry, Reader, Reads};
use loosepin_text::numbers::{NumberReader, ReadsNumbers};

impl Reads for ModelReader {
    fn document(&mut self) -> &mut Reader {
        &mut self.numbers.reader
    }
}

impl ReadsNumbers for ModelReader {
    fn numbers(&mut self) -> &mut NumberReader {
        &mut self.numbers
    }
}

impl PartReader for ModelReader {
    fn point(&mut self, entry: &Entry<'_>) -> Option<PointId> {
        Self::point(self, entry)
    }

    fn body(&mut self, entry: &Entry<'_>) -> Option<BodyId> {
        let name = self.numbers.reader.text(entry)?;
        Self::body(self, entry, name)
    }

    fn joint(&mut self, entry: &Entry<'_>) -> Option<JointId> {
        let text = self.numbers.reader.text(entry)?;
        let name = text.strip_prefix("joint.").unwrap_or(text);
        self.numbers.named(entry, "joint", name, &self.joint_names)
    }

    fn body_name(&self, body: BodyId) -> String {
        self.bodies[body.0].name.clone()
    }

    fn joint_name(&self, joint: JointId) -> String {
        self.joints[joint.0].name.clone()
    }
}

#[cfg(test)]
mod tests {
    use crate::model::Model;

    /// The slider-crank template.
    const SLIDER_CRANK: &str = include_str!("../../../../loosepin-import/templates/slider-crank/model.toml");

    #[test]
    fn a_joint_is_named_with_its_table_or_without() {
        let joint_of_drive = |joint: &str| {
            let (before, drive) = SLIDER_CRANK.split_once("[drive.").unwrap();
            let text =
                format!("{before}[drive.{}", drive.replacen("joint = \"main\"", &format!("joint = \"{joint}\""), 1));
            let model = Model::from_text("model.toml", &text).map_err(|diagnostics| diagnostics.to_string())?;
            Ok::<String, String>(model.joints[model.drives[0].joint.0].name.clone())
        };
        assert_eq!(joint_of_drive("main"), Ok("main".to_owned()));
        assert_eq!(joint_of_drive("joint.main"), Ok("main".to_owned()));
        assert!(joint_of_drive("joint.joint.main").is_err());
    }
}
