//! A sweep as a Slurm job array: one task a row.

use super::error::SweepError;
use super::local::Watcher;
use super::one;
use super::place::SweepFolder;
use super::prepare::{Need, prepare};
use super::record::RowRecord;
use super::rows::{Sweep, SweepRow};
use crate::ground::file::write_text;
use crate::ground::order::ascending;
use std::path::{Path, PathBuf};

/// Its name in the folder of the sweep.
const SCRIPT: &str = "sweep.sbatch";

/// Memory asked for over memory estimated: Slurm kills what takes more than it asked for, and estimates are
/// within a quarter.
const MEMORY_MARGIN: f64 = 1.25;
/// Unknowns for each processor: fewer keep it waiting for the others.
const UNKNOWNS_PER_CPU: usize = 50_000;
const MOST_CPUS: usize = 8;

/// Prepares the rows of `sweep` in `place` and writes a job script beside them; with `resume` only for
/// those that have not ended. Comes back with the script, and the rows that it runs; those that cannot
/// be prepared are told, and left out.
///
/// # Errors
/// [`SweepError`] where the folder cannot be used, or no row is left.
pub fn emit(
    sweep: &Sweep,
    place: &SweepFolder,
    resume: bool,
    watcher: &mut dyn Watcher,
) -> Result<(PathBuf, Vec<usize>), SweepError> {
    let _lock = place.lock()?;
    let ended = RowRecord::all_final(sweep, place, resume)?;
    let mut needs: Vec<(usize, Need)> = Vec::new();
    let left = (sweep.rows.iter()).filter(|row| !ended.contains_key(&row.number));
    let left: Vec<&SweepRow> = left.collect();
    for (at, row) in left.iter().enumerate() {
        if watcher.stopped() {
            break;
        }
        match prepare(sweep, row, place) {
            Ok(need) => needs.push((row.number, need)),
            Err(error) => {
                let record = one::failed(row, &error, watcher.stopped());
                record.write(place, row)?;
                watcher.ended(&record, left.len() - at - 1);
            }
        }
    }
    let path = place.0.join(SCRIPT);
    let text = script(sweep, place, &needs)?;
    write_text(&path, &text)?;
    Ok((path, needs.into_iter().map(|(row, _)| row).collect()))
}

fn script(
    sweep: &Sweep,
    place: &SweepFolder,
    needs: &[(usize, Need)],
) -> Result<String, SweepError> {
    let absolute = |path: &Path| {
        let path = std::path::absolute(path).map_err(|error| SweepError::folder(path, error))?;
        let text = path
            .to_str()
            .filter(|text| !text.contains(char::is_control));
        // A line break would end a comment of the script, or an option.
        let text = text.ok_or_else(|| SweepError::Script { path: path.clone() })?;
        Ok::<_, SweepError>(quoted(text))
    };
    let program = std::env::current_exe().map_err(|error| SweepError::Start { error })?;
    let [program, file, out] = [&program, &sweep.file, &place.0].map(|path| absolute(path));
    let (program, file, out) = (program?, file?, out?);
    let log = std::path::absolute(&place.0).unwrap_or_else(|_| place.0.clone());
    let (quote, log) = option(&log).ok_or_else(|| SweepError::Script { path: log.clone() })?;
    let rows: Vec<usize> = needs.iter().map(|(row, _)| *row).collect();
    let largest = needs
        .iter()
        .map(|(_, need)| need.memory)
        .fold(0.0, f64::max);
    let unknowns = needs
        .iter()
        .map(|(_, need)| need.unknowns)
        .max()
        .unwrap_or(0);
    Ok(format!(
        "#!/bin/bash\n\
         # {title}: {count} rows of {file}\n\
         #\n\
         # Submit:   sbatch {out}/{SCRIPT}\n\
         # Afterwards, or meanwhile, gather the rows that have ended into one table:\n\
         #           {program} sweep {file} --out {out} --collect\n\
         # Once more, rows that were killed (finished rows end at once, half-done ones go on):\n\
         #           sbatch --array=<rows> {out}/{SCRIPT}\n\
         #\n\
         # Program, files and folder must be seen by the nodes under these paths. Memory is the largest\n\
         # estimate of a row, and a quarter more. Options of sbatch go before those below:\n\
         # --time, --partition and --account are yours to give; --array={range}%20 runs 20 at a time.\n\
         # Many clusters take no array index above 1000.\n\
         {by_size}\
         #\n\
         #SBATCH --job-name={job}\n\
         #SBATCH --array={range}\n\
         #SBATCH --ntasks=1\n\
         #SBATCH --cpus-per-task={cpus}\n\
         #SBATCH --mem={memory}M\n\
         #SBATCH --output={log}/rows/slurm-%A_%a.log{quote}\n\
         #SBATCH --requeue\n\
         # A minute before the time is over: stop at a checkpoint.\n\
         #SBATCH --signal=B:INT@60\n\
         \n\
         exec {program} sweep {file} --out {out} \\\n    \
         --row \"$SLURM_ARRAY_TASK_ID\" --threads \"${{SLURM_CPUS_PER_TASK:-1}}\" --resume\n",
        title = one_line(&sweep.title),
        count = rows.len(),
        range = ranges(&rows),
        by_size = by_size(needs),
        job = job_name(&sweep.title),
        cpus = cpus(unknowns),
        memory = megabytes(largest),
    ))
}

