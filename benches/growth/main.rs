//! Time and memory of the bearing of Section 2.6.2 against its unknowns, all element sizes scaled
//! together in every direction, under the same load history.
//!
//!     cargo bench --bench growth -- --sizes 10k,25k,50k --case centre,offset
//!
//! Each size is a run of the release binary in a process of its own, so that memory is that of this
//! size alone. Results are kept in the target folder: what was measured with the same binary is not
//! measured again. `--write` puts table and plot into `docs/`.

mod fit;
#[path = "../kit/mod.rs"]
mod kit;
mod page;
mod process;
mod record;
mod run;
mod sizes;

use clap::Parser;
use kit::Failure;
use record::{Record, Store};
use sizes::{Model, Size};
use std::path::Path;
use std::process::ExitCode;
use std::time::Duration;

/// Folder of cases, meshes, results and the records, below the target folder.
const WORK: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/growth");
const BINARY: &str = env!("CARGO_BIN_EXE_brinell");
const ROOT: &str = env!("CARGO_MANIFEST_DIR");

#[derive(Debug, Parser)]
struct Arguments {
    /// Unknowns, about; any number between 10k and 1M will do.
    #[arg(
        long,
        value_delimiter = ',',
        default_value = "10k,25k,50k,100k,200k,400k,1M"
    )]
    sizes: Vec<Size>,
    /// The quarter of the centred bearing, or the whole of one with rollers 2.5 in off the centre.
    #[arg(long, value_delimiter = ',', default_value = "centre")]
    case: Vec<Model>,
    /// Threads of each run.
    #[arg(long, default_value_t = 2)]
    threads: usize,
    /// Seconds after which a run is given up.
    #[arg(long, default_value_t = 3600)]
    limit: u64,
    /// Measure again what has been measured.
    #[arg(long)]
    again: bool,
    /// Take the results of other builds, too.
    #[arg(long)]
    any_build: bool,
    /// Write docs/performance.md and docs/images/growth.svg.
    #[arg(long)]
    write: bool,
    /// Handed on by cargo; without effect.
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> ExitCode {
    match measure(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("growth: {error}");
            ExitCode::FAILURE
        }
    }
}

fn measure(arguments: &Arguments) -> Result<(), Failure> {
    std::fs::create_dir_all(WORK)?;
    let mut store = Store::open(&Path::new(WORK).join("results.jsonl"))?;
    let build = record::build(Path::new(BINARY))?;
    let wanted = (!arguments.any_build).then_some(build.as_str());
    let mut series: Vec<(Model, Vec<Record>)> = Vec::new();
    for &model in &arguments.case {
        println!("\n{}, {} threads", model.words(), arguments.threads);
        let mut rows: Vec<Record> = Vec::new();
        for size in &arguments.sizes {
            let known = store.find(model, size, arguments.threads, wanted);
            let row = match known.filter(|_| !arguments.again) {
                Some(row) => row.clone(),
                None => {
                    let limit = Duration::from_secs(arguments.limit);
                    let row = run::run(model, size, arguments.threads, limit, &build)?;
                    store.push(row.clone())?;
                    row
                }
            };
            println!("{}", page::line(&row));
            rows.push(row);
        }
        series.push((model, rows));
    }
    let text = page::text(&series, arguments.threads);
    println!("\n{text}");
    page::picture(&series, &Path::new(WORK).join("growth.svg"))?;
    if arguments.write {
        page::picture(&series, &Path::new(ROOT).join("docs/images/growth.svg"))?;
        kit::insert(
            &Path::new(ROOT).join("docs/performance.md"),
            "growth",
            &text,
        )?;
    }
    Ok(())
}
