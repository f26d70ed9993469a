//! Design rules against numbers worked by hand from their formulas, two for each, to four digits.

use brinell::analytic::rules::{
    Bound, Judged, Limit, LoadError, Rule, RuleInput, RuleMeasure, RuleSteel, RuleVerdict,
    Standing, rules,
};
use brinell::ground::units::{Dimension, UnitSystem};

use crate::close;

/// As many digits as the numbers by hand have.
const FOUR_DIGITS: f64 = 1e-4;

const EN_STATIC: &str = "EN 13001-3-3, static";
const EN_FATIGUE: &str = "EN 13001-3-3, fatigue";
const LINE_LOAD: &str = "AASHTO, load per inch";

fn steel(youngs_modulus: f64) -> RuleSteel {
    RuleSteel::elastic(youngs_modulus, 0.3)
}

/// The study's roller: D = 3 in, L = 8 in, 29500 ksi, 100 ksi.
fn study() -> RuleInput {
    let steel = RuleSteel {
        yield_stress: Some(100.0),
        ..steel(29500.0)
    };
    RuleInput::new(UnitSystem::InKipKsi, 3.0, 8.0, [steel; 2])
}

/// A bridge roller: D = 160 mm, L = 400 mm, S355.
fn bridge() -> RuleInput {
    let steel = RuleSteel {
        yield_stress: Some(355.0),
        ultimate_strength: Some(470.0),
        ..steel(210e3)
    };
    RuleInput::new(UnitSystem::MmNMPa, 160.0, 400.0, [steel; 2])
}

/// A crane wheel: D = 400 mm, 250 HB.
fn wheel() -> RuleInput {
    let steel = RuleSteel {
        hardness: Some(250.0),
        ..steel(210e3)
    };
    RuleInput::new(UnitSystem::MmNMPa, 400.0, 60.0, [steel; 2])
}

#[track_caller]
fn rule(input: &RuleInput, name: &str) -> Rule {
    let all = rules(input).unwrap();
    all.into_iter().find(|rule| rule.name == name).unwrap()
}

#[track_caller]
fn bound(input: &RuleInput, name: &str) -> Bound {
    let rule = rule(input, name);
    rule.bound().unwrap_or_else(|| panic!("{:?}", rule.limit))
}

/// Fails unless the rule allows this load per length, and this peak pressure.
#[track_caller]
fn allows(input: &RuleInput, name: &str, line_load: f64, pressure: f64) {
    let bound = bound(input, name);
    close(name, bound.line_load, line_load, FOUR_DIGITS);
    close(name, bound.pressure, pressure, FOUR_DIGITS);
}

/// Fails unless the rule refuses the roller, saying `why`.
#[track_caller]
fn refuses(input: &RuleInput, name: &str, why: &str) {
    match rule(input, name).limit {
        Limit::Refused(text) => assert_eq!(text, why),
        other => panic!("{other:?}"),
    }
}

/// 1.65 · 100; q = 5.7177 · 165² · 1.5 / 29500. 1.65 · 355; q = 5.7177 · 585.75² · 80 / 210000.
#[test]
fn the_pressure_limit_of_the_study() {
    allows(&study(), "(2-49)", 7.915, 165.0);
    allows(&bridge(), "(2-49)", 747.3, 585.8);
}

/// 8 · 3 · 100² / 29500; 8 · 160 · 355² / 210000.
#[test]
fn the_sizing_of_the_study() {
    allows(&study(), "(2-50), (2-51)", 8.1356, 167.28);
    allows(&bridge(), "(2-50), (2-51)", 768.2, 593.9);
}

/// 8 · 6 / (1 - 6/24) · 50² / 29000 in a groove; 8 · 200 · 345² / 200000 on a flat.
#[test]
fn contact_of_cylinders_by_aashto_lrfd() {
    let yields = |e, y| RuleSteel {
        yield_stress: Some(y),
        ..steel(e)
    };
    let groove = RuleInput {
        mating_diameter: Some(24.0),
        ..RuleInput::new(UnitSystem::InKipKsi, 6.0, 20.0, [yields(29000.0, 50.0); 2])
    };
    allows(&groove, "AASHTO LRFD", 5.517, 83.64);
    let sides = [yields(200e3, 345.0), yields(200e3, 400.0)];
    let flat = RuleInput::new(UnitSystem::MmNMPa, 200.0, 500.0, sides);
    allows(&flat, "AASHTO LRFD", 952.2, 577.1);
}

