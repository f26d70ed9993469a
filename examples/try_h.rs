use brinell::material::{Steel, mises};
use brinell::scene::*;
use brinell::solve::{Iteration, Observer, solve};
struct Log;
impl Observer for Log {
    fn iteration(&mut self, i: &Iteration) {
        println!(
            "{:3} t{:.3} it{:3} r{:.2e} E{:.2e} act{} st{} sl{} ch{} pen{:.2e} flow{} dir{} fac{} ls{:.3}",
            i.step,
            i.time,
            i.iteration,
            i.residual,
            i.energy,
            i.active,
            i.sticking,
            i.slipping,
            i.changed,
            i.penetration,
            i.flowing,
            i.directions,
            i.refactored,
            i.line_search
        );
    }
    fn message(&mut self, m: &str) {
        println!("-- {m}");
    }
}
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let friction: f64 = std::env::args().nth(2).map_or(0.0, |s| s.parse().unwrap());
    let pf: f64 = std::env::args().nth(3).map_or(1.0, |s| s.parse().unwrap());
    let mesh = brinell::mesh::msh::read(path.as_ref()).unwrap();
    let sup = |s: &str, c: [Option<f64>; 3]| Support {
        name: s.into(),
        surface: s.into(),
        components: c,
    };
    let (o, n) = (Some(0.0), None);
    let mut scene = Scene {
        name: "h".into(),
        materials: vec![Steel::elastic(29500.0, 0.3); 2],
        mesh,
        contacts: vec![ContactPair {
            name: "cylinder-block".into(),
            upper: Partner::Surface("cylinder_contact".into()),
            lower: Partner::Surface("block_contact".into()),
            carrier: Side::Upper,
            friction,
            penalty_factor: pf,
            true_geometry: true,
        }],
        supports: vec![
            sup("base", [o, o, o]),
            sup("symmetry", [o, n, n]),
            sup("back", [n, n, o]),
            sup("front", [n, n, o]),
        ],
        rigid_planes: vec![],
        tractions: vec![Traction {
            name: "top".into(),
            surface: "top".into(),
            value: TractionValue::Pressure(8.125 / 3.0),
        }],
        steps: vec![Step {
            name: "load".into(),
            factor: 1.0,
            factors: vec![],
        }],
        mirrors: vec![0],
        controls: Controls::default(),
    };
    let t = std::time::Instant::now();
    let sol = solve(&mut scene, &mut Log).unwrap();
    println!("{:.3} s {:?}", t.elapsed().as_secs_f64(), sol.counters);
    let state = sol.states.last().unwrap();
    let c = &state.contacts[0];
    let p0 = c.pressure.iter().cloned().fold(0.0, f64::max);
    let f: f64 = c.force.iter().map(|f| f[1]).sum();
    let t: f64 = c
        .traction
        .iter()
        .map(|t| (t[0] * t[0] + t[1] * t[1] + t[2] * t[2]).sqrt())
        .fold(0.0, f64::max);
    let thick = scene.mesh.points.iter().map(|p| p[2]).fold(0.0, f64::max);
    println!(
        "p0 {:.3} ({:+.3} %)  force {:.8} tmax/p0 {:.2e}",
        p0,
        100.0 * (p0 / 167.17 - 1.0),
        f / thick / 8.125 * 2.0,
        t / p0
    );
    let rec = brinell::results::recovery::recover(&scene.mesh, state);
    let _ = mises;
    for p in brinell::results::peaks::peaks(&scene, state, &rec) {
        let lim = if p.name == "block" { 94.98 } else { 92.69 };
        let pc = |x: Option<f64>| x.map_or(f64::NAN, |v| 100.0 * (v / lim - 1.0));
        println!(
            "{:10} centroid {:+.2} ip {:+.2} nodal {:+.2}",
            p.name,
            pc(p.centroid.as_ref().map(|p| p.value)),
            pc(p.integration_point.as_ref().map(|p| p.value)),
            pc(p.nodal.as_ref().map(|p| p.value))
        );
    }
    let a = brinell::results::strip::half_width(
        &scene.mesh,
        scene.mesh.surface("cylinder_contact").unwrap(),
        c,
        &brinell::results::strip::Strip {
            middle: Some(0.0),
            ..brinell::results::strip::Strip::across(0)
        },
    );
    println!("{a:?}");
}
