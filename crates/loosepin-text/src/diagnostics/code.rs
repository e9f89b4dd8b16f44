//! The table of codes: each with a title and the long explanation that `loosepin explain CODE` prints.
//!
//! A code never changes its meaning; one that is no longer used is not given out again.

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
        /// The kinds of complaint.
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

/// A text that is no code.
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
"The file named on the command line, or by `model` in a study file, cannot be opened. The path in a study file is taken \
from the folder of the study file. Check the spelling, the folder you are in, and that you may read it."

    NotUtf8 "E0102" "a file is not UTF-8 text"
"Model and study files are UTF-8. The place given is the first byte that is not. Save the file as UTF-8; editors call \
this the encoding."

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

    UnknownChoice "E0204" "a value is not one of those possible"
"Some keys take one value of a list: `kind = \"revolute\"`, `law = \"lankarani-nikravesh\"`, `along = \"x\"`. The message names \
the possible values."

    ConflictingKeys "E0205" "keys cannot be used together, or need each other"
"Some keys are alternatives: a contact stiffness comes from materials or is given. Other keys need each other: a radial \
clearance needs the bearing radius and a contact. The message names the keys."

    BadName "E0206" "a name cannot be used"
"Names of bodies, points, joints and outputs begin with a letter or `_` and consist of letters, digits, `_` and `-`, so \
that paths such as `joint.gudgeon.radial_clearance` are unambiguous. Names of parameters have no `-`, and must not be \
the name of a unit or a function, since they stand in arithmetic beside them."

    NotYetSupported "E0207" "planned, and not yet in this version"
"The key or value is part of the file format, but this version cannot compute with it. To ignore it would change the result \
without notice, so it is refused."

    BadCount "E0208" "a count is not possible"
"Counts (samples, turns, seeds) are whole numbers within the limits that the message names."

    ToFillIn "E0209" "a value is still to be filled in"
"A model made from a drawing has \"?\" for all numbers that a drawing does not hold: masses, inertias, speeds. Replace it by \
the number with its unit."

    TooMany "E0210" "a file has more of something than is computed"
"A model has at most 1000 moving bodies and 2000 joints, a question at most 2000 poses: more would take minutes before the first answer. \
The message names what is too many and the limit; the place is the first entry beyond it. docs/files/limits.md lists all limits \
with their reasons."

    ExpressionSyntax "E0301" "a value cannot be read"
"A value is a number with its unit, \"0.5 mm\" or \"1e-4 kg m^2\", or arithmetic over such values and parameters, \
\"2 * crank_length + 1 mm\". Known are + - * / ^, parentheses, pi, sqrt, sin, cos, tan, asin, acos, atan, atan2, abs, min \
and max. The column points at the first place that cannot be read. Behind `/` several units need parentheses: \
`J/(kg m)`."

    UnknownUnit "E0302" "a unit is not known"
"Lengths are m, mm, µm (um), nm, cm, dm, km, in, ft, mil, thou; masses kg, g, mg, t, lb; times s, ms, µs (us), ns, min, h; \
angles rad, mrad, deg, °, rev; and rpm, Hz, kHz, N, mN, kN, MN, lbf, Pa, kPa, MPa, GPa, bar, psi, J, mJ, kJ, W, mW, kW, cP, \
%. Products and powers are written `kg m^2`, `m/s^2`, `N/m^1.5`. Capital letters matter."

    MissingUnit "E0303" "a unit is missing"
"The value needs a unit, also if it is zero. No unit is assumed: a clearance of 0.5 could be in millimetres or in metres. Write \
the value as text with its unit: \"0.5 mm\"."

    WrongDimension "E0304" "a value has the wrong dimension"
"The unit is known, but it has the wrong dimension, for example a time instead of a length. Angles have their own dimension: an \
angular velocity times a radius has the unit rad m/s until it is divided by `1 rad`. The unit of a contact stiffness depends \
on the exponent n of its law: N/m^n."

    UnknownParameter "E0305" "a name in an expression is not known"