fn cpus(unknowns: usize) -> usize {
    unknowns.div_ceil(UNKNOWNS_PER_CPU).clamp(1, MOST_CPUS)
}

fn megabytes(memory: f64) -> u64 {
    (MEMORY_MARGIN * memory / (1024.0 * 1024.0)).ceil() as u64
}

/// Which rows could do with less, where sizes differ: classes by powers of two.
fn by_size(needs: &[(usize, Need)]) -> String {
    let class = |need: &Need| megabytes(need.memory).next_power_of_two();
    let classes = ascending(needs.iter().map(|(_, need)| class(need)));
    // Neighbours may differ by next to nothing.
    if classes.len() < 2 || classes.last() == classes.first().map(|size| 2 * size).as_ref() {
        return String::new();
    }
    let line = |size: &u64| {
        let of = || needs.iter().filter(|(_, need)| class(need) == *size);
        let rows: Vec<usize> = of().map(|(row, _)| *row).collect();
        let most = of()
            .map(|(_, need)| megabytes(need.memory))
            .max()
            .unwrap_or(0);
        format!("#   sbatch --array={} --mem={most}M ...\n", ranges(&rows))
    };
    let lines: String = classes.iter().map(line).collect();
    format!("# Rows differ in size; submitted by size they ask for less:\n{lines}")
}

/// Ascending numbers as Slurm takes them: `1-3,7`.
pub fn ranges(numbers: &[usize]) -> String {
    let mut parts: Vec<[usize; 2]> = Vec::new();
    for number in numbers {
        match parts.last_mut() {
            Some(part) if part[1] + 1 == *number => part[1] = *number,
            _ => parts.push([*number, *number]),
        }
    }
    let part = |[first, last]: &[usize; 2]| {
        if first == last {
            first.to_string()
        } else {
            format!("{first}-{last}")
        }
    };
    parts.iter().map(part).collect::<Vec<_>>().join(",")
}

/// A path as the beginning of an option for sbatch, and the quote that ends it; `None` for what sbatch would take for
/// something else.
fn option(path: &Path) -> Option<(&'static str, String)> {
    let text = path.to_str()?;
    if text.contains(['"', '\\', '%']) {
        return None;
    }
    Some(if quoted(text) == text {
        ("", text.to_owned())
    } else {
        ("\"", format!("\"{text}"))
    })
}

/// As one word of the shell.
fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-+=:@%".contains(c);
    if text.chars().all(plain) && !text.is_empty() {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn job_name(title: &str) -> String {
    let fine = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
    title.chars().take(40).map(fine).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_told_by_ranges() {
        assert_eq!(ranges(&[1, 2, 3, 7, 9, 10]), "1-3,7,9-10");
        assert_eq!(ranges(&[4]), "4");
        assert_eq!(ranges(&[]), "");
    }

    #[test]
    fn options_of_sbatch_are_quoted_or_refused() {
        let of = |path: &str| option(Path::new(path));
        assert_eq!(of("/a/b"), Some(("", "/a/b".to_owned())));
        assert_eq!(of("/a b/$(c)"), Some(("\"", "\"/a b/$(c)".to_owned())));
        for strange in ["/a\"b", "/a\\b", "/a%j"] {
            assert_eq!(of(strange), None);
        }
    }

    #[test]
    fn strange_paths_are_one_word() {
        assert_eq!(quoted("/a/b-1.toml"), "/a/b-1.toml");
        assert_eq!(quoted("/a b/it's"), r"'/a b/it'\''s'");
    }

    #[test]
    fn rows_of_one_size_need_no_classes() {
        let need = |memory| Need {
            unknowns: 10,
            memory,
        };
        assert_eq!(by_size(&[(1, need(1e8)), (2, need(1e8))]), "");
        let text = by_size(&[(1, need(1e8)), (2, need(8e8)), (3, need(1e8))]);
        assert!(text.contains("--array=1,3 --mem=120M"), "{text}");
        assert_eq!([cpus(100), cpus(120_000), cpus(10_000_000)], [1, 3, 8]);
    }
}
