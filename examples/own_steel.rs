//! A steel of your own, from the points of a tension test, in a bar that is pulled and let go.
//!
//! ```text
//!     stress            A tension test gives engineering stress and strain; the program wants a
//!       |        __--*  bilinear curve of true stress: E up to the yield stress, then a line.
//!       |   *--´´
//!       |  /            The bar is one cube, held on three of its sides, pulled at a fourth.
//!       | /
//!       +---------- strain
//! ```
//! mm, N, MPa. In closed form the bar follows its curve, and what stays of the strain ε after unloading is ε - σ(ε)/E.
//! (Strains are small here: a test's true strain goes into the curve, and the bar is not made thinner.)

use brinell::prelude::*;
use brinell::proof::closed_forms::steel::{BilinearSteel, StrainMeasure, true_from_engineering};
use std::error::Error;

/// Of the test: Young's modulus and yield stress, MPa; stress, MPa, and strain at the end of even elongation.
const YOUNG: f64 = 206e3;
const YIELD: f64 = 690.0;
const ULTIMATE: (f64, f64) = (880.0, 0.08);
/// The strain that the bar is pulled to.
const STRAIN: f64 = 0.02;

/// What, by finite elements, in closed form.
type Figures = Result<Vec<(&'static str, f64, f64)>, Box<dyn Error>>;

pub fn figures() -> Figures {
    let [stress, strain] = true_from_engineering(ULTIMATE.0, ULTIMATE.1)?;
    let total = StrainMeasure::Total;
    let curve = BilinearSteel::from_second_point(YOUNG, YIELD, stress, strain, total)?;
    let steel = Steel {
        youngs_modulus: curve.youngs_modulus(),
        poissons_ratio: 0.3,
        yield_stress: curve.yield_stress(),
        hardening_modulus: curve.hardening_modulus(),
    };

    let side = || uniform(0.0, 1.0, 2);
    let rest = curve.residual_strain(STRAIN)?;
    let scene = SceneBuilder::new("bar")
        .body(Block::new("bar", side(), side(), side()), steel)
        .hold("bar_x_min", Axis::X)
        .hold("bar_y_min", Axis::Y)
        .hold("bar_z_min", Axis::Z)
        .load(Load::travel("bar_z_max", Axis::Z, STRAIN).named("pull"))
        .step("half", 0.5)
        .step("pull", 1.0)
        .step("let go", rest / STRAIN)
        .build()?;
    let answer = Solved::of(scene)?;

    let stress = |step| {
        answer
            .at_end_of(step)
            .map_or(f64::NAN, |state| state.stress[0][0][2])
    };
    // Without load the stress is zero: to be seen beside the yield stress, what is left is added to that.
    Ok(vec![
        (
            "stress at 1 % strain, MPa",
            stress(0),
            curve.stress(0.5 * STRAIN)?,
        ),
        (
            "stress at 2 % strain, MPa",
            stress(1),
            curve.stress(STRAIN)?,
        ),
        ("yield stress + rest, let go, MPa", YIELD + stress(2), YIELD),
    ])
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("{:<36} {:>12} {:>12} {:>8}", "", "computed", "exact", "off");
    for (what, value, exact) in figures()? {
        let off = 100.0 * (value / exact - 1.0);
        println!("{what:<36} {value:>12.5} {exact:>12.5} {off:>6.2} %");
    }
    Ok(())
}