"Expressions can use only the names under [parameter], not values elsewhere in the file. Give a quantity that is used in several \
places a name under [parameter]."

    ParameterCycle "E0306" "parameters are defined by one another"
"A parameter cannot depend on itself, neither directly nor through others. The message names the circle."

    ExpressionTooLong "E0307" "an expression is too long or nested too deeply"
"Expressions are limited to 1000 characters and 24 levels of parentheses, signs, powers and functions. Give parts of a \
longer one names under [parameter]."

    NotFinite "E0308" "a value is not finite"
"The value is infinite or not a number, most often by a division by zero, a root or logarithm of a negative number or an exponent \
that is too large."

    MixedDimensions "E0309" "an operation does not fit its dimensions"
"Only values of one dimension can be added, subtracted or compared; sines need angles, exponents need numbers. \"50 mm + 3\" \
is refused: the unit of 3 is not known."

    FunctionNotPossible "E0310" "an expression over time does what the equations of motion cannot"
"Expressions that change with time or with a joint are part of the equations of motion, which run on many samples at once. \
They know + - * / ^, exp, log, sqrt, abs, min, max, sin, cos and tan. Everything else is allowed in the part that does not \
change: give it a name under [parameter]."

    UnknownReference "E0401" "a name refers to nothing"
"Points are written `body.point`, joints, contacts, drives and outputs by their names. The message lists what there is."

    SameBody "E0402" "a joint connects a body to itself"
"Both points of the joint lie on one body, so that it constrains nothing."

    DriveNotPossible "E0403" "a joint cannot be driven so"
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
"Gears and belts couple two revolute joints, a rack a revolute and a prismatic one, and both wheels hang on one body: the frame, \
or the carrier of a planetary gear. Angles and positions are counted from that body."

    TableNotReadable "E0411" "a table in a CSV file cannot be read"
"A CSV table has two columns, separated by a comma, with names and units in its first row (`time [s], angle [deg]`) and plain numbers \
below, the first column increasing. Lines that begin with # are comments."

    TablePeriod "E0412" "a table does not fit its period"
"A table with a period begins again after it: its points span at most one period. Where they span all of it, the last point is the first \
again and has the same value; where they span less, the curve goes from the last point on to the first. Leave the last point out if \
measured values differ there."

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
"A quantity is either random or epistemic. It cannot be both, and it cannot be given twice under different spellings."

    ImpossibleShare "E0606" "a distribution puts too much on impossible values"
"More than one per cent of the samples would be impossible (a mass below zero, a clearance above the bearing radius, a restitution \
above 1), and these runs would fail. Choose a distribution within the range: truncated normal, lognormal or beta."

    BadProbability "E0607" "a probability is not possible"
"Probabilities lie between 0 and 1. Quantiles exclude both ends; a requirement excludes 0 and allows 1."

    AskNotPossible "E0608" "a question is not possible"
"The statistic, deviation or place does not fit the output. A path has two columns: ask for its coordinates as outputs. A pose is \
given by the angle of the drive that the cycle counts."

    NothingUncertain "E0609" "a study has no uncertain input"
"A study needs at least one random or epistemic input. For a single run use `loosepin simulate`."

    NothingAsked "E0610" "a study asks no question"
"A study needs at least one [[ask]] or [[require]]: a statistic or a requirement to compute bounds of."

    SamplingNotPossible "E0611" "the numbers of runs do not fit together"
"The runs at each point are split into equal replicates; their spread gives the sampling error. `inner` must be a multiple of \
`replicates`, best `replicates` times a power of two."

    BadList "E0612" "a list of possible values is not valid"
"The list of an epistemic input, any_of = [...], needs at least two members, each of them once. A single value belongs in the \
model file."

    LawNotPossible "E0613" "a law needs values that the model does not have"
"A contact law can be set, or be in a list, if the model has all its values. All laws except kelvin-voigt need the restitution. A \
line-contact law needs materials and the bearing_length of each of its joints. Linear laws need a stiffness in N/m instead of \
materials, so a list cannot mix them with other laws."

    BadEvidence "E0614" "intervals with masses, degrees or quantiles do not fit together"
