//! Notes on contact forces: the law, the restitution that it delivers, its limits, and the meaning of deep penetrations.

use crate::medium::short_answer::Said;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{capitalised, count, listed};
use loosepin_result::simulation::{JointSummary, SimulationRecord};
use loosepin_result::study::{JointImpacts, StudyResult};
use loosepin_result::{ContactBasis, ContactShape, LongPinForce};
use loosepin_text::units::SiUnit;

/// Largest penetration over clearance up to which nothing is said. The patch of a point or line contact then reaches to a/R ≈ √(δ/c),
/// 18° to each side, and all laws of contact suppose a patch that is small beside the pin.
const DEEPEST_SHARE: f64 = 0.1;
/// The least impact speed where a model gives none, m/s.
const USUAL_FLOOR_M_S: f64 = 1e-3;
/// Digits of a force that is estimated.
const ESTIMATE_DIGITS: usize = 2;

/// A joint whose forces are shown, whichever record they stand in.
pub(crate) struct JointForces<'a> {
    joint: &'a str,
    /// The laws with what they rest on; several where a study has a list.
    laws: Vec<(&'a str, &'a ContactBasis)>,
    /// Smallest and largest restitution as stated, and as delivered by a free impact.
    restitution: Option<[f64; 2]>,
    delivered: Option<[f64; 2]>,
    share_outside_validity: Option<f64>,
    penetration_share: f64,
    long_pin: Option<&'a LongPinForce>,
    /// Contacts that began, and whether none was an impact.
    contacts: u64,
    has_impacts: bool,
    /// The fastest of them, where it is known, m/s.
    fastest_m_s: Option<f64>,
    /// Whether they are those of a single run, not of a study.
    is_of_run: bool,
    /// What distinguishes the ends of a range in tags; a single run has none.
    ends: [&'static str; 2],
}

impl<'a> JointForces<'a> {
    pub fn run(joint: &'a JointSummary) -> Self {
        let both = |value: Option<f64>| value.map(|value| [value; 2]);
        Self {
            joint: &joint.joint,
            laws: joint.basis.iter().map(|basis| (&joint.law[..], basis)).collect(),
            restitution: both(joint.nominal_restitution),
            delivered: both(joint.delivered_restitution),
            share_outside_validity: joint.share_outside_validity,
            penetration_share: joint.largest_penetration_m / joint.radial_clearance_m,
            long_pin: joint.long_pin.as_ref(),
            contacts: joint.contacts,
            has_impacts: joint.impacts > 0,
            fastest_m_s: Some(joint.largest_speed_m_s),
            is_of_run: true,
            ends: [""; 2],
        }
    }

    pub fn study(joint: &'a JointImpacts) -> Self {
        Self {
            joint: &joint.joint,
            laws: joint.laws.iter().map(|own| (&own.law[..], &own.basis)).collect(),
            restitution: joint.nominal_restitution,
            delivered: joint.delivered_restitution,
            share_outside_validity: joint.share_outside_validity,
            penetration_share: joint.largest_penetration_share,
            long_pin: None,
            contacts: joint.floored_contacts,
            has_impacts: joint.impacts_per_turn[2] > 0.0,
            fastest_m_s: None,
            is_of_run: false,
            ends: [" least", " most"],
        }
    }

    fn tag(&self, statistic: &str, part: &str) -> Tag {
        Tag::joint(self.joint, statistic, part)
    }

    fn percent(&self, statistic: &str, part: &str, share: f64, writer: &NumberWriter) -> String {
        writer.with_tag(&self.tag(statistic, part)).percent(share, Rounding::Up)
    }

    /// Each law with what it rests on.
    pub fn laws(&self, writer: &NumberWriter) -> Vec<String> {
        self.laws.iter().map(|(law, basis)| law_words(self.joint, law, basis, writer)).collect()
    }

    /// The law, the restitution that it delivers, its limits; `None` in records of older versions.
    pub fn sentence(&self, writer: &NumberWriter) -> Option<String> {
        let laws = self.laws(writer);
        if laws.is_empty() {
            return None;
        }
        let mut sentence = format!("Contact forces in {} are those of {}.", self.joint, listed(&laws));
        let details: Vec<String> =
            [self.restitution_words(writer), self.limits_words(writer)].into_iter().flatten().collect();
        if !details.is_empty() {
            sentence.push_str(&format!(" {}.", capitalised(&details.join("; "))));
        }
        if let Some(long_pin) = self.long_pin {
            sentence.push_str(&format!(" {}", long_pin_sentence(self.joint, long_pin, writer)));
        }
        Some(sentence)
    }

