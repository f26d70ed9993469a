//! Steels by name, in cases and in a file of one's own.

use brinell::case::grades::{GradeError, Grades};
use brinell::case::{Case, Kind, SteelStrength, parse};
use brinell::ground::units::UnitSystem::{InKipKsi, MmNMPa};
use brinell::model::material::Steel;

use crate::kit::{BEARING, SCENE, bad, good, render, with};

/// The keys of the steel of [`BEARING`].
const OWN: &str = "[steel]\nyoungs_modulus = \"29500 ksi\"\npoissons_ratio = 0.3\nyield_stress = \"100 ksi\"\n\
                   hardening = { stress = \"138 ksi\", strain = 0.157 }\n";

/// [`BEARING`] in millimetres with another steel; `root` stands before its first table.
fn bearing(root: &str, steel: &str) -> String {
    let text = with(BEARING, OWN, steel);
    with(
        &text,
        "units = \"in-kip-ksi\"\n",
        &format!("units = \"mm-N-MPa\"\n{root}"),
    )
}

#[track_caller]
fn steel(case: &Case, body: &str) -> (Steel, SteelStrength) {
    let Kind::Bearing(bearing) = &case.kind else {
        panic!("a bearing")
    };
    let steels = &bearing.steels;
    (steels.of(body).unwrap(), steels.strength_of(body).unwrap())
}

/// Strengths of the standards, by thickness, spot by spot: EN 10025-2, -3, -4, -6, EN 10083, ASTM.
#[test]
fn grades_have_the_strengths_of_their_standards() {
    let grades = Grades::shipped().unwrap();
    for (name, thickness, expected) in [
        ("S235", 16.0, [235.0, 360.0]),
        ("S235", 16.1, [225.0, 360.0]),
        ("s275 jr", 100.0, [235.0, 410.0]),
        ("S355", 40.0, [345.0, 470.0]),
        ("S355J2", 120.0, [295.0, 450.0]),
        ("S450J0", 63.0, [410.0, 550.0]),
        ("S460N", 50.0, [430.0, 540.0]),
        ("S460M", 50.0, [430.0, 530.0]),
        ("S690QL", 60.0, [650.0, 760.0]),
        ("C45+N", 90.0, [305.0, 580.0]),
        ("42CrMo4", 80.0, [650.0, 900.0]),
        ("34CrNiMo6+QT", 150.0, [700.0, 900.0]),
        ("G20Mn5+QT", 80.0, [300.0, 500.0]),
    ] {
        let found = grades.find(name).unwrap();
        let found = found.in_units(MmNMPa, Some(thickness)).unwrap();
        let strengths = [found.yield_stress, found.ultimate_strength].map(Option::unwrap);
        for (found, expected) in strengths.into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{name}: {found}");
        }
        assert!((found.youngs_modulus / 210e3 - 1.0).abs() < 1e-12);
    }
    for (name, thickness, expected) in [
        ("A36", 2.0, [36.0, 58.0]),
        ("A572 Grade 50", 4.0, [50.0, 65.0]),
        ("ASTM A588", 4.5, [46.0, 67.0]),
        ("a709-50w", 1.0, [50.0, 70.0]),
        ("HPS 70W", 1.0, [70.0, 85.0]),
        ("A709 HPS 100W", 3.0, [90.0, 100.0]),
        ("A668-D", 12.0, [37.5, 75.0]),
    ] {
        let found = grades.find(name).unwrap();
        let found = found.in_units(InKipKsi, Some(thickness)).unwrap();
        let strengths = [found.yield_stress, found.ultimate_strength].map(Option::unwrap);
        assert_eq!(strengths, expected, "{name}");
        assert_eq!(found.youngs_modulus, 29000.0);
    }
}