"Masses of evidence are above 0 and sum to 1. The cuts of a fuzzy number are nested: the cut of a higher degree lies within that of \
a lower one. Its corners do not decrease. Quantiles increase with their probabilities. Quantiles and the mean lie within the \
support."

    BadPeriod "E0615" "a period is not possible"
"After one period a quantity has its first value again. The period of an angle is a whole turn, or a whole fraction of it if the \
mechanism is symmetric. An angle between two limits is an interval, not periodic."

    FarFromModel "E0616" "a study and its model do not agree on a length or an angle"
"The model has a length or an angle outside the range of the study (for a normal distribution: more than six standard deviations \
from the mean), or a tolerance with another nominal value. Deviations are from the ideal motion of the model, so they would include this \
difference. One dimension has one nominal value: correct one of the two, leave the mean out, or write the deviations of a tolerance alone. \
Only a tolerance with another nominal value is refused; the rest is warned of."

    RequirementRuns "E0617" "the planned runs cannot show a required share"
"A share that must be at least p is shown by counting only where N runs at each value leave less than 1 - p open: with none of them outside, N is \
at least ln 0.005 / ln p (1960 for 99.73 %). Fewer runs can still refute the requirement, or show it where the output is smooth in the random \
inputs. `inner` is raised to what is needed where it is left out."

    BadCorrelation "E0620" "a correlation is not possible"
"A correlation joins two different random inputs of the study, each pair once, by a rank correlation (Spearman) or the linear \
correlation of the values (Pearson), between -1 and 1. Two distributions of different shapes cannot have every linear \
correlation; the message gives the range. The matrix of all correlations must be \
positive definite. An epistemic input has no distribution and no correlation."

    BadSample "E0621" "a sample gives no distribution"
"A sample is a column of a CSV file whose header has a unit, for example pin [mm]. It needs two different values, and five \
to fit a family to it; lognormal, weibull, gamma and exponential are fitted to positive values only. A warning appears if \
the fit is worse than 95 % of fits to samples of that family."

    BadTolerance "E0622" "a tolerance is not possible"
"A tolerance is written as on a drawing, \"50 ± 0.05 mm\" (or +/-) or \"50 +0.02 -0.01 mm\". The part is normal about the middle \
of the limits, which are 3 Cpk standard deviations away. Cpk includes an offset of the mean, so it is at most Cp."

    FitNotPossible "E0623" "a fit is not possible here"
"A fit by ISO 286 such as H7/g6 with a diameter up to 500 mm gives the radial clearance of a joint: half the difference of the \
diameters of hole and shaft. Known are the holes D E F G H JS K M N P and the shafts d e f g h js k m n p r s, grades 3 to 13. A \
joint with play needs a clearance above 0 for all sizes within the limits, which holes H have with shafts d to g."

    PlayOfCoupling "E0640" "play of a coupling is not possible"
"Backlash is a length on the pitch circles, so gears need their radii. Teeth, and a cam and its follower, touch where nothing tells \
the radii of their surfaces and how they slide: their contact has a stiffness that is given, no friction and no film. A follower \
that may lift off its cam slides in a prismatic joint."

    TeethNotPossible "E0641" "forces of teeth are not possible"
"With `pressure_angle` the two joints of gears, or of a rack and its pinion, carry the force of the teeth: the torque over the pitch \
radius along the pitch circles, and tan(pressure angle) of that apart. So it needs pitch radii, which must fit the distance of the \
centres, and joints whose motion does not depend on what they carry: without play and without friction. A rack needs a prismatic \
joint: a slot does not keep it parallel to its line."

    BeamNotPossible "E0642" "a flexible link is not possible here"
"A body with `beam` bends and stretches between two of its points, `from` and `to`. Revolute joints with or without play hold it there \
and, in a floating frame, at points between. Where a drive or a rigid joint holds it at `from`, its frame must be \"tangent\": the frame through both ends turns \
against the section there. With formulation = \"absolute-nodal\" either end may be held, without a frame. Not computed yet: joints of other \
kinds, torques and torsional springs on the link, couplings, controls and friction in ideal joints beside it; in absolute nodal \
coordinates points between the ends."

    TooFewDrives "E0701" "the drives do not determine the motion"