/// 37/20 · 0.6 · 6 kip/in; a rocker of 36 in: 23/20 · 3 · √36 = 20.7 kip/in, which is 3625 N/mm.
#[test]
fn the_load_per_inch_of_old() {
    let yields = |y| RuleSteel {
        yield_stress: Some(y),
        ..steel(29000.0)
    };
    let roller = RuleInput::new(UnitSystem::InKipKsi, 6.0, 20.0, [yields(50.0); 2]);
    allows(&roller, LINE_LOAD, 6.66, 106.11);
    let ksi = UnitSystem::InKipKsi.factor_to(UnitSystem::MmNMPa, Dimension::STRESS);
    let steel = RuleSteel {
        yield_stress: Some(36.0 * ksi),
        ..steel(29000.0 * ksi)
    };
    let rocker = RuleInput::new(UnitSystem::MmNMPa, 36.0 * 25.4, 500.0, [steel; 2]);
    allows(&rocker, LINE_LOAD, 3625.0, 76.37 * ksi);
}

/// 23 · 80 · 470² / 210000; 23 · 150 · 510² / 205000.
#[test]
fn roller_bearings_by_en_1337_4() {
    allows(&bridge(), "EN 1337-4", 1935.5, 942.65);
    let steel = RuleSteel {
        ultimate_strength: Some(510.0),
        ..steel(205e3)
    };
    let large = RuleInput::new(UnitSystem::MmNMPa, 300.0, 900.0, [steel; 2]);
    allows(&large, "EN 1337-4", 4377.3, 1022.9);
}

/// 1750² π 400 · 0.91 · 0.85 / (210000 · 1.1). Then 300 HB on 350, of 210000 and 175000: E_m = 190909, and a rounded
/// edge of 4 mm beside 10 mm: f1 = 0.64/0.7; 2100² π 600 · 0.91 · 0.9143 / (190909 · 1.1).
#[test]
fn wheels_by_en_13001_static() {
    allows(&wheel(), EN_STATIC, 12886.0, 1538.3);
    let hard = |hardness, e| RuleSteel {
        hardness: Some(hardness),
        ..steel(e)
    };
    let cast = RuleInput {
        end_radius: 4.0,
        overhang: Some(10.0),
        ..RuleInput::new(
            UnitSystem::MmNMPa,
            600.0,
            80.0,
            [hard(300.0, 210e3), hard(350.0, 175e3)],
        )
    };
    allows(&cast, EN_STATIC, 32934.0, 1914.5);
}

/// 750² π 400 · 0.91 · 0.85 / (210000 · 1.1), over (1/6.4)^0.3 = 0.5730. Then a hardened surface over a core of
/// 800 N/mm², p0 = 1.8 · 800, nothing standing out, over (20/6.4)^0.3 = 1.408.
#[test]
fn wheels_by_en_13001_fatigue() {
    let rolled = RuleInput {
        rollings: Some(1e6),
        ..wheel()
    };
    allows(&rolled, EN_FATIGUE, 4130.8, 870.97);
    let hardened = RuleSteel {
        yield_stress: Some(800.0),
        hardness: Some(500.0),
        surface_hardened: true,
        ..steel(210e3)
    };
    let rolled = RuleInput {
        rollings: Some(2e7),
        overhang: Some(0.0),
        ..RuleInput::new(UnitSystem::MmNMPa, 500.0, 80.0, [hardened; 2])
    };
    allows(&rolled, EN_FATIGUE, 9116.3, 1157.3);
}

/// 5.7177 · 4000² · 10 / 207000 N/mm. In inches: 580.2 ksi; 5.7177 · 580.15² · 0.5 / 30000 kip/in.
#[test]
fn static_rating_by_iso_76() {
    let hard = |e| RuleSteel {
        hardness: Some(650.0),
        ..steel(e)
    };
    let roller = RuleInput::new(UnitSystem::MmNMPa, 20.0, 20.0, [hard(207e3); 2]);
    allows(&roller, "ISO 76", 4419.5, 4000.0);
    let roller = RuleInput::new(UnitSystem::InKipKsi, 1.0, 1.0, [hard(30e3); 2]);
    allows(&roller, "ISO 76", 32.074, 580.15);
}

/// 1.7937 Y and 4 Y/√3, of the weaker side.
#[test]
fn yield_and_shakedown() {
    allows(&study(), "first yield", 9.354, 179.37);
    allows(&bridge(), "first yield", 883.2, 636.8);
    allows(&study(), "elastic shakedown", 15.506, 230.94);
    let mut bridge = bridge();
    bridge.sides[1].yield_stress = Some(690.0);
    allows(&bridge, "elastic shakedown", 1464.0, 819.8);
}