    fn restitution_words(&self, writer: &NumberWriter) -> Option<String> {
        let range = |what: &str, [from, to]: [f64; 2]| {
            let [least, most] = self.ends;
            let [from, to] = [(from, least), (to, most)].map(|(end, part)| {
                writer
                    .with_tag(&self.tag("restitution", &format!("{what}{part}")))
                    .shortest((end * 1e4).round() / 1e4, &SiUnit::NONE)
            });
            if from == to { from } else { format!("{from} to {to}") }
        };
        let (stated, delivered) = (self.restitution?, self.delivered?);
        Some(format!(
            "the stated restitution of {} acts as {} in a free impact",
            range("stated", stated),
            range("delivered", delivered)
        ))
    }

    fn limits_words(&self, writer: &NumberWriter) -> Option<String> {
        let of_all = |limit: fn(&ContactBasis) -> Option<f64>| {
            self.laws.iter().filter_map(|(_, basis)| limit(basis)).min_by(f64::total_cmp)
        };
        let speed = of_all(|basis| basis.largest_valid_speed_m_s).map(|limit_m_s| {
            let limit = writer.with_tag(&self.tag("validity", "fastest")).rounded(
                limit_m_s,
                &SiUnit::VELOCITY,
                2,
                Rounding::Nearest,
            );
            match self.share_outside_validity {
                Some(share) => format!(
                    "impacts up to {limit} ({} are faster)",
                    self.percent("impacts", "outside validity", share, writer)
                ),
                None => format!("impacts up to {limit}"),
            }
        });
        let depth = of_all(|basis| basis.largest_valid_penetration_m).map(|limit_m| {
            format!(
                "penetrations up to {}",
                writer.with_tag(&self.tag("validity", "deepest")).rounded(limit_m, &SiUnit::LENGTH, 2, Rounding::Down)
            )
        });
        let limits: Vec<String> = [speed, depth].into_iter().flatten().collect();
        (!limits.is_empty()).then(|| format!("valid for {}", listed(&limits)))
    }

    /// That impacts are faster than the law is valid for, and what to do; `None` if none is.
    pub fn beyond_validity(&self, writer: &NumberWriter) -> Option<String> {
        let share = self.share_outside_validity.filter(|share| *share > 0.0)?;
        // A law that takes a restitution can take a smaller one.
        let (reason, instead) = match self.restitution {
            Some(_) => ("; real parts rebound less", "a lower restitution"),
            None => ("", "another contact law"),
        };
        Some(format!(
            "{} of the impacts in {} are faster than the contact law is valid for{reason}. Use the answer only if a {} with {instead} gives nearly the same.",
            self.percent("impacts", "outside validity", share, writer),
            self.joint,
            if self.is_of_run { "run" } else { "study" }
        ))
    }

    /// Says where all contacts began below a least impact speed that the model has raised; `None` if it is the usual one.
    pub fn slow(&self, writer: &NumberWriter) -> Option<String> {
        let floors = self.laws.iter().filter_map(|(_, basis)| basis.minimum_impact_speed_m_s);
        let floor_m_s = floors.min_by(f64::total_cmp).filter(|floor_m_s| *floor_m_s > USUAL_FLOOR_M_S)?;
        if self.has_impacts || self.contacts == 0 {
            return None;
        }
        let fastest = self.fastest_m_s.map_or(String::new(), |speed_m_s| {
            format!(
                " (the fastest at {})",
                writer.with_tag(&self.tag("impacts", "largest speed")).value(speed_m_s, &SiUnit::VELOCITY)
            )
        });
        Some(format!(
            "In {} no contact began faster than the minimum impact speed of {}{fastest}: all are computed as impacts at this speed, which lose less energy, and none is counted. Use a lower minimum_impact_speed.",
            self.joint,
            writer.with_tag(&Tag::Given("least impact speed")).value_shortest(floor_m_s, &SiUnit::VELOCITY)
        ))
    }

    /// Whether a contact is so soft that the parts pass through each other: none that its law describes.
    pub fn is_law_broken(&self) -> bool {
        self.penetration_share > 1.0
    }