"The mechanism has more degrees of freedom than drives, counted with every clearance at zero. The message names bodies \
that can still move while all drives stand still. Add a drive or a joint. Often a joint names the wrong point, and a loop is open."

    TooManyDrives "E0702" "drives work against each other"
"There are more drives than degrees of freedom, counted with every clearance at zero. Remove a drive, or a joint that removes a \
degree of freedom."

    DrivenLoop "E0703" "every joint of a loop is driven"
"Prescribing the coordinates of all joints of a loop leaves nothing that could close it. Remove one of the drives."

    CannotClose "E0704" "the links cannot close a loop"
"With every clearance at zero no position was found in which all joints hold together: the links are too short or too long \
for each other, at the start or somewhere on the way. The message names the joint that stays open furthest, and how far. \
Lengths, the positions of fixed points and the start angle are the usual causes. A mechanism that rocks between two dead \
centres cannot be driven through a full turn."

    SingularPosition "E0705" "a position is singular"
"In this position the drives no longer determine the motion: a body can move although every drive stands still, as at a dead \
centre that is driven from the wrong side, or where links lie in one line. Forces are unbounded there and nothing can be \
computed. Start a few degrees away, or drive another joint."

    StartNotPossible "E0706" "the initial state does not fit the mechanism"
"A mechanism that its drives do not move alone needs its state at time zero under [initial]: as many angles or positions as \
it has freedoms that no drive moves, and as many rates (none at all for a mechanism without drives means at rest). What is \
given beyond that must agree with the links. Everything else follows from the joints."

    ControlNotPossible "E0707" "a control does not fit the mechanism"
"A control needs a freedom that no drive moves. Inverse dynamics, fed forward along the references, is worked out for open chains \
on the ground in which every joint is driven or controlled, so that the motion without play is known."

    FrictionNotPossible "E0708" "friction in a joint cannot be computed"
"Friction in an ideal joint is as large as what the joint carries. Where constraints repeat each other, rigid bodies do not say \
how they share the force."

    NoQuasiStaticAnswer "E0709" "play for which there is no quasi-static answer"
"The quasi-static answer takes each joint as anywhere within its play. A slider whose half-height and clearance together \
exceed half its diagonal can turn over in its guide, and then its play has no end. A dynamic run still tells what happens."

    DrivesOnOneFreedom "E0710" "two drives move the same freedom"
"Each drive moves a freedom of its own. Two drives on joints of one loop with a single freedom contradict each other at all instants but \
some, whatever the lengths are: the angle of the crank tells that of the rod. The message names the drives. The mechanism may have as many \
drives as freedoms and one that no drive moves."

    JointsBlock "E0711" "joints hold one another"
"A revolute joint takes two freedoms of a body, a prismatic joint two, a slot one, a rigid joint three. The joints that the message names take \
more than their bodies have: a triangle of links, a rod that is pinned to the ground at both ends. Such a mechanism closes only where the \
lengths agree by chance or to all digits, and then does not move. Mechanisms that repeat a joint on purpose (parallel cranks) need lengths \
that agree exactly: give them one parameter."

    NoDynamics "E0730" "a model without dynamics is run"
"Lengths, joints and clearances are enough for the motion and its worst case (`loosepin motion`, the studio's band). A run needs a mass, an \
inertia and a centre of mass for each body, a contact for each joint with play, and gravity. The entries that are missing are named."

    DriveStandsStill "E0801" "the drive that counts turns stands still"
"The length of a run is given in turns of the drive that [cycle] names. At speed zero a turn never ends."

    StepTooSmall "E0802" "a run needs steps that are too small"
"The steps of the integration fell below what numbers can resolve, at the time that the message names. Most often a \
contact is far too stiff for the mass behind it, or a body has almost no mass. A looser --tolerance may help where it is \
very tight."

    RunNotFinite "E0803" "a run left the finite numbers"
