//! The table of error codes: each has a title and the long explanation that `loosepin explain CODE` prints.
//!
//! A code never changes its meaning, and a retired code is never used again.

use std::fmt;
use std::str::FromStr;

/// A code with its texts.
#[derive(Debug, Clone, Copy)]
pub struct CodeEntry {
    /// The code.
    pub code: Code,
    /// Its text, for example `E0203`.
    pub text: &'static str,
    /// One line.
    pub title: &'static str,
    /// A few sentences with an example.
    pub explanation: &'static str,
}

macro_rules! codes {
    ($($name:ident $text:literal $title:literal $explanation:literal)+) => {
        /// Kinds of diagnostics.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Code {
            $(#[doc = $title] $name,)+
        }

        /// Every code with its texts, in the order of [`Code`].
        pub static CODES: &[CodeEntry] = &[
            $(CodeEntry { code: Code::$name, text: $text, title: $title, explanation: $explanation },)+
        ];
    };
}

impl Code {
    /// The entry of this code.
    pub fn entry(self) -> &'static CodeEntry {
        // The table is generated in the order of the enum.
        &CODES[self as usize]
    }

    /// Its text, for example `E0203`.
    pub fn as_str(self) -> &'static str {
        self.entry().text
    }
}

impl fmt::Display for Code {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.as_str())
    }
}

/// A text that is not an error code.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no code '{text}'; codes run from {first} to {last}")]
pub struct UnknownCode {
    /// The text.
    pub text: String,
    /// The first code.
    pub first: &'static str,
    /// The last code.
    pub last: &'static str,
}

impl FromStr for Code {
    type Err = UnknownCode;
    fn from_str(text: &str) -> Result<Code, UnknownCode> {
        let wanted = text.trim();
        CODES.iter().find(|entry| entry.text.eq_ignore_ascii_case(wanted)).map(|entry| entry.code).ok_or_else(|| {
            let first = CODES.first().map_or("", |entry| entry.text);
            UnknownCode { text: wanted.to_owned(), first, last: CODES.last().map_or("", |entry| entry.text) }
        })
    }
}

