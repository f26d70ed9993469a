use super::*;
use crate::solver::linear::sparse::{Pattern, SymmetricMatrix};

/// Laplacian of a chain plus one: solved against its own product.
#[test]
fn solves_what_it_multiplies() {
    let n = 50u32;
    let cliques: Vec<Vec<u32>> = (0..n - 1).map(|i| vec![i, i + 1]).collect();
    let pattern = Pattern::new((0..=n).collect(), cliques.iter().map(Vec::as_slice));
    let mut m = pattern.zeros();
    for c in &cliques {
        pattern.add_block(&mut m, c, |i, j| if i == j { 1.5 } else { -1.0 });
    }
    let x: Vec<f64> = (0..n).map(|i| f64::from(i).sin()).collect();
    let mut b = vec![0.0; n as usize];
    pattern.multiply(&m, &x, &mut b);
    let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..n)]).unwrap();
    let factor = symbolic.factorise::<f64>(&pattern, &m, None).unwrap();
    symbolic.solve(&factor, &mut b);
    assert!(b.iter().zip(&x).all(|(b, x)| (b - x).abs() < 1e-12));
}

/// A plate of springs between neighbours, `spring` being the entries of each: a factor of many supernodes.
pub fn plate(n: u32, spring: impl Fn(usize, usize) -> f64) -> (Pattern, SymmetricMatrix) {
    let at = |i: u32, j: u32| i + n * j;
    let right = (0..n).flat_map(|j| (0..n - 1).map(move |i| [at(i, j), at(i + 1, j)]));
    let up = (0..n - 1).flat_map(|j| (0..n).map(move |i| [at(i, j), at(i, j + 1)]));
    let springs: Vec<[u32; 2]> = right.chain(up).collect();
    let starts = (0..=n * n).map(|v| 3 * v).collect();
    let pattern = Pattern::new(starts, springs.iter().map(|s| s.as_slice()));
    let mut m = pattern.zeros();
    for [a, b] in springs {
        let equations: Vec<u32> = (3 * a..3 * a + 3).chain(3 * b..3 * b + 3).collect();
        pattern.add_block(&mut m, &equations, &spring);
    }
    (pattern, m)
}

/// Held everywhere a little.
pub fn held(i: usize, j: usize) -> f64 {
    match (i == j, i % 3 == j % 3) {
        (true, _) => 2.0,
        (false, true) => -1.0,
        _ => 0.1,
    }
}

pub fn threads<T: Send>(count: usize, work: impl FnOnce() -> T + Send) -> T {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(count)
        .build()
        .unwrap();
    pool.install(work)
}

#[test]
fn threads_do_not_change_the_factor() {
    let (pattern, m) = plate(60, held);
    let n = pattern.len();
    let x: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
    let mut b = vec![0.0; n];
    pattern.multiply(&m, &x, &mut b);
    let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..3600)]).unwrap();
    let factors = [1, 2, 3].map(|count| {
        threads(count, || {
            symbolic.factorise::<f64>(&pattern, &m, None).unwrap()
        })
    });
    for factor in &factors {
        let mut solved = b.clone();
        symbolic.solve(factor, &mut solved);
        assert!(solved.iter().zip(&x).all(|(s, x)| (s - x).abs() < 1e-11));
        let pairs = factor.values.iter().zip(factors[0].values.iter());
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-12));
    }
}

#[test]
fn subtrees_side_by_side_solve_as_faer_does() {
    let (pattern, m) = plate(60, held);
    let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..3600)]).unwrap();
    let factor = threads(2, || symbolic.factorise::<f64>(&pattern, &m, None).unwrap());
    let b: Vec<f64> = (0..pattern.len()).map(|i| (i as f64).sin()).collect();
    let mut expected: Vec<f64> = b.iter().zip(&factor.scale).map(|(b, s)| b * s).collect();
    solve(&symbolic.inner, &factor.values, &mut expected);
    let order = order(&symbolic.inner);
    for count in [1, 2, 3, 7] {
        let mut x: Vec<f64> = (order.iter())
            .map(|e| b[*e as usize] * factor.scale[*e as usize])
            .collect();
        let mut triangles = symbolic.triangles(&factor).unwrap();
        triangles.threads = count;
        threads(count, || {
            triangles.reduce(&mut x);
            triangles.recover(&mut x);
        });
        for (e, x) in order.iter().zip(x) {
            assert!((x - expected[*e as usize]).abs() < 1e-12);
        }
    }
}