"A position or a velocity became infinite or undefined, at the time that the message names. Most often values of very \
different size meet, such as a mass of 1e-30 kg and a stiffness of 1e12 N/m^1.5. Where the message names a load, a control or a \
drive, its expression has no value then: the logarithm or the root of a negative number, a power of one, a division by zero."

    RunTooLong "E0804" "a run takes too many evaluations"
"The run was given up after the number of evaluations that the message names, so that it ends at all. Ask for fewer turns \
or a looser --tolerance; a contact with very many tiny bounces also ends here."

    AllRunsFailed "E0805" "every run of a study failed"
"No run of the study was finished, so there are no bounds. The message gives the reason of the first run; `loosepin simulate` with \
the values of the study repeats it."

    NoThreads "E0806" "threads cannot be started"
"The system did not give the program the threads that it asked for. Ask for fewer with --threads."

    Interrupted "E0807" "a study was interrupted"
"Ctrl-C, or a signal, ended the study before its last run. What was finished is kept."

    PinLeavesBearing "E0808" "a pin leaves its hole"
"The penetration of a contact grew so deep that the centre of the pin left the hole, or the axis of the slider its guide. No \
contact law holds there: the parts are far too soft, or the drive far too fast, for the masses that they carry. Look at the \
stiffness or Young's modulus, the speed and the masses."

    BeyondContactLaw "E0809" "a contact is deeper than its law goes"
"Line-contact laws with a logarithm (johnson, esdu-78035, dubowsky-freudenstein, radzimovsky) give the penetration for a force; \
beyond a share of the clearance no force belongs to a penetration, and the run ends. Take a law without that limit (liu, bai-zhao), \
or look whether the parts are far too soft or the drive far too fast."

    ClearanceOutsideFit "E0810" "a clearance to which the contact law was not fitted"
"The law of Pereira, Ramalho and Ambrósio is a formula fitted to computed contacts, for radial clearances from 0.005 to 10 mm. \
Outside it means nothing, so such a clearance is refused. In a study, a run with such a clearance fails by this reason."

    RoughnessOutsideFilm "E0811" "a roughness that does not go with a film of oil"
"The roughness of a film is the thickness below which it no longer stiffens. It must be less than half of the radial clearance, or \
there is hardly a film at all; and the films `reynolds` and `finite-length` are computed down to 0.002 of the clearance. In a study, a \
run outside of that fails by this reason."

    NothingIsFree "E0812" "a motion has no Lyapunov exponent"
"A Lyapunov exponent measures the growth of a small difference of the motion. A mechanism with ideal joints follows its drives \
exactly, so there can be no difference."

    Jams "E0813" "friction in a joint has no solution"
"Friction in an ideal joint is as large as what the joint carries, and what it carries depends on the friction. With much \
friction, a long arm or a short guide no friction force fits any more (jamming, Painlevé's paradox): a rigid body has no motion \
then."

    SliderBeyondGuide "E0814" "a slider leaves its guide"
"A slider may overhang the faces of a guide with `start` and `end`: the edge of the guide then holds the side of the slider. Once the \
rear of the slider is beyond the end, or its front before the start, nothing holds it any more, and the run ends. Give the guide other \
ends, or leave them out: then the faces have none."

    TooManyFailed "E0815" "too many runs of a study failed"
"Bounds allow for every outcome of a failed run, so many failed runs make them wide. Most often the model or the uncertain inputs are \
wrong. The study ends if more runs fail than most_failed under [sampling] allows (default: a tenth). The finished runs are kept in \
runs.parquet and in the store: --resume --most-failed 0.3 continues with them. The command in the message repeats one failed run."

    RunsNotMade "E0816" "runs were not made elsewhere"
"A study may leave its runs to other processes, as Study.run(client=...) of the Python package does. They did not come back; the \
complaint has the words of whoever was to make them. What came back before is in the store of the folder, where one was given, and the \
same call with resume=True goes on from there."

    TooMuchMemory "E0817" "a study needs more memory than there is"