/// What each limit is as a peak pressure, for equal steels with ν = 0.3, as multiples of what it goes by.
#[test]
fn limits_as_peak_pressures() {
    let steel = RuleSteel {
        yield_stress: Some(1.0),
        ultimate_strength: Some(1.0),
        hardness: Some(1.0),
        ..steel(1000.0)
    };
    let unit = RuleInput {
        overhang: Some(0.0),
        rollings: Some(6.4e6),
        ..RuleInput::new(UnitSystem::MmNMPa, 10.0, 30.0, [steel; 2])
    };
    // Without its partial factor of 1.1.
    let bare = 1.1_f64.sqrt();
    for (name, expected) in [
        ("EN 1337-4", 2.006),
        ("AASHTO LRFD", 1.673),
        ("(2-49)", 1.65),
        (EN_STATIC, 7.0 / bare),
        (EN_FATIGUE, 3.0 / bare),
        ("first yield", 1.79),
        ("elastic shakedown", 2.31),
    ] {
        let found = bound(&unit, name);
        close(name, found.pressure, expected, 2.5e-3);
        // Hertz, for equal steels: q = 5.7177 p0² R / E.
        let hertz = 5.7177 * found.pressure.powi(2) * 5.0 / 1000.0;
        close(name, found.line_load, hertz, 1e-4);
    }
    for (diameter, fy, expected) in [(3.0, 100.0, 1.63), (3.0, 36.0, 2.32)] {
        let steel = RuleSteel {
            yield_stress: Some(fy),
            ..self::steel(29000.0)
        };
        let input = RuleInput::new(UnitSystem::InKipKsi, diameter, 8.0, [steel; 2]);
        close(
            LINE_LOAD,
            bound(&input, LINE_LOAD).pressure / fy,
            expected,
            2.5e-3,
        );
    }
}

#[test]
fn what_is_out_of_range_is_refused_by_its_limit() {
    let short = RuleInput {
        length: 240.0,
        ..bridge()
    };
    let why = "length over diameter is 1.5, but it must be from 2 to 6";
    refuses(&short, "EN 1337-4", why);
    let turned = RuleInput {
        rotation: Some(0.06),
        ..bridge()
    };
    let why = "rotation in rad is 0.06, but it must be at most 0.05";
    refuses(&turned, "EN 1337-4", why);
    let vast = RuleInput {
        diameter: 126.0,
        ..study()
    };
    let why = "diameter in inch is 126, but it must be at most 125";
    refuses(&vast, LINE_LOAD, why);
    let mut weak = study();
    weak.sides[0].yield_stress = Some(13.0);
    let why = "yield stress in ksi is 13, but it must be more than 13";
    refuses(&weak, LINE_LOAD, why);
    let why = "Brinell hardness is 250, but it must be at least 615: the rule is of hardened bearing steel";
    refuses(&wheel(), "ISO 76", why);
    let mut soft = wheel();
    for side in &mut soft.sides {
        (side.surface_hardened, side.yield_stress) = (true, Some(500.0));
    }
    let why = "hardness of a hardened surface is 250, but it must be at least 0.6 of the yield stress, 300";
    refuses(&soft, EN_STATIC, why);
    for name in ["EN 1337-4", LINE_LOAD, EN_STATIC, "(2-50), (2-51)"] {
        let groove = RuleInput {
            mating_diameter: Some(500.0),
            sides: [RuleSteel {
                hardness: Some(300.0),
                ..bridge().sides[0]
            }; 2],
            ..bridge()
        };
        let why =
            "diameter of the groove is 500, but it must be that of a flat: the rule knows no other";
        refuses(&groove, name, why);
    }
}

#[test]
fn what_is_missing_is_named_and_no_roller_at_all_is_an_error() {
    let needs = |input: &RuleInput, name: &str| match rule(input, name).limit {
        Limit::Needs(what) => what,
        other => panic!("{other:?}"),
    };
    let (study, wheel) = (study(), wheel());
    assert_eq!(
        needs(&study, "EN 1337-4"),
        "the ultimate strength of both steels"
    );
    assert_eq!(
        needs(&study, EN_STATIC),
        "the Brinell hardness of both steels"
    );
    assert_eq!(needs(&wheel, EN_FATIGUE), "the number of rollings");
    assert_eq!(needs(&wheel, "(2-49)"), "the yield stress of both steels");
    let mut half = study;
    half.sides[1].yield_stress = None;
    assert_eq!(
        needs(&half, "AASHTO LRFD"),
        "the yield stress of the plate's steel"
    );
    for wrong in [
        RuleInput {
            diameter: -3.0,
            ..study
        },
        RuleInput {
            length: f64::NAN,
            ..study
        },
        RuleInput {
            mating_diameter: Some(2.0),
            ..study
        },
        RuleInput {
            end_radius: -1.0,
            ..study
        },
    ] {
        assert!(rules(&wrong).is_err(), "{wrong:?}");
    }
}

