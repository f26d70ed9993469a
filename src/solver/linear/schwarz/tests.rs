use super::*;
use crate::solver::linear::krylov;

/// A cube of springs between neighbours, every vertex with three equations, held at one face.
fn cube(n: usize) -> (Pattern, SymmetricMatrix, Vec<Place>) {
    let at = |i: usize, j: usize, k: usize| (i + n * (j + n * k)) as u32;
    let (mut cliques, mut places, mut held) = (Vec::new(), Vec::new(), Vec::new());
    for (k, j, i) in (0..n * n * n).map(|m| (m / (n * n), m / n % n, m % n)) {
        let point = [i as f64, j as f64, k as f64];
        places.extend((0..3).map(|axis| Some((point, axis))));
        let next = [(i + 1, j, k), (i, j + 1, k), (i, j, k + 1)];
        let inside = next.into_iter().filter(|(i, j, k)| *i.max(j).max(k) < n);
        cliques.extend(inside.map(|(a, b, c)| vec![at(i, j, k), at(a, b, c)]));
        if k == 0 {
            held.push(at(i, j, k));
        }
    }
    let starts = (0..=(n * n * n) as u32).map(|v| 3 * v).collect();
    let pattern = Pattern::new(starts, cliques.iter().map(Vec::as_slice));
    let mut matrix = pattern.zeros();
    for pair in &cliques {
        for axis in 0..3 {
            let equations = [3 * pair[0] + axis, 3 * pair[1] + axis];
            pattern.add_block(
                &mut matrix,
                &equations,
                |i, j| if i == j { 1.0 } else { -1.0 },
            );
        }
    }
    for v in held {
        let own = [3 * v, 3 * v + 1, 3 * v + 2];
        pattern.add_block(&mut matrix, &own, |i, j| f64::from(u8::from(i == j)));
    }
    (pattern, matrix, places)
}

#[test]
fn few_directions_are_needed_and_few_more_after_a_change() {
    let (pattern, mut matrix, places) = cube(20);
    let schwarz = Schwarz::new(&pattern, &matrix, &places).unwrap();
    let b: Vec<f64> = (0..pattern.len()).map(|i| (i as f64).sin()).collect();
    let elastic = matrix.clone();
    let mut factor = schwarz
        .factorise(&pattern, &matrix, &elastic, None)
        .unwrap();
    for change in [1.0, 50.0] {
        // A stiff corner.
        let start = pattern.columns[pattern.len() - 1] as usize;
        matrix.values[start] *= change;
        factor = schwarz
            .factorise(&pattern, &matrix, &elastic, Some(factor))
            .unwrap();
        let multiply = |x: &[f64], y: &mut [f64]| pattern.multiply(&matrix, x, y);
        let precondition = |x: &mut [f64]| schwarz.apply(&pattern, &factor, multiply, x);
        let (x, outcome) = krylov::solve(multiply, precondition, &b, 1e-8, 40);
        assert!(
            outcome.residual <= 1e-8 && outcome.iterations <= 25,
            "{outcome:?}"
        );
        let mut product = vec![0.0; x.len()];
        multiply(&x, &mut product);
        assert!(product.iter().zip(&b).all(|(p, b)| (p - b).abs() < 1e-6));
    }
}

#[test]
fn little_changes_reach_the_coarse_system() {
    let (pattern, mut matrix, places) = cube(12);
    let schwarz = Schwarz::new(&pattern, &matrix, &places).unwrap();
    let elastic = matrix.clone();
    let factorise = |matrix: &_, old| schwarz.factorise(&pattern, matrix, &elastic, old);
    let factor = factorise(&matrix, None).unwrap();
    // Two corners change, one by less than a subdomain is factored anew for.
    for (equation, change) in [(0, 1.01), (pattern.len() - 1, 50.0)] {
        matrix.values[pattern.columns[equation] as usize] *= change;
    }
    let kept = factorise(&matrix, Some(factor)).unwrap();
    let fresh = factorise(&matrix, None).unwrap();
    let r: Vec<f64> = (0..pattern.len()).map(|i| (i as f64).cos()).collect();
    let solve = |f: &SchwarzFactor| schwarz.coarse.solve(&pattern, &f.coarse, &r);
    assert_eq!(solve(&kept), solve(&fresh));
}
