//! Numeric factorisation on one thread and on two: seconds, Gflop/s, and the share of what a
//! product of dense matrices reaches in the same run.
//!
//!     cargo bench --bench factor -- --blocks 25,31,40,100x20x20 --single
//!
//! Medians of runs that take turns: one thread, two threads, one thread, ... The order (METIS) and
//! the symbolic work are timed beside them.

mod block;
#[path = "../kit/mod.rs"]
mod kit;
mod single;

use block::{Cells, Size};
use brinell::solver::linear::cholesky::Symbolic;
use brinell::solver::linear::ordering::{Block, blockwise};
use brinell::solver::linear::sparse::{Pattern, SymmetricMatrix};
use clap::Parser;
use cpu_time::ProcessTime;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use kit::Failure;
use single::Single;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

/// Threads that are compared.
const THREADS: [usize; 2] = [1, 2];
/// Two threads may take this much longer than one.
const SLACK: f64 = 1.05;
/// Rows and columns of the dense matrices.
const DENSE: usize = 2000;

/// Seconds on the clock, and of all threads together.
#[derive(Debug, Clone, Copy)]
struct Cost {
    wall: f64,
    cpu: f64,
}

#[derive(Debug, Parser)]
struct Arguments {
    /// Cells along the edges: one number for a cube, or three with x between them.
    #[arg(long, value_delimiter = ',', value_parser = cells, default_value = "25,31,40,100x20x20")]
    blocks: Vec<Cells>,
    /// Runs of which the median is taken.
    #[arg(long, default_value_t = 5)]
    samples: usize,
    /// In single precision, too.
    #[arg(long)]
    single: bool,
    /// Write the table into docs/performance.md.
    #[arg(long)]
    write: bool,
    /// Handed on by cargo; without effect.
    #[arg(long, hide = true)]
    bench: bool,
}

fn cells(text: &str) -> Result<Cells, String> {
    let numbers: Result<Vec<usize>, _> = text.split('x').map(str::parse).collect();
    match numbers.as_deref() {
        Ok([n]) if *n > 0 => Ok(Cells([*n; 3])),
        Ok([x, y, z]) if x * y * z > 0 => Ok(Cells([*x, *y, *z])),
        _ => Err(format!(
            "`{text}` is neither a number nor three, such as 100x20x20"
        )),
    }
}

fn main() -> ExitCode {
    match measure(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("factor: {error}");
            ExitCode::FAILURE
        }
    }
}

fn measure(arguments: &Arguments) -> Result<(), Failure> {
    let peaks = [
        dense::<f64>(arguments.samples)?,
        dense::<f32>(arguments.samples)?,
    ];
    let mut text = format!(
        "## Factorisation\n\n\
         Elastic stiffness of blocks of hexahedra, factorised in the order of METIS; medians of {}, one and\n\
         two threads in turn. Gflop/s by the exact operations of the factor; in brackets the share of a\n\
         product of two dense matrices of {DENSE} in the same run ({} Gflop/s). {}.\n\n    {}\n\n{HEAD}",
        arguments.samples,
        peaks
            .each_ref()
            .map(|p| p.map(|r| format!("{r:.0}")).join(" and "))
            .join(", single "),
        kit::machine(),
        command(arguments),
    );
    println!("{text}");
    for cells in &arguments.blocks {
        let rows = block(*cells, arguments, &peaks)?;
        print!("{rows}");
        text.push_str(&rows);
    }
    if arguments.write {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/performance.md");
        kit::insert(&page, "factor", &text)?;
    }
    Ok(())
}

const HEAD: &str = "\
| cells | unknowns | entries, million | Gflop | METIS s | symbolic s | precision | 1 thread: s | CPU s | Gflop/s \
| 2 threads: s | CPU s | Gflop/s | 2 to 1 |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";

fn command(arguments: &Arguments) -> String {
    let block = |c: &Cells| c.0.map(|n| n.to_string()).join("x");
    let blocks: Vec<String> = arguments.blocks.iter().map(block).collect();
    let single = if arguments.single { " --single" } else { "" };
    format!(
        "cargo bench --bench factor -- --blocks {}{single} --write",
        blocks.join(",")
    )
}