#[test]
fn the_shipped_grades_are_whole() {
    let grades = Grades::shipped().unwrap();
    let mut names = Vec::new();
    for grade in grades.all() {
        assert!(
            !grade.source.is_empty() && !grade.source.contains('§'),
            "{}",
            grade.name
        );
        names.push(grade.name.clone());
        names.extend(grade.also.clone());
        assert_eq!(grades.find(&grade.name).unwrap(), grade);
        assert!(
            grade
                .also
                .iter()
                .all(|also| grades.find(also).unwrap() == grade)
        );
        let thin = grade.in_units(MmNMPa, Some(1.0)).unwrap();
        if let (Some(y), Some(u)) = (thin.yield_stress, thin.ultimate_strength) {
            assert!(y < u && y > 200.0, "{}", grade.name);
        }
    }
    let count = names.len();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), count, "a name twice");
}

#[test]
fn a_bearing_takes_its_steel_by_name_and_its_thickness_from_its_parts() {
    for text in [
        bearing("steel = \"S355\"\n", ""),
        bearing("", "[steel]\ngrade = \"S355\"\n"),
    ] {
        let case = good(&text);
        // 1 in of plate, 3 in of roller.
        let (plate, strength) = steel(&case, "upper_plate");
        assert_eq!((plate.youngs_modulus, plate.yield_stress), (210e3, 345.0));
        assert_eq!(strength.ultimate_strength, Some(470.0));
        let (roller, _) = steel(&case, "lower_roller");
        assert_eq!(roller.yield_stress, 325.0);
        let told = |key: &str| case.assumptions.iter().find(|a| a.key == key);
        let thickness = told("steel.thickness").unwrap();
        let parts = "upper_plate 25.4 mm, upper_roller 76.2 mm, intermediate_plate 25.4 mm";
        assert!(thickness.value.starts_with(parts), "{}", thickness.value);
        let grade = told("steel.grade").unwrap();
        assert!(grade.why.contains("EN 10025-2") && grade.given);
    }
}

#[test]
fn what_a_table_says_goes_before_its_grade_and_that_before_the_default() {
    let steels = "[steel]\ngrade = \"S355\"\nthickness = \"50 mm\"\nultimate_strength = \"500 MPa\"\n\
                  [steel.upper_roller]\ngrade = \"42CrMo4\"\nhardness = 300\n\
                  [steel.lower_roller]\nyield_stress = \"800 MPa\"\n\
                  [steel.lower_plate]\npoissons_ratio = 0.28\n";
    let case = good(&bearing("", steels));
    let (plate, strength) = steel(&case, "intermediate_plate");
    assert_eq!(
        (plate.yield_stress, strength.ultimate_strength),
        (335.0, Some(500.0))
    );
    // Also 50 mm thick: what is given for all bodies.
    let (roller, strength) = steel(&case, "upper_roller");
    assert_eq!(
        (roller.yield_stress, strength.hardness),
        (650.0, Some(300.0))
    );
    assert_eq!(strength.ultimate_strength, Some(900.0));
    // Strengths of another steel do not complete those of one's own.
    let (roller, strength) = steel(&case, "lower_roller");
    assert_eq!(
        (roller.yield_stress, strength.ultimate_strength),
        (800.0, None)
    );
    assert_eq!(roller.youngs_modulus, 210e3);
    let (plate, strength) = steel(&case, "lower_plate");
    assert_eq!((plate.poissons_ratio, plate.yield_stress), (0.28, 335.0));
    assert_eq!(strength.ultimate_strength, Some(500.0));
}

