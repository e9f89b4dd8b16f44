//! Limits of holes and shafts by the ISO code system, and the clearance of a fit.
//!
//! Source: ISO 286-1:2010, "ISO code system for tolerances on linear sizes": tables 1 (standard tolerances), 2 and 3 (fundamental
//! deviations of holes), 4 and 5 (of shafts), for nominal sizes up to 500 mm. Kept here are the grades 3 to 13 and the letters D E
//! F G H JS K M N P of holes and d e f g h js k m n p r s of shafts.

use thiserror::Error;

/// Upper ends of the ranges of nominal sizes, mm; a size at an end belongs to the range below it.
const RANGES_MM: [f64; 13] = [3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0];

/// The least grade that is kept here.
const MIN_GRADE: u8 = 3;

/// Standard tolerances of the grades IT2 to IT13, µm; IT2 only for the step below IT3.
const TOLERANCES_UM: [[f64; 13]; 12] = [
    [1.2, 1.5, 1.5, 2.0, 2.5, 2.5, 3.0, 4.0, 5.0, 7.0, 8.0, 9.0, 10.0],
    [2.0, 2.5, 2.5, 3.0, 4.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 13.0, 15.0],
    [3.0, 4.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0],
    [4.0, 5.0, 6.0, 8.0, 9.0, 11.0, 13.0, 15.0, 18.0, 20.0, 23.0, 25.0, 27.0],
    [6.0, 8.0, 9.0, 11.0, 13.0, 16.0, 19.0, 22.0, 25.0, 29.0, 32.0, 36.0, 40.0],
    [10.0, 12.0, 15.0, 18.0, 21.0, 25.0, 30.0, 35.0, 40.0, 46.0, 52.0, 57.0, 63.0],
    [14.0, 18.0, 22.0, 27.0, 33.0, 39.0, 46.0, 54.0, 63.0, 72.0, 81.0, 89.0, 97.0],
    [25.0, 30.0, 36.0, 43.0, 52.0, 62.0, 74.0, 87.0, 100.0, 115.0, 130.0, 140.0, 155.0],
    [40.0, 48.0, 58.0, 70.0, 84.0, 100.0, 120.0, 140.0, 160.0, 185.0, 210.0, 230.0, 250.0],
    [60.0, 75.0, 90.0, 110.0, 130.0, 160.0, 190.0, 220.0, 250.0, 290.0, 320.0, 360.0, 400.0],
    [100.0, 120.0, 150.0, 180.0, 210.0, 250.0, 300.0, 350.0, 400.0, 460.0, 520.0, 570.0, 630.0],
    [140.0, 180.0, 220.0, 270.0, 330.0, 390.0, 460.0, 540.0, 630.0, 720.0, 810.0, 890.0, 970.0],
];

/// Upper deviations of shafts that lie below the nominal size, µm.
const BELOW_UM: [(&str, [f64; 13]); 5] = [
    ("d", [20.0, 30.0, 40.0, 50.0, 65.0, 80.0, 100.0, 120.0, 145.0, 170.0, 190.0, 210.0, 230.0]),
    ("e", [14.0, 20.0, 25.0, 32.0, 40.0, 50.0, 60.0, 72.0, 85.0, 100.0, 110.0, 125.0, 135.0]),
    ("f", [6.0, 10.0, 13.0, 16.0, 20.0, 25.0, 30.0, 36.0, 43.0, 50.0, 56.0, 62.0, 68.0]),
    ("g", [2.0, 4.0, 5.0, 6.0, 7.0, 9.0, 10.0, 12.0, 14.0, 15.0, 17.0, 18.0, 20.0]),
    ("h", [0.0; 13]),
];

