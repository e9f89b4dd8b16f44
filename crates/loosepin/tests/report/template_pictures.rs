//! The pictures of the templates and `docs/templates.md` are what the templates make today.
//!
//! With `LOOSEPIN_BLESS=1` in the environment they are written anew, to be looked at before they are committed.

use std::fs;
use std::path::{Path, PathBuf};

use loosepin::accuracy::{MotionPlan, motion};
use loosepin::mechanism::Mechanism;
use loosepin::model::Model;
use loosepin::report::{mechanism_picture, motion_picture};
use loosepin::simulate::controlled_drawing;
use loosepin::space::SpatialModel;
use loosepin::templates::{SPATIAL_TEMPLATES, TEMPLATES, Template, all_templates};

/// Positions of the motion without play, of which one is drawn; the frame holds them all.
const POSITIONS: usize = 72;

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn picture(template: &Template) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../loosepin-import/templates").join(template.name);
    let model = Model::from_path(&folder.join("model.toml")).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{}: {error}", template.name));
    if !mechanism.is_driven() {
        let drawing = controlled_drawing(&mechanism, &values, POSITIONS);
        let drawing = drawing.unwrap_or_else(|error| panic!("{}: {error}", template.name));
        return mechanism_picture(&drawing, template.name);
    }
    let plan = MotionPlan {
        span: model.cycle.span,
        positions: POSITIONS,
        scatter: Vec::new(),
        correlations: Vec::new(),
        paths: Vec::new(),
        asked: Vec::new(),
        overrides: Vec::new(),
    };
    let record = motion(&mechanism, &values, &plan).unwrap_or_else(|error| panic!("{}: {error}", template.name));
    assert!(record.singular_positions.is_empty(), "{}: {:?}", template.name, record.singular_positions);
    mechanism_picture(&record.drawing, template.name)
}

fn picture_in_space(template: &Template) -> String {
    let model = SpatialModel::from_text("model.toml", template.model).unwrap_or_else(|found| panic!("{found}"));
    let record = model.motion_record(&model.quantities.nominal()).unwrap_or_else(|found| panic!("{found}"));
    motion_picture(&record)
}

fn page() -> String {
    let mut page = String::from(
        "# Templates\n\nMechanisms to start from: `loosepin new NAME my_mechanism` writes a commented `model.toml` and \
         `study.toml`; `loosepin new --list` shows this list. Pictures and page are made from the templates by a test.\n",
    );
    for template in all_templates() {
        page.push_str(&format!(
            "\n## {name}\n\n{description}.\n\n![The {name} in one position](images/templates/{name}.svg)\n\n{paragraph}\n",
            name = template.name,
            description = capital(template.description()),
            paragraph = template.paragraph(),
        ));
    }
    page
}

fn capital(line: &str) -> String {
    let mut letters = line.chars();
    letters.next().map_or(String::new(), |first| format!("{}{}", first.to_uppercase(), letters.as_str()))
}

/// Compares a file with what is due, or writes it.
fn compare(path: &Path, due: &str, stale: &mut Vec<String>) {
    if fs::read_to_string(path).ok().as_deref() == Some(due) {
        return;
    }
    if std::env::var_os("LOOSEPIN_BLESS").is_some() {
        fs::write(path, due).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    } else {
        stale.push(path.display().to_string());
    }
}

#[test]
fn pictures_and_page_of_the_templates_are_up_to_date() {
    let folder = repository().join("docs/images/templates");
    let mut stale = Vec::new();
    for template in TEMPLATES {
        assert!(!template.paragraph().is_empty(), "{} does not say what to look at", template.name);
        compare(&folder.join(format!("{}.svg", template.name)), &picture(template), &mut stale);
    }
    for template in SPATIAL_TEMPLATES {
        assert!(!template.paragraph().is_empty(), "{} does not say what to look at", template.name);
        compare(&folder.join(format!("{}.svg", template.name)), &picture_in_space(template), &mut stale);
    }
    compare(&repository().join("docs/templates.md"), &page(), &mut stale);
    let pictures = fs::read_dir(&folder).expect("there are pictures").count();
    assert_eq!(pictures, all_templates().count(), "a picture without a template in {}", folder.display());
    assert!(stale.is_empty(), "out of date: {stale:#?}\nhint: LOOSEPIN_BLESS=1 writes them anew; look at them");
}