#[test]
fn verdicts_say_what_they_are_worth() {
    let bridge = RuleInput {
        rollings: Some(1e6),
        sides: [RuleSteel {
            hardness: Some(650.0),
            ..bridge().sides[0]
        }; 2],
        ..bridge()
    };
    for rule in rules(&bridge).unwrap() {
        let Bound {
            line_load,
            pressure,
        } = rule.bound().unwrap();
        let judge = |load, error| rule.judge(load, error).unwrap();
        let words = |judged: Judged| judged.verdict.to_string();
        let expected = match rule.standing {
            Standing::Rule => ["met", "NOT met"],
            Standing::Indicative => ["indicative: within", "indicative: exceeded"],
            Standing::Threshold => ["below", "beyond"],
        };
        let [less, more] =
            [0.81 * line_load, 1.21 * line_load].map(|load| judge(load, LoadError::None));
        assert_eq!([words(less), words(more)], expected, "{}", rule.name);
        let [low, high] = match rule.measure {
            RuleMeasure::LineLoad => [0.81, 1.21],
            RuleMeasure::Pressure => [0.9, 1.1],
        };
        close(rule.name, less.utilisation, low, 1e-12);
        close(rule.name, more.utilisation, high, 1e-12);
        close(rule.name, less.pressure, 0.9 * pressure, 1e-12);
        // An error that reaches over the limit leaves it open.
        let open = judge(0.95 * line_load, LoadError::Within(0.1 * line_load));
        assert_eq!(open.verdict, RuleVerdict::Open);
        assert_eq!(open.verdict.is_within(), None);
        let known = judge(0.8 * line_load, LoadError::Within(0.1 * line_load));
        assert_eq!(known.verdict.is_within(), Some(true));
        let unknown = judge(0.1 * line_load, LoadError::Unknown);
        assert_eq!(
            (unknown.verdict, unknown.error),
            (RuleVerdict::Unresolved, None)
        );
        let indicative = rule.standing == Standing::Indicative;
        assert!(!indicative || expected.iter().all(|word| !word.contains("met")));
        // No clause of a standard that was not read.
        assert!(
            !indicative || !rule.source.contains(['§', '.']),
            "{}",
            rule.source
        );
    }
}

#[test]
fn units_change_nothing() {
    let (inch, mm) = (UnitSystem::InKipKsi, UnitSystem::MmNMPa);
    let to_mm = |value, dimension| value * inch.factor_to(mm, dimension);
    let metal = RuleSteel {
        youngs_modulus: 29500.0,
        poissons_ratio: 0.3,
        yield_stress: Some(100.0),
        ultimate_strength: Some(120.0),
        hardness: Some(650.0),
        surface_hardened: false,
    };
    let own = RuleInput {
        rollings: Some(1e5),
        ..RuleInput::new(inch, 3.0, 8.0, [metal; 2])
    };
    let stress = |value| to_mm(value, Dimension::STRESS);
    let metric = RuleSteel {
        youngs_modulus: stress(29500.0),
        yield_stress: Some(stress(100.0)),
        ultimate_strength: Some(stress(120.0)),
        ..metal
    };
    let metric = RuleInput {
        rollings: Some(1e5),
        ..RuleInput::new(mm, 3.0 * 25.4, 8.0 * 25.4, [metric; 2])
    };
    for (own, metric) in rules(&own).unwrap().iter().zip(rules(&metric).unwrap()) {
        let (a, b) = (own.bound().unwrap(), metric.bound().unwrap());
        close(own.name, b.pressure, stress(a.pressure), 1e-12);
        let load = to_mm(a.line_load, Dimension::LINE_LOAD);
        close(own.name, b.line_load, load, 1e-12);
    }
}

#[test]
fn en_1337_4_says_where_the_strengths_differ() {
    let mut uneven = bridge();
    uneven.sides[1].ultimate_strength = Some(510.0);
    let told = |input: &RuleInput| rule(input, "EN 1337-4").notes.join("; ");
    assert!(told(&uneven).contains("here they differ") && !told(&bridge()).contains("differ"));
    // The lower strength is the limit.
    allows(&uneven, "EN 1337-4", 1935.5, 942.65);
}