"The numbers of all runs are held in memory until the bounds are computed. The message says how much the study needs and how much the \
machine has at hand: what the operating system calls available, within the limits of the container and of the process. Fewer runs \
(outer, inner) or fewer poses need less; other programs may be closed."

    EnergyNotBalanced "E0820" "the energy balance of a run does not close"
"Each run checks itself: kinetic, potential and stored energy, losses, and the work of drives and loads must add up. A run whose balance is \
off by more than 1e-4 of the energy exchanged is not what the equations say, and counts as failed. Most often the tolerance is too \
coarse: take a smaller --tolerance, or a smaller tolerance under [sampling] of a study. `loosepin simulate` writes all files of such a \
run, so that you can look at it; its page and its summary.json say that it failed."

    LawGainsEnergy "E0821" "a law gained energy"
"Friction, damping and contact laws turn energy into heat. Over this run the law gave more energy than it took, by more than 1e-4 of \
the energy exchanged, so the motion is that of a machine with a hidden motor. Two frictions can do that: `lugre`, whose bristles are \
springs as stiff as the normal force is large, so that bristles bent under a small force give back more under a large one (they do \
where they slip over a longer way than a contact lasts: a coefficient over about 10, or a small bristle_stiffness; bristle_damping \
works against it), and `sliding_velocity = \"literal\"`. Take a smaller coefficient, a larger bristle_stiffness or bristle_damping, or \
a law without memory. `loosepin simulate` writes all files of such a run."

    ToleranceTooLarge "E0822" "the tolerance is too coarse for the clearances"
"The tolerance is the error of positions that is asked for in a run. Above a hundredth of the smallest clearance the motion of a pin \
in its hole is no longer resolved well, which is warned of; above the smallest clearance nothing of it is left, which is refused. In a \
study the smallest clearance is that of the smallest values of the inputs: the lower end of an interval, and of a random input what one \
value in a thousand lies below. Mechanisms without play have no such limit."

    HardlyPossible "E0823" "a number is hardly possible"
"A warning: the number keeps its rule, and is far from what machines have. Most often a unit is a thousand times off (MPa for GPa, g for kg, \
mm for m), or a speed in rpm is written in rad/s. Looked at are Young's modulus, Poisson's ratio, density, viscosity, friction, speeds of \
drives, gravity, masses against one another, inertia and centre of mass against the points of the body, clearances against the radius, a \
restitution that the law does not deliver, parameters called length or radius below zero, and in studies standard deviations of a tenth \
of a length and samples of the other sign. Nothing is changed: ignore the warning where the number is meant."

    OutOfMemory "E0824" "memory was refused"
"The system refused memory while a command ran, and nothing could go on without it: the exit status is 4. Before a study starts its need is \
compared with what is there (E0817); other programs may take that meanwhile. What was finished is kept. Raise the limit of memory (ulimit \
-v, ulimit -d, or that of the container), or ask for fewer --threads or samples; --resume goes on with the saved runs of a study."

    LengthOutsideFilm "E0825" "a bearing that is too long for its film of oil"
"The table of the film `reynolds` ends at bearings four times as long as their diameter. In longer ones the film would be whole nearly \
all around the pin, and its force would depend on where the oil comes in, which is not computed. The films `finite-length` and \
`pinkus-sternlicht` have no such limit. In a study, a run outside of that fails by this reason."

    FolderHoldsOther "E0901" "a folder holds something else"
"The folder holds results of other inputs, or other files. They are not overwritten. Give another folder, or leave out --out: then \
a new folder is created. --force replaces results of loosepin; other files stay, unless they have the same name."

    NoResults "E0902" "a folder holds no results"
"`loosepin report` writes pages again from stored results. A folder of results has a file loosepin.json that says what it \
holds; this one has none, or the run that filled it did not finish."

    FolderNotUsable "E0903" "a folder or file cannot be written or read"
"The file system reports an error; the message gives the reason: rights, a full disk, or a file instead of a folder."

    FileExists "E0904" "a file is there already"
