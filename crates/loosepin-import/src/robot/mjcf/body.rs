//! `<worldbody>`: bodies with their joints.

use super::compiler::{Compiler, Masses, chosen};
use super::defaults::{Defaults, MAIN, Styled};
use super::inertia::{of_geom, of_inertial, together};
use super::orientation::frame;
use crate::robot::description::{GROUND, Inertial, JointSide, Link, RobotJoint, RobotJointKind};
use crate::robot::problem::RobotProblem;
use crate::robot::xml::Element;
use loosepin_space::{Frame, Vec3};
use loosepin_text::diagnostics::Diagnostics;
use std::collections::{HashMap, HashSet};

/// Bodies, joints and names, while a file is read.
pub(super) struct Bodies<'s, 'd> {
    pub compiler: &'s Compiler,
    pub defaults: &'s Defaults<'d>,
    /// Joints with motors.
    pub actuated: HashSet<&'d str>,
    pub links: Vec<Link>,
    pub joints: Vec<RobotJoint>,
    /// Links by the names of bodies, `world` among them.
    pub by_name: HashMap<&'d str, usize>,
    joint_names: HashSet<&'d str>,
    /// Sites by their names: the link, and the place on it.
    pub sites: HashMap<&'d str, (usize, Vec3)>,
    /// Sites without a name, which nothing can refer to.
    pub nameless_sites: usize,
    /// Bodies, those between joints of one body left out.
    pub count: usize,
    /// Geoms in all.
    pub geoms: usize,
    /// Bodies whose mass is that of geoms.
    pub weighed: usize,
    /// Bodies of whose geoms only meshes know the mass.
    pub unweighed: Vec<String>,
}

