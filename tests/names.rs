//! Titles, names and folders that would be orders to other programs: everywhere quoted, changed or refused, and never
//! obeyed.

use brinell::model::mesh::{Mesh, msh};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// Ends a line, a quotation, a tag and a cell, and orders what comes after.
const NASTY: &str = "=a, 'b\"\n*INCLUDE,INPUT=c\nimport pwned\n#SBATCH --wrap=touch\n$(touch pwned) \
                     `touch pwned` \"\"\" </script><script>pwned = 1</script><!--";
/// What of it a mesh or a folder can be called.
const NAME: &str =
    "=a, 'b' $(touch pwned) `touch pwned`;touch pwned <script>pwned = 1<!script> # %2";

/// A block on a block of these names, in a folder of this name.
struct Bench {
    folder: TempDir,
}

impl Bench {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let extreme = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/extreme");
        let mut mesh: Mesh = msh::read(&extreme.join("stack.msh")).unwrap();
        let mut text = std::fs::read_to_string(extreme.join("stack.toml")).unwrap();
        let mut change = |from: String, to: &str| {
            assert!(text.contains(&from), "{from}");
            text = text.replace(&from, &json!(to).to_string());
        };
        change(json!("block on block").to_string(), NASTY);
        change(json!("upper-lower").to_string(), NASTY);
        change(json!("stack.msh").to_string(), &format!("{NAME}.msh"));
        for surface in &mut mesh.surfaces {
            let name = format!("{NAME}{}", surface.name);
            let quoted = json!(surface.name).to_string();
            if text_has(&extreme, &quoted) {
                change(quoted, &name);
            }
            surface.name = name;
        }
        for body in &mut mesh.bodies {
            body.name = format!("{NAME}{}", body.name);
        }
        let step = json!(NASTY);
        text += &format!("\n[[step]]\nname = {step}\n[[step]]\nname = \"=2\"\n");
        let place = |name: String| folder.path().join(name);
        std::fs::write(place(format!("{NAME}.toml")), text).unwrap();
        std::fs::write(place(format!("{NAME}.msh")), msh::write::msh41(&mesh)).unwrap();
        Self { folder }
    }

    fn brinell(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_brinell"))
            .current_dir(self.folder.path())
            .args(arguments)
            .output()
            .unwrap()
    }

    /// Runs the case into a folder of its name.
    fn run(&self) -> PathBuf {
        let output = self.brinell(&["run", &format!("{NAME}.toml"), "--out", NAME]);
        assert!(output.status.success(), "{output:?}");
        self.folder.path().join(NAME)
    }

    /// Has any of the orders been obeyed?
    fn is_pwned(&self) -> bool {
        self.folder.path().join("pwned").exists()
    }
}

fn text_has(folder: &Path, words: &str) -> bool {
    let text = std::fs::read_to_string(folder.join("stack.toml")).unwrap();
    text.contains(words)
}

/// The text of the only file in `folder` whose name ends so.
#[track_caller]
fn only(folder: &Path, end: &str) -> String {
    let files = std::fs::read_dir(folder)
        .unwrap()
        .map(|f| f.unwrap().path());
    let named = |path: &PathBuf| path.to_string_lossy().ends_with(end);
    let files: Vec<PathBuf> = files.filter(named).collect();
    assert_eq!(files.len(), 1, "{files:?}");
    std::fs::read_to_string(&files[0]).unwrap()
}

#[test]
fn the_script_of_paraview_takes_names_as_texts() {
    let bench = Bench::new();
    let script = only(&bench.run(), "-views.py");
    // Above the part that is the same in all of them.
    let head = script.split("\n# What stands below").next().unwrap();
    assert!(head.contains("FOLDER = "), "{head}");
    let (mut title, mut folder) = (None, None);
    for line in head
        .lines()
        .filter(|l| !l.is_empty() && !l.starts_with('#'))
    {
        let (name, value) = line.split_once(" = ").unwrap();
        let is_name = |c: char| c.is_ascii_uppercase() || "_, ".contains(c);
        assert!(name.chars().all(is_name), "{line}");
        match name {
            "TITLE" => title = serde_json::from_str::<String>(value).ok(),
            "FOLDER" => folder = serde_json::from_str::<String>(value).ok(),
            _ => assert!(!value.contains("pwned") || name == "NAME", "{line}"),
        }
    }
    assert_eq!(title.as_deref(), Some(NASTY));
    let real = bench.folder.path().canonicalize().unwrap().join(NAME);
    assert_eq!(PathBuf::from(folder.unwrap()).canonicalize().unwrap(), real);
}

#[test]
fn the_page_of_a_run_shows_names() {
    let bench = Bench::new();
    let page = only(&bench.run(), "report.html");
    assert!(page.contains("&lt;script&gt;pwned = 1"));
    for tag in page.split('<').skip(1) {
        assert!(!tag.starts_with("script>pwned") && !tag.starts_with("!script"));
    }
    // Scripts end where the page ends them: a script of the page begins with none of the orders.
    let begun = page.matches("<script").count();
    assert_eq!(begun, page.matches("</script>").count());
    assert!(!page.contains("<!--"));
}