"`loosepin new` writes model.toml and study.toml and does not overwrite files of yours. Give another folder, or move them."

    WrongKindOfFile "E0905" "a study was given instead of a model, or a model instead of a study"
"Some commands take a model (a mechanism with its nominal values), some a study (what is uncertain in it, and what is asked). \
A file with a key `model` at its top is a study."

    ResultNotStorable "E0906" "a result cannot be laid out as a file"
"A value of the result has no form in JSON, CSV or Parquet, or its columns do not fit together. This is a slip of ours: please \
report it with the files that lead to it."

    FolderInUse "E0907" "a folder of results is in use"
"While a command writes into a folder of results, it holds the folder's lock (loosepin.lock; a study also locks its runs.sqlite), so that \
two processes never write into one result. Wait for the other one to end, or give a folder of its own by --out. The lock ends with \
its process, even when that is killed: a file loosepin.lock that is left behind need not be removed."

    StoreOfOther "E0908" "a store holds the runs of something else"
"The finished runs in a runs.sqlite belong to one study, one model and one version of the program: other inputs or another version \
give other numbers, and mixing them would give a result of neither."

    StoreDamaged "E0909" "a store of finished runs is damaged"
"A row of runs.sqlite does not have its checksum, or the file is not built as SQLite builds it: the disk or a copy has changed it. \
Nothing of it is used. Restore the file from a copy, or begin anew with --force."

    StudyStarted "E0910" "a study that was begun before has finished runs"
"The folder holds runs of this very study, which an earlier command has finished before it was stopped. Whether to go on with them is \
for you to say: --resume takes them over, --force drops them."

    ShardsDoNotFit "E0911" "folders are not the shards of one study"
"`loosepin merge` joins the folders that shards of one study have written, RESULTS.shard-1-of-7 to RESULTS.shard-7-of-7: all of them, \
each once, of the same study, the same number of shards and the same version. The message names the folder that does not fit, or the \
shards that are missing."

    RoundOpen "E0912" "a round of a study waits for its shards"
"A study asks for its runs in rounds, and each round depends on the results of those before. Every shard makes its part of a round; \
`loosepin merge` joins the parts and opens the next round, or writes the results after the last one."

    ResultNotWhole "E0913" "a finished result is not as it was written"
"loosepin.json lists the files of a result with their BLAKE3 hashes, and every command that reads a result holds them against it. A file \
is missing or was changed since: restore the folder from a copy, or make the result again with --force."

    NoSurrogateAnswer "E0920" "saved surrogates give no answer"
"A surrogates.json needs values for all its inputs, within the training ranges; there is no extrapolation. A file of another version, \
or an incomplete file, is refused."

    SurrogateNotExported "E0921" "a surrogate cannot be written for other programs"
"`loosepin export` writes neural networks as ONNX. Polynomials and Gaussian processes are not made of layers; all of their coefficients \
stand in surrogates.json. An output of the name that was given by --output must be among those that were learned."

    MeasuredTable "E1001" "a table of measured values cannot be used"
"A table of measured curves is comma-separated text. Its first line names each column with its unit, `angle [deg], slider [mm]`; \
the first column is a time or an angle of the drive that goes upwards, the others are outputs of the model. An empty cell is a \
value that was not measured."

    MeasuredOutside "E1002" "a measured value lies outside what was recorded"
"Measured values are held against the run at the same time or angle. Times count from the start of the run; angles are moved by \
whole turns so that the first of them lies in the first recorded turn. Record more turns, or cut the table."

    NotADrawing "E1101" "a drawing cannot be read"
"`loosepin import` reads DXF files, as text or binary, of any version since R10. The reason begins with the line of the file, or with \
the byte of a binary file."

    DrawingNotAMechanism "E1102" "a drawing is not a sketch of a mechanism"
"Lines and polylines are links, circles are joints. Every circle is met by a link, every link meets a circle, and what stands in \
the ground is on a layer called ground. The message gives the place in the coordinates of the drawing."
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
        assert_eq!(error.to_string(), "there is no code 'E9999'; codes run from E0101 to E1102");
    }
}