codes! {
    FileNotReadable "E0101" "a file cannot be read"
"The file named on the command line, or by `model` in a study file, cannot be opened. The path in a study file is relative to \
the folder of the study file. Check the spelling, the current folder and the permission to read the file."

    NotUtf8 "E0102" "a file is not UTF-8 text"
"Model and study files are UTF-8. The message gives the position of the first byte that is not valid. Save the file as UTF-8; \
editors call this the encoding."

    FileTooLarge "E0103" "a file is larger than any model"
"Files above one mebibyte are refused: no model or study is that large. Most often a file of results was given by mistake."

    TomlSyntax "E0104" "a file is not TOML"
"Model and study files are TOML (toml.io). Text is in double quotes, a table begins with its name in brackets, and each key \
is defined once. The file is checked further only when it is TOML."

    UnknownKey "E0201" "a key is not known here"
"Each table has a fixed set of keys; another key has no effect. `loosepin schema model` and `loosepin schema study` list the \
keys. Often the key is misspelt, or it is under the wrong table: in TOML a key belongs to the last table header above it."

    MissingKey "E0202" "a key is missing"
"A value without a sensible default must be written, for example the mass of a body. Gravity has no default either: you \
decide whether it acts."

    WrongType "E0203" "a value has the wrong type"
"TOML has text (\"0.5 mm\"), numbers (0.9), tables ({ x = 1 }) and lists ([1, 2]). Values with units are text. An angle, a \
length or a mass without a unit is E0303."

    UnknownChoice "E0204" "a value is not one of the possible values"
"Some keys take one value of a list: `kind = \"revolute\"`, `law = \"lankarani-nikravesh\"`, `along = \"x\"`. The message names \
the possible values."

    ConflictingKeys "E0205" "keys cannot be used together, or need each other"
"Some keys are alternatives: a contact stiffness comes from materials or is given. Other keys need each other: a radial \
clearance needs the bearing radius and a contact. The message names the keys."

    BadName "E0206" "a name cannot be used"
"Names of bodies, points, joints and outputs begin with a letter or `_` and consist of letters, digits, `_` and `-`, so \
that paths such as `joint.gudgeon.radial_clearance` are unambiguous. Names of parameters have no `-`, and must not be \
the name of a unit or a function, because they are used in arithmetic together with them."

    NotYetSupported "E0207" "planned, but not in this version"
"The key or value is part of the file format, but this version cannot compute with it. It is refused, because ignoring it would \
change the result without notice."

    BadCount "E0208" "a count is not possible"
"Counts (samples, turns, seeds) are whole numbers within the limits that the message names."

    ToFillIn "E0209" "a value is still to be filled in"
"A model made from a drawing has \"?\" for all numbers that a drawing does not contain: masses, inertias, speeds. Replace each \"?\" \
by the number with its unit."

    TooMany "E0210" "a file has too many entries of one kind"
"A model has at most 1000 moving bodies and 2000 joints, a question at most 2000 poses: more would take minutes before the first result. \
The message names the entries and the limit, and points at the first entry beyond the limit. docs/files/limits.md lists all limits \
with their reasons."

    ExpressionSyntax "E0301" "a value cannot be read"
"A value is a number with its unit, \"0.5 mm\" or \"1e-4 kg m^2\", or arithmetic over such values and parameters, \
\"2 * crank_length + 1 mm\". Known are + - * / ^, parentheses, pi, sqrt, sin, cos, tan, asin, acos, atan, atan2, abs, min \
and max. The column points at the first character that cannot be read. After `/`, several units need parentheses: \
`J/(kg m)`. A value with its tolerance, \"30 ± 0.05 mm\", \"30 mm +- 0.05 mm\" or \"30 h9\", belongs in a study: the model has the nominal value, \
and `[random]` in study.toml the deviations."

    UnknownUnit "E0302" "a unit is not known"
"Lengths are m, mm, µm (um), nm, cm, dm, km, in, ft, mil, thou; masses kg, g, mg, t, lb; times s, ms, µs (us), ns, min, h; \
angles rad, mrad, deg, °, rev; and rpm, Hz, kHz, N, mN, kN, MN, lbf, Pa, kPa, MPa, GPa, bar, psi, J, mJ, kJ, W, mW, kW, cP, \
%. Products and powers are written `kg m^2`, `m/s^2`, `N/m^1.5`. Capital letters matter."

    MissingUnit "E0303" "a unit is missing"
"The value needs a unit, even if it is zero. No unit is assumed: a clearance of 0.5 could be in millimetres or in metres. Write \
the value as text with its unit: \"0.5 mm\"."

    WrongDimension "E0304" "a value has the wrong dimension"
"The unit is known, but it has the wrong dimension, for example a time instead of a length. Angles have their own dimension: an \
angular velocity times a radius has the unit rad m/s until it is divided by `1 rad`. The unit of a contact stiffness depends \
on the exponent n of its law: N/m^n."

    UnknownParameter "E0305" "a name in an expression is not known"
"Expressions can use only the names under [parameter], not values elsewhere in the file. Give a quantity that is used in several \
places a name under [parameter]."

    ParameterCycle "E0306" "parameters are defined by one another"
"A parameter cannot depend on itself, neither directly nor through other parameters. The message names the parameters of the cycle."

    ExpressionTooLong "E0307" "an expression is too long or nested too deeply"
"Expressions are limited to 1000 characters and 24 levels of parentheses, signs, powers and functions. Give parts of a \
longer one names under [parameter]."

    NotFinite "E0308" "a value is not finite"
"The value is infinite or not a number, most often by a division by zero, a root or logarithm of a negative number or an exponent \
that is too large."

    MixedDimensions "E0309" "an operation does not fit its dimensions"
"Only values of one dimension can be added, subtracted or compared; sines need angles, exponents need numbers. \"50 mm + 3\" \
is refused: the unit of 3 is not known."

    FunctionNotPossible "E0310" "an expression over time uses a function that the equations of motion do not have"
"Expressions that change with time or with a joint are part of the equations of motion, which are computed for many samples at once. \
These expressions can use + - * / ^, exp, log, sqrt, abs, min, max, sin, cos and tan. All other functions are allowed in the constant \
part: give it a name under [parameter]."

    UnknownReference "E0401" "a name refers to nothing"
"Points are written `body.point`, joints, contacts, drives and outputs by their names. The message lists the existing names."

    SameBody "E0402" "a joint connects a body to itself"
"Both points of the joint are on the same body, so the joint constrains nothing."

    DriveNotPossible "E0403" "a joint cannot be driven in this way"
"A drive prescribes the coordinate of an ideal revolute joint (speed, start_angle) or of a prismatic joint (speed, \
start_position). A joint with clearance has no such coordinate. The cycle counts the turns of a revolute drive."

    DrivenTwice "E0404" "a joint is driven twice"
"Two drives prescribe the coordinate of one joint, or a control acts in a joint that a drive or another control moves. Remove \
one of them."

    UnknownPath "E0405" "a path names no quantity"
"Quantities are named by their place in the model file: `parameter.crank_length`, `body.crank.mass`, \
`body.crank.points.pin.x`, `joint.gudgeon.radial_clearance`, `contact.steel_pin.restitution`, `drive.crank.speed`. Only \
values that the model has can be set."

    NotSettable "E0406" "a value given by an expression cannot be set"
"An expression in the model file gives this value. Set one of the values in the expression, or write a number in the model \
file."

    SettingSyntax "E0407" "a setting is not written path=value"
"A setting on the command line is a path of the model, an equals sign, and a value with its unit: \
`--set joint.gudgeon.radial_clearance=0.3mm`. Quote it for the shell if the value contains spaces."

    Unused "E0408" "something in the file is not used"
"A warning: nothing refers to this parameter or contact, so its value has no effect. Often an expression names another one by \
mistake."

    SetTwice "E0409" "a value is set twice"
"Two settings on the command line give values to one quantity. Remove one of them."

    CouplingNotPossible "E0410" "a coupling does not fit its joints"
"Gears and belts couple two revolute joints; a rack couples a revolute and a prismatic joint. One body carries both joints: the frame, \
or the carrier of a planetary gear. Angles and positions are measured relative to this body."

    TableNotReadable "E0411" "a table in a CSV file cannot be read"
"A CSV table has two columns, separated by a comma. Its first row has names and units (`time [s], angle [deg]`), the other rows have \
plain numbers, and the first column increases. Lines that begin with # are comments."

    TablePeriod "E0412" "a table does not fit its period"
"A table with a period repeats after it, so its points span at most one period. If they span the whole period, the last point is the \
first point of the next period and must have the same value. If they span less, the curve continues from the last point to the first \
one of the next period. Remove the last point if the measured values differ there."

    BreaksRule "E0501" "a value is outside its range"
"Each value has a range: masses and inertias above 0, clearances at least 0, restitution in (0, 1], Poisson's ratio in \
[0, 0.5]. Values outside are refused and never changed."

    OutOfOrder "E0502" "two values are in the wrong order"
"One value must be below another: the radial clearance below the bearing radius, the lower speed of the friction law below the \
upper one."

    IntervalTurnedRound "E0601" "an interval has its ends in the wrong order"
"The first number of an interval is its lower end, the second its upper end. They are not exchanged automatically: the error may \
be in a digit, not in the order."

    IntervalWithoutWidth "E0602" "an interval has no width"
"Both ends are equal, so the value is not uncertain. Write it in the model file, or widen the interval."

    ClearanceTouchesZero "E0603" "a clearance interval reaches zero"
"A joint without clearance is another mechanism: it has one more equation and no contact. One study cannot mix both. Start the \
interval above zero, and run the ideal joint (radial_clearance = \"0 mm\") as a second study."

    BadDistribution "E0604" "a distribution is not possible"
"The parameters of a distribution have ranges: standard deviations above 0, the lower end below the upper end, the mode between \
them, shapes from 0.001 to 1e6, the mean of a lognormal distribution above 0."

    InputTwice "E0605" "a quantity is uncertain twice"
"A quantity is either random or unknown (epistemic). It cannot be both, and it cannot be given twice under different spellings."

    ImpossibleShare "E0606" "a distribution gives impossible values too often"
"More than one per cent of the samples would be impossible (a mass below zero, a clearance above the bearing radius, a restitution \
above 1), and these runs would fail. Choose a distribution within the range: truncated normal, lognormal or beta."

    BadProbability "E0607" "a probability is not possible"
"Probabilities lie between 0 and 1. Quantiles exclude both ends; a requirement excludes 0 and allows 1."

    AskNotPossible "E0608" "a question is not possible"
"The statistic, deviation or place does not fit the output. A planar path has two columns, one in space three: name one with component, for example \
component = \"x\", or in space \"magnitude\" for the distance from the ideal point. In space there are no runs: outputs are positions, paths, turns and \
orientations, and their deviations come from play, dimensions and errors of manufacture. A pose is given by the angle of the drive that the cycle counts."

    NothingUncertain "E0609" "a study has no uncertain input"
"A study needs at least one random or unknown (epistemic) input. For a single run use `loosepin simulate`."

    NothingAsked "E0610" "a study asks no question"
"A study needs at least one [[ask]] or [[require]]: a statistic to bound, or a requirement."

    SamplingNotPossible "E0611" "the numbers of runs are not compatible"
"The runs at each point are split into equal replicates; their spread gives the sampling error. `inner` must be a multiple of \
`replicates`, best `replicates` times a power of two."

    BadList "E0612" "a list of possible values is not valid"
"The list of an unknown (epistemic) input, any_of = [...], needs at least two members, each of them once. A single value belongs in \
the model file."

    LawNotPossible "E0613" "a law needs values that the model does not have"
"A contact law can be set, or be in a list, if the model has all its values. All laws except kelvin-voigt need the restitution. A \
line-contact law needs materials and the bearing_length of each of its joints. Linear laws need a stiffness in N/m instead of \
materials, so a list cannot mix them with other laws."

    BadEvidence "E0614" "intervals with masses, degrees or quantiles contradict each other"
"Masses of evidence are above 0 and sum to 1. The cuts of a fuzzy number are nested: the cut of a higher degree lies within that of \
a lower one. Its corners do not decrease. Quantiles increase with their probabilities. Quantiles and the mean lie within the \
support."

    BadPeriod "E0615" "a period is not possible"
"After one period a quantity has its first value again. The period of an angle is a whole turn, or a whole fraction of it if the \
mechanism is symmetric. An angle between two limits is an interval, not periodic."

    FarFromModel "E0616" "a study and its model do not agree on a length or an angle"
"The model has a length or an angle outside the range of the study (for a normal distribution: more than six standard deviations \
from the mean), or the study has a tolerance with another nominal value. Deviations are measured from the ideal motion of the model, so \
they would include this difference. One dimension has one nominal value: correct one of the two, omit the mean, or write only the \
deviations of a tolerance. A tolerance with another nominal value is an error; the other cases are warnings."

    RequirementRuns "E0617" "the planned runs are too few to show a required probability"
"A probability of at least p can be shown by counting only with enough runs N at each value: if no run is outside the limit, N must be at \
least ln 0.005 / ln p (1960 for 99.73 %). Fewer runs can still refute the requirement, or show it if the output is smooth in the random \
inputs. If `inner` is omitted, it is increased to the number needed."

    BadCorrelation "E0620" "a correlation is not possible"
"A correlation joins two different random inputs of the study, each pair once, by a rank correlation (Spearman) or the linear \
correlation of the values (Pearson), between -1 and 1. Two distributions of different shapes cannot have every linear \
correlation; the message gives the range. The matrix of all correlations must be \
positive definite. An unknown (epistemic) input has no distribution and no correlation."

    BadSample "E0621" "a sample gives no distribution"
"A sample is a column of a CSV file whose header has a unit, for example pin [mm]. It needs two different values, and five \
to fit a family to it; lognormal, weibull, gamma and exponential are fitted to positive values only. A warning appears if \
the fit is worse than 95 % of fits to samples of that family."

    BadTolerance "E0622" "a tolerance is not possible"
"A tolerance is written as on a drawing, \"50 ± 0.05 mm\" (or +/-) or \"50 +0.02 -0.01 mm\". The dimension has a normal distribution \
about the middle of the limits, which are 3 Cpk standard deviations away. Cpk includes an offset of the mean, so it is at most Cp."

    FitNotPossible "E0623" "a fit is not possible here"
"A fit by ISO 286 such as H7/g6 with a diameter up to 500 mm gives the radial clearance of a joint: half the difference of the \
diameters of hole and shaft. Known are the holes D E F G H JS K M N P and the shafts d e f g h js k m n p r s, grades 3 to 13. A \
joint with play needs a clearance above 0 for all sizes within the limits, which holes H have with shafts d to g."

    PlayOfCoupling "E0640" "play of a coupling is not possible"
"Backlash is a length on the pitch circles, so gears need their radii. The model does not give the radii of the surfaces of teeth, or of \
a cam and its follower, nor their sliding: their contact needs a given stiffness, and has no friction and no film. A follower that may \
lift off its cam slides in a prismatic joint."

    TeethNotPossible "E0641" "forces of teeth are not possible"
"With `pressure_angle`, the two joints of gears, or of a rack and its pinion, carry the force of the teeth. Its tangential part is the \
torque divided by the pitch radius; its radial part is tan(pressure angle) times that and separates the wheels. Therefore `pressure_angle` \
needs pitch radii that fit the distance of the centres, and joints without play and without friction, whose motion does not depend on \
their load. A rack needs a prismatic joint: a slot does not keep it parallel to its line."

    BeamNotPossible "E0642" "a flexible link is not possible here"
"A body with `beam` bends and stretches between two of its points, `from` and `to`. Revolute joints with or without play hold it there \
and, in a floating frame, at points between them. If a drive or a rigid joint holds it at `from`, its frame must be \"tangent\", because \
a frame through both ends turns relative to the section there. With formulation = \"absolute-nodal\" either end may be held, and there is no \
frame. Not supported yet: joints of other kinds, torques and torsional springs on the link; in the same model, couplings, controls and \
friction in ideal joints; in absolute nodal coordinates, points between the ends."

    TooFewDrives "E0701" "the drives do not determine the motion"
"The mechanism has more degrees of freedom than drives, counted with every clearance at zero. The message names bodies \
that can still move while all drives are locked. Add a drive or a joint. Often a joint names the wrong point, so that a loop is open."

    TooManyDrives "E0702" "there are more drives than degrees of freedom"
"The mechanism has more drives than degrees of freedom, counted with every clearance at zero. Remove a drive, or a joint that removes a \
degree of freedom."

    DrivenLoop "E0703" "every joint of a loop is driven"
"If the coordinates of all joints of a loop are prescribed, no joint is free to close the loop. Remove one of the drives."

    CannotClose "E0704" "the links cannot close a loop"
"With every clearance at zero, no position was found in which all joints are closed: the links are too short or too long \
for each other, at the start or later in the motion. The message names the joint with the largest gap, and the gap. \
Lengths, the positions of fixed points and the start angle are the usual causes. A mechanism that rocks between two dead \
centres cannot be driven through a full turn."

    SingularPosition "E0705" "a position is singular"
"In this position the drives no longer determine the motion: a body can move although every drive is locked, for example at a dead \
centre that is driven from the wrong side, or with links in one line. Forces are unbounded there, so nothing can be computed. Start a \
few degrees away, or drive another joint."

    StartNotPossible "E0706" "the initial state does not fit the mechanism"
"If the drives alone do not determine the motion, the mechanism needs its state at time zero under [initial]: one angle or position, and \
one rate, for each degree of freedom without a drive (without drives, no rates mean that it is at rest). Additional values must agree \
with the links. The joints determine everything else."

    ControlNotPossible "E0707" "a control does not fit the mechanism"
"A control needs a degree of freedom without a drive. Feed-forward by inverse dynamics along the references is available for open chains \
on the ground in which every joint is driven or controlled, so that the motion without play is known."

    FrictionNotPossible "E0708" "friction in a joint cannot be computed"
"Friction in an ideal joint is proportional to the force in the joint. With redundant constraints, rigid-body mechanics does not \
determine how they share the force."

    NoQuasiStaticAnswer "E0709" "the play is too large for a quasi-static result"
"The quasi-static result lets each joint be anywhere within its play. A slider whose half-height and clearance together \
exceed half its diagonal can turn over in its guide, so its play is unlimited. A dynamic run can still simulate it."

    DrivesOnOneFreedom "E0710" "two drives move the same degree of freedom"
"Each drive needs its own degree of freedom. Two drives on joints of one loop with a single degree of freedom contradict each other at \
almost every instant, for any lengths: the angle of the crank determines the angle of the rod. The message names the drives. The total \
numbers of drives and degrees of freedom may be equal; then another degree of freedom has no drive."

    JointsBlock "E0711" "joints block one another"
"A revolute joint removes two degrees of freedom, a prismatic joint two, a slot one, a rigid joint three. The joints in the message remove \
more than their bodies have. Examples are a triangle of links, and a rod that is pinned to the ground at both ends. Such a mechanism closes \
only if its lengths agree exactly, and then it does not move. A mechanism with a redundant joint on purpose (parallel cranks) needs lengths \
that agree exactly: use one parameter for them."

    NoDynamics "E0730" "a run needs values for dynamics that the model does not have"
"Lengths, joints and clearances are sufficient for the motion and its worst case (`loosepin motion`, the studio's band). A run also needs a \
mass, an inertia and a centre of mass for each body, a contact for each joint with play, and gravity. The message names the missing entries."

    DriveStandsStill "E0801" "the drive that counts turns has speed zero"
"The length of a run is given in turns of the drive that [cycle] names. At speed zero, a turn never ends."

    StepTooSmall "E0802" "a run needs steps that are too small"
"The steps of the integration became smaller than floating-point numbers can resolve, at the time in the message. Most often a \
contact is far too stiff for the mass behind it, or a body has almost no mass. If --tolerance is very small, a larger one may help."

    RunNotFinite "E0803" "a value of a run became infinite or undefined"
"A position or a velocity became infinite or undefined, at the time in the message. Most often the model combines values of very \
different size, such as a mass of 1e-30 kg and a stiffness of 1e12 N/m^1.5. If the message names a load, a control or a drive, its \
expression is undefined at this time: the logarithm, root or power of a negative number, or a division by zero."

    RunTooLong "E0804" "a run takes too many evaluations"
"The run was stopped after the number of evaluations in the message, because it might not end. Use fewer turns or a larger \
--tolerance. A contact with very many tiny bounces can also cause this error."

    AllRunsFailed "E0805" "every run of a study failed"
"No run of the study was finished, so there are no bounds. The message gives the reason for the first failed run; `loosepin simulate` \
with the values of the study repeats this run."

    NoThreads "E0806" "threads cannot be started"
"The operating system did not provide the requested number of threads. Use fewer, with --threads."

    Interrupted "E0807" "a study was interrupted"
"Ctrl-C or another signal ended the study before its last run. Finished runs are kept."

    PinLeavesBearing "E0808" "a pin leaves its hole"
"The penetration of a contact became so deep that the centre of the pin left the hole, or the axis of the slider left its guide. No \
contact law is valid there: the parts are far too soft, or the drive is far too fast for the masses. Check the stiffness or Young's \
modulus, the speed and the masses."

    BeyondContactLaw "E0809" "a penetration is outside the range of the contact law"
"Line-contact laws with a logarithm (johnson, esdu-78035, dubowsky-freudenstein, radzimovsky) give the penetration as a function of the \
force. Above a certain share of the clearance, no force gives the penetration, and the run ends. Use a law without this limit (liu, \
bai-zhao), or check whether the parts are far too soft or the drive is far too fast."

    ClearanceOutsideFit "E0810" "a clearance is outside the range of the contact law"
"The law of Pereira, Ramalho and Ambrósio is a formula fitted to computed contacts, for radial clearances from 0.005 to 10 mm. \
Outside this range it is not valid, so such a clearance is refused. In a study, a run with such a clearance fails for this reason."

    RoughnessOutsideFilm "E0811" "a roughness is outside the range of the film of oil"
"The roughness of a film is the thickness below which the film does not become stiffer. It must be less than half of the radial \
clearance: a larger one leaves hardly any film. For the films `reynolds` and `finite-length` it must be at least 0.002 of the clearance. \
In a study, a run outside this range fails for this reason."

    NothingIsFree "E0812" "a motion has no Lyapunov exponent"
"A Lyapunov exponent measures the growth of a small difference between two motions. A mechanism with ideal joints follows its drives \
exactly, so there is no difference."

    Jams "E0813" "friction in a joint has no solution"
"Friction in an ideal joint is proportional to the force in the joint, and this force depends on the friction. With high friction, a \
long arm or a short guide, no friction force satisfies both (jamming, Painlevé's paradox). The equations of rigid bodies then have no \
solution."

    SliderBeyondGuide "E0814" "a slider leaves its guide"
"A slider may overhang the faces of a guide with `start` and `end`: the edge of the guide then supports the side of the slider. When the \
rear of the slider passes the end, or its front passes the start, nothing supports it, and the run ends. Change the ends of the guide, or \
omit them for faces without ends."

    TooManyFailed "E0815" "too many runs of a study failed"
"Bounds allow for every outcome of a failed run, so many failed runs make them wide. Most often the model or the uncertain inputs are \
wrong. The study ends if more runs fail than most_failed under [sampling] allows (default: a tenth). The finished runs are kept in \
runs.parquet and in the store: --resume --most-failed 0.3 continues with them. The command in the message repeats one failed run."

    RunsNotMade "E0816" "runs were not made elsewhere"
"Other processes can make the runs of a study, for example with Study.run(client=...) of the Python package. They did not return the \
runs; the message repeats their error. If a folder was given, its store has the runs that were returned earlier, and the same call with \
resume=True continues from there."

    TooMuchMemory "E0817" "a study needs more memory than there is"
"The results of all runs stay in memory until the bounds are computed. The message gives the memory that the study needs and the memory \
that the operating system reports as available, within the limits of the container and of the process. Use fewer runs (outer, inner) or \
fewer poses, or close other programs."

    EnergyNotBalanced "E0820" "the energy balance of a run does not close"
"Each run checks its energy balance: kinetic, potential and stored energy, losses, and the work of drives and loads must add up. A run \
whose balance has an error of more than 1e-4 of the energy exchanged does not solve the equations, and counts as failed. Most often the \
tolerance is too large: use a smaller --tolerance, or a smaller tolerance under [sampling] of a study. `loosepin simulate` still writes all \
files of such a run; its page and its summary.json state that it failed."

    LawGainsEnergy "E0821" "a law gained energy"
"Friction, damping and contact laws turn energy into heat. Over this run, the law released more energy than it absorbed, by more than \
1e-4 of the energy exchanged, so the motion is not physical. Two friction models can do this. The first is `lugre`: its bristles are \
springs with a stiffness proportional to the normal force, so bristles bent under a small force release more energy under a large one. \
This happens if their sliding distance is longer than a contact lasts: with a coefficient above about 10, or a small bristle_stiffness; \
bristle_damping reduces it. The second is `sliding_velocity = \"literal\"`. Use a smaller coefficient, a larger bristle_stiffness or \
bristle_damping, or a law without memory. `loosepin simulate` writes all files of such a run."

    ToleranceTooLarge "E0822" "the tolerance is too coarse for the clearances"
"The tolerance is the permitted error of positions in a run. Above a hundredth of the smallest clearance, a run does not resolve the motion \
of a pin in its hole well: this is a warning. Above the smallest clearance it does not resolve this motion at all: this is an error. In a \
study, the smallest clearance is taken at the lower end of an interval, and at the 0.1 % quantile of a random input. Mechanisms without \
play have no such limit."

    ImplausibleNumber "E0823" "a number is implausible"
"A warning: the number is permitted, but far from the values of real machines. Most often a unit is wrong by a factor of a thousand (MPa for \
GPa, g for kg, mm for m), or a speed in rpm is written in rad/s. The check covers Young's modulus, Poisson's ratio, density, viscosity, \
friction, speeds of drives, smallest impact speeds, gravity, masses, inertia and centre of mass compared with the points of the body, \
clearances, pitch circles of gears that do not touch, a restitution that the law does not deliver, and parameters called length or radius below \
zero, in files and as values of --set. Outputs whose body stands still over the whole cycle are named as well: most often the loops are closed in \
another way than meant. In studies it covers standard deviations above 3 % of a length, and samples of the opposite sign. The value is not changed: ignore the warning \
if the number is intended."

    OutOfMemory "E0824" "out of memory"
"The system refused memory while a command ran, and the command ended with exit status 4. Before a study starts, the memory it needs is \
compared with the available memory (E0817), but other programs may use this memory later. Finished runs are kept. Raise the memory limit \
(ulimit -v, ulimit -d, or the limit of the container), or use fewer --threads or samples; --resume continues with the saved runs of a study."

    LengthOutsideFilm "E0825" "a bearing is too long for its film of oil"
"The table of the film `reynolds` ends at bearings four times as long as their diameter. In a longer bearing, the film would surround nearly \
the whole pin, and its force would depend on the position of the oil supply, which is not modelled. The films `finite-length` and \
`pinkus-sternlicht` have no such limit. In a study, a run with a longer bearing fails for this reason."

    FolderHoldsOther "E0901" "a folder holds something else"
"The folder contains results of other inputs, or other files. They are not overwritten. Give another folder, or omit --out: then \
a new folder is created. --force replaces results of loosepin; other files stay, unless they have the same name."

    NoResults "E0902" "a folder holds no results"
"`loosepin report` writes pages again from stored results. A folder of results has a file loosepin.json that describes its \
contents. This folder has none, or the command that wrote it did not finish."

    FolderNotUsable "E0903" "a folder or file cannot be written or read"
"The file system reports an error; the message gives the reason: permissions, a full disk, or a file instead of a folder."

    FileExists "E0904" "a file already exists"
"`loosepin new` writes model.toml and study.toml and does not overwrite your files. Give another folder, or move the files."

    WrongKindOfFile "E0905" "a file is of another kind than the command takes"
"Some commands take a model (a mechanism with its nominal values), others a study (its uncertain inputs, and the questions). \
A file with a key `model` at its top level is a study. A model with geometry = \"space\" is one of a mechanism in space, which `check` \
and `motion` take."

    ResultNotStorable "E0906" "a result cannot be stored"
"JSON, CSV or Parquet cannot represent a value of the result, or its columns do not match. This is a fault of loosepin: please \
report it with the input files."

    FolderInUse "E0907" "a folder of results is in use"
"While a command writes into a folder of results, it holds the folder's lock (loosepin.lock; a study also locks its runs.sqlite), so that \
two processes never write into one result. Wait until the other one ends, or give another folder with --out. The lock ends with \
its process, even if the process is killed: a remaining file loosepin.lock need not be removed."

    StoreOfOther "E0908" "a store contains runs of other inputs or of another version"
"The finished runs in a runs.sqlite belong to one study, one model and one version of the program. Other inputs or another version \
give other numbers, and a mixture would be wrong for both."

    StoreDamaged "E0909" "a store of finished runs is damaged"
"A row of runs.sqlite does not match its checksum, or the file is not a valid SQLite file: it was changed on the disk or during copying. \
The file is not used. Restore it from a copy, or start again with --force."

    StudyStarted "E0910" "an earlier command left finished runs of this study"
"The folder contains finished runs of this study, from an earlier command that was stopped. Choose whether to use them: --resume \
continues with them, --force deletes them."

    ShardsDoNotFit "E0911" "folders are not the shards of one study"
"`loosepin merge` joins the folders of all shards of one study, RESULTS.shard-1-of-7 to RESULTS.shard-7-of-7. It needs each shard once, \
with the same study, the same number of shards and the same version. The message names the folder that does not match, or the missing \
shards."

    RoundOpen "E0912" "a round of a study is not complete"
"A study makes its runs in rounds, and each round depends on the results of the earlier ones. Every shard runs its part of a round; \
`loosepin merge` joins the parts and starts the next round, or writes the results after the last one."

    ResultNotWhole "E0913" "a finished result was changed"
"loosepin.json lists the files of a result with their BLAKE3 hashes, and every command that reads a result checks them. A file \
is missing or was changed. Restore the folder from a copy, or make the result again with --force."

    NoSurrogateAnswer "E0920" "saved surrogates give no answer"
"A surrogates.json needs values for all its inputs, within the training ranges; there is no extrapolation. A file of another version, \
or an incomplete file, is refused."

    SurrogateNotExported "E0921" "a surrogate cannot be written for other programs"
"`loosepin export` writes neural networks as ONNX. It does not export polynomials and Gaussian processes, which have no layers; \
surrogates.json contains all their coefficients. An output named by --output must have a surrogate in the results."

    MeasuredTable "E1001" "a table of measured values cannot be used"
"A table of measured curves is comma-separated text. Its first line names each column with its unit, `angle [deg], slider [mm]`. \
The first column is an increasing time or drive angle, the others are outputs of the model. An empty cell is a value that was not \
measured."

    MeasuredOutside "E1002" "a measured value is outside the recorded turns"
"Measured values are compared with the run at the same time or angle. Times count from the start of the run; angles are moved by \
whole turns so that the first one is in the first recorded turn. Record more turns, or shorten the table."

    NotADrawing "E1101" "a drawing cannot be read"
"`loosepin import` reads DXF files, as text or binary, of any version since R10. The reason begins with the line number of the file, or \
with the byte position in a binary file."

    DrawingNotAMechanism "E1102" "a drawing is not a sketch of a mechanism"
"Lines and polylines are links, circles are joints. Every circle must touch a link, every link must touch a circle, and fixed parts are \
on a layer called ground. The message gives the position in the coordinates of the drawing."

    NotARobot "E1103" "a robot description cannot be read"
"`loosepin import` reads URDF (root element `robot`) and MJCF (root element `mujoco`). The file must be XML without a document type, \
every number must be finite, and every name that is referred to must be there. Files of xacro must be expanded first, with `xacro \
robot.xacro > robot.urdf`."

    RobotNotAMechanism "E1104" "a robot description is not a mechanism on the ground"
"Its links must be a tree with one root, which becomes the ground. Bodies that float freely, joints of other kinds than fixed, revolute, \
continuous, prismatic and planar (URDF) or hinge, slide and ball (MJCF), and elements that make further bodies are refused by name."

    NotExportable "E1105" "a model cannot be exported as a robot description"
"URDF knows trees of revolute, prismatic, planar and fixed joints; cylindrical and universal joints become two. MJCF also knows balls, \
and loops that a ball, a pin or a rigid joint closes. Screws are in neither. The message names the joint; `--to mjcf` may know it."
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_explained_and_unique() {
        for (index, entry) in CODES.iter().enumerate() {
            assert_eq!(entry.code as usize, index);
            assert!(entry.text.len() == 5 && entry.text.starts_with('E'), "{}", entry.text);
            assert!(entry.explanation.len() > 60 && entry.explanation.ends_with('.'), "{}", entry.text);
            assert!(!entry.explanation.contains('!') && !entry.title.contains('!'), "{}", entry.text);
            assert!(CODES[..index].iter().all(|other| other.text < entry.text), "{} out of order", entry.text);
            assert_eq!(entry.text.parse(), Ok(entry.code));
        }
    }

    #[test]
    fn an_unknown_code_is_refused() {
        let error = "E9999".parse::<Code>().expect_err("no such code");
        assert_eq!(error.to_string(), "there is no code 'E9999'; codes run from E0101 to E1105");
    }
}
