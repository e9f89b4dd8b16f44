//! `<default>`: attributes that elements have without writing them, by class.

use crate::robot::problem::RobotProblem;
use crate::robot::xml::{Attribute, Element};
use loosepin_text::diagnostics::Diagnostics;

/// A class: what it inherits from, and its own elements.
struct Class<'d> {
    name: &'d str,
    parent: Option<usize>,
    own: Vec<Element<'d>>,
}

/// The classes of a file; the first is that of all elements without a class.
pub(super) struct Defaults<'d> {
    classes: Vec<Class<'d>>,
}

/// The class of elements without one.
pub(super) const MAIN: usize = 0;

impl<'d> Defaults<'d> {
    /// Reads all elements `<default>` of a file.
    pub fn read(root: Element<'d>) -> Result<Defaults<'d>, Diagnostics> {
        let mut defaults = Defaults { classes: vec![Class { name: "main", parent: None, own: Vec::new() }] };
        for (number, element) in root.all("default").enumerate() {
            // The name of the outermost class is free.
            if let Some(name) = element.attribute("class").filter(|_| number == 0) {
                defaults.classes[MAIN].name = name.text;
            }
            defaults.add(element, MAIN)?;
        }
        Ok(defaults)
    }

    fn add(&mut self, element: Element<'d>, class: usize) -> Result<(), Diagnostics> {
        for child in element.children() {
            if child.tag() != "default" {
                self.classes[class].own.push(child);
                continue;
            }
            let name = child.required_attribute("class")?;
            if self.classes.iter().any(|other| other.name == name.text) {
                return Err(name.error(&RobotProblem::SameName { kind: "class", name: name.shown() }));
            }
            self.classes.push(Class { name: name.text, parent: Some(class), own: Vec::new() });
            self.add(child, self.classes.len() - 1)?;
        }
        Ok(())
    }

    /// The class that an attribute names.
    pub fn class(&self, name: &Attribute<'d>) -> Result<usize, Diagnostics> {
        self.classes
            .iter()
            .position(|class| class.name == name.text)
            .ok_or_else(|| name.error(&RobotProblem::Unknown { element: name.of(), kind: "class", name: name.shown() }))
    }

    /// An element with the attributes of its class, or of the class of what is around it.
    pub fn styled<'s>(&'s self, element: Element<'d>, around: usize) -> Result<Styled<'s, 'd>, Diagnostics> {
        let class = element.attribute("class").map_or(Ok(around), |name| self.class(&name))?;
        Ok(Styled { element, defaults: self, class })
    }
}

/// An element with the attributes of its class.
#[derive(Clone, Copy)]
pub(super) struct Styled<'s, 'd> {
    /// The element.
    pub element: Element<'d>,
    defaults: &'s Defaults<'d>,
    class: usize,
}

impl<'d> Styled<'_, 'd> {
    /// An attribute of the element, or of its class.
    pub fn attribute(&self, name: &str) -> Option<Attribute<'d>> {
        self.element.attribute(name).or_else(|| self.inherited(self.element.tag(), name))
    }

    /// An attribute of its class, as elements of this tag have it.
    pub fn inherited(&self, tag: &str, name: &str) -> Option<Attribute<'d>> {
        let mut class = Some(self.class);
        while let Some(number) = class {
            let own = self.defaults.classes.get(number)?;
            // Of several elements of one tag, the last one counts.
            let found = own.own.iter().rev().filter(|element| element.tag() == tag).find_map(|own| own.attribute(name));
            if found.is_some() {
                return found;
            }
            class = own.parent;
        }
        None
    }
}