/// What stands in a body, in its frame.
#[derive(Default)]
struct Content<'s, 'd> {
    joints: Vec<(Styled<'s, 'd>, Frame)>,
    bodies: Vec<(Element<'d>, Frame, usize)>,
    geoms: Vec<(Styled<'s, 'd>, Frame)>,
    sites: Vec<(Styled<'s, 'd>, Frame)>,
    inertial: Option<(Element<'d>, Frame)>,
}

/// Types of joints.
const KINDS: [(&str, Option<RobotJointKind>); 4] = [
    ("hinge", Some(RobotJointKind::Hinge)),
    ("slide", Some(RobotJointKind::Slide)),
    ("ball", Some(RobotJointKind::Ball)),
    ("free", None),
];

impl<'s, 'd> Bodies<'s, 'd> {
    /// The ground alone.
    pub fn new(compiler: &'s Compiler, defaults: &'s Defaults<'d>, actuated: HashSet<&'d str>) -> Bodies<'s, 'd> {
        let ground = Link { name: "world".to_owned(), inertial: None, points: Vec::new() };
        Bodies {
            compiler,
            defaults,
            actuated,
            links: vec![ground],
            joints: Vec::new(),
            by_name: HashMap::from([("world", GROUND)]),
            joint_names: HashSet::new(),
            sites: HashMap::new(),
            nameless_sites: 0,
            count: 0,
            geoms: 0,
            weighed: 0,
            unweighed: Vec::new(),
        }
    }

    /// Reads `<worldbody>`.
    pub fn world(&mut self, element: Element<'d>) -> Result<(), Diagnostics> {
        let mut content = Content::default();
        self.collect(element, &Frame::IDENTITY, MAIN, &mut content)?;
        if let Some((joint, _)) = content.joints.first() {
            let why = "the world does not move";
            return Err(joint.element.error(&RobotProblem::NotRead { element: joint.element.words(), why }));
        }
        self.geoms += content.geoms.len();
        self.read_sites(GROUND, &content)?;
        self.inner(GROUND, content)
    }

    fn inner(&mut self, link: usize, content: Content<'s, 'd>) -> Result<(), Diagnostics> {
        content.bodies.into_iter().try_for_each(|(element, around, class)| self.body(element, link, &around, class))
    }

    /// What an element holds, that of frames in it as well.
    fn collect(
        &self,
        element: Element<'d>,
        around: &Frame,
        class: usize,
        content: &mut Content<'s, 'd>,
    ) -> Result<(), Diagnostics> {
        for child in element.children() {
            match child.tag() {
                "joint" | "freejoint" => content.joints.push((self.defaults.styled(child, class)?, *around)),
                "geom" => content.geoms.push((self.defaults.styled(child, class)?, *around)),
                "site" => content.sites.push((self.defaults.styled(child, class)?, *around)),
                "body" => content.bodies.push((child, *around, class)),
                "inertial" if content.inertial.is_none() => content.inertial = Some((child, *around)),
                "inertial" => {
                    let problem = RobotProblem::Twice { element: element.words(), what: "inertial" };
                    return Err(child.error(&problem));
                }
                "frame" => {
                    let class = child.attribute("childclass").map_or(Ok(class), |name| self.defaults.class(&name))?;
                    let own = frame(|name| child.attribute(name), self.compiler)?;
                    self.collect(child, &around.compose(&own), class, content)?;
                }
                "camera" | "light" | "plugin" => {}
                "composite" | "flexcomp" | "replicate" | "attach" | "include" => {
                    let why = "it makes further bodies; write them out, as MuJoCo does when it saves a model";
                    return Err(child.error(&RobotProblem::NotRead { element: child.words(), why }));
                }
                _ => {
                    let why = "no such element belongs to a body";
                    return Err(child.error(&RobotProblem::NotRead { element: child.words(), why }));
                }
            }
        }
        Ok(())
    }

    fn body(&mut self, element: Element<'d>, parent: usize, around: &Frame, class: usize) -> Result<(), Diagnostics> {
        self.count += 1;
        let name = element.attribute("name");
        let class = element.attribute("childclass").map_or(Ok(class), |name| self.defaults.class(&name))?;
        let at = around.compose(&frame(|name| element.attribute(name), self.compiler)?);
        let mut content = Content::default();
        self.collect(element, &Frame::IDENTITY, class, &mut content)?;
        let own_name = name.map_or_else(|| format!("body{}", self.count), |name| name.text.to_owned());
        let link = self.chain(&content, &own_name, parent, &at)?;
        if let Some(name) = name
            && self.by_name.insert(name.text, link).is_some()
        {
            return Err(name.error(&RobotProblem::SameName { kind: "body", name: name.shown() }));
        }
        self.links[link].inertial = self.mass(&content, &own_name)?;
        self.read_sites(link, &content)?;
        self.inner(link, content)
    }

    /// The joints of a body, each but the last with a body of no mass behind it; the number of the body itself.
    fn chain(
        &mut self,
        content: &Content<'s, 'd>,
        name: &str,
        parent: usize,
        at: &Frame,
    ) -> Result<usize, Diagnostics> {
        let count = content.joints.len();
        let (mut before, mut frame) = (parent, *at);
        for (number, (joint, around)) in content.joints.iter().enumerate() {
            let link = self.links.len();
            let mut own = self.joint(joint, around, name, number, count)?;
            own.child.link = link;
            own.parent = own.child.seen_from(before, &frame);
            let reference = own.reference;
            let own = own.with_reference(reference);
            let link_name = if number + 1 == count { name.to_owned() } else { format!("{name}_{}", own.name) };
            self.links.push(Link { name: link_name, inertial: None, points: Vec::new() });
            self.joints.push(own);
            (before, frame) = (link, Frame::IDENTITY);
        }
        if count > 0 {
            return Ok(before);
        }
        let link = self.links.len();
        let side = JointSide::new(link, Vec3::ZERO, Vec3::Z);
        self.links.push(Link { name: name.to_owned(), inertial: None, points: Vec::new() });
        self.joints.push(RobotJoint {
            name: name.to_owned(),
            kind: RobotJointKind::Fixed,
            parent: side.seen_from(parent, at),
            child: side,
            reference: 0.0,
            limits: None,
            is_actuated: false,
            closes_loop: false,
            comments: Vec::new(),
        });
        Ok(link)
    }

    /// A joint with its side on the body; its parent is that of the side as well so far.
    fn joint(
        &mut self,
        joint: &Styled<'s, 'd>,
        around: &Frame,
        body: &str,
        number: usize,
        count: usize,
    ) -> Result<RobotJoint, Diagnostics> {
        let element = joint.element;
        let kind = match joint.attribute("type") {
            _ if element.tag() == "freejoint" => None,
            Some(own) => chosen(&own, "type", &KINDS)?,
            None => Some(RobotJointKind::Hinge),
        };
        let Some(kind) = kind else {
            let words = if element.attribute("name").is_some() {
                element.words()
            } else {
                format!("the joint of body '{body}'")
            };
            return Err(element.error(&RobotProblem::Floating { element: words }));
        };
        let name = match element.attribute("name") {
            Some(name) if !self.joint_names.insert(name.text) => {
                return Err(name.error(&RobotProblem::SameName { kind: "joint", name: name.shown() }));
            }
            Some(name) => name.text.to_owned(),
            None if count == 1 => body.to_owned(),
            None => format!("{body}{}", number + 1),
        };
        let point_m = joint.attribute("pos").map_or(Ok(Vec3::ZERO), |own| own.vector())?;
        let axis = joint.attribute("axis").map_or(Ok(Vec3::Z), |own| own.direction("axis"))?;
        // A ball has no axis.
        let axis = if kind == RobotJointKind::Ball { Vec3::Z } else { around.axes.apply(axis) };
        let side = JointSide::new(GROUND, around.point_m(point_m), axis);
        let reference = joint.attribute("ref").map_or(Ok(0.0), |own| own.number())? * self.unit(kind);
        let is_actuated = element.attribute("name").is_some_and(|name| self.actuated.contains(name.text));
        let limits = self.limits(joint, kind)?;
        Ok(RobotJoint {
            name,
            kind,
            parent: side,
            child: side,
            reference,
            limits,
            is_actuated,
            closes_loop: false,
            comments: Vec::new(),
        })
    }

    /// The unit of the coordinate of a joint, rad or m.
    fn unit(&self, kind: RobotJointKind) -> f64 {
        if kind == RobotJointKind::Hinge { self.compiler.radians } else { 1.0 }
    }

    /// The range of a joint.
    fn limits(&self, joint: &Styled<'s, 'd>, kind: RobotJointKind) -> Result<Option<[f64; 2]>, Diagnostics> {
        let is_limited = joint.attribute("limited").is_none_or(|own| own.text != "false");
        let has_range = matches!(kind, RobotJointKind::Hinge | RobotJointKind::Slide);
        let Some(range) = joint.attribute("range").filter(|_| is_limited && has_range) else { return Ok(None) };
        let [lower, upper] = range.numbers::<2>()?.map(|limit| limit * self.unit(kind));
        Ok((lower < upper).then_some([lower, upper]))
    }

    fn mass(&mut self, content: &Content<'s, 'd>, name: &str) -> Result<Option<Inertial>, Diagnostics> {
        self.geoms += content.geoms.len();
        let inertial = content.inertial.filter(|_| self.compiler.masses != Masses::Geoms);
        if let Some((element, around)) = inertial {
            return of_inertial(element, &around, self.compiler).map(Some);
        }
        if self.compiler.masses == Masses::Inertial {
            return Ok(None);
        }
        let mut parts = Vec::new();
        for (geom, around) in &content.geoms {
            match of_geom(geom, around, self.compiler)? {
                Some(part) => parts.push(part),
                None => {
                    self.unweighed.push(name.to_owned());
                    return Ok(None);
                }
            }
        }
        let found = together(&parts);
        self.weighed += usize::from(found.is_some());
        Ok(found)
    }

    /// Sites become points.
    fn read_sites(&mut self, link: usize, content: &Content<'s, 'd>) -> Result<(), Diagnostics> {
        for (site, around) in &content.sites {
            let Some(name) = site.element.attribute("name") else {
                self.nameless_sites += 1;
                continue;
            };
            let at_m = around.point_m(site.attribute("pos").map_or(Ok(Vec3::ZERO), |own| own.vector())?);
            if self.sites.insert(name.text, (link, at_m)).is_some() {
                return Err(name.error(&RobotProblem::SameName { kind: "site", name: name.shown() }));
            }
            self.links[link].points.push((name.text.to_owned(), at_m));
        }
        Ok(())
    }
}