/// Columns of W = L⁻¹ B for few entries of B: Wᵀ L⁻¹ c = Bᵀ A⁻¹ c, Wᵀ W = Bᵀ A⁻¹ B, and with W f taken off between the
/// triangles A⁻¹ (c − B f) comes out.
#[test]
fn few_entries_reach_what_a_whole_solution_says() {
    let (pattern, m) = plate(60, held);
    let n = pattern.len();
    let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..3600)]).unwrap();
    let factor = symbolic.factorise::<f64>(&pattern, &m, None).unwrap();
    let solved = |b: &[f64]| {
        let mut x = b.to_vec();
        symbolic.solve(&factor, &mut x);
        x
    };
    let b = [
        [vec![(7, 1.0), (4000, -2.0)], vec![(7, 0.5)], Vec::new()],
        [
            vec![(9000, 1.0)],
            vec![(10799, 3.0), (8, 1.0)],
            vec![(0, 1.0)],
        ],
    ];
    let whole = |column: &[(usize, f64)]| {
        let mut b = vec![0.0; n];
        column.iter().for_each(|(e, value)| b[*e] = *value);
        b
    };
    let reached = symbolic.reach(&factor, &b, f64::INFINITY).unwrap();
    assert!(symbolic.reach(&factor, &b, 1.0).is_none());
    let times = |b: &[f64], x: &[f64]| b.iter().zip(x).map(|(b, x)| b * x).sum::<f64>();
    for (columns, b) in reached.iter().zip(&b) {
        let c: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let pulled = std::cell::Cell::new([0.0; 3]);
        let force = [0.3, -1.0, 2.0];
        let mut x = c.clone();
        let update = |x: &mut [f64]| {
            pulled.set(columns.pull(x));
            columns.take_off(force, x);
        };
        symbolic.solve_updated(&factor, &mut x, Some(&update));
        let whole = b.each_ref().map(|column| whole(column));
        let exact = solved(&c);
        for (pulled, b) in pulled.get().iter().zip(&whole) {
            assert!((pulled - times(b, &exact)).abs() < 1e-11);
        }
        let left = |i: usize| c[i] - (0..3).map(|k| whole[k][i] * force[k]).sum::<f64>();
        let exact = solved(&(0..n).map(left).collect::<Vec<_>>());
        assert!(
            x.iter()
                .zip(&exact)
                .all(|(x, exact)| (x - exact).abs() < 1e-11)
        );
    }
    let products = reached[0].products(&reached[1]);
    let [first, second] = &b;
    for (line, b) in products.iter().zip(first) {
        for (product, d) in line.iter().zip(second) {
            assert!((product - times(&whole(b), &solved(&whole(d)))).abs() < 1e-11);
        }
    }
}

#[test]
fn single_precision_solves_to_its_own_rounding() {
    let (pattern, mut m) = plate(60, held);
    // Far beyond what single precision can tell from nothing.
    m.values.iter_mut().for_each(|v| *v *= 1e60);
    let x: Vec<f64> = (0..pattern.len()).map(|i| (i as f64).sin()).collect();
    let mut b = vec![0.0; pattern.len()];
    pattern.multiply(&m, &x, &mut b);
    let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..3600)]).unwrap();
    let factor = symbolic.factorise::<f32>(&pattern, &m, None).unwrap();
    symbolic.solve(&factor, &mut b);
    let error = b.iter().zip(&x).map(|(b, x)| (b - x).abs());
    let error = error.fold(0.0, f64::max);
    assert!((1e-12..1e-4).contains(&error), "{error:.1e}");
}

#[test]
fn a_pivot_that_is_not_positive_is_named_on_any_number_of_threads() {
    let (pattern, mut m) = plate(60, held);
    m.values[pattern.columns[5000] as usize] = -1.0;
    let symbolic = Symbolic::new(&pattern, &[Block::Sparse(0..3600)]).unwrap();
    for count in [1, 2] {
        let result = threads(count, || {
            symbolic.factorise::<f64>(&pattern, &m, None).map(|_| ())
        });
        assert_eq!(
            result,
            Err(FactorError::NotPositiveDefinite { equation: 5000 })
        );
    }
}