    /// Meaning of a penetration beyond a tenth of the clearance; `None` below.
    pub fn warning(&self, writer: &NumberWriter) -> Option<String> {
        let share = Some(self.penetration_share).filter(|share| share.is_finite() && *share > DEEPEST_SHARE)?;
        let reached = format!(
            "In {} the parts penetrate each other by up to {} of the clearance",
            self.joint,
            self.percent("penetration", "largest share", share, writer)
        );
        if self.is_law_broken() {
            return Some(format!("{reached}: the contact law does not hold. Check Young's modulus and the masses."));
        }
        let is_given = self.laws.iter().all(|(_, basis)| basis.shape == ContactShape::Given) && !self.laws.is_empty();
        Some(if is_given {
            format!("{reached}, more than a tenth: force and deviation depend on the given stiffness.")
        } else {
            format!(
                "{reached}; contact laws hold up to about a tenth. Force and deviation depend on the law: compare with another one."
            )
        })
    }
}

/// How many contacts began slower than the law can be computed with; `None` if none did.
pub(crate) fn min_impact_speed_words(joint: &str, contacts: u64, writer: &NumberWriter) -> Option<String> {
    let number = || count(contacts, &writer.with_tag(&Tag::joint(joint, "impacts", "very slow")));
    (contacts > 0).then(|| format!("{} computed with the smallest impact speed of the law", number()))
}

fn law_words(joint: &str, law: &str, basis: &ContactBasis, writer: &NumberWriter) -> String {
    let tag = Tag::joint(joint, "bearing length", "");
    let writer = writer.with_tag(&tag);
    let default = if basis.is_law_named { "" } else { " by default" };
    let length = |length_m: f64| writer.value_trimmed(length_m, &SiUnit::LENGTH);
    match basis.shape {
        ContactShape::Point { unused_length_m: None } => {
            format!("{law}{default} (point contact, no length of the bearing enters)")
        }
        ContactShape::Point { unused_length_m: Some(length_m) } => {
            format!("{law}{default} (point contact, the bearing's length of {} does not enter)", length(length_m))
        }
        ContactShape::Given => format!("{law}{default} (stiffness as given)"),
        ContactShape::Line { length_m } => format!("{law}{default} (line contact over {})", length(length_m)),
        ContactShape::Foundation => format!("the elastic foundation between worn surfaces, with the loss of {law}"),
    }
}

fn long_pin_sentence(joint: &str, long_pin: &LongPinForce, writer: &NumberWriter) -> String {
    let LongPinForce { law, length_m, is_length_given, force_n } = long_pin;
    let length =
        writer.with_tag(&Tag::joint(joint, "length of a line contact", "")).value_trimmed(*length_m, &SiUnit::LENGTH);
    let over = if *is_length_given { length } else { format!("{length}, its diameter,") };
    match force_n {
        Some(force_n) => format!(
            "As a line contact over {over} the same impact energy gives about {} ({law}).",
            writer.with_tag(&Tag::joint(joint, "normal force", "as a line contact")).rounded(
                *force_n,
                &SiUnit::FORCE,
                ESTIMATE_DIGITS,
                Rounding::Nearest
            )
        ),
        None => format!("A line contact over {over} ({law}) is not defined up to the same impact energy."),
    }
}

/// The law behind the force of each joint of a run that carried one, and what puts these forces in doubt: impacts beyond the validity of the law,
/// deep penetrations, slow contacts.
pub(crate) fn run_said(record: &SimulationRecord, writer: &NumberWriter) -> Vec<Said> {
    let forces: Vec<JointForces> =
        record.joints.iter().filter(|joint| joint.peak_force_n > 0.0).map(JointForces::run).collect();
    let laws = forces.iter().filter_map(|of| of.sentence(writer)).map(Said::detail);
    laws.chain(force_warnings(&forces, writer).into_iter().map(Said::caveat)).collect()
}

/// What puts the forces of joints in doubt, the most serious first: laws that do not hold, impacts beyond the validity of a law, deep penetrations
/// and slow contacts.
pub(crate) fn force_warnings(forces: &[JointForces], writer: &NumberWriter) -> Vec<String> {
    let soft = |of: &&JointForces| [of.warning(writer), of.slow(writer)];
    // A contact whose law does not hold is worse than one beyond its validity.
    let (broken, sound): (Vec<&JointForces>, Vec<&JointForces>) = forces.iter().partition(|of| of.is_law_broken());
    let beyond = forces.iter().map(|of| of.beyond_validity(writer));
    let found = broken.iter().flat_map(soft).chain(beyond).chain(sound.iter().flat_map(soft));
    found.flatten().collect()
}

/// The sentences on the joints whose contact force a study is asked about.
pub(crate) fn study_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    let is_asked = |joint: &&JointImpacts| {
        result.outputs.iter().any(|output| output.contact_force_in.as_ref() == Some(&joint.joint))
    };
    result.impacts.iter().filter(is_asked).filter_map(|joint| JointForces::study(joint).sentence(writer)).collect()
}
