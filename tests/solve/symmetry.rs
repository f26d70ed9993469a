//! A quarter of a centred bearing says the same as the whole.

use crate::bearing::{case, figures, state};
use brinell::case::Kind;
use brinell::product::job;

/// A centred bearing is solved as a quarter without being asked; the full model on the mirror
/// images of that mesh has the same peaks to 1e-6.
#[test]
fn a_quarter_says_what_the_whole_says() {
    let mut case = case();
    let mesh = job::find_mesh(&case, None, &mut |_| ()).expect("the shipped mesh");
    let mut whole = mesh.unfolded(0, 1e-9).unfolded(1, 1e-9);
    assert_eq!(whole.hexes.len(), 4 * mesh.hexes.len());
    let quarter = state(&case, mesh);
    assert_eq!(quarter.0.mirrors, [0, 1]);
    case.set_full().expect("a bearing");
    if let Kind::Bearing(bearing) = &case.kind {
        whole.fingerprint = Some(bearing.fingerprint());
    }
    let whole = state(&case, whole);
    assert!(whole.0.mirrors.is_empty());
    let mut worst = Vec::new();
    for ((name, a), (_, b)) in figures(&quarter).iter().zip(figures(&whole)) {
        let off = if *a == b { 0.0 } else { (b / a - 1.0).abs() };
        println!("{name}: {a} {b} {off:.1e}");
        if off > 1e-6 {
            worst.push(format!("{name}: {a} in the quarter, {b} in the whole"));
        }
    }
    assert!(worst.is_empty(), "{}", worst.join("\n"));
    let yielded = whole.1.peeq.iter().flatten().any(|p| *p > 0.0);
    let sticks = whole.1.contacts.iter().any(|c| c.status.contains(&1));
    let slips = whole.1.contacts.iter().any(|c| c.status.contains(&2));
    assert!(yielded && sticks && slips, "{yielded} {sticks} {slips}");
}
