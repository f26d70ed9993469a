//! `brinell sweep`: rows from a table, runs that are killed, and tables that come out the same.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

/// What depends on the machine, and not on the row.
const APART: [&str; 2] = ["seconds", "memory_bytes"];

fn cases(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("cases")
        .join(file);
    path.to_string_lossy().into_owned()
}

/// Twelve rows that take some tenths of a second each.
fn twelve() -> String {
    format!(
        "case = \"{}\"\n[set]\nmesh.level = 1\n[grid]\npressure.0.value = [\"1 ksi\", \"2 ksi\", \
         \"3 ksi\"]\nsteel.poissons_ratio = [0.25, 0.3]\ncontact.cylinder-block.friction = [0, 0.1]\n",
        cases("problem-h.toml")
    )
}

/// Rows of a block on a block that take next to no time.
fn quick(rows: &str) -> String {
    format!("case = \"{}\"\n{rows}", cases("extreme/stack.toml"))
}

struct Bench {
    folder: TempDir,
}

impl Bench {
    fn new(sweep: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("sweep.toml"), sweep).unwrap();
        Self { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn command(&self, line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_brinell"));
        command.current_dir(self.folder.path());
        command
            .args(["sweep", "sweep.toml"])
            .args(line.split_whitespace());
        command
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        command
    }

    /// Runs it; its exit status and all that it says.
    fn run(&self, line: &str) -> (i32, String) {
        let Output {
            status,
            stdout,
            stderr,
        } = self.command(line).output().unwrap();
        let said = String::from_utf8_lossy(&stdout) + String::from_utf8_lossy(&stderr);
        let plain = said.replace(['│', '×', '╰', '─', '▶'], " ");
        let words: Vec<&str> = plain.split_whitespace().collect();
        (status.code().unwrap_or(-1), words.join(" "))
    }

    fn start(&self, line: &str) -> Child {
        let mut command = self.command(line);
        command
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    }

    /// The rows of the table in `out`, which is the same in both files.
    fn table(&self, out: &str) -> Vec<Value> {
        let text = std::fs::read_to_string(self.path(out).join("table.jsonl")).unwrap_or_default();
        let rows: Vec<Value> = text
            .lines()
            .map(|l| serde_json::from_str(l).unwrap())
            .collect();
        let csv = std::fs::read_to_string(self.path(out).join("table.csv")).unwrap_or_default();
        assert!(csv.lines().count() >= rows.len());
        rows
    }

    /// Statuses in the table, and how many rows have them.
    fn statuses(&self, out: &str) -> Vec<(String, usize)> {
        let table = self.table(out);
        let status = |row: &Value| row["status"].as_str().unwrap().to_owned();
        let kinds: BTreeSet<String> = table.iter().map(status).collect();
        let count = |kind: &String| table.iter().filter(|r| status(r) == *kind).count();
        kinds
            .iter()
            .map(|kind| (kind.clone(), count(kind)))
            .collect()
    }

    /// Waits until nobody runs a row any more.
    fn wait_until_idle(&self, out: &str) {
        for row in self.rows(out) {
            let lock = std::fs::File::create(row.join("row.lock")).unwrap();
            lock.lock().unwrap();
        }
    }

    /// The folders of rows, in order.
    fn rows(&self, out: &str) -> Vec<PathBuf> {
        let folders = std::fs::read_dir(self.path(out).join("rows")).unwrap();
        let mut folders: Vec<PathBuf> = folders.map(|f| f.unwrap().path()).collect();
        folders.sort();
        folders
    }
}

fn kill(process: u32) {
    let process = i32::try_from(process).unwrap();
    // SAFETY: a signal to a process that this test started.
    unsafe { libc::kill(process, libc::SIGKILL) };
}

/// Processes that `parent` has started.
fn children(parent: u32) -> Vec<u32> {
    let list = format!("/proc/{parent}/task/{parent}/children");
    let list = std::fs::read_to_string(list).unwrap_or_default();
    list.split_whitespace()
        .map(|word| word.parse().unwrap())
        .collect()
}

/// Waits until `ready` says so.
#[track_caller]
fn wait_until(mut ready: impl FnMut() -> bool) {
    let end = Instant::now() + Duration::from_secs(120);
    while !ready() {
        assert!(Instant::now() < end, "it takes too long");
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Asserts that two tables say the same, numbers to 1e-8, as a row that goes on from a checkpoint
/// does.
#[track_caller]
fn same(one: &[Value], other: &[Value]) {
    assert_eq!(one.len(), other.len());
    for (a, b) in one.iter().zip(other) {
        let (a, b) = (a.as_object().unwrap(), b.as_object().unwrap());
        assert!(a.keys().eq(b.keys()));
        for (name, a) in a.iter().filter(|(name, _)| !APART.contains(&name.as_str())) {
            let b = &b[name];
            let near = match (a.as_f64(), b.as_f64()) {
                (Some(a), Some(b)) => (a - b).abs() <= 1e-8 * a.abs().max(b.abs()),
                _ => a == b,
            };
            assert!(near, "{name}: {a} and {b}");
        }
    }
}

#[test]
fn a_sweep_that_is_killed_goes_on_to_the_same_table() {
    let bench = Bench::new(&twelve());
    let (status, said) = bench.run("--out alone");
    assert_eq!(status, 0, "{said}");
    assert!(said.contains("12 rows: 12 done"), "{said}");
    let alone = bench.table("alone");

    // Once a few rows have ended: the sweep and all of its runs at once; then the sweep alone, whose
    // runs notice; then one run, which the sweep survives.
    let mut sweep = bench.start("--out killed --jobs 2");
    wait_until(|| bench.table("killed").len() >= 2);
    let runs = children(sweep.id());
    kill(sweep.id());
    runs.into_iter().for_each(kill);
    sweep.wait().unwrap();
    let after_all = bench.table("killed").len();
    assert!(after_all < 12, "it was too fast to be killed");

    let (status, said) = bench.run("--out killed");
    assert_eq!(status, 2, "{said}");
    assert!(
        said.contains("rows of an earlier sweep") && said.contains("--resume"),
        "{said}"
    );

    let mut sweep = bench.start("--out killed --jobs 2 --resume");
    wait_until(|| bench.table("killed").len() > after_all);
    kill(sweep.id());
    sweep.wait().unwrap();
    let after_sweep = bench.table("killed").len();
    bench.wait_until_idle("killed");
    assert!((after_all + 1..12).contains(&after_sweep));

    let mut sweep = bench.start("--out killed --jobs 1 --resume");
    let mut runs = Vec::new();
    wait_until(|| {
        runs = children(sweep.id());
        !runs.is_empty()
    });
    runs.into_iter().for_each(kill);
    assert_eq!(sweep.wait().unwrap().code(), Some(3));
    let statuses = bench.statuses("killed");
    assert_eq!(
        statuses,
        [("crashed".to_owned(), 1), ("done".to_owned(), 11)]
    );
    let table = bench.table("killed");
    let crashed = table.iter().find(|row| row["status"] == "crashed").unwrap();
    assert!(
        crashed["message"].as_str().unwrap().contains("signal: 9"),
        "{crashed}"
    );

    let (status, said) = bench.run("--out killed --resume");
    assert_eq!(status, 0, "{said}");
    same(&alone, &bench.table("killed"));
}

#[test]
fn a_row_waits_for_a_run_of_an_earlier_sweep_that_still_has_its_folder() {
    let bench = Bench::new(&quick("[grid]\npressure.0.value = [\"10 MPa\"]\n"));
    assert_eq!(bench.run("--out out --emit slurm").0, 0);
    let row = &bench.rows("out")[0];
    let lock = std::fs::File::create(row.join("row.lock")).unwrap();
    lock.lock().unwrap();
    let mut sweep = bench.start("--out out --resume");
    let log = || std::fs::read_to_string(row.join("run.log")).unwrap_or_default();
    wait_until(|| log().contains("waiting for it"));
    assert!(!row.join("row.json").exists());
    drop(lock);
    assert_eq!(sweep.wait().unwrap().code(), Some(0));
    assert_eq!(bench.statuses("out"), [("done".to_owned(), 1)]);
}

#[test]
fn a_run_whose_sweep_is_gone_stops_by_itself() {
    let bench = Bench::new(&twelve());
    assert_eq!(bench.run("--out out --emit slurm").0, 0);
    // Its standard input has ended.
    assert_eq!(bench.run("--out out --row 1 --leash").0, 130);
    let (status, said) = bench.run("--out out --collect");
    assert_eq!(status, 130, "{said}");
    assert!(said.contains("not ended: rows 2-12"), "{said}");
    assert_eq!(bench.statuses("out"), [("interrupted".to_owned(), 1)]);
}

#[test]
fn tasks_of_a_job_array_come_to_the_table_of_a_local_sweep() {
    let rows = "[[row]]\npressure.0.value = \"10 MPa\"\n[[row]]\npressure.0.value = \"20 MPa\"\n";
    let bench = Bench::new(&quick(rows));
    assert_eq!(bench.run("--out here").0, 0);
    let (status, said) = bench.run("--out there --emit slurm");
    assert_eq!(status, 0, "{said}");
    assert!(
        said.contains("2 of 2 rows") && said.contains("--collect"),
        "{said}"
    );
    let script = bench.path("there/sweep.sbatch");
    let text = std::fs::read_to_string(&script).unwrap();
    for line in [
        "#SBATCH --array=1-2\n",
        "#SBATCH --mem=",
        "#SBATCH --cpus-per-task=1\n",
    ] {
        assert!(text.contains(line), "{text}");
    }
    for task in ["1", "2"] {
        let mut bash = Command::new("bash");
        let bash = bash.arg(&script).env("SLURM_ARRAY_TASK_ID", task);
        assert!(bash.output().unwrap().status.success());
    }
    assert_eq!(bench.run("--out there --collect").0, 0);
    same(&bench.table("here"), &bench.table("there"));
    // Blocks of 1 mm go down by p (1/E1 + 1/E2) times that: 1e-4 mm under 10 MPa.
    let table = bench.table("here");
    assert_eq!(table[1]["pressure.0.value"], "20 MPa");
    for (row, expected) in table.iter().zip([1e-4, 2e-4]) {
        let descent = row["descent"].as_f64().unwrap();
        assert!((descent / expected - 1.0).abs() < 1e-6, "{descent}");
    }
    let peak = table[0]["mises_nodal"].as_f64().unwrap();
    assert!((peak / 10.0 - 1.0).abs() < 1e-6, "{peak}");
    // Every figure without an error is named; those away from edges have columns of their own.
    let row = table[0].as_object().unwrap();
    let unresolved = row["unresolved"].as_str().unwrap();
    let errors = row
        .iter()
        .filter(|(key, _)| key.ends_with(".mises_nodal_error"));
    assert!(errors.clone().count() > 0);
    for (key, error) in errors {
        let body = key.trim_end_matches(".mises_nodal_error");
        assert!(row.contains_key(&format!("{body}.mises_away")), "{body}");
        assert!(
            !error.is_null() || unresolved.contains(body),
            "{unresolved}"
        );
    }
    assert!(bench.path("here/pressure.0.value.svg").exists());
}

#[test]
fn rows_come_from_a_csv_file_too() {
    let bench = Bench::new(&quick("csv = \"rows.csv\"\n"));
    let rows = "pressure.0.value,contact.upper-lower.friction\n10 MPa,0.1\n10 MPa,\n";
    std::fs::write(bench.path("rows.csv"), rows).unwrap();
    assert_eq!(bench.run("--out out").0, 0);
    let table = bench.table("out");
    assert_eq!(table[0]["contact.upper-lower.friction"], 0.1);
    assert_eq!(table[1]["contact.upper-lower.friction"], Value::Null);
    assert_eq!(table[1]["folder"], "rows/0002");
}

#[test]
fn nothing_is_run_before_all_rows_are_understood() {
    let rows = "csv = \"rows.csv\"\n";
    let bench = Bench::new(&quick(rows));
    for (rows, parts) in [
        (
            "pressure.0.value\n10 MPa\n10 mm\n",
            [
                "1 of 2 rows",
                "row 2, column `pressure.0.value`, value \"10 mm\"",
            ],
        ),
        (
            "contact.0.frictoin\n0.1\n",
            [
                "row 1, column `contact.0.frictoin`, value 0.1",
                "did you mean `friction`",
            ],
        ),
        (
            "contact.3.friction\n0.1\n",
            ["column `contact.3.friction`", "has no place for"],
        ),
    ] {
        std::fs::write(bench.path("rows.csv"), rows).unwrap();
        let (status, said) = bench.run("--out out");
        assert_eq!(status, 2, "{said}");
        for part in parts {
            assert!(said.contains(part), "`{part}` is not in: {said}");
        }
        assert!(!bench.path("out").exists());
    }
}

#[test]
fn a_row_that_fails_stops_nothing_and_is_run_anew_when_its_case_changes() {
    let rows = |gone: &str| {
        quick(&format!(
            "[[row]]\nmesh.file = \"{gone}\"\n[[row]]\npressure.0.value = \"20 MPa\"\n"
        ))
    };
    let bench = Bench::new(&rows("gone.msh"));
    assert_eq!(bench.run("--out out").0, 2);
    let expected = [("bad input".to_owned(), 1), ("done".to_owned(), 1)];
    assert_eq!(bench.statuses("out"), expected);
    let message = bench.table("out")[0]["message"]
        .as_str()
        .unwrap()
        .to_owned();
    assert!(message.contains("gone.msh"), "{message}");

    let begun = bench.rows("out").iter().find_map(|row| {
        let log = row.join("run.log");
        log.metadata().and_then(|m| m.modified()).ok()
    });
    std::fs::write(bench.path("sweep.toml"), rows("stack.msh")).unwrap();
    let (status, said) = bench.run("--out out --resume");
    assert_eq!(status, 0, "{said}");
    assert_eq!(bench.statuses("out"), [("done".to_owned(), 2)]);
    // The second row had been done, and was let alone.
    let second = bench
        .rows("out")
        .into_iter()
        .find(|r| r.ends_with("0002-20MPa"));
    let log = second.unwrap().join("run.log").metadata().unwrap();
    assert_eq!(begun, log.modified().ok());
}

#[test]
fn a_row_beyond_the_memory_is_refused_with_its_estimate() {
    let bench = Bench::new(&quick("[grid]\npressure.0.value = [\"10 MPa\"]\n"));
    let (status, said) = bench.run("--out out --memory 1MB");
    assert_eq!(status, 2, "{said}");
    assert!(
        said.contains("unknowns need about") && said.contains("--memory"),
        "{said}"
    );
    assert_eq!(bench.run("--out out --resume").0, 0);
}

/// A slip in a grid is told before its rows fill the memory.
#[test]
fn a_grid_beyond_all_reason_is_refused() {
    let long = |key: usize| format!("a{key} = {:?}\n", [1; 400]);
    let pair = |key: usize| format!("a{key} = [1, 2]\n");
    let rows: String = (0..2).map(long).collect();
    let values: String = (0..16).map(pair).collect();
    for (grid, what) in [(rows, "100000 rows"), (values, "1000000 values")] {
        let (status, said) = Bench::new(&quick(&format!("[grid]\n{grid}"))).run("--out out");
        assert_eq!(status, 2, "{said}");
        assert!(said.contains(&format!("more than {what}")), "{said}");
    }
}

/// A mesh that never ends is no mesh.
#[cfg(target_os = "linux")]
#[test]
fn a_device_is_no_mesh_of_a_sweep() {
    let bench = Bench::new(&quick("[[row]]\nmesh.file = \"/dev/zero\"\n"));
    let (status, said) = bench.run("--out out");
    assert_eq!(status, 2, "{said}");
    assert!(
        said.contains("/dev/zero: cannot read the mesh file"),
        "{said}"
    );
}
