//! What is wrong with a robot description. Each error stands at a place of its file.

use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::listed;

problems! {
    /// Why a robot description gives no model. `element` is an element with its name, in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum RobotProblem {
        NotXml { why: String } => Code::NotARobot,
            says("the file is not XML that can be read: {why}");
        /// Entities of a document type can make a small file very large.
        DocumentType => Code::NotARobot,
            says("the file has a document type, which is not read"),
            hint("remove <!DOCTYPE ...>, and write out its entities");
        TooLarge { what: &'static str, limit: usize } => Code::TooMany,
            says("the file has more than {limit} {what}"),
            hint("a robot description has meshes in files of their own");
        ManyAttributes { element: String, found: usize, limit: usize } => Code::TooMany,
            says("<{element}> has {found} attributes; must have at most {limit}");
        OtherRoot { found: String } => Code::NotARobot,
            says("the root element is <{found}>; must be <robot> (URDF) or <mujoco> (MJCF)"),
            hint_of(match found.as_str() {
                "sdf" => Some("convert SDF to URDF or MJCF".to_owned()),
                "mujocoinclude" => Some("import the file that includes this one, with its parts written out".to_owned()),
                _ => None,
            });
        Macros => Code::NotARobot,
            says("the file has elements of xacro, which are not expanded"),
            hint("expand them first: xacro robot.xacro > robot.urdf");
        Missing { element: String, what: String } => Code::NotARobot,
            says("{element} has no {what}");
        Twice { element: String, what: &'static str } => Code::NotARobot,
            says("{element} has a second <{what}>");
        SameName { kind: &'static str, name: String } => Code::NotARobot,
            says("a second {kind} is called '{name}'");
        NotNumbers { element: String, attribute: String, found: String, expected: String } => Code::NotARobot,
            says("{element}: {attribute} is '{found}'; must be {expected}");
        NotPositive { element: String, attribute: String, found: String } => Code::NotARobot,
            says("{element}: {attribute} is '{found}'; must be above zero");
        NoDirection { element: String, attribute: &'static str } => Code::NotARobot,
            says("{element}: {attribute} has length zero, so it has no direction");
        Choice { element: String, attribute: &'static str, found: String, choices: Vec<String> } => Code::NotARobot,
            says("{element}: {attribute} is '{found}'; must be {}", listed(choices, "or"));
        Unknown { element: String, kind: &'static str, name: String } => Code::NotARobot,
            says("{element}: there is no {kind} '{name}'");
        Together { element: String, one: &'static str, other: &'static str } => Code::NotARobot,
            says("{element}: '{one}' and '{other}' cannot be used together"),
            hint("keep one of the two");
        NotRead { element: String, why: &'static str } => Code::RobotNotAMechanism,
            says("{element} is not read: {why}");
        Floating { element: String } => Code::RobotNotAMechanism,
            says("{element} lets a body float freely; mechanisms stand on the ground"),
            hint("remove it, so that the body is fixed to the ground, or give the body joints");
        OtherKind { element: String, found: String, known: &'static str } => Code::RobotNotAMechanism,
            says("{element} is of type '{found}'; models in space know {known}");
        TwoParents { link: String, joint: String } => Code::RobotNotAMechanism,
            says("link '{link}' is the child of joint '{joint}' already; links must be a tree"),
            hint("URDF has no loops; MJCF closes them by <equality>");
        SelfParent { joint: String, link: String } => Code::RobotNotAMechanism,
            says("joint '{joint}' has link '{link}' as parent and as child");
        TwoRoots { first: String, second: String } => Code::RobotNotAMechanism,
            says("link '{second}' is the child of no joint, as is link '{first}'; exactly one link is the root"),
            hint("the root becomes the ground; connect the other one by a joint");
        NoLinks => Code::RobotNotAMechanism,
            says("the file has no link that moves");
        Circle { link: String } => Code::RobotNotAMechanism,
            says("link '{link}' hangs on itself: its parents make a circle"),
            hint("URDF has no loops; MJCF closes them by <equality>");
        SameBody { element: String, body: String } => Code::RobotNotAMechanism,
            says("{element} connects body '{body}' with itself");
        /// The model that was written is not accepted.
        NotAccepted { why: String } => Code::RobotNotAMechanism,
            says("the model that the description gives is refused: {why}");
    }
}