#[test]
fn mistakes_in_a_name_or_a_thickness_are_marked() {
    let says = |text: &str, parts: &[&str]| {
        let error = bad(text);
        for part in parts {
            assert!(error.contains(part), "{part} is not in\n{error}");
        }
    };
    says(
        &bearing("steel = \"S356\"\n", ""),
        &["no steel is called `S356`", "the nearest are: S355", "╭─["],
    );
    says(
        &bearing("", "[steel]\ngrade = \"S355\"\nthickness = \"300 mm\"\n"),
        &["steel.thickness", "up to 250 mm, and not 300 mm thick"],
    );
    says(
        &bearing("", "[steel]\ngrade = \"100Cr6\"\n"),
        &["needs `yield_stress` or `elastic = true`"],
    );
    good(&bearing(
        "",
        "[steel]\ngrade = \"100Cr6\"\nelastic = true\n",
    ));
    says(
        &bearing("steel = 355\n", ""),
        &["steel", "a table is wanted"],
    );
    says(
        &bearing("", "[steel]\ngrade = \"S355\"\nhardness = -1\n"),
        &["steel.hardness = -1", "must be positive"],
    );
    // A scene does not know how thick the products were.
    let scene = with(
        SCENE,
        "[steel]\nyoungs_modulus = \"200 GPa\"\npoissons_ratio = 0.3\nelastic = true\n",
        "[steel]\ngrade = \"S355\"\n",
    );
    let error = good(&scene).scene(crate::kit::blocks()).unwrap_err();
    let text = render(&error);
    assert!(
        text.contains("depends on the thickness") && text.contains("355 MPa to 16 mm"),
        "{text}"
    );
    let thick = with(
        &scene,
        "grade = \"S355\"\n",
        "grade = \"S355\"\nthickness = 30\n",
    );
    let made = good(&thick).scene(crate::kit::blocks()).unwrap();
    assert_eq!(made.materials[0].yield_stress, 345.0);
    let body = format!("{thick}[[body]]\nname = \"upper\"\nsteel = \"A36\"\n");
    let made = good(&body).scene(crate::kit::blocks()).unwrap();
    assert!((made.materials[1].yield_stress - 248.211).abs() < 1e-3);
}

#[test]
fn grades_of_ones_own_stand_in_a_file_beside_the_case() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shop.toml");
    let case = folder.path().join("case.toml").display().to_string();
    let text = bearing("steel = \"Shop steel\"\ngrades = \"shop.toml\"\n", "");
    let missing = parse(&case, &text).unwrap_err();
    assert!(missing.to_string().contains("cannot be read"), "{missing}");
    let own = "[[grade]]\nname = \"Shop steel\"\nsource = \"mill\"\nyoungs_modulus = \"205 GPa\"\n\
               poissons_ratio = 0.29\nyield_stress = \"800 MPa\"\nultimate_strength = [{ up_to = \"100 mm\", value = \
               \"950 MPa\" }]\nhardness = 280\n";
    std::fs::write(&file, own).unwrap();
    let read = parse(&case, &text).unwrap();
    let (roller, strength) = steel(&read, "upper_roller");
    assert_eq!((roller.poissons_ratio, roller.yield_stress), (0.29, 800.0));
    assert_eq!(
        (strength.ultimate_strength, strength.hardness),
        (Some(950.0), Some(280.0))
    );
    for (wrong, why) in [
        (with(own, "205 GPa", "205"), "has no unit"),
        (with(own, "800 MPa", "800 mm"), "a stress is wanted"),
        (
            with(own, "up_to = \"100 mm\"", "to = \"100 mm\""),
            "a stress such as",
        ),
        (with(own, "hardness = 280", "hardnes = 280"), "hardnes"),
        (with(own, "0.29", "0.5"), "between -1 and 0.5"),
        (with(own, "280", "-280"), "must be positive"),
        (
            with(own, "[{ up_to = \"100 mm\", value = \"950 MPa\" }]", "[]"),
            "at least one step",
        ),
        ("nonsense".to_owned(), "shop.toml"),
    ] {
        std::fs::write(&file, &wrong).unwrap();
        let error = render(&parse(&case, &text).unwrap_err());
        assert!(
            error.contains(why) && error.contains("shop.toml"),
            "{why} is not in\n{error}"
        );
    }
}

#[test]
fn a_thickness_is_asked_for_and_not_guessed() {
    let grades = Grades::shipped().unwrap();
    let steel = grades.find("S355").unwrap();
    let why = |thickness| steel.in_units(MmNMPa, thickness).unwrap_err();
    assert!(matches!(why(None), GradeError::NoThickness { .. }));
    assert!(matches!(why(Some(251.0)), GradeError::TooThick { .. }));
    assert!(
        grades
            .find("100Cr6")
            .unwrap()
            .in_units(MmNMPa, None)
            .is_ok()
    );
}
