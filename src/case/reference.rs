//! Discrepancies inside the reference study that touch a result, printed with it.

use serde::Serialize;

/// Two statements of the study that do not agree, or a printed value that cannot be right.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Discrepancy {
    /// What differs, in words.
    pub what: &'static str,
    /// What it does to this result, and how the program takes it.
    pub effect: &'static str,
}

/// The published cases that a case file may refer to by `reference = "…"`.
pub(super) const STUDIES: [&str; 5] = [
    "section-2.6.2",
    "prototype-1",
    "prototype-2",
    "chapter-5",
    "ncree",
];

const MODULUS: Discrepancy = Discrepancy {
    what: "E = 29500 ksi is printed as 204000 MPa; it is 203395 MPa",
    effect: "0.3 % in stiffness; the value in ksi is taken",
};

const LENGTH_ALONE: Discrepancy = Discrepancy {
    what: "the printed maxima fall from 70 to 30 ksi (plate) and from 49 to 23 ksi (rollers) \
           between 8 and 10.5 in of roller",
    effect: "length alone lowers them to 0.87 to 0.96, not to 0.43 and 0.47: mesh, plate size or \
             modelling must have differed, so the printed values are comparisons, not targets",
};

const BELOW_HERTZ: Discrepancy = Discrepancy {
    what: "the printed Mises maxima lie below Hertz's 93 ksi (8 in) and 81 ksi (10.5 in) for a \
           uniform line load",
    effect: "they are values of a mesh that cannot see a contact strip 0.06 in wide",
};

const HARDENING: Discrepancy = Discrepancy {
    what: "of the hardening point (138 ksi, 0.157) it is not said whether the strain is total or \
           plastic, nor whether the values are true or engineering values",
    effect: "H = 249.471 ksi as total strain, 242.04 ksi as plastic strain",
};

const OFFSET: Discrepancy = Discrepancy {
    what: "\"2.5 in\" is the displacement of a roller in the captions, but twice the roller \
           displacement of 1.25 in where the roller length is chosen",
    effect: "both offsets, 1.25 and 2.5 in, are run",
};

const OFFSET_UNIT: Discrepancy = Discrepancy {
    what: "\"2.5 in (51 mm)\" is 63.5 mm; 51 mm are 2 in",
    effect: "the value in inches is taken",
};

const THIN_WALL: Discrepancy = Discrepancy {
    what: "the wall is 0.1667 of the diameter, against the study's own rule that less than 0.25 \
           needs a finite-element analysis, and none is reported",
    effect: "ring bending is 2.4 times that of a wall of 0.25 diameters at the same line load",
};

const THIN_WALL_2: Discrepancy = Discrepancy {
    what: "the wall is 0.2154 of the diameter, against the study's own rule that less than 0.25 \
           needs a finite-element analysis, and none is reported",
    effect: "ring bending is 1.4 times that of a wall of 0.25 diameters at the same line load",
};

const DESCENT_UNIT: Discrepancy = Discrepancy {
    what: "the descent of \"0.056 in (1.44 mm)\" at 210 kip is 1.42 mm, and includes the closing of \
           gaps of unknown width",
    effect: "it is no target; the slopes above 90 kip are what a test could be compared with",
};

const SIZING: Discrepancy = Discrepancy {
    what: "the constant 8 of the sizing rule stands for 7.783, so that the initial length L exceeds \
           the study's own limit of 1.65 yield stresses",
    effect: "by 0.9 % under the design load on L alone, as with the rollers fully displaced",
};

const ULTIMATE: Discrepancy = Discrepancy {
    what: "the roller is sized by its ultimate strength, and the yield stress is not given",
    effect: "the ultimate strength is taken for the yield stress, so less yields here than would",
};

const RETURNING: Discrepancy = Discrepancy {
    what: "a slope of 2 deg does not give the \"returning acceleration = 0.09 g\": half its sine is \
           0.017",
    effect: "2 deg are taken; 0.09 g would take 10.4 deg",
};

/// The discrepancies that touch a case of `study` with this offset.
pub(super) fn discrepancies(study: &str, displaced: bool) -> Vec<Discrepancy> {
    match study {
        "section-2.6.2" => {
            let mut all = vec![MODULUS, LENGTH_ALONE, BELOW_HERTZ, HARDENING];
            if displaced {
                all.extend([OFFSET, OFFSET_UNIT]);
            }
            all
        }
        "prototype-1" => vec![MODULUS, THIN_WALL],
        "prototype-2" => vec![MODULUS, THIN_WALL_2, SIZING, DESCENT_UNIT],
        "chapter-5" => vec![SIZING],
        "ncree" => vec![ULTIMATE, RETURNING],
        _ => Vec::new(),
    }
}