/// Lower deviations of shafts that lie above the nominal size, µm; those of k for the grades 4 to 7.
const ABOVE_UM: [(&str, [f64; 13]); 4] = [
    ("k", [0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0, 5.0]),
    ("m", [2.0, 4.0, 6.0, 7.0, 8.0, 9.0, 11.0, 13.0, 15.0, 17.0, 20.0, 21.0, 23.0]),
    ("n", [4.0, 8.0, 10.0, 12.0, 15.0, 17.0, 20.0, 23.0, 27.0, 31.0, 34.0, 37.0, 40.0]),
    ("p", [6.0, 12.0, 15.0, 18.0, 22.0, 26.0, 32.0, 37.0, 43.0, 50.0, 56.0, 62.0, 68.0]),
];

/// Lower deviations of the shafts r and s, µm, whose ranges are finer above 50 mm: upper end of the range in mm, r, s.
const ABOVE_FINE_UM: [(f64, f64, f64); 22] = [
    (3.0, 10.0, 14.0),
    (6.0, 15.0, 19.0),
    (10.0, 19.0, 23.0),
    (18.0, 23.0, 28.0),
    (30.0, 28.0, 35.0),
    (50.0, 34.0, 43.0),
    (65.0, 41.0, 53.0),
    (80.0, 43.0, 59.0),
    (100.0, 51.0, 71.0),
    (120.0, 54.0, 79.0),
    (140.0, 63.0, 92.0),
    (160.0, 65.0, 100.0),
    (180.0, 68.0, 108.0),
    (200.0, 77.0, 122.0),
    (225.0, 80.0, 130.0),
    (250.0, 84.0, 140.0),
    (280.0, 94.0, 158.0),
    (315.0, 98.0, 170.0),
    (355.0, 108.0, 190.0),
    (400.0, 114.0, 208.0),
    (450.0, 126.0, 232.0),
    (500.0, 132.0, 252.0),
];

/// Why a fit has no limits.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// What is not written as a fit.
    #[error("'{text}' is no fit")]
    NotAFit {
        /// The text.
        text: String,
    },
    /// A letter that is not kept here.
    #[error("'{class}': the {part} letters known here are {known}")]
    Letter {
        /// The tolerance class.
        class: String,
        /// Hole or shaft.
        part: &'static str,
        /// The letters.
        known: &'static str,
    },
    /// A grade that is not kept here.
    #[error("'{class}': the grade must be 3 to 13")]
    Grade {
        /// The tolerance class.
        class: String,
    },
    /// A grade that the standard gives no deviation for.
    #[error("'{class}': the standard has K for grades up to 8 only")]
    NoDeviation {
        /// The tolerance class.
        class: String,
    },
    /// A size outside the tables.
    #[error("a diameter of {diameter_mm} mm; the tables go from above 0 mm to 500 mm")]
    Size {
        /// The diameter, mm.
        diameter_mm: f64,
    },
}

/// A hole and a shaft of the same nominal diameter, for example `H7/g6`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fit {
    hole: Class,
    shaft: Class,
}

/// Lower and upper limits of the diameters of a fit, as deviations from the nominal one, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitLimits {
    /// Limits of the hole.
    pub hole_m: [f64; 2],
    /// Limits of the shaft.
    pub shaft_m: [f64; 2],
}

/// A letter and a grade.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Class {
    is_hole: bool,
    letter: String,
    grade: u8,
}

impl Fit {
    /// Reads `H7/g6`: the hole in capital letters first, the shaft in small letters.
    ///
    /// # Errors
    /// What is not a fit, or not kept here.
    pub fn parse(text: &str) -> Result<Self, FitError> {
        let not_a_fit = || FitError::NotAFit { text: text.to_owned() };
        let (hole, shaft) = text.split_once('/').ok_or_else(not_a_fit)?;
        let (hole, shaft) = (hole.trim(), shaft.trim());
        let is_written = |class: &str, is_case: fn(&char) -> bool| {
            let letters = class.chars().take_while(char::is_ascii_alphabetic).count();
            let digits = &class[letters.min(class.len())..];
            letters > 0
                && class.chars().take(letters).all(|letter| is_case(&letter))
                && !digits.is_empty()
                && digits.chars().all(|digit| digit.is_ascii_digit())
        };
        if !is_written(hole, char::is_ascii_uppercase) || !is_written(shaft, char::is_ascii_lowercase) {
            return Err(not_a_fit());
        }
        Ok(Self { hole: Class::parse(hole, true)?, shaft: Class::parse(shaft, false)? })
    }

