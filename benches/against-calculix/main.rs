//! Brinell against CalculiX: the same meshes, steel, loads and contact, both as processes.
//!
//!     cargo bench --bench against-calculix -- centre --write
//!
//! Both programs read their mesh from a file and write their results; the mesh is made before. The
//! time of the processor is that of all threads, the memory the largest resident set. `--write`
//! puts the tables into `docs/performance.md`, and what is compared node by node into
//! `docs/cross-check.md`.

mod bearing;
mod ccx;
mod convergence;
mod fields;
mod frd;
mod page;
mod problem_h;
mod process;
mod reactions;
mod reading;
mod slice;
mod subject;
mod tied;

use std::path::Path;
use std::process::ExitCode;

const USAGE: &str = "\
cargo bench --bench against-calculix -- SCENARIO... [--write] [--repeat N] [--no-spooles]
                                        [--no-iterative]

  centre       the centre bearing, 36 thousand unknowns, plasticity and friction
  centre-100k  the same, 100 thousand unknowns
  problem-h    which mesh reaches 1 % and 0.3 % on problem H, and at what cost
  slice        problem H extruded to 181 thousand unknowns, elastic
  all          all four
  centre-convergence, displaced-convergence
               errors of a bearing against seconds and memory, elastic: presets, targets, CalculiX
  centre-fields, offset-fields
               displacements, reactions and Mises stresses of the exported bearing, node by node;
               fails where they differ by more than is allowed
  tie-fields   displacements of an exported beam of two parts that are tied, likewise

  --write          put the tables into docs/performance.md and docs/cross-check.md
  --repeat N       run each short run N times, for the median [default: 3]
  --no-spooles     leave out CalculiX with its direct solver on large meshes
  --no-iterative   leave out CalculiX with its iterative solver on the bearing
  --contact-stiffness K
                   of the decks of the fields, ksi/in [default: that of brinell export]";

/// What was asked for.
pub struct Options {
    pub repeat: usize,
    pub spooles: bool,
    pub iterative: bool,
    /// Of the decks whose fields are compared.
    pub stiffness: Option<String>,
    write: bool,
}

impl Options {
    /// The linear solvers of CalculiX to try: name and word.
    fn solvers(&self) -> Vec<(&'static str, &'static str)> {
        let mut solvers = Vec::new();
        if self.spooles {
            solvers.push(("SPOOLES", "spooles"));
        }
        if self.iterative {
            solvers.push(("ITERATIVE CHOLESKY", "iterative-cholesky"));
        }
        solvers
    }
}

const SCENARIOS: [&str; 4] = ["centre", "centre-100k", "problem-h", "slice"];
/// Error against run time.
const CONVERGENCE: [&str; 2] = ["centre-convergence", "displaced-convergence"];
/// What is compared node by node.
const FIELDS: [&str; 3] = ["centre-fields", "offset-fields", "tie-fields"];
/// Element sizes of about 100 thousand unknowns, over those of `h0125`.
const SCALE_100K: f64 = 0.68;

fn main() -> ExitCode {
    match read_arguments().and_then(|(options, scenarios)| run(&options, &scenarios)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn read_arguments() -> Result<(Options, Vec<&'static str>), String> {
    let mut options = Options {
        repeat: 3,
        spooles: true,
        iterative: true,
        stiffness: None,
        write: false,
    };
    let mut scenarios = Vec::new();
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            // From cargo.
            "--bench" | "--test" => {}
            "--write" => options.write = true,
            "--no-spooles" => options.spooles = false,
            "--no-iterative" => options.iterative = false,
            "--repeat" => {
                let number = words.next().and_then(|n| n.parse().ok());
                options.repeat = number.filter(|n| *n > 0).ok_or("--repeat wants a number")?;
            }
            "--contact-stiffness" => {
                let wanted = "--contact-stiffness wants a number";
                options.stiffness = Some(words.next().ok_or(wanted)?);
            }
            "all" => scenarios.extend(SCENARIOS),
            word => match SCENARIOS
                .into_iter()
                .chain(FIELDS)
                .chain(CONVERGENCE)
                .find(|s| *s == word)
            {
                Some(scenario) => scenarios.push(scenario),
                None => return Err(format!("`{word}` is not understood\n\n{USAGE}")),
            },
        }
    }
    Ok((options, scenarios))
}

fn run(options: &Options, scenarios: &[&str]) -> Result<(), String> {
    if scenarios.is_empty() {
        println!("{USAGE}");
        return Ok(());
    }
    let version = ccx::ensure()?;
    for scenario in scenarios {
        let machine = page::machine(&version);
        println!("\n== {scenario}\n{machine}");
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("against-calculix")
            .join(scenario);
        std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let tables = match *scenario {
            "centre" => bearing::run(options, &folder, 1.0)?,
            "centre-100k" => bearing::run(options, &folder, SCALE_100K)?,
            "problem-h" => problem_h::run(options, &folder)?,
            "centre-fields" => fields::run(options, &folder, &fields::CENTRE)?,
            "offset-fields" => fields::run(options, &folder, &fields::OFFSET)?,
            "tie-fields" => tied::run(&folder)?,
            "centre-convergence" => converged(options, &folder, &convergence::CENTRE)?,
            "displaced-convergence" => converged(options, &folder, &convergence::DISPLACED)?,
            _ => slice::run(options, &folder)?,
        };
        println!("\n{tables}");
        if options.write {
            let page = match *scenario {
                scenario if FIELDS.contains(&scenario) => page::CROSS_CHECK,
                scenario if CONVERGENCE.contains(&scenario) => page::CONVERGENCE,
                _ => page::PERFORMANCE,
            };
            page::write(page, scenario, &format!("{machine}\n\n{tables}"))?;
        }
    }
    Ok(())
}

/// Tables of a bearing, and its picture where pages are written.
fn converged(
    options: &Options,
    folder: &Path,
    subject: &convergence::Subject,
) -> Result<String, String> {
    let name = format!("docs/images/convergence-{}.svg", subject.bearing);
    let picture = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    convergence::run(folder, subject, options.write.then_some(picture.as_path()))
}