/// The rows of one block.
fn block(cells: Cells, arguments: &Arguments, peaks: &[[f64; 2]; 2]) -> Result<String, Failure> {
    let (pattern, matrix) = block::matrix(cells)?;
    let blocks = [Block::Sparse(0..(pattern.vertex_start.len() - 1) as u32)];
    let start = Instant::now();
    let order = blockwise(&pattern, &blocks);
    let order_s = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let structure = single::symbolic(&pattern, &order)?;
    let symbolic_s = start.elapsed().as_secs_f64();
    let symbolic = Symbolic::new(&pattern, &blocks)?;
    let size = block::factor_size(&pattern, &order);
    let head = format!(
        "| {} | {} | {:.1} | {:.1} | {order_s:.2} | {symbolic_s:.2} |",
        cells.words(),
        pattern.len(),
        1e-6 * size.entries,
        1e-9 * size.flops
    );
    let costs = double(&pattern, &matrix, &symbolic, arguments.samples)?;
    let mut text = format!("{head} double |{}\n", cells_of(&costs, size, &peaks[0]));
    if arguments.single {
        let mut single = Single::new(&pattern, &matrix, structure);
        let costs = turns(arguments.samples, |threads| {
            let par = if threads == 1 {
                Par::Seq
            } else {
                Par::rayon(threads)
            };
            single.factorise(par)
        })?;
        text.push_str(&format!(
            "| | | | | | | single |{}\n",
            cells_of(&costs, size, &peaks[1])
        ));
    }
    Ok(text)
}

/// The cost in double precision, as the program does it where single is not enough. The last factor is put to the test.
fn double(
    pattern: &Pattern,
    matrix: &SymmetricMatrix,
    symbolic: &Symbolic,
    samples: usize,
) -> Result<[Cost; 2], Failure> {
    let mut factor = None;
    let costs = turns(samples, |_| {
        factor = Some(symbolic.factorise::<f64>(pattern, matrix, factor.take())?);
        Ok(())
    })?;
    let wanted: Vec<f64> = (0..pattern.len()).map(|k| (k as f64).sin()).collect();
    let mut found = vec![0.0; wanted.len()];
    pattern.multiply(matrix, &wanted, &mut found);
    symbolic.solve(&factor.ok_or("no sample was taken")?, &mut found);
    let error = wanted.iter().zip(&found).map(|(a, b)| (a - b).abs());
    let error = error.fold(0.0, f64::max);
    if error > 1e-6 {
        return Err(format!("the factor is wrong: error {error:.1e}").into());
    }
    Ok(costs)
}

/// Medians of `work` on each number of threads, which take turns.
fn turns(
    samples: usize,
    mut work: impl FnMut(usize) -> Result<(), Failure> + Send,
) -> Result<[Cost; 2], Failure> {
    let mut costs = THREADS.map(|_| Vec::new());
    for _ in 0..samples.max(1) {
        for (threads, list) in THREADS.into_iter().zip(&mut costs) {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()?;
            let done = pool.install(|| {
                let (start, cpu) = (Instant::now(), ProcessTime::now());
                work(threads).map_err(|e| e.to_string())?;
                Ok::<_, String>([start.elapsed(), cpu.elapsed()].map(|d| d.as_secs_f64()))
            });
            list.push(done?);
        }
    }
    Ok(costs.map(|list| {
        let [wall, cpu] = [0, 1].map(|k| {
            let mut each: Vec<f64> = list.iter().map(|c| c[k]).collect();
            each.sort_by(f64::total_cmp);
            each[each.len() / 2]
        });
        Cost { wall, cpu }
    }))
}

/// Gflop/s of a product of dense matrices on each number of threads.
fn dense<T: faer::traits::ComplexField + From<f32> + Send + Sync>(
    samples: usize,
) -> Result<[f64; 2], Failure> {
    let value = |i: usize, j: usize| T::from(((7 * i + 13 * j) % 17) as f32);
    let (a, b) = (
        Mat::from_fn(DENSE, DENSE, value),
        Mat::from_fn(DENSE, DENSE, value),
    );
    let mut c = Mat::<T>::zeros(DENSE, DENSE);
    let seconds = turns(samples, |threads| {
        let par = if threads == 1 {
            Par::Seq
        } else {
            Par::rayon(threads)
        };
        matmul(&mut c, Accum::Replace, &a, &b, T::from(1.0), par);
        Ok(())
    })?;
    Ok(seconds.map(|s| 2e-9 * (DENSE as f64).powi(3) / s.wall))
}

/// The cells of seconds and speed.
fn cells_of(costs: &[Cost; 2], size: Size, peaks: &[f64; 2]) -> String {
    let each = costs.iter().zip(peaks).map(|(cost, peak)| {
        let rate = 1e-9 * size.flops / cost.wall;
        let share = 100.0 * rate / peak;
        format!(
            " {:.2} | {:.2} | {rate:.1} ({share:.0} %) |",
            cost.wall, cost.cpu
        )
    });
    let ratio = costs[1].wall / costs[0].wall;
    let verdict = if ratio > SLACK { ", slower" } else { "" };
    format!("{} {ratio:.2}{verdict} |", each.collect::<String>())
}