    /// The limits at a nominal diameter.
    ///
    /// # Errors
    /// [`FitError::Size`] outside the tables, [`FitError::NoDeviation`] where the standard has no such hole.
    pub fn limits(&self, diameter_m: f64) -> Result<FitLimits, FitError> {
        let diameter_mm = tabulated_mm(diameter_m)?;
        Ok(FitLimits { hole_m: self.hole.limits_m(diameter_mm)?, shaft_m: self.shaft.limits_m(diameter_mm)? })
    }
}

/// Lower and upper deviation of a hole (`H7`) or a shaft (`h9`) from its nominal size, m.
///
/// # Errors
/// What is not kept here, as for [`Fit::parse`] and [`Fit::limits`].
pub fn class_deviations_m(class: &str, nominal_m: f64) -> Result<[f64; 2], FitError> {
    let is_hole = class.starts_with(|letter: char| letter.is_ascii_uppercase());
    let class = Class::parse(class, is_hole)?;
    let nominal_mm = tabulated_mm(nominal_m)?;
    class.limits_m(nominal_mm)
}

/// A size of the tables, mm, to a nanometre, so that 18 mm is 18 mm whatever unit it was written in.
fn tabulated_mm(size_m: f64) -> Result<f64, FitError> {
    let size_mm = (size_m * 1e9).round() / 1e6;
    let is_tabulated = size_mm > 0.0 && size_mm <= RANGES_MM[RANGES_MM.len() - 1];
    is_tabulated.then_some(size_mm).ok_or(FitError::Size { diameter_mm: size_m * 1e3 })
}

impl FitLimits {
    /// The least and the greatest radial clearance: half of the differences of the diameters, below 0 where hole and shaft
    /// interfere.
    pub fn radial_clearance_m(&self) -> [f64; 2] {
        [0.5 * (self.hole_m[0] - self.shaft_m[1]), 0.5 * (self.hole_m[1] - self.shaft_m[0])]
    }
}

impl Class {
    fn parse(text: &str, is_hole: bool) -> Result<Self, FitError> {
        let class = || text.to_owned();
        let letters = text.chars().take_while(char::is_ascii_alphabetic).count();
        let (letter, grade) = text.split_at(letters);
        let (part, known) = if is_hole { ("hole", HOLE_LETTERS) } else { ("shaft", SHAFT_LETTERS) };
        if !known.split(' ').any(|known| known == letter) {
            return Err(FitError::Letter { class: class(), part, known });
        }
        let grades = MIN_GRADE..=MIN_GRADE + (TOLERANCES_UM.len() - 2) as u8;
        match grade.parse::<u8>() {
            Ok(grade) if grades.contains(&grade) => Ok(Self { is_hole, letter: letter.to_owned(), grade }),
            _ => Err(FitError::Grade { class: class() }),
        }
    }

    /// Lower and upper deviation from the nominal size, m.
    fn limits_m(&self, nominal_mm: f64) -> Result<[f64; 2], FitError> {
        let limits_um = if self.is_hole { self.hole_um(nominal_mm)? } else { self.shaft_um(nominal_mm) };
        Ok(limits_um.map(|limit_um| limit_um / 1e6))
    }

    /// As it is written.
    fn written(&self) -> String {
        format!("{}{}", self.letter, self.grade)
    }