#[test]
fn a_deck_has_its_own_keywords_only() {
    let bench = Bench::new();
    let case = format!("{NAME}.toml");
    // A plane is named in a comment.
    let place = bench.folder.path().join(&case);
    let text = std::fs::read_to_string(&place).unwrap();
    let top = json!(format!("{NAME}upper_z_max"));
    let plane = format!(
        "[[rigid_plane]]\nname = {}\nsurface = {top}\nforce = {{ z = \"-1 N\" }}\n",
        json!(NASTY)
    );
    let pressed = format!("[[pressure]]\nsurface = {top}\nvalue = \"10 MPa\"\n");
    assert!(text.contains(&pressed));
    std::fs::write(&place, text.replace(&pressed, &plane)).unwrap();
    let output = bench.brinell(&["export", &case, "--format", "inp", "--out", NAME]);
    assert!(output.status.success(), "{output:?}");
    let deck = only(&bench.folder.path().join(NAME), ".inp");
    let mut lines = deck.lines();
    assert_eq!(lines.next(), Some("*HEADING"));
    let title = lines.next().unwrap();
    assert!(
        title.contains("*INCLUDE") && !title.starts_with('*'),
        "{title}"
    );
    assert!(deck.contains("** The nodes of =a, 'b\""));
    for line in lines.filter(|line| !line.starts_with("**")) {
        let plain = |c: char| c.is_ascii_alphanumeric() || "*,=_-+. ".contains(c);
        assert!(line.chars().all(plain), "{line}");
        assert!(!line.starts_with("*INCLUDE"), "{line}");
    }
}

/// The cells of a table.
#[track_caller]
fn cells(text: &str) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .from_reader(text.as_bytes());
    let rows = reader.records().map(|row| {
        let row = row.unwrap();
        row.iter().map(str::to_owned).collect()
    });
    rows.collect()
}

#[test]
fn a_line_load_has_a_cell_for_a_name_and_no_formula() {
    let bench = Bench::new();
    let table = cells(&only(&bench.run(), "line-load.csv"));
    assert!(table.len() > 1);
    for row in &table[1..] {
        assert_eq!(row.len(), 5);
        assert_eq!(row[0], format!("'{NASTY}"));
    }
}

/// A sweep over the title of the case, and its name.
fn sweep(bench: &Bench) -> String {
    let name = format!("{NAME} sweep.toml");
    let case = json!(format!("{NAME}.toml"));
    let nasty = json!(NASTY);
    let text = format!(
        "title = {nasty}\ncase = {case}\n[[row]]\ntitle = {nasty}\n[[row]]\ntitle = \"@b\"\n\
         pressure.0.value = \"-3 MPa\"\n"
    );
    std::fs::write(bench.folder.path().join(&name), text).unwrap();
    name
}

#[test]
fn the_table_of_a_sweep_has_no_formula() {
    let bench = Bench::new();
    let name = sweep(&bench);
    bench.brinell(&["sweep", &name, "--out", NAME]);
    let table = cells(&only(&bench.folder.path().join(NAME), "table.csv"));
    let column = |name: &str| table[0].iter().position(|head| head == name).unwrap();
    let (title, pressure) = (column("title"), column("pressure.0.value"));
    assert_eq!(table[1][title], format!("'{NASTY}"));
    assert_eq!([&table[2][title], &table[2][pressure]], ["'@b", "-3 MPa"]);
    assert!(!bench.is_pwned());
}

#[cfg(unix)]
#[test]
fn a_job_script_takes_names_as_words_or_refuses_them() {
    let bench = Bench::new();
    let name = sweep(&bench);
    let emit = |out: &str| bench.brinell(&["sweep", &name, "--out", out, "--emit", "slurm"]);
    for out in ["a\nb", "a\"b", "a\\b", "a%jb"] {
        let output = emit(out);
        assert_eq!(output.status.code(), Some(2), "{out}");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(said.contains("cannot stand in a job script"), "{said}");
    }
    let out = NAME.replace('%', "");
    let output = emit(&out);
    assert!(output.status.success(), "{output:?}");
    let script = bench.folder.path().join(&out).join("sweep.sbatch");
    let text = std::fs::read_to_string(&script).unwrap();
    for line in text.lines().filter(|line| line.starts_with("#SBATCH")) {
        let known = [
            "job-name=",
            "array=",
            "ntasks=",
            "cpus-per-task=",
            "mem=",
            "output=",
            "requeue",
            "signal=",
        ];
        let option = line.strip_prefix("#SBATCH --").unwrap();
        assert!(
            known.iter().any(|known| option.starts_with(known)),
            "{line}"
        );
    }
    // Run as a task, it finds sweep and folder.
    let task = Command::new("bash")
        .current_dir(bench.folder.path())
        .arg(&script)
        .env("SLURM_ARRAY_TASK_ID", "1")
        .output()
        .unwrap();
    assert!(task.status.success(), "{task:?}");
    assert!(!bench.is_pwned());
}