    /// Lower and upper deviation ei and es, µm: one from the letter, the other one a standard tolerance away.
    fn shaft_um(&self, diameter_mm: f64) -> [f64; 2] {
        let range = range_of(diameter_mm);
        let tolerance = tolerance_um(self.grade, range);
        if self.letter == "js" {
            return [-0.5 * tolerance, 0.5 * tolerance];
        }
        match shaft_deviation_um(&self.letter, self.grade, range, diameter_mm) {
            FundamentalDeviation::Upper(upper) => [upper - tolerance, upper],
            FundamentalDeviation::Lower(lower) => [lower, lower + tolerance],
        }
    }

    /// Lower and upper deviation EI and ES, µm. D to H mirror the shafts: EI = -es. K, M and N up to grade 8 and P up to grade 7 are
    /// placed so that a hole fits a shaft of the next finer grade as the shaft of that letter fits H: ES = -ei + Δ, Δ = IT_n -
    /// IT_(n-1), for sizes above 3 mm.
    fn hole_um(&self, diameter_mm: f64) -> Result<[f64; 2], FitError> {
        let range = range_of(diameter_mm);
        let tolerance = tolerance_um(self.grade, range);
        if self.letter == "JS" {
            return Ok([-0.5 * tolerance, 0.5 * tolerance]);
        }
        let step = if range == 0 { 0.0 } else { tolerance - tolerance_um(self.grade - 1, range) };
        let letter = self.letter.to_ascii_lowercase();
        // The deviation that belongs to the letter: k keeps its value for holes up to grade 8.
        let of_letter = shaft_deviation_um(&letter, if letter == "k" { 6 } else { self.grade }, range, diameter_mm);
        let upper = match of_letter {
            FundamentalDeviation::Upper(upper) => return Ok([-upper, -upper + tolerance]),
            FundamentalDeviation::Lower(lower) => lower,
        };
        let upper = match letter.as_str() {
            "k" if self.grade > 8 => return Err(FitError::NoDeviation { class: self.written() }),
            "p" if self.grade > 7 => -upper,
            "m" if self.grade > 8 => -upper,
            "n" if self.grade > 8 => {
                if range == 0 {
                    -upper
                } else {
                    0.0
                }
            }
            // A special case of the standard.
            "m" if self.grade == 6 && (250.0..=315.0).contains(&diameter_mm) && diameter_mm > 250.0 => -9.0,
            _ => -upper + step,
        };
        Ok([upper - tolerance, upper])
    }
}

/// The letters of holes that are kept here.
const HOLE_LETTERS: &str = "D E F G H JS K M N P";
/// The letters of shafts that are kept here.
const SHAFT_LETTERS: &str = "d e f g h js k m n p r s";

/// A fundamental deviation, µm: which limit it is.
enum FundamentalDeviation {
    Lower(f64),
    Upper(f64),
}

fn range_of(diameter_mm: f64) -> usize {
    RANGES_MM.partition_point(|&end_mm| end_mm < diameter_mm).min(RANGES_MM.len() - 1)
}

fn tolerance_um(grade: u8, range: usize) -> f64 {
    TOLERANCES_UM[usize::from(grade + 1 - MIN_GRADE)][range]
}

fn shaft_deviation_um(letter: &str, grade: u8, range: usize, diameter_mm: f64) -> FundamentalDeviation {
    if let Some((_, below)) = BELOW_UM.iter().find(|(known, _)| *known == letter) {
        return FundamentalDeviation::Upper(-below[range]);
    }
    if let Some((_, above)) = ABOVE_UM.iter().find(|(known, _)| *known == letter) {
        let is_zero = letter == "k" && !(4..=7).contains(&grade);
        return FundamentalDeviation::Lower(if is_zero { 0.0 } else { above[range] });
    }
    let fine = ABOVE_FINE_UM.partition_point(|row| row.0 < diameter_mm).min(ABOVE_FINE_UM.len() - 1);
    let (_, r, s) = ABOVE_FINE_UM[fine];
    FundamentalDeviation::Lower(if letter == "r" { r } else { s })
}

#[cfg(test)]
mod tests;
